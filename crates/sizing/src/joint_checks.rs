//! The checks of the screw joints and of the field of application.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{Comparison, explained, not_checked};
use crate::demand::Demand;
use crate::workings;
use actuator::{Parameters, ScrewJoint};
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, ONE};
use quantities::{Measure, Torque};

/// Both joints, and the field of application where a special one is stated.
pub(crate) fn judge(
    axis: &Axis,
    actuator: &Parameters,
    demand: Option<&Demand>,
    explain: bool,
    checks: &mut Vec<Check>,
) {
    // In a collision the joints carry its torque.
    let peak = |work: &mut Workings| {
        let demand = demand?;
        match axis.asked.collision_torque {
            Some(collision) if collision.si() > demand.torque_peak.si() => {
                let key = Source::Project { key: "requirements.collision_torque".into() };
                work.figure("T_peak", &NEWTON_METRE, collision.si(), &key, Grade::Printed);
                Some(collision)
            }
            _ => {
                workings::peak_torque(axis, actuator, demand, work);
                Some(demand.torque_peak)
            }
        }
    };
    for (id, screws, symbol) in [
        (CheckId::ScrewJointLoad, &actuator.screw_joint_load, "transmissible_torque_load"),
        (CheckId::ScrewJointHousing, &actuator.screw_joint_housing, "transmissible_torque_housing"),
    ] {
        checks.push(explained(explain, |work| {
            let peak = peak(work);
            joint(id, screws, symbol, peak, work)
        }));
    }
    if axis.asked.special_application.is_some() {
        let mut work = if explain { Workings::on() } else { Workings::off() };
        let mut check = not_checked(CheckId::Application, Missing { symbol: "approval" });
        check.verdict = Verdict::Advice;
        check.missing = None;
        // One approval is needed, none is at hand.
        check.value = Some(Figure { si: 1.0, unit: &ONE });
        check.limit = Some(Figure { si: 0.0, unit: &ONE });
        check.grade = Some(Grade::Printed);
        check.value_source = Some(Source::Project { key: "requirements.special_application".into() });
        check.notes.to_mut().push(Note::ApprovalNeeded);
        let source = Source::Project { key: "requirements.special_application".into() };
        work.figure("approvals_needed", &ONE, 1.0, &source, Grade::Printed);
        work.value("approvals_needed");
        work.figure("approvals", &ONE, 0.0, &source, Grade::Assumed);
        work.limit("approvals");
        check.workings = work.into_steps();
        checks.push(check);
    }
}

/// T_peak ≤ the torque that the screws transmit by friction (table 79.1).
fn joint(id: CheckId, joint: &ScrewJoint, symbol: &'static str, peak: Option<Torque>, work: &mut Workings) -> Check {
    let Some(peak) = peak else { return not_checked(id, Missing { symbol: "J_out" }) };
    work.value("T_peak");
    match joint.transmissible_torque.require(symbol) {
        Ok(limit) => {
            work.given("T_trans", &NEWTON_METRE, limit);
            work.limit("T_trans");
            Comparison::with(id, &NEWTON_METRE, peak.si(), Source::Model { name: "demand" }, limit)
                .answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}
