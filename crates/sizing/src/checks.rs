//! The checks of one actuator for one axis.

use crate::axis::Axis;
use crate::bearing_checks;
use crate::brake_checks;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::demand::{Demand, ManualDemand};
use crate::electric_checks;
use crate::feedback_checks;
use crate::gear_checks;
use crate::joint_checks;
use crate::trace::{Extent, Node};
use actuator::{MotorVoltage, Parameters};
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{AMPERE, DEGREE_CELSIUS, KILOGRAM_SQUARE_METRE, NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{AngularVelocity, ElectricCurrent, ElectricPotential, Measure, ThermodynamicTemperature, Time, Unit};

/// J_L ≤ 3 J_out is recommended for highly dynamic duty (table 70.1).
const INERTIA_RATIO_RECOMMENDED: f64 = 3.0;

/// Above this share of the winding's time constant a cycle is no longer short: the winding's temperature swings by
/// more than a tenth of its rise, so the effective value alone says too little.
const SHORT_CYCLE_SHARE: f64 = 0.2;

/// Room for all checks of one actuator, so that judging many does not grow one vector after the other.
const CHECKS_MOST: usize = 40;

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
    let inertia = actuator.inertia_out.known().map(|known| known.value);
    let demand = inertia.map(|inertia| axis.demand(inertia));
    let bare = depth == Depth::Margins;
    let manual = inertia.filter(|_| !bare).and_then(|inertia| axis.manual_demand(inertia));
    let mut checks = Vec::with_capacity(CHECKS_MOST);
    // Pushed one by one: a check is large, and a list of them would be copied once more.
    checks.push(peak_torque(actuator, demand.as_ref(), manual.as_ref()));
    checks.push(peak_speed(axis, actuator));
    checks.push(mean_speed(axis, actuator));
    checks.push(continuous_torque(axis, actuator, demand.as_ref(), manual.as_ref()));
    checks.extend(current_checks(axis, actuator));
    checks.extend(axis.supply.map(|(supply, reserve)| voltage(axis, actuator, supply, reserve)));
    if !bare {
        checks.push(inertia_ratio(axis, actuator));
    }
    gear_checks::judge(axis, actuator, bare, &mut checks);
    checks.extend(bearing_checks::judge(axis, &actuator.output_bearing));
    checks.extend(axis.ambient.map(|stated| ambient(stated, actuator)));
    checks.extend(axis.supply.map(|(supply, _)| electric_checks::dc_link(supply, actuator)));
    if depth != Depth::Survivors || checks.iter().all(|check| check.verdict != Verdict::Fail) {
        let currents = Currents::of(actuator);
        electric_checks::judge(axis, actuator, currents.as_ref(), &mut checks);
        if !bare || axis.asked.regeneration_power_max.is_some() {
            checks.push(electric_checks::regeneration(axis, actuator, currents.as_ref()));
        }
        gear_checks::judge_further(axis, actuator, bare, &mut checks);
        checks.extend(brake_checks::judge(axis, actuator));
        let asked = &axis.asked;
        let of_feedback =
            asked.absolute == Some(true) || asked.resolution_max.is_some() || asked.battery_life_min.is_some();
        if !bare || of_feedback {
            checks.extend(feedback_checks::judge(axis, actuator));
        }
        joint_checks::judge(axis, actuator, demand.as_ref(), &mut checks);
    }
    Judgement { demand, manual, checks }
}

/// What a check compares, before it is a [`Check`].
pub(crate) struct Comparison<'a> {
    pub(crate) id: CheckId,
    pub(crate) unit: &'static Unit,
    pub(crate) value: f64,
    pub(crate) value_source: Source,
    pub(crate) at: Option<Time>,
    pub(crate) limit: f64,
    pub(crate) limit_source: &'a Source,
    pub(crate) grade: Grade,
    pub(crate) errata: &'static [&'static str],
    pub(crate) notes: Vec<Note>,
}

impl<'a> Comparison<'a> {
    /// A value against a limit that is known with its source.
    pub(crate) fn with<Q: Measure>(
        id: CheckId,
        unit: &'static Unit,
        value: f64,
        value_source: Source,
        limit: &'a Sourced<Q>,
    ) -> Self {
        Self {
            id,
            unit,
            value,
            value_source,
            at: None,
            limit: limit.value.si(),
            limit_source: &limit.source,
            grade: limit.grade,
            errata: limit.errata,
            notes: Vec::new(),
        }
    }

    /// Pass up to and including the limit; `otherwise` beyond.
    pub(crate) fn answer(self, otherwise: Verdict) -> Check {
        let verdict = if self.value.abs() <= self.limit.abs() { Verdict::Pass } else { otherwise };
        let mut notes = self.notes;
        cite(&mut notes, self.errata);
        Check {
            id: self.id,
            verdict,
            value: Some(Figure { si: self.value, unit: self.unit }),
            limit: Some(Figure { si: self.limit, unit: self.unit }),
            utilisation: (self.limit != 0.0).then(|| (self.value / self.limit).abs()),
            at: self.at,
            grade: Some(self.grade),
            value_source: Some(self.value_source),
            limit_source: Some(self.limit_source.clone()),
            missing: None,
            notes,
        }
    }
}

pub(crate) fn not_checked(id: CheckId, missing: Missing) -> Check {
    Check {
        id,
        verdict: Verdict::NotChecked,
        value: None,
        limit: None,
        utilisation: None,
        at: None,
        grade: None,
        value_source: None,
        limit_source: None,
        missing: Some(missing.symbol),
        notes: Vec::new(),
    }
}

/// A value that grows the safer it is, against the least that is asked; with no such limit it is shown, not judged.
pub(crate) fn at_least(
    id: CheckId,
    unit: &'static Unit,
    value: f64,
    asked: Option<f64>,
    key: &'static str,
    source: Source,
) -> Check {
    let verdict = match asked {
        None => Verdict::NotChecked,
        Some(limit) if value >= limit => Verdict::Pass,
        Some(_) => Verdict::Fail,
    };
    Check {
        id,
        verdict,
        value: Some(Figure { si: value, unit }),
        limit: asked.map(|limit| Figure { si: limit, unit }),
        utilisation: asked.map(|limit| limit / value),
        at: None,
        grade: Some(Grade::Computed),
        value_source: Some(source),
        limit_source: asked.map(|_| Source::Project { key: key.into() }),
        missing: asked.is_none().then_some(key),
        notes: Vec::new(),
    }
}

/// A value that grows the worse it is, against the most that is permitted; with no such limit it is shown, not judged.
pub(crate) fn shown_or_at_most(
    id: CheckId,
    unit: &'static Unit,
    value: f64,
    permitted: Option<f64>,
    key: &'static str,
    source: Source,
) -> Check {
    let mut check = at_least(id, unit, value, permitted, key, source);
    if let Some(limit) = permitted {
        check.verdict = if value <= limit { Verdict::Pass } else { Verdict::Fail };
        check.utilisation = Some(value / limit);
    }
    check
}

/// Cites errata, each once.
fn cite(notes: &mut Vec<Note>, errata: &'static [&'static str]) {
    for id in errata {
        let note = Note::Erratum(id);
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
}

/// The errata of the own inertia, which is part of every torque.
fn inertia_errata(actuator: &Parameters) -> &'static [&'static str] {
    actuator.inertia_out.known().map_or(&[], |known| known.errata)
}

pub(crate) const fn equation(number: &'static str) -> Source {
    Source::Equation { document: "cha-manual", number }
}

/// Says that eq. 69.2 takes the braking torque from the accelerating time, where it does.
fn braking_note(manual: Option<&ManualDemand>) -> Vec<Note> {
    manual.filter(|manual| manual.braking_assumed).map(|_| Note::BrakingTorqueAssumed).into_iter().collect()
}

/// The manual's equation where it describes the axis and sees every braking torque, else the exact integral.
fn demand_source(manual: Option<&ManualDemand>, number: &'static str) -> Source {
    match manual {
        Some(manual) if !manual.braking_assumed => equation(number),
        _ => Source::Model { name: "demand" },
    }
}

/// T_peak ≤ T_max (cha-manual 7.1: T_1 < T_max; glossary T_max: largest accelerating and braking torque).
fn peak_torque(actuator: &Parameters, demand: Option<&Demand>, manual: Option<&ManualDemand>) -> Check {
    let id = CheckId::PeakTorque;
    let (limit, demand) = match (actuator.torque_max.require("T_max"), demand) {
        (Ok(limit), Some(demand)) => (limit, demand),
        (Err(missing), _) => return not_checked(id, missing),
        (_, None) => return not_checked(id, Missing { symbol: "J_out" }),
    };
    let value_source = demand_source(manual, "69.1");
    let mut notes = braking_note(manual);
    cite(&mut notes, inertia_errata(actuator));
    Comparison {
        at: Some(demand.torque_peak_at),
        notes,
        ..Comparison::with(id, &NEWTON_METRE, demand.torque_peak.si(), value_source, limit)
    }
    .answer(Verdict::Fail)
}

/// n_peak ≤ n_mot,max / i, the exact quotient.
fn peak_speed(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::PeakSpeed;
    match actuator::speed_max(actuator) {
        Ok(limit) => {
            let source = Source::Project { key: "motion.speed".into() };
            let value = axis.moments.speed_peak.si();
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
fn mean_speed(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::MeanSpeed;
    match actuator::speed_rated_out(actuator) {
        Ok(limit) => {
            let value = axis.moments.speed_mean().si();
            Comparison::with(id, &REVOLUTION_PER_MINUTE, value, equation("69.3"), &limit).answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// T_rms ≤ continuous torque at n_av (cha-manual 7.1: the point (n_av, T_rms) inside the continuous zone).
fn continuous_torque(
    axis: &Axis,
    actuator: &Parameters,
    demand: Option<&Demand>,
    manual: Option<&ManualDemand>,
) -> Check {
    let id = CheckId::ContinuousTorque;
    let Some(demand) = demand else { return not_checked(id, Missing { symbol: "J_out" }) };
    let limit = match actuator::continuous_torque(actuator, demand.speed_mean) {
        Ok(limit) => limit,
        Err(missing) => return not_checked(id, missing),
    };
    let mut notes = braking_note(manual);
    cite(&mut notes, inertia_errata(actuator));
    if limit.limit.grade == Grade::Estimated {
        for datum in [&actuator.stall_current, &actuator.stall_current_motor] {
            cite(&mut notes, datum.known().map_or(&[], |known| known.errata));
        }
        cite(&mut notes, actuator.torque_constant_out.known().map_or(&[], |known| known.errata));
        notes.push(Note::EstimatedUpTo(limit.upper));
    }
    if axis.moments.duration.si() > SHORT_CYCLE_SHARE * actuator::WINDING_TIME_CONSTANT {
        notes.push(Note::CycleNotShort { cycle: axis.moments.duration });
    }
    Comparison {
        notes,
        ..Comparison::with(id, &NEWTON_METRE, demand.torque_rms.si(), demand_source(manual, "69.2"), &limit.limit)
    }
    .answer(Verdict::Fail)
}

/// The motor current at every instant.
///
/// I = T/k_Tout + σ (I_NLS + K_INL |n|). Friction that opposes the torque counts with the 30 °C value of K_INL, friction
/// that helps with the 80 °C value: either way the larger current.
pub(crate) struct Currents {
    pub(crate) inertia: f64,
    torque_constant: f64,
    starting: f64,
    cold: f64,
    warm: f64,
    pub(crate) grade: Grade,
    errata: [&'static [&'static str]; 2],
}

impl Currents {
    fn of(actuator: &Parameters) -> Result<Self, Missing> {
        let inertia = actuator.inertia_out.require("J_out")?;
        let torque_constant = actuator.torque_constant_out.require("k_Tout")?;
        let starting = actuator.no_load_starting_current.require("I_NLS")?;
        let cold = actuator.no_load_current_constant_30.require("K_INL")?;
        let warm = actuator.no_load_current_constant_80.known().unwrap_or(cold);
        let grades = [inertia.grade, torque_constant.grade, starting.grade, cold.grade];
        Ok(Self {
            inertia: inertia.value.si(),
            torque_constant: torque_constant.value.si(),
            starting: starting.value.si(),
            cold: cold.value.si(),
            warm: warm.value.si(),
            grade: grades.into_iter().fold(Grade::Computed, Grade::worst),
            errata: [inertia.errata, torque_constant.errata],
        })
    }

    /// How friction counts, and the errata of the inputs.
    fn notes(&self) -> Vec<Note> {
        let mut notes = Vec::with_capacity(4);
        notes.push(Note::FrictionTemperatures);
        for errata in self.errata {
            cite(&mut notes, errata);
        }
        notes
    }

    /// The current at an instant \[A\].
    pub(crate) fn at(&self, node: &Node) -> f64 {
        let torque = self.inertia * node.acceleration + node.load;
        let constant = if torque * node.direction < 0.0 { self.warm } else { self.cold };
        torque / self.torque_constant + node.direction * (self.starting + constant * node.speed.abs())
    }

    /// The current as a weighted sum of (α, T_L, σ, ω), where friction has one sign over all nodes: `power_sign` is that
    /// of T σ.
    pub(crate) fn weights(&self, power_sign: f64) -> [f64; 4] {
        let constant = if power_sign < 0.0 { self.warm } else { self.cold };
        [self.inertia / self.torque_constant, 1.0 / self.torque_constant, self.starting, constant]
    }

    /// The current of friction as such a sum \[A\], times σ.
    pub(crate) const fn friction_weights(&self) -> [f64; 4] {
        [0.0, 0.0, self.starting, self.cold]
    }

    /// The part of it that friction takes, by magnitude \[A\].
    pub(crate) fn friction(&self, node: &Node) -> f64 {
        node.direction.abs() * (self.starting + self.cold * node.speed.abs())
    }

    /// No current of a block of nodes is above this.
    fn bound(&self, extent: &Extent) -> f64 {
        extent.torque(self.inertia) / self.torque_constant + self.starting + self.cold.max(self.warm) * extent.speed
    }

    /// The largest magnitude and its instant.
    fn largest(&self, axis: &Axis) -> (f64, Time) {
        let (current, at) = axis.trace.largest(|extent| self.bound(extent), |node| self.at(node).abs());
        (current, Time::from_si(at.time))
    }
}

/// U ≤ (U_DC/√2) · reserve: the motor's terminal voltage at every instant of the cycle, winding hot.
fn voltage(axis: &Axis, actuator: &Parameters, supply: ElectricPotential, reserve: f64) -> Check {
    let id = CheckId::Voltage;
    let (motor, currents) = match MotorVoltage::of(actuator).and_then(|m| Ok((m, Currents::of(actuator)?))) {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let typed = |node: &Node| (AngularVelocity::from_si(node.speed), ElectricCurrent::from_si(currents.at(node)));
    // The voltage of a block is below the one at its largest current and speed together.
    let bound = |extent: &Extent| {
        motor.at(AngularVelocity::from_si(extent.speed), ElectricCurrent::from_si(currents.bound(extent))).si()
    };
    let (highest, at) = axis.trace.largest(bound, |node| {
        let (speed, current) = typed(node);
        motor.at(speed, current).si()
    });
    // Between two instants the voltage may rise above both; speed and current are taken as straight.
    let worst = axis.trace.largest_between(highest, bound, |a, b, found| {
        let (a, b) = (typed(a), typed(b));
        let together = motor.at(a.0.abs().max(b.0.abs()), a.1.abs().max(b.1.abs())).si();
        if together <= found { together } else { motor.largest([a, b]).si() }
    });
    Comparison {
        id,
        unit: &VOLT,
        value: worst,
        value_source: Source::Model { name: "voltage" },
        at: Some(Time::from_si(at.time)),
        limit: supply.si() / std::f64::consts::SQRT_2 * reserve,
        limit_source: &Source::Project { key: "requirements.supply".into() },
        grade: motor.grade.worst(currents.grade),
        errata: &[],
        notes: currents.notes(),
    }
    .answer(Verdict::Fail)
}

/// I_peak ≤ I_max, and I_peak ≤ I_E, at which demagnetisation begins.
fn current_checks(axis: &Axis, actuator: &Parameters) -> [Check; 2] {
    let currents = Currents::of(actuator);
    let peak = currents.as_ref().ok().map(|currents| currents.largest(axis));
    let limits = [
        (CheckId::PeakCurrent, actuator.current_max.require("I_max")),
        (CheckId::Demagnetisation, actuator.current_demagnetisation.require("I_E")),
    ];
    limits.map(|(id, limit)| {
        let (limit, currents, (current, at)) = match (limit, &currents, peak) {
            (Ok(limit), Ok(currents), Some(peak)) => (limit, currents, peak),
            (Err(missing), ..) => return not_checked(id, missing),
            (_, Err(missing), _) => return not_checked(id, *missing),
            _ => return not_checked(id, Missing { symbol: "J_out" }),
        };
        Comparison {
            id,
            unit: &AMPERE,
            value: current,
            value_source: Source::Model { name: "current" },
            at: Some(at),
            limit: limit.value.si(),
            limit_source: &limit.source,
            grade: currents.grade.worst(limit.grade),
            errata: limit.errata,
            notes: currents.notes(),
        }
        .answer(Verdict::Fail)
    })
}

/// J_L ≤ 3 J_out is recommended for highly dynamic duty (table 70.1).
fn inertia_ratio(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::InertiaRatio;
    match actuator.inertia_out.require("J_out") {
        Ok(own) => {
            let source = match axis.by_the_manual() {
                Some(_) => Source::Project { key: "load.inertia".into() },
                None => Source::Model { name: "mechanisms" },
            };
            Comparison {
                limit: INERTIA_RATIO_RECOMMENDED * own.value.si(),
                grade: own.grade.worst(Grade::Computed),
                notes: vec![Note::RecommendationForHighDynamics],
                ..Comparison::with(id, &KILOGRAM_SQUARE_METRE, axis.moments.inertia_max.si(), source, own)
            }
            .answer(Verdict::Advice)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// The stated ambient temperature against the range that the actuator's data hold for (tables 13.1 and 13.2).
fn ambient(stated: ThermodynamicTemperature, actuator: &Parameters) -> Check {
    let id = CheckId::Ambient;
    let range = match actuator.ambient_range.require("ambient_temperature_operation") {
        Ok(range) => range,
        Err(missing) => return not_checked(id, missing),
    };
    let (low, high) = (range.value.0.si(), range.value.1.si());
    // A difference of a nanokelvin is a rounding of the conversion, not a warmer place.
    let inside = stated.si() >= low - 1e-9 && stated.si() <= high + 1e-9;
    let nearest = if stated.si() < low { low } else { high };
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
        notes: Vec::new(),
    }
}
