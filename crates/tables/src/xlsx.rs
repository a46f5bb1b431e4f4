//! A whole workbook.

mod charts;
mod cover;
mod sheet;
mod style;

use crate::error::WriteError;
use crate::format;
use crate::table::Table;

use project::Project;
use quantities::Language;
use questions::Candidate;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Workbook, Worksheet};
use sheet::Links;
use style::Styles;
use words::{Word, capitalised, tables, terms};

/// Largest number of rows of a table on a sheet; a longer one is named on the first sheet and left to the other
/// formats. A choice of this crate that keeps a workbook small; a sheet could hold 2²⁰.
pub const SHEET_ROWS_MOST: usize = 200_000;

/// Content of the first sheet in addition to the tables.
#[derive(Clone, Copy, Debug)]
pub struct Front<'a> {
    /// Name of the project file.
    pub file: &'a str,
    /// Revision of the project, if stated.
    pub revision: Option<&'a str>,
    /// Date, if stated; the clock is not used.
    pub date: Option<&'a str>,
    /// Axis.
    pub project: &'a Project,
    /// Actuator of the tables.
    pub chosen: &'a Candidate<'a>,
    /// Language of the words.
    pub language: Language,
}

/// Writes a workbook with a first sheet, a sheet for each table and one with the meaning of every column.
///
/// Utilisations, margins and the effective torque of the course are live formulas. Equal tables give equal bytes.
///
/// # Errors
/// [`WriteError::Workbook`] if the library refuses.
pub fn xlsx(tables: &[Table], front: &Front<'_>) -> Result<Vec<u8>, WriteError> {
    let language = front.language;
    let styles = Styles::new();
    let links = Links::of(tables);
    let mut workbook = Workbook::new();
    workbook.set_properties(&properties(front)?);
    let cover = cover::sheet(tables, front, &styles)?;
    workbook.push_worksheet(cover);
    for table in tables.iter().filter(|table| format::Format::Workbook.holds(table)) {
        workbook.push_worksheet(sheet::sheet(table, &links, &styles, language)?);
    }
    if let Some(charts) = charts::sheet(tables, &front.chosen.id.to_string(), language)? {
        workbook.push_worksheet(charts);
    }
    workbook.push_worksheet(meanings(tables, &styles, language)?);
    Ok(workbook.save_to_buffer()?)
}

/// Returns the document properties, with a fixed date of creation instead of the clock.
fn properties(front: &Front<'_>) -> Result<DocProperties, WriteError> {
    let title = if front.project.name.is_empty() { front.file } else { &front.project.name };
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?.and_hms(0, 0, 0)?;
    Ok(DocProperties::new()
        .set_title(title)
        .set_subject(front.chosen.id.to_string())
        .set_author("antrieb")
        .set_creation_datetime(&created))
}

/// Writes the sheet with the meaning of every column and its name in data exchange.
fn meanings(tables: &[Table], styles: &Styles, language: Language) -> Result<Worksheet, WriteError> {
    let mut sheet = Worksheet::new();
    sheet.set_name(capitalised(terms::columns(language)))?;
    let heads: [Word; 5] =
        [tables::sheet, tables::heading, tables::name_in_csv_json_parquet, terms::unit, tables::meaning_and_source];
    let widths = [16.0, 30.0, 30.0, 12.0, 60.0];
    for ((column, head), width) in (0_u16..).zip(heads).zip(widths) {
        sheet.write_string_with_format(0, column, head(language), &styles.head)?;
        sheet.set_column_width(column, width)?;
    }
    let columns = tables.iter().flat_map(|table| table.columns.iter().map(move |column| (table, column)));
    for (row, (table, column)) in (1_u32..).zip(columns) {
        let name = format!("{}.{}", table.name, column.name);
        let unit = column.unit.map(|unit| unit.symbol_in(language)).filter(|symbol| *symbol != "1").unwrap_or_default();
        let texts = [&table.title, &column.title, &name, unit, &column.about];
        for (at, text) in (0_u16..).zip(texts) {
            sheet.write_string_with_format(row, at, text, &styles.text)?;
        }
        let most = texts.iter().zip(widths).map(|(text, wide)| lines(text, wide)).max();
        sheet.set_row_height(row, height(most.unwrap_or(1)))?;
    }
    sheet.set_freeze_panes(1, 0)?;
    Paper::for_width(widths.iter().sum()).set(&mut sheet);
    Ok(sheet)
}

/// Estimates the number of lines of a text in a column width, rather high than low: a surplus line is empty, a missing
/// one is cut off.
fn lines(text: &str, characters: f64) -> u32 {
    let mut lines = 0;
    for paragraph in text.split('\n') {
        let (mut used, mut rows) = (0.0, 1);
        for word in paragraph.split(' ') {
            #[allow(clippy::cast_precision_loss, reason = "the length of a word")]
            let long = word.chars().count() as f64 * 1.08;
            let space = if used > 0.0 { 1.0 } else { 0.0 };
            if used + space + long <= characters {
                used += space + long;
            } else {
                rows += u32::from(used > 0.0);
                // A word longer than the column is broken.
                let mut rest = long;
                while rest > characters {
                    rest -= characters;
                    rows += 1;
                }
                used = rest;
            }
        }
        lines += rows;
    }
    lines
}

/// Returns the height of a row of `lines` lines in points; the limit of a sheet is 409.
fn height(lines: u32) -> f64 {
    (f64::from(lines) * 15.0).min(409.0)
}

/// Paper of a printed sheet, landscape, with the heading on every page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Paper {
    /// Size of the paper.
    size: Size,
    /// Number of pages beside each other.
    pages: u16,
}

/// Size of a paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    A4,
    /// For sheets illegible on A4.
    A3,
}

/// Characters of all columns that A4 and A3 hold at a scale of sixty per cent, below which letters are hard to read.
const CHARACTERS: [f64; 2] = [240.0, 340.0];

impl Paper {
    /// One page of A4.
    const A4: Self = Self { size: Size::A4, pages: 1 };

    /// Returns the smallest paper on which columns of this total width in characters stay legible, A3 on as many pages as
    /// that takes.
    fn for_width(characters: f64) -> Self {
        let [a4, a3] = CHARACTERS;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
        let pages = (characters / a3).ceil().clamp(1.0, 20.0) as u16;
        if characters <= a4 { Self::A4 } else { Self { size: Size::A3, pages } }
    }

    fn set(self, sheet: &mut Worksheet) {
        let number = match self.size {
            Size::A4 => 9,
            Size::A3 => 8,
        };
        sheet.set_paper_size(number).set_landscape().set_print_fit_to_pages(self.pages, 0);
        sheet.set_margins(0.4, 0.4, 0.5, 0.5, 0.3, 0.3);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_takes_the_lines_that_its_words_need() {
        assert_eq!(lines("", 10.0), 1);
        assert_eq!(lines("one two", 10.0), 1);
        assert_eq!(lines("one two three four", 12.0), 2);
        assert_eq!(lines("a\nb", 10.0), 2);
        assert_eq!(lines(&"x".repeat(25), 10.0), 3);
    }
}
