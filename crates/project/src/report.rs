//! Faults of a file as they are found.

use crate::recovery::Damage;
use crate::{Diagnostic, Fault, Hint};
use std::ops::Range as Span;

/// Number of faults listed one by one; further ones are counted, so that the cost stays proportional to the file.
const FAULTS_MOST: usize = 50;

/// Faults of a file, reported while it is read and while axes are built from it.
#[derive(Debug)]
pub struct FaultReport<'t, F = Fault> {
    text: &'t str,
    found: Vec<Found<F>>,
    /// Places that could not be read; `None` if the syntax has no fault.
    damage: Option<Damage>,
    /// Byte at which reading stopped because of too many faults.
    stopped: Option<usize>,
    /// Number of faults in lines that could not be read, which are not reported.
    unread_faults: usize,
    /// Number of faults beyond those that are kept.
    more: usize,
    /// Start of the last fault that is listed so far, if some are not.
    last: usize,
}

/// A fault with its place and hint.
type Found<F> = (Span<usize>, F, Option<Hint>);

impl<'t, F: From<Fault> + PartialEq> FaultReport<'t, F> {
    /// Creates a report without faults about a text.
    #[must_use]
    pub const fn new(text: &'t str) -> Self {
        Self { text, found: Vec::new(), damage: None, stopped: None, unread_faults: 0, more: 0, last: usize::MAX }
    }

    /// Marks the syntax as faulty, with the places that could not be read, and where reading stopped.
    pub(crate) fn damage(&mut self, damage: Damage, stopped: Option<usize>) {
        self.damage = Some(damage);
        self.stopped = stopped;
    }

    /// Returns the text of the file.
    #[must_use]
    pub const fn text(&self) -> &'t str {
        self.text
    }

    /// Returns `true` if the syntax had errors, so that keys that seem missing may be present.
    #[must_use]
    pub const fn is_damaged(&self) -> bool {
        self.damage.is_some()
    }

    /// Returns `true` if a key or value belongs to a statement that could not be read.
    pub(crate) fn is_unread(&self, span: &Span<usize>) -> bool {
        self.damage.as_ref().is_some_and(|damage| damage.is_unread(span))
    }

    /// Returns `true` if a part of a list could not be read.
    pub(crate) fn is_partial(&self, span: &Span<usize>) -> bool {
        self.damage.as_ref().is_some_and(|damage| damage.is_partial(span))
    }

    /// Returns `true` if a name is that of a damaged heading.
    pub(crate) fn is_of_damaged_heading(&self, span: &Span<usize>) -> bool {
        self.damage.as_ref().is_some_and(|damage| damage.is_of_heading(span))
    }

    /// Returns `true` if a fault at a place would be listed; further faults are only counted.
    pub(crate) const fn is_listed(&self, at: usize) -> bool {
        at <= self.last
    }

    /// Returns the number of faults reported so far.
    #[must_use]
    pub const fn fault_count(&self) -> usize {
        self.found.len() + self.more + self.unread_faults
    }

    /// Returns the faults in the order of the file, with a last one that counts those not listed.
    #[must_use]
    pub fn into_faults(mut self) -> Vec<Diagnostic<F>> {
        self.keep_first();
        let text = self.text;
        let end = self.found.last().map_or(0, |(span, ..)| span.start);
        let more = (self.more > 0).then_some(Fault::More { count: self.more });
        let stopped = self.stopped.map(|at| Fault::ReadingStopped { line: crate::place(text, at).0 });
        let counted = more.map(|fault| (end, fault)).into_iter().chain(stopped.map(|fault| (end, fault)));
        let listed = self.found.into_iter().map(|(span, fault, hint)| Diagnostic::at(text, span, fault, hint));
        listed.chain(counted.map(|(end, fault)| Diagnostic::at(text, end..end, fault.into(), None))).collect()
    }

    /// Keeps the faults that are listed: the first ones in the order of the file.
    fn keep_first(&mut self) {
        self.found.sort_by_key(|(span, ..)| (span.start, span.end));
        self.found.dedup();
        if self.found.len() > FAULTS_MOST {
            self.more += self.found.len() - FAULTS_MOST;
            self.found.truncate(FAULTS_MOST);
            self.last = self.found.last().map_or(usize::MAX, |(span, ..)| span.start);
        }
    }

    /// Reports a fault at a place of the text, in bytes.
    pub fn fault(&mut self, span: Span<usize>, fault: impl Into<F>, hint: Option<Hint>) {
        // A line that could not be read has its fault of the syntax only.
        if self.damage.as_ref().is_some_and(|damage| damage.hides(&span)) {
            self.unread_faults += 1;
            return;
        }
        // A place in a damaged line may lie within a character.
        let end = self.text.ceil_char_boundary(span.end.min(self.text.len()));
        let start = self.text.floor_char_boundary(span.start.min(end));
        if !self.is_listed(start) {
            self.more += 1;
            return;
        }
        self.found.push((start..end, fault.into(), hint));
        if self.found.len() >= 2 * FAULTS_MOST {
            self.keep_first();
        }
    }

    /// Returns the report for faults of another kind, of which those so far are some.
    #[must_use]
    pub fn into_other<G: From<F>>(self) -> FaultReport<'t, G> {
        let Self { text, found, damage, stopped, unread_faults, more, last } = self;
        let found = found.into_iter().map(|(span, fault, hint)| (span, fault.into(), hint)).collect();
        FaultReport { text, found, damage, stopped, unread_faults, more, last }
    }
}
