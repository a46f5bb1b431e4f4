//! Sentences about the project file in the words of the page: faults with their hints, keys as the labels of their fields.

use crate::file_lines::in_words;
use crate::markup::label_of;
use maud::{Markup, html};
use quantities::Language;

/// Returns a sentence about the file: text between grave accents is a quotation of it; a key is shown by its label.
pub(crate) fn quoted(text: &str, language: Language) -> Markup {
    html! { @for (place, piece) in text.split('`').enumerate() {
        @if place % 2 == 0 { (piece) }
        @else if let Some(label) = label_of(piece, language) { em data-key=(piece) { (label) } }
        // A key of a segment without its table.
        @else if let Some(label) = label_of(&format!("motion[1].{piece}"), language) { em data-key=(piece) { (label) } }
        @else if let Some(words) = Some(in_words(piece, language)).filter(|words| words != piece) { (words) }
        @else { code { (piece) } }
    } }
}

pub(crate) fn hint(hint: Option<&str>, language: Language) -> Markup {
    let line = |hint: &str| {
        let (head, example) = hint.split_once(": ").filter(|(_, example)| is_line(example))?;
        let value = example.split_once(" = ").map_or(example, |(_, value)| value).to_owned();
        let (head, alone) = (head.to_owned(), value.strip_prefix('"').and_then(|value| value.strip_suffix('"')));
        Some(
            html! { (head) ": " @match alone { Some(alone) if !alone.contains('"') => { (alone) }, _ => code { (value) } } },
        )
    };
    html! { @if let Some(hint) = hint { " – " @match line(hint) { Some(example) => { (example) }, None => { (quoted(hint, language)) } } } }
}

/// Returns `true` for a line of the file, which a hint states as an example; its field is where the hint stands.
fn is_line(text: &str) -> bool {
    let key = text.split_once(" = ").map_or("", |(key, _)| key);
    !key.is_empty() && key.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase() || byte.is_ascii_digit())
}

/// Returns a fault with its hint.
pub(crate) fn worded(message: &str, advice: Option<&str>, language: Language) -> Markup {
    html! { (quoted(message, language)) (hint(advice, language)) }
}
