//! `[mechanism.hoist]`: a drum that lifts a load by a rope with several falls.

use crate::drawing::{Drawing, Look};
use crate::equations::{Effects, Equations, Reduced};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, metres};
use crate::{Endless, Extra, Geometry, MechanismId, gravity_m_s2};
use quantities::{Length, Mass, Measure, MomentOfInertia};

/// A hoist.
///
/// k = D/2n, x = k q, J = J_d + (m + m_p + m_c) k² + μ k² ((L − x) Σ u² + n³ x),
/// T_h = k ((m + m_p − m_c) g + n μ g (L − x) + F_p)
///
/// # Symbols
/// D diameter of the drum to the middle of the rope, n falls, x height lifted, J_d inertia of the drum, m load with hook,
/// m_p payload of the segment, m_c counterweight with the same reeving, μ = m_r/n L mass of the rope per length, m_r that
/// of all falls, L length of each at q = 0, u speed of a fall by that of the load: n, n − 2, n − 2, n − 4, …
/// # Source
/// docs/theory/mechanisms.md; Lagrange's equation with the whole rope in the system
/// # Valid
/// vertical falls, stiff rope; the rope on the drum at q = 0 belongs to J_d, the inertia of the sheaves is neglected
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hoist {
    /// D: diameter of the drum to the middle of the rope.
    pub drum_diameter: Length,
    /// n: falls that carry the load.
    pub falls: u32,
    /// J_d: inertia of the drum and of what turns with it.
    pub inertia: MomentOfInertia,
    /// m: load with hook and lower block.
    pub mass: Mass,
    /// m_c: counterweight; it moves against the load.
    pub counterweight: Mass,
    /// m_r: mass of all falls of the rope at position zero.
    pub rope_mass: Mass,
    /// L: length of each fall at position zero; only with a mass of the rope, and then greater than zero.
    pub hanging: Length,
}

/// Efficiency of a reeving while lifting.
///
/// η_F = (1/n) (1 − η_S^n)/(1 − η_S)
///
/// # Symbols
/// n falls, η_S efficiency of one sheave
/// # Source
/// DIN 15020-1; FEM 1.001 booklet 4: the pull of each fall is that of the one before times η_S
/// # Valid
/// one end of the rope on the drum, the other fixed; η_S in (0, 1]
#[must_use]
pub fn reeving_efficiency(falls: u32, sheave: f64) -> f64 {
    let (mut sum, mut share) = (0.0, 1.0);
    for _ in 0..falls {
        sum += share;
        share *= sheave;
    }
    sum / f64::from(falls.max(1))
}

impl Hoist {
    /// What is wrong with its figures.
    #[must_use]
    pub fn faults(&self) -> Vec<Geometry> {
        Geometry::found([(self.rope_mass.si() > 0.0 && !self.has_rope(), Geometry::RopeWithoutLength)])
    }

    /// k [m/rad]
    fn travel(&self) -> f64 {
        self.drum_diameter.si() / (2.0 * f64::from(self.falls))
    }

    fn has_rope(&self) -> bool {
        self.rope_mass.si() > 0.0 && self.hanging.si() > 0.0
    }

    /// μ [kg/m]
    fn rope_kg_per_m(&self) -> f64 {
        if self.has_rope() { self.rope_mass.si() / (f64::from(self.falls) * self.hanging.si()) } else { 0.0 }
    }

    /// Σ u²: the squares of the speeds of the falls by that of the load.
    fn speeds(&self) -> f64 {
        let mut left = self.falls;
        let (mut speed, mut sum) = (f64::from(left), 0.0);
        // The rope runs n times as fast as the load at the drum and two slower after each pair of sheaves.
        let mut pair = 1;
        while left > 0 {
            let count = pair.min(left);
            sum += f64::from(count) * speed * speed;
            left -= count;
            speed -= 2.0;
            pair = 2;
        }
        sum
    }

    /// Pulls of the rope and of the counterweight's rope on the drum \[N\].
    fn pulls(&self, at: &Instant<'_>) -> [f64; 2] {
        let (k, g, alpha) = (self.travel(), gravity_m_s2(), at.output.acceleration_rad_s2);
        let of_load = Self { inertia: MomentOfInertia::from_si(0.0), counterweight: Mass::from_si(0.0), ..*self };
        let of_line = Extra { mass: at.extra.mass, force: at.extra.force, ..Extra::none() };
        let reduced = of_load.reduced(at.output.position_rad, &of_line);
        let omega = at.output.speed_rad_s;
        let torque = reduced.inertia * alpha + 0.5 * reduced.slope * omega * omega + reduced.holding + at.recorded_nm;
        let radius = 0.5 * self.drum_diameter.si();
        [torque / radius, self.counterweight.si() * (g - k * alpha) * k / radius]
    }
}

impl Equations for Hoist {
    fn id(&self) -> MechanismId {
        MechanismId::Hoist
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let (k, n, rope) = (self.travel(), f64::from(self.falls), self.rope_kg_per_m());
        let lifted = k * position_rad;
        let falls = self.hanging.si() - lifted;
        let carried = self.mass.si() + extra.mass.si();
        let (speeds, wound) = (self.speeds(), n * n * n);
        let weight = (carried - self.counterweight.si() + n * rope * falls) * gravity_m_s2();
        Reduced {
            inertia: self.inertia.si()
                + extra.inertia.si()
                + (carried + self.counterweight.si() + rope * (falls * speeds + lifted * wound)) * k * k,
            slope: rope * (wound - speeds) * k * k * k,
            holding: k * (weight + extra.force.si()) + extra.torque.si(),
            coulomb: 0.0,
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        Self {
            inertia: self.inertia * factor,
            mass: self.mass * factor,
            counterweight: self.counterweight * factor,
            rope_mass: self.rope_mass * factor,
            ..*self
        }
    }

    /// Linear in the position.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        self.has_rope().then_some(f64::INFINITY)
    }

    fn endless(&self) -> Endless {
        Endless::Never
    }

    /// The hook can be lifted as far as the rope hangs down.
    fn range_rad(&self) -> Option<(f64, f64)> {
        self.has_rope().then(|| (f64::NEG_INFINITY, self.hanging.si() / self.travel()))
    }

    fn travel_m_per_rad(&self) -> Option<f64> {
        Some(self.travel())
    }

    fn effects(&self) -> Effects {
        Effects { payload: true, payload_inertia: true, process_force: true }
    }

    fn on_flange(&self) -> Option<OnFlange> {
        Some(OnFlange { missing: None, overhang: Overhang { of_mechanism: true, of_payload: false } })
    }

    /// Both ropes pull the drum downwards.
    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let [load, counterweight] = self.pulls(at);
        let amount = at.before_losses(load, at.output.direction) + counterweight.abs();
        let mut forces = FlangeForces::default();
        forces.act([0.0, 0.0, metres(at.mounting.overhang)], [0.0, -amount, 0.0]);
        forces
    }

    fn switches(&self, at: &Instant<'_>) -> [f64; 2] {
        self.pulls(at)
    }
}

pub(crate) fn drawing() -> Drawing {
    Drawing::new()
        .line(Look::Axis, [20.0, 62.0], [232.0, 62.0])
        .actuator([28.0, 62.0])
        .rect(Look::Body, [106.0, 36.0], [110.0, 52.0])
        .rect(Look::Body, [100.0, 26.0], [8.0, 72.0])
        .rect(Look::Body, [214.0, 26.0], [8.0, 72.0])
        .rope([120.0, 36.0], [52.0, 0.0])
        .line(Look::Line, [150.0, 88.0], [150.0, 140.0])
        .line(Look::Line, [178.0, 24.0], [178.0, 140.0])
        .ground_above([166.0, 24.0], 24.0)
        .circle(Look::Housing, [164.0, 140.0], 14.0)
        .circle(Look::Hole, [164.0, 140.0], 4.0)
        .rect(Look::Body, [140.0, 158.0], [48.0, 28.0])
        .centre([164.0, 172.0])
        .line(Look::Line, [204.0, 36.0], [204.0, 26.0])
        .line(Look::Line, [204.0, 88.0], [204.0, 124.0])
        .rect(Look::Body, [194.0, 124.0], [20.0, 32.0])
        .arrow([128.0, 176.0], [128.0, 146.0])
        .line(Look::Thin, [222.0, 36.0], [250.0, 36.0])
        .line(Look::Thin, [222.0, 88.0], [250.0, 88.0])
        .dimension([244.0, 36.0], [244.0, 88.0])
        .line(Look::Thin, [140.0, 88.0], [84.0, 88.0])
        .line(Look::Thin, [150.0, 140.0], [84.0, 140.0])
        .dimension([90.0, 88.0], [90.0, 140.0])
        .calls("drum_diameter", "D", [244.0, 62.0], [268.0, 62.0])
        .calls("falls", "n", [178.0, 118.0], [234.0, 108.0])
        .calls("mass", "m", [180.0, 172.0], [226.0, 176.0])
        .calls("counterweight", "m_G", [212.0, 140.0], [248.0, 144.0])
        .calls("inertia", "J", [204.0, 50.0], [262.0, 22.0])
        .calls("rope_mass", "µ", [150.0, 110.0], [118.0, 112.0])
        .calls("hanging", "L", [90.0, 122.0], [66.0, 124.0])
        .calls("friction_torque", "T_L", [106.0, 56.0], [130.0, 16.0])
}
