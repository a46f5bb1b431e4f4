//! The order of the candidates.

use crate::judge::Judgement;
use std::cmp::Ordering;

/// What the order looks at, besides the judgement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Whether nothing speaks against the candidate: no failing check and no unmet requirement.
    pub fits: bool,
    /// Frame size; the smaller is preferred.
    pub size: u16,
    /// Largest utilisation of a limit.
    pub utilisation: f64,
    /// Mass in kilograms, for ties; infinite if not known.
    pub mass_kg: f64,
}

impl Standing {
    /// The standing of a judged candidate.
    #[must_use]
    pub fn of(judgement: &Judgement, requirements_met: bool, size: u16, mass_kg: Option<f64>) -> Self {
        Self {
            fits: judgement.fits() && requirements_met,
            size,
            utilisation: judgement.utilisation(),
            mass_kg: mass_kg.unwrap_or(f64::INFINITY),
        }
    }
}

/// The stated rule: what fits before what does not; among what fits, what keeps within every limit before what lies inside
/// the band of an estimate, whose utilisation is above one; then the smaller frame size; then the lower utilisation, that is
/// the larger margin; then the lower mass. Among those that do not fit, the one that misses by least comes first, then
/// the smaller frame size: what every check would pass misses by nothing.
///
/// Equal standings keep the order in which they came, the order of the catalogue.
#[must_use]
pub fn rank(a: &Standing, b: &Standing) -> Ordering {
    let by_margin = || a.utilisation.total_cmp(&b.utilisation);
    let by_miss = || a.utilisation.max(1.0).total_cmp(&b.utilisation.max(1.0));
    let by_size = || a.size.cmp(&b.size);
    let by_band = || (a.utilisation > 1.0).cmp(&(b.utilisation > 1.0));
    b.fits
        .cmp(&a.fits)
        .then_with(|| {
            if a.fits {
                by_band().then_with(by_size).then_with(by_margin)
            } else {
                by_miss().then_with(by_size).then_with(by_margin)
            }
        })
        .then_with(|| a.mass_kg.total_cmp(&b.mass_kg))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standing(fits: bool, size: u16, utilisation: f64, mass_kg: f64) -> Standing {
        Standing { fits, size, utilisation, mass_kg }
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
            field.iter().map(|s| (s.fits, s.size, s.utilisation, s.mass_kg)).collect();
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
}
