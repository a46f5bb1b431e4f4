//! The simulation of the actuator that is looked at: a scenario, its course, what it shows beside the sizing.

use crate::chapters::laid_out;
use crate::demand::picture;
use crate::state::State;
use maud::{Markup, html};
use project::Project;
use questions::list::simulate::{ScenarioId, of_scenario};
use questions::{Candidate, CandidateId, Patience, Simulated, answer, chapter};
use words::{capitalised, page, simulation};

/// The run of the scenario that is chosen, else of the one that the project states.
///
/// # Errors
/// Why it is not run, in a sentence.
pub(crate) fn run<'p>(
    state: &State,
    project: &'p Project,
    candidate: &Candidate<'_>,
    patience: &Patience,
) -> Result<Simulated<'p>, String> {
    let code = match &candidate.id {
        CandidateId::Code(code) => Some(code),
        CandidateId::Own(_) => None,
    };
    of_scenario(project, code, chosen(state, project), patience, state.language)
}

fn chosen(state: &State, project: &Project) -> ScenarioId {
    state.scenario.unwrap_or(project.twin.scenario.id)
}

/// What is shown.
pub(crate) fn view(state: &State, project: &Project, candidate: &Candidate<'_>, patience: &Patience) -> Markup {
    let l = state.language;
    let none = html! {};
    let found = run(state, project, candidate, patience);
    let is_it = |id: ScenarioId| id == chosen(state, project);
    html! {
        label.inline { (page::scenario(l)) " "
            select id="scenario" name="scenario" form="state" data-chosen=(chosen(state, project).id()) hx-post="/work" hx-trigger="change" {
                @for id in ScenarioId::ALL { option value=(id.id()) selected[is_it(*id)] { (capitalised(&simulation::scenario_title(*id, l))) } }
            }
        }
        @match &found {
            Ok(run) => {
                (picture(state, "simulation", Ok(figures::simulation(run, l)), &none, &none))
                (laid_out(&chapter::simulation(&answer::simulation(run, l), l)))
            }
            Err(why) => p.empty { (capitalised(why)) },
        }
    }
}
