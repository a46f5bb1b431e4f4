//! An unbalanced arm.

use super::parts::{Friction, Losses, StartAngle};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::choices::ArmShape;
use crate::section::section;
use quantities::{Angle, Length, Mass, MomentOfInertia};

section! {
    /// An arm whose centre of mass is off the axis.
    Arm, ArmName of About::Mechanism, MechanismName::Arm {
        shape: ArmShape;
        length: Length => positive, example("600 mm");
        width: Length => positive, example("80 mm");
        mass: Mass => not_negative, needed;
        inertia: MomentOfInertia => not_negative;
        centre_distance: Length => not_negative;
        payload_distance: Length => not_negative;
        axis_tilt: Angle => noted(KeyDefault::AxisLevel);
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}
