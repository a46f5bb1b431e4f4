//! A joint whose torque is recorded with its motion.

use super::MechanismName;
use crate::about::About;
use crate::section::section;
use quantities::{MomentOfInertia, Torque};

section! {
    /// A joint of a robot.
    Joint, JointName of About::Mechanism, MechanismName::Joint {
        inertia: MomentOfInertia => positive;
        holding_torque: Torque => not_negative;
    }
}
