//! What can be wrong with the spelling of a code.

use crate::field::Field;
use std::ops::Range;
use thiserror::Error;

/// One fault of a code.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
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
    /// Nothing stands between two hyphens, or behind the last one.
    #[error("nothing stands at this hyphen")]
    EmptyPart {
        /// Place of the hyphen.
        span: Range<usize>,
    },
    /// No token of this field.
    #[error("\"{found}\" is no {field}")]
    UnknownToken {
        /// Field expected here.
        field: Field,
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
    },
    /// A token that belongs to an earlier field.
    #[error("{field} \"{found}\" stands in the wrong place")]
    OutOfOrder {
        /// Field that the token belongs to.
        field: Field,
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
    },
    /// A field for the second time.
    #[error("{field} is given twice, here as \"{found}\"")]
    Repeated {
        /// Field.
        field: Field,
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
    },
    /// A field that may not be left out.
    #[error("{field} is missing")]
    Missing {
        /// Field.
        field: Field,
        /// Place where it should stand.
        at: usize,
    },
}

impl CodeError {
    /// The offending part of the text, in bytes.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Empty => 0..0,
            Self::Missing { at, .. } => *at..*at,
            Self::TooLong { span, .. }
            | Self::EmptyPart { span }
            | Self::UnknownToken { span, .. }
            | Self::OutOfOrder { span, .. }
            | Self::Repeated { span, .. } => span.clone(),
        }
    }

    /// The tokens that would be valid here.
    #[must_use]
    pub const fn expected(&self) -> &'static [&'static str] {
        match self {
            Self::UnknownToken { field, .. } | Self::Missing { field, .. } => field.tokens(),
            Self::Empty => Field::Series.tokens(),
            _ => &[],
        }
    }

    /// The valid token that is nearest to what stands here, if one is near.
    #[must_use]
    pub fn nearest(&self) -> Option<&'static str> {
        let Self::UnknownToken { field, found, .. } = self else { return None };
        let found: String = found.chars().take(16).collect();
        field
            .tokens()
            .iter()
            .map(|token| (crate::edit_distance(&found, token), *token))
            .min()
            .filter(|(distance, token)| *distance * 2 <= token.len())
            .map(|(_, token)| token)
    }
}

/// Every fault of a code; never empty.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}", first(.faults))]
pub struct CodeErrors {
    faults: Vec<CodeError>,
}

fn first(faults: &[CodeError]) -> String {
    faults.first().map(ToString::to_string).unwrap_or_default()
}

impl CodeErrors {
    pub(crate) fn new(faults: Vec<CodeError>) -> Self {
        Self { faults }
    }

    /// The faults, in the order of the text.
    pub fn iter(&self) -> impl Iterator<Item = &CodeError> {
        self.faults.iter()
    }
}
