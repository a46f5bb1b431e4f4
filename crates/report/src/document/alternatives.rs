//! What else fits, what nearly fits, and why the rest does not.

use super::checks::{Titles, by_utilisation, capital};
use super::shown::Shown;
use crate::data::{Judged, Rejected, Sizing};
use serde::Serialize;

/// Nearest misses shown in full.
const NEAREST: usize = 12;
/// Fitting actuators shown in full.
const FITTING: usize = 12;

#[derive(Serialize)]
pub(super) struct Alternatives {
    judged: Option<u64>,
    fitting: Option<u64>,
    answer: String,
    rule: String,
    ranking: Vec<Fitting>,
    nearest: Vec<Miss>,
    reasons: Vec<Reason>,
}

#[derive(Serialize)]
struct Fitting {
    rank: usize,
    code: String,
    utilisation: f64,
    percent: String,
    tightest: String,
    mass: String,
    open: usize,
    on_request: Vec<String>,
    chosen: bool,
}

#[derive(Serialize)]
struct Miss {
    code: String,
    check: String,
    value: String,
    limit: String,
    utilisation: f64,
    percent: String,
    further: Vec<String>,
}

/// One reason and every code that it excludes.
#[derive(Serialize)]
struct Reason {
    /// `check` or `requirement`.
    kind: &'static str,
    text: String,
    codes: Vec<String>,
}

impl Alternatives {
    pub(super) fn build(sizing: &Sizing, judged: &Judged, titles: &Titles, shown: &Shown) -> Self {
        let ranking = sizing
            .ranking
            .iter()
            .take(FITTING)
            .enumerate()
            .map(|(index, each)| Fitting {
                rank: index + 1,
                code: each.code.clone(),
                utilisation: each.utilisation.unwrap_or_default(),
                percent: each.utilisation.map(|share| shown.percent(share)).unwrap_or_default(),
                tightest: capital(&titles.of(&each.tightest)),
                mass: each.mass_kg.map(|mass| shown.number(mass)).unwrap_or_default(),
                open: each.open_questions,
                on_request: each.on_request.clone(),
                chosen: each.code == judged.code,
            })
            .collect();
        Self {
            judged: sizing.judged,
            fitting: sizing.fitting,
            answer: sizing.answer.clone(),
            rule: capital(&sizing.rule),
            ranking,
            nearest: nearest(&sizing.rejected, titles, shown),
            reasons: reasons(&sizing.rejected, titles),
        }
    }
}

/// Those that only a limit excludes, the least exceeded first. Where the limit is zero there is no near and far.
fn nearest(rejected: &[Rejected], titles: &Titles, shown: &Shown) -> Vec<Miss> {
    let mut near: Vec<&Rejected> =
        rejected.iter().filter(|each| each.objections.is_empty() && each.utilisation.is_some()).collect();
    near.sort_by(|a, b| by_utilisation(b.utilisation, a.utilisation));
    near.into_iter()
        .take(NEAREST)
        .map(|each| {
            let figure = |value: Option<f64>| value.map(|value| shown.figure(value, &each.unit)).unwrap_or_default();
            Miss {
                code: each.code.clone(),
                check: capital(&titles.of(&each.check)),
                value: figure(each.value),
                limit: figure(each.limit),
                utilisation: each.utilisation.unwrap_or_default(),
                percent: each.utilisation.map(|share| shown.percent(share)).unwrap_or_default(),
                further: each.failing.iter().filter(|id| **id != each.check).map(|id| titles.of(id)).collect(),
            }
        })
        .collect()
}

/// Every rejected code once, below its first reason: a requirement not met goes before a limit exceeded.
fn reasons(rejected: &[Rejected], titles: &Titles) -> Vec<Reason> {
    let mut found: Vec<(String, Reason)> = Vec::new();
    for each in rejected {
        let (kind, text) = match each.objections.first() {
            Some(objection) => ("requirement", objection.clone()),
            None => ("check", titles.of(&each.check)),
        };
        let key = format!("{kind} {}", without_figures(&text));
        match found.iter_mut().find(|(known, _)| *known == key) {
            Some((_, reason)) => {
                if reason.text != text {
                    reason.text = without_figures(&text);
                }
                reason.codes.push(each.code.clone());
            }
            None => found.push((key, Reason { kind, text, codes: vec![each.code.clone()] })),
        }
    }
    let mut reasons: Vec<Reason> = found.into_iter().map(|(_, reason)| reason).collect();
    reasons.sort_by_key(|reason| std::cmp::Reverse(reason.codes.len()));
    for reason in &mut reasons {
        reason.codes.sort();
    }
    reasons
}

/// The sentence with every number replaced, so that alike reasons meet.
fn without_figures(text: &str) -> String {
    let words: Vec<&str> =
        text.split(' ')
            .map(|word| {
                if word.parse::<f64>().is_ok() || word.replace(',', ".").parse::<f64>().is_ok() { "…" } else { word }
            })
            .collect();
    words.join(" ")
}
