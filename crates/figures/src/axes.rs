//! Power of several axes over time.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::amount;
use plot::{Line, Panel, PlaneAxis, StackedChart, Tone};
use quantities::Language;
use quantities::unit::{SECOND, WATT};
use questions::Course;
use words::{capitalised, page, terms};

const WIDTH_MM: f64 = 165.0;
/// Height of title and time axis.
const FRAME_MM: f64 = 20.0;
const PANEL_MM: f64 = 24.0;

/// Draws the power at the motor terminals of each axis over its cycle, one panel for each; an axis without it is left
/// out. `None` if no axis has it.
#[must_use]
pub fn power_of_axes(axes: &[(&str, Course)], language: Language) -> Option<Drawing> {
    let l = language;
    let mut chart =
        StackedChart::new(PlaneAxis::new("t", SECOND.symbol).name(&capitalised(terms::time(l))).minor_ticks());
    let (mut height, mut said) = (FRAME_MM, Vec::new());
    for (name, course) in axes {
        let points: Vec<(f64, f64)> =
            course.samples.iter().filter_map(|sample| Some((sample.time_s, WATT.from_si(sample.power_w?)))).collect();
        if points.is_empty() {
            continue;
        }
        let (low, high) = points.iter().fold((0.0_f64, 0.0_f64), |(low, high), (_, p)| (low.min(*p), high.max(*p)));
        said.push(words::incoming::range_of(name, &amount(low, &WATT, l), &amount(high, &WATT, l), &"", l));
        let axis = PlaneAxis::new("P", WATT.symbol).name(name);
        chart = chart.panel(Panel::new(axis).with(Line::new(points).tone(Tone::Trace)));
        height += PANEL_MM;
    }
    if said.is_empty() {
        return None;
    }
    let texts = (page::power_over_time_about(l).to_owned(), said.join("; "));
    let of = page::power_over_time(l);
    Some(Drawing::new(Figure::Cycle, of, (WIDTH_MM, height), texts, Chart::Stacked(chart), l))
}
