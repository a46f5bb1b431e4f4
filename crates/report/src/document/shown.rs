//! Numbers and units in the words of a language.

use quantities::{Language, Unit, format_number, format_significant};

/// Writes for one language.
pub(super) struct Shown(pub(super) Language);

/// No-break narrow space between number and unit, as DIN 5008 and the SI brochure ask.
const THIN: char = '\u{202f}';

/// The text with every unit tied to the number before it.
pub(super) fn tied(text: &str) -> String {
    let mut tied = String::with_capacity(text.len());
    let mut after_digit = false;
    for (place, sign) in text.char_indices() {
        let ties = sign == ' ' && after_digit && {
            let next = text.get(place + 1..).and_then(|rest| rest.split([' ', ',', ';', ')', ':']).next());
            next.is_some_and(|word| word == "%" || Unit::of(word.trim_end_matches('.')).is_some())
        };
        tied.push(if ties { THIN } else { sign });
        after_digit = sign.is_ascii_digit();
    }
    tied
}

impl Shown {
    /// Four significant digits.
    pub(super) fn number(&self, value: f64) -> String {
        // A figure that is exact in fewer digits is not padded with zeros it does not have.
        let text = format_significant(value, 4, self.0);
        let point = if self.0 == Language::De { ',' } else { '.' };
        let (mantissa, power) = text.split_at(text.find('·').unwrap_or(text.len()));
        let short =
            if mantissa.contains(point) { mantissa.trim_end_matches('0').trim_end_matches(point) } else { mantissa };
        format!("{}{power}", grouped(short))
    }

    /// A share as percentage, one decimal.
    pub(super) fn percent(&self, share: f64) -> String {
        let percent = share * 100.0;
        let text = if percent != 0.0 && percent.abs() < 0.05 {
            format!("<{THIN}{}", format_number(0.1, 1, self.0))
        } else {
            format_number(percent, 1, self.0)
        };
        format!("{text}{THIN}%")
    }

    /// A unit of the JSON as people write it.
    pub(super) fn unit(&self, json: &str) -> String {
        match json {
            "1" => String::new(),
            other => Unit::of(other).map_or_else(|| other.to_owned(), |unit| unit.symbol.to_owned()),
        }
    }

    /// Number and unit.
    pub(super) fn figure(&self, value: f64, unit: &str) -> String {
        let unit = self.unit(unit);
        let number = self.number(value);
        match unit.as_str() {
            "" => number,
            "°" => format!("{number}°"),
            _ => format!("{number}{THIN}{unit}"),
        }
    }

    /// A value as the project writes it: number and unit are set as such, every other text stays as it is.
    pub(super) fn written(&self, text: &str) -> String {
        let number_ends = text.find(|sign: char| !matches!(sign, '0'..='9' | '.' | '-' | '+')).unwrap_or(text.len());
        let (number, rest) = text.split_at(number_ends);
        if number.parse::<f64>().is_err() {
            return text.to_owned();
        }
        let number = number.replace('-', "−");
        let number = if self.0 == Language::De { number.replace('.', ",") } else { number };
        match (rest.trim(), Unit::of(rest.trim())) {
            ("", _) => number,
            ("deg", _) => format!("{number}°"),
            (_, Some(unit)) => format!("{number}{THIN}{}", unit.symbol),
            _ => text.to_owned(),
        }
    }

    /// A date.
    pub(super) fn date(&self, year: u16, month: u8, day: u8) -> String {
        match self.0 {
            Language::De => format!("{day:02}.{month:02}.{year:04}"),
            Language::En => format!("{year:04}-{month:02}-{day:02}"),
        }
    }
}

/// Whole numbers of five digits and more in groups of three, as ISO 80000-1 has it.
fn grouped(number: &str) -> String {
    let (sign, digits) = number.strip_prefix('−').map_or(("", number), |rest| ("−", rest));
    if digits.len() < 5 || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return number.to_owned();
    }
    let mut text = sign.to_owned();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(THIN);
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_quantity_is_typeset_and_nothing_else_is_touched() {
        let (de, en) = (Shown(Language::De), Shown(Language::En));
        assert_eq!(de.written("1.3 kg m^2"), "1,3\u{202f}kgm²");
        assert_eq!(en.written("-180 mm"), "−180\u{202f}mm");
        assert_eq!(de.written("40 1/min"), "40\u{202f}min⁻¹");
        assert_eq!(en.written("90 deg"), "90°");
        for text in ["", "robot-joint.csv", "1.2.3", "3 turns", "true", "-", "2 #let x"] {
            assert_eq!(de.written(text), text);
        }
    }

    #[test]
    fn a_unit_stays_with_its_number() {
        assert_eq!(tied("up to 39.0 Nm, at 30 °C (80 °C)"), "up to 39.0\u{202f}Nm, at 30\u{202f}°C (80\u{202f}°C)");
        assert_eq!(tied("20 min⁻¹ und 5,5 %."), "20\u{202f}min⁻¹ und 5,5\u{202f}%.");
        for text in ["", "in 4 segments", "J_L ≤ 3 J_out", "L_10 of 2"] {
            assert_eq!(tied(text), text);
        }
    }

    #[test]
    fn numbers_have_four_digits_and_the_sign_of_their_language() {
        let de = Shown(Language::De);
        assert_eq!(de.number(193.495_559), "193,5");
        assert_eq!(de.number(40.0), "40");
        assert_eq!(de.number(3500.0), "3500");
        assert_eq!(de.number(-19_200.0), "−19\u{202f}200");
        assert_eq!(de.number(846_776_078.7), "8,468·10⁸");
        assert_eq!(de.figure(0.25, "kgm^2"), "0,25\u{202f}kgm²");
        assert_eq!(de.percent(1.417_89), "141,8\u{202f}%");
        assert_eq!(de.percent(0.000_035), "<\u{202f}0,1\u{202f}%");
    }
}
