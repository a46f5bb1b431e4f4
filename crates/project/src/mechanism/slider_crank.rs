//! Crank, rod and slider.

use super::parts::{Friction, Losses, ProcessForce, Slide, StartAngle};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::Length;

section! {
    /// A crank that moves a slider by a rod.
    SliderCrank, SliderCrankName of About::Mechanism, MechanismName::SliderCrank {
        crank: Length => positive, needed, example("50 mm");
        rod: Length => positive, needed, example("200 mm");
        ..slide: Slide;
        ..start: StartAngle;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
