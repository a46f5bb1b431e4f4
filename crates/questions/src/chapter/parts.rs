//! Parts of which chapters are made: hazards, remarks, grids, and numbers in their cells.

use answers::{Chapter, CitedErratum, Column, Fact, Hazard, Id, Number};
use catalogue::SignalWord;
use quantities::{Language, Unit, format_significant};
use words::{ERRATUM_MARK, erratum_line, signal_word};

/// Creates a hazard or a rule with its signal word.
pub(super) fn hazard(signal: Option<Id<SignalWord>>, text: &str, source: String, language: Language) -> Hazard {
    Hazard {
        level: signal.map_or("", |signal| signal.id()),
        word: signal.map_or("", |signal| signal_word(*signal, language)),
        text: text.to_owned(),
        source,
    }
}

/// Converts facts to hazards and rules, in the same order.
pub(super) fn hazards(facts: &[Fact], language: Language) -> Vec<Hazard> {
    facts.iter().map(|fact| hazard(fact.signal, fact.text, fact.source.clone(), language)).collect()
}

/// Returns errata with their evidence, each behind the mark of the values that it concerns.
#[must_use]
pub fn marked_errata(errata: &[CitedErratum], language: Language) -> Vec<String> {
    errata.iter().map(|each| format!("{ERRATUM_MARK} {}", erratum_line(&each.id, language))).collect()
}

/// Returns notes, and errata with their evidence.
pub(super) fn remarks(notes: &[String], errata: &[CitedErratum], language: Language) -> Vec<String> {
    let erratum = |erratum: &CitedErratum| erratum_line(&erratum.id, language);
    notes.iter().cloned().chain(errata.iter().map(erratum)).collect()
}

/// A column, and the function that formats its cells.
pub(super) type Shown<'f, T> = (Column, &'f dyn Fn(&T) -> String);

/// Adds a grid with a row for each item, if there are any items.
pub(super) fn grid<'t, T: 't>(chapter: &mut Chapter, items: impl IntoIterator<Item = &'t T>, columns: &[Shown<'_, T>]) {
    let row = |item: &T| columns.iter().map(|(_, cell)| cell(item)).collect();
    let rows = items.into_iter().map(row).collect();
    chapter.grid(columns.iter().map(|(column, _)| column.clone()).collect(), rows);
}

/// Text of an empty value.
pub(super) const NOTHING: &str = "–";

/// Formats a number with this many significant digits.
pub(super) fn significant(value: Option<Number>, digits: usize, language: Language) -> String {
    value.map_or_else(|| NOTHING.to_owned(), |value| format_significant(value.0, digits, language))
}

/// Formats a number as in the manual, without padding zeros.
pub(super) fn plain(value: Option<Number>, language: Language) -> String {
    let text = value.and_then(|value| value.written()).map_or_else(|| NOTHING.to_owned(), |value| value.to_string());
    text.replace('.', &language.decimal_mark().to_string())
}

/// Returns the symbol of a unit of the records; empty for a pure number.
pub(super) fn unit_shown(unit: &str, language: Language) -> String {
    match Unit::of(unit) {
        _ if unit == "1" => String::new(),
        Some(unit) => unit.symbol_in(language).to_owned(),
        // The increment of an object: `0.1 %`.
        None if unit.starts_with(|c: char| c.is_ascii_digit()) => {
            unit.replace('.', &language.decimal_mark().to_string())
        }
        None => unit.to_owned(),
    }
}
