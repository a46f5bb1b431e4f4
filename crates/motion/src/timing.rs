//! Timing of recorded samples: time stamps that scatter although the rows are evenly spaced.

use crate::faults::RecordedFault;
use crate::recorded::Samples;
use crate::resolution::median_interval;
use quantities::{Measure, Time};
use std::sync::Arc;

/// Scatter of the intervals, relative to their mean, that is no scatter.
const SCATTER_LEAST: f64 = 0.02;

/// Interval, relative to the mean one, at which a missing row is looked for.
const LONG: f64 = 1.75;

/// Number of rows before and behind a long interval that show whether a row is missing.
const NEAR: usize = 9;

/// Largest standard deviation of the stamps from an even grid, relative to its interval.
const SCATTER_MOST: f64 = 1.0;

/// Ratio of the roughness of the acceleration on an even grid and by the stamps, below which the stamps are wrong.
const SMOOTHER: f64 = 0.5;

/// Evenly spaced instants in place of time stamps.
pub(crate) struct Even {
    /// Instants from the first row \[s\].
    pub(crate) time_s: Vec<f64>,
    /// Interval of the rows \[s\].
    pub(crate) interval_s: f64,
    /// Standard deviation of the stamps from these instants \[s\].
    pub(crate) scatter_s: f64,
}

impl Even {
    /// Returns `true` if the stamps can be those of evenly spaced rows.
    fn is_likely(&self) -> bool {
        self.scatter_s <= SCATTER_MOST * self.interval_s
    }
}

/// Fits evenly spaced instants to time stamps by least squares, t = a + b n, where n skips the rows that are missing
/// at a lasting shift of the stamps.
fn even(time: &[f64]) -> Option<Even> {
    let median = median_interval(time);
    let steps = || time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one);
    let usual = || steps().filter(|step| *step <= 2.5 * median);
    let interval = usual().sum::<f64>() / usual().count().max(1) as f64;
    let off = |index: usize| time.get(index).map(|t| t - index as f64 * interval);
    let middle = |range: std::ops::Range<usize>| {
        let mut all: Vec<f64> = range.filter_map(off).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let mut missing = 0.0;
    let mut places = Vec::with_capacity(time.len());
    places.push(0.0);
    for (index, step) in (1_usize..).zip(steps()) {
        if step > LONG * interval
            && let Some((before, behind)) = middle(index.saturating_sub(NEAR)..index).zip(middle(index..index + NEAR))
        {
            // More than the interval itself is a gap nearby.
            let shift = ((behind - before) / interval).round();
            missing += if (0.0..=step / interval).contains(&shift) { shift } else { 0.0 };
        }
        places.push(index as f64 + missing);
    }
    let count = places.len() as f64;
    let (mean_n, mean_t) = (places.iter().sum::<f64>() / count, time.iter().sum::<f64>() / count);
    let about = || places.iter().zip(time).map(|(n, t)| (n - mean_n, t - mean_t));
    let slope = about().map(|(n, t)| n * t).sum::<f64>() / about().map(|(n, _)| n * n).sum::<f64>();
    let square = about().map(|(n, t)| (t - slope * n) * (t - slope * n)).sum::<f64>();
    let time_s = places.into_iter().map(|n| n * slope).collect();
    let is_rising = slope.is_finite() && slope > 0.0;
    is_rising.then(|| Even { time_s, interval_s: slope, scatter_s: (square / count).sqrt() })
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

    /// Returns `true` if the acceleration is much smoother than another one of the same motion.
    pub(crate) fn is_smoother_than(self, other: Self) -> bool {
        self.roughness() < SMOOTHER * other.roughness()
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
