//! Results of the checks of one actuator.

use crate::check::{Check, CheckId};
use std::slice::Iter;
use std::sync::Arc;

/// Results of the checks of one actuator, in the order in which they are judged.
///
/// Neighbours in the catalogue share the results that depend on their drivetrain or their output bearing alone.
#[derive(Clone, Debug, Default)]
pub struct Checks {
    own: Vec<Check>,
    shared: [Arc<[Check]>; 2],
}

impl Checks {
    /// Creates the results that an actuator shares with others, each list in order, with room for others.
    pub(crate) fn sharing(shared: [Arc<[Check]>; 2], capacity: usize) -> Self {
        Self { own: Vec::with_capacity(capacity), shared }
    }

    /// Returns the results of the actuator alone, to which others are added in their order.
    pub(crate) const fn own(&mut self) -> &mut Vec<Check> {
        &mut self.own
    }

    /// Returns an iterator over the results in their order.
    #[must_use]
    pub fn iter(&self) -> InOrder<'_> {
        let [drivetrain, bearing] = &self.shared;
        InOrder([self.own.iter(), drivetrain.iter(), bearing.iter()])
    }

    /// Returns an iterator over the results in any order, which costs less.
    pub(crate) fn unordered(&self) -> impl Iterator<Item = &Check> {
        let [drivetrain, bearing] = &self.shared;
        [&self.own[..], drivetrain, bearing].into_iter().flatten()
    }

    /// Returns the result of a check.
    #[must_use]
    pub fn of(&self, id: CheckId) -> Option<&Check> {
        self.unordered().find(|check| check.id == id)
    }

    /// Returns the number of results.
    #[must_use]
    pub fn len(&self) -> usize {
        self.iter().len()
    }

    /// Returns `true` if no check was made.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<'c> IntoIterator for &'c Checks {
    type Item = &'c Check;
    type IntoIter = InOrder<'c>;

    fn into_iter(self) -> InOrder<'c> {
        self.iter()
    }
}

/// Iterator over results in the order in which their checks are judged; see [`Checks::iter`].
#[derive(Clone, Debug)]
pub struct InOrder<'c>([Iter<'c, Check>; 3]);

impl<'c> Iterator for InOrder<'c> {
    type Item = &'c Check;

    fn next(&mut self) -> Option<&'c Check> {
        let next = |list: &&mut Iter<'c, Check>| list.as_slice().first().map_or(u8::MAX, |check| check.id as u8);
        self.0.iter_mut().min_by_key(next)?.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.0.iter().map(ExactSizeIterator::len).sum();
        (left, Some(left))
    }
}

impl ExactSizeIterator for InOrder<'_> {}
