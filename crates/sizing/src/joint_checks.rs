//! Checks of the bolted joints and of the field of application.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, not_checked, project};
use crate::list::{Case, Outcome};
use crate::notes::Note;
use crate::workings;
use actuator::{Parameters, ScrewJoint};
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, ONE};
use quantities::{Measure, Time, Torque};
use trace::{Convex, Extent, Node};

/// Compares the torque through the joint of the load with the torque that its screws transmit.
pub(crate) fn load(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let through = load_torque(case.axis, work);
    joint(CheckId::ScrewJointLoad, (&case.actuator.screw_joint_load, "transmissible_torque_load"), through, work)
}

/// Compares the torque through the joint of the housing with the torque that its screws transmit.
pub(crate) fn housing(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let through = housing_torque(case.axis, case.actuator, work)?;
    let joined = (&case.actuator.screw_joint_housing, "transmissible_torque_housing");
    joint(CheckId::ScrewJointHousing, joined, through, work)
}

/// Compares the approvals that the field of application needs with those available: one is needed, none is available.
pub(crate) fn application(_: &Case<'_>, work: &mut Workings) -> Outcome {
    let key = "requirements.special_application";
    let source = project(key);
    work.stated("approvals_needed", &ONE, 1.0, key);
    work.value("approvals_needed");
    work.figure("approvals", &ONE, 0.0, &source, Grade::Assumed);
    work.limit("approvals");
    Ok(Check {
        verdict: Verdict::Advice,
        missing: None,
        value: Some(Amount { si: 1.0, unit: &ONE }),
        limit: Some(Amount { si: 0.0, unit: &ONE }),
        grade: Some(Grade::Printed),
        value_source: Some(source),
        notes: Note::ApprovalNeeded.into(),
        ..not_checked(CheckId::Application, Missing { symbol: "approval" })
    })
}

/// Torque through a joint, its instant, and its symbol in the derivation.
type Through = (Torque, Option<Time>, &'static str);

/// Returns the torque of a collision if it is above that of the cycle: both joints carry it.
fn collision(axis: &Axis, cycle: f64, work: &mut Workings) -> Option<Through> {
    let torque = axis.asked.collision_torque.filter(|torque| torque.si() > cycle)?;
    work.stated("T_k", &NEWTON_METRE, torque.si(), "requirements.collision_torque");
    Some((torque, None, "T_k"))
}

/// Returns the torque through the joint of the load: the torque of the load. The rotor is on the other side of it.
fn load_torque(axis: &Axis, work: &mut Workings) -> Through {
    let moments = axis.moments();
    if let Some(collision) = collision(axis, moments.load_peak.si(), work) {
        return collision;
    }
    workings::peak_load(axis, "T_j", work);
    (moments.load_peak, Some(moments.load_peak_at), "T_j")
}

/// Returns the torque through the joint of the housing.
///
/// T_j = |T_L| + (J_out/i) |α|
///
/// The angular momentum of the rotating inner parts is that of the rotor, J_out/i² times i ω, in or against the
/// direction of the output depending on the design of the gear: the housing takes T_L and the change of that momentum,
/// in the worst case with the same sign.
///
/// # Source
/// docs/theory/gear.md
fn housing_torque(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Result<Through, Missing> {
    let own = actuator.inertia_out.require("J_out")?.value.si();
    // For an own actuator the ratio may be unknown: without a gear the whole of J_out acts on the housing, which is the
    // maximum.
    let ratio = actuator.ratio.known();
    let inertia = own / ratio.map_or(1.0, |ratio| ratio.value);
    let bound = |extent: &Extent| extent.torque(inertia).max(extent.torque(-inertia));
    let value = |node: &Node| node.load_nm.abs() + inertia * node.acceleration_rad_s2.abs();
    let (torque, node) = axis.trace.largest(&Convex(bound, value));
    if let Some(collision) = collision(axis, torque, work) {
        return Ok(collision);
    }
    if work.is_on() {
        workings::instant(axis, &node, actuator, work);
        let text = match ratio {
            Some(ratio) => {
                work.given_number("i", ratio);
                "abs(T_L) + J_out/i*abs(alpha)"
            }
            None => "abs(T_L) + J_out*abs(alpha)",
        };
        work.formula("T_j", &NEWTON_METRE, torque, text, &Source::Model { name: "gear" });
    }
    Ok((Torque::from_si(torque), Some(Time::from_si(node.time_s)), "T_j"))
}

/// Checks that the torque through a joint ≤ the torque that its screws transmit by friction (table 79.1).
fn joint(
    id: CheckId,
    (joint, symbol): (&ScrewJoint, &'static str),
    (torque, at, name): Through,
    work: &mut Workings,
) -> Outcome {
    work.value(name);
    let limit = joint.transmissible_torque.require(symbol)?;
    work.given("T_trans", &NEWTON_METRE, limit);
    work.limit("T_trans");
    let source = match name {
        "T_k" => project("requirements.collision_torque"),
        _ => Source::Model { name: "demand" },
    };
    Ok(Comparison { at, ..Comparison::with(id, &NEWTON_METRE, torque.si(), source, limit) }.answer(Verdict::Fail))
}
