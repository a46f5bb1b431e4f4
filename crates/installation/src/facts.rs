//! Facts of the manual that concern an ordering code, and their order.

use actuator::Parameters;
use catalogue::{Fact, LifeStep, Topic};
use configurator::Uncovered;
use order_code::OrderCode;
use provenance::Datum;
use quantities::unit::KILOGRAM;
use quantities::{Mass, Measure};

/// Fact that states the mass above which lifting gear is needed.
const HOIST: &str = "hoist_above_20_kg";

/// Order of facts; equal ones keep the order of the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Order of the data.
    Data,
    /// Severity of the signal word, then phases of the machine's life.
    Gravest,
    /// Phases of the machine's life, then severity of the signal word; shutdown in the order of its steps.
    Life,
}

/// Returns the facts on a topic about a code; safety is included in every topic. Lifting gear is omitted if the mass is
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
            let weight = (fact.step != Some(LifeStep::Shutdown)).then_some((fact.signal.is_none(), fact.signal));
            (fact.step.is_none(), fact.step, weight)
        }),
    }
    facts
}

/// Returns `true` if a mass requires lifting gear; `None` if it is not stated.
pub(crate) fn needs_hoist(mass: &Datum<Mass>) -> Option<bool> {
    let fact = catalogue::fact(HOIST)?;
    let limit = fact.values.first().map(|value| Mass::new_in(value.number, &KILOGRAM))?;
    mass.known().map(|mass| mass.value.si() > limit.si())
}

/// Returns the mass of a code; unknown for a design that differs from the standard version.
pub(crate) fn mass_of(actuator: &Parameters, uncovered: &[Uncovered]) -> Datum<Mass> {
    if uncovered.iter().any(|what| what.not_printed().contains(&"m")) {
        Datum::NotPrinted
    } else {
        actuator.mass.clone()
    }
}
