//! `[mechanism.scissor_lift]`: a platform on crossed arms that a screw draws together.

use crate::drawing::{Drawing, GroupAngles as Way, Look, MechanismValues, Placement};
use crate::equations::{Equations, Reduced, panel_length};
use crate::flange::{FlangeDatum, FlangeForces, Instant, OnFlange, Overhang, Recurrence};
use crate::{Endless, Extra, Geometry, MechanismId, gravity_m_s2};
use quantities::unit::DEGREE;
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia};
use std::f64::consts::FRAC_PI_2;

/// A scissor lift with a screw at the lower end of an arm.
///
/// b = L cos θ_0 − k q, w = √(L² − b²), h = n w, h' = n k b/w, h'' = −n k² L²/w³,
/// J = J_s + (m + m_p) h'² + m_a (k²/4 + (n²/3 − 1/12) w'² + L² θ'²/12),
/// T_h = (m + m_p + m_a/2) g h' + F_p h'
///
/// # Symbols
/// n stages, L length of an arm between its end pins, b distance of the lower pins, w height of a stage, h height of
/// the platform, k = lead/2π, θ angle of the arms above the horizontal with θ_0 at q = 0 and θ' = k/w, w' = k b/w, m
/// platform, m_p payload of the segment, m_a mass of all arms, J_s inertia of the screw
/// # Source
/// docs/theory/mechanisms.md; Lagrange's equation
/// # Valid
/// arms pinned at their centre, of uniform mass; one lower pin fixed, the other on the nut; 0 < θ < 90°. The torque
/// tends to infinity as θ approaches 0
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScissorLift {
    /// n: number of stages.
    pub stages: u32,
    /// L: length of an arm between its end pins.
    pub arm_length: Length,
    /// Travel of the nut per turn.
    pub lead: Length,
    /// θ_0: angle of the arms above the horizontal at position zero.
    pub angle: Angle,
    /// m: platform with its permanent load.
    pub mass: Mass,
    /// m_a: mass of all arms.
    pub arm_mass: Mass,
    /// J_s: inertia of screw and coupling.
    pub inertia: MomentOfInertia,
}

/// Smallest permitted arm angle [°], at which the thrust of the weight is 57 times that at 45°. A guess: no lift is
/// built for less.
const LEAST_ANGLE_DEG: f64 = 1.0;

/// Height of a stage and the rates of the linkage at a position.
struct Course {
    /// w' and w'' [m/rad], [m/rad²]
    rise: f64,
    rise_slope: f64,
    /// θ' and θ'' \[1\], [1/rad]
    turn: f64,
    turn_slope: f64,
}

impl ScissorLift {
    /// Returns the faults of the data.
    #[must_use]
    pub fn faults(&self) -> Vec<Geometry> {
        let angle = self.angle.in_unit(&DEGREE);
        Geometry::found([(angle < LEAST_ANGLE_DEG, Geometry::Flat), (angle >= 90.0, Geometry::Upright)])
    }

    /// Returns the angle of the screw for a stroke of the platform from a position; the strokes down and up that are possible
    /// there \[m\] if this one is not.
    ///
    /// q' − q = (√(L² − w²) − √(L² − w'²)) / k, w' = w + Δh/n
    ///
    /// # Symbols
    /// Δh stroke; others as for [`ScissorLift`]
    /// # Errors
    /// When the platform does not reach the height.
    pub fn turned(&self, position_rad: f64, stroke: Length) -> Result<f64, [f64; 2]> {
        let (l, n) = (self.arm_length.si(), f64::from(self.stages));
        let (_, widest) = self.bases();
        let height = |base: f64| (l * l - base * base).max(0.0).sqrt();
        let (base, lowest) = (self.base(position_rad), height(widest));
        let to = height(base) + stroke.si() / n;
        // The ends belong to the range, up to rounding.
        let slack = 1e-9 * l;
        if to < lowest - slack || to > l + slack {
            return Err([lowest, l].map(|end| n * (end - height(base))));
        }
        Ok((base - height(to.clamp(lowest, l))) / self.travel())
    }

    /// Returns the stroke of the platform between the smallest arm angle and upright arms.
    #[must_use]
    pub fn stroke(&self) -> Length {
        let (l, widest) = (self.arm_length.si(), self.bases().1);
        Length::from_si(f64::from(self.stages) * (l - (l * l - widest * widest).sqrt()))
    }

    /// Returns k, the travel per angle [m/rad].
    fn travel(&self) -> f64 {
        self.lead.si() / std::f64::consts::TAU
    }

    /// Returns b at q = 0, and the longest b, at the smallest arm angle \[m\].
    fn bases(&self) -> (f64, f64) {
        let (l, least) = (self.arm_length.si(), Angle::new_in(LEAST_ANGLE_DEG, &DEGREE));
        (l * self.angle.si().cos(), l * least.si().cos())
    }

    /// Returns b(q), limited by upright arms and the smallest arm angle \[m\].
    fn base(&self, position_rad: f64) -> f64 {
        let (start, most) = self.bases();
        (start - self.travel() * position_rad).max(0.0).min(most)
    }

    fn course(&self, position_rad: f64) -> Course {
        let (k, l, b) = (self.travel(), self.arm_length.si(), self.base(position_rad));
        let w = (l * l - b * b).sqrt();
        Course {
            rise: k * b / w,
            rise_slope: -k * k * l * l / (w * w * w),
            turn: k / w,
            turn_slope: -k * k * b / (w * w * w),
        }
    }

    /// Returns b, w and w' at a position \[m\], \[m\], [m/rad].
    pub(crate) fn linkage(&self, position_rad: f64) -> (f64, f64, f64) {
        let (l, b) = (self.arm_length.si(), self.base(position_rad));
        (b, (l * l - b * b).sqrt(), self.course(position_rad).rise)
    }

    /// Returns the thrust of the screw \[N\].
    fn thrust(&self, at: &Instant<'_>) -> f64 {
        let screw_less = Self { inertia: MomentOfInertia::from_si(0.0), ..*self };
        at.line_torque(&screw_less) / self.travel()
    }
}

impl Equations for ScissorLift {
    fn id(&self) -> MechanismId {
        MechanismId::ScissorLift
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let (n, k, l) = (f64::from(self.stages), self.travel(), self.arm_length.si());
        let Course { rise, rise_slope, turn, turn_slope } = self.course(position_rad);
        let (carried, arms) = (self.mass.si() + extra.mass.si(), self.arm_mass.si());
        // Σ (i + ½)² over the stages, divided by their number: squared heights of the arm centres.
        let (high, wide) = (n * n / 3.0 - 1.0 / 12.0, l * l / 12.0);
        let along = (carried + 0.5 * arms) * gravity_m_s2() + extra.force.si();
        Reduced {
            inertia: self.inertia.si()
                + extra.inertia.si()
                + carried * n * n * rise * rise
                + arms * (0.25 * k * k + high * rise * rise + wide * turn * turn),
            slope: 2.0 * carried * n * n * rise * rise_slope
                + 2.0 * arms * (high * rise * rise_slope + wide * turn * turn_slope),
            holding: n * rise * along + extra.torque.si(),
            coulomb: 0.0,
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        let (mass, arm_mass, inertia) = (self.mass * factor, self.arm_mass * factor, self.inertia * factor);
        Self { mass, arm_mass, inertia, ..*self }
    }

    /// The square root has its branch points at b = ±L, on the real axis beyond the lowest position.
    fn smooth_over(&self, from_rad: f64, to_rad: f64) -> Option<f64> {
        let widest = self.base(from_rad).max(self.base(to_rad));
        Some(panel_length((self.arm_length.si() - widest) / self.travel()))
    }

    fn endless(&self) -> Endless {
        Endless::Never
    }

    /// Returns the positions at the smallest arm angle and with upright arms.
    fn range_rad(&self) -> Option<(f64, f64)> {
        let (start, most) = self.bases();
        Some(((start - most) / self.travel(), start / self.travel()))
    }

    fn on_flange(&self) -> Option<OnFlange> {
        // The thrust of the screw acts along the axis.
        let overhang = Overhang { of_mechanism: false, of_payload: false };
        Some(OnFlange { missing: Some(FlangeDatum::FlangeShare), overhang, recurrence: Recurrence::Never })
    }

    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        FlangeForces { axial_n: self.thrust(at), ..FlangeForces::default() }
    }

    fn switches(&self, at: &Instant<'_>) -> Option<[f64; 2]> {
        Some([self.thrust(at), 0.0])
    }
}

/// Largest number of stages drawn, from the bottom.
const STAGES_MOST: u32 = 4;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let stages = figures.count("stages", 2, STAGES_MOST);
    let n = f64::from(stages);
    let arm = figures.length("arm_length").unwrap_or(1.2);
    let upright = Angle::new_in(89.0, &DEGREE).si();
    let angle = figures.of("arm_angle").unwrap_or(0.24).clamp(0.05, upright);
    let lift = ScissorLift {
        stages,
        arm_length: Length::from_si(arm),
        lead: Length::from_si(figures.length("lead").unwrap_or(0.01)),
        angle: Angle::from_si(angle),
        ..ScissorLift::default()
    };
    let lean = |position: f64| (lift.base(position) / arm).clamp(-1.0, 1.0).acos();
    let highest = figures.motion_rad().map_or(angle, |[_, to]| lean(to).max(angle));
    // High lifts are drawn smaller to keep the sheet readable.
    let long = (210.0 / (n * highest.sin())).clamp(70.0, 185.0);
    let scale = long / arm;
    let high = |position: f64| long * lean(position).sin();
    let wide = |position: f64| scale * lift.base(position);
    let (right, y, start) = (330.0, 140.0, figures.start_rad());
    let (b, w) = (wide(start), high(start));
    // Rows every 1.5° of the arm angle, from flat to upright.
    let (flat, step) = (Angle::new_in(LEAST_ANGLE_DEG, &DEGREE).si(), Angle::new_in(1.5, &DEGREE).si());
    let count = (0_u32..).take_while(|index| flat + f64::from(*index) * step < upright);
    let first = arm * angle.cos();
    let leans = count.map(|index| flat + f64::from(index) * step).chain([upright, FRAC_PI_2]);
    let angles = leans.map(|lean| (first - arm * lean.cos()) / lift.travel()).collect();
    let way = Way::bounded(angles);
    let top = y - n * w;
    let mut drawing = Drawing::new()
        .line(Look::Axis, [8.0, y], [372.0, y])
        .actuator([16.0, y])
        .spindle([94.0, y], 220.0, lift.lead.si() * scale, start)
        .rect(Look::Housing, [314.0, y - 12.0], [12.0, 24.0])
        .ground([110.0, y + 28.0], 240.0);
    for stage in 0..stages {
        let below = f64::from(stage);
        let foot = y - below * w;
        for leans_left in [false, true] {
            let place = |position: f64| {
                let turn = lean(position) - lean(start);
                let shift = [0.5 * (b - wide(position)), (below + 0.5) * (w - high(position))];
                Placement { turn_rad: if leans_left { -turn } else { turn }, ..Placement::shifted(shift) }
            };
            let (from, to) = if leans_left {
                ([right, foot], [right - b, foot - w])
            } else {
                ([right - b, foot], [right, foot - w])
            };
            let middle = [right - 0.5 * b, foot - 0.5 * w];
            let share = |part: f64| [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
            drawing = drawing.moves(&way, middle, place, |it| {
                let it = it.bar(from, to, 5.0);
                let it = if stage + 1 == stages && leans_left {
                    it.calls("stages", "n", middle, [366.0, middle[1]])
                } else {
                    it
                };
                match (stage, leans_left) {
                    (0, false) => it.calls("arm_angle", "θ_0", share(0.14), [right - b - 22.0, y - 20.0]).calls(
                        "arm_length",
                        "L",
                        share(0.75),
                        [362.0, y - 28.0],
                    ),
                    (0, true) => it.calls("arm_mass", "m_a", share(0.8), [right - b - 22.0, foot - w + 6.0]),
                    _ => it,
                }
            });
        }
    }
    drawing
        .moves(
            &way,
            [right - b, y],
            |position| Placement::shifted([b - wide(position), 0.0]),
            |it| it.rect(Look::Hole, [right - b - 12.0, y - 8.0], [24.0, 16.0]),
        )
        .moves(
            &way,
            [240.0, top],
            |position| Placement::shifted([0.0, n * (w - high(position))]),
            |it| {
                it.rect(Look::Body, [136.0, top - 18.0], [210.0, 12.0])
                    .centre([240.0, top - 26.0])
                    .arrow([300.0, top - 46.0], [300.0, top - 22.0])
                    .arrow([118.0, top + 10.0], [118.0, top - 30.0])
                    .calls("mass", "m", [180.0, top - 12.0], [150.0, top - 34.0])
                    .calls("process_force", "F", [300.0, top - 40.0], [322.0, top - 40.0])
            },
        )
        .calls("inertia", "J", [276.0, 146.0], [276.0, 184.0])
        .calls("friction_torque", "T_L", [98.0, 134.0], [92.0, 88.0])
}
