//! Words about errata.

use super::condition_text;
use crate::texts::said;
use crate::{capitalised, document_short, evidence_text, pick, row_name};
use catalogue::{Erratum, ErratumKind};
use quantities::Language;

/// Marks a value whose cell has an erratum: it may not be the printed one.
pub const ERRATUM_MARK: char = '†';

/// Returns a value, followed by the mark if the value has errata.
#[must_use]
pub fn marked(value: String, errata: &[&str]) -> String {
    if errata.is_empty() { value } else { format!("{value} {ERRATUM_MARK}") }
}

/// Returns the kind of an erratum in one or two words.
#[must_use]
pub fn erratum_kind(kind: ErratumKind, language: Language) -> &'static str {
    let (en, de) = match kind {
        ErratumKind::Recovery => ("recovered text", "wiederhergestellter Text"),
        ErratumKind::PrintError => ("printing error", "Druckfehler"),
        ErratumKind::Contradiction => ("contradiction", "Widerspruch"),
        ErratumKind::Rounding => ("rounding", "Rundung"),
        ErratumKind::Edition => ("different edition", "andere Ausgabe"),
    };
    if language == Language::De { de } else { en }
}

/// Returns the status of an erratum in one word.
#[must_use]
pub fn erratum_status(corrected: bool, language: Language) -> &'static str {
    match (corrected, language) {
        (true, Language::En) => "corrected",
        (true, Language::De) => "berichtigt",
        (false, Language::En) => "flagged",
        (false, Language::De) => "offen",
    }
}

/// Returns the place of an erratum: the table, and the cell or a description of the place.
#[must_use]
pub fn erratum_place(erratum: &'static Erratum, language: Language) -> String {
    let mut parts = Vec::new();
    if !erratum.table.is_empty() {
        parts.push(match erratum.table.strip_prefix("glossary-") {
            Some(symbol) => said!(language => "glossary, {symbol}" | "Glossar, {symbol}"),
            // A table of another document has the name of its file.
            None if erratum.table.starts_with(char::is_alphabetic) => published_in(erratum.table, language),
            None => said!(language => "table {}" | "Tabelle {}", erratum.table),
        });
    }
    match erratum.cell() {
        Some(cell) => {
            parts.push(row_name(cell.place.symbol, language));
            parts.push(cell.place.drive.to_owned());
            // Some drives are named with their feedback.
            if !cell.place.drive.ends_with(&format!("-{}", cell.feedback)) {
                parts.push(cell.feedback.to_owned());
            }
            if !cell.place.ratio.is_empty() {
                parts.push(format!("i = {}", cell.place.ratio));
            }
            parts.push(condition_text(cell.place.condition, language));
        }
        None => parts.push(pick(language, erratum.place, erratum.place_de).to_owned()),
    }
    parts.retain(|part| !part.is_empty());
    parts.join(", ")
}

/// Returns the short name of the document with a table that is not in the manual.
fn published_in(table: &'static str, language: Language) -> String {
    catalogue::table(table).map_or_else(|| table.to_owned(), |found| document_short(found.source, language).to_owned())
}

/// Returns the place of an erratum in words, and its evidence.
#[must_use]
pub fn erratum_line(id: &str, language: Language) -> String {
    format!("{}: {}", capitalised(&erratum_place_of(id, language)), evidence_text(id, language))
}

/// Returns the place of an erratum in words: the table, and the cell or a description; empty for an unknown id.
#[must_use]
pub fn erratum_place_of(id: &str, language: Language) -> String {
    catalogue::erratum(id).map_or_else(String::new, |erratum| erratum_place(erratum, language))
}
