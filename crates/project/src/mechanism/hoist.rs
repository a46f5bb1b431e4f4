//! Drum, rope and load.

use super::parts::{Counterweight, Friction, Losses, ProcessForce};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::section::section;
use quantities::{Length, Mass, MomentOfInertia};

section! {
    /// A drum that lifts a load by a rope with several falls.
    Hoist, HoistName of About::Mechanism, MechanismName::Hoist {
        drum_diameter: Length => positive, needed, example("320 mm");
        falls: u32 = 1 => whole(1, 32), example("2");
        mass: Mass => not_negative, needed;
        inertia: MomentOfInertia => not_negative, noted(KeyDefault::PartsWithoutInertia);
        rope_mass: Mass => not_negative, example("4 kg"), noted(KeyDefault::RopeWeightless);
        hanging: Length => positive, example("6 m");
        sheave_efficiency: f64 = 1.0 => within(0.5, 1.0), example("0.98"), noted(KeyDefault::SheavesNoLosses);
        ..counterweight: Counterweight;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
