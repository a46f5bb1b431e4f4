//! Lines of the project file within a sentence, in the words of the page: `gaps = "allow"` becomes “gaps: permitted”.
//!
//! The texts name what to write in the file, for readers of the terminal. On the page the same statement is a field.

use crate::markup::label_of;
use crate::value::said;
use project::key_at;
use quantities::Language;
use std::borrow::Cow;
use words::{key_word, page, table_of_project, views};

/// Spellings of a quotation mark in the texts of a page.
const QUOTES: [&str; 3] = ["&quot;", "\"", "&#39;"];

/// Tables whose keys appear in a sentence without their table.
const TABLES: [&str; 6] = ["motion[1]", "axis", "bearing", "requirements", "stage", "mechanism.arm"];

/// Word of the project file for a column that is not used.
const NO_COLUMN: &str = "none";

/// Keys behind the words that describe them.
const ASIDES: [&str; 2] = [" (from, to)", " (time, distance)"];

/// A value in a line of the project file.
enum Stated<'t> {
    /// A text in quotation marks, or a word or number without them.
    Value(&'t str),
    /// Keys with their values between braces.
    Table(Vec<(&'t str, &'t str)>),
}

/// Returns a text with the lines of the project file in it replaced by the names of their fields and the chosen words.
pub(crate) fn in_words(text: &str, language: Language) -> Cow<'_, str> {
    if let Some((before, behind)) = ASIDES.into_iter().find_map(|aside| text.split_once(aside)) {
        return Cow::Owned(format!("{before}{}", in_words(behind, language)));
    }
    if !text.contains(" = ") && !text.contains('[') {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(from) = rest.find(|sign: char| sign.is_ascii_lowercase() || sign == '[') {
        let (before, here) = rest.split_at(from);
        out.push_str(before);
        let is_begun = out.ends_with(|sign: char| sign.is_alphanumeric() || "_.-&;#\"".contains(sign));
        // A key with its table in parentheses stands behind its words, and is left out of the text as a whole.
        let is_aside = out.ends_with('(') && here.split_once(" = ").is_some_and(|(key, _)| key.contains('.'));
        let found = if is_begun && !out.ends_with("&quot;") || is_aside {
            None
        } else {
            line(here, language).or_else(|| table(here, language))
        };
        match found {
            Some((words, behind)) => {
                out.push_str(&words);
                rest = behind;
            }
            None => {
                let end = here.find(|sign: char| !is_of_name(sign)).unwrap_or(here.len()).max(1);
                out.push_str(here.get(..end).unwrap_or_default());
                rest = here.get(end..).unwrap_or_default();
            }
        }
    }
    out.push_str(rest);
    Cow::Owned(out)
}

const fn is_of_name(sign: char) -> bool {
    sign.is_ascii_lowercase() || sign.is_ascii_digit() || matches!(sign, '_' | '.')
}

/// Reads a line at the beginning of a text; returns its words, and the rest behind it.
fn line(text: &str, language: Language) -> Option<(String, &str)> {
    let (key, behind) = text.split_once(" = ")?;
    if key.is_empty() || !key.chars().all(is_of_name) {
        return None;
    }
    let (value, rest) = value(behind)?;
    let words = match value {
        Stated::Value(value) => pair(key, value, language)?,
        Stated::Table(pairs) => {
            let words: Option<Vec<String>> =
                pairs.into_iter().map(|(name, value)| pair(&format!("{key}.{name}"), value, language)).collect();
            words?.join(", ")
        }
    };
    Some((views::in_quotes(&words, language), rest))
}

/// Reads the name of a table in brackets.
fn table(text: &str, language: Language) -> Option<(String, &str)> {
    let (open, close) = if text.starts_with("[[") { ("[[", "]]") } else { ("[", "]") };
    let (name, rest) = text.strip_prefix(open)?.split_once(close)?;
    let title = table_of_project(name, language).filter(|_| !name.is_empty())?;
    Some((views::in_quotes(&title, language), rest))
}

/// Reads a value; returns it with the rest behind it.
fn value(text: &str) -> Option<(Stated<'_>, &str)> {
    if let Some(inside) = text.strip_prefix("{ ") {
        let (inside, rest) = inside.split_once(" }")?;
        let pairs: Option<Vec<_>> = inside
            .split(", ")
            .map(|pair| {
                let (name, value) = pair.split_once(" = ")?;
                Some((name, quoted(value).map_or(value, |(value, _)| value)))
            })
            .collect();
        return Some((Stated::Table(pairs?), rest));
    }
    if let Some((value, rest)) = quoted(text) {
        return Some((Stated::Value(value), rest));
    }
    let word = ["true", "false"].into_iter().find(|word| text.starts_with(word))?;
    let (word, rest) = text.split_at(word.len());
    (!rest.starts_with(char::is_alphanumeric)).then_some((Stated::Value(word), rest))
}

/// Reads a text in quotation marks.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let mark = QUOTES.into_iter().find(|mark| text.starts_with(mark))?;
    text.get(mark.len()..)?.split_once(mark)
}

/// Returns the name of the field of a key, and its value in words; `None` if there is no such key.
fn pair(key: &str, value: &str, language: Language) -> Option<String> {
    let path = std::iter::once(key.to_owned())
        .chain(TABLES.iter().map(|table| format!("{table}.{key}")))
        .find(|path| key_at(path).is_some())?;
    let last = key.rsplit('.').next().unwrap_or(key);
    let name = match short_name(key, language) {
        Some(name) => name.to_owned(),
        None => label_of(&path, language)?,
    };
    let value = match value {
        NO_COLUMN if key.starts_with("columns.") => page::no_column(language).into(),
        _ => key_word(last, value, language).unwrap_or_else(|| said(value, language).into()),
    };
    Some(format!("{name}: {value}"))
}

/// Returns the name of a key within a sentence, if its label is a whole sentence.
const fn short_name(key: &str, language: Language) -> Option<&'static str> {
    Some(match key.as_bytes() {
        b"gaps" => views::line_gaps(language),
        b"held_values" => views::line_held_values(language),
        b"time_stamps" => views::line_time_stamps(language),
        b"smoothing" => views::line_smoothing(language),
        b"standstill" => views::line_standstill(language),
        b"from" => views::line_from(language),
        b"to" => views::line_to(language),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_file_is_said_in_words() {
        for (text, words) in [
            ("oder mit gaps = &quot;allow&quot; zulassen", "oder mit „Lücken: zulässig“ zulassen"),
            ("standstill = \"0.25 1/min\" angeben", "„Grenze des Stillstands: 0,25 min⁻¹“ angeben"),
            ("Ende angeben: to = &quot;4.5 ms&quot;", "Ende angeben: „Ende des Fensters: 4,5 ms“"),
            ("unter [axis] single_move = true angeben", "unter „Achse“ „"),
            ("eine eigene [[axis]] je Achse", "eine eigene „Achse“ je Achse"),
            ("oder columns.speed = \"none\"", "oder „Name der Drehzahl- oder Geschwindigkeitsspalte: keine Spalte“"),
            (
                "angeben: columns = { time = &quot;#1&quot;, position = &quot;#2&quot; }",
                "angeben: „Name der Zeitspalte: #1, Name der Positionsspalte: #2“",
            ),
        ] {
            let found = in_words(text, Language::De);
            assert!(found.starts_with(words), "{text}: {found}");
        }
    }

    #[test]
    fn what_is_no_line_of_the_file_stays() {
        for text in [
            "T = 4 Nm, i = 100 und U_DCmax = 400 V",
            "q [deg] und time [s]",
            "α = &quot;x&quot;",
            "[4] und motion[2].time",
            "n_gaps = &quot;allow&quot;",
        ] {
            assert_eq!(in_words(text, Language::De), text);
        }
    }
}
