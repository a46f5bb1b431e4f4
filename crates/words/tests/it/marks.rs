//! Decimal marks and units of the figures in a text.

use quantities::Language;
use std::cell::{Cell, RefCell};

thread_local! {
    /// Factor of all values in the texts, so that they have decimals, thousands and powers of ten.
    pub(crate) static FACTOR: Cell<f64> = const { Cell::new(1.0) };
    /// Texts whose figures have the mark of the other language.
    pub(crate) static WRONG: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Returns a plain number of a text times the factor.
pub(crate) fn x(value: f64) -> f64 {
    value * FACTOR.get()
}

/// Parts of a text whose points and commas are no decimal marks: code, quoted text, lines of a file, references to tables,
/// sections and equations, dates.
fn without_quotations(text: &str) -> String {
    // An erratum is named by its table: T17.1-number.
    let is_erratum =
        |word: &&str| word.strip_prefix('T').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    let text = text.split(' ').filter(|word| !is_erratum(word)).collect::<Vec<_>>().join(" ");
    let mut left = text.replace("MATLAB 7.3", "…").replace("15.2 und 18.1", "…").replace("15.2 and 18.1", "…");
    for (open, close) in [("`", "`"), ("\"", "\""), ("„", "“"), ("‚", "‘")] {
        while let Some(from) = left.find(open) {
            let Some(length) = left.get(from + open.len()..).and_then(|rest| rest.find(close)) else { break };
            left.replace_range(from..from + open.len() + length + close.len(), "…");
        }
    }
    for before in [
        "table ",
        "tables ",
        "section ",
        "eq. ",
        "Tabelle ",
        "Tabellen ",
        "Abschnitt ",
        "Abschn. ",
        "Gl. ",
        "Kapitel ",
        "Matrix ",
        "matrix ",
        "chapter ",
    ] {
        while let Some(from) = left.find(before) {
            let end = from + before.len();
            let rest = left.get(end..).unwrap_or_default();
            let length = rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(rest.len());
            left.replace_range(from..end + length, "…");
        }
    }
    left
}

/// Returns `true` if a text in German has straight quotes elsewhere than around a value of a file, behind its key or as an
/// example.
pub(crate) fn has_foreign_quotes(text: &str) -> bool {
    let is_value = |before: &str| {
        let ends = ["=", "= ", "[", "Beispiel ", "etwa ", "wie "];
        ends.iter().any(|end| before.ends_with(end)) || before.contains("= \"") || before.contains("[\"")
    };
    // A hint that states the value alone: "1 s" schreiben.
    let text = text.strip_prefix('"').and_then(|text| text.split_once("\" schreiben")).map_or(text, |(_, rest)| rest);
    let code: Vec<&str> = text.split('`').step_by(2).collect();
    let opens = |part: &str| -> bool {
        let places: Vec<usize> = part.match_indices('"').map(|(place, _)| place).collect();
        places.iter().step_by(2).any(|place| !is_value(part.get(..*place).unwrap_or_default()))
    };
    code.iter().any(|part| opens(part))
}

/// Figures of a text have the decimal mark of the language, and no other.
pub(crate) fn has_own_marks(what: &str, text: &str, language: Language) {
    let other = if language == Language::De { '.' } else { ',' };
    let plain: Vec<char> = without_quotations(text).chars().collect();
    let is_foreign =
        |three: &[char]| matches!(three, [a, mark, b] if a.is_ascii_digit() && *mark == other && b.is_ascii_digit());
    let wrong = plain.windows(3).any(is_foreign);
    let units = ["1/min", "kg m^2", "kg m²", " N m", "rpm"];
    let plain: String = plain.into_iter().collect();
    let has_unit_of_files = language == Language::De && units.iter().any(|unit| plain.contains(unit));
    if wrong || has_unit_of_files || language == Language::De && has_foreign_quotes(text) {
        WRONG.with_borrow_mut(|all| all.push(format!("{what}: {text}")));
    }
}
