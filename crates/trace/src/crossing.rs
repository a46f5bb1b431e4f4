//! Where a function passes zero.

/// So many steps at most.
const STEPS: usize = 100;

/// From so many steps on every other one halves: what is so slow is no smooth function.
const SMOOTH: usize = 12;

/// Where a function passes zero between two places with values of opposite sign, as closely as is asked for.
///
/// Regula falsi; the end that stays behind counts half (Illinois). It ends where two steps that follow upon each other are
/// close.
///
/// # Source   Dowell and Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11 (1971)
/// # Valid    one value is above zero and the other below; a jump over zero is found too
#[inline]
pub fn crossing(
    value: impl Fn(f64) -> f64,
    (mut a, mut at_a): (f64, f64),
    (mut b, mut at_b): (f64, f64),
    close: f64,
) -> f64 {
    let mut s = a;
    let mut kept = None;
    for step in 0..STEPS {
        let before = s;
        s = if step > SMOOTH && step % 2 == 0 { 0.5 * (a + b) } else { b - at_b * (b - a) / (at_b - at_a) };
        let here = value(s);
        if here == 0.0 || (s - before).abs() <= close {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_by_hand() {
        let found = |value: fn(f64) -> f64, a: f64, b: f64| crossing(value, (a, value(a)), (b, value(b)), 1e-14);
        assert!((found(|s| s * s - 2.0, 0.0, 2.0) - 2.0_f64.sqrt()).abs() < 1e-14);
        assert!((found(f64::cos, 0.0, 3.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
        assert!((found(|s| 1.0 - 5.0 * s, 0.0, 1.0) - 0.2).abs() < 1e-16);
        assert!((found(|s| (s - 0.3).powi(3), 0.0, 1.0) - 0.3).abs() < 1e-4, "flat there");
        assert!((found(|s| if s < 0.7 { -1.0 } else { 1e3 }, 0.0, 1.0) - 0.7).abs() < 1e-9, "a jump");
    }
}
