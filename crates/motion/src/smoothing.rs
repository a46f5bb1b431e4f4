//! Smoothing of samples by a moving parabola.

use crate::faults::RecordedFault;
use quantities::{Measure, Time};
use std::ops::Range;

/// Returns value and slope, at each sample, of the parabola fitted to the samples within half a window on both sides.
///
/// Least squares of y = a + b τ + c τ², τ = t − t_k; the window is cut off at the ends. Positions and speeds up to the
/// second degree are reproduced. A window wider than the recording is refused: at every instant it would be cut off at an
/// end, up to one parabola through all samples.
pub(crate) fn smooth(time: &[f64], values: &[f64], window: f64) -> Result<(Vec<f64>, Vec<f64>), RecordedFault> {
    // Samples at the edge belong to the window despite rounding of their instants.
    let half = 0.5 * window * (1.0 + 1e-9);
    let duration = time.first().zip(time.last()).map_or(0.0, |(first, last)| last - first);
    if window > duration * (1.0 + 1e-9) {
        let [window, duration] = [window, duration].map(Time::from_si);
        return Err(RecordedFault::WindowOverMotion { window, duration });
    }
    let mut fitted = (Vec::with_capacity(time.len()), Vec::with_capacity(time.len()));
    let groups = Sums::of_groups(time, values, half);
    let (mut from, mut to) = (0, 0);
    for t in time {
        while time.get(from).is_some_and(|first| t - first > half) {
            from += 1;
        }
        while time.get(to).is_some_and(|last| last - t <= half) {
            to += 1;
        }
        if to - from > WINDOW_MOST {
            return Err(RecordedFault::WindowTooLong { most: WINDOW_MOST });
        }
        // The window must determine a parabola even where it is cut off at an end.
        if to - from < 4 {
            let gap = time.windows(2).filter_map(|pair| Some(pair.last()? - pair.first()?)).fold(0.0, f64::max);
            let least = Some(6.0 * gap).filter(|least| *least <= duration * (1.0 + 1e-9));
            return Err(RecordedFault::WindowTooShort { least: least.map(Time::from_si) });
        }
        let mut sums = Sums::default();
        let mut take = |range: Range<usize>| {
            let near = time.get(range.clone()).unwrap_or_default().iter().zip(values.get(range).unwrap_or_default());
            near.for_each(|(other, y)| sums.take((other - t) / half, *y));
        };
        let whole = from.div_ceil(GROUP)..to / GROUP;
        if whole.len() < 2 {
            take(from..to);
        } else {
            take(from..whole.start * GROUP);
            take(whole.end * GROUP..to);
            let inside = groups.get(whole).unwrap_or_default();
            inside.iter().for_each(|(middle, group)| sums.take_group(group, (middle - t) / half));
        }
        let (value, slope) = sums.parabola();
        fitted.0.push(value);
        fitted.1.push(slope / half);
    }
    Ok(fitted)
}

/// Smooths like [`smooth`] samples of one cycle of a motion that repeats: a window at an end holds the samples of the other
/// end too. `gap`: difference of the last and the first value, without their noise.
fn smooth_closed(time: &[f64], values: &[f64], window: f64, gap: f64) -> Result<(Vec<f64>, Vec<f64>), RecordedFault> {
    let half = 0.5 * window * (1.0 + 1e-9);
    let (start, end) = (time.first().copied().unwrap_or(0.0), time.last().copied().unwrap_or(0.0));
    let period = end - start;
    // Both ends are the same instant of the cycle.
    let (first, last) = (values.first().copied().unwrap_or(0.0), values.last().copied().unwrap_or(0.0));
    let middle = f64::midpoint(first, last - gap);
    let count = time.len();
    let own = time.iter().zip(values).enumerate().map(|(place, (t, y))| match place {
        0 => (*t, middle),
        place if place + 1 == count => (*t, middle + gap),
        _ => (*t, *y),
    });
    let inside = || time.iter().zip(values).take(count.saturating_sub(1)).skip(1);
    let before = inside().skip_while(|(t, _)| end - **t > half).map(|(t, y)| (t - period, y - gap));
    let behind = inside().take_while(|(t, _)| **t - start <= half).map(|(t, y)| (t + period, y + gap));
    let before: Vec<(f64, f64)> = before.collect();
    let skipped = before.len();
    let (times, extended): (Vec<f64>, Vec<f64>) = before.into_iter().chain(own).chain(behind).unzip();
    let (value, slope) = smooth(&times, &extended, window)?;
    let of_cycle = |all: Vec<f64>| all.into_iter().skip(skipped).take(count).collect();
    Ok((of_cycle(value), of_cycle(slope)))
}

/// Smooths samples; those of a cycle that repeats over its ends, with the gap of their values.
pub(crate) fn smooth_by(
    time: &[f64],
    values: &[f64],
    window: f64,
    gap: Option<f64>,
) -> Result<(Vec<f64>, Vec<f64>), RecordedFault> {
    gap.map_or_else(|| smooth(time, values, window), |gap| smooth_closed(time, values, window, gap))
}

/// Returns three standard errors of the difference of two fits at the ends of samples, for a factor of one.
///
/// A parabola through m samples of a half window h has at its end the standard errors 3 σ/√m of its value and
/// √192 σ/(h √m) of its slope; σ is the deviation of the samples from the smoothed ones.
pub(crate) fn end_error(raw: &[f64], smoothed: &[f64], samples: f64) -> f64 {
    let squares = raw.iter().zip(smoothed).map(|(raw, smoothed)| (raw - smoothed).powi(2)).sum::<f64>();
    #[allow(clippy::cast_precision_loss, reason = "a count far below 2^52")]
    let deviation = (squares / raw.len().max(1) as f64).sqrt();
    3.0 * std::f64::consts::SQRT_2 * deviation / samples.max(1.0).sqrt()
}

/// Largest number of samples in one smoothing window.
const WINDOW_MOST: usize = 10_001;

/// Number of samples of a long window that are added at once.
const GROUP: usize = 64;

/// Sums of the powers of x and of their products with y, from which the parabola of least squares follows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Sums {
    /// Σ 1, Σ x, … Σ x⁴
    s: [f64; 5],
    /// Σ y, Σ x y, Σ x² y
    r: [f64; 3],
}

impl Sums {
    fn take(&mut self, x: f64, y: f64) {
        let x2 = x * x;
        for (sum, term) in self.s.iter_mut().zip([1.0, x, x2, x2 * x, x2 * x2]) {
            *sum += term;
        }
        for (sum, term) in self.r.iter_mut().zip([y, x * y, x2 * y]) {
            *sum += term;
        }
    }

    /// Adds samples whose sums are known about a point at distance d: x = d + x', so that Σ xᵏ follows from the sums of
    /// the powers up to k by the binomial theorem. Within a window |d| ≤ 1, without more cancellation than in the sums
    /// themselves.
    fn take_group(&mut self, group: &Self, d: f64) {
        let ([s0, s1, s2, s3, s4], [r0, r1, r2]) = (group.s, group.r);
        let d2 = d * d;
        let moved = [
            s0,
            s1 + d * s0,
            s2 + 2.0 * d * s1 + d2 * s0,
            s3 + 3.0 * d * s2 + 3.0 * d2 * s1 + d2 * d * s0,
            s4 + 4.0 * d * s3 + 6.0 * d2 * s2 + 4.0 * d2 * d * s1 + d2 * d2 * s0,
        ];
        self.s.iter_mut().zip(moved).for_each(|(sum, term)| *sum += term);
        let moved = [r0, r1 + d * r0, r2 + 2.0 * d * r1 + d2 * r0];
        self.r.iter_mut().zip(moved).for_each(|(sum, term)| *sum += term);
    }

    /// Returns the sums of each [`GROUP`] of samples about its middle instant, with that instant.
    fn of_groups(time: &[f64], values: &[f64], half: f64) -> Vec<(f64, Self)> {
        let groups = time.chunks(GROUP).zip(values.chunks(GROUP));
        groups
            .map(|(time, values)| {
                let middle = time.get(time.len() / 2).copied().unwrap_or(0.0);
                let mut sums = Self::default();
                time.iter().zip(values).for_each(|(t, y)| sums.take((t - middle) / half, *y));
                (middle, sums)
            })
            .collect()
    }

    /// Returns value and slope at zero of the parabola of least squares.
    fn parabola(&self) -> (f64, f64) {
        let ([s0, s1, s2, s3, s4], [r0, r1, r2]) = (self.s, self.r);
        let (m00, m01, m02) = (s2 * s4 - s3 * s3, s2 * s3 - s1 * s4, s1 * s3 - s2 * s2);
        let (m11, m12) = (s0 * s4 - s2 * s2, s1 * s2 - s0 * s3);
        let determinant = s0 * m00 + s1 * m01 + s2 * m02;
        ((m00 * r0 + m01 * r1 + m02 * r2) / determinant, (m01 * r0 + m11 * r1 + m12 * r2) / determinant)
    }
}

/// Returns the error of the slope at the first sample from the third difference of four samples: the first four or,
/// with smoothing, those that divide the window there into thirds.
///
/// The parabola through three samples deviates from the slope of a cubic by h_0 (h_0 + h_1) y'''/6; that of least
/// squares over a half window W by W² y'''/10.
pub(crate) fn slope_error(time: &[f64], values: &[f64], half_window: f64) -> f64 {
    let first = time.first().copied().unwrap_or(0.0);
    let later = |share: f64, least: usize| {
        time.partition_point(|t| (t - first).abs() < share * half_window * (1.0 - 1e-9)).max(least)
    };
    let at = [0, later(1.0 / 3.0, 1), later(2.0 / 3.0, 2), later(1.0, 3)];
    let point = |index: usize| time.get(index).copied().zip(values.get(index).copied());
    let [Some((t0, y0)), Some((t1, y1)), Some((t2, y2)), Some((t3, y3))] = at.map(point) else { return 0.0 };
    let (d01, d12, d23) = ((y1 - y0) / (t1 - t0), (y2 - y1) / (t2 - t1), (y3 - y2) / (t3 - t2));
    let third = ((d23 - d12) / (t3 - t1) - (d12 - d01) / (t2 - t0)) / (t3 - t0);
    // The third difference is a sixth of the mean third derivative over the samples, between which it may vary as in a
    // motion law: hence a factor of two.
    (2.0 * third * if half_window > 0.0 { 0.6 * half_window * half_window } else { (t1 - t0) * (t2 - t0) }).abs()
}

/// Returns [`slope_error`] at the last sample.
pub(crate) fn slope_error_at_end(time: &[f64], values: &[f64], half_window: f64) -> f64 {
    // Only samples within the window, or the last four, are reversed.
    let last = time.last().copied().unwrap_or(0.0);
    let from = time.partition_point(|t| last - t > half_window).min(time.len().saturating_sub(4)).saturating_sub(1);
    let turned = |values: &[f64]| values.get(from..).unwrap_or_default().iter().rev().copied().collect::<Vec<f64>>();
    slope_error(&turned(time), &turned(values), half_window)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_window_gives_the_parabola_that_its_samples_give_one_by_one() {
        // Irregular instants, a signal far from zero, windows from a few samples to nearly all.
        let mut time = vec![0.0];
        for k in 1..3000_u32 {
            time.push(time[time.len() - 1] + 1e-3 * (1.0 + 0.5 * f64::from(k * 7919 % 101) / 101.0));
        }
        let values: Vec<f64> = time.iter().map(|t| 700.0 + 3.0 * (2.0 * t).sin() + 0.1 * (311.0 * t).cos()).collect();
        for window in [0.02, 0.2, 0.35, 1.0, 3.0] {
            let (value, slope) = smooth(&time, &values, window).unwrap();
            let half = 0.5 * window * (1.0 + 1e-9);
            for (k, t) in time.iter().enumerate().step_by(37) {
                let mut sums = Sums::default();
                let near = time.iter().zip(&values).filter(|(other, _)| (*other - t).abs() <= half);
                near.for_each(|(other, y)| sums.take((other - t) / half, *y));
                let (one_value, one_slope) = sums.parabola();
                assert!((value[k] - one_value).abs() < 1e-9, "{window} {t}: {} {one_value}", value[k]);
                assert!((slope[k] - one_slope / half).abs() * half < 1e-9, "{window} {t}: {}", slope[k]);
            }
        }
    }
}
