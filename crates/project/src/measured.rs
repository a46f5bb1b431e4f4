//! Record of a commissioning: measured values with their units, read with the same faults as a project file.

use crate::about::About;
use crate::choices::{Counting, Turn};
use crate::key::{Key, Kind, example};
use crate::read::Reader;
use crate::section::{Section, section};
use crate::value::OneOrMany;
use crate::{Diagnostic, Fault};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Frequency, Inductance,
    ThermodynamicTemperature, Time,
};

/// Format version of the record.
pub const MEASURED_FORMAT: i64 = 1;

section! {
    /// A whole record.
    MeasuredRoot, MeasuredRootName of About::Measured, MeasuredKey::Root {
        format: u32 => whole(MEASURED_FORMAT, MEASURED_FORMAT), needed;
        winding: Winding;
        emf: Emf;
        sensor: Sensor;
        brake: Brake;
        direction: Direction;
        speed: Speed;
        no_load: OneOrMany<NoLoadPoint, NoLoadPoint>;
    }
}

section! {
    /// The winding.
    Winding, WindingName of About::Measured, MeasuredKey::Winding {
        temperature: ThermodynamicTemperature => needed;
        resistance_ll: ElectricalResistance => not_negative;
        inductance_ll: Inductance => not_negative;
    }
}

section! {
    /// The back-EMF.
    Emf, EmfName of About::Measured, MeasuredKey::Emf {
        voltage_ll: ElectricPotential => not_negative, needed;
        speed_motor: AngularVelocity => positive, needed;
    }
}

section! {
    /// The temperature sensors.
    Sensor, SensorName of About::Measured, MeasuredKey::Sensor {
        temperature: ThermodynamicTemperature => needed;
        kty: ElectricalResistance => not_negative;
        ptc: ElectricalResistance => not_negative;
    }
}

section! {
    /// The brake.
    Brake, BrakeName of About::Measured, MeasuredKey::Brake {
        voltage: ElectricPotential => not_negative;
        opening_current: ElectricCurrent => not_negative;
        holding_current: ElectricCurrent => not_negative;
        opening_time: Time => not_negative;
        closing_time: Time => not_negative;
    }
}

section! {
    /// The direction of rotation, seen from the front.
    Direction, DirectionName of About::Measured, MeasuredKey::Direction {
        motor: Turn => needed;
        flange: Turn;
        position: Counting;
    }
}

section! {
    /// Speeds at the same time.
    Speed, SpeedName of About::Measured, MeasuredKey::Speed {
        motor: AngularVelocity => positive, needed;
        flange: AngularVelocity => positive;
        electrical_frequency: Frequency => positive;
    }
}

section! {
    /// The no-load current at one speed.
    NoLoadPoint, NoLoadName of About::Measured, MeasuredKey::NoLoad {
        speed_out: AngularVelocity => not_negative, needed;
        current: ElectricCurrent => not_negative, needed;
        temperature: ThermodynamicTemperature => needed;
    }
}

/// Keys of the root of the record; its tables contain the others.
pub const MEASURED_KEYS: &[Key] = MeasuredRoot::KEYS;

/// A key of a record of measured values, by its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredKey {
    /// Key of the root.
    Root(MeasuredRootName),
    /// Key of `[winding]`.
    Winding(WindingName),
    /// Key of `[emf]`.
    Emf(EmfName),
    /// Key of `[sensor]`.
    Sensor(SensorName),
    /// Key of `[brake]`.
    Brake(BrakeName),
    /// Key of `[direction]`.
    Direction(DirectionName),
    /// Key of `[speed]`.
    Speed(SpeedName),
    /// Key of `[[no_load]]`.
    NoLoad(NoLoadName),
}

/// Reads a record of measured values.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file.
pub fn read_measured(text: &str) -> Result<MeasuredRoot, Vec<Diagnostic>> {
    let mut reader = Reader::of_file(text)?;
    let root: MeasuredRoot = reader.read();
    let stated: Vec<_> = reader.tolerances.iter().map(|tolerance| tolerance.span.clone()).collect();
    for span in stated {
        // A measured value is a single value.
        reader.fault(span, Fault::NoTolerance, None);
    }
    let faults = reader.report.into_faults();
    if faults.is_empty() { Ok(root) } else { Err(faults) }
}

/// A line of an empty record: the heading of a table, or a key with an example of its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasuredLine {
    /// `[winding]`, `resistance_ll = "5.9 ohm"`.
    pub text: String,
    /// Purpose.
    pub key: MeasuredKey,
    /// The line is the heading of a table.
    pub is_table: bool,
    /// The key is required if its table is present.
    pub required: bool,
}

/// Returns every line that a record may have, table by table.
#[must_use]
pub fn measured_lines() -> Vec<MeasuredLine> {
    let mut lines = Vec::new();
    for each in MEASURED_KEYS {
        let keys = each.kind.keys(true);
        let head = match each.kind {
            Kind::Table(_) => format!("[{}]", each.name),
            Kind::OneOrMany(..) => format!("[[{}]]", each.name),
            _ => example(each).unwrap_or_default(),
        };
        lines.extend(line(each, head, !keys.is_empty()));
        lines.extend(keys.iter().filter_map(|key| line(key, example(key)?, false)));
    }
    lines
}

fn line(key: &Key, text: String, is_table: bool) -> Option<MeasuredLine> {
    let About::Measured(purpose) = key.about else { return None };
    Some(MeasuredLine { text, key: purpose, is_table, required: key.required })
}
