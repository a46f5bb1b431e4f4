//! A screw with a slide.

use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::Lead;

section! {
    /// A screw that moves a slide.
    Screw, ScrewName of About::Mechanism, MechanismName::Screw {
        lead: Lead => positive, needed, example("10 mm");
        ..slide: Slide;
        ..counterweight: Counterweight;
        ..guide: Guide;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
