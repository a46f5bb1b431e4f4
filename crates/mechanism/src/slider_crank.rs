//! Crank, rod and slider.

use crate::drawing::{Drawing, Look};
use crate::equations::{Effects, Equations, Reduced, TWELFTH_RAD, beside};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, metres};
use crate::{Endless, Extra, MechanismId, Output, gravity_m_s2};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia};

/// A slider-crank.
///
/// x(q) = r cos q + √(l² − r² sin² q), J = J_c + (m + m_p) x'², J' = 2 (m + m_p) x' x'', T_h = x' ((m + m_p) g sin γ + F_p)
///
/// # Symbols
/// r crank radius, l rod length, q = 0 where the slider is farthest out, J_c inertia of the crank (with the
/// rotating share of the rod), m slider (with the moving share of the rod), γ inclination of the outward direction
/// # Source
/// docs/theory/mechanisms.md
/// # Valid
/// l > r, slider's line through the crank's axis; the rod's own rotation is left to the two shares
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

/// x of the slider by the angle of the crank, its slopes, and tan ψ of the rod.
struct Course {
    first: f64,
    second: f64,
    lean: f64,
}

impl SliderCrank {
    fn course(&self, position_rad: f64) -> Course {
        let (r, l) = (self.crank.si(), self.rod.si());
        let (sine, cosine) = (position_rad + self.angle.si()).sin_cos();
        let root = (l * l - r * r * sine * sine).sqrt();
        // x' and x'' of x = r cos q + root, with root' = −r² sin q cos q / root.
        let root_slope = -r * r * sine * cosine / root;
        Course {
            first: -r * sine + root_slope,
            second: -r * cosine + (-r * r * (cosine * cosine - sine * sine) - root_slope * root_slope) / root,
            lean: r * sine / root,
        }
    }

    /// Force that the rod gives to the slider along its line \[N\].
    ///
    /// F = (m + m_p)(x' α + x'' ω² + g sin γ) + F_p
    fn rod_force(&self, course: &Course, output: &Output, extra: &Extra) -> f64 {
        let acceleration =
            course.first * output.acceleration_rad_s2 + course.second * output.speed_rad_s * output.speed_rad_s;
        let mass = self.mass.si() + extra.mass.si();
        mass * (acceleration + gravity_m_s2() * self.inclination.si().sin()) + extra.force.si()
    }
}

impl Equations for SliderCrank {
    fn id(&self) -> MechanismId {
        MechanismId::SliderCrank
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let Course { first, second, .. } = self.course(position_rad);
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

    fn with_masses(&self, factor: f64) -> Self {
        Self { inertia: self.inertia * factor, mass: self.mass * factor, ..*self }
    }

    /// The root has its branch points at sin q = l/r.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        Some(TWELFTH_RAD.min(beside((self.rod.si() / self.crank.si()).acosh())))
    }

    fn endless(&self) -> Endless {
        Endless::EachRevolution
    }

    fn inclination_rad(&self) -> Option<f64> {
        Some(self.inclination.si())
    }

    fn effects(&self) -> Effects {
        Effects { payload: true, payload_inertia: true, process_force: true }
    }

    fn on_flange(&self) -> Option<OnFlange> {
        Some(OnFlange { missing: None, overhang: Overhang { of_mechanism: true, of_payload: false } })
    }

    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let course = self.course(at.output.position_rad);
        let force = self.rod_force(&course, at.output, at.extra);
        // Outward travel has the sign of x' ω.
        let amount = at.before_losses(force, course.first * at.output.direction);
        let mut forces = FlangeForces::default();
        // Amount and line of the rod's force: its own sign turns both components.
        forces.act([0.0, 0.0, metres(at.mounting.overhang)], [-amount, amount * course.lean, 0.0]);
        forces
    }

    fn switches(&self, at: &Instant<'_>) -> [f64; 2] {
        [self.rod_force(&self.course(at.output.position_rad), at.output, at.extra), 0.0]
    }
}

pub(crate) fn drawing() -> Drawing {
    Drawing::new()
        .along_a_line()
        .line(Look::Axis, [24.0, 112.0], [366.0, 112.0])
        .face([88.0, 112.0], 44.0)
        .bar([88.0, 112.0], [116.0, 74.0], 9.0)
        .rect(Look::Body, [250.0, 92.0], [62.0, 40.0])
        .bar([116.0, 74.0], [275.0, 112.0], 7.0)
        .ground([226.0, 134.0], 124.0)
        .line(Look::Line, [226.0, 90.0], [350.0, 90.0])
        .arrow([258.0, 62.0], [312.0, 62.0])
        .arrow([362.0, 112.0], [318.0, 112.0])
        .turning([140.0, 112.0], 52.0, false, [119.0, 70.0])
        .calls("crank", "r", [102.0, 92.0], [78.0, 44.0])
        .calls("rod", "l", [196.0, 92.0], [190.0, 52.0])
        .calls("mass", "m", [296.0, 104.0], [330.0, 158.0])
        .calls("inertia", "J", [66.0, 142.0], [38.0, 168.0])
        .calls("start_angle", "φ_0", [138.0, 98.0], [168.0, 128.0])
        .calls("process_force", "F", [346.0, 112.0], [362.0, 84.0])
        .calls("inclination", "γ", [216.0, 112.0], [206.0, 150.0])
        .calls("friction_torque", "T_L", [56.0, 84.0], [26.0, 56.0])
}
