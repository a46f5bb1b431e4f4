//! `[mechanism.slider_crank]`: crank, rod and slider.

use crate::drawing::{Drawing, GroupAngles as Way, Look, MechanismValues, Placement, polar};
use crate::equations::{Equations, Reduced, TWELFTH_RAD, panel_length};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, Recurrence, metres};
use crate::{Endless, Extra, MechanismId, Output, gravity_m_s2};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia};

/// A slider-crank with payload on the slider.
///
/// x(q) = r cos q + √(l² − r² sin² q), J = J_c + (m + m_p) x'², J' = 2 (m + m_p) x' x'', T_h = x' ((m + m_p) g sin γ + F_p)
///
/// # Symbols
/// r crank radius, l rod length, q = 0 where the slider is farthest out, J_c inertia of the crank (with the rotating
/// share of the rod), m slider (with the translating share of the rod), γ inclination of the outward direction
/// # Source
/// docs/theory/mechanisms.md
/// # Valid
/// l > r, line of the slider through the axis of the crank; the rotation of the rod is represented by the two shares
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SliderCrank {
    /// r: crank radius.
    pub crank: Length,
    /// l: rod length, greater than r.
    pub rod: Length,
    /// J_c: inertia of the rotating parts.
    pub inertia: MomentOfInertia,
    /// m: mass of the sliding parts.
    pub mass: Mass,
    /// γ: inclination of the outward direction above the horizontal.
    pub inclination: Angle,
    /// q_0: crank angle at position zero of the motion.
    pub angle: Angle,
}

/// x of the slider as a function of the crank angle, its derivatives, and tan ψ of the rod.
struct Course {
    place: f64,
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
            place: r * cosine + root,
            first: -r * sine + root_slope,
            second: -r * cosine + (-r * r * (cosine * cosine - sine * sine) - root_slope * root_slope) / root,
            lean: r * sine / root,
        }
    }

    /// Returns x' and x'' at a position [m/rad], [m/rad²].
    pub(crate) fn rates(&self, position_rad: f64) -> [f64; 2] {
        let course = self.course(position_rad);
        [course.first, course.second]
    }

    /// Returns the force of the rod on the slider along its line \[N\].
    ///
    /// F = (m + m_p)(x' α + x'' ω² + g sin γ) + F_p
    fn rod_force(&self, course: &Course, output: &Output, extra: &Extra) -> f64 {
        let acceleration =
            course.first * output.acceleration_rad_s2 + course.second * output.speed_rad_s * output.speed_rad_s;
        let mass = self.mass.si() + extra.mass.si();
        mass * (acceleration + gravity_m_s2() * self.inclination.si().sin()) + extra.force.si()
    }

    /// Returns the force of the rod on the slider along its line \[N\], and x' [m/rad].
    pub(crate) fn rod(&self, at: &Instant<'_>) -> (f64, f64) {
        let course = self.course(at.output.position_rad);
        (self.rod_force(&course, at.output, at.extra), course.first)
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

    /// The square root has its branch points at sin q = l/r.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        Some(TWELFTH_RAD.min(panel_length((self.rod.si() / self.crank.si()).acosh())))
    }

    fn endless(&self) -> Endless {
        Endless::EachRevolution
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let overhang = Overhang { of_mechanism: true, of_payload: false };
        Some(OnFlange { missing: None, overhang, recurrence: Recurrence::EachRevolution })
    }

    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let course = self.course(at.output.position_rad);
        let (force, outward) = self.rod(at);
        // Outward travel has the sign of x' ω.
        let amount = at.before_losses(force, outward * at.output.direction);
        let mut forces = FlangeForces::default();
        // Amount and line of the rod force: its own sign reverses both components.
        forces.act([0.0, 0.0, metres(at.mounting.overhang)], [-amount, amount * course.lean, 0.0]);
        forces
    }

    fn switches(&self, at: &Instant<'_>) -> Option<[f64; 2]> {
        let course = self.course(at.output.position_rad);
        // With losses the amount steps at the dead centres, where driving and driven side are exchanged.
        let dead_centre = if at.efficiency_driving == 1.0 { 0.0 } else { course.first };
        Some([self.rod_force(&course, at.output, at.extra), dead_centre])
    }
}

/// Crank angle of the drawing if none is stated \[rad\].
const NEUTRAL_RAD: f64 = 0.936;

/// Longest drawn rod relative to the crank, so that the crank stays visible.
const LONGEST_ROD: f64 = 8.0;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let axis = [88.0, 112.0];
    let ratio = figures.length("rod").zip(figures.length("crank")).map_or(3.46, |(rod, crank)| rod / crank);
    let ratio = ratio.clamp(1.05, LONGEST_ROD);
    let r = (210.0 / (1.0 + ratio)).min(60.0);
    let l = ratio * r;
    let (start, lean) = (figures.start_rad(), figures.of("start_angle").unwrap_or(NEUTRAL_RAD));
    // The linkage without masses, with its lengths on the sheet.
    let linkage = SliderCrank { crank: Length::from_si(r), rod: Length::from_si(l), ..SliderCrank::default() };
    let pin = |angle: f64| polar(axis, r, angle);
    let slider = |angle: f64| axis[0] + linkage.course(angle).place;
    let rod_lean = |angle: f64| -linkage.course(angle).lean.atan();
    let (at, x) = (pin(lean), slider(lean));
    let of = |angle: f64| angle - start + lean;
    let (near, far) = (axis[0] + l - r - 37.0, axis[0] + l + r + 37.0);
    Drawing::new()
        .along_a_line(figures)
        .line(Look::Axis, [24.0, 112.0], [far.max(366.0), 112.0])
        .face(axis, r.max(30.0) - 4.0)
        .ground([near, 134.0], far - near)
        .line(Look::Line, [near, 90.0], [far, 90.0])
        .turns(start, axis, 1.0, |it| {
            it.bar(axis, at, 9.0).calls(
                "crank",
                "r",
                polar(axis, 0.5 * r, lean),
                polar(polar(axis, 0.7 * r, lean), 42.0, lean + 1.57),
            )
        })
        .moves(
            &Way::round(start),
            [x, 112.0],
            |angle| Placement::shifted([slider(of(angle)) - x, 0.0]),
            |it| {
                it.rect(Look::Body, [x - 31.0, 92.0], [62.0, 40.0])
                    .arrow([x + 84.0, 112.0], [x + 38.0, 112.0])
                    .arrow([x - 20.0, 78.0], [x + 34.0, 78.0])
                    .calls("mass", "m", [x + 16.0, 104.0], [x + 52.0, 158.0])
                    .calls("process_force", "F", [x + 68.0, 112.0], [x + 76.0, 92.0])
            },
        )
        .moves(
            &Way::round(start),
            at,
            |angle| {
                let [px, py] = pin(of(angle));
                let turn_rad = rod_lean(of(angle)) - rod_lean(lean);
                Placement { turn_rad, ..Placement::shifted([px - at[0], py - at[1]]) }
            },
            |it| {
                let middle = [0.5 * (at[0] + x), 0.5 * (at[1] + 112.0)];
                it.bar(at, [x, 112.0], 7.0).calls("rod", "l", middle, [middle[0] + 4.0, 48.0])
            },
        )
        .sweep(Look::Arrow, axis, r + 18.0, [0.0, if lean.abs() > 0.2 { lean } else { NEUTRAL_RAD }])
        .calls("inertia", "J", polar(axis, 26.0, -2.2), [38.0, 168.0])
        .calls("start_angle", "φ_0", polar(axis, r + 18.0, 0.3 * lean), polar(axis, r + 44.0, -0.32))
        .calls("inclination", "γ", [28.0, 112.0], [14.0, 128.0])
        .calls("friction_torque", "T_L", polar(axis, 26.0, 2.5), [26.0, 56.0])
}
