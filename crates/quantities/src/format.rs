//! Number formatting for display.

use crate::{Language, Unit};

/// Formats a number with a fixed count of decimals; decimal comma in German; no negative zero.
///
/// A half is rounded away from zero, after the noise of the computation is taken off: 46.875 and 46.874 999 999 999 99 are
/// two computations of one value, and have one text. A value that is no number is written as a word, so that it cannot pass
/// for a result.
///
/// ```
/// use quantities::{Language, format_number};
/// assert_eq!(format_number(-93.984, 2, Language::De), "−93,98");
/// assert_eq!([46.875, 46.874_999_999_999_99].map(|speed| format_number(speed, 2, Language::En)), ["46.88", "46.88"]);
/// ```
#[must_use]
pub fn format_number(value: f64, digits: usize, language: Language) -> String {
    if !value.is_finite() {
        return not_finite(value, language);
    }
    let (number, exponent) = decimal(value);
    let decimals = i32::try_from(digits).unwrap_or(i32::MAX);
    let dropped = u32::try_from((COMPUTED - 1 - exponent).saturating_sub(decimals)).unwrap_or(0);
    if dropped == 0 {
        return typeset(&format!("{value:.digits$}"), language);
    }
    let text = format!("{:0>width$}", without_digits(number, dropped), width = digits + 1);
    let (whole, decimals) = text.split_at(text.len() - digits);
    let sign = if value < 0.0 { "-" } else { "" };
    let point = if digits == 0 { "" } else { "." };
    typeset(&format!("{sign}{whole}{point}{decimals}"), language)
}

/// Significant digits in which two computations of one value agree.
const COMPUTED: i32 = 13;

/// Returns the magnitude of a value as a whole number of [`COMPUTED`] digits, and the power of ten of its first one.
fn decimal(value: f64) -> (u64, i32) {
    let text = format!("{:.*e}", usize::try_from(COMPUTED - 1).unwrap_or(0), value.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (mantissa.replace('.', "").parse().unwrap_or(0), exponent.parse().unwrap_or(0))
}

/// Returns a whole number without so many of its last digits, rounded half up.
fn without_digits(number: u64, dropped: u32) -> u64 {
    10_u64.checked_pow(dropped).map_or(0, |power| number.saturating_add(power / 2) / power)
}

/// Formats a number with a count of significant digits; decimal comma in German.
///
/// Integer digits are never cut: 12345 with three digits stays 12345. Below 10⁻⁴ and from 10⁶ on a power of ten is
/// written, for a whole number from 10⁷ on: a life of 2 472 001.3 h is no exact count.
///
/// ```
/// use quantities::{Language, format_significant};
/// assert_eq!(format_significant(0.012_345, 3, Language::En), "0.0123");
/// assert_eq!(format_significant(2_273_506_756.0, 4, Language::De), "2,274·10⁹");
/// assert_eq!(format_significant(2_472_001.3, 4, Language::De), "2,472·10⁶");
/// assert_eq!(format_significant(4_194_304.0, 4, Language::De), "4194304");
/// ```
#[must_use]
pub fn format_significant(value: f64, digits: usize, language: Language) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return not_finite(value, language);
    }
    let digits = digits.clamp(1, 17);
    // Rounded before the exponent is read: 9.996 with three digits is 10.0.
    let (exponent, mantissa) = significant(value, digits);
    let is_whole = value.fract() == 0.0;
    if !(1e-4..if is_whole { 1e7 } else { 1e6 }).contains(&value.abs()) {
        let raised: String = exponent.to_string().chars().map(raised).collect();
        return format!("{}·10{raised}", typeset(&mantissa, language));
    }
    let decimals = i32::try_from(digits).unwrap_or(17) - 1 - exponent;
    format_number(value, usize::try_from(decimals).unwrap_or(0), language)
}

/// Returns the power of ten of a value rounded to a count of significant digits as by [`format_number`], and its mantissa.
fn significant(value: f64, digits: usize) -> (i32, String) {
    let dropped = u32::try_from(COMPUTED).unwrap_or(0).saturating_sub(u32::try_from(digits).unwrap_or(0));
    if dropped == 0 {
        let scientific = format!("{value:.*e}", digits - 1);
        let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        return (exponent.parse().unwrap_or(0), mantissa.to_owned());
    }
    let (number, exponent) = decimal(value);
    let rounded = without_digits(number, dropped).to_string();
    let exponent = exponent + i32::from(rounded.len() > digits);
    let sign = if value < 0.0 { "-" } else { "" };
    let (first, further) = rounded.split_at(1);
    let further = further.get(..digits - 1).unwrap_or(further);
    let point = if digits == 1 { "" } else { "." };
    (exponent, format!("{sign}{first}{point}{further}"))
}

/// Most digits that tell two numbers apart: beyond, they are equal up to rounding.
const DIGITS_APART: usize = 9;

/// Returns the count of significant digits, `digits` at least, with which two numbers that differ are written differently.
///
/// ```
/// use quantities::digits_apart;
/// assert_eq!([digits_apart([27.0, 26.0], 4), digits_apart([27.0, 27.001], 4), digits_apart([27.0, 27.0], 4)], [4, 5, 4]);
/// ```
#[must_use]
pub fn digits_apart(numbers: [f64; 2], digits: usize) -> usize {
    let is_apart = |digits: usize| {
        let [one, other] = numbers.map(|number| format_significant(number, digits, Language::En));
        one != other
    };
    (digits..=DIGITS_APART).find(|digits| is_apart(*digits)).unwrap_or(digits)
}

/// Life \[h\] above which only the order of magnitude is stated: more than a century.
const LIFE_MOST_H: f64 = 1e6;

impl Unit {
    /// Formats a computed figure, given in SI, in this unit with a count of significant digits
    /// ([`format_significant`]); one below the resolution of its quantity ([`resolution_si`](crate::Dimension::resolution_si)) is 0.
    #[must_use]
    pub fn figure(&self, si: f64, digits: usize, language: Language) -> String {
        if self.is_below_resolution(self.from_si(si)) {
            return "0".to_owned();
        }
        // A life beyond every machine: its digits say nothing.
        if self.symbol == "h" && self.from_si(si) > LIFE_MOST_H {
            return "> 10⁶".to_owned();
        }
        format_significant(self.from_si(si), digits, language)
    }

    /// Returns `true` if a computed value in this unit is below the resolution of its quantity.
    #[must_use]
    pub fn is_below_resolution(&self, value: f64) -> bool {
        self.to_si(value).abs() < self.dimension.resolution_si()
    }

    /// Returns the spelling for display in a language: `rev`, the only word among the symbols, is `Umdr.` in German, and `U` in a
    /// quotient.
    #[must_use]
    pub fn symbol_in(&self, language: Language) -> &'static str {
        match (language, self.symbol) {
            (Language::De, "rev") => "Umdr.",
            (Language::De, "rev/s") => "U/s",
            (Language::De, "rev/s²") => "U/s²",
            (Language::De | Language::En, symbol) => symbol,
        }
    }
}

/// Narrow no-break space between groups of digits.
const GROUP: char = '\u{202f}';

/// Returns a number, as text, with the digits before its decimal mark in groups of three if there are five or more
/// (ISO 80000-1).
///
/// ```
/// use quantities::grouped;
/// assert_eq!([grouped("43300"), grouped("−19200,5"), grouped("3500")], ["43\u{202f}300", "−19\u{202f}200,5", "3500"]);
/// ```
#[must_use]
pub fn grouped(number: &str) -> String {
    let from = number.find(|sign: char| sign.is_ascii_digit()).unwrap_or(number.len());
    let (sign, rest) = number.split_at(from);
    let end = rest.find(|sign: char| !sign.is_ascii_digit()).unwrap_or(rest.len());
    let (whole, decimals) = rest.split_at(end);
    if whole.len() < 5 {
        return number.to_owned();
    }
    let mut text = sign.to_owned();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            text.push(GROUP);
        }
        text.push(digit);
    }
    text + decimals
}

/// Returns a number, as text, with the symbol of its unit behind it: a space between them, none before the degree sign of
/// an angle (ISO 80000-1), and the number alone without a unit.
///
/// ```
/// use quantities::with_symbol;
/// assert_eq!([with_symbol("17.9", "°"), with_symbol("38", "°C"), with_symbol("2", "1")], ["17.9°", "38 °C", "2"]);
/// ```
#[must_use]
pub fn with_symbol(number: &str, symbol: &str) -> String {
    match symbol {
        "" | "1" => number.to_owned(),
        "°" | "′" | "″" => format!("{number}{symbol}"),
        _ => format!("{number} {symbol}"),
    }
}

const fn raised(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

/// Parses a number of a German table: digits with an optional decimal comma and sign, nothing else.
///
/// ```
/// use quantities::parse_german;
/// assert_eq!(parse_german("1,12"), Some(1.12));
/// assert_eq!(parse_german("1.12"), None);
/// ```
#[must_use]
pub fn parse_german(text: &str) -> Option<f64> {
    let digits = text.strip_prefix(['-', '−']).unwrap_or(text);
    let (whole, fraction) = digits.split_once(',').map_or((digits, None), |(whole, rest)| (whole, Some(rest)));
    let plain = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    if !plain(whole) || !fraction.is_none_or(plain) {
        return None;
    }
    let value: f64 = digits.replace(',', ".").parse().ok().filter(|value: &f64| value.is_finite())?;
    Some(if digits.len() == text.len() { value } else { -value })
}

/// Applies the decimal mark of the language and a true minus sign, and removes a minus before zero.
fn typeset(text: &str, language: Language) -> String {
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    let text = if zero { text.replace('-', "") } else { text.replace('-', "−") };
    match language {
        Language::En => text,
        Language::De => text.replacen('.', ",", 1),
    }
}

fn not_finite(value: f64, language: Language) -> String {
    let text = match (value.is_nan(), value > 0.0, language) {
        (true, _, Language::En) => "not a number",
        (true, _, Language::De) => "keine Zahl",
        (false, true, _) => "∞",
        (false, false, _) => "−∞",
    };
    text.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn german_numbers_of_a_table() {
        for (text, value) in [("1,12", 1.12), ("-20", -20.0), ("−0,5", -0.5), ("10000000", 1e7), ("007,50", 7.5)] {
            let read = parse_german(text).unwrap();
            assert!((read - value).abs() < 1e-15, "{text}: {read}");
        }
        let huge = "9".repeat(400);
        for wrong in [
            "", "-", "--1", "+1", "1.12", "1.000,5", "1,", ",5", "1,2,3", "1 000", "12,9 ", " 1", "NaN", "1e3", "±12",
            "٣", &huge,
        ] {
            assert!(parse_german(wrong).is_none(), "{wrong}");
        }
    }

    #[test]
    fn decimals_are_written_in_the_language() {
        assert_eq!(format_number(103.984, 2, Language::De), "103,98");
        assert_eq!(format_number(-93.984, 2, Language::En), "−93.98");
        assert_eq!(format_number(12345.0, 0, Language::De), "12345");
        assert_eq!(format_number(1e300, 0, Language::En).len(), 301);
    }

    #[test]
    fn zero_has_no_sign() {
        for value in [-0.001, -0.0, 0.0, 0.004] {
            assert_eq!(format_number(value, 2, Language::En), "0.00");
        }
        assert_eq!(format_number(-0.4, 0, Language::En), "0");
        assert_eq!(format_significant(-0.0, 3, Language::De), "0");
    }

    #[test]
    fn significant_digits_count_from_the_first_that_is_not_zero() {
        for (value, digits, text) in [
            (38.9012, 4, "38,90"),
            (0.012_345, 3, "0,0123"),
            (12345.6, 3, "12346"),
            (9.996, 3, "10,0"),
            (0.099_96, 3, "0,100"),
            (100.0, 4, "100,0"),
            (-7.25, 2, "−7,3"),
            (7.35, 2, "7,4"),
            (0.999_5, 3, "1,00"),
            (5.0, 0, "5"),
            (0.0001, 3, "0,000100"),
            (999_999.4, 3, "999999"),
            (2_472_001.3, 4, "2,472·10⁶"),
            (9_999_999.6, 3, "1,00·10⁷"),
            (1e7, 3, "1,00·10⁷"),
            (9_999_999.0, 4, "9999999"),
            (2_273_506_756.0, 4, "2,274·10⁹"),
            (9.999_96e9, 4, "1,000·10¹⁰"),
            (1.234e300, 3, "1,23·10³⁰⁰"),
            (-2.5e-7, 3, "−2,50·10⁻⁷"),
            (9.9e-5, 1, "1·10⁻⁴"),
        ] {
            assert_eq!(format_significant(value, digits, Language::De), text);
        }
    }

    /// Halves, and what a computation makes of them in its last bits, are rounded away from zero; all other digits are those
    /// of exact decimal arithmetic.
    #[test]
    fn two_computations_of_one_value_have_one_text() {
        for thousandths in (1_u64..200_000).step_by(37).chain((5..200_000).step_by(910)) {
            let value = thousandths as f64 / 1000.0;
            let hundredths = (thousandths + 5) / 10;
            let text = format!("{}.{:02}", hundredths / 100, hundredths % 100);
            for bits in [-3_i64, -1, 0, 1, 3] {
                let noisy = f64::from_bits(value.to_bits().saturating_add_signed(bits));
                assert_eq!(format_number(noisy, 2, Language::En), text, "{thousandths} {bits}");
                for digits in 1..=6 {
                    let [exact, other] = [value, noisy].map(|value| format_significant(value, digits, Language::De));
                    assert_eq!(exact, other, "{thousandths} {bits} {digits}");
                }
            }
        }
    }

    /// A figure below the resolution of its quantity is 0 in every unit, and all others are unchanged.
    #[test]
    fn the_rounding_of_a_computation_is_zero() {
        for unit in crate::unit::ALL {
            let resolution = unit.dimension.resolution_si();
            for mantissa in [1.5, 2.345, 9.99] {
                for exponent in -20..7 {
                    for sign in [1.0, -1.0] {
                        let si = sign * mantissa * 10_f64.powi(exponent);
                        for language in Language::ALL {
                            let plain = format_significant(unit.from_si(si), 4, language);
                            let expected = if si.abs() < resolution { "0" } else { plain.as_str() };
                            assert_eq!(unit.figure(si, 4, language), expected, "{si} {}", unit.symbol);
                        }
                    }
                }
            }
        }
        use crate::unit::{NEWTON_METRE, RADIAN_PER_SECOND_SQUARED, SECOND};
        assert_eq!(SECOND.figure(3e-10, 3, Language::De), "0");
        assert_eq!(SECOND.figure(62.5e-6, 3, Language::De), "6,25·10⁻⁵");
        assert_eq!(RADIAN_PER_SECOND_SQUARED.figure(3.6e-11, 4, Language::En), "0");
        assert_eq!(NEWTON_METRE.figure(6.346e-7, 4, Language::En), "0");
    }

    #[test]
    fn what_is_no_number_is_said() {
        assert_eq!(format_number(f64::NAN, 2, Language::En), "not a number");
        assert_eq!(format_significant(f64::NAN, 2, Language::De), "keine Zahl");
        assert_eq!(format_number(f64::INFINITY, 2, Language::En), "∞");
        assert_eq!(format_significant(f64::NEG_INFINITY, 2, Language::De), "−∞");
    }
}
