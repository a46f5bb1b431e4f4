//! The printed page: the first page of the report, as the browser prints it.

use crate::markup::logo;
use crate::shown::{class, looked_at_alone};
use crate::state::PageState;
use crate::{Call, Shell};
use axis::AxisProject;
use maud::{Markup, html};
use quantities::{Language, Measure, format_significant};
use questions::list::check::reserve_unasked;
use questions::texts::{
    by_importance, counts_text, demand_figures, margin_share, objection_text, percent, reserve_lines, standing_text,
};
use questions::{Candidate, Check, Progress, Verdict, catalogue_fingerprint, project_fingerprint};
use std::collections::BTreeMap;
use words::{assumption_text, capitalised, page, terminal, title_of_check, unmet_text, verdict_count, without_keys};

/// Number of checks with a bar, as on the first page of the report.
const BARS: usize = 5;

/// Full scale of the bars \[% of the limit\].
const SCALE: f64 = 125.0;

/// Returns the page of the selected actuator; empty without one.
pub(crate) fn first_page(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let mut state = PageState::of(call);
    let held = state.hold(shell, progress);
    let found = held.projects.get(state.axis);
    let found = found.and_then(|project| Some((project, looked_at_alone(&state, project, progress)?)));
    html! { @if let Some((project, candidate)) = found { (page_of(&state, project, &candidate, progress)) } }
}

fn page_of(state: &PageState, project: &AxisProject, candidate: &Candidate<'_>, progress: &Progress) -> Markup {
    let l = state.language;
    let words = words::report::words(l);
    let word = |key: &str| words.get(key).map_or("", String::as_str);
    let open: Vec<String> = candidate
        .judgement
        .checks
        .iter()
        .filter(|check| check.verdict == Verdict::NotChecked && !check.is_without_limit())
        .map(|check| title_of_check(check, l))
        .collect();
    let reserve = reserve_unasked(project, candidate, progress).unwrap_or_default();
    html! {
        div.masthead { (logo()) strong { "antrieb" } span { strong { (word("report")) } br; (word("subject")) } }
        p.over { (word("axis")) }
        h1 { (project.name) }
        section class={ "result " (class(candidate)) } {
            p.standing { strong.code { (candidate.id) } br; (capitalised(&standing_text(candidate, l))) }
            @for objection in &candidate.objections { p.fail { (objection_text(candidate, objection, l)) } }
            @for open in &candidate.open_requirements { p { (capitalised(terminal::requirement_not_checked(l))) ": " (unmet_text(open, l)) } }
            p { (capitalised(&counts_text(candidate, l))) }
            @if !open.is_empty() { p { (capitalised(&verdict_count(Verdict::NotChecked, open.len(), l))) ": " (open.join("; ")) "." } }
        }
        (tiles(project, candidate, &words, l))
        h2 { (word("s_tightest")) }
        (bars(candidate, l))
        @for (head, parts) in reserve_lines(&reserve, candidate, l) { p.small { strong { (capitalised(head)) ": " } (parts.join("; ")) } }
        @let assumed: Vec<_> = project.assumed().into_iter().filter(|each| candidate.is_concerned_by(each.assumption)).collect();
        @if !assumed.is_empty() {
            h2 { (page::assumed_title(l)) }
            ul.assumed-list { @for each in &assumed { li { (capitalised(&without_keys(&assumption_text(each.assumption, l), l))) } } }
        }
        dl.facts {
            dt { (word("program")) } dd { "antrieb " (env!("CARGO_PKG_VERSION")) }
            @if !state.file.is_empty() { dt { (word("project")) } dd { (state.file) } }
            dt { (word("hash_project")) } dd { (project_fingerprint(&state.text, &project.recordings)) }
            dt { (word("hash_catalogue")) } dd { (catalogue_fingerprint(&**project.catalogue())) }
        }
        div.signatures { @for role in ["prepared", "checked", "released"] { div { strong { (word(role)) } p { (word("signature")) } } } }
        p.small { (word("disclaimer")) }
    }
}

/// Returns governing check, demand, cycle time and mass.
fn tiles(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    words: &BTreeMap<&'static str, String>,
    language: Language,
) -> Markup {
    let word = |key: &str| words.get(key).map_or("", String::as_str);
    let tile = |label: &str, value: &str, below: &Markup| html! { div { span { (label) } strong { (value) } small { (below) } } };
    html! {
        div.tiles {
            @if let Some(check) = candidate.governing() {
                (tile(word("governing_check"), &format!("{} %", percent(check.utilisation, language)), &html! { (title_of_check(check, language)) }))
            }
            @if let Some(demand) = &candidate.judgement.demand {
                @let names = ["torque_rms", "torque_peak", "speed_mean", "speed_peak", "duty"];
                @for (name, (symbol, value, unit)) in names.into_iter().zip(demand_figures(demand, language)) {
                    (tile(word(name), &format!("{value} {unit}"), &crate::chapters::with_symbols(symbol)))
                }
            }
            (tile(word("cycle"), &format!("{} s", format_significant(project.axis.motion.duration().si(), 4, language)), &html! {}))
        }
    }
}

/// Returns the checks with the highest utilisation, each with a bar to its limit.
fn bars(candidate: &Candidate<'_>, language: Language) -> Markup {
    let checks = by_importance(&candidate.judgement.checks);
    let with_share = checks.into_iter().filter_map(|check| Some((check, margin_share(check)?)));
    html! {
        table.bars { @for (check, share) in with_share.take(BARS) { tr {
            td { (title_of_check(check, language)) }
            td { (bar(check, share)) }
            td.number { (percent(Some(share), language)) " %" }
        } } }
    }
}

fn bar(check: &Check, share: f64) -> Markup {
    let end = (share * 100.0).clamp(0.0, SCALE);
    let sure = check.utilisation_band().map_or(end, |[low, _]| (low * 100.0).clamp(0.0, end));
    html! {
        svg viewBox={ "0 0 " (SCALE) " 5" } width="300" height="12" aria-hidden="true" {
            rect width=(SCALE) height="5" fill="#eef2f3" {}
            rect width=(sure) height="5" fill=(if check.verdict == Verdict::Fail { "#b3261e" } else { "#0f5c63" }) {}
            @if sure < end { rect x=(sure) width=(end - sure) height="4.4" y="0.3" fill="none" stroke="#8a5a00" stroke-width="0.6" stroke-dasharray="1.4 1" {} }
            path d="M100 -1V6" stroke="#1d2b2e" stroke-width="0.7" {}
        }
    }
}
