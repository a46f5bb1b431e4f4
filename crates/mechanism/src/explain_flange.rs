//! Derivation of the loads on the flange at one instant.

use crate::explain::{At, Steps};
use crate::flange::{cosine, metres, sine};
use crate::{Aligned, FlangeForces, Mechanism, MechanismKind, Mounting, Rotor, RotorKind};
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM, METRE, NEWTON, NEWTON_METRE, RADIAN, RADIAN_PER_SECOND, RADIAN_PER_SECOND_SQUARED, SECOND,
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
