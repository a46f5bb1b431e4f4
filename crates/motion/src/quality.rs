//! Step and noise of a recorded column, as shown before a recording is used.

use crate::grid::{Grid, ROUNDING};
use crate::resolution::median_interval;

/// Largest number of third differences whose median is taken.
const DIFFERENCES_MOST: usize = 100_000;

/// Permitted deviation of an interval from the median one, relative to it; of unequal intervals the third difference
/// contains the motion itself.
const EVEN: f64 = 0.05;

/// Ratio of the standard deviation of normally distributed values to the median of their magnitudes, 1/Φ⁻¹(3/4).
const OF_MEDIAN: f64 = 1.482_602_218_505_602;

/// Step and noise of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColumnQuality {
    /// Step of an encoder, a converter or the file, in the unit of the values.
    pub step: Option<f64>,
    /// Standard deviation of the noise, in the unit of the values.
    pub noise: Option<f64>,
}

impl ColumnQuality {
    /// Determines step and noise of the values of a column.
    ///
    /// σ = 1.4826 med|Δ³y|/√20
    ///
    /// # Symbols
    /// Δ³y third difference y_3 − 3 y_2 + 3 y_1 − y_0 of four values at equal intervals; of independent errors its variance is
    /// (1 + 9 + 9 + 1) σ²
    /// # Source
    /// docs/theory/recorded-motion.md
    /// # Valid
    /// upper bound: the jerk of the motion counts as noise; none without equal intervals of most values, or where
    /// more than half of the third differences are zero or rounding errors
    #[must_use]
    pub fn of(time_s: &[f64], values: &[f64]) -> Self {
        let step = Grid::of(values).step;
        Self { step: (step > 0.0).then_some(step), noise: noise(time_s, values) }
    }
}

fn noise(time_s: &[f64], values: &[f64]) -> Option<f64> {
    let interval = median_interval(time_s);
    let is_even = |times: &[f64]| {
        times.windows(2).all(|ends| matches!(ends, [from, to] if ((to - from) - interval).abs() <= EVEN * interval))
    };
    let spread = values.len().div_ceil(DIFFERENCES_MOST).max(1);
    let count = time_s.len().saturating_sub(3).div_ceil(spread);
    let quadruples = time_s.windows(4).zip(values.windows(4)).step_by(spread);
    let mut differences: Vec<f64> = quadruples
        .filter(|(times, _)| is_even(times))
        .filter_map(|(_, values)| match values {
            [a, b, c, d] => Some((d - 3.0 * c + 3.0 * b - a).abs()),
            _ => None,
        })
        .collect();
    let middle = differences.len() / 2;
    if differences.is_empty() || 2 * differences.len() < count {
        return None;
    }
    let (_, median, _) = differences.select_nth_unstable_by(middle, f64::total_cmp);
    let noise = OF_MEDIAN * *median / 20.0_f64.sqrt();
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    (noise > ROUNDING * largest).then_some(noise)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers with the variance 1 and nearly normal: sums of twelve even ones.
    fn normal(seed: &mut u64) -> f64 {
        (0..12)
            .map(|_| {
                *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (*seed >> 11) as f64 / (1_u64 << 53) as f64
            })
            .sum::<f64>()
            - 6.0
    }

    #[test]
    fn the_noise_added_to_a_smooth_motion_is_found() {
        let mut seed = 1;
        for sigma in [1e-6, 1e-4, 3e-3] {
            for rows in [500_u32, 5000] {
                let time: Vec<f64> = (0..rows).map(|row| f64::from(row) * 0.001).collect();
                let values: Vec<f64> = time.iter().map(|t| (2.0 * t).sin() + sigma * normal(&mut seed)).collect();
                let found = ColumnQuality::of(&time, &values).noise.unwrap();
                assert!((found / sigma - 1.0).abs() < 0.2, "{sigma}, {rows}: {found}");
            }
        }
    }

    #[test]
    fn the_step_of_a_rounded_motion_is_found_and_uneven_rows_have_no_noise() {
        for step in [0.001, 0.02] {
            let time: Vec<f64> = (0..2000).map(|row| f64::from(row) * 0.001).collect();
            let values: Vec<f64> = time.iter().map(|t| step * ((3.0 * t).sin() / step).round()).collect();
            let found = ColumnQuality::of(&time, &values).step.unwrap();
            assert!((found / step - 1.0).abs() < 1e-6, "{step}: {found}");
        }
        let time: Vec<f64> = (0..400).map(|row| f64::from(row * row) * 0.001).collect();
        let values: Vec<f64> = time.iter().map(|t| t.sin()).collect();
        assert_eq!(ColumnQuality::of(&time, &values).noise, None);
        assert_eq!(ColumnQuality::of(&[], &[]), ColumnQuality::default());
    }
}
