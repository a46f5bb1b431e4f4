//! Sentences and figures about the quality of a recording.

use quantities::unit::{
    DEGREE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, MILLIMETRE, MILLISECOND, NEWTON, NEWTON_METRE,
    RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND,
};
use quantities::{Language, Unit, format_significant};
use questions::{Along, ColumnOutliers, ColumnRole, ExaminedRecording, Spurious};
use words::{incoming, role_text};

fn figure(si: f64, unit: &Unit, digits: usize, language: Language) -> String {
    format!("{} {}", format_significant(unit.from_si(si), digits, language), unit.symbol)
}

/// Returns the figures of a recording: their names and values.
pub(super) fn quality_rows(examined: &ExaminedRecording, language: Language) -> Vec<(String, String)> {
    let l = language;
    let time = |s: f64| figure(s, if s < 1.0 { &MILLISECOND } else { &SECOND }, 4, l);
    let [least, median, most] = examined.intervals_s;
    let is_even = most - least <= 1e-6 * median;
    let sample_time =
        if is_even { time(median) } else { incoming::sample_time_varies(&time(median), &time(least), &time(most), l) };
    let mut rows = vec![
        (incoming::rows(l).to_owned(), examined.recording.time_s.len().to_string()),
        (incoming::period(l).to_owned(), figure(examined.recorded.duration_s(), &SECOND, 5, l)),
        (incoming::sample_time(l).to_owned(), sample_time),
    ];
    for role in [ColumnRole::Position, ColumnRole::Speed] {
        if let Some((along, ends)) = examined.ends(role) {
            let [from, to] = ends.map(|si| figure(si, unit(role, along), 4, l));
            rows.push((incoming::ends_of(&role_text(role, l), l), incoming::from_to(&from, &to, l)));
        }
    }
    for (role, along, quality) in &examined.quality {
        let unit = unit(*role, *along);
        let name = role_text(*role, l);
        let step = quality.step.map_or_else(|| incoming::none_found(l).to_owned(), |step| figure(step, unit, 3, l));
        rows.push((incoming::step_of(&name, l), step));
        if let Some(noise) = quality.noise {
            rows.push((incoming::noise_of(&name, l), incoming::at_most(&figure(noise, unit, 2, l), l)));
        }
    }
    rows
}

/// Returns the sentence about the single values of a column that are far beside those around them.
pub(super) fn outliers(found: &ColumnOutliers, language: Language) -> String {
    let l = language;
    let value = figure(found.value, unit(found.role, found.along), 4, l);
    let time = figure(found.time_s, &SECOND, 6, l);
    incoming::outliers(found.count, &words::capitalised(&role_text(found.role, l)), &value, &time, l)
}

/// Returns the sentence about a jump of the position.
pub(super) fn jump(along: Along, time_s: f64, change: f64, language: Language) -> String {
    let l = language;
    incoming::jump(&figure(change, unit(ColumnRole::Position, along), 4, l), &figure(time_s, &SECOND, 6, l), l)
}

/// Returns the unit in which a column is shown.
const fn unit(role: ColumnRole, along: Along) -> &'static Unit {
    match (role, along) {
        (ColumnRole::Time, _) => &SECOND,
        (ColumnRole::Position, Along::Turning) => &DEGREE,
        (ColumnRole::Position, Along::Line) => &MILLIMETRE,
        (ColumnRole::Speed, Along::Turning) => &REVOLUTION_PER_MINUTE,
        (ColumnRole::Speed, Along::Line) => &METRE_PER_SECOND,
        (ColumnRole::Torque, Along::Turning) => &NEWTON_METRE,
        (ColumnRole::Torque, Along::Line) => &NEWTON,
    }
}

/// Returns an acceleration at the output, or along the line.
pub(super) fn acceleration(examined: &ExaminedRecording, si: f64, language: Language) -> String {
    let unit = if examined.is_along_a_line() { &METRE_PER_SECOND_SQUARED } else { &RADIAN_PER_SECOND_SQUARED };
    figure(si, unit, 4, language)
}

/// Returns the sentence about the acceleration that the resolution of the file alone produces, and about its part in the
/// peak torque. A recorded torque that is the whole load contains none of it.
pub(super) fn alone(examined: &ExaminedRecording, is_whole_load: bool, language: Language) -> Option<String> {
    let l = language;
    let made_up = examined.made_up()?;
    let unit = if examined.is_along_a_line() { &METRE_PER_SECOND_SQUARED } else { &RADIAN_PER_SECOND_SQUARED };
    let [alone, motion] = [made_up.acceleration_rad_s2, made_up.motion_rad_s2].map(|si| figure(si, unit, 3, l));
    let cause = match made_up.cause {
        Spurious::Steps { .. } | Spurious::Updates { .. } => incoming::steps_alone(&alone, &motion, l),
        Spurious::Noise { .. } => incoming::noise_alone(&alone, &motion, l),
        Spurious::Held { period_s } => incoming::held_alone(&figure(period_s, &MILLISECOND, 3, l), &alone, &motion, l),
        Spurious::Stamps { scatter_s } => {
            incoming::stamps_alone(&figure(scatter_s, &MILLISECOND, 3, l), &alone, &motion, l)
        }
    };
    let part = if is_whole_load { incoming::in_the_actuator_alone(l) } else { incoming::in_the_peak(l) };
    Some(format!("{cause} {part}"))
}
