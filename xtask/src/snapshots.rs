//! Rewrites the snapshots of the project's own texts. Reference values are not snapshots and stay unchanged.

use std::path::Path;
use std::process::Command;

use crate::Error;
use crate::cargo::{cargo, must_succeed};

/// Runs the tests with the snapshots rewritten, then lists the `.snap` files that changed or are new.
///
/// # Errors
/// When a test fails for another reason than a snapshot, or git cannot be asked; the list is printed first.
pub fn run(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["test", "--workspace", "--no-fail-fast"]);
    let tests = must_succeed(command.env("INSTA_UPDATE", "always"));
    git(root, &["--no-pager", "diff", "--stat", "--", "*.snap"])?;
    git(root, &["ls-files", "--others", "--exclude-standard", "--", "*.snap"])?;
    tests
}

fn git(root: &Path, args: &[&str]) -> Result<(), Error> {
    must_succeed(Command::new("git").args(args).current_dir(root))
}
