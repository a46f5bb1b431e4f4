//! Drum, rope and load.

use super::parts::{Counterweight, Friction, Losses, ProcessForce};
use super::{Driven, MechanismName, OnFlange, sound};
use crate::Assumption;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::MechanismKind;
use quantities::{Length, Mass, MomentOfInertia};

section! {
    /// A drum that lifts a load by a rope with several falls.
    Hoist, HoistName of About::Mechanism, MechanismName::Hoist {
        drum_diameter: Length => positive, needed, example("320 mm");
        falls: u32 = 1 => whole(1, 32), example("2");
        mass: Mass => not_negative, needed;
        inertia: MomentOfInertia => not_negative, noted(Assumption::PartsWithoutInertia);
        rope_mass: Mass => not_negative, example("4 kg"), noted(Assumption::RopeWeightless);
        hanging: Length => positive, example("6 m");
        sheave_efficiency: f64 = 1.0 => within(0.5, 1.0), example("0.98"), noted(Assumption::SheavesNoLosses);
        ..counterweight: Counterweight;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for Hoist {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        let hoist = mechanism::Hoist {
            drum_diameter: self.drum_diameter.value()?,
            falls: self.falls(),
            inertia: self.inertia.or_zero(),
            mass: self.mass.value()?,
            counterweight: self.counterweight.counterweight.or_zero(),
            rope_mass: self.rope_mass.or_zero(),
            hanging: self.hanging.or_zero(),
            reeving: mechanism::reeving_efficiency(self.falls(), self.sheave_efficiency()),
        };
        sound(self, hoist.faults(), reader)?;
        Some(MechanismKind::Hoist(hoist))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.mass]
    }

    fn is_without_effect(&self, default: Assumption) -> bool {
        // A single fall runs over no sheave.
        default == Assumption::SheavesNoLosses && self.falls() == 1
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.drum_diameter)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}
