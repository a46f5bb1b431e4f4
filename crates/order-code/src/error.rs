//! Faults in the spelling of a code.

use crate::field::Field;
use crate::grammar::Series;
use std::ops::{Deref, Range};
use thiserror::Error;

/// A fault of a code.
///
/// The hint is separate from the message: [`Self::nearest`], or [`Self::expected`] if no word is near.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CodeError {
    /// The text is empty.
    #[error("the code is empty")]
    Empty,
    /// The text is longer than any code.
    #[error("the code is longer than {most} characters")]
    TooLong {
        /// Bytes beyond the limit.
        span: Range<usize>,
        /// Length limit in characters.
        most: usize,
    },
    /// A separator without a word on one side: two hyphens in a row, or a hyphen at the beginning or the end.
    #[error("nothing stands at this hyphen")]
    EmptyPart {
        /// Bytes of the separator.
        span: Range<usize>,
        /// Fields allowed after a final hyphen; empty at any other hyphen, which is surplus.
        expected: Expected,
    },
    /// The text is no word of the expected field.
    #[error("{found:?} is no {field}")]
    UnknownToken {
        /// Field expected here; if several are allowed, the one with the nearest word.
        field: Field,
        /// Bytes of the unknown word.
        span: Range<usize>,
        /// Text found, cut after 24 characters.
        found: String,
        /// Fields allowed here, in the order of the code; empty behind a complete code.
        expected: Expected,
    },
    /// A known word whose field belongs to another position.
    #[error("{field} {found:?} stands in the wrong place")]
    OutOfOrder {
        /// Field of the word.
        field: Field,
        /// Bytes of the word.
        span: Range<usize>,
        /// Text found.
        found: String,
        /// Fields allowed here.
        expected: Expected,
    },
    /// A field that was already given.
    #[error("{field} is given twice, here as {found:?}")]
    Repeated {
        /// Repeated field.
        field: Field,
        /// Bytes of the second word.
        span: Range<usize>,
        /// Text found.
        found: String,
        /// Fields allowed here.
        expected: Expected,
    },
    /// A mandatory field is missing.
    #[error("{field} is missing")]
    Missing {
        /// Missing field.
        field: Field,
        /// Byte offset where its word should stand.
        at: usize,
        /// Series of the code.
        series: Series,
    },
    /// Words without hyphens that can be read in more than one way.
    ///
    /// Impossible with the words of the embedded series (see the grammar); kept so that a new word cannot lead to a
    /// guess.
    #[error("{found:?} can be read as {}", .readings.join(" or "))]
    Ambiguous {
        /// Bytes of the ambiguous part.
        span: Range<usize>,
        /// Text found.
        found: String,
        /// Possible readings, with hyphens.
        readings: Vec<String>,
    },
}

impl CodeError {
    /// Returns the byte range of the fault; empty where something is missing.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Empty => 0..0,
            Self::Missing { at, .. } => *at..*at,
            Self::TooLong { span, .. }
            | Self::EmptyPart { span, .. }
            | Self::UnknownToken { span, .. }
            | Self::OutOfOrder { span, .. }
            | Self::Repeated { span, .. }
            | Self::Ambiguous { span, .. } => span.clone(),
        }
    }

    /// Returns the words allowed at the fault.
    #[must_use]
    pub fn expected(&self) -> Vec<&'static str> {
        let series = match self {
            Self::Empty | Self::TooLong { .. } | Self::Ambiguous { .. } => Series::default(),
            Self::Missing { series, .. } => *series,
            Self::EmptyPart { expected, .. }
            | Self::UnknownToken { expected, .. }
            | Self::OutOfOrder { expected, .. }
            | Self::Repeated { expected, .. } => expected.series,
        };
        let fields = self.expected_fields();
        // The series is known only after its word.
        if fields == [Field::Series] {
            return Series::all().map(Series::as_str).collect();
        }
        fields.iter().flat_map(|field| series.words(*field)).copied().collect()
    }

    /// Returns the fields whose words are allowed at the fault.
    #[must_use]
    pub fn expected_fields(&self) -> &[Field] {
        match self {
            Self::Empty => &[Field::Series],
            Self::Missing { field, .. } => std::slice::from_ref(field),
            Self::EmptyPart { expected, .. }
            | Self::UnknownToken { expected, .. }
            | Self::OutOfOrder { expected, .. }
            | Self::Repeated { expected, .. } => &expected.fields,
            Self::TooLong { .. } | Self::Ambiguous { .. } => &[],
        }
    }

    /// Returns the valid word nearest to the text found, if its edit distance is at most half of its length.
    #[must_use]
    pub fn nearest(&self) -> Option<&'static str> {
        match self {
            Self::UnknownToken { found, expected, .. } => {
                nearest_token(found, expected.series, &expected.fields).map(|(_, token)| token)
            }
            _ => None,
        }
    }
}

/// Fields allowed at a position, in the order of the code, with the series that defines their words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    pub(crate) series: Series,
    pub(crate) fields: Vec<Field>,
}

impl Deref for Expected {
    type Target = [Field];

    fn deref(&self) -> &[Field] {
        &self.fields
    }
}

/// Returns the word of the given fields that is nearest to `found`, with its field. Among equally near words the one
/// with the longest common beginning wins, then the first in the order of the fields.
pub(crate) fn nearest_token(found: &str, series: Series, fields: &[Field]) -> Option<(Field, &'static str)> {
    let found = found.chars().take(16).collect::<String>().to_ascii_uppercase();
    fields
        .iter()
        .flat_map(|field| series.words(*field).iter().map(move |token| (*field, *token)))
        .map(|(field, token)| (strsim::osa_distance(&found, token), field, token))
        .filter(|(distance, _, token)| distance * 2 <= token.len())
        .min_by_key(|(distance, _, token)| (*distance, std::cmp::Reverse(common_beginning(&found, token))))
        .map(|(_, field, token)| (field, token))
}

fn common_beginning(a: &str, b: &str) -> usize {
    a.bytes().zip(b.bytes()).take_while(|(a, b)| a.eq_ignore_ascii_case(b)).count()
}

/// Faults of one code, in the order of the text; at least one.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}", joined(.faults))]
pub struct CodeErrors {
    faults: Vec<CodeError>,
    series: Series,
    understood: Vec<(Field, &'static str)>,
}

fn joined(faults: &[CodeError]) -> String {
    let sentences: Vec<String> = faults.iter().map(ToString::to_string).collect();
    sentences.join("; ")
}

impl CodeErrors {
    /// Creates the list from faults, which are sorted by position, and the words that were understood. `faults` must
    /// not be empty.
    pub(crate) fn new(mut faults: Vec<CodeError>, series: Series, understood: Vec<(Field, &'static str)>) -> Self {
        faults.sort_by_key(|fault| fault.span().start);
        Self { faults, series, understood }
    }

    /// Returns the series in whose grammar the text was read.
    #[must_use]
    pub const fn series(&self) -> Series {
        self.series
    }

    /// Returns the word of a field that was understood despite the faults.
    #[must_use]
    pub fn understood(&self, field: Field) -> Option<&'static str> {
        self.understood.iter().find(|(known, _)| *known == field).map(|(_, token)| *token)
    }

    /// Iterates over the faults, in the order of the text.
    pub fn iter(&self) -> std::slice::Iter<'_, CodeError> {
        self.faults.iter()
    }
}

impl From<CodeError> for CodeErrors {
    fn from(fault: CodeError) -> Self {
        Self { faults: vec![fault], series: Series::default(), understood: Vec::new() }
    }
}

impl<'a> IntoIterator for &'a CodeErrors {
    type Item = &'a CodeError;
    type IntoIter = std::slice::Iter<'a, CodeError>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
