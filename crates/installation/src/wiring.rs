//! Connectors, pins and cables of an ordering code, from sections 6.24 and 6.25 of the manual.

mod cables;
mod comparison;
mod drop;
mod pin_list;
mod role;
mod signal;

pub use cables::{Cable, CableFor, CableLength, CableRole};
pub use comparison::{PinComparison, PinDifference, PinFinding, Severity, compare};
pub use drop::{Circuit, DropVerdict, VoltageDrop, voltage_drops};
pub use pin_list::{LISTED_BYTES_MAX, ListFault, ListedPin, PinColumn, PinList, read_pin_list};
pub use role::Role;
pub use signal::{Polarity, Protocol, SignalGroup, SignalMeaning, TrackForm, WiringSignal};

use catalogue::{Cell, ManualTable, SeriesData};
use order_code::{Brake, OrderCode};
use quantities::identified;
use role::holds;

/// Wiring of one ordering code.
#[derive(Clone, Debug)]
pub struct CodeWiring {
    /// Ordering code of the actuator.
    pub code: OrderCode,
    /// Connectors: motor, motor feedback, and the encoder at the output if fitted.
    pub connectors: Vec<Connector>,
    /// Cables that the manual lists for the code.
    pub cables: Vec<Cable>,
    /// Items that the code or the manual lacks.
    pub absences: Vec<Absence>,
}

impl CodeWiring {
    /// Returns the connector with a role.
    #[must_use]
    pub fn connector(&self, role: Role) -> Option<&Connector> {
        self.connectors.iter().find(|connector| connector.role == role)
    }
}

/// A connector of the actuator and its mating coupling.
#[derive(Clone, Debug)]
pub struct Connector {
    /// Role of the connector.
    pub role: Role,
    /// Poles and thread as stated in the manual: `17 / M23 x 1`.
    pub kind: &'static Cell,
    /// Number of poles.
    pub poles: u8,
    /// Coupling thread: `M23 x 1`.
    pub thread: &'static str,
    /// Material number of the mating coupling; `None` if the manual states none.
    pub mating: Option<&'static Cell>,
    /// Outer diameter of the mating coupling.
    pub outer_diameter: Option<&'static Cell>,
    /// Length of the mating coupling.
    pub length: Option<&'static Cell>,
    /// Mounting at a cable or in the housing; `None` if table 11.3 does not state it.
    pub exit: Option<Exit>,
    /// Table of the pins.
    pub table: &'static ManualTable,
    /// Pins in order; empty if the table applies to other sizes only.
    pub pins: Vec<Pin>,
    /// Colours shared by several wires.
    pub ambiguous: Vec<Ambiguous>,
}

impl Connector {
    /// Returns the pin with a name.
    #[must_use]
    pub fn pin(&self, name: &str) -> Option<&Pin> {
        self.pins.iter().find(|pin| pin.name == name)
    }
}

/// Mounting of a connector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Connector at the end of a cable.
    Cable,
    /// Connector in the housing.
    Housing,
}

/// A pin of a connector.
#[derive(Clone, Debug)]
pub struct Pin {
    /// Number of the pin, or `PE`.
    pub name: String,
    /// Pin in brackets in the table, connected to the same wire.
    pub joined: Option<String>,
    /// Signal stated in the manual; `None` if the field is empty.
    pub signal: Option<&'static Cell>,
    /// Signal on the pin; `None` if it is not connected.
    pub carries: Option<WiringSignal>,
    /// Colour of the wire; `None` if the manual states none.
    pub colour: Option<&'static Cell>,
}

impl Pin {
    /// Returns the signal as stated in the manual; a dash if nothing is connected.
    #[must_use]
    pub fn printed(&self) -> &'static str {
        self.signal.map_or("-", |cell| cell.corrected)
    }

    /// Returns `true` if the pin has a signal of a group.
    pub(crate) fn carries(&self, group: SignalGroup) -> bool {
        self.carries.is_some_and(|signal| signal.group() == group)
    }
}

/// A colour that does not identify a single wire.
#[derive(Clone, Debug)]
pub struct Ambiguous {
    /// Colour of the wires.
    pub colour: &'static Cell,
    /// Pins whose wires have the colour.
    pub pins: Vec<String>,
}

/// An item that the code or the manual lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absence {
    /// Kind of item.
    pub what: Absent,
    /// Table that shows the absence.
    pub table: &'static str,
}

identified! {
    /// Item that a code, or the manual, lacks.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Absent {
        /// The brake: its pins are free.
        Brake = "brake",
        /// The pin assignment of the motor connector, which is stated for other sizes only.
        MotorPins = "motor_pins",
        /// Contacts for a PTC thermistor.
        Ptc = "ptc",
        /// Contacts for a KTY sensor.
        Kty = "kty",
        /// Sense lines.
        Sense = "sense_lines",
        /// A pin for a shield.
        ShieldPin = "shield_pin",
        /// Wire colours.
        Colours = "wire_colours",
        /// Size of the mating coupling.
        MatingSize = "mating_size",
        /// A cable for SINAMICS.
        SinamicsCable = "cable_sinamics",
        /// A cable set with open end.
        OpenCable = "cable_open_end",
        /// A cable set for `YukonDrive`.
        YukonCable = "cable_yukondrive",
        /// A cable for SIMODRIVE.
        SimodriveCable = "cable_simodrive",
        /// Arrangement of the contacts in the insert: the figures of the manual are not in its recovered text.
        Arrangement = "contact_arrangement",
        /// Gender of the contacts of each half.
        Gender = "contact_gender",
        /// Cross-sections of the wires.
        CrossSection = "cross_section",
        /// Effect of the option for cable and connector exit on the connectors.
        ExitOption = "exit_option",
    }
}

/// Returns the wiring of a code; `None` if section 6.24 has none for its winding and feedback.
///
/// # Source
/// cha-manual tables 63.1 to 68.4, with their errata; exits from table 11.3
/// # Valid
/// Standard actuator; a special design may be wired differently.
#[must_use]
pub fn wiring(code: &OrderCode) -> Option<CodeWiring> {
    let mut tables = SeriesData::of(code.series()).wirings.iter();
    let is_wired =
        |windings: &[_], feedbacks: &[_]| windings.contains(&code.winding) && feedbacks.contains(&code.feedback);
    let found = tables.find(|each| is_wired(each.windings, each.feedbacks))?;
    let [motor_kind, motor_pins, feedback_kind, feedback_pins] = found.tables;
    let mut connectors = Vec::new();
    connectors.extend(connector(Role::Motor, motor_kind, motor_pins, code));
    connectors.extend(connector(Role::Feedback, feedback_kind, feedback_pins, code));
    if let ([kind, pins], true) = (SeriesData::of(code.series()).output_wiring, code.has_output_encoder()) {
        connectors.extend(connector(Role::OutputEncoder, kind, pins, code));
    }
    let cables = cables::cables(code);
    let absences = absences(code, &connectors, &cables);
    Some(CodeWiring { code: *code, connectors, cables, absences })
}

fn connector(role: Role, kind: &str, pins: &str, code: &OrderCode) -> Option<Connector> {
    let (kinds, table) = (catalogue::table(kind)?, catalogue::table(pins)?);
    let symbol = if role == Role::Motor { "motor_connector" } else { "encoder_connector" };
    let find = |symbol: &str| kinds.cells().iter().find(|cell| cell.place.symbol == symbol && holds(cell, role, code));
    let kind = find(symbol)?;
    let (poles, thread) = kind.corrected.split_once(" / ")?;
    let poles: u8 = poles.parse().ok()?;
    let pins = pins_of(role, table, poles, code);
    let ambiguous = ambiguous(&pins);
    Some(Connector {
        role,
        kind,
        poles,
        thread,
        mating: find("mat_no"),
        outer_diameter: find("outer_diameter"),
        length: find("length"),
        exit: exit_of(role, code),
        table,
        pins,
        ambiguous,
    })
}

fn exit_of(role: Role, code: &OrderCode) -> Option<Exit> {
    if role == Role::OutputEncoder {
        return None;
    }
    let winding = format!("winding={}", code.winding);
    let marked = |symbol: &str| {
        catalogue::table_cells(SeriesData::of(code.series()).pairs).iter().any(|cell| {
            let of_code = cell.place.condition == winding && cell.feedback == code.feedback.as_str();
            cell.place.symbol == symbol && of_code && cell.corrected == "x"
        })
    };
    match (marked("cable_outlet"), marked("housing_connector")) {
        (true, false) => Some(Exit::Cable),
        (false, true) => Some(Exit::Housing),
        _ => None,
    }
}

/// Returns the pins of a connector: those listed in the table, and the remaining poles with empty fields.
fn pins_of(role: Role, table: &'static ManualTable, poles: u8, code: &OrderCode) -> Vec<Pin> {
    let mut pins: Vec<Pin> = Vec::new();
    for cell in table.cells().iter().filter(|cell| holds(cell, role, code)) {
        let Some((_, head)) = cell.place.condition.rsplit_once("pin ") else { continue };
        let (name, joined) = match head.split_once(" (") {
            Some((name, joined)) => (name, joined.strip_suffix(')').map(str::to_owned)),
            None => (head, None),
        };
        if !pins.iter().any(|pin| pin.name == name) {
            pins.push(Pin { name: name.to_owned(), joined, signal: None, carries: None, colour: None });
        }
        let Some(pin) = pins.iter_mut().find(|pin| pin.name == name) else { continue };
        match cell.place.symbol {
            "wire_colour" if cell.corrected != "-" => pin.colour = Some(cell),
            "signal" | "motor_phase" => {
                pin.signal = Some(cell);
                pin.carries = WiringSignal::of_print(cell.corrected, role, code.feedback);
            }
            _ => {}
        }
    }
    if !pins.is_empty() {
        for number in 1..=poles {
            let name = number.to_string();
            let earth = poles == 8 && number == 8;
            if !earth && !pins.iter().any(|pin| pin.name == name) {
                pins.push(Pin { name, joined: None, signal: None, carries: None, colour: None });
            }
        }
    }
    // Numbers in order, followed by PE.
    pins.sort_by_key(|pin| (pin.name.parse().unwrap_or(u8::MAX), pin.name.clone()));
    pins
}

fn ambiguous(pins: &[Pin]) -> Vec<Ambiguous> {
    let mut found: Vec<Ambiguous> = Vec::new();
    for pin in pins {
        let Some(colour) = pin.colour else { continue };
        match found.iter_mut().find(|each| each.colour.corrected == colour.corrected) {
            Some(each) => each.pins.push(pin.name.clone()),
            None => found.push(Ambiguous { colour, pins: vec![pin.name.clone()] }),
        }
    }
    found.retain(|each| each.pins.len() > 1);
    found
}

fn absences(code: &OrderCode, connectors: &[Connector], cables: &[Cable]) -> Vec<Absence> {
    let of = |role: Role| connectors.iter().find(|connector| connector.role == role);
    let carried =
        |group: SignalGroup| connectors.iter().flat_map(|connector| &connector.pins).any(|pin| pin.carries(group));
    let mut found = Vec::new();
    let mut absent = |what: Absent, table: &'static str| found.push(Absence { what, table });
    let (motor, feedback) = (of(Role::Motor), of(Role::Feedback));
    let motor_table = motor.map_or("", |motor| motor.table.id);
    let feedback_table = feedback.map_or("", |feedback| feedback.table.id);
    if code.brake == Brake::Without {
        absent(Absent::Brake, motor_table);
    }
    if motor.is_some_and(|motor| motor.pins.is_empty()) {
        absent(Absent::MotorPins, motor_table);
    } else if !carried(SignalGroup::Ptc) {
        absent(Absent::Ptc, motor_table);
    }
    if !carried(SignalGroup::Kty) {
        absent(Absent::Kty, feedback_table);
    }
    for (what, group) in [(Absent::Sense, SignalGroup::Sense), (Absent::ShieldPin, SignalGroup::Shield)] {
        if !feedback.is_some_and(|feedback| feedback.pins.iter().any(|pin| pin.carries(group))) {
            absent(what, feedback_table);
        }
    }
    for connector in connectors {
        if !connector.pins.is_empty() && connector.pins.iter().all(|pin| pin.colour.is_none()) {
            absent(Absent::Colours, connector.table.id);
        }
        if connector.outer_diameter.is_none() {
            absent(Absent::MatingSize, connector.kind.place.table);
        }
    }
    for (what, goal) in [
        (Absent::SinamicsCable, CableFor::SinamicsSmc),
        (Absent::OpenCable, CableFor::OpenEnd),
        (Absent::YukonCable, CableFor::YukonDrive),
        (Absent::SimodriveCable, CableFor::Simodrive),
    ] {
        // The encoder at the output has cables of its own; here motor and feedback are concerned.
        if !cables.iter().any(|cable| cable.goal == goal && cable.role != CableRole::OutputEncoder) {
            absent(what, feedback_table);
        }
    }
    for what in [Absent::Arrangement, Absent::Gender, Absent::CrossSection] {
        absent(what, feedback_table);
    }
    if code.option_2.is_some() {
        absent(Absent::ExitOption, "11.6");
    }
    found
}

#[cfg(test)]
#[path = "wiring_tests.rs"]
mod tests;
