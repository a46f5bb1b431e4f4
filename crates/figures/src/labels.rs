//! Numbers and words of figures.

use plot::Label;
use quantities::{Language, Unit, grouped, with_symbol};
use questions::Candidate;
use words::{percent_text, pictures};

/// Writes a value with four digits and its unit.
pub(crate) fn amount(si: f64, unit: &Unit, language: Language) -> String {
    with_symbol(&grouped(&unit.figure(si, 4, language)), unit.symbol_in(language))
}

/// Returns a text as a label, each symbol with an index in it (`f_w`) set as such.
pub(crate) fn with_symbols(text: &str) -> Label {
    let mut label = Label::default();
    for (place, word) in text.split(' ').enumerate() {
        let label_so_far = if place > 0 { label.text(" ") } else { label };
        let is_symbol = word.split_once('_').is_some_and(|(base, index)| {
            (1..=2).contains(&base.chars().count()) && index.chars().all(char::is_alphanumeric)
        });
        label = if is_symbol { label_so_far.and_symbol(word) } else { label_so_far.text(word) };
    }
    label
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
