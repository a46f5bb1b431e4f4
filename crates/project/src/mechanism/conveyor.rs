//! A conveyor or roller that runs endlessly.

use super::parts::{Friction, Guide, Losses, ProcessForce, Slide, linear};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::flange::Bearing;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::{MechanismKind, LinearKind};
use quantities::{Measure, Length};

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

impl Driven for Conveyor {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        linear(self, LinearKind::Conveyor, self.roller_diameter.value()?.si() / 2.0)
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.roller_diameter)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }

    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn StatedField> {
        vec![&bearing.overhang, &bearing.flange_share, &bearing.belt_tension, &bearing.wheel_mass, &bearing.axis_tilt]
    }
}
