//! Display of faults within their text, underlined, in the style of compilers.
//!
//! All words are supplied by the caller. Invisible characters, which could control a terminal, are shown as a mark.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use quantities::is_unseen;
use std::borrow::Cow;
use std::ops::Range;

/// Maximum length of a line shown with an underline; a longer one is not displayed.
const LINE_MAX: usize = 400;

/// A fault of a text, with texts ready for display.
#[derive(Clone, Debug)]
pub struct Fault<'f> {
    /// Offending part of the text, in bytes.
    pub span: Range<usize>,
    /// Line of its beginning, counted from one.
    pub line: usize,
    /// Column of its beginning, counted from one.
    pub column: usize,
    /// Description of the fault.
    pub message: &'f str,
    /// Suggested remedy.
    pub hint: Option<&'f str>,
}

/// Settings of the display.
#[derive(Clone, Copy, Debug)]
pub struct Style<'s> {
    /// Name of the file.
    pub file: &'s str,
    /// Word before a fault.
    pub error: &'s str,
    /// Word before a hint.
    pub help: &'s str,
    /// Width of the terminal in columns: a wider line is cut around the place of the fault.
    pub width: usize,
}

/// Returns a fault with its underlined line, in terminal colours; a very long line is not shown.
///
/// Cost: the lines of the fault and their neighbours, independent of the length of the text.
#[must_use]
pub fn show(text: &str, fault: &Fault<'_>, style: &Style<'_>) -> String {
    let part = Part::about(text, fault);
    let line = line_at(part.text, part.span.start).unwrap_or_default();
    if line.len() > LINE_MAX || fault.span.len() > LINE_MAX {
        let help = fault.hint.map(|hint| format!("  {}: {hint}\n", style.help)).unwrap_or_default();
        let place = format!("{}:{}:{}", style.file, fault.line, fault.column);
        return format!("{}: {}\n  --> {place}\n{help}", style.error, fault.message);
    }
    // Each sign that is not seen is one of three bytes in what is shown.
    let mut shown = blanked(part.text);
    if part.span.start == part.text.len() && (part.text.is_empty() || part.text.ends_with('\n')) {
        // A line without any sign in it would be taken for the one before.
        shown.to_mut().push(' ');
    }
    let place = |at: usize| part.text.get(..at).map_or(shown.len(), |before| blanked(before).len());
    let span = place(part.span.start)..place(part.span.end);
    let snippet = Snippet::source(shown.as_ref()).line_start(part.line).path(style.file);
    let mut group: Group<'_> = Level::ERROR
        .with_name(style.error)
        .primary_title(fault.message)
        .element(snippet.annotation(AnnotationKind::Primary.span(span)));
    if let Some(hint) = fault.hint {
        group = group.element(Level::HELP.with_name(style.help).message(hint));
    }
    format!("{}\n", Renderer::styled().term_width(style.width).render(&[group]))
}

/// Lines of a text that contain a fault, with one before and one after.
struct Part<'t> {
    text: &'t str,
    /// Number of its first line, from one.
    line: usize,
    /// The fault in it.
    span: Range<usize>,
}

impl<'t> Part<'t> {
    fn about(text: &'t str, fault: &Fault<'_>) -> Self {
        let end = text.floor_char_boundary(fault.span.end);
        let start = text.floor_char_boundary(fault.span.start).min(end);
        let begin_of = |at: usize| text.get(..at).and_then(|before| before.rfind('\n')).map_or(0, |found| found + 1);
        let end_of =
            |at: usize| text.get(at..).and_then(|rest| rest.find('\n')).map_or(text.len(), |found| at + found + 1);
        let own = begin_of(start);
        let first = begin_of(own.saturating_sub(1));
        let behind = end_of(end_of(end));
        Self {
            text: text.get(first..behind).unwrap_or_default(),
            line: if first < own { fault.line.saturating_sub(1).max(1) } else { fault.line.max(1) },
            span: start - first..end - first,
        }
    }
}

fn line_at(text: &str, at: usize) -> Option<&str> {
    let begin = text.get(..at)?.rfind('\n').map_or(0, |found| found + 1);
    text.get(begin..)?.lines().next()
}

/// Replaces invisible characters by a mark; line breaks and tabs stay.
fn blanked(text: &str) -> Cow<'_, str> {
    let is_blank = |sign: char| is_unseen(sign) && !matches!(sign, '\n' | '\r' | '\t');
    if text.chars().any(is_blank) {
        Cow::Owned(text.chars().map(|sign| if is_blank(sign) { '\u{fffd}' } else { sign }).collect())
    } else {
        Cow::Borrowed(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STYLE: Style<'_> = Style { file: "a.toml", error: "error", help: "help", width: 80 };

    fn shown(text: &str, part: &str) -> String {
        let start = text.find(part).unwrap();
        let line = text[..start].matches('\n').count() + 1;
        let fault = Fault { span: start..start + part.len(), line, column: 1, message: "wrong", hint: Some("right") };
        plain(&show(text, &fault, &STYLE))
    }

    /// Removes the colours.
    fn plain(text: &str) -> String {
        let mut parts = text.split('\u{1b}');
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |sum, part| sum + part.split_once('m').map_or("", |(_, rest)| rest))
    }

    #[test]
    fn a_fault_is_underlined_in_its_line() {
        let text = "one\ntwo\nthree = 4\nfour\nfive\n";
        let found = shown(text, "4");
        assert_eq!(found, "error: wrong\n --> a.toml:3:9\n  |\n3 | three = 4\n  |         ^\n  |\n  = help: right\n");
        let many = format!("{}{text}", "zero\n".repeat(500));
        assert!(shown(&many, "4").contains("503 | three = 4\n"), "{}", shown(&many, "4"));
    }

    #[test]
    fn a_fault_over_several_lines_shows_them() {
        let found = shown("one\ntwo [\nthree\n]\nfive\n", "[\nthree\n]");
        assert!(found.contains("2 |") && found.contains("4 |") && !found.contains("five"), "{found}");
    }

    #[test]
    fn what_is_not_seen_is_marked_and_moves_nothing() {
        let found = shown("\u{202e}a\u{1b}[31m\u{9b}b = 4\n", "4");
        assert!(found.contains("\u{fffd}a\u{fffd}[31m\u{fffd}b = 4"), "{found}");
        let lines: Vec<&str> = found.lines().collect();
        let column = |sign: char| lines.iter().find_map(|line| line.chars().position(|found| found == sign)).unwrap();
        assert_eq!(column('^'), lines[3].chars().position(|found| found == '4').unwrap(), "{found}");
    }

    #[test]
    fn a_long_line_is_not_shown() {
        let found = shown(&format!("x = \"{}\"\n", "y".repeat(401)), "x");
        assert_eq!(found, "error: wrong\n  --> a.toml:1:1\n  help: right\n");
    }

    #[test]
    fn places_at_the_edge_and_beyond_are_shown() {
        for text in ["", "\n", "a", "a\n", "a\r\nß", "\u{feff}", "\r", "a\n\n\n"] {
            for (start, end) in [(0, 0), (0, 1), (1, 1), (1, 9), (2, 3), (9, 9), (3, 2)] {
                let start_in = text.floor_char_boundary(start);
                let line = text[..start_in].matches('\n').count() + 1;
                let fault = Fault { span: start..end, line, column: 1, message: "wrong", hint: None };
                let found = plain(&show(text, &fault, &STYLE));
                assert!(found.starts_with("error: wrong"), "{text:?} {start} {end}");
                assert!(found.contains(&format!("a.toml:{line}:")), "{text:?} {start} {end} in {line}: {found}");
            }
        }
    }

    #[test]
    fn a_fault_behind_the_last_line_is_in_the_line_behind_it() {
        let fault = Fault { span: 10..10, line: 3, column: 1, message: "no end", hint: None };
        let found = plain(&show("a = \"\"\"\nb\n", &fault, &STYLE));
        assert!(found.contains("--> a.toml:3:1") && found.contains("\n  | ^"), "{found}");
    }
}
