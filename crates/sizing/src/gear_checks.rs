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
use quantities::{Angle, AngularVelocity, Length, Measure, Ratio, Torque};

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

/// Checks T_k ≤ T_M, and the number of collisions; only if a rating of the gear is published. Above the ratcheting
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
    let otherwise = beyond(&limit.source);
    let mut check = Comparison::with(id, &NEWTON_METRE, torque.si(), project(key), limit).answer(otherwise);
    // At the peak speed a collision covers the largest number of turns of the wave generator.
    let stands = axis.asked.collision_time.zip(actuator.ratio.known()).zip(gear.collision_cycles.known());
    let permitted = stands.map(|((time, ratio), cycles)| {
        actuator::collision_count_max(cycles.value, axis.moments().speed_peak, ratio.value, time)
    });
    let mut by_number = false;
    if let (Some(count), Some(permitted)) = (axis.asked.collisions, permitted) {
        let most = Sourced { value: Ratio::from_si(permitted), source: MODEL, grade: limit.grade, errata: &[] };
        let number = Comparison::with(id, &ONE, count, project("requirements.collisions"), &most).answer(otherwise);
        // The check of torque or number with the higher utilisation is returned.
        if number.utilisation > check.utilisation {
            check = number;
            explain_collisions(axis, actuator, (count, permitted), work);
            by_number = true;
        }
    }
    if work.is_on() && !by_number {
        work.stated("T_k", &NEWTON_METRE, torque.si(), key);
        work.value("T_k");
        work.given("T_M", &NEWTON_METRE, limit);
        work.limit("T_M");
    }
    check.notes.extend(of_another_gear(&limit.source).iter().cloned());
    check.notes.extend(permitted.map(Note::CollisionsPermitted));
    check.notes.extend(note);
    Ok(check)
}

/// Records the derivation of the number of collisions, `N`, and of the permissible one, `N_k`.
fn explain_collisions(axis: &Axis, actuator: &Parameters, (count, permitted): (f64, f64), work: &mut Workings) {
    let (Some(time), Some(ratio)) = (axis.asked.collision_time, actuator.ratio.known().filter(|_| work.is_on())) else {
        return;
    };
    work.stated("N", &ONE, count, "requirements.collisions");
    work.value("N");
    let speed = axis.moments().speed_peak.si();
    let what = Finding::PeakSpeed;
    work.found("n", &REVOLUTION_PER_MINUTE, speed, what, &workings::DEMAND, Grade::Computed);
    work.given_number("i", ratio);
    work.stated("t_k", &SECOND, time.si(), "requirements.collision_time");
    work.formula("N_k", &ONE, permitted, "min(10^4/(2*i*n*t_k/60), 10^4)", &MODEL);
    work.limit("N_k");
}

/// Checks the sum of all angular errors at the output, and its deviation at the lever arm.
pub(crate) fn error_budget(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::ErrorBudget;
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
            let has_torque = case.position_loop == PositionLoop::Motor && !budget.missing.contains(&ErrorKind::Torsion);
            stage::explain_budget(axis, stage, (worst, has_torque), work);
        }
    }
    let source = Source::Model { name: "error-budget" };
    // Along the line of a mechanism the travel per angle takes the place of a lever arm.
    let is_asked = axis.asked.deviation_max.is_some();
    let of_the_line = axis.mechanism.travel_m_per_rad().filter(|_| is_asked);
    let lever = match (axis.asked.lever_arm, of_the_line) {
        (Some(lever), _) => {
            if is_asked {
                work.stated("r", &MILLIMETRE, lever.si(), "requirements.lever_arm");
            }
            Some(lever)
        }
        (None, Some(travel)) => {
            let lever = travel * axis.mechanism.stage_ratio();
            work.figure("r", &MILLIMETRE, lever, &Source::Model { name: "mechanisms" }, Grade::Computed);
            Some(Length::from_si(lever))
        }
        (None, None) => None,
    };
    let deviation = lever.map(|lever| actuator::deviation_at(worst, lever));
    let mut check = match (deviation, axis.asked.deviation_max) {
        (Some(deviation), Some(permitted)) => {
            let key = "requirements.deviation_max";
            work.formula("s", &MILLIMETRE, deviation.si(), "phi_sum*pi/10800*r", &source);
            work.value("s");
            work.asked_by("s_max", &MILLIMETRE, permitted.si(), key);
            let limit_source = Some(project(key));
            Check { limit_source, ..against_asked(id, &MILLIMETRE, deviation.si(), Some(permitted.si()), source) }
        }
        _ => {
            let permitted = axis.asked.angle_error_max.map(Measure::si);
            work.value("phi_sum");
            work.asked("phi_sum_max", &ARCMINUTE, permitted, id);
            against_asked(id, &ARCMINUTE, worst.si(), permitted, source)
        }
    };
    check.grade = Some(budget.grade());
    check.notes.push(Note::Budget(Box::new(Budget { errors: budget, deviation })));
    Ok(check)
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
