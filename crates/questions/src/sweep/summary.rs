//! Numbers of the results of a sweep.

use super::{Answer, Every, Judged, OnFront, Sweep, Wanted};
use answers::{AssumptionEntry, Id, Number};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::{CheckId, Fit, Verdict};
use std::collections::BTreeMap;

/// Largest number of different reasons listed.
const REASONS_MOST: usize = 20;

/// Largest number of different reasons counted separately.
const COUNTED_MOST: usize = 10_000;

/// Summary of the answers to the rows of a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SweepSummary {
    /// The file of the answers; `null` where there is none.
    pub file: Option<String>,
    /// Rows of the table.
    pub rows: u64,
    /// Rows for which an actuator fits within every limit.
    pub fit: u64,
    /// Rows for which one fits only if an estimate holds.
    pub fit_if_estimate: u64,
    /// The sum of both.
    pub fitting: u64,
    /// Rows for which none fits, by the governing check of the nearest miss, most first.
    pub none_fits: Vec<MissedBy>,
    /// Rows that are not judged, by the reason, most first.
    pub not_judged: Vec<NotJudged>,
    /// Rows with further reasons.
    pub further: u64,
    /// The answers of the rows; empty where a file holds them.
    pub answers: Vec<SweepRow>,
    /// Assumptions that hold for every row: those of the project that no column states.
    pub assumptions: Vec<AssumptionEntry>,
}

/// Rows that miss by a check.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct MissedBy {
    /// The check; `null` where no actuator is of the required class.
    pub check: Option<&'static str>,
    /// Title of the check.
    pub title: String,
    /// Number of rows.
    pub rows: u64,
}

/// Rows that are not judged for a reason.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct NotJudged {
    /// The reason.
    pub message: String,
    /// Number of rows.
    pub rows: u64,
}

/// Verdict and utilisation of a requested check.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SweepCheck {
    /// Identifier of the check.
    pub id: Id<CheckId>,
    /// Verdict; `null` if axis or actuator do not have the check.
    pub verdict: Option<Id<Verdict>>,
    /// Utilisation.
    pub utilisation: Option<Number>,
}

/// The answer of a row.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SweepRow {
    /// The row, from 0.
    pub row: u64,
    /// Number of codes that fit within every limit.
    pub fit: Option<u32>,
    /// Number of others that fit if an estimate holds.
    pub fit_if_estimate: Option<u32>,
    /// The best of both.
    pub code: Option<String>,
    /// Utilisation of its governing check; where none fits that of the nearest miss.
    pub utilisation: Option<Number>,
    /// Identifier of this check.
    pub tightest: Option<Id<CheckId>>,
    /// Ratio of the stage chosen among several of the project.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stage_ratio: Option<Number>,
    /// The requested checks of the code.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<SweepCheck>,
    /// Why the row is not judged.
    pub error: Option<String>,
    /// Cells of the columns that are no keys, such as `id`, by their headings; for values that the call states those of the keys.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub labels: BTreeMap<String, String>,
}

impl SweepRow {
    /// Returns the lines of the answer for a row, one for each code if there are several; `wanted` are the requested checks.
    #[must_use]
    pub fn of(row: u64, answer: &Answer, wanted: &Wanted) -> Vec<Self> {
        let empty = || Self {
            row,
            fit: None,
            fit_if_estimate: None,
            code: None,
            utilisation: None,
            tightest: None,
            stage_ratio: None,
            checks: Vec::new(),
            error: None,
            labels: BTreeMap::new(),
        };
        let share = |share: Option<f64>| share.map(|share| Number::in_unit(share, &quantities::unit::ONE));
        let of = |code: Option<String>, utilisation: Option<f64>, tightest: Option<CheckId>| Self {
            code,
            utilisation: share(utilisation),
            tightest: tightest.map(Id),
            ..empty()
        };
        match answer {
            Ok(Judged::Best(best)) => {
                let found = of(best.code.as_ref().map(|code| code.to_string()), best.utilisation, best.tightest);
                let stage_ratio = share(best.stage_ratio);
                vec![Self { fit: Some(best.fit), fit_if_estimate: Some(best.fit_if_estimate), stage_ratio, ..found }]
            }
            Ok(Judged::Every(all)) => {
                let ids = if let Wanted::Every(ids) = wanted { ids.as_slice() } else { &[] };
                let check = |(id, found): (&CheckId, &Option<(Verdict, Option<f64>)>)| SweepCheck {
                    id: Id(*id),
                    verdict: found.map(|(verdict, _)| Id(verdict)),
                    utilisation: share(found.and_then(|(_, utilisation)| utilisation)),
                };
                let each = |one: &Every| Self {
                    checks: ids.iter().zip(&one.checks).map(check).collect(),
                    fit: Some(u32::from(one.fit == Fit::Fits)),
                    fit_if_estimate: Some(u32::from(one.fit == Fit::FitsIfEstimate)),
                    stage_ratio: share(one.stage_ratio),
                    ..of(Some(one.code.to_string()), one.utilisation, one.tightest)
                };
                all.iter().map(each).collect()
            }
            Ok(Judged::Front(front)) => {
                let each = |one: &OnFront| Self {
                    stage_ratio: share(one.stage_ratio),
                    ..of(Some(one.code.to_string()), Some(one.utilisation), one.tightest)
                };
                front.iter().map(each).collect()
            }
            Err(why) => vec![Self { error: Some(why.clone()), ..empty() }],
        }
    }
}

/// Counter of the answers for rows.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    rows: u64,
    fit: u64,
    fit_if_estimate: u64,
    missed: BTreeMap<Option<String>, u64>,
    refused: BTreeMap<String, u64>,
    further: u64,
}

impl Tally {
    /// Adds the answer for a row.
    pub fn add(&mut self, answer: &Answer) {
        match answer {
            Ok(Judged::Best(best)) => {
                let fit = match (best.fit, best.fit_if_estimate) {
                    (0, 0) => Fit::DoesNotFit,
                    (0, _) => Fit::FitsIfEstimate,
                    _ => Fit::Fits,
                };
                self.judged(fit, best.tightest.map(CheckId::id));
            }
            Ok(Judged::Every(all)) => {
                self.judged(all.iter().map(|one| one.fit).min().unwrap_or(Fit::DoesNotFit), None);
            }
            Ok(Judged::Front(front)) => {
                self.judged(front.iter().map(|one| one.fit).min().unwrap_or(Fit::DoesNotFit), None);
            }
            Err(why) => self.refused(why),
        }
    }

    /// Adds a row by the verdict on its best code, or by the governing check of the actuator with the smallest excess.
    pub fn judged(&mut self, fit: Fit, tightest: Option<&str>) {
        self.rows += 1;
        match fit {
            Fit::Fits => self.fit += 1,
            Fit::FitsIfEstimate => self.fit_if_estimate += 1,
            Fit::DoesNotFit => *self.missed.entry(tightest.map(str::to_owned)).or_default() += 1,
        }
    }

    /// Adds a row that is not judged.
    pub fn refused(&mut self, why: &str) {
        self.rows += 1;
        if let Some(count) = self.refused.get_mut(why) {
            *count += 1;
        } else if self.refused.len() < COUNTED_MOST {
            self.refused.insert(why.to_owned(), 1);
        } else {
            self.further += 1;
        }
    }

    /// Returns the number of rows so far.
    #[must_use]
    pub const fn rows(&self) -> u64 {
        self.rows
    }

    /// Returns the summary in a language.
    #[must_use]
    pub fn summary(&self, sweep: &Sweep, file: Option<String>) -> SweepSummary {
        let language = sweep.options().language;
        let title = |id: Option<CheckId>| {
            id.map_or_else(|| words::sweeps::no_class(language).to_owned(), |id| words::check_title(id, language))
        };
        let check = |id: &Option<String>| CheckId::ALL.iter().copied().find(|check| Some(check.id()) == id.as_deref());
        let mut none_fits: Vec<MissedBy> = self
            .missed
            .iter()
            .map(|(id, rows)| MissedBy { check: check(id).map(CheckId::id), title: title(check(id)), rows: *rows })
            .collect();
        none_fits.sort_by_key(|each| std::cmp::Reverse(each.rows));
        let mut not_judged: Vec<NotJudged> =
            self.refused.iter().map(|(why, rows)| NotJudged { message: why.clone(), rows: *rows }).collect();
        not_judged.sort_by_key(|each| std::cmp::Reverse(each.rows));
        let beyond: u64 = not_judged.iter().skip(REASONS_MOST).map(|each| each.rows).sum();
        not_judged.truncate(REASONS_MOST);
        SweepSummary {
            file,
            rows: self.rows,
            fit: self.fit,
            fit_if_estimate: self.fit_if_estimate,
            fitting: self.fit + self.fit_if_estimate,
            none_fits,
            not_judged,
            further: self.further + beyond,
            answers: Vec::new(),
            assumptions: sweep.assumptions(),
        }
    }
}
