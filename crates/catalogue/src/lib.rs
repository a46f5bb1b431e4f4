//! Products as their manuals state them: every cell of the tables, the errata, the glossary and the sources, embedded
//! in the program, with typed access in SI.
//!
//! This crate holds the statements of the manuals with their places and no physics. Other crates fill the parameter
//! structs of the physics from it.

use record::Packed;
use std::collections::BTreeMap;
use std::sync::{LazyLock, OnceLock};

mod drive;
mod fact;
mod record;
mod series;

pub use drive::{Drive, cells_about, datum_of, drive, drives, size_cell};
pub use fact::{Bound, Fact, FactValue, HoldsFor, LifeStep, SignalWord, Topic};
pub use provenance::Value;
pub use record::{Cell, Erratum, ErratumKind, Footnote, ManualTable, ProductWord, SourceDocument, Term};
pub use series::{
    DriveHead, Mark, MarkEntry, SeriesData, WindingData, WiringTables, leads_out_kty, leads_out_ptc, winding_data,
};

mod embedded {
    use crate::fact::{Bound, Fact, FactValue, HoldsFor, LifeStep, SignalWord, Topic};
    use crate::record::{Erratum, ErratumKind, Footnote, ManualTable, Packed, ProductWord, SourceDocument, Term};
    use crate::series::{DriveHead, Mark, MarkEntry, SeriesData, WindingData, WiringTables};
    use provenance::Value;
    include!(concat!(env!("OUT_DIR"), "/data.rs"));
}

/// Cells of the embedded tables, unpacked when one of them is first read.
static CELLS: [OnceLock<Vec<Cell>>; embedded::TABLES.len()] = [const { OnceLock::new() }; embedded::TABLES.len()];

/// Embedded data joined with those of further series.
static EXTENDED: OnceLock<Further> = OnceLock::new();

/// Series that are not embedded: their cells, tables, documents and records.
#[derive(Clone, Debug, Default)]
pub struct Further {
    /// Cells of the tables.
    pub cells: Vec<Cell>,
    /// Tables, whose `number` counts them and whose `first` and `end` count these cells.
    pub tables: Vec<ManualTable>,
    /// Documents that contain the tables.
    pub documents: Vec<SourceDocument>,
    /// A record for each series, in the order of their grammars.
    pub series: Vec<SeriesData>,
}

/// Adds series to the embedded ones, for the whole program; called once, before any data are read, and after
/// [`order_code::extend`] with their grammars.
///
/// # Errors
/// The series, if others were added before.
pub fn extend(further: Further) -> Result<(), Box<Further>> {
    let moved = |table: &ManualTable| ManualTable { number: table.number + CELLS.len(), ..*table };
    let joined = Further {
        cells: further.cells.clone(),
        tables: embedded::TABLES.iter().copied().chain(further.tables.iter().map(moved)).collect(),
        documents: [embedded::SOURCES, &further.documents].concat(),
        series: [embedded::SERIES, &further.series].concat(),
    };
    EXTENDED.set(joined).map_err(|_| Box::new(further))
}

/// Returns the record of each series, in the order of [`order_code::Series::all`].
#[must_use]
pub fn series() -> &'static [SeriesData] {
    EXTENDED.get().map_or(embedded::SERIES, |all| &all.series)
}

/// Returns every cell of every table, in the order of the tables, rows and columns.
pub fn cells() -> impl Iterator<Item = &'static Cell> {
    tables().iter().flat_map(ManualTable::cells)
}

/// Returns the cells of one table.
fn cells_of(table: &ManualTable) -> &'static [Cell] {
    let within = table.first..table.end;
    match CELLS.get(table.number) {
        Some(cells) => cells.get_or_init(|| {
            let unpacked = |cell: &Packed| cell.unpacked(embedded::CELL_TEXTS, embedded::CELL_ERRATA);
            embedded::PACKED.get(within).unwrap_or_default().iter().map(unpacked).collect()
        }),
        None => EXTENDED.get().and_then(|all| all.cells.get(within)).unwrap_or_default(),
    }
}

/// Returns every table, the manual's first, in the order of their numbers.
#[must_use]
pub fn tables() -> &'static [ManualTable] {
    EXTENDED.get().map_or(embedded::TABLES, |all| &all.tables)
}

/// Returns the table with this number, e.g. `26.1`.
#[must_use]
pub fn table(id: &str) -> Option<&'static ManualTable> {
    // Looked up some thousand times when the parameters of the actuators are read.
    static BY_ID: LazyLock<BTreeMap<&str, &ManualTable>> =
        LazyLock::new(|| embedded::TABLES.iter().rev().map(|table| (table.id, table)).collect());
    match EXTENDED.get() {
        Some(all) => all.tables.iter().find(|table| table.id == id),
        None => BY_ID.get(id).copied(),
    }
}

/// Returns every known difference between the recovered text and the manual, and every known error of the manual.
#[must_use]
pub fn errata() -> &'static [Erratum] {
    embedded::ERRATA
}

/// Returns the cells of a table; empty if there is no such table.
#[must_use]
pub fn table_cells(id: &str) -> &'static [Cell] {
    table(id).map(ManualTable::cells).unwrap_or_default()
}

/// Returns the first cell of a table with this symbol.
#[must_use]
pub fn table_cell(id: &str, symbol: &str) -> Option<&'static Cell> {
    table_cells(id).iter().find(|cell| cell.place.symbol == symbol)
}

/// Returns the erratum with this identifier.
#[must_use]
pub fn erratum(id: &str) -> Option<&'static Erratum> {
    embedded::ERRATA.iter().find(|erratum| erratum.id == id)
}

/// Returns the terms of the field: symbol, identifier, unit, English and German name.
#[must_use]
pub fn glossary() -> &'static [Term] {
    embedded::GLOSSARY
}

/// Returns the term with this symbol.
#[must_use]
pub fn term(symbol: &str) -> Option<&'static Term> {
    embedded::GLOSSARY.iter().find(|term| term.symbol == symbol)
}

/// Returns the words of the product: one term per thing, in both languages.
#[must_use]
pub fn words() -> &'static [ProductWord] {
    embedded::WORDS
}

/// Returns every document that a number comes from.
#[must_use]
pub fn documents() -> &'static [SourceDocument] {
    EXTENDED.get().map_or(embedded::SOURCES, |all| &all.documents)
}

/// Returns the document with this identifier.
#[must_use]
pub fn document(id: &str) -> Option<&'static SourceDocument> {
    documents().iter().find(|document| document.id == id)
}

/// Returns every fact that a source states in prose, file by file.
#[must_use]
pub fn facts() -> &'static [Fact] {
    embedded::FACTS
}

/// Returns the fact with this identifier.
#[must_use]
pub fn fact(id: &str) -> Option<&'static Fact> {
    embedded::FACTS.iter().find(|fact| fact.id == id)
}
