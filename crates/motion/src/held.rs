//! Values of a recording that are held over several rows, because their source is slower than the logger.

use crate::grid::Grid;
use crate::recorded::slopes;
use crate::resolution::{mean_interval, median_interval};
use crate::standstill::rests;
use crate::timing::SpeedOverTime;

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

/// Largest number of periods in a run of equal values that is no rest.
const LOST_MOST: usize = 3;

/// Share of the distance of a change from the grid by which the grid follows it.
const LED: f64 = 0.3;

/// Scatter of the changes about an even grid above which the updates come early or late, in rows; the rows alone cause
/// 1/√12.
const SCATTER_OF_ROWS: f64 = 0.4;

/// Ratio of the roughness of the acceleration with updates at their rows and on an even grid, below which they are at
/// their rows.
const SMOOTHER: f64 = 0.7;

/// Returns the period at which the values of a column are updated \[s\]; `None` if they are not held over rows.
///
/// Runs of equal values are counted, without those at rest. Their lengths are those of one period or, where updates are
/// lost, of several: four fifths lie within one row, or 15 %, of a multiple. Their differences are more than a step of
/// the column; runs of four and more rows may differ by single steps if nine tenths agree within one row. Runs of any
/// length are held too if they repeat half of the rows: updates that jitter by rows, or a value that is written when it
/// has changed. Noise that repeats a value by chance also returns to the value before the last, which a held signal does
/// not.
pub(crate) fn held(time: &[f64], values: &[f64]) -> Option<f64> {
    let pairs = || values.iter().zip(values.iter().skip(1));
    let repeats = pairs().filter(|(one, other)| one == other).count();
    if (repeats as f64) < REPEATED * values.len() as f64 {
        return None;
    }
    let grid = Grid::of(values);
    // Neighbouring levels are up to a step and the rounding of the file apart.
    let least = (ABOVE_STEP * grid.step).max((1.0 + numeric::EQUAL) * grid.error());
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
    let counted = |range: std::ops::RangeInclusive<usize>| {
        let counts = lengths.get(range.clone()).unwrap_or_default();
        counts
            .iter()
            .zip(range)
            .fold((0_u64, 0.0), |(sum, rows), (count, length)| (sum + count, rows + length as f64 * *count as f64))
    };
    let within = |range| counted(range).0;
    let longest = (LOST_MOST * median + median / 2 + 1).min(ROWS_MOST);
    let (moving, rows) = counted(0..=longest);
    rests += all - moving;
    let repeated = rows - moving as f64;
    if moving < HELD_LEAST || 3 * rests > moving || repeated < (HELD_LEAST as f64).max(REPEATED * rows) {
        return None;
    }
    // Runs of one period.
    let (singles, rows_of_singles) = counted(median.div_ceil(2)..=(median + (median / 2).max(1)).min(longest));
    let mean = rows_of_singles / singles.max(1) as f64;
    let is_multiple = |length: f64| {
        let periods = (length / mean).round().max(1.0);
        (length - periods * mean).abs() <= (0.15 * mean).max(1.0)
    };
    let counts = lengths.iter().take(longest + 1).enumerate();
    let regular: u64 = counts.filter(|(length, _)| is_multiple(*length as f64)).map(|(_, count)| *count).sum();
    let is_distinct = 5 * distinct >= 4 * held;
    let is_strict = median >= 4 && 10 * within(median - 1..=median + 1) >= 9 * moving;
    let is_regular = 5 * regular >= 4 * moving && 2 * singles >= moving && (is_strict || is_distinct);
    let is_stepped = median >= 2 && 2.0 * repeated >= rows && is_distinct;
    if !is_regular && !is_stepped || 4 * returns > held {
        return None;
    }
    let rows = if 10 * within(median..=median) >= 9 * moving { median as f64 } else { mean };
    Some(rows * mean_interval(time))
}

/// Instants at which a held column is updated, with their values.
struct Updates {
    time: Vec<f64>,
    values: Vec<f64>,
    /// The changes do not follow an even grid.
    is_irregular: bool,
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
///
/// The number of periods between two changes follows from a grid that is led by the changes, so that updates may come
/// early or late by almost half a period.
fn stretches(time: &[f64], values: &[f64], period: f64) -> Vec<Vec<Change>> {
    let mut found: Vec<Vec<Change>> = Vec::new();
    let mut grid = 0.0;
    let rows = time.iter().zip(values);
    for ((before, old), (now, value)) in rows.clone().zip(rows.skip(1)) {
        if old == value {
            continue;
        }
        let mut change = Change { rows: [*before, *now], value: *value, periods: 0.0 };
        let middle = change.middle();
        if let Some(stretch) = found.last_mut()
            && let Some(last) = stretch.last()
        {
            let periods = ((middle - grid) / period).round().max(1.0);
            if periods < REST {
                grid += periods * period;
                grid += LED * (middle - grid);
                change.periods = last.periods + periods;
                stretch.push(change);
                continue;
            }
        }
        grid = middle;
        found.push(vec![change]);
    }
    found
}

impl Updates {
    /// Finds the updates: on an even grid, or at their rows where the acceleration is much smoother by these.
    fn new(time: &[f64], values: &[f64], period: f64, is_speed: bool) -> Self {
        let stretches = stretches(time, values, period);
        let [even, own] = [true, false].map(|is_even| Self::at(time, values, period, &stretches, is_even));
        let roughness = |updates: &Self| {
            let slopes = (!is_speed).then(|| slopes(&updates.time, &updates.values));
            SpeedOverTime { time: &updates.time, speed: slopes.as_ref().unwrap_or(&updates.values) }.roughness()
        };
        if roughness(&own) < SMOOTHER * roughness(&even) { own } else { even }
    }

    /// Returns the updates. On an even grid they lie at equal intervals within a stretch of changes, by least squares
    /// through the middles between the row of a change and the row before, with one interval for all stretches;
    /// otherwise at these middles. A value that stays for longer is at rest in between, unless an update is lost.
    fn at(time: &[f64], values: &[f64], period: f64, stretches: &[Vec<Change>], is_even: bool) -> Self {
        let mut found = Self { time: Vec::new(), values: Vec::new(), is_irregular: !is_even };
        let (Some(first), Some(end)) = (time.first().zip(values.first()), time.last()) else { return found };
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
        // A clock of the source that drifts against that of the logger stays within half a row, updates that come
        // early or late within their scatter.
        let count = about().count().max(1) as f64;
        let scatter = (about().map(|(n, t)| (t - period * n).powi(2)).sum::<f64>() / count).sqrt();
        let row = median_interval(time);
        let is_scattered = scatter > SCATTER_OF_ROWS * row;
        found.is_irregular |= is_scattered;
        let slack = if is_scattered { 3.0 * scatter } else { 0.5 * row };
        let mut updates: Vec<(f64, f64)> = Vec::with_capacity(count as usize + 1);
        for (stretch, [mean_n, mean_t]) in stretches.iter().zip(&means) {
            for change in stretch {
                let [before, now] = change.rows;
                let update = if is_even {
                    (mean_t + period * (change.periods - mean_n)).clamp(before - slack, now + slack)
                } else {
                    change.middle()
                };
                let last = updates.last().map_or(*first.0, |last| last.0);
                updates.push((if update > last { update } else { now.max(last) }, change.value));
            }
        }
        found.add(*first.0, *first.1);
        let (mut at, mut value) = (*first.0, *first.1);
        // Change by one period before each update, and of the one before.
        let per_period = |index: usize| {
            let (before, behind) = updates.get(index.checked_sub(1)?).zip(updates.get(index))?;
            Some((behind.1 - before.1) * (period / (behind.0 - before.0)).min(4.0))
        };
        for (index, (update, next)) in updates.iter().enumerate() {
            let periods = (update - at) / period;
            let beside =
                [index.checked_sub(1).and_then(per_period), per_period(index + 1)].map(|each| each.unwrap_or(0.0));
            let usual = 0.5 * (beside[0] + beside[1]);
            let is_lost = periods >= 1.5 && (next - value - periods * usual).abs() < (next - value - usual).abs();
            if index == 0 && update - at < 1.5 * period {
                // The first value may have been updated before the recording.
                found.time.clear();
                found.values.clear();
                found.add(at.min(update - period), value);
            } else if !is_lost {
                found.rest(at, *update, value, period);
            }
            (at, value) = (*update, *next);
            found.add(at, value);
        }
        if *end > at {
            found.rest(at, *end, value, period);
            found.add(*end, value);
        }
        found
    }

    fn add(&mut self, at: f64, value: f64) {
        if self.time.last().is_none_or(|last| *last < at) {
            self.time.push(at);
            self.values.push(value);
        }
    }

    /// Adds the updates without change next to both ends of a rest.
    fn rest(&mut self, from: f64, to: f64, value: f64, period: f64) {
        let periods = ((to - from) / period).round();
        if periods >= 2.0 {
            self.add(from + period, value);
        }
        if periods >= 4.0 {
            self.add(to - 2.0 * period, value);
        }
        if periods >= 3.0 {
            self.add(to - period, value);
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
    /// The updates do not follow an even grid.
    pub(crate) is_irregular: bool,
}

/// Returns a held position and its speed at each row, from one sample for each update; `None` if it is not held.
pub(crate) fn interpolated_position(time: &[f64], values: &[f64]) -> Option<Interpolated> {
    let updates = Updates::new(time, values, held(time, values)?, false);
    let (position, speed) = updates.at_rows(time, Some(&slopes(&updates.time, &updates.values)));
    let is_irregular = updates.is_irregular;
    Some(Interpolated { position, speed, update_s: updates.time, updated: updates.values, is_irregular })
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
    /// The updates do not follow an even grid.
    pub(crate) is_irregular: bool,
}

impl Updated {
    /// Returns the values of a held column at each row, straight between its updates, and the updates.
    pub(crate) fn new(time: &[f64], values: &[f64]) -> Option<(Vec<f64>, Self)> {
        let updates = Updates::new(time, values, held(time, values)?, true);
        let rows = updates.at_rows(time, None).0;
        Some((
            rows,
            Self { time: updates.time, speed: updates.values, position: None, is_irregular: updates.is_irregular },
        ))
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

#[cfg(test)]
#[path = "held_tests.rs"]
mod tests;
