//! Record of comparisons, deviations and their explanations.

use super::view::{AuditedCell, TextVersion};
use catalogue::Cell;
use std::collections::BTreeSet;
use std::fmt;

/// A value that does not fit its neighbours.
#[derive(Clone, Debug)]
pub(crate) struct Deviation {
    /// Name of the check.
    pub(crate) check: &'static str,
    /// TextVersion in which the value deviates.
    pub(crate) reading: TextVersion,
    /// Place, value found and value expected.
    pub(crate) message: String,
    /// Identifiers of the errata that explain the deviation.
    pub(crate) errata: Vec<&'static str>,
    /// Reason written in code, if a rule explains the deviation.
    pub(crate) rule: Option<&'static str>,
}

impl Deviation {
    /// Returns `true` if an erratum or a rule explains the deviation.
    #[must_use]
    pub(crate) fn is_explained(&self) -> bool {
        !self.errata.is_empty() || self.rule.is_some()
    }
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}): {}", self.check, self.reading.name(), self.message)
    }
}

/// Place of a cell: table, row, column.
pub(super) type CellPlace = (&'static str, u16, u16);

/// Returns the place of a cell.
pub(super) const fn place(cell: &Cell) -> CellPlace {
    (cell.place.table, cell.row, cell.column)
}

/// Explanation of a deviation other than the errata of the compared cells.
#[derive(Clone, Copy, Default)]
pub(super) struct Excuse {
    /// Erratum about a table as a whole: the table, and words that its `where` must contain.
    pub(crate) table_erratum: Option<(&'static str, &'static str)>,
    /// Reason written in code.
    pub(crate) rule: Option<&'static str>,
}

/// Result of one check in one reading.
pub(super) struct Tally {
    /// Name of the check.
    pub(crate) check: &'static str,
    /// TextVersion.
    pub(crate) reading: TextVersion,
    /// Number of comparisons made.
    pub(crate) comparisons: usize,
    /// Deviations found.
    pub(crate) deviations: Vec<Deviation>,
    /// Places of the cells that could explain a failed comparison.
    pub(crate) covered: BTreeSet<CellPlace>,
}

impl Tally {
    pub(super) const fn new(check: &'static str, reading: TextVersion) -> Self {
        Self { check, reading, comparisons: 0, deviations: Vec::new(), covered: BTreeSet::new() }
    }

    /// Records a comparison. `blamed` are the cells whose erratum would explain a failure.
    pub(super) fn compare(&mut self, fits: bool, blamed: &[&AuditedCell], message: impl FnOnce() -> String) {
        self.compare_or(fits, blamed, Excuse::default(), message);
    }

    /// Records a comparison with an excuse in addition to the errata of the blamed cells.
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

    /// Records a comparison that is impossible because a cell is absent or no number; it always counts as a deviation.
    pub(super) fn absent(&mut self, what: impl fmt::Display) {
        self.compare(false, &[], || format!("cannot be checked: {what}"));
    }

    /// Iterates over the unexplained deviations.
    pub(super) fn unexplained(&self) -> impl Iterator<Item = &Deviation> {
        self.deviations.iter().filter(|deviation| !deviation.is_explained())
    }
}

impl Tally {
    /// Returns the messages of the unexplained deviations.
    pub(super) fn findings(&self) -> Vec<String> {
        self.unexplained().map(ToString::to_string).collect()
    }
}
