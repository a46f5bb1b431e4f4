//! Record of a commissioning: measured values with their units, read with the same faults as a project file.

use crate::about::About;
use crate::key::{Key, Kind, example};
use crate::read::Reader;
use crate::section::{Section, section};
use crate::value::{OneOrMany, choices};
use crate::{Diagnostic, Fault};
use installation::commission::expected::Measurand;
use installation::commission::recorded::{Counting, MeasuredValues, NoLoad, Turn};
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

choices! {
    Turn { Clockwise = "cw", CounterClockwise = "ccw" }
    Counting { Rising = "rising", Falling = "falling" }
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

impl MeasuredKey {
    /// Returns the measured quantity; `None` for a condition of the measurement.
    #[must_use]
    pub const fn measurand(self) -> Option<Measurand> {
        Some(match self {
            Self::Winding(WindingName::resistance_ll) => Measurand::ResistanceLl,
            Self::Winding(WindingName::inductance_ll) => Measurand::InductanceLl,
            Self::Emf(EmfName::voltage_ll) => Measurand::Emf,
            Self::Sensor(SensorName::kty) => Measurand::Kty,
            Self::Sensor(SensorName::ptc) => Measurand::Ptc,
            Self::Brake(BrakeName::voltage) => Measurand::BrakeVoltage,
            Self::Brake(BrakeName::opening_current) => Measurand::BrakeOpeningCurrent,
            Self::Brake(BrakeName::holding_current) => Measurand::BrakeHoldingCurrent,
            Self::Brake(BrakeName::opening_time) => Measurand::BrakeOpeningTime,
            Self::Brake(BrakeName::closing_time) => Measurand::BrakeClosingTime,
            Self::NoLoad(NoLoadName::current) => Measurand::NoLoadCurrent,
            Self::Winding(WindingName::temperature)
            | Self::Emf(EmfName::speed_motor)
            | Self::Sensor(SensorName::temperature)
            | Self::NoLoad(NoLoadName::speed_out | NoLoadName::temperature)
            | Self::Root(_)
            | Self::Direction(_)
            | Self::Speed(_) => return None,
        })
    }
}

/// Reads a record of measured values.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file.
pub fn measured(text: &str) -> Result<MeasuredValues, Vec<Diagnostic>> {
    let mut reader = Reader::of_file(text)?;
    let root: MeasuredRoot = reader.read();
    let stated: Vec<_> = reader.tolerances.iter().map(|tolerance| tolerance.span.clone()).collect();
    for span in stated {
        // A measured value is a single value.
        reader.fault(span, Fault::NoTolerance, None);
    }
    let found = build(&root);
    let faults = reader.into_faults();
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

fn build(root: &MeasuredRoot) -> MeasuredValues {
    let mut found = MeasuredValues::default();
    if let Some(winding) = root.winding.get() {
        found.winding_temperature = winding.temperature.value();
        found.resistance_ll = winding.resistance_ll.value();
        found.inductance_ll = winding.inductance_ll.value();
    }
    if let Some(emf) = root.emf.get() {
        found.emf = emf.voltage_ll.value().zip(emf.speed_motor.value());
    }
    if let Some(sensor) = root.sensor.get() {
        found.sensor_temperature = sensor.temperature.value();
        found.kty = sensor.kty.value();
        found.ptc = sensor.ptc.value();
    }
    if let Some(brake) = root.brake.get() {
        found.brake_voltage = brake.voltage.value();
        found.brake_opening_current = brake.opening_current.value();
        found.brake_holding_current = brake.holding_current.value();
        found.brake_opening_time = brake.opening_time.value();
        found.brake_closing_time = brake.closing_time.value();
    }
    if let Some(direction) = root.direction.get() {
        found.direction_motor = direction.motor.value();
        found.direction_flange = direction.flange.value();
        found.position = direction.position.value();
    }
    if let Some(speed) = root.speed.get() {
        found.speed_motor = speed.motor.value();
        found.speed_flange = speed.flange.value();
        found.electrical_frequency = speed.electrical_frequency.value();
    }
    let points = match root.no_load.get() {
        Some(OneOrMany::One(single)) => std::slice::from_ref(single),
        Some(OneOrMany::Many(several)) => several.as_slice(),
        None => &[],
    };
    let point = |point: &NoLoadPoint| {
        Some(NoLoad {
            speed_out: point.speed_out.value()?,
            current: point.current.value()?,
            temperature: point.temperature.value()?,
        })
    };
    found.no_load = points.iter().filter_map(point).collect();
    found
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
        let whole = MeasuredValues { no_load: found.no_load.clone(), ..found.clone() };
        assert_eq!(found, whole);
        assert!(found.resistance_ll.is_some() && found.brake_closing_time.is_some() && found.position.is_some());
        assert!(found.electrical_frequency.is_some() && found.emf.is_some() && found.ptc.is_some());
        assert_eq!(found.no_load.len(), 1);
    }

    #[test]
    fn every_fault_is_reported_at_its_place() {
        let text = "format = 1\n[winding]\nresistance_ll = \"5.9 H\"\n[brake]\nvoltage = 24\nopening_curent = \"0.6 A\"\n\
                    [direction]\nmotor = \"left\"\n";
        let reported = faults(text);
        assert_eq!(
            reported,
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
