//! Comparison of a value with a limit.

/// Relative tolerance of every comparison with a limit, so that the rounding of a unit, a sum or a search does not
/// decide a verdict.
pub const AT_THE_LIMIT: f64 = 1e-9;

/// Returns `true` if a value is at most a limit, up to [`AT_THE_LIMIT`] of it.
///
/// A comparison with NaN is `false`.
#[must_use]
pub fn at_most(value: f64, limit: f64) -> bool {
    value <= limit || value <= limit + AT_THE_LIMIT * limit.abs()
}

/// Returns `true` if a value is at least a limit, up to [`AT_THE_LIMIT`] of it.
#[must_use]
pub fn at_least(value: f64, limit: f64) -> bool {
    value >= limit || value >= limit - AT_THE_LIMIT * limit.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_decides_nothing_and_a_millionth_does() {
        for limit in [1e-9, 0.3, 1.963_495_408_493_620_7, 40.0, 1e12] {
            for share in [1.0, 1.0 + 1e-12, 1.0 - 1e-12, 1.0 - 1e-6] {
                assert!(at_most(limit * share, limit), "{limit} {share}");
            }
            for share in [1.0, 1.0 + 1e-12, 1.0 - 1e-12, 1.0 + 1e-6] {
                assert!(at_least(limit * share, limit), "{limit} {share}");
            }
            assert!(!at_most(limit * (1.0 + 1e-6), limit) && !at_least(limit * (1.0 - 1e-6), limit));
            assert!(at_most(-limit, -limit * (1.0 + 1e-12)) && !at_most(-limit, -limit * (1.0 + 1e-6)));
        }
        assert!(at_most(0.0, 0.0) && at_least(0.0, 0.0) && !at_most(f64::MIN_POSITIVE, 0.0));
        assert!(!at_most(f64::NAN, 1.0) && !at_least(f64::NAN, 1.0));
        assert!(at_most(1.0, f64::INFINITY) && at_least(f64::INFINITY, f64::INFINITY));
    }
}
