//! What the checks have compared, what deviates, and what explains it.

use super::view::{AuditedCell, Reading};
use catalogue::Cell;
use std::collections::BTreeSet;
use std::fmt;

/// A value that does not fit its neighbours.
#[derive(Clone, Debug)]
pub struct Deviation {
    /// The check that found it.
    pub check: &'static str,
    /// The reading in which it deviates.
    pub reading: Reading,
    /// What stands where, and what was expected.
    pub message: String,
    /// Identifiers of the errata that explain it.
    pub errata: Vec<&'static str>,
    /// The reason written in code, where a rule explains it.
    pub rule: Option<&'static str>,
}

impl Deviation {
    /// Whether an erratum or a rule explains it.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        !self.errata.is_empty() || self.rule.is_some()
    }
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}): {}", self.check, self.reading.name(), self.message)
    }
}

/// A cell by its place: table, row, column.
pub(super) type CellPlace = (&'static str, u16, u16);

/// The place of a cell.
pub(super) const fn place(cell: &Cell) -> CellPlace {
    (cell.place.table, cell.row, cell.column)
}

/// What else may explain a deviation, besides the errata of the cells compared.
#[derive(Clone, Copy, Default)]
pub(super) struct Excuse {
    /// An erratum about a table as a whole: the table, and words that its `where` must contain.
    pub table_erratum: Option<(&'static str, &'static str)>,
    /// A reason written in code.
    pub rule: Option<&'static str>,
}

/// The outcome of one check in one reading.
pub(super) struct Tally {
    /// The check.
    pub check: &'static str,
    /// The reading.
    pub reading: Reading,
    /// How many comparisons were made.
    pub comparisons: usize,
    /// What does not fit.
    pub deviations: Vec<Deviation>,
    /// The cells that the comparisons could have blamed.
    pub covered: BTreeSet<CellPlace>,
}

impl Tally {
    pub(super) const fn new(check: &'static str, reading: Reading) -> Self {
        Self { check, reading, comparisons: 0, deviations: Vec::new(), covered: BTreeSet::new() }
    }

    /// One comparison. `blamed` are the cells whose erratum would explain a failure.
    pub(super) fn compare(&mut self, fits: bool, blamed: &[&AuditedCell], message: impl FnOnce() -> String) {
        self.compare_or(fits, blamed, Excuse::default(), message);
    }

    /// The same with an excuse besides the errata of the blamed cells.
    pub(super) fn compare_or(
        &mut self,
        fits: bool,
        blamed: &[&AuditedCell],
        excuse: Excuse,
        message: impl FnOnce() -> String,
    ) {
        self.comparisons += 1;
        self.covered.extend(blamed.iter().map(|entry| place(entry.cell)));
        if fits {
            return;
        }
        let explains = |id: &&'static str| catalogue::erratum(id).is_some_and(|e| self.reading.explains(e));
        let mut errata: Vec<&'static str> =
            blamed.iter().flat_map(|entry| entry.cell.errata).copied().filter(explains).collect();
        if let Some((table, words)) = excuse.table_erratum {
            let about = catalogue::errata().iter().filter(|e| e.table == table && e.place.contains(words));
            errata.extend(about.map(|e| e.id).filter(explains));
        }
        errata.sort_unstable();
        errata.dedup();
        let rule = if errata.is_empty() { excuse.rule } else { None };
        let (check, reading) = (self.check, self.reading);
        self.deviations.push(Deviation { check, reading, message: message(), errata, rule });
    }

    /// A comparison that could not be made because a cell is absent or is no number: never passed in silence.
    pub(super) fn absent(&mut self, what: impl fmt::Display) {
        self.compare(false, &[], || format!("cannot be checked: {what}"));
    }

    /// The deviations that nothing explains.
    pub(super) fn unexplained(&self) -> impl Iterator<Item = &Deviation> {
        self.deviations.iter().filter(|deviation| !deviation.is_explained())
    }
}

#[cfg(test)]
impl Tally {
    /// The messages of the unexplained deviations.
    pub(super) fn findings(&self) -> Vec<String> {
        self.unexplained().map(ToString::to_string).collect()
    }
}
