//! A recording over time, before it is part of a project.

use crate::drawing::{Chart, Drawing, Figure};
use plot::{Line, Panel, PlaneAxis, StackedChart, Tone};
use quantities::unit::{DEGREE, METRE_PER_SECOND, MILLIMETRE, NEWTON, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Unit, format_significant};
use questions::{Along, ColumnRole, ExaminedRecording};
use words::{capitalised, incoming, pictures, role_text, terms};

const WIDTH_MM: f64 = 165.0;
/// Height of title and time axis.
const FRAME_MM: f64 = 20.0;
const PANEL_MM: f64 = 24.0;

/// Number of time columns of a curve, each with its smallest and its largest value.
const COLUMNS: usize = 1500;

/// Draws position, speed and torque of a recording over its time. Speed that is not recorded is the derivative of the position.
#[must_use]
pub fn recording(name: &str, found: &ExaminedRecording, language: Language) -> Drawing {
    let l = language;
    let course = &found.recording.course;
    let along = if found.is_along_a_line() { Along::Line } else { Along::Turning };
    let recorded = &found.recorded;
    let position =
        course.position.as_ref().map(|series| (ColumnRole::Position, series.along, series.values.as_slice()));
    let speed = match &course.speed {
        Some(series) => (ColumnRole::Speed, series.along, series.values.as_slice()),
        None => (ColumnRole::Speed, along, recorded.speed_rad_s()),
    };
    let torque =
        found.recording.torque.as_ref().map(|series| (ColumnRole::Torque, series.along, series.values.as_slice()));
    let time = &found.recording.time_s;
    let mut chart =
        StackedChart::new(PlaneAxis::new("t", SECOND.symbol).name(&capitalised(terms::time(l))).minor_ticks());
    let mut said = Vec::new();
    let mut height = FRAME_MM;
    for (role, along, values) in [position, Some(speed), torque].into_iter().flatten() {
        let (symbol, unit) = sign(role, along);
        let name = capitalised(&role_text(role, l));
        let is_derived = role == ColumnRole::Speed && course.speed.is_none();
        let name = if is_derived { incoming::from_position(&name, l) } else { name };
        let line = Line::new(thinned(time, values).map(|(t, value)| (t, unit.from_si(value)))).tone(Tone::Trace);
        chart = chart.panel(Panel::new(PlaneAxis::new(symbol, unit.symbol).name(&name)).with(line));
        height += PANEL_MM;
        let (low, high) = values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
        let number = |si: f64| format_significant(unit.from_si(si), 4, l);
        said.push(incoming::range_of(&name, &number(low), &number(high), &unit.symbol, l));
    }
    let texts = (pictures::recording_caption(l).to_owned(), said.join("; "));
    Drawing::new(Figure::Cycle, name, (WIDTH_MM, height), texts, Chart::Stacked(chart), l)
}

/// Returns symbol and unit of a column.
const fn sign(role: ColumnRole, along: Along) -> (&'static str, &'static Unit) {
    match (role, along) {
        (ColumnRole::Time, _) => ("t", &SECOND),
        (ColumnRole::Position, Along::Turning) => ("φ", &DEGREE),
        (ColumnRole::Position, Along::Line) => ("x", &MILLIMETRE),
        (ColumnRole::Speed, Along::Turning) => ("n", &REVOLUTION_PER_MINUTE),
        (ColumnRole::Speed, Along::Line) => ("v", &METRE_PER_SECOND),
        (ColumnRole::Torque, Along::Turning) => ("T", &NEWTON_METRE),
        (ColumnRole::Torque, Along::Line) => ("F", &NEWTON),
    }
}

/// Reduces a curve to its smallest and its largest value of each column of equal numbers of samples.
fn thinned<'v>(time: &'v [f64], values: &'v [f64]) -> impl Iterator<Item = (f64, f64)> + 'v {
    let width = time.len().div_ceil(2 * COLUMNS).max(1);
    let chunk = |(time, values): (&'v [f64], &'v [f64])| {
        let points = || time.iter().copied().zip(values.iter().copied());
        let least = points().min_by(|one, other| one.1.total_cmp(&other.1));
        let most = points().max_by(|one, other| one.1.total_cmp(&other.1));
        let mut pair: Vec<(f64, f64)> = [least, most].into_iter().flatten().collect();
        pair.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
        pair.dedup();
        pair
    };
    time.chunks(width).zip(values.chunks(width)).flat_map(chunk)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thinned_curve_keeps_its_extremes() {
        for rows in [7_u32, 1000, 100_000] {
            let time: Vec<f64> = (0..rows).map(f64::from).collect();
            let mut values: Vec<f64> = time.iter().map(|t| (0.01 * t).sin()).collect();
            values[rows as usize / 2] = 7.0;
            values[rows as usize / 3] = -8.0;
            let found: Vec<(f64, f64)> = thinned(&time, &values).collect();
            assert!(found.len() <= 4 * COLUMNS && found.is_sorted_by(|one, other| one.0 < other.0));
            let extremes = found.iter().fold((0.0_f64, 0.0_f64), |(low, high), p| (low.min(p.1), high.max(p.1)));
            assert_eq!(extremes, (-8.0, 7.0));
        }
    }
}
