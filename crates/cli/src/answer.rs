//! Answer of a command: data for stdout, messages for stderr, an exit code.

use quantities::{Language, is_unseen, seen};
pub(crate) use questions::answer::written;
use serde::Serialize;
use std::borrow::Cow;
use std::io::Write;
use words::{UsageHint, file_trouble, usage_hint};

/// Answer of a command.
#[derive(Debug, Default)]
pub(crate) struct CommandAnswer {
    /// Text for stdout.
    pub(crate) data: String,
    /// Messages for stderr.
    pub(crate) talk: String,
    /// Messages for stderr below the data: calls that go on from the answer.
    pub(crate) next: String,
    /// Exit code: 0 fits or answered, 1 does not fit, 2 not answered.
    pub(crate) code: u8,
}

/// Returns a text for a terminal: without invisible characters except ends of lines, tabs and the colours of antrieb.
/// User input is made visible where it enters a message; this is the last barrier.
fn safe(text: &str) -> Cow<'_, str> {
    if !text.chars().any(|sign| is_unseen(sign) && !matches!(sign, '\n' | '\t')) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(sign) = rest.chars().next() {
        let colour = rest.strip_prefix("\u{1b}[").and_then(|code| {
            let code = code.split_once('m')?.0;
            code.bytes().all(|byte| byte.is_ascii_digit() || byte == b';').then_some(code.len() + 3)
        });
        // CSV lines end with CR LF.
        let end = rest.starts_with("\r\n").then_some(2);
        let ours = colour.or(end);
        let (part, behind) = rest.split_at_checked(ours.unwrap_or(sign.len_utf8())).unwrap_or((rest, ""));
        match ours {
            None if !matches!(sign, '\n' | '\t') => out.push_str(&seen(part)),
            _ => out.push_str(part),
        }
        rest = behind;
    }
    Cow::Owned(out)
}

/// Splits a text into pieces of whole lines, so that a long one is not copied as a whole.
fn pieces(mut rest: &str) -> impl Iterator<Item = &str> {
    const LONG: usize = 1 << 16;
    std::iter::from_fn(move || {
        let from = rest.floor_char_boundary(LONG);
        let end = rest.get(from..).and_then(|behind| behind.find('\n')).map_or(rest.len(), |at| from + at + 1);
        let (piece, behind) = rest.split_at_checked(end)?;
        rest = behind;
        (!piece.is_empty()).then_some(piece)
    })
}

impl CommandAnswer {
    pub(crate) fn none() -> Self {
        Self::default()
    }

    pub(crate) fn data(data: String) -> Self {
        Self { data, ..Self::default() }
    }

    /// Creates an answer of lines for stdout.
    pub(crate) fn lines(lines: &[String]) -> Self {
        Self::data(lines.iter().flat_map(|line| [line.as_str(), "\n"]).collect())
    }

    /// Adds a remark before the messages.
    pub(crate) fn remarked(mut self, remark: Option<String>) -> Self {
        if let Some(remark) = remark {
            self.talk.insert_str(0, &format!("{remark}\n"));
        }
        self
    }

    /// Adds calls that work to the messages of a refused one.
    pub(crate) fn with_calls(mut self, calls: &[String], language: Language) -> Self {
        if !calls.is_empty() {
            let hint = usage_hint(&UsageHint::Calls(calls.to_vec()), language);
            self.talk.push_str(&format!("  {}\n", hint.replace('\n', "\n  ")));
        }
        self
    }

    /// Creates an answer with a record for stdout.
    pub(crate) fn record(record: &impl Serialize) -> Self {
        Self::data(written(record))
    }

    /// Joins the answers about all axes: texts one below the other; the code is 1 if one axis does not fit.
    pub(crate) fn of_axes(found: Vec<(String, bool)>) -> Self {
        let fits = found.iter().all(|(_, fits)| *fits);
        let texts: Vec<String> = found.into_iter().map(|(text, _)| text).collect();
        Self::data(texts.join("\n")).fits(fits)
    }

    /// Sets the exit code of a verdict.
    pub(crate) fn fits(self, fits: bool) -> Self {
        Self { code: u8::from(!fits), ..self }
    }

    /// Writes data and messages; colours are removed if the stream is no terminal. A pipe closed by its reader is no
    /// fault, nor is a standard output that the caller closed; any other error of stdout is.
    pub(crate) fn write(self, language: Language) -> u8 {
        let _ = anstream::stderr().write_all(safe(&self.talk).as_bytes());
        let mut out = anstream::stdout();
        let mut pieces = pieces(&self.data);
        let written = pieces.try_for_each(|piece| out.write_all(safe(piece).as_bytes())).and_then(|()| out.flush());
        let _ = anstream::stderr().write_all(safe(&self.next).as_bytes());
        match written {
            Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                let _ = writeln!(anstream::stderr(), "antrieb: stdout: {}", file_trouble(&error, language));
                2
            }
            _ => self.code,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn our_own_colours_pass_and_nothing_else_that_steers() {
        assert_eq!(safe("\u{1b}[1;32mfits\u{1b}[0m\n\ta"), "\u{1b}[1;32mfits\u{1b}[0m\n\ta");
        let hostile = "\u{1b}]0;title\u{7}\u{1b}[2J\u{9b}31m\u{202e}x\r";
        let shown = safe(hostile);
        assert_eq!(shown, "\\u{1b}]0;title\\u{7}\\u{1b}[2J\\u{9b}31m\\u{202e}x\\u{d}");
        assert_eq!(safe("\u{1b}["), "\\u{1b}[");
        assert_eq!(safe("a,b\r\nc\rd"), "a,b\r\nc\\u{d}d");
    }

    #[test]
    fn a_long_text_is_written_in_whole_lines() {
        for text in [String::new(), "x".into(), "a\n".into(), "ä".repeat(50_000), "äb\r\n".repeat(70_000) + "end"] {
            let pieces: Vec<&str> = pieces(&text).collect();
            assert!(pieces.iter().rev().skip(1).all(|piece| piece.ends_with('\n') && piece.len() > 1 << 16));
            assert_eq!(pieces.concat(), text);
        }
    }
}
