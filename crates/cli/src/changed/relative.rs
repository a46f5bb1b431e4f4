//! Values that a call states as changes of the present ones: `+5kg`, `-10%`.

use super::factor::{any_factor, share, undecided_factors};
use super::value::Fault;
use crate::command::typed::{number_and_unit, typed};
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
    let Some(key) = key_at(path) else { return Relative::Absolute };
    let kind = key.kind;
    let value = value.trim();
    // A change of a value that is not stated is one of its default.
    let default = key.default.map(|default| default());
    let stated = stated.or(default.as_deref());
    let percent = value.strip_suffix('%').and_then(|number| number.trim().replace(',', ".").parse::<f64>().ok());
    let is_signed = value.starts_with(['+', '-']);
    match (kind, percent) {
        (Kind::Number(low, high), Some(percent)) if kind.is_ratio() => {
            let share = percent / 100.0;
            // Without a value to be changed the share itself may be meant; it has no sign.
            let values = match stated.and_then(|stated| stated.parse::<f64>().ok()) {
                _ if !is_signed => return Relative::Value(plain(share)),
                Some(old) => vec![old * (1.0 + share), old + share],
                None => vec![share.abs(), 1.0 + share],
            };
            Relative::Undecided(values.into_iter().filter(|value| (low..=high).contains(value)).map(plain).collect())
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

/// Unit of a temperature that is proposed in place of a difference in kelvin.
const CELSIUS: &str = "degC";

/// Returns a stated value plus a signed one. Of a key whose values have a sign, a minus sign is that of the value, and a plus sign
/// may be.
fn added(dimensions: &[Dimension], range: Range, stated: Option<&str>, value: &str) -> Relative {
    if !value.starts_with(['+', '-']) {
        return Relative::Absolute;
    }
    let Some(stated) = stated else {
        // Without a value a difference of temperatures states none; that in degrees may be one.
        let (number, unit) = number_and_unit(value);
        let is_difference = dimensions.contains(&Dimension::Temperature) && (unit == "K" || value.starts_with('+'));
        let unit = if unit == "K" { CELSIUS } else { unit };
        let plain = format!("{}{unit}", number.trim_start_matches('+'));
        return if is_difference { Relative::Undecided(vec![plain]) } else { Relative::Absolute };
    };
    let of_both = |dimension: &&Dimension| parse(**dimension, value).is_ok();
    let Some(dimension) = dimensions.iter().find(of_both) else { return Relative::Absolute };
    if *dimension == Dimension::Temperature {
        return warmed(stated, value);
    }
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

/// Returns a stated temperature plus a signed one: a difference in kelvin is one, since no temperature in kelvin has a sign; with a
/// plus sign before degrees both are meant, and a minus sign is that of the temperature.
fn warmed(stated: &str, value: &str) -> Relative {
    let of = |text: &str| parse(Dimension::Temperature, text).ok().map(|read| read.si);
    let (number, unit) = number_and_unit(stated);
    let (by, by_unit) = number_and_unit(value);
    let step = |unit: &str| Some(of(&format!("1 {unit}"))? - of(&format!("0 {unit}"))?);
    let sum = || {
        let (number, by): (f64, f64) = (number.parse().ok()?, by.replace(',', ".").parse().ok()?);
        let first_unit = unit.split(['±', '+']).next().unwrap_or_default().trim();
        Some(format!("{} {unit}", plain(number + by * step(by_unit)? / step(first_unit)?)))
    };
    let Some(sum) = sum() else { return Relative::Absolute };
    match (by_unit, value.starts_with('-')) {
        ("K", _) => Relative::Value(sum),
        (_, true) => Relative::Absolute,
        (_, false) => {
            let plain = value.trim_start_matches('+').to_owned();
            if sum == plain { Relative::Absolute } else { Relative::Undecided(vec![sum, plain]) }
        }
    }
}

/// Returns the refusal of a statement that may mean several values of a key, with a call for each.
pub(super) fn undecided(key: &str, value: &str, values: &[String], language: Language) -> Fault {
    let mut calls: Vec<String> =
        values.iter().map(|value| typed(["--set", &format!("{}={value}", seen(key))])).collect();
    calls.dedup();
    let message = match value.ends_with('%') {
        true => terminal::factor_undecided(&seen(value), language),
        false => terminal::addition_undecided(&seen(value), language),
    };
    let hint = match (calls.is_empty(), key_at(key).map(|key| key.kind)) {
        (false, _) => Some(UsageHint::Calls(calls)),
        (true, Some(Kind::Number(low, high))) => Some(UsageHint::Range(plain(low), plain(high))),
        (true, _) => None,
    };
    (message, hint.map(|hint| usage_hint(&hint, language)))
}

/// Writes a number without rounding errors of its computation.
fn plain(number: f64) -> String {
    let text = format!("{number:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
