//! The checks of the gear.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{Comparison, at_least, equation, not_checked, shown_or_at_most};
use actuator::{BudgetCase, Parameters, PositionLoop};
use provenance::{Datum, Grade, Missing, Source, Sourced};
use quantities::unit::{ARCMINUTE, HERTZ, HOUR, MILLIMETRE, NEWTON_METRE, ONE, PERCENT, REVOLUTION_PER_MINUTE};
use quantities::{AngularVelocity, Measure, Ratio, Time, Torque};

/// Every check of the gear. It carries the torque of the load only: the rotor's inertia is on its other side.
/// `bare`: without those that have no limit because none is asked for.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters, bare: bool, checks: &mut Vec<Check>) {
    let asked = &axis.asked;
    checks.push(mean_torque(axis, actuator));
    checks.extend((!bare || asked.gear_life_min.is_some()).then(|| life(axis, actuator)));
    checks.extend((!bare || asked.torsion_max.is_some()).then(|| torsion(axis, actuator)));
    checks.extend((!bare || asked.natural_frequency_min.is_some()).then(|| natural_frequency(axis, actuator)));
}

/// The checks of the gear that only matter where nothing else fails. `bare`: without advice, and without those that have
/// no limit because none is asked for.
pub(crate) fn judge_further(axis: &Axis, actuator: &Parameters, bare: bool, checks: &mut Vec<Check>) {
    let asked = &axis.asked;
    checks.push(mean_input_speed(axis, actuator));
    checks.extend(asked.collision_torque.map(|torque| collision(axis, torque, actuator)));
    checks.extend((!bare).then(|| resonance(axis, actuator)));
    let judged = asked.angle_error_max.is_some() || asked.deviation_max.is_some();
    checks.extend((!bare || judged).then(|| error_budget(axis, actuator)));
}

/// i n_av ≤ n_in,av; only where a limit of the gear is published.
fn mean_input_speed(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::GearMeanInputSpeed;
    let found =
        actuator.gear.input_speed_mean_max.require("n_in_av").and_then(|l| Ok((l, actuator.ratio.require("i")?)));
    match found {
        Ok((limit, ratio)) => {
            let speed = axis.moments().speed_mean().si() * ratio.value;
            Comparison {
                notes: vec![Note::RatingOfInterchangeableGear],
                ..Comparison::with(id, &REVOLUTION_PER_MINUTE, speed, equation("69.3"), limit)
            }
            .answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// T_k ≤ T_M, and the number of collisions; only where a rating of the gear is published.
fn collision(axis: &Axis, torque: Torque, actuator: &Parameters) -> Check {
    let id = CheckId::CollisionTorque;
    let limit = match actuator.gear.collision_torque_max.require("T_M") {
        Ok(limit) => limit,
        Err(missing) => return not_checked(id, missing),
    };
    let key = |key: &'static str| Source::Project { key: key.into() };
    let mut check = Comparison::with(id, &NEWTON_METRE, torque.si(), key("requirements.collision_torque"), limit)
        .answer(Verdict::Fail);
    // At the peak speed a collision lasts for the most turns of the wave generator.
    let permitted = axis.asked.collision_time.zip(actuator.ratio.known()).map(|(time, ratio)| {
        let speed_in = AngularVelocity::from_si(axis.moments().speed_peak.si() * ratio.value);
        actuator::collisions_permitted(speed_in, time)
    });
    if let (Some(count), Some(permitted)) = (axis.asked.collisions, permitted) {
        let most = Sourced {
            value: Ratio::from_si(permitted),
            source: Source::Model { name: "gear" },
            grade: limit.grade,
            errata: &[],
        };
        let number = Comparison::with(id, &ONE, count, key("requirements.collisions"), &most).answer(Verdict::Fail);
        // Of torque and number the tighter one is told.
        if number.utilisation > check.utilisation {
            check = number;
        }
    }
    check.notes.push(Note::RatingOfInterchangeableGear);
    check.notes.extend(permitted.map(Note::CollisionsPermitted));
    check
}

/// Half width of the band around a resonance speed in which nothing should run for long: a tenth of the speed. Assumed;
/// the model has no damping and knows no amplitude.
const RESONANCE_BAND: f64 = 0.1;

/// The distance that is told where no speed is held, or every resonance lies further off.
const FAR_FROM_RESONANCE: f64 = 1.0;

/// Distance of the speeds that the cycle holds from those at which the wave generator excites the load (2 i n/60 = f on
/// each region of stiffness), relative to the latter. To hold such a speed is against advice; to pass through is not.
fn resonance(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::ResonanceSpeed;
    let inertia = axis.moments().inertia_max;
    let found = (|| {
        let ratio = actuator.ratio.require("i")?;
        let [k1, k2, k3] = &actuator.gear.stiffness;
        let stiffness = [k1.require("K_1")?, k2.require("K_2")?, k3.require("K_3")?];
        if inertia.si() <= 0.0 {
            return Err(Missing { symbol: "J_L" });
        }
        let speed = |k: &provenance::Sourced<quantities::TorsionalStiffness>| {
            actuator::resonance_speed(actuator::natural_frequency(k.value, inertia), ratio.value)
        };
        let [k1, k2, k3] = stiffness;
        Ok([speed(k1), speed(k2), speed(k3)])
    })();
    match found {
        Ok(speeds) => {
            let distance = |speed: f64| {
                speeds.iter().map(|n| (speed.abs() / n.si() - 1.0).abs()).fold(FAR_FROM_RESONANCE, f64::min)
            };
            let held = axis.motion.pieces().iter().filter(|piece| piece.speed_degree() == Some(0) && !piece.is_rest());
            let nearest =
                held.map(|piece| (distance(piece.speed_rad_s), piece.start_s)).min_by(|a, b| a.0.total_cmp(&b.0));
            let (value, at) =
                nearest.map_or((FAR_FROM_RESONANCE, None), |(value, at)| (value, Some(Time::from_si(at))));
            let source = Source::Model { name: "gear" };
            Check {
                id,
                verdict: if value >= RESONANCE_BAND { Verdict::Pass } else { Verdict::Advice },
                value: Some(Figure { si: value, unit: &PERCENT }),
                limit: Some(Figure { si: RESONANCE_BAND, unit: &PERCENT }),
                utilisation: (value > 0.0).then(|| RESONANCE_BAND / value),
                at,
                grade: Some(Grade::Assumed),
                value_source: Some(source.clone()),
                limit_source: Some(source),
                missing: None,
                notes: vec![Note::ResonanceSpeeds(speeds)],
                workings: Vec::new(),
            }
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// Sum of all angular errors at the output, and its deviation at the lever arm.
fn error_budget(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::ErrorBudget;
    let offset = actuator.output_bearing.offset.known();
    let moment = axis.bearing.as_ref().zip(offset).map_or(0.0, |(duty, offset)| {
        duty.loads.iter().map(|load| actuator::tilting_moment(load, offset.value).si()).fold(0.0, f64::max)
    });
    let case = BudgetCase {
        torque: axis.moments().load_peak,
        tilting_moment: Torque::from_si(moment),
        position_loop: if axis.asked.loop_at_output { PositionLoop::Output } else { PositionLoop::Motor },
    };
    if axis.asked.loop_at_output && matches!(actuator.feedback_out.accuracy, Datum::NotApplicable) {
        return not_checked(id, Missing { symbol: "EC" });
    }
    let budget = actuator::error_budget(actuator, &case);
    if budget.contributions.is_empty() {
        return not_checked(id, Missing { symbol: "transmission_accuracy" });
    }
    let worst = budget.worst_case();
    let deviation = axis.asked.lever_arm.map(|lever| actuator::deviation_at(worst, lever));
    let source = Source::Model { name: "error-budget" };
    let mut check = match (deviation, axis.asked.deviation_max) {
        (Some(deviation), Some(permitted)) => {
            let key = "requirements.deviation_max";
            shown_or_at_most(id, &MILLIMETRE, deviation.si(), Some(permitted.si()), key, source)
        }
        _ => {
            let permitted = axis.asked.angle_error_max.map(Measure::si);
            shown_or_at_most(id, &ARCMINUTE, worst.si(), permitted, "requirements.angle_error_max", source)
        }
    };
    check.grade = Some(budget.grade());
    check.notes.push(Note::Budget {
        root_sum_square: budget.root_sum_square(),
        deviation,
        missing: budget.missing.len(),
    });
    check
}

/// T_av ≤ T_A; only where a rating of the gear is published.
fn mean_torque(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::GearMeanTorque;
    match actuator.gear.average_torque_max.require("T_A") {
        Ok(limit) => Comparison {
            notes: vec![Note::RatingOfInterchangeableGear],
            ..Comparison::with(id, &NEWTON_METRE, axis.load_cubic_mean().si(), Source::Model { name: "gear" }, limit)
        }
        .answer(Verdict::Fail),
        Err(missing) => not_checked(id, missing),
    }
}

/// L_10 of the wave-generator bearing against the life required.
fn life(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::GearLife;
    let found = (|| {
        let rated = actuator.gear.rated_torque.require("T_N")?;
        let ratio = actuator.ratio.require("i")?;
        let mean = axis.load_cubic_mean();
        let speed = AngularVelocity::from_si(axis.moments().speed_mean().si() * ratio.value);
        if speed.si() <= 0.0 || mean.si() <= 0.0 {
            return Err(Missing { symbol: "n_av" });
        }
        Ok((actuator::wave_generator_life(rated.value, mean, speed), rated.grade))
    })();
    match found {
        Ok((life, grade)) => {
            let asked = axis.asked.gear_life_min.map(Measure::si);
            let source = Source::Model { name: "gear" };
            let mut check = at_least(id, &HOUR, life.si(), asked, "requirements.gear_life_min", source);
            check.grade = Some(grade.worst(Grade::Computed));
            check.notes.push(Note::RatingOfInterchangeableGear);
            check
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// Torsion of the gear under the largest torque of the load.
fn torsion(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::Torsion;
    let Some(curve) = actuator.gear.torsion() else { return not_checked(id, Missing { symbol: "K_1" }) };
    let worst = axis.moments().load_peak;
    let source = Source::Equation { document: "cha-manual", number: "73.1" };
    let limit = axis.asked.torsion_max.map(Measure::si);
    let mut check =
        shown_or_at_most(id, &ARCMINUTE, curve.angle(worst).si(), limit, "requirements.torsion_max", source);
    check.at = Some(axis.moments().load_peak_at);
    check
}

/// First natural frequency of the load on the softest region of the gear, against the least that is asked.
fn natural_frequency(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::NaturalFrequency;
    let [softest, _, _] = &actuator.gear.stiffness;
    let found = softest
        .require("K_1")
        .and_then(|k| if axis.moments().inertia_max.si() > 0.0 { Ok(k) } else { Err(Missing { symbol: "J_L" }) });
    match found {
        Ok(k) => {
            let frequency = actuator::natural_frequency(k.value, axis.moments().inertia_max);
            let asked = axis.asked.natural_frequency_min.map(Measure::si);
            let source = Source::Model { name: "gear" };
            at_least(id, &HERTZ, frequency.si(), asked, "requirements.natural_frequency_min", source)
        }
        Err(missing) => not_checked(id, missing),
    }
}
