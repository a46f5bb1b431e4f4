//! Laws of the mechanisms in a derivation: inertia, weight and forces with their values.

use super::{Parts, Steps};
use crate::equations::Reduced;
use crate::{
    Extra, FourBar, Hoist, Joint, Linear, LinearKind, Output, Rotor, RotorKind, ScissorLift, SliderCrank, Table,
    Winder, Winding,
};
use derivation::Finding;
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM, KILOGRAM_PER_CUBIC_METRE, KILOGRAM_SQUARE_METRE, METRE, NEWTON, NEWTON_METRE, ONE, RADIAN,
};
use quantities::{Mass, Measure, Unit};

/// Records the additions of a segment to the inertia, and returns which there are: payload and payload inertia.
fn payload(extra: &Extra, steps: &mut Steps<'_>) -> (bool, bool) {
    (
        steps.of_segment("m_p", &KILOGRAM, extra.mass.si(), "payload"),
        steps.of_segment("J_p", &KILOGRAM_SQUARE_METRE, extra.inertia.si(), "payload_inertia"),
    )
}

const INERTIA: (&str, &Unit) = ("J_M", &KILOGRAM_SQUARE_METRE);

impl Rotor {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let is_turntable = self.kind == RotorKind::Turntable;
        if is_turntable {
            steps.found("J_0", INERTIA.1, self.inertia.si(), Finding::SumOfBodies);
        } else {
            steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        }
        let of_lever =
            if self.payload_radius.si() == 0.0 { Extra { mass: Mass::from_si(0.0), ..*extra } } else { *extra };
        let (mass, inertia) = payload(&of_lever, steps);
        if mass {
            steps.own("r_p", &METRE, self.payload_radius.si(), "payload_distance");
        }
        let text = match (mass, inertia) {
            (false, false) => "J_0",
            (true, false) => "J_0 + m_p*r_p^2",
            (false, true) => "J_0 + J_p",
            (true, true) => "J_0 + J_p + m_p*r_p^2",
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        let has_weight = self.is_unbalanced();
        if has_weight {
            let turned = self.angle.si() != 0.0;
            if is_turntable {
                steps.found("m", &KILOGRAM, self.mass.si(), Finding::SumOfBodies);
                steps.found("r_0", &METRE, self.radius.si(), Finding::SumOfBodies);
            } else {
                steps.own("m", &KILOGRAM, self.mass.si(), "mass");
                steps.own("r_0", &METRE, self.radius.si(), "centre_distance");
            }
            if turned {
                steps.found("phi_0", &RADIAN, self.angle.si(), Finding::SumOfBodies);
            }
            steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
            let text = match (mass, turned) {
                (false, false) => "9.80665*m*r_0*cos(q)*sin(beta)",
                (true, false) => "9.80665*(m*r_0 + m_p*r_p)*cos(q)*sin(beta)",
                (false, true) => "9.80665*m*r_0*cos(q + phi_0)*sin(beta)",
                (true, true) => "9.80665*(m*r_0 + m_p*r_p)*cos(q + phi_0)*sin(beta)",
            };
            steps.formula("T_h", &NEWTON_METRE, reduced.holding, text);
        }
        Parts { inertia: true, holding: has_weight, ..Parts::default() }
    }
}

impl Linear {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let travel = self.travel_m_per_rad;
        match self.kind {
            LinearKind::Screw => {
                steps.own("P_h", &METRE, travel * std::f64::consts::TAU, "lead");
                steps.formula("k", &METRE, travel, "P_h/(2*pi)");
            }
            LinearKind::Belt => {
                steps.own("D", &METRE, travel * 2.0, "pulley_diameter");
                steps.formula("k", &METRE, travel, "D/2");
            }
            LinearKind::Conveyor => {
                steps.own("D", &METRE, travel * 2.0, "roller_diameter");
                steps.formula("k", &METRE, travel, "D/2");
            }
        }
        steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        let (mass, inertia) = payload(extra, steps);
        let counterweight = self.counterweight.si() != 0.0;
        if counterweight {
            steps.own("m_c", &KILOGRAM, self.counterweight.si(), "counterweight");
        }
        let text = match (mass, inertia, counterweight) {
            (false, false, false) => "J_0 + m*k^2",
            (true, false, false) => "J_0 + (m + m_p)*k^2",
            (false, true, false) => "J_0 + J_p + m*k^2",
            (true, true, false) => "J_0 + J_p + (m + m_p)*k^2",
            (false, false, true) => "J_0 + (m + m_c)*k^2",
            (true, false, true) => "J_0 + (m + m_p + m_c)*k^2",
            (false, true, true) => "J_0 + J_p + (m + m_c)*k^2",
            (true, true, true) => "J_0 + J_p + (m + m_p + m_c)*k^2",
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
        steps.process_force(extra.force.si());
        let text = match (mass, counterweight) {
            (false, false) => "k*(9.80665*m*sin(gamma) + F_p)",
            (true, false) => "k*(9.80665*(m + m_p)*sin(gamma) + F_p)",
            (false, true) => "k*(9.80665*(m - m_c)*sin(gamma) + F_p)",
            (true, true) => "k*(9.80665*(m + m_p - m_c)*sin(gamma) + F_p)",
        };
        steps.formula("T_h", &NEWTON_METRE, reduced.holding, text);
        let guide = reduced.coulomb != 0.0;
        if guide {
            steps.own("F_f", &NEWTON, self.friction_force.si(), "friction_force");
            steps.own("mu", &ONE, self.friction_coefficient, "friction_coefficient");
            let text = if mass {
                "k*(F_f + 9.80665*mu*(m + m_p)*abs(cos(gamma)))"
            } else {
                "k*(F_f + 9.80665*mu*m*abs(cos(gamma)))"
            };
            steps.formula("T_g", &NEWTON_METRE, reduced.coulomb, text);
        }
        Parts { inertia: true, holding: true, guide, ..Parts::default() }
    }
}

impl SliderCrank {
    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        steps.own("r_c", &METRE, self.crank.si(), "crank");
        steps.own("l", &METRE, self.rod.si(), "rod");
        let [first, second] = self.rates(output.position_rad);
        let root = "-r_c*sin(q) - r_c^2*sin(q)*cos(q)/sqrt(l^2 - r_c^2*sin(q)^2)";
        steps.formula("x_1", &METRE, first, root);
        let text = "-r_c*cos(q) - (r_c^2*(cos(q)^2 - sin(q)^2) + (x_1 + r_c*sin(q))^2)/sqrt(l^2 - r_c^2*sin(q)^2)";
        steps.formula("x_2", &METRE, second, text);
        steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        let (mass, inertia) = payload(extra, steps);
        let text = match (mass, inertia) {
            (false, false) => "J_0 + m*x_1^2",
            (true, false) => "J_0 + (m + m_p)*x_1^2",
            (false, true) => "J_0 + J_p + m*x_1^2",
            (true, true) => "J_0 + J_p + (m + m_p)*x_1^2",
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        let slope = reduced.slope != 0.0;
        if slope {
            let text = if mass { "2*(m + m_p)*x_1*x_2" } else { "2*m*x_1*x_2" };
            steps.formula("J_q", INERTIA.1, reduced.slope, text);
        }
        steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
        steps.process_force(extra.force.si());
        let text = if mass { "x_1*(9.80665*(m + m_p)*sin(gamma) + F_p)" } else { "x_1*(9.80665*m*sin(gamma) + F_p)" };
        steps.formula("T_h", &NEWTON_METRE, reduced.holding, text);
        Parts { inertia: true, holding: true, slope, ..Parts::default() }
    }
}

impl Table {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let inertia = steps.of_segment("J_p", INERTIA.1, extra.inertia.si(), "payload_inertia");
        steps.found("J_0", INERTIA.1, reduced.inertia - extra.inertia.si(), Finding::TableAt);
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, if inertia { "J_0 + J_p" } else { "J_0" });
        let slope = reduced.slope != 0.0;
        if slope {
            steps.found("J_q", INERTIA.1, reduced.slope, Finding::TableAt);
        }
        steps.found("T_h", &NEWTON_METRE, reduced.holding, Finding::TableAt);
        Parts { inertia: true, holding: true, slope, ..Parts::default() }
    }
}

impl Joint {
    /// The recorded torque contains all others.
    pub(super) fn explain(&self, _steps: &mut Steps<'_>) -> Parts {
        Parts::default()
    }
}

impl Hoist {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        steps.own("D", &METRE, self.drum_diameter.si(), "drum_diameter");
        steps.own("z_f", &ONE, f64::from(self.falls), "falls");
        steps.formula("k", &METRE, self.drum_diameter.si() / (2.0 * f64::from(self.falls)), "D/(2*z_f)");
        steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        steps.own("m_c", &KILOGRAM, self.counterweight.si(), "counterweight");
        let (mass, inertia) = payload(extra, steps);
        let rope = self.has_rope();
        if rope {
            steps.own("m_r", &KILOGRAM, self.rope_mass.si(), "rope_mass");
            steps.own("L_f", &METRE, self.hanging.si(), "hanging");
            steps.found("S_u", &ONE, self.speeds(), Finding::SpeedsOfFalls);
        }
        let text = match (mass, inertia, rope) {
            (false, false, false) => "J_0 + (m + m_c)*k^2",
            (true, false, false) => "J_0 + (m + m_p + m_c)*k^2",
            (false, true, false) => "J_0 + J_p + (m + m_c)*k^2",
            (true, true, false) => "J_0 + J_p + (m + m_p + m_c)*k^2",
            (false, false, true) => "J_0 + (m + m_c + m_r/(z_f*L_f)*((L_f - k*q)*S_u + z_f^3*k*q))*k^2",
            (true, false, true) => "J_0 + (m + m_p + m_c + m_r/(z_f*L_f)*((L_f - k*q)*S_u + z_f^3*k*q))*k^2",
            (false, true, true) => "J_0 + J_p + (m + m_c + m_r/(z_f*L_f)*((L_f - k*q)*S_u + z_f^3*k*q))*k^2",
            (true, true, true) => "J_0 + J_p + (m + m_p + m_c + m_r/(z_f*L_f)*((L_f - k*q)*S_u + z_f^3*k*q))*k^2",
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        let slope = reduced.slope != 0.0;
        if slope {
            steps.formula("J_q", INERTIA.1, reduced.slope, "m_r/(z_f*L_f)*(z_f^3 - S_u)*k^3");
        }
        steps.process_force(extra.force.si());
        let text = match (mass, rope) {
            (false, false) => "k*(9.80665*(m - m_c) + F_p)",
            (true, false) => "k*(9.80665*(m + m_p - m_c) + F_p)",
            (false, true) => "k*(9.80665*(m - m_c + m_r*(1 - k*q/L_f)) + F_p)",
            (true, true) => "k*(9.80665*(m + m_p - m_c + m_r*(1 - k*q/L_f)) + F_p)",
        };
        steps.formula("T_h", &NEWTON_METRE, reduced.holding, text);
        if self.reeving != 1.0 {
            let key = format!("{}.sheave_efficiency, {}.falls", steps.table, steps.table);
            steps.work.figure("eta_F", &ONE, self.reeving, &Source::Project { key: key.into() }, Grade::Printed);
        }
        Parts { inertia: true, holding: true, slope, ..Parts::default() }
    }
}

impl Winder {
    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
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
        let (radius, holding) = match self.winding {
            Winding::Up => ("min(max(D_0/2 + s_w*q/(2*pi), D_k/2), D_f/2)", "F_w*r_w"),
            Winding::Off => ("min(max(D_0/2 - s_w*q/(2*pi), D_k/2), D_f/2)", "-F_w*r_w"),
        };
        steps.formula("r_w", &METRE, self.radius(output.position_rad), radius);
        steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        let inertia = steps.of_segment("J_p", INERTIA.1, extra.inertia.si(), "payload_inertia");
        let text = if inertia {
            "J_0 + J_p + pi/2*rho*b_w*(r_w^4 - (D_k/2)^4)"
        } else {
            "J_0 + pi/2*rho*b_w*(r_w^4 - (D_k/2)^4)"
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        steps.own("F_w", &NEWTON, self.tension.si(), "tension");
        steps.formula("T_h", &NEWTON_METRE, reduced.holding, holding);
        Parts { inertia: true, holding: true, ..Parts::default() }
    }
}

impl ScissorLift {
    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        let (lead, stages) = (self.lead.si(), f64::from(self.stages));
        steps.own("P_h", &METRE, lead, "lead");
        steps.formula("k", &METRE, lead / std::f64::consts::TAU, "P_h/(2*pi)");
        steps.own("L_s", &METRE, self.arm_length.si(), "arm_length");
        steps.own("theta_0", &RADIAN, self.angle.si(), "arm_angle");
        steps.own("z_s", &ONE, stages, "stages");
        let (base, height, rise) = self.linkage(output.position_rad);
        steps.formula("b_s", &METRE, base, "min(max(L_s*cos(theta_0) - k*q, 0), L_s*cos(pi/180))");
        steps.formula("w_s", &METRE, height, "sqrt(L_s^2 - b_s^2)");
        steps.formula("h_1", &METRE, stages * rise, "z_s*k*b_s/w_s");
        steps.own("J_0", INERTIA.1, self.inertia.si(), "inertia");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        steps.own("m_a", &KILOGRAM, self.arm_mass.si(), "arm_mass");
        let (mass, inertia) = payload(extra, steps);
        let text = match (mass, inertia) {
            (false, false) => "J_0 + m*h_1^2 + m_a*(k^2/4 + (z_s^2/3 - 1/12)*(h_1/z_s)^2 + L_s^2/12*(k/w_s)^2)",
            (true, false) => "J_0 + (m + m_p)*h_1^2 + m_a*(k^2/4 + (z_s^2/3 - 1/12)*(h_1/z_s)^2 + L_s^2/12*(k/w_s)^2)",
            (false, true) => "J_0 + J_p + m*h_1^2 + m_a*(k^2/4 + (z_s^2/3 - 1/12)*(h_1/z_s)^2 + L_s^2/12*(k/w_s)^2)",
            (true, true) => {
                "J_0 + J_p + (m + m_p)*h_1^2 + m_a*(k^2/4 + (z_s^2/3 - 1/12)*(h_1/z_s)^2 + L_s^2/12*(k/w_s)^2)"
            }
        };
        steps.formula(INERTIA.0, INERTIA.1, reduced.inertia, text);
        let slope = reduced.slope != 0.0;
        if slope {
            let bend = -stages * lead * lead * self.arm_length.si() * self.arm_length.si()
                / (std::f64::consts::TAU * std::f64::consts::TAU * height * height * height);
            steps.formula("h_2", &METRE, bend, "-z_s*k^2*L_s^2/w_s^3");
            let text = if mass {
                "2*(m + m_p)*h_1*h_2 + 2*m_a*((z_s^2/3 - 1/12)*h_1*h_2/z_s^2 - L_s^2/12*k^3*b_s/w_s^4)"
            } else {
                "2*m*h_1*h_2 + 2*m_a*((z_s^2/3 - 1/12)*h_1*h_2/z_s^2 - L_s^2/12*k^3*b_s/w_s^4)"
            };
            steps.formula("J_q", INERTIA.1, reduced.slope, text);
        }
        steps.process_force(extra.force.si());
        let text = if mass { "h_1*(9.80665*(m + m_p + m_a/2) + F_p)" } else { "h_1*(9.80665*(m + m_a/2) + F_p)" };
        steps.formula("T_h", &NEWTON_METRE, reduced.holding, text);
        Parts { inertia: true, holding: true, slope, ..Parts::default() }
    }
}

impl FourBar {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let lengths = [
            ("l_g", self.ground, "ground"),
            ("l_1", self.crank, "crank"),
            ("l_2", self.coupler, "coupler"),
            ("l_3", self.rocker, "rocker"),
            ("s_2", self.coupler_centre, "coupler_centre"),
            ("s_3", self.rocker_centre, "rocker_centre"),
        ];
        lengths.into_iter().for_each(|(symbol, value, key)| steps.own(symbol, &METRE, value.si(), key));
        let inertias = [
            ("J_0", self.inertia, "inertia"),
            ("J_c2", self.coupler_inertia, "coupler_inertia"),
            ("J_c3", self.rocker_inertia, "rocker_inertia"),
        ];
        inertias.into_iter().for_each(|(symbol, value, key)| steps.own(symbol, INERTIA.1, value.si(), key));
        steps.own("m_2", &KILOGRAM, self.coupler_mass.si(), "coupler_mass");
        steps.own("m_3", &KILOGRAM, self.rocker_mass.si(), "rocker_mass");
        steps.own("T_r3", &NEWTON_METRE, self.rocker_torque.si(), "rocker_torque");
        steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
        steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
        steps.of_segment("J_p", INERTIA.1, extra.inertia.si(), "payload_inertia");
        steps.found(INERTIA.0, INERTIA.1, reduced.inertia, Finding::LinkageInertia);
        let slope = reduced.slope != 0.0;
        if slope {
            steps.found("J_q", INERTIA.1, reduced.slope, Finding::LinkageInertia);
        }
        steps.found("T_h", &NEWTON_METRE, reduced.holding, Finding::LinkageTorque);
        Parts { inertia: true, holding: true, slope, ..Parts::default() }
    }
}
