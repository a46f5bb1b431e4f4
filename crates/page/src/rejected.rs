//! The actuators that do not fit, each with its reason and the change that would let it fit.

use crate::call::{Call, Shell};
use crate::checks;
use crate::fits::{filters, fold};
use crate::markup::{id_of_product, vals};
use crate::parts::part;
use crate::shown::Outcome;
use crate::state::{PageState, product_id};
use axis::AxisProject;
use maud::{Markup, html};
use quantities::Language;
use questions::list::check::reserve_unasked;
use questions::texts::{change_lines, objection_text, reason, reserve_condition};
use questions::{Candidate, Objection, ProductId, Progress, Sizing, check};
use words::{capitalised, page, terms};

/// Number of actuators whose changes are searched at once.
const BLOCK: usize = 20;

/// Longest cycle, in instants and samples, for which the changes are searched without a request: some hundred thousand judged
/// instants for each block. Of a longer one only the selected actuator states its changes.
const INSTANTS_MOST: f64 = 2_000.0;

/// Cost of an instant of the loads on the flange, relative to that of an instant of the cycle.
const FLANGE_SHARE: f64 = 0.05;

/// Field with the actuators of a block.
const NAMES: &str = "names";

/// Returns the rejected actuators by rising excess, each with its failed check, and the checks of the selected one below
/// it. The changes are requested block by block as they come into sight. `version` identifies the project.
pub(crate) fn list(state: &PageState, sizing: &Sizing<'_>, found: &Outcome<'_, '_>, version: &str) -> Markup {
    let l = state.language;
    let all = sizing.rejected();
    let listed: Vec<&Candidate<'_>> = all.iter().filter(|each| state.filter.holds(each)).collect();
    let is_searched = found.project.is_some_and(is_short);
    html! {
        (part(filters(state, sizing)))
        p.small { (page::shown_of(&listed.len(), &all.len(), l)) @if !is_searched { ". " (page::change_when_selected(l)) } }
        table.rejected {
            thead { tr {
                th scope="col" { (capitalised(terms::ordering_code(l))) }
                th scope="col" { (capitalised(terms::reason(l))) }
                @if is_searched { th scope="col" { (page::what_would_let_it_in(l)) } }
            } }
            @for block in listed.chunks(BLOCK) {
                @for (place, candidate) in block.iter().enumerate() {
                    @let name = candidate.id.to_string();
                    @let it = found.candidate.filter(|it| it.id == candidate.id);
                    tbody id={ "r-" (id_of_product(&name)) } aria-current=[it.map(|_| "true")] {
                        tr {
                            td.code {
                                (fold(&name, it.is_some() && state.unfolded, l))
                                button.plain type="button" title=(page::what_would_let_it_in(l)) hx-post="/work" hx-vals=(vals(&[("code", &name)])) { (name) }
                            }
                            td.fail { (reason(candidate, l)) }
                            @if is_searched { td.small id=(cell(version, &name)) hx-morph-skip="" { @if place == 0 {
                                span hx-post="/let-in" hx-trigger="intersect once" hx-swap="none" hx-sync="this" hx-vals=(vals(&[(NAMES, &names(block)), ("version", version)])) { "…" }
                            } @else { "…" } } }
                        }
                        @if let Some(it) = it.filter(|_| state.unfolded) { tr.unfolded { td colspan="3" { (checks::of(it, &state.prefix, l)) } } }
                    }
                }
            }
        }
    }
}

/// Returns `true` if judging the axis some thousand times takes well below a second.
fn is_short(project: &AxisProject) -> bool {
    let [on_flange, recorded] = project.axis.flange_instants();
    #[expect(clippy::cast_precision_loss, reason = "a count of instants")]
    let instants = project.axis.instants() as f64;
    instants + FLANGE_SHARE * (on_flange + recorded) <= INSTANTS_MOST
}

/// Returns the identifier of the cell with the change of an actuator.
fn cell(version: &str, name: &str) -> String {
    format!("w-{version}-{}", id_of_product(name))
}

fn names(block: &[&Candidate<'_>]) -> String {
    block.iter().map(|candidate| candidate.id.to_string()).collect::<Vec<_>>().join("\n")
}

/// Returns what would remove an objection: another requirement, or nothing for a code that cannot be ordered.
fn without(candidate: &Candidate<'_>, objection: &Objection, language: Language) -> String {
    let text = objection_text(candidate, objection, language);
    match objection {
        Objection::Unmet(_) => page::without_the_requirement(&text, language),
        Objection::Rule(_) => text,
    }
}

/// Returns the changes with which the requested actuators would fit, each for its cell.
pub(crate) fn changes(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let mut state = PageState::of(call);
    let l = state.language;
    let held = state.hold(shell, progress);
    let Some(project) = held.projects.get(state.axis).filter(|project| is_short(project)) else { return html! {} };
    let version = call.field("version").unwrap_or_default();
    let named = call.field(NAMES).unwrap_or_default();
    let ids = named.lines().take(BLOCK).filter_map(|name| product_id(name, l));
    let of = |id: &ProductId| {
        let candidate = check(project, id).ok()?;
        let mut parts: Vec<String> = candidate.objections.iter().map(|each| without(&candidate, each, l)).collect();
        // Where only requirements object, reserves of the checks let nothing in.
        if !candidate.judgement_fits() {
            let reserve = reserve_unasked(project, &candidate, progress).ok()?;
            let lines = change_lines(&reserve, &candidate, l).into_iter().flat_map(|(_, parts)| parts);
            let mut text = lines.collect::<Vec<_>>().join(&format!(" {} ", words::pages::or(l)));
            if reserve_condition(&reserve, &candidate, l).is_some() {
                text = format!("{text} ({})", words::report::reserve_partial(l));
            }
            parts.push(if text.is_empty() { page::no_single_change(l).to_owned() } else { text });
        }
        parts.into_iter().reduce(|one, other| page::and_also(&one, &other, l))
    };
    html! {
        @for id in ids {
            @if let Some(text) = of(&id) {
                template hx type="partial" hx-target={ "#" (cell(&version, &id.to_string())) } hx-swap="innerHTML" { (text) }
            }
        }
    }
}
