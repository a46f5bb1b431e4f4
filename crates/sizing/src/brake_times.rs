//! Dwells held by the brake: the times in which the motor holds the load, the number of brakings, and the open time of
//! the brake.

use crate::axis::Axis;
use actuator::Brake;
use motion::{Hold, Motion, Stretch};
use provenance::Datum;
use quantities::{Measure, Ratio, Time};
use std::sync::{Arc, Mutex, PoisonError};
use trace::Carried;

/// Switching times of the brakes for which the demand of an axis is computed: those of the catalogue, equal for every
/// actuator whose brake does not state others (`Axis::braked_by`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrakeTimes {
    /// t_c: time to close.
    pub closing: Time,
    /// t_o: time to open.
    pub opening: Time,
}

impl BrakeTimes {
    /// Returns the times of a brake: what it does not state is taken from those of the catalogue.
    fn of(brake: &Brake, of_catalogue: Option<Self>) -> Option<Self> {
        let stated = |time: &Datum<Time>| time.known().map(|known| known.value);
        let closing = stated(&brake.closing_time).or(of_catalogue.map(|times| times.closing));
        let opening = stated(&brake.opening_time).or(of_catalogue.map(|times| times.opening));
        Some(Self { closing: closing?, opening: opening? })
    }

    /// Returns `true` if the times of a brake are not those of the catalogue.
    pub(crate) fn are_others(brake: &Brake, of_catalogue: Option<Self>) -> bool {
        Self::of(brake, of_catalogue).is_some_and(|times| of_catalogue != Some(times))
    }
}

/// An axis with other brakes, by their times, as far as it was needed.
///
/// A copy of an axis, which may then be changed, has none.
#[derive(Debug, Default)]
pub(crate) struct OtherBrakes(Mutex<Vec<(BrakeTimes, Arc<Axis>)>>);

impl Clone for OtherBrakes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl OtherBrakes {
    fn get(&self, times: BrakeTimes, make: impl FnOnce() -> Axis) -> Arc<Axis> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, axis)) = known.iter().find(|(of, _)| *of == times) {
            return Arc::clone(axis);
        }
        let axis = Arc::new(make());
        known.push((times, Arc::clone(&axis)));
        axis
    }
}

/// A segment of a rest that the brake holds: of consecutive dwells, over which it stays closed, also across the end of the
/// cycle.
#[derive(Clone, Copy, Debug)]
struct Held {
    /// Time from the beginning of the segment in which the motor holds the load \[s\].
    first_s: f64,
    /// Time to the end of the segment in which the motor holds the load \[s\].
    last_s: f64,
    /// Duration of the rest \[s\].
    rest_s: f64,
    /// The rest begins with this segment.
    is_first: bool,
}

/// Returns the segments that the brake holds, with the times in which the motor holds the load nevertheless; `None` for the
/// others.
///
/// 0 … t_c of a rest, until the brake has closed, and t_r − t_o … t_r, while it opens; the whole rest if
/// t_r ≤ t_c + t_o. How a rest is divided into segments is of no effect.
///
/// # Source
/// docs/theory/brake.md
fn held(motion: &Motion, times: &BrakeTimes) -> Vec<Option<Held>> {
    let stretches = motion.stretches();
    let (closing, opening) = (times.closing.si(), times.opening.si());
    let count = stretches.len();
    let is_held = |index: usize| stretches.get(index).is_some_and(|stretch| stretch.hold == Hold::Brake);
    let duration = |index: usize| stretches.get(index).map_or(0.0, |stretch| stretch.duration.si());
    let mut found = vec![None; count];
    // The cycle repeats: a rest at its end goes on at its beginning. One that lasts the whole cycle begins with it.
    let begin = (0..count).find(|index| !is_held(*index)).unwrap_or(0);
    let mut at = begin;
    while at < begin + count {
        let rest: Vec<usize> =
            (at..begin + count).map(|index| index % count).take_while(|index| is_held(*index)).collect();
        let rest_s: f64 = rest.iter().map(|index| duration(*index)).sum();
        let is_short = closing + opening >= rest_s;
        let mut before_s = 0.0;
        for index in &rest {
            let own_s = duration(*index);
            let after_s = rest_s - before_s - own_s;
            let first_s = if is_short { own_s } else { (closing - before_s).clamp(0.0, own_s) };
            let last_s = if is_short { 0.0 } else { (opening - after_s).clamp(0.0, own_s - first_s) };
            if let Some(place) = found.get_mut(*index) {
                *place =
                    Some(Held { first_s, last_s, rest_s, is_first: before_s == 0.0 && rest.first() == Some(index) });
            }
            before_s += own_s;
        }
        at += rest.len().max(1);
    }
    found
}

/// Returns the holding times of the motor in each segment at rest: until the brake has closed and while it opens; the
/// whole segment without a brake.
pub(crate) fn carried(motion: &Motion, times: Option<&BrakeTimes>) -> Vec<Carried> {
    let held = times.map(|times| held(motion, times)).unwrap_or_default();
    let of = |(index, stretch): (usize, &Stretch)| match (stretch.hold, held.get(index).copied().flatten()) {
        (Hold::Brake, Some(Held { first_s, last_s, .. })) => {
            Carried::AtItsEnds { first: Time::from_si(first_s), last: Time::from_si(last_s) }
        }
        (Hold::Motor | Hold::Brake, _) => Carried::Throughout,
        (Hold::Free, _) => Carried::Never,
    };
    motion.stretches().iter().enumerate().map(of).collect()
}

/// Duty of the brake in a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Brakings {
    /// Number of times that the brake closes in one cycle.
    pub(crate) each_cycle: f64,
    /// Shortest rest that is too short for the brake to close and to open again.
    pub(crate) too_short: Option<Time>,
}

/// Returns the durations of the rests that the brake holds \[s\].
fn rests(motion: &Motion, times: &BrakeTimes) -> Vec<f64> {
    held(motion, times).into_iter().flatten().filter(|held| held.is_first).map(|held| held.rest_s).collect()
}

/// Counts the brakings: the brake closes once in each rest that it holds. One that is switched off counts, independent of
/// how soon it is switched on again.
pub(crate) fn brakings(axis: &Axis) -> Brakings {
    let Some(times) = &axis.brake_times else { return Brakings { each_cycle: 0.0, too_short: None } };
    let rests = rests(&axis.motion, times);
    let short = rests.iter().copied().filter(|rest| times.closing.si() + times.opening.si() >= *rest);
    #[allow(clippy::cast_precision_loss, reason = "far fewer than 2⁵³ segments")]
    let each_cycle = rests.len() as f64;
    Brakings { each_cycle, too_short: short.min_by(f64::total_cmp).map(Time::from_si) }
}

impl Axis {
    /// Returns the axis as a brake that states times of its own holds it; `None` if it is this axis.
    ///
    /// T_rms, currents and heat depend on how long the motor holds the load while the brake closes and opens.
    pub(crate) fn braked_by(&self, brake: &Brake) -> Option<Arc<Self>> {
        if !BrakeTimes::are_others(brake, self.brake_times) {
            return None;
        }
        let times = BrakeTimes::of(brake, self.brake_times)?;
        if !self.motion.stretches().iter().any(|stretch| stretch.hold == Hold::Brake) {
            return None;
        }
        Some(self.other_brakes.get(times, || {
            let (mechanism, motion, extras) = (self.mechanism.clone(), self.motion.clone(), self.extras.clone());
            let axis = Self { brake_times: Some(times), ..self.clone() };
            axis.changed(mechanism, motion, extras)
        }))
    }

    /// Returns the share of the cycle in which the brake is kept open and its coil draws current.
    ///
    /// s = 1 − Σ (t_r − t_o)/t_0 over the rests t_r that the brake holds: the coil is without current from the beginning
    /// of such a rest until the brake begins to open
    #[must_use]
    pub fn brake_open_share(&self) -> Ratio {
        let Some(times) = &self.brake_times else { return Ratio::from_si(1.0) };
        let (closing, opening) = (times.closing.si(), times.opening.si());
        // In a rest that is too short to close the brake, the coil stays on.
        let without_current = |rest: f64| if closing + opening >= rest { 0.0 } else { rest - opening };
        let closed: f64 = rests(&self.motion, times).into_iter().map(without_current).sum();
        Ratio::from_si((1.0 - closed / self.moments().duration.si()).clamp(0.0, 1.0))
    }
}
