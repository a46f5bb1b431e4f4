//! The checks of one actuator for one axis.

use crate::axis::Axis;
use crate::bearing_checks;
use crate::brake_checks;
use crate::check::{Check, CheckId, Figure, Note, Notes, Verdict};
use crate::comparison::{Comparison, cite, equation, explained, not_checked};
use crate::currents::{self, Currents};
use crate::demand::{Demand, ManualDemand};
use crate::electric_checks;
use crate::energy;
use crate::feedback_checks;
use crate::gear_checks;
use crate::heat_checks;
use crate::joint_checks;
use crate::workings;
use actuator::Parameters;
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{DEGREE_CELSIUS, KILOGRAM_SQUARE_METRE, NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{Measure, ThermodynamicTemperature};
use std::borrow::Cow;

/// J_L ≤ 3 J_out is recommended for highly dynamic duty (table 70.1).
const INERTIA_RATIO_RECOMMENDED: f64 = 3.0;

/// Room for the checks of an actuator that is rejected, and for all of one that is not, so that judging many does not
/// grow one vector after the other.
const ROOM: [usize; 2] = [22, 40];

/// Everything there is to say about one actuator for one axis.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// The demand by exact integrals; checks use it. `None` if the own inertia is not known.
    pub demand: Option<Demand>,
    /// The demand by the manual's equations, shown beside it.
    pub manual: Option<ManualDemand>,
    /// Every check, in a fixed order.
    pub checks: Vec<Check>,
}

impl Judgement {
    /// Whether no check fails.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.checks.iter().all(|check| check.verdict != Verdict::Fail)
    }

    /// The failing check that is exceeded most, if any.
    #[must_use]
    pub fn worst_failure(&self) -> Option<&Check> {
        let key = |check: &Check| check.utilisation.unwrap_or(f64::INFINITY);
        self.checks.iter().filter(|c| c.verdict == Verdict::Fail).max_by(|a, b| key(a).total_cmp(&key(b)))
    }

    /// The largest utilisation among the checks with a margin; infinite where a limit of zero
    /// is exceeded.
    #[must_use]
    pub fn utilisation(&self) -> f64 {
        let share = |check: &Check| match check.utilisation {
            None if check.verdict == Verdict::Fail && check.id != CheckId::Ambient => f64::INFINITY,
            share => share.unwrap_or(0.0),
        };
        self.checks
            .iter()
            .filter(|check| check.id.has_margin() || check.verdict == Verdict::Fail)
            .map(share)
            .fold(0.0, f64::max)
    }

    /// The check with that utilisation.
    #[must_use]
    pub fn tightest(&self) -> Option<&Check> {
        self.checks
            .iter()
            .filter(|check| check.id.has_margin() && check.utilisation.is_some())
            .max_by(|a, b| a.utilisation.unwrap_or(0.0).total_cmp(&b.utilisation.unwrap_or(0.0)))
    }
}

/// How far a judgement goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Every check.
    Full,
    /// The checks that look at the cycle once more only if none of the others fails.
    Survivors,
    /// Every check that can fail or has a margin: what is only shown or advised is left out, and so is the demand by
    /// the manual. Verdict and utilisation are those of [`Depth::Full`].
    Margins,
}

/// Judges one actuator for one axis.
#[must_use]
pub fn judge(axis: &Axis, actuator: &Parameters, depth: Depth) -> Judgement {
    judge_with(axis, actuator, depth, false)
}

/// Judges one actuator for one axis by every check, each with the workings of its value and its limit.
#[must_use]
pub fn explain(axis: &Axis, actuator: &Parameters) -> Judgement {
    judge_with(axis, actuator, Depth::Full, true)
}

fn judge_with(axis: &Axis, actuator: &Parameters, depth: Depth, explain: bool) -> Judgement {
    let inertia = actuator.inertia_out.known().map(|known| known.value);
    let demand = inertia.map(|inertia| axis.demand(inertia));
    let bare = depth == Depth::Margins;
    let manual = inertia.filter(|_| !bare).and_then(|inertia| axis.manual_demand(inertia));
    let [rejected, all] = ROOM;
    let mut checks = Vec::with_capacity(if depth == Depth::Survivors { rejected } else { all });
    // Pushed one by one: a check is large, and a list of them would be copied once more.
    let demands = (demand.as_ref(), manual.as_ref());
    checks.push(explained(explain, |work| peak_torque(axis, actuator, demands, work)));
    checks.push(explained(explain, |work| peak_speed(axis, actuator, work)));
    checks.push(explained(explain, |work| mean_speed(axis, actuator, work)));
    let currents = Currents::of(axis, actuator);
    let currents = currents.as_ref();
    checks.push(explained(explain, |work| heat_checks::continuous_torque(axis, actuator, currents, demands, work)));
    checks.extend(currents::current_checks(axis, actuator, currents, explain));
    if axis.supply.is_some() {
        checks.push(explained(explain, |work| currents::voltage(axis, actuator, currents, work)));
    }
    if !bare {
        checks.push(explained(explain, |work| inertia_ratio(axis, actuator, work)));
    }
    gear_checks::judge(axis, actuator, (bare, explain), &mut checks);
    bearing_checks::judge(axis, &actuator.output_bearing, explain, &mut checks);
    if let Some(stated) = axis.ambient {
        checks.push(explained(explain, |work| ambient(stated, actuator, work)));
    }
    if let Some((supply, _)) = axis.supply {
        checks
            .push(explained(explain, |work| electric_checks::dc_link(supply, axis.asked.dc_link_rise, actuator, work)));
    }
    if depth != Depth::Survivors || checks.iter().all(|check| check.verdict != Verdict::Fail) {
        checks.reserve_exact(all - checks.len().min(all));
        checks.push(explained(explain, |work| electric_checks::torque_speed_trace(axis, actuator, currents, work)));
        checks.push(explained(explain, |work| heat_checks::thermal(axis, actuator, currents, work)));
        checks.push(explained(explain, |work| heat_checks::overload(axis, actuator, currents, work)));
        if !bare || axis.asked.regeneration_power_max.is_some() {
            checks.push(explained(explain, |work| energy::regeneration(axis, actuator, currents, work)));
        }
        gear_checks::judge_further(axis, actuator, (bare, explain), &mut checks);
        checks.extend(brake_checks::judge(axis, actuator, explain));
        let asked = &axis.asked;
        let of_feedback =
            asked.absolute == Some(true) || asked.resolution_max.is_some() || asked.battery_life_min.is_some();
        if !bare || of_feedback {
            checks.extend(feedback_checks::judge(axis, actuator, explain));
        }
        joint_checks::judge(axis, actuator, explain, &mut checks);
    }
    Judgement { demand, manual, checks }
}

/// The errata of the own inertia, which is part of every torque.
pub(crate) fn inertia_errata(actuator: &Parameters) -> &'static [&'static str] {
    actuator.inertia_out.known().map_or(&[], |known| known.errata)
}

/// Says that eq. 69.2 takes the braking torque from the accelerating time, where it does.
pub(crate) fn braking_note(manual: Option<&ManualDemand>) -> Notes {
    match manual {
        Some(manual) if manual.braking_assumed => Cow::Borrowed(&[Note::BrakingTorqueAssumed]),
        _ => Cow::Borrowed(&[]),
    }
}

/// The manual's equation where it describes the axis and sees every braking torque, else the exact integral.
pub(crate) fn demand_source(manual: Option<&ManualDemand>, number: &'static str) -> Source {
    match manual {
        Some(manual) if !manual.braking_assumed => equation(number),
        _ => Source::Model { name: "demand" },
    }
}

/// The exact demand, and that of the manual.
pub(crate) type Demands<'a> = (Option<&'a Demand>, Option<&'a ManualDemand>);

/// T_peak ≤ T_max (cha-manual 7.1: T_1 < T_max; glossary T_max: largest accelerating and braking torque).
fn peak_torque(axis: &Axis, actuator: &Parameters, (demand, manual): Demands<'_>, work: &mut Workings) -> Check {
    let id = CheckId::PeakTorque;
    let (limit, demand) = match (actuator.torque_max.require("T_max"), demand) {
        (Ok(limit), Some(demand)) => (limit, demand),
        (Err(missing), _) => return not_checked(id, missing),
        (_, None) => return not_checked(id, Missing { symbol: "J_out" }),
    };
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
    Comparison {
        at: Some(demand.torque_peak_at),
        notes,
        ..Comparison::with(id, &NEWTON_METRE, demand.torque_peak.si(), value_source, limit)
    }
    .answer(Verdict::Fail)
}

/// n_peak ≤ n_mot,max / i, the exact quotient.
fn peak_speed(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::PeakSpeed;
    match actuator::speed_max_with(actuator, work) {
        Ok(limit) => {
            let key = if axis.motion.recordings().is_empty() { "motion.speed" } else { "motion.file" };
            let source = Source::Project { key: key.into() };
            let value = axis.moments.speed_peak.si();
            work.limit("n_max");
            work.found("n_peak", &REVOLUTION_PER_MINUTE, value, "max |n| over the cycle", &source, Grade::Computed);
            work.value("n_peak");
            Comparison {
                at: Some(axis.moments.speed_peak_at),
                ..Comparison::with(id, &REVOLUTION_PER_MINUTE, value, source, &limit)
            }
            .answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// n_av ≤ n_N / i.
fn mean_speed(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::MeanSpeed;
    match actuator::speed_rated_out_with(actuator, work) {
        Ok(limit) => {
            let value = axis.moments.speed_mean().si();
            work.limit("n_N_out");
            workings::mean_speed(axis, work);
            work.value("n_av");
            Comparison::with(id, &REVOLUTION_PER_MINUTE, value, equation("69.3"), &limit).answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// J_L ≤ 3 J_out is recommended for highly dynamic duty (table 70.1).
fn inertia_ratio(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::InertiaRatio;
    if matches!(axis.mechanism.kind, mechanism::Kind::Joint(_)) && axis.moments.inertia_max.si() <= 0.0 {
        return not_checked(id, Missing { symbol: "mechanism.joint.inertia" });
    }
    match actuator.inertia_out.require("J_out") {
        Ok(own) => {
            let source = match axis.by_the_manual() {
                Some(_) => Source::Project { key: "load.inertia".into() },
                None => Source::Model { name: "mechanisms" },
            };
            let (value, limit) = (axis.moments.inertia_max.si(), INERTIA_RATIO_RECOMMENDED * own.value.si());
            workings::own_inertia(actuator, work);
            work.found("J_L", &KILOGRAM_SQUARE_METRE, value, "largest on the way", &source, Grade::Computed);
            work.value("J_L");
            let table = Source::Model { name: "demand" };
            work.formula("J_L_rec", &KILOGRAM_SQUARE_METRE, limit, "3*J_out", &table);
            work.limit("J_L_rec");
            Comparison {
                limit,
                grade: own.grade.worst(Grade::Computed),
                notes: Cow::Borrowed(&[Note::RecommendationForHighDynamics]),
                ..Comparison::with(id, &KILOGRAM_SQUARE_METRE, value, source, own)
            }
            .answer(Verdict::Advice)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// The stated ambient temperature against the range that the actuator's data hold for (tables 13.1 and 13.2).
fn ambient(stated: ThermodynamicTemperature, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::Ambient;
    let range = match actuator.ambient_range.require("ambient_temperature_operation") {
        Ok(range) => range,
        Err(missing) => return not_checked(id, missing),
    };
    let (low, high) = (range.value.0.si(), range.value.1.si());
    // A difference of a nanokelvin is a rounding of the conversion, not a warmer place.
    let inside = stated.si() >= low - 1e-9 && stated.si() <= high + 1e-9;
    let nearest = if stated.si() < low { low } else { high };
    let key = Source::Project { key: "requirements.ambient".into() };
    work.figure("theta_a", &DEGREE_CELSIUS, stated.si(), &key, Grade::Printed);
    work.value("theta_a");
    work.figure("theta_limit", &DEGREE_CELSIUS, nearest, &range.source, range.grade);
    work.limit("theta_limit");
    Check {
        id,
        verdict: if inside { Verdict::Pass } else { Verdict::Fail },
        value: Some(Figure { si: stated.si(), unit: &DEGREE_CELSIUS }),
        limit: Some(Figure { si: nearest, unit: &DEGREE_CELSIUS }),
        utilisation: None,
        at: None,
        grade: Some(range.grade),
        value_source: Some(Source::Project { key: "requirements.ambient".into() }),
        limit_source: Some(range.source.clone()),
        missing: None,
        notes: Cow::Borrowed(&[]),
        workings: Vec::new(),
    }
}

#[cfg(test)]
#[path = "checks_tests.rs"]
mod tests;
