//! Inertia and torque over the position.

use crate::fault::{AxisFault, AxisReport};
use crate::driven::Driven;
use mechanism::{MechanismKind, TablePoint};
use project::sections::{StatedField, Table, TableRow};

use quantities::{Angle, Measure, MomentOfInertia, Torque};

impl Driven for Table {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        match mechanism::Table::new(self.points.get()?.values().iter().map(point).collect()) {
            Ok(table) => Some(MechanismKind::Table(table)),
            Err(fault) => {
                report.fault(self.points.span(), AxisFault::Table(fault), None);
                None
            }
        }
    }
}

fn point(row: &TableRow) -> TablePoint {
    let [position, inertia, torque] = row.si();
    TablePoint {
        position: Angle::from_si(position),
        inertia: MomentOfInertia::from_si(inertia),
        torque: Torque::from_si(torque),
    }
}
