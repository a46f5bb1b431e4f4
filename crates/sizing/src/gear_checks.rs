//! Checks of the gear. It transmits the torque of the load only: the rotor's inertia is on its other side.

use crate::axis::Axis;
use crate::bearing_checks::Borne;
use crate::bearing_workings;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, against_asked, equation, not_checked, project};
use crate::list::{Case, Outcome};
use crate::notes::{Budget, Note, Notes};
use crate::stage;
use crate::workings;
use actuator::{
    BudgetCase, Drivetrain, ErrorBudget, ErrorKind, Feedback, FeedbackSide, Gear, LifeLaw, Parameters, PositionLoop,
};
use derivation::{Finding, Workings};
use provenance::{Datum, Grade, Missing, Source, Sourced};
use quantities::unit::{
    ARCMINUTE, ARCSECOND, HOUR, MILLIMETRE, NEWTON_METRE, NEWTON_METRE_PER_ARCMINUTE, NEWTON_METRE_PER_RADIAN, ONE,
    REVOLUTION_PER_MINUTE, SECOND,
};
use quantities::{Angle, AngularVelocity, Length, Measure, Ratio, Time, Torque};

/// Model of torsion, natural frequency, mean torque, collisions and life.
const MODEL: Source = Source::Model { name: "gear" };

/// Returns the verdict beyond a rating of the gear. Only ratings of the actuator itself reject: those of the gear of
/// another series or of another manufacturer are advice.
pub(crate) const fn beyond(rating: &Source) -> Verdict {
    match rating {
        Source::Cell(_)
        | Source::Equation { .. }
        | Source::Project { .. }
        | Source::CatalogueFile { .. }
        | Source::NotStated { .. } => Verdict::Fail,
        Source::Published(_) | Source::Model { .. } => Verdict::Advice,
    }
}

/// Returns the remark on a rating of another gear than that of the actuator.
const fn of_another_gear(rating: &Source) -> Notes {
    match rating {
        Source::Cell(_)
        | Source::Equation { .. }
        | Source::Project { .. }
        | Source::CatalogueFile { .. }
        | Source::NotStated { .. } => Notes::NONE,
        Source::Published(_) => Notes::fixed(&[Note::RatingOfInterchangeableGear]),
        Source::Model { .. } => Notes::fixed(&[Note::RatingByStrongerGear]),
    }
}

impl CheckId {
    /// Returns `true` if another gear may have a rating for it, which advises: only a limit of the actuator itself rejects.
    #[must_use]
    pub const fn may_be_rated_elsewhere(self) -> bool {
        matches!(self, Self::GearMeanInputSpeed | Self::GearMeanTorque | Self::GearLife | Self::CollisionTorque)
    }
}

/// Checks i n_av ≤ n_in,av; only if a limit of the gear is published.
pub(crate) fn mean_input_speed(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::GearMeanInputSpeed;
    let limit = actuator.gear.input_speed_mean_max.require("n_in_av")?;
    let ratio = actuator.ratio.require("i")?;
    let speed = axis.moments().speed_mean().si() * ratio.value;
    explain_input_speed(axis, ratio, speed, work);
    work.value("n_in");
    work.given("n_in_av", &REVOLUTION_PER_MINUTE, limit);
    work.limit("n_in_av");
    Ok(Comparison {
        notes: of_another_gear(&limit.source),
        ..Comparison::with(id, &REVOLUTION_PER_MINUTE, speed, equation("69.3"), limit)
    }
    .answer(beyond(&limit.source)))
}

/// Records the derivation of the mean input speed, `n_in`.
fn explain_input_speed(axis: &Axis, ratio: &Sourced<f64>, speed: f64, work: &mut Workings) {
    workings::mean_speed(axis, work);
    work.given_number("i", ratio);
    work.formula("n_in", &REVOLUTION_PER_MINUTE, speed, "i*n_av", &MODEL);
}

/// Checks T_k ≤ T_M; only if a rating of the gear is published. Above the ratcheting
/// torque of a cup-type gear of the same size it is against advice in any case.
pub(crate) fn collision(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let (id, gear) = (CheckId::CollisionTorque, &actuator.gear);
    let key = "requirements.collision_torque";
    let torque = axis.asked.collision_torque.ok_or(Missing { symbol: key })?;
    let ratchets = gear.ratcheting_torque.known();
    let note = ratchets.map(|ratcheting| Note::Ratcheting {
        ratcheting: ratcheting.value,
        buckling: gear.buckling_torque.known().map(|known| known.value),
    });
    let limit = match gear.collision_torque_max.require("T_M") {
        Ok(limit) => limit,
        Err(missing) => {
            let mut check = match ratchets.filter(|ratcheting| torque.si() > ratcheting.value.si()) {
                Some(ratcheting) => {
                    work.stated("T_k", &NEWTON_METRE, torque.si(), key);
                    work.value("T_k");
                    work.given("T_ratchet", &NEWTON_METRE, ratcheting);
                    work.limit("T_ratchet");
                    Comparison::with(id, &NEWTON_METRE, torque.si(), project(key), ratcheting).answer(Verdict::Advice)
                }
                None => not_checked(id, missing),
            };
            check.notes.extend(note);
            return Ok(check);
        }
    };
    let mut check = Comparison::with(id, &NEWTON_METRE, torque.si(), project(key), limit).answer(beyond(&limit.source));
    work.stated("T_k", &NEWTON_METRE, torque.si(), key);
    work.value("T_k");
    work.given("T_M", &NEWTON_METRE, limit);
    work.limit("T_M");
    let permitted = axis.asked.collision_time.and_then(|time| collisions_permitted(axis, actuator, time).ok());
    check.notes.extend(of_another_gear(&limit.source).iter().cloned());
    check.notes.extend(permitted.map(Note::CollisionsPermitted));
    check.notes.extend(note);
    Ok(check)
}

/// Returns the number of collisions that the gear bears: at the peak speed, at which one covers the largest number of turns of
/// the wave generator.
fn collisions_permitted(axis: &Axis, actuator: &Parameters, time: Time) -> Result<f64, Missing> {
    let cycles = actuator.gear.collision_cycles.require("N_k")?.value;
    let ratio = actuator.ratio.require("i")?.value;
    Ok(actuator::collision_count_max(cycles, axis.moments().speed_peak, ratio, time))
}

/// Checks the stated number of collisions ≤ N_k, that of the stated duration which the gear bears.
///
/// N_k = min(10⁴/(2 i n t_k/60), 10⁴)
///
/// # Symbols
/// n peak speed at the output [min⁻¹], i ratio, t_k duration of a collision \[s\]
/// # Source
/// docs/theory/gear.md; only with a published T_M, up to which N_k holds
pub(crate) fn collision_number(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let (id, key, of_time) = (CheckId::CollisionNumber, "requirements.collisions", "requirements.collision_time");
    let count = axis.asked.collisions.ok_or(Missing { symbol: key })?;
    let time = axis.asked.collision_time.ok_or(Missing { symbol: of_time })?;
    let gear = &actuator.gear;
    let (rating, cycles) = (gear.collision_torque_max.require("T_M")?, gear.collision_cycles.require("N_k")?);
    let permitted = collisions_permitted(axis, actuator, time)?;
    work.stated("N", &ONE, count, key);
    work.value("N");
    let speed = axis.moments().speed_peak.si();
    work.found("n", &REVOLUTION_PER_MINUTE, speed, Finding::PeakSpeed, &workings::DEMAND, Grade::Computed);
    if let Some(ratio) = actuator.ratio.known() {
        work.given_number("i", ratio);
    }
    work.stated("t_k", &SECOND, time.si(), of_time);
    work.formula("N_k", &ONE, permitted, "min(10^4/(2*i*n*t_k/60), 10^4)", &MODEL);
    work.limit("N_k");
    let most = Sourced {
        value: Ratio::from_si(permitted),
        source: MODEL,
        grade: rating.grade.worst(cycles.grade),
        errata: &[],
    };
    let mut check = Comparison::with(id, &ONE, count, project(key), &most).answer(beyond(&rating.source));
    check.notes.extend(of_another_gear(&rating.source).iter().cloned());
    Ok(check)
}

/// Angular errors of an actuator on an axis, at the mechanism.
struct AngularErrors {
    budget: ErrorBudget,
    /// Sum of all errors.
    worst: Angle,
    /// Lever arm of the deviation: that of the project; along the line of a mechanism its travel per angle.
    lever: Option<Length>,
    /// The mechanism moves along a line, whose travel per angle takes the place of the lever arm.
    is_along_the_line: bool,
}

impl AngularErrors {
    /// Adds the errors, and records the derivation of their sum, `phi_sum`.
    fn of(case: &Case<'_>, work: &mut Workings) -> Result<Self, Missing> {
        let Case { axis, actuator, .. } = *case;
        let moment = case.bearing.and_then(|borne| Some(borne.largest_moment().ok()?.value()));
        let case = BudgetCase {
            torque: axis.moments().load_peak,
            tilting_moment: moment.map(Torque::from_si),
            position_loop: if axis.asked.loop_at_output { PositionLoop::Output } else { PositionLoop::Motor },
        };
        if axis.asked.loop_at_output && matches!(actuator.feedback_out.accuracy, Datum::NotApplicable) {
            return Err(Missing { symbol: "EC" });
        }
        let mut budget = actuator::error_budget(actuator, &case);
        if budget.contributions.is_empty() {
            return Err(Missing { symbol: "transmission_accuracy" });
        }
        if let Some(stage) = &axis.mechanism.stage {
            stage::behind(stage, &mut budget, case.torque);
        }
        let worst = budget.worst_case();
        if work.is_on() {
            explain_budget(axis, actuator, (&case, &budget), work);
            if let Some(stage) = &axis.mechanism.stage {
                let has_torque =
                    case.position_loop == PositionLoop::Motor && !budget.missing.contains(&ErrorKind::Torsion);
                stage::explain_budget(axis, stage, (worst, has_torque), work);
            }
        }
        let of_the_line = || {
            let travel = axis.mechanism.travel_m_per_rad().filter(|_| axis.asked.deviation_max.is_some())?;
            Some(Length::from_si(travel * axis.mechanism.stage_ratio()))
        };
        let lever = axis.asked.lever_arm;
        Ok(Self { budget, worst, lever: lever.or_else(of_the_line), is_along_the_line: lever.is_none() })
    }

    fn deviation(&self) -> Option<Length> {
        self.lever.map(|lever| actuator::deviation_at(self.worst, lever))
    }

    /// Returns a check with the grade of the errors and the remark that lists them.
    fn of_check(self, mut check: Check) -> Check {
        check.grade = Some(self.budget.grade());
        let deviation = self.deviation();
        check.notes.push(Note::Budget(Box::new(Budget {
            errors: self.budget,
            deviation,
            is_along_the_line: self.is_along_the_line,
        })));
        check
    }
}

const ERROR_BUDGET: Source = Source::Model { name: "error-budget" };

/// Checks the sum of all angular errors at the mechanism.
pub(crate) fn error_budget(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let id = CheckId::ErrorBudget;
    let errors = AngularErrors::of(case, work)?;
    let permitted = case.axis.asked.angle_error_max.map(Measure::si);
    work.value("phi_sum");
    work.asked("phi_sum_max", &ARCMINUTE, permitted, id);
    let check = against_asked(id, &ARCMINUTE, errors.worst.si(), permitted, ERROR_BUDGET);
    Ok(errors.of_check(check))
}

/// Checks the sum of all angular errors at the lever arm, or along the line of the mechanism, against the permissible
/// deviation.
///
/// s = φ_sum r
///
/// # Symbols
/// φ_sum sum of all angular errors \[rad\], r lever arm, or travel per angle of the mechanism \[m\]
/// # Source
/// docs/theory/error-budget.md
/// # Errors
/// When neither a lever arm is stated nor the mechanism moves along a line.
pub(crate) fn deviation(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let (id, axis) = (CheckId::Deviation, case.axis);
    let errors = AngularErrors::of(case, work)?;
    let of_the_lever = Missing { symbol: "requirements.lever_arm" };
    let (lever, deviation) = errors.lever.zip(errors.deviation()).ok_or(of_the_lever)?;
    if axis.asked.lever_arm.is_some() {
        work.stated("r", &MILLIMETRE, lever.si(), of_the_lever.symbol);
    } else {
        work.figure("r", &MILLIMETRE, lever.si(), &Source::Model { name: "mechanisms" }, Grade::Computed);
    }
    work.formula("s", &MILLIMETRE, deviation.si(), "phi_sum*pi/10800*r", &ERROR_BUDGET);
    work.value("s");
    let permitted = axis.asked.deviation_max.map(Measure::si);
    work.asked("s_max", &MILLIMETRE, permitted, id);
    let check = against_asked(id, &MILLIMETRE, deviation.si(), permitted, ERROR_BUDGET);
    Ok(errors.of_check(check))
}

/// Records the derivation of the sum of all angular errors, `phi_sum`: an unknown error counts as zero, with a remark.
fn explain_budget(
    axis: &Axis,
    actuator: &Parameters,
    (case, budget): (&BudgetCase, &ErrorBudget),
    work: &mut Workings,
) {
    let source = Source::Model { name: "error-budget" };
    let unknown = |kind: ErrorKind| budget.missing.contains(&kind);
    let missing = |work: &mut Workings, symbol, unit| {
        work.found(symbol, unit, 0.0, Finding::NotKnown, &source, Grade::Computed);
    };
    let motor = case.position_loop == PositionLoop::Motor;
    if motor {
        let accuracy = &actuator.accuracy;
        for (symbol, datum) in [
            ("transmission_accuracy", &accuracy.transmission_accuracy),
            ("repeatability", &accuracy.repeatability),
            ("hysteresis_loss", &accuracy.hysteresis_loss),
            ("lost_motion", &accuracy.lost_motion),
        ] {
            match datum.known() {
                Some(angle) => work.given(symbol, &ARCMINUTE, angle),
                None => missing(work, symbol, &ARCMINUTE),
            }
        }
        if unknown(ErrorKind::Torsion) {
            missing(work, "phi", &ARCMINUTE);
        } else {
            explain_torsion(axis, &actuator.gear, case.torque, work);
        }
    }
    let feedback = if motor { &actuator.feedback } else { &actuator.feedback_out };
    if unknown(ErrorKind::FeedbackAccuracy) {
        missing(work, "accuracy_out", &ARCSECOND);
    } else {
        let texts = ("accuracy", "accuracy_out", "accuracy/i");
        explain_feedback(&feedback.accuracy, feedback, &actuator.ratio, texts, work);
    }
    if unknown(ErrorKind::FeedbackResolution) {
        missing(work, "resolution_out", &ARCSECOND);
    } else {
        let texts = ("resolution", "resolution_out", "resolution/i");
        explain_feedback(&feedback.resolution, feedback, &actuator.ratio, texts, work);
    }
    if axis.mechanism.stage.is_some() {
        let what = Finding::TiltBehindStage;
        work.found("gamma", &ARCMINUTE, 0.0, what, &stage::MODEL, Grade::Computed);
    } else {
        explain_tilt(axis, actuator, case, work);
    }
    let text = if motor {
        "transmission_accuracy + repeatability + hysteresis_loss + lost_motion + phi \
         + (accuracy_out + resolution_out)/60 + gamma"
    } else {
        "(accuracy_out + resolution_out)/60 + gamma"
    };
    match &axis.mechanism.stage {
        None => work.formula("phi_sum", &ARCMINUTE, budget.worst_case().si(), text, &source),
        Some(stage) => {
            let before = stage::before(stage, budget);
            work.formula("phi_out", &ARCMINUTE, before.si(), text, &source);
        }
    }
}

/// Records the derivation of the tilt of the flange, `gamma`.
fn explain_tilt(axis: &Axis, actuator: &Parameters, case: &BudgetCase, work: &mut Workings) {
    let source = Source::Model { name: "error-budget" };
    let missing = |work: &mut Workings, symbol, unit| {
        work.found(symbol, unit, 0.0, Finding::NotKnown, &source, Grade::Computed);
    };
    match (case.tilting_moment, actuator.output_bearing.tilting_stiffness.known(), &axis.bearing) {
        (Some(moment), Some(stiffness), Some(duty)) => {
            bearing_workings::explain_largest_moment(&Borne::of(axis, duty, &actuator.output_bearing), work);
            work.given("K_B", &NEWTON_METRE_PER_ARCMINUTE, stiffness);
            let tilt = actuator::tilt_angle(moment, stiffness.value);
            work.formula("gamma", &ARCMINUTE, tilt.si(), "M/K_B", &equation("76.4"));
        }
        _ => missing(work, "gamma", &ARCMINUTE),
    }
}

/// Records the derivation of an angle of the feedback at the output.
fn explain_feedback(
    angle: &Datum<Angle>,
    feedback: &Feedback,
    ratio: &Datum<f64>,
    (symbol, symbol_out, text): (&'static str, &'static str, &'static str),
    work: &mut Workings,
) {
    match (angle.known(), ratio.known(), feedback.side) {
        (Some(angle), _, FeedbackSide::Output) => work.given(symbol_out, &ARCSECOND, angle),
        (Some(angle), Some(ratio), FeedbackSide::Motor) => {
            work.given(symbol, &ARCSECOND, angle);
            work.given_number("i", ratio);
            let source = Source::Model { name: "feedback" };
            work.formula(symbol_out, &ARCSECOND, angle.value.si() / ratio.value, text, &source);
        }
        _ => {}
    }
}

/// Checks T_av ≤ T_A; only if a rating of the gear is published.
pub(crate) fn mean_torque(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::GearMeanTorque;
    let limit = actuator.gear.average_torque_max.require("T_A")?;
    let mean = axis.load_cubic_mean();
    explain_mean_torque(mean, work);
    work.value("T_av");
    work.given("T_A", &NEWTON_METRE, limit);
    work.limit("T_A");
    Ok(Comparison {
        notes: of_another_gear(&limit.source),
        ..Comparison::with(id, &NEWTON_METRE, mean.si(), MODEL, limit)
    }
    .answer(beyond(&limit.source)))
}

/// Records the derivation of the cubic mean torque, `T_av`.
fn explain_mean_torque(mean: Torque, work: &mut Workings) {
    let what = Finding::CubicMeanTorque;
    work.found("T_av", &NEWTON_METRE, mean.si(), what, &MODEL, Grade::Computed);
}

/// Checks L_10 of the wave-generator bearing against the required life.
pub(crate) fn life(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::GearLife;
    let rated = actuator.gear.rated_torque.require("T_N")?;
    let ratio = actuator.ratio.require("i")?;
    let mean = axis.load_cubic_mean();
    let speed = AngularVelocity::from_si(axis.moments().speed_mean().si() * ratio.value);
    if speed.si() <= 0.0 || mean.si() <= 0.0 {
        return Err(Missing { symbol: "gear_load" });
    }
    if work.is_on() {
        explain_input_speed(axis, ratio, speed.si(), work);
        explain_mean_torque(mean, work);
        work.given("T_N", &NEWTON_METRE, rated);
    }
    let law = LifeLaw::of(&actuator.gear)?;
    let life = law.l10_with(rated.value, mean, speed, work);
    // With almost no load the life is infinite.
    if !life.si().is_finite() {
        return Err(Missing { symbol: "gear_load" });
    }
    work.value("L_10");
    let asked = axis.asked.gear_life_min.map(Measure::si);
    work.asked("L_10_min", &HOUR, asked, id);
    let mut check = against_asked(id, &HOUR, life.si(), asked, MODEL);
    check.grade = Some(rated.grade.worst(Grade::Computed));
    check.notes.extend(of_another_gear(&rated.source).iter().cloned());
    Ok(check)
}

/// Checks the torsion of the gear under the largest torque of the load.
pub(crate) fn torsion(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let id = CheckId::Torsion;
    let curve = actuator.gear.torsion().ok_or(Missing { symbol: "K_1" })?;
    let worst = axis.moments().load_peak;
    let source = Source::Equation { number: "73.1" };
    let limit = axis.asked.torsion_max.map(Measure::si);
    explain_torsion(axis, &actuator.gear, worst, work);
    let (angle, symbol, source) = match &axis.mechanism.stage {
        None => (curve.angle(worst), "phi", source),
        Some(stage) => (stage::torsion(stage, curve.angle(worst), worst, work), "phi_L", stage::MODEL),
    };
    work.value(symbol);
    work.asked("phi_max", &ARCMINUTE, limit, id);
    let mut check = against_asked(id, &ARCMINUTE, angle.si(), limit, source);
    check.at = Some(axis.moments().load_peak_at);
    Ok(check)
}

/// Records the derivation of the torsion under the largest torque of the load, `phi`, by the equation of the region
/// that it reaches.
fn explain_torsion(axis: &Axis, gear: &Gear, torque: Torque, work: &mut Workings) {
    let Some(curve) = gear.torsion().filter(|_| work.is_on()) else { return };
    let (angle, [k1, k2, k3]) = (curve.angle(torque).si(), &gear.stiffness);
    workings::peak_load(axis, "T", work);
    work.known("K_1", &NEWTON_METRE_PER_RADIAN, k1);
    if torque.si() <= curve.torque_1.si() {
        work.formula("phi", &ARCMINUTE, angle, "T/K_1*10800/pi", &equation("73.1"));
        return;
    }
    work.known("T_1", &NEWTON_METRE, &gear.torque_1);
    work.known("K_2", &NEWTON_METRE_PER_RADIAN, k2);
    if torque.si() <= curve.torque_2.si() {
        work.formula("phi", &ARCMINUTE, angle, "(T_1/K_1 + (T - T_1)/K_2)*10800/pi", &equation("73.2"));
        return;
    }
    work.known("T_2", &NEWTON_METRE, &gear.torque_2);
    work.known("K_3", &NEWTON_METRE_PER_RADIAN, k3);
    let text = "(T_1/K_1 + (T_2 - T_1)/K_2 + (T - T_2)/K_3)*10800/pi";
    work.formula("phi", &ARCMINUTE, angle, text, &equation("73.3"));
}
