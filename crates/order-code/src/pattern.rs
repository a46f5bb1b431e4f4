//! Partial codes: `CHA-20A-100-H-*`.

use crate::error::CodeErrors;
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use crate::grammar::Series;
use crate::parse::Spans;
use crate::scan::{Form, scan};

/// One field of a partial code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slot<T> {
    /// Anything, or nothing where the field is optional.
    #[default]
    Any,
    /// This value.
    Exactly(T),
}

impl<T: PartialEq> Slot<T> {
    fn allows(&self, value: &T) -> bool {
        match self {
            Self::Any => true,
            Self::Exactly(wanted) => wanted == value,
        }
    }
}

/// A partial code, for completing and listing: `CHA-20A-100-H-*`, `CHA-20A`, `CHA-*-100-*-M512P-B`, or nothing at all.
///
/// `*` stands for any value of one field, or for the absence of an optional one. What the text does not name is open:
/// everything behind its end, and an optional field that it passes over may be there or not. Absence cannot be written;
/// set the slot instead.
///
/// ```
/// use order_code::{Brake, Pattern, Slot, parse};
///
/// let mut pattern = Pattern::parse("CHA-20A-100-H-C1024")?;
/// let braked = parse("CHA-20A-100-H-C1024-B")?.code;
/// assert!(pattern.matches(&braked));
/// pattern.brake = Slot::Exactly(Brake::Without);
/// assert!(!pattern.matches(&braked));
/// # Ok::<(), order_code::CodeErrors>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pattern {
    /// Series.
    pub series: Slot<Series>,
    /// Frame size.
    pub size: Slot<Size>,
    /// Reduction ratio.
    pub ratio: Slot<Ratio>,
    /// Motor winding and connectors.
    pub winding: Slot<Winding>,
    /// Motor feedback.
    pub feedback: Slot<Feedback>,
    /// Brake.
    pub brake: Slot<Brake>,
    /// Sensor option.
    pub option_1: Slot<Option<Option1>>,
    /// Cable and connector option.
    pub option_2: Slot<Option<Option2>>,
    /// Special design.
    pub special: Slot<bool>,
}

impl Pattern {
    /// Reads a partial code, as tolerant of spelling as [`parse`](crate::parse()).
    ///
    /// `*` stands alone between hyphens: `20A*` and `1?0` are faults, no shell patterns.
    ///
    /// # Errors
    /// Every fault with its place; a hyphen at the end is one.
    pub fn parse(text: &str) -> Result<Self, CodeErrors> {
        Self::parse_with_spans(text).map(|(pattern, _)| pattern)
    }

    /// The same, and each field that the text names, with its place in bytes.
    ///
    /// # Errors
    /// As [`Pattern::parse`].
    pub fn parse_with_spans(text: &str) -> Result<(Self, Spans), CodeErrors> {
        let series = Series::of_text(text);
        let (tokens, _) = scan(text, series, Form::Pattern)?;
        let token = |field: Field| tokens.iter().find(|found| found.field == field).and_then(|found| found.token);
        let named = tokens.iter().filter(|found| found.token.is_some());
        Ok((Self::of(series, token), named.map(|found| (found.field, found.span.clone())).collect()))
    }

    /// The codes of a series that have these words, each a word of its field; a field without one is open.
    #[must_use]
    pub fn of<'w>(series: Series, word: impl Fn(Field) -> Option<&'w str>) -> Self {
        Self {
            series: word(Field::Series).map_or(Slot::Any, |_| Slot::Exactly(series)),
            size: word(Field::Size).and_then(|word| Size::of(series, word)).map_or(Slot::Any, Slot::Exactly),
            ratio: word(Field::Ratio).and_then(|word| Ratio::of(series, word)).map_or(Slot::Any, Slot::Exactly),
            winding: word(Field::Winding).and_then(|word| Winding::of(series, word)).map_or(Slot::Any, Slot::Exactly),
            feedback: word(Field::Feedback)
                .and_then(|word| Feedback::of(series, word))
                .map_or(Slot::Any, Slot::Exactly),
            brake: word(Field::Brake).map_or(Slot::Any, |_| Slot::Exactly(Brake::With)),
            option_1: word(Field::Option1).map_or(Slot::Any, |word| Slot::Exactly(Option1::of(series, word))),
            option_2: word(Field::Option2).map_or(Slot::Any, |word| Slot::Exactly(Option2::of(series, word))),
            special: word(Field::Special).map_or(Slot::Any, |_| Slot::Exactly(true)),
        }
    }

    /// Whether a code is among those that the pattern allows.
    #[must_use]
    pub fn matches(&self, code: &OrderCode) -> bool {
        self.series.allows(&code.series())
            && self.size.allows(&code.size)
            && self.ratio.allows(&code.ratio)
            && self.winding.allows(&code.winding)
            && self.feedback.allows(&code.feedback)
            && self.brake.allows(&code.brake)
            && self.option_1.allows(&code.option_1)
            && self.option_2.allows(&code.option_2)
            && self.special.allows(&code.special)
    }
}
