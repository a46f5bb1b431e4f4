//! Units with which the values of a product contradict no rule.

use super::finding::PlausibilityFinding;
use super::neighbours::{Peers, is_same_motor};
use super::rows::{Number, Row};
use super::rules::{PLAUSIBILITY_RULES, PlausibilityRuleId};
use crate::catalogue_csv::UnitHeading;
use project::sections::{ActuatorEntry, Section};
use project::{Key, Kind};
use quantities::{Dimension, Unit};
use std::collections::{BTreeMap, BTreeSet};

/// A proposed cell: one change with which no rule that reads the value has a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitProposal {
    /// Name of the product; `None` for the heading of a column.
    pub product: Option<String>,
    /// Name of the key.
    pub key: &'static str,
    /// Line of the cell, from one.
    pub line: usize,
    /// Column of the cell in characters, from one.
    pub column: usize,
    /// Cell as written.
    pub old: String,
    /// Proposed cell.
    pub new: String,
    /// Value that the proposed cell means, with its unit.
    pub meant: String,
    /// Rules that the value breaks as written.
    pub resolves: Vec<PlausibilityRuleId>,
    /// Another cell of the product would resolve the same findings: one of them is wrong.
    pub is_one_of_several: bool,
    /// Only a change of the whole column resolves the findings.
    of_column: bool,
}

/// Misplaced decimal marks that are tried besides other units.
const SHIFTS: [f64; 6] = [10.0, 0.1, 100.0, 0.01, 1000.0, 0.001];

/// Decades within which two changes explain a finding equally well, so that the more usual one comes first.
const EQUAL: f64 = 0.15;

/// Decades by which a change must explain a finding better than one that is a place before it in the list of units.
const PLACE: f64 = 0.06;

/// Decades by which a shifted decimal mark must explain a finding better than the last unit.
const SHIFT: f64 = 0.3;

/// A change of a value.
struct Change {
    /// Number in the unit as written, for a table.
    number: f64,
    /// Value and unit that are meant.
    meant: String,
    /// Changed value in SI.
    si: f64,
    /// Decades that are added to its distance.
    handicap: f64,
}

/// Returns the proposals for all findings: for each product the cells of which a single change resolves every finding that
/// reads it, those that resolve most first; one for the heading if it resolves the whole column.
pub(super) fn proposed(
    peers: &Peers<'_>,
    headings: &[UnitHeading],
    findings: &[PlausibilityFinding],
) -> Vec<UnitProposal> {
    let mut by_product: BTreeMap<&str, Vec<&PlausibilityFinding>> = BTreeMap::new();
    for finding in findings {
        by_product.entry(&finding.product).or_default().push(finding);
    }
    let mut all = Vec::new();
    for (index, row) in peers.rows.iter().enumerate() {
        if let Some(of_row) = by_product.get(row.id.as_str()) {
            all.extend(of_product(peers, index, row, of_row));
        }
    }
    all.sort_by_key(|proposal| (proposal.line, proposal.column));
    of_headings(peers.rows, headings, all)
}

/// Returns the proposals for one product.
fn of_product(peers: &Peers<'_>, index: usize, row: &Row, findings: &[&PlausibilityFinding]) -> Vec<UnitProposal> {
    let reads = |finding: &PlausibilityFinding, key: &str| finding.figures.iter().any(|figure| figure.key == key);
    let keys: BTreeSet<&'static str> =
        findings.iter().flat_map(|finding| finding.figures.iter().map(|figure| figure.key)).collect();
    let of_key = |key: &'static str| {
        let number = row.values.get(key)?;
        let change = |compares| best(key, number, &|si| distance(peers, (index, row), compares, (key, si)));
        // Where a whole column is wrong, the neighbours are no measure.
        let with_neighbours = change(Compares::All);
        let of_column = with_neighbours.is_none();
        let change = with_neighbours.or_else(|| change(Compares::Product))?;
        let new =
            if number.of_table { as_cell(change.number, &number.cell) } else { quoted(&change.meant, &number.cell) };
        let resolves = findings.iter().filter(|finding| reads(finding, key)).map(|finding| finding.rule).collect();
        Some(UnitProposal {
            product: Some(row.id.clone()),
            key,
            line: number.line,
            column: number.column,
            old: number.cell.clone(),
            new,
            meant: change.meant,
            resolves,
            is_one_of_several: false,
            of_column,
        })
    };
    let mut rest: Vec<UnitProposal> = keys.into_iter().filter_map(of_key).collect();
    let mut open: Vec<&PlausibilityFinding> = findings.to_vec();
    let mut chosen = Vec::new();
    // The cell that explains most findings first; what is left decides about the others.
    loop {
        let explained = |proposal: &UnitProposal| open.iter().filter(|finding| reads(finding, proposal.key)).count();
        let most = rest.iter().map(explained).max().unwrap_or(0);
        if most == 0 {
            return chosen;
        }
        let (mut best, others): (Vec<UnitProposal>, Vec<UnitProposal>) =
            rest.into_iter().partition(|proposal| explained(proposal) == most);
        let several = best.len() > 1;
        open.retain(|finding| !best.iter().any(|proposal| reads(finding, proposal.key)));
        best.iter_mut().for_each(|proposal| proposal.is_one_of_several = several);
        chosen.append(&mut best);
        rest = others;
    }
}

/// Replaces the proposals for all cells of a column, if they mean one unit, by one for its heading.
fn of_headings(rows: &[Row], headings: &[UnitHeading], mut all: Vec<UnitProposal>) -> Vec<UnitProposal> {
    for heading in headings {
        let unit = |proposal: &UnitProposal| proposal.meant.split_once(' ').map(|(_, unit)| unit.to_owned());
        let of_column: Vec<&UnitProposal> = all.iter().filter(|proposal| proposal.key == heading.key).collect();
        let stated = rows.iter().filter(|row| row.si(heading.key).is_some_and(|value| value != 0.0)).count();
        let Some(other) = of_column.first().and_then(|first| unit(first)) else { continue };
        let is_whole = of_column.len() == stated && stated > 1;
        if !is_whole
            || other == heading.unit
            || of_column.iter().any(|proposal| unit(proposal).as_ref() != Some(&other))
        {
            continue;
        }
        let resolves: BTreeSet<PlausibilityRuleId> =
            of_column.iter().flat_map(|proposal| proposal.resolves.iter().copied()).collect();
        let proposal = UnitProposal {
            product: None,
            key: heading.key,
            line: heading.line,
            column: heading.column,
            old: heading.text.clone(),
            new: heading.text.replace(&heading.unit, &other),
            is_one_of_several: of_column.iter().any(|proposal| proposal.is_one_of_several),
            meant: other,
            of_column: false,
            resolves: resolves.into_iter().collect(),
        };
        all.retain(|proposal| proposal.key != heading.key);
        all.push(proposal);
    }
    all.retain(|proposal| !proposal.of_column);
    all.sort_by_key(|proposal| (proposal.line, proposal.column));
    all
}

/// Returns the best change of a value without a finding: the first of those that are about as far from the middle of all
/// windows as the least far one.
fn best(key: &str, number: &Number, distance: &dyn Fn(f64) -> Option<f64>) -> Option<Change> {
    let found: Vec<(f64, Change)> = changes(key, number)
        .into_iter()
        .filter_map(|change| Some((distance(change.si)? + change.handicap, change)))
        .collect();
    let least = found.iter().map(|(distance, _)| *distance).min_by(f64::total_cmp)?;
    found.into_iter().find(|(distance, _)| *distance <= least + EQUAL).map(|(_, change)| change)
}

/// Comparison of a changed value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Compares {
    /// With the rules about the product, and with its neighbours.
    All,
    /// With the rules about the product.
    Product,
}

/// Returns the distance of a changed value from the other products of the series, or, without a law, of the product from the
/// middle of all windows that read it, in decades; `None` if a finding is left.
fn distance(peers: &Peers<'_>, (index, row): (usize, &Row), compares: Compares, (key, si): (&str, f64)) -> Option<f64> {
    let value = |wanted: &str| if wanted == key { Some(si) } else { row.si(wanted) };
    let mut sum = 0.0;
    for rule in PLAUSIBILITY_RULES.iter().filter(|rule| rule.terms.iter().any(|(_, term, _)| *term == key)) {
        let Some(ratio) = rule.ratio(&value) else { continue };
        if !rule.holds(ratio) {
            return None;
        }
        sum += (ratio / (rule.low * rule.high).sqrt()).log10().abs();
    }
    if compares == Compares::Product {
        return Some(sum);
    }
    let factor = si / row.si(key).filter(|old| *old > 0.0)?;
    let same_motor = peers.motors.ratio(index).filter(|_| key == "inertia_out");
    if same_motor.is_some_and(|ratio| !is_same_motor(ratio * factor)) {
        return None;
    }
    let Some((deviation, most)) = peers.series.deviation(index, row, key) else { return Some(sum) };
    let changed = (deviation + factor.log10()).abs();
    (changed <= most).then_some(changed)
}

/// Returns other meanings of a value: the same number in every other unit, then shifted decimal marks.
fn changes(key: &str, number: &Number) -> Vec<Change> {
    let Some(dimension) = ActuatorEntry::KEYS.iter().find(|known| known.name == key).and_then(dimension_of) else {
        return Vec::new();
    };
    let Some((digits, unit)) = number.written.split_once(' ') else { return Vec::new() };
    let Some((written, value)) =
        Unit::of_dimension(dimension, unit.trim()).zip(digits.replace(',', ".").parse::<f64>().ok())
    else {
        return Vec::new();
    };
    let units = dimension.units();
    let place = |place: usize| PLACE * f64::from(u8::try_from(place).unwrap_or(u8::MAX));
    let of_unit = |(index, other): (usize, &Unit)| {
        let si = other.to_si(value);
        let meant = format!("{digits} {}", other.ascii);
        Change { number: written.from_si(si), meant, si, handicap: place(index) }
    };
    let shifted = |factor: &f64| {
        let number = rounded(value * factor);
        let meant = format!("{number} {}", unit.trim());
        Change { number, meant, si: written.to_si(number), handicap: place(units.len()) + SHIFT }
    };
    let is_other = |change: &Change| (change.si / number.si - 1.0).abs() > 1e-6;
    units.iter().enumerate().map(of_unit).chain(SHIFTS.iter().map(shifted)).filter(is_other).collect()
}

const fn dimension_of(key: &Key) -> Option<Dimension> {
    match key.kind {
        Kind::Quantity(dimension, _) => Some(dimension),
        _ => None,
    }
}

/// Returns a number without the last digits of a product of floats.
fn rounded(number: f64) -> f64 {
    format!("{number:.11e}").parse().unwrap_or(number)
}

/// Returns a number as a cell, with the decimal mark of the old one.
fn as_cell(number: f64, old: &str) -> String {
    let text = rounded(number).to_string();
    if old.contains(',') && !old.contains('.') { text.replace('.', ",") } else { text }
}

/// Returns a value in the quotation marks of the old one.
fn quoted(value: &str, old: &str) -> String {
    let mark = old.chars().next().filter(|mark| ['"', '\''].contains(mark)).unwrap_or('"');
    format!("{mark}{value}{mark}")
}
