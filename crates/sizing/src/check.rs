//! The answer of one check.

use crate::notes::{Note, Notes};
use derivation::Step;
use numeric::{at_least, at_most};
use provenance::{Grade, Source};
use quantities::{Measure, Time, Unit, identified};

pub use crate::list::CheckId;

identified! {
    /// How a value must lie to its limit.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Direction {
        /// Value ≤ limit; the utilisation is value by limit.
        AtMost = "at_most",
        /// Value ≥ limit; the utilisation is limit by value.
        AtLeast = "at_least",
    }
}

impl Direction {
    /// Returns `true` if a value keeps a limit, which it does up to the rounding of both ([`numeric::AT_THE_LIMIT`]).
    #[must_use]
    pub fn keeps(self, value: f64, limit: f64) -> bool {
        match self {
            Self::AtMost => at_most(value, limit),
            Self::AtLeast => at_least(value, limit),
        }
    }

    /// Returns value over limit or limit over value; what keeps the limit but for rounding uses all of it, not more.
    #[must_use]
    pub(crate) fn share(self, value: f64, limit: f64) -> f64 {
        let share = match self {
            Self::AtMost => value / limit,
            Self::AtLeast => limit / value,
        };
        if self.keeps(value, limit) { share.min(1.0) } else { share }
    }

    /// The sign between a value and its limit that is true: ≤, >, ≥ or <.
    #[must_use]
    pub fn relation(self, passes: bool, value: f64, limit: f64) -> &'static str {
        // What passes keeps its limit, also where it is at it but for rounding.
        match self {
            Self::AtMost if passes || self.keeps(value.abs(), limit.abs()) => "≤",
            Self::AtMost => ">",
            Self::AtLeast if passes || self.keeps(value, limit) => "≥",
            Self::AtLeast => "<",
        }
    }
}

/// What the utilisation of a check says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Margin {
    /// A share of the limit: what is left is a margin that the ranking looks at.
    Share,
    /// That of a recommendation, which the ranking leaves out.
    Recommendation,
    /// Of a class that is met or not, such as a voltage: there is nothing between.
    Class,
    /// Of a range with a limit at either end, in which a value has no share of a limit.
    Range,
}

identified! {
    /// The part of the actuator that a check is about.
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
    /// The answer of a check.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Verdict {
        /// Inside the limit.
        Pass = "pass",
        /// Outside the limit.
        Fail = "fail",
        /// Inside every limit, but a recommendation is broken.
        Advice = "advice",
        /// A datum is missing; see [`Check::missing`].
        NotChecked = "not_checked",
    }
}

identified! {
    /// The verdict on an actuator as a whole, the best first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Fit {
        /// Nothing speaks against it.
        Fits = "fits",
        /// No check fails, but one is beyond its limit within the band of an estimate, or beyond a rating of another gear: it
        /// fits if the estimate holds.
        FitsIfEstimate = "fits_if_estimate",
        /// A check fails, or a requirement is not met.
        DoesNotFit = "does_not_fit",
    }
}

impl Fit {
    /// Returns `true` unless something speaks against it.
    #[must_use]
    pub const fn fits(self) -> bool {
        !matches!(self, Self::DoesNotFit)
    }
}

/// A number with the unit that people read it in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// Value in SI.
    pub si: f64,
    /// Unit to show it in.
    pub unit: &'static Unit,
}

impl Amount {
    /// The value in its unit.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.unit.from_si(self.si)
    }
}

/// The answer of one check, with everything needed to question it.
#[derive(Clone, Debug)]
pub struct Check {
    /// Which check.
    pub id: CheckId,
    /// Its answer.
    pub verdict: Verdict,
    /// What the axis asks.
    pub value: Option<Amount>,
    /// What the actuator gives.
    pub limit: Option<Amount>,
    /// |value| / |limit|; for a recommendation the same ratio.
    pub utilisation: Option<f64>,
    /// Instant of the worst case within the cycle.
    pub at: Option<Time>,
    /// The worst grade among the inputs.
    pub grade: Option<Grade>,
    /// Where the value comes from.
    pub value_source: Option<Source>,
    /// Where the limit comes from.
    pub limit_source: Option<Source>,
    /// Symbol of the datum that is missing.
    pub missing: Option<&'static str>,
    /// Remarks.
    pub notes: Notes,
    /// How value and limit came about; empty unless an explanation is requested.
    pub workings: Box<[Step]>,
}

impl Check {
    /// How the value must lie to the limit. Of the two limits of a range the nearer one is compared.
    #[must_use]
    pub fn direction(&self) -> Direction {
        match (self.id.margin(), self.value, self.limit) {
            (Margin::Range, Some(value), Some(limit)) if self.verdict == Verdict::Fail && value.si < limit.si => {
                Direction::AtLeast
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

    /// Returns `true` if the check has a value and the project states no limit for it: it is shown, not judged.
    #[must_use]
    pub fn is_without_limit(&self) -> bool {
        self.verdict == Verdict::NotChecked && self.value.is_some()
    }

    /// Returns `true` if the check lacks a datum.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.verdict == Verdict::NotChecked && self.value.is_none()
    }

    /// Utilisation by which checks are compared: infinite where a failing check has none, since its limit is zero or a range.
    #[must_use]
    pub fn severity(&self) -> f64 {
        match self.utilisation {
            None if self.verdict == Verdict::Fail => f64::INFINITY,
            share => share.unwrap_or(0.0),
        }
    }

    /// Value over the edge above which the check fails: its utilisation, of an estimate that by the upper edge of its band.
    /// `None` where it has none, and where the limit is a rating of another gear, which rejects nothing.
    #[must_use]
    pub fn share_of_failure(&self) -> Option<f64> {
        let is_advice_only = self.notes.contains(&Note::RatingOfInterchangeableGear)
            && !matches!(self.limit_source, Some(Source::Project { .. }));
        if is_advice_only {
            return None;
        }
        let (share, limit) = (self.utilisation?, self.limit?.si);
        let noted = |of: fn(&Note) -> Option<f64>| self.notes.iter().find_map(of);
        let upper = noted(|note| if let Note::EstimatedUpTo(upper) = note { Some(upper.si) } else { None });
        // The utilisation of a temperature is that of its rise.
        let zero = noted(|note| if let Note::RiseAbove(zero) = note { Some(zero.si()) } else { None }).unwrap_or(0.0);
        let widened = upper.map(|upper| (limit - zero) / (upper - zero)).filter(|ratio| *ratio > 0.0);
        Some(share * widened.unwrap_or(1.0))
    }

    /// The place of the check where checks are listed, the most important first: what fails, what is advised, what could not
    /// be checked, what passes, what is shown without a limit; within each what has a margin before what has none, and the
    /// larger utilisation first.
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
        (class, has_no_margin, std::cmp::Reverse(crate::rank::in_order(self.severity())))
    }

    /// The sign between value and limit that is true: ≤, >, ≥ or <; none where one of them is missing.
    #[must_use]
    pub fn relation(&self) -> Option<&'static str> {
        Some(self.direction().relation(self.verdict == Verdict::Pass, self.value?.si, self.limit?.si))
    }
}
