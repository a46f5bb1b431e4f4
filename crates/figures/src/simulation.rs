//! A run of the digital twin over time, and the frequency responses of its control.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::subject;
use plot::{Dash, Line, Panel, PlaneAxis, Reference, StackedChart, Tone};
use quantities::unit::{AMPERE, ARCMINUTE, DEGREE, DEGREE_CELSIUS, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND, VOLT};
use quantities::{Language, Unit, format_significant};
use questions::{Simulated, TwinSample};
use std::f64::consts::SQRT_2;
use words::{capitalised, pictures, simulation, terms};

const WIDTH_MM: f64 = 165.0;
/// Height of title and axis of time, and of a panel.
const FRAME_MM: f64 = 26.0;
const PANEL_MM: f64 = 27.0;
/// Relative height of the courses by which a run is judged: torque, current and following error.
const JUDGED_HIGH: f64 = 1.6;

/// A line of a panel: tone, dash, label, value in SI.
type Curve<'l> = (Tone, Option<Dash>, &'l str, fn(&TwinSample) -> f64);

/// Draws a run; `id` is one of [`questions::list::simulate::FIGURES`], `None` selects the course.
#[must_use]
pub fn of_a_run(id: Option<&str>, run: &Simulated<'_>, language: Language) -> Drawing {
    match id {
        Some("control_loops") => control_loops(run, language),
        _ => simulation(run, None, &[], language),
    }
}

/// Draws position, speed, torque, current, following error, DC link and temperatures over the run, or between two
/// instants \[s\] of it. The scale of each panel contains the range in `also`, in the unit of the panel: that of another run to
/// compare with.
#[must_use]
pub fn simulation(run: &Simulated<'_>, window: Option<(f64, f64)>, also: &[(f64, f64)], language: Language) -> Drawing {
    let l = language;
    let (from, until) = window.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let first = run.course.partition_point(|sample| sample.time_s < from);
    let last = run.course.partition_point(|sample| sample.time_s <= until);
    // A window outside the run, or between two of its samples, shows the whole run.
    let course = run.course.get(first..last).filter(|course| course.len() > 1).unwrap_or(&run.course);
    let of = |axis: PlaneAxis, unit: &'static Unit, curves: &[Curve<'_>]| {
        curves.iter().fold(Panel::new(axis), |panel, (tone, dash, label, value)| {
            let points = course.iter().map(|sample| (sample.time_s, unit.from_si(value(sample))));
            let line = Line::new(points).tone(*tone);
            let line = if label.is_empty() { line } else { line.label(*label) };
            panel.with(match dash {
                Some(dash) => line.dash(*dash),
                None => line,
            })
        })
    };
    let (first, second) = (Tone::Series(0), Tone::Series(1));
    let [wanted, load, motor] = [simulation::wanted(l), simulation::of_the_load(l), simulation::of_the_motor(l)];
    let mut panels = vec![
        of(
            PlaneAxis::new("φ", DEGREE.symbol).name(pictures::angle_at_the_output(l)),
            &DEGREE,
            &[(first, None, load, |s| s.position_rad), (Tone::Trace, Some(Dash::Dotted), wanted, |s| s.wanted_rad)],
        ),
        of(
            PlaneAxis::new("n", REVOLUTION_PER_MINUTE.symbol).name(pictures::output_speed(l)),
            &REVOLUTION_PER_MINUTE,
            &[
                (second, None, motor, |s| s.motor_rad_s),
                (first, None, load, |s| s.speed_rad_s),
                (Tone::Trace, Some(Dash::Dotted), wanted, |s| s.wanted_rad_s),
            ],
        ),
        of(
            PlaneAxis::new("T", NEWTON_METRE.symbol).name(pictures::torque_on_the_gear(l)),
            &NEWTON_METRE,
            &[(Tone::Trace, None, "", |s| s.torque_nm)],
        )
        .weight(JUDGED_HIGH),
        of(
            PlaneAxis::new("I", AMPERE.symbol).name(pictures::motor_current_rms(l)),
            &AMPERE,
            &[(Tone::Trace, None, "", |s| s.current_q_a / SQRT_2)],
        )
        .weight(JUDGED_HIGH),
        of(
            PlaneAxis::new("Δφ", "arcmin").name(simulation::following_error(l)),
            &ARCMINUTE,
            &[(Tone::Trace, None, "", |s| s.following_rad)],
        )
        .weight(JUDGED_HIGH),
        of(
            PlaneAxis::new("U_DC", VOLT.symbol).name(simulation::dc_link(l)),
            &VOLT,
            &[(Tone::Trace, None, "", |s| s.link_v)],
        ),
    ];
    let (winding, housing) = (terms::winding(l), terms::housing(l));
    panels.push(of(
        PlaneAxis::new("ϑ", DEGREE_CELSIUS.symbol).name(simulation::temperatures(l)),
        &DEGREE_CELSIUS,
        &[(first, None, winding, |s| s.winding_k), (second, None, housing, |s| s.housing_k)],
    ));
    let time = PlaneAxis::new("t", SECOND.symbol).name(&capitalised(terms::time(l))).minor_ticks();
    let mut chart = StackedChart::new(time);
    let mut height = FRAME_MM;
    let also = also.iter().copied().map(Some).chain(std::iter::repeat(None));
    for (panel, also) in panels.into_iter().zip(also) {
        let panel = match also {
            Some(range) => panel.including(range),
            None => panel,
        };
        // Events are marked in every panel.
        let marks = run
            .events
            .iter()
            .filter(|event| event.kind == questions::TwinEvent::Scenario && (from..=until).contains(&event.time_s));
        let panel = marks.fold(panel, |panel, event| panel.with(Reference::vertical(event.time_s).dash(Dash::Dashed)));
        chart = chart.panel(panel);
        height += PANEL_MM;
    }
    let number = |value: f64| format_significant(value, 4, l);
    let summary = &run.summary;
    let described = simulation::run_described(
        &simulation::scenario_title(run.scenario.id, l),
        &number(summary.time_s),
        &number(summary.current_peak_a),
        &number(summary.torque_peak_nm),
        &number(ARCMINUTE.from_si(summary.following_peak_rad)),
        l,
    );
    let (of, texts) = (subject(&run.candidate, &run.project.name), (simulation::run_caption(l).to_owned(), described));
    Drawing::new(Figure::Simulation, &of, (WIDTH_MM, height), texts, Chart::Stacked(chart), l)
}

/// Draws magnitude and phase of the open loops over the logarithm of the frequency, with the limits of stability.
#[must_use]
pub fn control_loops(run: &Simulated<'_>, language: Language) -> Drawing {
    let l = language;
    let frequency = PlaneAxis::new("lg f", "Hz").name(simulation::logarithm_of_frequency(l)).minor_ticks();
    let decibel = |size: f64| 20.0 * size.max(1e-6).log10();
    let mut magnitude = Panel::new(PlaneAxis::new("|F|", "dB").name(simulation::magnitude(l)));
    let mut phase = Panel::new(PlaneAxis::new("φ", "°").name(simulation::phase(l)));
    for (tone, each) in (0_u8..).zip(&run.loops) {
        let tone = Tone::Series(tone);
        let label = simulation::loop_title(each.of, l);
        let seen = || each.points.iter().filter(|point| point.frequency_hz >= 1.0);
        magnitude = magnitude.with(
            Line::new(seen().map(|point| (point.frequency_hz.log10(), decibel(point.open)))).tone(tone).label(label),
        );
        let angle = seen().map(|point| (point.frequency_hz.log10(), DEGREE.from_si(point.open_phase_rad)));
        phase = phase.with(Line::new(angle).tone(tone));
    }
    magnitude = magnitude.with(Reference::horizontal(0.0).dash(Dash::Dotted));
    phase = phase.with(Reference::horizontal(-180.0).dash(Dash::Dotted));
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |value| format_significant(value, 3, l));
    let each = run.loops.iter().map(|each| {
        let margin = each.margins.phase_rad.map(f64::to_degrees);
        simulation::loop_described(
            &simulation::loop_title(each.of, l),
            &number(each.margins.crossover_hz),
            &number(margin),
            &number(each.margins.bandwidth_hz),
            l,
        )
    });
    let described = each.collect::<Vec<_>>().join(" ");
    let chart = StackedChart::new(frequency).panel(magnitude.weight(1.4)).panel(phase);
    let (of, texts) =
        (subject(&run.candidate, &run.project.name), (simulation::loops_caption(l).to_owned(), described));
    Drawing::new(Figure::ControlLoops, &of, (WIDTH_MM, 120.0), texts, Chart::Stacked(chart), l)
}
