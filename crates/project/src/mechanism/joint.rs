//! A joint whose torque is recorded with its motion.

use super::{Driven, MechanismName};
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use mechanism::MechanismKind;
use quantities::{MomentOfInertia, Torque};

section! {
    /// A joint of a robot.
    Joint, JointName of About::Mechanism, MechanismName::Joint {
        inertia: MomentOfInertia => positive;
        holding_torque: Torque => not_negative;
    }
}

impl Driven for Joint {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        let (inertia, holding_torque) = (self.inertia.value(), self.holding_torque.value());
        Some(MechanismKind::Joint(mechanism::Joint { inertia, holding_torque }))
    }

    fn torque_is_recorded(&self) -> bool {
        true
    }
}
