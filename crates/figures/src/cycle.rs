//! The cycle over time, one panel for each quantity.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::{amount, listed, subject};
use crate::thin::thinned;
use axis::AxisProject;
use plot::{Dash, Label, Line, Panel, PlaneAxis, Reference, StackedChart, Tone};
use quantities::unit::{
    AMPERE, DEGREE, DEGREE_CELSIUS, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, MILLIMETRE, NEWTON_METRE, PERCENT,
    RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND, WATT,
};
use quantities::{Language, Measure, Unit};
use questions::{Candidate, CheckId, Course, Move, Sample};
use words::{capitalised, law_text, pictures, terms};

const WIDTH_MM: f64 = 165.0;
/// Height of title, segments and time axis.
const FRAME_MM: f64 = 26.0;
const PANEL_MM: f64 = 25.5;
/// Relative heights of the panels of the motion: the torque decides, and points of the position can be dragged.
const TORQUE_HIGH: f64 = 2.2;
const POSITION_HIGH: f64 = 1.7;

/// Distance of the course from a limit, as a share of the limit, within which the limit is drawn; a distant one would
/// flatten the course.
const LIMIT_NEAR: f64 = 0.2;

/// Extent of a panel relative to its largest value.
const ROOM: f64 = 1.12;

/// Selection of the quantities of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CyclePanels {
    /// Every quantity, one below the other.
    All,
    /// Position, speed, acceleration and torque.
    Motion,
    /// Current, temperatures and I²t.
    Heat,
    /// Speed, torque and power.
    Energy,
}

/// Draws some quantities of the cycle, or of the time between two instants \[s\] of it with the resolution of that
/// window.
///
/// Position, speed and acceleration are linear ones if the axis has a linear mechanism. In the selection `Motion` the
/// torque is the highest panel and the position is high enough for dragging.
#[must_use]
pub fn cycle(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    shown: CyclePanels,
    window: Option<(f64, f64)>,
    language: Language,
) -> Drawing {
    let window = window.and_then(|window| inside(window, project));
    let whole = questions::course_seen(project, candidate, window);
    let course = thinned(match window {
        Some(window) => cut(whole, window),
        None => whole,
    });
    let moves = questions::moves(project);
    let along = (!moves.turns).then_some(moves.per_output);
    use CyclePanels::{All, Energy, Heat, Motion};
    let is_in = |views: &[CyclePanels]| shown == All || views.contains(&shown);
    let signals = [
        is_in(&[Motion]).then(|| match along {
            Some(factor) => {
                let axis = PlaneAxis::new("x", MILLIMETRE.symbol).name(pictures::position_along_the_line(language));
                signal(&course, axis, &MILLIMETRE, |sample| Some(factor * sample.position_rad))
            }
            None => {
                let axis = PlaneAxis::new("φ", "°").name(pictures::angle_at_the_output(language));
                signal(&course, axis, &DEGREE, |sample| Some(sample.position_rad))
            }
        }),
        along.filter(|_| is_in(&[Motion])).map(|factor| {
            let axis = PlaneAxis::new("v", METRE_PER_SECOND.symbol).name(pictures::speed_along_the_line(language));
            signal(&course, axis, &METRE_PER_SECOND, |sample| Some(factor * sample.speed_rad_s))
        }),
        is_in(&[Motion, Energy]).then(|| {
            limited(
                signal(
                    &course,
                    PlaneAxis::new("n", REVOLUTION_PER_MINUTE.symbol).name(pictures::output_speed(language)),
                    &REVOLUTION_PER_MINUTE,
                    |sample| Some(sample.speed_rad_s),
                ),
                limit_of(candidate, CheckId::PeakSpeed),
                "n_max",
                language,
            )
        }),
        is_in(&[Motion]).then(|| match along {
            Some(factor) => {
                let name = pictures::acceleration_along_the_line(language);
                let axis = PlaneAxis::new("a", METRE_PER_SECOND_SQUARED.symbol).name(name);
                signal(&course, axis, &METRE_PER_SECOND_SQUARED, |sample| Some(factor * sample.acceleration_rad_s2))
            }
            None => {
                let name = pictures::acceleration_at_the_output(language);
                let axis = PlaneAxis::new("α", RADIAN_PER_SECOND_SQUARED.symbol).name(name);
                signal(&course, axis, &RADIAN_PER_SECOND_SQUARED, |sample| Some(sample.acceleration_rad_s2))
            }
        }),
        is_in(&[Motion, Energy]).then(|| {
            limited(
                signal(
                    &course,
                    PlaneAxis::new("T", NEWTON_METRE.symbol).name(pictures::output_torque(language)),
                    &NEWTON_METRE,
                    |sample| Some(sample.torque_nm),
                ),
                limit_of(candidate, CheckId::PeakTorque),
                "T_max",
                language,
            )
        }),
        is_in(&[Heat]).then(|| {
            limited(
                signal(
                    &course,
                    PlaneAxis::new("I", AMPERE.symbol).name(pictures::motor_current_rms(language)),
                    &AMPERE,
                    |sample| sample.current_a,
                ),
                limit_of(candidate, CheckId::PeakCurrent),
                "I_max",
                language,
            )
        }),
        is_in(&[Energy]).then(|| {
            signal(
                &course,
                PlaneAxis::new("P", WATT.symbol).name(pictures::power_at_the_motor_terminals(language)),
                &WATT,
                |sample| sample.power_w,
            )
        }),
    ];
    let overload = limited(
        signal(&course, PlaneAxis::new("I²t", PERCENT.symbol).name(pictures::overload(language)), &PERCENT, |sample| {
            sample.overload
        }),
        limit_of(candidate, CheckId::OverloadI2t),
        "",
        language,
    );
    let mut panels: Vec<Panel> = signals.into_iter().flatten().flatten().map(Signal::panel).collect();
    let mut height = FRAME_MM;
    if shown == Motion {
        // Position first, torque last.
        let high = [POSITION_HIGH, TORQUE_HIGH];
        panels = ends(panels, high);
        height += high.map(|high| (high - 1.0) * PANEL_MM).iter().sum::<f64>();
    }
    if is_in(&[Heat]) {
        panels.extend(temperatures(&course, candidate, language));
        panels.extend(overload.map(Signal::panel));
    }
    let mut chart = StackedChart::new(time_axis(window, language));
    for (from, to, name) in segments(project, language) {
        chart = chart.segment(from, to, name);
    }
    for panel in panels {
        chart = chart.panel(panel);
        height += PANEL_MM;
    }
    let has_inertia = candidate.parameters.inertia_out.known().is_some();
    let caption = if has_inertia { pictures::cycle_caption } else { pictures::cycle_caption_of_the_load };
    let texts = (caption(language).to_owned(), description(&course, project, language));
    let of = subject(candidate, &project.name);
    Drawing::new(Figure::Cycle, &of, (WIDTH_MM, height), texts, Chart::Stacked(chart), language)
}

/// Returns the panels with these heights of the first and the last one.
fn ends(panels: Vec<Panel>, [first, last]: [f64; 2]) -> Vec<Panel> {
    let count = panels.len();
    let high = |(place, panel): (usize, Panel)| match place {
        0 => panel.weight(first),
        place if place + 1 == count => panel.weight(last),
        _ => panel,
    };
    panels.into_iter().enumerate().map(high).collect()
}

/// Returns the part of a time window within the cycle.
pub(crate) fn inside((from, until): (f64, f64), project: &AxisProject) -> Option<(f64, f64)> {
    let until = until.min(project.axis.motion.duration().si());
    (from.max(0.0) < until).then_some((from.max(0.0), until))
}

/// Returns the time axis of a window or of the whole cycle.
pub(crate) fn time_axis(window: Option<(f64, f64)>, language: Language) -> PlaneAxis {
    let axis = PlaneAxis::new("t", SECOND.symbol).name(&capitalised(terms::time(language))).minor_ticks();
    match window {
        Some((from, until)) => axis.range(from, until),
        None => axis,
    }
}

/// Returns the samples within a window, with the one before and the one behind it, so that lines reach its edges.
fn cut(course: Course, (from, until): (f64, f64)) -> Course {
    let first = course.samples.partition_point(|sample| sample.time_s < from).saturating_sub(1);
    let last = course.samples.partition_point(|sample| sample.time_s <= until);
    let samples = course.samples.into_iter().take(last + 1).skip(first).collect();
    Course { samples, ..course }
}

/// A quantity over the cycle.
struct Signal {
    axis: PlaneAxis,
    unit: &'static Unit,
    line: Line,
    /// Extremes in SI.
    low: f64,
    high: f64,
    limits: Vec<Reference>,
    /// Ends of the axis; `None` to leave them to the renderer.
    range: Option<(f64, f64)>,
}

impl Signal {
    fn panel(self) -> Panel {
        let axis = match self.range {
            Some((from, to)) => self.axis.range(from, to),
            None => self.axis,
        };
        self.limits.into_iter().fold(Panel::new(axis).with(self.line), Panel::with)
    }
}

fn signal(
    course: &Course,
    axis: PlaneAxis,
    unit: &'static Unit,
    of: impl Fn(&Sample) -> Option<f64>,
) -> Option<Signal> {
    let (low, high) = extremes(course, &of)?;
    let points = course.samples.iter().filter_map(|sample| Some((sample.time_s, unit.from_si(of(sample)?))));
    let line = Line::new(points).tone(Tone::Trace);
    Some(Signal { axis, unit, line, low, high, limits: Vec::new(), range: None })
}

fn extremes(course: &Course, of: impl Fn(&Sample) -> Option<f64>) -> Option<(f64, f64)> {
    let mut found: Option<(f64, f64)> = None;
    for value in course.samples.iter().filter_map(of) {
        found = Some(found.map_or((value, value), |(low, high)| (low.min(value), high.max(value))));
    }
    // A rounding error next to zero is zero.
    let noise = found.map_or(0.0, |(low, high)| 1e-12 * f64::max(low.abs(), high.abs()));
    let clean = |value: f64| if value.abs() <= noise { 0.0 } else { value };
    found.map(|(low, high)| (clean(low), clean(high)))
}

fn limit_of(candidate: &Candidate<'_>, id: CheckId) -> Option<questions::Amount> {
    candidate.judgement.checks.iter().find(|check| check.id == id)?.limit
}

/// Returns the limit on each side that the signal comes near to.
fn limited(
    signal: Option<Signal>,
    limit: Option<questions::Amount>,
    symbol: &str,
    language: Language,
) -> Option<Signal> {
    let mut signal = signal?;
    let Some(limit) = limit.filter(|limit| limit.si > 0.0) else { return Some(signal) };
    let value = signal.unit.from_si(limit.si);
    let text = amount(limit.si, signal.unit, language);
    let mut label = match symbol {
        "" => Label::from(format!("{} {text}", pictures::limit_of_the_check(language))),
        symbol => Label::symbol(symbol).text(&format!(" = {text}")),
    };
    let line = |value: f64| Reference::horizontal(value).tone(Tone::ShortTime).dash(Dash::Dashed);
    let (above, below) = (signal.high >= LIMIT_NEAR * limit.si, -signal.low >= LIMIT_NEAR * limit.si);
    if above {
        signal.limits.push(line(value).label(std::mem::take(&mut label)));
    }
    if below {
        signal.limits.push(line(-value).label(label));
    }
    if above || below {
        let end = |near: bool, extreme: f64| {
            let extreme = signal.unit.from_si(extreme).max(0.0);
            ROOM * if near { extreme.max(value) } else { extreme }
        };
        signal.range = Some((-end(below, -signal.low), end(above, signal.high)));
    }
    Some(signal)
}

/// Room above the warmest value and below the coldest one, as a share of what lies between them.
const TEMPERATURE_ROOM: f64 = 0.15;

fn temperatures(course: &Course, candidate: &Candidate<'_>, language: Language) -> Option<Panel> {
    let line = |of: fn(&Sample) -> Option<f64>| {
        let points = course.samples.iter();
        Line::new(points.filter_map(move |sample| Some((sample.time_s, DEGREE_CELSIUS.from_si(of(sample)?)))))
    };
    let mut axis = PlaneAxis::new("ϑ", DEGREE_CELSIUS.symbol).name(pictures::temperature(language)).without_zero();
    let (coldest, _) = extremes(course, |sample| sample.housing_k.or(sample.winding_k))?;
    let (_, warmest) = extremes(course, |sample| sample.winding_k)?;
    if let Some(limit) = limit_of(candidate, CheckId::Thermal) {
        let (low, high) = (DEGREE_CELSIUS.from_si(coldest), DEGREE_CELSIUS.from_si(warmest).max(limit.value()));
        let room = TEMPERATURE_ROOM * (high - low).max(1.0);
        axis = axis.range(low - room, high + room);
    }
    let mut panel = Panel::new(axis)
        .with(line(|sample| sample.winding_k).tone(Tone::Trace).label(terms::winding(language)))
        .with(line(|sample| sample.housing_k).tone(Tone::Series(1)).label(terms::housing(language)));
    if let Some(limit) = limit_of(candidate, CheckId::Thermal) {
        let text = format!("{} {}", pictures::limit_of_the_check(language), amount(limit.si, limit.unit, language));
        panel = panel.with(Reference::horizontal(limit.value()).tone(Tone::Continuous).label(text));
    }
    Some(panel)
}

/// Returns beginning, end and name of each segment.
pub(crate) fn segments(project: &AxisProject, language: Language) -> Vec<(f64, f64, String)> {
    let named = |(index, segment): (usize, &Move<'_>)| {
        let what = law_text(segment.law, language);
        let from = segment.start.si();
        (from, from + segment.duration.si(), format!("{} {what}", index + 1))
    };
    questions::moves(project).moves.iter().enumerate().map(named).collect()
}

fn description(course: &Course, project: &AxisProject, language: Language) -> String {
    let range = |what: &str, of: &dyn Fn(&Sample) -> Option<f64>, unit: &Unit| {
        let (low, high) = extremes(course, of)?;
        Some(pictures::from_to(&what, &amount(low, unit, language), &amount(high, unit, language), language))
    };
    let l = language;
    let parts: Vec<String> = [
        range(pictures::the_angle(l), &|sample| Some(sample.position_rad), &DEGREE),
        range(pictures::the_speed(l), &|sample| Some(sample.speed_rad_s), &REVOLUTION_PER_MINUTE),
        range(pictures::the_torque(l), &|sample| Some(sample.torque_nm), &NEWTON_METRE),
        range(pictures::the_current(l), &|sample| sample.current_a, &AMPERE),
        range(pictures::the_power(l), &|sample| sample.power_w, &WATT),
        range(pictures::the_winding(l), &|sample| sample.winding_k, &DEGREE_CELSIUS),
        range(pictures::the_overload(l), &|sample| sample.overload, &PERCENT),
    ]
    .into_iter()
    .flatten()
    .collect();
    let (count, duration) = (questions::moves(project).moves.len(), amount(course.duration_s, &SECOND, language));
    pictures::cycle_described(count, &duration, &listed(&parts, l), l)
}
