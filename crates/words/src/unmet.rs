//! Words for requirements that an actuator does not meet.

use crate::results::{symbol_term, with_unit};
use crate::texts::said;
use configurator::{OfferDatum, Price, Unmet};
use order_code::Brake;
use quantities::unit::{DAY, KILOGRAM, MILLIMETRE, VOLT};
use quantities::{Language, Measure, format_number};

/// Returns a requirement that is not met, as text.
#[must_use]
pub fn unmet_text(unmet: &Unmet, language: Language) -> String {
    let mm = |si| with_unit(si, &MILLIMETRE, 4, language);
    let volt = |si| with_unit(si, &VOLT, 3, language);
    let kg = |si: f64| format!("{} {}", format_number(KILOGRAM.from_si(si), 1, language), KILOGRAM.symbol);
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
        Unmet::HollowShaft { has, needs } => said!(language =>
            "hollow shaft bore {} is smaller than {}"
            | "Hohlwellendurchmesser {} ist kleiner als {}", mm(has.si()), mm(needs.si())
        ),
        Unmet::Length { has, permits } => {
            said!(language => "length {} exceeds {}" | "Länge {} überschreitet {}", mm(has.si()), mm(permits.si()))
        }
        Unmet::Mass { has, permits } => {
            said!(language => "mass {} exceeds {}" | "Masse {} überschreitet {}", kg(has.si()), kg(permits.si()))
        }
        Unmet::SupplyTooLow { needs, gives } => said!(language =>
            "the supply corresponds to {} at the motor terminals (U_DC/√2), the winding requires {}"
            | "die Versorgung entspricht {} an den Motorklemmen (U_DC/√2), die Wicklung erfordert {}", volt(gives.si()), volt(needs.si())
        ),
        Unmet::Maker => {
            said!(language => "manufacturer not among the permitted ones" | "Hersteller nicht unter den zulässigen")
        }
        Unmet::Price { has, permits } => {
            let [has, permits] = [has, permits].map(|price| price_text(price, language));
            said!(language => "price {has} exceeds {permits}" | "Preis {has} überschreitet {permits}")
        }
        Unmet::LeadTime { has, permits } => {
            let [has, permits] = [has, permits].map(|time| with_unit(time.si(), &DAY, 4, language));
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
        Unmet::NotKnown { symbol } => {
            let term = symbol_term(symbol, language);
            said!(language => "{symbol} ({term}) is not known" | "{symbol} ({term}) ist nicht bekannt")
        }
    }
}

/// Returns an amount of money with two decimals.
fn price_text(price: &Price, language: Language) -> String {
    format!("{} {}", format_number(price.amount, 2, language), price.currency)
}
