//! A mass moved along a line in proportion to the angle: screw, belt, rack, conveyor.

use crate::equations::{Equations, Reduced};
use crate::flange::{FlangeDatum, FlangeForces, Instant, OnFlange, Overhang, Recurrence, sine, wheel_forces};
use crate::{Endless, Extra, MechanismId, Rope, gravity_m_s2};
use quantities::{Angle, Force, Mass, Measure, MomentOfInertia};

/// Conversion of rotation into linear motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinearKind {
    /// A screw with its nut: travel = lead/2π per radian.
    Screw,
    /// A belt or a rack and pinion with limited stroke: travel = pulley radius per radian.
    Belt,
    /// A conveyor or a roller with unlimited travel.
    Conveyor,
}

/// A linear drive with slide and counterweight.
///
/// k = dx/dq, J = J_r + (m + m_p) k², T_h = k ((m + m_p − m_c) g sin γ + F_p), T_g = k (F_f + μ (m + m_p) g cos γ)
///
/// # Symbols
/// k travel per angle [m/rad], J_r rotating inertia (screw, pulleys), m moved mass, m_p payload of the segment,
/// m_c counterweight, γ inclination (90° is vertical, upwards positive), F_p process force against the positive
/// direction, F_f friction force of seals and guides, μ friction coefficient of the guide
/// # Source
/// cha-manual eq. 70.3 for the horizontal screw (k = P/2π); docs/theory/mechanisms.md for the rest
/// # Valid
/// stiff transmission without backlash; the counterweight moves with the slide
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Conversion of rotation into linear motion.
    pub kind: LinearKind,
    /// k: travel per angle of the output [m/rad], greater than zero.
    pub travel_m_per_rad: f64,
    /// J_r: inertia of parts turning with the output: screw, coupling, pulleys, rollers.
    pub inertia: MomentOfInertia,
    /// m: mass moving along the line.
    pub mass: Mass,
    /// m_c: counterweight, which moves with the slide and whose weight opposes that of the slide.
    pub counterweight: Mass,
    /// γ: inclination of the positive direction above the horizontal.
    pub inclination: Angle,
    /// F_f: friction force independent of the mass.
    pub friction_force: Force,
    /// μ: friction coefficient of the guide.
    pub friction_coefficient: f64,
}

impl Linear {
    /// Returns the force of the wheel or thread on the parts moving along the line \[N\], without and with the rotating
    /// inertia of mechanism and payload, which may be beyond the belt.
    pub(crate) fn pulls(&self, at: &Instant<'_>) -> [f64; 2] {
        let (k, alpha) = (self.travel_m_per_rad, at.output.acceleration_rad_s2);
        // Inertia turning with the wheel and couples about its axis cause no force along the line.
        let line = Self { inertia: MomentOfInertia::from_si(0.0), ..*self };
        let of_line = Extra { mass: at.extra.mass, force: at.extra.force, ..Extra::none() };
        let reduced = line.reduced(0.0, &of_line);
        let torque = reduced.inertia * alpha + reduced.holding + reduced.coulomb * at.output.direction + at.recorded_nm;
        let without = torque / k;
        [without, without + (self.inertia.si() + at.extra.inertia.si()) * alpha / k]
    }

    /// Returns the force at the circumference of the wheel \[N\]. The share of the rotating inertia beyond the belt is not
    /// known; the pull is largest at one of the limits.
    pub(crate) fn tangential(&self, at: &Instant<'_>) -> f64 {
        let [without, with] = self.pulls(at).map(|force| at.before_losses(force, at.output.direction));
        without.max(with)
    }
}

impl Equations for Linear {
    fn id(&self) -> MechanismId {
        match self.kind {
            LinearKind::Screw => MechanismId::Screw,
            LinearKind::Belt => MechanismId::Belt,
            LinearKind::Conveyor => MechanismId::Conveyor,
        }
    }

    fn reduced(&self, _position_rad: f64, extra: &Extra) -> Reduced {
        let k = self.travel_m_per_rad;
        let carried = self.mass.si() + extra.mass.si();
        let (sine, cosine) = self.inclination.si().sin_cos();
        // A slide at 90° exerts no normal force on its guide; the residue of the rounded cosine must cause no friction.
        let normal = if cosine.abs() < 1e-12 { 0.0 } else { cosine.abs() };
        let weight = (carried - self.counterweight.si()) * gravity_m_s2() * sine;
        Reduced {
            inertia: self.inertia.si() + extra.inertia.si() + (carried + self.counterweight.si()) * k * k,
            slope: 0.0,
            holding: k * (weight + extra.force.si()) + extra.torque.si(),
            coulomb: k * (self.friction_force.si() + self.friction_coefficient * carried * gravity_m_s2() * normal),
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        let (inertia, mass, counterweight) = (self.inertia * factor, self.mass * factor, self.counterweight * factor);
        Self { inertia, mass, counterweight, ..*self }
    }

    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        None
    }

    fn endless(&self) -> Endless {
        match self.kind {
            LinearKind::Screw | LinearKind::Belt => Endless::Never,
            LinearKind::Conveyor => Endless::Everywhere,
        }
    }

    fn travel_m_per_rad(&self) -> Option<f64> {
        Some(self.travel_m_per_rad)
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let missing = match self.kind {
            LinearKind::Screw => FlangeDatum::FlangeShare,
            LinearKind::Belt | LinearKind::Conveyor => FlangeDatum::BeltTension,
        };
        // The thrust of a screw acts along the axis.
        let overhang = Overhang { of_mechanism: self.kind != LinearKind::Screw, of_payload: false };
        Some(OnFlange { missing: Some(missing), overhang, recurrence: Recurrence::Constant })
    }

    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        if self.kind == LinearKind::Screw {
            let [thrust, _] = self.pulls(at);
            return FlangeForces { axial_n: thrust, ..FlangeForces::default() };
        }
        wheel_forces(self.tangential(at), self.travel_m_per_rad, at.mounting)
    }

    fn switches(&self, at: &Instant<'_>) -> Option<[f64; 2]> {
        Some(self.pulls(at))
    }

    /// The counterweight is on the side to which the slide would fall.
    fn rope_tension(&self, rope: Rope, at: &Instant<'_>) -> Option<f64> {
        let (mass, steep) = (self.counterweight.si(), sine(self.inclination));
        let hangs = rope == Rope::Counterweight && mass > 0.0 && steep != 0.0;
        let along = self.travel_m_per_rad * at.output.acceleration_rad_s2;
        hangs.then(|| mass * (gravity_m_s2() * steep.abs() - along * steep.signum()))
    }
}
