//! Curves and battery as JSON.

use super::{in_unit, number};
use crate::limits::{NeededLimit, limits_needed};
use crate::sizing_use::Candidate;
use actuator::{BatteryLife, CurveKind, CurvePoint, PerformanceCurve};
use order_code::OrderCode;
use quantities::unit::{DEGREE_CELSIUS, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND, VOLT, YEAR};
use quantities::{Language, Measure};
use serde_json::{Value, json};
use sizing::Reserve;
use words::{curve_title, source_text};

fn points(points: &[CurvePoint]) -> Vec<[Value; 2]> {
    points
        .iter()
        .map(|point| [in_unit(point.speed.si(), &REVOLUTION_PER_MINUTE), in_unit(point.torque.si(), &NEWTON_METRE)])
        .collect()
}

/// The curves of the torque-speed plane.
#[must_use]
pub fn curves(code: &OrderCode, curves: &[PerformanceCurve], language: Language) -> Value {
    let curves: Vec<Value> = curves
        .iter()
        .map(|curve| {
            let (kind, duty) = match curve.kind {
                CurveKind::Continuous => ("continuous", Value::Null),
                CurveKind::S3 { duty } => ("S3", number(duty.si() * 100.0)),
                CurveKind::ShortTime => ("short_time", Value::Null),
            };
            json!({
                "kind": kind,
                "ED": duty,
                "title": curve_title(&curve.kind, language),
                "voltage": curve.voltage.map(|voltage| in_unit(voltage.si(), &VOLT)),
                "points": points(&curve.points),
                "upper": curve.upper.as_deref().map(points),
                "grade": curve.grade.id(),
                "source": source_text(&curve.source, language),
            })
        })
        .collect();
    json!({ "code": code.to_string(), "units": { "n": "1/min", "T": "Nm", "U": "V", "ED": "%" }, "curves": curves })
}

/// How far the axis may be changed, or the limits of its project; `null` where nothing within reach fits or everything
/// does.
#[must_use]
pub fn reserve(reserve: &Reserve, candidate: &Candidate<'_>) -> Value {
    let limits = limits_needed(candidate).map(|limits| {
        let limit = |needed: &NeededLimit| {
            let unit = needed.enough.unit;
            json!({ "key": needed.key, "value": in_unit(needed.enough.si, unit), "unit": unit.json })
        };
        limits.iter().map(limit).collect::<Vec<_>>()
    });
    json!({
        "limits": limits,
        "load_factor": reserve.load_factor.map(number),
        "payload_factor": reserve.payload_factor.map(number),
        "cycle_time": reserve.cycle_time.map(|time| in_unit(time.si(), &SECOND)),
        "ambient": reserve.ambient.map(|ambient| in_unit(ambient.si(), &DEGREE_CELSIUS)),
        "units": { "cycle_time": "s", "ambient": "degC" },
    })
}

/// Life of the battery.
#[must_use]
pub fn battery(battery: &BatteryLife) -> Value {
    json!({
        "life": in_unit(battery.life.value.si(), &YEAR),
        "exchange_recommended": in_unit(battery.exchange_recommended.si(), &YEAR),
        "exchange_latest": in_unit(battery.exchange_latest.si(), &YEAR),
        "capped": battery.capped,
        "unit": YEAR.json,
        "grade": battery.life.grade.id(),
        "source": battery.life.source.to_string(),
    })
}
