//! Values of keys that a call states, and the refusals of them.

use crate::command::typed::number_and_unit;
use project::{Kind, key_at};
use quantities::Language;
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

/// Returns both values that a quantity with a point before three digits may have in a language with a decimal comma, without and
/// with a decimal point: `1.000 kg` is 1000 kg or 1.0000 kg.
pub(super) fn thousands(path: &str, value: &str, language: Language) -> Option<[String; 2]> {
    let is_measured = key_at(path).is_some_and(|key| matches!(key.kind, Kind::Quantity(..) | Kind::Along(..)));
    let (number, unit) = number_and_unit(value);
    let (whole, rest) = number.split_once('.').filter(|_| is_measured && language.decimal_mark() == ',')?;
    let digits = whole.trim_start_matches(['+', '-']);
    let is_whole = (1..=3).contains(&digits.len()) && !digits.starts_with('0');
    let is_group = rest.len() == 3 && rest.bytes().all(|sign| sign.is_ascii_digit());
    let with_unit = |number: String| format!("{number} {unit}").trim().to_owned();
    (is_whole && is_group && digits.bytes().all(|sign| sign.is_ascii_digit()))
        .then(|| [with_unit(format!("{whole}{rest}")), with_unit(format!("{number}0"))])
}
