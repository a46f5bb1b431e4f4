//! A screw with a slide.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange};
use super::parts::linear;
use mechanism::{LinearKind, MechanismKind};
use project::sections::{Screw, StatedField};
use quantities::Measure;

impl Driven for Screw {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
        linear(self, LinearKind::Screw, self.lead.value()?.si() / std::f64::consts::TAU)
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.lead)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Shaft)
    }
}
