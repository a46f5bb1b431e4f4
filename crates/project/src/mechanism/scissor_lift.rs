//! A platform on crossed arms that a screw draws together.

use super::parts::{Friction, Losses, ProcessForce};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::section::section;
use quantities::{Angle, Lead, Length, Mass, MomentOfInertia};

section! {
    /// A scissor lift with a screw at the lower end of an arm.
    ScissorLift, ScissorLiftName of About::Mechanism, MechanismName::ScissorLift {
        stages: u32 = 1 => whole(1, 32), example("2"), noted(KeyDefault::OneScissor);
        arm_length: Length => positive, needed, example("1.2 m");
        lead: Lead => positive, needed, example("10 mm");
        arm_angle: Angle => needed, example("20 deg");
        mass: Mass => not_negative, needed;
        arm_mass: Mass => not_negative, example("60 kg"), noted(KeyDefault::ArmsWeightless);
        inertia: MomentOfInertia => not_negative, noted(KeyDefault::PartsWithoutInertia);
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}
