//! Faults of an input file as records.

use crate::diagnostic::Diagnostic;
use answers::{Fault, Faults, Place};

/// Faults of an input file.
#[must_use]
pub fn faults(file: &str, faults: &[Diagnostic]) -> Faults {
    let fault = |fault: &Diagnostic| Fault {
        file: Some(file.to_owned()),
        place: Some(Place { line: fault.line, column: fault.column, span: [fault.span.start, fault.span.end] }),
        message: fault.message.clone(),
        hint: fault.hint.clone(),
        ..Fault::default()
    };
    Faults { errors: faults.iter().map(fault).collect() }
}
