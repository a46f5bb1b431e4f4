//! Stretches of samples: runs of slow ones, travel and range.

use std::ops::Range;

/// Number of samples of a move that must be smooth for its end to be found.
pub(crate) const SMOOTH: usize = 5;

/// Returns the longest runs of samples within a range that are no faster than `most`.
pub(crate) fn runs(speed: &[f64], within: Range<usize>, most: f64) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut start = None;
    for index in within.clone() {
        let is_slow = speed.get(index).is_some_and(|speed| speed.abs() <= most);
        match (is_slow, start) {
            (true, None) => start = Some(index),
            (false, Some(from)) => {
                found.push(from..index);
                start = None;
            }
            _ => {}
        }
    }
    found.extend(start.map(|from| from..within.end));
    found
}

/// Iterates over the travel up to each sample, by the trapezoidal rule.
pub(crate) fn travelled<'v>(time: &'v [f64], speed: &'v [f64]) -> impl Iterator<Item = f64> + 'v {
    let points = || time.iter().zip(speed);
    let parts = points().zip(points().skip(1)).map(|((t0, w0), (t1, w1))| 0.5 * (w0 + w1) * (t1 - t0));
    std::iter::once(0.0).chain(parts.scan(0.0, |sum, part| {
        *sum += part;
        Some(*sum)
    }))
}

/// Returns the difference of the largest and the smallest value.
pub(crate) fn range(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    (high - low).max(0.0)
}

/// Returns the number of samples of a rest that continue a move without noise; `None` if the last samples of the move
/// are not smooth. The first `outside` speeds belong to the move.
pub(crate) fn smooth_end(speeds: impl Iterator<Item = f64>, outside: usize, near: f64) -> Option<usize> {
    if outside < SMOOTH {
        return None;
    }
    let mut last = [0.0; SMOOTH - 1];
    let mut count = 0;
    for (index, speed) in speeds.enumerate() {
        let [a, b, c, d] = last;
        let is_smooth = index < SMOOTH - 1 || (speed - (4.0 * (d + b) - 6.0 * c - a)).abs() <= near;
        match (is_smooth, index < outside) {
            (true, true) => {}
            (true, false) => count += 1,
            (false, true) => return None,
            (false, false) => break,
        }
        last = [b, c, d, speed];
    }
    Some(count)
}
