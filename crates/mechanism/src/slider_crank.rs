//! Crank, rod and slider.

use crate::{Extra, Reduced, gravity_m_s2};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia};

/// A slider-crank.
///
/// x(q) = r cos q + √(l² − r² sin² q), J = J_c + (m + m_p) x'², J' = 2 (m + m_p) x' x'', T_h = x' ((m + m_p) g sin γ + F_p)
///
/// # Symbols  r crank radius, l rod length, q = 0 where the slider is farthest out, J_c inertia of the crank (with the
/// rotating share of the rod), m slider (with the moving share of the rod), γ inclination of the outward direction
/// # Source   docs/theory/mechanisms.md
/// # Valid    l > r, slider's line through the crank's axis; the rod's own rotation is left to the two shares
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrank {
    /// r: crank radius.
    pub crank: Length,
    /// l: rod length, greater than r.
    pub rod: Length,
    /// J_c: inertia of what turns.
    pub inertia: MomentOfInertia,
    /// m: mass of what slides.
    pub mass: Mass,
    /// γ: inclination of the outward direction above the horizontal.
    pub inclination: Angle,
    /// q_0: angle of the crank at position zero of the motion.
    pub angle: Angle,
}

impl SliderCrank {
    pub(crate) fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let (r, l) = (self.crank.si(), self.rod.si());
        let (sine, cosine) = (position_rad + self.angle.si()).sin_cos();
        let root = (l * l - r * r * sine * sine).sqrt();
        // x' and x'' of x = r cos q + root, with root' = −r² sin q cos q / root.
        let root_slope = -r * r * sine * cosine / root;
        let first = -r * sine + root_slope;
        let second = -r * cosine + (-r * r * (cosine * cosine - sine * sine) - root_slope * root_slope) / root;
        let mass = self.mass.si() + extra.mass.si();
        // A process force against the positive direction of the slide opposes outward travel, dx > 0.
        let along = mass * gravity_m_s2() * self.inclination.si().sin() + extra.force.si();
        Reduced {
            inertia: self.inertia.si() + extra.inertia.si() + mass * first * first,
            slope: 2.0 * mass * first * second,
            holding: first * along + extra.torque.si(),
            coulomb: 0.0,
        }
    }
}
