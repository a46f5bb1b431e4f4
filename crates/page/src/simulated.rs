//! The simulation of the selected actuator: a scenario, its course, and its figures next to those of the sizing.

use crate::chapters::laid_out;
use crate::demand::picture;
use crate::overlay;
use crate::state::PageState;
use axis::AxisProject;
use maud::{Markup, html};
use project::key_at;
use quantities::{Language, Unit, format_significant};
use questions::list::simulate::{ScenarioId, of_scenario};
use questions::{Candidate, Progress, Simulated, Verdict, answer, chapter};
use words::{about_text, capitalised, page, short_label, simulation, verdict_word};

/// Runs the selected scenario, else that of the project.
///
/// # Errors
/// The reason in one sentence, if it is not run.
pub(crate) fn run<'p>(
    state: &PageState,
    project: &'p AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
) -> Result<Simulated<'p>, String> {
    of_scenario(project, Some(&candidate.id), chosen(state, project), progress, state.language)
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
        label.inline { (page::scenario(l)) " "
            select id="scenario" name="scenario" form="state" data-chosen=(chosen(state, project).id()) hx-post="/work" hx-trigger="change" {
                @for id in ScenarioId::ALL { option value=(id.id()) selected[is_it(id)] { (capitalised(&simulation::scenario_title(id, l))) } }
            }
        }
        @match &found {
            Ok(run) => {
                @let record = answer::simulation(run, l);
                (exceeded(&record, l))
                (overlay::controls(run.summary.time_s, overlay::ShownTime::of(state.window), l))
                (picture(state, "simulation", Ok(figures::simulation(run, state.window, l)), &none, &none))
                (gains(state, &record, l))
                (laid_out(&chapter::simulation(&record, l)))
            }
            Err(why) => p.empty { (capitalised(why)) },
        }
    }
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

/// Returns the gains in use, each with a link to its field: another gain starts a new run, and the instant stays.
fn gains(state: &PageState, record: &answers::Simulation, language: Language) -> Markup {
    let l = language;
    let stated = record.gains.0.iter().filter_map(|gain| {
        let path = format!("{}twin.{}", state.prefix, gain.id);
        let key = key_at(&path)?;
        Some((path, short_label(about_text(key.about, l)), gain.title.as_str(), gain.value?, gain.unit))
    });
    html! {
        p.small { (page::gains_in_use(l)) ": " @for (place, (path, about, symbol, value, unit)) in stated.enumerate() {
            @if place > 0 { ", " }
            a href={ "#" (crate::markup::id(&path)) } title=(about) { (crate::chapters::symbol(symbol)) } " = " (format_significant(value.0, 4, l)) " " (Unit::of(unit).map_or(unit, |unit| unit.symbol_in(l)))
        } }
    }
}
