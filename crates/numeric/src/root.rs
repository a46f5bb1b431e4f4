//! Search for zeros of a function.

/// Maximum number of steps of false position before bisection; a smooth function needs no more.
const FALSE_POSITION: u32 = 12;

/// Maximum number of bisections: enough for any two numbers of the same magnitude.
const HALVINGS: u32 = 80;

/// Returns the zero of a function between two places with values of opposite sign.
///
/// Regula falsi; an end that stays counts half (Illinois). After twelve steps the bracket is bisected. The search ends
/// when two consecutive steps differ by `close` or by the last bit.
///
/// # Source
/// Dowell and Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11 (1971)
/// # Valid
/// a < b, with values of opposite sign or zero. For a smooth function with a simple zero the error is far below `close`
/// (the order of convergence is 1.44); a jump across zero and a multiple zero are found by bisection, to `close`.
#[inline]
pub fn root(
    value: impl Fn(f64) -> f64,
    (mut a, mut at_a): (f64, f64),
    (mut b, mut at_b): (f64, f64),
    close: f64,
) -> f64 {
    if at_a == 0.0 || at_b == 0.0 {
        return if at_a == 0.0 { a } else { b };
    }
    let mut s = a;
    let mut kept = None;
    for step in 0..FALSE_POSITION + HALVINGS {
        let before = s;
        s = if step < FALSE_POSITION { b - at_b * (b - a) / (at_b - at_a) } else { 0.5 * (a + b) };
        if step > 0 && (s - before).abs() <= close.max(f64::EPSILON * s.abs()) {
            break;
        }
        if !(s > a && s < b) {
            s = 0.5 * (a + b);
            if !(s > a && s < b) {
                break;
            }
        }
        let here = value(s);
        if here == 0.0 {
            break;
        }
        let keeps_a = (here < 0.0) == (at_b < 0.0);
        let behind = if kept == Some(keeps_a) { 0.5 } else { 1.0 };
        if keeps_a {
            (b, at_b, at_a) = (s, here, behind * at_a);
        } else {
            (a, at_a, at_b) = (s, here, behind * at_b);
        }
        kept = Some(keeps_a);
    }
    s
}

/// Returns the zero of a rising function from its value and slope: Newton's method, kept within a bracket.
///
/// The search ends when a step is at most `close` of the place; the error is then of second order.
///
/// # Valid
/// low < high, the value at `low` not above zero and at `high` not below; `start` between them
pub fn root_by_slope(
    value_and_slope: impl Fn(f64) -> (f64, f64),
    start: f64,
    (mut low, mut high): (f64, f64),
    close: f64,
) -> f64 {
    let mut here = start;
    for _ in 0..HALVINGS {
        let (value, slope) = value_and_slope(here);
        if value > 0.0 {
            high = here;
        } else {
            low = here;
        }
        let newton = here - value / slope;
        if (newton - here).abs() <= close * here.abs() {
            return newton;
        }
        here = if newton > low && newton < high { newton } else { f64::midpoint(low, high) };
    }
    here
}

/// Number of steps into which a span is divided in the search for roots; two roots closer than one step are not resolved.
const STEPS: u32 = 64;

/// Returns the roots of a continuous function strictly inside 0…`end`, from sign changes over [`root_steps`], each to
/// the last bits. Roots at the ends are left out.
pub fn roots(f: impl Fn(f64) -> f64, end: f64) -> Vec<f64> {
    let values: Vec<f64> = root_steps(end).map(&f).collect();
    roots_between(&values, f, end)
}

/// Iterates over the 65 places from 0 to `end` at which a search for roots evaluates the function.
pub fn root_steps(end: f64) -> impl Iterator<Item = f64> {
    (0..=STEPS).map(move |step| end * f64::from(step) / f64::from(STEPS))
}

/// Returns the roots of a function whose values at the [`root_steps`] are known.
pub fn roots_between(values: &[f64], f: impl Fn(f64) -> f64, end: f64) -> Vec<f64> {
    let mut found = Vec::new();
    // Rounding leaves values of the size of an ulp where the exact value is zero: they are no change of sign.
    let scale = values.iter().fold(0.0_f64, |scale, v| scale.max(v.abs()));
    let mut last: Option<(f64, f64)> = None;
    for (at, value) in root_steps(end).zip(values) {
        if value.abs() <= 1e-13 * scale {
            continue;
        }
        if let Some(before) = last
            && before.1 * value < 0.0
        {
            let root = root(&f, before, (at, *value), 0.0);
            if root > 0.0 && root < end {
                found.push(root);
            }
        }
        last = Some((at, *value));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    #[test]
    fn zeros_by_hand() {
        let found = |value: fn(f64) -> f64, a: f64, b: f64| root(value, (a, value(a)), (b, value(b)), 1e-14);
        assert!((found(|s| s * s - 2.0, 0.0, 2.0) - 2.0_f64.sqrt()).abs() < 1e-14);
        assert!((found(f64::cos, 0.0, 3.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
        assert!((found(|s| 1.0 - 5.0 * s, 0.0, 1.0) - 0.2).abs() < 1e-16);
        assert!((found(|s| (s - 0.3).powi(3), 0.0, 1.0) - 0.3).abs() < 1e-4, "flat there");
        assert!((found(|s| if s < 0.7 { -1.0 } else { 1e3 }, 0.0, 1.0) - 0.7).abs() < 1e-13, "a jump");
    }

    #[test]
    fn a_smooth_zero_takes_few_steps_and_none_takes_many() {
        let calls = |value: fn(f64) -> f64, close: f64| {
            let count = Cell::new(0);
            let counted = |s: f64| {
                count.set(count.get() + 1);
                value(s)
            };
            root(counted, (0.0, value(0.0)), (1.0, value(1.0)), close);
            count.get()
        };
        for value in [|s: f64| s - 0.3, |s: f64| s.exp() - 1.5, |s: f64| (7.0 * s).sin() - 0.9 * (s - 0.5)] {
            assert!(calls(value, 1e-12) <= 10, "{}", calls(value, 1e-12));
        }
        assert!(calls(|s| (s - 0.3).powi(9), 0.0) <= FALSE_POSITION + HALVINGS);
        assert!(calls(|s| if s < 1e-300 { -1e-300 } else { 1e300 }, 0.0) <= FALSE_POSITION + HALVINGS);
    }

    #[test]
    fn the_slope_leads_to_the_same_zero() {
        let rising = |s: f64| (s.exp() - 3.0, s.exp());
        assert!((root_by_slope(rising, 0.1, (0.0, 2.0), 1e-8) - 3.0_f64.ln()).abs() < 1e-14);
        // A slope that leads out of the bracket.
        let cube = |s: f64| ((s - 0.3).cbrt(), 1.0 / (3.0 * (s - 0.3).cbrt().powi(2)));
        assert!((root_by_slope(cube, 0.9, (0.0, 1.0), 1e-12) - 0.3).abs() < 1e-11);
    }

    #[test]
    fn roots_are_found_inside_and_rounding_is_none() {
        let found = roots(|t| (t - 0.25) * (t - 0.75), 1.0);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 0.25).abs() < 1e-15 && (found[1] - 0.75).abs() < 1e-15);
        assert!(roots(|t| t * (1.0 - t), 1.0).is_empty(), "roots at the ends are left out");
        assert!(roots(|t| 1.0 + 1e-16 * (t * 1e3).sin(), 1.0).is_empty());
    }

    /// A jump is found as precisely as a root.
    #[test]
    fn jumps_are_found_by_halving() {
        let found = roots(|t| if t < 0.3 { -1.0 } else { 2.0 }, 1.0);
        assert!(found.len() == 1 && (found[0] - 0.3).abs() < 1e-15, "{found:?}");
    }
}
