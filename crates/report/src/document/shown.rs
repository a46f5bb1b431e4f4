//! Numbers and units in the format of a language.

use answers::{Grade, Number};
use chrono::NaiveDate;
use quantities::{Language, Unit, digits_apart, format_number, format_significant, grouped};
use words::percent_text;

/// Formatter of numbers, units and dates for one language.
pub(super) struct Formatter(pub(super) Language);

/// Narrow no-break space between number and unit, as required by DIN 5008 and the SI brochure.
const THIN: char = '\u{202f}';

/// Returns the text with every unit tied to the number before it, the degree sign to its digits, and long numbers with
/// a unit in groups of three, as elsewhere in the document.
pub(super) fn tied(text: &str) -> String {
    let mut tied = String::with_capacity(text.len());
    // Start of the last run of digits in the output; `None` if something else came last.
    let mut digits: Option<usize> = None;
    for (place, sign) in text.char_indices() {
        if sign.is_ascii_digit() {
            // Digits after a letter, a point or a comma are no whole number by themselves.
            let alone = |last: char| !last.is_alphanumeric() && !matches!(last, '.' | ',' | '_' | '-');
            digits = digits.or_else(|| Some(tied.len()).filter(|_| tied.chars().next_back().is_none_or(alone)));
            tied.push(sign);
            continue;
        }
        let rest = text.get(place..).unwrap_or_default();
        let after_digit = tied.ends_with(|last: char| last.is_ascii_digit());
        let unit = if after_digit && matches!(sign, ' ' | THIN) { unit_at(rest) } else { None };
        let has_unit = unit.is_some() || after_digit && sign == '°';
        if let (true, Some(from)) = (has_unit, digits) {
            let grouped = grouped(tied.get(from..).unwrap_or_default());
            tied.truncate(from);
            tied.push_str(&grouped);
        }
        match unit {
            // No space between digits and degree sign (ISO 80000-1).
            Some("°") => {}
            Some(_) => tied.push(THIN),
            None => tied.push(sign),
        }
        digits = None;
    }
    tied
}

/// Returns the unit with which a text begins, after leading spaces.
fn unit_at(text: &str) -> Option<&str> {
    let word = text.trim_start_matches([' ', THIN]);
    let word = word.split([' ', ',', ';', ')', ':', THIN]).next()?;
    let word = word.trim_end_matches('.');
    (word == "%" || Unit::of(word).is_some()).then_some(word)
}

/// Life \[h\] above which only the order of magnitude is stated: more than a century.
const LIFE_MOST_H: f64 = 1e6;

/// Significant digits of a number.
const DIGITS: usize = 4;

impl Formatter {
    /// Formats a number with four significant digits.
    pub(super) fn number(&self, value: Number) -> String {
        self.number_with(value, DIGITS)
    }

    fn number_with(&self, value: Number, digits: usize) -> String {
        let Some(value) = value.written() else { return "∞".to_owned() };
        // An exact figure with fewer digits is not padded with zeros.
        let text = format_significant(value, digits, self.0);
        let point = self.0.decimal_mark();
        let (mantissa, power) = text.split_at(text.find('·').unwrap_or(text.len()));
        let short =
            if mantissa.contains(point) { mantissa.trim_end_matches('0').trim_end_matches(point) } else { mantissa };
        format!("{}{power}", grouped(short))
    }

    /// Formats a share as a percentage with one decimal.
    pub(super) fn share(&self, share: Number) -> String {
        let Some(share) = share.written() else { return format!("∞{THIN}%") };
        let percent = share * 100.0;
        let text = if percent != 0.0 && percent.abs() < 0.05 {
            format!("<{THIN}{}", format_number(0.1, 1, self.0))
        } else {
            grouped(&percent_text(share, self.0))
        };
        format!("{text}{THIN}%")
    }

    /// Returns the symbol of a unit of the records.
    pub(super) fn unit(&self, json: &str) -> String {
        match json {
            "1" => String::new(),
            other => Unit::of(other).map_or_else(|| other.to_owned(), |unit| unit.symbol_in(self.0).to_owned()),
        }
    }

    /// Formats a number with its unit.
    pub(super) fn figure(&self, value: Number, unit: &str) -> String {
        self.figure_with(value, unit, DIGITS)
    }

    /// Formats a value beyond its limit and the limit, with as many digits as tell them apart.
    pub(super) fn figures_apart(&self, numbers: [Number; 2], unit: &str) -> [String; 2] {
        let digits = digits_apart(numbers.map(|number| number.0), DIGITS);
        numbers.map(|number| self.figure_with(number, unit, digits))
    }

    fn figure_with(&self, value: Number, unit: &str, digits: usize) -> String {
        let is_rounding = Unit::of(unit).is_some_and(|unit| unit.is_below_resolution(value.0));
        let unit = self.unit(unit);
        let number = if is_rounding { "0".to_owned() } else { self.number_with(value, digits) };
        match unit.as_str() {
            "" => number,
            // A life beyond every machine: its digits say nothing.
            "h" if value.0 > LIFE_MOST_H => format!(">{THIN}10⁶{THIN}h"),
            "°" => format!("{number}°"),
            _ => format!("{number}{THIN}{unit}"),
        }
    }

    /// Formats an instant \[s\] of the cycle; one within a microsecond of its start is 0.
    pub(super) fn instant(&self, at: Number) -> String {
        self.figure(if at.0.abs() < 1e-6 { Number(0.0) } else { at }, "s")
    }

    /// Formats the values of a column, each to the last digit of the largest with four significant digits: what is below
    /// is noise beside it.
    pub(super) fn column(&self, values: &[Option<Number>]) -> Vec<String> {
        let largest = values.iter().flatten().map(|value| value.0.abs()).fold(0.0, f64::max);
        let step = if largest > 0.0 { 10.0_f64.powf(largest.log10().floor() - 3.0) } else { 0.0 };
        let rounded = |value: &Number| if step > 0.0 { Number((value.0 / step).round() * step) } else { *value };
        values.iter().map(|value| value.as_ref().map(|value| self.number(rounded(value))).unwrap_or_default()).collect()
    }

    /// Formats a mass \[kg\], with a decimal as the manual states it: `3,0` next to `2,3`.
    pub(super) fn mass(&self, value: Number) -> String {
        let tenths = value.0 * 10.0;
        let is_stated = (tenths - tenths.round()).abs() < 1e-9 * tenths.abs().max(1.0);
        if is_stated { grouped(&format_number(value.0, 1, self.0)) } else { self.number(value) }
    }

    /// Converts an angle or a speed of the output to travel or speed along a line; `None` for other units.
    pub(super) fn along(&self, value: Number, unit: &str, travel_mm_per_rev: Number) -> Option<String> {
        let turns = match unit {
            "rev" => 1.0,
            "deg" => 1.0 / 360.0,
            "arcmin" => 1.0 / 21_600.0,
            "arcsec" => 1.0 / 1_296_000.0,
            "1/min" => return Some(self.figure(Number(value.0 * travel_mm_per_rev.0 / 60.0), "mm/s")),
            _ => return None,
        };
        let way = value.0 * turns * travel_mm_per_rev.0;
        // Lengths below 0.01 mm are stated in micrometres.
        let small = way != 0.0 && way.abs() < 0.01;
        Some(if small { self.figure(Number(way * 1e3), "µm") } else { self.figure(Number(way), "mm") })
    }

    /// Returns the word for a grade.
    pub(super) fn grade(&self, grade: Grade) -> &'static str {
        words::grade_word(grade, self.0)
    }

    /// Formats a date.
    pub(super) fn date(&self, date: NaiveDate) -> String {
        words::report::date(date, self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_stays_with_its_number() {
        assert_eq!(tied("up to 39.0 Nm, at 30 °C (80 °C)"), "up to 39.0\u{202f}Nm, at 30\u{202f}°C (80\u{202f}°C)");
        assert_eq!(tied("20 min⁻¹ und 5,5 %."), "20\u{202f}min⁻¹ und 5,5\u{202f}%.");
        assert_eq!(tied("swings of 2.00 °, then 4500 °"), "swings of 2.00°, then 4500°");
        assert_eq!(tied("21600° and 21600 °"), "21\u{202f}600° and 21\u{202f}600°");
        assert_eq!(tied("35000 h, 12345.5 N"), "35\u{202f}000\u{202f}h, 12345.5\u{202f}N");
        for text in ["", "in 4 segments", "J_L ≤ 3 J_out", "L_10 of 2", "order 1019307", "CHA-25A-100"] {
            assert_eq!(tied(text), text);
        }
    }

    #[test]
    fn a_mass_has_the_decimal_of_the_manual() {
        let de = Formatter(Language::De);
        assert_eq!(["3,0", "2,3", "12,35"].map(str::to_owned), [3.0, 2.3, 12.35].map(|mass| de.mass(Number(mass))));
    }

    #[test]
    fn numbers_have_four_digits_and_the_sign_of_their_language() {
        let de = Formatter(Language::De);
        assert_eq!(de.number(Number(193.495_559)), "193,5");
        assert_eq!(de.number(Number(40.0)), "40");
        assert_eq!(de.number(Number(3500.0)), "3500");
        assert_eq!(de.number(Number(-19_200.0)), "−19\u{202f}200");
        assert_eq!(de.number(Number(846_776_078.7)), "8,468·10⁸");
        assert_eq!(de.figure(Number(0.25), "kgm^2"), "0,25\u{202f}kgm²");
        assert_eq!(de.share(Number(1.417_89)), "141,8\u{202f}%");
        assert_eq!(de.share(Number(0.000_035)), "<\u{202f}0,1\u{202f}%");
        assert_eq!(de.share(Number(f64::INFINITY)), "∞\u{202f}%");
    }

    #[test]
    fn an_angle_is_a_way_along_the_line() {
        let (de, travel) = (Formatter(Language::De), Number(40.0));
        let along = |value, unit| de.along(Number(value), unit, travel);
        assert_eq!(along(0.5, "rev").as_deref(), Some("20\u{202f}mm"));
        assert_eq!(along(4.5, "deg").as_deref(), Some("0,5\u{202f}mm"));
        assert_eq!(along(1.0, "arcmin").as_deref(), Some("1,852\u{202f}µm"));
        assert_eq!(along(90.0, "1/min").as_deref(), Some("60\u{202f}mm/s"));
        assert_eq!(along(1.0, "Nm"), None);
    }
}
