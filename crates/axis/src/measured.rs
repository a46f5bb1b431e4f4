//! Record of a commissioning: measured values with their units, read with the same faults as a project file.

use crate::choices;
use crate::fault::AxisDiagnostic;
use installation::commission::expected::Measurand;
use installation::commission::recorded::{MeasuredValues, NoLoad};
use project::names::{BrakeName, EmfName, NoLoadName, SensorName, WindingName};
use project::sections::{MeasuredRoot, NoLoadPoint, OneOrMany};
use project::{Diagnostic, MeasuredKey};

/// Reads a record of measured values.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file.
pub fn measured(text: &str) -> Result<MeasuredValues, Vec<AxisDiagnostic>> {
    let read = project::read_measured(text);
    read.map(|root| build(&root)).map_err(|faults| faults.into_iter().map(Diagnostic::into_other).collect())
}

/// Returns the measured quantity; `None` for a condition of the measurement.
#[must_use]
pub const fn measurand(key: MeasuredKey) -> Option<Measurand> {
    Some(match key {
        MeasuredKey::Winding(WindingName::resistance_ll) => Measurand::ResistanceLl,
        MeasuredKey::Winding(WindingName::inductance_ll) => Measurand::InductanceLl,
        MeasuredKey::Emf(EmfName::voltage_ll) => Measurand::Emf,
        MeasuredKey::Sensor(SensorName::kty) => Measurand::Kty,
        MeasuredKey::Sensor(SensorName::ptc) => Measurand::Ptc,
        MeasuredKey::Brake(BrakeName::voltage) => Measurand::BrakeVoltage,
        MeasuredKey::Brake(BrakeName::opening_current) => Measurand::BrakeOpeningCurrent,
        MeasuredKey::Brake(BrakeName::holding_current) => Measurand::BrakeHoldingCurrent,
        MeasuredKey::Brake(BrakeName::opening_time) => Measurand::BrakeOpeningTime,
        MeasuredKey::Brake(BrakeName::closing_time) => Measurand::BrakeClosingTime,
        MeasuredKey::NoLoad(NoLoadName::current) => Measurand::NoLoadCurrent,
        MeasuredKey::Winding(WindingName::temperature)
        | MeasuredKey::Emf(EmfName::speed_motor)
        | MeasuredKey::Sensor(SensorName::temperature)
        | MeasuredKey::NoLoad(NoLoadName::speed_out | NoLoadName::temperature)
        | MeasuredKey::Root(_)
        | MeasuredKey::Direction(_)
        | MeasuredKey::Speed(_) => return None,
    })
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
        found.direction_motor = direction.motor.value().map(choices::turn);
        found.direction_flange = direction.flange.value().map(choices::turn);
        found.position = direction.position.value().map(choices::counting);
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

#[cfg(test)]
mod tests {
    use super::*;
    use project::measured_lines;

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
