//! Drum, rope and load.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange, sound};
use mechanism::{Geometry, MechanismKind};
use project::KeyDefault;
use project::sections::{Hoist, StatedField};

impl Driven for Hoist {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
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
        // A length that is stated but faulty is none that is missing.
        let is_missing = |fault: &Geometry| *fault != Geometry::RopeWithoutLength || !self.hanging.is_written();
        sound(self, hoist.faults().into_iter().filter(is_missing).collect(), report)?;
        Some(MechanismKind::Hoist(hoist))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.mass]
    }

    fn is_without_effect(&self, default: KeyDefault) -> bool {
        // A single fall runs over no sheave.
        default == KeyDefault::SheavesNoLosses && self.falls() == 1
    }

    fn travel(&self) -> Option<&dyn StatedField> {
        Some(&self.drum_diameter)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}
