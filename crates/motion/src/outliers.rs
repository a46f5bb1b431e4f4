//! Single values of a recorded column far beside those around them, and jumps of a position.

use numeric::quantile;

/// Smallest deviation of an outlier from the running median relative to that which 99 % of the values do not exceed. A choice:
/// noise of any kind stays below.
const OF_USUAL: f64 = 20.0;

/// Smallest deviation relative to the range of a position or a speed, which do not jump. A choice.
const OF_RANGE: f64 = 0.3;

/// Smallest deviation relative to the range of a torque or a current: at a reversal they jump by the friction, with a peak of
/// the controller within a row. A choice.
const OF_RANGE_FORCE: f64 = 1.0;

/// Largest share of the rows that are outliers. A choice: more are a signal.
const SHARE_MOST: f64 = 0.01;

/// Quantity of a column, which decides how far it may change from row to row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalKind {
    /// Position or speed: steady.
    Motion,
    /// Torque, force or current: may jump.
    Force,
}

/// Outliers of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outliers {
    /// Index of the first one.
    pub first: usize,
    /// Index of the one farthest from its neighbours.
    pub farthest: usize,
    /// Number of them.
    pub count: usize,
}

impl Outliers {
    /// Finds the single values that lie far beside those before and behind; `None` if there are none, or so many that they
    /// are a signal.
    ///
    /// |y_k − med(y_{k−2} … y_{k+2})| > max(20 q_99, c (y_99 − y_1))
    ///
    /// # Symbols
    /// q_99 deviation from the running median that 99 % of the values do not exceed; y_1, y_99 values that 1 % and 99 % of the
    /// values do not exceed; c 0.3 of a motion, 1 of a force
    /// # Source
    /// docs/theory/recorded-motion.md
    /// # Valid
    /// outliers of up to two rows, at most 1 % of the rows; the factors are choices
    #[must_use]
    pub fn of(values: &[f64], kind: SignalKind) -> Option<Self> {
        let off = |five: &[f64]| {
            let mut sorted: [f64; 5] = five.try_into().ok()?;
            sorted.sort_unstable_by(f64::total_cmp);
            Some((five.get(2)? - sorted.get(2)?).abs())
        };
        let off: Vec<f64> = values.windows(5).filter_map(off).collect();
        let usual = quantile(&mut off.clone(), 0.99);
        let mut sorted = values.to_vec();
        let range = quantile(&mut sorted, 0.99) - quantile(&mut sorted, 0.01);
        let of_range = match kind {
            SignalKind::Motion => OF_RANGE,
            SignalKind::Force => OF_RANGE_FORCE,
        };
        let least = (OF_USUAL * usual).max(of_range * range);
        let wild = || off.iter().enumerate().filter(|(_, off)| **off > least);
        let (first, _) = wild().next()?;
        let (farthest, _) = wild().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        let count = wild().count();
        #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
        let share = count as f64 / values.len() as f64;
        (share < SHARE_MOST).then_some(Self { first: first + 2, farthest: farthest + 2, count })
    }
}

/// Column of a recording with outliers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutlyingColumn {
    /// Position.
    Position,
    /// Speed.
    Speed,
    /// Torque.
    Torque,
}

/// Outliers of a column of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutlyingValues {
    /// The column.
    pub column: OutlyingColumn,
    /// Number of outliers.
    pub count: usize,
    /// Instant of the farthest one from the first sample \[s\].
    pub time_s: f64,
    /// Value of the farthest one \[rad\], [rad/s], \[Nm\].
    pub value: f64,
}

/// Smallest change from row to row relative to the range of all values, without which there is no outlier: two thirds of the least
/// deviation of a motion.
const CHANGE_LEAST: f64 = 0.2;

impl OutlyingValues {
    /// Finds the outliers of a column, as [`Outliers::of`] does.
    pub(crate) fn of(time: &[f64], values: &[f64], column: OutlyingColumn) -> Option<Self> {
        let changes = values.windows(2).filter_map(|pair| Some((pair.last()? - pair.first()?).abs()));
        let [least, most] = values
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(*value), most.max(*value)]);
        // One pass decides for most columns.
        if changes.fold(0.0, f64::max) < CHANGE_LEAST * (most - least) {
            return None;
        }
        let kind = if column == OutlyingColumn::Torque { SignalKind::Force } else { SignalKind::Motion };
        let found = Outliers::of(values, kind)?;
        let (time_s, value) = (*time.get(found.farthest)?, *values.get(found.farthest)?);
        Some(Self { column, count: found.count, time_s, value })
    }
}

/// Smallest jump relative to the change from row to row that 99 % of the other rows have. A choice.
const JUMP_OF_USUAL: f64 = 10.0;

/// Smallest jump relative to the range of the position. A choice.
const JUMP_OF_RANGE: f64 = 0.02;

/// Largest interval of a jump relative to the median one: over a gap of the recording a position may change by much.
const JUMP_GAP: f64 = 1.5;

/// Returns the places at which a position jumps from one row to the next, each as the index of the row behind it with the
/// change.
///
/// |y_k − y_(k−1)| > max(10 q_99, 0.02 (y_max − y_min))
///
/// # Symbols
/// q_99 change from row to row that 99 % of the changes do not exceed, the largest left out; y_min, y_max range of the values
/// # Source
/// docs/theory/recorded-motion.md
/// # Valid
/// rows at the usual interval; the factors are choices
#[must_use]
pub fn jumps(time_s: &[f64], values: &[f64]) -> Vec<(usize, f64)> {
    let change = |pair: &[f64]| pair.last().zip(pair.first()).map_or(0.0, |(to, from)| to - from);
    let ways: Vec<f64> = values.windows(2).map(change).collect();
    let gaps: Vec<f64> = time_s.windows(2).map(change).collect();
    // Steps of a position with few digits are the usual changes.
    let mut sizes: Vec<f64> = ways.iter().map(|way| way.abs()).filter(|way| *way > 0.0).collect();
    if let Some(largest) = (0..sizes.len()).max_by(|a, b| {
        let size = |place: &usize| sizes.get(*place).copied().unwrap_or_default();
        size(a).total_cmp(&size(b))
    }) {
        let _ = sizes.swap_remove(largest);
    }
    let usual = quantile(&mut sizes, 0.99);
    let gap = quantile(&mut gaps.clone(), 0.5);
    let [low, high] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)]);
    let least = (JUMP_OF_USUAL * usual).max(JUMP_OF_RANGE * (high - low));
    let is_jump =
        |place: usize, way: f64| way.abs() > least && gaps.get(place).is_some_and(|own| *own < JUMP_GAP * gap);
    ways.into_iter()
        .enumerate()
        .filter(|(place, way)| is_jump(*place, *way))
        .map(|(place, way)| (place + 1, way))
        .collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing, clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;

    fn swing() -> Vec<f64> {
        (0..500_u32).map(|k| (f64::from(k) * 0.02).sin() + 1e-3 * f64::from(k * 7919 % 13)).collect()
    }

    #[test]
    fn single_values_are_found_where_they_were_planted() {
        for kind in [SignalKind::Motion, SignalKind::Force] {
            assert_eq!(Outliers::of(&swing(), kind), None);
            let mut values = swing();
            values[120] += 8.0;
            values[300] -= 12.0;
            let found = Outliers::of(&values, kind);
            assert_eq!(found, Some(Outliers { first: 120, farthest: 300, count: 2 }));
        }
    }

    /// The pass that decides for most columns never changes the answer.
    #[test]
    fn outliers_of_a_column_are_those_of_its_values() {
        let time: Vec<f64> = (0..500_u32).map(|k| 0.01 * f64::from(k)).collect();
        let mut found = 0;
        for size in 0..60_u32 {
            for (column, kind) in
                [(OutlyingColumn::Speed, SignalKind::Motion), (OutlyingColumn::Torque, SignalKind::Force)]
            {
                let mut values = swing();
                values[(37 * size as usize + 11) % 490 + 5] += 0.1 * f64::from(size) - 2.0;
                let of_column = OutlyingValues::of(&time, &values, column);
                let plain = Outliers::of(&values, kind);
                assert_eq!(of_column.map(|found| found.count), plain.map(|found| found.count), "{size} {column:?}");
                found += usize::from(of_column.is_some());
            }
        }
        assert!(found > 20, "{found}");
    }

    #[test]
    fn a_position_that_is_set_anew_jumps_and_a_motion_does_not() {
        let time: Vec<f64> = (0..500_u32).map(|k| 0.001 * f64::from(k)).collect();
        let swing: Vec<f64> = swing().iter().map(|value| 40.0 * value).collect();
        assert_eq!(jumps(&time, &swing), []);
        let set: Vec<f64> =
            swing.iter().enumerate().map(|(k, value)| if k < 200 { *value } else { value + 90.0 }).collect();
        assert!(matches!(jumps(&time, &set).as_slice(), [(200, way)] if (way - 90.0).abs() < 2.0));
        // One step in a record at rest, and a change over a gap of the recording.
        let step: Vec<f64> = (0..500_u32).map(|k| if k < 300 { 0.0 } else { 720.0 }).collect();
        assert_eq!(jumps(&time, &step), [(300, 720.0)]);
        let with_gap: Vec<f64> = time.iter().map(|t| if *t < 0.3 { *t } else { t + 1.0 }).collect();
        assert_eq!(jumps(&with_gap, &step), []);
        // Samples of an indexing motion with a few steps each.
        let indexed: Vec<f64> = (0..500_u32).map(|k| f64::from(k / 50) * 30.0).collect();
        assert_eq!(jumps(&time, &indexed), []);
    }

    #[test]
    fn a_reversal_of_friction_and_a_frequent_peak_are_a_signal() {
        let friction: Vec<f64> = (0..500_u32).map(|k| if k / 50 % 2 == 0 { 3.0 } else { -3.0 }).collect();
        let peaks: Vec<f64> = (0..500_u32).map(|k| if k % 20 == 0 { 30.0 } else { 0.0 }).collect();
        assert_eq!(Outliers::of(&friction, SignalKind::Force), None);
        assert_eq!(Outliers::of(&peaks, SignalKind::Force), None);
        assert_eq!(Outliers::of(&[], SignalKind::Motion), None);
    }
}
