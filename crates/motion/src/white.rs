//! White noise of a recorded column.

use numeric::upper_median;

/// Smallest number of samples from which the noise follows.
const SAMPLES_LEAST: usize = 64;

/// Largest ratio of the deviations by differences of two successive orders if the noise is white: those of a motion without noise
/// fall with the order, or rise where it is sampled too coarsely.
const ALIKE: f64 = 1.3;

/// Smallest noise relative to the largest value that is none of the rounding of numbers.
const ROUNDED: f64 = 1e-11;

/// Ratio of the standard deviation of normally distributed values to the median of their magnitudes, 1/Φ⁻¹(3/4).
const OF_MEDIAN: f64 = 1.482_602_218_505_602;

/// Returns the standard deviation of the white noise of evenly spaced values; zero if there is none that stands out from the motion.
///
/// σ = 1.48 median |Δ⁴ y| / √70
///
/// # Symbols
/// Δᵏ difference of the order k, whose standard deviation of white noise is σ √(2k over k): √20, √70, √252
/// # Valid
/// where the third, the fourth and the fifth difference give the same σ to 30 %
pub(crate) fn deviation(values: &[f64]) -> f64 {
    let of = |weights: &[f64]| {
        let norm = weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
        let sizes = values
            .windows(weights.len())
            .map(|near| near.iter().zip(weights).map(|(value, weight)| value * weight).sum::<f64>().abs() / norm);
        OF_MEDIAN * upper_median(sizes).unwrap_or(0.0)
    };
    common(
        values,
        [of(&[1.0, -3.0, 3.0, -1.0]), of(&[1.0, -4.0, 6.0, -4.0, 1.0]), of(&[1.0, -5.0, 10.0, -10.0, 5.0, -1.0])],
    )
}

/// Returns the standard deviation of the white noise of values at any instants; zero if there is none that stands out from the motion.
///
/// σ = 1.48 median |Σ w_i y_i| / √(Σ w_i²), w_i = Π_{j ≠ i} 1/(t_i − t_j)
///
/// # Symbols
/// w weights of the divided difference of the order k over k + 1 samples, which is zero for polynomials of lower degree
/// # Valid
/// as [`deviation`], whose differences these are where the samples are evenly spaced
pub(crate) fn deviation_at(time: &[f64], values: &[f64]) -> f64 {
    /// Returns |Σ w_i y_i| / √(Σ w_i²) of a window.
    fn size(time: &[f64], values: &[f64]) -> f64 {
        let weight = |at: usize, own: f64| {
            let others = time.iter().enumerate().filter(|(other, _)| *other != at);
            others.map(|(_, other)| own - other).product::<f64>().recip()
        };
        let (sum, square) =
            time.iter().zip(values).enumerate().fold((0.0, 0.0), |(sum, square), (at, (own, value))| {
                let weight = weight(at, *own);
                (sum + weight * value, square + weight * weight)
            });
        f64::abs(sum) / f64::sqrt(square)
    }
    let sizes =
        |samples: usize| time.windows(samples).zip(values.windows(samples)).map(|(time, values)| size(time, values));
    common(values, [4, 5, 6].map(|samples| OF_MEDIAN * upper_median(sizes(samples)).unwrap_or(0.0)))
}

/// Returns the deviation by the fourth differences if those by the third and the fifth are alike.
fn common(values: &[f64], [third, fourth, fifth]: [f64; 3]) -> f64 {
    if values.len() < SAMPLES_LEAST {
        return 0.0;
    }
    let are_alike = |one: f64, other: f64| one <= ALIKE * other && other <= ALIKE * one;
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    if fourth > ROUNDED * largest && are_alike(third, fourth) && are_alike(fourth, fifth) { fourth } else { 0.0 }
}

/// Number of standard deviations of the range of white noise, at most, in a recording.
const RANGE_MOST: f64 = 12.0;

/// Number of parts of a rest whose means show if it stays in place.
const PARTS: usize = 4;

/// Number of standard deviations by which the means of the parts may differ by chance.
const CHANCE: f64 = 4.0;

/// Returns the range of positions of a stretch without their white noise: that of the means of its parts, less what noise alone causes.
/// The range itself if it is no white noise.
pub(crate) fn range_without_noise(positions: &[f64]) -> f64 {
    let range = |values: &[f64]| {
        let ends = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(*y), high.max(*y)));
        (ends.1 - ends.0).max(0.0)
    };
    let whole = range(positions);
    let noise = deviation(positions);
    if whole > RANGE_MOST * noise {
        return whole;
    }
    let each = positions.len() / PARTS;
    let means: Vec<f64> =
        positions.chunks_exact(each.max(1)).map(|part| part.iter().sum::<f64>() / part.len() as f64).collect();
    (range(&means) - CHANCE * noise / (each as f64).sqrt()).max(0.0)
}

#[cfg(test)]
#[path = "white_tests.rs"]
mod tests;
