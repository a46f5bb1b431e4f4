//! Line reader with a bounded buffer, for text of any length.

use crate::cells::split;
use crate::clock::is_clock;
use crate::encoding::Utf8;
use crate::faults::Fault;
use crate::limits::{BLANK_BYTES_MAX, LINE_BYTES_MAX, Limit};
use crate::number::is_value;
use crate::series::Encoding;
use memchr::{memchr, memchr2, memrchr};
use std::collections::VecDeque;
use std::io::{ErrorKind, Read};
use std::ops::Range;

/// Buffer size: several lines of maximum length, so that few bytes are moved to the front again, and enough for two
/// threads that read numbers.
const BUFFER_BYTES: usize = 16 * LINE_BYTES_MAX;

/// Bytes of comments above the rows that are kept, as a comment may be the heading or a row.
const COMMENT_BYTES_MOST: usize = 1 << 20;

/// Reader of lines with content; comments (`#`) and empty lines are skipped but counted. Once the form of the rows is known, a line
/// that begins with `#` and is a row by its cells is none of the comments.
pub(crate) struct Lines<R> {
    source: Utf8<R>,
    buffer: Vec<u8>,
    /// Range of the buffered text not yet returned.
    rest: Range<usize>,
    line: Range<usize>,
    number: u64,
    at_end: bool,
    /// Read error that occurred after the buffered text.
    failed: Option<ErrorKind>,
    /// Line ending: a line feed, or a carriage return if that alone ends the first line; `None` before the first line.
    end: Option<u8>,
    /// The rest of a line that is too long must still be skipped.
    in_long: bool,
    /// Number of bytes since the last line with content.
    blank: u64,
    /// Comments above the rows with their `#`, the last of them if there are many.
    kept: VecDeque<(u64, Vec<u8>)>,
    kept_bytes: usize,
    /// Delimiter and number of the cells of a row, once the heading was found.
    form: Option<(u8, usize)>,
    /// Number of comments below the heading.
    comments: u64,
}

/// Returns `true` if a line that begins with `#` is a row: it has as many cells as the heading, and one of them is a number, with or
/// without a unit, or a clock time. Of a single column every such line is a comment.
pub(crate) fn is_marked_row(line: &[u8], (delimiter, fields): (u8, usize)) -> bool {
    let is_value = |cell: &String| is_value(cell) || is_clock(cell);
    fields > 1
        && line.len() <= LINE_BYTES_MAX
        && split(line, delimiter).is_some_and(|cells| cells.len() == fields && cells.iter().any(is_value))
}

impl<R: Read> Lines<R> {
    pub(crate) fn new(source: R) -> Self {
        Self {
            source: Utf8::new(source),
            buffer: vec![0; BUFFER_BYTES],
            rest: 0..0,
            line: 0..0,
            number: 0,
            at_end: false,
            failed: None,
            end: None,
            in_long: false,
            blank: 0,
            kept: VecDeque::new(),
            kept_bytes: 0,
            form: None,
            comments: 0,
        }
    }

    /// Returns the current line without its end.
    pub(crate) fn line(&self) -> &[u8] {
        self.buffer.get(self.line.clone()).unwrap_or_default()
    }

    /// Returns the number of the current line, counted from 1.
    pub(crate) const fn number(&self) -> u64 {
        self.number
    }

    /// Returns the encoding of the text; valid once the first line was read.
    pub(crate) const fn encoding(&self) -> Encoding {
        self.source.encoding()
    }

    /// Advances to the next line with content; returns `false` at the end.
    ///
    /// # Errors
    /// [`Fault::LineTooLong`], errors of the source, and more than [`BLANK_BYTES_MAX`] without such a line.
    pub(crate) fn advance(&mut self) -> Result<bool, Fault> {
        self.advance_to(|_| false)
    }

    /// Advances like [`Lines::advance`] also to a comment above the known rows that `is_row`.
    pub(crate) fn advance_to(&mut self, is_row: impl Fn(&[u8]) -> bool) -> Result<bool, Fault> {
        self.blank = 0;
        while self.next_physical()? {
            let line = self.line();
            if line.starts_with(b"#") {
                match self.form {
                    Some(form) if is_marked_row(line, form) => return Ok(true),
                    None if is_row(line) => return Ok(true),
                    Some(_) => self.comments += 1,
                    None => self.keep(),
                }
            } else if !line.iter().all(u8::is_ascii_whitespace) {
                return Ok(true);
            }
            let bytes = self.line.len() + 1;
            self.leave(bytes)?;
        }
        Ok(false)
    }

    /// Keeps the current line, a comment above the rows.
    fn keep(&mut self) {
        let comment = self.line().to_vec();
        self.kept_bytes += comment.len();
        self.kept.push_back((self.number, comment));
        while self.kept_bytes > COMMENT_BYTES_MOST
            && let Some((_, first)) = self.kept.pop_front()
        {
            self.kept_bytes -= first.len();
            self.comments += 1;
        }
    }

    /// Counts bytes without content.
    fn leave(&mut self, bytes: usize) -> Result<(), Fault> {
        self.blank += bytes as u64;
        Limit::BlankBytes.hold(self.blank, BLANK_BYTES_MAX)
    }

    /// Returns the comments kept so far, with their `#`.
    pub(crate) const fn kept(&self) -> &VecDeque<(u64, Vec<u8>)> {
        &self.kept
    }

    /// Returns the comments kept so far, as the heading was found: from here on rows have so many cells.
    pub(crate) fn take_kept(&mut self, form: (u8, usize)) -> VecDeque<(u64, Vec<u8>)> {
        self.form = Some(form);
        std::mem::take(&mut self.kept)
    }

    /// Adds a comment below the heading.
    pub(crate) const fn count_comment(&mut self) {
        self.comments += 1;
    }

    /// Returns the number of comments below the heading so far.
    pub(crate) const fn comments(&self) -> u64 {
        self.comments
    }

    /// Returns the line ending; valid once the first line was read.
    pub(crate) fn ending(&self) -> u8 {
        self.end.unwrap_or(b'\n')
    }

    /// Returns the complete lines after the current one that are buffered, with their ends.
    pub(crate) fn whole(&mut self) -> &[u8] {
        while !self.at_end && self.failed.is_none() && self.rest.len() < BUFFER_BYTES - LINE_BYTES_MAX {
            self.failed = self.read_on().err();
        }
        let rest = self.buffer.get(self.rest.clone()).unwrap_or_default();
        let length = memrchr(self.ending(), rest).map_or(0, |at| at + 1);
        rest.get(..length).unwrap_or_default()
    }

    /// Skips lines returned by [`whole`](Self::whole).
    pub(crate) const fn pass(&mut self, bytes: usize, lines: u64) {
        self.rest.start += bytes;
        self.number += lines;
    }

    fn next_physical(&mut self) -> Result<bool, Fault> {
        let end = self.end()?;
        self.pass_long(end)?;
        let mut searched = 0;
        loop {
            let rest = self.buffer.get(self.rest.clone()).unwrap_or_default();
            let unsearched = rest.get(searched..).unwrap_or_default();
            if let Some(at) = memchr(end, unsearched) {
                let length = searched + at;
                return self.take(length, length + 1);
            }
            searched = rest.len();
            if searched > LINE_BYTES_MAX {
                self.in_long = true;
                return self.take(searched, searched);
            }
            if self.at_end {
                return if searched == 0 { Ok(false) } else { self.take(searched, searched) };
            }
            self.fill()?;
        }
    }

    /// Skips the rest of a line that was too long.
    fn pass_long(&mut self, end: u8) -> Result<(), Fault> {
        while self.in_long {
            let rest = self.buffer.get(self.rest.clone()).unwrap_or_default();
            if let Some(at) = memchr(end, rest) {
                self.rest.start += at + 1;
                self.in_long = false;
            } else if self.at_end {
                self.in_long = false;
            } else {
                self.leave(rest.len())?;
                self.rest.start = self.rest.end;
                self.fill()?;
            }
        }
        Ok(())
    }

    /// Returns the line ending, determined from the first line.
    fn end(&mut self) -> Result<u8, Fault> {
        loop {
            if let Some(end) = self.end {
                return Ok(end);
            }
            let rest = self.buffer.get(self.rest.clone()).unwrap_or_default();
            let first = memchr2(b'\n', b'\r', rest).and_then(|at| Some((*rest.get(at)?, rest.get(at + 1).copied())));
            self.end = match first {
                Some((b'\r', Some(behind))) if behind != b'\n' => Some(b'\r'),
                // The byte after a carriage return may not be buffered yet.
                Some((b'\r', None)) if !self.at_end => None,
                Some(_) => Some(b'\n'),
                None if self.at_end || rest.len() > LINE_BYTES_MAX => Some(b'\n'),
                None => None,
            };
            if self.end.is_none() {
                self.fill()?;
            }
        }
    }

    fn take(&mut self, length: usize, with_end: usize) -> Result<bool, Fault> {
        let start = self.rest.start;
        self.line = start..start + length;
        self.rest.start += with_end;
        self.number += 1;
        if self.number == 1 && self.line().starts_with(b"\xef\xbb\xbf") {
            self.line.start += 3;
        }
        if self.line().last() == Some(&b'\r') {
            self.line.end -= 1;
        }
        if length > LINE_BYTES_MAX {
            return Err(Fault::LineTooLong { line: self.number, most: LINE_BYTES_MAX });
        }
        Ok(true)
    }

    fn fill(&mut self) -> Result<(), Fault> {
        let outcome = self.failed.take().map_or_else(|| self.read_on(), Err);
        outcome.map_err(|kind| Fault::ReadFailed { line: self.number + 1, kind })
    }

    fn read_on(&mut self) -> Result<(), ErrorKind> {
        if self.buffer.len() - self.rest.end < LINE_BYTES_MAX {
            self.buffer.copy_within(self.rest.clone(), 0);
            self.rest = 0..self.rest.len();
        }
        let free = self.buffer.get_mut(self.rest.end..).unwrap_or_default();
        match self.source.read(free) {
            // A source may not claim more bytes than it was given room for.
            Ok(count) => {
                self.rest.end += count.min(free.len());
                self.at_end = count == 0;
                Ok(())
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => Ok(()),
            Err(error) => Err(error.kind()),
        }
    }
}
