//! Changes of a text, with the places of the original for those of the changed text.

use std::ops::Range as Span;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// Parts of a text that are replaced, in their order.
#[derive(Debug, Default)]
pub(super) struct Edits(Vec<Edit>);

#[derive(Debug)]
struct Edit {
    /// Replaced part of the original.
    from: Span<usize>,
    /// Place of the replacement in the changed text.
    to: Span<usize>,
}

impl Edits {
    /// Appends a replacement of a part behind all earlier ones to the changed text.
    pub(super) fn replace(&mut self, text: &str, changed: &mut String, from: Span<usize>, with: &str) {
        let copied = self.0.last().map_or(0, |last| last.from.end);
        changed.push_str(text.get(copied..from.start).unwrap_or_default());
        let start = changed.len();
        changed.push_str(with);
        self.0.push(Edit { from, to: start..changed.len() });
    }

    /// Appends the rest of the text.
    pub(super) fn finish(&self, text: &str, changed: &mut String) {
        let copied = self.0.last().map_or(0, |last| last.from.end);
        changed.push_str(text.get(copied..).unwrap_or_default());
    }

    /// Returns the place in the original; one inside a replacement is its start, or its end.
    fn place(&self, at: usize, is_end: bool) -> usize {
        let before = self.0.partition_point(|edit| edit.to.start < at || (edit.to.start == at && !is_end));
        let Some(edit) = before.checked_sub(1).and_then(|last| self.0.get(last)) else { return at };
        if at < edit.to.end || (at == edit.to.end && is_end) {
            if is_end { edit.from.end } else { edit.from.start }
        } else {
            at - edit.to.end + edit.from.end
        }
    }

    /// Returns the place of a part in the original.
    pub(super) fn span(&self, of: &Span<usize>) -> Span<usize> {
        let start = self.place(of.start, false);
        start..self.place(of.end, true).max(start)
    }

    /// Returns a table with the places of the original.
    pub(crate) fn placed<'t>(&self, table: DeTable<'t>) -> DeTable<'t> {
        if self.0.is_empty() {
            return table;
        }
        table.into_iter().map(|(name, value)| (self.placed_name(name), self.value(value))).collect()
    }

    fn placed_name<T>(&self, value: Spanned<T>) -> Spanned<T> {
        let span = self.span(&value.span());
        Spanned::new(span, value.into_inner())
    }

    fn value<'t>(&self, value: Spanned<DeValue<'t>>) -> Spanned<DeValue<'t>> {
        let span = self.span(&value.span());
        let inner = match value.into_inner() {
            DeValue::Table(table) => DeValue::Table(self.placed(table)),
            DeValue::Array(items) => {
                DeValue::Array(items.into_iter().map(|item| self.value(item)).collect::<DeArray<'t>>())
            }
            other => other,
        };
        Spanned::new(span, inner)
    }
}
