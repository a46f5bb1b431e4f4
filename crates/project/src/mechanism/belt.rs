//! A belt, or rack and pinion, with a slide.

use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide, linear};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::flange::Bearing;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::{MechanismKind, LinearKind};
use quantities::{Measure, Length};

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

impl Driven for Belt {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        linear(self, LinearKind::Belt, self.pulley_diameter.value()?.si() / 2.0)
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.pulley_diameter)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }

    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn StatedField> {
        vec![
            &bearing.overhang,
            &bearing.flange_share,
            &bearing.belt_tension,
            &bearing.pressure_angle,
            &bearing.helix_angle,
            &bearing.wheel_mass,
            &bearing.axis_tilt,
        ]
    }
}
