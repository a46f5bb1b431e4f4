//! Reasons why a text is no quantity.

use crate::Language;
use crate::dimension::Dimension;
use crate::units::Unit;
use std::ops::Range;
use thiserror::Error;

/// Reason why a text is no quantity, with its place in the text.
///
/// `Display` is for developers who use this crate; texts for users are in `words`, in both languages.
/// The texts in `found` are shortened to 40 characters.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// The text is empty or blank.
    #[error("empty, expected {} such as \"{}\"", en(*expected), expected.example())]
    Empty {
        /// Place in the text, in bytes: all of it.
        span: Range<usize>,
        /// Expected quantity.
        expected: Dimension,
    },
    /// There is a unit without a number.
    #[error("the number is missing before \"{found}\", expected {} such as \"{}\"", en(*expected), expected.example())]
    NumberMissing {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// Unit as written.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The text in place of the number is none, or is grouped with spaces or dots.
    #[error("\"{found}\" is not a number")]
    NumberUnreadable {
        /// Place in the text, in bytes.
        span: Range<usize>,
        /// Text in place of the number.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The number has a decimal comma.
    #[error("decimal comma in \"{found}\"")]
    DecimalComma {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// The number as written.
        found: String,
    },
    /// The number is infinite, no number, or too large to be represented.
    #[error("\"{found}\" is not a finite number")]
    NotFinite {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// Number as written.
        found: String,
    },
    /// There is a number without a unit.
    #[error("the unit is missing, expected {} such as \"{}\"", en(*expected), expected.example())]
    UnitMissing {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The unit is unknown.
    #[error("unknown unit \"{found}\"")]
    UnitUnknown {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// Unit as written.
        found: String,
        /// Expected quantity.
        expected: Dimension,
        /// Unit of the expected quantity with the most similar spelling, if one is close.
        nearest: Option<&'static Unit>,
    },
    /// The unit belongs to another quantity.
    #[error(
        "\"{found}\" is a unit of {}, expected a unit of {}",
        measures.name(Language::OF_ERRORS),
        expected.name(Language::OF_ERRORS)
    )]
    WrongQuantity {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// Unit as written.
        found: String,
        /// Quantity measured by the unit.
        measures: Dimension,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The unit of a flywheel effect GD² in place of a moment of inertia, four times as large.
    #[error("\"{found}\" is a unit of GD², expected a moment of inertia J = GD²/4")]
    FlywheelEffect {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// Unit as written.
        found: String,
    },
    /// The sign of a tolerance is followed by nothing.
    #[error("the half-width of the tolerance is missing")]
    ToleranceMissing {
        /// Place of the sign in the text, in bytes.
        span: Range<usize>,
    },
    /// The half-width of a tolerance is negative.
    #[error("the half-width of a tolerance must not be negative")]
    ToleranceNegative {
        /// Place of the half-width in the text, in bytes.
        span: Range<usize>,
    },
    /// A percentage of a temperature in °C.
    #[error("a percent of a temperature in °C has no meaning: its zero is arbitrary")]
    ToleranceOfOffsetScale {
        /// Place of the half-width in the text, in bytes.
        span: Range<usize>,
    },
}

fn en(dimension: Dimension) -> &'static str {
    dimension.name_with_article(Language::OF_ERRORS)
}

impl QuantityError {
    /// Returns the offending part of the text, in bytes; always at character boundaries.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.clone().span_mut().clone()
    }

    /// Returns the place of the offending part of the text, to change it.
    pub(crate) const fn span_mut(&mut self) -> &mut Range<usize> {
        match self {
            Self::Empty { span, .. }
            | Self::NumberMissing { span, .. }
            | Self::NumberUnreadable { span, .. }
            | Self::DecimalComma { span, .. }
            | Self::NotFinite { span, .. }
            | Self::UnitMissing { span, .. }
            | Self::UnitUnknown { span, .. }
            | Self::WrongQuantity { span, .. }
            | Self::FlywheelEffect { span, .. }
            | Self::ToleranceMissing { span }
            | Self::ToleranceNegative { span }
            | Self::ToleranceOfOffsetScale { span } => span,
        }
    }
}
