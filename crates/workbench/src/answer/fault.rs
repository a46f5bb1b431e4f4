//! Faults of an input file as records.

use answers::{Fault, Faults, Place};
use words::Told;

/// Faults of an input file.
#[must_use]
pub fn faults(file: &str, faults: &[Told]) -> Faults {
    let fault = |fault: &Told| Fault {
        id: Some(fault.id),
        file: Some(file.to_owned()),
        place: Some(Place { line: fault.line, column: fault.column, span: [fault.span.start, fault.span.end] }),
        message: fault.message.clone(),
        hint: fault.hint.clone(),
        ..Fault::default()
    };
    Faults { errors: faults.iter().map(fault).collect() }
}
