//! A belt, or rack and pinion, with a slide.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange};
use super::parts::linear;
use mechanism::{LinearKind, MechanismKind};
use project::sections::{Bearing, Belt, StatedField};
use quantities::Measure;

impl Driven for Belt {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
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
