//! The checks: their order, their counts, what is missing.

use super::shown::{Formatter, tied};
use answers::{Check, CheckId, Dossier, Grade, Identified, Number, Shaft, Verdict};
use quantities::Language;
use serde::Serialize;
use std::collections::BTreeMap;
use words::report::limit_of_zero;
use words::{capitalised, degree_of_protection, grade_about, grade_word};

/// Every check, in the order of the dossier.
#[derive(Serialize)]
pub(super) struct Checks {
    rows: Vec<CheckRow>,
    /// The remarks of all rows, each once, in the order of the rows that point to them.
    notes: Vec<String>,
    /// Checks that could not be made.
    open: Vec<Open>,
}

#[derive(Serialize)]
struct CheckRow {
    id: &'static str,
    /// Part of the actuator, or the place of installation.
    part: &'static str,
    title: String,
    verdict: &'static str,
    value: String,
    limit: String,
    /// Value and limit along the line of the mechanism; empty where there is none.
    line: [String; 2],
    /// The sign that is true between value and limit.
    relation: &'static str,
    /// Required relation of the value to the limit.
    required: &'static str,
    /// Utilisation, where [`CheckId::shows_utilisation`].
    utilisation: Option<f64>,
    /// `true` if the utilisation is a margin; that of a recommendation or of a voltage class is not.
    margin: bool,
    /// `true` if the limit is a rating of another manufacturer's gear.
    is_of_another_gear: bool,
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
    /// `true` if the missing datum could reject the actuator.
    rejects: bool,
    /// `true` if only a limit of the manufacturer of the actuator could reject it.
    by_own_limit: bool,
    notes: Vec<String>,
}

impl Checks {
    pub(super) fn build(dossier: &Dossier, shown: &Formatter) -> Self {
        let mechanism = &dossier.mechanism;
        let travel = |shaft: Shaft| match shaft {
            Shaft::Output => mechanism.travel_mm_per_rev,
            Shaft::Mechanism => mechanism.own_travel_mm_per_rev,
        };
        let checks = dossier.judgement.candidate.checks.iter();
        let (open, explained): (Vec<&Check>, Vec<&Check>) = checks.partition(|check| check.is_open);
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
            rows.push(row(check, own, check.id.shaft().and_then(travel), shown));
        }
        Self { rows, notes, open: open.into_iter().map(|check| missing(check, dossier)).collect() }
    }

    /// Returns value and limit of a check with the sign between them, or the words for a limit of zero; `None` if it has no
    /// limit.
    pub(super) fn compared(&self, check: &Check) -> Option<String> {
        let row = self.rows.iter().find(|row| row.id == check.id.id())?;
        match (row.relation, row.limit.as_str()) {
            (_, "") => None,
            ("", limit) => Some(format!("{}, {limit}", row.value)),
            (relation, limit) => Some(format!("{} {relation} {limit}", row.value)),
        }
    }

    /// Returns the number of open checks that may reject the actuator.
    pub(super) fn rejecting(&self) -> usize {
        self.open.iter().filter(|open| open.rejects).count()
    }
}

fn missing(check: &Check, dossier: &Dossier) -> Open {
    let missing = dossier.missing.iter().find(|missing| *missing.check == *check.id);
    Open {
        title: capitalised(&check.title),
        missing: missing.map(|missing| tied(&missing.text)).unwrap_or_default(),
        rejects: !check.id.is_recommendation(),
        by_own_limit: check.id.may_be_rated_elsewhere(),
        notes: check.notes.iter().map(|note| tied(note)).collect(),
    }
}

fn row(check: &Check, notes: Vec<usize>, travel: Option<Number>, shown: &Formatter) -> CheckRow {
    let unit = check.unit.unwrap_or("1");
    let figure = |value: Option<Number>| {
        let text = |value: Number| match *check.id {
            CheckId::Protection => degree_of_protection(value.0),
            _ => shown.figure(value, unit),
        };
        value.map(text).unwrap_or_default()
    };
    let is_exceeded = *check.verdict == Verdict::Fail && *check.id != CheckId::Protection;
    let [value, limit] = match (check.value, check.limit) {
        (Some(value), Some(limit)) if is_exceeded => shown.figures_apart([value, limit], unit),
        (value, limit) => [figure(value), figure(limit)],
    };
    let along = |value: Option<Number>| {
        value.zip(travel).and_then(|(value, travel)| shown.along(value, unit, travel)).unwrap_or_default()
    };
    let passes = *check.verdict == Verdict::Pass;
    // "41 Nm > 0 Nm" where nothing holds: the words stand in the place of the limit.
    let of_zero = check.limit.filter(|limit| limit.0 == 0.0 && !passes);
    let of_zero = of_zero.and_then(|_| limit_of_zero(*check.id, shown.0));
    let both = check.value.zip(check.limit);
    let utilisation = check.utilisation.filter(|_| check.id.shows_utilisation(*check.verdict));
    CheckRow {
        id: check.id.id(),
        part: check.part.id(),
        title: capitalised(&check.title),
        verdict: check.verdict.id(),
        value,
        limit: of_zero.map_or(limit, str::to_owned),
        line: [along(check.value), along(check.limit.filter(|_| of_zero.is_none()))],
        relation: both
            .filter(|_| of_zero.is_none())
            .map_or("", |(value, limit)| check.direction.relation(passes, value.0, limit.0)),
        required: both.filter(|_| of_zero.is_none()).map_or("", |_| check.direction.required()),
        utilisation: utilisation.and_then(Number::written),
        margin: *check.verdict == Verdict::Fail || check.margin,
        is_of_another_gear: check.is_of_another_gear,
        percent: utilisation.map(|share| shown.share(share)).unwrap_or_default(),
        at: check.at.map(|at| shown.instant(at)).unwrap_or_default(),
        grade: check.grade.map_or("", |grade| shown.grade(*grade)),
        sources: once(&check.sources),
        notes,
    }
}

/// Returns the texts without repetitions, in their order.
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

/// Returns the grades that occur among the checks of all axes, the best first.
pub(super) fn grades<'d>(dossiers: impl Iterator<Item = &'d Dossier> + Clone, language: Language) -> Vec<GradeTold> {
    let borne = |grade: &&Grade| {
        let mut checks = dossiers.clone().flat_map(|dossier| &dossier.judgement.candidate.checks);
        checks.any(|check| check.grade.is_some_and(|own| *own == **grade))
    };
    let explained =
        |grade: &Grade| GradeTold { name: grade_word(*grade, language), about: grade_about(*grade, language) };
    Grade::ALL.iter().filter(borne).map(explained).collect()
}

/// Titles of the checks, by identifier.
pub(super) struct Titles(BTreeMap<CheckId, String>);

impl Titles {
    pub(super) fn collect(dossier: &Dossier) -> Self {
        let ranked = dossier.sizing.ranking.iter().flat_map(|ranked| &ranked.of.candidate.checks);
        let named = dossier.judgement.candidate.checks.iter().chain(ranked);
        Self(named.map(|check| (*check.id, check.title.clone())).collect())
    }

    /// Returns the title of a check; its identifier if no title is known.
    pub(super) fn of(&self, id: CheckId) -> String {
        self.0.get(&id).cloned().unwrap_or_else(|| id.id().to_owned())
    }
}
