//! From text to code.

use crate::error::{CodeError, CodeErrors};
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use std::ops::Range;

/// Longest text that is read as a code, in characters.
const LENGTH_MAX: usize = 64;

/// How a text departs from the canonical spelling though it is understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Departure {
    /// A token in small letters.
    LowerCase {
        /// Place in the text.
        span: Range<usize>,
    },
    /// A space or another dash in place of a hyphen, or around one.
    Separator {
        /// Place in the text.
        span: Range<usize>,
    },
    /// Two tokens without a hyphen between them.
    MissingHyphen {
        /// Place between them.
        at: usize,
    },
    /// Space before or behind the code.
    SurroundingSpace,
}

/// A code that was understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parsed {
    /// The code.
    pub code: OrderCode,
    /// How the text departs from the canonical spelling.
    pub departures: Vec<Departure>,
    /// Each field that is present, with its place in the text.
    pub spans: Vec<(Field, Range<usize>)>,
}

impl Parsed {
    /// Whether the text was written canonically.
    #[must_use]
    pub const fn is_canonical(&self) -> bool {
        self.departures.is_empty()
    }
}

/// One token found in the text; the wildcard of a pattern has no token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) field: Field,
    pub(crate) token: Option<&'static str>,
    pub(crate) span: Range<usize>,
}

/// A part of the text between separators, in capitals.
struct Part {
    text: String,
    span: Range<usize>,
}

/// The parts of a text with the departures in its separators.
struct Parts {
    parts: Vec<Part>,
    departures: Vec<Departure>,
    faults: Vec<CodeError>,
}

fn is_dash(c: char) -> bool {
    matches!(c, '-' | '‐' | '‑' | '‒' | '–' | '—' | '−')
}

fn split(text: &str) -> Parts {
    let mut found = Parts { parts: Vec::new(), departures: Vec::new(), faults: Vec::new() };
    let trimmed = text.trim();
    if trimmed.len() != text.len() {
        found.departures.push(Departure::SurroundingSpace);
    }
    let offset = text.len() - text.trim_start().len();
    let mut rest = trimmed;
    let mut at = offset;
    while !rest.is_empty() {
        let separator = |c: char| is_dash(c) || c.is_whitespace();
        let part_end = rest.find(separator).unwrap_or(rest.len());
        let (part, tail) = rest.split_at(part_end);
        let span = at..at + part_end;
        if !part.is_empty() {
            found.parts.push(Part { text: part.to_ascii_uppercase(), span: span.clone() });
        }
        let gap_end = tail.find(|c: char| !separator(c)).unwrap_or(tail.len());
        let (gap, next) = tail.split_at(gap_end);
        let gap_span = span.end..span.end + gap_end;
        let dashes = gap.chars().filter(|c| is_dash(*c)).count();
        if dashes > 1 || (dashes == 1 && (part.is_empty() || next.is_empty())) {
            found.faults.push(CodeError::EmptyPart { span: gap_span.clone() });
        } else if !gap.is_empty() && gap != "-" {
            found.departures.push(Departure::Separator { span: gap_span.clone() });
        }
        at = gap_span.end;
        rest = next;
    }
    found
}

/// All ways to read a part as tokens of fields from `from` on, in order. With `wildcard`, `*` stands for the next field.
/// A mandatory field may not be skipped.
fn readings(part: &Part, from: usize, wildcard: bool) -> Vec<Vec<Found>> {
    let fields = Field::ALL.get(from..).unwrap_or_default();
    if wildcard && part.text == "*" {
        let any = fields.first().map(|field| Found { field: *field, token: None, span: part.span.clone() });
        return any.into_iter().map(|found| vec![found]).collect();
    }
    let mut all = Vec::new();
    read_on(part, 0, fields, &mut Vec::new(), &mut all);
    all
}

fn read_on(part: &Part, at: usize, fields: &'static [Field], so_far: &mut Vec<Found>, all: &mut Vec<Vec<Found>>) {
    let rest = part.text.get(at..).unwrap_or_default();
    if rest.is_empty() {
        all.push(so_far.clone());
        return;
    }
    for (index, field) in fields.iter().enumerate() {
        for token in field.tokens() {
            if rest.starts_with(token) {
                let start = part.span.start + at;
                so_far.push(Found { field: *field, token: Some(token), span: start..start + token.len() });
                read_on(part, at + token.len(), fields.get(index + 1..).unwrap_or_default(), so_far, all);
                so_far.pop();
            }
        }
        if !field.is_optional() {
            return;
        }
    }
}

/// The tokens of a text in the order of the fields, or every fault.
///
/// `partial`: a pattern, which may hold wildcards and stop early.
pub(crate) fn scan(text: &str, partial: bool) -> Result<(Vec<Found>, Vec<Departure>), CodeErrors> {
    if let Some((at, _)) = text.char_indices().nth(LENGTH_MAX) {
        let fault = CodeError::TooLong { span: at..text.len(), most: LENGTH_MAX };
        return Err(CodeErrors::new(vec![fault]));
    }
    let Parts { parts, mut departures, mut faults } = split(text);
    if parts.is_empty() && faults.is_empty() && !partial {
        return Err(CodeErrors::new(vec![CodeError::Empty]));
    }
    let mut tokens: Vec<Found> = Vec::new();
    let mut next = 0;
    for part in &parts {
        // Tokens of different fields never begin alike, so a part has at most one reading; the tests walk the whole
        // code space to hold this.
        match readings(part, next, partial).into_iter().next() {
            Some(reading) => {
                for pair in reading.windows(2) {
                    if let [_, second] = pair {
                        departures.push(Departure::MissingHyphen { at: second.span.start });
                    }
                }
                for found in reading {
                    next = position(found.field) + 1;
                    tokens.push(found);
                }
            }
            None => next = diagnose(part, next, &mut faults),
        }
    }
    if !partial {
        let end = parts.last().map_or(0, |part| part.span.end);
        for field in Field::ALL.get(next..).unwrap_or_default() {
            if !field.is_optional() {
                faults.push(CodeError::Missing { field: *field, at: end });
            }
        }
    }
    for found in &tokens {
        let written = text.get(found.span.clone()).unwrap_or_default();
        if found.token.is_some_and(|token| token != written) {
            departures.push(Departure::LowerCase { span: found.span.clone() });
        }
    }
    if faults.is_empty() {
        Ok((tokens, departures))
    } else {
        faults.sort_by_key(|fault| fault.span().start);
        Err(CodeErrors::new(faults))
    }
}

fn position(field: Field) -> usize {
    Field::ALL.iter().position(|known| *known == field).unwrap_or(0)
}

/// Says what is wrong with a part that cannot be read, and which field comes next.
fn diagnose(part: &Part, next: usize, faults: &mut Vec<CodeError>) -> usize {
    let (span, found) = (part.span.clone(), part.text.chars().take(24).collect::<String>());
    let expected = Field::ALL.get(next).copied();
    if let Some(field) = Field::of_token(&part.text) {
        let place = position(field);
        if place < next {
            let again = next > 0 && place + 1 == next;
            faults.push(if again {
                CodeError::Repeated { field, span, found }
            } else {
                CodeError::OutOfOrder { field, span, found }
            });
            return next;
        }
        // The token of a later field: what stands between is missing.
        for missing in Field::ALL.get(next..place).unwrap_or_default() {
            if !missing.is_optional() {
                faults.push(CodeError::Missing { field: *missing, at: span.start });
            }
        }
        return place + 1;
    }
    let field = match expected {
        Some(field) if field.is_optional() => nearest_optional(&part.text, next),
        Some(field) => field,
        None => Field::Special,
    };
    faults.push(CodeError::UnknownToken { field, span, found });
    (position(field) + 1).max(next)
}

/// Among the optional fields that may still come, the one with the nearest token.
fn nearest_optional(text: &str, next: usize) -> Field {
    let fields = Field::ALL.get(next..).unwrap_or_default();
    let distance = |field: &Field| {
        field.tokens().iter().map(|token| crate::edit_distance(text, token)).min().unwrap_or(usize::MAX)
    };
    fields.iter().copied().min_by_key(distance).unwrap_or(Field::Special)
}

/// Reads an ordering code.
///
/// Small letters, spaces and missing hyphens are understood and reported as [`Departure`]s; nothing is ever taken for
/// something else.
///
/// # Errors
/// Every fault with its place.
pub fn parse(text: &str) -> Result<Parsed, CodeErrors> {
    let (tokens, departures) = scan(text, false)?;
    let token = |field: Field| tokens.iter().find(|found| found.field == field).and_then(|found| found.token);
    let missing = |field| CodeErrors::new(vec![CodeError::Missing { field, at: text.len() }]);
    let code = OrderCode {
        size: token(Field::Size).and_then(Size::of).ok_or_else(|| missing(Field::Size))?,
        ratio: token(Field::Ratio).and_then(Ratio::of).ok_or_else(|| missing(Field::Ratio))?,
        winding: token(Field::Winding).and_then(Winding::of).ok_or_else(|| missing(Field::Winding))?,
        feedback: token(Field::Feedback).and_then(Feedback::of).ok_or_else(|| missing(Field::Feedback))?,
        brake: if token(Field::Brake).is_some() { Brake::With } else { Brake::Without },
        option_1: token(Field::Option1).and_then(Option1::of),
        option_2: token(Field::Option2).and_then(Option2::of),
        special: token(Field::Special).is_some(),
    };
    let spans = tokens.into_iter().map(|found| (found.field, found.span)).collect();
    Ok(Parsed { code, departures, spans })
}
