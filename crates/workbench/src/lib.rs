//! The facade: the project file and every use case as plain data. Every face calls only this.
//!
//! Texts come in English and German ([`Language`]); results come as data ([`Sizing`], [`Candidate`]) and as JSON
//! values ([`json`]). Nothing here touches a file, the clock, the environment or the terminal.

mod codes;
mod diagnostic;
mod export;
pub mod json;
mod project;
mod sheet;
mod sizing_use;
pub mod text;

pub use codes::{CodeFault, CodeReading, completion, explain_code, list_codes, read_code, read_pattern};
pub use diagnostic::{Diagnostic, place};
pub use export::{EXPORT_COLUMNS, export_rows};
pub use project::{Assumption, OwnActuator, PROJECT_MAX_BYTES, Project, schema};
pub use configurator::{Availability, Choice};
pub use order_code::{Field, OrderCode};
pub use quantities::{self, Language};
pub use sizing::{Check, Demand, Figure, Verdict};
pub use sheet::{Sheet, SheetRow, SheetSection, sheet};
pub use sizing_use::{Candidate, CandidateId, Objection, Refusal, Sizing, catalogue_actuators, check, check_own, size};
