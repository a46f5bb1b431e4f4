//! Checks of the feedback: range, resolution, battery.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Direction, Verdict};
use crate::comparison::{Asking, against_asked, project, unjudged};
use crate::list::{Case, Outcome};
use crate::notes::Note;
use actuator::{Feedback, FeedbackSide, Parameters};
use derivation::{Finding, Workings};
use provenance::{Datum, Grade, Missing, Source};
use quantities::unit::{ARCSECOND, HOUR, ONE, REVOLUTION, YEAR};
use quantities::{Measure, Time};

/// Returns the feedback with the longer absolute range: an encoder at the output, if there is one, also provides its
/// turn.
fn absolute(actuator: &Parameters) -> Option<(f64, &Feedback)> {
    [&actuator.feedback, &actuator.feedback_out]
        .into_iter()
        .filter_map(|feedback| Some((feedback.absolute_turns_out(&actuator.ratio)?, feedback)))
        .max_by(|a, b| a.0.total_cmp(&b.0))
}

/// Checks travel ≤ absolute range in turns of the output; an axis that rotates endlessly exceeds it unless N/i is a
/// whole number. `None` if the position need not be absolute.
pub(crate) fn range(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    (case.axis.asked.absolute != Some(false)).then(|| absolute_travel(case.axis, case.actuator, work))
}

fn absolute_travel(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Outcome {
    let id = CheckId::FeedbackRange;
    let moments = axis.moments();
    let endless = !moments.is_swing() && moments.angle_travelled.si() > 0.0;
    let travel = moments.angle_swing.si();
    let source = Source::Model { name: "feedback" };
    let asked = axis.asked.absolute;
    if actuator.feedback.turns_absolute == Datum::NotPrinted
        && actuator.feedback_out.turns_absolute == Datum::NotApplicable
    {
        return Err(Missing { symbol: "turns" });
    }
    let what = Finding::Travel;
    work.found("phi", &REVOLUTION, travel, what, &source, Grade::Computed);
    work.value("phi");
    let mut check = Check {
        value: Some(Amount { si: travel, unit: &REVOLUTION }),
        grade: Some(Grade::Computed),
        value_source: Some(source.clone()),
        missing: id.key().filter(|_| asked.is_none()),
        ..unjudged(id)
    };
    let Some((turns, feedback)) = absolute(actuator) else {
        check.notes.push(Note::NeedsReferencing);
        if asked.is_some() {
            work.figure("N_out", &REVOLUTION, 0.0, &source, Grade::Printed);
            work.limit("N_out");
            check.limit = Some(Amount { si: 0.0, unit: &REVOLUTION });
            check.limit_source = Some(source);
            check.verdict = Verdict::Fail;
        }
        return Ok(check);
    };
    let limit = turns * std::f64::consts::TAU;
    let lost = endless && feedback.endless_axis_loses_reference(&actuator.ratio) == Some(true);
    let within = Direction::AtMost.keeps(travel, limit) && !lost;
    if work.is_on() {
        absolute_range(feedback, actuator, limit, work);
    }
    check.limit = Some(Amount { si: limit, unit: &REVOLUTION });
    check.limit_source = Some(source);
    if lost {
        let turns = feedback.turns_absolute.known().map_or(1.0, |turns| turns.value);
        check.notes.push(Note::ReferenceLost { turns });
    } else if !within {
        check.notes.push(Note::NeedsReferencing);
    }
    if asked.is_some() {
        check.verdict = if within { Verdict::Pass } else { Verdict::Fail };
        check.utilisation = (!lost).then(|| Direction::AtMost.share(travel, limit));
    }
    Ok(check)
}

/// Checks the step at the output ≤ the largest permissible step.
pub(crate) fn resolution(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::FeedbackResolution;
    let of = |feedback: &Feedback| feedback.resolution_out(&actuator.ratio).known().cloned();
    // A feedback at the output does not replace the finer one on the motor.
    let step = of(&actuator.feedback).ok_or(Missing { symbol: "resolution_motor_inc" })?;
    let asked = axis.asked.resolution_max.map(Measure::si);
    if let (Some(motor), Some(ratio)) = (actuator.feedback.resolution.known(), actuator.ratio.known()) {
        work.given("s_mot", &ARCSECOND, motor);
        work.given_number("i", ratio);
        work.formula("s_out", &ARCSECOND, step.value.si(), "s_mot/i", &step.source);
        work.value("s_out");
    }
    work.asked("s_perm", &ARCSECOND, asked, id);
    let mut check = against_asked(id, &ARCSECOND, step.value.si(), asked, step.source);
    check.grade = Some(step.grade);
    Ok(check)
}

/// Checks the life of the encoder's battery for the stated operation per day and storage before it. `None` if the
/// encoder has no battery.
pub(crate) fn battery(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    let feedback = &case.actuator.feedback;
    feedback.buffered_by_battery.then(|| battery_life(case.axis, feedback, work))
}

fn battery_life(axis: &Axis, feedback: &Feedback, work: &mut Workings) -> Outcome {
    let id = CheckId::Battery;
    const OPERATION: Missing = Missing { symbol: "requirements.operation_per_day" };
    let operation = axis.asked.operation_per_day.ok_or(OPERATION)?;
    let storage = axis.asked.storage.unwrap_or_else(|| Time::from_si(0.0));
    let model = feedback.battery.require("battery_capacity")?;
    let battery = model.value.life(operation, storage).map_err(|_| OPERATION)?;
    let asked = axis.asked.battery_life_min.map(Measure::si);
    if work.is_on() {
        work.stated("t_op", &HOUR, operation.si(), OPERATION.symbol);
        let grade = if axis.asked.storage.is_some() { Grade::Printed } else { Grade::Assumed };
        work.figure("t_store", &YEAR, storage.si(), &project("requirements.storage"), grade);
        let what = Finding::BatteryLife;
        let life = &battery.life;
        work.found("L_bat", &YEAR, life.value.si(), what, &life.source, life.grade);
        work.value("L_bat");
    }
    work.asked("L_asked", &YEAR, asked, id);
    let mut check = against_asked(id, &YEAR, battery.life.value.si(), asked, battery.life.source.clone());
    check.grade = Some(battery.life.grade);
    check
        .notes
        .push(Note::BatteryExchange { recommended: battery.exchange_recommended, latest: battery.exchange_latest });
    Ok(check)
}

/// Records the derivation of the absolute range in turns of the output, `N_out`.
fn absolute_range(feedback: &Feedback, actuator: &Parameters, limit: f64, work: &mut Workings) {
    let source = Source::Model { name: "feedback" };
    match feedback.turns_absolute.known() {
        Some(turns) => work.given_number("N", turns),
        None => work.figure("N", &ONE, 1.0, &source, Grade::Computed),
    }
    match actuator.ratio.known().filter(|_| feedback.side == FeedbackSide::Motor) {
        Some(ratio) => {
            work.given_number("i", ratio);
            work.formula("N_out", &REVOLUTION, limit, "N/i", &source);
        }
        None => work.formula("N_out", &REVOLUTION, limit, "N", &source),
    }
    work.limit("N_out");
}
