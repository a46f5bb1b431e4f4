//! Sentences about the project file in the words of the page: faults with their hints, keys as the labels of their fields.

use crate::file_lines::in_words;
use crate::markup::label_of;
use maud::{Markup, html};
use quantities::Language;
use questions::ColumnRole;
use words::{incoming, role_key, role_text};

/// Word of the file for a column without use.
const NO_COLUMN: &str = "none";

/// Words for a column in a table of the file.
type ColumnWords = fn(&dyn std::fmt::Display, Language) -> String;

/// Tables of a recording in the project, each with the words of the page for one column.
const TABLES: [(&str, ColumnWords); 3] = [
    ("columns", |column, _| column.to_string()),
    ("units", incoming::unit_of),
    ("recorded_ratio", incoming::ratio_of_column),
];

/// Returns `true` if a sentence states a table of a recording in the project: where its columns can be chosen, they are.
pub(crate) fn states_a_table(text: &str) -> bool {
    TABLES.iter().any(|(key, _)| text.contains(&format!("{key} = {{ ")))
}

/// Returns a sentence with the tables of a recording, `columns = { torque = "none" }`, in the words of the page.
fn tables_in_words(text: &str, language: Language) -> String {
    let role = |key: &str| ColumnRole::ALL.into_iter().find(|role| role_key(*role) == key.trim());
    let said = |pair: &str, words: ColumnWords| {
        let (key, value) = pair.split_once(" = ")?;
        let value = value.trim_matches('"');
        let value = match value.strip_prefix('#') {
            Some(number) => incoming::column_number(&number, language),
            None if value == NO_COLUMN => incoming::not_used(language).to_owned(),
            None => value.to_owned(),
        };
        Some(format!("{} {value}", words(&role_text(role(key)?, language), language)))
    };
    let mut text = text.to_owned();
    for (key, words) in TABLES {
        let head = format!("{key} = {{ ");
        while let Some((before, rest)) = text.split_once(&head)
            && let Some((inside, after)) = rest.split_once(" }")
            && let Some(pairs) = inside.split(", ").map(|pair| said(pair, words)).collect::<Option<Vec<String>>>()
        {
            text = format!("{before}{}{after}", pairs.join(", "));
        }
    }
    text
}

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
    let hint = hint.map(|hint| tables_in_words(hint, language));
    html! { @if let Some(hint) = hint.as_deref() { " – " @match line(hint) { Some(example) => { (example) }, None => { (quoted(hint, language)) } } } }
}

/// Returns `true` for a line of the file, which a hint states as an example; its field is where the hint stands.
fn is_line(text: &str) -> bool {
    let key = text.split_once(" = ").map_or("", |(key, _)| key);
    !key.is_empty() && key.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase() || byte.is_ascii_digit())
}

/// Returns a fault with its hint.
pub(crate) fn worded(message: &str, advice: Option<&str>, language: Language) -> Markup {
    html! { (quoted(&tables_in_words(message, language), language)) (hint(advice, language)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_a_recording_are_said_in_words() {
        let said = [
            (
                "use the speed alone: columns = { position = \"none\" }",
                "use the speed alone: position not used",
                "use the speed alone: Position nicht verwendet",
            ),
            (
                "columns = { time = \"#1\", torque = \"M\" } and units = { time = \"s\" }",
                "time column 1, torque or force M and unit of time s",
                "Zeit Spalte 1, Drehmoment oder Kraft M and Einheit von Zeit s",
            ),
            ("columns = { other = 1 }", "columns = { other = 1 }", "columns = { other = 1 }"),
        ];
        for (file, en, de) in said {
            assert_eq!(tables_in_words(file, Language::En), en);
            assert_eq!(tables_in_words(file, Language::De), de);
        }
    }
}
