//! Price and time of delivery of a product.

use quantities::Time;
use std::fmt;
use std::sync::Arc;

/// Price and time of delivery of a product.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Offer {
    /// Price as written, such as `1250 EUR`.
    pub price: Option<Arc<str>>,
    /// Time of delivery.
    pub lead_time: Option<Time>,
}

/// Amount of money in a currency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Price {
    /// Amount in the main unit of the currency.
    pub amount: f64,
    /// Currency.
    pub currency: Currency,
}

/// Currency by its code of three letters (ISO 4217).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Currency([char; 3]);

/// Signs that stand for one currency only; the dollar sign stands for several.
const SIGNS: [(char, Currency); 2] = [('€', Currency(['E', 'U', 'R'])), ('£', Currency(['G', 'B', 'P']))];

impl fmt::Display for Currency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|letter| write!(f, "{letter}"))
    }
}

impl Price {
    /// Reads a price: an amount with its currency before or behind it, `1250 EUR`, `EUR 1\u{202f}250.50`, `1250,50 €`.
    ///
    /// `None` if there is no currency, or if the amount has two readings: one mark before three digits, `1.250`, is a decimal
    /// mark in one country and groups digits in another.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let is_of_amount = |sign: char| sign.is_ascii_digit() || " .,'’\u{a0}\u{202f}".contains(sign);
        let from = text.find(|sign: char| sign.is_ascii_digit())?;
        let until = text.rfind(|sign: char| sign.is_ascii_digit())? + 1;
        let (before, number, after) = (text.get(..from)?, text.get(from..until)?, text.get(until..)?);
        let word = match (before.trim(), after.trim()) {
            ("", word) | (word, "") => word,
            _ => return None,
        };
        if !number.chars().all(is_of_amount) {
            return None;
        }
        Some(Self { amount: amount(number)?, currency: currency(word)? })
    }
}

fn currency(word: &str) -> Option<Currency> {
    let mut letters = word.chars().map(|letter| letter.to_ascii_uppercase());
    match (letters.next(), letters.next(), letters.next(), letters.next()) {
        (Some(sign), None, ..) => SIGNS.into_iter().find(|(known, _)| *known == sign).map(|(_, currency)| currency),
        (Some(a), Some(b), Some(c), None) => {
            [a, b, c].iter().all(char::is_ascii_uppercase).then_some(Currency([a, b, c]))
        }
        _ => None,
    }
}

/// Returns the number of digits in groups of three with a decimal mark, or without either.
fn amount(number: &str) -> Option<f64> {
    let marks: Vec<(usize, char)> = number.char_indices().filter(|(_, sign)| matches!(sign, '.' | ',')).collect();
    let whole_and_cents = match marks.as_slice() {
        [] => (number, ""),
        all => {
            let (at, last) = *all.last()?;
            let behind = number.get(at + 1..)?;
            let is_repeated = all.iter().filter(|(_, mark)| *mark == last).count() > 1;
            match (behind.len(), is_repeated, all.len()) {
                (3, true, _) => (number, ""),
                (1 | 2, false, _) => (number.get(..at)?, behind),
                // `1.250` has two readings.
                _ => return None,
            }
        }
    };
    let (whole, cents) = whole_and_cents;
    let groups: Vec<&str> = whole.split(|sign: char| !sign.is_ascii_digit()).collect();
    let are_groups = groups.iter().skip(1).all(|group| group.len() == 3) && groups.first()?.len() <= 3;
    if groups.len() > 1 && !are_groups || !cents.chars().all(|sign| sign.is_ascii_digit()) {
        return None;
    }
    format!("{}.{cents}0", groups.concat()).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prices_are_read_as_they_are_written() {
        for (text, amount, currency) in [
            ("1250 EUR", 1250.0, "EUR"),
            ("EUR 1250", 1250.0, "EUR"),
            ("1250,5 €", 1250.5, "EUR"),
            ("€1250.50", 1250.5, "EUR"),
            ("1.250,50 EUR", 1250.5, "EUR"),
            ("1,250.50 USD", 1250.5, "USD"),
            ("1 250 chf", 1250.0, "CHF"),
            ("1'250.00 CHF", 1250.0, "CHF"),
            ("12.345.678 JPY", 12_345_678.0, "JPY"),
            ("0 EUR", 0.0, "EUR"),
        ] {
            let price = Price::read(text);
            assert_eq!(price.map(|price| price.amount), Some(amount), "{text}");
            assert_eq!(price.map(|price| price.currency.to_string()).as_deref(), Some(currency), "{text}");
        }
    }

    #[test]
    fn what_is_no_price_or_has_two_readings_is_none() {
        for text in [
            "",
            "EUR",
            "1250",
            "1.250 EUR",
            "1,250 EUR",
            "1250 $",
            "1250 EURO",
            "EUR 1250 USD",
            "12 50 EUR",
            "1.25.0 EUR",
            "-5 EUR",
            "1e3 EUR",
            "on request",
        ] {
            assert_eq!(Price::read(text), None, "{text}");
        }
    }
}
