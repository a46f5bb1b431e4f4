//! The first place among equally high ones.

/// Relative difference up to which two values count as equally high: far below any displayed digit, far above rounding.
pub const EQUAL: f64 = 1e-9;

/// Highest of some values, and the first of the places whose values are equally high.
///
/// Two values are equally high if they differ by less than the share [`EQUAL`], so that neither another unit of an input nor
/// another order of the sums moves the place. The values may be seen in any order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct First<P> {
    value: f64,
    /// Value at the first place.
    there: f64,
    at: f64,
    place: P,
}

impl<P: Copy> First<P> {
    /// Creates the highest value of none: everything above `least` counts.
    #[must_use]
    pub const fn above(least: f64, place: P) -> Self {
        Self { value: least, there: least, at: f64::NEG_INFINITY, place }
    }

    /// Adds the value of a place at an instant.
    #[inline]
    pub fn see(&mut self, value: f64, at: f64, place: P) {
        let is_higher = value > self.value;
        if is_higher {
            self.value = value;
        }
        let is_far = self.there < equal_to(self.value);
        if (is_higher && is_far) || (at < self.at && value >= equal_to(self.value)) {
            *self = Self { there: value, at, place, ..*self };
        }
    }

    /// Returns `true` if a bound of the values from an instant on permits a value that is higher by more than a share, or
    /// an equally high one before the first.
    #[inline]
    #[must_use]
    pub fn permits(&self, bound: f64, from: f64, share: f64) -> bool {
        let is_higher = bound > self.value;
        (is_higher && (self.value.is_infinite() || bound - self.value > share * self.value.abs()))
            || (from < self.at && bound >= equal_to(self.value))
    }

    /// Returns the highest value.
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// Returns the instant of the first place.
    #[must_use]
    pub const fn at(&self) -> f64 {
        self.at
    }

    /// Returns the first place.
    #[must_use]
    pub const fn place(&self) -> P {
        self.place
    }
}

/// Returns the least value that is as high as another.
#[inline]
fn equal_to(value: f64) -> f64 {
    if value.is_infinite() { value } else { value - EQUAL * value.abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns value and instant of some values, each seen at its own place.
    fn first(all: &[(f64, f64)]) -> (f64, f64) {
        let mut first = First::above(f64::NEG_INFINITY, 0.0);
        for (value, at) in all {
            first.see(*value, *at, *at);
        }
        assert_eq!(first.at(), first.place());
        (first.value(), first.at())
    }

    #[test]
    fn the_first_of_equals_counts_in_any_order() {
        let low = 5.0 * (1.0 - 1e-15);
        let all = [(4.0, 0.0), (low, 1.0), (5.0, 2.0), (low, 3.0), (4.999, 0.5)];
        for turn in 0..all.len() {
            let mut turned = all;
            turned.rotate_left(turn);
            assert_eq!(first(&turned), (5.0, 1.0));
            turned.reverse();
            assert_eq!(first(&turned), (5.0, 1.0));
        }
        // What differs by more than rounding is another height; negative and infinite values too.
        assert_eq!(first(&[(5.0 - 1e-6, 0.0), (5.0, 1.0)]), (5.0, 1.0));
        assert_eq!(first(&[(-2.0, 3.0), (-2.0 - 1e-12, 1.0), (-7.0, 0.0)]), (-2.0, 1.0));
        assert_eq!(first(&[(f64::INFINITY, 2.0), (f64::INFINITY, 4.0), (1.0, 0.0)]), (f64::INFINITY, 2.0));
        assert_eq!(first(&[(0.0, 2.0), (0.0, 1.0)]), (0.0, 1.0));
    }

    #[test]
    fn a_bound_permits_what_counts() {
        let mut first = First::above(f64::NEG_INFINITY, ());
        assert!(first.permits(-1e300, 9.0, 1e-9) && first.permits(f64::INFINITY, 9.0, 1e-9));
        first.see(5.0, 2.0, ());
        assert!(
            first.permits(5.0, 1.0, 0.1) && first.permits(5.1, 3.0, 0.01) && first.permits(f64::INFINITY, 3.0, 0.1)
        );
        assert!(!first.permits(5.0, 2.0, 0.0) && !first.permits(4.9, 1.0, 0.0) && !first.permits(5.1, 3.0, 0.1));
    }
}
