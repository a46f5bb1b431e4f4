//! The order of the candidates.

use crate::check::Fit;
use crate::judge::Judgement;
use std::cmp::Ordering;

/// What the order looks at, besides the judgement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The verdict on the candidate: checks and requirements.
    pub fit: Fit,
    /// Whether something holds the load without power, or nothing has to.
    pub holds: bool,
    /// Frame size; the smaller is preferred.
    pub size: u16,
    /// Utilisation of the governing check, see [`Judgement::utilisation`].
    pub utilisation: f64,
    /// Mass in kilograms, for ties; infinite if not known.
    pub mass_kg: f64,
}

impl Standing {
    /// The standing of a judged candidate.
    #[must_use]
    pub fn of(judgement: &Judgement, requirements_met: bool, size: u16, mass_kg: Option<f64>) -> Self {
        Self {
            fit: if requirements_met { judgement.fit() } else { Fit::DoesNotFit },
            holds: !judgement.leaves_load_unheld(),
            size,
            utilisation: judgement.utilisation(),
            mass_kg: mass_kg.unwrap_or(f64::INFINITY),
        }
    }
}

/// The stated rule: what fits before what does not; among what fits, what holds a hanging load without power before what does
/// not, then what keeps within every limit before what lies inside
/// the band of an estimate, whose utilisation is above one; then the smaller frame size; then the lower utilisation, that is
/// the larger margin; then the lower mass. Among those that do not fit, the one whose governing check is exceeded least comes
/// first, then the smaller frame size: what every check would pass misses by nothing.
///
/// Equal standings keep the order in which they came, the order of the catalogue.
#[must_use]
pub fn rank(a: &Standing, b: &Standing) -> Ordering {
    RankKey::of(a).cmp(&RankKey::of(b))
}

/// The rule as what is compared one after the other: made once for each of many that are put in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RankKey {
    unfit: bool,
    /// Whether nothing holds a hanging load without power; the order of what does not fit takes no notice of it.
    unheld: bool,
    /// Whether it lies inside the band of an estimate.
    inside_band: bool,
    /// By how much it misses; nothing of what fits.
    miss: u64,
    size: u16,
    utilisation: u64,
    mass: u64,
}

impl RankKey {
    /// That of a candidate.
    #[must_use]
    pub fn of(standing: &Standing) -> Self {
        let Standing { fit, holds, size, utilisation, mass_kg } = *standing;
        let fits = fit.fits();
        Self {
            unfit: !fits,
            unheld: fits && !holds,
            inside_band: fit == Fit::FitsIfEstimate,
            miss: if fits { 0 } else { in_order(utilisation.max(1.0)) },
            size,
            utilisation: in_order(utilisation),
            mass: in_order(mass_kg),
        }
    }
}

/// A number in the order of [`f64::total_cmp`] as one that is compared at once.
pub(crate) const fn in_order(value: f64) -> u64 {
    let bits = value.to_bits();
    let negative = bits >> 63 == 1;
    if negative { !bits } else { bits | 1 << 63 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standing(fits: bool, size: u16, utilisation: f64, mass_kg: f64) -> Standing {
        let fit = match (fits, utilisation > 1.0) {
            (false, _) => Fit::DoesNotFit,
            (true, true) => Fit::FitsIfEstimate,
            (true, false) => Fit::Fits,
        };
        Standing { fit, holds: true, size, utilisation, mass_kg }
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
        let order: Vec<(bool, u16, f64, f64)> =
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
    fn numbers_keep_their_order() {
        let rising =
            [f64::NEG_INFINITY, -1.0, -0.0, 0.0, 5e-324, 0.7, 1.0, 1.0 + f64::EPSILON, f64::INFINITY, f64::NAN];
        assert!(rising.is_sorted_by(|a, b| a.total_cmp(b).is_lt() && in_order(*a) < in_order(*b)));
    }
}
