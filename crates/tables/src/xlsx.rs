//! A whole workbook.

mod charts;
pub(crate) mod cover;
mod overall;
mod paper;
mod sheet;
mod style;

use crate::error::WriteError;
use crate::format;
use crate::table::{Column, Table};
use cover::Front;
pub use overall::AxisSheets;
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
    let mut workbook = Workbook::new();
    let title = if front.project.name.is_empty() { front.file } else { &front.project.name };
    workbook.set_properties(&document(title, &front.chosen.id.to_string())?);
    for sheet in of_axis(tables, front, [tables::overview(language), tables::charts(language)], &styles)? {
        workbook.push_worksheet(sheet);
    }
    workbook.push_worksheet(meanings(&columns(tables, language), &styles, language)?);
    Ok(workbook.save_to_buffer()?)
}

/// Writes a workbook of several axes: a sheet with a row for each, the sheets of a workbook of each one with its name in their
/// titles, and one with the meaning of every column. The workbook of a single axis is that of [`xlsx`].
///
/// # Errors
/// [`WriteError::Workbook`] if the library refuses.
pub fn xlsx_of_axes(mut axes: Vec<AxisSheets<'_>>, language: Language) -> Result<Vec<u8>, WriteError> {
    if let [one] = &axes[..] {
        return xlsx(&one.tables, &one.front);
    }
    let styles = Styles::new();
    let mut workbook = Workbook::new();
    let codes: Vec<String> = axes.iter().map(|axis| axis.front.chosen.id.to_string()).collect();
    let mut files: Vec<&str> = axes.iter().map(|axis| axis.front.file).collect();
    files.dedup();
    workbook.set_properties(&document(&files.join(", "), &codes.join(", "))?);
    let mut all: Vec<[String; 5]> = Vec::new();
    for column in axes.iter().flat_map(|axis| columns(&axis.tables, language)) {
        if !all.contains(&column) {
            all.push(column);
        }
    }
    let own = [tables::overview(language), tables::charts(language)];
    let titles = axes.iter().flat_map(|axis| axis.tables.iter().map(|table| table.title.as_str())).chain(own);
    let longest = titles.map(|title| title.chars().count()).max().unwrap_or_default();
    let name = |axis: &AxisSheets<'_>| -> String {
        let stem = axis.front.file.rsplit_once('.').map_or(axis.front.file, |(stem, _)| stem);
        if axis.front.project.name.is_empty() { stem.to_owned() } else { axis.front.project.name.clone() }
    };
    let names: Vec<String> = axes.iter().map(name).collect();
    let labels = overall::labels(names.iter().map(String::as_str), longest);
    workbook.push_worksheet(overall::sheet(&axes, &labels, &styles, language)?);
    for (axis, label) in axes.iter_mut().zip(&labels) {
        for table in &mut axis.tables {
            table.title = overall::named(label, &table.title);
        }
        let [overview, charts] = own.map(|title| overall::named(label, title));
        for sheet in of_axis(&axis.tables, &axis.front, [&overview, &charts], &styles)? {
            workbook.push_worksheet(sheet);
        }
    }
    workbook.push_worksheet(meanings(&all, &styles, language)?);
    Ok(workbook.save_to_buffer()?)
}

/// Writes the sheets of an axis: the first one, its tables, its charts.
fn of_axis(
    tables: &[Table],
    front: &Front<'_>,
    [overview, charts]: [&str; 2],
    styles: &Styles,
) -> Result<Vec<Worksheet>, WriteError> {
    let language = front.language;
    let links = Links::of(tables);
    let mut sheets = vec![cover::sheet(tables, front, overview, styles)?];
    for table in tables.iter().filter(|table| format::Format::Workbook.holds(table)) {
        sheets.push(sheet::sheet(table, &links, styles, language)?);
    }
    sheets.extend(charts::sheet(tables, &front.chosen.id.to_string(), charts, language)?);
    Ok(sheets)
}

/// Returns the document properties, with a fixed date of creation instead of the clock.
fn document(title: &str, subject: &str) -> Result<DocProperties, WriteError> {
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?.and_hms(0, 0, 0)?;
    Ok(DocProperties::new().set_title(title).set_subject(subject).set_author("antrieb").set_creation_datetime(&created))
}

/// Returns sheet, heading, name in data exchange, unit and meaning of every column.
fn columns(tables: &[Table], language: Language) -> Vec<[String; 5]> {
    let of = |table: &Table| -> Vec<[String; 5]> {
        let row = |column: &Column| {
            let name = format!("{}.{}", table.name, column.name);
            let unit = column.unit.map(|unit| unit.symbol_in(language)).filter(|symbol| *symbol != "1");
            let unit = unit.unwrap_or_default().to_owned();
            [table.title.clone(), column.title.clone(), name, unit, column.about.clone()]
        };
        table.columns.iter().map(row).collect()
    };
    tables.iter().flat_map(of).collect()
}

/// Writes the sheet with the meaning of every column and its name in data exchange.
fn meanings(columns: &[[String; 5]], styles: &Styles, language: Language) -> Result<Worksheet, WriteError> {
    let mut sheet = Worksheet::new();
    sheet.set_name(capitalised(terms::columns(language)))?;
    let heads: [Word; 5] =
        [tables::sheet, tables::heading, tables::name_in_csv_json_parquet, terms::unit, tables::meaning_and_source];
    let widths = [16.0, 30.0, 30.0, 12.0, 60.0];
    for ((column, head), width) in (0_u16..).zip(heads).zip(widths) {
        sheet.write_string_with_format(0, column, head(language), &styles.head)?;
        sheet.set_column_width(column, width)?;
    }
    for (row, texts) in (1_u32..).zip(columns) {
        for (at, text) in (0_u16..).zip(texts) {
            sheet.write_string_with_format(row, at, text.as_str(), &styles.text)?;
        }
        let most = texts.iter().zip(widths).map(|(text, wide)| lines(text, wide)).max();
        sheet.set_row_height(row, height(most.unwrap_or(1)))?;
    }
    sheet.set_freeze_panes(1, 0)?;
    Paper::for_width(widths.iter().sum()).set(&mut sheet);
    Ok(sheet)
}
