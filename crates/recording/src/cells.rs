//! Cells of a line of a CSV.

use crate::collected::FaultCollector;
use crate::encoding;
use crate::faults::Fault;
use csv_core::{ReadRecordResult, ReaderBuilder};
use memchr::{memchr, memchr2_iter};
use std::cell::RefCell;
use std::ops::Range;

/// Signs that separate cells.
pub(crate) const DELIMITERS: [u8; 4] = [b';', b'\t', b',', b'|'];

/// Splitter of lines into cells.
pub(crate) struct CellSplitter {
    pub(crate) delimiter: u8,
    /// Reader of lines with quotes, built at the first of them: that takes far longer than splitting a line.
    quoted: Option<csv_core::Reader>,
    /// Cells of a line with quotes, without their quotes.
    text: Vec<u8>,
    ends: Vec<usize>,
    /// Ranges of the requested cells, in the line or in `text`.
    found: Vec<Range<usize>>,
    in_text: bool,
}

impl CellSplitter {
    pub(crate) fn new(delimiter: u8) -> Self {
        Self { delimiter, quoted: None, text: Vec::new(), ends: Vec::new(), found: Vec::new(), in_text: false }
    }

    /// Finds the requested cells and returns the number of all cells; `None` if a quoted cell does not end.
    pub(crate) fn split(&mut self, line: &[u8], wanted: &[usize]) -> Option<usize> {
        self.found.clear();
        self.found.resize(wanted.len(), 0..0);
        self.in_text = false;
        let (mut start, mut count) = (0, 0);
        for end in memchr2_iter(self.delimiter, b'"', line).chain([line.len()]) {
            if line.get(end) == Some(&b'"') {
                return self.split_quoted(line, wanted);
            }
            for (index, found) in wanted.iter().zip(&mut self.found) {
                if *index == count {
                    *found = start..end;
                }
            }
            start = end + 1;
            count += 1;
        }
        Some(count)
    }

    fn split_quoted(&mut self, line: &[u8], wanted: &[usize]) -> Option<usize> {
        self.in_text = true;
        let count = self.unquote(line)?;
        for (index, found) in wanted.iter().zip(&mut self.found) {
            *found = range_of(&self.ends, *index);
        }
        Some(count)
    }

    /// Iterates over the requested cells of the line split last.
    pub(crate) fn found<'a>(&'a self, line: &'a [u8]) -> impl Iterator<Item = &'a [u8]> {
        let text = if self.in_text { self.text.as_slice() } else { line };
        self.found.iter().map(|range| text.get(range.clone()).unwrap_or_default())
    }

    /// Returns every cell of a line; reports an open quote.
    pub(crate) fn all(&mut self, line: &[u8], number: u64, faults: &mut FaultCollector) -> Option<Vec<Vec<u8>>> {
        let cells = self.try_all(line);
        if cells.is_none() {
            faults.push(Fault::QuoteOpen { line: number });
        }
        cells
    }

    /// Returns every cell of a line; `None` if a quoted cell does not end.
    pub(crate) fn try_all(&mut self, line: &[u8]) -> Option<Vec<Vec<u8>>> {
        self.every(line).map(|cells| cells.map(<[u8]>::to_vec).collect())
    }

    /// Returns the number of cells of a line; `None` if a quoted cell does not end.
    pub(crate) fn count(&mut self, line: &[u8]) -> Option<usize> {
        self.split(line, &[])
    }

    /// Iterates over every cell of a line; `None` if a quoted cell does not end.
    pub(crate) fn every<'a>(&'a mut self, line: &'a [u8]) -> Option<impl Iterator<Item = &'a [u8]>> {
        let (count, delimiter) = match memchr(b'"', line) {
            Some(_) => (self.unquote(line)?, None),
            None => (0, Some(self.delimiter)),
        };
        let plain = delimiter.into_iter().flat_map(move |delimiter| line.split(move |byte| *byte == delimiter));
        let unquoted = (0..count).map(|index| self.text.get(range_of(&self.ends, index)).unwrap_or_default());
        Some(plain.chain(unquoted))
    }

    fn unquote(&mut self, line: &[u8]) -> Option<usize> {
        let delimiter = self.delimiter;
        let quoted = self.quoted.get_or_insert_with(|| ReaderBuilder::new().delimiter(delimiter).build());
        quoted.reset();
        // No cell is longer than the line, and a line has at most one more cell than bytes.
        self.text.resize(line.len() + 1, 0);
        self.ends.resize(line.len() + 2, 0);
        let (_, _, written, cells) = quoted.read_record(line, &mut self.text, &mut self.ends);
        let (text, ends) = (self.text.get_mut(written..)?, self.ends.get_mut(cells..)?);
        // An end of line within quotes belongs to the cell and continues the record.
        let (result, _, _, rest) = quoted.read_record(b"\n", text, ends);
        (result == ReadRecordResult::Record).then_some(cells + rest)
    }
}

fn range_of(ends: &[usize], index: usize) -> Range<usize> {
    let start = index.checked_sub(1).and_then(|before| ends.get(before)).copied().unwrap_or(0);
    start..ends.get(index).copied().unwrap_or(start)
}

/// Returns `true` if a line ends with so many empty cells.
pub(crate) fn ends_empty(line: &[u8], more: usize, delimiter: u8) -> bool {
    let blanks = line.iter().rev().filter(|sign| **sign != b' ');
    blanks.take(more).filter(|sign| **sign == delimiter).count() == more
}

/// Returns the delimiter found in a line: `;`, else a tab, else `,`, else `|`; `,` if there is none of them.
pub(crate) fn delimiter(header: &[u8]) -> u8 {
    DELIMITERS.into_iter().find(|sign| memchr(*sign, header).is_some()).unwrap_or(b',')
}

thread_local! {
    /// Splitters for the search for a heading, which splits the same lines at every delimiter.
    static SPLITTERS: RefCell<[CellSplitter; 4]> = RefCell::new(DELIMITERS.map(CellSplitter::new));
}

/// Returns the cells of a line as trimmed texts.
pub(crate) fn split(line: &[u8], delimiter: u8) -> Option<Vec<String>> {
    let cells = SPLITTERS.with_borrow_mut(|all| {
        let known = all.iter_mut().find(|cells| cells.delimiter == delimiter);
        known.map_or_else(|| CellSplitter::new(delimiter).try_all(line), |cells| cells.try_all(line))
    })?;
    Some(cells.iter().map(|cell| encoding::text(cell).trim().to_owned()).collect())
}
