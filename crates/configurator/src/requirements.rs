//! Requirements of the user on the actuator in addition to the checks.

use crate::offer::Price;
use crate::product::{Product, ProductId};
use crate::rules::uncovered;
use actuator::Parameters;
use numeric::{at_least, at_most};
use order_code::{Brake, Feedback};
use provenance::Datum;
use quantities::{ElectricPotential, Length, Mass, Measure, Time};

/// Requirements that filter the products.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Requirements {
    /// Permitted motor feedback systems; empty if any is permitted.
    pub feedback: Vec<Feedback>,
    /// Brake required (`true`), excluded (`false`) or optional (`None`).
    pub brake: Option<bool>,
    /// Smallest bore of the hollow shaft.
    pub hollow_shaft_min: Option<Length>,
    /// Largest length.
    pub length_max: Option<Length>,
    /// Largest mass.
    pub mass_max: Option<Mass>,
    /// Names of the permitted manufacturers, or their first words; empty if any is permitted.
    pub makers: Vec<String>,
    /// Largest price.
    pub price_max: Option<Price>,
    /// Longest time of delivery.
    pub lead_time_max: Option<Time>,
    /// DC link voltage that supplies the servo drive.
    pub supply: Option<ElectricPotential>,
}

/// Statement of an offer that a requirement needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfferDatum {
    /// Price.
    Price,
    /// Price in the currency of the requirement.
    PriceInCurrency,
    /// Time of delivery.
    LeadTime,
}

/// A requirement that an actuator does not meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unmet {
    /// The feedback is not among the permitted ones.
    Feedback(Feedback),
    /// A brake is required but absent, or excluded but fitted.
    Brake(Brake),
    /// The hollow shaft is too narrow.
    HollowShaft {
        /// Bore of the actuator.
        has: Length,
        /// Bore required.
        needs: Length,
    },
    /// The actuator is too long.
    Length {
        /// Length of the actuator.
        has: Length,
        /// Length permitted.
        permits: Length,
    },
    /// The actuator is too heavy.
    Mass {
        /// Mass of the actuator; the larger one if the value of the manual is doubtful.
        has: Mass,
        /// Mass permitted.
        permits: Mass,
    },
    /// The DC link voltage does not suffice for the terminal voltage required for the stated performance.
    SupplyTooLow {
        /// Terminal voltage U_M required for the stated performance.
        needs: ElectricPotential,
        /// U_DC/√2, the largest fundamental that the supply can provide.
        gives: ElectricPotential,
    },
    /// The manufacturer is not among the permitted ones.
    Maker,
    /// The price is too high.
    Price {
        /// Price of the actuator.
        has: Price,
        /// Price permitted.
        permits: Price,
    },
    /// The time of delivery is too long.
    LeadTime {
        /// Time of delivery of the actuator.
        has: Time,
        /// Time permitted.
        permits: Time,
    },
    /// No file states what the requirement needs of the offer, so that it is open.
    NotOffered(OfferDatum),
    /// The manual does not state the datum that the requirement needs.
    NotKnown {
        /// Symbol of the datum.
        symbol: &'static str,
        /// Value required of it, in SI.
        requires: f64,
    },
}

impl Unmet {
    /// Returns `true` if a datum is missing, so that the requirement is open and not broken.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        matches!(self, Self::NotKnown { .. } | Self::NotOffered(_))
    }

    /// Returns `true` if it rejects a product. Data that a file of the user leaves open, and an offer that no file states, are
    /// unknown and reject none; the manual is expected to state its data.
    #[must_use]
    pub const fn rejects(&self, product: &Product) -> bool {
        match self {
            Self::NotOffered(_) => false,
            Self::NotKnown { .. } => !product.is_described(),
            _ => true,
        }
    }
}

/// Returns `true` if a manufacturer has a name, or one that begins with its words, in any case.
#[must_use]
pub fn is_maker(manufacturer: &str, name: &str) -> bool {
    let words = |text: &str| text.split_whitespace().map(str::to_lowercase).collect::<Vec<String>>();
    let (manufacturer, name) = (words(manufacturer), words(name));
    !name.is_empty() && manufacturer.starts_with(&name)
}

impl Requirements {
    /// Iterates over the requirements that a product does not meet as it is ordered; an unknown datum meets none, and a
    /// product that names no feedback or no brake is not judged by it.
    pub fn unmet(&self, ordered: &ProductId, product: &Product) -> impl Iterator<Item = Unmet> + use<> {
        let is_other = |has: &Feedback| {
            !self.feedback.is_empty() && !self.feedback.iter().any(|each| each.as_str() == has.as_str())
        };
        let other_feedback = product.feedback.filter(is_other);
        let other_brake = product.brake.filter(|has| self.brake.is_some_and(|brake| brake != (*has == Brake::With)));
        // A value stated for the standard version only is unknown for this code.
        let unknown = |symbol| {
            let uncovered = ordered.order_code().map(uncovered).unwrap_or_default();
            uncovered.iter().any(|each| each.not_printed().contains(&symbol))
        };
        let length_unknown = self.length_max.is_some() && unknown("L");
        let mass_unknown = self.mass_max.is_some() && unknown("m");
        let of_the_product = [
            other_feedback.map(Unmet::Feedback),
            other_brake.map(Unmet::Brake),
            self.length_max.filter(|_| length_unknown).map(|most| Unmet::NotKnown { symbol: "L", requires: most.si() }),
            self.mass_max.filter(|_| mass_unknown).map(|most| Unmet::NotKnown { symbol: "m", requires: most.si() }),
        ];
        let is_permitted = |maker: &str| self.makers.iter().any(|name| is_maker(maker, name));
        let other_maker =
            product.manufacturer.as_deref().is_some_and(|maker| !self.makers.is_empty() && !is_permitted(maker));
        let of_the_offer =
            [other_maker.then_some(Unmet::Maker), self.unmet_price(product), self.unmet_lead_time(product)];
        let length_max = self.length_max.filter(|_| !length_unknown);
        let mass_max = self.mass_max.filter(|_| !mass_unknown);
        let of_the_product = of_the_product.into_iter().chain(of_the_offer).flatten();
        of_the_product.chain(self.unmet_of((length_max, mass_max), &product.parameters))
    }

    fn unmet_price(&self, product: &Product) -> Option<Unmet> {
        let permits = self.price_max?;
        let Some(has) = product.offer.price.as_deref().and_then(Price::read) else {
            return Some(Unmet::NotOffered(OfferDatum::Price));
        };
        if has.currency != permits.currency {
            return Some(Unmet::NotOffered(OfferDatum::PriceInCurrency));
        }
        (!at_most(has.amount, permits.amount)).then_some(Unmet::Price { has, permits })
    }

    fn unmet_lead_time(&self, product: &Product) -> Option<Unmet> {
        let permits = self.lead_time_max?;
        let Some(has) = product.offer.lead_time else { return Some(Unmet::NotOffered(OfferDatum::LeadTime)) };
        (!at_most(has.si(), permits.si())).then_some(Unmet::LeadTime { has, permits })
    }

    /// Returns `true` if a product meets the requirements as it is ordered: none of them [rejects](Unmet::rejects) it.
    #[must_use]
    pub fn are_met(&self, ordered: &ProductId, product: &Product) -> bool {
        !self.unmet(ordered, product).any(|unmet| unmet.rejects(product))
    }

    /// Iterates over the unmet requirements among those that depend on data only, with the limits of length and mass
    /// passed in.
    fn unmet_of(
        &self,
        (length_max, mass_max): (Option<Length>, Option<Mass>),
        actuator: &Parameters,
    ) -> impl Iterator<Item = Unmet> + use<> {
        let found = [
            compare(self.hollow_shaft_min, &actuator.hollow_shaft, "d_H", |needs, has| {
                (!at_least(has.si(), needs.si())).then_some(Unmet::HollowShaft { has, needs })
            }),
            compare(length_max, &actuator.length, "L", |permits, has| {
                (!at_most(has.si(), permits.si())).then_some(Unmet::Length { has, permits })
            }),
            compare(mass_max, &actuator.mass, "m", |permits, has| {
                (!at_most(has.si(), permits.si())).then_some(Unmet::Mass { has, permits })
            }),
            compare(self.supply, &actuator.terminal_voltage_min, "U_M", |supply, needs| {
                let gives = ElectricPotential::from_si(supply.si() / std::f64::consts::SQRT_2);
                (!at_least(gives.si(), needs.si())).then_some(Unmet::SupplyTooLow { needs, gives })
            }),
        ];
        found.into_iter().flatten()
    }
}

/// Compares a requirement with a datum; `None` if there is no requirement or it is met.
fn compare<Q: Measure>(
    required: Option<Q>,
    datum: &Datum<Q>,
    symbol: &'static str,
    breaks: impl FnOnce(Q, Q) -> Option<Unmet>,
) -> Option<Unmet> {
    let required = required?;
    match datum.known() {
        Some(known) => breaks(required, known.value),
        None => Some(Unmet::NotKnown { symbol, requires: required.si() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{MILLIMETRE, VOLT};

    fn unmet(requirements: &Requirements, text: &str) -> Vec<Unmet> {
        let code = order_code::parse(text).unwrap().code;
        let product = Product::of_code(code, crate::parameters(&code).unwrap());
        requirements.unmet(&code.into(), &product).collect()
    }

    #[test]
    fn the_length_with_option_k_is_not_the_printed_one() {
        let short = Requirements { length_max: Some(Length::new_in(130.0, &MILLIMETRE)), ..Requirements::default() };
        assert_eq!(unmet(&short, "CHA-14A-30-E-RES"), []);
        assert_eq!(unmet(&short, "CHA-14A-30-E-RES-K"), [Unmet::NotKnown { symbol: "L", requires: 0.13 }]);
        assert!(matches!(unmet(&short, "CHA-25A-30-H-C1024").as_slice(), [Unmet::Length { .. }]));
    }

    #[test]
    fn of_a_special_design_length_and_mass_are_not_known() {
        let wish = Requirements {
            length_max: Some(Length::new_in(1.0, &quantities::unit::METRE)),
            mass_max: Some(Mass::new_in(100.0, &quantities::unit::KILOGRAM)),
            ..Requirements::default()
        };
        assert_eq!(unmet(&wish, "CHA-20A-100-H-C1024"), []);
        let unknown = [("L", 1.0), ("m", 100.0)].map(|(symbol, requires)| Unmet::NotKnown { symbol, requires });
        assert_eq!(unmet(&wish, "CHA-20A-100-H-C1024-SP"), unknown);
    }

    #[test]
    fn the_supply_must_reach_the_winding() {
        let at =
            |volts| Requirements { supply: Some(ElectricPotential::new_in(volts, &VOLT)), ..Requirements::default() };
        assert_eq!(unmet(&at(48.0), "CHA-14A-30-E-RES"), []);
        assert_eq!(unmet(&at(560.0), "CHA-14A-30-H-RES"), []);
        assert!(matches!(unmet(&at(48.0), "CHA-14A-30-H-RES").as_slice(), [Unmet::SupplyTooLow { .. }]));
    }

    #[test]
    fn an_offer_is_compared_where_it_is_stated() {
        use crate::offer::Offer;
        use quantities::unit::DAY;
        let offered = |price: &str| {
            let offer = Offer { price: Some(price.into()), lead_time: Some(Time::new_in(30.0, &DAY)) };
            Product::of_file("X", (Some("Example Drives GmbH"), None), Parameters::unknown(), offer)
        };
        let all = Requirements {
            makers: vec!["example drives".to_owned()],
            price_max: Price::read("1000 EUR"),
            lead_time_max: Some(Time::new_in(30.0, &DAY)),
            ..Requirements::default()
        };
        let unmet = |requirements: &Requirements, price: &str| {
            let product = offered(price);
            (requirements.unmet(&product.id, &product).collect::<Vec<_>>(), requirements.are_met(&product.id, &product))
        };
        assert_eq!(unmet(&all, "1000,00 EUR"), (vec![], true));
        assert!(
            matches!(unmet(&all, "1000,01 EUR"), (found, false) if matches!(found.as_slice(), [Unmet::Price { .. }]))
        );
        assert_eq!(unmet(&all, "900 CHF"), (vec![Unmet::NotOffered(OfferDatum::PriceInCurrency)], true));
        assert_eq!(unmet(&all, "on request"), (vec![Unmet::NotOffered(OfferDatum::Price)], true));
        let others = Requirements { makers: vec!["Example D".to_owned()], ..Requirements::default() };
        assert_eq!(unmet(&others, "1 EUR"), (vec![Unmet::Maker], false));
        let sooner = Requirements { lead_time_max: Some(Time::new_in(29.0, &DAY)), ..Requirements::default() };
        assert!(
            matches!(unmet(&sooner, "1 EUR"), (found, false) if matches!(found.as_slice(), [Unmet::LeadTime { .. }]))
        );
    }

    /// The manual states no price: of its products the price stays open, and they are not left out.
    #[test]
    fn without_an_offer_the_price_is_open() {
        let code = order_code::parse("CHA-20A-100-H-C1024").unwrap().code;
        let product = Product::of_code(code, crate::parameters(&code).unwrap());
        let cheap = Requirements { price_max: Price::read("1 EUR"), ..Requirements::default() };
        let found: Vec<Unmet> = cheap.unmet(&code.into(), &product).collect();
        assert_eq!(found, [Unmet::NotOffered(OfferDatum::Price)]);
        assert!(found[0].is_open() && cheap.are_met(&code.into(), &product));
    }

    #[test]
    fn a_doubtful_mass_counts_with_the_heavier_value() {
        use quantities::unit::KILOGRAM;
        let light = Requirements { mass_max: Some(Mass::new_in(5.0, &KILOGRAM)), ..Requirements::default() };
        assert_eq!(unmet(&light, "CHA-25A-50-H-C1024"), []);
        assert!(matches!(unmet(&light, "CHA-25A-50-H-M512P").as_slice(), [Unmet::Mass { .. }]));
    }
}
