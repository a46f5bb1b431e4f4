//! Order of the candidates.

use crate::check::Fit;
use crate::judge::Judgement;
use std::cmp::Ordering;

/// Data that the order uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Verdict on the candidate: checks and requirements.
    pub fit: Fit,
    /// The load is held without power, or need not be.
    pub holds: bool,
    /// Frame size, the smaller of which is preferred; where products without frame sizes compete, the mass \[g\].
    pub size: u32,
    /// Utilisation of the governing check, see [`Judgement::utilisation`].
    pub utilisation: f64,
    /// Number of failing checks.
    pub failing: usize,
    /// Mass \[kg\], for ties; infinite if unknown.
    pub mass_kg: f64,
}

impl Standing {
    /// Returns the standing of a judged candidate.
    #[must_use]
    pub fn of(judgement: &Judgement, requirements_met: bool, size: u32, mass_kg: Option<f64>) -> Self {
        Self {
            fit: if requirements_met { judgement.fit() } else { Fit::DoesNotFit },
            holds: !judgement.leaves_load_unheld(),
            size,
            utilisation: judgement.utilisation(),
            failing: judgement.failing(),
            mass_kg: mass_kg.unwrap_or(f64::INFINITY),
        }
    }
}

/// Compares by the stated rule: fitting before others; among fitting ones, those that hold a load under gravity or
/// tension without power first, then those within every limit before those inside the band of an estimate, whose
/// utilisation is above one; then the smaller frame size, or the lower mass
/// where products without frame sizes compete; then the lower utilisation, i.e. the larger margin; then the
/// lower mass. Among those that do not fit, the one whose governing check is exceeded least comes first, to a tenth of a
/// percent as it is printed; then the one with the fewest failing checks, then the smaller frame size; one that every
/// check would pass has an excess of zero.
///
/// Equal standings keep their original order, that of the catalogue.
#[must_use]
pub fn rank(a: &Standing, b: &Standing) -> Ordering {
    RankKey::of(a).cmp(&RankKey::of(b))
}

/// Sort key of the rule, computed once for each of many candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RankKey {
    unfit: bool,
    /// A load under gravity or tension is not held without power; ignored for candidates that do not fit.
    unheld: bool,
    /// The candidate is inside the band of an estimate.
    inside_band: bool,
    /// Excess in tenths of a percent; zero for a fitting candidate.
    miss: u64,
    /// Number of failing checks; zero for a fitting candidate.
    failing: usize,
    size: u32,
    utilisation: u64,
    mass: u64,
}

impl RankKey {
    /// Returns the key of a candidate.
    #[must_use]
    pub fn of(standing: &Standing) -> Self {
        let Standing { fit, holds, size, utilisation, failing, mass_kg } = *standing;
        let fits = fit.fits();
        Self {
            unfit: !fits,
            unheld: fits && !holds,
            inside_band: fit == Fit::FitsIfEstimate,
            miss: if fits { 0 } else { in_order((utilisation.max(1.0) * 1000.0).round()) },
            failing: if fits { 0 } else { failing },
            size,
            utilisation: in_order(utilisation),
            mass: in_order(mass_kg),
        }
    }
}

/// Returns an integer whose order is that of [`f64::total_cmp`].
pub(crate) const fn in_order(value: f64) -> u64 {
    let bits = value.to_bits();
    let negative = bits >> 63 == 1;
    if negative { !bits } else { bits | 1 << 63 }
}

/// Returns an integer whose order is that of the values rounded to 31 binary digits (4.7 · 10⁻¹⁰), so that values that
/// differ only by the rounding of their computation are equal.
pub(crate) const fn up_to_rounding(value: f64) -> u64 {
    const DROPPED: u32 = f64::MANTISSA_DIGITS - 31;
    (in_order(value) >> (DROPPED - 1)).div_ceil(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_differ_by_rounding_are_equal_and_keep_their_order_otherwise() {
        let mut random = numeric::Random::new(7);
        for _ in 0..10_000 {
            let value = 2.0_f64.powf(40.0 * random.uniform() - 20.0);
            // Half of a step may lie between two neighbours; they differ by one step then.
            let next = up_to_rounding(value.next_up()).abs_diff(up_to_rounding(value));
            assert!(next <= 1, "{value}");
            assert!(up_to_rounding(value * (1.0 + 1e-8)) > up_to_rounding(value), "{value}");
            assert!(up_to_rounding(-value) < up_to_rounding(-value * (1.0 - 1e-8)), "{value}");
        }
        let share = 5.0_f64 / 14.0;
        assert_eq!(up_to_rounding(share), up_to_rounding(share.next_up().next_up()));
        assert!(up_to_rounding(f64::INFINITY) > up_to_rounding(f64::MAX / 2.0));
        assert!(up_to_rounding(0.0) > up_to_rounding(-1e-300));
    }

    fn standing(fits: bool, size: u32, utilisation: f64, mass_kg: f64) -> Standing {
        let fit = match (fits, utilisation > 1.0) {
            (false, _) => Fit::DoesNotFit,
            (true, true) => Fit::FitsIfEstimate,
            (true, false) => Fit::Fits,
        };
        Standing { fit, holds: true, size, utilisation, failing: 1, mass_kg }
    }

    #[test]
    fn fitting_first_then_certain_then_smallest_then_widest_margin_then_lightest() {
        let mut field = [
            standing(false, 14, 1.2, 1.0),
            standing(true, 25, 0.4, 5.0),
            standing(false, 14, 3.0, 1.0),
            standing(true, 20, 0.9, 3.2),
            standing(true, 20, 0.9, 3.1),
            standing(true, 20, 0.8, 4.2),
            standing(true, 14, 1.05, 1.4),
        ];
        field.sort_by(rank);
        let order: Vec<(bool, u32, f64, f64)> =
            field.iter().map(|s| (s.fit.fits(), s.size, s.utilisation, s.mass_kg)).collect();
        assert_eq!(
            order,
            vec![
                (true, 20, 0.8, 4.2),
                (true, 20, 0.9, 3.1),
                (true, 20, 0.9, 3.2),
                (true, 25, 0.4, 5.0),
                (true, 14, 1.05, 1.4),
                (false, 14, 1.2, 1.0),
                (false, 14, 3.0, 1.0),
            ]
        );
    }

    #[test]
    fn of_equal_excess_as_printed_the_one_with_fewer_failing_checks_comes_first() {
        let of = |utilisation, failing| Standing { failing, ..standing(false, 58, utilisation, 32.0) };
        assert_eq!(rank(&of(1.867_9, 1), &of(1.867_6, 3)), Ordering::Less, "both print 186.8 %");
        assert_eq!(rank(&of(1.861, 3), &of(1.867_9, 1)), Ordering::Less);
        assert_eq!(rank(&of(f64::INFINITY, 1), &of(f64::MAX, 1)), Ordering::Greater);
    }

    #[test]
    fn numbers_keep_their_order() {
        let rising =
            [f64::NEG_INFINITY, -1.0, -0.0, 0.0, 5e-324, 0.7, 1.0, 1.0 + f64::EPSILON, f64::INFINITY, f64::NAN];
        assert!(rising.is_sorted_by(|a, b| a.total_cmp(b).is_lt() && in_order(*a) < in_order(*b)));
    }
}
