//! Timing of recorded samples: time stamps that scatter although the rows are evenly spaced.

use crate::faults::RecordedFault;
use crate::resolution::median_interval;
use crate::samples::Samples;
use quantities::{Measure, Time};
use std::sync::Arc;

/// Scatter of the intervals, relative to their mean, that is no scatter.
const SCATTER_LEAST: f64 = 0.02;

/// Interval, relative to the mean one, at which a missing row is looked for.
const LONG: f64 = 1.75;

/// Number of rows before and behind a long interval that show whether a row is missing.
const NEAR: usize = 9;

/// Passes of the search for missing rows: share of the deviation of a stamp by which the grid behind is moved, and deviation
/// from which a row is missing, relative to the interval. A row that is taken as missing by mistake shifts all behind, one
/// overlooked is found at the next.
const PASSES: [[f64; 2]; 3] = [[0.2, 0.65], [0.05, 0.6], [0.02, 0.5]];

/// Number of rows over which the first interval is taken.
const ROWS_OVER: usize = 8;

/// Largest deviation of a stamp from the even grid, relative to its interval, up to which rounding finds the places.
const ROUNDED_MOST: f64 = 0.49;

/// Largest standard deviation of stamps that are rounded, relative to the step; rounding alone causes 1/√12.
const STEP_SCATTER_MOST: f64 = 0.4;

/// Largest standard deviation of the stamps from an even grid, relative to its interval.
const SCATTER_MOST: f64 = 1.0;

/// Evenly spaced instants in place of time stamps.
pub(crate) struct Even {
    /// Instants from the first row \[s\].
    pub(crate) time_s: Vec<f64>,
    /// Instant of the first row in the time of the stamps \[s\].
    pub(crate) start_s: f64,
    /// Interval of the rows \[s\].
    pub(crate) interval_s: f64,
    /// Standard deviation of the stamps from these instants \[s\].
    pub(crate) scatter_s: f64,
    /// Step to which the stamps are rounded if some are equal, otherwise zero \[s\].
    rounded_s: f64,
}

impl Even {
    /// Returns `true` if the stamps can be those of evenly spaced rows; equal stamps are rounded to a step, with an error
    /// of up to half of it.
    fn is_likely(&self) -> bool {
        self.scatter_s <= (SCATTER_MOST * self.interval_s).max(STEP_SCATTER_MOST * self.rounded_s)
    }
}

/// Fits evenly spaced instants to time stamps by least squares, t = a + b n, where n skips the rows that are missing: by
/// rounding where the stamps scatter by less than half an interval, else at a lasting shift of the stamps.
fn even(time: &[f64]) -> Option<Even> {
    if let Some(even) = rounded_to_steps(time) {
        return Some(even);
    }
    // Over several rows the scatter matters less, and most stretches have no missing row.
    let over = time.iter().zip(time.iter().skip(ROWS_OVER)).map(|(one, other)| (other - one) / ROWS_OVER as f64);
    let start = median_of(over.collect())?;
    let rounded = PASSES.iter().try_fold((None, start), |(_, interval), pass| {
        let (even, off) = fitted(time, rounded(time, interval, *pass)?)?;
        let interval = even.interval_s;
        Some((Some((even, off)), interval))
    });
    let rounded = rounded.and_then(|(found, _)| found);
    let is_near = |(even, off): &(Even, f64)| *off < ROUNDED_MOST * even.interval_s;
    let found = match rounded.filter(is_near) {
        Some((even, _)) => even,
        None => fitted(time, shifted(time))?.0,
    };
    Some(found)
}

fn median_of(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len() / 2;
    (middle < values.len()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Returns the places of rows on an even grid by rounding each interval from the mean course of the stamps before; `None` if
/// more rows are missing than there are.
fn rounded(time: &[f64], interval: f64, [followed, from]: [f64; 2]) -> Option<Vec<f64>> {
    let mut places = Vec::with_capacity(time.len());
    let first = time.iter().take(2 * NEAR + 1).zip(0_u32..).map(|(t, k)| t - f64::from(k) * interval);
    let (mut place, mut start) = (0.0, median_of(first.collect())?);
    places.push(place);
    for t in time.iter().skip(1) {
        place += ((t - start) / interval - place + 1.0 - from).floor().max(1.0);
        start += followed * (t - start - place * interval);
        places.push(place);
    }
    (place < 2.0 * time.len() as f64).then_some(places)
}

/// Returns the step to which stamps are rounded if some are equal, otherwise zero \[s\].
fn rounding(time: &[f64]) -> f64 {
    let steps = || time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one);
    let least = steps().filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min);
    if least.is_finite() && steps().any(|step| step == 0.0) { least } else { 0.0 }
}

/// Smallest number of rows with one stamp, on average, from which the rows are placed by the changes of the stamp.
const ROWS_OF_STEP: f64 = 3.0;

/// Returns evenly spaced instants of rows whose stamps are rounded to a step of several rows without a missing row: the stamp changes
/// at the row that is first in its step, so that the line through the changes gives the interval; `None` for other stamps, and if
/// the changes do not lie within a row of that line.
fn rounded_to_steps(time: &[f64]) -> Option<Even> {
    let step = rounding(time);
    let count = time.len() as f64;
    let changes: Vec<(f64, f64)> = time
        .windows(2)
        .zip(1_u32..)
        .filter_map(
            |(pair, row)| {
                if let [one, other] = pair { (one != other).then_some((f64::from(row), *other)) } else { None }
            },
        )
        .collect();
    let (first, last) = (changes.first()?, changes.last()?);
    let rows = (last.0 - first.0) / ((last.1 - first.1) / step);
    // A single change, or rows that are as far apart as the stamps, show no interval.
    if step <= 0.0 || !rows.is_finite() || rows < ROWS_OF_STEP {
        return None;
    }
    let interval = step / rows;
    let is_near = |(row, stamp): &(f64, f64)| ((row - first.0) * interval - (stamp - first.1)).abs() <= 1.5 * interval;
    // The rows of the first and the last step are at most as many as those of the others.
    let ends = [first.0, count - last.0];
    if !changes.iter().all(is_near) || ends.iter().any(|end| *end > rows + 2.0) {
        return None;
    }
    let start_s = first.1 - first.0 * interval;
    let time_s: Vec<f64> = (0_u32..).take(time.len()).map(|row| f64::from(row) * interval).collect();
    let off = time_s.iter().zip(time).map(|(even, stamp)| (stamp - start_s - even).powi(2)).sum::<f64>();
    let mean = time_s.iter().zip(time).map(|(even, stamp)| stamp - start_s - even).sum::<f64>() / count;
    let scatter_s = (off / count - mean * mean).max(0.0).sqrt();
    Some(Even { time_s, start_s, interval_s: interval, scatter_s, rounded_s: step })
}

/// Returns the places of rows on an even grid; rows are missing where the stamps shift by whole intervals for good.
fn shifted(time: &[f64]) -> Vec<f64> {
    let median = median_interval(time);
    let steps = || time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one);
    let rounded_s = rounding(time);
    let usual = || steps().filter(|step| *step <= (2.5 * median).max(1.5 * rounded_s));
    let interval = usual().sum::<f64>() / usual().count().max(1) as f64;
    let off = |index: usize| time.get(index).map(|t| t - index as f64 * interval);
    let middle = |range: std::ops::Range<usize>| median_of(range.filter_map(off).collect());
    let mut missing = 0.0;
    let mut places = Vec::with_capacity(time.len());
    places.push(0.0);
    // The stamps of rows in one step are those of the first or the last of them.
    let near = NEAR.max((4.0 * rounded_s / interval).ceil() as usize);
    for (index, step) in (1_usize..).zip(steps()) {
        if step > LONG * interval + rounded_s
            && let Some((before, behind)) = middle(index.saturating_sub(near)..index).zip(middle(index..index + near))
        {
            // More than the interval itself is a gap nearby.
            let shift = ((behind - before) / interval).round();
            missing += if (0.0..=step / interval).contains(&shift) { shift } else { 0.0 };
        }
        places.push(index as f64 + missing);
    }
    places
}

/// Fits instants to stamps at places of an even grid, and returns them with the largest deviation of a stamp \[s\].
fn fitted(time: &[f64], places: Vec<f64>) -> Option<(Even, f64)> {
    let count = places.len() as f64;
    let (mean_n, mean_t) = (places.iter().sum::<f64>() / count, time.iter().sum::<f64>() / count);
    let about = || places.iter().zip(time).map(|(n, t)| (n - mean_n, t - mean_t));
    let slope = about().map(|(n, t)| n * t).sum::<f64>() / about().map(|(n, _)| n * n).sum::<f64>();
    let off = || about().map(|(n, t)| t - slope * n);
    let square = off().map(|off| off * off).sum::<f64>();
    let most = off().fold(0.0_f64, |most, off| most.max(off.abs()));
    let is_rising = slope.is_finite() && slope > 0.0;
    let start_s = mean_t - slope * mean_n;
    let time_s = places.into_iter().map(|n| n * slope).collect();
    let scatter_s = (square / count).sqrt();
    is_rising.then(|| (Even { time_s, start_s, interval_s: slope, scatter_s, rounded_s: rounding(time) }, most))
}

/// Replaces the stamps of samples by evenly spaced instants.
pub(crate) fn evenly_spaced(time: &[f64]) -> Result<Arc<Vec<f64>>, RecordedFault> {
    match even(time) {
        Some(even) if even.is_likely() => Ok(Arc::new(even.time_s)),
        Some(even) => Err(RecordedFault::StampsUneven {
            scatter: Time::from_si(even.scatter_s),
            interval: Time::from_si(even.interval_s),
        }),
        None => Err(RecordedFault::StampsUneven {
            scatter: Time::from_si(median_interval(time)),
            interval: Time::from_si(median_interval(time)),
        }),
    }
}

/// Returns `true` if time stamps are as evenly spaced as the instants fitted to them.
pub(crate) fn is_even(time: &[f64], even: &[f64]) -> bool {
    let slack = 0.5 * SCATTER_LEAST * median_interval(even);
    let first = time.first().copied().unwrap_or(0.0);
    let pairs = time.iter().zip(even).map(|(stamp, even)| stamp - first - even);
    let (low, high) = pairs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), off| (low.min(off), high.max(off)));
    high - low <= slack
}

/// Returns evenly spaced instants if the stamps scatter about them.
pub(crate) fn scattered(time: &[f64]) -> Option<Even> {
    let steps = || time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one);
    let count = steps().count().max(1) as f64;
    let mean = steps().sum::<f64>() / count;
    let square = steps().map(|step| (step - mean) * (step - mean)).sum::<f64>() / count;
    if square.sqrt() < SCATTER_LEAST * mean {
        return None;
    }
    even(time).filter(|even| even.is_likely() && even.scatter_s > 0.5 * SCATTER_LEAST * even.interval_s)
}

/// A speed over its instants.
#[derive(Clone, Copy)]
pub(crate) struct SpeedOverTime<'s> {
    /// Instants \[s\].
    pub(crate) time: &'s [f64],
    /// Speeds [rad/s].
    pub(crate) speed: &'s [f64],
}

impl<'s> SpeedOverTime<'s> {
    fn accelerations(self) -> impl Iterator<Item = f64> + Clone + 's {
        let points = self.time.iter().zip(self.speed);
        points.clone().zip(points.skip(1)).map(|((t0, w0), (t1, w1))| (w1 - w0) / (t1 - t0))
    }

    /// Returns the sum of the changes of the acceleration [rad/s²].
    pub(crate) fn roughness(self) -> f64 {
        let all = self.accelerations();
        all.clone().zip(all.skip(1)).map(|(one, other)| (other - one).abs()).sum()
    }

    /// Returns the largest acceleration [rad/s²].
    pub(crate) fn largest_acceleration(self) -> f64 {
        self.accelerations().fold(0.0, |most, alpha| most.max(alpha.abs()))
    }

    /// Returns the largest acceleration, and the largest difference of another one of the same rows from it [rad/s²].
    pub(crate) fn acceleration_and_difference(self, other: Self) -> (f64, f64) {
        let both = self.accelerations().zip(other.accelerations());
        both.fold((0.0, 0.0), |(most, apart), (own, other)| (own.abs().max(most), (other - own).abs().max(apart)))
    }
}

/// Returns the samples with evenly spaced instants.
pub(crate) fn with_time(samples: &Samples, time_s: Vec<f64>) -> Samples {
    Samples { time_s: Arc::new(time_s), ..samples.clone() }
}

#[cfg(test)]
#[path = "timing_tests.rs"]
mod tests;
