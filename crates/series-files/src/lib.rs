//! The files of `data/`: read, and held to the rules of `data/README.md`.
//!
//! For build scripts, which embed what they read, and for tests, which load a series from elsewhere. A file that breaks a rule
//! is a fault; all are listed at once.
#![allow(clippy::disallowed_methods, reason = "build scripts and tests read files")]

mod cells;
mod code;
mod facts;
mod read;

pub use cells::{Cell, Cells, KEYS, Value, cells, value_of};
pub use code::{Code, Drive, FEEDBACK_KINDS, FIELDS, Feedback, Field, Mark, Meaning, Tables, Winding, Wiring};
pub use facts::embed as facts;
pub use read::{Data, Erratum, Source, Table, codes, read_all, read_one, series_folders};
