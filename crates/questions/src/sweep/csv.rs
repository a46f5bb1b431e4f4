//! Tables in CSV: a line for each row, commas, cells in quotation marks where they hold a comma.

use project::{Fault, TabularFault};
use quantities::Language;
use std::borrow::Cow;
use std::io::{self, BufRead, Read as _};

/// Longest line of a table in bytes.
const LINE_MOST: usize = 1 << 20;

/// The rows of a table, some at a time.
pub struct Lines<R> {
    source: R,
    headings: Vec<String>,
    /// That of the line that was read last, counted from one.
    line: u64,
    /// What is wrong with the line behind the rows that were handed out.
    wrong: Option<TabularFault>,
}

/// Why there are no rows.
#[derive(Debug)]
pub enum Broken {
    /// The line of a row is wrong; the next rows are behind it.
    Line(TabularFault),
    /// The table is not read further.
    Unread(io::Error),
}

impl Broken {
    /// In one sentence.
    #[must_use]
    pub fn text(&self, language: Language) -> String {
        match self {
            Self::Line(fault) => words::fault_text(&Fault::Tabular(fault.clone()), language),
            Self::Unread(error) => words::file_trouble(error, language),
        }
    }
}

/// The cells of some rows, by columns; `None` where a cell is empty.
pub type Columns = Vec<Vec<Option<String>>>;

impl<R: BufRead> Lines<R> {
    /// Reads the headings.
    ///
    /// # Errors
    /// Where their line is wrong, or not read.
    pub fn open(source: R) -> Result<Self, Broken> {
        let mut lines = Self { source, headings: Vec::new(), line: 0, wrong: None };
        let head = lines.next()?.unwrap_or_default();
        let heads = cells(head.trim_start_matches('\u{feff}')).filter(|_| !head.is_empty());
        if heads.is_none() && !head.is_empty() {
            return Err(Broken::Line(TabularFault::OpenQuote { line: lines.line }));
        }
        lines.headings = heads.unwrap_or_default().iter().map(|name| name.trim().to_owned()).collect();
        Ok(lines)
    }

    /// The headings.
    pub fn headings(&self) -> &[String] {
        &self.headings
    }

    /// Leaves rows out.
    ///
    /// # Errors
    /// Where a line of them is wrong, or not read.
    pub fn skip(&mut self, rows: u64) -> Result<(), Broken> {
        for _ in 0..rows {
            if self.next()?.is_none() {
                break;
            }
        }
        Ok(())
    }

    /// The next rows, at most so many; `None` behind the last.
    ///
    /// # Errors
    /// Where the next line is wrong, or not read.
    pub fn rows(&mut self, most: usize) -> Result<Option<Columns>, Broken> {
        if let Some(wrong) = self.wrong.take() {
            return Err(Broken::Line(wrong));
        }
        let mut columns: Columns = vec![Vec::new(); self.headings.len()];
        for count in 0..most {
            match self.row(&mut columns) {
                Ok(true) => {}
                Ok(false) if count == 0 => return Ok(None),
                Ok(false) => break,
                Err(Broken::Line(wrong)) if count > 0 => {
                    self.wrong = Some(wrong);
                    break;
                }
                Err(broken) => return Err(broken),
            }
        }
        Ok(Some(columns))
    }

    /// Adds the cells of the next row, where there is one.
    fn row(&mut self, columns: &mut Columns) -> Result<bool, Broken> {
        let Some(text) = self.next()? else { return Ok(false) };
        let line = self.line;
        let cells = cells(&text).ok_or(Broken::Line(TabularFault::OpenQuote { line }))?;
        let (found, expected) = (cells.len(), columns.len());
        if found != expected {
            return Err(Broken::Line(TabularFault::Ragged { line, found, expected }));
        }
        let cell = |cell: Cow<'_, str>| Some(cell.into_owned()).filter(|cell| !cell.is_empty());
        columns.iter_mut().zip(cells).for_each(|(column, text)| column.push(cell(text)));
        Ok(true)
    }

    /// The next line that is not empty.
    fn next(&mut self) -> Result<Option<String>, Broken> {
        loop {
            let mut bytes = Vec::new();
            let most = LINE_MOST as u64 + 1;
            self.line += 1;
            let line = self.line;
            let read = self.source.by_ref().take(most).read_until(b'\n', &mut bytes).map_err(Broken::Unread)?;
            if read == 0 {
                return Ok(None);
            }
            if bytes.len() > LINE_MOST {
                if bytes.last() != Some(&b'\n') {
                    self.source.skip_until(b'\n').map_err(Broken::Unread)?;
                }
                return Err(Broken::Line(TabularFault::LongLine { line, most: LINE_MOST }));
            }
            while bytes.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) {
                bytes.pop();
            }
            let text = String::from_utf8(bytes).map_err(|_| Broken::Line(TabularFault::NotUtf8 { line }))?;
            if !text.trim().is_empty() {
                return Ok(Some(text));
            }
        }
    }
}

/// The cells of a line without its end; `None` where a quoted cell does not end.
#[must_use]
pub fn cells(line: &str) -> Option<Vec<Cow<'_, str>>> {
    let mut cells = Vec::new();
    let mut rest = line;
    loop {
        let (cell, behind) = match rest.strip_prefix('"') {
            None => {
                let (cell, behind) = rest.split_once(',').map_or((rest, None), |(cell, behind)| (cell, Some(behind)));
                (Cow::Borrowed(cell), behind)
            }
            Some(quoted) => {
                let end = end_of_quoted(quoted)?;
                let cell = quoted.get(..end)?.replace("\"\"", "\"");
                let behind = quoted.get(end + 1..)?;
                // What stands between the quotation mark and the comma belongs to no cell.
                (Cow::Owned(cell), behind.split_once(',').map(|(_, behind)| behind))
            }
        };
        cells.push(cell);
        match behind {
            Some(behind) => rest = behind,
            None => return Some(cells),
        }
    }
}

/// Where a quoted cell ends: at a quotation mark that is not doubled.
fn end_of_quoted(quoted: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let at = from + quoted.get(from..)?.find('"')?;
        if quoted.get(at + 1..)?.starts_with('"') {
            from = at + 2;
        } else {
            return Some(at);
        }
    }
}

/// A field (RFC 4180): in quotation marks where it holds a comma, a quotation mark or the end of a line.
#[must_use]
pub fn quoted(field: &str) -> Cow<'_, str> {
    if field.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", field.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(field)
    }
}

/// A cell as it is written in a line, whose end it may not hold.
#[must_use]
pub fn written(cell: &str) -> Cow<'_, str> {
    let cell = quoted(cell);
    if cell.contains(['\n', '\r']) { Cow::Owned(cell.replace(['\n', '\r'], " ")) } else { cell }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_read_as_they_are_written() {
        for row in [vec!["a", "", "b c"], vec!["1,5", "say \"so\"", ""], vec![""], vec!["\"", ",", "x"]] {
            let line: Vec<_> = row.iter().map(|cell| written(cell)).collect();
            assert_eq!(cells(&line.join(",")).unwrap(), row);
        }
        assert_eq!(cells("a,\"open"), None);
        assert_eq!(cells("\"a\" ,b").unwrap(), ["a", "b"]);
    }

    #[test]
    fn a_wrong_line_is_reported_and_those_behind_it_are_read() {
        let long = "x".repeat(LINE_MOST + 5);
        let table = [b"a,b\n1,2\n\n3\n4,\"5\n".as_slice(), b"\xff,1\n", long.as_bytes(), b"\n6,\n"].concat();
        let mut lines = Lines::open(table.as_slice()).unwrap();
        assert_eq!(lines.headings(), ["a", "b"]);
        let (mut rows, mut wrong) = (Vec::new(), Vec::new());
        loop {
            match lines.rows(10) {
                Ok(None) => break,
                Ok(Some(columns)) => rows.push(columns),
                Err(Broken::Line(fault)) => wrong.push(fault),
                Err(Broken::Unread(error)) => panic!("{error}"),
            }
        }
        let cells = |cells: &[&str]| cells.iter().map(|cell| Some((*cell).to_owned())).collect::<Vec<_>>();
        assert_eq!(rows, [vec![cells(&["1"]), cells(&["2"])], vec![cells(&["6"]), vec![None]]]);
        assert_eq!(
            wrong,
            [
                TabularFault::Ragged { line: 4, found: 1, expected: 2 },
                TabularFault::OpenQuote { line: 5 },
                TabularFault::NotUtf8 { line: 6 },
                TabularFault::LongLine { line: 7, most: LINE_MOST },
            ]
        );
        assert!(Lines::open("".as_bytes()).unwrap().headings().is_empty());
    }
}
