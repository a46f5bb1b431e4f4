//! Reader of the files of `data/`, which checks the rules of `data/README.md`.
//!
//! Used by build scripts, which embed the data, and by tests, which load a series from elsewhere. A file that violates
//! a rule is a fault; all faults are listed together.
#![allow(clippy::disallowed_methods, reason = "build scripts and tests read files")]

mod cells;
mod code;
mod fact_file;
mod facts;
mod read;

pub use cells::{AllCells, KEYS, PlacedCell, cells, value_of};
pub use code::{Code, CodeField, Feedback, HeadingDrives, Mark, Tables, Winding, Wiring, WordMeaning, variant_of};
pub use facts::embed as facts;
pub use read::{Data, ErratumEntry, SourceDocument, TableFile, codes, read_all, read_one, series_folders};

use std::path::Path;
use std::process::ExitCode;

/// Writes the output of a build script to its `OUT_DIR`; if there are faults cargo reports them instead.
#[allow(clippy::print_stdout, reason = "a build script speaks to cargo over stdout")]
#[must_use]
pub fn write_out(name: &str, text: &str, faults: &[String]) -> ExitCode {
    for fault in faults {
        println!("cargo::error={fault}");
    }
    match std::env::var_os("OUT_DIR") {
        _ if !faults.is_empty() => {}
        None => println!("cargo::error=OUT_DIR is not set"),
        Some(out) => match std::fs::write(Path::new(&out).join(name), text) {
            Ok(()) => return ExitCode::SUCCESS,
            Err(fault) => println!("cargo::error=cannot write {name}: {fault}"),
        },
    }
    ExitCode::FAILURE
}
