//! What comes out of antrieb, as plain data: the record of every answer, and of every fault.
//!
//! `--json` is the serialisation of these records, their [JSON Schema](schema) is generated from them, and report, tables
//! and figures take them as they are. A word of a fixed set is an [`Id`], a number a [`Number`]; a `String` whose name is
//! `title`, `name`, `meaning`, `message`, `hint`, `notes`, `source` … is a text in the language asked for. Nothing here
//! computes, and no record is made from JSON.

mod glossary;
mod id;
mod number;

pub use glossary::{Glossary, GlossarySymbol, GlossaryTerm, GlossaryWord};
pub use id::{Availability, Fit, Id, Identified};
pub use number::Number;
