//! What can be wrong with the spelling of a code.

use crate::field::Field;
use crate::grammar::Series;
use std::ops::{Deref, Range};
use thiserror::Error;

/// One fault of a code.
///
/// The hint is apart from the message: [`Self::nearest`] or else [`Self::expected`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CodeError {
    /// There is nothing.
    #[error("the code is empty")]
    Empty,
    /// Longer than any code.
    #[error("the code is longer than {most} characters")]
    TooLong {
        /// Place of what is too much.
        span: Range<usize>,
        /// Longest text that is read.
        most: usize,
    },
    /// Nothing stands between two hyphens, before the first one or behind the last one.
    #[error("nothing stands at this hyphen")]
    EmptyPart {
        /// Place of the hyphen.
        span: Range<usize>,
        /// Fields that could stand behind the last hyphen; empty at any other hyphen, which is simply too much.
        expected: Expected,
    },
    /// No word of the field that is expected here.
    #[error("{found:?} is no {field}")]
    UnknownToken {
        /// Field expected here; where several may stand, the one with the nearest word.
        field: Field,
        /// Place in the text.
        span: Range<usize>,
        /// What stands there, cut after 24 characters.
        found: String,
        /// Every field that could stand here, in their order; none behind a complete code.
        expected: Expected,
    },
    /// A word of another field, and that field belongs to another place.
    #[error("{field} {found:?} stands in the wrong place")]
    OutOfOrder {
        /// Field that the word belongs to.
        field: Field,
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// Every field that could stand here.
        expected: Expected,
    },
    /// A field for the second time.
    #[error("{field} is given twice, here as {found:?}")]
    Repeated {
        /// Field.
        field: Field,
        /// Place of the second.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// Every field that could stand here.
        expected: Expected,
    },
    /// A field that may not be left out.
    #[error("{field} is missing")]
    Missing {
        /// Field.
        field: Field,
        /// Place where it should stand.
        at: usize,
        /// Series of the code.
        series: Series,
    },
    /// Words without hyphens that can be read in more than one way.
    ///
    /// Cannot happen with the words of today, see the grammar; it stands here so that a new word cannot bring a guess.
    #[error("{found:?} can be read as {}", .readings.join(" or "))]
    Ambiguous {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// The readings, with hyphens.
        readings: Vec<String>,
    },
}

impl CodeError {
    /// The offending part of the text, in bytes; empty where something is missing.
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

    /// The words that would be valid here.
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
        // Which series it is shows with the first word only.
        if fields == [Field::Series] {
            return Series::all().map(Series::as_str).collect();
        }
        fields.iter().flat_map(|field| series.words(*field)).copied().collect()
    }

    /// The fields of which a word would be valid here.
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

    /// The valid word that is nearest to what stands here, if one is near: at most half of its letters are wrong.
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

/// The fields of which a word could stand at a place, in their order, with the series that has the words.
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

/// Among the words of some fields the one that is nearest to a text, with its field. Of several as near, the one that
/// begins most like the text, then the first in the order of the fields.
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

/// Every fault of a code, in the order of the text; at least one.
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
    /// Several faults, sorted by their place, and the words that were understood. The caller has at least one fault.
    pub(crate) fn new(mut faults: Vec<CodeError>, series: Series, understood: Vec<(Field, &'static str)>) -> Self {
        faults.sort_by_key(|fault| fault.span().start);
        Self { faults, series, understood }
    }

    /// The series that the text was read as a code of.
    #[must_use]
    pub const fn series(&self) -> Series {
        self.series
    }

    /// The word of a field that was understood in spite of the faults.
    #[must_use]
    pub fn understood(&self, field: Field) -> Option<&'static str> {
        self.understood.iter().find(|(known, _)| *known == field).map(|(_, token)| *token)
    }

    /// The faults, in the order of the text.
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
