//! Parser for a quantity with a tolerance such as `"1.3 kg m^2 ± 10 %"`.

use crate::dimension::Dimension;
use crate::error::QuantityError;
use crate::parse::{Reading, parse, parse_at};
use crate::unit::PERCENT;
use std::borrow::Cow;
use std::ops::Range;

/// Notations of "plus or minus"; the first is the usual sign, the others are for keyboards.
pub const PLUS_MINUS: [&str; 3] = ["±", "+/-", "+-"];

/// The half-width of a tolerance band, about the value before it.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfWidth {
    /// Value in SI, zero or more; a difference for a temperature.
    pub si: f64,
    /// Place of the half-width in the text, in bytes.
    pub span: Range<usize>,
}

/// Parses a quantity that may have a tolerance, `value ± half-width`.
///
/// The half-width is a quantity of the same kind, or a share of the value in percent; zero is no tolerance. That of a
/// temperature is a difference: `23 degC ± 2 degC` and `23 degC ± 2 K` are the same, 9 °F are 5 K. A percentage of a
/// temperature in °C or °F is refused, since zero degrees are no absence of temperature.
///
/// ```
/// use quantities::{Dimension, parse_toleranced};
///
/// let (reading, half) = parse_toleranced(Dimension::Torque, "20 N m ± 10 %")?;
/// assert_eq!((reading.si, half.map(|half| half.si)), (20.0, Some(2.0)));
/// let (_, half) = parse_toleranced(Dimension::Torque, "20 N m +/- 500 mN m")?;
/// assert_eq!(half.map(|half| half.si), Some(0.5));
///
/// let fault = parse_toleranced(Dimension::Torque, "20 N m ± 1 s").unwrap_err();
/// assert_eq!(fault.span(), 12..13);
/// # Ok::<(), quantities::QuantityError>(())
/// ```
///
/// # Errors
/// The same as for [`parse()`], for the value and for the half-width; a negative half-width, or a percentage of °C or °F.
pub fn parse_toleranced(expected: Dimension, text: &str) -> Result<(Reading, Option<HalfWidth>), QuantityError> {
    let Some((at, sign)) = sign_of(text) else { return parse(expected, text).map(|reading| (reading, None)) };
    let value = text.get(..at).unwrap_or_default();
    let start = at + sign.len();
    let half = text.get(start..).unwrap_or_default();
    if value.trim().is_empty() {
        // The fault is about the text itself: a sign without a number.
        return Err(parse(expected, text).err().unwrap_or(QuantityError::Empty { span: 0..text.len(), expected }));
    }
    let reading = parse(expected, value)?;
    let span = start + half.len() - half.trim_start().len()..start + half.trim_end().len();
    if span.is_empty() {
        return Err(QuantityError::ToleranceMissing { span: at..start });
    }
    let si = half_width(expected, &reading, half, start)?;
    if si < 0.0 {
        return Err(QuantityError::ToleranceNegative { span });
    }
    if !si.is_finite() {
        let found = half.trim().to_owned();
        return Err(QuantityError::NotFinite { span, found });
    }
    Ok((reading, Some(HalfWidth { si: si.abs(), span })))
}

/// Returns every fault of a quantity that may have a tolerance: a faulty number does not hide a faulty unit after it.
///
/// ```
/// use quantities::{Dimension, QuantityError, quantity_faults};
///
/// let faults = quantity_faults(Dimension::Torque, "0,3 foo");
/// assert!(matches!(faults[..], [QuantityError::DecimalComma { .. }, QuantityError::UnitUnknown { .. }]));
/// ```
#[must_use]
pub fn quantity_faults(expected: Dimension, text: &str) -> Vec<QuantityError> {
    // A number of the value and one of the half-width.
    const NUMBERS: usize = 2;
    let mut faults = Vec::new();
    let mut text = Cow::Borrowed(text);
    let mut replaced: Vec<Range<usize>> = Vec::new();
    while let Err(mut error) = parse_toleranced(expected, &text) {
        // A number that was replaced is its fault's place as a whole.
        if let Some(number) = replaced.iter().find(|number| number.contains(&error.span().start)) {
            let span = error.span_mut();
            *span = number.start..span.end.max(number.end);
        }
        let span = error.span();
        let written = text.get(span.clone()).unwrap_or_default();
        let is_number = match error {
            QuantityError::DecimalComma { .. } => true,
            QuantityError::NumberUnreadable { .. } => {
                written.starts_with(|c: char| c.is_ascii_digit() || "+-−".contains(c))
            }
            _ => false,
        };
        let is_last = !is_number || faults.len() == NUMBERS;
        faults.push(error);
        if is_last {
            break;
        }
        // A number of the same length, so that the places of further faults are those of the text as written.
        let (before, after) = (text.get(..span.start).unwrap_or_default(), text.get(span.end..).unwrap_or_default());
        text = Cow::Owned(format!("{before}{:<width$}{after}", 1, width = span.len()));
        replaced.push(span);
    }
    faults
}

/// Returns the part of a text before the tolerance.
#[must_use]
pub fn without_tolerance(text: &str) -> &str {
    sign_of(text).and_then(|(at, _)| text.get(..at)).unwrap_or(text)
}

/// Returns the first sign of a tolerance and its place in bytes.
fn sign_of(text: &str) -> Option<(usize, &'static str)> {
    PLUS_MINUS.iter().filter_map(|sign| Some((text.find(sign)?, *sign))).min_by_key(|(at, _)| *at)
}

/// Returns the half-width in SI, with its sign; `text` begins `offset` bytes into the whole.
fn half_width(expected: Dimension, reading: &Reading, text: &str, offset: usize) -> Result<f64, QuantityError> {
    if text.trim_end().ends_with(PERCENT.symbol) {
        let share = parse_at(Dimension::Ratio, text, offset)?.si;
        if reading.unit.to_si(0.0) != 0.0 {
            let (start, end) = (text.len() - text.trim_start().len(), text.trim_end().len());
            return Err(QuantityError::ToleranceOfOffsetScale { span: offset + start..offset + end });
        }
        return Ok(reading.si.abs() * share);
    }
    if expected != Dimension::Temperature {
        return parse_at(expected, text, offset).map(|half| half.si);
    }
    // A difference of temperatures, in any of their units.
    parse_at(Dimension::TemperatureInterval, text, offset).map(|half| half.si).or_else(|fault| {
        let half = parse_at(expected, text, offset).map_err(|_| fault)?;
        Ok(half.si - half.unit.to_si(0.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half(dimension: Dimension, text: &str) -> f64 {
        parse_toleranced(dimension, text).unwrap().1.unwrap().si
    }

    #[test]
    fn every_spelling_of_the_sign_is_read() {
        for text in ["2 N m ± 10 %", "2 N m±10%", "2 N m +- 10 %", "2 N m+/-10%", " 2 Nm  ±  0.2 Nm ", "-2 N m ± 10 %"]
        {
            assert!((half(Dimension::Torque, text) - 0.2).abs() < 1e-15, "{text}");
        }
        assert!(parse_toleranced(Dimension::Torque, "2 N m").unwrap().1.is_none());
        assert_eq!(half(Dimension::Torque, "2 N m ± 0 %"), 0.0);
        assert_eq!(half(Dimension::Temperature, "40 degC ± 5 K"), 5.0);
        for text in ["40 degC ± 5 degC", "77 degF ± 9 degF", "77 degF ± 5 °C", "313 K ± 9 °F"] {
            assert!((half(Dimension::Temperature, text) - 5.0).abs() < 1e-12, "{text}");
        }
        assert!((half(Dimension::Temperature, "300 K ± 1 %") - 3.0).abs() < 1e-12);
        assert!((half(Dimension::Angle, "90 deg ± 1 arcmin") - std::f64::consts::PI / 10800.0).abs() < 1e-15);
    }

    #[test]
    fn a_fault_of_the_half_width_has_its_place() {
        for (dimension, text, fault) in [
            (Dimension::Torque, "2 N m ±", "±"),
            (Dimension::Torque, "2 N m +- ", "+-"),
            (Dimension::Torque, "2 N m ± -1 N m", "-1 N m"),
            (Dimension::Torque, "2 N m ± −10 %", "−10 %"),
            (Dimension::Torque, "2 N m ± NaN N m", "NaN"),
            (Dimension::Torque, "2 N m ± nan %", "nan"),
            (Dimension::Torque, "2 N m ± inf %", "inf"),
            (Dimension::Torque, "2 N m ± 1e999 %", "1e999"),
            (Dimension::Torque, "1e300 N m ± 1e300 %", "1e300 %"),
            (Dimension::Torque, "2 N m ± 0.1", "0.1"),
            (Dimension::Torque, "2 N m ± 1,5 N m", "1,5"),
            (Dimension::Torque, "2 N m ± 1 s", "s"),
            (Dimension::Torque, "2 N m ± 1 ‰", "‰"),
            (Dimension::Torque, "2 N m ± 1 % ± 2 %", "1 % ± 2 %"),
            (Dimension::Torque, "2 ± 10 %", "2"),
            (Dimension::Torque, "± 10 %", "±"),
            (Dimension::Temperature, "40 degC ± 10 %", "10 %"),
            (Dimension::Temperature, "77 degF ± 10 %", "10 %"),
            (Dimension::Temperature, "40 degC ± 5 m", "m"),
            (Dimension::Temperature, "40 degC ± -5 degC", "-5 degC"),
        ] {
            let error = parse_toleranced(dimension, text).unwrap_err();
            let place = text.get(error.span()).unwrap();
            assert!(place == fault || text.contains("± 2 %"), "{text}: {place:?} {error}");
        }
    }
}
