//! Keys that need another one.

use project::sections::StatedField;
use project::{Fault, FaultReport};

/// Reports a key that is stated without another one that it needs.
pub(crate) fn needs(given: &dyn StatedField, needed: &dyn StatedField, report: &mut FaultReport<'_>) {
    if given.is_given() && !needed.is_written() {
        report.fault(given.span(), Fault::MissingKey { path: needed.path(), list: false }, None);
    }
}
