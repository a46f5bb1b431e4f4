//! Reading, listing and completing ordering codes.

use configurator::{Availability, Choice, availability};
use order_code::{CodeErrors, Field, OrderCode, Parsed, Pattern};
use quantities::Language;
use std::ops::Range;
use words::{describe_code_error, describe_field, describe_rule, describe_token, either};

/// A code as it was understood.
#[derive(Clone, Debug)]
pub struct CodeReading {
    /// The code with its spans and departures from the canonical spelling.
    pub parsed: Parsed,
    /// Whether it can be had without asking.
    pub availability: Availability,
}

/// One fault of a code: of its spelling, or of its combination.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeFault {
    /// Offending part of the text, in bytes.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What is valid here.
    pub hint: Option<String>,
    /// The table whose rule is broken, if it is a rule.
    pub table: Option<&'static str>,
}

/// Reads a code and holds it to the rules of the ordering tables.
///
/// # Errors
/// Every fault, each with its place in the text, and the nearest valid codes.
pub fn read_code(text: &str, language: Language) -> Result<CodeReading, (Vec<CodeFault>, Vec<OrderCode>)> {
    let near = || configurator::nearest(text, 3);
    let parsed = order_code::parse(text).map_err(|errors| (spelling_faults(&errors, language), near()))?;
    match availability(&parsed.code) {
        Ok(availability) => Ok(CodeReading { parsed, availability }),
        Err(broken) => {
            let faults = broken
                .iter()
                .map(|rule| {
                    let span = parsed.spans.iter().find(|(field, _)| *field == rule.field);
                    CodeFault {
                        span: span.map_or(0..text.len(), |(_, span)| span.clone()),
                        message: describe_rule(&parsed.code, rule, language),
                        hint: None,
                        table: Some(rule.table),
                    }
                })
                .collect();
            Err((faults, near()))
        }
    }
}

/// Reads a partial code.
///
/// # Errors
/// Every fault of its spelling.
pub fn read_pattern(text: &str, language: Language) -> Result<Pattern, Vec<CodeFault>> {
    Pattern::parse(text).map_err(|errors| spelling_faults(&errors, language))
}

pub(crate) fn spelling_faults(errors: &CodeErrors, language: Language) -> Vec<CodeFault> {
    errors
        .iter()
        .map(|error| {
            let hint = match error.nearest() {
                Some(near) => Some(either(
                    language,
                    format!("did you mean `{near}`?"),
                    format!("gemeint ist vielleicht `{near}`"),
                )),
                None if error.expected().is_empty() => None,
                None => {
                    let valid = error.expected().join(", ");
                    Some(either(language, format!("valid here: {valid}"), format!("hier gültig: {valid}")))
                }
            };
            CodeFault { span: error.span(), message: describe_code_error(error, language), hint, table: None }
        })
        .collect()
}

/// Each field of a code with its token and what it means.
#[must_use]
pub fn explain_code(code: &OrderCode, language: Language) -> Vec<(Field, String, String)> {
    Field::ALL
        .iter()
        .copied()
        .map(|field| {
            let token = code.token(field).unwrap_or("").to_owned();
            (field, token, describe_token(code, field, language))
        })
        .collect()
}

/// Every valid code with its availability, optionally only those that a partial code allows.
pub fn list_codes(pattern: Option<&Pattern>) -> Vec<&'static (OrderCode, Availability)> {
    match pattern {
        Some(pattern) => configurator::complete(pattern).collect(),
        None => configurator::all().iter().collect(),
    }
}

/// For each field of a partial code, what may stand there.
#[must_use]
pub fn completion(pattern: &Pattern, language: Language) -> Vec<(Field, &'static str, Vec<Choice>)> {
    configurator::choices(pattern)
        .into_iter()
        .map(|(field, choices)| (field, describe_field(field, language), choices))
        .collect()
}
