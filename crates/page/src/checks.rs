//! Checks of one actuator by the part that they are about, with bars, limits, grades and sources.

use crate::markup::{id, label, vals};
use crate::{overlay, value};
use maud::{Markup, html};
use project::{Key, key_at};
use quantities::{Language, Measure};
use questions::texts::{
    by_importance, compared_texts, instant_text, margin_share, margin_text, unit_text, verdict_text,
};
use questions::{Candidate, Check, Part, Verdict};
use words::{
    about_text, capitalised, check_missing, grade_word, hyphenated, note_text, page, part_title, short_label,
    source_text, terminal, terms, title_of_check,
};

pub(crate) fn verdict_class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "pass",
        Verdict::Fail => "fail",
        Verdict::Advice => "advice",
        Verdict::NotChecked => "unchecked",
    }
}

/// Returns the style class of a check; a check with a value and no limit is shown and not judged.
fn class(check: &Check) -> &'static str {
    if check.is_without_limit() { "no-limit" } else { verdict_class(check.verdict) }
}

/// Returns the checks as HTML: by part in the order of a report, then by importance; those without a limit in a fold.
pub(crate) fn of(candidate: &Candidate<'_>, prefix: &str, language: Language) -> Markup {
    let l = language;
    let worst = overlay::worst(candidate);
    let all = by_importance(&candidate.judgement.checks);
    let of_part =
        |part: Part| all.iter().filter(move |check| check.id.part() == part && !check.is_without_limit()).copied();
    let without: Vec<&Check> = all.iter().filter(|check| check.is_without_limit()).copied().collect();
    html! {
        div id="checks" {
            h3.unseen id="checks-title" { (page::checks_of(&candidate.id, l)) }
            table.checks aria-labelledby="checks-title" {
                thead { tr {
                    th scope="col" { (capitalised(terms::check(l))) }
                    th.number scope="col" { (capitalised(terms::value(l))) }
                    th.number scope="col" { (capitalised(terms::limit(l))) }
                    th.of-unit scope="col" { (capitalised(terms::unit(l))) }
                    th.number scope="col" { (crate::tip::of_word(terms::utilisation_short(l), l)) }
                } }
                @for part in &Part::ALL {
                    @if of_part(*part).next().is_some() {
                        tbody {
                            tr.part { th colspan="5" scope="rowgroup" { (part_title(*part, l)) } }
                            @for check in of_part(*part) { (row(check, &worst, prefix, l)) }
                        }
                    }
                }
                @if !without.is_empty() {
                    tbody {
                        tr.part { th colspan="5" scope="rowgroup" { (page::without_limit_head(l)) } }
                        @for check in without { (row(check, &worst, prefix, l)) }
                    }
                }
            }
        }
    }
}

/// Returns the utilisation of a check as a bar with a line at one; where the limit is an estimate, the part between the
/// utilisations by the edges of its band is hatched. A hundredth of a percent is at most a tenth of a pixel; further
/// digits of a sum differ between machines.
pub(crate) fn bar(share: f64, band: Option<[f64; 2]>) -> Markup {
    let place = |share: f64| (share * 100.0).clamp(0.0, 150.0);
    let (to, from) = (place(share), band.map(|[low, _]| place(low)));
    let solid = format!("{:.2}", from.unwrap_or(to));
    html! {
        svg.bar viewBox="0 0 150 8" preserveAspectRatio="none" aria-hidden="true" {
            rect x="0" y="0" width=(solid) height="8" {}
            @if let Some(from) = from { rect.estimate x=(solid) y="0" width=(format!("{:.2}", to - from)) height="8" {} }
            path d="M100 0V8" {}
        }
    }
}

fn row(check: &Check, worst: &[overlay::Worst<'_>], prefix: &str, language: Language) -> Markup {
    let l = language;
    let share = margin_share(check);
    let class = class(check);
    let [value, limit] = compared_texts(check, l);
    html! {
        tr id={ "check-" (check.id.id()) } class=(class) {
            th scope="row" {
                span.verdict title=(verdict_text(check, l)) { span.unseen { (verdict_text(check, l)) ": " } }
                button.plain type="button" title=(page::how_it_came_about(l)) hx-post="/explain" hx-target="#detail" hx-swap="innerHTML"
                    hx-vals=(vals(&[("check", check.id.id())])) { (hyphenated(&capitalised(&title_of_check(check, l)))) }
            }
            td.number { (value) }
            // In a narrow pane the unit stands behind the limit.
            td.number { (limit) span.unit { " " (unit_text(check.value.or(check.limit), l)) } }
            td.of-unit { (unit_text(check.value.or(check.limit), l)) }
            td.number {
                (margin_text(check, l))
                @if let Some(at) = check.at {
                    " " button type="button" class={ "mark-number " (class) } data-instant=(at.si()) title={ (page::jump_to_worst(l)) ": " (page::worst_instant(&instant_text(at, l), l)) } aria-label={ (page::jump_to_worst(l)) ": " (page::worst_instant(&instant_text(at, l), l)) } {
                        (overlay::number(worst, check).map_or_else(String::new, |number| number.to_string()))
                    }
                }
                @if let Some(share) = share { @if check.is_of_another_gear() { span.another title=(page::another_gear(l)) { (bar(share, None)) } } @else { (bar(share, check.utilisation_band())) } }
            }
        }
        tr class={ "about " (class) } { td colspan="5" { (about(check, prefix, l)) } }
    }
}

/// Returns the missing value with a field to state it, the remarks, and the source of the limit.
fn about(check: &Check, prefix: &str, language: Language) -> Markup {
    let l = language;
    let key =
        check.missing.filter(|_| check.verdict == Verdict::NotChecked).and_then(|path| Some((path, key_at(path)?)));
    html! {
        @if let Some(missing) = check.missing.filter(|_| key.is_none() || !check.is_without_limit()) { span { (page::to_be_checked_state(l)) " " (check_missing(missing, l)) } }
        @if let Some((path, key)) = key { (field(path, key, prefix, check, l)) }
        // A passed check has its remarks in its explanation.
        @if check.verdict != Verdict::Pass { @for note in check.notes.iter() { span { (capitalised(&note_text(note, l))) "." } " " } }
        @if let (Some(source), Some(grade)) = (&check.limit_source, check.grade) { span.source { (grade_word(grade, l)) ", " (source_text(source, l)) } }
    }
}

/// Returns a field for a key that the project does not state.
fn field(path: &str, key: &Key, prefix: &str, check: &Check, language: Language) -> Markup {
    let l = language;
    let path = format!("{prefix}{path}");
    let own = format!("s-{}-{}", check.id.id(), id(&path));
    let sample = page::for_example(&value::sample(key).unwrap_or_default(), l);
    html! {
        label.state for=(own) {
            span { (label(&capitalised(&short_label(about_text(key.about, l))))) }
            input id=(own) name="value" type="text" size=(sample.chars().count()) placeholder=(sample) autocomplete="off" spellcheck="false"
                hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", &path)]));
        }
    }
}

/// Returns the headings of a table of checks next to a calculator.
pub(crate) fn check_heads(language: Language) -> [&'static str; 6] {
    let l = language;
    [terms::check(l), terms::verdict(l), terms::value(l), terms::limit(l), terms::unit(l), terms::utilisation_short(l)]
}

/// Returns the names of the two sides of a check, the same as on the terminal.
pub(crate) fn sides(language: Language) -> [&'static str; 2] {
    [terminal::asked(language), terminal::permitted(language)]
}
