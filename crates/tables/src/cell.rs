//! A value of a table.

use quantities::unit::ONE;
use quantities::{Language, Unit};

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Empty cell.
    Empty,
    /// Text.
    Text(String),
    /// A finite number.
    Number(f64),
    /// A word of a fixed set: its identifier in data exchange, and its text for readers.
    Word(&'static str, String),
    /// Several identifiers separated by commas, and their text for readers.
    Ids(String, String),
}

impl Cell {
    /// Creates a number with twelve significant digits, which removes the digits of a unit conversion. A non-finite
    /// value gives an empty cell.
    #[must_use]
    pub fn number(value: f64) -> Self {
        rounded(value).map_or(Self::Empty, Self::Number)
    }

    /// Converts an SI value to a unit.
    #[must_use]
    pub fn in_unit(si: Option<f64>, unit: &Unit) -> Self {
        si.map_or(Self::Empty, |si| Self::number(unit.from_si(si)))
    }

    /// Creates the cell of a unit: its name in data exchange, and its symbol for readers.
    #[must_use]
    pub fn unit(unit: &Unit, language: Language) -> Self {
        Self::Word(unit.json, if *unit == ONE { String::new() } else { unit.symbol_in(language).to_owned() })
    }

    /// Creates a text; an empty text gives an empty cell.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        let text = text.into();
        if text.is_empty() { Self::Empty } else { Self::Text(text) }
    }

    /// Returns the number, if it is one.
    #[must_use]
    pub const fn as_number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// Returns the text in data exchange, if it is a text.
    #[must_use]
    pub fn as_text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            Self::Word(id, _) => Some(id),
            Self::Ids(ids, _) => Some(ids),
            _ => None,
        }
    }
}

/// Rounds a finite number to the double closest to its twelve significant digits.
pub(crate) fn rounded(value: f64) -> Option<f64> {
    if !value.is_finite() {
        return None;
    }
    // Negative zero becomes zero.
    if value == 0.0 {
        return Some(0.0);
    }
    Some(rounded_by_a_power_of_ten(value).unwrap_or_else(|| format!("{value:.11e}").parse().unwrap_or(value)))
}

/// Rounds without formatting if the result is certain: the number scaled to twelve digits before the point, rounded,
/// divided by the power of ten. Both are integers that a double holds exactly, so that their quotient is the double
/// closest to the digits. The error of the scaled number is below 2⁻¹³: it decides the rounding unless it is close to
/// one half.
fn rounded_by_a_power_of_ten(value: f64) -> Option<f64> {
    /// Largest power of ten that a double holds exactly.
    const EXACT: i32 = 22;
    #[allow(clippy::cast_possible_truncation, reason = "the exponent of a double has three digits")]
    let places = 11 - value.abs().log10().floor() as i32;
    if !(0..=EXACT).contains(&places) {
        return None;
    }
    let power = 10_f64.powi(places);
    let product = value.abs() * power;
    let whole = product.floor();
    let behind = product - whole;
    if !(1e11..1e12 - 1.0).contains(&whole) || (behind - 0.5).abs() < 1e-3 {
        return None;
    }
    Some(((whole + if behind > 0.5 { 1.0 } else { 0.0 }) / power).copysign(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_holds_a_finite_number_or_none() {
        assert_eq!(Cell::number(0.1 + 0.2), Cell::Number(0.3));
        assert_eq!(Cell::number(f64::INFINITY), Cell::Empty);
        assert_eq!(Cell::number(f64::NAN), Cell::Empty);
        assert_eq!(Cell::number(-0.0), Cell::Number(0.0));
        assert_eq!(Cell::number(5e-324), Cell::Number(5e-324));
        assert!(matches!(Cell::number(-0.0), Cell::Number(zero) if zero.is_sign_positive()));
    }

    #[test]
    fn the_quick_way_to_twelve_digits_gives_the_digits() {
        let mut state = 0x2545_f491_4f6c_dd1d_u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        let mut quick = 0;
        let mut look = |value: f64| {
            let written: f64 = format!("{value:.11e}").parse().unwrap();
            if let Some(found) = rounded_by_a_power_of_ten(value) {
                quick += 1;
                assert_eq!(found.to_bits(), written.to_bits(), "{value:e}");
            }
            assert_eq!(rounded(value), Some(written), "{value:e}");
        };
        for _ in 0..200_000 {
            // Every exponent, common ones, decimals at the border between two roundings, and powers of ten.
            let any = f64::from_bits(next());
            if any.is_finite() && any != 0.0 {
                look(any);
            }
            let digits = (next() % 10_000_000_000_000) as f64;
            let power = 10_f64.powi((next() % 30) as i32);
            look(digits.max(1.0) / power);
            look((digits + 0.5).next_up() / power);
            look(f64::from(u32::try_from(next() >> 32).unwrap()).mul_add(1e-9, 1e-3));
            look(power.next_down());
            look(1.0 / power);
        }
        assert!(quick > 500_000, "{quick}");
    }
}
