//! `[mechanism.hoist]`: a drum that lifts a load by a rope with several falls.

use crate::drawing::{Drawing, GroupAngles as Way, Look, MechanismValues, Placement};
use crate::equations::{Equations, Reduced};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, Recurrence, metres};
use crate::stage::with_losses;
use crate::{Endless, Extra, Geometry, MechanismId, Output, Rope, gravity_m_s2};
use quantities::{Length, Mass, Measure, MomentOfInertia};

/// A hoist with drum, rope and counterweight.
///
/// k = D/2n, x = k q, J = J_d + (m + m_p + m_c) k² + μ k² ((L − x) Σ u² + n³ x),
/// T_h = k ((m + m_p − m_c) g + n μ g (L − x) + F_p)
///
/// with the losses of the sheaves T = J_d α + R (F_1 η_F^∓1 − F_2 η_F^±1), upper sign while lifting; divided by η_F
/// where the ropes drive the drum
///
/// # Symbols
/// D diameter of the drum to the centre of the rope, n falls, x lifted height, J_d inertia of the drum, m load with
/// hook, m_p payload of the segment, m_c counterweight with equal reeving, μ = m_r/n L rope mass per length, m_r mass
/// of all falls, L length of each at q = 0, u speed of a fall relative to that of the load: n, n − 2, n − 2, n − 4, …;
/// R = D/2, F_1 and F_2 pulls of the load's and of the counterweight's rope on the drum without losses \[N\], η_F
/// efficiency of each reeving
/// # Source
/// docs/theory/mechanisms.md; Lagrange's equation with the whole rope in the system
/// # Valid
/// vertical falls, stiff rope; the rope on the drum at q = 0 is included in J_d, the inertia of the sheaves is
/// neglected
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hoist {
    /// D: diameter of the drum to the centre of the rope.
    pub drum_diameter: Length,
    /// n: falls that bear the load.
    pub falls: u32,
    /// J_d: inertia of the drum and of parts turning with it.
    pub inertia: MomentOfInertia,
    /// m: load with hook and lower block.
    pub mass: Mass,
    /// m_c: counterweight, which moves opposite to the load.
    pub counterweight: Mass,
    /// m_r: mass of all falls of the rope at position zero.
    pub rope_mass: Mass,
    /// L: length of each fall at position zero; positive if the rope has a mass, else unused.
    pub hanging: Length,
    /// η_F: efficiency of each reeving, see [`reeving_efficiency`] \[1\].
    pub reeving: f64,
}

/// Returns the efficiency of a reeving while lifting \[1\].
///
/// η_F = (1/n) (1 − η_S^n)/(1 − η_S)
///
/// # Symbols
/// n falls, η_S efficiency of one sheave
/// # Source
/// DIN 15020-1; FEM 1.001 booklet 4: the pull of each fall is that of the previous one times η_S
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
    /// Returns the faults of the data.
    #[must_use]
    pub fn faults(&self) -> Vec<Geometry> {
        Geometry::found([(self.rope_mass.si() > 0.0 && !self.has_rope(), Geometry::RopeWithoutLength)])
    }

    /// Returns k, the travel per angle [m/rad].
    fn travel(&self) -> f64 {
        self.drum_diameter.si() / (2.0 * f64::from(self.falls))
    }

    pub(crate) fn has_rope(&self) -> bool {
        self.rope_mass.si() > 0.0 && self.hanging.si() > 0.0
    }

    /// Returns μ, the rope mass per length [kg/m].
    fn rope_kg_per_m(&self) -> f64 {
        if self.has_rope() { self.rope_mass.si() / (f64::from(self.falls) * self.hanging.si()) } else { 0.0 }
    }

    /// Returns Σ u², the sum of the squared speeds of the falls relative to that of the load.
    pub(crate) fn speeds(&self) -> f64 {
        let mut left = self.falls;
        let (mut speed, mut sum) = (f64::from(left), 0.0);
        // At the drum the rope is n times as fast as the load, and two less after each pair of sheaves.
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

    /// Returns the pulls on the drum of the load's and of the counterweight's rope \[N\].
    fn pulls(&self, at: &Instant<'_>) -> [f64; 2] {
        let (k, g, alpha) = (self.travel(), gravity_m_s2(), at.output.acceleration_rad_s2);
        let of_load = Self { inertia: MomentOfInertia::from_si(0.0), counterweight: Mass::from_si(0.0), ..*self };
        let radius = 0.5 * self.drum_diameter.si();
        [at.line_torque(&of_load) / radius, self.counterweight.si() * (g - k * alpha) * k / radius]
    }

    /// Returns the torque of both ropes on the drum with the losses of the sheaves, for a useful torque without them
    /// that contains no external torque \[Nm\]; `None` if the sheaves have no losses.
    pub(crate) fn ropes_nm(&self, useful_nm: f64, output: &Output, extra: &Extra) -> Option<[f64; 2]> {
        if self.reeving == 1.0 {
            return None;
        }
        let (k, alpha) = (self.travel(), output.acceleration_rad_s2);
        // Drum, couples and a payload inertia turn in front of the sheaves.
        let of_ropes = useful_nm - extra.torque.si() - (self.inertia.si() + extra.inertia.si()) * alpha;
        let counterweight = self.counterweight.si() * (gravity_m_s2() - k * alpha) * k;
        let [load, lowered] = self.through_sheaves([of_ropes + counterweight, counterweight], output.direction);
        Some([of_ropes, load - lowered])
    }

    /// Returns the pulls, or torques, of both ropes on the drum for those without losses.
    ///
    /// A rope that is lifted pulls the drum by more than its load, one that is lowered by less. While both together
    /// drive the drum, the loss in the lowered rope is not counted as a help: then the sum is that of the losses,
    /// divided by η_F.
    fn through_sheaves(&self, pulls: [f64; 2], direction: f64) -> [f64; 2] {
        let [load, balance] = self.sheave_losses(pulls, direction);
        let help = if (load + balance) * direction < 0.0 { self.reeving } else { 1.0 };
        [load / help, -balance / help]
    }

    /// Returns the pull of the load's rope and that of the counterweight's against it, each with the losses of its sheaves.
    pub(crate) fn sheave_losses(&self, [load, counterweight]: [f64; 2], direction: f64) -> [f64; 2] {
        [load, -counterweight].map(|pull| with_losses(pull, direction, [self.reeving; 2]))
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

    /// The equations are linear in the position.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        self.has_rope().then_some(f64::INFINITY)
    }

    fn endless(&self) -> Endless {
        Endless::Never
    }

    /// The travel ends where the rope is fully wound.
    fn range_rad(&self) -> Option<(f64, f64)> {
        self.has_rope().then(|| (f64::NEG_INFINITY, self.hanging.si() / self.travel()))
    }

    fn travel_m_per_rad(&self) -> Option<f64> {
        Some(self.travel())
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let overhang = Overhang { of_mechanism: true, of_payload: false };
        Some(OnFlange { missing: None, overhang, recurrence: Recurrence::never_if(self.has_rope()) })
    }

    /// Both ropes pull the drum downwards, with the forces that turn it.
    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let direction = at.output.direction;
        let [load, counterweight] = self.through_sheaves(self.pulls(at), direction);
        let amount = at.before_losses(load, direction) + counterweight.abs();
        let mut forces = FlangeForces::default();
        forces.act([0.0, 0.0, metres(at.mounting.overhang)], [0.0, -amount, 0.0]);
        forces
    }

    fn switches(&self, at: &Instant<'_>) -> Option<[f64; 2]> {
        let pulls @ [load, counterweight] = self.pulls(at);
        let [pulling, balancing] = self.through_sheaves(pulls, at.output.direction);
        Some([load, if self.reeving == 1.0 { counterweight } else { pulling - balancing }])
    }

    /// Returns the pull on the drum.
    fn rope_tension(&self, rope: Rope, at: &Instant<'_>) -> Option<f64> {
        let [load, counterweight] = self.pulls(at);
        match rope {
            Rope::Load => Some(load),
            Rope::Counterweight => (self.counterweight.si() > 0.0).then_some(counterweight),
        }
    }
}

/// Largest number of falls drawn.
const FALLS_MOST: u32 = 6;

/// Longest and shortest suspended rope on the sheet.
const HANGING: [f64; 2] = [96.0, 18.0];

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let falls = figures.count("falls", 2, FALLS_MOST);
    let diameter = figures.length("drum_diameter").unwrap_or(0.32);
    let hoist_travel = diameter / (2.0 * figures.of("falls").unwrap_or(2.0).max(1.0));
    let start = figures.start_rad();
    let [most, least] = HANGING;
    let by_figures = figures.length("hanging").map_or(most / (2.0 * diameter), |hanging| most / hanging);
    let (scale, lifted) = figures.along(hoist_travel, by_figures, [0.0, most - least], 0.0);
    let lifted = if figures.motion_rad().is_some() { lifted } else { 0.0 };
    // The load stays below the drum and above the ground.
    let per_rad = hoist_travel * scale;
    let way = Way::bounded(vec![start - lifted.max(30.0) / per_rad, start + (most - least - lifted) / per_rad]);
    let rise = |angle: f64| per_rad * (angle - start);
    let drum = (0.5 * diameter * by_figures).clamp(17.0, 26.0);
    let (low, hung) = (62.0 + drum, most - lifted);
    let sheave = low + hung;
    let ropes = [150.0, 178.0];
    let place = |index: u32| {
        if falls == 1 { 164.0 } else { ropes[0] + (ropes[1] - ropes[0]) * f64::from(index) / f64::from(falls - 1) }
    };
    let rope = |it: Drawing, x: f64, from: f64, to: f64, sign: f64| {
        it.moves(
            &way,
            [x, from],
            |angle| Placement::stretched([1.0, (to - from + sign * rise(angle)) / (to - from)]),
            |it| {
                let it = it.line(Look::Line, [x, from], [x, to]);
                if from > 40.0 && sign < 0.0 {
                    it.calls("rope_mass", "µ", [x, 0.5 * (from + to)], [118.0, 0.5 * (from + to)])
                } else {
                    it
                }
            },
        )
    };
    let mut drawing = Drawing::new()
        .line(Look::Axis, [20.0, 62.0], [232.0, 62.0])
        .actuator([28.0, 62.0])
        .ground_above([152.0, 20.0], 40.0);
    for index in 1..falls {
        drawing = rope(drawing, place(index), 20.0, sheave, -1.0);
    }
    drawing = drawing
        .rect(Look::Body, [106.0, 62.0 - drum], [110.0, 2.0 * drum])
        .rect(Look::Body, [100.0, 52.0 - drum], [8.0, 20.0 + 2.0 * drum])
        .rect(Look::Body, [214.0, 52.0 - drum], [8.0, 20.0 + 2.0 * drum])
        .rope([120.0, 62.0 - drum], [2.0 * drum, 0.0])
        .line(Look::Line, [204.0, 62.0 - drum], [204.0, 52.0 - drum]);
    drawing = rope(drawing, place(0), low, sheave, -1.0);
    // The counterweight hangs on as many falls as the load.
    let of_counterweight = |index: u32| {
        if falls == 1 { 204.0 } else { 198.0 + 16.0 * f64::from(index) / f64::from(falls - 1) }
    };
    drawing = rope(drawing, of_counterweight(0), low, low + 36.0, 1.0);
    if falls > 1 {
        drawing = drawing.ground_above([190.0, 20.0], 32.0);
    }
    for index in 1..falls {
        drawing = rope(drawing, of_counterweight(index), 20.0, low + 36.0, 1.0);
    }
    drawing
        .moves(
            &way,
            [204.0, low + 36.0],
            |angle| Placement::shifted([0.0, rise(angle)]),
            |it| {
                let (it, top) = if falls > 1 {
                    let middle = [206.0, low + 36.0];
                    (it.circle(Look::Housing, middle, 8.0).circle(Look::Hole, middle, 2.5), low + 46.0)
                } else {
                    (it, low + 36.0)
                };
                it.rect(Look::Body, [194.0, top], [24.0, 26.0]).calls(
                    "counterweight",
                    "m_G",
                    [216.0, top + 14.0],
                    [252.0, top + 18.0],
                )
            },
        )
        .moves(
            &way,
            [164.0, sheave],
            |angle| Placement::shifted([0.0, -rise(angle)]),
            |it| {
                let it = if falls > 1 {
                    it.circle(Look::Housing, [164.0, sheave], 14.0).circle(Look::Hole, [164.0, sheave], 4.0)
                } else {
                    it.line(Look::Line, [164.0, sheave], [164.0, sheave + 18.0])
                };
                it.rect(Look::Body, [140.0, sheave + 18.0], [48.0, 28.0])
                    .centre([164.0, sheave + 32.0])
                    .arrow([128.0, sheave + 36.0], [128.0, sheave + 6.0])
                    .calls("mass", "m", [180.0, sheave + 32.0], [226.0, sheave + 36.0])
            },
        )
        .line(Look::Thin, [222.0, 62.0 - drum], [250.0, 62.0 - drum])
        .line(Look::Thin, [222.0, low], [250.0, low])
        .dimension([244.0, 62.0 - drum], [244.0, low])
        .line(Look::Thin, [140.0, low], [84.0, low])
        .line(Look::Thin, [150.0, sheave], [84.0, sheave])
        .dimension([90.0, low], [90.0, sheave])
        .calls("drum_diameter", "D", [244.0, 62.0], [268.0, 62.0])
        .calls("falls", "n", [place(falls - 1), low + 0.6 * hung], [234.0, low + 22.0])
        .calls("inertia", "J", [204.0, 50.0], [262.0, 22.0])
        .calls("hanging", "L", [90.0, low + 0.5 * hung], [66.0, low + 0.5 * hung])
        .calls("friction_torque", "T_L", [106.0, 56.0], [130.0, 14.0])
}
