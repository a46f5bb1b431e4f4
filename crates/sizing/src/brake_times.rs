//! Dwells held by the brake: the times in which the motor holds the load, the number of brakings, and the open time of
//! the brake.

use crate::axis::Axis;
use motion::{Hold, Motion};
use quantities::{Measure, Ratio, Time};
use trace::Carried;

/// Switching times of the brake of an axis, equal for every candidate, so that the demand is computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrakeTimes {
    /// t_c: time to close.
    pub closing: Time,
    /// t_o: time to open.
    pub opening: Time,
}

/// Returns the times at the beginning and at the end of a dwell in which the motor holds the load although the brake is
/// to hold it.
///
/// t_c at the beginning, until the brake has closed, and t_o at the end, while it opens; the whole dwell if it is
/// shorter than both. If the brake also holds the segment before or after, it stays closed between them.
///
/// # Source
/// docs/theory/brake.md
fn held_by_the_motor(motion: &Motion, segment: usize, times: &BrakeTimes) -> (f64, f64) {
    let stretches = motion.stretches();
    let is_held = |index: usize| stretches.get(index).is_some_and(|stretch| stretch.hold == Hold::Brake);
    let last = stretches.len().saturating_sub(1);
    // The cycle repeats: its first segment follows its last.
    let before = segment.checked_sub(1).unwrap_or(last);
    let after = if segment == last { 0 } else { segment + 1 };
    let alone = |neighbour: usize| neighbour == segment || !is_held(neighbour);
    let duration = stretches.get(segment).map_or(0.0, |stretch| stretch.duration.si());
    let closing = if alone(before) { times.closing.si() } else { 0.0 };
    let opening = if alone(after) { times.opening.si() } else { 0.0 };
    if closing + opening >= duration { (duration, 0.0) } else { (closing, opening) }
}

/// Returns the holding times of the motor in each segment at rest.
pub(crate) fn carried(motion: &Motion, times: Option<&BrakeTimes>) -> Vec<Carried> {
    (0..motion.stretches().len()).map(|segment| carried_in(motion, segment, times)).collect()
}

/// Returns the holding times of the motor in a segment at rest: until the brake has closed and while it opens; the
/// whole segment without a brake.
pub(crate) fn carried_in(motion: &Motion, segment: usize, times: Option<&BrakeTimes>) -> Carried {
    match (motion.stretches().get(segment).map_or(Hold::Motor, |stretch| stretch.hold), times) {
        (Hold::Brake, Some(times)) => {
            let (closing, opening) = held_by_the_motor(motion, segment, times);
            Carried::AtItsEnds { first: Time::from_si(closing), last: Time::from_si(opening) }
        }
        (Hold::Motor | Hold::Brake, _) => Carried::Throughout,
        (Hold::Free, _) => Carried::Never,
    }
}

/// Duty of the brake in a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Brakings {
    /// Number of times that the brake closes in one cycle.
    pub(crate) each_cycle: f64,
    /// Shortest dwell that is too short for the brake to close and to open again.
    pub(crate) too_short: Option<Time>,
}

/// Counts the brakings: the brake closes once in each sequence of dwells that it holds, unless they are too short.
pub(crate) fn brakings(axis: &Axis) -> Brakings {
    let stretches = axis.motion.stretches();
    let mut found = Brakings { each_cycle: 0.0, too_short: None };
    let Some(times) = &axis.brake_times else { return found };
    for (index, stretch) in stretches.iter().enumerate().filter(|(_, stretch)| stretch.hold == Hold::Brake) {
        let (closing, opening) = held_by_the_motor(&axis.motion, index, times);
        if closing + opening >= stretch.duration.si() {
            let shorter = found.too_short.is_none_or(|shortest| stretch.duration.si() < shortest.si());
            found.too_short = if shorter { Some(stretch.duration) } else { found.too_short };
        }
        // A brake that is switched off counts, independent of how soon it is switched on again.
        if closing > 0.0 {
            found.each_cycle += 1.0;
        }
    }
    found
}

impl Axis {
    /// Returns the share of the cycle in which the brake is kept open and its coil draws current.
    ///
    /// s = 1 − Σ (t_d − t_o)/t_0 over the dwells t_d that the brake holds: the coil is without current from the beginning
    /// of such a dwell until the brake begins to open
    #[must_use]
    pub fn brake_open_share(&self) -> Ratio {
        let Some(times) = &self.brake_times else { return Ratio::from_si(1.0) };
        let stretches = self.motion.stretches().iter().enumerate();
        let closed: f64 = stretches
            .filter(|(_, stretch)| stretch.hold == Hold::Brake)
            .map(|(index, stretch)| match held_by_the_motor(&self.motion, index, times) {
                // The dwell is too short to close the brake: the coil stays on.
                (closing, opening) if closing + opening >= stretch.duration.si() => 0.0,
                (_, opening) => stretch.duration.si() - opening,
            })
            .sum();
        Ratio::from_si((1.0 - closed / self.moments().duration.si()).clamp(0.0, 1.0))
    }
}
