//! Development tasks of the project, each one a module with a `run`.
//!
//! [`ci`] is exactly what CI runs, [`mod@test`] the tests alone. [`tidy`] checks the house rules that no compiler
//! checks. [`data`] prints the cross-checks of the data, [`snapshots`] rewrites the snapshots, [`samples`]
//! the answers shown in the documents, [`notices`] the list of third parties; [`mod@book`] builds the book, [`german`]
//! checks its German, [`picture`] composes the picture of the README, [`site`] builds the folder of the page without a
//! server, [`mod@browser`] tests both in a browser, [`mod@bench`] runs the bench gates, [`fuzz`] the targets. A Rust
//! toolchain is enough to start: [`tools`] installs the rest.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore talks to the person who started it")]

use std::path::{Path, PathBuf};

mod api;
pub mod bench;
pub mod book;
pub mod browser;
mod canopen;
mod cargo;
pub mod ci;
pub mod data;
mod environment;
mod error;
pub mod fuzz;
pub mod german;
mod lint;
mod markdown;
pub mod notices;
pub mod picture;
mod python;
mod readme;
mod readme_words;
pub mod samples;
pub mod site;
pub mod snapshots;
mod standard;
pub mod test;
pub mod tidy;
pub mod tools;
mod yanked;

pub use error::Error;

/// Returns the root of the repository from which this program was built.
#[must_use]
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here).to_path_buf()
}
