//! Keys of a text by their places in it.

use project::Written;
use std::ops::Range;

/// Keys of a text in the order of their places, so that a fault finds its own without a look at every other.
pub(crate) struct Places<'w> {
    /// Keys by the beginning of their spans.
    keys: Vec<&'w Written>,
    /// Largest end of a span up to each key.
    ends: Vec<usize>,
}

impl<'w> Places<'w> {
    pub(crate) fn of(written: &'w [Written]) -> Self {
        let mut keys: Vec<&Written> = written.iter().collect();
        keys.sort_by_key(|key| key.span.start);
        let furthest = |end: &mut usize, key: &&Written| {
            *end = key.span.end.max(*end);
            Some(*end)
        };
        let ends = keys.iter().scan(0, furthest).collect();
        Self { keys, ends }
    }

    /// Returns the smallest value around a part of the text.
    pub(crate) fn around(&self, part: &Range<usize>) -> Option<&'w Written> {
        let before = self.keys.partition_point(|key| key.span.start < part.end.max(part.start + 1));
        let near = self.keys.iter().zip(&self.ends).take(before).rev().take_while(|(_, end)| **end > part.start);
        near.map(|(key, _)| *key).filter(|key| part.start < key.span.end).min_by_key(|key| key.span.len())
    }

    /// Returns the first value behind a place of the text, on the same line.
    pub(crate) fn behind_on_line(&self, place: usize, text: &str) -> Option<&'w Written> {
        let line = place + text.get(place..)?.find('\n').unwrap_or(text.len() - place);
        let behind = self.keys.partition_point(|key| key.span.start < place);
        let on_line = self.keys.iter().skip(behind).take_while(|key| key.span.start <= line);
        on_line.copied().find(|key| key.value.is_some())
    }
}
