//! The simulation of the selected actuator: a scenario, its course, and its figures next to those of the sizing.

use crate::chapters::folded;
use crate::demand::picture;
use crate::gains::gains;
use crate::markup::vals;
use crate::overlay;
use crate::run_part;
use crate::state::PageState;
use axis::AxisProject;
use maud::{Markup, html};
use quantities::{Language, Unit, format_significant};
use questions::list::simulate::{NotSimulated, ScenarioId, of_scenario};
use questions::{Candidate, Progress, Simulated, Verdict, answer, chapter};
use words::{capitalised, page, simulation, terms, verdict_word, views};

/// Runs the selected scenario, else that of the project.
///
/// # Errors
/// The reason, if it is not run.
pub(crate) fn run<'p>(
    state: &PageState,
    project: &'p AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
) -> Result<Simulated<'p>, NotSimulated> {
    let part = run_part::of(state, project).map_err(|sentence| NotSimulated {
        sentence,
        changes: Vec::new(),
        is_too_long: true,
    })?;
    of_scenario(project, Some(&candidate.id), (chosen(state, project), part), progress, state.language)
}

fn chosen(state: &PageState, project: &AxisProject) -> ScenarioId {
    state.scenario.unwrap_or(project.twin.scenario.id)
}

/// Returns the simulation as HTML.
pub(crate) fn view(state: &PageState, project: &AxisProject, candidate: &Candidate<'_>, progress: &Progress) -> Markup {
    let l = state.language;
    let none = html! {};
    let found = run(state, project, candidate, progress);
    let is_it = |id: ScenarioId| id == chosen(state, project);
    html! {
        div.run-bar {
          label.inline { (page::scenario(l)) " "
            select id="scenario" name="scenario" form="state" data-chosen=(chosen(state, project).id()) hx-post="/work" hx-trigger="change" {
                @for id in ScenarioId::ALL { option value=(id.id()) selected[is_it(id)] { (capitalised(&simulation::scenario_title(id, l))) } }
            }
          }
          @if found.is_ok() { button type="button" id="keep-run" data-keep-run="" aria-pressed="false" hx-morph-skip="" data-first=(views::keep_run(l)) data-other=(views::discard_run(l)) { (views::keep_run(l)) } }
          @if found.is_ok() { input type="hidden" id="kept-ranges" name="run_ranges" form="state" value=(list_of(&state.kept_ranges)); span id="kept-legend" hidden { span.kept-sample {} (views::kept_run(l)) } }
        }
        @match &found {
            Ok(run) => {
                @if let Some(part) = &run.part {
                    (run_part::fields(state, project, candidate))
                    (run_part::statement(part, project, !run.scenario.starts_warm(), state))
                }
                @let record = answer::simulation(run, l);
                (exceeded(&record, l))
                (gains(state, &record))
                (overlay::controls(run.summary.time_s, overlay::ShownTime::of(state.window), l))
                (picture(state, "simulation", Ok(figures::simulation(run, state.window, &state.kept_ranges, l)), &none, &none))
                (figures_of(&record, l))
                (folded(&chapter::simulation(&record, l), "run", &[simulation::summary(l), simulation::gains(l)]))
            }
            Err(why) => {
                p.empty { (capitalised(&why.sentence)) }
                @if why.is_too_long { (run_part::fields(state, project, candidate)) }
                @if !why.changes.is_empty() { div.downloads { @for change in &why.changes {
                    @let edits: String = change.edits.iter().map(|(key, value)| format!("value {}{key}={value}\n", state.prefix)).collect();
                    button type="button" hx-post="/work" hx-vals=(vals(&[("do", &edits)])) { (capitalised(&change.title)) }
                } } }
            }
        }
    }
}

/// Returns the ranges as the field of the form keeps them.
fn list_of(ranges: &[(f64, f64)]) -> String {
    ranges.iter().map(|(from, to)| format!("{from} {to}")).collect::<Vec<_>>().join(",")
}

/// Returns the exceeded limits of the run, above its picture; all figures and events are below it.
fn exceeded(record: &answers::Simulation, language: Language) -> Markup {
    let number = |value: Option<answers::Number>| {
        value.map_or_else(|| String::from("–"), |value| format_significant(value.0, 4, language))
    };
    let failed: Vec<_> = record.verdicts.iter().filter(|each| *each.verdict == Verdict::Fail).collect();
    html! { @if !failed.is_empty() {
        p.fail { strong { (capitalised(&verdict_word(Verdict::Fail, language))) ": " } @for (place, each) in failed.iter().enumerate() {
            @if place > 0 { "; " }
            (each.title) " " (number(each.value)) " > " (number(each.limit)) " " (Unit::of(each.unit).map_or(each.unit, |unit| unit.symbol_in(language)))
        } }
    } }
}

/// Returns the figures of the run, with a column for those of a kept run.
fn figures_of(record: &answers::Simulation, language: Language) -> Markup {
    let l = language;
    html! {
        details id="run-summary" open {
            summary { (capitalised(simulation::summary(l))) }
            div.wide tabindex="0" role="region" aria-label=(capitalised(simulation::summary(l))) { table id="run-figures" {
                thead { tr {
                    th scope="col" { (capitalised(simulation::quantity(l))) }
                    th.number scope="col" { (capitalised(terms::value(l))) }
                    th.number scope="col" data-kept=(views::kept_run(l)) {}
                    th scope="col" { (terms::unit(l)) }
                } }
                tbody { @for figure in &record.summary.0 {
                    @if let Some(value) = figure.value {
                        tr data-figure=(figure.id) {
                            td { (figure.title) }
                            td.number { (format_significant(value.0, 4, l)) }
                            td.number {}
                            td { (Unit::of(figure.unit).map_or(figure.unit, |unit| unit.symbol_in(l))) }
                        }
                    }
                } }
            } }
        }
    }
}
