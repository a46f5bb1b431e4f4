//! From text to code.

use crate::error::{CodeError, CodeErrors};
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use crate::grammar::Series;
use crate::scan::{Form, scan};
use std::ops::Range;

/// Reads an ordering code, of the series whose word it begins with.
///
/// Small letters, other dashes, spaces and missing hyphens are understood and reported as [`Departure`]s. The manual
/// prints its example with spaces around the hyphens, so that departs too. White space other than spaces (tab, end of
/// line) is understood around the code only.
///
/// # Errors
/// Every fault with its place. A text without hyphens is read up to its first unknown word and on from the next word
/// that fits, so there one fault may hide another.
pub fn parse(text: &str) -> Result<Parsed, CodeErrors> {
    let series = Series::of_text(text);
    let (tokens, departures) = scan(text, series, Form::Code)?;
    let token = |field: Field| tokens.iter().find(|found| found.field == field).and_then(|found| found.token);
    let missing = |field| CodeErrors::from(CodeError::Missing { field, at: text.len(), series });
    let code = OrderCode {
        size: token(Field::Size).and_then(|word| Size::of(series, word)).ok_or_else(|| missing(Field::Size))?,
        ratio: token(Field::Ratio).and_then(|word| Ratio::of(series, word)).ok_or_else(|| missing(Field::Ratio))?,
        winding: token(Field::Winding)
            .and_then(|word| Winding::of(series, word))
            .ok_or_else(|| missing(Field::Winding))?,
        feedback: token(Field::Feedback)
            .and_then(|word| Feedback::of(series, word))
            .ok_or_else(|| missing(Field::Feedback))?,
        brake: if token(Field::Brake).is_some() { Brake::With } else { Brake::Without },
        option_1: token(Field::Option1).and_then(|word| Option1::of(series, word)),
        option_2: token(Field::Option2).and_then(|word| Option2::of(series, word)),
        special: token(Field::Special).is_some(),
    };
    let spans = tokens.into_iter().map(|found| (found.field, found.span)).collect();
    Ok(Parsed { code, departures, spans })
}

/// Fields with their places in a text, in bytes.
pub type Spans = Vec<(Field, Range<usize>)>;

/// A code that was understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parsed {
    /// The code.
    pub code: OrderCode,
    /// How the text departs from the canonical spelling, in the order of the text.
    pub departures: Vec<Departure>,
    /// Each field that is present, with its place in the text, in bytes.
    pub spans: Spans,
}

impl Parsed {
    /// Whether the text was written canonically.
    #[must_use]
    pub const fn is_canonical(&self) -> bool {
        self.departures.is_empty()
    }
}

/// How a text departs from the canonical spelling though it is understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Departure {
    /// A word with small letters.
    LowerCase {
        /// Place of the word.
        span: Range<usize>,
    },
    /// Spaces in place of a hyphen, or around one.
    Spaces {
        /// Place of the separator, with its hyphen.
        span: Range<usize>,
    },
    /// Another dash in place of the hyphen: `‐ ‑ ‒ – — ― −`.
    OtherDash {
        /// Place of the dash.
        span: Range<usize>,
    },
    /// Two words without a hyphen between them.
    MissingHyphen {
        /// Place between them.
        at: usize,
    },
    /// White space before or behind the code.
    SurroundingSpace,
}

impl Departure {
    /// Place in the text, in bytes; empty where a hyphen is missing, and `None` for the space around the code.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::LowerCase { span } | Self::Spaces { span } | Self::OtherDash { span } => Some(span.clone()),
            Self::MissingHyphen { at } => Some(*at..*at),
            Self::SurroundingSpace => None,
        }
    }
}
