//! Samples that are far apart for their motion: the acceleration that differences over them leave out.

use crate::resolution::{SteppedColumn, median_interval};

/// Samples too far apart for the acceleration of their motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SparseSamples {
    /// Usual time between two samples \[s\].
    pub interval_s: f64,
    /// Part of the effective acceleration that is left out, relative to that of the motion \[1\]; an estimate.
    pub share: f64,
}

/// Smallest share that is reported. A choice.
const NOTABLE: f64 = 0.02;

/// Smallest effective acceleration from every fourth sample, relative to that from each, with which it is one of the motion. A choice.
const REACHED: f64 = 0.6;

/// Order where it is not known: between those of a smooth and of a jumping acceleration.
const UNKNOWN: f64 = 1.5;

/// Largest deviation of a time step from the usual one, relative to it, with which the samples count as evenly spaced.
const EVEN: f64 = 0.05;

/// Smallest number of samples: four times four intervals of the widest differences.
const LEAST: usize = 16;

/// Returns the samples as sparse ones if their differences leave out a considerable part of the acceleration.
///
/// A = A₁ + (A₁ − A₂)/(2^p − 1), p = lb((A₂ − A₄)/(A₁ − A₂)) from 1 to 2
///
/// # Symbols
/// A_k effective acceleration from every k-th sample, as the motion has it: of positions
/// (q₃ − q₂ − q₁ + q₀)/(2 h²), of speeds (ω₁ − ω₀)/h; A that of the motion; p order of the error, 2 of a smooth motion and 1 of
/// one whose acceleration jumps
/// # Source
/// Richardson, The deferred approach to the limit, Phil. Trans. A 226 (1927)
/// # Valid
/// evenly spaced samples; `None` where the differences grow by noise instead, which [`MadeUp`](crate::MadeUp) judges: noise makes
/// A₁ − A₂ larger than A₂ − A₄
pub(crate) fn sparse(time: &[f64], values: &[f64], column: SteppedColumn) -> Option<SparseSamples> {
    let interval_s = median_interval(time);
    let is_even = time.windows(2).all(|pair| match pair {
        [a, b] => (b - a - interval_s).abs() <= EVEN * interval_s,
        _ => true,
    });
    if values.len() < LEAST || interval_s <= 0.0 || !is_even {
        return None;
    }
    let [first, second, fourth] = [1, 2, 4].map(|apart| effective(values, interval_s, apart, column));
    let (near, far) = (first - second, second - fourth);
    if !(near > 0.0 && far >= near) {
        return None;
    }
    // Where the widest differences reach over a whole move, their ratio says nothing of the order.
    let order = if fourth > REACHED * first { (far / near).log2().clamp(1.0, 2.0) } else { UNKNOWN };
    let missing = near / (order.exp2() - 1.0);
    let share = missing / (first + missing);
    (share > NOTABLE).then_some(SparseSamples { interval_s, share })
}

/// Returns the effective acceleration from samples so many rows apart, the largest of those with another first row: it is that of
/// the rows at which the acceleration jumps, if there are such.
fn effective(values: &[f64], interval_s: f64, apart: usize, column: SteppedColumn) -> f64 {
    let step = interval_s * apart as f64;
    let at = |place: usize| values.get(place).copied().unwrap_or_default();
    let reach = match column {
        SteppedColumn::Position => 3 * apart,
        SteppedColumn::Speed => apart,
    };
    let acceleration = |k: usize| match column {
        SteppedColumn::Position => {
            (at(k + 3 * apart) - at(k + 2 * apart) - at(k + apart) + at(k)) / (2.0 * step * step)
        }
        SteppedColumn::Speed => (at(k + apart) - at(k)) / step,
    };
    let of_first = |first: usize| {
        let squares = (first..values.len().saturating_sub(reach)).step_by(apart).map(|k| acceleration(k).powi(2));
        let [sum, count] = squares.fold([0.0, 0.0], |[sum, count], square| [sum + square, count + 1.0]);
        (sum / f64::max(count, 1.0)).sqrt()
    };
    (0..apart).map(of_first).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Positions and speeds of a swing with rests between, by a law with a continuous acceleration or by one whose jumps.
    fn swings(interval_s: f64, time_s: f64, jumps: bool) -> (Vec<f64>, [Vec<f64>; 2], f64) {
        let (rest, turn) = (0.5, std::f64::consts::TAU);
        let cycle = 2.0 * (time_s + rest);
        let count = (4.0 * cycle / interval_s) as usize;
        let time: Vec<f64> = (0..=count).map(|k| k as f64 * interval_s).collect();
        let of = |time: f64| {
            let place = time % cycle;
            let is_back = place >= 0.5 * cycle;
            let x = ((place % (0.5 * cycle)) / time_s).min(1.0);
            let [s, v] = if jumps {
                let half = |x: f64| [2.0 * x * x, 4.0 * x];
                if x < 0.5 { half(x) } else { [1.0 - half(1.0 - x)[0], half(1.0 - x)[1]] }
            } else {
                [x - (turn * x).sin() / turn, 1.0 - (turn * x).cos()]
            };
            if is_back { [1.0 - s, -v / time_s] } else { [s, v / time_s] }
        };
        let both = [0, 1].map(|which| time.iter().map(|time| of(*time)[which]).collect());
        // ∫ (s″)² of each law over a move: 16 of the jumping one, 2 π² of the other.
        let square = if jumps { 16.0 } else { 0.5 * turn * turn };
        let truth = (square / time_s.powi(3) / (time_s + rest)).sqrt();
        (time, both, truth)
    }

    #[test]
    fn what_is_left_out_is_about_what_the_motion_has_more() {
        for jumps in [false, true] {
            for column in [SteppedColumn::Position, SteppedColumn::Speed] {
                for interval_s in [0.002, 0.01, 0.03, 0.05, 0.07] {
                    let (time, [position, speed], truth) = swings(interval_s, 0.6, jumps);
                    let values = if column == SteppedColumn::Position { position } else { speed };
                    let share = 1.0 - effective(&values, interval_s, 1, column) / truth;
                    let found = sparse(&time, &values, column).map_or(0.0, |found| found.share);
                    // Never from a dense recording; of a sparse one at least half and at most twice.
                    assert!(share > 0.01 || found < 0.03, "{jumps} {column:?} {interval_s}: {found} of {share}");
                    assert!(
                        share < 0.05 || (0.5..2.0).contains(&(found / share)),
                        "{jumps} {column:?} {interval_s}: {found} of {share}"
                    );
                }
            }
        }
    }

    #[test]
    fn noise_is_no_motion_between_the_samples() {
        let mut state = 1_u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
        };
        for size in [1e-5, 1e-4, 1e-3] {
            let (time, [mut position, _], _) = swings(0.005, 0.6, false);
            position.iter_mut().for_each(|value| *value += size * noise());
            assert_eq!(sparse(&time, &position, SteppedColumn::Position), None, "{size}");
        }
    }
}
