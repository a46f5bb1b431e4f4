//! Faults of values alone: a section that is made in Python is checked before it is part of a project.

use project::Fault;
use quantities::Language;

/// Fault of a value: its line from one, the fault in one sentence, and what is expected.
pub type ValueFault = (usize, String, Option<String>);

/// Returns the faults of the values of a text; keys that are missing or do not belong together are faults of the whole
/// project.
#[must_use]
pub fn value_faults(text: &str, language: Language) -> Vec<ValueFault> {
    let Ok(read) = project::read(text) else { return Vec::new() };
    let mut found = read.report.into_faults();
    found.retain(|each| is_of_the_value(&each.fault));
    let lines: Vec<usize> = found.iter().map(|each| each.line).collect();
    let words = words::worded(&found, language);
    lines.into_iter().zip(words).map(|(line, worded)| (line, worded.message, worded.hint)).collect()
}

const fn is_of_the_value(fault: &Fault) -> bool {
    matches!(
        fault,
        Fault::BareNumber { .. }
            | Fault::Quantity { .. }
            | Fault::NumberOutOfRange { .. }
            | Fault::QuantityOutOfRange { .. }
            | Fault::BelowAbsoluteZero { .. }
            | Fault::Implausible { .. }
            | Fault::TextTooLong { .. }
            | Fault::ControlCharacter { .. }
            | Fault::WrongType { .. }
            | Fault::NotAChoice { .. }
            | Fault::TooManyEntries { .. }
            | Fault::NotARow { .. }
            | Fault::RatioTooSmall { .. }
            | Fault::EmptyList { .. }
            | Fault::ToleranceEnd { .. }
            | Fault::InBody { .. }
    )
}
