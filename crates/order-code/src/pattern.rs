//! Partial codes, such as `CHA-20A-100-H-*`.

use crate::error::CodeErrors;
use crate::field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
use crate::grammar::{FieldWords, Series};
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
    /// Words left by the wildcards within fields, for each assignment of the parts of the text to fields.
    worn: [Option<Worn>; READINGS_MOST],
}

/// Largest number of assignments of parts to optional fields: two of four.
const READINGS_MOST: usize = 6;

/// Words of each field that a text with wildcards leaves, as bits in the order of the ordering tables; `None` for all.
type Worn = [Option<u64>; Field::ALL.len()];

impl Pattern {
    /// Parses a partial code with the tolerance of [`parse`](crate::parse()) for spelling.
    ///
    /// `*` stands alone between hyphens; `20A*` and `1?0` are faults here, see [`Pattern::parse_worn`].
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

    /// Parses a code of which letters are unreadable or missing: `?` is one letter, `*` and `…` (or `...`) are any letters
    /// within a field, as in `CHA-25A-1?0-H-M…`. With `is_begun` the last field may end within its word. `None` if the text
    /// allows no word of a field, or has no hyphen between two fields.
    #[must_use]
    pub fn parse_worn(text: &str, is_begun: bool) -> Option<Self> {
        let series = Series::of_text(text);
        let capitals = text.trim().to_ascii_uppercase().replace('…', "*").replace("...", "*");
        let parts: Vec<&str> = capitals.split('-').map(str::trim).collect();
        let mut readings: Vec<Worn> = Vec::new();
        read_worn(&parts, series.words_of_fields(), is_begun, Worn::default(), &mut readings);
        let mut pattern = Self::default();
        if readings.is_empty() || readings.len() > READINGS_MOST {
            return None;
        }
        for (slot, reading) in pattern.worn.iter_mut().zip(readings) {
            *slot = Some(reading);
        }
        Some(pattern)
    }

    /// Returns `true` if the words left by wildcards allow `code`.
    fn is_worn_like(&self, code: &OrderCode) -> bool {
        let mut readings = self.worn.iter().flatten().peekable();
        readings.peek().is_none() || readings.any(|worn| is_read_as(code, worn))
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
            worn: [None; READINGS_MOST],
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
            && self.is_worn_like(code)
    }
}

/// Returns `true` if the words left by one reading of a text allow `code`.
fn is_read_as(code: &OrderCode, worn: &Worn) -> bool {
    let fields = Field::ALL.iter().zip(worn).filter_map(|(field, mask)| Some((*field, (*mask)?)));
    fields.into_iter().all(|(field, mask)| {
        let words = code.series().words(field);
        let place = code.token(field).and_then(|token| words.iter().position(|word| *word == token));
        place.is_some_and(|place| mask >> place & 1 == 1)
    })
}

/// Adds every assignment of parts with wildcards to the fields that may follow: an optional field may be skipped.
fn read_worn(parts: &[&str], fields: &[FieldWords], is_begun: bool, worn: Worn, readings: &mut Vec<Worn>) {
    let Some((part, further)) = parts.split_first() else {
        readings.push(worn);
        return;
    };
    if part.is_empty() {
        // A hyphen at the end begins the next field.
        if is_begun && further.is_empty() {
            readings.push(worn);
        }
        return;
    }
    let Some((known, behind)) = fields.split_first() else { return };
    if *part == "*" {
        read_worn(further, behind, is_begun, worn, readings);
        return;
    }
    let begun = if is_begun && further.is_empty() { format!("{part}*") } else { (*part).to_owned() };
    let bits = (0..).zip(known.words).filter(|(_, word)| is_like(word.as_bytes(), begun.as_bytes()));
    let mask = bits.fold(0_u64, |mask, (bit, _)| mask | 1 << bit);
    let slot = Field::ALL.iter().position(|field| *field == known.field);
    if let (Some(slot), true) = (slot, mask != 0) {
        let mut worn = worn;
        if let Some(place) = worn.get_mut(slot) {
            *place = Some(mask);
        }
        read_worn(further, behind, is_begun, worn, readings);
    }
    if known.is_optional {
        read_worn(parts, behind, is_begun, worn, readings);
    }
}

/// Returns `true` if a word is like a text with wildcards: `?` for one letter, `*` for any number.
fn is_like(word: &[u8], text: &[u8]) -> bool {
    match (word, text) {
        // Of stars one after the other a single one counts.
        (_, [b'*', rest @ ..]) if rest.first() == Some(&b'*') => is_like(word, rest),
        (_, [b'*', rest @ ..]) => (0..=word.len()).any(|from| word.get(from..).is_some_and(|word| is_like(word, rest))),
        ([letter, word @ ..], [sign, rest @ ..]) => (*sign == b'?' || letter == sign) && is_like(word, rest),
        (word, text) => word.is_empty() && text.is_empty(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;
    use crate::parse;

    #[test]
    fn unreadable_letters_allow_every_code_that_could_be_meant() {
        let allows =
            |text: &str, code: &str| Pattern::parse_worn(text, false).unwrap().matches(&parse(code).unwrap().code);
        for (text, code, is_meant) in [
            ("CHA-25A-1?0-H-M…", "CHA-25A-120-H-M512P-B", true),
            ("CHA-25A-1?0-H-M...", "CHA-25A-100-H-M128S", true),
            ("cha-25a-1?0-h-m*", "CHA-25A-50-H-M512P", false),
            ("CHA-25A-1?0-H-M…", "CHA-25A-120-H-C1024", false),
            ("CHA-*-100-?-C*-B", "CHA-20A-100-N-C1024-B", true),
            ("CHA-*-100-?-C*-B", "CHA-20A-100-N-C1024", false),
            ("CHA-2?A", "CHA-20A-100-N-C1024", true),
        ] {
            assert_eq!(allows(text, code), is_meant, "{text} {code}");
        }
        for text in ["CHA-25A-7?", "CHA-25A-1?0-H-Q*", "X?", "CHA--100", "CHA-25A-1?0H"] {
            assert_eq!(Pattern::parse_worn(text, false), None, "{text}");
        }
        let begun = Pattern::parse_worn("CHA-25A-1", true).unwrap();
        assert!(begun.matches(&parse("CHA-25A-160-H-M512P").unwrap().code));
        assert!(!begun.matches(&parse("CHA-25A-50-H-M512P").unwrap().code));
        assert!(Pattern::parse_worn("CHA-25A-", true).is_some() && Pattern::parse_worn("CHA-25A-", false).is_none());
    }
}
