//! The motion as JSON.

use super::{in_unit, number};
use crate::moves::{Move, Moves};
use project::RecordingRead;
use quantities::unit::SECOND;
use quantities::{Language, Measure};
use recording::{KnownBy, Role};
use serde_json::{Map, Value, json};
use words::law_text;

/// Every segment with what was given and what followed from it.
#[must_use]
pub fn moves(moves: &Moves<'_>, language: Language) -> Value {
    let [distance, speed, acceleration] = moves.units;
    json!({
        "units": { "time": "s", "distance": distance.json, "speed": speed.json, "acceleration": acceleration.json },
        "segments": moves.moves.iter().map(|each| segment(each, moves, language)).collect::<Vec<_>>(),
    })
}

fn segment(each: &Move<'_>, moves: &Moves<'_>, language: Language) -> Value {
    let mut map = Map::new();
    map.insert("law".into(), json!(each.law.id()));
    map.insert("name".into(), json!(law_text(each.law, language)));
    map.insert("start".into(), in_unit(each.start.si(), &SECOND));
    map.insert("duration".into(), in_unit(each.duration.si(), &SECOND));
    if let Some(course) = each.course {
        for ((name, si), unit) in ["distance", "speed", "acceleration"].into_iter().zip(course).zip(moves.units) {
            map.insert(name.into(), in_unit(si, unit));
        }
    }
    if let Some(read) = each.recording {
        map.insert("recording".into(), recording(read));
    }
    Value::Object(map)
}

fn recording(read: &RecordingRead) -> Value {
    let recording = &read.recording;
    let columns: Vec<Value> = recording
        .columns
        .iter()
        .map(|column| {
            let role = match column.role {
                Role::Time => "time",
                Role::Position => "position",
                Role::Speed => "speed",
                Role::Torque => "torque",
            };
            let by = match column.known_by {
                KnownBy::Header => "header",
                KnownBy::UnitRow => "unit_row",
                KnownBy::Metadata => "metadata",
                KnownBy::Layout => "project",
            };
            json!({ "role": role, "name": column.name, "unit": column.unit.json, "unit_by": by })
        })
        .collect();
    json!({
        "file": read.file,
        "samples": recording.time_s.len(),
        "first_time": number(SECOND.from_si(recording.first_time.si())),
        "left_out_before": recording.left_out_before,
        "left_out_after": recording.left_out_after,
        "columns": columns,
    })
}
