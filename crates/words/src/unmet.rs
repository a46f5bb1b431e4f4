//! Words for requirements that an actuator does not meet.

use crate::results::{symbol_term, with_unit};
use crate::texts::said;
use configurator::{OfferDatum, Price, Unmet};
use order_code::Brake;
use quantities::unit::{DAY, KILOGRAM, MILLIMETRE, VOLT};
use quantities::{Language, Measure, Unit, digits_apart, format_number};

/// Returns a requirement that is not met, as text.
#[must_use]
pub fn unmet_text(unmet: &Unmet, language: Language) -> String {
    let apart = |unit: &Unit, digits: usize, figures: [f64; 2]| {
        let digits = digits_apart(figures.map(|si| unit.from_si(si)), digits);
        figures.map(|si| with_unit(si, unit, digits, language))
    };
    match unmet {
        Unmet::Feedback(feedback) => said!(language =>
            "encoder {feedback} is not permitted"
            | "Geber {feedback} ist nicht zugelassen"
        ),
        Unmet::Brake(Brake::Without) => {
            said!(language => "holding brake required, not available" | "Haltebremse gefordert, nicht vorhanden")
        }
        Unmet::Brake(Brake::With) => {
            said!(language => "version without brake required" | "Ausführung ohne Bremse gefordert")
        }
        Unmet::HollowShaft { has, needs } => {
            let [has, needs] = apart(&MILLIMETRE, 4, [has.si(), needs.si()]);
            said!(language =>
                "hollow shaft bore {has} is smaller than {needs}"
                | "Hohlwellendurchmesser {has} ist kleiner als {needs}"
            )
        }
        Unmet::Length { has, permits } => {
            let [has, permits] = apart(&MILLIMETRE, 4, [has.si(), permits.si()]);
            said!(language => "length {has} exceeds {permits}" | "Länge {has} überschreitet {permits}")
        }
        Unmet::Mass { has, permits } => {
            let [has, permits] = masses([has.si(), permits.si()], language);
            said!(language => "mass {has} exceeds {permits}" | "Masse {has} überschreitet {permits}")
        }
        Unmet::SupplyTooLow { needs, gives } => {
            let [needs, gives] = apart(&VOLT, 3, [needs.si(), gives.si()]);
            said!(language =>
                "the supply corresponds to {gives} at the motor terminals (U_DC/√2), the winding requires {needs}"
                | "die Versorgung entspricht {gives} an den Motorklemmen (U_DC/√2), die Wicklung erfordert {needs}"
            )
        }
        Unmet::Maker => {
            said!(language => "manufacturer not among the permitted ones" | "Hersteller nicht unter den zulässigen")
        }
        Unmet::Price { has, permits } => {
            let [has, permits] = prices([has, permits], language);
            said!(language => "price {has} exceeds {permits}" | "Preis {has} überschreitet {permits}")
        }
        Unmet::LeadTime { has, permits } => {
            let [has, permits] = apart(&DAY, 4, [has.si(), permits.si()]);
            said!(language => "lead time {has} exceeds {permits}" | "Lieferzeit {has} überschreitet {permits}")
        }
        Unmet::NotOffered(OfferDatum::Price) => {
            said!(language => "price not stated, or not as an amount with its currency" | "Preis nicht angegeben oder nicht als Betrag mit Währung")
        }
        Unmet::NotOffered(OfferDatum::PriceInCurrency) => {
            said!(language => "price stated in another currency" | "Preis in anderer Währung angegeben")
        }
        Unmet::NotOffered(OfferDatum::LeadTime) => {
            said!(language => "lead time not stated" | "Lieferzeit nicht angegeben")
        }
        Unmet::NotKnown { symbol, requires } => not_known(symbol, *requires, language),
    }
}

/// Names a requirement for which a datum of the actuator is missing.
fn not_known(symbol: &str, requires: f64, language: Language) -> String {
    let required = |unit: &Unit, digits| with_unit(requires, unit, digits, language);
    match symbol {
        "U_M" => {
            let link = required(&VOLT, 3);
            said!(language =>
                "DC link voltage {link}: no voltage range of the actuator stated"
                | "Zwischenkreisspannung {link}: kein Spannungsbereich des Antriebs angegeben"
            )
        }
        "d_H" => {
            let least = required(&MILLIMETRE, 4);
            said!(language =>
                "hollow shaft bore at least {least}: not stated for the actuator"
                | "Hohlwellendurchmesser mindestens {least}: für den Antrieb nicht angegeben"
            )
        }
        "L" => {
            let most = required(&MILLIMETRE, 4);
            said!(language =>
                "length at most {most}: not stated for the actuator" | "Länge höchstens {most}: für den Antrieb nicht angegeben"
            )
        }
        "m" => {
            let most = required(&KILOGRAM, 4);
            said!(language =>
                "mass at most {most}: not stated for the actuator" | "Masse höchstens {most}: für den Antrieb nicht angegeben"
            )
        }
        _ => {
            let term = symbol_term(symbol, language);
            said!(language => "{symbol} ({term}) is not known" | "{symbol} ({term}) ist nicht bekannt")
        }
    }
}

/// Formats two masses with the decimal of the catalogue, or with as many as tell them apart.
fn masses(masses: [f64; 2], language: Language) -> [String; 2] {
    let masses = masses.map(|si| KILOGRAM.from_si(si));
    let decimals = decimals_apart(masses, 1);
    masses.map(|mass| format!("{} {}", format_number(mass, decimals, language), KILOGRAM.symbol))
}

/// Formats two amounts of money with two decimals, or with as many as tell them apart.
fn prices(prices: [&Price; 2], language: Language) -> [String; 2] {
    let decimals = decimals_apart(prices.map(|price| price.amount), 2);
    prices.map(|price| format!("{} {}", format_number(price.amount, decimals, language), price.currency))
}

/// Returns the count of decimals, `decimals` at least, with which two numbers that differ are written differently.
fn decimals_apart(numbers: [f64; 2], decimals: usize) -> usize {
    let is_apart = |decimals: usize| {
        let [one, other] = numbers.map(|number| format_number(number, decimals, Language::En));
        one != other
    };
    (decimals..=9).find(|decimals| is_apart(*decimals)).unwrap_or(decimals)
}
