//! Search for the largest value of a curve between known places.

/// Maximum number of parabolas.
const STEPS: u32 = 24;

/// Returns place and value of the highest point of a smooth curve near three places in order, by successive parabolas:
/// each vertex replaces the farthest of the three points of the last parabola.
///
/// The search ends when a parabola promises nothing above `enough` or the known values, or when the value at its vertex
/// agrees to `close`; the error is then of second order for a smooth curve.
///
/// # Valid
/// A maximum between the outer two places; if there are several, any of them. The result is a value of the curve and at
/// least the largest of the three.
pub fn highest(
    value: impl Fn(f64) -> f64,
    [mut a, mut b, mut c]: [(f64, f64); 3],
    mut enough: f64,
    close: f64,
) -> (f64, f64) {
    let mut best = [a, c].into_iter().fold(b, |best, end| if end.1 > best.1 { end } else { best });
    for _ in 0..STEPS {
        enough = enough.max(best.1);
        let Some((s, height)) = vertex(a, b, c).filter(|(_, height)| *height > enough) else { break };
        let found = (s, value(s));
        if found.1 > best.1 {
            best = found;
        }
        if (height - found.1).abs() <= close * best.1.abs() {
            break;
        }
        (a, b, c) = match (found.1 > b.1, s > b.0) {
            (true, true) => (b, found, c),
            (true, false) => (a, found, b),
            (false, true) => (a, b, found),
            (false, false) => (found, b, c),
        };
    }
    best
}

/// Returns the vertex of the parabola through three points, strictly between the outer two; `None` if the parabola
/// opens upwards.
#[must_use]
pub fn vertex(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<(f64, f64)> {
    let (left, right) = ((b.1 - a.1) / (b.0 - a.0), (c.1 - b.1) / (c.0 - b.0));
    let bend = (right - left) / (c.0 - a.0);
    let s = 0.5 * (a.0 + b.0 - left / bend);
    let height = a.1 + left * (s - a.0) + bend * (s - a.0) * (s - b.0);
    (bend < 0.0 && s > a.0 && s < c.0 && s != b.0).then_some((s, height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_by_hand() {
        let peak = |f: fn(f64) -> f64, at: [f64; 3]| highest(f, at.map(|s| (s, f(s))), f64::NEG_INFINITY, 1e-15);
        let (s, value) = peak(|s| 3.0 - (s - 0.7).powi(2), [0.0, 0.5, 1.0]);
        assert!((s - 0.7).abs() < 1e-15 && (value - 3.0).abs() < 1e-15);
        let (s, value) = peak(f64::sin, [0.4, 1.0, 2.9]);
        assert!((s - std::f64::consts::FRAC_PI_2).abs() < 1e-7 && (value - 1.0).abs() < 1e-15, "{s} {value}");
        let (_, value) = peak(|s| (s * s * (1.0 - s)).sqrt(), [0.2, 0.5, 0.95]);
        assert!((value - (4.0_f64 / 27.0).sqrt()).abs() < 1e-14, "{value}");
        // A monotonically rising curve is highest at its end.
        assert_eq!(peak(f64::exp, [0.0, 0.5, 1.0]), (1.0, 1.0_f64.exp()));
    }

    #[test]
    fn nothing_is_sought_below_what_is_enough() {
        let f = |_: f64| unreachable!();
        let [a, b, c] = [(0.0, 0.0), (0.4, 0.9), (1.0, 0.0)];
        assert_eq!(highest(f, [a, b, c], 2.0, 1e-9), b);
    }
}
