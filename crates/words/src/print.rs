//! Texts of the data that the data state in both languages.

use crate::pick;
use catalogue::{Cell, Erratum, Footnote, ManualTable, ProductWord, SourceDocument, Term};
use quantities::Language;
use std::borrow::Cow;

/// Returns the title of a printed table.
#[must_use]
pub const fn table_title(table: &ManualTable, language: Language) -> &'static str {
    pick(language, table.title_en, table.title_de)
}

/// Returns the text of a note of a printed table.
#[must_use]
pub const fn table_note(note: &Footnote, language: Language) -> &'static str {
    pick(language, note.en, note.de)
}

/// Returns the text of a cell after errata.
#[must_use]
pub fn cell_text(cell: &Cell, language: Language) -> &'static str {
    pick(language, cell.corrected_en(), cell.corrected)
}

/// Returns a text of the manual with the signs of typesetting: `200 x 200` with the sign of multiplication, `0 ... 40` with an
/// ellipsis, `-20` with a minus sign.
#[must_use]
pub fn typeset(text: &str) -> Cow<'_, str> {
    let is_digit = |sign: Option<char>| sign.is_some_and(|sign| sign.is_ascii_digit());
    if !(text.contains(" x ") || text.contains("...") || text.contains('-')) {
        return Cow::Borrowed(text);
    }
    let mut set = String::with_capacity(text.len() + 8);
    let mut rest = text;
    while let Some(at) = rest.find([' ', '.', '-']) {
        let (before, behind) = rest.split_at(at);
        set.push_str(before);
        let last = set.chars().next_back();
        let (sign, taken) = if behind.starts_with(" x ") && is_digit(last) {
            (" × ", 3)
        } else if behind.starts_with("...") {
            ("…", 3)
        } else if behind.starts_with('-')
            && last.is_none_or(|last| matches!(last, ' ' | '('))
            && is_digit(behind.chars().nth(1))
        {
            ("−", 1)
        } else {
            (behind.get(..1).unwrap_or_default(), 1)
        };
        set.push_str(sign);
        rest = behind.get(taken..).unwrap_or_default();
    }
    set.push_str(rest);
    Cow::Owned(set)
}

/// Returns the recovered text of an erratum, if any, then the printed and the correct text.
#[must_use]
pub const fn erratum_readings(erratum: &Erratum, language: Language) -> (Option<&'static str>, [&'static str; 2]) {
    pick(
        language,
        (erratum.recovered, [erratum.printed, erratum.corrected]),
        (erratum.recovered_de, [erratum.printed_de, erratum.corrected_de]),
    )
}

/// Returns the short name by which texts cite a document; the identifier if the catalogue lacks the document.
#[must_use]
pub fn document_short(id: &'static str, language: Language) -> &'static str {
    catalogue::document(id).map_or(id, |found| short(found, language))
}

/// Returns the short name of a document.
#[must_use]
pub const fn short(document: &SourceDocument, language: Language) -> &'static str {
    in_german(document.short, document.short_de, language)
}

/// Returns the title of a document: in the language of the document, or in both if it is a document of antrieb.
#[must_use]
pub const fn document_title(document: &SourceDocument, language: Language) -> &'static str {
    in_german(document.title, document.title_de, language)
}

const fn in_german(text: &'static str, german: &'static str, language: Language) -> &'static str {
    pick(language, text, if german.is_empty() { text } else { german })
}

/// Returns the remark on a document, which exists in English only; empty in German.
#[must_use]
pub const fn document_note(document: &SourceDocument, language: Language) -> &'static str {
    pick(language, document.note, "")
}

/// Returns the meaning of a word of the glossary.
#[must_use]
pub const fn word_meaning(word: &ProductWord, language: Language) -> &'static str {
    pick(language, word.about_en, word.about_de)
}

/// Returns the remark on a term of the glossary.
#[must_use]
pub const fn term_remark(term: &Term, language: Language) -> &'static str {
    pick(language, term.note_en, term.note_de)
}

/// Returns a text in both languages, that of the requested language first.
#[must_use]
pub const fn own_and_foreign<'t>(en: &'t str, de: &'t str, language: Language) -> [&'t str; 2] {
    pick(language, [en, de], [de, en])
}

/// Returns a printed number with the decimal mark of the language; other texts stay unchanged.
#[must_use]
pub fn decimal(text: &str, language: Language) -> String {
    let numeric = text.chars().all(|c| c.is_ascii_digit() || " ,.<>≤≥±%-".contains(c));
    let mark = language.decimal_mark();
    if numeric { text.chars().map(|sign| if sign == ',' { mark } else { sign }).collect() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_the_manual_have_the_signs_of_typesetting() {
        for (text, expected) in [
            ("200 x 200 x 6", "200 × 200 × 6"),
            ("1 x KTY 84-130 / M17 x 1", "1 × KTY 84-130 / M17 × 1"),
            ("-20 ... 60 (-5)", "−20 … 60 (−5)"),
            ("CHA-14A-100, part 2-6, - and an x here", "CHA-14A-100, part 2-6, - and an x here"),
        ] {
            assert_eq!(typeset(text), expected);
        }
    }
}
