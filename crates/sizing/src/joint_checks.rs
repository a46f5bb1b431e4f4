//! The checks of the screw joints and of the field of application.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{Comparison, not_checked};
use crate::demand::Demand;
use actuator::{Parameters, ScrewJoint};
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, ONE};
use quantities::{Measure, Torque};

/// Both joints, and the field of application where a special one is stated.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters, demand: Option<&Demand>, checks: &mut Vec<Check>) {
    let peak = demand.map(|demand| demand.torque_peak);
    // In a collision the joints carry its torque.
    let peak = match (peak, axis.asked.collision_torque) {
        (Some(peak), Some(collision)) => Some(if collision.si() > peak.si() { collision } else { peak }),
        (peak, _) => peak,
    };
    checks.push(joint(CheckId::ScrewJointLoad, &actuator.screw_joint_load, "transmissible_torque_load", peak));
    checks.push(joint(CheckId::ScrewJointHousing, &actuator.screw_joint_housing, "transmissible_torque_housing", peak));
    if axis.asked.special_application.is_some() {
        let mut check = not_checked(CheckId::Application, Missing { symbol: "approval" });
        check.verdict = Verdict::Advice;
        check.missing = None;
        // One approval is needed, none is at hand.
        check.value = Some(Figure { si: 1.0, unit: &ONE });
        check.limit = Some(Figure { si: 0.0, unit: &ONE });
        check.grade = Some(Grade::Printed);
        check.value_source = Some(Source::Project { key: "requirements.special_application".into() });
        check.notes.push(Note::ApprovalNeeded);
        checks.push(check);
    }
}

/// T_peak ≤ the torque that the screws transmit by friction (table 79.1).
fn joint(id: CheckId, joint: &ScrewJoint, symbol: &'static str, peak: Option<Torque>) -> Check {
    let Some(peak) = peak else { return not_checked(id, Missing { symbol: "J_out" }) };
    match joint.transmissible_torque.require(symbol) {
        Ok(limit) => Comparison::with(id, &NEWTON_METRE, peak.si(), Source::Model { name: "demand" }, limit)
            .answer(Verdict::Fail),
        Err(missing) => not_checked(id, missing),
    }
}
