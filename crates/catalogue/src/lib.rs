//! The products as they are printed: every cell of the tables, the errata, the glossary and the sources,
//! embedded in the program, and typed access to them in SI.
//!
//! This crate knows what is printed and where; it knows no physics. Physics takes parameter structs that
//! other crates fill from here.

mod drive;
mod fact;
mod record;

pub use drive::{Drive, cells_about, datum_of, drive, drives, size_cell};
pub use fact::{Bound, Fact, FactValue, HoldsFor, Signal, Step, Topic};
pub use record::{Cell, Document, Erratum, ErratumKind, Footnote, Table, Term, Value, Word};

mod embedded {
    use crate::fact::{Bound, Fact, FactValue, HoldsFor, Signal, Step, Topic};
    use crate::record::{Cell, Document, Erratum, ErratumKind, Footnote, Table, Term, Value, Word};
    use provenance::CellRef;
    include!(concat!(env!("OUT_DIR"), "/data.rs"));
}

/// Every printed cell of every table, in the order of the tables, rows and columns.
#[must_use]
pub fn cells() -> &'static [Cell] {
    embedded::CELLS
}

/// Every table, the manual's first, in the order of their numbers.
#[must_use]
pub fn tables() -> &'static [Table] {
    embedded::TABLES
}

/// The table with this number, e.g. `26.1`.
#[must_use]
pub fn table(id: &str) -> Option<&'static Table> {
    embedded::TABLES.iter().find(|table| table.id == id)
}

/// Every known departure from the recovered text and every known error of the print.
#[must_use]
pub fn errata() -> &'static [Erratum] {
    embedded::ERRATA
}

/// The erratum with this identifier.
#[must_use]
pub fn erratum(id: &str) -> Option<&'static Erratum> {
    embedded::ERRATA.iter().find(|erratum| erratum.id == id)
}

/// The terms of the field: symbol, identifier, unit, English and German name.
#[must_use]
pub fn glossary() -> &'static [Term] {
    embedded::GLOSSARY
}

/// The term with this symbol.
#[must_use]
pub fn term(symbol: &str) -> Option<&'static Term> {
    embedded::GLOSSARY.iter().find(|term| term.symbol == symbol)
}

/// The words of the product: one for one thing, in both languages.
#[must_use]
pub fn words() -> &'static [Word] {
    embedded::WORDS
}

/// Every document that a number comes from.
#[must_use]
pub fn documents() -> &'static [Document] {
    embedded::SOURCES
}

/// The document with this identifier.
#[must_use]
pub fn document(id: &str) -> Option<&'static Document> {
    embedded::SOURCES.iter().find(|document| document.id == id)
}

/// Every fact that a source states in prose, file by file.
#[must_use]
pub fn facts() -> &'static [Fact] {
    embedded::FACTS
}

/// The fact with this identifier.
#[must_use]
pub fn fact(id: &str) -> Option<&'static Fact> {
    embedded::FACTS.iter().find(|fact| fact.id == id)
}
