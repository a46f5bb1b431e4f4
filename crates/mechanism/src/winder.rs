//! `[mechanism.winder]`: a web that is wound up or off, so that the diameter changes with every turn.

use crate::drawing::{Drawing, GroupAngles as Way, Look, MechanismValues, Placement, polar};
use crate::equations::{Equations, Reduced};
use crate::flange::{FlangeForces, Instant, OnFlange, Overhang, Recurrence, cosine, metres, sine};
use crate::{Endless, Extra, Geometry, MechanismId, gravity_m_s2};
use quantities::{Angle, Force, Length, MassDensity, Measure, MomentOfInertia};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Direction of the web for a positive rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Winding {
    /// Wound onto the roll.
    Up,
    /// Wound off the roll.
    Off,
}

/// A winder with core and web.
///
/// r(q) = D_0/2 ± s q/2π, J = J_k + ½ π ρ b (r⁴ − r_k⁴), T_h = ± F r, T_u = J α + T_h
///
/// # Symbols
/// D_0 diameter at q = 0, s thickness of the web, J_k inertia of core and shaft, ρ density of the wound material, b
/// width, r_k radius of the core, F tension of the web; upper sign for winding up, lower sign for winding off
/// # Source
/// docs/theory/mechanisms.md: balance of angular momentum of the roll with the incoming web
/// # Valid
/// tightly wound web, incoming without slip. It adds the angular momentum ṁ v r = J' ω², so that the change of inertia
/// requires no torque of its own: the term ½ J' ω² of Lagrange's equation holds for constant mass only
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winder {
    /// Direction of the web for a positive rotation.
    pub winding: Winding,
    /// D_k: outer diameter of the core.
    pub core_diameter: Length,
    /// D_f: diameter of the full roll.
    pub full_diameter: Length,
    /// D_0: diameter at position zero, between core and full roll.
    pub start_diameter: Length,
    /// s: thickness of the web, by which the radius changes per turn.
    pub thickness: Length,
    /// b: width of the web.
    pub width: Length,
    /// ρ: density of the wound material.
    pub density: MassDensity,
    /// F: tension of the web.
    pub tension: Force,
    /// J_k: inertia of core and shaft.
    pub inertia: MomentOfInertia,
}

impl Winder {
    /// Returns the faults of the data.
    #[must_use]
    pub fn faults(&self) -> Vec<Geometry> {
        let (core, full, start) = (self.core_diameter.si(), self.full_diameter.si(), self.start_diameter.si());
        Geometry::found([
            (full <= core, Geometry::FullBelowCore),
            (start < core, Geometry::StartBelowCore),
            (start > full && full > core, Geometry::StartAboveFull),
        ])
    }

    /// Returns +1 if a positive rotation winds up, −1 if it winds off.
    const fn sign(&self) -> f64 {
        match self.winding {
            Winding::Up => 1.0,
            Winding::Off => -1.0,
        }
    }

    /// Returns r(q), limited by core and full roll \[m\].
    pub(crate) fn radius(&self, position_rad: f64) -> f64 {
        let free = 0.5 * self.start_diameter.si() + self.sign() * self.thickness.si() * position_rad / TAU;
        free.max(0.5 * self.core_diameter.si()).min(0.5 * self.full_diameter.si())
    }
}

impl Equations for Winder {
    fn id(&self) -> MechanismId {
        MechanismId::Winder
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let (r, core) = (self.radius(position_rad), 0.5 * self.core_diameter.si());
        let web = 0.5 * PI * self.density.si() * self.width.si() * (r * r * r * r - core * core * core * core);
        Reduced {
            inertia: self.inertia.si() + extra.inertia.si() + web,
            slope: 0.0,
            holding: self.sign() * self.tension.si() * r + extra.torque.si(),
            coulomb: 0.0,
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        Self { inertia: self.inertia * factor, density: self.density * factor, ..*self }
    }

    /// The equations are polynomials of the fourth degree.
    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        Some(f64::INFINITY)
    }

    /// A full roll is replaced by a core: a cycle need not return.
    fn endless(&self) -> Endless {
        Endless::Never
    }

    /// Returns the positions at core and full roll.
    fn range_rad(&self) -> Option<(f64, f64)> {
        let turns = |diameter: Length| {
            self.sign() * (diameter.si() - self.start_diameter.si()) / (2.0 * self.thickness.si()) * TAU
        };
        let (core, full) = (turns(self.core_diameter), turns(self.full_diameter));
        Some((core.min(full), core.max(full)))
    }

    fn on_flange(&self) -> Option<OnFlange> {
        let overhang = Overhang { of_mechanism: true, of_payload: false };
        Some(OnFlange { missing: None, overhang, recurrence: Recurrence::Never })
    }

    /// Returns tension and weight of the roll; the direction of the web is not stated, so that the tension and the
    /// radial part of the weight add in the worst case. Without a stated tilt the axis is horizontal.
    fn forces(&self, at: &Instant<'_>) -> FlangeForces {
        let (r, core) = (self.radius(at.output.position_rad), 0.5 * self.core_diameter.si());
        let mass = PI * self.density.si() * self.width.si() * (r * r - core * core);
        let mut forces = FlangeForces::default();
        let tilt = at.mounting.axis_tilt.unwrap_or_else(|| Angle::from_si(FRAC_PI_2));
        let weight = mass * gravity_m_s2();
        forces.aligned.radial_n = weight * sine(tilt).abs() + self.tension.si().abs();
        forces.aligned.axial_n = weight * cosine(tilt).abs();
        forces.aligned.moment_nm = forces.aligned.radial_n * metres(at.mounting.overhang);
        forces
    }
}

/// Radius of the full roll on the sheet.
const FULL: f64 = 74.0;

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let middle = [145.0, 96.0];
    let full = figures.length("full_diameter").unwrap_or(2.0 * FULL);
    let stated = |key: &str, neutral: f64, [least, most]: [f64; 2]| {
        (2.0 * FULL * figures.length(key).map_or(neutral, |diameter| diameter / full)).clamp(2.0 * least, 2.0 * most)
    };
    let core = stated("core_diameter", 0.4, [12.0, FULL - 6.0]);
    let first = stated("start_diameter", 0.8, [0.5 * core, FULL]);
    let winding = if figures.of("winding") == Some(-1.0) { Winding::Off } else { Winding::Up };
    let roll = Winder {
        winding,
        core_diameter: Length::from_si(core),
        full_diameter: Length::from_si(2.0 * FULL),
        start_diameter: Length::from_si(first),
        thickness: Length::from_si(figures.length("thickness").map_or(0.5, |thickness| 2.0 * FULL * thickness / full)),
        width: Length::from_si(0.0),
        density: MassDensity::from_si(0.0),
        tension: Force::from_si(0.0),
        inertia: MomentOfInertia::from_si(0.0),
    };
    let start = figures.start_rad();
    let (from, to) = roll.range_rad().unwrap_or((start, start + TAU));
    let angles = (0..=40).map(|step| from + f64::from(step) / 40.0 * (to - from)).collect();
    let way = Way::bounded(angles);
    // The guide roller is higher than the full roll, so that the web always rises towards it.
    let (r, guide) = (roll.radius(start), [300.0, 12.0]);
    let high = |radius: f64| middle[1] - radius - guide[1];
    let turns = roll.sign();
    let arc = if turns > 0.0 { [-1.5, -0.75] } else { [-0.75, -1.5] };
    Drawing::new()
        .line(Look::Axis, [46.0, 96.0], [244.0, 96.0])
        .line(Look::Axis, [145.0, 8.0], [145.0, 184.0])
        .circle(Look::Hidden, middle, FULL)
        .moves(
            &way,
            middle,
            |angle| Placement::stretched([roll.radius(angle) / r; 2]),
            |it| {
                it.circle(Look::Body, middle, r)
                    .calls("start_diameter", "D_0", polar(middle, r, 2.45), [48.0, 28.0])
                    .calls("density", "ρ", polar(middle, 0.5 * (r + 0.5 * core), 0.3), [256.0, 82.0])
            },
        )
        .face(middle, 0.5 * core)
        .turns(start, middle, turns, |it| it.holes(middle, 0.36 * core, 0.06 * core))
        .moves(
            &way,
            guide,
            |angle| Placement::stretched([1.0, high(roll.radius(angle)) / high(r)]),
            |it| it.line(Look::Line, guide, [middle[0], middle[1] - r]),
        )
        .line(Look::Line, guide, [344.0, 12.0])
        .circle(Look::Housing, [300.0, 26.0], 14.0)
        .circle(Look::Hole, [300.0, 26.0], 4.0)
        .arrow([318.0, 12.0], [366.0, 12.0])
        .sweep(Look::Arrow, middle, FULL + 6.0, arc)
        .line(Look::Thin, [145.0 - FULL, 96.0], [145.0 - FULL, 186.0])
        .line(Look::Thin, [145.0 + FULL, 96.0], [145.0 + FULL, 186.0])
        .dimension([145.0 - FULL, 183.0], [145.0 + FULL, 183.0])
        .line(Look::Thin, [145.0 - 0.5 * core, 96.0], [145.0 - 0.5 * core, 162.0])
        .line(Look::Thin, [145.0 + 0.5 * core, 96.0], [145.0 + 0.5 * core, 162.0])
        .dimension([145.0 - 0.5 * core, 158.0], [145.0 + 0.5 * core, 158.0])
        .calls("full_diameter", "D_f", [206.0, 183.0], [246.0, 176.0])
        .calls("core_diameter", "D_k", [136.0, 158.0], [104.0, 172.0])
        .calls("thickness", "s", [324.0, 12.0], [332.0, 46.0])
        .calls("width", "b", [270.0, 16.0], [262.0, 50.0])
        .calls("tension", "F", [350.0, 12.0], [358.0, 34.0])
        .calls("inertia", "J", polar(middle, 0.4 * core, -0.5), [258.0, 112.0])
        .calls("friction_torque", "T_L", polar(middle, 0.4 * core, 2.6), [40.0, 68.0])
}
