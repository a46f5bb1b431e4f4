//! Command `data`: runs [`crate::audit`] and prints its report.
//!
//! The build of the catalogue already rejects a file that violates its own form. The checks here hold between tables:
//! sums, products and ratios that the stated values must satisfy.

use crate::{Error, audit};

/// Runs every cross-check, prints what was compared and what the errata explain, and every unexplained deviation.
///
/// # Errors
/// When a deviation is not explained, or an erratum explains nothing.
pub fn run() -> Result<(), Error> {
    let report = audit::run();
    print!("{report}");
    let findings = report.findings();
    for finding in &findings {
        eprintln!("data: {finding}");
    }
    if findings.is_empty() { Ok(()) } else { Err(Error::Untidy { count: findings.len() }) }
}
