//! The facts in prose that concern an ordering code, and their order.

use actuator::Parameters;
use catalogue::{Fact, Step, Topic};
use configurator::Uncovered;
use order_code::OrderCode;
use provenance::Datum;
use quantities::unit::KILOGRAM;
use quantities::{Mass, Measure};

/// The fact that names the mass from which lifting gear is needed.
const HOIST: &str = "hoist_above_20_kg";

/// The order of the facts; equal ones keep the order of the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As the data have them.
    Data,
    /// The gravest signal word first, then as a machine lives.
    Gravest,
    /// As a machine lives, the gravest of a step first; shutting down goes in the order of its steps.
    Life,
}

/// What is stated on a topic about a code; safety is stated on every topic. Lifting gear is left out where the mass is
/// known to need none.
#[must_use]
pub fn facts_about(topic: Topic, code: &OrderCode, order: Order) -> Vec<&'static Fact> {
    let light = || {
        let actuator = configurator::parameters(code)?;
        Some(!needs_hoist(&mass_of(&actuator, &configurator::uncovered(code)))?)
    };
    let shown = |fact: &&Fact| fact.is_shown(topic, code) && (fact.id != HOIST || light() != Some(true));
    let mut facts: Vec<&'static Fact> = catalogue::facts().iter().filter(shown).collect();
    match order {
        Order::Data => {}
        Order::Gravest => facts.sort_by_key(|fact| (fact.signal.is_none(), fact.signal, fact.step)),
        Order::Life => facts.sort_by_key(|fact| {
            let weight = (fact.step != Some(Step::Shutdown)).then_some((fact.signal.is_none(), fact.signal));
            (fact.step.is_none(), fact.step, weight)
        }),
    }
    facts
}

/// Whether a mass requires lifting gear; `None` if it is not printed.
pub(crate) fn needs_hoist(mass: &Datum<Mass>) -> Option<bool> {
    let fact = catalogue::fact(HOIST)?;
    let limit = fact.values.first().map(|value| Mass::new_in(value.number, &KILOGRAM))?;
    mass.known().map(|mass| mass.value.si() > limit.si())
}

/// The mass of a code; that of the standard is none of a design that differs from it.
pub(crate) fn mass_of(actuator: &Parameters, uncovered: &[Uncovered]) -> Datum<Mass> {
    if uncovered.iter().any(|what| what.not_printed().contains(&"m")) {
        Datum::NotPrinted
    } else {
        actuator.mass.clone()
    }
}
