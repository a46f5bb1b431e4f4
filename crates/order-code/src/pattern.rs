//! Partial codes, such as `CHA-20A-100-H-*`.

use crate::error::CodeErrors;
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use crate::grammar::Series;
use crate::parse::Spans;
use crate::scan::{ScannedText, scan};

/// Condition on one field of a partial code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slot<T> {
    /// Any value, or none if the field is optional.
    #[default]
    Any,
    /// Exactly this value.
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

/// A partial code for completion and listing: `CHA-20A-100-H-*`, `CHA-20A`, `CHA-*-100-*-M512P-B`, or the empty text.
///
/// `*` stands for any value of one field, or for the absence of an optional one. Fields that the text does not name are
/// open: all those after its end, and optional fields that it skips. The text cannot require absence; set the slot
/// instead.
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
    /// Series of the actuator.
    pub series: Slot<Series>,
    /// Frame size and version letter.
    pub size: Slot<Size>,
    /// Reduction ratio.
    pub ratio: Slot<Ratio>,
    /// Motor winding and connector configuration.
    pub winding: Slot<Winding>,
    /// Motor feedback.
    pub feedback: Slot<Feedback>,
    /// Holding brake.
    pub brake: Slot<Brake>,
    /// Option 1, sensor at the output.
    pub option_1: Slot<Option<Option1>>,
    /// Option 2, cable and connector exit.
    pub option_2: Slot<Option<Option2>>,
    /// Special design.
    pub special: Slot<bool>,
}

impl Pattern {
    /// Parses a partial code with the tolerance of [`parse`](crate::parse()) for spelling.
    ///
    /// `*` stands alone between hyphens; `20A*` and `1?0` are faults, because shell patterns are not supported.
    ///
    /// # Errors
    /// Returns all faults with their positions, a final hyphen among them.
    pub fn parse(text: &str) -> Result<Self, CodeErrors> {
        Self::parse_with_spans(text).map(|(pattern, _)| pattern)
    }

    /// Parses a partial code and also returns the byte range of each field that the text names.
    ///
    /// # Errors
    /// See [`Pattern::parse`].
    pub fn parse_with_spans(text: &str) -> Result<(Self, Spans), CodeErrors> {
        let series = Series::of_text(text);
        let (tokens, _) = scan(text, series, ScannedText::Pattern)?;
        let token = |field: Field| tokens.iter().find(|found| found.field == field).and_then(|found| found.token);
        let named = tokens.iter().filter(|found| found.token.is_some());
        Ok((Self::of(series, token), named.map(|found| (found.field, found.span.clone())).collect()))
    }

    /// Creates a pattern from the words of some fields; fields for which `word` returns `None` stay open.
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

    /// Returns `true` if the pattern allows `code`.
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
