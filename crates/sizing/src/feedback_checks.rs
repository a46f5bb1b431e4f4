//! The checks of the feedback: range, resolution, battery.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{at_least, not_checked, shown_or_at_most};
use actuator::{Feedback, Parameters};
use provenance::{Datum, Grade, Missing, Source};
use quantities::unit::{ARCSECOND, REVOLUTION, YEAR};
use quantities::{Measure, Time};

/// The checks of the feedback; that of the battery only where there is one.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters) -> Vec<Check> {
    let mut checks = Vec::with_capacity(3);
    // Who says that it need not be absolute wants no answer.
    if axis.asked.absolute != Some(false) {
        checks.push(range(axis, actuator));
    }
    checks.push(resolution(axis, actuator));
    if actuator.feedback.buffered_by_battery {
        checks.push(battery(axis));
    }
    checks
}

/// The feedback with the longer absolute range: that at the output, if there is one, tells its turn too.
fn absolute(actuator: &Parameters) -> Option<(f64, &Feedback)> {
    [&actuator.feedback, &actuator.feedback_out]
        .into_iter()
        .filter_map(|feedback| Some((feedback.absolute_turns_out(&actuator.ratio)?, feedback)))
        .max_by(|a, b| a.0.total_cmp(&b.0))
}

/// Travel ≤ absolute range in turns of the output; an axis that turns on and on leaves it unless N/i is a whole number.
fn range(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::FeedbackRange;
    let moments = axis.moments();
    let endless = !moments.is_swing() && moments.angle_travelled.si() > 0.0;
    let travel = moments.angle_swing.si();
    let source = Source::Model { name: "feedback" };
    let asked = axis.asked.absolute;
    if actuator.feedback.turns_absolute == Datum::NotPrinted
        && actuator.feedback_out.turns_absolute == Datum::NotApplicable
    {
        return not_checked(id, Missing { symbol: "turns" });
    }
    let mut check = Check {
        id,
        verdict: Verdict::NotChecked,
        value: Some(Figure { si: travel, unit: &REVOLUTION }),
        limit: None,
        utilisation: None,
        at: None,
        grade: Some(Grade::Computed),
        value_source: Some(source.clone()),
        limit_source: None,
        missing: asked.is_none().then_some("requirements.absolute"),
        notes: Vec::new(),
        workings: Vec::new(),
    };
    let Some((turns, feedback)) = absolute(actuator) else {
        check.notes.push(Note::NeedsReferencing);
        if asked.is_some() {
            check.limit = Some(Figure { si: 0.0, unit: &REVOLUTION });
            check.limit_source = Some(source);
            check.verdict = Verdict::Fail;
        }
        return check;
    };
    let limit = turns * std::f64::consts::TAU;
    let lost = endless && feedback.endless_axis_loses_reference(&actuator.ratio) == Some(true);
    let within = travel <= limit * (1.0 + 1e-9) && !lost;
    check.limit = Some(Figure { si: limit, unit: &REVOLUTION });
    check.limit_source = Some(source);
    if lost {
        check.notes.push(Note::ReferenceLost);
    } else if !within {
        check.notes.push(Note::NeedsReferencing);
    }
    if asked.is_some() {
        check.verdict = if within { Verdict::Pass } else { Verdict::Fail };
        check.utilisation = (!lost).then(|| travel / limit);
    }
    check
}

/// Step at the output ≤ the step asked for.
fn resolution(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::FeedbackResolution;
    let of = |feedback: &Feedback| feedback.resolution_out(&actuator.ratio).known().cloned();
    // A feedback at the output does not replace the finer one on the motor.
    match of(&actuator.feedback) {
        Some(step) => {
            let asked = axis.asked.resolution_max.map(Measure::si);
            let key = "requirements.resolution_max";
            let mut check = shown_or_at_most(id, &ARCSECOND, step.value.si(), asked, key, step.source);
            check.grade = Some(step.grade);
            check
        }
        None => not_checked(id, Missing { symbol: "resolution_motor_inc" }),
    }
}

/// Life of the encoder's battery for the stated operation a day and storage before.
fn battery(axis: &Axis) -> Check {
    let id = CheckId::Battery;
    let Some(operation) = axis.asked.operation_per_day else {
        return not_checked(id, Missing { symbol: "requirements.operation_per_day" });
    };
    let storage = axis.asked.storage.unwrap_or_else(|| Time::from_si(0.0));
    match actuator::battery_life(operation, storage) {
        Ok(battery) => {
            let asked = axis.asked.battery_life_min.map(Measure::si);
            let key = "requirements.battery_life_min";
            let mut check = at_least(id, &YEAR, battery.life.value.si(), asked, key, battery.life.source.clone());
            check.grade = Some(battery.life.grade);
            check.notes.push(Note::BatteryExchange {
                recommended: battery.exchange_recommended,
                latest: battery.exchange_latest,
            });
            check
        }
        Err(_) => not_checked(id, Missing { symbol: "requirements.operation_per_day" }),
    }
}
