//! A screw with a slide.

use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide, linear};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::{MechanismKind, LinearKind};
use quantities::{Measure, Lead};

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

impl Driven for Screw {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        linear(self, LinearKind::Screw, self.lead.value()?.si() / std::f64::consts::TAU)
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.lead)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Shaft)
    }
}
