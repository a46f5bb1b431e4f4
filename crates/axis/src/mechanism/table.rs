//! Inertia and torque over the position.

use crate::driven::Driven;
use mechanism::MechanismKind;
use project::sections::{StatedField, Table};
use project::{Fault, FaultReport};

impl Driven for Table {
    fn kind(&self, report: &mut FaultReport<'_>) -> Option<MechanismKind> {
        match mechanism::Table::new(self.points.get()?.values()) {
            Ok(table) => Some(MechanismKind::Table(table)),
            Err(fault) => {
                report.fault(self.points.span(), Fault::Table(fault), None);
                None
            }
        }
    }
}
