//! Timing of recorded samples: values held over several rows, and time stamps that scatter although the rows are
//! evenly spaced.

use crate::faults::RecordedFault;
use crate::recorded::{Samples, slopes};
use crate::resolution::{median_interval, step};
use crate::standstill::rests;
use quantities::{Measure, Time};
use std::sync::Arc;

/// Smallest share of repeated values among the rows of a held column.
const REPEATED: f64 = 0.05;

/// Smallest number of held values.
const HELD_LEAST: u64 = 8;

/// Largest number of rows over which a value is held; more are rest.
const ROWS_MOST: usize = 1000;

/// Difference of a held value from its neighbour, in steps of the column, above which it is more than one step: a
/// slow signal with steps repeats its values too.
const ABOVE_STEP: f64 = 1.5;

/// Number of periods without a change that are a rest.
const REST: f64 = 4.0;

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

/// Returns the period at which the values of a column are updated \[s\]; `None` if they are not held over rows.
///
/// Runs of equal values, without those at rest, have nearly constant length: at least four fifths lie within one row,
/// or 15 %, of their mean. Their differences are more than a step of the column; runs of four and more rows may differ
/// by single steps if nine tenths agree within one row. Noise that repeats a value by chance also returns to the value
/// before the last, which a held signal does not.
pub(crate) fn held(time: &[f64], values: &[f64]) -> Option<f64> {
    let pairs = || values.iter().zip(values.iter().skip(1));
    let repeats = pairs().filter(|(one, other)| one == other).count();
    if (repeats as f64) < REPEATED * values.len() as f64 {
        return None;
    }
    let least = ABOVE_STEP * step(values);
    let mut lengths = vec![0_u64; ROWS_MOST + 1];
    let (mut begin, mut held, mut distinct, mut returns, mut rests) = (None, 0_u64, 0_u64, 0_u64, 0_u64);
    for (index, (before, value)) in (1..).zip(pairs()) {
        if before == value {
            continue;
        }
        // The first run may have begun before the recording.
        if let Some(begin) = begin.replace(index) {
            let rows: usize = index - begin;
            match lengths.get_mut(rows) {
                Some(count) => *count += 1,
                None => rests += 1,
            }
            if (2..=ROWS_MOST).contains(&rows) {
                held += 1;
                distinct += u64::from((value - before).abs() > least);
            }
            let is_return = rows == 1 && values.get(begin.wrapping_sub(1)) == Some(value);
            returns += u64::from(is_return);
        }
    }
    let all: u64 = lengths.iter().sum();
    let mut sum = 0;
    let median = lengths.iter().position(|count| {
        sum += count;
        2 * sum >= all.max(1)
    })?;
    let within = |range: std::ops::RangeInclusive<usize>| lengths.get(range).unwrap_or_default().iter().sum::<u64>();
    let longest = (2 * median + 1).min(ROWS_MOST);
    let moving = within(0..=longest);
    rests += all - moving;
    let rows: f64 = lengths.iter().take(longest + 1).enumerate().map(|(rows, count)| rows as f64 * *count as f64).sum();
    let repeated = rows - moving as f64;
    if moving < HELD_LEAST || 3 * rests > moving || repeated < (HELD_LEAST as f64).max(REPEATED * rows) {
        return None;
    }
    let mean = rows / moving as f64;
    let spread = (0.15 * mean).max(1.0);
    let (low, high) = ((mean - spread).ceil().max(0.0) as usize, (mean + spread).floor() as usize);
    let is_constant = 5 * within(low..=high.min(longest)) >= 4 * moving;
    let is_strict = median >= 4 && 10 * within(median - 1..=median + 1) >= 9 * moving;
    if !is_constant || !(is_strict || 5 * distinct >= 4 * held) || 4 * returns > held {
        return None;
    }
    let rows = if 10 * within(median..=median) >= 9 * moving { median as f64 } else { mean };
    Some(rows * median_interval(time))
}

/// Instants at which a held column is updated, with their values.
struct Updates {
    time: Vec<f64>,
    values: Vec<f64>,
}

/// A change of a held value.
struct Change {
    /// Instants of the row before and of the row of the change \[s\].
    rows: [f64; 2],
    value: f64,
    /// Number of periods since the first change of its stretch; a stretch begins behind a rest.
    periods: f64,
}

impl Change {
    fn middle(&self) -> f64 {
        0.5 * (self.rows[0] + self.rows[1])
    }
}

/// Returns the changes of a held value in stretches without rest.
fn stretches(time: &[f64], values: &[f64], period: f64) -> Vec<Vec<Change>> {
    let mut found: Vec<Vec<Change>> = Vec::new();
    let rows = time.iter().zip(values);
    for ((before, old), (now, value)) in rows.clone().zip(rows.skip(1)) {
        if old == value {
            continue;
        }
        let mut change = Change { rows: [*before, *now], value: *value, periods: 0.0 };
        if let Some(stretch) = found.last_mut()
            && let Some(last) = stretch.last()
        {
            let periods = ((change.middle() - last.middle()) / period).round().max(1.0);
            if periods < REST {
                change.periods = last.periods + periods;
                stretch.push(change);
                continue;
            }
        }
        found.push(vec![change]);
    }
    found
}

impl Updates {
    /// Finds the updates: at equal intervals within a stretch of changes, by least squares through the middles between
    /// the row of a change and the row before, with one interval for all stretches. A value that stays for longer is
    /// at rest in between.
    fn new(time: &[f64], values: &[f64], period: f64) -> Self {
        let mut found = Self { time: Vec::new(), values: Vec::new() };
        let (Some(first), Some(end)) = (time.first().zip(values.first()), time.last()) else { return found };
        let stretches = stretches(time, values, period);
        let means: Vec<[f64; 2]> = stretches
            .iter()
            .map(|stretch| {
                let sum = |of: fn(&Change) -> f64| stretch.iter().map(of).sum::<f64>() / stretch.len() as f64;
                [sum(|change| change.periods), sum(Change::middle)]
            })
            .collect();
        let about = || {
            let both = stretches.iter().zip(&means);
            both.flat_map(|(stretch, [n, t])| stretch.iter().map(move |each| (each.periods - n, each.middle() - t)))
        };
        let square = about().map(|(n, _)| n * n).sum::<f64>();
        let fitted = about().map(|(n, t)| n * t).sum::<f64>() / square;
        let period = if square > 0.0 && fitted > 0.0 { fitted } else { period };
        let (mut at, mut value) = (*first.0, *first.1);
        found.put(at, value);
        let mut is_first = true;
        for (stretch, [mean_n, mean_t]) in stretches.iter().zip(&means) {
            for change in stretch {
                // A clock of the source that drifts against that of the logger stays within half a row.
                let [before, now] = change.rows;
                let slack = 0.5 * (now - before);
                let update = (mean_t + period * (change.periods - mean_n)).clamp(before - slack, now + slack);
                let update = if update > at { update } else { now };
                // The first value may have been updated before the recording.
                if is_first && update - at < 1.5 * period {
                    found.time.clear();
                    found.values.clear();
                    found.put(at.min(update - period), value);
                } else {
                    found.rest(at, update, value, period);
                }
                is_first = false;
                (at, value) = (update, change.value);
                found.put(at, value);
            }
        }
        if *end > at {
            found.rest(at, *end, value, period);
            found.put(*end, value);
        }
        found
    }

    fn put(&mut self, at: f64, value: f64) {
        if self.time.last().is_none_or(|last| *last < at) {
            self.time.push(at);
            self.values.push(value);
        }
    }

    /// Adds the updates without change next to both ends of a rest.
    fn rest(&mut self, from: f64, to: f64, value: f64, period: f64) {
        let periods = ((to - from) / period).round();
        if periods >= 2.0 {
            self.put(from + period, value);
        }
        if periods >= 4.0 {
            self.put(to - 2.0 * period, value);
        }
        if periods >= 3.0 {
            self.put(to - period, value);
        }
    }

    /// Returns value and slope at each row: slopes are straight between the updates, values follow them, or are
    /// straight without slopes.
    fn at_rows(&self, time: &[f64], slopes: Option<&[f64]>) -> (Vec<f64>, Vec<f64>) {
        let pair = |values: &[f64], index: usize| values.get(index).copied().zip(values.get(index + 1).copied());
        let mut index = 0;
        let rows = time.iter().map(|t| {
            while self.time.get(index + 1).is_some_and(|next| next < t) {
                index += 1;
            }
            let (Some((from, to)), Some((y0, y1))) = (pair(&self.time, index), pair(&self.values, index)) else {
                return (self.values.last().copied().unwrap_or(0.0), 0.0);
            };
            let u = ((t - from) / (to - from)).clamp(0.0, 1.0);
            let (s0, s1) = slopes.and_then(|slopes| pair(slopes, index)).unwrap_or((0.0, 0.0));
            let bow = 0.5 * (s1 - s0) * (to - from) * u * (1.0 - u);
            (y0 + u * (y1 - y0) - bow, s0 + u * (s1 - s0))
        });
        rows.unzip()
    }
}

/// A held position between its updates.
pub(crate) struct Interpolated {
    /// Position at each row \[rad\].
    pub(crate) position: Vec<f64>,
    /// Speed at each row [rad/s].
    pub(crate) speed: Vec<f64>,
    /// Instants of the updates \[s\].
    pub(crate) update_s: Vec<f64>,
    /// Positions at the updates \[rad\].
    pub(crate) updated: Vec<f64>,
}

/// Returns a held position and its speed at each row, from one sample for each update; `None` if it is not held.
pub(crate) fn interpolated_position(time: &[f64], values: &[f64]) -> Option<Interpolated> {
    let updates = Updates::new(time, values, held(time, values)?);
    let (position, speed) = updates.at_rows(time, Some(&slopes(&updates.time, &updates.values)));
    Some(Interpolated { position, speed, update_s: updates.time, updated: updates.values })
}

/// Returns the values of a held column at each row, straight between its updates; `None` if it is not held.
pub(crate) fn interpolated(time: &[f64], values: &[f64]) -> Option<Vec<f64>> {
    Some(Updated::new(time, values)?.0)
}

/// Instants of the updates of a held speed \[s\], and the speeds there [rad/s], with positions from which they follow.
pub(crate) struct Updated {
    pub(crate) time: Vec<f64>,
    pub(crate) speed: Vec<f64>,
    pub(crate) position: Option<Vec<f64>>,
}

impl Updated {
    /// Returns the values of a held column at each row, straight between its updates, and the updates.
    pub(crate) fn new(time: &[f64], values: &[f64]) -> Option<(Vec<f64>, Self)> {
        let updates = Updates::new(time, values, held(time, values)?);
        let rows = updates.at_rows(time, None).0;
        Some((rows, Self { time: updates.time, speed: updates.values, position: None }))
    }

    /// Returns the rows at which the axis is at rest with noise: between two rows the noise of a held speed is straight, and
    /// resembles slow motion.
    pub(crate) fn rests(&self, rows_s: &[f64]) -> Vec<std::ops::Range<usize>> {
        let position = self.position.as_deref();
        let found = rests(&self.time, &self.speed, position, position.is_some()).unwrap_or_default();
        let last = self.time.len();
        let rows = |range: std::ops::Range<usize>| {
            let begin = self.time.get(range.start).filter(|_| range.start > 0);
            let end = self.time.get(range.end - 1).filter(|_| range.end < last);
            begin.map_or(0, |begin| rows_s.partition_point(|t| t < begin))
                ..end.map_or(rows_s.len(), |end| rows_s.partition_point(|t| t <= end))
        };
        found.into_iter().map(rows).filter(|range| !range.is_empty()).collect()
    }
}

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

    fn roughness(self) -> f64 {
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
