//! Inertia and torque over the position.

use super::parts::{Friction, Losses, StartAngle};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use crate::value::{Rows, TableRow};

section! {
    /// A mechanism given by points.
    Table, TableName of About::Mechanism, MechanismName::Table {
        points: Rows<TableRow> => needed,
            example("[[\"0 deg\", \"1.3 kg m^2\", \"5 N m\"], [\"90 deg\", \"1.6 kg m^2\", \"0 N m\"]]");
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}
