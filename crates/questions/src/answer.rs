//! The results of the use cases as records of `answers`, with their texts in the requested language.

mod beside;
mod chapters;
mod check;
mod code;
mod commission;
mod dossier;
mod errata;
mod facts;
mod fault;
mod inputs;
mod judged;
mod motion;
mod mount;
mod recorded;
mod sheet;
mod upkeep;
mod wiring;
mod written;

pub use beside::{comparison, difference};
pub use chapters::{battery, bearings, curves, inertia, torsion};
pub use check::{check, explained, explanations};
pub use code::{code_faults, code_reading, completion, listed};
pub use commission::{commissioning, drive_objects};
pub(crate) use dossier::document;
pub use dossier::dossier;
pub use errata::{errata, erratum};
pub use facts::facts;
pub use fault::{code_worded, fault, faults, file_fault, not_in_glossary, option_fault, refusal_text};
pub use judged::{candidate, fit, judgement, objections, reserve, sizing, tolerance};
pub use motion::motion;
pub use mount::mount;
pub use recorded::recorded;
pub use sheet::{catalogue_cells, sheet, sheet_note_text};
pub use upkeep::upkeep;
pub use wiring::{wiring, wiring_check};
pub use written::written;
