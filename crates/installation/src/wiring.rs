//! Connectors, pins and cables of an ordering code, as sections 6.24 and 6.25 print them.

mod cables;
mod comparison;
mod drop;
mod pin_list;
mod signal;

pub use cables::{Cable, CableFor, CableLength, CableRole};
pub use comparison::{Comparison, Difference, Finding, Severity, compare};
pub use drop::{Circuit, DropVerdict, VoltageDrop, voltage_drops};
pub use pin_list::{Column, LISTED_BYTES_MAX, ListFault, ListedPin, PinList, read_pin_list};
pub use signal::{Form, Group, Meaning, Polarity, Protocol, Signal};

use catalogue::{Cell, SeriesData, Table};
use order_code::{Brake, OrderCode};
use quantities::identified;

/// The wiring of one ordering code.
#[derive(Clone, Debug)]
pub struct Wiring {
    /// The code.
    pub code: OrderCode,
    /// Its connectors: motor, motor feedback, and the encoder at the output where it has one.
    pub connectors: Vec<Connector>,
    /// The cables that the manual lists for it.
    pub cables: Vec<Cable>,
    /// What there is not for this code, or not in the manual.
    pub absences: Vec<Absence>,
}

impl Wiring {
    /// The connector of a role.
    #[must_use]
    pub fn connector(&self, role: Role) -> Option<&Connector> {
        self.connectors.iter().find(|connector| connector.role == role)
    }
}

identified! {
    /// What a connector is for.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Role {
        /// Motor phases, protective earth, brake.
        Motor = "motor",
        /// Motor feedback.
        Feedback = "feedback",
        /// Encoder at the gear output, option EC.
        OutputEncoder = "output_encoder",
    }
}

/// One connector of the actuator and what mates with it.
#[derive(Clone, Debug)]
pub struct Connector {
    /// What it is for.
    pub role: Role,
    /// Poles and thread as printed: `17 / M23 x 1`.
    pub kind: &'static Cell,
    /// Poles, as printed.
    pub poles: u8,
    /// Coupling thread: `M23 x 1`.
    pub thread: &'static str,
    /// Material number of the mating coupling; `None` where none is printed.
    pub mating: Option<&'static Cell>,
    /// Outer diameter of the mating coupling.
    pub outer_diameter: Option<&'static Cell>,
    /// Length of the mating coupling.
    pub length: Option<&'static Cell>,
    /// Whether it hangs on a cable or sits in the housing; `None` where table 11.3 does not say.
    pub exit: Option<Exit>,
    /// The table of the pins.
    pub table: &'static Table,
    /// Its pins in order; empty where the table holds for other sizes only.
    pub pins: Vec<Pin>,
    /// Colours that several of its wires have.
    pub ambiguous: Vec<Ambiguous>,
}

impl Connector {
    /// The pin with this name.
    #[must_use]
    pub fn pin(&self, name: &str) -> Option<&Pin> {
        self.pins.iter().find(|pin| pin.name == name)
    }
}

/// Where a connector is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// At the end of a cable.
    Cable,
    /// In the housing.
    Housing,
}

/// One pin.
#[derive(Clone, Debug)]
pub struct Pin {
    /// Its number, or `PE`.
    pub name: String,
    /// The pin that the table names in brackets: both belong to one wire.
    pub joined: Option<String>,
    /// What is printed for it; `None`: the field is empty.
    pub signal: Option<&'static Cell>,
    /// What it carries; `None`: nothing.
    pub carries: Option<Signal>,
    /// Colour of its wire; `None` where none is printed.
    pub colour: Option<&'static Cell>,
}

impl Pin {
    /// The signal as printed; a dash where nothing is connected.
    #[must_use]
    pub fn printed(&self) -> &'static str {
        self.signal.map_or("-", |cell| cell.corrected)
    }

    /// Whether it carries a signal of this group.
    pub(crate) fn carries(&self, group: Group) -> bool {
        self.carries.is_some_and(|signal| signal.group() == group)
    }
}

/// A colour that does not tell wires apart.
#[derive(Clone, Debug)]
pub struct Ambiguous {
    /// The colour.
    pub colour: &'static Cell,
    /// The pins whose wires have it.
    pub pins: Vec<String>,
}

/// What there is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absence {
    /// What is absent.
    pub what: Absent,
    /// The table that shows it.
    pub table: &'static str,
}

identified! {
    /// What a code, or the manual, does not have.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Absent {
        /// The code has no brake: its pins are free.
        Brake = "brake",
        /// The pin-out of the motor connector is printed for other sizes only.
        MotorPins = "motor_pins",
        /// No PTC thermistor is led out.
        Ptc = "ptc",
        /// No KTY sensor is led out.
        Kty = "kty",
        /// No sense lines.
        Sense = "sense_lines",
        /// No pin for a shield.
        ShieldPin = "shield_pin",
        /// No wire colours are printed.
        Colours = "wire_colours",
        /// The size of the mating coupling is not printed.
        MatingSize = "mating_size",
        /// No cable for SINAMICS.
        SinamicsCable = "cable_sinamics",
        /// No cable set with open end.
        OpenCable = "cable_open_end",
        /// No cable set for `YukonDrive`.
        YukonCable = "cable_yukondrive",
        /// No cable for SIMODRIVE.
        SimodriveCable = "cable_simodrive",
        /// Where the contacts sit in the insert: the figures of the manual are not in the text it was recovered from.
        Arrangement = "contact_arrangement",
        /// Which half of the pair is pin and which is socket.
        Gender = "contact_gender",
        /// Cross-sections of the wires.
        CrossSection = "cross_section",
        /// What the option on the exit of cable and connectors changes on the connectors.
        ExitOption = "exit_option",
    }
}

/// The wiring of a code; `None` where section 6.24 has none for its winding and feedback.
///
/// # Source
/// cha-manual tables 63.1 to 68.4, with their errata; exits from table 11.3
/// # Valid
/// For the standard actuator. A special design may be wired otherwise.
#[must_use]
pub fn wiring(code: &OrderCode) -> Option<Wiring> {
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
    Some(Wiring { code: *code, connectors, cables, absences })
}

/// Whether a cell holds for the size and feedback of a code.
pub(crate) fn holds(cell: &Cell, role: Role, code: &OrderCode) -> bool {
    let size = format!("{}-{}", code.series().as_str(), code.size);
    let feedback = if role == Role::OutputEncoder { "EC" } else { code.feedback.as_str() };
    let among = |entry: &str, name: &str| entry.is_empty() || entry.split(" / ").any(|each| each == name);
    among(cell.place.drive, &size) && among(cell.feedback, feedback)
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

/// The pins of a connector: those that the table heads, and of the poles those whose fields are empty.
fn pins_of(role: Role, table: &'static Table, poles: u8, code: &OrderCode) -> Vec<Pin> {
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
                pin.carries = Signal::of_print(cell.corrected, role, code.feedback);
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
    // Numbers in order, PE behind them.
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
    let carried = |group: Group| connectors.iter().flat_map(|connector| &connector.pins).any(|pin| pin.carries(group));
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
    } else if !carried(Group::Ptc) {
        absent(Absent::Ptc, motor_table);
    }
    if !carried(Group::Kty) {
        absent(Absent::Kty, feedback_table);
    }
    for (what, group) in [(Absent::Sense, Group::Sense), (Absent::ShieldPin, Group::Shield)] {
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
        // Of the encoder at the output there is a cable for each of its own; here it is about motor and feedback.
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
