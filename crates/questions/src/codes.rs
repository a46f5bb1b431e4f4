//! Reading, listing and completing ordering codes.

use configurator::{Availability, BrokenRule, Choice, ProductId, availability};
use order_code::{CodeError, CodeErrors, Field, OrderCode, Parsed, Pattern, Size};
use project::Hint;
use quantities::Language;
use std::ops::Range;
use words::{describe_code_error, describe_field, describe_rule, describe_token, hint_text};

/// Result of reading a code.
#[derive(Clone, Debug)]
pub struct CodeReading {
    /// The code with its spans and departures from the canonical spelling.
    pub parsed: Parsed,
    /// Availability of the code, with the fields that are on request only.
    pub availability: Availability,
}

/// Fault of a code: of its spelling, or of its combination.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeFault {
    /// Offending part of the text, in bytes.
    pub span: Range<usize>,
    /// The fault in one sentence.
    pub message: String,
    /// Valid choices at this place.
    pub hint: Option<String>,
    /// The table whose rule is broken, if it is a rule.
    pub table: Option<&'static str>,
}

impl CodeFault {
    /// Returns the stable identifier of the kind of fault.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        if self.table.is_some() { "code_rule" } else { "code_spelling" }
    }
}

/// Reasons why a text is no code.
#[derive(Clone, Debug)]
pub struct CodeRefusal {
    /// Every fault, each with its place in the text.
    pub faults: Vec<CodeFault>,
    /// The nearest valid codes with data.
    pub nearest: Vec<&'static (OrderCode, Availability)>,
}

/// Number of codes proposed in place of one that does not exist.
const PROPOSALS: usize = 3;

/// Reads a code and checks it against the rules of the ordering tables.
///
/// # Errors
/// Every fault, each with its place in the text, and the nearest valid codes.
pub fn read_code(text: &str, language: Language) -> Result<CodeReading, CodeRefusal> {
    let parsed = order_code::parse(text)
        .or_else(|errors| with_hyphens(text).map_or(Err(errors), |text| order_code::parse(&text)));
    let parsed = parsed.map_err(|errors| CodeRefusal {
        faults: spelling_faults(&errors, language),
        nearest: configurator::nearest(text, PROPOSALS),
    })?;
    match availability(&parsed.code) {
        Ok(availability) => Ok(CodeReading { parsed, availability }),
        Err(broken) => {
            let broken: Vec<(OrderCode, BrokenRule)> = broken.into_iter().map(|rule| (parsed.code, rule)).collect();
            Err(rules_broken(text, &broken, &parsed.spans, language))
        }
    }
}

/// Reads the identity of a product: an ordering code, else a text that is the name of a product.
///
/// # Errors
/// The reasons why a text that is no name is no code.
pub fn read_product(
    text: &str,
    is_name: impl FnOnce(&str) -> bool,
    language: Language,
) -> Result<ProductId, CodeRefusal> {
    let name = text.trim();
    match read_code(text, language) {
        Ok(reading) => Ok(reading.parsed.code.into()),
        Err(_) if !name.is_empty() && is_name(name) => Ok(ProductId::named(name)),
        Err(refusal) => Err(refusal),
    }
}

/// Returns `true` if the text of a project may name catalogue files or describe an actuator, so that a product may have a name.
pub(crate) fn may_name_products(text: &[u8]) -> bool {
    const TABLE: &[u8] = b"catalogue";
    let opens_own = |line: &[u8]| [&b"[actuator]"[..], b"[axis.actuator]"].contains(&line.trim_ascii());
    text.windows(TABLE.len()).any(|part| part == TABLE) || text.split(|byte| *byte == b'\n').any(opens_own)
}

/// Returns a code whose fields are joined by underscores with hyphens in their place; `None` for one with hyphens.
fn with_hyphens(text: &str) -> Option<String> {
    (text.contains('_') && !text.contains('-')).then(|| text.replace('_', "-"))
}

/// Returns a code with `?` for each sign by which people mark a letter that they cannot read; no ordering code has an X.
fn with_wildcards(text: &str) -> String {
    let is_unreadable = |sign: char| matches!(sign, 'x' | 'X' | '_' | '#') || sign == '.' && !text.contains("...");
    text.chars().map(|sign| if is_unreadable(sign) { '?' } else { sign }).collect()
}

/// Length limit in bytes of a text with wildcards.
const WORN_MOST: usize = 64;

/// Fields of a code that one wildcard may stand for.
const FIELDS_MOST: usize = 4;

/// Iterates over the texts in which the first field that is a wildcard stands for several: `CHA-25A-*-B` is `CHA-25A-*-*-*-B`.
fn with_further_fields(text: &str) -> impl Iterator<Item = String> {
    let fields: Vec<&str> = text.split('-').collect();
    let place = fields.iter().position(|field| *field == "*");
    let with = move |place: usize, more: usize| {
        let mut fields = fields.clone();
        fields.splice(place..place, std::iter::repeat_n("*", more));
        fields.join("-")
    };
    (1..FIELDS_MOST).filter_map(move |more| Some(with(place?, more)))
}

/// Reads a partial code that allows at least one code.
///
/// # Errors
/// Every fault of its spelling, or the rules that exclude every code with its words.
pub fn read_pattern(text: &str, language: Language) -> Result<Pattern, CodeRefusal> {
    read_pattern_begun(text, false, language)
}

/// Reads a partial code as [`read_pattern`]; with `is_begun` its last word may be incomplete.
///
/// # Errors
/// As [`read_pattern`].
pub(crate) fn read_pattern_begun(text: &str, is_begun: bool, language: Language) -> Result<Pattern, CodeRefusal> {
    let own = with_hyphens(text);
    let text = own.as_deref().unwrap_or(text);
    let found = Pattern::parse_with_spans(text);
    // Letters that cannot be read: every code that could be meant.
    let unreadable = with_wildcards(text);
    let is_worn = unreadable.contains(['*', '?', '…']) || text.contains("...");
    let is_due = found.is_err() && text.len() <= WORN_MOST && (is_worn || is_begun);
    let readings = std::iter::once(unreadable.clone()).chain(with_further_fields(&unreadable));
    let worn = |text: String| {
        Pattern::parse_worn(&text, is_begun).filter(|worn| configurator::complete(worn).next().is_some())
    };
    if let Some(worn) = readings.filter(|_| is_due).find_map(worn) {
        return Ok(worn);
    }
    let (pattern, spans) =
        found.map_err(|errors| CodeRefusal { faults: spelling_faults(&errors, language), nearest: Vec::new() })?;
    let broken = configurator::broken_by_all(&pattern);
    if broken.is_empty() { Ok(pattern) } else { Err(rules_broken(text, &broken, &spans, language)) }
}

/// Returns the refusal with the broken rules, each at the place of its field, and the codes nearest to the first that
/// breaks them.
fn rules_broken(
    text: &str,
    broken: &[(OrderCode, BrokenRule)],
    spans: &[(Field, Range<usize>)],
    language: Language,
) -> CodeRefusal {
    let faults = broken.iter().map(|(code, rule)| {
        let span = spans.iter().find(|(field, _)| *field == rule.field);
        CodeFault {
            span: span.map_or(0..text.len(), |(_, span)| span.clone()),
            message: describe_rule(code, rule, language),
            hint: None,
            table: Some(rule.table),
        }
    });
    let nearest = broken.first().map(|(code, _)| configurator::nearest_to(code, PROPOSALS)).unwrap_or_default();
    CodeRefusal { faults: faults.collect(), nearest }
}

pub(crate) fn spelling_faults(errors: &CodeErrors, language: Language) -> Vec<CodeFault> {
    let understood = errors.understood(Field::Size);
    let size = understood.and_then(|word| Size::of(errors.series(), word));
    errors
        .iter()
        .map(|error| {
            let valid = valid_here(error, size);
            let hint = match error.nearest().filter(|near| valid.contains(near)) {
                Some(near) => Some(hint_text(&Hint::DidYouMean(near.to_owned()), language)),
                None if valid.is_empty() => None,
                None => {
                    let valid = valid.into_iter().map(str::to_owned).collect();
                    Some(hint_text(&Hint::ValidAre(valid), language))
                }
            };
            CodeFault { span: error.span(), message: describe_code_error(error, language), hint, table: None }
        })
        .collect()
}

/// Returns the valid words at a fault; if the size is known, only those of the size.
fn valid_here(error: &CodeError, size: Option<Size>) -> Vec<&'static str> {
    let Some(size) = size.filter(|_| !error.expected_fields().contains(&Field::Series)) else {
        return error.expected();
    };
    error.expected_fields().iter().flat_map(|field| configurator::tokens_of_size(*field, size)).copied().collect()
}

/// Returns the fields of a code, each with its token and meaning.
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

/// Returns every valid code with its availability, optionally only those that a partial code allows.
pub fn list_codes(pattern: Option<&Pattern>) -> Vec<&'static (OrderCode, Availability)> {
    match pattern {
        Some(pattern) => configurator::complete(pattern).collect(),
        None => configurator::all().iter().collect(),
    }
}

/// Returns the fields of a partial code, each with its valid choices.
#[must_use]
pub fn completion(pattern: &Pattern, language: Language) -> Vec<(Field, &'static str, Vec<Choice>)> {
    configurator::choices(pattern)
        .into_iter()
        .map(|(field, choices)| (field, describe_field(field, language), choices))
        .collect()
}
