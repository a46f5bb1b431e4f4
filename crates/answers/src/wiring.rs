//! Connectors, pins and cables of a code, and the comparison of a pin list with them.

use crate::{Fact, Id, NoteBy, Number};
use installation::wiring::{CableFor, CableRole, Circuit, Group, Role, Severity};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `wiring`: what is connected where.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Wiring {
    /// The code.
    pub code: String,
    /// Its connectors.
    pub connectors: Vec<Connector>,
    /// The cables that the manual lists for it.
    pub cables: Vec<Cable>,
    /// What there is not for this code, or not in the manual.
    pub not_available: Vec<NotAvailable>,
    /// What the tables and their notes say besides.
    pub notes: Vec<WiringNote>,
    /// Rules and hazards, gravest first.
    pub rules: Vec<Fact>,
    /// Voltage lost on the wires; `null` unless a length was given.
    pub voltage_drop: Option<VoltageDrops>,
    /// Ids of the errata that touch what is shown.
    pub errata: Vec<&'static str>,
}

/// A connector of the actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Connector {
    /// What it is for.
    pub role: Id<Role>,
    /// Poles and thread as printed.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// Its poles.
    pub poles: u8,
    /// Its thread.
    pub thread: &'static str,
    /// Where it is: at the end of a cable, in the housing; `null` where that is not stated.
    pub exit: Option<ConnectorExit>,
    /// Material number of the mating coupling; `null` where none is printed.
    pub material_number: Option<&'static str>,
    /// Outer diameter of the mating coupling as printed; `null` where none is.
    pub outer_diameter: Option<&'static str>,
    /// Length of the mating coupling as printed; `null` where none is.
    pub length: Option<&'static str>,
    /// Unit of the two.
    pub unit: &'static str,
    /// Its pins; empty where they are not printed for this code.
    pub pins: Vec<ConnectorPin>,
    /// Colours that several of its wires have: wire by pin.
    pub ambiguous: Vec<AmbiguousColour>,
    /// Table of the connector, and of its pins.
    pub tables: [&'static str; 2],
}

/// Where a connector is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ConnectorExit {
    /// At the end of a cable.
    Cable,
    /// In the housing.
    Housing,
}

/// A pin of a connector.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConnectorPin {
    /// Its number, or `PE`.
    pub pin: String,
    /// The pin that the print names in brackets: both belong to one wire.
    pub joined_with: Option<String>,
    /// The signal as printed; `-` where nothing is connected.
    pub signal: &'static str,
    /// Whether something is connected.
    pub connected: bool,
    /// Of which kind the signal is; `null` where nothing is connected.
    pub group: Option<Id<Group>>,
    /// Colour of the wire, in the requested language; `null` if none is printed.
    pub colour: Option<&'static str>,
    /// What the signal is.
    pub meaning: String,
    /// The cell that prints it; of an empty field its table.
    pub source: String,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Ids of the errata that touch it.
    pub errata: Vec<&'static str>,
}

/// A colour that does not tell wires apart.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AmbiguousColour {
    /// The colour.
    pub colour: &'static str,
    /// The pins whose wires have it.
    pub pins: Vec<String>,
}

/// A cable.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Cable {
    /// What it connects.
    pub role: Id<CableRole>,
    /// Its material number.
    pub material_number: &'static str,
    /// Its length; `null` where the material number has it in letters of another maker.
    pub length_m: Option<Number>,
    /// The letters of the material number that stand for the length; else `null`.
    pub length_code: Option<&'static str>,
    /// What it goes to.
    #[serde(rename = "for")]
    pub goal: String,
    /// The same as an id.
    pub drive: Id<CableFor>,
    /// The table that prints it.
    pub table: &'static str,
    /// The cell that prints it.
    pub source: String,
}

/// What there is not.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NotAvailable {
    /// Its id.
    pub id: &'static str,
    /// What there is not, and why.
    pub text: &'static str,
    /// The table that shows it.
    pub table: &'static str,
}

/// What a table's notes say.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringNote {
    /// What it says.
    pub text: String,
    /// Who says so.
    pub by: NoteBy,
    /// The table that it is about; `null`: several.
    pub table: Option<&'static str>,
}

/// Voltage lost on the wires of a cable.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct VoltageDrops {
    /// Length of the cable.
    pub length_m: Number,
    /// Cross-section of a wire; `null` where none was given.
    pub cross_section_mm2: Option<Number>,
    /// The circuits.
    pub circuits: Vec<VoltageDrop>,
    /// What was assumed.
    pub assumptions: &'static str,
    /// Where the resistivity of copper is from.
    pub resistivity_source: String,
}

/// Voltage lost in one circuit, forth and back.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct VoltageDrop {
    /// Which circuit.
    pub circuit: Id<Circuit>,
    /// Its name.
    pub name: &'static str,
    /// Its current.
    pub current_a: Number,
    /// Where the current is from.
    pub current_source: String,
    /// Voltage that the source has; `null` where none is printed.
    pub nominal_v: Option<Number>,
    /// Least voltage at the load; `null` where none is printed.
    pub least_v: Option<Number>,
    /// Where the voltages are from.
    pub voltage_source: String,
    /// Loss at 20 °C; `null` without a cross-section.
    pub loss_20_degc_v: Option<Number>,
    /// Loss at 70 °C; `null` without a cross-section.
    pub loss_70_degc_v: Option<Number>,
    /// Source voltage required for the least voltage at the load on a warm wire; `null` if not known.
    pub needed_v: Option<Number>,
    /// Smallest cross-section at 70 °C; `null` where no limit is printed.
    pub cross_section_min_mm2: Option<Number>,
    /// Whether it is enough.
    pub verdict: Id<Verdict>,
    /// Why it is not, or not checked; empty where it is enough.
    pub reason: &'static str,
    /// Whether the connector has sense lines.
    pub sense_lines: bool,
    /// How far the loss can be trusted.
    pub grade: Id<Grade>,
}

/// `wiring --check`: a list of pins compared with the print.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringCheck {
    /// The code.
    pub code: String,
    /// Whether nothing but advice was found.
    pub agrees: bool,
    /// Rows of the list.
    pub rows: usize,
    /// Rows that agree with the print.
    pub agreeing: usize,
    /// What is different, by line.
    pub findings: Vec<WiringFinding>,
}

/// A difference between list and print.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringFinding {
    /// Its id.
    pub id: &'static str,
    /// How grave it is.
    pub severity: Id<Severity>,
    /// The connector.
    pub connector: Id<Role>,
    /// Line of the list; `null` where it is about what is not in it.
    pub line: Option<usize>,
    /// The pin; `null` where it is about the connector.
    pub pin: Option<String>,
    /// The printed value; `null` if the finding is about the connector or a pin that does not exist.
    pub expected: Option<&'static str>,
    /// What is different.
    pub message: String,
    /// What to do.
    pub action: &'static str,
}
