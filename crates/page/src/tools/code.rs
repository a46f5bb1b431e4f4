//! Explanations of an ordering code, and of the terms.

use crate::chapters::symbol;
use maud::{Markup, html};
use provenance::Grade;
use quantities::{Language, Unit};
use questions::list::code_complete::completion;
use questions::list::code_list::{list_codes, read_pattern};
use questions::list::code_parse::{explain_code, uncovered};
use questions::list::data::{SheetMarks, SheetNote, SheetSection, sheet};
use questions::list::errata::{ErrataRefusal, errata_about};
use questions::list::glossary::glossary;
use questions::texts::{sheet_value_text, uncovered_mark};
use questions::{CodeRefusal, answer, read_code};
use words::{
    ERRATUM_MARK, Word, capitalised, condition_text, describe_field, describe_uncovered, erratum_place_of,
    evidence_text, grade_word, page, row_sign, symbol_term, table_title, terminal, terms,
};

/// Number of proposed codes for the beginning of one.
const PROPOSED: usize = 12;

/// Explains a code field by field, or proposes its completions.
pub(super) fn explained(typed: &str, language: Language) -> Markup {
    let l = language;
    let code = match read_code(typed, l) {
        Ok(reading) => reading.parsed.code,
        Err(fault) => return incomplete(typed, &fault, l),
    };
    html! {
        p { strong { (code) } }
        table {
            thead { tr { @for head in [terminal::field(l), terminal::token(l), terminal::meaning(l)] { th scope="col" { (capitalised(head)) } } } }
            tbody { @for (field, token, meaning) in explain_code(&code, l) { tr { th scope="row" { (describe_field(field, l)) } td { (token) } td { (meaning) } } } }
        }
        @for what in uncovered(&code) { p.unchecked { (describe_uncovered(what, l)) } }
    }
}

/// Explains why a text is no valid code, with its completions and the nearest codes.
pub(super) fn incomplete(typed: &str, fault: &CodeRefusal, language: Language) -> Markup {
    let l = language;
    let pattern = read_pattern(typed, l).ok();
    let into = |code: String, is_available: bool| {
        html! { button.plain type="button" data-into="about" value=(code) { (code) } @if !is_available { " " (terms::on_request(l)) } }
    };
    html! {
        @if let Some(pattern) = &pattern {
            @for (_, name, choices) in completion(pattern, l) {
                p { (capitalised(name)) ": " @for choice in &choices { span.token { (if choice.token.is_empty() { "–" } else { choice.token }) @if !choice.available { " (" (terms::on_request(l)) ")" } } " " } }
            }
            ul.rejected { @for (code, found) in list_codes(Some(pattern)).iter().take(PROPOSED) { li { (into(code.to_string(), found.is_available())) } } }
        } @else {
            @for each in &fault.faults { p.fault { (crate::sentences::worded(&each.message, each.hint.as_deref(), l)) } }
        }
        @if !fault.nearest.is_empty() {
            p { (capitalised(terminal::nearest_valid_codes(l))) ": " }
            ul.rejected { @for (code, found) in &fault.nearest { li { (into(code.to_string(), found.is_available())) } } }
        }
    }
}

/// Returns the data sheet, table by table, with the notes and errata of each.
pub(super) fn data(typed: &str, language: Language) -> Markup {
    let l = language;
    let code = match read_code(typed, l) {
        Ok(reading) => reading.parsed.code,
        Err(fault) => return incomplete(typed, &fault, l),
    };
    let Some(found) = sheet(&code) else { return html! { p.unchecked { (terminal::no_data(l)) } } };
    let mut errata: Vec<&'static str> = Vec::new();
    let sections: Vec<Markup> = found.sections.iter().map(|each| section(each, &mut errata, l)).collect();
    html! {
        @for what in &found.uncovered { p.unchecked { "[" (uncovered_mark(*what)) "] " (describe_uncovered(*what, l)) } }
        @for each in &sections { (each) }
        @if !errata.is_empty() {
            h4 { (page::tool_errata(l)) }
            dl { @for id in &errata { dt id={ "erratum-" (id) } title=(id) { (capitalised(&erratum_place_of(id, l))) } dd { (evidence_text(id, l)) } } }
        }
    }
}

fn section(section: &SheetSection, errata: &mut Vec<&'static str>, language: Language) -> Markup {
    let l = language;
    let mut marks = SheetMarks::default();
    let mut mention = |ids: &[&'static str]| {
        for id in ids {
            if !errata.contains(id) {
                errata.push(id);
            }
        }
    };
    let rows: Vec<Markup> = section.rows.iter().map(|row| {
        let cell = row.cell;
        mention(cell.errata);
        let notes: Vec<String> = row.notes.iter().map(|note| marks.of(*note)).collect();
        html! { tr {
            th scope="row" { @if let Some(sign) = row_sign(cell.place.symbol) { (symbol(&sign)) " " } span.small { (symbol_term(cell.place.symbol, l)) @if !cell.place.condition.is_empty() { " (" (condition_text(cell.place.condition, l)) ")" } } }
            td.number {
                (sheet_value_text(row, l))
                @for mark in &notes { " [" (mark) "]" }
                @for id in cell.errata { " " a.advice href={ "#erratum-" (id) } title=(erratum_place_of(id, l)) { (ERRATUM_MARK) } }
            }
            td { (Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol)) }
        } }
    }).collect();
    mention(&section.errata);
    let by = |note: &SheetNote| {
        if note.is_ours() { format!("{}: ", terminal::not_of_the_manual(l)) } else { String::new() }
    };
    html! {
        h4 { (table_title(section.table, l)) }
        p.small { (capitalised(terminal::table(l))) " " (section.table.id) ", " (grade_word(Grade::Printed, l)) }
        div.wide tabindex="0" { table {
            thead { tr { @for head in [terminal::name as Word, terms::value, terms::unit] { th scope="col" { (capitalised(head(l))) } } } }
            tbody { @for row in &rows { (row) } }
        } }
        @for (mark, note) in marks.sorted() { p.small { "[" (mark) "] " (by(&note)) (answer::sheet_note_text(&note, l)) } }
        @for note in &section.notices { p.small { (by(note)) (answer::sheet_note_text(note, l)) } }
        @if !section.errata.is_empty() {
            p.small { (capitalised(terminal::errata_of_this_table(l))) ": " @for (place, id) in section.errata.iter().enumerate() { @if place > 0 { "; " } a.advice href={ "#erratum-" (id) } { (erratum_place_of(id, l)) } } }
        }
    }
}

/// Returns the errata of a code or a table, or all of them.
pub(super) fn errata(typed: &str, language: Language) -> Markup {
    let l = language;
    let found = match errata_about(Some(typed), l) {
        Ok(found) => found,
        Err(ErrataRefusal::Code(fault)) => return incomplete(typed, &fault, l),
        Err(ErrataRefusal::NoData) => return html! { p.unchecked { (terminal::no_data(l)) } },
        Err(ErrataRefusal::Unknown { message, hint }) => {
            return html! { p.fault { (crate::sentences::worded(&message, hint.as_deref(), l)) } };
        }
    };
    let record = answer::errata(&found, l);
    html! {
        @if record.errata.is_empty() { p { (capitalised(terminal::no_erratum(l))) } }
        dl { @for each in &record.errata {
            dt title=(each.id) { (capitalised(&each.place)) }
            dd { (each.printed) " → " (each.corrected) " " (Unit::of(each.unit).map_or(each.unit, |unit| unit.symbol)) br; span.small { (each.evidence) } }
        } }
    }
}

/// Returns terms and symbols with their meaning.
pub(super) fn words(typed: &str, language: Language) -> Markup {
    let wanted = (!typed.starts_with("CHA")).then_some(typed);
    match glossary(wanted, language) {
        Ok(found) => html! { dl {
            @for word in &found.words { dt { (word.en) " · " (word.de) } dd { (word.meaning) } }
            @for term in &found.terms { dt { (symbol(&term.symbol)) } dd { (term.en) " · " (term.de) @if !term.unit.is_empty() { " [" (Unit::of(&term.unit).map_or(&*term.unit, |unit| unit.symbol)) "]" } @if !term.remark.is_empty() { br; span.small { (term.remark) } } } }
            @for sign in &found.symbols {
                // A row that the tables name in words has no symbol.
                @if let Some(shown) = row_sign(&sign.symbol) { dt { (symbol(&shown)) } dd { (sign.en) " · " (sign.de) } } @else { dt { (sign.en) } dd { (sign.de) } }
            }
        } },
        Err(nearest) => {
            html! { p { (terminal::nothing_in_the_glossary(&typed, language)) @if !nearest.is_empty() { ": " (nearest.join(", ")) } } }
        }
    }
}
