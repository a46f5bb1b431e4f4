//! Data sheet of a code, and cells of the catalogue.

use crate::{Id, Number, TableCell};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// `data`: the values that the manual states for an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sheet {
    /// Ordering code.
    pub code: String,
    /// Remarks on data not covered by the tables, as text.
    pub notes: Vec<String>,
    /// One section per table, in the order of the manual.
    pub sections: Vec<SheetSection>,
}

/// Values of one table of the manual.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetSection {
    /// Number of the table.
    pub table: &'static str,
    /// Title of the table.
    pub title: &'static str,
    /// Values for this code.
    pub values: Vec<SheetValue>,
    /// Notices on the table as a whole.
    pub notices: Vec<SheetNote>,
    /// Ids of the errata that concern the table instead of a single cell.
    pub errata: Vec<&'static str>,
}

/// A value stated in the manual.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetValue {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Technical term.
    pub name: String,
    /// Further condition of the row.
    pub condition: &'static str,
    /// Text of the cell in the manual.
    pub printed: &'static str,
    /// Value after errata in the unit of the manual: a number or a text; `null` if the manual states none for this
    /// code.
    pub value: TableCell,
    /// Unit of the manual in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table.
    pub table: &'static str,
    /// Grade of the value.
    pub grade: Id<Grade>,
    /// Ids of the errata that concern the value.
    pub errata: &'static [&'static str],
    /// Value used by checks if it is not `value`.
    pub checks_use: Option<Number>,
    /// Text of the value in the language of the answer; `null` for a number.
    pub text: Option<&'static str>,
    /// Notes on the row.
    pub notes: Vec<SheetNote>,
}

/// A note on a value or a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetNote {
    /// Mark in the manual; `null` if it has none.
    pub mark: Option<&'static str>,
    /// Author of the note.
    pub by: NoteBy,
    /// Text of the note in the project's own words.
    pub text: String,
}

/// Author of a note.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoteBy {
    /// The manual.
    Manual,
    /// A conclusion of the project from the manual.
    Antrieb,
}

/// `catalogue export`: a cell in long form.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueCell {
    /// Drive as headed in the manual; empty if the cell holds for all drives.
    pub drive: &'static str,
    /// Feedback system, several joined by ` / `; empty for every one of the drive.
    pub feedback: &'static str,
    /// Reduction ratio, or `> 50`; empty if stated once for all ratios.
    pub ratio: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Further condition of the row.
    pub condition: &'static str,
    /// Text of the cell in the manual.
    pub printed: &'static str,
    /// Value after errata in the unit of the manual: a number or a text; `null` if the manual states none.
    pub value: TableCell,
    /// Unit of the manual in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table, or its name in another document.
    pub table: &'static str,
    /// Ids of the errata that concern the value, joined by `;`.
    pub erratum: String,
}
