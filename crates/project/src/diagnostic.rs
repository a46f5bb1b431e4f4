//! A fault of the input, with its place and a hint.

use crate::{Fault, Hint};
use std::ops::Range;

/// One fault of a text that the user wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic<F = Fault> {
    /// Faulty part of the text, in bytes.
    pub span: Range<usize>,
    /// Line, from one.
    pub line: usize,
    /// Column in characters, from one.
    pub column: usize,
    /// Fault.
    pub fault: F,
    /// Expected text, or the nearest valid choice, unless the fault itself contains it.
    pub hint: Option<Hint>,
}

/// Returns line and column of a byte offset, both from one; the column counts characters. A carriage return alone ends a
/// line too.
#[must_use]
pub fn place(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..text.floor_char_boundary(offset)).unwrap_or_default();
    let line_start = (0..before.len()).rev().find(|at| ends_line(text, *at)).map_or(0, |at| at + 1);
    let lines = (0..before.len()).filter(|at| ends_line(text, *at)).count();
    (lines + 1, before.get(line_start..).unwrap_or_default().chars().count() + 1)
}

/// Returns the byte offset of a line and column, both from one: the inverse of [`place`]. Beyond the end of a line its end,
/// beyond the last line the end of the text.
#[must_use]
pub fn offset(text: &str, line: usize, column: usize) -> usize {
    let ends = (0..text.len()).filter(|at| ends_line(text, *at)).map(|at| at + 1);
    let start = std::iter::once(0).chain(ends).nth(line.saturating_sub(1)).unwrap_or(text.len());
    let rest = text.get(start..).unwrap_or_default();
    let length = rest.find(['\n', '\r']).unwrap_or(rest.len());
    let within = rest.get(..length).unwrap_or_default();
    within.char_indices().nth(column.saturating_sub(1)).map_or(start + length, |(at, _)| start + at)
}

/// Returns `true` if the byte at an offset ends a line.
fn ends_line(text: &str, at: usize) -> bool {
    let bytes = text.as_bytes();
    match bytes.get(at) {
        Some(b'\n') => true,
        Some(b'\r') => bytes.get(at + 1).is_some_and(|next| *next != b'\n'),
        _ => false,
    }
}

impl<F> Diagnostic<F> {
    /// Creates a fault at a place of a text.
    #[must_use]
    pub fn at(text: &str, span: Range<usize>, fault: F, hint: Option<Hint>) -> Self {
        let (line, column) = place(text, span.start);
        Self { span, line, column, fault, hint }
    }

    /// Returns the fault as one of another kind, at its place.
    #[must_use]
    pub fn into_other<G: From<F>>(self) -> Diagnostic<G> {
        let Self { span, line, column, fault, hint } = self;
        Diagnostic { span, line, column, fault: fault.into(), hint }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_from_one_and_in_characters() {
        assert_eq!(place("ab\ncd", 0), (1, 1));
        assert_eq!(place("ab\ncd", 4), (2, 2));
        assert_eq!(place("äö\nü", 5), (2, 1));
        assert_eq!(place("äö", 1), (1, 1), "inside a character");
        assert_eq!(place("", 9), (1, 1));
        assert_eq!(place("ab\r\ncd", 5), (2, 2));
        assert_eq!(place("ab\rcd", 4), (2, 2));
        assert_eq!(place("ab\r", 3), (1, 4), "at the end of the text");
    }

    #[test]
    fn an_offset_is_that_of_its_place() {
        for text in ["ab\ncd", "äö\nü\n\nx", "a\r\nb\rc\n", ""] {
            let ends = |at: usize| {
                text.get(at..).is_some_and(|rest| rest.starts_with('\n') && at > 0 && text.as_bytes()[at - 1] == b'\r')
            };
            for at in (0..=text.len()).filter(|at| text.is_char_boundary(*at) && !ends(*at)) {
                let (line, column) = place(text, at);
                assert_eq!(offset(text, line, column), at, "{text:?} {at}");
            }
        }
        assert_eq!(offset("ab\ncd", 1, 9), 2);
        assert_eq!(offset("ab\ncd", 9, 1), 5);
    }
}
