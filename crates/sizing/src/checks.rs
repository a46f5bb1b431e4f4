//! Checks of torque, speed, inertia and ambient temperature.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, cite, equation, project, unjudged};
use crate::demand::ManualDemand;
use crate::list::{Case, Outcome};
use crate::notes::{Note, Notes};
use crate::workings::{self, Extreme};
use actuator::{Drivetrain, Parameters};
use derivation::{Finding, Workings};
use numeric::{at_least, at_most};
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{DEGREE_CELSIUS, KILOGRAM_SQUARE_METRE, NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{Measure, Torque};

/// Returns the errata of the own inertia, which is part of every torque.
pub(crate) fn inertia_errata(actuator: &Parameters) -> &'static [&'static str] {
    actuator.inertia_out.known().map_or(&[], |known| known.errata)
}

/// Returns the remark that eq. 69.2 uses the accelerating time for the braking torque, if it does.
pub(crate) fn braking_note(manual: Option<&ManualDemand>) -> Notes {
    match manual {
        Some(manual) if manual.braking_assumed => Notes::fixed(&[Note::BrakingTorqueAssumed]),
        _ => Notes::NONE,
    }
}

/// Returns the manual's equation if it describes the axis and every braking torque, else the exact integral.
pub(crate) fn demand_source(manual: Option<&ManualDemand>, number: &'static str) -> Source {
    match manual {
        Some(manual) if !manual.braking_assumed => equation(number),
        _ => Source::Model { name: "demand" },
    }
}

/// Checks T_peak ≤ T_max (cha-manual 7.1: T_1 < T_max; glossary T_max: largest accelerating and braking torque).
pub(crate) fn peak_torque(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, demand, manual, .. } = *case;
    let id = CheckId::PeakTorque;
    let limit = actuator.torque_max.require("T_max")?;
    let Some(demand) = demand else { return least_peak_torque(axis, limit, work) };
    let value_source = demand_source(manual, "69.1");
    let mut notes = braking_note(manual);
    cite(&mut notes, inertia_errata(actuator));
    if let Some(manual) = manual.filter(|manual| !manual.braking_assumed) {
        workings::manual_torques(axis, actuator, manual, work);
        work.formula(
            "T_peak",
            &NEWTON_METRE,
            demand.torque_peak.si(),
            "max(abs(T_1), abs(T_2), abs(T_3))",
            &value_source,
        );
    } else {
        workings::peak_torque(axis, actuator, demand, work);
    }
    work.value("T_peak");
    work.given("T_max", &NEWTON_METRE, limit);
    work.limit("T_max");
    Ok(Comparison {
        at: Some(demand.torque_peak_at),
        notes,
        ..Comparison::with(id, &NEWTON_METRE, demand.torque_peak.si(), value_source, limit)
    }
    .answer(Verdict::Fail))
}

/// Checks the least peak torque of an actuator without a known J_out: one that T_max does not permit fails whatever J_out is; below
/// it nothing is known.
fn least_peak_torque(axis: &Axis, limit: &Sourced<Torque>, work: &mut Workings) -> Outcome {
    let (least, at) = axis.least_peak();
    if at_most(least.si(), limit.value.si()) {
        return Err(Missing { symbol: "J_out" });
    }
    let source = Source::Model { name: "demand" };
    work.figure("T_peak", &NEWTON_METRE, least.si(), &source, Grade::Computed);
    work.value("T_peak");
    work.given("T_max", &NEWTON_METRE, limit);
    work.limit("T_max");
    Ok(Comparison {
        at: Some(at),
        notes: Note::WithAnyInertia.into(),
        ..Comparison::with(CheckId::PeakTorque, &NEWTON_METRE, least.si(), source, limit)
    }
    .answer(Verdict::Fail))
}

/// Checks n_peak ≤ n_mot,max / i, the exact quotient.
pub(crate) fn peak_speed(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::PeakSpeed;
    let limit = actuator::speed_max_with(actuator, work)?;
    let key = if axis.motion.recordings().is_empty() { "motion.speed" } else { "motion.file" };
    let source = project(key);
    let value = axis.moments.speed_peak.si();
    work.limit("n_max");
    work.found("n_peak", &REVOLUTION_PER_MINUTE, value, Finding::PeakSpeed, &source, Grade::Computed);
    work.value("n_peak");
    Ok(Comparison {
        at: Some(axis.moments.speed_peak_at),
        ..Comparison::with(id, &REVOLUTION_PER_MINUTE, value, source, &limit)
    }
    .answer(Verdict::Fail))
}

/// Checks n_av ≤ n_N / i.
pub(crate) fn mean_speed(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::MeanSpeed;
    let limit = actuator::speed_rated_out_with(actuator, work)?;
    let value = axis.moments.speed_mean().si();
    work.limit("n_N_out");
    workings::mean_speed(axis, work);
    work.value("n_av");
    Ok(Comparison::with(id, &REVOLUTION_PER_MINUTE, value, equation("69.3"), &limit).answer(Verdict::Fail))
}

/// Checks J_L ≤ k_J J_out, which is recommended for highly dynamic duty.
pub(crate) fn inertia_ratio(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::InertiaRatio;
    if matches!(axis.mechanism.kind, mechanism::MechanismKind::Joint(_)) && axis.moments.inertia_max.si() <= 0.0 {
        return Err(Missing { symbol: "mechanism.joint.inertia" });
    }
    let own = actuator.inertia_out.require("J_out")?;
    let factor = actuator.inertia_ratio_recommended.require("k_J")?;
    let source = workings::inertia_source(axis);
    let (value, limit) = (axis.moments.inertia_max.si(), factor.value * own.value.si());
    workings::own_inertia(actuator, work);
    workings::load_inertia(axis, ("J_L", Extreme::Largest), value, work);
    work.value("J_L");
    let table = Source::Model { name: "demand" };
    work.given_number("k_J", factor);
    work.formula("J_L_rec", &KILOGRAM_SQUARE_METRE, limit, "k_J*J_out", &table);
    work.limit("J_L_rec");
    Ok(Comparison {
        limit,
        grade: own.grade.worst(factor.grade).worst(Grade::Computed),
        notes: Note::RecommendationForHighDynamics { factor: factor.value }.into(),
        ..Comparison::with(id, &KILOGRAM_SQUARE_METRE, value, source, own)
    }
    .answer(Verdict::Advice))
}

/// Compares the stated ambient temperature with the range for which the actuator's data hold (tables 13.1 and 13.2).
pub(crate) fn ambient(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let stated = axis.ambient.ok_or(Missing { symbol: "requirements.ambient" })?;
    let range = actuator.ambient_range.require("ambient_temperature_operation")?;
    let (low, high) = (range.value.0.si(), range.value.1.si());
    let inside = at_least(stated.si(), low) && at_most(stated.si(), high);
    let nearest = if stated.si() < low { low } else { high };
    let key = "requirements.ambient";
    work.stated("theta_a", &DEGREE_CELSIUS, stated.si(), key);
    work.value("theta_a");
    work.figure("theta_limit", &DEGREE_CELSIUS, nearest, &range.source, range.grade);
    work.limit("theta_limit");
    Ok(Check {
        verdict: if inside { Verdict::Pass } else { Verdict::Fail },
        value: Some(Amount { si: stated.si(), unit: &DEGREE_CELSIUS }),
        limit: Some(Amount { si: nearest, unit: &DEGREE_CELSIUS }),
        grade: Some(range.grade),
        value_source: Some(project(key)),
        limit_source: Some(range.source.clone()),
        ..unjudged(CheckId::Ambient)
    })
}

#[cfg(test)]
#[path = "checks_tests.rs"]
mod tests;
