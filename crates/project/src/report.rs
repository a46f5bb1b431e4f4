//! Faults of a file as they are found.

use crate::recovery::Replaced;
use crate::{Diagnostic, Fault, Hint};
use std::ops::Range as Span;

/// Number of faults listed one by one; further ones are counted, so that the cost stays proportional to the file.
const FAULTS_MOST: usize = 50;

/// Faults of a file, reported while it is read and while axes are built from it.
#[derive(Debug)]
pub struct FaultReport<'t, F = Fault> {
    text: &'t str,
    found: Vec<Diagnostic<F>>,
    /// The syntax had errors.
    damaged: bool,
    /// Lines that could not be read.
    unread: Vec<Replaced>,
    /// Number of faults in lines that could not be read, which are not reported.
    unread_faults: usize,
    /// Number of faults beyond those that are kept.
    more: usize,
}

impl<'t, F: From<Fault> + PartialEq> FaultReport<'t, F> {
    /// Creates a report without faults about a text.
    #[must_use]
    pub const fn new(text: &'t str) -> Self {
        Self { text, found: Vec::new(), damaged: false, unread: Vec::new(), unread_faults: 0, more: 0 }
    }

    /// Marks the syntax as faulty, with the lines that could not be read.
    pub(crate) fn damage(&mut self, unread: Vec<Replaced>) {
        self.damaged = true;
        self.unread = unread;
    }

    /// Returns the text of the file.
    #[must_use]
    pub const fn text(&self) -> &'t str {
        self.text
    }

    /// Returns `true` if the syntax had errors, so that keys that seem missing may be present.
    #[must_use]
    pub const fn is_damaged(&self) -> bool {
        self.damaged
    }

    /// Returns `true` if a line states a key of the table with a place, but could not be read.
    pub(crate) fn is_unread(&self, key: &str, table: &Span<usize>) -> bool {
        self.unread.iter().any(|line| line.states(key, table))
    }

    /// Returns `true` if further faults are only counted.
    pub(crate) const fn is_full(&self) -> bool {
        self.found.len() >= FAULTS_MOST
    }

    /// Returns the number of faults reported so far.
    #[must_use]
    pub const fn fault_count(&self) -> usize {
        self.found.len() + self.more + self.unread_faults
    }

    /// Returns the faults in the order of the file, with a last one that counts those not listed.
    #[must_use]
    pub fn into_faults(mut self) -> Vec<Diagnostic<F>> {
        self.found.sort_by_key(|fault| (fault.span.start, fault.span.end));
        self.found.dedup();
        if self.more > 0 {
            let end = self.found.last().map_or(0, |fault| fault.span.start);
            let fault = Fault::More { count: self.more };
            self.found.push(Diagnostic::at(self.text, end..end, fault.into(), None));
        }
        self.found
    }

    /// Reports a fault at a place of the text, in bytes.
    pub fn fault(&mut self, span: Span<usize>, fault: impl Into<F>, hint: Option<Hint>) {
        // A line that could not be read has its fault of the syntax only.
        let is_unread = |Replaced { line, .. }: &Replaced| line.start <= span.start && span.start <= line.end;
        if !span.is_empty() && self.unread.iter().any(is_unread) {
            self.unread_faults += 1;
            return;
        }
        if self.is_full() {
            self.more += 1;
            return;
        }
        let end = span.end.min(self.text.len());
        let start = span.start.min(end);
        self.found.push(Diagnostic::at(self.text, start..end, fault.into(), hint));
    }

    /// Returns the report for faults of another kind, of which those so far are some.
    #[must_use]
    pub fn into_other<G: From<F>>(self) -> FaultReport<'t, G> {
        let Self { text, found, damaged, unread, unread_faults, more } = self;
        let found = found.into_iter().map(Diagnostic::into_other).collect();
        FaultReport { text, found, damaged, unread, unread_faults, more }
    }
}
