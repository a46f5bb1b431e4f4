//! The cycle on the chosen actuator by segments, the motor shaft, the duty type, and the data of the manual.

use super::ends::Ends;
use super::shown::{Formatter, tied};
use answers::{Dossier, Number, SegmentLoad};
use quantities::{grouped, with_symbol};
use serde::Serialize;
use words::{capitalised, marked, typeset};

/// The cycle on the actuator.
#[derive(Serialize)]
pub(super) struct CycleData {
    segments: Ends<LoadRow>,
    cycle: LoadRow,
    facts: Vec<OperationFact>,
    duty: String,
    duty_reason: String,
}

/// A segment, or the whole cycle.
#[derive(Serialize)]
struct LoadRow {
    /// Number of the segment from 1; `None` for the whole cycle.
    number: Option<usize>,
    /// Duration, T_peak, T_rms, n_peak, I_peak cold and settled, I_rms, P_peak, energy taken, energy returned; empty where not
    /// known.
    values: [String; 10],
}

/// A quantity of the motor or of the inertias.
#[derive(Serialize)]
struct OperationFact {
    /// Word of the template.
    key: &'static str,
    symbol: &'static str,
    value: String,
}

/// A value of the manual.
#[derive(Serialize)]
pub(super) struct DataRow {
    symbol: &'static str,
    name: String,
    /// With its unit and, where an erratum touches it, the mark.
    value: String,
    table: &'static str,
}

/// The values of the manual, with their errata.
#[derive(Serialize)]
pub(super) struct DataSheet {
    rows: Vec<DataRow>,
    has_doubts: bool,
}

/// Returns the values of a row of the loads, in the order of [`LoadRow::values`].
const fn values(load: &SegmentLoad) -> [Option<Number>; 10] {
    [
        Some(load.duration),
        Some(load.torque_peak),
        Some(load.torque_rms),
        Some(load.speed_peak),
        load.current_peak_cold,
        load.current_peak,
        load.current_rms,
        load.power_peak,
        load.energy_taken,
        load.energy_returned,
    ]
}

/// Returns the rows of the segments, and that of the whole cycle.
fn rows(segments: &[SegmentLoad], cycle: &SegmentLoad, shown: &Formatter) -> (Vec<LoadRow>, LoadRow) {
    let all: Vec<[Option<Number>; 10]> = segments.iter().chain([cycle]).map(values).collect();
    let columns: Vec<Vec<String>> = (0..10)
        .map(|column| shown.column(&all.iter().map(|row| row.get(column).copied().flatten()).collect::<Vec<_>>()))
        .collect();
    let row = |place: usize| LoadRow {
        number: (place < segments.len()).then_some(place + 1),
        values: std::array::from_fn(|column| {
            columns.get(column).and_then(|cells| cells.get(place)).cloned().unwrap_or_default()
        }),
    };
    ((0..segments.len()).map(row).collect(), row(segments.len()))
}

pub(super) fn operation(dossier: &Dossier, shown: &Formatter) -> Option<CycleData> {
    let found = dossier.operation.as_ref()?;
    let (segments, cycle) = rows(&found.segments, &found.cycle, shown);
    let mut facts = Vec::new();
    let mut add = |key, symbol, value: Option<String>| {
        facts.extend(value.map(|value| OperationFact { key, symbol, value }));
    };
    add("current_rms", "I_rms", found.cycle.current_rms.map(|value| shown.figure(value, "A")));
    add("current_peak_cold", "I_peak", found.cycle.current_peak_cold.map(|value| shown.figure(value, "A")));
    add("current_peak", "I_peak", found.cycle.current_peak.map(|value| shown.figure(value, "A")));
    if let Some(motor) = &found.motor {
        let torque = |value: Option<Number>| Some(marked(shown.figure(value?, "Nm"), motor.torque_errata));
        add("motor_speed_peak", "n_mot", Some(shown.figure(motor.speed_peak, "1/min")));
        add("motor_speed_mean", "n_mot_av", Some(shown.figure(motor.speed_mean, "1/min")));
        add("motor_torque_peak_cold", "T_mot", torque(motor.torque_peak_cold));
        add("motor_torque_peak", "T_mot", torque(motor.torque_peak));
        add("motor_torque_rms", "T_mot_rms", torque(motor.torque_rms));
    }
    let ratio = (found.inertia_own.0 > 0.0).then(|| shown.number(Number(found.inertia_load.0 / found.inertia_own.0)));
    add("inertia_ratio", "J_L/J_out", ratio);
    Some(CycleData {
        segments: Ends::of(segments.into_iter(), None),
        cycle,
        facts,
        duty: format!("{}, {}", found.duty.id, found.duty.name),
        duty_reason: capitalised(found.duty.reason),
    })
}

pub(super) fn data_sheet(dossier: &Dossier) -> DataSheet {
    let row = |line: &answers::DataLine| DataRow {
        symbol: line.symbol,
        name: tied(&typeset(&capitalised(&line.name))),
        value: tied(&marked(with_unit(&each_grouped(&typeset(&line.value)), line.unit.as_str()), line.errata)),
        table: line.table,
    };
    let lines = &dossier.data_sheet;
    DataSheet { rows: lines.iter().map(row).collect(), has_doubts: lines.iter().any(|line| !line.errata.is_empty()) }
}

/// Returns a value with each of its numbers in groups of digits: `42 000 (checks: 29 600)`.
fn each_grouped(value: &str) -> String {
    let is_of_number = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | ',');
    let mut out = String::with_capacity(value.len());
    let mut rest = value;
    while let Some(at) = rest.find(|sign: char| sign.is_ascii_digit()) {
        let (before, number) = rest.split_at(at);
        let end = number.find(|sign: char| !is_of_number(sign)).unwrap_or(number.len());
        let (number, behind) = number.split_at(end);
        out.push_str(before);
        // Digits behind a letter or a hyphen belong to a name: `KTY 84-130`, `M23`.
        let is_name = before.ends_with(|sign: char| sign.is_alphabetic() || matches!(sign, '-' | '_'));
        out.push_str(&if is_name { number.to_owned() } else { grouped(number) });
        rest = behind;
    }
    out + rest
}

/// A printed value with its unit: `16·10³ Nm/rad`, `24 V ±10 %`.
fn with_unit(value: &str, unit: &str) -> String {
    match (value.split_once(" ±"), unit) {
        (_, "") => value.to_owned(),
        // The unit is that of the number, not of its tolerance in per cent.
        (Some((number, tolerance)), unit) if tolerance.ends_with('%') => format!("{number} {unit} ±{tolerance}"),
        (_, unit) if unit.starts_with("10") => format!("{value}·{unit}"),
        (_, unit) => with_symbol(value, unit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_stands_with_its_number() {
        assert_eq!(with_unit("16", "10³ Nm/rad"), "16·10³ Nm/rad");
        assert_eq!(with_unit("24 ±10 %", "V"), "24 V ±10 %");
        assert_eq!(with_unit("±0,1", "arcmin"), "±0,1 arcmin");
        assert_eq!(with_unit("IP65", ""), "IP65");
    }
}
