//! Characters that the embedded fonts can show.
//!
//! An archive file must show every character, and a name may contain any. A character without a glyph is written as its
//! code point instead of a blank box.

use serde_json::Value;
use typst::text::{Coverage, FontBook};

pub(crate) struct Glyphs {
    coverages: Vec<Coverage>,
}

impl Glyphs {
    pub(crate) fn of(book: &FontBook, count: usize) -> Self {
        Self { coverages: (0..count).filter_map(|index| Some(book.info(index)?.coverage.clone())).collect() }
    }

    /// Replaces characters that cannot be shown, in every text of the value.
    pub(crate) fn printable(&self, value: Value) -> Value {
        match value {
            Value::String(text) => Value::String(self.printable_text(&text)),
            Value::Array(items) => items.into_iter().map(|item| self.printable(item)).collect(),
            Value::Object(map) => map.into_iter().map(|(key, value)| (key, self.printable(value))).collect(),
            other => other,
        }
    }

    /// Returns the text with characters that cannot be shown replaced by their code points, and line breaks by spaces.
    pub(crate) fn printable_text(&self, text: &str) -> String {
        let mut printable = String::with_capacity(text.len());
        for sign in text.chars() {
            if sign == '\n' || sign == '\t' {
                printable.push(' ');
            } else if quantities::is_unseen(sign) {
                printable.push_str(&format!("<U+{:04X}>", u32::from(sign)));
            } else if sign == ' ' || sign == '\u{202f}' || self.has(sign) {
                printable.push(sign);
            } else {
                printable.push_str(&format!("<U+{:04X}>", u32::from(sign)));
            }
        }
        printable
    }

    fn has(&self, sign: char) -> bool {
        self.coverages.iter().any(|coverage| coverage.contains(u32::from(sign)))
    }
}
