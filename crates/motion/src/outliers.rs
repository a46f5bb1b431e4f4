//! Single values of a recorded column far beside those around them.

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

    #[test]
    fn a_reversal_of_friction_and_a_frequent_peak_are_a_signal() {
        let friction: Vec<f64> = (0..500_u32).map(|k| if k / 50 % 2 == 0 { 3.0 } else { -3.0 }).collect();
        let peaks: Vec<f64> = (0..500_u32).map(|k| if k % 20 == 0 { 30.0 } else { 0.0 }).collect();
        assert_eq!(Outliers::of(&friction, SignalKind::Force), None);
        assert_eq!(Outliers::of(&peaks, SignalKind::Force), None);
        assert_eq!(Outliers::of(&[], SignalKind::Motion), None);
    }
}
