//! The checks: their order, their counts, what is missing.

use super::shown::{Shown, tied};
use answers::{Check, CheckId, Dossier, Grade, Identified, Number, Verdict};
use quantities::Language;
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use words::{capitalised, grade_about, grade_word};

/// Every check, the worst first.
#[derive(Serialize)]
pub(super) struct Checks {
    rows: Vec<CheckRow>,
    /// The remarks of all rows, each once, in the order of the rows that point to them.
    notes: Vec<String>,
    /// What could not be checked.
    open: Vec<Open>,
}

#[derive(Serialize)]
struct CheckRow {
    id: &'static str,
    title: String,
    verdict: &'static str,
    value: String,
    limit: String,
    /// Value and limit along the line of the mechanism; empty where there is none.
    line: [String; 2],
    /// The sign that is true between value and limit.
    relation: &'static str,
    utilisation: Option<f64>,
    /// Whether the utilisation is a margin: that of a recommendation or of a voltage class is not.
    margin: bool,
    percent: String,
    at: String,
    grade: &'static str,
    sources: Vec<String>,
    /// Numbers of its remarks, from 1.
    notes: Vec<usize>,
}

/// A check that could not be made.
#[derive(Serialize)]
struct Open {
    title: String,
    missing: String,
    /// Whether its answer could keep the actuator out.
    rejects: bool,
    notes: Vec<String>,
}

pub(super) struct Counts {
    pub(super) passed: usize,
    pub(super) failed: usize,
    pub(super) advised: usize,
    /// Without a value: a datum is missing.
    pub(super) open: usize,
    /// Those of the open ones that could keep the actuator out.
    pub(super) rejecting: usize,
    /// With a value and without a limit: not required.
    pub(super) shown: usize,
}

/// Whether a check lacks a datum; with a value and without a limit it is only shown, since no limit is required.
fn is_open(check: &Check) -> bool {
    *check.verdict == Verdict::NotChecked && check.value.is_none()
}

impl Checks {
    pub(super) fn build(dossier: &Dossier, shown: &Shown) -> Self {
        let travel = dossier.mechanism.travel_mm_per_rev;
        let mut checks: Vec<&Check> = dossier.judgement.candidate.checks.iter().collect();
        checks.sort_by(|a, b| rank(a).cmp(&rank(b)).then_with(|| by_utilisation(a.utilisation, b.utilisation)));
        let (open, explained): (Vec<&Check>, Vec<&Check>) = checks.into_iter().partition(|check| is_open(check));
        let mut notes: Vec<String> = Vec::new();
        let mut rows = Vec::new();
        for check in explained {
            let own = check.notes.iter().map(|note| {
                let note = tied(note);
                notes.iter().position(|known| *known == note).unwrap_or_else(|| {
                    notes.push(note);
                    notes.len() - 1
                }) + 1
            });
            let own = own.collect();
            rows.push(row(check, own, travel, shown));
        }
        Self { rows, notes, open: open.into_iter().map(|check| missing(check, dossier)).collect() }
    }

    pub(super) fn counts(&self) -> Counts {
        let count = |verdict: Verdict| self.rows.iter().filter(|row| row.verdict == verdict.id()).count();
        Counts {
            passed: count(Verdict::Pass),
            failed: count(Verdict::Fail),
            advised: count(Verdict::Advice),
            open: self.open.len(),
            rejecting: self.open.iter().filter(|open| open.rejects).count(),
            shown: count(Verdict::NotChecked),
        }
    }
}

fn missing(check: &Check, dossier: &Dossier) -> Open {
    let missing = dossier.missing.iter().find(|missing| *missing.check == *check.id);
    Open {
        title: capitalised(&check.title),
        missing: missing.map(|missing| tied(&missing.text)).unwrap_or_default(),
        rejects: !check.id.is_recommendation(),
        notes: check.notes.iter().map(|note| tied(note)).collect(),
    }
}

/// Failed checks first, then advice, checks not made last; in between those with a margin
/// before those that are only met or not.
fn rank(check: &Check) -> u8 {
    match (*check.verdict, check.utilisation) {
        (Verdict::Fail, _) => 0,
        (Verdict::Advice, _) => 1,
        (Verdict::Pass, Some(_)) if check.margin => 2,
        (Verdict::Pass, Some(_)) => 3,
        (Verdict::Pass, None) => 4,
        (Verdict::NotChecked, _) => 5,
    }
}

fn by_utilisation(a: Option<Number>, b: Option<Number>) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => b.0.total_cmp(&a.0),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => Ordering::Equal,
    }
}

fn row(check: &Check, notes: Vec<usize>, travel: Option<Number>, shown: &Shown) -> CheckRow {
    let unit = check.unit.unwrap_or("1");
    let figure = |value: Option<Number>| value.map(|value| shown.figure(value, unit)).unwrap_or_default();
    let along = |value: Option<Number>| {
        let travel = travel.filter(|_| check.id.is_of_the_output());
        value.zip(travel).and_then(|(value, travel)| shown.along(value, unit, travel)).unwrap_or_default()
    };
    let passes = *check.verdict == Verdict::Pass;
    let both = check.value.zip(check.limit);
    CheckRow {
        id: check.id.id(),
        title: capitalised(&check.title),
        verdict: check.verdict.id(),
        value: figure(check.value),
        limit: figure(check.limit),
        line: [along(check.value), along(check.limit)],
        relation: both.map_or("", |(value, limit)| check.direction.relation(passes, value.0, limit.0)),
        utilisation: check.utilisation.and_then(Number::written),
        margin: *check.verdict == Verdict::Fail || check.margin,
        // That of a recommendation or of a voltage class is no margin and is not shown as one.
        percent: check
            .utilisation
            .filter(|_| matches!(*check.verdict, Verdict::Fail | Verdict::Advice) || check.margin)
            .map(|share| shown.share(share))
            .unwrap_or_default(),
        at: check.at.map(|at| shown.figure(at, "s")).unwrap_or_default(),
        grade: check.grade.map_or("", |grade| shown.grade(*grade)),
        sources: once(&check.sources),
        notes,
    }
}

/// Each text once.
pub(super) fn once<'t>(texts: impl IntoIterator<Item = &'t String>) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for text in texts {
        if !found.contains(text) {
            found.push(text.clone());
        }
    }
    found
}

/// A grade in words.
#[derive(Serialize)]
pub(super) struct GradeTold {
    name: &'static str,
    about: &'static str,
}

/// The grades that the checks of all axes bear, the best first.
pub(super) fn grades<'d>(dossiers: impl Iterator<Item = &'d Dossier> + Clone, language: Language) -> Vec<GradeTold> {
    let borne = |grade: &&Grade| {
        let mut checks = dossiers.clone().flat_map(|dossier| &dossier.judgement.candidate.checks);
        checks.any(|check| check.grade.is_some_and(|own| *own == **grade))
    };
    let explained =
        |grade: &Grade| GradeTold { name: grade_word(*grade, language), about: grade_about(*grade, language) };
    Grade::ALL.iter().filter(borne).map(explained).collect()
}

/// Titles of the checks, from wherever one is named.
pub(super) struct Titles(BTreeMap<CheckId, String>);

impl Titles {
    pub(super) fn collect(dossier: &Dossier) -> Self {
        let ranked = dossier.sizing.ranking.iter().flat_map(|ranked| &ranked.of.candidate.checks);
        let named = dossier.judgement.candidate.checks.iter().chain(ranked);
        Self(named.map(|check| (*check.id, check.title.clone())).collect())
    }

    /// The title; the identifier where none is known.
    pub(super) fn of(&self, id: CheckId) -> String {
        self.0.get(&id).cloned().unwrap_or_else(|| id.id().to_owned())
    }
}
