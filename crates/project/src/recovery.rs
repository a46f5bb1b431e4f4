//! Recovery from faults of the syntax, statement by statement: one that cannot be read hides no fault of another one.
//!
//! The parser goes on behind most faults, but some of them swallow what follows: a damaged heading its table, an open list
//! or text everything down to the end. In a file with such faults each statement is therefore parsed by itself; a faulty
//! one is replaced by one that can be read, and its key counts as stated. The work grows with the size of the file alone.

mod edits;
mod names;
mod statements;

use edits::Edits;
use names::{Heading, key_of};
pub(crate) use names::{KeyName, KeysAt, TableKind};
use quantities::is_unseen;
use statements::{Extent, begins_with_heading, lacks_value, line_end};
use std::borrow::Cow;
use std::ops::Range as Span;
use toml::de::{DeTable, DeValue};

/// Number of faulty statements behind which reading stops.
const FAULTY_MOST: usize = 100;

/// Key that stands behind a statement to see whether that one hides others.
const SENTINEL: &str = "\n_=1\n";

/// A file with faults of the syntax as far as it can be read.
#[derive(Debug, Default)]
pub(crate) struct Recovery<'t> {
    /// Text to be read instead of that of the file.
    text: Cow<'t, str>,
    /// Places in the file for those of the text.
    edits: Edits,
    /// Faults of the syntax, in the order of the file.
    pub(crate) faults: Vec<(Span<usize>, SyntaxFault)>,
    /// Places of the statements and rows that cannot be read.
    pub(crate) damage: Damage,
    /// Faulty headings whose tables are not known, and other faults that hide parts of the file.
    pub(crate) is_torn: bool,
    /// Byte at which reading stopped because of too many faults.
    pub(crate) stopped: Option<usize>,
    /// Number of bytes that were parsed.
    work: usize,
}

/// A fault of the syntax.
#[derive(Debug)]
pub(crate) enum SyntaxFault {
    /// Message of the parser.
    Message {
        message: String,
        /// Parts of the file are not read because of it.
        hides: bool,
    },
    /// A character in or beside a key that is not seen.
    Invisible(char),
}

/// Places that cannot be read, each in the order of the file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Damage {
    /// Statements of which only the key is known.
    statements: Vec<Span<usize>>,
    /// Lines of a list whose other lines are read.
    rows: Vec<Span<usize>>,
    /// Headings that are read as they are meant.
    headings: Vec<Span<usize>>,
}

/// Returns `true` if one of some places in their order touches a part.
fn touches(places: &[Span<usize>], part: &Span<usize>) -> bool {
    let first = places.partition_point(|place| place.end <= part.start);
    places.get(first).is_some_and(|place| place.start < part.end)
}

impl Damage {
    /// Returns `true` if a value or key belongs to a statement that cannot be read.
    pub(crate) fn is_unread(&self, span: &Span<usize>) -> bool {
        !span.is_empty() && touches(&self.statements, span)
    }

    /// Returns `true` if a part of a list cannot be read.
    pub(crate) fn is_partial(&self, span: &Span<usize>) -> bool {
        !span.is_empty() && touches(&self.rows, span)
    }

    /// Returns `true` if a name is that of a damaged heading.
    pub(crate) fn is_of_heading(&self, span: &Span<usize>) -> bool {
        touches(&self.headings, span)
    }

    /// Returns `true` if a fault is in a line that has its fault of the syntax already.
    pub(crate) fn hides(&self, span: &Span<usize>) -> bool {
        self.is_unread(span) || (!span.is_empty() && touches(&self.rows, &(span.start..span.start + 1)))
    }
}

/// Parses a text; the faults are in the order of their places.
fn parsed(text: &str) -> (DeTable<'_>, Vec<(Span<usize>, String)>) {
    let (root, errors) = DeTable::parse_recoverable(text);
    let mut found: Vec<(Span<usize>, String)> =
        errors.iter().map(|error| (error.span().unwrap_or(0..0), error.message().to_owned())).collect();
    // The faults of values come behind those of the structure.
    found.sort_by_key(|(span, _)| span.start);
    (root.into_inner(), found)
}

const fn syntax(message: String, hides: bool) -> SyntaxFault {
    SyntaxFault::Message { message, hides }
}

impl<'t> Recovery<'t> {
    /// Finds the faults of a file with these keys, and what can be read of it.
    pub(crate) fn of(text: &'t str, keys: KeysAt<'_>) -> Self {
        let mut recovery = Self { text: Cow::Borrowed(text), work: text.len(), ..Self::default() };
        if DeTable::parse_recoverable(text).1.is_empty() {
            return recovery;
        }
        let lines = with_newlines(text);
        if let Some(at) = lone_return(text) {
            recovery.faults.push((at..at + 1, syntax("carriage return must be followed by newline".to_owned(), false)));
        }
        let mut statements = Statements { text: &lines, keys, path: Vec::new(), changed: String::new(), recovery };
        let mut at = 0;
        while at < lines.len() && statements.recovery.faults.len() < FAULTY_MOST {
            at = statements.next(at);
        }
        let Statements { mut changed, mut recovery, .. } = statements;
        if at < lines.len() {
            recovery.stopped = Some(at);
            recovery.is_torn = true;
            recovery.edits.replace(&lines, &mut changed, at..lines.len(), "");
        }
        recovery.edits.finish(&lines, &mut changed);
        recovery.rest(&lines, &changed);
        recovery.text = Cow::Owned(changed);
        recovery
    }

    /// Adds the faults of statements that are valid alone, such as a key that is stated twice.
    fn rest(&mut self, text: &str, changed: &str) {
        self.work += changed.len();
        let (_, found) = parsed(changed);
        for (span, message) in found {
            let span = self.edits.span(&span);
            let span = missing_comma(text, &span, &message).unwrap_or(span);
            let line = line_of(text, span.start);
            if [&self.damage.statements, &self.damage.rows, &self.damage.headings]
                .iter()
                .any(|each| touches(each, &line))
            {
                continue;
            }
            let hides = message.starts_with("cannot extend");
            self.is_torn |= hides;
            self.faults.push((span, syntax(message, hides)));
        }
        self.faults.sort_by_key(|(span, _)| span.start);
    }

    /// Returns the tables of the file as far as they can be read, with their places.
    pub(crate) fn table(&self) -> DeTable<'_> {
        self.edits.placed(DeTable::parse_recoverable(&self.text).0.into_inner())
    }
}

/// Returns the line with a byte.
fn line_of(text: &str, at: usize) -> Span<usize> {
    let start = text.get(..at).and_then(|before| before.rfind('\n')).map_or(0, |end| end + 1);
    start..line_end(text, at)
}

/// Returns the last byte of the entry behind which a comma is missing, for such a fault.
fn missing_comma(text: &str, place: &Span<usize>, message: &str) -> Option<Span<usize>> {
    let mut before = text.get(..place.start).filter(|_| message.starts_with("missing comma"))?.trim_end();
    loop {
        let line = before.get(before.rfind('\n').map_or(0, |end| end + 1)..)?;
        let code = line.rfind([']', '}', '"', '\'']).map_or(0, |last| last + 1);
        match line.get(code..)?.find('#') {
            Some(comment) => before = before.get(..before.len() - line.len() + code + comment)?.trim_end(),
            None => break,
        }
    }
    let last = before.char_indices().next_back()?.0;
    Some(last..before.len())
}

/// Returns the place of the first carriage return that no newline follows.
fn lone_return(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    (0..bytes.len()).find(|at| bytes.get(*at) == Some(&b'\r') && bytes.get(at + 1) != Some(&b'\n'))
}

/// Returns the text with every lone carriage return as a newline, of the same length.
#[must_use]
pub fn with_newlines(text: &str) -> Cow<'_, str> {
    if lone_return(text).is_none() {
        return Cow::Borrowed(text);
    }
    let mut rest = text.chars().peekable();
    let mut changed = String::with_capacity(text.len());
    while let Some(sign) = rest.next() {
        let is_lone = sign == '\r' && rest.peek() != Some(&'\n');
        changed.push(if is_lone { '\n' } else { sign });
    }
    Cow::Owned(changed)
}

/// Statements of a text, read one after another.
struct Statements<'s, 't> {
    text: &'s str,
    keys: KeysAt<'s>,
    /// Names of the heading above.
    path: Vec<String>,
    /// Text to be read, up to the last replacement.
    changed: String,
    recovery: Recovery<'t>,
}

impl<'s> Statements<'s, '_> {
    /// Reads the statement at the start of a line; returns the start of the next one.
    fn next(&mut self, start: usize) -> usize {
        let first = line_end(self.text, start);
        let line = self.get(start..first);
        if line.trim().is_empty() {
            return first;
        }
        let written = line.trim_start();
        let is_heading = written.starts_with('[') && !line.contains(['"', '\'', ',']);
        if is_heading || written.starts_with('#') || begins_with_heading(line) {
            self.line(start..first);
            return first;
        }
        let extent = Extent::of(self.text, start);
        let end = extent.end.max(first);
        self.key(start..end, &extent)
    }

    fn get(&self, span: Span<usize>) -> &'s str {
        self.text.get(span).unwrap_or_default()
    }

    /// Returns the first fault of a statement by itself.
    fn fault_of(&mut self, span: &Span<usize>) -> Option<(Span<usize>, String)> {
        self.recovery.work += span.len();
        // At the start of a file it is a mark and valid.
        let has_mark = span.start > 0 && self.get(span.clone()).starts_with('\u{feff}');
        if has_mark {
            return Some((span.start..span.start + '\u{feff}'.len_utf8(), "invalid unquoted key".to_owned()));
        }
        let (_, found) = parsed(self.get(span.clone()));
        let (place, message) = found.into_iter().next()?;
        Some((span.start + place.start..span.start + place.end, message))
    }

    /// Reads a heading or comment.
    fn line(&mut self, span: Span<usize>) {
        let Some(fault) = self.fault_of(&span) else {
            let line = self.get(span.clone());
            if !line.trim_start().starts_with('#') {
                self.path = heading_path(line);
            }
            return;
        };
        if self.has_invisible(&span) {
            return;
        }
        if self.get(span.clone()).trim_start().starts_with('#') {
            self.replace_statement(span, fault, "", false);
        } else {
            self.heading(span, fault);
        }
    }

    /// Replaces a damaged heading by the one that is meant.
    fn heading(&mut self, line: Span<usize>, (place, message): (Span<usize>, String)) {
        let span = self.trimmed(&line);
        let written = self.get(span.clone());
        let meant = Heading::meant(self.keys, written);
        // A key behind the heading counts as stated.
        let rest = written.rfind(']').filter(|_| written.contains('=')).map_or(written.len(), |last| last + 1);
        let (head, rest) = (span.start..span.start + rest, span.start + rest..span.end);
        let hides = meant.is_none();
        let heading = meant.as_ref().map_or_else(|| format!("[unread-{}]", span.start), Heading::written);
        self.path = meant.map_or_else(Vec::new, |heading| heading.path);
        self.recovery.is_torn |= hides;
        self.push(
            place.start.min(span.end)..place.end.min(span.end).max(place.start.min(span.end)),
            syntax(message, hides),
        );
        self.recovery.damage.headings.push(head.clone());
        self.replace(head, &heading);
        if !rest.is_empty() {
            let key = key_of(&(self.keys)(&self.path), self.get(rest.clone()));
            let stated = key.map_or_else(String::new, |key| format!("\n{key}={{}}"));
            self.recovery.damage.statements.push(rest.clone());
            self.replace(rest, &stated);
        }
    }

    /// Reads a key with its value, or a line of another kind.
    fn key(&mut self, span: Span<usize>, extent: &Extent) -> usize {
        let end = span.end;
        let Some(fault) = self.fault_of(&span) else {
            if self.get(span.clone()).trim_start().starts_with('[') {
                self.path = heading_path(self.get(span));
            }
            return end;
        };
        if self.has_invisible(&span) {
            return end;
        }
        let written = self.get(span.clone());
        let first = span.start..line_end(self.text, span.start).min(span.end);
        let tables = (self.keys)(&self.path);
        let line = self.get(first.clone());
        let is_bare = !line.contains('=');
        let bare = is_bare.then(|| key_of(&tables, line)).flatten();

        let is_value =
            bare.as_ref().is_some_and(|name| tables.iter().any(|key| key.name == name && key.table.is_none()));
        if is_bare && !is_value && Heading::without_brackets(self.keys, line).is_some() {
            let end = first.end;
            self.heading(first, fault);
            return end;
        }
        let is_of_lines = written.trim_end().contains('\n');
        if is_of_lines && !extent.is_bad_at_start && self.list(&span, extent) {
            return end;
        }
        let (mut place, mut message) = fault;
        if extent.is_open && (is_of_lines || !extent.rows.is_empty() || message.starts_with("unclosed")) {
            // An open bracket or text is reported where it opens; the parser reports it where it cannot go on.
            place = self.trimmed(&first);
        }
        if extent.is_bad_at_start {
            place = self.trimmed(&first);
        } else if lacks_value(line) {
            "missing value".clone_into(&mut message);
            place = self.trimmed(&first);
        }
        let key = key_of(&tables, line);
        let stated = match key {
            // An inline table would be in the way of the headings of the table.
            Some(key) if tables.iter().any(|each| each.name == key && each.table.is_some()) => String::new(),
            Some(key) => format!("{key}={{}}"),
            None => format!("unread-{}={{}}", span.start),
        };
        self.recovery.is_torn |= is_of_lines && extent.is_open;
        self.replace_statement(span, (place, message), &stated, is_of_lines);
        end
    }

    /// Reads a list of several lines without its faulty rows; returns `true` if its other rows can be read.
    fn list(&mut self, span: &Span<usize>, extent: &Extent) -> bool {
        const ROW: &str = "{},";
        let (mut trial, mut edits) = (String::new(), Edits::default());
        for row in &extent.rows {
            let row = self.trimmed(row);
            edits.replace(self.text.get(..span.end).unwrap_or_default(), &mut trial, row, ROW);
        }
        edits.finish(self.text.get(..span.end).unwrap_or_default(), &mut trial);
        let head = span.start;
        let mut trial = trial.get(head..).unwrap_or_default().to_owned();
        let closing = if extent.is_open { "\n]" } else { "" };
        trial.push_str(closing);
        let length = trial.len();
        trial.push_str(SENTINEL);
        self.recovery.work += trial.len();
        let (root, found) = parsed(&trial);
        let is_list = root.iter().any(|(_, value)| matches!(value.get_ref(), DeValue::Array(_)));
        if !is_list || !root.iter().any(|(name, _)| name.get_ref() == "_") {
            return false;
        }
        let mut faults: Vec<(Span<usize>, Span<usize>, String)> = Vec::new();
        for row in &extent.rows {
            let row = self.trimmed(row);
            let value = self.get(row.clone()).trim_end_matches(',');
            let alone = format!("x={value}");
            self.recovery.work += alone.len();
            let message =
                parsed(&alone).1.into_iter().next().map_or_else(|| "invalid value".to_owned(), |(_, found)| found);
            faults.push((row.clone(), row, message));
        }
        if extent.is_open {
            let first = self.trimmed(&(span.start..line_end(self.text, span.start)));
            faults.push((first.clone(), first, "unclosed array, expected `]`".to_owned()));
        }
        for (place, message) in found {
            if place.start >= length {
                continue;
            }
            let mut place = edits.span(&(head + place.start..head + place.end));
            if let Some(found) = missing_comma(self.text, &place, &message) {
                place = found;
            }
            let line = self.trimmed(&line_of(self.text, place.start));
            if !faults.iter().any(|(row, ..)| row.start <= line.end && line.start <= row.end) {
                faults.push((line, place, message));
            }
        }
        if faults.is_empty() {
            return false;
        }
        faults.sort_by_key(|(row, ..)| row.start);
        for (row, place, message) in faults {
            self.recovery.damage.rows.push(row);
            self.push(place, syntax(message, false));
        }
        for row in &extent.rows {
            let row = self.trimmed(row);
            self.replace(row, ROW);
        }
        if extent.is_open {
            let end = span.start + self.get(span.clone()).trim_end_matches(['\n', '\r']).len();
            self.replace(end..end, closing);
        }
        true
    }

    /// Reports an invisible character outside of texts, if the statement is valid without it.
    fn has_invisible(&mut self, span: &Span<usize>) -> bool {
        let written = self.get(span.clone());
        let mut found: Vec<(usize, char, &str)> = Vec::new();
        let (mut quote, mut is_value) = (None, false);
        for (at, sign) in written.char_indices() {
            match (sign, quote) {
                ('\n', _) => quote = None,
                ('=', None) => is_value = true,
                ('"' | '\'', None) => quote = Some(sign),
                ('#', None) => quote = Some('\n'),
                (sign, Some(open)) if sign == open => quote = None,
                (sign, None) if is_invisible(sign) => found.push((at, sign, in_place_of(sign))),
                // A key with quotation marks.
                (sign, Some('"' | '\'')) if !is_value && is_invisible(sign) => found.push((at, sign, "")),
                _ => {}
            }
        }
        let Some((first, sign, _)) = found.first().copied() else { return false };
        let mut clean = String::new();
        let mut copied = 0;
        for (at, sign, instead) in &found {
            clean.push_str(written.get(copied..*at).unwrap_or_default());
            clean.push_str(instead);
            copied = at + sign.len_utf8();
        }
        clean.push_str(written.get(copied..).unwrap_or_default());
        self.recovery.work += clean.len();
        let (_, faults) = parsed(&clean);
        if !faults.is_empty() {
            return false;
        }
        if begins_with_heading(&clean) {
            self.path = heading_path(&clean);
        }
        for (at, sign, instead) in found {
            let start = span.start + at;
            self.replace(start..start + sign.len_utf8(), instead);
        }
        let start = span.start + first;
        self.push(start..start + sign.len_utf8(), SyntaxFault::Invisible(sign));
        true
    }

    /// Returns a place without the spaces at its ends.
    fn trimmed(&self, span: &Span<usize>) -> Span<usize> {
        let written = self.get(span.clone());
        let start = span.start + written.len() - written.trim_start().len();
        start..(start + written.trim().len())
    }

    fn replace_statement(
        &mut self,
        span: Span<usize>,
        (place, message): (Span<usize>, String),
        with: &str,
        hides: bool,
    ) {
        let kept = self.trimmed(&span);
        let place = place.start.min(kept.end)..place.end.min(kept.end);
        self.recovery.damage.statements.push(kept.clone());
        self.push(place, syntax(message, hides));
        self.replace(kept, with);
    }

    fn replace(&mut self, span: Span<usize>, with: &str) {
        self.recovery.edits.replace(self.text, &mut self.changed, span, with);
    }

    fn push(&mut self, place: Span<usize>, fault: SyntaxFault) {
        self.recovery.faults.push((place, fault));
    }
}

/// Returns the names of a valid heading.
fn heading_path(line: &str) -> Vec<String> {
    let mut path = Vec::new();
    let (root, _) = DeTable::parse_recoverable(line);
    let mut table = Some(root.get_ref());
    while let Some((name, value)) = table.and_then(|table| table.iter().next()) {
        path.push(name.get_ref().to_string());
        table = match value.get_ref() {
            DeValue::Array(items) => items.first().and_then(|item| item.get_ref().as_table()),
            other => other.as_table(),
        };
    }
    path
}

/// Returns `true` for a character that is not seen, or that looks like a space but is none in TOML.
pub(crate) fn is_invisible(sign: char) -> bool {
    let is_zero_width =
        matches!(sign, '\u{ad}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2060}'..='\u{2064}' | '\u{feff}');
    let is_space = !sign.is_ascii() && sign.is_whitespace();
    is_zero_width || is_space || (is_unseen(sign) && !matches!(sign, '\t' | '\n' | '\r'))
}

/// Returns the text to be read in place of an invisible character.
const fn in_place_of(sign: char) -> &'static str {
    if sign.is_whitespace() { " " } else { "" }
}

#[cfg(test)]
#[path = "recovery_tests.rs"]
mod tests;
