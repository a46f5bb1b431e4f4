//! Plausibility of catalogue files: values that a reader accepts and a data sheet cannot mean.
//!
//! [`check_catalogue`] is the entry. The rules about one product are data in `rules`; `neighbours` compares the products of a
//! series with each other; `proposals` searches units with which no rule has a finding.

mod finding;
mod neighbours;
mod proposals;
mod rows;
mod rules;

pub use finding::{ComparedFigure, PlausibilityFinding};
pub use proposals::UnitProposal;
pub use rules::{PLAUSIBILITY_RULES, PlausibilityRule, PlausibilityRuleId, SERIES_KEYS, SIZE_KEYS, SeriesKey};

use crate::catalogue_files::read_products;
use crate::fault::AxisDiagnostic;
use actuator::Parameters;
use neighbours::{Peers, SameMotors, SeriesFits};
use rows::{Row, rows};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Result of the plausibility check of a catalogue file.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogueCheck {
    /// Names of the products, in the order of the file.
    pub names: Vec<String>,
    /// Implausible values, in the order of the file.
    pub findings: Vec<PlausibilityFinding>,
    /// Proposed units, in the order of the file.
    pub proposals: Vec<UnitProposal>,
}

/// Checks the values of a catalogue file against the rules; with `proposes` also searches units without a finding.
///
/// # Errors
/// Every fault of the file, each with its place, as [`read_products`].
pub fn check_catalogue(
    name: &str,
    bytes: &[u8],
    parameters: &Parameters,
    proposes: bool,
) -> Result<CatalogueCheck, Vec<AxisDiagnostic>> {
    read_products(name, bytes, parameters)?;
    let (rows, headings) = rows(name, bytes);
    let series = SeriesFits::of(&rows);
    let motors = SameMotors::of(&rows);
    let mut findings: Vec<PlausibilityFinding> = rows.iter().flat_map(own_findings).collect();
    findings.extend(motors.findings(&rows));
    findings.extend(series.findings(&rows));
    findings.extend(same_names(&rows));
    findings.sort_by_key(|finding| (finding.line, finding.rule, finding.column));
    let peers = Peers { rows: &rows, series, motors };
    let proposals = if proposes { proposals::proposed(&peers, &headings, &findings) } else { Vec::new() };
    Ok(CatalogueCheck { names: rows.into_iter().map(|row| row.id).collect(), findings, proposals })
}

/// Returns the findings about the values of one product.
fn own_findings(row: &Row) -> Vec<PlausibilityFinding> {
    let broken = |rule: &PlausibilityRule| {
        let ratio = rule.ratio(&|key| row.si(key)).filter(|ratio| !rule.holds(*ratio))?;
        let figures: Vec<ComparedFigure> =
            rule.terms.iter().filter_map(|(symbol, key, _)| row.figure(symbol, key)).collect();
        Some(PlausibilityFinding {
            ratio: Some(ratio),
            window: Some((rule.low, rule.high)),
            unit: rule.unit,
            formula: rule.formula,
            ..row.finding(rule.id, figures)
        })
    };
    PLAUSIBILITY_RULES.iter().filter_map(broken).collect()
}

/// Returns the products whose names differ from that of an earlier one in case and separators only.
fn same_names(rows: &[Row]) -> Vec<PlausibilityFinding> {
    let mut first: BTreeMap<(&str, String), &Row> = BTreeMap::new();
    let mut found = Vec::new();
    for row in rows {
        match first.entry((row.maker.as_str(), plain_name(&row.id))) {
            Entry::Vacant(free) => drop(free.insert(row)),
            Entry::Occupied(earlier) => found.push(PlausibilityFinding {
                other: Some((earlier.get().id.clone(), earlier.get().line)),
                ..row.finding(PlausibilityRuleId::SameName, Vec::new())
            }),
        }
    }
    found
}

/// Returns a name in lower case, with one hyphen for each run of separators.
fn plain_name(name: &str) -> String {
    let is_part = |sign: char| sign.is_alphanumeric();
    let parts = name.split(|sign| !is_part(sign)).filter(|part| !part.is_empty());
    parts.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}
