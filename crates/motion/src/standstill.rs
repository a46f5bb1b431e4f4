//! Noise of a recorded axis at rest.

use crate::grid::Grid;
use crate::resolution::median_interval;
use crate::settled::slow;
use crate::stretch::{SMOOTH, range, runs, smooth_end, travelled};
use crate::white::range_without_noise;
use std::ops::Range;

/// Largest speed at which noise is searched for, relative to the largest speed.
const NOISE_MOST: f64 = 0.05;

/// Ratio of two adjacent levels of the search above [`SLOW`].
const LEVEL: f64 = 0.35;

/// Largest speed that may be rest without the conditions on noise that is visible, relative to the largest speed.
const SLOW: f64 = 1e-3;

/// Largest speed that is a rounding error of a computation, relative to the largest speed.
const ROUNDED: f64 = 1e-9;

/// Smallest number of samples of a rest with noise.
const REST_LEAST: usize = 8;

/// Smallest number of samples that show noise to be uncorrelated.
const NOISE_LEAST: usize = 24;

/// Largest distance of samples whose correlation is examined; an oscillation with a longer period is already correlated
/// by 0.7 from one sample to the next.
const LAGS: usize = 8;

/// Largest number of samples of one sign that belong to a rest before its first and behind its last change of sign.
const ONE_SIGN: usize = 6;

/// Largest travel of white noise in standard deviations; two of a million stretches exceed it.
const DRIFT: f64 = 5.0;

/// Deviation of a smooth continuation relative to the bound of the noise: 0.05 standard deviations.
const ABRUPT: f64 = 0.01;

/// Largest smoothed speed at an end of a rest, relative to the largest in windows that hold samples of the rest alone.
const OUTWARDS: f64 = 2.0;

/// Bound of noise relative to its median: 5.4 standard deviations of normal noise.
const ABOVE_MEDIAN: f64 = 8.0;

/// Largest speed of samples that alternate, relative to the largest speed.
const ALTERNATING_MOST: f64 = 0.2;

/// Smallest share of samples that alternate and are reported.
const ALTERNATING_LEAST: f64 = 0.02;

/// Noise at rest that was set to zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestNoise {
    /// Largest speed that was set to zero [rad/s].
    pub speed_rad_s: f64,
    /// Time at rest hidden by the noise \[s\].
    pub duration_s: f64,
    /// Largest range of the positions of one rest \[rad\].
    pub place_rad: f64,
}

/// Speeds that change sign from sample to sample and count as motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alternating {
    /// Share of the samples that differ in sign from both of their neighbours \[1\].
    pub share: f64,
    /// Bound of these speeds [rad/s]: `standstill` that would set them to zero.
    pub speed_rad_s: f64,
}

/// Returns the speeds that alternate in sign, if they are frequent.
pub(crate) fn alternating(speed: &[f64]) -> Option<Alternating> {
    let most = speed.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let limit = ALTERNATING_MOST * most;
    let alternates = |three: &[f64]| match three {
        [a, b, c] if a * b < 0.0 && b * c < 0.0 && a.abs().max(b.abs()).max(c.abs()) <= limit => Some(b.abs()),
        _ => None,
    };
    let mut sizes: Vec<f64> = speed.windows(3).filter_map(alternates).collect();
    let share = sizes.len() as f64 / speed.len() as f64;
    let middle = sizes.len() / 2;
    if sizes.len() < REST_LEAST || share < ALTERNATING_LEAST {
        return None;
    }
    let median = *sizes.select_nth_unstable_by(middle, f64::total_cmp).1;
    Some(Alternating { share, speed_rad_s: (ABOVE_MEDIAN * median).min(limit) })
}

/// Returns the samples at rest whose speeds are noise, and the noise; their speeds are to be set to zero.
///
/// Of smoothed speeds, `smoothed` contains the window \[s\] and the [`rests`] of the speeds before smoothing. There the axis is at
/// rest too: half a window inside both ends and outwards, as long as the smoothed speed is at most twice the largest
/// inside.
pub(crate) fn still(
    time: &[f64],
    speed: &[f64],
    position: Option<&[f64]>,
    differentiated: bool,
    smoothed: Option<(f64, &[Range<usize>])>,
) -> Option<(Vec<Range<usize>>, RestNoise)> {
    let mut found = rests(time, speed, position, differentiated).unwrap_or_default();
    if let Some((window, before)) = smoothed {
        found.extend(before.iter().flat_map(|rest| of_smoothed(time, speed, rest, 0.5 * window)));
        found = joined(found);
    }
    let noise = found.iter().flat_map(|range| speed.get(range.clone()).unwrap_or_default());
    let speed_rad_s = noise.fold(0.0_f64, |most, speed| most.max(speed.abs()));
    if speed_rad_s == 0.0 {
        return None;
    }
    let length = |range: &Range<usize>| {
        let ends = time.get(range.start).zip(time.get(range.end - 1));
        ends.map_or(0.0, |(first, last)| last - first)
    };
    let is_noisy =
        |range: &&Range<usize>| speed.get((*range).clone()).unwrap_or_default().iter().any(|speed| *speed != 0.0);
    let duration_s = found.iter().filter(is_noisy).map(length).sum();
    let place = |rest: &Range<usize>| match position.and_then(|position| position.get(rest.clone())) {
        Some(position) => range(position.iter().copied()),
        None => {
            range(travelled(time.get(rest.clone()).unwrap_or_default(), speed.get(rest.clone()).unwrap_or_default()))
        }
    };
    let place_rad = found.iter().filter(is_noisy).map(place).fold(0.0, f64::max);
    Some((found, RestNoise { speed_rad_s, duration_s, place_rad }))
}

/// Returns the parts of a rest found before smoothing in which the smoothed speed is noise.
fn of_smoothed(time: &[f64], speed: &[f64], rest: &Range<usize>, half_window_s: f64) -> Vec<Range<usize>> {
    // A window that is cut off at an end of the recording holds no sample beyond it.
    let last = speed.len().saturating_sub(1);
    let begin =
        time.get(rest.start).filter(|_| rest.start > 0).map_or(f64::NEG_INFINITY, |begin| begin + half_window_s);
    let end = time.get(rest.end - 1).filter(|_| rest.end <= last).map_or(f64::INFINITY, |end| end - half_window_s);
    let inside = time.get(rest.clone()).into_iter().flatten().zip(speed.get(rest.clone()).into_iter().flatten());
    let inside = inside.filter(|(time, _)| (begin..=end).contains(*time)).map(|(_, speed)| speed.abs());
    let (count, most) = inside.fold((0_usize, 0.0_f64), |(count, most), size| (count + 1, most.max(size)));
    if count < REST_LEAST {
        return Vec::new();
    }
    let bound = OUTWARDS * most;
    let mut found = runs(speed, rest.clone(), bound);
    found.retain(|part| part.len() >= REST_LEAST);
    found
}

/// Returns ranges in ascending order, those that overlap or meet joined.
fn joined(mut ranges: Vec<Range<usize>>) -> Vec<Range<usize>> {
    ranges.sort_by_key(|range| range.start);
    let mut all: Vec<Range<usize>> = Vec::with_capacity(ranges.len());
    for range in ranges {
        match all.last_mut().filter(|last| range.start <= last.end) {
            Some(last) => last.end = last.end.max(range.end),
            None => all.push(range),
        }
    }
    all
}

/// Returns the samples at rest whose speeds are noise; `None` if there are no slow samples other than zero.
///
/// Stretches are searched at decreasing speeds, from a twentieth of the largest down to the rounding error. Up to a
/// thousandth of the largest speed, or two steps of the column, a stretch is rest if it has at least eight samples and
/// the axis stays in place: recorded positions vary by less than a quarter of the travel that the speeds add up to, and
/// by at most 10⁻⁴ of the total travel or two steps; without positions, the speeds must change sign often, and their
/// travel must be that of white noise. Above, [`Stretch::noisy`] decides. Speeds in it up to eight times the median of
/// those other than zero become zero.
pub(crate) fn rests(
    time: &[f64],
    speed: &[f64],
    position: Option<&[f64]>,
    differentiated: bool,
) -> Option<Vec<Range<usize>>> {
    let most = speed.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let position_grid = position.map(Grid::of);
    let position_step = position_grid.map_or(0.0, |grid| grid.step);
    let (speed_step, rounded) = if differentiated {
        let twice = 2.0 * median_interval(time);
        (position_step / twice, position_grid.map_or(0.0, |grid| grid.rounded) / twice)
    } else {
        let grid = Grid::of(speed);
        (grid.step, grid.rounded)
    };
    let rounding = rounded.max(ROUNDED * most);
    let nil = if speed_step > 2.0 * rounding { rounding } else { 0.0 };
    let floor = nil.max(ROUNDED * most);
    let slowest = NOISE_MOST * most;
    let small = (SLOW * most).max((2.0 * speed_step).min(slowest));
    if !speed.iter().any(|speed| *speed != 0.0 && speed.abs() <= slowest) {
        return None;
    }
    let span = match position {
        Some(position) => range(position.iter().copied()),
        None => range(travelled(time, speed)),
    };
    let stretch = Stretch { time, speed, position, position_step, span, nil, floor, differentiated };
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut open: Vec<Range<usize>> = std::iter::once(0..speed.len()).collect();
    let mut level = slowest;
    while !open.is_empty() && level >= floor && level > 0.0 {
        let mut left = Vec::new();
        for within in open {
            let mut end = within.start;
            for run in runs(speed, within.clone(), level) {
                let noise = stretch.noise(&run);
                let bound = noise.max(2.0 * speed_step).max(floor).min(level);
                // Samples of larger noise, or of a reversal, between which the speed is by chance below the level.
                let is_cut = noise > 1.5 * level && noise > 1.01 * ABOVE_MEDIAN * speed_step;
                let rest = |part: Range<usize>| match part.len() >= REST_LEAST {
                    true if bound > small => Some(part).filter(|_| !is_cut).and_then(|part| stretch.noisy(&part)),
                    true if stretch.is_rest(&part, is_cut) => stretch.between_moves(&part, false),
                    _ => None,
                };
                for part in runs(speed, run, bound).into_iter().filter_map(rest) {
                    left.push(end..part.start);
                    end = part.end;
                    found.push(part);
                }
            }
            left.push(end..within.end);
        }
        open = left.into_iter().filter(|range| range.len() >= REST_LEAST).collect();
        level = match level {
            _ if level > small => (LEVEL * level).max(small),
            _ if level > floor => (0.1 * level).max(floor),
            _ => 0.0,
        };
    }
    let settled = slow(time, speed, position, differentiated).into_iter().filter(|slow| slow.is_rest);
    found.extend(settled.map(|slow| slow.samples));
    Some(joined(found))
}

/// Samples among which rests are searched.
struct Stretch<'s> {
    time: &'s [f64],
    speed: &'s [f64],
    position: Option<&'s [f64]>,
    position_step: f64,
    span: f64,
    /// Largest speed that is zero up to the rounding of the column's steps; zero if it has none.
    nil: f64,
    /// Largest speed that is a rounding error.
    floor: f64,
    differentiated: bool,
}

impl Stretch<'_> {
    /// Returns the bound of the noise in a run, from the median of the speeds other than zero.
    fn noise(&self, run: &Range<usize>) -> f64 {
        let sizes = self.speed.get(run.clone()).unwrap_or_default().iter().map(|speed| speed.abs());
        let mut sizes: Vec<f64> = sizes.filter(|size| *size > self.nil).collect();
        let middle = sizes.len() / 2;
        if middle >= sizes.len() {
            return 0.0;
        }
        ABOVE_MEDIAN * *sizes.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// Returns an iterator over the speeds other than zero. In a column with steps, of an encoder or of a ramp of equal
    /// steps, rounding errors are zeros: they do not show that the lowest step is noise.
    fn moving<'a>(&self, speed: &'a [f64]) -> impl Iterator<Item = &'a f64> + use<'a> {
        let nil = self.nil;
        speed.iter().filter(move |speed| speed.abs() > nil)
    }

    /// Returns the range of positions; beside recorded speeds without their own noise, which the speeds do not follow.
    fn place(&self, positions: &[f64]) -> f64 {
        if self.differentiated { range(positions.iter().copied()) } else { range_without_noise(positions) }
    }

    /// Returns `true` if the axis stays in place in a run; of one that is cut only where its speeds are rounding errors.
    fn is_rest(&self, run: &Range<usize>, is_cut: bool) -> bool {
        let time = self.time.get(run.clone()).unwrap_or_default();
        let speed = self.speed.get(run.clone()).unwrap_or_default();
        if speed.iter().all(|speed| speed.abs() <= self.floor) {
            return true;
        }
        if is_cut {
            return false;
        }
        let moving = || self.moving(speed);
        let count = moving().count();
        if count < REST_LEAST {
            return false;
        }
        // Noise reverses often, the ends of two moves at most once.
        let turns = moving().zip(moving().skip(1)).filter(|(one, other)| (**one < 0.0) != (**other < 0.0)).count();
        let turns_often = 8 * turns >= count;
        let sizes: Vec<f64> = speed.iter().map(|speed| speed.abs()).collect();
        let way = travelled(time, &sizes).last().unwrap_or(0.0);
        let resolved = 2.0 * self.position_step;
        let place = self.position.and_then(|position| position.get(run.clone())).map(|all| self.place(all));
        let near = 1e-4 * self.span;
        match place {
            Some(place) if self.differentiated => {
                way <= resolved || turns_often && place <= 0.25 * way + resolved && place <= near.max(resolved)
            }
            Some(place) if way > 4.0 * resolved => place <= 0.25 * way && place <= near.max(resolved),
            // Positions are missing or too coarse to decide.
            _ => {
                let place = range(travelled(time, speed));
                // Standard deviation of the travel of white noise with these speeds; few samples may exceed it.
                let duration = time.first().zip(time.last()).map_or(0.0, |(first, last)| last - first);
                let square = speed.iter().map(|speed| speed * speed).sum::<f64>() / speed.len() as f64;
                let drift = (square / count as f64).sqrt() * duration;
                turns_often
                    && place <= (0.25 * way).max((3.5 * drift).min(0.6 * way))
                    && place <= near.max(DRIFT * drift)
            }
        }
    }

    /// Returns the samples of a run that are noise of an axis at rest, visible beside the motion.
    ///
    /// Without the ends of the moves before and behind it ([`Stretch::between_moves`]) the axis is at rest if the
    /// speeds are uncorrelated over the next eight samples, r_k ≤ max(4/√n, 0.2), at most 0.6, change their sign in a
    /// quarter of the samples and add up to the travel of white noise, at most five standard deviations. Recorded
    /// positions take the place of the last condition: they stay within a quarter of the travel that the speeds add up
    /// to and 10⁻³ of the total travel, or two steps. Positions that resolve the speeds and do not follow them, Σ Δq ω h
    /// ≤ Σ (ω h)²/4, suffice alone.
    ///
    /// # Symbols
    /// r_k correlation of samples at the distance k, n samples, Δq step of the position between two samples
    /// # Source
    /// own derivation, docs/theory/recorded-motion.md#standstill
    /// # Valid
    /// oscillations with a period of four samples or more are correlated by at least 0.65 in a stretch of 24 samples
    fn noisy(&self, run: &Range<usize>) -> Option<Range<usize>> {
        let run = self.between_moves(run, true)?;
        let (time, speed) = (self.time.get(run.clone())?, self.speed.get(run.clone())?);
        let moving = || self.moving(speed);
        let count = moving().count();
        if count < REST_LEAST {
            return None;
        }
        let squares: f64 = speed.iter().map(|speed| speed * speed).sum();
        let resolved = 2.0 * self.position_step;
        let position = self.position.and_then(|position| position.get(run.clone()));
        let stays = position.map(|position| {
            let sizes: Vec<f64> = speed.iter().map(|speed| speed.abs()).collect();
            let way = travelled(time, &sizes).last().unwrap_or(0.0);
            let place = self.place(position);
            place <= 0.25 * way + resolved && place <= (1e-3 * self.span).max(resolved)
        });
        if stays == Some(false) {
            return None;
        }
        if let Some(position) = position.filter(|_| !self.differentiated) {
            let steps = time.windows(2).zip(speed.windows(2)).zip(position.windows(2));
            let (mut both, mut own, mut pairs) = (0.0, 0.0, 0.0_f64);
            for ((t, w), q) in steps {
                if let ([t0, t1], [w0, w1], [q0, q1]) = (t, w, q) {
                    let way = 0.5 * (w0 + w1) * (t1 - t0);
                    (both, own, pairs) = (both + way * (q1 - q0), own + way * way, pairs + 1.0);
                }
            }
            if own > pairs * self.position_step * self.position_step && both <= 0.25 * own {
                return Some(run);
            }
        }
        let turns = moving().zip(moving().skip(1)).filter(|(one, other)| (**one < 0.0) != (**other < 0.0)).count();
        let most = (4.0 / (speed.len() as f64).sqrt()).clamp(0.2, 0.6);
        let is_correlated = |lag: usize| {
            let products: f64 = speed.iter().zip(speed.iter().skip(lag)).map(|(one, other)| one * other).sum();
            products > most * squares
        };
        if count < NOISE_LEAST || 4 * turns < count || (1..=LAGS).any(is_correlated) {
            return None;
        }
        let is_fine = stays.is_some() && (self.differentiated || self.position_step == 0.0) || {
            let duration = time.first().zip(time.last()).map_or(0.0, |(first, last)| last - first);
            let drift = (squares / speed.len() as f64 / count as f64).sqrt() * duration;
            range(travelled(time, speed)) <= DRIFT * drift
        };
        is_fine.then_some(run)
    }

    /// Returns the run without the ends of the moves before and behind it.
    ///
    /// A move without noise is continued inwards by the cubic through its last four samples, to within a twentieth
    /// of the standard deviation of the noise. With noise it ends, if `by_sign`, where the speeds change their sign for the
    /// first time.
    fn between_moves(&self, run: &Range<usize>, by_sign: bool) -> Option<Range<usize>> {
        let speed = self.speed.get(run.clone())?;
        let outside = SMOOTH.min(run.start);
        let from_before = self.speed.get(run.start - outside..run.end)?.iter().copied();
        let beyond = SMOOTH.min(self.speed.len() - run.end);
        let from_behind = self.speed.get(run.start..run.end + beyond)?.iter().rev().copied();
        let noise = self.noise(run);
        if !by_sign && noise <= self.floor {
            return Some(run.clone());
        }
        let near = ABRUPT * noise;
        let turns = |pair: &[f64]| matches!(pair, [one, other] if one * other < 0.0);
        let of_sign = |one_sign: &mut dyn ExactSizeIterator<Item = f64>, before: Option<f64>| {
            end_of_move(&one_sign.collect::<Vec<_>>(), before)
        };
        let before = match smooth_end(from_before, outside, near) {
            Some(count) => count,
            None if by_sign => {
                let first = speed.windows(2).position(turns)?;
                let before = run.start.checked_sub(1).and_then(|index| self.speed.get(index)).copied();
                of_sign(&mut speed.get(..=first)?.iter().copied(), before)
            }
            None => 0,
        };
        let behind = match smooth_end(from_behind, beyond, near) {
            Some(count) => count,
            None if by_sign => {
                let last = speed.windows(2).rposition(turns)? + 1;
                of_sign(&mut speed.get(last..)?.iter().rev().copied(), self.speed.get(run.end).copied())
            }
            None => 0,
        };
        // The difference over two intervals carries the noise of the first sample at rest into the last of the move.
        let carried = usize::from(by_sign && self.differentiated);
        let of_move = |outside: usize, samples: usize| if outside > 0 { samples + carried } else { samples };
        let (before, behind) = (of_move(outside, before), of_move(beyond, behind));
        (before + behind + REST_LEAST <= run.len()).then(|| run.start + before..run.end - behind)
    }
}

/// Returns the number of samples, all of one sign, that belong to the move before a rest: those that fall from the last
/// sample of the move, and those at more than [`ONE_SIGN`] from the first change of sign behind the last.
fn end_of_move(speeds: &[f64], before: Option<f64>) -> usize {
    let falls = |pair: &&[f64]| matches!(pair, [one, other] if one.abs() > other.abs());
    let falling = 1 + speeds.windows(2).take_while(falls).count();
    // A recording begins and ends at rest or within a move, of which [`ONE_SIGN`] remains.
    let is_move = before.zip(speeds.first()).is_some_and(|(before, first)| before * first > 0.0);
    (if is_move { falling } else { 0 }).max(speeds.len().saturating_sub(ONE_SIGN)).min(speeds.len())
}

#[cfg(test)]
#[path = "standstill_tests.rs"]
mod tests;
