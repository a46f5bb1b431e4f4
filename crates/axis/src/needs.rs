//! Keys that need another one.

use crate::fault::AxisReport;
use project::Fault;
use project::sections::StatedField;

/// Reports a key that is stated without another one that it needs.
pub(crate) fn needs(given: &dyn StatedField, needed: &dyn StatedField, report: &mut AxisReport<'_>) {
    if given.is_given() && !needed.is_written() {
        report.fault(given.span(), Fault::MissingKey { path: needed.path(), list: false }, None);
    }
}
