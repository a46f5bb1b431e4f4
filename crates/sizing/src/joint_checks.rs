//! The checks of the screw joints and of the field of application.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Verdict};
use crate::comparison::{Comparison, explained, not_checked};
use crate::notes::Note;
use crate::workings;
use actuator::{Parameters, ScrewJoint};
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, ONE, RADIAN_PER_SECOND_SQUARED, SECOND};
use quantities::{Measure, Time, Torque};
use trace::{Convex, Extent, Node};

/// Both joints, and the field of application where a special one is stated.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters, explain: bool, checks: &mut Vec<Check>) {
    let load = (&actuator.screw_joint_load, "transmissible_torque_load");
    let housing = (&actuator.screw_joint_housing, "transmissible_torque_housing");
    checks.push(explained(explain, |work| joint(CheckId::ScrewJointLoad, load, load_torque(axis, work), work)));
    checks.push(explained(explain, |work| {
        joint(CheckId::ScrewJointHousing, housing, housing_torque(axis, actuator, work), work)
    }));
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
        check.notes.push(Note::ApprovalNeeded);
        let source = Source::Project { key: "requirements.special_application".into() };
        work.figure("approvals_needed", &ONE, 1.0, &source, Grade::Printed);
        work.value("approvals_needed");
        work.figure("approvals", &ONE, 0.0, &source, Grade::Assumed);
        work.limit("approvals");
        check.workings = work.into_steps().into();
        checks.push(check);
    }
}

/// Torque through a joint, the instant of it, and its symbol in the workings.
type Through = (Torque, Option<Time>, &'static str);

/// The torque of a collision where it is above that of the cycle: both joints carry it.
fn collision(axis: &Axis, cycle: f64, work: &mut Workings) -> Option<Through> {
    let torque = axis.asked.collision_torque.filter(|torque| torque.si() > cycle)?;
    let key = Source::Project { key: "requirements.collision_torque".into() };
    work.figure("T_k", &NEWTON_METRE, torque.si(), &key, Grade::Printed);
    Some((torque, None, "T_k"))
}

/// What passes through the joint of the load: the torque of the load. The rotor turns on the other side of it.
fn load_torque(axis: &Axis, work: &mut Workings) -> Result<Through, Missing> {
    let moments = axis.moments();
    if let Some(collision) = collision(axis, moments.load_peak.si(), work) {
        return Ok(collision);
    }
    let text = "max |T_L| over the cycle";
    work.found("T_j", &NEWTON_METRE, moments.load_peak.si(), text, &workings::DEMAND, Grade::Computed);
    Ok((moments.load_peak, Some(moments.load_peak_at), "T_j"))
}

/// What passes through the joint of the housing.
///
/// T_j = |T_L| + (J_out/i) |α|
///
/// The angular momentum of what turns inside is that of the rotor, J_out/i² times i ω, forwards or backwards with the
/// output according to the build of the gear: the housing takes T_L and what changes it, in the worst case with the same
/// sign.
///
/// # Source   docs/theory/gear.md
fn housing_torque(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Result<Through, Missing> {
    let own = actuator.inertia_out.require("J_out")?.value.si();
    // Of an own actuator the ratio may not be known: without a gear the whole of J_out acts on the housing, the most.
    let ratio = actuator.ratio.known();
    let inertia = own / ratio.map_or(1.0, |ratio| ratio.value);
    let bound = |extent: &Extent| extent.torque(inertia).max(extent.torque(-inertia));
    let value = |node: &Node| node.load_nm.abs() + inertia * node.acceleration_rad_s2.abs();
    let (torque, node) = axis.trace.largest(&Convex(bound, value));
    if let Some(collision) = collision(axis, torque, work) {
        return Ok(collision);
    }
    if work.is_on() {
        let demand = &workings::DEMAND;
        workings::own_inertia(actuator, work);
        work.figure("t", &SECOND, node.time_s, demand, Grade::Computed);
        work.found(
            "alpha",
            &RADIAN_PER_SECOND_SQUARED,
            node.acceleration_rad_s2,
            "acceleration at t",
            demand,
            Grade::Computed,
        );
        work.found("T_L", &NEWTON_METRE, node.load_nm, "torque of the load at t", demand, Grade::Computed);
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

/// The torque through a joint ≤ what its screws transmit by friction (table 79.1).
fn joint(
    id: CheckId,
    (joint, symbol): (&ScrewJoint, &'static str),
    through: Result<Through, Missing>,
    work: &mut Workings,
) -> Check {
    let (torque, at, name) = match through {
        Ok(through) => through,
        Err(missing) => return not_checked(id, missing),
    };
    work.value(name);
    match joint.transmissible_torque.require(symbol) {
        Ok(limit) => {
            work.given("T_trans", &NEWTON_METRE, limit);
            work.limit("T_trans");
            let source = match name {
                "T_k" => Source::Project { key: "requirements.collision_torque".into() },
                _ => Source::Model { name: "demand" },
            };
            Comparison { at, ..Comparison::with(id, &NEWTON_METRE, torque.si(), source, limit) }.answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}
