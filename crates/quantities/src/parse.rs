//! Parser for a quantity such as `"1.3 kg m^2"`.

use crate::dimension::Dimension;
use crate::error::QuantityError;
use crate::measure::Measure;
use crate::spelling::Canonical;
use crate::unit::ONE;
use crate::units::Unit;
use std::ops::Range;

/// A quantity as written.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Value in SI.
    pub si: f64,
    /// Value as written.
    pub value: f64,
    /// Unit as written; [`ONE`] for a ratio without a unit.
    pub unit: &'static Unit,
}

/// Parses a quantity: a number with a decimal point, and a unit of the expected dimension.
///
/// The number is an optional sign, digits with at most one point, and an optional exponent. Space around and between is
/// free. Only a ratio may go without a unit. No range is checked: a length may be negative here.
///
/// ```
/// use quantities::{Dimension, parse};
///
/// let reading = parse(Dimension::AngularVelocity, "40 1/min")?;
/// assert_eq!((reading.value, reading.unit.symbol), (40.0, "min⁻¹"));
///
/// let fault = parse(Dimension::Torque, "5").unwrap_err();
/// assert_eq!(fault.to_string(), "the unit is missing, expected a torque such as \"5 N m\"");
/// # Ok::<(), quantities::QuantityError>(())
/// ```
///
/// # Errors
/// [`QuantityError`] with the place of the fault.
pub fn parse(expected: Dimension, text: &str) -> Result<Reading, QuantityError> {
    parse_at(expected, text, 0)
}

/// Parses a quantity in a text that begins `offset` bytes into a longer one, to which the place of a fault refers.
pub(crate) fn parse_at(expected: Dimension, text: &str, offset: usize) -> Result<Reading, QuantityError> {
    let trimmed = text.trim();
    if trimmed.is_empty() {
        return Err(QuantityError::Empty { span: offset..offset + text.len(), expected });
    }
    let start = offset + text.len() - text.trim_start().len();
    let (number, rest) = trimmed.split_at(number_length(trimmed));
    if number.is_empty() {
        return Err(no_number(trimmed, start, expected));
    }
    let number_span = start..start + number.len();
    let unit_text = rest.trim_start();
    let unit_start = start + trimmed.len() - unit_text.len();
    let unit_span = unit_start..unit_start + unit_text.len();

    if let Some(fault) = no_end_of_number(trimmed, number, start, expected) {
        return Err(fault);
    }
    let Ok(value) = number.replace('−', "-").parse::<f64>() else {
        return Err(QuantityError::NumberUnreadable { span: number_span, found: excerpt(number), expected });
    };
    // A number below the smallest one is read as zero.
    let mantissa = number.split(['e', 'E']).next().unwrap_or(number);
    let is_lost = value == 0.0 && mantissa.bytes().any(|digit| (b'1'..=b'9').contains(&digit));
    if !value.is_finite() || is_lost {
        return Err(QuantityError::NotFinite { span: number_span, found: excerpt(number) });
    }
    let unit = match Unit::of_dimension(expected, unit_text) {
        Some(unit) => unit,
        None if !unit_text.is_empty() => return Err(no_unit(unit_text, unit_span, expected)),
        None if expected == Dimension::Ratio => &ONE,
        None => return Err(QuantityError::UnitMissing { span: number_span, expected }),
    };
    let si = unit.to_si(value);
    if !si.is_finite() || si == 0.0 && value != 0.0 && unit.to_si(0.0) == 0.0 {
        return Err(QuantityError::NotFinite { span: number_span, found: excerpt(number) });
    }
    Ok(Reading { si, value, unit })
}

/// Parses a typed quantity.
///
/// # Errors
/// As [`parse()`].
pub fn parse_as<Q: Measure>(text: &str) -> Result<Q, QuantityError> {
    parse(Q::DIMENSION, text).map(|reading| Q::from_si(reading.si))
}

/// Returns the fault of a text that does not begin with a number.
fn no_number(trimmed: &str, start: usize, expected: Dimension) -> QuantityError {
    let whole = start..start + trimmed.len();
    if Unit::of(trimmed).is_some() {
        return QuantityError::NumberMissing { span: whole, found: excerpt(trimmed), expected };
    }
    let word = trimmed.split_whitespace().next().unwrap_or(trimmed);
    let span = start..start + word.len();
    let unsigned = word.trim_start_matches(['+', '-', '−']);
    if ["nan", "inf", "infinity", "∞"].contains(&unsigned.to_lowercase().as_str()) {
        return QuantityError::NotFinite { span, found: excerpt(word) };
    }
    match digits(unsigned.strip_prefix(',').unwrap_or_default()) {
        0 => QuantityError::NumberUnreadable { span, found: excerpt(word), expected },
        fraction => {
            let length = word.len() - unsigned.len() + 1 + fraction;
            let found = excerpt(word.get(..length).unwrap_or(word));
            QuantityError::DecimalComma { span: start..start + length, found }
        }
    }
}

/// Returns the fault of a number that continues after its expected end: `1,5`, `1 000`, `1.000.000`, `1'000`.
fn no_end_of_number(trimmed: &str, number: &str, start: usize, expected: Dimension) -> Option<QuantityError> {
    let rest = trimmed.get(number.len()..).unwrap_or_default();
    let goes_on = match rest.trim_start().chars().next() {
        // After a space a digit may begin a unit, as in `40 1/min`; but no unit of digits alone, they group thousands.
        Some(c) if c.is_ascii_digit() => !is_unit_with_digits_first(rest.trim_start()),
        Some(c) => ",.'’_".contains(c),
        None => false,
    };
    if !goes_on {
        return None;
    }
    let tail = |c: char| c.is_ascii_digit() || c.is_whitespace() || ",.'’_".contains(c);
    let run = trimmed.get(..number.len() + rest.len() - rest.trim_start_matches(tail).len()).unwrap_or(trimmed);
    // A unit may begin with a digit, `40,5 1/min`: it is not part of the number.
    let unit = run.match_indices(char::is_whitespace).map(|(at, _)| at);
    let unit =
        unit.into_iter().find(|at| is_unit_with_digits_first(trimmed.get(*at..).unwrap_or_default().trim_start()));
    let run = unit.and_then(|at| run.get(..at)).unwrap_or(run).trim_end();
    let fraction = rest.strip_prefix(',').map_or(0, digits);
    if fraction > 0 && run.len() == number.len() + 1 + fraction && !number.contains(['.', 'e', 'E']) {
        let length = run.len() + exponent_length(trimmed.get(run.len()..).unwrap_or_default());
        let found = excerpt(trimmed.get(..length).unwrap_or(run));
        return Some(QuantityError::DecimalComma { span: start..start + length, found });
    }
    Some(QuantityError::NumberUnreadable { span: start..start + run.len(), found: excerpt(run), expected })
}

/// Returns `true` if a text that begins with a digit looks like a unit: `1/min`, `10^-4 kg m^2`, `10⁻³ A/min⁻¹`.
fn is_unit_with_digits_first(text: &str) -> bool {
    let after = text.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    after.starts_with(['/', '^', '⁻', '³', '⁴', '⁶'])
}

/// Returns the fault of a text that is no unit of the expected dimension.
fn no_unit(unit_text: &str, span: Range<usize>, expected: Dimension) -> QuantityError {
    let found = excerpt(unit_text);
    if expected == Dimension::MomentOfInertia && is_flywheel_effect(unit_text) {
        return QuantityError::FlywheelEffect { span, found };
    }
    match Unit::of(unit_text) {
        Some(other) => QuantityError::WrongQuantity { span, found, measures: other.dimension, expected },
        None => QuantityError::UnitUnknown { span, found, expected, nearest: Unit::nearest(expected, unit_text) },
    }
}

/// Returns `true` for a weight times the square of a diameter, `kgf m²`: papers state GD² so, and no moment of inertia.
fn is_flywheel_effect(unit_text: &str) -> bool {
    let (weights, lengths) = (["kgf", "kp", "gf"], ["m2", "cm2"]);
    let written = Canonical::of(unit_text).text;
    weights.iter().any(|weight| written.strip_prefix(weight).is_some_and(|length| lengths.contains(&length)))
}

/// Returns the length in bytes of the number at the start of a text: sign, digits, point, digits, exponent; 0 without a
/// digit.
fn number_length(text: &str) -> usize {
    let sign = text.chars().next().filter(|c| ['+', '-', '−'].contains(c)).map_or(0, char::len_utf8);
    let after_sign = text.get(sign..).unwrap_or_default();
    let whole = digits(after_sign);
    let fraction = after_sign.get(whole..).and_then(|rest| rest.strip_prefix('.')).map(digits);
    if whole + fraction.unwrap_or(0) == 0 {
        return 0;
    }
    let mantissa = sign + whole + fraction.map_or(0, |fraction| 1 + fraction);
    mantissa + exponent_length(text.get(mantissa..).unwrap_or_default())
}

/// Returns the length in bytes of the exponent at the start of a text; 0 if there is none.
fn exponent_length(text: &str) -> usize {
    let Some(after) = text.strip_prefix(['e', 'E']) else { return 0 };
    let unsigned = after.strip_prefix(['+', '-', '−']).unwrap_or(after);
    match digits(unsigned) {
        0 => 0,
        count => text.len() - unsigned.len() + count,
    }
}

fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// Shortens a text for a message.
fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((at, _)) => format!("{}…", text.get(..at).unwrap_or_default()),
        None => text.to_owned(),
    }
}
