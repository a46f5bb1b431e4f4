//! A platform on crossed arms that a screw draws together.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange, sound};
use mechanism::MechanismKind;
use project::sections::{ScissorLift, StatedField};
use quantities::{Length, Measure};

impl Driven for ScissorLift {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let lift = mechanism::ScissorLift {
            stages: if self.stages.is_written() { self.stages.value()? } else { self.stages() },
            arm_length: self.arm_length.value()?,
            lead: Length::from_si(self.lead.value()?.si()),
            angle: self.arm_angle.value()?,
            mass: self.mass.value()?,
            arm_mass: self.arm_mass.or_zero(),
            inertia: self.inertia.or_zero(),
        };
        sound(self, lift.faults(), report)?;
        Some(MechanismKind::ScissorLift(lift))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.mass]
    }

    fn gearing(&self) -> Option<&dyn StatedField> {
        Some(&self.lead)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Shaft)
    }
}
