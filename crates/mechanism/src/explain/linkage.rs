//! Law of the four-bar linkage in a derivation: closed loop, inertia, weight and the force on the crank pin.

use super::sum::Sum;
use super::{Parts, Steps};
use crate::equations::Reduced;
use crate::{Extra, FourBar, Output};
use derivation::Finding;
use quantities::Measure;
use quantities::unit::{
    KILOGRAM, KILOGRAM_SQUARE_METRE, METRE, METRE_PER_SECOND_SQUARED, NEWTON, NEWTON_METRE, ONE, RADIAN,
    RADIAN_PER_SECOND_SQUARED,
};

/// Component of gravity in the plane of the linkage.
const GRAVITY: &str = "9.80665*sin(beta)";

impl FourBar {
    /// Records the lengths, the angles of coupler and rocker, `phi_2` and `phi_3`, their first derivatives over the angle of the
    /// crank, `u_2` and `u_3`, and their second ones, `v_2` and `v_3`.
    fn explain_loop(&self, position_rad: f64, has_second: bool, steps: &mut Steps<'_>) {
        steps.position();
        for (symbol, value, key) in [
            ("l_g", self.ground, "ground"),
            ("l_1", self.crank, "crank"),
            ("l_2", self.coupler, "coupler"),
            ("l_3", self.rocker, "rocker"),
        ] {
            steps.own(symbol, &METRE, value.si(), key);
        }
        let ([x, y], [coupler, coupler_1, coupler_2], [rocker, rocker_1, rocker_2]) = self.angles(position_rad);
        steps.formula("x_d", &METRE, x, "l_1*cos(q) - l_g");
        steps.formula("y_d", &METRE, y, "l_1*sin(q)");
        steps.formula("l_d", &METRE, (x * x + y * y).sqrt(), "sqrt(x_d^2 + y_d^2)");
        let sign = if self.is_crossed { "+" } else { "-" };
        let text = format!("arctan2(y_d, x_d) {sign} arccos((l_3^2 + l_d^2 - l_2^2)/(2*l_3*l_d))");
        steps.formula("phi_3", &RADIAN, rocker, text);
        let text = "arctan2(l_3*sin(phi_3) - y_d, l_3*cos(phi_3) - x_d)";
        steps.formula("phi_2", &RADIAN, coupler, text);
        steps.formula("u_2", &ONE, coupler_1, "l_1*sin(q - phi_3)/(l_2*sin(phi_3 - phi_2))");
        steps.formula("u_3", &ONE, rocker_1, "l_1*sin(q - phi_2)/(l_3*sin(phi_3 - phi_2))");
        if has_second {
            let text = "(l_1*cos(q - phi_3) + l_2*u_2^2*cos(phi_3 - phi_2) - l_3*u_3^2)/(l_2*sin(phi_3 - phi_2))";
            steps.formula("v_2", &ONE, coupler_2, text);
            let text = "(l_1*cos(q - phi_2) + l_2*u_2^2 - l_3*u_3^2*cos(phi_3 - phi_2))/(l_3*sin(phi_3 - phi_2))";
            steps.formula("v_3", &ONE, rocker_2, text);
        }
    }

    /// Records the mass of the coupler and the distance of its centre, `m_2` and `s_2`.
    fn explain_coupler(&self, steps: &mut Steps<'_>) {
        steps.own("m_2", &KILOGRAM, self.coupler_mass.si(), "coupler_mass");
        steps.own("s_2", &METRE, self.coupler_centre.si(), "coupler_centre");
    }

    /// Records what acts on the rocker, `m_3`, `s_3` and `T_r3`, and the directions of gravity, `gamma` and `beta`.
    fn explain_rocker(&self, steps: &mut Steps<'_>) {
        steps.own("m_3", &KILOGRAM, self.rocker_mass.si(), "rocker_mass");
        steps.own("s_3", &METRE, self.rocker_centre.si(), "rocker_centre");
        steps.own("T_r3", &NEWTON_METRE, self.rocker_torque.si(), "rocker_torque");
        steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
        steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
    }

    /// Records the inertias of coupler and rocker, `J_c2` and `J_c3`.
    fn explain_inertias(&self, steps: &mut Steps<'_>) {
        steps.own("J_c2", &KILOGRAM_SQUARE_METRE, self.coupler_inertia.si(), "coupler_inertia");
        steps.own("J_c3", &KILOGRAM_SQUARE_METRE, self.rocker_inertia.si(), "rocker_inertia");
    }

    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        let slope = steps.needs_slope(reduced);
        self.explain_loop(output.position_rad, slope, steps);
        self.explain_coupler(steps);
        let payload = steps.payload(&Extra { mass: quantities::Mass::from_si(0.0), ..*extra });
        if steps.needs_inertia() {
            self.explain_inertias(steps);
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            let of_coupler = "m_2*(l_1^2 + s_2^2*u_2^2 + 2*l_1*s_2*u_2*cos(q - phi_2))";
            let further = [of_coupler, "J_c2*u_2^2", "J_c3*u_3^2"].map(str::to_owned);
            steps.inertia(reduced, payload, &further);
        }
        if slope {
            let of_coupler = "2*m_2*s_2*(s_2*u_2*v_2 + l_1*(v_2*cos(q - phi_2) - u_2*(1 - u_2)*sin(q - phi_2)))";
            let text = Sum::of(of_coupler).and(true, "2*J_c2*u_2*v_2").and(true, "2*J_c3*u_3*v_3");
            steps.formula("J_q", &KILOGRAM_SQUARE_METRE, reduced.slope, text.text());
        }
        if steps.needs_holding() {
            self.explain_rocker(steps);
            let of_coupler = "m_2*(l_1*cos(q + gamma) + s_2*u_2*cos(phi_2 + gamma))";
            let of_rocker = "m_3*s_3*u_3*cos(phi_3 + gamma)";
            steps.holding(reduced, format!("{GRAVITY}*({of_coupler} + {of_rocker}) + T_r3*u_3"));
        }
        Parts { slope, ..Parts::of(steps, payload) }
    }

    /// Records the force of the crank pin on the coupler at an instant `t`, `F_px` along the fixed link and `F_py` across it.
    pub(crate) fn explain_pin(&self, output: &Output, steps: &mut Steps<'_>) {
        steps.motion(output, true, false);
        steps.place(output.position_rad, Finding::PositionAt);
        self.explain_loop(output.position_rad, true, steps);
        self.explain_coupler(steps);
        self.explain_rocker(steps);
        self.explain_inertias(steps);
        let pin = self.pin(output);
        let [second, third] = pin.accelerations_rad_s2;
        steps.formula("alpha_c2", &RADIAN_PER_SECOND_SQUARED, second, "u_2*alpha + v_2*omega^2");
        steps.formula("alpha_c3", &RADIAN_PER_SECOND_SQUARED, third, "u_3*alpha + v_3*omega^2");
        let [ax, ay] = pin.centre_m_s2;
        let text = "-l_1*(omega^2*cos(q) + alpha*sin(q)) - s_2*((u_2*omega)^2*cos(phi_2) + alpha_c2*sin(phi_2))";
        steps.formula("a_x", &METRE_PER_SECOND_SQUARED, ax, text);
        let text = "l_1*(alpha*cos(q) - omega^2*sin(q)) + s_2*(alpha_c2*cos(phi_2) - (u_2*omega)^2*sin(phi_2))";
        steps.formula("a_y", &METRE_PER_SECOND_SQUARED, ay, text);
        let [x, y] = pin.lacking_n;
        steps.formula("F_2x", &NEWTON, x, format!("m_2*(a_x + {GRAVITY}*sin(gamma))"));
        steps.formula("F_2y", &NEWTON, y, format!("m_2*(a_y + {GRAVITY}*cos(gamma))"));
        let [on_coupler, on_rocker] = pin.moments_nm;
        let text = "-J_c2*alpha_c2 - s_2*(cos(phi_2)*F_2y - sin(phi_2)*F_2x)";
        steps.formula("M_2", &NEWTON_METRE, on_coupler, text);
        let text = format!("J_c3*alpha_c3 + T_r3 + m_3*s_3*{GRAVITY}*cos(phi_3 + gamma)");
        steps.formula("M_3", &NEWTON_METRE, on_rocker, text);
        let [x, y] = pin.force_n;
        for (symbol, value, force, function) in [("F_px", x, "F_2x", "cos"), ("F_py", y, "F_2y", "sin")] {
            let moments = format!("M_3*l_2*{function}(phi_2) - M_2*l_3*{function}(phi_3)");
            let text = format!("{force} + ({moments})/(l_2*l_3*sin(phi_2 - phi_3))");
            steps.formula(symbol, &NEWTON, value, text);
        }
    }
}
