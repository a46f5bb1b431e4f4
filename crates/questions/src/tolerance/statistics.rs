//! Ranks, their correlation, quantiles and the interval of a share.

/// z of a two-sided 95 % interval of the normal distribution.
const Z_95: f64 = 1.959_963_984_540_054;

/// Ranks of a series, mid-ranks for equal values, relative to their mean.
#[derive(Clone, Debug)]
pub(super) struct Ranks {
    centred: Vec<f64>,
    square: f64,
    /// Values in ascending order.
    sorted: Vec<u64>,
}

impl Ranks {
    /// Creates the ranks of values that are compared as whole numbers; the bits of a non-negative float are suitable
    /// too.
    #[allow(clippy::cast_precision_loss, reason = "ranks are bounded by SAMPLES_MOST")]
    pub(super) fn of(values: impl Iterator<Item = u64>) -> Self {
        let mut order: Vec<(u64, usize)> = values.zip(0..).collect();
        order.sort_unstable();
        let middle = (order.len() as f64 - 1.0) / 2.0;
        let mut centred = vec![0.0; order.len()];
        let mut first = 0.0;
        for equal in order.chunk_by(|a, b| a.0 == b.0) {
            let rank = first + (equal.len() as f64 - 1.0) / 2.0 - middle;
            for (_, index) in equal {
                if let Some(place) = centred.get_mut(*index) {
                    *place = rank;
                }
            }
            first += equal.len() as f64;
        }
        let square = centred.iter().map(|rank| rank * rank).sum();
        Self { centred, square, sorted: order.into_iter().map(|(value, _)| value).collect() }
    }

    /// Returns the smallest value that at least this share of the values does not exceed; `None` without values.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a share of a bounded count"
    )]
    pub(super) fn quantile(&self, share: f64) -> Option<u64> {
        let rank = (share * self.sorted.len() as f64).ceil() as usize;
        self.sorted.get(rank.saturating_sub(1)).copied()
    }

    /// Computes ρ: Pearson's correlation of the ranks; zero if one of the series is constant.
    ///
    /// # Source
    /// Spearman, The proof and measurement of association between two things, 1904
    pub(super) fn correlation(&self, other: &Self) -> f64 {
        let product: f64 = self.centred.iter().zip(&other.centred).map(|(a, b)| a * b).sum();
        let size = (self.square * other.square).sqrt();
        if size > 0.0 { product / size } else { 0.0 }
    }
}

/// Computes the 95 % interval of a share by Wilson.
///
/// (p + z²/2n ± z √(p (1 − p)/n + z²/4n²)) / (1 + z²/n)
///
/// # Source
/// Wilson, Probable inference, the law of succession, and statistical inference, 1927
#[allow(clippy::cast_precision_loss, reason = "counts are bounded by SAMPLES_MOST")]
pub(super) fn wilson(passes: usize, samples: usize) -> (f64, f64) {
    let (n, p) = (samples as f64, passes as f64 / samples as f64);
    let square = Z_95 * Z_95;
    let scale = 1.0 + square / n;
    let centre = (p + square / (2.0 * n)) / scale;
    let half = Z_95 * (p * (1.0 - p) / n + square / (4.0 * n * n)).sqrt() / scale;
    // At the ends of the scale only rounding would exceed it.
    let low = if passes == 0 { 0.0 } else { (centre - half).max(0.0) };
    let high = if passes == samples { 1.0 } else { (centre + half).min(1.0) };
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_share_their_ranks() {
        let ranks = Ranks::of([5, 1, 5, 9].into_iter());
        assert_eq!(ranks.centred, [0.0, -1.5, 0.0, 1.5]);
        assert_eq!(Ranks::of([3, 3, 3].into_iter()).correlation(&Ranks::of([1, 2, 3].into_iter())), 0.0);
    }

    /// ρ = 1 − 6 Σd²/(n (n² − 1)) without ties: d = (0, −1, 1, 0, 0), n = 5, ρ = 1 − 12/120.
    #[test]
    fn spearman_by_hand() {
        let (a, b) = (Ranks::of([1, 2, 3, 4, 5].into_iter()), Ranks::of([1, 3, 2, 4, 5].into_iter()));
        assert!((a.correlation(&b) - 0.9).abs() < 1e-15);
        let falling = Ranks::of([5, 4, 3, 2, 1].into_iter());
        assert!((a.correlation(&falling) + 1.0).abs() < 1e-15);
    }

    /// Newcombe, Two-sided confidence intervals for the single proportion, 1998, table I: method 3.
    #[test]
    fn wilson_as_published() {
        for (passes, samples, low, high) in
            [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)]
        {
            let found = wilson(passes, samples);
            assert!((found.0 - low).abs() < 5.1e-5 && (found.1 - high).abs() < 5.1e-5, "{found:?}");
        }
        assert_eq!(wilson(7, 7).1, 1.0);
    }

    #[test]
    fn quantiles_are_values_of_the_series() {
        let ranks = Ranks::of((1..=100).rev());
        assert_eq!([0.05, 0.5, 0.95, 1.0].map(|share| ranks.quantile(share)), [5, 50, 95, 100].map(Some));
        assert_eq!(Ranks::of(std::iter::once(3)).quantile(0.05), Some(3));
        assert_eq!(Ranks::of(std::iter::empty()).quantile(0.05), None);
    }
}
