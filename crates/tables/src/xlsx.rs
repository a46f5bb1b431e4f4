//! A whole workbook.

mod charts;
pub(crate) mod cover;
mod paper;
mod sheet;
mod style;

use crate::error::WriteError;
use crate::format;
use crate::table::Table;
use cover::Front;
use paper::{Paper, height, lines};
use quantities::Language;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Workbook, Worksheet};
use sheet::Links;
use style::Styles;
use words::{Word, capitalised, tables, terms};

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
