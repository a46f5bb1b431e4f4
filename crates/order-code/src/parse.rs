//! Parser of ordering codes.

use crate::departure::Departure;
use crate::error::{CodeError, CodeErrors};
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use crate::grammar::Series;
use crate::scan::{ScannedText, scan};
use std::ops::Range;

/// Parses an ordering code in the grammar of the series whose word it begins with.
///
/// Lower case, other dashes, spaces and missing hyphens are understood and reported as [`Departure`]s. The example of
/// the manual has spaces around the hyphens and is therefore a departure too. White space other than spaces (tab, line
/// end) is accepted only around the code.
///
/// # Errors
/// Returns all faults with their positions. A text without hyphens is read up to its first unknown word and resumed at
/// the next word that fits, so that one fault may hide another.
pub fn parse(text: &str) -> Result<Parsed, CodeErrors> {
    let series = Series::of_text(text);
    let (tokens, departures) = scan(text, series, ScannedText::Code)?;
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

/// Fields with their byte ranges in a text.
pub type Spans = Vec<(Field, Range<usize>)>;

/// A parsed code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parsed {
    /// Code in the canonical form.
    pub code: OrderCode,
    /// Departures from the canonical spelling, in the order of the text.
    pub departures: Vec<Departure>,
    /// Fields present, with their byte ranges.
    pub spans: Spans,
}

impl Parsed {
    /// Returns `true` if the text has the canonical spelling.
    #[must_use]
    pub const fn is_canonical(&self) -> bool {
        self.departures.is_empty()
    }
}
