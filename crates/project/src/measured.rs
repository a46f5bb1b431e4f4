//! The record of a commissioning: measured values with their units, read with the same faults as a project file.

use crate::about::{About, MeasuredKey};
use crate::read::{Reader, example};
use crate::section::Section;
use crate::spec::{Key, Kind, key, needed, quantity};
use crate::{Diagnostic, Fault, PROJECT_MAX_BYTES, Range};
use installation::commission::recorded::{Counting, Measured, NoLoad, Turn};
use quantities::Dimension;

/// The format of the record that this version reads.
pub const MEASURED_FORMAT: i64 = 1;

/// Directions, seen from the front: clockwise and counter-clockwise.
const TURNS: &[&str] = &["cw", "ccw"];

const COUNTINGS: &[&str] = &["rising", "falling"];

const fn about(key: MeasuredKey) -> About {
    About::Measured(key)
}

const fn table(name: &'static str, keys: &'static [Key], purpose: MeasuredKey) -> Key {
    key(name, Kind::Table(keys), false, about(purpose))
}

/// The root of the record, and under its tables every other key.
#[rustfmt::skip] // one line per key
pub const MEASURED_KEYS: &[Key] = &[
    key("format", Kind::Integer(MEASURED_FORMAT, MEASURED_FORMAT), true, about(MeasuredKey::Format)),
    table("winding", WINDING, MeasuredKey::Winding),
    table("emf", EMF, MeasuredKey::Emf),
    table("sensor", SENSOR, MeasuredKey::Sensor),
    table("brake", BRAKE, MeasuredKey::Brake),
    table("direction", DIRECTION, MeasuredKey::Direction),
    table("speed", SPEED, MeasuredKey::Speed),
    key("no_load", Kind::OneOrMany(NO_LOAD, NO_LOAD), false, about(MeasuredKey::NoLoad)),
];

#[rustfmt::skip] // one line per key
const WINDING: &[Key] = &[
    needed("temperature", Dimension::Temperature, Range::Any, about(MeasuredKey::WindingTemperature)),
    quantity("resistance_ll", Dimension::Resistance, Range::NotNegative, about(MeasuredKey::ResistanceLl)),
    quantity("inductance_ll", Dimension::Inductance, Range::NotNegative, about(MeasuredKey::InductanceLl)),
];

#[rustfmt::skip] // one line per key
const EMF: &[Key] = &[
    needed("voltage_ll", Dimension::Voltage, Range::NotNegative, about(MeasuredKey::EmfVoltage)),
    needed("speed_motor", Dimension::AngularVelocity, Range::Positive, about(MeasuredKey::EmfSpeed)),
];

#[rustfmt::skip] // one line per key
const SENSOR: &[Key] = &[
    needed("temperature", Dimension::Temperature, Range::Any, about(MeasuredKey::SensorTemperature)),
    quantity("kty", Dimension::Resistance, Range::NotNegative, about(MeasuredKey::Kty)),
    quantity("ptc", Dimension::Resistance, Range::NotNegative, about(MeasuredKey::Ptc)),
];

#[rustfmt::skip] // one line per key
const BRAKE: &[Key] = &[
    quantity("voltage", Dimension::Voltage, Range::NotNegative, about(MeasuredKey::BrakeVoltage)),
    quantity("opening_current", Dimension::Current, Range::NotNegative, about(MeasuredKey::OpeningCurrent)),
    quantity("holding_current", Dimension::Current, Range::NotNegative, about(MeasuredKey::HoldingCurrent)),
    quantity("opening_time", Dimension::Time, Range::NotNegative, about(MeasuredKey::OpeningTime)),
    quantity("closing_time", Dimension::Time, Range::NotNegative, about(MeasuredKey::ClosingTime)),
];

#[rustfmt::skip] // one line per key
const DIRECTION: &[Key] = &[
    key("motor", Kind::OneOf(TURNS), true, about(MeasuredKey::DirectionMotor)),
    key("flange", Kind::OneOf(TURNS), false, about(MeasuredKey::DirectionFlange)),
    key("position", Kind::OneOf(COUNTINGS), false, about(MeasuredKey::DirectionPosition)),
];

#[rustfmt::skip] // one line per key
const SPEED: &[Key] = &[
    needed("motor", Dimension::AngularVelocity, Range::Positive, about(MeasuredKey::SpeedMotor)),
    quantity("flange", Dimension::AngularVelocity, Range::Positive, about(MeasuredKey::SpeedFlange)),
    quantity("electrical_frequency", Dimension::Frequency, Range::Positive, about(MeasuredKey::SpeedFrequency)),
];

#[rustfmt::skip] // one line per key
const NO_LOAD: &[Key] = &[
    needed("speed_out", Dimension::AngularVelocity, Range::NotNegative, about(MeasuredKey::NoLoadSpeed)),
    needed("current", Dimension::Current, Range::NotNegative, about(MeasuredKey::NoLoadCurrent)),
    needed("temperature", Dimension::Temperature, Range::Any, about(MeasuredKey::NoLoadTemperature)),
];

/// Reads a record of measured values.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file.
pub fn measured(text: &str) -> Result<Measured, Vec<Diagnostic>> {
    if text.len() > PROJECT_MAX_BYTES {
        let fault = Fault::FileTooLarge { bytes: text.len(), most: PROJECT_MAX_BYTES };
        return Err(vec![Diagnostic::at(text, 0..0, fault, None)]);
    }
    let mut reader = Reader::new(text);
    let root = reader.read_as(MEASURED_KEYS);
    let stated: Vec<_> = reader.tolerances.iter().map(|tolerance| tolerance.span.clone()).collect();
    for span in stated {
        // What was measured is one value.
        reader.fault(span, Fault::NoTolerance, None);
    }
    let found = build(&root);
    let faults = reader.into_faults();
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

fn build(root: &Section) -> Measured {
    let mut found = Measured::default();
    if let Some(winding) = root.table("winding") {
        found.winding_temperature = winding.quantity("temperature");
        found.resistance_ll = winding.quantity("resistance_ll");
        found.inductance_ll = winding.quantity("inductance_ll");
    }
    if let Some(emf) = root.table("emf") {
        found.emf = emf.quantity("voltage_ll").zip(emf.quantity("speed_motor"));
    }
    if let Some(sensor) = root.table("sensor") {
        found.sensor_temperature = sensor.quantity("temperature");
        found.kty = sensor.quantity("kty");
        found.ptc = sensor.quantity("ptc");
    }
    if let Some(brake) = root.table("brake") {
        found.brake_voltage = brake.quantity("voltage");
        found.brake_opening_current = brake.quantity("opening_current");
        found.brake_holding_current = brake.quantity("holding_current");
        found.brake_opening_time = brake.quantity("opening_time");
        found.brake_closing_time = brake.quantity("closing_time");
    }
    if let Some(direction) = root.table("direction") {
        let turn =
            |name| direction.text(name).map(|word| if word == "cw" { Turn::Clockwise } else { Turn::CounterClockwise });
        found.direction_motor = turn("motor");
        found.direction_flange = turn("flange");
        let counting = |word| if word == "rising" { Counting::Rising } else { Counting::Falling };
        found.position = direction.text("position").map(counting);
    }
    if let Some(speed) = root.table("speed") {
        found.speed_motor = speed.quantity("motor");
        found.speed_flange = speed.quantity("flange");
        found.electrical_frequency = speed.quantity("electrical_frequency");
    }
    let points: Vec<&Section> = match root.table("no_load") {
        Some(single) => vec![single],
        None => root.tables("no_load").iter().collect(),
    };
    let point = |section: &&Section| {
        Some(NoLoad {
            speed_out: section.quantity("speed_out")?,
            current: section.quantity("current")?,
            temperature: section.quantity("temperature")?,
        })
    };
    found.no_load = points.iter().filter_map(point).collect();
    found
}

/// A line of an empty record: the head of a table, or a key with a value as one would write it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasuredLine {
    /// `[winding]`, `resistance_ll = "5.9 ohm"`.
    pub text: String,
    /// What it is for.
    pub key: MeasuredKey,
    /// Whether it is the head of a table.
    pub is_table: bool,
    /// Whether the key must be there if its table is.
    pub required: bool,
}

/// Every line that a record may have, table by table.
#[must_use]
pub fn measured_lines() -> Vec<MeasuredLine> {
    let mut lines = Vec::new();
    for each in MEASURED_KEYS {
        let (head, keys) = match each.kind {
            Kind::Table(keys) => (format!("[{}]", each.name), keys),
            Kind::OneOrMany(_, keys) => (format!("[[{}]]", each.name), keys),
            _ => (example(each).unwrap_or_default(), [].as_slice()),
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

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> Vec<(&'static str, usize, usize)> {
        measured(text).unwrap_err().iter().map(|fault| (fault.fault.id(), fault.line, fault.column)).collect()
    }

    #[test]
    fn a_record_of_every_key_is_read() {
        let text: String = measured_lines().into_iter().map(|line| format!("{}\n", line.text)).collect();
        let found = measured(&text).unwrap();
        let whole = Measured { no_load: found.no_load.clone(), ..found.clone() };
        assert_eq!(found, whole);
        assert!(found.resistance_ll.is_some() && found.brake_closing_time.is_some() && found.position.is_some());
        assert!(found.electrical_frequency.is_some() && found.emf.is_some() && found.ptc.is_some());
        assert_eq!(found.no_load.len(), 1);
    }

    #[test]
    fn every_fault_is_told_at_its_place() {
        let text = "format = 1\n[winding]\nresistance_ll = \"5.9 H\"\n[brake]\nvoltage = 24\nopening_curent = \"0.6 A\"\n\
                    [direction]\nmotor = \"left\"\n";
        let told = faults(text);
        assert_eq!(
            told,
            [
                ("missing_key", 2, 1),
                ("unit_of_another_quantity", 3, 22),
                ("bare_number", 5, 11),
                ("unknown_key", 6, 1),
                ("not_a_choice", 8, 9),
            ]
        );
        assert_eq!(
            faults("format = 1\n[emf]\nvoltage_ll = \"23 V ± 1 V\"\nspeed_motor = \"1000 1/min\"\n"),
            [("no_tolerance", 3, 22)]
        );
        assert_eq!(faults("[winding]\ntemperature = \"20 degC\"\n"), [("missing_key", 1, 1)]);
        assert!(!faults("format = 1\nresistance").is_empty());
    }
}
