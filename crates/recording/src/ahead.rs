//! Search for the heading of a CSV, which may follow lines about the file.

use crate::cells::{DELIMITERS, delimiter, split};
use crate::clock::is_clock;
use crate::encoding;
use crate::faults::Fault;
use crate::limits::TABLE_COLUMNS_MAX;
use crate::lines::{Lines, is_marked_row};
use crate::names::is_usual_name;
use crate::number::{Decimals, with_unit};
use crate::series::Encoding;
use crate::tools::Headers;
use memchr::memchr;
use quantities::Unit;
use std::collections::VecDeque;
use std::io::Read;

/// Maximum number of lines searched for the heading.
const LINES_MOST: usize = 200;

/// Maximum number of bytes in these lines.
const BYTES_MOST: usize = 1 << 20;

/// Lines with look-ahead: those read during the search for the heading come first.
pub(crate) struct Ahead<R> {
    lines: Lines<R>,
    queue: VecDeque<(u64, Vec<u8>)>,
    current: Option<(u64, Vec<u8>)>,
    /// Read error that occurred after the queued lines.
    failed: Option<Fault>,
    /// Without a heading, two successive lines hold numbers separated by spaces alone.
    is_spaced: bool,
}

/// Position of the heading and the delimiter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct HeadingPlace {
    /// Delimiter of the cells.
    pub(crate) delimiter: u8,
    /// The file has no heading: its first line holds numbers.
    pub(crate) is_missing: bool,
    /// A line of notes between the units and the rows, below the heading by so many lines.
    notes: Option<usize>,
}

impl<R: Read> Ahead<R> {
    pub(crate) fn new(source: R) -> Self {
        Self { lines: Lines::new(source), queue: VecDeque::new(), current: None, failed: None, is_spaced: false }
    }

    /// Searches the heading; the next line is then the heading, or the first row if there is none. Returns `None` for a
    /// file without lines.
    ///
    /// The heading is the line above the first of two rows with the same number of cells, most of them numbers; a row
    /// of units may stand in between. Without such rows it is the first line. A first line with numbers in all columns
    /// that `numbered` lists by their indices is a row, whatever the others hold.
    pub(crate) fn heading(&mut self, numbered: &[usize]) -> Result<Option<HeadingPlace>, Fault> {
        let mut seen: Vec<(u64, Vec<u8>)> = Vec::new();
        let (mut stated, mut bytes) = (None, 0);
        let mut found = None;
        let mut is_end = false;
        let mut headers = Headers::default();
        while found.is_none() && !is_end && seen.len() < LINES_MOST && bytes < BYTES_MOST {
            match self.lines.advance_to(|line| follows(&seen, line)) {
                Ok(true) => {}
                Ok(false) => is_end = true,
                Err(fault) if seen.is_empty() => return Err(fault),
                Err(fault) => {
                    self.failed = Some(fault);
                    is_end = true;
                }
            }
            if !is_end {
                let line = self.lines.line().to_vec();
                if seen.is_empty()
                    && stated.is_none()
                    && let Some(sign) = stated_delimiter(&line)
                {
                    stated = Some(sign);
                    continue;
                }
                bytes += line.len();
                // A line of delimiters below lines without a number is no row, and states neither names nor units.
                if is_blank(&line) && seen.last().is_some_and(|(_, last)| !holds_number(last)) {
                    continue;
                }
                if headers.end_with(&line, seen.is_empty()) {
                    seen.clear();
                    continue;
                }
                seen.push((self.lines.number(), line));
            }
            if (seen.len() == 2 || is_end && seen.len() == 1)
                && headers.are_over()
                && let Some(delimiter) = delimiter_of_rows(&seen, numbered, stated)
            {
                found = Some((0, HeadingPlace { delimiter, is_missing: true, notes: None }));
                break;
            }
            // A row counts once the next one confirms it or the file ends.
            if let Some((row, number, headings, delimiter)) = headers.scope(&seen) {
                if let Some(fault) = headers.scale(&seen) {
                    return Err(fault);
                }
                self.queue = std::iter::once((number, headings)).chain(seen.drain(row..)).collect();
                self.take_comments(delimiter, u64::MAX);
                return Ok(Some(HeadingPlace { delimiter, is_missing: false, notes: None }));
            }
            let row = if is_end { seen.len().checked_sub(1) } else { seen.len().checked_sub(2) };
            let row = row.filter(|_| is_end || headers.are_over());
            found = row.and_then(|row| heading_above(&seen, row, (stated, is_row)));
        }
        // Most columns may hold text, and most numbers a unit.
        let found = found.or_else(|| {
            let rows = |is_row: IsRow| (1..seen.len()).find_map(|row| heading_above(&seen, row, (stated, is_row)));
            rows(is_mixed_row).or_else(|| rows(is_row_with_units))
        });
        self.is_spaced =
            found.is_none() && seen.windows(2).any(|pair| pair.iter().all(|(_, line)| is_spaced_row(line)));
        let Some((_, first)) = seen.first() else { return Ok(None) };
        let (start, mut answer) = found.unwrap_or_else(|| {
            (0, HeadingPlace { delimiter: stated.unwrap_or_else(|| delimiter(first)), is_missing: false, notes: None })
        });
        let heading = marked_heading(self.lines.kept(), &seen, start, answer);
        self.queue = seen.into_iter().skip(heading.as_ref().map_or(start, |marked| marked.below)).collect();
        if let Some(notes) = answer.notes {
            let _ = self.queue.remove(notes);
        }
        let mut used = 0;
        if let Some(marked) = heading {
            used = marked.last;
            marked.lines.into_iter().rev().for_each(|line| self.queue.push_front(line));
            (answer.is_missing, answer.delimiter) = (false, marked.delimiter);
        }
        self.take_comments(answer.delimiter, used);
        Ok(Some(answer))
    }

    /// Adds the comments below the heading that are rows to the lines; `used` is the number of the last comment that is part of the
    /// heading.
    fn take_comments(&mut self, delimiter: u8, used: u64) {
        let Some((first, heading)) = self.queue.front() else { return };
        let (first, form) = (*first, (delimiter, split(heading, delimiter).map_or(0, |cells| cells.len())));
        for (number, line) in self.lines.take_kept(form) {
            if number <= first.max(used) {
                continue;
            }
            if is_marked_row(&line, form) {
                let place = self.queue.partition_point(|(other, _)| *other < number);
                self.queue.insert(place, (number, line));
            } else {
                self.lines.count_comment();
            }
        }
    }

    /// Returns the number of comments below the heading so far.
    pub(crate) const fn comments(&self) -> u64 {
        self.lines.comments()
    }

    /// Returns `true` if no heading was found, and two successive lines hold numbers separated by spaces alone.
    pub(crate) const fn is_spaced(&self) -> bool {
        self.is_spaced
    }

    /// Searches the line of headings of a table with any columns, and returns its delimiter; the next line is then the headings.
    /// Returns `None` for a file without lines.
    ///
    /// The headings are the first line with two known names, or with known names in half of its cells; lines above it are about
    /// the file. Without such a line they are the first one.
    pub(crate) fn headings(&mut self, is_known: impl Fn(&str) -> bool) -> Result<Option<u8>, Fault> {
        let mut seen: Vec<(u64, Vec<u8>)> = Vec::new();
        let (mut stated, mut bytes, mut found) = (None, 0, None);
        while found.is_none() && seen.len() < LINES_MOST && bytes < BYTES_MOST {
            match self.lines.advance_to(|line| follows(&seen, line)) {
                Ok(true) => {}
                Ok(false) => break,
                Err(fault) if seen.is_empty() => return Err(fault),
                Err(fault) => {
                    self.failed = Some(fault);
                    break;
                }
            }
            let line = self.lines.line();
            if seen.is_empty()
                && stated.is_none()
                && let Some(sign) = stated_delimiter(line)
            {
                stated = Some(sign);
                continue;
            }
            bytes += line.len();
            let number = self.lines.number();
            found = delimiter_of_names(line, stated, &is_known).map(|sign| (seen.len(), sign));
            // A comment with known names directly above a line with as many cells.
            let above = self
                .lines
                .kept()
                .back()
                .filter(|(comment, _)| found.is_none() && seen.last().is_none_or(|(before, _)| before < comment));
            if let Some((comment, text)) = above {
                let names = unmarked(text);
                let sign = delimiter_of_names(&names, stated, &is_known);
                let count = |line: &[u8], sign: u8| split(line, sign).map(|cells| cells.len());
                if let Some(sign) = sign.filter(|sign| count(&names, *sign) == count(line, *sign)) {
                    found = Some((seen.len(), sign));
                    seen.push((*comment, names));
                }
            }
            seen.push((number, line.to_vec()));
        }
        let Some((_, first)) = seen.first() else { return Ok(None) };
        let (place, sign) = found.unwrap_or_else(|| (0, stated.unwrap_or_else(|| of_headings(first))));
        self.queue = seen.into_iter().skip(place).collect();
        self.take_comments(sign, 0);
        Ok(Some(sign))
    }

    /// Returns the line behind the current one without advancing to it; `None` at the end, or if it cannot be read.
    pub(crate) fn next(&mut self) -> Option<&[u8]> {
        if self.queue.is_empty() && self.failed.is_none() {
            // The buffer of the lines holds one line only.
            if self.current.is_none() {
                self.current = Some((self.lines.number(), self.lines.line().to_vec()));
            }
            match self.lines.advance() {
                Ok(true) => self.queue.push_back((self.lines.number(), self.lines.line().to_vec())),
                Ok(false) => {}
                Err(fault) => self.failed = Some(fault),
            }
        }
        self.queue.front().map(|(_, line)| line.as_slice())
    }

    /// Advances to the next line with content; returns `false` at the end.
    pub(crate) fn advance(&mut self) -> Result<bool, Fault> {
        self.current = self.queue.pop_front();
        if self.current.is_some() {
            return Ok(true);
        }
        match self.failed.take() {
            Some(fault) => Err(fault),
            None => self.lines.advance(),
        }
    }

    /// Returns the current line without its end.
    pub(crate) fn line(&self) -> &[u8] {
        self.current.as_ref().map_or_else(|| self.lines.line(), |(_, line)| line.as_slice())
    }

    /// Returns the number of the current line, counted from 1.
    pub(crate) fn number(&self) -> u64 {
        self.current.as_ref().map_or_else(|| self.lines.number(), |(number, _)| *number)
    }

    /// Returns the encoding of the text.
    pub(crate) const fn encoding(&self) -> Encoding {
        self.lines.encoding()
    }

    /// Returns the lines not read yet, once the queued ones are used up.
    pub(crate) fn unread(&mut self) -> Option<&mut Lines<R>> {
        (self.queue.is_empty() && self.failed.is_none()).then_some(&mut self.lines)
    }
}

/// Returns `true` if a line holds delimiters alone.
fn is_blank(line: &[u8]) -> bool {
    line.iter().all(|byte| DELIMITERS.contains(byte) || byte.is_ascii_whitespace())
}

/// Returns `true` if a cell of a line is a number, by any delimiter.
fn holds_number(line: &[u8]) -> bool {
    let numbers = |sign: u8| split(line, sign).is_some_and(|cells| cells.iter().any(|cell| Decimals::is_number(cell)));
    DELIMITERS.into_iter().any(numbers)
}

/// Returns the delimiter stated by a first line `sep=;`, as written by spreadsheets.
fn stated_delimiter(line: &[u8]) -> Option<u8> {
    let line = line.trim_ascii();
    let line = line.strip_prefix(b"\"").and_then(|line| line.strip_suffix(b"\"")).unwrap_or(line);
    let (key, sign) = line.split_at_checked(4)?;
    let sign = match sign {
        b"" => b'\t',
        b"\\t" => b'\t',
        [sign] => *sign,
        _ => return None,
    };
    (key.eq_ignore_ascii_case(b"sep=") && DELIMITERS.contains(&sign)).then_some(sign)
}

/// Returns the delimiters to try, most likely first.
fn possible_delimiters(stated: Option<u8>, likely: u8) -> Vec<u8> {
    let others = DELIMITERS.into_iter().filter(|sign| *sign != likely);
    stated.map_or_else(|| std::iter::once(likely).chain(others).collect(), |sign| vec![sign])
}

/// Returns the delimiter of a line of headings; of a single column no comma separates cells, so that its numbers may have
/// decimal commas.
fn of_headings(line: &[u8]) -> u8 {
    let sign = delimiter(line);
    if memchr(sign, line).is_none() { b';' } else { sign }
}

/// Returns the delimiter by which a line has two known names, or known names in half of its cells.
fn delimiter_of_names(line: &[u8], stated: Option<u8>, is_known: impl Fn(&str) -> bool) -> Option<u8> {
    let signs = possible_delimiters(stated, of_headings(line));
    signs.into_iter().find(|sign| {
        // A line with more cells than a table has columns is not searched.
        let cells = split(line, *sign).filter(|cells| cells.len() as u64 <= TABLE_COLUMNS_MAX).unwrap_or_default();
        let known = cells.iter().filter(|cell| is_known(cell)).take(2).count();
        let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
        known > 1 || known > 0 && 2 * known >= filled
    })
}

/// Returns `true` if a line consists of several numbers separated by spaces alone.
pub(crate) fn is_spaced_row(line: &[u8]) -> bool {
    let text = encoding::text(line);
    let mut cells = text.split_ascii_whitespace();
    text.trim().contains(' ') && cells.all(|cell| Decimals::is_number(cell) || is_clock(cell))
}

/// Returns `true` if a comment is a row below the last line: as many cells, most of them numbers.
fn follows(seen: &[(u64, Vec<u8>)], comment: &[u8]) -> bool {
    let Some((_, last)) = seen.last() else { return false };
    DELIMITERS.into_iter().any(|sign| {
        let count = split(last, sign).map_or(0, |cells| cells.len());
        count > 1 && split(comment, sign).is_some_and(|cells| cells.len() == count && is_row(&cells))
    })
}

/// Returns a comment without its sign.
fn unmarked(comment: &[u8]) -> Vec<u8> {
    comment.strip_prefix(b"#").unwrap_or(comment).trim_ascii().to_vec()
}

/// A heading in comments.
struct MarkedHeading {
    /// Line of the names, and that of the units if both are comments.
    lines: Vec<(u64, Vec<u8>)>,
    delimiter: u8,
    /// Number of the last comment.
    last: u64,
    /// Index of the first line below it.
    below: usize,
}

/// Returns the heading in the comments directly above the rows, `# t [s],q [deg]`: as many names as a row has cells, one of them usual,
/// and no number. A line of units may stand below it. A heading with usual names that is no comment comes first.
fn marked_heading(
    kept: &VecDeque<(u64, Vec<u8>)>,
    seen: &[(u64, Vec<u8>)],
    start: usize,
    answer: HeadingPlace,
) -> Option<MarkedHeading> {
    let cells_of = |line: &[u8], sign: u8| split(line, sign).filter(|cells| cells.len() > 1);
    let usual = |cells: &[String]| cells.iter().any(|cell| is_usual_name(cell));
    let are_units = |cells: &[String]| cells.iter().all(|cell| is_unit(cell));
    // The comments between a line and the one above it, the lowest first.
    let above = |place: usize| {
        let least = place.checked_sub(1).and_then(|before| seen.get(before)).map_or(0, |(number, _)| *number);
        let most = seen.get(place).map_or(0, |(number, _)| *number);
        kept.iter().rev().filter(move |(number, _)| *number > least && *number < most)
    };
    let names_above = |place: usize, sign: u8| {
        let count = cells_of(&seen.get(place)?.1, sign)?.len();
        let mut comments = above(place).map(|(number, line)| (*number, unmarked(line)));
        let (last, lowest) = comments.next()?;
        let fitting = |line: &[u8]| cells_of(line, sign).filter(|cells| cells.len() == count && values(cells).0 == 0);
        let cells = fitting(&lowest)?;
        if usual(&cells) && !are_units(&cells) {
            return Some(MarkedHeading { lines: vec![(last, lowest)], delimiter: sign, last, below: place });
        }
        let (number, names) = comments.next().filter(|_| are_units(&cells))?;
        let is_heading = fitting(&names).is_some_and(|names| usual(&names));
        is_heading.then(|| MarkedHeading {
            lines: vec![(number, names), (last, lowest)],
            delimiter: sign,
            last,
            below: place,
        })
    };
    let sign = answer.delimiter;
    if answer.is_missing {
        return names_above(start, sign);
    }
    let heading = cells_of(&seen.get(start)?.1, sign);
    if heading.as_ref().is_some_and(|cells| usual(cells) && !are_units(cells)) {
        return None;
    }
    // Units that are no comment, below names that are one.
    if heading.is_some_and(|cells| are_units(&cells))
        && let Some(found) = names_above(start, sign)
    {
        return Some(found);
    }
    // Rows below lines about the file.
    let is_row_at = |place: usize, sign: u8| {
        seen.get(place).and_then(|(_, line)| cells_of(line, sign)).is_some_and(|cells| is_row(&cells))
    };
    (start + 1..seen.len()).find_map(|place| {
        let first = above(place).next()?;
        let sign = delimiter(&first.1);
        let confirms = seen.get(place + 1).is_none() || is_row_at(place + 1, sign);
        names_above(place, sign).filter(|_| is_row_at(place, sign) && confirms)
    })
}

/// Counts the numbers and clock times among the non-empty cells, and the non-empty cells.
fn values(cells: &[String]) -> (usize, usize) {
    let filled = || cells.iter().filter(|cell| !cell.is_empty());
    (filled().filter(|cell| Decimals::is_number(cell) || is_clock(cell)).count(), filled().count())
}

/// Returns `true` if most cells are numbers or clock times.
fn is_row(cells: &[String]) -> bool {
    let (values, filled) = values(cells);
    2 * values > filled
}

/// Returns `true` if at least half of the cells are numbers or clock times.
fn is_mixed_row(cells: &[String]) -> bool {
    let (values, filled) = values(cells);
    values > 0 && 2 * values >= filled
}

/// Returns `true` if most cells are numbers, with or without a unit, or clock times.
fn is_row_with_units(cells: &[String]) -> bool {
    let filled = cells.iter().filter(|cell| !cell.is_empty());
    let values = cells.iter().filter(|cell| with_unit(cell).is_some()).count() + values(cells).0;
    2 * values > filled.count()
}

/// Returns the delimiter by which all lines have numbers or clock times in the numbered columns.
fn delimiter_of_rows(lines: &[(u64, Vec<u8>)], numbered: &[usize], stated: Option<u8>) -> Option<u8> {
    let (_, first) = lines.first().filter(|_| !numbered.is_empty())?;
    let signs = possible_delimiters(stated, delimiter(first));
    let is_value = |cell: &String| Decimals::is_number(cell) || is_clock(cell);
    let is_row = |line: &[u8], sign: u8| {
        let cells = split(line, sign).unwrap_or_default();
        numbered.iter().all(|index| cells.get(*index).is_some_and(is_value))
    };
    signs.into_iter().find(|sign| lines.iter().all(|(_, line)| is_row(line, *sign)))
}

/// Predicate: the cells of a line can be those of a row of values.
type IsRow = fn(&[String]) -> bool;

/// Returns the index of the line that heads a row, and its properties, if the row has a heading.
fn heading_above(
    seen: &[(u64, Vec<u8>)],
    row: usize,
    (stated, is_row): (Option<u8>, IsRow),
) -> Option<(usize, HeadingPlace)> {
    let line = |place: usize| seen.get(place).map(|(_, line)| line.as_slice());
    let above = row.checked_sub(1).and_then(line);
    let signs = possible_delimiters(stated, above.map_or(b';', delimiter));
    signs.into_iter().find_map(|delimiter| {
        let cells = split(line(row)?, delimiter).filter(|cells| cells.len() > 1 && is_row(cells))?;
        let alike = |place: usize| split(line(place)?, delimiter).filter(|other| other.len() == cells.len());
        if line(row + 1).is_some() && !alike(row + 1).is_some_and(|next| is_row(&next)) {
            return None;
        }
        let Some(head) = row.checked_sub(1) else {
            let (values, filled) = values(&cells);
            return (values == filled).then_some((0, HeadingPlace { delimiter, is_missing: true, notes: None }));
        };
        // A row with one number is a faulty row, or a line about the file.
        let heading = alike(head).filter(|cells| values(cells).0 == 0)?;
        let at = |place| Some((place, HeadingPlace { delimiter, is_missing: false, notes: None }));
        let Some((higher, names)) = head.checked_sub(1).and_then(|place| Some((place, alike(place)?))) else {
            return at(head);
        };
        // The lower of two lines of text may hold the units.
        let are_units = heading.iter().filter(|cell| !cell.is_empty()).all(|cell| is_unit(cell));
        // catman writes a line of notes below the units: text in few of the columns.
        let is_note = !are_units && 2 * heading.iter().filter(|cell| !cell.is_empty()).count() <= heading.len();
        if is_note
            && names.iter().all(|cell| !cell.is_empty() && is_unit(cell))
            && let Some(top) = higher.checked_sub(1)
            && alike(top).is_some_and(|cells| values(&cells).0 == 0)
        {
            return Some((top, HeadingPlace { delimiter, is_missing: false, notes: Some(head - top) }));
        }
        let usual = |cells: &[String]| cells.iter().filter(|cell| is_usual_name(cell)).count();
        let (own, above) = (usual(&heading), usual(&names));
        let is_higher = values(&names).0 == 0 && (are_units || above >= own.max(1) || own == 0 && higher == 0);
        at(if is_higher { higher } else { head })
    })
}

fn is_unit(cell: &str) -> bool {
    let bare = cell.trim_matches(['[', ']', '(', ')']).trim();
    bare.is_empty() || bare == "-" || Unit::of(bare).is_some()
}
