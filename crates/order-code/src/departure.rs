//! Departures from the canonical spelling of a code.

use std::ops::Range;

/// A departure from the canonical spelling that is understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Departure {
    /// A word with lower-case letters.
    LowerCase {
        /// Bytes of the word.
        span: Range<usize>,
    },
    /// Spaces instead of a hyphen or around it.
    Spaces {
        /// Bytes of the separator, including its hyphen.
        span: Range<usize>,
    },
    /// Another dash instead of the hyphen: `‐ ‑ ‒ – — ― −`.
    OtherDash {
        /// Bytes of the dash.
        span: Range<usize>,
    },
    /// Two words without a hyphen between them.
    MissingHyphen {
        /// Byte offset between the words.
        at: usize,
    },
    /// White space before or after the code.
    SurroundingSpace,
}

impl Departure {
    /// Returns the byte range of the departure; empty for a missing hyphen, `None` for surrounding white space.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        match self {
            Self::LowerCase { span } | Self::Spaces { span } | Self::OtherDash { span } => Some(span.clone()),
            Self::MissingHyphen { at } => Some(*at..*at),
            Self::SurroundingSpace => None,
        }
    }
}
