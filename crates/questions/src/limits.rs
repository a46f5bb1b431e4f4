//! Limits of a project with which a candidate would fit.

use crate::sizing_use::{Candidate, Objection};
use configurator::Unmet;
use provenance::Source;
use quantities::unit::{DAY, KILOGRAM, MILLIMETRE};
use quantities::{Measure, Unit};
use sizing::{Amount, Verdict};

/// A limit that the project requires, and the value that would be met.
#[derive(Clone, Debug)]
pub struct NeededLimit {
    /// Key of the limit: `requirements.torsion_max`.
    pub key: String,
    /// Value that the candidate reaches, rounded to four digits towards the permissible side.
    pub enough: Amount,
}

impl NeededLimit {
    fn of(key: &str, reached: Amount) -> Self {
        let enough = outward(reached.value(), key.ends_with("_min"));
        Self { key: key.to_owned(), enough: Amount { si: reached.unit.to_si(enough), ..reached } }
    }
}

/// Rounds a positive value to four digits, down or up.
fn outward(value: f64, down: bool) -> f64 {
    if value <= 0.0 || !value.is_finite() {
        return value;
    }
    let place = 10_f64.powf(3.0 - value.log10().floor());
    let digits = value * place;
    // A value with four digits must not change due to its rounding.
    let near = digits.round();
    let rounded = if (digits - near).abs() <= 1e-9 * near {
        near
    } else if down {
        digits.floor()
    } else {
        digits.ceil()
    };
    rounded / place
}

/// Returns the limits of the project with which, all together, a candidate would fit; `None` if it fits, or if an
/// objection is independent of the limits of the project.
#[must_use]
pub fn limits_needed(candidate: &Candidate<'_>) -> Option<Vec<NeededLimit>> {
    let of = |key: &str, si: f64, unit: &'static Unit| NeededLimit::of(key, Amount { si, unit });
    let mut needed = Vec::new();
    for objection in &candidate.objections {
        needed.push(match objection {
            Objection::Unmet(Unmet::HollowShaft { has, .. }) => {
                of("requirements.hollow_shaft_min", has.si(), &MILLIMETRE)
            }
            Objection::Unmet(Unmet::Length { has, .. }) => of("requirements.length_max", has.si(), &MILLIMETRE),
            Objection::Unmet(Unmet::Mass { has, .. }) => of("requirements.mass_max", has.si(), &KILOGRAM),
            Objection::Unmet(Unmet::LeadTime { has, .. }) => of("requirements.lead_time_max", has.si(), &DAY),
            _ => return None,
        });
    }
    for check in candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail) {
        let Some(Source::Project { key }) = &check.limit_source else { return None };
        // For one axis of several the key is relative to the axis, like that of an objection.
        let key = key.find("requirements.").and_then(|at| key.get(at..))?;
        let asked = key.ends_with("_max") || key.ends_with("_min");
        needed.push(NeededLimit::of(key, check.value.filter(|_| asked)?));
    }
    (!needed.is_empty()).then_some(needed)
}
