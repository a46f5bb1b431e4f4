//! A load that turns with the output: direct, turntable, unbalanced arm.

use crate::equations::{Equations, Reduced, TWELFTH_RAD};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, Recurrence, cosine, metres, sine};
use crate::{ArmBody, Endless, Extra, MechanismId, gravity_m_s2};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia};

/// Description of a rotor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RotorKind {
    /// Inertia only; weight and centre of mass are unknown.
    #[default]
    Load,
    /// Bodies on a plate.
    Turntable,
    /// Inertia, mass and centre of mass.
    Arm,
    /// An arm whose inertia and centre of mass follow from its shape.
    Shaped(ArmBody),
}

/// A rigid body on the output flange.
///
/// J = J_L + m_p r_p², T_h = g cos(q + q_0) sin β (m r + m_p r_p)
///
/// # Symbols
/// q_0 angle of the centre of mass above the horizontal at q = 0, β tilt of the axis from the vertical, m r unbalance,
/// m_p payload of the segment, r_p distance of the payload from the axis
/// # Source
/// docs/theory/mechanisms.md; cha-manual eq. 70.5 for the inertia
/// # Valid
/// rigid body; the payload is in the direction of the centre of mass
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rotor {
    /// Description of the rotor in the project file.
    pub kind: RotorKind,
    /// J_L: inertia about the axis, without payload.
    pub inertia: MomentOfInertia,
    /// m: mass whose weight causes the gravity torque.
    pub mass: Mass,
    /// r: distance of the centre of mass from the axis.
    pub radius: Length,
    /// r_p: distance of the payload from the axis.
    pub payload_radius: Length,
    /// q_0: angle of the centre of mass above the horizontal at q = 0; 90° is upright.
    pub angle: Angle,
    /// β: tilt of the axis of rotation from the vertical; 0 for no gravity torque, 90° for a horizontal axis.
    pub tilt: Angle,
}

impl Rotor {
    /// Creates a balanced load.
    #[must_use]
    pub fn balanced(inertia: MomentOfInertia) -> Self {
        Self { inertia, ..Self::default() }
    }

    /// Computes the constants that do not depend on the position, for many evaluations.
    pub(crate) fn laden(&self, extra: &Extra) -> Laden {
        let payload = extra.mass.si() * self.payload_radius.si();
        let unbalance = self.mass.si() * self.radius.si() + payload;
        Laden {
            inertia: self.inertia.si() + extra.inertia.si() + payload * self.payload_radius.si(),
            weight_nm: gravity_m_s2() * unbalance,
            angle_rad: self.angle.si(),
            sine_of_tilt: self.tilt.si().sin(),
            torque_nm: extra.torque.si(),
        }
    }

    /// Returns `true` if gravity causes a torque that depends on the position.
    pub(crate) fn is_unbalanced(&self) -> bool {
        self.tilt.si().sin() != 0.0 && (self.mass.si() * self.radius.si() != 0.0 || self.payload_radius.si() != 0.0)
    }
}

impl Equations for Rotor {
    fn id(&self) -> MechanismId {
        match self.kind {
            RotorKind::Load => MechanismId::Load,
            RotorKind::Turntable => MechanismId::Turntable,
            RotorKind::Arm | RotorKind::Shaped(_) => MechanismId::Arm,
        }
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        self.laden(extra).reduced(position_rad)
    }

    fn with_masses(&self, factor: f64) -> Self {
        Self { inertia: self.inertia * factor, mass: self.mass * factor, ..*self }
    }

    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        self.is_unbalanced().then_some(TWELFTH_RAD)
    }

    fn endless(&self) -> Endless {
        if self.is_unbalanced() { Endless::EachRevolution } else { Endless::Everywhere }
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let of_mass = Overhang { of_mechanism: self.mass.si() > 0.0, of_payload: true };
        // On a vertical axis the flange loads turn with the load, and their amounts are constant.
        let recurrence = Recurrence::each_revolution_if(self.is_unbalanced());
        (self.kind != RotorKind::Load).then_some(OnFlange { missing: None, overhang: of_mass, recurrence })
    }

    /// Returns m (g − a) of the rotor and of its payload.
    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let (output, extra, mounting) = (at.output, at.extra, at.mounting);
        let (sin, cos) = (output.position_rad + self.angle.si()).sin_cos();
        let (omega, alpha) = (output.speed_rad_s, output.acceleration_rad_s2);
        let (across, along) = (gravity_m_s2() * sine(self.tilt), gravity_m_s2() * cosine(self.tilt));
        let mut forces = FlangeForces::default();
        for (mass, radius, overhang) in
            [(self.mass, self.radius, mounting.overhang), (extra.mass, self.payload_radius, mounting.payload_overhang)]
        {
            let (m, r) = (mass.si(), radius.si());
            if m == 0.0 {
                continue;
            }
            let (centrifugal, tangential) = (omega * omega * r, alpha * r);
            let force = [
                m * (centrifugal * cos + tangential * sin),
                m * (centrifugal * sin - tangential * cos - across),
                -m * along,
            ];
            forces.act([r * cos, r * sin, metres(overhang)], force);
        }
        forces
    }
}

/// A rotor with the additions of a segment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Laden {
    /// J: inertia \[kgm²\].
    inertia: f64,
    /// g (m r + m_p r_p): gravity torque at the largest lever, before the tilt \[Nm\].
    weight_nm: f64,
    /// q_0: angle of the centre of mass \[rad\].
    angle_rad: f64,
    /// sin β of the tilt \[1\].
    sine_of_tilt: f64,
    /// Process torque \[Nm\].
    torque_nm: f64,
}

impl Laden {
    /// Returns the part that does not depend on the position, and of the weight its largest torque \[Nm\] and q_0
    /// \[rad\].
    pub(crate) fn apart(&self) -> (Reduced, f64, f64) {
        let balanced = Self { weight_nm: 0.0, ..*self };
        (balanced.reduced(0.0), self.weight_nm * self.sine_of_tilt, self.angle_rad)
    }

    pub(crate) fn reduced(&self, position_rad: f64) -> Reduced {
        let lever = if self.weight_nm == 0.0 { 0.0 } else { (position_rad + self.angle_rad).cos() * self.sine_of_tilt };
        Reduced { inertia: self.inertia, slope: 0.0, holding: self.weight_nm * lever + self.torque_nm, coulomb: 0.0 }
    }
}
