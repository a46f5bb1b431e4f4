//! Comparisons and differences as JSON.

use super::{check, number, objections};
use crate::compare::{CheckChange, Comparison, DatumRow, Difference};
use crate::sizing_use::Candidate;
use project::InputChange;
use quantities::Language;
use serde_json::{Map, Value, json};
use sizing::Check;
use words::check_title;

fn head(candidate: &Candidate<'_>, language: Language) -> Value {
    json!({
        "code": candidate.id.to_string(),
        "verdict": verdict(candidate),
        "utilisation": number(candidate.standing.utilisation),
        "tightest": candidate.judgement.tightest().map(|check| check.id.id()),
        "open_questions": candidate.open_questions(),
        "objections": objections(candidate, language),
    })
}

/// Identifier of the verdict on a whole candidate.
#[must_use]
pub const fn verdict(candidate: &Candidate<'_>) -> &'static str {
    if candidate.fits() { "fits" } else { "does_not_fit" }
}

fn values(row: &DatumRow) -> Vec<Value> {
    row.values.iter().map(|value| value.map_or(Value::Null, number)).collect()
}

fn rows(rows: &[DatumRow]) -> Vec<Value> {
    rows.iter().map(|row| json!({ "symbol": row.symbol, "unit": row.unit.json, "values": values(row) })).collect()
}

fn answer(found: Option<&Check>, language: Language) -> Value {
    found.map_or(Value::Null, |found| check(found, language))
}

/// Several actuators side by side.
#[must_use]
pub fn compare(found: &Comparison<'_>, axis: &str, language: Language) -> Value {
    let checks: Vec<Value> = found
        .checks
        .iter()
        .map(|row| {
            json!({
                "id": row.id.id(),
                "title": check_title(row.id, language),
                "better": row.better,
                "answers": row.checks.iter().map(|each| answer(each.as_ref(), language)).collect::<Vec<_>>(),
            })
        })
        .collect();
    json!({
        "axis": axis,
        "candidates": found.candidates.iter().map(|each| head(each, language)).collect::<Vec<_>>(),
        "better": found.better,
        "demand": rows(&found.demand),
        "data": rows(&found.data),
        "checks": checks,
    })
}

/// The values that differ between two project files.
#[must_use]
pub fn input_changes(changes: &[InputChange]) -> Value {
    changes.iter().map(|each| json!({ "path": each.path, "old": each.old, "new": each.new })).collect()
}

/// One actuator before and after.
#[must_use]
pub fn difference(found: &Difference<'_>, axis: &str, language: Language) -> Value {
    let checks: Vec<Value> = found.checks.iter().map(|each| changed(each, language)).collect();
    let demand: Vec<Value> = found
        .demand
        .iter()
        .map(|row| {
            let mut map = Map::new();
            map.insert("symbol".into(), json!(row.symbol));
            map.insert("unit".into(), json!(row.unit.json));
            map.extend(["before", "after"].map(str::to_owned).into_iter().zip(values(row)));
            Value::Object(map)
        })
        .collect();
    json!({
        "axis": axis,
        "code": found.after.id.to_string(),
        "verdict": verdict(&found.after),
        "before": head(&found.before, language),
        "after": head(&found.after, language),
        "best_before": found.best_before.as_ref().map(ToString::to_string),
        "best_after": found.best_after.as_ref().map(ToString::to_string),
        "demand": demand,
        "checks": checks,
    })
}

fn changed(each: &CheckChange, language: Language) -> Value {
    json!({
        "id": each.id.id(),
        "title": check_title(each.id, language),
        "changed": !each.is_same(),
        "change": each.change().map(number),
        "before": answer(each.before.as_ref(), language),
        "after": answer(each.after.as_ref(), language),
    })
}
