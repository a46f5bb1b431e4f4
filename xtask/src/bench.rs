//! The bench gates: package `benches`, which compares counts or ratios within one run.

use std::path::Path;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};

/// Runs every bench of package `benches`; `words` are passed on to the benches.
///
/// # Errors
/// When the workspace has no such package, or a gate does not hold.
pub fn run(root: &Path, words: &[String]) -> Result<(), Error> {
    Workspace::ask(root)?.require("benches")?;
    let mut command = cargo(root, &["bench", "--package", "benches"]);
    if !words.is_empty() {
        command.arg("--").args(words);
    }
    must_succeed(&mut command)
}
