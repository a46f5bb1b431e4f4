//! Statements of a text with faults: a heading, a key with its value, or a line of its own.
//!
//! A statement ends where its brackets are closed. A line that can only begin another one, such as a key inside a list,
//! ends it as well: the bracket before is missing.

use std::ops::Range as Span;

/// Extent of a statement.
#[derive(Debug, Default)]
pub(super) struct Extent {
    /// First byte behind it, behind the end of its last line.
    pub(super) end: usize,
    /// A bracket is not closed.
    pub(super) is_open: bool,
    /// Rows of its list whose brackets are faulty.
    pub(super) rows: Vec<Span<usize>>,
    /// The first line lacks the opening bracket of its list, or has one too many.
    pub(super) is_bad_at_start: bool,
}

/// Returns `true` if nothing follows an equals sign.
pub(super) fn lacks_value(line: &str) -> bool {
    let Some((_, value)) = line.split_once('=') else { return false };
    let value = value.trim();
    value.is_empty() || value.starts_with('#')
}

/// Returns the end of the line with a byte, behind its end-of-line character.
pub(super) fn line_end(text: &str, at: usize) -> usize {
    text.get(at..).and_then(|rest| rest.find('\n')).map_or(text.len(), |found| at + found + 1)
}

fn line(text: &str, start: usize) -> &str {
    text.get(start..line_end(text, start)).unwrap_or_default()
}

/// Returns `true` if a character can be part of a key without quotes.
pub(super) const fn is_of_key(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || matches!(sign, '-' | '_')
}

/// Returns `true` if a line begins with a key and an equals sign.
fn begins_with_key(line: &str) -> bool {
    let line = line.trim_start();
    let rest = line.trim_start_matches(|sign: char| is_of_key(sign) || sign == '.');
    rest.len() < line.len() && rest.trim_start().starts_with('=')
}

/// Returns `true` if a line begins as a heading: bracket and name. A row of a list begins with a bracket too, but holds
/// values.
pub(super) fn begins_with_heading(line: &str) -> bool {
    let line = line.trim_start();
    let inner = line.trim_start_matches(['[', ' ']);
    let name = inner.get(..inner.find(|sign: char| !is_of_key(sign)).unwrap_or(inner.len())).unwrap_or_default();
    line.starts_with('[')
        && name.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
        && !["true", "false", "inf", "nan"].contains(&name)
        && !inner.get(name.len()..).unwrap_or_default().trim_start().starts_with(',')
}

/// Returns `true` if a line is a closing bracket, with a comma or a comment at most.
fn is_closing(line: &str) -> bool {
    let rest = line.trim_start().strip_prefix(']').map(|rest| rest.trim_start().trim_start_matches(',').trim_start());
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('#'))
}

fn is_blank(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || line.starts_with('#')
}

/// State of the scan of a statement.
struct Scan<'t> {
    text: &'t str,
    /// Open brackets.
    open: Vec<u8>,
    /// Last character that is neither space nor comment.
    last: u8,
    /// The first bracket opens a list.
    is_list: bool,
    /// Line at which the row began that is open, or that the last line closed.
    row: Option<usize>,
    extent: Extent,
}

impl Extent {
    /// Finds the extent of the statement that begins at the start of a line.
    pub(super) fn of(text: &str, start: usize) -> Self {
        let first = line_end(text, start);
        let mut scan = Scan { text, open: Vec::new(), last: 0, is_list: false, row: None, extent: Self::default() };
        let mut at = start;
        while at < text.len() {
            if at > start && scan.is_cut(at) {
                break;
            }
            let Some(next) = scan.line(at) else {
                // A text of several lines that is not closed.
                return Self { end: first, is_open: true, ..Self::default() };
            };
            if scan.open.is_empty() && !scan.goes_on(at, next) {
                scan.extent.end = next;
                return scan.extent;
            }
            at = next;
        }
        scan.cut(start, at)
    }
}

impl Scan<'_> {
    /// Returns `true` if a line inside of brackets can only begin another statement.
    fn is_cut(&mut self, at: usize) -> bool {
        let written = line(self.text, at);
        let is_row = written.trim_start().starts_with('[');
        match self.open.as_slice() {
            [.., b'['] if begins_with_key(written) || begins_with_heading(written) => return true,
            [.., b'{'] if begins_with_heading(written) => return true,
            [.., b'{'] if begins_with_key(written) => return !matches!(self.last, b'{' | b','),
            _ => {}
        }
        // A row inside of a row: that one is not closed.
        if is_row && self.is_list && self.open.len() > 1 && self.open.iter().all(|open| *open == b'[') {
            match self.row {
                Some(row) => self.extent.rows.push(row..at),
                None => self.extent.is_bad_at_start = true,
            }
            self.open.truncate(1);
        }
        if is_row && self.open.len() == 1 {
            self.row = Some(at);
        }
        false
    }

    /// Returns `true` if a list that seems closed goes on: the line closed one bracket too many.
    fn goes_on(&mut self, at: usize, next: usize) -> bool {
        let mut following = next;
        while following < self.text.len() && is_blank(line(self.text, following)) {
            following = line_end(self.text, following);
        }
        let written = line(self.text, following);
        let is_row = written.trim_start().starts_with('[') && !begins_with_heading(written);
        let is_list = self.is_list && (is_row || is_closing(written));
        let is_unopened = !self.is_list && is_row && lacks_value(line(self.text, at));
        let goes_on = is_list || is_unopened;
        if is_unopened {
            (self.is_list, self.extent.is_bad_at_start, self.open) = (true, true, vec![b'[']);
        } else if goes_on {
            self.extent.rows.push(at..next);
            self.open.push(b'[');
            self.row = None;
        }
        goes_on
    }

    /// Ends the statement with open brackets.
    fn cut(mut self, start: usize, at: usize) -> Extent {
        self.extent.end = at;
        let body = self.text.get(start..at).unwrap_or_default();
        let (mut rest, mut closing) = (body, None);
        while let Some(found) = rest.trim_end().rfind('\n') {
            let last = rest.get(found + 1..).unwrap_or_default();
            if !is_blank(last) {
                closing = is_closing(last).then_some(start + found + 1);
                break;
            }
            rest = rest.get(..found).unwrap_or_default();
        }
        match (closing, self.row) {
            // The last bracket closed the row before instead of the list.
            (Some(closing), Some(row)) if self.open.len() == 1 && self.is_list => self.extent.rows.push(row..closing),
            _ => self.extent.is_open = true,
        }
        self.extent
    }

    /// Reads a line; returns the start of the next one, `None` if a text of several lines is not closed.
    fn line(&mut self, start: usize) -> Option<usize> {
        let bytes = self.text.as_bytes();
        let mut at = start;
        while let Some(sign) = bytes.get(at) {
            let rest = self.text.get(at..).unwrap_or_default();
            match sign {
                b'\n' => return Some(at + 1),
                b'#' => return Some(line_end(self.text, at)),
                b'"' | b'\'' => {
                    self.last = *sign;
                    let quotes = if *sign == b'"' { "\"\"\"" } else { "'''" };
                    if rest.starts_with(quotes) {
                        let found = rest.get(3..)?.find(quotes)?;
                        at += 3 + found + 3;
                        // A quotation mark may stand before the closing ones.
                        while bytes.get(at) == Some(sign) {
                            at += 1;
                        }
                        let behind = line(self.text, at).trim();
                        if self.open.is_empty() && !behind.is_empty() && !behind.starts_with('#') {
                            return None;
                        }
                        continue;
                    }
                    at = closing_quote(bytes, at);
                    continue;
                }
                b'[' | b'{' => {
                    self.is_list |= self.open.is_empty() && *sign == b'[' && self.last == b'=';
                    self.open.push(*sign);
                    self.last = *sign;
                }
                b']' | b'}' => {
                    self.open.pop();
                    self.last = *sign;
                }
                b' ' | b'\t' | b'\r' => {}
                other => self.last = *other,
            }
            at += 1;
        }
        Some(self.text.len())
    }
}

/// Returns the byte behind the closing quotation mark, or the end of the line without one.
fn closing_quote(bytes: &[u8], start: usize) -> usize {
    let quote = bytes.get(start);
    let mut at = start + 1;
    while let Some(sign) = bytes.get(at) {
        match sign {
            b'\n' => return at,
            b'\\' if quote == Some(&b'"') && bytes.get(at + 1).is_some_and(|next| *next != b'\n') => at += 1,
            _ if Some(sign) == quote => return at + 1,
            _ => {}
        }
        at += 1;
    }
    at
}
