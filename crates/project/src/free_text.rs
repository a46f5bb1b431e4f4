//! Free texts, and lists of them.

use crate::key::example;
use crate::read::{FoundValue, Reader};
use crate::{Expected, Fault, Hint};
use quantities::is_unseen;
use std::ops::Range as Span;
use toml::de::DeValue;

/// Longest free text.
const TEXT_MAX: usize = 200;

impl Reader<'_> {
    /// Returns free text of bounded length.
    pub(crate) fn free_text(&mut self, found: &FoundValue<'_, '_>) -> Option<String> {
        let DeValue::String(text) = found.value else { return self.wrong_type(found) };
        self.plain(text, found.span.clone(), found.path)
    }

    /// Returns a list of free texts, each with its place.
    pub(crate) fn texts(&mut self, found: &FoundValue<'_, '_>) -> Option<Vec<(String, Span<usize>)>> {
        let items = self.items(found)?;
        if items.is_empty() {
            let fault = Fault::EmptyList { path: found.path.to_owned() };
            self.fault(found.span.clone(), fault, example(found.key).map(Hint::Example));
            return None;
        }
        let mut texts = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) => {
                    texts.extend(self.plain(text, item.span(), found.path).map(|text| (text, item.span())));
                }
                other => self.of_another_type(found.path, item.span(), Expected::Text, other),
            }
        }
        Some(texts)
    }

    /// Returns a text of bounded length without invisible characters.
    fn plain(&mut self, text: &str, span: Span<usize>, path: &str) -> Option<String> {
        if text.chars().count() > TEXT_MAX {
            return self.refuse(span, Fault::TextTooLong { path: path.to_owned(), most: TEXT_MAX });
        }
        if text.chars().any(is_unseen) {
            return self.refuse(span, Fault::ControlCharacter { path: path.to_owned() });
        }
        Some(text.to_owned())
    }
}
