//! Part of a long cycle for the simulation: its beginning and its duration, typed or taken from the worst instants.

use crate::markup::vals;
use crate::overlay::{self, Worst};
use crate::state::PageState;
use crate::value::{stated, with_mark};
use axis::AxisProject;
use maud::{Markup, html};
use quantities::unit::SECOND;
use quantities::{Language, Measure, Time, format_significant, parse_as};
use questions::list::simulate::Part;
use questions::{Candidate, Check};
use words::{title_of_check, views};

/// Duration of a proposed part \[s\].
const PROPOSED_S: f64 = 10.0;

/// Shortest part \[s\].
const LEAST_S: f64 = 0.01;

/// Largest number of proposed parts.
const PROPOSALS: usize = 3;

/// Returns the duration of all cycles of a run \[s\].
fn whole_s(project: &AxisProject) -> f64 {
    project.axis.motion.duration().si() * f64::from(project.twin.scenario.cycles.max(1))
}

/// Formats a duration with its unit.
fn seconds_text(seconds: f64, digits: usize, language: Language) -> String {
    format!("{} {}", format_significant(seconds, digits, language), SECOND.symbol_in(language))
}

/// Returns the stated part; `None` for the whole motion.
///
/// # Errors
/// The limits of a part, if the stated one is not within them.
pub(crate) fn of(state: &PageState, project: &AxisProject) -> Result<Option<Part>, String> {
    let Some([from, long]) = &state.part else { return Ok(None) };
    let l = state.language;
    let whole = whole_s(project);
    let seconds = |typed: &str| parse_as::<Time>(&stated(typed, "s", l)).ok().map(Measure::si);
    let part = seconds(from).zip(seconds(long)).map(|(from_s, for_s)| Part { from_s, for_s });
    let is_within =
        |part: &Part| part.from_s >= 0.0 && part.for_s >= LEAST_S && part.from_s + part.for_s <= whole * (1.0 + 1e-9);
    part.filter(is_within)
        .map(Some)
        .ok_or_else(|| views::part_outside(&seconds_text(whole, 6, l), &seconds_text(LEAST_S, 2, l), l))
}

/// Returns the stated or proposed beginning and duration, as their fields show them.
fn shown(state: &PageState, worst: &[Worst<'_>], whole: f64) -> [String; 2] {
    state.part.clone().unwrap_or_else(|| {
        let first = worst.first().map_or(0.0, Worst::at_s);
        around(first, whole).map(|seconds| with_mark(&seconds, state.language))
    })
}

/// Returns beginning and duration of a part around an instant, as a project file states numbers.
fn around(at_s: f64, whole: f64) -> [String; 2] {
    let long = PROPOSED_S.min(whole);
    // In whole milliseconds the part ends within the motion.
    let from = (at_s - 0.5 * long).clamp(0.0, whole - long);
    [from, long].map(|seconds| ((seconds * 1e3).floor() / 1e3).to_string())
}

/// Returns the fields of the part, and the parts around the worst instants of the cycle.
pub(crate) fn fields(state: &PageState, project: &AxisProject, candidate: &Candidate<'_>) -> Markup {
    let l = state.language;
    let (whole, worst) = (whole_s(project), overlay::worst(candidate));
    let [from, long] = shown(state, &worst, whole);
    // Instants close to each other have one part.
    let mut parts: Vec<([String; 2], &Worst<'_>)> = Vec::new();
    for each in &worst {
        let part = around(each.at_s(), whole);
        if parts.len() < PROPOSALS && parts.iter().all(|(known, _)| *known != part) {
            parts.push((part, each));
        }
    }
    let names = |each: &Worst<'_>| {
        let name = |check: &&Check| title_of_check(check, l);
        each.checks().iter().map(name).collect::<Vec<_>>().join(", ")
    };
    html! {
        div.run-part id="part-of-run" role="group" aria-label=(views::part_of_cycle(l)) {
            span { (views::part_of_cycle(l)) ": " (views::part_from(l)) " " }
            span.quantity { input id="run-from" name="run_from" form="state" type="text" size="8" inputmode="decimal" autocomplete="off" value=(from) aria-label=(views::part_start(l)); span.unit { (SECOND.symbol) } }
            span { " " (views::part_for(l)) " " }
            span.quantity { input id="run-for" name="run_for" form="state" type="text" size="6" inputmode="decimal" autocomplete="off" value=(long) aria-label=(views::part_duration(l)); span.unit { (SECOND.symbol) } }
            input type="hidden" id="run-is-part" name="run_part" form="state" value=(state.part.is_some());
            " " button type="button" id="run-part" hx-post="/work" hx-vals=(vals(&[("run_part", "true")])) { (views::run_part(l)) }
            @if state.part.is_some() { " " button type="button" id="run-whole" hx-post="/work" hx-vals=(vals(&[("run_part", "false")])) { (views::whole_cycle(l)) } }
        }
        @if !parts.is_empty() { div.downloads { @for ([from, long], each) in &parts {
            button.small type="button" hx-post="/work" hx-vals=(vals(&[("run_part", "true"), ("run_from", &with_mark(from, l)), ("run_for", &with_mark(long, l))])) {
                (views::part_around(&seconds_text(PROPOSED_S.min(whole), 2, l), &seconds_text(each.at_s(), 5, l), &names(each), l))
            }
        } } }
    }
}

/// Returns the statement of which part was simulated.
pub(crate) fn statement(part: &Part, project: &AxisProject, is_cold: bool, state: &PageState) -> Markup {
    let l = state.language;
    let figure = |seconds: f64| seconds_text(seconds, 6, l);
    let text = views::part_shown(&figure(part.from_s), &figure(part.from_s + part.for_s), &figure(whole_s(project)), l);
    html! { p.advice id="part-shown" { (text) @if !is_cold { " " (views::part_is_warm(l)) } } }
}
