//! A joint whose torque is recorded with its motion.

use crate::fault::AxisReport;
use crate::driven::Driven;
use mechanism::MechanismKind;
use project::sections::Joint;

impl Driven for Joint {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let (inertia, holding_torque) = (self.inertia.value(), self.holding_torque.value());
        Some(MechanismKind::Joint(mechanism::Joint { inertia, holding_torque }))
    }

    fn torque_is_recorded(&self) -> bool {
        true
    }
}
