//! A mass along a line, moved in proportion to the angle: screw, belt, rack, conveyor.

use crate::{Extra, Reduced, gravity_m_s2};
use quantities::{Angle, Force, Mass, Measure, MomentOfInertia};

/// What makes the line out of the rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinearKind {
    /// A screw with its nut: travel = lead/2π per radian.
    Screw,
    /// A belt or a rack and pinion with a bounded stroke: travel = pulley radius per radian.
    Belt,
    /// A conveyor or a roller that runs endlessly.
    Conveyor,
}

/// A linear drive.
///
/// k = dx/dq, J = J_r + (m + m_p) k², T_h = k ((m + m_p − m_c) g sin γ + F_p), T_g = k (F_f + μ (m + m_p) g cos γ)
///
/// # Symbols  k travel per angle [m/rad], J_r rotating inertia (screw, pulleys), m moved mass, m_p payload of the segment,
/// m_c counterweight, γ inclination (90° is vertical, upwards positive), F_p process force against the positive
/// direction, F_f friction force of seals and guides, μ friction coefficient of the guide
/// # Source   cha-manual eq. 70.3 for the horizontal screw (k = P/2π); docs/theory/mechanisms.md for the rest
/// # Valid    stiff transmission without play; the counterweight moves with the slide
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// What makes the line out of the rotation.
    pub kind: LinearKind,
    /// k: travel per angle of the output [m/rad], greater than zero.
    pub travel_m_per_rad: f64,
    /// J_r: inertia of what turns with the output: screw, coupling, pulleys, rollers.
    pub inertia: MomentOfInertia,
    /// m: mass that moves along the line.
    pub mass: Mass,
    /// m_c: counterweight; it moves along, and its weight acts against that of the slide.
    pub counterweight: Mass,
    /// γ: inclination of the positive direction above the horizontal.
    pub inclination: Angle,
    /// F_f: friction force that does not depend on the mass.
    pub friction_force: Force,
    /// μ: friction coefficient of the guide.
    pub friction_coefficient: f64,
}

impl Linear {
    pub(crate) fn reduced(&self, extra: &Extra) -> Reduced {
        let k = self.travel_m_per_rad;
        let carried = self.mass.si() + extra.mass.si();
        let (sine, cosine) = self.inclination.si().sin_cos();
        // A slide at 90° presses on its guide with nothing; the cosine of the rounded angle is no friction.
        let normal = if cosine.abs() < 1e-12 { 0.0 } else { cosine.abs() };
        let weight = (carried - self.counterweight.si()) * gravity_m_s2() * sine;
        Reduced {
            inertia: self.inertia.si() + extra.inertia.si() + (carried + self.counterweight.si()) * k * k,
            slope: 0.0,
            holding: k * (weight + extra.force.si()) + extra.torque.si(),
            coulomb: k * (self.friction_force.si() + self.friction_coefficient * carried * gravity_m_s2() * normal),
        }
    }
}
