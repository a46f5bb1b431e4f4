//! Numbers for people.

use crate::Language;

/// A number with a fixed count of decimals; decimal comma in German; no negative zero.
#[must_use]
pub fn format_number(value: f64, digits: usize, language: Language) -> String {
    if value.is_nan() {
        return "NaN".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    let mut text = format!("{value:.digits$}");
    if text.starts_with('-') && text.chars().all(|c| !c.is_ascii_digit() || c == '0') {
        text.remove(0);
    }
    let text = text.replacen('-', "−", 1);
    match language {
        Language::En => text,
        Language::De => text.replacen('.', ",", 1),
    }
}

/// From here on numbers are written with a power of ten.
const POWER_FROM: f64 = 1e7;

/// A number with a count of significant digits. Below 10⁷ whole digits are never cut: 12345 with three digits stays
/// 12345; above, a power of ten is written: 2.27·10⁹.
#[must_use]
pub fn format_significant(value: f64, digits: usize, language: Language) -> String {
    if value == 0.0 || !value.is_finite() {
        return format_number(value, 0, language);
    }
    if value.abs() >= POWER_FROM {
        let text = format!("{value:.*e}", digits.saturating_sub(1));
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let mantissa: f64 = mantissa.parse().unwrap_or(value);
        let raised: String = exponent.chars().map(raised).collect();
        return format!("{}·10{raised}", format_number(mantissa, digits.saturating_sub(1), language));
    }
    let magnitude = value.abs().log10().floor();
    // Rounding may carry into the next decade: 9.996 with three digits is 10.0.
    #[allow(clippy::cast_possible_truncation, reason = "the exponent of an f64 is small")]
    let exponent = magnitude as i32;
    let scale = 10f64.powi(exponent - i32::try_from(digits).unwrap_or(1) + 1);
    let carried = (value.abs() / scale).round() * scale >= 10f64.powi(exponent + 1);
    let exponent = exponent + i32::from(carried);
    let decimals = i32::try_from(digits).unwrap_or(1) - 1 - exponent;
    format_number(value, usize::try_from(decimals.clamp(0, 12)).unwrap_or(0), language)
}

const fn raised(digit: char) -> char {
    match digit {
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

/// A number of a German table: digits with an optional decimal comma and sign, nothing else.
#[must_use]
pub fn parse_german(text: &str) -> Option<f64> {
    let digits = text.strip_prefix(['-', '−']).unwrap_or(text);
    let mut parts = digits.split(',');
    let (whole, fraction) = (parts.next()?, parts.next());
    let plain = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    if !plain(whole) || !fraction.is_none_or(plain) || parts.next().is_some() {
        return None;
    }
    let value: f64 = digits.replace(',', ".").parse().ok()?;
    Some(if digits.len() == text.len() { value } else { -value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn german_numbers_of_a_table() {
        assert_eq!(parse_german("1,12"), Some(1.12));
        assert_eq!(parse_german("-20"), Some(-20.0));
        assert_eq!(parse_german("10000000"), Some(1e7));
        for wrong in ["", "-", "1.12", "1,", ",5", "1,2,3", "1 000", "12.9 ", "NaN", "1e3"] {
            assert_eq!(parse_german(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn numbers_are_written_in_the_language() {
        assert_eq!(format_number(103.984, 2, Language::De), "103,98");
        assert_eq!(format_number(-93.984, 2, Language::En), "−93.98");
        assert_eq!(format_number(-0.001, 2, Language::En), "0.00");
        assert_eq!(format_number(f64::NAN, 2, Language::En), "NaN");
        assert_eq!(format_significant(38.9012, 4, Language::De), "38,90");
        assert_eq!(format_significant(0.012_345, 3, Language::En), "0.0123");
        assert_eq!(format_significant(12345.6, 3, Language::En), "12346");
        assert_eq!(format_significant(2_273_506_756.0, 4, Language::De), "2,274·10⁹");
        assert_eq!(format_significant(9_999_999.0, 4, Language::En), "9999999");
        assert_eq!(format_significant(9.996, 3, Language::En), "10.0");
        assert_eq!(format_significant(0.0, 3, Language::En), "0");
        assert_eq!(format_significant(100.0, 4, Language::En), "100.0");
    }
}
