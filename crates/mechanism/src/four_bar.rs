//! `[mechanism.four_bar]`: crank, coupler and rocker on a fixed link.

use crate::drawing::{Drawing, GroupAngles as Way, Look, MechanismValues, Placement, polar as on_sheet};
use crate::equations::{Equations, Reduced, TWELFTH_RAD, panel_length};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, Recurrence, metres};
use crate::{Endless, Extra, Geometry, MechanismId, Output, gravity_m_s2};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia, Torque};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A four-bar linkage with a fully rotating crank.
///
/// r e^{iq} + c e^{iβ} = g + l e^{iψ},
/// J = J_1 + m_c |v_c|² + J_c β'² + J_r ψ'², |v_c|² = r² + s² β'² + 2 r s β' cos(q − β),
/// T_h = g_n sin δ (m_c y_c' + m_r y_r') + T_r ψ'
///
/// # Symbols
/// g fixed link, r crank, c coupler, l rocker \[m\]; q, β, ψ their angles relative to the fixed link, q = 0 along it
/// towards the rocker's pivot; J_1 inertia of the crank, m_c, J_c, s mass of the coupler, its inertia about its centre
/// and the distance of its centre from the crank pin, m_r mass of the rocker, J_r inertia of the rocker about its pivot
/// including its load, T_r torque on the rocker against increasing ψ; y height of a centre of mass, δ tilt of the axes
/// from the vertical
/// # Source
/// docs/theory/mechanisms.md: the closed loop and its two derivatives, Lagrange's equation
/// # Valid
/// the crank can rotate fully: see [`FourBar::faults`]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FourBar {
    /// g: distance of the two fixed pivots.
    pub ground: Length,
    /// r: length of the crank.
    pub crank: Length,
    /// c: length of the coupler.
    pub coupler: Length,
    /// l: length of the rocker.
    pub rocker: Length,
    /// Crossed linkage: the joint of coupler and rocker is on the other side of the diagonal.
    pub is_crossed: bool,
    /// J_1: inertia of the parts turning with the crank.
    pub inertia: MomentOfInertia,
    /// m_c: mass of the coupler.
    pub coupler_mass: Mass,
    /// s: distance of the coupler's centre of mass from the crank pin, along the coupler.
    pub coupler_centre: Length,
    /// J_c: inertia of the coupler about its centre of mass.
    pub coupler_inertia: MomentOfInertia,
    /// m_r: mass of the rocker.
    pub rocker_mass: Mass,
    /// s_r: distance of the rocker's centre of mass from its pivot, along the rocker.
    pub rocker_centre: Length,
    /// J_r: inertia of the rocker about its pivot, including its load.
    pub rocker_inertia: MomentOfInertia,
    /// T_r: torque on the rocker, against increasing ψ.
    pub rocker_torque: Torque,
    /// γ: angle of the fixed link above the horizontal, from crank to rocker.
    pub inclination: Angle,
    /// δ: tilt of the axes from the vertical; at 90° the linkage moves in a vertical plane.
    pub tilt: Angle,
}

/// Angles of coupler and rocker with their first and second derivatives with respect to q.
struct Course {
    q: f64,
    beta: [f64; 3],
    psi: [f64; 3],
}

type Vector = [f64; 2];

/// Force of the crank pin on the coupler, and the quantities from which it follows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pin {
    /// Angular accelerations of coupler and rocker [rad/s²].
    pub(crate) accelerations_rad_s2: [f64; 2],
    /// Acceleration of the coupler's centre of mass [m/s²].
    pub(crate) centre_m_s2: Vector,
    /// m_c (a − g) of the coupler \[N\].
    pub(crate) lacking_n: Vector,
    /// Moments of the force between coupler and rocker, about the crank pin and about the rocker's pivot \[Nm\].
    pub(crate) moments_nm: [f64; 2],
    /// Force of the pin \[N\].
    pub(crate) force_n: Vector,
}

fn polar(length: f64, angle: f64) -> Vector {
    [length * angle.cos(), length * angle.sin()]
}

impl FourBar {
    fn lengths(&self) -> [f64; 4] {
        [self.ground.si(), self.crank.si(), self.coupler.si(), self.rocker.si()]
    }

    /// Returns the faults of the lengths. A fully rotating crank requires that every diagonal between |g − r| and g + r
    /// closes a triangle with coupler and rocker (Grashof's condition with crank or fixed link as the shortest link).
    #[must_use]
    pub fn faults(&self) -> Vec<Geometry> {
        let [g, r, c, l] = self.lengths();
        let longest = g.max(r).max(c).max(l);
        if 2.0 * longest >= g + r + c + l {
            return vec![Geometry::NotAssembled];
        }
        Geometry::found([(r + g >= c + l, Geometry::TooShort), ((g - r).abs() <= (c - l).abs(), Geometry::TooUnequal)])
    }

    /// Returns the angles, by the law of cosines on the diagonal from the rocker's pivot to the crank pin, and their
    /// rates, from the loop r i e^{iq} + c i β' e^{iβ} = l i ψ' e^{iψ} and its derivative.
    fn course(&self, q: f64) -> Course {
        let [g, r, c, l] = self.lengths();
        let (x, y) = (r * q.cos() - g, r * q.sin());
        let squared = x * x + y * y;
        let cosine = (l * l + squared - c * c) / (2.0 * l * squared.sqrt());
        let corner = cosine.clamp(-1.0, 1.0).acos();
        let psi = y.atan2(x) + if self.is_crossed { corner } else { -corner };
        let beta = (l * psi.sin() - y).atan2(l * psi.cos() - x);
        let across = (psi - beta).sin();
        let (beta_1, psi_1) = (r * (q - psi).sin() / (c * across), r * (q - beta).sin() / (l * across));
        let along = (psi - beta).cos();
        let psi_2 = (r * (q - beta).cos() + c * beta_1 * beta_1 - l * psi_1 * psi_1 * along) / (l * across);
        let beta_2 = (r * (q - psi).cos() + c * beta_1 * beta_1 * along - l * psi_1 * psi_1) / (c * across);
        Course { q, beta: [beta, beta_1, beta_2], psi: [psi, psi_1, psi_2] }
    }

    /// Returns the weight per mass in the plane of the linkage, as a vector \[m/s²\].
    fn gravity(&self) -> Vector {
        let across = gravity_m_s2() * self.tilt.si().sin();
        let gamma = self.inclination.si();
        [-across * gamma.sin(), -across * gamma.cos()]
    }

    /// Returns the acceleration of the coupler's centre of mass [m/s²].
    fn coupler_acceleration(&self, course: &Course, [omega, alpha]: [f64; 2]) -> Vector {
        let (r, s) = (self.crank.si(), self.coupler_centre.si());
        let [beta, first, second] = course.beta;
        let mut sum = [0.0; 2];
        for (length, angle, rate, change) in
            [(r, course.q, omega, alpha), (s, beta, first * omega, first * alpha + second * omega * omega)]
        {
            let [ex, ey] = polar(length, angle);
            let [x, y] = &mut sum;
            *x += -rate * rate * ex - change * ey;
            *y += -rate * rate * ey + change * ex;
        }
        sum
    }

    /// Returns the crank pin relative to the rocker's pivot \[m\], and the angles of coupler and rocker with their derivatives.
    pub(crate) fn angles(&self, q: f64) -> (Vector, [f64; 3], [f64; 3]) {
        let course = self.course(q);
        let [x, y] = polar(self.crank.si(), q);
        ([x - self.ground.si(), y], course.beta, course.psi)
    }

    /// Returns the force of the crank pin and the quantities from which it follows, at a state of the crank.
    pub(crate) fn pin(&self, output: &Output) -> Pin {
        self.pin_force(&self.course(output.position_rad), [output.speed_rad_s, output.acceleration_rad_s2])
    }

    /// Returns the force of the crank pin on the coupler, in the plane of the linkage.
    ///
    /// The rocker's moment about its pivot and the coupler's about the crank pin yield the force between them; Newton's
    /// law for the coupler yields that at the pin.
    fn pin_force(&self, course: &Course, rates: [f64; 2]) -> Pin {
        let [_, _, c, l] = self.lengths();
        let [omega, alpha] = rates;
        let acceleration = |[_, first, second]: [f64; 3]| first * alpha + second * omega * omega;
        let cross = |[ax, ay]: Vector, [bx, by]: Vector| ax * by - ay * bx;
        let gravity = self.gravity();
        let (rocker, coupler) = (polar(l, course.psi[0]), polar(c, course.beta[0]));
        let accelerations_rad_s2 = [course.beta, course.psi].map(acceleration);
        let [of_coupler, of_rocker] = accelerations_rad_s2;
        // B acts on the rocker: J_r ψ̈ = l × B + s_r × m_r g − T_r.
        let on_rocker = self.rocker_inertia.si() * of_rocker + self.rocker_torque.si()
            - self.rocker_mass.si() * cross(polar(self.rocker_centre.si(), course.psi[0]), gravity);
        // −B acts on the coupler: J_c β̈ + s × m_c (a − g) = −c × B.
        let mass = self.coupler_mass.si();
        let centre_m_s2 = self.coupler_acceleration(course, rates);
        let [ax, ay] = centre_m_s2;
        let lacking_n = [mass * (ax - gravity[0]), mass * (ay - gravity[1])];
        let on_coupler =
            -self.coupler_inertia.si() * of_coupler - cross(polar(self.coupler_centre.si(), course.beta[0]), lacking_n);
        // l × B and c × B by Cramer's rule.
        let across = cross(rocker, coupler);
        let force = [
            (on_rocker * coupler[0] - on_coupler * rocker[0]) / across,
            (on_rocker * coupler[1] - on_coupler * rocker[1]) / across,
        ];
        Pin {
            accelerations_rad_s2,
            centre_m_s2,
            lacking_n,
            moments_nm: [on_coupler, on_rocker],
            force_n: [lacking_n[0] + force[0], lacking_n[1] + force[1]],
        }
    }

    /// Returns 1 over the efficiency while the pin force drives the linkage, else 1.
    pub(crate) fn pin_losses(&self, at: &Instant<'_>) -> f64 {
        let torque = self.pin_torque(&self.course(at.output.position_rad), self.pin(at.output).force_n);
        at.before_losses(torque.signum(), at.output.direction)
    }

    /// Returns the torque of a crank pin force about the axis of the crank \[Nm\].
    fn pin_torque(&self, course: &Course, [x, y]: Vector) -> f64 {
        let [px, py] = polar(self.crank.si(), course.q);
        px * y - py * x
    }
}

impl Equations for FourBar {
    fn id(&self) -> MechanismId {
        MechanismId::FourBar
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let course = self.course(position_rad);
        let (q, [beta, beta_1, beta_2], [psi, psi_1, psi_2]) = (course.q, course.beta, course.psi);
        let (r, s) = (self.crank.si(), self.coupler_centre.si());
        let (mass, turning, rocker) = (self.coupler_mass.si(), self.coupler_inertia.si(), self.rocker_inertia.si());
        let (sine, cosine) = (q - beta).sin_cos();
        let speed = r * r + s * s * beta_1 * beta_1 + 2.0 * r * s * beta_1 * cosine;
        let speed_slope =
            2.0 * s * s * beta_1 * beta_2 + 2.0 * r * s * (beta_2 * cosine - beta_1 * (1.0 - beta_1) * sine);
        let [gx, gy] = self.gravity();
        // −g · d(centre)/dq
        let rise = |parts: &[(f64, f64, f64)]| {
            parts.iter().map(|(length, angle, rate)| length * rate * (gx * angle.sin() - gy * angle.cos())).sum::<f64>()
        };
        let weight = mass * rise(&[(r, q, 1.0), (s, beta, beta_1)])
            + self.rocker_mass.si() * rise(&[(self.rocker_centre.si(), psi, psi_1)]);
        Reduced {
            inertia: self.inertia.si()
                + extra.inertia.si()
                + mass * speed
                + turning * beta_1 * beta_1
                + rocker * psi_1 * psi_1,
            slope: mass * speed_slope + 2.0 * turning * beta_1 * beta_2 + 2.0 * rocker * psi_1 * psi_2,
            holding: weight + self.rocker_torque.si() * psi_1 + extra.torque.si(),
            coulomb: 0.0,
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        Self {
            inertia: self.inertia * factor,
            coupler_mass: self.coupler_mass * factor,
            coupler_inertia: self.coupler_inertia * factor,
            rocker_mass: self.rocker_mass * factor,
            rocker_inertia: self.rocker_inertia * factor,
            ..*self
        }
    }

    /// Branch points where coupler and rocker are aligned, cos q = (g² + r² − (c ± l)²)/2gr, and where the diagonal
    /// vanishes, cos q = (g² + r²)/2gr; all at a distance of arcosh |cos q| from the real axis.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        let [g, r, c, l] = self.lengths();
        let nearest = [c + l, c - l, 0.0]
            .map(|diagonal| ((g * g + r * r - diagonal * diagonal) / (2.0 * g * r)).abs().max(1.0).acosh())
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        Some(TWELFTH_RAD.min(panel_length(nearest)))
    }

    fn endless(&self) -> Endless {
        Endless::EachRevolution
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let overhang = Overhang { of_mechanism: true, of_payload: false };
        Some(OnFlange { missing: None, overhang, recurrence: Recurrence::EachRevolution })
    }

    /// Returns the force of the coupler on the crank pin, before the losses while the crank drives, in full while the
    /// linkage does.
    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let [x, y] = self.pin(at.output).force_n;
        let mut forces = FlangeForces::default();
        // Losses do not change the direction of a force: both components scale with the torque of the pin.
        let share = self.pin_losses(at);
        forces.act([0.0, 0.0, metres(at.mounting.overhang)], [-x * share, -y * share, 0.0]);
        forces
    }

    /// Returns the torque of the pin force, at whose change of sign driving and driven side are exchanged.
    fn switches(&self, at: &Instant<'_>) -> Option<[f64; 2]> {
        let course = self.course(at.output.position_rad);
        let force = self.pin(at.output).force_n;
        (at.efficiency_driving != 1.0).then(|| [self.pin_torque(&course, force), 0.0])
    }
}

/// Crank angle of the drawing if none is stated \[rad\].
const NEUTRAL_RAD: f64 = 1.107;

/// Fixed link, crank, coupler and rocker on the sheet if they are not stated or form no linkage.
const NEUTRAL: [f64; 4] = [198.0, 49.2, 165.0, 93.0];

/// Returns the linkage for drawing, scaled so that a full revolution fits the sheet.
fn drawn(figures: &MechanismValues) -> FourBar {
    let is_crossed = figures.of("crossed") == Some(1.0);
    let of = |[ground, crank, coupler, rocker]: [f64; 4]| FourBar {
        ground: Length::from_si(ground),
        crank: Length::from_si(crank),
        coupler: Length::from_si(coupler),
        rocker: Length::from_si(rocker),
        is_crossed,
        ..FourBar::default()
    };
    let stated = ["ground", "crank", "coupler", "rocker"].map(|key| figures.length(key));
    let [Some(g), Some(r), Some(c), Some(l)] = stated else { return of(NEUTRAL) };
    let linkage = of([g, r, c, l]);
    if !linkage.faults().is_empty() {
        return of(NEUTRAL);
    }
    let (mut left, mut right, mut high) = (-r, r.max(g), r);
    for step in 0..=60 {
        let [x, y] = polar(l, linkage.course(f64::from(step) * TAU / 60.0).psi[0]);
        (left, right, high) = (left.min(g + x), right.max(g + x), high.max(y.abs()));
    }
    let scale = (300.0 / (right - left)).min(110.0 / high);
    of([g, r, c, l].map(|length| length * scale))
}

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let linkage = drawn(figures);
    let [g, r, _, l] = linkage.lengths();
    let (start, lean) = (figures.start_rad(), figures.of("start_angle").unwrap_or(NEUTRAL_RAD));
    let (crank, rocker) = ([92.0, 128.0], [92.0 + g, 128.0]);
    let at = |angle: f64| {
        let course = linkage.course(angle - start + lean);
        let pin = on_sheet(crank, r, course.q);
        (pin, on_sheet(rocker, l, course.psi[0]), course.beta[0], course.psi[0])
    };
    let (pin, joint, beta, psi) = at(start);
    let between = |[ax, ay]: Vector, [bx, by]: Vector, share: f64| [ax + share * (bx - ax), ay + share * (by - ay)];
    let aside = |at: Vector, angle: f64, by: f64| on_sheet(at, by, angle + FRAC_PI_2);
    let knee = |share: f64, by: f64| aside(between(pin, joint, share), beta, by);
    let of_rocker = |share: f64, by: f64| aside(between(rocker, joint, share), psi, by);
    let share = |key: &str, of: f64, whole: &str, neutral: f64| {
        figures.length(key).zip(figures.length(whole)).map_or(neutral, |(part, whole)| (part / whole).min(of))
    };
    let (of_coupler, of_rocker_centre) =
        (share("coupler_centre", 1.2, "coupler", 0.46), share("rocker_centre", 1.2, "rocker", 0.48));
    Drawing::new()
        .leaning(figures.of("inclination").unwrap_or(0.0))
        .line(Look::Axis, [30.0, 128.0], [rocker[0].max(290.0) + 62.0, 128.0])
        .face(crank, 40.0_f64.min(0.9 * r).max(16.0))
        .pivot(rocker)
        .moves(
            &Way::round(start),
            rocker,
            |angle| Placement::turned(at(angle).3 - psi),
            |it| {
                it.bar(rocker, joint, 8.0)
                    .centre(of_rocker(of_rocker_centre, 0.0))
                    .calls("rocker", "l", of_rocker(0.22, 0.0), of_rocker(0.22, 36.0))
                    .calls("rocker_mass", "m_r", of_rocker(of_rocker_centre, -5.0), of_rocker(0.7, -42.0))
                    .calls("rocker_centre", "s_r", of_rocker(0.12, 0.0), of_rocker(-0.06, 46.0))
                    .calls("rocker_inertia", "J_r", of_rocker(0.8, 0.0), of_rocker(1.08, -30.0))
            },
        )
        .turns(start, crank, 1.0, |it| {
            it.bar(crank, pin, 8.0).calls(
                "crank",
                "r",
                between(crank, pin, 0.5),
                aside(between(crank, pin, 0.9), lean, 34.0),
            )
        })
        .moves(
            &Way::round(start),
            pin,
            |angle| {
                let (now, _, angle, _) = at(angle);
                let shift = [now[0] - pin[0], now[1] - pin[1]];
                Placement { turn_rad: angle - beta, ..Placement::shifted(shift) }
            },
            |it| {
                it.bar(pin, joint, 6.0)
                    .centre(knee(of_coupler, 0.0))
                    .calls("coupler", "c", knee(0.74, 0.0), knee(0.7, 24.0))
                    .calls("coupler_mass", "m_c", knee(of_coupler, 5.0), knee(0.3, 38.0))
                    .calls("coupler_centre", "s_c", knee(0.23, 0.0), knee(0.08, 32.0))
                    .calls("coupler_inertia", "J_c", knee(of_coupler, -5.0), knee(0.56, -26.0))
            },
        )
        .sweep(Look::Arrow, crank, r + 10.0, [0.0, if lean.abs() > 0.2 { lean } else { NEUTRAL_RAD }])
        .sweep(Look::Arrow, rocker, 44.0, [0.4, 1.1])
        .line(Look::Thin, crank, [crank[0], 184.0])
        .line(Look::Thin, [rocker[0], 150.0], [rocker[0], 184.0])
        .dimension([crank[0], 180.0], [rocker[0], 180.0])
        .calls("ground", "g", [crank[0] + 0.45 * g, 180.0], [crank[0] + 0.45 * g, 166.0])
        .calls("inertia", "J", on_sheet(crank, 20.0, -2.2), [40.0, 172.0])
        .calls("rocker_torque", "T_r", on_sheet(rocker, 44.0, 0.5), on_sheet(rocker, 68.0, 0.5))
        .calls("start_angle", "φ_0", on_sheet(crank, r + 10.0, 0.25 * lean), on_sheet(crank, r + 34.0, 0.08))
        .calls("inclination", "γ", [rocker[0] + 52.0, 128.0], [rocker[0] + 66.0, 146.0])
        .calls("friction_torque", "T_L", on_sheet(crank, 20.0, 2.8), [28.0, 104.0])
}
