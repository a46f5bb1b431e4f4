//! Derivation of the loads on the flange at one instant.

use crate::explain::{At, Steps};
use crate::flange::{cosine, metres, sine};
use crate::{
    Aligned, FlangeForces, Mechanism, MechanismId, MechanismKind, Mounting, Rotor, RotorKind, Winder, Winding,
};
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM, KILOGRAM_PER_CUBIC_METRE, METRE, NEWTON, NEWTON_METRE, ONE, RADIAN, RADIAN_PER_SECOND,
    RADIAN_PER_SECOND_SQUARED, SECOND,
};
use quantities::{Length, Measure, Unit};

/// Model of the loads on the flange.
const MODEL: Source = Source::Model { name: "flange-loads" };

/// One of the loads on the flange.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlangeLoadKind {
    /// F_r
    Radial,
    /// F_a
    Axial,
    /// M about a centre behind the flange face.
    Moment,
}

impl Mechanism {
    /// Records the parts of a load on the flange at an instant and returns the formula of their sum, without stated loads. For
    /// the moment `R` is recorded before.
    pub fn explain_flange(
        &self,
        kind: FlangeLoadKind,
        at: &At,
        (mounting, offset): (&Mounting, Length),
        work: &mut Workings,
    ) -> &'static str {
        let forces = self.flange_forces(&at.output, &at.extra, at.recorded_nm, mounting);
        let is_rotor = self.stage.is_none() && mounting.share.is_none() && mounting.wheel_mass.is_none();
        if let (MechanismKind::Rotor(rotor), true) = (&self.kind, is_rotor) {
            return rotor.explain_flange(kind, at, (mounting, offset, &forces), work);
        }
        instant(at, work);
        let is_alone = self.stage.is_none() && mounting.wheel_mass.is_none();
        if kind == FlangeLoadKind::Axial && is_alone {
            let share = mounting.share.unwrap_or(1.0);
            if share != 0.0 && self.explain_thrust(at, forces.axial_n / share, work) {
                work.figure("w_F", &ONE, share, &bearing("bearing.flange_share"), Grade::Printed);
                return "w_F*abs(F_l)";
            }
        }
        if let (MechanismKind::Winder(winder), true, None) = (&self.kind, is_alone, mounting.share)
            && kind != FlangeLoadKind::Axial
        {
            winder.explain_pull(at, forces.aligned.radial_n, work);
            if kind == FlangeLoadKind::Radial {
                return "F_n";
            }
            work.figure("L_0", &METRE, metres(mounting.overhang), &bearing("bearing.overhang"), Grade::Printed);
            return "abs(L_0 + R)*F_n";
        }
        // A part that is zero has no line, unless it is the only one.
        let mut parts = |unit: &'static Unit, [vector, aligned]: [(&'static str, f64); 2]| {
            let is_shown = |(_, si): &(&str, f64)| *si != 0.0;
            for (symbol, si) in [vector, aligned] {
                if si != 0.0 || (symbol == aligned.0 && !is_shown(&vector)) {
                    work.found(symbol, unit, si, Finding::FlangeForcesAt, &MODEL, Grade::Computed);
                }
            }
            [is_shown(&vector), is_shown(&aligned)]
        };
        match kind {
            FlangeLoadKind::Radial => {
                let [x, y] = forces.radial_n;
                match parts(&NEWTON, [("F_v", x.hypot(y)), ("F_n", forces.aligned.radial_n)]) {
                    [true, false] => "F_v",
                    [true, true] => "F_v + F_n",
                    [false, _] => "F_n",
                }
            }
            FlangeLoadKind::Axial => {
                match parts(&NEWTON, [("F_z", forces.axial_n), ("F_zn", forces.aligned.axial_n)]) {
                    [true, false] => "abs(F_z)",
                    [true, true] => "abs(F_z) + F_zn",
                    [false, _] => "F_zn",
                }
            }
            FlangeLoadKind::Moment => {
                let vector = FlangeForces { aligned: Aligned::default(), ..forces }.moment(offset);
                match parts(&NEWTON_METRE, [("M_v", vector), ("M_n", forces.moment(offset) - vector)]) {
                    [true, false] => "M_v",
                    [true, true] => "M_v + M_n",
                    [false, _] => "M_n",
                }
            }
        }
    }
}

/// Records the instant.
fn instant(at: &At, work: &mut Workings) {
    work.figure("t", &SECOND, at.time_s, &MODEL, Grade::Computed);
}

impl Winder {
    /// Records tension and weight of the roll, `F_n`.
    fn explain_pull(&self, at: &At, pull_n: f64, work: &mut Workings) {
        let mut steps = Steps::of(MechanismId::Winder, at.segment, work);
        steps.found("q", &RADIAN, at.output.position_rad, Finding::PositionAt);
        for (symbol, value, key) in [
            ("D_0", self.start_diameter, "start_diameter"),
            ("D_k", self.core_diameter, "core_diameter"),
            ("D_f", self.full_diameter, "full_diameter"),
            ("s_w", self.thickness, "thickness"),
            ("b_w", self.width, "width"),
        ] {
            steps.own(symbol, &METRE, value.si(), key);
        }
        steps.own("rho", &KILOGRAM_PER_CUBIC_METRE, self.density.si(), "density");
        steps.own("F_w", &NEWTON, self.tension.si(), "tension");
        let text = match self.winding {
            Winding::Up => "min(max(D_0/2 + s_w*q/(2*pi), D_k/2), D_f/2)",
            Winding::Off => "min(max(D_0/2 - s_w*q/(2*pi), D_k/2), D_f/2)",
        };
        steps.work.formula("r_w", &METRE, self.radius(at.output.position_rad), text, &MODEL);
        let text = "9.80665*pi*rho*b_w*(r_w^2 - (D_k/2)^2) + abs(F_w)";
        steps.work.formula("F_n", &NEWTON, pull_n, text, &MODEL);
    }
}

impl Rotor {
    /// Records m (g − a) of the rotor and of its payload, and their moments.
    fn explain_flange(
        &self,
        kind: FlangeLoadKind,
        at: &At,
        (mounting, offset, forces): (&Mounting, Length, &FlangeForces),
        work: &mut Workings,
    ) -> &'static str {
        let payload = at.extra.mass.si() != 0.0;
        let (is_level, is_upright) = (cosine(self.tilt) == 0.0, sine(self.tilt) == 0.0);
        let mut steps = Steps::of(crate::equations::Equations::id(self), at.segment, work);
        if self.kind == RotorKind::Turntable {
            steps.found("m", &KILOGRAM, self.mass.si(), Finding::SumOfBodies);
        } else {
            steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        }
        if payload {
            steps.of_segment("m_p", &KILOGRAM, at.extra.mass.si(), "payload");
        }
        let (weight, [fx, fy], r) = (forces.axial_n, forces.radial_n, offset.si());
        let along = match (is_level, payload) {
            (true, _) => None,
            (false, false) => Some("-9.80665*m*cos(beta)"),
            (false, true) => Some("-9.80665*(m + m_p)*cos(beta)"),
        };
        if kind == FlangeLoadKind::Axial {
            let Some(text) = along else { return steps.nothing(payload) };
            steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
            steps.work.formula("F_z", &NEWTON, weight, text, &MODEL);
            return "abs(F_z)";
        }
        if self.kind == RotorKind::Turntable {
            steps.found("r_0", &METRE, self.radius.si(), Finding::SumOfBodies);
        } else {
            steps.own("r_0", &METRE, self.radius.si(), "centre_distance");
        }
        if payload {
            steps.own("r_p", &METRE, self.payload_radius.si(), "payload_distance");
        }
        let angle = at.output.position_rad + self.angle.si();
        instant(at, steps.work);
        steps.found("q_m", &RADIAN, angle, Finding::AngleOfMassAt);
        steps.found("omega", &RADIAN_PER_SECOND, at.output.speed_rad_s, Finding::SpeedAt);
        steps.found("alpha", &RADIAN_PER_SECOND_SQUARED, at.output.acceleration_rad_s2, Finding::AccelerationAt);
        if !is_upright || (kind == FlangeLoadKind::Moment && !is_level) {
            steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
        }
        let of = |mass: f64, radius: f64| {
            let (sin, cos) = angle.sin_cos();
            let (omega, alpha) = (at.output.speed_rad_s, at.output.acceleration_rad_s2);
            let (centrifugal, tangential) = (omega * omega * radius, alpha * radius);
            let across = crate::gravity_m_s2() * sine(self.tilt);
            [mass * (centrifugal * cos + tangential * sin), mass * (centrifugal * sin - tangential * cos - across)]
        };
        if !payload {
            steps.work.formula("F_x", &NEWTON, fx, "m*r_0*(omega^2*cos(q_m) + alpha*sin(q_m))", &MODEL);
            let text = if is_upright {
                "m*r_0*(omega^2*sin(q_m) - alpha*cos(q_m))"
            } else {
                "m*(r_0*(omega^2*sin(q_m) - alpha*cos(q_m)) - 9.80665*sin(beta))"
            };
            steps.work.formula("F_y", &NEWTON, fy, text, &MODEL);
        } else {
            let [own, carried] =
                [of(self.mass.si(), self.radius.si()), of(at.extra.mass.si(), self.payload_radius.si())];
            let texts = if is_upright {
                ["m*r_0*(omega^2*sin(q_m) - alpha*cos(q_m))", "m_p*r_p*(omega^2*sin(q_m) - alpha*cos(q_m))"]
            } else {
                [
                    "m*(r_0*(omega^2*sin(q_m) - alpha*cos(q_m)) - 9.80665*sin(beta))",
                    "m_p*(r_p*(omega^2*sin(q_m) - alpha*cos(q_m)) - 9.80665*sin(beta))",
                ]
            };
            let [own_y, carried_y] = texts;
            steps.work.formula("F_x1", &NEWTON, own[0], "m*r_0*(omega^2*cos(q_m) + alpha*sin(q_m))", &MODEL);
            steps.work.formula("F_y1", &NEWTON, own[1], own_y, &MODEL);
            steps.work.formula("F_x2", &NEWTON, carried[0], "m_p*r_p*(omega^2*cos(q_m) + alpha*sin(q_m))", &MODEL);
            steps.work.formula("F_y2", &NEWTON, carried[1], carried_y, &MODEL);
        }
        if kind == FlangeLoadKind::Radial {
            return if payload { "sqrt((F_x1 + F_x2)^2 + (F_y1 + F_y2)^2)" } else { "sqrt(F_x^2 + F_y^2)" };
        }
        let [mx, my] = [forces.moment_nm[0] - r * fy, forces.moment_nm[1] + r * fx];
        steps.work.figure("L_0", &METRE, metres(mounting.overhang), &bearing("bearing.overhang"), Grade::Printed);
        if payload {
            let key = "bearing.payload_overhang";
            steps.work.figure("L_p", &METRE, metres(mounting.payload_overhang), &bearing(key), Grade::Printed);
        }
        if let Some(text) = along {
            steps.work.formula("F_z", &NEWTON, weight, text, &MODEL);
        }
        let [of_x, of_y] = match (is_level, payload) {
            (true, false) => ["-(L_0 + R)*F_y", "(L_0 + R)*F_x"],
            (true, true) => ["-(L_0 + R)*F_y1 - (L_p + R)*F_y2", "(L_0 + R)*F_x1 + (L_p + R)*F_x2"],
            (false, false) => ["r_0*sin(q_m)*F_z - (L_0 + R)*F_y", "(L_0 + R)*F_x - r_0*cos(q_m)*F_z"],
            (false, true) => [
                "(m*r_0 + m_p*r_p)/(m + m_p)*sin(q_m)*F_z - (L_0 + R)*F_y1 - (L_p + R)*F_y2",
                "(L_0 + R)*F_x1 + (L_p + R)*F_x2 - (m*r_0 + m_p*r_p)/(m + m_p)*cos(q_m)*F_z",
            ],
        };
        steps.work.formula("M_x", &NEWTON_METRE, mx, of_x, &MODEL);
        steps.work.formula("M_y", &NEWTON_METRE, my, of_y, &MODEL);
        "sqrt(M_x^2 + M_y^2)"
    }
}

fn bearing(key: &'static str) -> Source {
    Source::Project { key: key.into() }
}

impl Steps<'_> {
    /// Returns the formula of a force that vanishes by its direction, with the masses that have none.
    const fn nothing(&self, payload: bool) -> &'static str {
        if payload { "0*(m + m_p)" } else { "0*m" }
    }
}
