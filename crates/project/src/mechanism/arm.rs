//! An unbalanced arm.

use super::parts::{Friction, Losses, StartAngle};
use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::{Angle, Length, Mass, MomentOfInertia};

section! {
    /// An arm whose centre of mass is off the axis.
    Arm, ArmName of About::Mechanism, MechanismName::Arm {
        inertia: MomentOfInertia => not_negative, needed;
        mass: Mass => not_negative, needed;
        centre_distance: Length => not_negative, needed;
        payload_distance: Length => not_negative;
        axis_tilt: Angle => needed;
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}
