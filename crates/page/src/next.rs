//! Steps to the first result of an axis, in the place of the actuators.

use crate::fault_lines::FaultLines;
use crate::markup::id;
use crate::sketch;
use crate::state::{PageState, ReadProject};
use crate::verdict::FAULTS_SHOWN;
use maud::{Markup, html};
use words::{capitalised, page, terms, views};

/// A step towards the first result.
struct Step {
    title: &'static str,
    is_done: bool,
    /// Identifier of the place where it is stated.
    at: String,
    drawing: Markup,
}

/// Returns what leads to a result: the steps that are still open as drawings with links to their places in the left
/// pane; where load and motion are stated, the faults of the project.
pub(crate) fn steps(state: &PageState, held: &ReadProject, fields: &str) -> Markup {
    let l = state.language;
    let is_stated = |table: &str| held.written.is_there(&format!("{}{table}", state.prefix));
    let at = |table: &str| format!("{}-t", id(&format!("{}{table}", state.prefix)));
    let law = html! { svg viewBox="0 0 52 58" { use href="#law-modified_sine" {} } };
    let all = [
        Step {
            title: page::mechanism(l),
            is_done: is_stated("load") || is_stated("mechanism"),
            at: String::from("mechanism"),
            drawing: sketch::still(Some("arm")),
        },
        Step { title: terms::motion(l), is_done: is_stated("motion"), at: at("motion"), drawing: law },
    ];
    let lines = FaultLines::new(state, held, fields);
    html! {
        @if all.iter().all(|step| step.is_done) {
            h3 { (page::faults(held.faults.len(), l)) }
            p { (page::no_result_yet(l)) }
            ul.by-line { @for fault in held.faults.iter().take(FAULTS_SHOWN) { li { (lines.line(fault)) } } }
        } @else {
            h3 { (views::next_steps(l)) }
            p { (page::no_result_yet(l)) }
            ul.tiles.steps { @for step in all {
                li { a.tile href={ "#" (step.at) } {
                    span.sketch aria-hidden="true" { (step.drawing) }
                    span { (capitalised(step.title)) ": " (if step.is_done { views::is_stated(l) } else { views::is_open(l) }) }
                } }
            } }
            p.small { (views::then_actuators(l)) }
        }
    }
}
