//! Rest by its size: disturbances of position and speed far below those of the motion.

use crate::grid::Grid;
use crate::stretch::{SMOOTH, range, runs, smooth_end, travelled};
use crate::white::range_without_noise;
use std::ops::Range;

/// Largest speed of a rest relative to the largest speed.
const SPEED_MOST: f64 = 0.05;

/// Largest range of positions of a rest with swings, relative to the range of the recording.
const SWING_MOST: f64 = 2.5e-4;

/// Largest range of positions of a rest with swings \[°\]: settling and noise as in the count of small swings.
const SWING_MOST_DEG: f64 = 0.1;

/// Largest range of positions of a rest in one direction, relative to the range of the recording.
const DRIFT_MOST: f64 = 5e-6;

/// Smallest number of changes of sign of a rest with swings: a reversal has one, a stop with overshoot two.
const TURNS_LEAST: usize = 3;

/// Largest range of the positions relative to ∫|ω|dt if the axis returns, instead of leaving its place with noise on top.
const RETURNS: f64 = 0.4;

/// Smallest duration of a rest relative to the time in which the motion reaches the largest speed of the rest.
const LONG: f64 = 20.0;

/// Smallest number of samples of a rest.
const REST_LEAST: usize = 8;

/// Ratio to the smallest speed so far at which a speed of one sign no longer belongs to the move before.
const RISES: f64 = 2.0;

/// Standard deviations of the noise by which a speed rises above the smallest so far.
const ABOVE_NOISE: f64 = 4.0;

/// Largest speed of the end of a move relative to the quiet speed of the run if it no longer falls.
const ABOVE_QUIET: f64 = 1.5;

/// Largest speed of a block of samples that are still falling, relative to that of the block before.
const FALLING: f64 = 0.9;

/// Change of a position in steps of its column that is none of a slow motion.
const ABOVE_STEP: f64 = 1.5;

/// Bound of the noise that the difference over two intervals carries from the first sample at rest into the last of the move,
/// in standard deviations of that at rest: 1.4 of its own.
const CARRIED: f64 = 1.0;

/// Largest speed of the first sample at rest relative to the speed at rest.
const AT_REST: f64 = 1.5;

/// Largest range of positions of a slow motion that may be meant as rest, relative to the range of the recording.
const SLOW_MOST: f64 = 10.0 * SWING_MOST;

/// Smallest share of the recording of slow motions that are reported.
const SLOW_LEAST: f64 = 0.02;

/// Largest slope at the end of a rest relative to the next one if the motion starts without a jump of the speed: a quarter
/// with a jump of the acceleration, a half with one of the speed.
const STARTS: f64 = 0.3;

/// Smallest standard deviation of uncorrelated noise relative to the largest speed at rest if that is white noise.
const WHITE: f64 = 0.3;

/// Largest number of samples by which the increments of a position correct the end of a rest.
const SHIFT_MOST: usize = 2;

/// Largest ratio of the last increment of a move to the one before if none is hidden in the noise, see [`by_increments`].
const HIDDEN_NONE: f64 = 0.25;

/// Ratio of the second increment of a move with a continuous acceleration to the first.
const SEVENTH: f64 = 7.0;

/// Number of samples after a move whose largest speed is that at rest there.
const LEVEL_OF: usize = 24;

/// Deviation of a smooth continuation relative to the speed at rest after it.
const ABRUPT: f64 = 0.1;

/// Deviation of a smooth continuation relative to the second difference of the move; where the acceleration of a move ends
/// without a jump, the first speed at rest, a difference over two intervals, deviates by a twelfth of it.
const ABRUPT_OF_MOVE: f64 = 0.05;

/// Ratio of the standard deviation of normally distributed values to the median of their magnitudes, 1/Φ⁻¹(3/4).
const OF_MEDIAN: f64 = 1.482_602_218_505_602;

/// Slow motion between moves, by so little that it may be meant as rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowMotion {
    /// Largest speed [rad/s].
    pub speed_rad_s: f64,
    /// Largest range of the positions of one stretch \[rad\].
    pub place_rad: f64,
    /// Time in motion of all stretches \[s\].
    pub duration_s: f64,
}

/// Returns the slow motion that counts as motion and is much smaller than the other moves, if it takes a significant time.
pub(crate) fn slow_motion(time: &[f64], speed: &[f64], position: Option<&[f64]>) -> Option<SlowMotion> {
    let travel = travel(time, speed, position);
    let is_small = |slow: &Slow| !slow.is_rest && slow.is_long && slow.place_rad <= SLOW_MOST * travel;
    let (mut sum, mut all) = (SlowMotion { speed_rad_s: 0.0, place_rad: 0.0, duration_s: 0.0 }, 0.0);
    for slow in slow(time, speed, position, false).into_iter().filter(is_small) {
        let times = time.get(slow.samples.clone()).unwrap_or_default();
        let speeds = speed.get(slow.samples.clone()).unwrap_or_default();
        // Between equal positions the axis is at rest: a count of the sensor to and fro moves it between two rows only.
        let moving = times.windows(2).zip(speeds.windows(2)).filter(|(_, ends)| *ends != [0.0; 2]);
        let moving_s: f64 =
            moving.map(|(ends, _)| ends.iter().rev().copied().reduce(|end, start| end - start).unwrap_or(0.0)).sum();
        sum = SlowMotion {
            speed_rad_s: sum.speed_rad_s.max(slow.speed_rad_s),
            place_rad: sum.place_rad.max(slow.place_rad),
            duration_s: sum.duration_s + moving_s,
        };
    }
    if let Some((first, last)) = time.first().zip(time.last()) {
        all = last - first;
    }
    (sum.duration_s > SLOW_LEAST * all).then_some(sum)
}

/// A stretch of slow samples between two moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slow {
    /// Samples.
    pub(crate) samples: Range<usize>,
    /// Largest speed [rad/s].
    pub(crate) speed_rad_s: f64,
    /// Range of the positions \[rad\].
    pub(crate) place_rad: f64,
    /// The stretch is much longer than the motion takes to reach its largest speed.
    pub(crate) is_long: bool,
    /// The axis is at rest.
    pub(crate) is_rest: bool,
}

/// Returns the slow stretches of a motion between its moves, with the verdict whether the axis rests.
///
/// |ω| ≤ ω_max/20, t ≥ 20 ω_s Δq/ω_max², and either Δq_s ≤ 5·10⁻⁶ Δq, or Δq_s ≤ 2.5·10⁻⁴ Δq ≤ 0.1° with three changes of
/// sign and Δq_s ≤ 0.4 ∫|ω|dt
///
/// # Symbols
/// ω_max largest speed of the recording, Δq range of its positions; t duration of the stretch, ω_s its largest speed, Δq_s range
/// of its positions
/// # Source
/// own choice, docs/theory/recorded-motion.md#standstill
/// # Valid
/// friction does not act as in motion: disturbances of this size are settling, hum and noise of sensor or control
pub(crate) fn slow(time: &[f64], speed: &[f64], position: Option<&[f64]>, differentiated: bool) -> Vec<Slow> {
    let most = largest(speed);
    let travel = travel(time, speed, position);
    if most <= 0.0 || travel <= 0.0 {
        return Vec::new();
    }
    let step = position.map_or(0.0, |position| Grid::of(position).step);
    let mut found = Vec::new();
    for run in runs(speed, 0..speed.len(), SPEED_MOST * most) {
        let between = between_moves(speed, &run, differentiated);
        let between = between.map(|samples| match position.filter(|_| differentiated) {
            Some(position) => by_increments(&samples, &run, position),
            None => samples,
        });
        let Some(samples) = between.filter(|samples| samples.len() >= REST_LEAST) else { continue };
        let (Some(times), Some(speeds)) = (time.get(samples.clone()), speed.get(samples.clone())) else { continue };
        let speed_rad_s = largest(speeds);
        if speed_rad_s == 0.0 {
            continue;
        }
        let positions = position.and_then(|position| position.get(samples.clone()));
        let place_rad = match positions {
            Some(positions) if !differentiated => range_without_noise(positions),
            positions => self::travel(times, speeds, positions),
        };
        let duration = times.first().zip(times.last()).map_or(0.0, |(first, last)| last - first);
        let is_long = duration >= LONG * speed_rad_s * travel / (most * most);
        let sizes: Vec<f64> = speeds.iter().map(|speed| speed.abs()).collect();
        let way = travelled(times, &sizes).last().unwrap_or(0.0);
        let swings = turns(speeds) >= TURNS_LEAST
            && place_rad <= RETURNS * way
            && place_rad <= (SWING_MOST * travel).min(SWING_MOST_DEG.to_radians()).max(2.0 * step);
        let is_rest = is_long && (swings || place_rad <= DRIFT_MOST * travel);
        found.push(Slow { samples, speed_rad_s, place_rad, is_long, is_rest });
    }
    found
}

/// Sets the slopes of positions at the first and the last sample of each rest to zero.
///
/// Between two equal positions of a rest nothing moves, so that the speed at both is zero; the slope over two intervals
/// contains that of the move beside. A position that leaves the rest by a step of its column or less may belong to a slow
/// motion, and one that jumps needs the slope for its travel: both keep it.
pub(crate) fn stop_at_rests(speed: &mut [f64], position: &[f64]) {
    let step = Grid::of(position).step;
    let rests: Vec<Range<usize>> =
        runs(speed, 0..speed.len(), 0.0).into_iter().filter(|rest| rest.len() >= REST_LEAST).collect();
    let at = |index: Option<usize>| index.and_then(|index| position.get(index)).copied();
    for rest in rests {
        let (first, last) = (rest.start.checked_sub(1), Some(rest.end));
        for (end, inside, next) in [
            (first, Some(rest.start), first.and_then(|first| first.checked_sub(1))),
            (last, rest.end.checked_sub(1), last.map(|last| last + 1)),
        ] {
            let (Some(at_end), Some(inside), Some(beyond)) = (at(end), at(inside), at(next)) else { continue };
            let slope = |index: Option<usize>| index.and_then(|index| speed.get(index)).map_or(0.0, |w| w.abs());
            let starts = slope(end) <= STARTS * slope(next);
            let is_end = at_end == inside && starts && (beyond - at_end).abs() > ABOVE_STEP * step;
            if let Some(speed) = end.filter(|_| is_end).and_then(|end| speed.get_mut(end)) {
                *speed = 0.0;
            }
        }
    }
}

/// Returns the range of the positions, or of the travel.
fn travel(time: &[f64], speed: &[f64], position: Option<&[f64]>) -> f64 {
    position.map_or_else(|| range(travelled(time, speed)), |position| range(position.iter().copied()))
}

fn largest(speeds: &[f64]) -> f64 {
    speeds.iter().fold(0.0, |most, speed| most.max(speed.abs()))
}

/// Returns the number of changes of sign.
fn turns(speeds: &[f64]) -> usize {
    let moving = || speeds.iter().filter(|speed| **speed != 0.0);
    moving().zip(moving().skip(1)).filter(|(one, other)| (**one < 0.0) != (**other < 0.0)).count()
}

/// Returns a run of slow samples without the ends of the moves before and after it; `None` if nothing is left.
fn between_moves(speed: &[f64], run: &Range<usize>, differentiated: bool) -> Option<Range<usize>> {
    let speeds = speed.get(run.clone())?;
    let noise = noise(speeds);
    let ends = Ends { noise, carried: if differentiated { CARRIED * noise } else { 0.0 }, quiet: quiet(speeds) };
    let outside = SMOOTH.min(run.start);
    let from_before = speed.get(run.start - outside..run.end)?;
    let first = ends.of_move(from_before.iter().copied(), outside);
    let beyond = SMOOTH.min(speed.len() - run.end);
    let from_after = speed.get(run.start..run.end + beyond)?;
    let last = ends.of_move(from_after.iter().rev().copied(), beyond);
    (first + last < speeds.len()).then(|| run.start + first..run.end - last)
}

/// Returns the samples at rest of a position with noise, from the first to the last one beside which it stays: where the first
/// increment of the move is seen, it shows the end to the sample, other than the difference over two intervals.
///
/// a > 4 σ and a < b/4, or a > 28 σ
///
/// # Symbols
/// a, b amounts of the increments of the move next to the rest and before it, σ standard deviation of those at rest
/// # Valid
/// The increments of a move grow from rest as 1, 3, 5 with a jump of the acceleration and as 1, 7, 19 without: none is hidden where
/// the ratio is below a quarter, or where a seventh would be seen. Elsewhere the end is known to an interval only, and T_rms of n ends
/// to ½ n h M²/∫M² dt with the torque M at the end, since friction acts or does not act in it.
fn by_increments(samples: &Range<usize>, run: &Range<usize>, position: &[f64]) -> Range<usize> {
    let step = |at: usize| Some((position.get(at + 1)? - position.get(at)?).abs());
    let inside: Vec<f64> = (samples.start..samples.end.saturating_sub(1)).filter_map(step).collect();
    let limit = ABOVE_NOISE * OF_MEDIAN * median(inside);
    if limit <= 0.0 {
        return samples.clone();
    }
    // The first sample of the rest, by the increment behind it and the two before it.
    let is_first = |[quiet, last, before]: [Option<f64>; 3]| {
        let (Some(quiet), Some(last), Some(before)) = (quiet, last, before) else { return false };
        quiet <= limit && last > limit && (last < HIDDEN_NONE * before || last > SEVENTH * limit)
    };
    let first =
        (samples.start.saturating_sub(SHIFT_MOST).max(run.start)..=samples.start + SHIFT_MOST).rev().find(|at| {
            let below = |by: usize| at.checked_sub(by).and_then(step);
            is_first([step(*at), below(1), below(2)])
        });
    let last = samples.end.saturating_sub(1);
    let last_of = (last.saturating_sub(SHIFT_MOST)..=(last + SHIFT_MOST).min(run.end.saturating_sub(1)))
        .find(|at| is_first([at.checked_sub(1).and_then(step), step(*at), step(at + 1)]));
    let found = first.unwrap_or(samples.start)..last_of.map_or(samples.end, |last| last + 1);
    if found.is_empty() { samples.clone() } else { found }
}

/// Speeds of a run of slow samples by which the ends of the moves at it are found.
struct Ends {
    /// Standard deviation of uncorrelated noise [rad/s].
    noise: f64,
    /// Standard deviation of the noise that a difference carries from the rest into the move [rad/s].
    carried: f64,
    /// Largest speed of quiet samples [rad/s].
    quiet: f64,
}

impl Ends {
    /// Returns the number of slow samples that belong to the move before them; the first `outside` speeds are those of the
    /// move.
    ///
    /// A smooth move is continued by the cubic through its last four samples, to within a tenth of the speeds at rest after
    /// it. A move with noise ends by [`Self::of_noisy_move`].
    fn of_move(&self, speeds: impl ExactSizeIterator<Item = f64> + Clone, outside: usize) -> usize {
        let count = speeds.len() - outside;
        let Some(moving) = speeds.clone().take(outside).last() else { return 0 };
        let roughly = self.of_noisy_move(moving, speeds.clone().skip(outside), count);
        let level = speeds.clone().skip(outside + roughly).take(LEVEL_OF).fold(0.0_f64, |most, w| most.max(w.abs()));
        let bend = bend(speeds.clone().take(outside));
        let near = (ABRUPT * level + self.carried).max(ABRUPT_OF_MOVE * bend);
        let smooth = smooth_end(speeds.clone(), outside, near).filter(|end| 2 * end <= count);
        // A move that is not smooth enough to be continued is left while it is still fast.
        let is_at_rest = |end: &usize| {
            let first = speeds.clone().nth(outside + end).unwrap_or(0.0);
            first.abs() <= AT_REST * level + bend
        };
        let Some(end) = smooth.filter(is_at_rest) else { return roughly };
        // The last sample of a move that ends between two samples has half of its second difference at most.
        let last = end.checked_sub(1).and_then(|last| speeds.clone().nth(outside + last));
        let is_rest = last.is_some_and(|last| last.abs() <= level.min(0.5 * bend));
        // Of white noise the last sample of the move has a part.
        end - usize::from(is_rest) + usize::from(self.carried > WHITE * level)
    }

    /// Returns the number of slow samples that belong to the move before them: those up to the first at zero or with the other
    /// sign, up to the slowest before the speed rises again, or up to the slowest of the first quiet block that no longer
    /// falls. All of them if the speed falls to the end.
    fn of_noisy_move(&self, moving: f64, speeds: impl Iterator<Item = f64>, all: usize) -> usize {
        let (mut slowest, mut least) = (0, moving.abs());
        let (mut slow, mut most, mut most_before) = (0, 0.0_f64, f64::INFINITY);
        for (index, speed) in speeds.enumerate() {
            if speed * moving <= 0.0 {
                return index;
            }
            let size = speed.abs();
            if size < least {
                (slowest, least) = (index, size);
            }
            if size > RISES * least + ABOVE_NOISE * self.noise {
                return slowest;
            }
            if size > ABOVE_QUIET * self.quiet {
                (slow, most, most_before) = (0, 0.0, f64::INFINITY);
                continue;
            }
            (slow, most) = (slow + 1, most.max(size));
            if slow == REST_LEAST {
                if most > FALLING * most_before {
                    return slowest;
                }
                (slow, most, most_before) = (0, 0.0, most);
            }
        }
        all
    }
}

/// Returns the standard deviation of uncorrelated noise of speeds, from their second differences.
fn noise(speeds: &[f64]) -> f64 {
    let second = |three: &[f64]| match three {
        [a, b, c] => (a - 2.0 * b + c).abs(),
        _ => 0.0,
    };
    OF_MEDIAN * median(speeds.windows(3).map(second).collect()) / 6.0_f64.sqrt()
}

/// Returns the mean second difference of a few speeds, without sign.
fn bend(speeds: impl Iterator<Item = f64>) -> f64 {
    let (mut last, mut sum, mut count) = ([0.0; 2], 0.0, 0.0);
    for (index, speed) in speeds.enumerate() {
        let [before, middle] = last;
        if index >= 2 {
            (sum, count) = (sum + before - 2.0 * middle + speed, count + 1.0);
        }
        last = [middle, speed];
    }
    if count > 0.0 { (sum / count).abs() } else { 0.0 }
}

/// Returns the median; zero of no values.
fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    if middle >= values.len() {
        return 0.0;
    }
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Returns the lower quartile of the largest speeds of blocks of samples.
fn quiet(speeds: &[f64]) -> f64 {
    let mut all: Vec<f64> = speeds.chunks_exact(REST_LEAST.clamp(1, speeds.len().max(1))).map(largest).collect();
    let quarter = all.len() / 4;
    if quarter >= all.len() {
        return 0.0;
    }
    *all.select_nth_unstable_by(quarter, f64::total_cmp).1
}

#[cfg(test)]
#[path = "settled_tests.rs"]
mod tests;
