//! Data sheet of a code, and cells of the catalogue.

use crate::{Id, Number, TableCell};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// `data`: every printed value of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sheet {
    /// The code.
    pub code: String,
    /// What the tables do not cover of it, in words.
    pub notes: Vec<String>,
    /// One section for each printed table, in the order of the manual.
    pub sections: Vec<SheetSection>,
}

/// The values of one printed table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetSection {
    /// Number of the table.
    pub table: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its values for this code.
    pub values: Vec<SheetValue>,
    /// Notices on the table as a whole.
    pub notices: Vec<SheetNote>,
    /// Ids of the errata of the table that name no single cell.
    pub errata: Vec<&'static str>,
}

/// A printed value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetValue {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// The field's word for it.
    pub name: String,
    /// Further distinction of the row.
    pub condition: &'static str,
    /// The text of the cell as printed.
    pub printed: &'static str,
    /// The value after errata in the printed unit: a number or a text; `null` where none is printed, for this code.
    pub value: TableCell,
    /// The printed unit in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table.
    pub table: &'static str,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Ids of the errata that touch it.
    pub errata: &'static [&'static str],
    /// The value that checks take where it is not `value`.
    pub checks_use: Option<Number>,
    /// The value of a text in the language of the answer; `null` for a number.
    pub text: Option<&'static str>,
    /// Notes on the row.
    pub notes: Vec<SheetNote>,
}

/// A note on a value or a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SheetNote {
    /// The mark as printed; `null` where it has none.
    pub mark: Option<&'static str>,
    /// Who says so.
    pub by: NoteBy,
    /// What it says, in our words.
    pub text: String,
}

/// Who says what a note says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoteBy {
    /// The manual.
    Manual,
    /// Our own conclusion from the print.
    Antrieb,
}

/// `catalogue export`: a printed cell in long form.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueCell {
    /// The drive as the manual heads it; empty where the cell holds for all.
    pub drive: &'static str,
    /// Feedback system, several joined by ` / `; empty: every one of the drive.
    pub feedback: &'static str,
    /// Reduction ratio, or `> 50`; empty: printed once for all ratios.
    pub ratio: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Further distinction of the row.
    pub condition: &'static str,
    /// The text of the cell as printed.
    pub printed: &'static str,
    /// The value after errata in the printed unit: a number or a text; `null` where none is printed.
    pub value: TableCell,
    /// The printed unit in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table, or its name in another document.
    pub table: &'static str,
    /// Ids of the errata that touch it, joined by `;`.
    pub erratum: String,
}
