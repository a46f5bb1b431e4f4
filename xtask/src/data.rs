//! Command `data`: runs the cross-checks of the data, a test of the configurator, and prints its report.
//!
//! The build of the catalogue already rejects a file that violates its own form. The checks hold between tables: sums, products and
//! ratios that the stated values must satisfy. CI runs them with the other tests.

use std::path::Path;

use crate::Error;
use crate::cargo::{cargo, must_succeed};

/// Runs every cross-check, prints what was compared and what the errata explain, and every unexplained deviation.
///
/// # Errors
/// When a deviation is not explained, or an erratum explains nothing.
pub fn run(root: &Path) -> Result<(), Error> {
    let test = [
        "test",
        "--quiet",
        "--package",
        "configurator",
        "--test",
        "it",
        "--",
        "--nocapture",
        "audit::the_data_are_consistent",
    ];
    must_succeed(&mut cargo(root, &test))
}
