//! Tables in CSV: a line for each row, read in the dialects of recordings, written with commas.

use super::CODE;
use project::{Counted, Fault, Heading, TabularFault};
use quantities::{Language, Unit};
use recording::{Commas, Records};
use std::borrow::Cow;
use std::io::Read;

/// Reader of the rows of a table, some at a time.
pub struct Lines<R> {
    records: Records<R>,
    /// Headings with the units that the rows state.
    headings: Vec<String>,
    /// Units of the columns in which every cell states its own.
    of_cells: Vec<Option<&'static Unit>>,
    /// Fault of the line after the rows already returned.
    wrong: Option<TabularFault>,
}

/// Reasons why there are no rows.
#[derive(Debug)]
pub enum Broken {
    /// The line of a row is invalid; further rows follow it.
    Line(TabularFault),
    /// The table cannot be read further.
    Unread(recording::Fault),
}

impl Broken {
    /// Returns the reason in one sentence.
    #[must_use]
    pub fn text(&self, language: Language) -> String {
        match self {
            Self::Line(fault) => words::fault_text(&Fault::Tabular(fault.clone()), language),
            Self::Unread(fault @ recording::Fault::ReadFailed { .. }) => words::recording_text(fault, language),
            Self::Unread(fault) => words::table_text(fault, language),
        }
    }
}

impl From<recording::Fault> for Broken {
    fn from(fault: recording::Fault) -> Self {
        match fault {
            recording::Fault::LineTooLong { line, most } => Self::Line(TabularFault::LongLine { line, most }),
            recording::Fault::QuoteOpen { line } => Self::Line(TabularFault::OpenQuote { line }),
            recording::Fault::Ragged { line, found, expected } => {
                Self::Line(TabularFault::Ragged { line, found, expected })
            }
            recording::Fault::CommasTwice { line, found, expected } => {
                Self::Line(TabularFault::CommasTwice { line, found, expected })
            }
            other => Self::Unread(other),
        }
    }
}

/// Cells of some rows, by columns; `None` for an empty cell.
pub type Columns = Vec<Vec<Option<String>>>;

impl<R: Read> Lines<R> {
    /// Reads the headings: the first line with keys, else the first line. The unit of a key that its heading lacks is that of a
    /// row of units below, or of the cell in the first row.
    ///
    /// # Errors
    /// If their line is invalid or cannot be read.
    pub fn open(source: R) -> Result<Self, Broken> {
        let mut records = Records::open_below(source, |cell| cell == CODE || Heading::is_one(cell))?;
        let (headings, of_cells) = with_units(&mut records)?;
        Ok(Self { records, headings, of_cells, wrong: None })
    }

    /// Returns the headings, each with the unit of its numbers.
    pub fn headings(&self) -> &[String] {
        &self.headings
    }

    /// Returns the number of comments below the headings so far.
    pub const fn comments(&self) -> u64 {
        self.records.comments()
    }

    /// Returns the commas that numbers may have.
    pub const fn commas(&self) -> Commas {
        self.records.commas()
    }

    /// Skips rows.
    ///
    /// # Errors
    /// If one of their lines is invalid or cannot be read.
    pub fn skip(&mut self, rows: u64) -> Result<(), Broken> {
        for _ in 0..rows {
            if !self.records.advance()? {
                break;
            }
        }
        Ok(())
    }

    /// Returns the next rows, at most `most`; `None` after the last.
    ///
    /// # Errors
    /// If the next line is invalid or cannot be read.
    pub fn rows(&mut self, most: usize) -> Result<Option<Columns>, Broken> {
        if let Some(wrong) = self.wrong.take() {
            return Err(Broken::Line(wrong));
        }
        let mut columns: Columns = vec![Vec::new(); self.headings().len()];
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

    /// Adds the cells of the next row, if there is one.
    fn row(&mut self, columns: &mut Columns) -> Result<bool, Broken> {
        if !self.records.advance()? {
            return Ok(false);
        }
        let mut wrong = None;
        self.records.row(|place, cell| {
            if let Some(Some(unit)) = self.of_cells.get(place)
                && !cell.trim().is_empty()
                && recording::with_unit(cell).is_none()
            {
                let heading = self.headings.get(place).map(|heading| recording::name_and_unit(heading).0);
                let (path, written) = (heading.unwrap_or_default(), cell.trim().chars().take(60).collect());
                wrong = Some(TabularFault::UnitOfCell { path, written, unit });
            }
            if let Some(column) = columns.get_mut(place) {
                column.push(Some(cell.to_owned()).filter(|cell| !cell.is_empty()));
            }
        })?;
        let Some(wrong) = wrong else { return Ok(true) };
        columns.iter_mut().for_each(|column| drop(column.pop()));
        Err(Broken::Line(wrong))
    }
}

/// Headings, and the units of the columns in which every cell states its own.
type WithUnits = (Vec<String>, Vec<Option<&'static Unit>>);

/// Returns the headings of a table with the units that the line below them states; a row of units is skipped.
fn with_units<R: Read>(records: &mut Records<R>) -> Result<WithUnits, Broken> {
    let mut headings = records.headings().to_vec();
    let mut of_cells = vec![None; headings.len()];
    let lacking: Vec<_> = headings.iter().map(|heading| Heading::lacks_unit_of(heading)).collect();
    if lacking.iter().all(Option::is_none) {
        return Ok((headings, of_cells));
    }
    let below = records.below().unwrap_or_default();
    let units: Vec<&str> = below.iter().map(|cell| unbracketed(cell)).collect();
    // The unit of a heading is repeated, or left out.
    let agrees = |(heading, unit): (&String, &&str)| {
        if unit.is_empty() || *unit == "-" {
            return true;
        }
        let Some(unit) = Unit::of(unit).map(|_| *unit) else { return false };
        match Heading::read(heading, Counted::FromOne, None) {
            Ok(Heading { unit: Some(own), .. }) => Unit::of_dimension(own.dimension, unit) == Some(own),
            Ok(_) => false,
            Err(_) => true,
        }
    };
    let states = |(lacks, unit): (&Option<_>, &&str)| lacks.is_some() && Unit::of(unit).is_some();
    let is_row_of_units = headings.iter().zip(&units).all(agrees) && lacking.iter().zip(&units).any(states);
    if is_row_of_units {
        records.skip_units()?;
    }
    let columns = headings.iter_mut().zip(&mut of_cells).zip(&lacking).zip(&below);
    for (((heading, of_cell), lacks), cell) in columns {
        let unit = if is_row_of_units {
            Some(unbracketed(cell)).filter(|unit| Unit::of(unit).is_some())
        } else {
            recording::with_unit(cell).map(|(_, unit)| unit)
        };
        if let Some((unit, dimensions)) = unit.zip(lacks.as_ref()) {
            *heading = format!("{heading} [{unit}]");
            if !is_row_of_units {
                *of_cell = dimensions.iter().find_map(|dimension| Unit::of_dimension(*dimension, unit));
            }
        }
    }
    Ok((headings, of_cells))
}

/// Returns a unit without its brackets.
fn unbracketed(cell: &str) -> &str {
    let inner =
        [('[', ']'), ('(', ')')].iter().find_map(|(open, close)| cell.strip_prefix(*open)?.strip_suffix(*close));
    inner.unwrap_or(cell).trim()
}

/// Formats a field (RFC 4180): in quotation marks if it contains a comma, a quotation mark or a line break.
#[must_use]
pub fn quoted(field: &str) -> Cow<'_, str> {
    quoted_between(field, ',')
}

fn quoted_between(field: &str, separator: char) -> Cow<'_, str> {
    if field.contains([separator, '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", field.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(field)
    }
}

/// Formats a cell for a line; line breaks become spaces.
#[must_use]
pub fn written(cell: &str) -> Cow<'_, str> {
    written_between(cell, ',')
}

/// Formats a cell for a line with a sign between its cells; line breaks become spaces.
#[must_use]
pub fn written_between(cell: &str, separator: char) -> Cow<'_, str> {
    let cell = quoted_between(cell, separator);
    if cell.contains(['\n', '\r']) { Cow::Owned(cell.replace(['\n', '\r'], " ")) } else { cell }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_read_as_they_are_written() {
        for row in [vec!["a", "", "b c"], vec!["1,5", "say \"so\"", ""], vec!["\"", ",", "x"], vec!["1;2", "\t", "z"]] {
            let line: Vec<_> = row.iter().map(|cell| written(cell)).collect();
            let text = format!("a,b,c\n{}\n", line.join(","));
            let found = Lines::open(text.as_bytes()).unwrap().rows(9).unwrap().unwrap();
            let cells: Vec<&str> = found.iter().map(|column| column[0].as_deref().unwrap_or_default()).collect();
            assert_eq!(cells, row);
        }
    }

    #[test]
    fn a_wrong_line_is_reported_and_those_behind_it_are_read() {
        let long = "x".repeat(recording::LINE_BYTES_MAX + 5);
        let table = format!("a,b\n1,2\n\n3\n4,\"5\n{long}\n6,\n");
        let mut lines = Lines::open(table.as_bytes()).unwrap();
        assert_eq!(lines.headings(), ["a", "b"]);
        let (mut rows, mut wrong) = (Vec::new(), Vec::new());
        loop {
            match lines.rows(10) {
                Ok(None) => break,
                Ok(Some(columns)) => rows.push(columns),
                Err(Broken::Line(fault)) => wrong.push(fault),
                Err(Broken::Unread(fault)) => panic!("{fault:?}"),
            }
        }
        let cells = |cells: &[&str]| cells.iter().map(|cell| Some((*cell).to_owned())).collect::<Vec<_>>();
        assert_eq!(rows, [vec![cells(&["1"]), cells(&["2"])], vec![cells(&["6"]), vec![None]]]);
        assert_eq!(
            wrong,
            [
                TabularFault::Ragged { line: 4, found: 1, expected: 2 },
                TabularFault::OpenQuote { line: 5 },
                TabularFault::LongLine { line: 6, most: recording::LINE_BYTES_MAX },
            ]
        );
        assert!(Lines::open("".as_bytes()).unwrap().headings().is_empty());
    }
}
