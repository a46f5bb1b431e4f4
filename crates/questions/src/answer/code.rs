//! Ordering codes as records.

use crate::codes::{CodeReading, CodeRefusal, completion as fields_of, explain_code};
use answers::{Availability, Choice, CodeFault, CodeFaults, CodeField, Completion, Id, ListedCode, OpenField};
use order_code::{Field, OrderCode, Pattern};
use quantities::Language;
use words::{describe_field, describe_uncovered};

/// Returns the names of fields.
pub(super) fn names(fields: &[Field], language: Language) -> Vec<String> {
    fields.iter().map(|field| describe_field(*field, language).to_owned()).collect()
}

/// Returns a code with every field explained.
#[must_use]
pub fn code_reading(reading: &CodeReading, language: Language) -> answers::CodeReading {
    let parsed = &reading.parsed;
    let span_of = |field| {
        let found = parsed.spans.iter().find(|(spanned, _)| *spanned == field);
        found.map(|(_, span)| [span.start, span.end])
    };
    let fields = explain_code(&parsed.code, language).into_iter().map(|(field, token, meaning)| CodeField {
        field: Id(field),
        name: describe_field(field, language).to_owned(),
        token,
        meaning,
        span: span_of(field),
    });
    let uncovered = configurator::uncovered(&parsed.code);
    answers::CodeReading {
        valid: true,
        code: parsed.code.to_string(),
        canonical: parsed.is_canonical(),
        availability: Availability::of(reading.availability.is_available()),
        on_request: names(&reading.availability.on_request, language),
        fields: fields.collect(),
        notes: uncovered.into_iter().map(|what| describe_uncovered(what, language)).collect(),
    }
}

/// Returns the faults of a code, with the nearest valid codes.
#[must_use]
pub fn code_faults(text: &str, refusal: &CodeRefusal, language: Language) -> CodeFaults {
    let fault = |fault: &crate::codes::CodeFault| CodeFault {
        id: fault.id(),
        position: text.get(..fault.span.start).map_or(1, |before| before.chars().count() + 1),
        span: [fault.span.start, fault.span.end],
        text: text.get(fault.span.clone()).map(str::to_owned),
        message: fault.message.clone(),
        hint: fault.hint.clone(),
        table: fault.table,
    };
    CodeFaults {
        valid: false,
        text: text.to_owned(),
        errors: refusal.faults.iter().map(fault).collect(),
        nearest: refusal.nearest.iter().map(|(code, _)| code.to_string()).collect(),
        nearest_codes: listed(&refusal.nearest, language),
    }
}

/// Returns codes with their availability.
#[must_use]
pub fn listed(codes: &[&(OrderCode, configurator::Availability)], language: Language) -> Vec<ListedCode> {
    let listed = |(code, found): &(OrderCode, configurator::Availability)| ListedCode {
        code: code.to_string(),
        availability: Availability::of(found.is_available()),
        on_request: names(&found.on_request, language),
    };
    codes.iter().map(|known| listed(known)).collect()
}

/// Returns the valid choices for each field of a partial code, and the codes that the partial code allows.
#[must_use]
pub fn completion(
    pattern: &Pattern,
    codes: &[&(OrderCode, configurator::Availability)],
    language: Language,
) -> Completion {
    let fields = fields_of(pattern, language).into_iter().map(|(field, name, choices)| OpenField {
        field: Id(field),
        name: name.to_owned(),
        choices: choices
            .iter()
            .map(|choice| Choice { token: choice.token, availability: Availability::of(choice.available) })
            .collect(),
    });
    Completion { fields: fields.collect(), codes: listed(codes, language) }
}
