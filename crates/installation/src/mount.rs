//! Mounting of an actuator: fits, tolerances, dimensions, screws, and requirements of the manual.

use crate::facts::{Order, facts_about, mass_of, needs_hoist};
use crate::fit::{Bore, PilotFit, Side, fit};
use crate::joint::{AxisLoads, BoltedJoint, joint};
use catalogue::{Cell, Fact, Topic};
use configurator::{Uncovered, uncovered};
use order_code::OrderCode;
use provenance::Datum;
use quantities::{Length, Mass};

/// Options of a mounting request in addition to the ordering code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MountInputs {
    /// Bore in the load; `None` for the recommended one.
    pub bore_load: Option<Bore>,
    /// Bore in the machine; `None` for the recommended one.
    pub bore_housing: Option<Bore>,
    /// Loads of a project, which replace the limits.
    pub axis: AxisLoads,
}

/// Mounting data of one actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Mount {
    /// Ordering code of the actuator.
    pub code: OrderCode,
    /// Properties of the code that the tables do not cover.
    pub uncovered: Vec<Uncovered>,
    /// Pilots with the bores on them, load first.
    pub fits: Vec<PilotFit>,
    /// Tolerances of the output flange, by symbol.
    pub runouts: Vec<(&'static str, Datum<Length>)>,
    /// Overall length; not stated for designs that differ from the standard version.
    pub length: Datum<Length>,
    /// Bore of the hollow shaft.
    pub hollow_shaft: Datum<Length>,
    /// Mass of the actuator.
    pub mass: Datum<Mass>,
    /// The mass requires lifting gear; `None` if it is not stated.
    pub hoist: Option<bool>,
    /// Aluminium plate to which the continuous-duty data apply.
    pub plate: Option<&'static Cell>,
    /// Degree of protection.
    pub protection: Option<&'static Cell>,
    /// Bolted joints, load first.
    pub joints: Vec<BoltedJoint>,
    /// Requirements of the manual, in the order of the steps.
    pub facts: Vec<&'static Fact>,
}

/// Returns the mounting data of an actuator; `None` if the manual has no data for it.
#[must_use]
pub fn mount(code: &OrderCode, asked: &MountInputs) -> Option<Mount> {
    let actuator = configurator::parameters(code)?;
    let uncovered = uncovered(code);
    let bores = [asked.bore_load, asked.bore_housing];
    let fits = Side::ALL.iter().zip(bores).filter_map(|(side, bore)| fit(code, *side, bore)).collect();
    let runouts = ["runout_a", "runout_b", "runout_c", "runout_d"].map(|symbol| {
        let cell = catalogue::size_cell(code.size, code.ratio, symbol);
        (symbol, cell.map_or(Datum::NotPrinted, catalogue::datum_of))
    });
    // The length of the standard version does not apply to a design that differs from it.
    let differs = uncovered.iter().any(|what| what.not_printed().contains(&"L"));
    let length = if differs { Datum::NotPrinted } else { actuator.length.clone() };
    let mass = mass_of(&actuator, &uncovered);
    let hoist = needs_hoist(&mass);
    let facts = facts_about(Topic::Mount, code, Order::Life);
    let joints = Side::ALL.iter().map(|side| joint(code, *side, &actuator, &asked.axis)).collect();
    let head = format!("{}-{}", code.series().as_str(), code.size);
    Some(Mount {
        code: *code,
        uncovered,
        fits,
        runouts: runouts.to_vec(),
        length,
        hollow_shaft: actuator.hollow_shaft.clone(),
        mass,
        hoist,
        plate: catalogue::cells().find(|cell| cell.place.symbol == "plate" && cell.place.drive == head),
        protection: catalogue::winding_data(code.winding)
            .and_then(|data| catalogue::table_cell(data.general, "protection_class")),
        joints,
        facts,
    })
}
