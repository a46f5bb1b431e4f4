//! Identifiers of the faults of lower crates, which need none themselves.

use order_code::CodeError;
use quantities::QuantityError;

/// Returns the identifier of a text that is no quantity.
pub(crate) const fn quantity(error: &QuantityError) -> &'static str {
    match error {
        QuantityError::Empty { .. } => "quantity_empty",
        QuantityError::NumberMissing { .. } => "number_missing",
        QuantityError::NumberUnreadable { .. } => "number_unreadable",
        QuantityError::DecimalComma { .. } => "decimal_comma",
        QuantityError::NotFinite { .. } => "not_finite",
        QuantityError::UnitMissing { .. } => "unit_missing",
        QuantityError::UnitUnknown { .. } => "unit_unknown",
        QuantityError::WrongQuantity { .. } => "unit_of_another_quantity",
        QuantityError::FlywheelEffect { .. } => "unit_of_flywheel_effect",
        QuantityError::ToleranceMissing { .. } => "tolerance_missing",
        QuantityError::ToleranceNegative { .. } => "tolerance_negative",
        QuantityError::ToleranceOfOffsetScale { .. } => "tolerance_of_offset_scale",
    }
}

/// Returns the identifier of a code that cannot be read.
pub(crate) const fn code(error: &CodeError) -> &'static str {
    match error {
        CodeError::Empty => "code_empty",
        CodeError::TooLong { .. } => "code_too_long",
        CodeError::EmptyPart { .. } => "code_empty_part",
        CodeError::UnknownToken { .. } => "code_unknown_token",
        CodeError::OutOfOrder { .. } => "code_out_of_order",
        CodeError::Repeated { .. } => "code_repeated",
        CodeError::Missing { .. } => "code_missing",
        CodeError::Ambiguous { .. } => "code_ambiguous",
    }
}
