//! Comparisons and differences as records.

use super::check::{assumptions, check};
use super::errata::cited_erratum;
use super::judged::{fit, objections};
use crate::compare::{CheckChange, Comparison, DatumRow, Difference, errata_of};
use crate::sizing_use::Candidate;
use answers::{CheckRow, DatumChange, Head, Id, Number};
use axis::AxisProject;
use project::InputChange;
use quantities::Language;
use words::check_title;

fn head(candidate: &Candidate<'_>, language: Language) -> Head {
    Head {
        code: candidate.id.to_string(),
        verdict: fit(candidate),
        utilisation: Number(candidate.utilisation().unwrap_or(f64::NAN)),
        tightest: candidate.governing().map(|check| Id(check.id)),
        open_questions: candidate.open_questions(),
        objections: objections(candidate, language),
    }
}

fn rows(rows: &[DatumRow]) -> Vec<answers::DatumRow> {
    let row = |row: &DatumRow| answers::DatumRow {
        symbol: row.symbol,
        unit: row.unit.json,
        values: row.values.iter().map(|value| value.map(Number)).collect(),
        errata: row.errata.iter().map(|errata| errata.to_vec()).collect(),
    };
    rows.iter().map(row).collect()
}

/// Returns the comparison of several actuators.
#[must_use]
pub fn comparison(found: &Comparison<'_>, project: &AxisProject, language: Language) -> answers::Comparison {
    let checks = found.checks.iter().map(|row| CheckRow {
        id: Id(row.id),
        title: check_title(row.id, language),
        better: row.better,
        answers: row.checks.iter().map(|each| each.as_ref().map(|each| check(each, language))).collect(),
    });
    answers::Comparison {
        axis: project.name.clone(),
        candidates: found.candidates.iter().map(|each| head(each, language)).collect(),
        better: found.better,
        demand: rows(&found.demand),
        data: rows(&found.data),
        errata: errata_of(&found.data).into_iter().map(|id| cited_erratum(id, language)).collect(),
        checks: checks.collect(),
        assumptions: assumptions(project, language),
    }
}

/// Returns one actuator before and after a change of the project.
#[must_use]
pub fn difference(
    found: &Difference<'_>,
    inputs: &[InputChange],
    axis: &str,
    language: Language,
) -> answers::Difference {
    let demand = found.demand.iter().map(|row| {
        let value = |index: usize| row.values.get(index).copied().flatten().map(Number);
        DatumChange { symbol: row.symbol, unit: row.unit.json, before: value(0), after: value(1) }
    });
    let inputs = inputs.iter().map(|each| answers::InputChange {
        path: each.path.clone(),
        old: each.old.clone(),
        new: each.new.clone(),
    });
    answers::Difference {
        axis: axis.to_owned(),
        code: found.after.id.to_string(),
        verdict: fit(&found.after),
        before: head(&found.before, language),
        after: head(&found.after, language),
        best_before: found.best_before.as_ref().map(ToString::to_string),
        best_after: found.best_after.as_ref().map(ToString::to_string),
        demand: demand.collect(),
        checks: found.checks.iter().map(|each| changed(each, language)).collect(),
        inputs: inputs.collect(),
    }
}

fn changed(each: &CheckChange, language: Language) -> answers::CheckChange {
    let answer = |found: &Option<sizing::Check>| found.as_ref().map(|found| check(found, language));
    answers::CheckChange {
        id: Id(each.id),
        title: check_title(each.id, language),
        changed: !each.is_same(),
        change: each.change().map(Number),
        before: answer(&each.before),
        after: answer(&each.after),
    }
}
