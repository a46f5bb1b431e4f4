//! Requirements of the user on the actuator in addition to the checks.

use crate::product::{Product, ProductId};
use crate::rules::uncovered;
use actuator::Parameters;
use numeric::{at_least, at_most};
use order_code::{Brake, Feedback};
use provenance::Datum;
use quantities::{ElectricPotential, Length, Mass, Measure};

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
    /// DC link voltage that supplies the servo drive.
    pub supply: Option<ElectricPotential>,
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
    /// The manual does not state the datum that the requirement needs.
    NotKnown {
        /// Symbol of the datum.
        symbol: &'static str,
    },
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
            length_unknown.then_some(Unmet::NotKnown { symbol: "L" }),
            mass_unknown.then_some(Unmet::NotKnown { symbol: "m" }),
        ];
        let length_max = self.length_max.filter(|_| !length_unknown);
        let mass_max = self.mass_max.filter(|_| !mass_unknown);
        of_the_product.into_iter().flatten().chain(self.unmet_of((length_max, mass_max), &product.parameters))
    }

    /// Returns `true` if a product meets the requirements as it is ordered. Data that a file of the user leaves open are
    /// unknown and break no requirement.
    #[must_use]
    pub fn are_met(&self, ordered: &ProductId, product: &Product) -> bool {
        self.unmet(ordered, product).all(|unmet| product.is_described() && matches!(unmet, Unmet::NotKnown { .. }))
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
fn compare<Q: Copy>(
    required: Option<Q>,
    datum: &Datum<Q>,
    symbol: &'static str,
    breaks: impl FnOnce(Q, Q) -> Option<Unmet>,
) -> Option<Unmet> {
    let required = required?;
    match datum.known() {
        Some(known) => breaks(required, known.value),
        None => Some(Unmet::NotKnown { symbol }),
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
        assert_eq!(unmet(&short, "CHA-14A-30-E-RES-K"), [Unmet::NotKnown { symbol: "L" }]);
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
        let unknown = ["L", "m"].map(|symbol| Unmet::NotKnown { symbol });
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
    fn a_doubtful_mass_counts_with_the_heavier_value() {
        use quantities::unit::KILOGRAM;
        let light = Requirements { mass_max: Some(Mass::new_in(5.0, &KILOGRAM)), ..Requirements::default() };
        assert_eq!(unmet(&light, "CHA-25A-50-H-C1024"), []);
        assert!(matches!(unmet(&light, "CHA-25A-50-H-M512P").as_slice(), [Unmet::Mass { .. }]));
    }
}
