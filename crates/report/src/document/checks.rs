//! The checks: their order, their parts, their sources and derivations.

use super::shown::{Shown, tied};
use crate::data::{Check, Judged, Sizing};
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Every check, the worst first.
#[derive(Serialize)]
pub(super) struct Checks {
    rows: Vec<CheckRow>,
}

#[derive(Serialize)]
pub(super) struct CheckRow {
    id: String,
    title: String,
    verdict: String,
    /// Chapter 7 of the part it belongs to.
    part: String,
    value: String,
    limit: String,
    /// `≤` or `≥` where the limit is kept, `>` or `<` where it is not.
    relation: &'static str,
    utilisation: Option<f64>,
    /// Whether the utilisation tells a margin: that of a recommendation or of a voltage class does not.
    margin: bool,
    percent: String,
    at: String,
    grade: String,
    sources: Vec<String>,
    missing: String,
    notes: Vec<String>,
}

pub(super) struct Counts {
    pub(super) passed: usize,
    pub(super) failed: usize,
    pub(super) advised: usize,
    pub(super) open: usize,
    pub(super) shown: usize,
}

impl Checks {
    pub(super) fn build(judged: &Judged, shown: &Shown) -> Self {
        let mut checks: Vec<&Check> = judged.checks.iter().collect();
        checks.sort_by(|a, b| rank(a).cmp(&rank(b)).then_with(|| by_utilisation(a.utilisation, b.utilisation)));
        Self { rows: checks.into_iter().map(|check| row(check, shown)).collect() }
    }

    pub(super) fn counts(&self) -> Counts {
        let count = |verdict: &str| self.rows.iter().filter(|row| row.verdict == verdict).count();
        // With a value and without a limit a check is shown: nobody asked.
        let open = self.rows.iter().filter(|row| row.verdict == "not_checked" && row.value.is_empty()).count();
        Counts {
            passed: count("pass"),
            failed: count("fail"),
            advised: count("advice"),
            open,
            shown: count("not_checked") - open,
        }
    }
}

/// What failed stands first and what was not checked last; between them the utilisation decides.
fn rank(check: &Check) -> u8 {
    match (check.verdict.as_str(), check.utilisation) {
        ("fail", _) => 0,
        ("not_checked", _) => 4,
        (_, Some(_)) => 1,
        ("advice", None) => 2,
        (_, None) => 3,
    }
}

pub(super) fn by_utilisation(a: Option<f64>, b: Option<f64>) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => b.total_cmp(&a),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => Ordering::Equal,
    }
}

fn row(check: &Check, shown: &Shown) -> CheckRow {
    let figure = |value: Option<f64>| value.map(|value| shown.figure(value, &check.unit)).unwrap_or_default();
    CheckRow {
        id: check.id.clone(),
        title: capital(&check.title),
        verdict: check.verdict.clone(),
        part: check.part.clone(),
        value: figure(check.value),
        limit: figure(check.limit),
        relation: relation(check),
        utilisation: check.utilisation,
        margin: check.verdict == "fail" || check.margin,
        percent: check.utilisation.map(|share| shown.percent(share)).unwrap_or_default(),
        at: check.at.map(|at| shown.figure(at, "s")).unwrap_or_default(),
        grade: check.grade.clone(),
        sources: parts_of_source(&check.source),
        missing: check.missing.clone(),
        notes: check.notes.iter().filter(|note| !note.is_empty()).map(|note| tied(note)).collect(),
    }
}

/// The text as the head of a line.
pub(super) fn capital(text: &str) -> String {
    let mut signs = text.chars();
    signs.next().map_or_else(String::new, |first| first.to_uppercase().chain(signs).collect())
}

/// How the value lies to its limit.
fn relation(check: &Check) -> &'static str {
    let (Some(value), Some(limit)) = (check.value, check.limit) else { return "" };
    match (check.direction.as_str(), value > limit, value < limit) {
        ("at_least", _, true) => "<",
        ("at_least", ..) => "≥",
        (_, true, _) => ">",
        _ => "≤",
    }
}

/// The sources of a check, each once.
pub(super) fn parts_of_source(text: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    for part in text.split("; ").map(str::trim).filter(|part| !part.is_empty()) {
        if !parts.iter().any(|known| known == part) {
            parts.push(part.to_owned());
        }
    }
    parts
}

/// Titles of the checks by id, from wherever one is named.
pub(super) struct Titles(BTreeMap<String, String>);

impl Titles {
    pub(super) fn collect(judged: &Judged, sizing: &Sizing) -> Self {
        let ranked = sizing.ranking.iter().flat_map(|candidate| &candidate.checks);
        let named = judged.checks.iter().chain(ranked).map(|check| (check.id.clone(), check.title.clone()));
        Self(named.filter(|(_, title)| !title.is_empty()).collect())
    }

    /// The title; the id where none is known.
    pub(super) fn of(&self, id: &str) -> String {
        self.0.get(id).cloned().unwrap_or_else(|| id.to_owned())
    }
}
