//! The chores of the project, each one a module with a `run`.
//!
//! [`ci`] is exactly what CI runs. [`tidy`] holds the rules of the house that no compiler holds.
//! [`data`] prints the cross-checks of the data in [`audit`], [`snapshots`] rewrites the snapshots, [`mod@bench`] runs the bench gates.
//! Nothing here needs more than a Rust toolchain.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore talks to the person who started it")]

use std::path::{Path, PathBuf};

pub mod audit;
pub mod bench;
mod cargo;
pub mod ci;
pub mod data;
mod error;
mod fuzz;
mod readme;
pub mod snapshots;
mod test;
pub mod tidy;

pub use error::Error;

/// The root of the repository that this program was built from.
#[must_use]
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here).to_path_buf()
}
