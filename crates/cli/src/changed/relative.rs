//! Values that a call states as changes of the present ones: `+5kg`, `-10%`.

use super::factor::{any_factor, share, undecided_factors};
use super::value::Fault;
use crate::command::typed::typed;
use project::{Kind, Range, increased, key_at, multiplied};
use quantities::{Dimension, Language, parse, seen};
use words::{UsageHint, terminal, usage_hint};

/// Value of a key as a call states it.
pub(super) enum Relative {
    /// The statement is the value itself.
    Absolute,
    /// The value that follows from the present one.
    Value(String),
    /// Several values that the statement may mean.
    Undecided(Vec<String>),
}

/// Returns the value that a statement gives the key at a path: a percentage changes the present value; a number with a sign is
/// added to one that has no sign.
pub(super) fn relative(path: &str, stated: Option<&str>, value: &str) -> Relative {
    let Some(kind) = key_at(path).map(|key| key.kind) else { return Relative::Absolute };
    let value = value.trim();
    let percent = value.strip_suffix('%').and_then(|number| number.trim().replace(',', ".").parse::<f64>().ok());
    let is_signed = value.starts_with(['+', '-']);
    match (kind, percent) {
        (Kind::Number(..), Some(percent)) if kind.is_ratio() => {
            match stated.and_then(|stated| stated.parse::<f64>().ok()) {
                Some(old) if is_signed => {
                    let values = [old * (1.0 + percent / 100.0), old + percent / 100.0];
                    Relative::Undecided(values.map(plain).to_vec())
                }
                _ if is_signed => Relative::Absolute,
                _ => Relative::Value(plain(percent / 100.0)),
            }
        }
        (Kind::Quantity(..) | Kind::Along(..), Some(_)) => {
            let Some(stated) = stated else { return Relative::Absolute };
            let factors = match share(value) {
                Some(factor) => vec![factor],
                None => undecided_factors(value).iter().filter_map(|factor| any_factor(factor)).collect(),
            };
            let values: Vec<String> = factors.into_iter().filter_map(|factor| multiplied(stated, factor)).collect();
            match <[String; 1]>::try_from(values) {
                Ok([value]) => Relative::Value(value),
                Err(values) => Relative::Undecided(values),
            }
        }
        (Kind::Quantity(dimension, range), None) => added(&[dimension], range, stated, value),
        (Kind::Along(turning, line, range), None) => added(&[turning, line], range, stated, value),
        _ => Relative::Absolute,
    }
}

/// Returns a stated value plus a signed one. Of a key whose values have a sign, a minus sign is that of the value, and a plus sign
/// may be.
fn added(dimensions: &[Dimension], range: Range, stated: Option<&str>, value: &str) -> Relative {
    let (Some(stated), true) = (stated, value.starts_with(['+', '-'])) else { return Relative::Absolute };
    let of_both = |dimension: &&Dimension| parse(**dimension, value).is_ok();
    let Some(dimension) = dimensions.iter().find(of_both).filter(|dimension| **dimension != Dimension::Temperature)
    else {
        return Relative::Absolute;
    };
    let Some(sum) = increased(stated, value, *dimension) else { return Relative::Absolute };
    match range {
        Range::Positive | Range::NotNegative => Relative::Value(sum),
        Range::Any => {
            let plain = value.trim_start_matches('+').to_owned();
            let is_same = sum == plain;
            match value.starts_with('-') || is_same {
                true => Relative::Absolute,
                false => Relative::Undecided(vec![sum, plain]),
            }
        }
    }
}

/// Returns the refusal of a statement that may mean several values of a key, with a call for each.
pub(super) fn undecided(key: &str, value: &str, values: &[String], language: Language) -> Fault {
    let calls = values.iter().map(|value| typed(["--set", &format!("{}={value}", seen(key))])).collect();
    let message = match value.ends_with('%') {
        true => terminal::factor_undecided(&seen(value), language),
        false => terminal::addition_undecided(&seen(value), language),
    };
    (message, Some(usage_hint(&UsageHint::Calls(calls), language)))
}

/// Writes a number without rounding errors of its computation.
fn plain(number: f64) -> String {
    let text = format!("{number:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
