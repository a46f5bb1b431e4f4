//! A conveyor or roller that runs endlessly.

use super::parts::{Friction, Guide, Losses, ProcessForce, Slide, linear};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::flange::Bearing;
use crate::read::Reader;
use crate::section::section;
use crate::stated::{Field, Stated};
use mechanism::{Kind, LinearKind};
use quantities::{Force, Length, Measure};

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
    fn kind(&self, _: &mut Reader<'_>) -> Option<Kind> {
        let travel_m_per_rad = self.roller_diameter.value()?.si() / 2.0;
        linear((LinearKind::Conveyor, travel_m_per_rad), (&self.slide, &self.guide), None)
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
        Some(&self.roller_diameter)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }

    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn Field> {
        vec![&bearing.overhang, &bearing.flange_share, &bearing.belt_tension, &bearing.wheel_mass, &bearing.axis_tilt]
    }
}
