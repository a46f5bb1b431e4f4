//! The effect of the tolerances on the selected actuator: at once if it is computed quickly, else on request.

use crate::call::{Call, Shell};
use crate::markup::vals;
use crate::shown::looked_at_alone;
use crate::state::PageState;
use crate::waiting;
use axis::AxisProject;
use maud::{Markup, html};
use quantities::Language;
use questions::answer::refusal_text;
use questions::list::check::scatter;
use questions::texts::{sampling_text, tolerance_heads, tolerance_lines, tolerance_rows};
use questions::{Assessment, Candidate, Progress, Refusal};
use words::{capitalised, page};

/// Returns the place of the tolerances; empty if the project has none. It identifies text, axis and actuator, so that a
/// script requests each result once.
pub(crate) fn place(state: &PageState, project: &AxisProject, candidate: &Candidate<'_>, shell: &dyn Shell) -> Markup {
    if project.tolerances.is_empty() {
        return html! {};
    }
    let l = state.language;
    let about = format!("{}\n{}\n{}\n{}\n{:?}", state.good, state.axis, candidate.id, l.id(), state.samples);
    let at_once = state.draw().is_quick(project, 1);
    html! {
        section id="tolerances" aria-labelledby="tolerances-title" data-of=(shell.version(about.as_bytes())) data-at-once=[at_once.then_some("")] {
            h3 id="tolerances-title" { (page::tolerances(l)) }
            p.small { (page::tolerances_about(project.tolerances.len(), l)) }
            label.inline { (page::samples(l)) " "
                input id="samples" name="samples" form="state" inputmode="numeric" size="8" value=[state.samples] placeholder=(page::as_many_as_seconds_allow(l))
                    hx-post="/work" hx-trigger="change";
            } " "
            button type="button" id="tolerances-go" hx-post="/tolerances" hx-target="#tolerances-found" hx-swap="innerHTML" hx-sync="this:replace"
                hx-vals=(vals(&[("code", &candidate.id.to_string())])) { (page::judge_tolerances(l)) }
            div id="tolerances-found" aria-live="polite" {}
        }
    }
}

/// Returns the judged tolerances.
pub(crate) fn judged(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let mut state = PageState::of(call);
    let l = state.language;
    let stopped =
        |refusal: &Refusal| html! { p.advice { (waiting::stopped(refusal, false, None, shell, progress, l)) } };
    let held = state.hold(shell, progress);
    if let Some(refusal) = &held.refused {
        return stopped(refusal);
    }
    let Some(project) = held.projects.get(state.axis) else { return html! {} };
    let Some(candidate) = looked_at_alone(&state, project, progress) else { return html! {} };
    match scatter(project, &candidate, state.draw(), progress) {
        Ok(Some(assessment)) => found(project, &assessment, l),
        Ok(None) => html! {},
        Err(Refusal::Stopped) => stopped(&Refusal::Stopped),
        Err(refusal) => html! { p.fault { (refusal_text(&refusal, None, l)) } },
    }
}

fn found(project: &AxisProject, assessment: &Assessment, language: Language) -> Markup {
    let is_number = |place: usize| !matches!(place, 0 | 3);
    html! {
        p.small { (capitalised(&sampling_text(assessment.sampling, language))) }
        ul.plain { @for line in tolerance_lines(project, assessment, language) { li { (capitalised(&line)) } } }
        div.wide tabindex="0" role="region" aria-labelledby="tolerances-title" {
            table {
                thead { tr { @for (place, head) in tolerance_heads(language).into_iter().enumerate() { th scope="col" class=[is_number(place).then_some("number")] { (capitalised(head)) } } } }
                tbody { @for row in tolerance_rows(project, assessment, language) { tr {
                    @for (place, cell) in row.iter().enumerate() { td class=[is_number(place).then_some("number")] { (cell) } }
                } } }
            }
        }
    }
}
