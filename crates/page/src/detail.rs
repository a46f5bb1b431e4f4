//! Derivation of a number, and comparison of actuators: the panels that open next to the columns.

use crate::checks::{sides, verdict_class};
use crate::formula;
use crate::markup::drawer;
use crate::shown::class;
use answers::Node;
use maud::{Markup, html};
use quantities::{Language, format_significant};
use questions::list::compare::{CheckRow, Comparison, DatumRow, errata_of};
use questions::list::explain::derivation;
use questions::texts::{ValuesInRow, margin_share, margin_text, node_amount, trust, verdict_text};
use questions::{Candidate, Check, Verdict, answer};
use words::{
    ERRATUM_MARK, capitalised, chapter_name, check_meaning, check_missing, check_title, erratum_place_of,
    evidence_text, figure_term, marked, note_text, page, terminal, terms, title_of_check,
};

/// Returns the derivation of a check: both sides, as trees.
pub(crate) fn explained(candidate: &Candidate<'_>, check: &Check, language: Language) -> Markup {
    let found = derivation(check, language);
    let title = format!("{}: {}", candidate.id, title_of_check(check, language));
    let inside = html! {
        p.small { (check_meaning(check.id, language)) }
        p class=(verdict_class(check.verdict)) { (capitalised(&verdict_text(check, language))) @if margin_share(check).is_some() { ", " (margin_text(check, language)) " %" } }
        @if let Some(missing) = check.missing { p.unchecked { (page::to_be_checked_state(language)) " " (check_missing(missing, language)) } }
        @for note in check.notes.iter() { p { (note_text(note, language)) } }
        @for (word, root) in sides(language).into_iter().zip([&found.value, &found.limit]) {
            @if let Some(root) = root { h3 { (capitalised(word)) } ul.tree { (node(root, language)) } }
        }
    };
    drawer(&title, &inside, language)
}

/// Number of characters above which a formula can be wider than its place and gets a scroll area, usable by keyboard.
const LONG: usize = 48;

fn formula_line(text: &str, typeset: &Markup) -> Markup {
    let is_long = text.chars().count() > LONG;
    html! { div.formula tabindex=[is_long.then_some("0")] role=[is_long.then_some("group")] aria-label=[is_long.then_some(text)] { "= " (typeset) } }
}

fn node(node: &Node, language: Language) -> Markup {
    html! {
        li {
            span.node { (formula::symbol_alone(&node.symbol)) " = " strong { (node_amount(node, language)) } @if !node.term.is_empty() { " " (node.term) } }
            span.trust {
                @if node.repeated { (terminal::see_above(language)) } @else {
                    (trust(node, language))
                    @if let Some(number) = node.page { ", " (page::page_of_the_manual(&number, language)) }
                    @if let Some(name) = node.model { ", " a href={ (page::theory_folder(language)) (name) ".html" } data-chapter="" title=(capitalised(chapter_name(name, language))) { (page::theory(language)) } }
                }
            }
            @if !node.repeated {
                @if let Some((text, typeset)) = node.formula.as_deref().zip(formula::symbols(node, language)) { (formula_line(text, &typeset)) }
                @if let Some((text, typeset)) = node.figures.as_deref().zip(formula::values(node, language)) { (formula_line(text, &typeset)) }
                @for erratum in &node.errata { div.advice title=(erratum.id) { (capitalised(&erratum_place_of(&erratum.id, language))) ": " (erratum.evidence) } }
            }
            @if !node.operands.is_empty() { ul { @for operand in &node.operands { (self::node(operand, language)) } } }
        }
    }
}

/// Returns a comparison of several actuators.
pub(crate) fn compared(found: &Comparison<'_>, language: Language) -> Markup {
    let l = language;
    let inside = html! {
        div.wide tabindex="0" role="region" aria-labelledby="detail-title" {
            table.compare {
                thead { tr {
                    th scope="col" { (crate::tip::of_word(terms::check(l), l)) }
                    th scope="col" { (capitalised(terms::unit(l))) }
                    @for (place, each) in found.candidates.iter().enumerate() {
                        th scope="col" { (each.id) @if found.better == Some(place) { br; (terminal::first_in_the_ranking(l)) } }
                    }
                } }
                tbody {
                    tr { th scope="row" { (capitalised(terms::verdict(l))) } td {} @for each in &found.candidates {
                        td class=(class(each)) {
                            (questions::texts::verdict_of(each, l))
                            @for objection in answer::objections(each, l) { br; (objection) }
                        }
                    } }
                    @for row in &found.checks { (check_row(row, l)) }
                    @for row in found.demand.iter().chain(&found.data) { (datum_row(row, l)) }
                }
            }
            @for id in errata_of(&found.data) { p.small { (ERRATUM_MARK) " " span title=(id) { (capitalised(&erratum_place_of(id, l))) } ": " (evidence_text(id, l)) } }
        }
    };
    drawer(page::side_by_side(l), &inside, l)
}

fn check_row(row: &CheckRow, language: Language) -> Markup {
    let values = ValuesInRow::of(row.checks.iter().map(Option::as_ref));
    html! {
        tr {
            th scope="row" { (capitalised(&check_title(row.id, language))) }
            td { (values.unit(language)) }
            @for (place, check) in row.checks.iter().enumerate() {
                @match check {
                    Some(check) => td class={ "number " (verdict_class(check.verdict)) } {
                        (values.value(check, language)) " "
                        @if check.verdict == Verdict::NotChecked { (verdict_text(check, language)) } @else if margin_share(check).is_some() { "(" (margin_text(check, language)) " %)" }
                        @if row.better == Some(place) { " *" }
                    },
                    None => td { "–" },
                }
            }
        }
    }
}

fn datum_row(row: &DatumRow, language: Language) -> Markup {
    html! {
        tr class=[row.is_same().then_some("same")] {
            th scope="row" { (crate::tip::of_symbol(row.symbol, language)) " " span.small { (figure_term(row.symbol, language)) } }
            td { (row.unit.symbol_in(language)) }
            @for (place, value) in row.values.iter().enumerate() {
                td.number {
                    (marked(value.map_or_else(|| "–".to_owned(), |value| format_significant(value, 4, language)), row.errata_of(place)))
                }
            }
        }
    }
}
