//! How an actuator is mounted: fits, tolerances, dimensions, screws, and what the manual asks for in prose.

use crate::fit::{Bore, Fit, Side, fit};
use crate::joint::{AxisLoads, Joint, joint};
use actuator::Parameters;
use catalogue::{Cell, Fact, Step, Table, Topic};
use configurator::{Uncovered, uncovered};
use order_code::{OrderCode, Winding};
use provenance::Datum;
use quantities::unit::KILOGRAM;
use quantities::{Length, Mass, Measure};

/// What is asked beside the ordering code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MountAsked {
    /// The bore in the load; the recommended one without.
    pub bore_load: Option<Bore>,
    /// The bore in the machine; the recommended one without.
    pub bore_housing: Option<Bore>,
    /// Loads of a project in place of the limits.
    pub axis: AxisLoads,
}

/// Everything for mounting one actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Mount {
    /// The ordering code.
    pub code: OrderCode,
    /// What the tables do not cover of it.
    pub uncovered: Vec<Uncovered>,
    /// The pilots with the bores over them, load first.
    pub fits: Vec<Fit>,
    /// Tolerances of the output flange, by symbol.
    pub runouts: Vec<(&'static str, Datum<Length>)>,
    /// Overall length; not printed for designs that differ from the standard.
    pub length: Datum<Length>,
    /// Bore of the hollow shaft.
    pub hollow_shaft: Datum<Length>,
    /// Mass to lift.
    pub mass: Datum<Mass>,
    /// Whether the mass asks for lifting gear; `None` where it is not printed.
    pub hoist: Option<bool>,
    /// Aluminium plate that the continuous data hold on.
    pub plate: Option<&'static Cell>,
    /// Degree of protection.
    pub protection: Option<&'static Cell>,
    /// The screw joints, load first.
    pub joints: Vec<Joint>,
    /// What the manual asks for, in the order of the steps.
    pub facts: Vec<&'static Fact>,
}

/// How an actuator is mounted; `None` where the manual prints no data for it.
#[must_use]
pub fn mount(code: &OrderCode, asked: &MountAsked) -> Option<Mount> {
    let actuator = configurator::parameters(code)?;
    let uncovered = uncovered(code);
    let bores = [asked.bore_load, asked.bore_housing];
    let fits = Side::ALL.iter().zip(bores).filter_map(|(side, bore)| fit(code, *side, bore)).collect();
    let runouts = ["runout_a", "runout_b", "runout_c", "runout_d"].map(|symbol| {
        let cell = catalogue::size_cell(code.size, code.ratio, symbol);
        (symbol, cell.map_or(Datum::NotPrinted, catalogue::datum_of))
    });
    // A length of the standard is none of a design that differs from it.
    let differs = uncovered.iter().any(|what| what.not_printed().contains(&"L"));
    let length = if differs { Datum::NotPrinted } else { actuator.length.clone() };
    let mass = mass_of(&actuator, &uncovered);
    let hoist = needs_hoist(&mass);
    let facts = facts_on(Topic::Mount, code, hoist);
    let joints = Side::ALL.iter().map(|side| joint(code, *side, &actuator, &asked.axis)).collect();
    let head = format!("CHA-{}", code.size);
    Some(Mount {
        code: *code,
        uncovered,
        fits,
        runouts: runouts.to_vec(),
        length,
        hollow_shaft: actuator.hollow_shaft.clone(),
        mass,
        hoist,
        plate: cell_of("13.3", "plate").find(|cell| cell.place.drive == head),
        protection: cell_of(if code.winding == Winding::E { "13.1" } else { "13.2" }, "protection_class").next(),
        joints,
        facts,
    })
}

/// The fact that names the mass from which lifting gear is needed.
const HOIST: &str = "hoist_above_20_kg";

/// Whether a mass asks for lifting gear; `None` where it is not printed.
pub(crate) fn needs_hoist(mass: &Datum<Mass>) -> Option<bool> {
    let fact = catalogue::facts().iter().find(|fact| fact.id == HOIST)?;
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

fn cell_of(table: &str, symbol: &'static str) -> impl Iterator<Item = &'static Cell> {
    let cells = catalogue::table(table).map(Table::cells).unwrap_or_default();
    cells.iter().filter(move |cell| cell.place.symbol == symbol)
}

/// The facts that an answer on a topic shows for a code, in the order of a machine's life, the gravest of a step first; shutting
/// down goes in the order of its steps. Lifting gear is left out where the mass is known to need none.
pub(crate) fn facts_on(topic: Topic, code: &OrderCode, hoist: Option<bool>) -> Vec<&'static Fact> {
    let shown = |fact: &&Fact| fact.is_shown(topic, code) && (fact.id != HOIST || hoist != Some(false));
    let mut facts: Vec<&'static Fact> = catalogue::facts().iter().filter(shown).collect();
    // Stable: what stands alike keeps the order of the data.
    facts.sort_by_key(|fact| {
        let weight = (fact.step != Some(Step::Shutdown)).then_some((fact.signal.is_none(), fact.signal));
        (fact.step.is_none(), fact.step, weight)
    });
    facts
}
