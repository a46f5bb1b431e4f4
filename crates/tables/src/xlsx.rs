//! A whole workbook.

mod cover;
mod sheet;
mod style;

use crate::error::WriteError;
use crate::table::Table;
use crate::words::t;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Workbook, Worksheet};
use sheet::Links;
use style::Styles;
use workbench::{Candidate, Language, Project};

/// Most rows of a table on a sheet; a longer one is named on the first sheet and left to the other formats. A choice
/// of this crate that keeps a workbook light; a sheet itself could hold 2²⁰.
pub const SHEET_ROWS_MOST: usize = 200_000;

/// What stands on the first sheet beside the tables.
#[derive(Clone, Copy, Debug)]
pub struct Front<'a> {
    /// Name of the project file.
    pub file: &'a str,
    /// Its revision, if one is stated.
    pub revision: Option<&'a str>,
    /// The date, if one is stated; the clock is never asked.
    pub date: Option<&'a str>,
    /// The axis.
    pub project: &'a Project,
    /// The actuator that the tables are about.
    pub chosen: &'a Candidate<'a>,
    /// Language of the words.
    pub language: Language,
}

/// A workbook with a first sheet, a sheet for each table and one that tells what every column means.
///
/// Utilisations, margins and the effective torque of the course are live formulas. The same tables give the same bytes.
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
    for table in tables.iter().filter(|table| table.rows.len() <= SHEET_ROWS_MOST) {
        workbook.push_worksheet(sheet::sheet(table, &links, &styles, language)?);
    }
    workbook.push_worksheet(meanings(tables, &styles, language)?);
    Ok(workbook.save_to_buffer()?)
}

/// The clock is not asked: the file is as old as its format.
fn properties(front: &Front<'_>) -> Result<DocProperties, WriteError> {
    let title = if front.project.name.is_empty() { front.file } else { &front.project.name };
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?.and_hms(0, 0, 0)?;
    Ok(DocProperties::new()
        .set_title(title)
        .set_subject(front.chosen.id.to_string())
        .set_author("antrieb")
        .set_creation_datetime(&created))
}

/// What every column means, with its name in data exchange.
fn meanings(tables: &[Table], styles: &Styles, language: Language) -> Result<Worksheet, WriteError> {
    let mut sheet = Worksheet::new();
    sheet.set_name(t(language, ["Columns", "Spalten"]))?;
    let heads = [
        ["sheet", "Blatt"],
        ["heading", "Überschrift"],
        ["name in CSV, JSON, Parquet", "Name in CSV, JSON, Parquet"],
        ["unit", "Einheit"],
        ["meaning and source", "Bedeutung und Quelle"],
    ];
    for ((column, head), width) in (0_u16..).zip(heads).zip([16.0, 30.0, 30.0, 12.0, 90.0]) {
        sheet.write_string_with_format(0, column, t(language, head), &styles.head)?;
        sheet.set_column_width(column, width)?;
    }
    let columns = tables.iter().flat_map(|table| table.columns.iter().map(move |column| (table, column)));
    for (row, (table, column)) in (1_u32..).zip(columns) {
        let name = format!("{}.{}", table.name, column.name);
        let unit = column.unit.map_or("", |unit| unit.symbol);
        for (at, text) in (0_u16..).zip([&table.title, &column.title, &name, unit, &column.about]) {
            sheet.write_string_with_format(row, at, text, &styles.text)?;
        }
    }
    sheet.set_freeze_panes(1, 0)?;
    page(&mut sheet);
    Ok(sheet)
}

/// A4 across, one page wide, the head on every page.
fn page(sheet: &mut Worksheet) {
    sheet.set_paper_size(9).set_landscape().set_print_fit_to_pages(1, 0);
}
