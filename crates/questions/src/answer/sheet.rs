//! Data sheet and catalogue as records.

use crate::sheet::{Sheet, SheetNote, SheetRow, SheetSection};
use answers::{CatalogueCell, Id, NoteBy, Number, SheetValue, TableCell};
use catalogue::{Cell, Value};
use provenance::Grade;
use quantities::Language;
use words::{cell_text, describe_uncovered, symbol_term, table_note, table_title};

/// Returns a data sheet.
#[must_use]
pub fn sheet(sheet: &Sheet, language: Language) -> answers::Sheet {
    answers::Sheet {
        code: sheet.code.to_string(),
        notes: sheet.uncovered.iter().map(|what| describe_uncovered(*what, language)).collect(),
        sections: sheet.sections.iter().map(|each| section(each, language)).collect(),
    }
}

fn section(section: &SheetSection, language: Language) -> answers::SheetSection {
    answers::SheetSection {
        table: section.table.id,
        title: table_title(section.table, language),
        values: section.rows.iter().map(|row| value(row, language)).collect(),
        notices: section.notices.iter().map(|each| note(each, language)).collect(),
        errata: section.errata.clone(),
    }
}

fn value(row: &SheetRow, language: Language) -> SheetValue {
    let cell = row.cell;
    let is_text = cell.value == Value::Text && !row.of_standard_only;
    SheetValue {
        symbol: cell.place.symbol,
        name: symbol_term(cell.place.symbol, language),
        condition: cell.place.condition,
        printed: cell.printed,
        value: if row.of_standard_only { TableCell::Empty } else { cell_value(cell) },
        unit: cell.unit,
        table: cell.place.table,
        grade: Id(Grade::Printed),
        errata: cell.errata,
        checks_use: cell.checks_use.and_then(Value::number).map(Number),
        text: is_text.then(|| cell_text(cell, language)),
        notes: row.notes.iter().map(|each| note(each, language)).collect(),
    }
}

fn note(note: &SheetNote, language: Language) -> answers::SheetNote {
    answers::SheetNote {
        mark: Some(note.mark()).filter(|mark| !mark.is_empty()),
        by: if note.is_ours() { NoteBy::Antrieb } else { NoteBy::Manual },
        text: sheet_note_text(note, language),
    }
}

/// Returns the text of a note on a data sheet.
#[must_use]
pub fn sheet_note_text(note: &SheetNote, language: Language) -> String {
    match note {
        SheetNote::Table(note) => table_note(note, language).to_owned(),
        SheetNote::Uncovered(what) => describe_uncovered(*what, language),
    }
}

/// Returns the value of a cell after errata.
pub(super) fn cell_value(cell: &Cell) -> TableCell {
    match cell.value {
        Value::NotPrinted => TableCell::Empty,
        Value::Range { .. } | Value::Text => TableCell::Text(cell.value_text()),
        _ => cell.value.number().map_or(TableCell::Empty, |value| TableCell::Number(Number(value))),
    }
}

/// Returns the catalogue in long form, one record per cell.
#[must_use]
pub fn catalogue_cells() -> Vec<CatalogueCell> {
    let record = |cell: &'static Cell| CatalogueCell {
        drive: cell.place.drive,
        feedback: cell.feedback,
        ratio: cell.place.ratio,
        symbol: cell.place.symbol,
        condition: cell.place.condition,
        printed: cell.printed,
        value: cell_value(cell),
        unit: cell.unit,
        table: cell.place.table,
        erratum: cell.errata.join(";"),
    };
    catalogue::cells().map(record).collect()
}
