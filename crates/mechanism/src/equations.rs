//! Interface of the mechanisms: the equations that each implements in its own module.

use crate::flange::{FlangeForces, Instant, OnFlange};
use crate::{Endless, Extra, MechanismId, Rope};

/// Inertia at the output at a position, its slope, and the torque that depends on the position only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reduced {
    /// J(q) \[kgm²\]
    pub(crate) inertia: f64,
    /// dJ/dq [kgm²/rad], as far as it causes a torque.
    pub(crate) slope: f64,
    /// Torque that holds the load at rest without friction: gravity and process \[Nm\].
    pub(crate) holding: f64,
    /// Coulomb friction beyond the transmission, referred to the output \[Nm\].
    pub(crate) coulomb: f64,
}

/// Equations of a mechanism, referred to its own shaft; a stage precedes it.
pub(crate) trait Equations {
    /// Returns the mechanism as named in a project file.
    fn id(&self) -> MechanismId;

    /// Returns inertia and torque at a position.
    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced;

    /// Returns J \[kgm²\] for the checks other than torque; `None` if it is not stated.
    fn known_inertia(&self, reduced: &Reduced) -> Option<f64> {
        Some(reduced.inertia)
    }

    /// Returns the torque that holds the load at rest, including the external one \[Nm\].
    fn holding(&self, reduced: &Reduced, external_nm: f64) -> f64 {
        reduced.holding + external_nm
    }

    /// Returns the mechanism with all masses and inertias multiplied by a factor; geometry and process remain.
    fn with_masses(&self, factor: f64) -> Self
    where
        Self: Sized;

    /// Returns the largest angle between two positions over which sixteen nodes resolve inertia and torque; infinite if
    /// they are polynomials of the position, `None` if they do not depend on it.
    fn smooth_over(&self, from_rad: f64, to_rad: f64) -> Option<f64>;

    /// Returns the condition on the end of a cycle.
    fn endless(&self) -> Endless;

    /// Returns the lowest and highest position that the geometry permits.
    fn range_rad(&self) -> Option<(f64, f64)> {
        None
    }

    /// Returns the travel along the line per angle [m/rad], if it is constant.
    fn travel_m_per_rad(&self) -> Option<f64> {
        None
    }

    /// Returns the positions at which inertia or torque have a kink.
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the properties of the flange load; `None` if masses and forces are not described.
    fn on_flange(&self) -> Option<OnFlange>;

    /// Returns the forces on the flange at one instant.
    fn forces(&self, _at: &Instant<'_>) -> FlangeForces {
        FlangeForces::default()
    }

    /// Returns the tension of a taut rope \[N\], negative where it would have to push; `None` without such a rope.
    fn rope_tension(&self, _rope: Rope, _at: &Instant<'_>) -> Option<f64> {
        None
    }

    /// Returns forces along a line whose changes of sign cause a kink in those on the flange \[N\]; `None` if there is
    /// no kink.
    fn switches(&self, _at: &Instant<'_>) -> Option<[f64; 2]> {
        None
    }
}

/// A twelfth of the period of gravity and crank terms.
pub(crate) const TWELFTH_RAD: f64 = std::f64::consts::FRAC_PI_6;

/// Returns the panel length on which sixteen nodes integrate a function with branch points near the real axis.
///
/// h = ¾ d, error ~ ρ⁻²⁹ with ρ = d/h + √(1 + (d/h)²) = 3
///
/// # Symbols
/// h half the panel, d distance of the nearest branch point [both in the unit of the position], ρ sum of the half-axes
/// of the largest ellipse about the panel in which the function is analytic
/// # Source
/// docs/theory/moments.md; Trefethen, Approximation Theory and Approximation Practice, theorem 19.3
pub(crate) fn panel_length(distance: f64) -> f64 {
    1.5 * distance
}
