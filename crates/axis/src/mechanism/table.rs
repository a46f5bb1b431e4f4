//! Inertia and torque over the position.

use crate::fault::{AxisFault, AxisReport};
use crate::driven::Driven;
use mechanism::{MechanismKind, TableFault, TablePoint};
use project::sections::{StatedField, Table, TableRow};

use quantities::{Angle, Measure, MomentOfInertia, Torque};

impl Driven for Table {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let rows = self.points.get()?;
        match mechanism::Table::new(rows.values().iter().map(point).collect()) {
            Ok(table) => rows.is_whole.then_some(MechanismKind::Table(table)),
            // A faulty row is one of the points.
            Err(TableFault::TooFewPoints) if !rows.is_whole => None,
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
