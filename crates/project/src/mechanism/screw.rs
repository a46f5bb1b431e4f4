//! A screw with a slide.

use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide, linear};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::flange::Bearing;
use crate::read::Reader;
use crate::section::section;
use crate::stated::{Field, Stated};
use mechanism::{Kind, LinearKind};
use quantities::{Force, Lead, Measure};

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
    fn kind(&self, _: &mut Reader<'_>) -> Option<Kind> {
        let travel_m_per_rad = self.lead.value()?.si() / std::f64::consts::TAU;
        linear(
            (LinearKind::Screw, travel_m_per_rad),
            (&self.slide, &self.guide),
            self.counterweight.counterweight.value(),
        )
    }

    fn inertia(&self) -> Vec<&dyn Field> {
        vec![&self.slide.inertia]
    }

    fn friction(&self) -> Option<&Friction> {
        Some(&self.friction)
    }

    fn guide(&self) -> Option<&Guide> {
        Some(&self.guide)
    }

    fn losses(&self) -> Option<&Losses> {
        Some(&self.losses)
    }

    fn process_force(&self) -> Option<&Stated<Force>> {
        Some(&self.process.process_force)
    }

    fn travel(&self) -> Option<&dyn Field> {
        Some(&self.lead)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Shaft)
    }

    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn Field> {
        vec![&bearing.overhang, &bearing.flange_share, &bearing.wheel_mass, &bearing.axis_tilt]
    }
}
