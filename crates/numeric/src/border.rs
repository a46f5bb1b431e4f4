//! Search for the boundary of the region in which a function is at most zero.

/// Number of steps beyond bisection that the search may use for interpolation.
const FREE: i32 = 4;

/// Returns both sides of the border between a place `good`, where a function is at most zero, and a place `bad` above it,
/// where it exceeds zero: at most `narrow` times the distance of the two apart, the good side first.
///
/// Inverse quadratic interpolation through both ends and the previous end, kept close enough to the middle that the
/// search needs at most four steps more than bisection; for a smooth function five to eight suffice. Once the
/// interpolation stays within the remaining distance of an end, the next step goes just beyond it. The function may
/// jump, and may be infinite above.
///
/// # Source
/// Chandrupatla, A new hybrid quadratic/bisection algorithm, Adv. Eng. Softw. 28 (1997), for where the
/// interpolation is trusted; Oliveira and Takahashi, ACM TOMS 47 (2020), for the projection, with n_0 = 4
/// # Errors
/// Errors of the function.
pub fn border<S>(
    mut excess: impl FnMut(f64) -> Result<f64, S>,
    mut good: (f64, f64),
    mut bad: (f64, f64),
    narrow: f64,
) -> Result<(f64, f64), S> {
    let whole = bad.0 - good.0;
    // Width of a bisection with the same number of steps; interpolation may use what exceeds half the width.
    let mut halved = whole * 2.0_f64.powi(FREE - 1);
    let step = 0.9 * whole * narrow;
    let mut before = None;
    while bad.0 - good.0 > whole * narrow {
        let width = bad.0 - good.0;
        let middle = good.0 + 0.5 * width;
        let beside = step.min(0.5 * width);
        let within = interpolated(good, bad, before).clamp(good.0 + beside, bad.0 - beside);
        let free = (halved - 0.5 * width).max(0.0);
        let at = within.clamp(middle - free, middle + free);
        halved *= 0.5;
        let found = (at, excess(at)?);
        let end = if found.1 <= 0.0 { &mut good } else { &mut bad };
        before = Some(std::mem::replace(end, found));
    }
    Ok((good.0, bad.0))
}

/// Returns the place where the function should be zero between two ends, from them and the end that one of them
/// replaced: by linear, later by inverse quadratic interpolation if the parabola has one branch between the ends.
/// Returns the middle if neither is reliable.
fn interpolated((a, at_a): (f64, f64), (b, at_b): (f64, f64), before: Option<(f64, f64)>) -> f64 {
    let found = match before {
        None => (at_b * a - at_a * b) / (at_b - at_a),
        Some((c, at_c)) => {
            // The end found last, and the one on the other side of the root.
            let ((new, at_new), (far, at_far)) =
                if (at_c <= 0.0) == (at_a <= 0.0) { ((a, at_a), (b, at_b)) } else { ((b, at_b), (a, at_a)) };
            let (place, height) = ((new - far) / (c - far), (at_new - at_far) / (at_c - at_far));
            let is_one_branch = height * height < place && (1.0 - height) * (1.0 - height) < 1.0 - place;
            let share = at_new / (at_far - at_new) * at_c / (at_far - at_c)
                + (c - new) / (far - new) * at_new / (at_c - at_new) * at_far / (at_c - at_far);
            if is_one_branch { new + share * (far - new) } else { f64::NAN }
        }
    };
    if found.is_finite() { found } else { 0.5 * (a + b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_border_is_found_in_few_steps_and_never_in_many() {
        use std::cell::Cell;
        const HALVINGS: u32 = 30;
        let calls = Cell::new(0);
        let steps = |excess: &dyn Fn(f64) -> f64| {
            calls.set(0);
            let (good, bad) = ((1.0, excess(1.0)), (1.1, excess(1.1)));
            let counted = |x: f64| {
                calls.set(calls.get() + 1);
                Ok::<_, std::convert::Infallible>(excess(x))
            };
            let Ok((found, above)) = border(counted, good, bad, 0.5_f64.powi(HALVINGS as i32));
            assert!(excess(found) <= 0.0 && excess(above) > 0.0, "{found}, {above}");
            (found, calls.get())
        };
        let root = 1.037_f64;
        let smooth: [&dyn Fn(f64) -> f64; 4] =
            [&|x| x / root - 1.0, &|x| (x / root).powi(3) - 1.0, &|x| 1.0 - (root / x).powi(2), &|x| {
                (x / root).powi(12) - 1.0
            }];
        for excess in smooth {
            let (found, calls) = steps(excess);
            assert!(found <= root && root - found < 1e-10 && calls <= 7, "{found}, {calls} calls");
        }
        // One branch replaces another near the border.
        let bent = |x: f64| f64::max(x - root, 5.0 * (x - root - 1e-5));
        let (found, calls) = steps(&bent);
        assert!(found <= root && root - found < 1e-10 && calls <= 25, "{found}, {calls} calls");
        // A jump, one to infinity, and one from the last bit below zero.
        let rough: [&dyn Fn(f64) -> f64; 3] =
            [&|x| if x <= root { -0.5 } else { 0.5 }, &|x| if x <= root { -0.5 } else { f64::INFINITY }, &|x| {
                if x <= root { -f64::EPSILON } else { x }
            }];
        for excess in rough {
            let (found, calls) = steps(excess);
            assert!(found <= root && root - found < 2e-10 && calls <= HALVINGS + 5, "{found}, {calls} calls");
        }
    }
}
