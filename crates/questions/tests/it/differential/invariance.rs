//! Changes of a project that change none of its results.

use super::cases::Case;
use std::collections::BTreeMap;
use toml::{Table, Value};

/// Another unit for each one in use, with what a number must be multiplied by.
const OTHER: &[(&str, &str, f64)] = &[
    ("kg m^2", "kg cm^2", 1e4),
    ("N m", "N cm", 1e2),
    ("1/min", "rad/s", std::f64::consts::TAU / 60.0),
    ("rad/s^2", "deg/s^2", 360.0 / std::f64::consts::TAU),
    ("rad/s^3", "deg/s^3", 360.0 / std::f64::consts::TAU),
    ("N m s/rad", "N m/(1/min)", std::f64::consts::TAU / 60.0),
    ("m/s", "mm/s", 1e3),
    ("m/s^2", "g", 1.0 / 9.80665),
    ("m/min", "m/s", 1.0 / 60.0),
    ("s", "ms", 1e3),
    ("min", "s", 60.0),
    ("m", "mm", 1e3),
    ("rad", "deg", 360.0 / std::f64::consts::TAU),
    ("rad/s", "1/min", 60.0 / std::f64::consts::TAU),
    ("mm", "m", 1e-3),
    ("kg", "g", 1e3),
    ("N", "kN", 1e-3),
    ("deg", "rad", std::f64::consts::TAU / 360.0),
    ("V", "kV", 1e-3),
];

fn read(text: &str) -> Table {
    text.parse().unwrap()
}

/// A quantity with its number changed.
fn map_number(text: &str, change: impl Fn(f64) -> f64) -> String {
    let (number, unit) = text.split_once(' ').unwrap();
    format!("{:?} {unit}", change(number.parse().unwrap()))
}

fn change(table: &mut Table, key: &str, how: impl Fn(f64) -> f64) {
    if let Some(value) = table.get_mut(key) {
        *value = Value::String(map_number(value.as_str().unwrap(), how));
    }
}

fn negate(table: &mut Table, keys: &[&str]) {
    for key in keys {
        change(table, key, |x| -x);
    }
}

/// Every quantity in another unit.
pub(crate) fn other_units(project: &str) -> String {
    fn walk(value: &mut Value) {
        match value {
            Value::String(text) => {
                let Some((number, unit)) = text.split_once(' ') else { return };
                let (Ok(number), Some((_, other, factor))) =
                    (number.parse::<f64>(), OTHER.iter().find(|(known, ..)| *known == unit))
                else {
                    return;
                };
                *text = format!("{:?} {other}", number * factor);
            }
            Value::Array(items) => items.iter_mut().for_each(walk),
            Value::Table(table) => table.iter_mut().for_each(|(_, value)| walk(value)),
            _ => {}
        }
    }
    let mut table = Value::Table(read(project));
    walk(&mut table);
    toml::to_string(&table).unwrap()
}

fn segments(table: &mut Table) -> &mut Vec<Value> {
    table["motion"].as_array_mut().unwrap()
}

/// The one mechanism and its name; none with a plain load.
fn mechanism(table: &mut Table) -> Option<(String, &mut Table)> {
    let (name, keys) = table.get_mut("mechanism")?.as_table_mut().unwrap().iter_mut().next().unwrap();
    Some((name.clone(), keys.as_table_mut().unwrap()))
}

/// The cycle begun with another segment, the axis standing where it stands then.
pub(crate) fn rotated(case: &Case, first: usize) -> String {
    let project = case.read();
    let moves = questions::moves(&project);
    let travelled: f64 =
        moves.moves.iter().take(first).filter_map(|one| one.course).map(|[distance, ..]| distance).sum();
    let mut table = read(&case.project);
    segments(&mut table).rotate_left(first);
    if let Some((_, keys)) = mechanism(&mut table).filter(|_| moves.turns) {
        change(keys, "start_angle", |angle| angle + travelled.to_degrees());
    }
    toml::to_string(&table).unwrap()
}

/// The motion twice in one cycle.
pub(crate) fn repeated(project: &str) -> String {
    let mut table = read(project);
    let segments = segments(&mut table);
    segments.extend_from_within(..);
    toml::to_string(&table).unwrap()
}

/// Every direction turned round: motion, torques, forces along the line, gravity.
pub(crate) fn mirrored(case: &Case) -> (String, BTreeMap<String, String>) {
    let mut table = read(&case.project);
    // Where the mirrored axis stands when the axis stands at zero, in degrees.
    let mut mirror = 0.0;
    let mut along_line = true;
    if let Some((name, keys)) = mechanism(&mut table) {
        negate(keys, &["external_torque"]);
        match name.as_str() {
            "arm" | "turntable" => {
                change(keys, "start_angle", |angle| 180.0 - angle);
                mirror = 180.0;
                if let Some(Value::Array(bodies)) = keys.get_mut("bodies") {
                    for body in bodies {
                        *body = Value::String(mirrored_body(body.as_str().unwrap()));
                    }
                }
            }
            // The slider stays where it is.
            "slider_crank" => {
                negate(keys, &["start_angle"]);
                along_line = false;
            }
            "table" => {
                negate(keys, &["start_angle"]);
                mirror_points(keys);
            }
            _ => negate(keys, &["inclination", "process_force"]),
        }
    } else {
        negate(table["load"].as_table_mut().unwrap(), &["external_torque"]);
    }
    for segment in segments(&mut table) {
        let segment = segment.as_table_mut().unwrap();
        negate(segment, &["distance", "end_speed", "process_torque"]);
        if !segment.contains_key("distance") {
            negate(segment, &["speed"]);
        }
        if along_line {
            negate(segment, &["process_force"]);
        }
    }
    let files = case.files.iter().map(|(name, text)| (name.clone(), mirrored_recording(text, mirror)));
    (toml::to_string(&table).unwrap(), files.collect())
}

fn mirrored_body(body: &str) -> String {
    let turned = |part: &str| match part.strip_prefix("angle=") {
        None => part.to_owned(),
        Some(angle) => format!("angle={}", angle.strip_prefix('-').map_or_else(|| format!("-{angle}"), str::to_owned)),
    };
    body.split(' ').map(turned).collect::<Vec<_>>().join(" ")
}

fn mirror_points(keys: &mut Table) {
    let points = keys["points"].as_array_mut().unwrap();
    points.reverse();
    for row in points {
        let row = row.as_array_mut().unwrap();
        for index in [0, 2] {
            row[index] = Value::String(map_number(row[index].as_str().unwrap(), |x| -x));
        }
    }
}

/// Positions from `mirror` backwards, speeds and torques with the other sign.
fn mirrored_recording(text: &str, mirror: f64) -> String {
    let mut lines = text.lines();
    let head = lines.next().unwrap();
    let roles: Vec<&str> = head.split(',').collect();
    let mut result = format!("{head}\n");
    for line in lines {
        let cells = line.split(',').zip(&roles).map(|(cell, role)| {
            let value: f64 = cell.parse().unwrap();
            match *role {
                role if role.starts_with("time") => cell.to_owned(),
                role if role.starts_with("position") => format!("{:?}", mirror - value),
                _ => format!("{:?}", -value),
            }
        });
        result.push_str(&cells.collect::<Vec<_>>().join(","));
        result.push('\n');
    }
    result
}
