//! A belt, or rack and pinion, with a slide.

use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::Length;

section! {
    /// A belt, or rack and pinion, that moves a slide.
    Belt, BeltName of About::Mechanism, MechanismName::Belt {
        pulley_diameter: Length => positive, needed, example("50 mm");
        ..slide: Slide;
        ..counterweight: Counterweight;
        ..guide: Guide;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
