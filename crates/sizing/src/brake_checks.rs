//! The checks of the holding brake.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{Comparison, not_checked, shown_or_at_most};
use actuator::{Brake, Parameters, StopOutcome};
use motion::Hold;
use provenance::{Datum, Grade, Missing, Source};
use quantities::unit::{DEGREE, NEWTON_METRE, ONE};
use quantities::{Measure, MomentOfInertia};

/// Below this share of the load's weight nothing hangs: rounding of an angle.
const HANGING: f64 = 1e-9;

/// The checks of the brake; none where there is no brake and none is asked for.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters) -> Vec<Check> {
    let brake = &actuator.brake;
    if hangs(axis) && axis.motion.stretches().iter().any(|stretch| stretch.hold == Hold::Free) {
        return vec![free(axis)];
    }
    let asked = axis.motion.stretches().iter().any(|stretch| stretch.hold == Hold::Brake);
    match brake.holding_torque {
        Datum::NotApplicable if asked => vec![absent(axis)],
        Datum::NotApplicable => Vec::new(),
        Datum::NotPrinted if !asked => Vec::new(),
        _ if !axis.mechanism.knows_holding_torque() => {
            let missing = Missing { symbol: "mechanism.joint.holding_torque" };
            vec![not_checked(CheckId::BrakeHolding, missing), not_checked(CheckId::BrakeEmergency, missing)]
        }
        _ => vec![holding(axis, actuator, brake), emergency(axis, actuator, brake)],
    }
}

/// Nothing holds: the load stays only where friction at the output is at least what moves it.
fn free(axis: &Axis) -> Check {
    let friction = provenance::Sourced {
        value: axis.mechanism.friction.coulomb,
        source: Source::Project { key: "friction_torque".into() },
        grade: Grade::Computed,
        errata: &[],
    };
    Comparison {
        notes: vec![Note::NothingHolds],
        ..Comparison::with(
            CheckId::BrakeHolding,
            &NEWTON_METRE,
            axis.moments().holding_torque.si(),
            Source::Model { name: "brake" },
            &friction,
        )
    }
    .answer(Verdict::Fail)
}

/// The motion wants to be held by a brake that is not there.
fn absent(axis: &Axis) -> Check {
    let none = Source::Project { key: "motion.hold".into() };
    Check {
        id: CheckId::BrakeHolding,
        verdict: Verdict::Fail,
        value: Some(Figure { si: axis.moments().holding_torque.si(), unit: &NEWTON_METRE }),
        limit: Some(Figure { si: 0.0, unit: &NEWTON_METRE }),
        utilisation: None,
        at: None,
        grade: Some(Grade::Printed),
        value_source: Some(Source::Model { name: "brake" }),
        limit_source: Some(none),
        missing: None,
        notes: vec![Note::NoBrake],
        workings: Vec::new(),
    }
}

fn hangs(axis: &Axis) -> bool {
    axis.moments().holding_torque.si() > HANGING
}

fn total_inertia(axis: &Axis, actuator: &Parameters) -> Result<MomentOfInertia, Missing> {
    // The lightest load moves most while the brake closes.
    let least = MomentOfInertia::from_si(axis.trace.inertia.1);
    Ok(actuator.inertia_out.require("J_out")?.value + least)
}

/// T_Br ≥ gravity, process and external torque at every instant, without the help of friction: the drive may fail at any.
fn holding(axis: &Axis, actuator: &Parameters, brake: &Brake) -> Check {
    let id = CheckId::BrakeHolding;
    let limit = match brake.holding_torque.require("T_Br") {
        Ok(limit) => limit,
        Err(missing) => return not_checked(id, missing),
    };
    let torque = axis.moments().holding_torque;
    let mut notes = Vec::new();
    if hangs(axis) {
        notes.push(Note::HangingLoad);
        if let (Ok(inertia), Some(closing)) = (total_inertia(axis, actuator), brake.closing_time.known()) {
            notes.push(Note::Sag(actuator::sag_angle(inertia, torque, closing.value)));
        }
    }
    Comparison { notes, ..Comparison::with(id, &NEWTON_METRE, torque.si(), Source::Model { name: "brake" }, limit) }
        .answer(Verdict::Fail)
}

/// A stop from the peak speed by the brake alone, the load driving on: its angle, and how many of them.
fn emergency(axis: &Axis, actuator: &Parameters, brake: &Brake) -> Check {
    let id = CheckId::BrakeEmergency;
    let found = (|| {
        let torque = brake.holding_torque.require("T_Br")?.value;
        let closing = brake.closing_time.require("t_c")?.value;
        let stated = !matches!(axis.mechanism.kind, mechanism::Kind::Joint(_));
        if !stated && axis.moments().inertia_max.si() <= 0.0 {
            return Err(Missing { symbol: "J_L" });
        }
        // The heaviest load is hardest to stop.
        let inertia = actuator.inertia_out.require("J_out")?.value + axis.moments().inertia_max;
        Ok((torque, closing, inertia))
    })();
    let (torque, closing, inertia) = match found {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let source = Source::Model { name: "brake" };
    let driving = axis.moments().holding_torque;
    let permitted = brake.emergency_max.known();
    let stop = match actuator::emergency_stop(inertia, axis.moments().speed_peak, torque, driving, closing) {
        StopOutcome::Stops(stop) => stop,
        StopOutcome::DoesNotStop => {
            let mut check = not_checked(id, Missing { symbol: "T_Br" });
            check.verdict = Verdict::Fail;
            check.missing = None;
            check.value = Some(Figure { si: driving.si(), unit: &NEWTON_METRE });
            check.limit = Some(Figure { si: torque.si(), unit: &NEWTON_METRE });
            check.utilisation = Some(driving.si() / torque.si());
            check.grade = Some(Grade::Computed);
            check.value_source = Some(source);
            check.limit_source = brake.holding_torque.known().map(|known| known.source.clone());
            check.notes.push(Note::BrakeDoesNotStop);
            return check;
        }
    };
    let angle = axis.asked.stop_angle_max.map(Measure::si);
    let mut check = shown_or_at_most(id, &DEGREE, stop.angle.si(), angle, "requirements.stop_angle_max", source);
    if let (Some(count), Some(limit)) = (axis.asked.emergency_stops, permitted) {
        let key = Source::Project { key: "requirements.emergency_stops".into() };
        let number = Comparison {
            limit: limit.value,
            limit_source: &limit.source,
            errata: limit.errata,
            ..Comparison::with(id, &ONE, count, key, &limit.clone().map(quantities::Ratio::from_si))
        }
        .answer(Verdict::Fail);
        // Of angle and number the tighter one is told.
        let share = |check: &Check| check.utilisation.unwrap_or(0.0);
        if check.verdict == Verdict::NotChecked || share(&number) > share(&check) {
            check = number;
        }
    }
    check.notes.push(Note::BrakeStop {
        angle: stop.angle,
        time: stop.time,
        energy: stop.energy,
        permitted: permitted.map(|permitted| permitted.value),
    });
    check
}
