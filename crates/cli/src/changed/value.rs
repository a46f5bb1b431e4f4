//! Values of keys that a call states, and the refusals of them.

use crate::command::typed::number_and_unit;
use project::{Kind, key_at};
use std::borrow::Cow;
use std::ops::RangeInclusive;

/// A refusal in one sentence, and a hint.
pub(super) type Fault = (String, Option<String>);

/// Largest number of keys that a refusal names.
pub(super) const NAMED_KEYS_MOST: usize = 4;

/// Factors that are proposed for a bare number.
pub(super) const FACTORS: RangeInclusive<f64> = 0.05..=20.0;

/// Returns the value of a quantity with a decimal point in place of a comma, unless that may separate thousands: `1,200 kg`.
pub(super) fn with_point<'v>(path: &str, value: &'v str) -> Cow<'v, str> {
    let is_measured = key_at(path).is_some_and(|key| matches!(key.kind, Kind::Quantity(..) | Kind::Along(..)));
    let (number, _) = number_and_unit(value);
    match number.split_once(',') {
        Some((whole, rest)) if is_measured && !rest.contains([',', '.']) && !whole.contains('.') && rest.len() != 3 => {
            Cow::Owned(value.replacen(',', ".", 1))
        }
        _ => Cow::Borrowed(value),
    }
}
