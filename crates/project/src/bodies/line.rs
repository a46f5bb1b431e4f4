//! One line split into its shape and its `key=value` pairs, each with its place.

use std::ops::Range;

/// One `key=value` pair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Keyed<'t> {
    pub(super) key: &'t str,
    pub(super) key_span: Range<usize>,
    pub(super) value: &'t str,
    /// Place of the value; of the key if the value is empty.
    pub(super) value_span: Range<usize>,
}

/// Parts of one line; places are those in the whole text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Line<'t> {
    /// The whole line without space around it.
    pub(super) span: Range<usize>,
    /// The first word, empty if it is a key or the line is empty.
    pub(super) shape: &'t str,
    /// Place of the shape.
    pub(super) shape_span: Range<usize>,
    pub(super) pairs: Vec<Keyed<'t>>,
    /// Text between the shape and the first key.
    pub(super) stray: Option<(&'t str, Range<usize>)>,
}

impl<'t> Line<'t> {
    /// Splits a line that begins at an offset of the text. A value extends to the next key, so that it may contain
    /// spaces: `mass=0.6 kg distance=80 mm`.
    pub(super) fn split(offset: usize, text: &'t str) -> Self {
        let trimmed = text.trim();
        let start = text.len() - text.trim_start().len();
        let end = start + trimmed.len();
        let part = |range: Range<usize>| text.get(range).unwrap_or_default();
        let spanned = |range: Range<usize>| {
            let inner = part(range.clone());
            let from = range.start + inner.len() - inner.trim_start().len();
            let to = from + inner.trim().len();
            (inner.trim(), offset + from..offset + to)
        };
        // Each key is the word before an equals sign.
        let keys: Vec<(Range<usize>, usize)> = text
            .match_indices('=')
            .map(|(at, _)| {
                let before = part(0..at).trim_end();
                let from = before.rfind(|c: char| c.is_whitespace() || c == '=').map_or(0, |space| {
                    space + before.get(space..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8)
                });
                (from..before.len().max(from), at)
            })
            .collect();
        let first = keys.first().map_or(end, |(key, _)| key.start);
        let word = trimmed.find(char::is_whitespace).map_or(end, |at| start + at);
        let shape_end = word.min(first).max(start);
        let pairs = keys
            .iter()
            .enumerate()
            .map(|(index, (key, equals))| {
                let until = keys.get(index + 1).map_or(end, |(next, _)| next.start).max(equals + 1);
                let (key_text, key_span) = spanned(key.clone());
                let (value, value_span) = spanned(equals + 1..until);
                let value_span = if value.is_empty() { key_span.start..offset + equals + 1 } else { value_span };
                Keyed { key: key_text, key_span, value, value_span }
            })
            .collect();
        let (stray, stray_span) = spanned(shape_end..first.max(shape_end));
        Self {
            span: offset + start..offset + end,
            shape: part(start..shape_end),
            shape_span: offset + start..offset + shape_end,
            pairs,
            stray: (!stray.is_empty()).then_some((stray, stray_span)),
        }
    }

    /// Returns `true` if a key is present.
    pub(super) fn has(&self, key: &str) -> bool {
        self.pairs.iter().any(|pair| pair.key == key)
    }
}
