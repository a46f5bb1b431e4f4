//! Resolution of recorded samples: the step of a column, the spurious acceleration that it causes, and the noise of an
//! axis at rest.

use std::ops::Range;

/// Rounding error of a value, relative to the largest: 64 units in the last place.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Smallest step relative to the rounding error.
const STEP_LEAST: f64 = 16.0;

/// Permitted deviation of a difference from a multiple of the step, relative to the step.
const STEP_SLACK: f64 = 0.05;

/// Smallest difference that counts as rough, relative to the step; values are rounded if a quarter of the samples are
/// rough.
const ROUGH: f64 = 0.5;

/// Smallest spurious acceleration that is reported, relative to that of the motion.
const NOTABLE: f64 = 0.05;

/// Largest speed that may be rest, relative to the largest speed.
const SLOW: f64 = 1e-3;

/// Largest speed that is a rounding error of a computation, relative to the largest speed.
const ROUNDED: f64 = 1e-9;

/// Smallest number of samples of a rest with noise.
const REST_LEAST: usize = 8;

/// Bound of noise relative to its median: 5.4 standard deviations of normal noise.
const ABOVE_MEDIAN: f64 = 8.0;

/// Noise at rest that was set to zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestNoise {
    /// Largest speed that was set to zero [rad/s].
    pub speed_rad_s: f64,
    /// Time at rest hidden by the noise \[s\].
    pub duration_s: f64,
}

/// Column whose steps cause a spurious acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SteppedColumn {
    /// Positions, differentiated twice \[rad\].
    Position,
    /// Speeds, differentiated once [rad/s].
    Speed,
}

/// A spurious acceleration caused by the resolution of a column.
///
/// # Symbols
/// s step of the column, h time step; positions: the second difference of rounded values reaches s/h², with smoothing
/// over n samples four standard deviations, 4 · 8.5 s/(√12 n² h²); speeds: s/h, with smoothing 4 · 2.1 s/(√12 n h)
/// # Source
/// docs/theory/recorded-motion.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeUp {
    /// Column with steps.
    pub column: SteppedColumn,
    /// Step of the column \[rad\] or [rad/s].
    pub step: f64,
    /// Median time step of the samples \[s\].
    pub interval_s: f64,
    /// Largest spurious acceleration \[rad/s²\].
    pub acceleration_rad_s2: f64,
    /// Largest acceleration of the motion, from samples far enough apart for the steps not to matter \[rad/s²\].
    pub motion_rad_s2: f64,
    /// Width of a smoothing window that reduces the spurious acceleration to a twentieth of the motion's, if there is
    /// one \[s\].
    pub smoothing_s: Option<f64>,
}

/// Returns the step of a column: the largest number of which all differences of adjacent values are multiples; zero if
/// there is none.
fn step(values: &[f64]) -> f64 {
    let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let least = ROUNDING * most;
    let mut step = 0.0_f64;
    for (one, other) in values.iter().zip(values.iter().skip(1)) {
        let difference = (other - one).abs();
        if difference <= least {
            continue;
        }
        if step == 0.0 {
            step = difference;
            continue;
        }
        let rest = (difference - step * (difference / step).round()).abs();
        if rest > STEP_SLACK * step.min(difference) {
            // Euclid's algorithm down to the rounding error.
            let (mut larger, mut smaller) = (difference.max(step), difference.min(step));
            while smaller > least && smaller > STEP_SLACK * larger.min(step) {
                (larger, smaller) = (smaller, (larger - smaller * (larger / smaller).round()).abs());
            }
            step = larger;
            if step < STEP_LEAST * least {
                return 0.0;
            }
        }
    }
    if step < STEP_LEAST * least { 0.0 } else { step }
}

/// Returns `true` if the values are rounded to the step: their differences of this order are as large as the step,
/// while those of a densely sampled motion vanish.
fn is_rough(values: &[f64], step: f64, order: usize) -> bool {
    let (mut rough, mut moving) = (0_usize, 0_usize);
    let (second, third) = (order == 2, order == 3);
    for window in values.windows(order + 1) {
        let difference = match window {
            [a, b, c] if second => a - 2.0 * b + c,
            [a, b, c, d] if third => d - 3.0 * c + 3.0 * b - a,
            _ => 0.0,
        };
        let is_rough = difference.abs() >= ROUGH * step;
        moving += usize::from(is_rough || window.first() != window.last());
        rough += usize::from(is_rough);
    }
    moving >= 8 && 4 * rough >= moving
}

/// Returns the median time step \[s\].
fn median_interval(time: &[f64]) -> f64 {
    let mut steps: Vec<f64> = time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one).collect();
    let middle = steps.len() / 2;
    if middle >= steps.len() {
        return 0.0;
    }
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Returns the spurious acceleration caused by the steps of a column, if it is significant compared with that of the
/// motion.
pub(crate) fn made_up(time: &[f64], values: &[f64], column: SteppedColumn, window_s: Option<f64>) -> Option<MadeUp> {
    let step = step(values);
    let order = match column {
        SteppedColumn::Position => 3,
        SteppedColumn::Speed => 2,
    };
    if step == 0.0 || !is_rough(values, step, order) {
        return None;
    }
    let h = median_interval(time);
    let deviation = step / 12.0_f64.sqrt();
    let smoothed = |window: f64| match column {
        SteppedColumn::Position => 4.0 * 8.5 * deviation / (window * window),
        SteppedColumn::Speed => 4.0 * 2.1 * deviation / window,
    };
    let plain = |apart: f64| match column {
        SteppedColumn::Position => step / (apart * apart),
        SteppedColumn::Speed => step / apart,
    };
    let acceleration = window_s.map_or_else(|| plain(h), |window| smoothed(window).min(plain(h)));
    // The distance of the samples is doubled until the steps are a tenth of the motion between them.
    let mut apart = 1;
    let motion = loop {
        let found = largest_acceleration(time, values, column, apart);
        if 2.0 * plain(apart as f64 * h) <= 0.1 * found || 6 * apart >= values.len() {
            break found;
        }
        apart *= 2;
    };
    if acceleration <= NOTABLE * motion {
        return None;
    }
    let wanted = match column {
        SteppedColumn::Position => (4.0 * 8.5 * deviation / (NOTABLE * motion)).sqrt(),
        SteppedColumn::Speed => 4.0 * 2.1 * deviation / (NOTABLE * motion),
    };
    let duration = time.first().zip(time.last()).map_or(0.0, |(first, last)| last - first);
    // Slightly more than an even multiple of the time step, so that the window contains the same number of samples
    // everywhere; at least seven.
    let half = (0.5 * wanted / h).ceil().max(3.0);
    let window = (2.0 * half + 0.5) * h;
    let is_short = window <= 0.1 * duration && half <= 5000.0 && window_s.is_none_or(|given| given < window);
    Some(MadeUp {
        column,
        step,
        interval_s: h,
        acceleration_rad_s2: acceleration,
        motion_rad_s2: motion,
        smoothing_s: is_short.then_some(window),
    })
}

/// Returns the largest acceleration between samples at a distance of `apart` \[rad/s²\].
fn largest_acceleration(time: &[f64], values: &[f64], column: SteppedColumn, apart: usize) -> f64 {
    let points = || time.iter().zip(values);
    let slopes = points().zip(points().skip(apart)).map(|((t0, y0), (t1, y1))| (t0, t1, (y1 - y0) / (t1 - t0)));
    match column {
        SteppedColumn::Speed => slopes.fold(0.0, |most, (.., slope)| most.max(slope.abs())),
        SteppedColumn::Position => {
            let later = slopes.clone().skip(apart);
            let second = |((t0, _, before), (_, t2, behind)): ((&f64, &f64, f64), (&f64, &f64, f64))| {
                2.0 * (behind - before) / (t2 - t0)
            };
            slopes.zip(later).map(second).fold(0.0, |most, alpha| most.max(alpha.abs()))
        }
    }
}

/// Returns the samples at rest whose speeds are noise, and the noise; their speeds are to be set to zero.
///
/// Stretches are searched at decreasing speeds, from a thousandth of the largest, or two steps of the column, down to
/// the rounding error. A stretch is rest if it has at least eight samples and the axis stays in place: recorded
/// positions vary by less than a quarter of the travel that the speeds add up to, and by at most 10⁻⁴ of the total
/// travel or two steps; without positions, the speeds must change sign often, and their travel must be that of white
/// noise. Speeds in it up to eight times the median of those other than zero become zero.
pub(crate) fn still(
    time: &[f64],
    speed: &[f64],
    position: Option<&[f64]>,
    differentiated: bool,
) -> Option<(Vec<Range<usize>>, RestNoise)> {
    let most = speed.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let position_step = position.map_or(0.0, step);
    let speed_step = if differentiated { position_step / (2.0 * median_interval(time)) } else { step(speed) };
    let floor = ROUNDED * most;
    let slowest = (SLOW * most).max((2.0 * speed_step).min(0.05 * most));
    if !speed.iter().any(|speed| *speed != 0.0 && speed.abs() <= slowest) {
        return None;
    }
    let span = match position {
        Some(position) => range(position.iter().copied()),
        None => range(travelled(time, speed)),
    };
    let stretch = Stretch { time, speed, position, position_step, span, floor, differentiated };
    let mut found: Vec<Range<usize>> = Vec::new();
    let mut open: Vec<Range<usize>> = std::iter::once(0..speed.len()).collect();
    let mut level = slowest;
    while !open.is_empty() && level >= floor {
        let mut left = Vec::new();
        for within in open {
            let mut end = within.start;
            for run in runs(speed, within.clone(), level) {
                let bound = stretch.noise(&run).max(2.0 * speed_step).max(floor).min(level);
                let parts = runs(speed, run, bound)
                    .into_iter()
                    .filter(|part| part.len() >= REST_LEAST && stretch.is_rest(part));
                for part in parts {
                    left.push(end..part.start);
                    end = part.end;
                    found.push(part);
                }
            }
            left.push(end..within.end);
        }
        open = left.into_iter().filter(|range| range.len() >= REST_LEAST).collect();
        level *= if level == floor { 0.0 } else { 0.1 };
        level = if level > 0.0 && level < floor { floor } else { level };
    }
    found.sort_by_key(|range| range.start);
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
    Some((found, RestNoise { speed_rad_s, duration_s }))
}

/// Samples among which rests are searched.
struct Stretch<'s> {
    time: &'s [f64],
    speed: &'s [f64],
    position: Option<&'s [f64]>,
    position_step: f64,
    span: f64,
    floor: f64,
    differentiated: bool,
}

impl Stretch<'_> {
    /// Returns the bound of the noise in a run, from the median of the speeds other than zero.
    fn noise(&self, run: &Range<usize>) -> f64 {
        let sizes = self.speed.get(run.clone()).unwrap_or_default().iter().map(|speed| speed.abs());
        let mut sizes: Vec<f64> = sizes.filter(|size| *size > 0.0).collect();
        let middle = sizes.len() / 2;
        if middle >= sizes.len() {
            return 0.0;
        }
        ABOVE_MEDIAN * *sizes.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// Returns `true` if the axis stays in place in a run.
    fn is_rest(&self, run: &Range<usize>) -> bool {
        let time = self.time.get(run.clone()).unwrap_or_default();
        let speed = self.speed.get(run.clone()).unwrap_or_default();
        if speed.iter().all(|speed| speed.abs() <= self.floor) {
            return true;
        }
        let moving = || speed.iter().filter(|speed| **speed != 0.0);
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
        let place = self.position.and_then(|position| position.get(run.clone())).map(|all| range(all.iter().copied()));
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
                turns_often && place <= (0.25 * way).max((3.5 * drift).min(0.6 * way)) && place <= near.max(4.0 * drift)
            }
        }
    }
}

/// Returns the longest runs of samples within a range that are no faster than `most`.
fn runs(speed: &[f64], within: Range<usize>, most: f64) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut start = None;
    for index in within.clone() {
        let is_slow = speed.get(index).is_some_and(|speed| speed.abs() <= most);
        match (is_slow, start) {
            (true, None) => start = Some(index),
            (false, Some(from)) => {
                found.push(from..index);
                start = None;
            }
            _ => {}
        }
    }
    found.extend(start.map(|from| from..within.end));
    found
}

/// Iterates over the travel up to each sample, by the trapezoidal rule.
fn travelled<'v>(time: &'v [f64], speed: &'v [f64]) -> impl Iterator<Item = f64> + 'v {
    let points = || time.iter().zip(speed);
    let parts = points().zip(points().skip(1)).map(|((t0, w0), (t1, w1))| 0.5 * (w0 + w1) * (t1 - t0));
    std::iter::once(0.0).chain(parts.scan(0.0, |sum, part| {
        *sum += part;
        Some(*sum)
    }))
}

/// Returns the difference of the largest and the smallest value.
fn range(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    (high - low).max(0.0)
}

#[cfg(test)]
#[path = "resolution_tests.rs"]
mod tests;
