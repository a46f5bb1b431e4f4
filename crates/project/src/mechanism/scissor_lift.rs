//! A platform on crossed arms that a screw draws together.

use super::parts::{Friction, Losses, ProcessForce};
use super::{Driven, MechanismName, OnFlange, sound};
use crate::Assumption;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::MechanismKind;
use quantities::{Measure, Lead, Angle, Length, Mass, MomentOfInertia};

section! {
    /// A scissor lift with a screw at the lower end of an arm.
    ScissorLift, ScissorLiftName of About::Mechanism, MechanismName::ScissorLift {
        stages: u32 => whole(1, 32), needed, example("2");
        arm_length: Length => positive, needed, example("1.2 m");
        lead: Lead => positive, needed, example("10 mm");
        arm_angle: Angle => needed, example("20 deg");
        mass: Mass => not_negative, needed;
        arm_mass: Mass => not_negative, example("60 kg"), noted(Assumption::ArmsWeightless);
        inertia: MomentOfInertia => not_negative, noted(Assumption::PartsWithoutInertia);
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for ScissorLift {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        let lift = mechanism::ScissorLift {
            stages: self.stages.value()?,
            arm_length: self.arm_length.value()?,
            lead: Length::from_si(self.lead.value()?.si()),
            angle: self.arm_angle.value()?,
            mass: self.mass.value()?,
            arm_mass: self.arm_mass.or_zero(),
            inertia: self.inertia.or_zero(),
        };
        sound(self, lift.faults(), reader)?;
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
