//! What the tolerances mean for an actuator, as JSON.

use super::number;
use crate::tolerance::{Assessment, Place};
use project::{ALL_CORNERS_MOST, Project};
use serde_json::{Value, json};

/// Samples, worst point and influences; an infinite utilisation is `null`.
#[must_use]
pub fn tolerance(project: &Project, assessment: &Assessment) -> Value {
    let found = &assessment.utilisation;
    let worst = &assessment.worst;
    let values: Vec<Value> = project
        .tolerances
        .iter()
        .zip(&worst.values)
        .map(|(each, si)| {
            json!({
                "quantity": each.path,
                "value": number(each.unit.from_si(*si)),
                "unit": each.unit.json,
            })
        })
        .collect();
    let influence: Vec<Value> = assessment
        .influence
        .iter()
        .filter_map(|each| {
            let quantity = &project.tolerances.get(each.quantity)?.path;
            Some(json!({ "quantity": quantity, "share": number(each.share) }))
        })
        .collect();
    json!({
        "samples": assessment.sampling.samples,
        "seed": assessment.sampling.seed,
        "distribution": "uniform",
        "passes": assessment.passes,
        "impossible": assessment.impossible,
        "share": number(assessment.share()),
        "interval": [number(assessment.interval.0), number(assessment.interval.1)],
        "utilisation": {
            "p05": number(found.p05),
            "p50": number(found.p50),
            "p95": number(found.p95),
            "max": number(found.max),
        },
        "worst_corner": {
            "verdict": if worst.fits { "fits" } else { "does_not_fit" },
            "utilisation": number(worst.utilisation),
            "check": worst.check.map(|check| check.id()),
            "values": values,
            "is_corner": worst.place != Place::Sample,
            "exhaustive": project.tolerances.len() <= ALL_CORNERS_MOST,
        },
        "influence": influence,
    })
}
