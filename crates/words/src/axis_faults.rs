//! Words for faults of what is built from a project file.

use super::{bodies, motion, recording};
use crate::faults::{FaultWords, file_fault_text, file_own_hint, hint_text, shown};
use crate::geometry::geometry;
use crate::pick;
use crate::results::with_unit;
use crate::texts::said;
use actuator::{BatteryFault, CurveFault};
use axis::{AxisFault, CycleFault};
use mechanism::{BodyError, TableFault};
use project::Hint;
use quantities::unit::SECOND;
use quantities::{Language, Measure, Unit};

impl FaultWords for AxisFault {
    fn id(&self) -> &'static str {
        self.id()
    }

    fn text(&self, language: Language) -> String {
        axis_fault_text(self, language)
    }

    fn own_hint(&self, language: Language) -> Option<String> {
        axis_own_hint(self, language)
    }
}

/// Returns the fault of an axis in one sentence.
fn axis_fault_text(fault: &AxisFault, language: Language) -> String {
    match fault {
        AxisFault::Stated(fault) => file_fault_text(fault, language),
        AxisFault::Curve(fault) => curve(*fault, language),
        AxisFault::Table(fault) => table(*fault, language),
        AxisFault::Points(fault) => motion::points_fault(*fault, language),
        AxisFault::Battery(fault) => battery_fault(fault, language),
        AxisFault::Recording { name, fault } => format!("{name}: {}", recording::fault(fault, language).0),
        AxisFault::Recorded { name, fault } => format!("{name}: {}", motion::recorded_fault(fault, language).0),
        AxisFault::Move { fault, travel_m_per_rad } => motion::fault(fault, *travel_m_per_rad, language).0,
        AxisFault::Cycle(CycleFault::TooShort { others, cycle }) => {
            let [others, cycle] = [others, cycle].map(|time| with_unit(time.si(), &SECOND, 4, language));
            said!(language =>
                "the other segments take {others}, longer than the cycle of {cycle}"
                | "die übrigen Abschnitte dauern {others}, länger als der Zyklus von {cycle}"
            )
        }
        AxisFault::Cycle(CycleFault::WithTime) => said!(language =>
            "a dwell states its time or the cycle that it fills, not both"
            | "eine Rast nennt ihre Dauer oder den Zyklus, den sie auffüllt, nicht beides"
        ),
        AxisFault::Cycle(CycleFault::Twice) => said!(language =>
            "another dwell fills the cycle already"
            | "eine andere Rast füllt den Zyklus bereits auf"
        ),
        AxisFault::Instants(found) => {
            let [found, most] = [found.instants, found.most].map(|count| format!("{count:.0}"));
            said!(language =>
                "the cycle requires {found} evaluation points; the limit is {most}"
                | "der Zyklus erfordert {found} Stützstellen; gerechnet werden höchstens {most}"
            )
        }
        AxisFault::Body(error) => bodies::fault(error, language),
        AxisFault::ImpossibleWithin { values, why } => impossible(values, why.as_deref(), language),
        AxisFault::Geometry(fault) => geometry(*fault, language).to_owned(),
        AxisFault::BodyOfText { path, error } => format!("`{path}`: {}", bodies::fault(error, language)),
        AxisFault::InCatalogue { name, found } => {
            let (line, column) = (found.line, found.column);
            let text = axis_fault_text(&found.fault, language);
            said!(language => "{name}, line {line}, column {column}: {text}" | "{name}, Zeile {line}, Spalte {column}: {text}")
        }
        AxisFault::NoPrice => said!(language =>
            "no price: an amount with its currency is required; a single point or comma before three digits can be read in two ways"
            | "kein Preis: erforderlich ist ein Betrag mit Währung; ein einzelner Punkt oder ein einzelnes Komma vor drei Ziffern ist nicht eindeutig"
        ),
        AxisFault::UnknownMaker { name, .. } => said!(language =>
            "the catalogue has no manufacturer {}" | "im Katalog steht kein Hersteller {}", recording::quoted(name, language)
        ),
        AxisFault::NoProducts => said!(language =>
            "the catalogue file has no products" | "die Katalogdatei enthält keine Produkte"
        ),
        AxisFault::ProductNamedTwice { id, line } => said!(language =>
            "{id} is named in line {line} already" | "{id} ist bereits in Zeile {line} genannt"
        ),
        AxisFault::ProductOfTwoFiles { id } => said!(language =>
            "{id} is named in two catalogue files" | "{id} ist in zwei Katalogdateien genannt"
        ),
        AxisFault::ProductNamedAsCode { id } => said!(language =>
            "{id} is an ordering code of the built-in series, whose data come from its manual"
            | "{id} ist eine Bestellbezeichnung der mitgelieferten Baureihe, deren Daten aus ihrer Anleitung stammen"
        ),
        AxisFault::NothingOffered => said!(language =>
            "without the built-in series and without catalogue files no actuator is offered"
            | "ohne die mitgelieferte Baureihe und ohne Katalogdateien steht kein Antrieb zur Auswahl"
        ),
    }
}

/// Returns the hint that follows from the fault of an axis alone.
fn axis_own_hint(fault: &AxisFault, language: Language) -> Option<String> {
    match fault {
        AxisFault::Stated(fault) => file_own_hint(fault, language),
        AxisFault::Move { fault, travel_m_per_rad } => motion::fault(fault, *travel_m_per_rad, language).1,
        AxisFault::Recording { fault, .. } => recording::fault(fault, language).1,
        AxisFault::Recorded { fault, .. } => motion::recorded_fault(fault, language).1,
        AxisFault::Instants(_) => Some(said!(language =>
            "describe a shorter cycle; where the load depends on the position, each revolution at changing speed requires 192 points, all revolutions at constant speed together at most two"
            | "einen kürzeren Zyklus beschreiben; hängt die Last von der Position ab, erfordert jede Umdrehung mit veränderlicher Drehzahl 192 Stützstellen, alle Umdrehungen mit konstanter Drehzahl zusammen höchstens zwei"
        )),
        AxisFault::Body(BodyError::NoMass) => example_hint("mass=0.6kg", language),
        AxisFault::Body(BodyError::DistanceOutOfRange { .. }) => example_hint("distance=80mm angle=180deg", language),
        AxisFault::ImpossibleWithin { why: Some(why), .. } => axis_own_hint(why, language),
        AxisFault::BodyOfText { error, .. } => axis_own_hint(&AxisFault::Body(*error), language),
        AxisFault::InCatalogue { found, .. } => {
            let own = || axis_own_hint(&found.fault, language);
            found.hint.as_ref().map(|hint| hint_text(hint, language)).or_else(own)
        }
        AxisFault::NoProducts => example_hint("[[actuator]]", language),
        AxisFault::NoPrice => example_hint("\"1500 EUR\"", language),
        AxisFault::UnknownMaker { makers, .. } => {
            let names = makers.join("; ");
            Some(said!(language => "manufacturers of the catalogue: {names}" | "Hersteller des Katalogs: {names}"))
        }
        AxisFault::NothingOffered => example_hint("files = [\"stock.toml\"]", language),
        AxisFault::ImpossibleWithin { why: None, .. }
        | AxisFault::Curve(_)
        | AxisFault::Table(_)
        | AxisFault::Battery(_)
        | AxisFault::Geometry(_)
        | AxisFault::Points(_)
        | AxisFault::Cycle(_)
        | AxisFault::Body(_)
        | AxisFault::ProductNamedTwice { .. }
        | AxisFault::ProductOfTwoFiles { .. }
        | AxisFault::ProductNamedAsCode { .. } => None,
    }
}

fn example_hint(line: &str, language: Language) -> Option<String> {
    Some(hint_text(&Hint::Example(line.to_owned()), language))
}

/// Returns the values within the tolerances at which the axis is impossible, and the reason.
fn impossible(values: &[(String, f64, &Unit)], why: Option<&AxisFault>, language: Language) -> String {
    // Largest number of quantities that are named.
    const NAMED_MOST: usize = 4;
    let mut named: Vec<String> = values
        .iter()
        .take(NAMED_MOST)
        .map(|(path, value, unit)| format!("{path} = {}", shown(*value, unit, language)))
        .collect();
    if values.len() > NAMED_MOST {
        named.push("…".to_owned());
    }
    let named = named.join(", ");
    let why = why.map(|fault| format!(": {}", axis_fault_text(fault, language))).unwrap_or_default();
    if values.len() == 1 {
        return said!(language =>
            "within this tolerance the axis is not feasible, at {named}{why}"
            | "innerhalb dieser Toleranz ist die Achse nicht ausführbar, bei {named}{why}"
        );
    }
    said!(language =>
        "within these tolerances combined the axis is not feasible, at {named}{why}"
        | "innerhalb dieser Toleranzen zusammen ist die Achse nicht ausführbar, bei {named}{why}"
    )
}

fn curve(fault: CurveFault, language: Language) -> String {
    let (en, de) = match fault {
        CurveFault::TooFewPoints => {
            ("a curve requires at least two points", "eine Kennlinie erfordert mindestens zwei Punkte")
        }
        CurveFault::DoesNotStartAtZero => {
            ("a curve starts at standstill, 0 1/min", "eine Kennlinie beginnt im Stillstand, bei 0 min⁻¹")
        }
        CurveFault::SpeedsNotAscending => (
            "the speeds of a curve must increase from point to point",
            "die Drehzahlen einer Kennlinie müssen von Punkt zu Punkt steigen",
        ),
        CurveFault::TorqueOutOfRange => {
            ("the torques of a curve must not be negative", "die Drehmomente einer Kennlinie dürfen nicht negativ sein")
        }
    };
    pick(language, en, de).to_owned()
}

fn table(fault: TableFault, language: Language) -> String {
    let (en, de) = match fault {
        TableFault::TooFewPoints => {
            ("a table requires at least two points", "eine Tabelle erfordert mindestens zwei Punkte")
        }
        TableFault::PositionsNotAscending => (
            "the positions of a table must increase from point to point",
            "die Positionen einer Tabelle müssen von Punkt zu Punkt steigen",
        ),
        TableFault::NegativeInertia => {
            ("a moment of inertia must not be negative", "ein Massenträgheitsmoment darf nicht negativ sein")
        }
    };
    pick(language, en, de).to_owned()
}

/// Returns a fault in the times for the battery, in one sentence.
#[must_use]
pub fn battery_fault(fault: &BatteryFault, language: Language) -> String {
    let (en, de) = match fault {
        BatteryFault::OperationOutOfRange { .. } => {
            ("operation per day must be from 0 h to 24 h", "der Betrieb je Tag muss zwischen 0 h und 24 h liegen")
        }
        BatteryFault::StorageOutOfRange { .. } => {
            ("the battery model is valid for 0 a to 3 a of storage", "das Batteriemodell gilt für 0 a bis 3 a Lagerung")
        }
    };
    pick(language, en, de).to_owned()
}
