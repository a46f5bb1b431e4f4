//! A conveyor or roller that runs endlessly.

use super::parts::{Friction, Guide, Losses, ProcessForce, Slide};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::Length;

section! {
    /// A conveyor or roller that runs endlessly.
    Conveyor, ConveyorName of About::Mechanism, MechanismName::Conveyor {
        roller_diameter: Length => positive, needed, example("50 mm");
        ..slide: Slide;
        ..guide: Guide;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
