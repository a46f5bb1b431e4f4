//! Connectors, pins and cables of a code, and the comparison of a pin list with them.

use crate::{Fact, Id, NoteBy, Number};
use installation::wiring::{CableFor, CableRole, Circuit, Role, Severity, SignalGroup};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `wiring`: connections of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Wiring {
    /// Ordering code.
    pub code: String,
    /// Connectors of the actuator.
    pub connectors: Vec<Connector>,
    /// Cables listed in the manual.
    pub cables: Vec<Cable>,
    /// Parts that do not exist for this code, or not in the manual.
    pub not_available: Vec<NotAvailable>,
    /// Further statements of the tables and their notes.
    pub notes: Vec<WiringNote>,
    /// Rules and hazards, the gravest first.
    pub rules: Vec<Fact>,
    /// Voltage drop on the wires; `null` unless a length was given.
    pub voltage_drop: Option<VoltageDrops>,
    /// Ids of the errata that concern the data shown.
    pub errata: Vec<&'static str>,
}

/// A connector of the actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Connector {
    /// Purpose of the connector.
    pub role: Id<Role>,
    /// Poles and thread as in the manual.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// Number of poles.
    pub poles: u8,
    /// Thread.
    pub thread: &'static str,
    /// Location: at the end of a cable, in the housing; `null` if not stated.
    pub exit: Option<ConnectorExit>,
    /// Material number of the mating connector; `null` if the manual states none.
    pub material_number: Option<&'static str>,
    /// Outer diameter of the mating connector as in the manual; `null` if it states none.
    pub outer_diameter: Option<&'static str>,
    /// Length of the mating connector as in the manual; `null` if it states none.
    pub length: Option<&'static str>,
    /// Unit of diameter and length.
    pub unit: &'static str,
    /// Pins; empty if the manual states none for this code.
    pub pins: Vec<ConnectorPin>,
    /// Colours shared by several wires: identify the wire by its pin.
    pub ambiguous: Vec<AmbiguousColour>,
    /// Tables of the connector and of its pins.
    pub tables: [&'static str; 2],
}

/// Location of a connector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ConnectorExit {
    /// Connector at the end of a cable.
    Cable,
    /// Connector in the housing.
    Housing,
}

/// A pin of a connector.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConnectorPin {
    /// Number of the pin, or `PE`.
    pub pin: String,
    /// Pin named in brackets in the manual: both belong to one wire.
    pub joined_with: Option<String>,
    /// Signal as in the manual; `-` if nothing is connected.
    pub signal: &'static str,
    /// `true` if a wire is connected.
    pub connected: bool,
    /// Kind of the signal; `null` if nothing is connected.
    pub group: Option<Id<SignalGroup>>,
    /// Colour of the wire, in the requested language; `null` if the manual states none.
    pub colour: Option<&'static str>,
    /// Meaning of the signal.
    pub meaning: String,
    /// Cell that states the signal; for an empty field its table.
    pub source: String,
    /// Grade of the statement.
    pub grade: Id<Grade>,
    /// Ids of the errata that concern the pin.
    pub errata: Vec<&'static str>,
}

/// A colour shared by several wires.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AmbiguousColour {
    /// Name of the colour.
    pub colour: &'static str,
    /// Pins whose wires have the colour.
    pub pins: Vec<String>,
}

/// A cable.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Cable {
    /// Parts connected by the cable.
    pub role: Id<CableRole>,
    /// Material number.
    pub material_number: &'static str,
    /// Length; `null` if another manufacturer encodes it in letters of the material number.
    pub length_m: Option<Number>,
    /// Letters of the material number that encode the length; else `null`.
    pub length_code: Option<&'static str>,
    /// Device at the other end.
    #[serde(rename = "for")]
    pub goal: String,
    /// Id of that device.
    pub drive: Id<CableFor>,
    /// Table that lists the cable.
    pub table: &'static str,
    /// Cell that lists the cable.
    pub source: String,
    /// Ids of the errata that concern the material number.
    pub errata: Vec<&'static str>,
}

/// A part that does not exist.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NotAvailable {
    /// Id of the part.
    pub id: &'static str,
    /// Name of the part and reason.
    pub text: &'static str,
    /// Table that shows it.
    pub table: &'static str,
}

/// A statement of the notes of a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringNote {
    /// Text of the note.
    pub text: String,
    /// Author of the note.
    pub by: NoteBy,
    /// Table concerned; `null` for several.
    pub table: Option<&'static str>,
}

/// Voltage drop on the wires of a cable.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct VoltageDrops {
    /// Length of the cable.
    pub length_m: Number,
    /// Cross-section of a wire; `null` if none was given.
    pub cross_section_mm2: Option<Number>,
    /// The circuits.
    pub circuits: Vec<VoltageDrop>,
    /// Assumptions, as text.
    pub assumptions: &'static str,
    /// Source of the resistivity of copper.
    pub resistivity_source: String,
}

/// Voltage drop in one circuit, outward and return wire.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct VoltageDrop {
    /// Id of the circuit.
    pub circuit: Id<Circuit>,
    /// Name of the circuit.
    pub name: &'static str,
    /// Current.
    pub current_a: Number,
    /// Source of the current.
    pub current_source: String,
    /// Voltage of the supply; `null` if the manual states none.
    pub nominal_v: Option<Number>,
    /// Minimum voltage at the load; `null` if the manual states none.
    pub least_v: Option<Number>,
    /// Source of the voltages.
    pub voltage_source: String,
    /// Voltage drop at 20 °C; `null` without a cross-section.
    pub loss_20_degc_v: Option<Number>,
    /// Voltage drop at 70 °C; `null` without a cross-section.
    pub loss_70_degc_v: Option<Number>,
    /// Supply voltage required for the minimum voltage at the load on a warm wire; `null` if unknown.
    pub needed_v: Option<Number>,
    /// Smallest cross-section at 70 °C; `null` if the manual states no limit.
    pub cross_section_min_mm2: Option<Number>,
    /// Verdict on the minimum voltage.
    pub verdict: Id<Verdict>,
    /// Reason why it fails or is not checked; empty if it passes.
    pub reason: &'static str,
    /// `true` if the connector has sense lines.
    pub sense_lines: bool,
    /// Grade of the voltage drop.
    pub grade: Id<Grade>,
}

/// `wiring --check`: comparison of a pin list with the manual.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringCheck {
    /// Ordering code.
    pub code: String,
    /// `true` if the findings are advice only.
    pub agrees: bool,
    /// Number of rows in the list.
    pub rows: usize,
    /// Number of rows that agree with the manual.
    pub agreeing: usize,
    /// Differences by line.
    pub findings: Vec<WiringFinding>,
}

/// A difference between list and manual.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WiringFinding {
    /// Id of the finding.
    pub id: &'static str,
    /// Severity of the finding.
    pub severity: Id<Severity>,
    /// Connector concerned.
    pub connector: Id<Role>,
    /// Line of the list; `null` if the finding concerns a missing entry.
    pub line: Option<usize>,
    /// Pin; `null` if the finding concerns the connector.
    pub pin: Option<String>,
    /// Value in the manual; `null` if the finding concerns the connector or a pin that does not exist.
    pub expected: Option<&'static str>,
    /// Description of the difference.
    pub message: String,
    /// Action to take.
    pub action: &'static str,
}
