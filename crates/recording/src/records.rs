//! Reader of CSV tables with any columns, in the dialects of recordings: every cell as written.

use crate::ahead::Ahead;
use crate::cells::{CellSplitter, ends_empty};
use crate::csv_faults::ragged;
use crate::encoding;
use crate::faults::{Fault, excerpt};
use crate::limits::{Limit, TABLE_COLUMNS_MAX};
use crate::number::{Decimals, finite, with_unit};
use crate::series::Encoding;
use crate::thousands::{Commas, RowKind, Thousands};
use std::io::Read;

/// Rows of a table under its headings, read one after the other in a bounded buffer.
///
/// The headings are the first line with known names, else the first that is neither empty nor a comment (`#`). It determines
/// the delimiter: `;`, else a tab, else `,`, else `|`; a line `sep=;` before it states it. The text is UTF-8, UTF-16 or
/// Windows-1252. Cells without a heading at the end of the lines must be empty; empty rows at the end of the table are no rows.
pub struct Records<R> {
    lines: Ahead<R>,
    cells: CellSplitter,
    headings: Vec<String>,
    decimals: Decimals,
    thousands: Thousands,
    is_utf8: bool,
    commas: Commas,
    is_first: bool,
    /// Empty rows before the current line that are still to be returned, and the line of the first.
    empty: (u64, u64),
}

impl<R: Read> Records<R> {
    /// Reads the headings from the first line; an empty text has none.
    ///
    /// # Errors
    /// Faults of the line of the headings.
    pub fn open(source: R) -> Result<Self, Fault> {
        Self::open_below(source, |_| false)
    }

    /// Reads the headings from the first line that has two known names, or known names in half of its cells; else from the
    /// first line.
    ///
    /// # Errors
    /// Faults of the line of the headings; [`Fault::NotText`].
    pub fn open_below(source: R, is_known: impl Fn(&str) -> bool) -> Result<Self, Fault> {
        let mut records = Self {
            lines: Ahead::new(source),
            cells: CellSplitter::new(b','),
            headings: Vec::new(),
            decimals: Decimals::PointAlways,
            thousands: Thousands::default(),
            is_utf8: true,
            commas: Commas::None,
            is_first: true,
            empty: (0, 0),
        };
        let Some(sign) = records.lines.headings(is_known)? else { return Ok(records) };
        if !records.lines.advance()? {
            return Ok(records);
        }
        if records.lines.line().iter().any(|byte| byte.is_ascii_control() && *byte != b'\t') {
            return Err(Fault::NotText);
        }
        records.cells = CellSplitter::new(sign);
        let mut headings = Vec::new();
        records.read(|heading| headings.push(heading.trim().to_owned()))?;
        Limit::Columns.hold(headings.len() as u64, TABLE_COLUMNS_MAX)?;
        while headings.len() > 1 && headings.last().is_some_and(String::is_empty) {
            let _ = headings.pop();
        }
        records.headings = headings;
        records.decide_commas();
        Ok(records)
    }

    /// Determines from the first row if numbers may have decimal commas: in a comma-separated table they must be quoted.
    fn decide_commas(&mut self) {
        let is_number = |cell: &str| Decimals::is_number(with_unit(cell).map_or(cell, |(number, _)| number));
        let is_quoted = |line: &[u8]| encoding::text(line).split('"').skip(1).step_by(2).any(is_number);
        let delimiter = self.cells.delimiter;
        self.commas = Commas::of(delimiter, delimiter == b',' && self.lines.next().is_some_and(is_quoted));
        self.thousands = Thousands::of(self.commas);
        self.decimals = if self.commas.may_be_decimal() { Decimals::Undecided } else { Decimals::PointAlways };
    }

    /// Skips the line below the headings, which holds units.
    ///
    /// # Errors
    /// As [`Records::advance`].
    pub fn skip_units(&mut self) -> Result<(), Fault> {
        let _ = self.lines.advance()?;
        self.decide_commas();
        Ok(())
    }

    /// Returns the headings without surrounding space.
    pub fn headings(&self) -> &[String] {
        &self.headings
    }

    /// Returns the commas that numbers may have.
    pub const fn commas(&self) -> Commas {
        self.commas
    }

    /// Returns the number of comments below the headings so far.
    pub const fn comments(&self) -> u64 {
        self.lines.comments()
    }

    /// Returns the cells of the line below the current one without surrounding space.
    pub fn below(&mut self) -> Option<Vec<String>> {
        let cells = self.cells.try_all(self.lines.next()?)?;
        Some(cells.iter().map(|cell| encoding::text(cell).trim().to_owned()).collect())
    }

    /// Returns the encoding of the text read so far.
    pub const fn encoding(&self) -> Encoding {
        if self.is_utf8 { self.lines.encoding() } else { Encoding::Windows1252Guessed }
    }

    /// Returns the number of the line of the row, counted from 1; of successive empty rows that of the first.
    pub fn line(&self) -> u64 {
        if self.empty.0 > 0 { self.empty.1 } else { self.lines.number() }
    }

    /// Advances to the next row; returns `false` after the last. After a faulty line, reading continues with the next
    /// one.
    ///
    /// # Errors
    /// [`Fault::LineTooLong`], and errors of the source.
    pub fn advance(&mut self) -> Result<bool, Fault> {
        if self.empty.0 > 0 {
            self.empty.0 -= 1;
            return Ok(true);
        }
        let mut first = 0;
        loop {
            if !self.lines.advance()? {
                self.empty.0 = 0;
                return Ok(false);
            }
            if !self.is_empty() {
                return Ok(true);
            }
            if self.empty.0 == 0 {
                first = self.lines.number();
            }
            self.empty = (self.empty.0 + 1, first);
        }
    }

    /// Returns `true` if the current line holds delimiters alone.
    fn is_empty(&self) -> bool {
        self.lines.line().iter().all(|byte| *byte == self.cells.delimiter || byte.is_ascii_whitespace())
    }

    /// Passes the cells of the row to `put` in order, as many as there are headings.
    ///
    /// # Errors
    /// [`Fault::QuoteOpen`], [`Fault::Ragged`], [`Fault::CommasTwice`].
    pub fn row(&mut self, mut put: impl FnMut(usize, &str)) -> Result<(), Fault> {
        let expected = self.headings.len();
        if self.empty.0 > 0 {
            (0..expected).for_each(|column| put(column, ""));
            return Ok(());
        }
        let line = self.lines.number();
        let is_first = std::mem::take(&mut self.is_first);
        let found = self.cells.count(self.lines.line()).ok_or(Fault::QuoteOpen { line })?;
        let is_padded = found > expected && ends_empty(self.lines.line(), found - expected, self.cells.delimiter);
        if found != expected && !is_padded {
            let may_be_twice = !self.commas.may_be_decimal() && (found == 2 * expected || is_first);
            return Err(ragged(self.lines.line(), (line, found, expected), may_be_twice));
        }
        let mut column = 0;
        self.read(|cell| {
            if column < expected {
                put(column, cell);
            }
            column += 1;
        })
    }

    /// Returns the line of the row as text.
    pub fn text(&self) -> String {
        encoding::text(self.lines.line()).into_owned()
    }

    /// Returns the fault of a column with a heading that `is_used` whose numbers may have separators of thousands:
    /// `998`, `1.002`.
    pub fn thousands(&self, rows: RowKind, is_used: impl Fn(usize) -> bool) -> Option<Fault> {
        let found = self.thousands.possible(rows).find(|found| is_used(found.column))?;
        let column = excerpt(self.headings.get(found.column)?);
        Some(Fault::ThousandsPossible { line: found.place, column, text: found.text.clone() })
    }

    /// Passes each number of the row with its text to `put`, `None` for a cell that is no finite number; as many as there are headings.
    /// Where commas do not separate the cells the numbers may have decimal commas, all or none.
    ///
    /// # Errors
    /// As [`Records::row`].
    pub fn numbers(&mut self, mut put: impl FnMut(usize, Option<f64>, &str)) -> Result<(), Fault> {
        let (line, mut decimals) = (self.lines.number(), self.decimals);
        let mut thousands = std::mem::take(&mut self.thousands);
        let read = self.row(|column, cell| {
            let number = decimals.plain(cell.as_bytes(), line).and_then(|text| finite(&text));
            put(column, number.ok(), cell);
            if decimals != Decimals::PointAlways {
                thousands.note(column, with_unit(cell).map_or(cell, |(number, _)| number), line);
            }
        });
        self.thousands = thousands;
        read?;
        self.decimals = decimals;
        Ok(())
    }

    fn read(&mut self, mut put: impl FnMut(&str)) -> Result<(), Fault> {
        let (line, is_utf8) = (self.lines.number(), &mut self.is_utf8);
        let cells = self.cells.every(self.lines.line()).ok_or(Fault::QuoteOpen { line })?;
        for cell in cells {
            *is_utf8 &= std::str::from_utf8(cell).is_ok();
            put(&encoding::text(cell));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::LINE_BYTES_MAX;

    type Rows = Vec<Result<Vec<String>, Fault>>;

    fn all(source: &[u8]) -> (Vec<String>, Rows, Encoding) {
        let mut records = Records::open(source).unwrap();
        let mut rows = Vec::new();
        loop {
            match records.advance() {
                Ok(false) => break,
                Ok(true) => {
                    let mut cells = Vec::new();
                    let row = records.row(|_, cell| cells.push(cell.to_owned()));
                    rows.push(row.map(|()| cells));
                }
                Err(fault) => rows.push(Err(fault)),
            }
        }
        (records.headings().to_vec(), rows, records.encoding())
    }

    /// A table is read alike in all dialects: delimiters, line endings, encodings, quotes, with and without a line that
    /// states the delimiter.
    #[test]
    fn a_table_is_read_alike_in_every_dialect() {
        let table = [["Drehmoment [N·m]", "Größe", "c"], ["0,5", "3 µm; b", ""], ["-1,25e3", "say \"so\"", "x"]];
        for sign in [';', '\t', ','] {
            for end in ["\n", "\r\n", "\r"] {
                for (is_quoted, says) in [(false, false), (true, false), (true, true)] {
                    let cell = |cell: &&str| {
                        if is_quoted || cell.contains([sign, '"', ',', ';']) {
                            format!("\"{}\"", cell.replace('"', "\"\""))
                        } else {
                            (*cell).to_owned()
                        }
                    };
                    let line = |row: &[&str; 3]| row.iter().map(cell).collect::<Vec<_>>().join(&sign.to_string());
                    let mut text = if says { format!("sep={sign}{end}") } else { String::new() };
                    text.push_str(&format!("# logged{end}{end}"));
                    for row in &table {
                        text.push_str(&line(row));
                        text.push_str(end);
                    }
                    let utf16: Vec<u8> =
                        "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
                    let windows: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
                    for (bytes, encoding) in [
                        (text.as_bytes(), Encoding::Utf8),
                        (utf16.as_slice(), Encoding::Utf16),
                        (windows.as_slice(), Encoding::Windows1252Guessed),
                    ] {
                        let context = format!("{sign:?} {end:?} {is_quoted} {says} {encoding:?}");
                        let (headings, rows, found) = all(bytes);
                        assert_eq!(
                            (headings.as_slice(), found),
                            (&table[0].map(str::to_owned)[..], encoding),
                            "{context}"
                        );
                        let expected: Vec<_> =
                            table[1..].iter().map(|row| Ok(row.map(str::to_owned).to_vec())).collect();
                        assert_eq!(rows, expected, "{context}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_wrong_line_is_reported_and_those_behind_it_are_read() {
        let long = "x".repeat(3 * LINE_BYTES_MAX);
        let text = format!("a;b\n1;2\n\n3\n4;\"5\n{long}\n6;\n{long}");
        let (_, rows, _) = all(text.as_bytes());
        let row = |cells: [&str; 2]| Ok(cells.map(str::to_owned).to_vec());
        let expected = [
            row(["1", "2"]),
            Err(Fault::Ragged { line: 4, found: 1, expected: 2 }),
            Err(Fault::QuoteOpen { line: 5 }),
            Err(Fault::LineTooLong { line: 6, most: LINE_BYTES_MAX }),
            row(["6", ""]),
            Err(Fault::LineTooLong { line: 8, most: LINE_BYTES_MAX }),
        ];
        assert_eq!(rows, expected);
        assert!(Records::open(&b""[..]).unwrap().headings().is_empty());
        assert!(Records::open(&b"sep=;\n"[..]).unwrap().headings().is_empty());
    }

    /// Lines about the file stand above the known names; bytes that are no text are not returned as headings.
    #[test]
    fn headings_are_the_first_line_with_known_names() {
        fn open(text: &str) -> Records<&[u8]> {
            Records::open_below(text.as_bytes(), |cell| ["a", "b"].contains(&cell)).unwrap()
        }
        for text in ["Study 7\nby;me\n\na;b\n1,5;2\n", "sep=;\nStudy, 7\na;b;;\n1,5;2;;\n", "x\ty\na\tb\n1,5\t2\n"] {
            let mut records = open(text);
            assert_eq!(records.headings(), ["a", "b"], "{text}");
            assert_eq!(records.below().unwrap()[..2], ["1,5", "2"], "{text}");
            assert!(records.advance().unwrap() && records.commas().may_be_decimal());
            let mut cells = Vec::new();
            records.row(|_, cell| cells.push(cell.to_owned())).unwrap();
            assert_eq!(cells, ["1,5", "2"], "{text}");
            assert!(!records.advance().unwrap(), "{text}");
        }
        assert_eq!(open("c;d\n1;2\n").headings(), ["c", "d"]);
        for bytes in [&b"ab\x01c\n1,2\n"[..], &b"\x00\x00\x00\x01"[..]] {
            assert!(matches!(Records::open(bytes), Err(Fault::NotText)), "{bytes:?}");
        }
    }

    /// Cells behind the last heading are padding if they are empty, and so are empty rows at the end; an empty row between
    /// others is a row.
    #[test]
    fn padding_is_no_content() {
        let (headings, rows, _) = all(b"a;b;;\n1;2;;\n;;;\n;\n3;4\n5;6; ;\n;;;\n;;;\n");
        let row = |cells: [&str; 2]| Ok(cells.map(str::to_owned).to_vec());
        assert_eq!(headings, ["a", "b"]);
        assert_eq!(rows, [row(["1", "2"]), row(["", ""]), row(["", ""]), row(["3", "4"]), row(["5", "6"])]);
        let (_, rows, _) = all(b"a;b;\n1;2;x\n1\n");
        let ragged = |line, found| Err(Fault::Ragged { line, found, expected: 2 });
        assert_eq!(rows, [ragged(2, 3), ragged(3, 1)]);
        let (_, rows, _) = all(b"a,b\n0,5,5,0\n1,2\n");
        assert_eq!(rows, [Err(Fault::CommasTwice { line: 2, found: 4, expected: 2 }), row(["1", "2"])]);
    }

    /// Numbers of one table have one decimal sign, and what is no finite number is none.
    #[test]
    fn numbers_are_read_with_either_decimal_sign() {
        type Numbers = Vec<(u64, Vec<Option<f64>>)>;
        let numbers = |text: &str| -> Numbers {
            let mut records = Records::open(text.as_bytes()).unwrap();
            let mut rows = Vec::new();
            while records.advance().unwrap() {
                let mut row = Vec::new();
                records.numbers(|_, number, _| row.push(number)).unwrap();
                rows.push((records.line(), row));
            }
            rows
        };
        let expected = vec![(3, vec![Some(0.5), Some(-1250.0)]), (4, vec![None, Some(3.0)])];
        assert_eq!(numbers("# run\na,b\n0.5, -1.25e3\nx,3\n"), expected);
        assert_eq!(numbers("# run\na;b\n0,5;-1,25e3\n;3\n"), expected);
        assert_eq!(numbers("# run\na\tb\n0.5\t-1.25e3\nNaN\t3\n"), expected);
        // A single column, in which no comma can separate cells.
        assert_eq!(numbers("a\n0,5\n2\n"), [(2, vec![Some(0.5)]), (3, vec![Some(2.0)])]);
        // A point behind commas may separate thousands.
        assert_eq!(numbers("a;b\n0,5;1.234\n1e999;\n"), [(2, vec![Some(0.5), None]), (3, vec![None, None])]);
    }
}
