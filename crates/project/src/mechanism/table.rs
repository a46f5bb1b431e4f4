//! Inertia and torque over the position.

use super::parts::{Friction, Losses, StartAngle};
use super::{Driven, MechanismName};
use crate::Fault;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use crate::value::Rows;
use mechanism::{MechanismKind, TablePoint};

section! {
    /// A mechanism given by points.
    Table, TableName of About::Mechanism, MechanismName::Table {
        points: Rows<TablePoint> => needed,
            example("[[\"0 deg\", \"1.3 kg m^2\", \"5 N m\"], [\"90 deg\", \"1.6 kg m^2\", \"0 N m\"]]");
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for Table {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        match mechanism::Table::new(self.points.get()?.values()) {
            Ok(table) => Some(MechanismKind::Table(table)),
            Err(fault) => {
                reader.fault(self.points.span(), Fault::Table(fault), None);
                None
            }
        }
    }
}
