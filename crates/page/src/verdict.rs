//! The bar under the head, always visible: verdict, governing checks, open checks, and the faults of the text.

use crate::fault_lines::FaultLines;
use crate::markup::{id, label, vals};
use crate::shown::{Outcome, class};
use crate::state::{List, PageState, ReadProject};
use maud::{Markup, html};
use project::key_at;
use quantities::Language;
use questions::list::check::reserve_unasked;
use questions::texts::{objection_text, percent, reserve_lines, standing_text};
use questions::{Candidate, Progress, Verdict};
use words::{
    about_text, capitalised, check_title, page, short_label, terminal, terms, unmet_text, verdict_count, without_limit,
};

/// Number of faults shown at once.
pub(crate) const FAULTS_SHOWN: usize = 20;

/// Returns the bar.
pub(crate) fn bar(
    state: &PageState,
    held: &ReadProject,
    found: &Outcome<'_, '_>,
    fields: &str,
    progress: &Progress,
) -> Markup {
    let l = state.language;
    let class = found.candidate.map_or("none", class);
    let assumed = found.project.map_or(0, |project| project.assumed().len());
    html! {
        section id="verdict" class={ (class) @if held.is_old { " old" } } aria-label=(capitalised(terms::verdict(l))) {
            @match found.candidate {
                Some(candidate) => { (line(candidate, assumed, l)) (below(found, candidate, progress, l)) },
                None => p id="standing" role="status" tabindex="-1" { (page::no_result_yet(l)) },
            }
            (faults(held, &FaultLines::new(state, held, fields)))
            (crate::markup::stopped(&html! {}))
            @if held.is_old && found.candidate.is_some() { p.advice id="is-old" role="status" { (page::result_is_old(l)) } }
        }
    }
}

fn line(candidate: &Candidate<'_>, assumed: usize, language: Language) -> Markup {
    let l = language;
    let counts = candidate.counts();
    let list = if candidate.fits() { List::Ranking } else { List::Rejected };
    let shown = vals(&[("unfolded", "true"), ("list", list.id())]);
    let count = |class: &str, count: usize, text: String| {
        html! { @if count > 0 {
            button type="button" class={ "count " (class) } data-goto={ "#checks tr." (class) } hx-post="/work" hx-vals=(shown) { @match text.split_once(' ') { Some((number, word)) => { (number) span.word { " " (word) } }, None => { (text) } } }
        } }
    };
    let of = |verdict, count| verdict_count(verdict, count, l);
    html! {
        p id="standing" role="status" aria-live="polite" tabindex="-1" { strong.code { (candidate.id) } ": " (standing_text(candidate, l)) }
        @if let Some(tightest) = candidate.governing() {
            button.count type="button" id="tightest" data-goto={ "#check-" (tightest.id.id()) } hx-post="/work" hx-vals=(shown) {
                span.word { (page::tightest(l)) " " } span.name { (check_title(tightest.id, l)) } " " strong { (percent(tightest.utilisation, l)) " %" }
            }
        }
        span.counts role="group" aria-label=(capitalised(terms::checks(l))) {
            (count("fail", counts.failed, of(Verdict::Fail, counts.failed)))
            (count("pass", counts.passed, of(Verdict::Pass, counts.passed)))
            (count("advice", counts.advised, of(Verdict::Advice, counts.advised)))
            (count("unchecked", counts.not_checked, of(Verdict::NotChecked, counts.not_checked)))
            (count("no-limit", counts.without_limit, format!("{} {}", counts.without_limit, without_limit(l))))
            @if assumed > 0 { a.count.assumed-count href="#assumptions" { (assumed) span.word { " " (terms::assumed(l)) } } }
        }
    }
}

/// Returns the failed checks, the changes that would let it fit, and the values to state so that the other checks can
/// be made.
fn below(found: &Outcome<'_, '_>, candidate: &Candidate<'_>, progress: &Progress, language: Language) -> Markup {
    let l = language;
    let keys = candidate.keys_to_state();
    let reserve = match found.project {
        // Where no actuator fits, the right pane says what would.
        Some(project) if !candidate.fits() && found.sizing.is_some_and(|sizing| sizing.answer().is_some()) => {
            reserve_unasked(project, candidate, progress).unwrap_or_default()
        }
        _ => questions::Reserve::default(),
    };
    html! {
        @for objection in &candidate.objections { p.below.fail { (objection_text(candidate, objection, l)) } }
        @for open in &candidate.open_requirements { p.below.open { (capitalised(terminal::requirement_not_checked(l))) ": " (unmet_text(open, l)) } }
        @for (head, parts) in reserve_lines(&reserve, candidate, l) {
            p.below.would { (capitalised(head)) ": " @for (place, part) in parts.iter().enumerate() { @if place > 0 { "; " } (part) } }
        }
        @if !keys.is_empty() {
            p.below.open { (page::to_be_checked_state(l)) " " @for (place, (key, _)) in keys.iter().enumerate() {
                @if place > 0 { ", " }
                a href={ "#" (id(key)) } { (key_at(key).map_or_else(|| html! { (key) }, |known| label(&short_label(about_text(known.about, l))))) }
            } }
        }
    }
}

/// Returns the faults of the text: the first in a line, the others in a fold.
fn faults(held: &ReadProject, lines: &FaultLines<'_>) -> Markup {
    let more = held.faults.len().saturating_sub(1);
    let l = lines.language();
    html! {
        div id="faults" role="status" {
            @if let Some(first) = held.faults.first() {
                // A single line, so that the field with the focus keeps its place; the others open over the panes.
                strong.fault { (page::faults(held.faults.len(), l)) } " "
                ul.first { li { (lines.line(first)) } }
                @if more > 0 {
                    details.more-faults id="more-faults" {
                        summary { (page::more_faults(more, l)) }
                        ul { @for fault in held.faults.iter().take(FAULTS_SHOWN).skip(1) { li { (lines.line(fault)) } } }
                    }
                }
            }
        }
    }
}
