//! Reading `"1.3 kg m^2"`.

use crate::Language;
use crate::measure::Measure;
use crate::units::{Dimension, Unit};
use std::ops::Range;
use thiserror::Error;

/// A quantity as it was written.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Value in SI.
    pub si: f64,
    /// Value as written.
    pub value: f64,
    /// Unit as written; `None` for a bare ratio.
    pub unit: Option<&'static Unit>,
}

/// Why a text is no quantity.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// The text is empty.
    #[error("empty, expected {} such as \"{}\"", expected.name(Language::En), expected.example())]
    Empty {
        /// Expected quantity.
        expected: Dimension,
    },
    /// The text does not begin with a number.
    #[error("\"{found}\" is not a number")]
    NotANumber {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The number has a decimal comma.
    #[error("decimal comma in \"{found}\"")]
    DecimalComma {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
    },
    /// The number is infinite or not a number.
    #[error("\"{found}\" is not a finite number")]
    NotFinite {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
    },
    /// There is no unit.
    #[error("the unit is missing, expected {} such as \"{}\"", expected.name(Language::En), expected.example())]
    UnitMissing {
        /// Place in the text.
        span: Range<usize>,
        /// Expected quantity.
        expected: Dimension,
    },
    /// Nobody knows the unit.
    #[error("unknown unit \"{found}\"")]
    UnitUnknown {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The unit measures something else.
    #[error("\"{found}\" is a unit of {}, expected a unit of {}", measures.name(Language::En), expected.name(Language::En))]
    WrongQuantity {
        /// Place in the text.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// What the unit measures.
        measures: Dimension,
        /// Expected quantity.
        expected: Dimension,
    },
}

impl QuantityError {
    /// The offending part of the text, in bytes.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Empty { .. } => 0..0,
            Self::NotANumber { span, .. }
            | Self::DecimalComma { span, .. }
            | Self::NotFinite { span, .. }
            | Self::UnitMissing { span, .. }
            | Self::UnitUnknown { span, .. }
            | Self::WrongQuantity { span, .. } => span.clone(),
        }
    }

    /// One sentence in a language.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        if language == Language::En {
            return self.to_string();
        }
        let name = |dimension: &Dimension| dimension.name(Language::De);
        match self {
            Self::Empty { expected } => format!("leer, erwartet: {}", name(expected)),
            Self::NotANumber { found, .. } => format!("„{found}“ ist keine Zahl"),
            Self::DecimalComma { found, .. } => format!("Dezimalkomma in „{found}“"),
            Self::NotFinite { found, .. } => format!("„{found}“ ist keine endliche Zahl"),
            Self::UnitMissing { expected, .. } => format!("die Einheit fehlt, erwartet: {}", name(expected)),
            Self::UnitUnknown { found, .. } => format!("unbekannte Einheit „{found}“"),
            Self::WrongQuantity { found, measures, expected, .. } => {
                format!("„{found}“ ist eine Einheit für: {}; erwartet: {}", name(measures), name(expected))
            }
        }
    }

    /// What would be right.
    #[must_use]
    pub fn hint(&self, language: Language) -> Option<String> {
        let example = |expected: &Dimension| match language {
            Language::En => format!("for example \"{}\"", expected.example()),
            Language::De => format!("zum Beispiel \"{}\"", expected.example()),
        };
        let units = |expected: &Dimension| {
            let names: Vec<&str> = expected.units().iter().map(|unit| unit.ascii).collect();
            match language {
                Language::En => format!("units of {}: {}", expected.name(language), names.join(", ")),
                Language::De => format!("Einheiten für {}: {}", expected.name(language), names.join(", ")),
            }
        };
        match self {
            Self::Empty { expected } | Self::NotANumber { expected, .. } => Some(example(expected)),
            Self::UnitMissing { expected, .. } => Some(format!("{}; {}", example(expected), units(expected))),
            Self::DecimalComma { found, .. } => {
                let right = found.replace(',', ".");
                Some(match language {
                    Language::En => format!("write a decimal point: {right}"),
                    Language::De => format!("in Projektdateien steht ein Dezimalpunkt: {right}"),
                })
            }
            Self::NotFinite { .. } => None,
            Self::UnitUnknown { found, expected, .. } => {
                let near = expected
                    .units()
                    .into_iter()
                    .map(|unit| (strsim::damerau_levenshtein(&found.to_lowercase(), &unit.ascii.to_lowercase()), unit))
                    .min_by_key(|(distance, _)| *distance)
                    .filter(|(distance, unit)| *distance <= 1 + unit.ascii.len() / 3)
                    .map(|(_, unit)| match language {
                        Language::En => format!("did you mean \"{}\"? ", unit.ascii),
                        Language::De => format!("gemeint ist vielleicht \"{}\"; ", unit.ascii),
                    });
                Some(format!("{}{}", near.unwrap_or_default(), units(expected)))
            }
            Self::WrongQuantity { expected, .. } => Some(units(expected)),
        }
    }
}

/// A short piece of the text for a message.
fn excerpt(text: &str) -> String {
    text.chars().take(40).collect()
}

/// Reads a quantity: a number with a decimal point, and a unit of the expected dimension.
///
/// Only a ratio may go without a unit.
///
/// # Errors
/// [`QuantityError`] with the place of the fault.
pub fn parse(expected: Dimension, text: &str) -> Result<Reading, QuantityError> {
    let trimmed = text.trim();
    if trimmed.is_empty() {
        return Err(QuantityError::Empty { expected });
    }
    let start = text.len() - text.trim_start().len();
    let length = number_length(trimmed);
    let (number, rest) = trimmed.split_at(length);
    let number_span = start..start + length;
    let unit_text = rest.trim();
    let unit_start = start + length + (rest.len() - rest.trim_start().len());
    let unit_span = unit_start..unit_start + unit_text.len();
    if length == 0 {
        let word: &str = trimmed.split_whitespace().next().unwrap_or(trimmed);
        let span = start..start + word.len();
        let lower = word.to_lowercase();
        let lower = lower.trim_start_matches(['+', '-']);
        if ["nan", "inf", "infinity", "∞"].contains(&lower) {
            return Err(QuantityError::NotFinite { span, found: excerpt(word) });
        }
        return Err(QuantityError::NotANumber { span, found: excerpt(word), expected });
    }
    if rest.starts_with(',') && rest.as_bytes().get(1).is_some_and(u8::is_ascii_digit) {
        let tail = rest.get(1..).unwrap_or_default();
        let digits = tail.bytes().take_while(u8::is_ascii_digit).count();
        let span = start..start + length + 1 + digits;
        let found = excerpt(text.get(span.clone()).unwrap_or_default());
        return Err(QuantityError::DecimalComma { span, found });
    }
    let value: f64 = number.parse().map_err(|_| QuantityError::NotANumber {
        span: number_span.clone(),
        found: excerpt(number),
        expected,
    })?;
    if !value.is_finite() {
        return Err(QuantityError::NotFinite { span: number_span, found: excerpt(number) });
    }
    if unit_text.is_empty() {
        if expected == Dimension::Ratio {
            return Ok(Reading { si: value, value, unit: None });
        }
        return Err(QuantityError::UnitMissing { span: number_span, expected });
    }
    if unit_text.starts_with(|c: char| c.is_ascii_digit())
        && rest.starts_with(char::is_whitespace)
        && !unit_text.starts_with("1/")
        && !unit_text.starts_with("10^")
    {
        let span = start..start + trimmed.len();
        return Err(QuantityError::NotANumber { span, found: excerpt(trimmed), expected });
    }
    let Some(unit) = Unit::of_dimension(expected, unit_text) else {
        return Err(match Unit::of(unit_text) {
            Some(other) => QuantityError::WrongQuantity {
                span: unit_span,
                found: excerpt(unit_text),
                measures: other.dimension,
                expected,
            },
            None => QuantityError::UnitUnknown { span: unit_span, found: excerpt(unit_text), expected },
        });
    };
    let si = unit.to_si(value);
    if !si.is_finite() {
        return Err(QuantityError::NotFinite { span: number_span, found: excerpt(number) });
    }
    Ok(Reading { si, value, unit: Some(unit) })
}

/// Reads a typed quantity.
///
/// # Errors
/// As [`parse`].
pub fn parse_as<Q: Measure>(text: &str) -> Result<Q, QuantityError> {
    parse(Q::DIMENSION, text).map(|reading| Q::from_si(reading.si))
}

/// Length of the number at the start of a text: sign, digits, point, digits, exponent.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(at);
    at += whole;
    let mut fraction = 0;
    if bytes.get(at) == Some(&b'.') {
        fraction = digits(at + 1);
        at += 1 + fraction;
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        let exponent = digits(at + 1 + sign);
        if exponent > 0 {
            at += 1 + sign + exponent;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AngularVelocity, MomentOfInertia, Torque};

    #[test]
    fn quantities_as_people_write_them() {
        let si = |dimension, text: &str| parse(dimension, text).unwrap().si;
        assert_eq!(si(Dimension::MomentOfInertia, "1.3 kg m^2"), 1.3);
        assert_eq!(si(Dimension::MomentOfInertia, "1.3kgm²"), 1.3);
        assert_eq!(si(Dimension::Torque, " 5 N m "), 5.0);
        assert_eq!(si(Dimension::Torque, "-5e-1 Nm"), -0.5);
        assert!((si(Dimension::AngularVelocity, "40 1/min") - 4.188_790_204_786_391).abs() < 1e-14);
        assert!((si(Dimension::AngularVelocity, "40 min⁻¹") - 4.188_790_204_786_391).abs() < 1e-14);
        assert_eq!(si(Dimension::Ratio, "0.5"), 0.5);
        assert_eq!(si(Dimension::Ratio, "50 %"), 0.5);
        assert_eq!(parse_as::<Torque>("5 N m").unwrap().si(), 5.0);
        assert_eq!(parse_as::<MomentOfInertia>("5 kg m^2").unwrap().si(), 5.0);
    }

    #[test]
    fn every_fault_has_its_place() {
        let fault = |dimension, text: &str| parse(dimension, text).unwrap_err();
        assert_eq!(fault(Dimension::Torque, "  ").span(), 0..0);
        assert_eq!(fault(Dimension::Torque, " five Nm").span(), 1..5);
        assert!(
            matches!(fault(Dimension::Torque, "1,5 Nm"), QuantityError::DecimalComma { span, .. } if span == (0..3))
        );
        assert!(matches!(fault(Dimension::Torque, "1e999 Nm"), QuantityError::NotFinite { .. }));
        assert!(matches!(fault(Dimension::Torque, "NaN Nm"), QuantityError::NotFinite { .. }));
        assert!(matches!(fault(Dimension::Torque, "-inf Nm"), QuantityError::NotFinite { .. }));
        assert!(matches!(fault(Dimension::Torque, "5"), QuantityError::UnitMissing { .. }));
        assert!(matches!(fault(Dimension::Torque, "5 Nn"), QuantityError::UnitUnknown { span, .. } if span == (2..4)));
        assert!(matches!(
            fault(Dimension::Torque, "5 kg"),
            QuantityError::WrongQuantity { measures: Dimension::Mass, .. }
        ));
        assert!(matches!(fault(Dimension::Torque, "1 000 Nm"), QuantityError::NotANumber { .. }));
        assert!(fault(Dimension::Torque, "5 Nn").hint(Language::De).unwrap().contains("N m"));
    }

    #[test]
    fn no_text_makes_it_panic() {
        let pieces = ["1", ".", "e", "-", "+", ",", " ", "N", "m", "²", "µ", "°", "∞", "\u{0}", "/", "min", "é"];
        let mut state: usize = 1;
        for _ in 0..20_000 {
            let mut text = String::new();
            for _ in 0..state % 9 {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                text.push_str(pieces[(state >> 33) % pieces.len()]);
            }
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            if let Err(error) = parse(Dimension::AngularVelocity, &text) {
                assert!(text.get(error.span()).is_some(), "{text:?} {error:?}");
                let _ = (error.message(Language::De), error.hint(Language::En));
            }
        }
        let _ = parse_as::<AngularVelocity>("1/min");
    }
}
