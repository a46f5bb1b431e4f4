//! A conveyor or roller that runs endlessly.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange};
use super::parts::linear;
use mechanism::{LinearKind, MechanismKind};
use project::sections::{Bearing, Conveyor, StatedField};
use quantities::Measure;

impl Driven for Conveyor {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
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
