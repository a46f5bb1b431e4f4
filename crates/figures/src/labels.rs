//! Numbers and words of figures.

use quantities::{Language, Unit};
use questions::Candidate;
use words::{percent_text, pictures};

/// Writes a value with four digits and its unit.
pub(crate) fn amount(si: f64, unit: &Unit, language: Language) -> String {
    let number = unit.figure(si, 4, language);
    match unit.symbol_in(language) {
        "1" => number,
        symbol @ ("°" | "′") => format!("{number}{symbol}"),
        symbol => format!("{number} {symbol}"),
    }
}

/// Writes a share in percent.
pub(crate) fn percent(share: f64, language: Language) -> String {
    format!("{} %", percent_text(share, language))
}

/// Returns the subject of a figure: the candidate, and the axis if it has a name.
pub(crate) fn subject(candidate: &Candidate<'_>, axis: &str) -> String {
    if axis.is_empty() { candidate.id.to_string() } else { format!("{axis}, {}", candidate.id) }
}

/// Joins parts of a sentence, the last one by a word.
pub(crate) fn listed(parts: &[String], language: Language) -> String {
    match parts {
        [] => String::new(),
        [only] => only.clone(),
        [head @ .., last] => format!("{} {} {last}", head.join(", "), pictures::and(language)),
    }
}
