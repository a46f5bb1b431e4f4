//! The questions that each mechanism answers, in its own module.

use crate::flange::{FlangeForces, Instant, OnFlange};
use crate::{Endless, Extra, MechanismId, Rope};

/// The inertia that the output feels at a position, its slope and the torque of the position alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reduced {
    /// J(q) \[kgm²\]
    pub(crate) inertia: f64,
    /// dJ/dq [kgm²/rad], as far as it takes a torque.
    pub(crate) slope: f64,
    /// Torque that holds the load at rest without friction: gravity and process \[Nm\].
    pub(crate) holding: f64,
    /// Coulomb friction on the far side of the transmission, referred to the output \[Nm\].
    pub(crate) coulomb: f64,
}

/// What a segment of the motion can add to a mechanism; anything else would have no effect and is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effects {
    /// A payload is carried along.
    pub payload: bool,
    /// An inertia is added at the output.
    pub payload_inertia: bool,
    /// A process force acts along a line.
    pub process_force: bool,
}

/// The equations of one mechanism, at the mechanism's own shaft: a stage lies before it.
pub(crate) trait Equations {
    /// Its name in a project file.
    fn id(&self) -> MechanismId;

    /// Inertia and torque at a position.
    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced;

    /// J \[kgm²\] for the checks that look beyond the torque; `None` where it is not stated.
    fn known_inertia(&self, reduced: &Reduced) -> Option<f64> {
        Some(reduced.inertia)
    }

    /// Torque that holds the load at rest, with the external one \[Nm\].
    fn holding(&self, reduced: &Reduced, external_nm: f64) -> f64 {
        reduced.holding + external_nm
    }

    /// The same with all masses and inertias times a factor; geometry and process stay.
    fn with_masses(&self, factor: f64) -> Self
    where
        Self: Sized;

    /// The longest angle between two positions over which inertia and torque are as smooth as sixteen nodes need;
    /// infinite where they are polynomials of the position, `None` where they do not depend on it.
    fn smooth_over(&self, from_rad: f64, to_rad: f64) -> Option<f64>;

    /// What the end of a cycle must come back to.
    fn endless(&self) -> Endless;

    /// Lowest and highest position that the geometry allows.
    fn range_rad(&self) -> Option<(f64, f64)> {
        None
    }

    /// Travel along the line per angle [m/rad], where it is constant.
    fn travel_m_per_rad(&self) -> Option<f64> {
        None
    }

    /// Positions at which inertia or torque have a kink.
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// What a segment can add.
    fn effects(&self) -> Effects;

    /// How it loads the flange; `None` where its masses and forces are not described.
    fn on_flange(&self) -> Option<OnFlange>;

    /// Its forces on the flange at one instant.
    fn forces(&self, _at: &Instant<'_>) -> FlangeForces {
        FlangeForces::default()
    }

    /// Tension of a rope while it is taut \[N\], below zero where it would have to push; `None` without such a rope.
    fn rope_tension(&self, _rope: Rope, _at: &Instant<'_>) -> Option<f64> {
        None
    }

    /// Forces along a line whose changes of sign bend those on the flange \[N\]; `None` where nothing bends them.
    fn switches(&self, _at: &Instant<'_>) -> Option<[f64; 2]> {
        None
    }
}

/// A twelfth of the period of what gravity and a crank make.
pub(crate) const TWELFTH_RAD: f64 = std::f64::consts::FRAC_PI_6;

/// The panel on which sixteen nodes integrate a function with branch points beside the real axis.
///
/// h = ¾ d, error ~ ρ⁻²⁹ with ρ = d/h + √(1 + (d/h)²) = 3
///
/// # Symbols
/// h half the panel, d distance of the nearest branch point [both in the unit of the position], ρ sum of the half-axes
/// of the largest ellipse about the panel in which the function is analytic
/// # Source
/// docs/theory/moments.md; Trefethen, Approximation Theory and Approximation Practice, theorem 19.3
pub(crate) fn beside(distance: f64) -> f64 {
    1.5 * distance
}
