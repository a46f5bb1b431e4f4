//! The fuzz step: package `fuzz`, run as plain tests for a bounded time.

use std::ffi::OsString;
use std::path::Path;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};

/// How long each target runs; the package reads it, a caller may set it.
const SECONDS: &str = "ANTRIEB_FUZZ_SECONDS";
const SECONDS_DEFAULT: &str = "20";

pub(crate) fn run(root: &Path) -> Result<(), Error> {
    Workspace::ask(root)?.require("fuzz")?;
    let seconds = std::env::var_os(SECONDS).unwrap_or_else(|| OsString::from(SECONDS_DEFAULT));
    let mut command = cargo(root, &["test", "--package", "fuzz", "--release"]);
    must_succeed(command.env(SECONDS, seconds))
}
