//! Result of one check, and those of all checks of an actuator.

use crate::notes::{Note, Notes};
use derivation::Step;
use numeric::{at_least, at_most};
use provenance::{Grade, Source};
use quantities::{Measure, Time, Unit, identified};
use std::slice::Iter;
use std::sync::Arc;

pub use crate::list::CheckId;

identified! {
    /// Required relation of a value to its limit.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Direction {
        /// Value ≤ limit; the utilisation is value by limit.
        AtMost = "at_most",
        /// Value ≥ limit; the utilisation is limit by value.
        AtLeast = "at_least",
    }
}

impl Direction {
    /// Returns `true` if a value keeps a limit, up to the rounding of both ([`numeric::AT_THE_LIMIT`]).
    #[must_use]
    pub fn keeps(self, value: f64, limit: f64) -> bool {
        match self {
            Self::AtMost => at_most(value, limit),
            Self::AtLeast => at_least(value, limit),
        }
    }

    /// Returns value over limit or limit over value; one that keeps the limit only up to rounding has a utilisation of
    /// one.
    #[must_use]
    pub(crate) fn share(self, value: f64, limit: f64) -> f64 {
        let share = match self {
            Self::AtMost => value / limit,
            Self::AtLeast => limit / value,
        };
        if self.keeps(value, limit) { share.min(1.0) } else { share }
    }

    /// Returns the required relation of a value to its limit: ≤ or ≥.
    #[must_use]
    pub const fn required(self) -> &'static str {
        match self {
            Self::AtMost => "≤",
            Self::AtLeast => "≥",
        }
    }

    /// Returns the true relation between a value and its limit: ≤, >, ≥ or <.
    #[must_use]
    pub fn relation(self, passes: bool, value: f64, limit: f64) -> &'static str {
        // A passed value keeps its limit, including one at the limit up to rounding.
        match self {
            Self::AtMost if passes || self.keeps(value.abs(), limit.abs()) => "≤",
            Self::AtMost => ">",
            Self::AtLeast if passes || self.keeps(value, limit) => "≥",
            Self::AtLeast => "<",
        }
    }
}

/// Meaning of the utilisation of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Margin {
    /// A share of the limit: the rest is a margin used by the ranking.
    Share,
    /// A share of a recommendation, which the ranking ignores.
    Recommendation,
    /// A class that is met or not, such as a voltage, without intermediate values.
    Class,
    /// A range with a limit at either end, in which a value has no share of a limit.
    Range,
}

identified! {
    /// Part of the actuator that a check is about.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[allow(missing_docs, reason = "the names say it")]
    pub enum Part {
        Drive = "drive",
        Thermal = "thermal",
        Energy = "energy",
        Gear = "gear",
        OutputBearing = "output_bearing",
        Brake = "brake",
        Feedback = "feedback",
        Screws = "screws",
        Environment = "environment",
    }
}

identified! {
    /// Verdict of a check.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Verdict {
        /// Inside the limit.
        Pass = "pass",
        /// Outside the limit.
        Fail = "fail",
        /// Inside every limit, but a recommendation is violated.
        Advice = "advice",
        /// A datum is missing; see [`Check::missing`].
        NotChecked = "not_checked",
    }
}

identified! {
    /// Verdict on an actuator as a whole, best first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Fit {
        /// No check fails.
        Fits = "fits",
        /// No check fails, but one is beyond its limit within the band of an estimate, or beyond a rating of another gear: it
        /// fits if the estimate holds.
        FitsIfEstimate = "fits_if_estimate",
        /// A check fails, or a requirement is not met.
        DoesNotFit = "does_not_fit",
    }
}

impl Fit {
    /// Returns `true` unless a check or requirement fails.
    #[must_use]
    pub const fn fits(self) -> bool {
        !matches!(self, Self::DoesNotFit)
    }
}

/// A number with its display unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// Value in SI.
    pub si: f64,
    /// Display unit.
    pub unit: &'static Unit,
}

impl Amount {
    /// Returns the value in its unit.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.unit.from_si(self.si)
    }
}

/// Result of one check, with all that is needed to verify it.
#[derive(Clone, Debug)]
pub struct Check {
    /// Identifier of the check.
    pub id: CheckId,
    /// Verdict.
    pub verdict: Verdict,
    /// Value required by the axis.
    pub value: Option<Amount>,
    /// Limit of the actuator.
    pub limit: Option<Amount>,
    /// |value| / |limit|; for a recommendation the same ratio.
    pub utilisation: Option<f64>,
    /// Instant of the worst case within the cycle.
    pub at: Option<Time>,
    /// Worst grade among the inputs.
    pub grade: Option<Grade>,
    /// Source of the value.
    pub value_source: Option<Source>,
    /// Source of the limit.
    pub limit_source: Option<Source>,
    /// Symbol of the missing datum.
    pub missing: Option<&'static str>,
    /// Remarks.
    pub notes: Notes,
    /// Derivation of value and limit; empty unless an explanation is requested.
    pub workings: Box<[Step]>,
}

impl Check {
    /// Returns the required relation of the value to the limit. Of the two limits of a range the nearer one is
    /// compared.
    #[must_use]
    pub fn direction(&self) -> Direction {
        match (self.id.margin(), self.value, self.limit) {
            (Margin::Range, Some(value), Some(limit)) if self.verdict == Verdict::Fail => {
                if value.si < limit.si {
                    Direction::AtLeast
                } else {
                    Direction::AtMost
                }
            }
            _ => self.id.direction(),
        }
    }

    /// Returns `true` if the check is beyond its limit without failing: within the band of an estimate, or beyond a rating of
    /// another gear.
    #[must_use]
    pub fn is_inside_band(&self) -> bool {
        self.verdict == Verdict::Advice && self.id.has_margin() && self.utilisation.is_some_and(|share| share > 1.0)
    }

    /// Returns `true` if the project states no limit for the check: its value is shown, if it is known, and not judged.
    #[must_use]
    pub fn is_without_limit(&self) -> bool {
        let lacks_limit = || self.missing.is_some() && self.missing == self.id.limit_key();
        self.verdict == Verdict::NotChecked && (self.value.is_some() || lacks_limit())
    }

    /// Returns `true` if the check lacks a datum.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.verdict == Verdict::NotChecked && !self.is_without_limit()
    }

    /// Returns the utilisation by which checks are compared: infinite for a failing check without one, whose limit is
    /// zero or a range.
    #[must_use]
    pub fn severity(&self) -> f64 {
        match self.utilisation {
            None if self.verdict == Verdict::Fail => f64::INFINITY,
            share => share.unwrap_or(0.0),
        }
    }

    /// Returns `true` if the limit is a rating of another manufacturer's gear: it is advice and rejects no actuator.
    #[must_use]
    pub fn is_of_another_gear(&self) -> bool {
        self.notes.contains(&Note::RatingOfInterchangeableGear)
            && !self.limit_source.as_ref().is_some_and(Source::is_of_the_user)
    }

    /// Returns value over the edge above which the check fails: its utilisation; for an estimate, that by the upper edge
    /// of its band. `None` without a utilisation, and for a limit that is a rating of another gear, which rejects no
    /// actuator.
    #[must_use]
    pub fn share_of_failure(&self) -> Option<f64> {
        if self.is_of_another_gear() {
            return None;
        }
        self.utilisation_band().map(|[by_upper_edge, _]| by_upper_edge).or(self.utilisation)
    }

    /// Returns the utilisations by the upper and by the lower edge of an estimated limit, or by the worst single instant and
    /// by the largest loads of different instants combined, the smaller one first; the second is [`Check::utilisation`].
    /// `None` without a band.
    #[must_use]
    pub fn utilisation_band(&self) -> Option<[f64; 2]> {
        let (share, limit) = (self.utilisation?, self.limit?.si);
        let noted = |of: fn(&Note) -> Option<f64>| self.notes.iter().find_map(of);
        if let Some(alone) = noted(|note| if let Note::AtOneInstant(alone) = note { Some(alone.si) } else { None }) {
            return Some([self.direction().share(alone, limit), share]);
        }
        let upper = noted(|note| match note {
            Note::EstimatedUpTo(upper) | Note::PermittedByCurve(upper) => Some(upper.si),
            _ => None,
        })?;
        // The utilisation of a temperature is that of its rise.
        let zero = noted(|note| if let Note::RiseAbove(zero) = note { Some(zero.si()) } else { None }).unwrap_or(0.0);
        let ratio = (limit - zero) / (upper - zero);
        (ratio > 0.0).then_some([share * ratio, share])
    }

    /// Returns the rank of the check in a list, the most important first: failed, advised, not checked, passed, shown
    /// without a limit; within each, checks with a margin first, then the larger utilisation. Utilisations that are equal
    /// up to the rounding of the machine are equal, so that the order of a list is the same on every machine.
    #[must_use]
    pub fn importance(&self) -> impl Ord + use<> {
        let class = match self.verdict {
            Verdict::Fail => 0_u8,
            Verdict::Advice => 1,
            Verdict::NotChecked if self.is_open() => 2,
            Verdict::Pass => 3,
            Verdict::NotChecked => 4,
        };
        let has_no_margin = !(self.verdict == Verdict::Fail || self.id.has_margin() && self.utilisation.is_some());
        (class, has_no_margin, std::cmp::Reverse(crate::rank::up_to_rounding(self.severity())))
    }

    /// Returns the true relation between value and limit: ≤, >, ≥ or <; `None` if one of them is missing.
    #[must_use]
    pub fn relation(&self) -> Option<&'static str> {
        Some(self.direction().relation(self.verdict == Verdict::Pass, self.value?.si, self.limit?.si))
    }
}

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
