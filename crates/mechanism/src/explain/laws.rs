//! Laws of the mechanisms in a derivation: inertia, weight and forces with their values.

use super::sum::Sum;
use super::{LawScope, Parts, Steps};
use crate::equations::Reduced;
use crate::{
    ArmBody, ArmShape, Extra, Hoist, Linear, LinearKind, Output, Rotor, RotorKind, ScissorLift, SliderCrank, Table,
    Winder, Winding,
};
use derivation::Finding;
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM, KILOGRAM_PER_CUBIC_METRE, KILOGRAM_SQUARE_METRE, METRE, NEWTON, NEWTON_METRE, ONE, RADIAN,
};
use quantities::{Mass, Measure};

/// Additions of a segment that are recorded.
#[derive(Clone, Copy, Default)]
pub(super) struct Payload {
    /// m_p is recorded.
    mass: bool,
    /// J_p is recorded.
    pub(super) inertia: bool,
}

impl Steps<'_> {
    /// Returns `true` if the derivation needs the inertia.
    pub(super) fn needs_inertia(&self) -> bool {
        self.scope != LawScope::Holding
    }

    /// Returns `true` if the derivation needs the slope of the inertia, and there is one.
    pub(super) fn needs_slope(&self, reduced: &Reduced) -> bool {
        self.scope == LawScope::Torque && reduced.slope != 0.0
    }

    /// Returns `true` if the derivation needs the torque that holds the load.
    pub(super) fn needs_holding(&self) -> bool {
        self.scope != LawScope::Inertia
    }

    /// Records the additions of a segment.
    pub(super) fn payload(&mut self, extra: &Extra) -> Payload {
        Payload {
            mass: self.of_segment("m_p", &KILOGRAM, extra.mass.si(), "payload"),
            inertia: self.needs_inertia()
                && self.of_segment("J_p", &KILOGRAM_SQUARE_METRE, extra.inertia.si(), "payload_inertia"),
        }
    }

    /// Records the inertia of the load: that of the rotating parts, of the payload, and further terms.
    pub(super) fn inertia(&mut self, reduced: &Reduced, payload: Payload, further: &[String]) {
        let sum = Sum::of("J_0").and(payload.inertia, "J_p");
        let sum = further.iter().fold(sum, |sum, term| sum.and(true, term));
        self.formula(self.inertia, &KILOGRAM_SQUARE_METRE, reduced.inertia, sum.text());
    }

    pub(super) fn holding(&mut self, reduced: &Reduced, text: String) {
        self.formula("T_h", &NEWTON_METRE, reduced.holding, text);
    }
}

impl Parts {
    pub(super) fn of(steps: &Steps<'_>, payload: Payload) -> Self {
        Self {
            inertia: steps.needs_inertia(),
            holding: steps.needs_holding(),
            payload_inertia: payload.inertia,
            ..Self::default()
        }
    }
}

/// Returns the mass that moves with the load: its own, and that of the payload.
fn carried(payload: Payload) -> Sum {
    Sum::of("m").and(payload.mass, "m_p")
}

impl Rotor {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let is_turntable = self.kind == RotorKind::Turntable;
        let of_lever =
            if self.payload_radius.si() == 0.0 { Extra { mass: Mass::from_si(0.0), ..*extra } } else { *extra };
        let has_weight = self.is_unbalanced() && steps.needs_holding();
        let payload = if steps.needs_inertia() || has_weight { steps.payload(&of_lever) } else { Payload::default() };
        if payload.mass {
            steps.own("r_p", &METRE, self.payload_radius.si(), "payload_distance");
        }
        if let RotorKind::Shaped(body) = self.kind
            && steps.needs_inertia()
        {
            let [law, _] = self.explain_shape(body, body.shape == ArmShape::Bar, steps);
            if steps.scope == LawScope::Inertia && !payload.mass && !payload.inertia {
                steps.formula(steps.inertia, &KILOGRAM_SQUARE_METRE, self.inertia.si(), law);
            } else {
                steps.formula("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), law);
                let further = payload.mass.then(|| "m_p*r_p^2".to_owned());
                steps.inertia(reduced, payload, further.as_slice());
            }
        } else if steps.scope == LawScope::Inertia && !is_turntable && !payload.mass && !payload.inertia {
            steps.own(steps.inertia, &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
        } else if steps.needs_inertia() {
            if is_turntable {
                steps.found("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), Finding::InertiaOfBodies);
            } else {
                steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            }
            let further = payload.mass.then(|| "m_p*r_p^2".to_owned());
            steps.inertia(reduced, payload, further.as_slice());
        }
        if has_weight {
            steps.position();
            let turned = self.angle.si() != 0.0;
            self.explain_mass(true, steps);
            if turned {
                steps.found("phi_0", &RADIAN, self.angle.si(), Finding::AngleOfBodies);
            }
            steps.own("beta", &RADIAN, self.tilt.si(), "axis_tilt");
            let lever = Sum::of("m*r_0").and(payload.mass, "m_p*r_p").factor();
            let angle = Sum::of("q").and(turned, "phi_0").text();
            steps.holding(reduced, format!("9.80665*{lever}*cos({angle})*sin(beta)"));
        }
        Parts { holding: has_weight, ..Parts::of(steps, payload) }
    }

    /// Records mass and length of an arm, `m` and `l_a`, and its width, `b_a`; returns the laws of J and s.
    fn explain_shape(&self, body: ArmBody, has_width: bool, steps: &mut Steps<'_>) -> [&'static str; 2] {
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        steps.own("l_a", &METRE, body.length.si(), "length");
        if has_width {
            steps.own("b_a", &METRE, body.width.si(), "width");
        }
        body.shape.laws()
    }

    /// Records the mass, `m`, and the distance of its centre, `r_0`.
    pub(crate) fn explain_mass(&self, has_distance: bool, steps: &mut Steps<'_>) {
        let is_turntable = self.kind == RotorKind::Turntable;
        if is_turntable {
            steps.found("m", &KILOGRAM, self.mass.si(), Finding::MassOfBodies);
        } else {
            steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        }
        if let (true, RotorKind::Shaped(body)) = (has_distance, self.kind) {
            let [_, law] = self.explain_shape(body, false, steps);
            steps.formula("r_0", &METRE, self.radius.si(), law);
            return;
        }
        match (has_distance, is_turntable) {
            (false, _) => {}
            (true, true) => steps.found("r_0", &METRE, self.radius.si(), Finding::CentreOfBodies),
            (true, false) => steps.own("r_0", &METRE, self.radius.si(), "centre_distance"),
        }
    }
}

impl Linear {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let travel = self.travel_m_per_rad;
        let (symbol, value, key, text) = match self.kind {
            LinearKind::Screw => ("P_h", travel * std::f64::consts::TAU, "lead", "P_h/(2*pi)"),
            LinearKind::Belt => ("D", travel * 2.0, "pulley_diameter", "D/2"),
            LinearKind::Conveyor => ("D", travel * 2.0, "roller_diameter", "D/2"),
        };
        steps.own(symbol, &METRE, value, key);
        steps.formula("k", &METRE, travel, text);
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        let payload = steps.payload(extra);
        let counterweight = self.counterweight.si() != 0.0;
        if counterweight {
            steps.own("m_c", &KILOGRAM, self.counterweight.si(), "counterweight");
        }
        if steps.needs_inertia() {
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            let moved = carried(payload).and(counterweight, "m_c").factor();
            steps.inertia(reduced, payload, &[format!("{moved}*k^2")]);
        }
        if steps.needs_holding() {
            steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
            steps.process_force(extra.force.si());
            let weight = carried(payload).less(counterweight, "m_c").factor();
            steps.holding(reduced, format!("k*(9.80665*{weight}*sin(gamma) + F_p)"));
        }
        let guide = reduced.coulomb != 0.0 && steps.scope == LawScope::Torque;
        if guide {
            steps.own("F_f", &NEWTON, self.friction_force.si(), "friction_force");
            steps.own("mu", &ONE, self.friction_coefficient, "friction_coefficient");
            let text = format!("k*(F_f + 9.80665*mu*{}*abs(cos(gamma)))", carried(payload).factor());
            steps.formula("T_g", &NEWTON_METRE, reduced.coulomb, text);
        }
        Parts { guide, ..Parts::of(steps, payload) }
    }
}

impl SliderCrank {
    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        let slope = steps.needs_slope(reduced);
        self.explain_rates(output, slope, steps);
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        let payload = steps.payload(extra);
        let moved = carried(payload).factor();
        if steps.needs_inertia() {
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            steps.inertia(reduced, payload, &[format!("{moved}*x_1^2")]);
        }
        if slope {
            steps.formula("J_q", &KILOGRAM_SQUARE_METRE, reduced.slope, format!("2*{moved}*x_1*x_2"));
        }
        if steps.needs_holding() {
            steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
            steps.process_force(extra.force.si());
            steps.holding(reduced, format!("x_1*(9.80665*{moved}*sin(gamma) + F_p)"));
        }
        Parts { slope, ..Parts::of(steps, payload) }
    }

    /// Records the position and the travel of the slider per angle, `x_1`, with its change, `x_2`.
    fn explain_rates(&self, output: &Output, has_change: bool, steps: &mut Steps<'_>) {
        steps.position();
        steps.own("r_c", &METRE, self.crank.si(), "crank");
        steps.own("l", &METRE, self.rod.si(), "rod");
        let [first, second] = self.rates(output.position_rad);
        let root = "-r_c*sin(q) - r_c^2*sin(q)*cos(q)/sqrt(l^2 - r_c^2*sin(q)^2)";
        steps.formula("x_1", &METRE, first, root);
        if has_change {
            let text = "-r_c*cos(q) - (r_c^2*(cos(q)^2 - sin(q)^2) + (x_1 + r_c*sin(q))^2)/sqrt(l^2 - r_c^2*sin(q)^2)";
            steps.formula("x_2", &METRE, second, text);
        }
    }

    /// Records the force of the rod along the line of the slider, `F_l`, at an instant `t`.
    pub(crate) fn explain_rod(&self, (output, extra): (&Output, &Extra), force_n: f64, steps: &mut Steps<'_>) {
        steps.motion(output, true, false);
        steps.place(output.position_rad + self.angle.si(), Finding::PositionAt);
        self.explain_rates(output, true, steps);
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        let mass = steps.of_segment("m_p", &KILOGRAM, extra.mass.si(), "payload");
        steps.own("gamma", &RADIAN, self.inclination.si(), "inclination");
        steps.process_force(extra.force.si());
        let moved = Sum::of("m").and(mass, "m_p").factor();
        let text = format!("{moved}*(x_1*alpha + x_2*omega^2 + 9.80665*sin(gamma)) + F_p");
        steps.formula("F_l", &NEWTON, force_n, text);
    }
}

impl Table {
    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        let (at, [low, high]) = self.between(output.position_rad);
        let payload = steps.payload(&Extra { mass: Mass::from_si(0.0), ..*extra });
        let slope = steps.needs_slope(reduced);
        let record = |steps: &mut Steps<'_>, index: usize, [position, inertia, torque]: [&'static str; 3]| {
            let Some(point) = self.points().get(index) else { return };
            let key = format!("points[{}]", index + 1);
            if low != high {
                steps.own(position, &RADIAN, point.position.si(), &key);
            }
            if steps.needs_inertia() {
                steps.own(inertia, &KILOGRAM_SQUARE_METRE, point.inertia.si(), &key);
            }
            if steps.needs_holding() {
                steps.own(torque, &NEWTON_METRE, point.torque.si(), &key);
            }
        };
        record(steps, low, ["q_a", "J_a", "T_a"]);
        let mut position = "q";
        if low != high {
            record(steps, high, ["q_b", "J_b", "T_b"]);
            steps.position();
            let turns = ((output.position_rad - at) / std::f64::consts::TAU).round();
            if turns != 0.0 {
                steps.work.figure("z_q", &ONE, turns, &super::MODEL, Grade::Computed);
                position = "q_t";
                steps.formula(position, &RADIAN, at, "q - 2*pi*z_q");
            }
        }
        let line = |a: &str, b: &str| {
            if low == high { a.to_owned() } else { format!("{a} + ({b} - {a})*({position} - q_a)/(q_b - q_a)") }
        };
        if steps.needs_inertia() {
            let text = line("J_a", "J_b");
            steps.formula("J_0", &KILOGRAM_SQUARE_METRE, reduced.inertia - extra.inertia.si(), text);
            steps.inertia(reduced, payload, &[]);
        }
        if slope {
            steps.formula("J_q", &KILOGRAM_SQUARE_METRE, reduced.slope, "(J_b - J_a)/(q_b - q_a)");
        }
        if steps.needs_holding() {
            steps.holding(reduced, line("T_a", "T_b"));
        }
        Parts { slope, ..Parts::of(steps, payload) }
    }
}

impl Hoist {
    pub(super) fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
        let falls = f64::from(self.falls);
        steps.own("D", &METRE, self.drum_diameter.si(), "drum_diameter");
        steps.own("z_f", &ONE, falls, "falls");
        steps.formula("k", &METRE, self.drum_diameter.si() / (2.0 * falls), "D/(2*z_f)");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        steps.own("m_c", &KILOGRAM, self.counterweight.si(), "counterweight");
        let payload = steps.payload(extra);
        let rope = self.has_rope();
        let slope = steps.needs_slope(reduced);
        if rope {
            steps.position();
            steps.own("m_r", &KILOGRAM, self.rope_mass.si(), "rope_mass");
            steps.own("L_f", &METRE, self.hanging.si(), "hanging");
        }
        if rope && (steps.needs_inertia() || slope) {
            steps.formula("S_u", &ONE, self.speeds(), "z_f*(z_f^2 + 2)/3");
        }
        if steps.needs_inertia() {
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            let of_rope = "m_r/(z_f*L_f)*((L_f - k*q)*S_u + z_f^3*k*q)";
            let moved = carried(payload).and(true, "m_c").and(rope, of_rope).factor();
            steps.inertia(reduced, payload, &[format!("{moved}*k^2")]);
        }
        if slope {
            let text = "m_r/(z_f*L_f)*(z_f^3 - S_u)*k^3";
            steps.formula("J_q", &KILOGRAM_SQUARE_METRE, reduced.slope, text);
        }
        if steps.needs_holding() {
            steps.process_force(extra.force.si());
            let weight = carried(payload).less(true, "m_c").and(rope, "m_r*(1 - k*q/L_f)").factor();
            steps.holding(reduced, format!("k*(9.80665*{weight} + F_p)"));
        }
        Parts { slope, ..Parts::of(steps, payload) }
    }

    /// Records the torques of the load's and of the counterweight's rope without the losses of the sheaves, `T_f1` and `T_f2`,
    /// for a recorded law of the hoist, and returns them \[Nm\].
    pub(super) fn explain_ropes(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        [alpha, omega]: [&str; 2],
        steps: &mut Steps<'_>,
    ) -> [f64; 2] {
        let k = self.drum_diameter.si() / (2.0 * f64::from(self.falls));
        let mass = self.counterweight.si();
        let acceleration = output.acceleration_rad_s2;
        let turning = self.inertia.si() + extra.inertia.si();
        let load = (reduced.inertia - turning - mass * k * k) * acceleration
            + 0.5 * reduced.slope * output.speed_rad_s * output.speed_rad_s
            + reduced.holding
            + mass * crate::gravity_m_s2() * k;
        let counterweight = mass * (crate::gravity_m_s2() - k * acceleration) * k;
        let moved =
            Sum::of("J_M").less(true, "J_0").less(extra.inertia.si() != 0.0, "J_p").less(mass != 0.0, "m_c*k^2");
        let text = Sum::of(format!("{}*{alpha}", moved.factor()))
            .and(reduced.slope != 0.0, format!("J_q*{omega}^2/2"))
            .and(true, "T_h")
            .and(mass != 0.0, "9.80665*m_c*k");
        steps.formula("T_f1", &NEWTON_METRE, load, text.text());
        if mass != 0.0 {
            steps.formula("T_f2", &NEWTON_METRE, counterweight, format!("m_c*(9.80665 - k*{alpha})*k"));
        }
        [load, counterweight]
    }

    /// Returns the symbols of both ropes with the losses of the sheaves, whose efficiency is recorded, for the values without
    /// them.
    pub(crate) fn explain_sheaves(
        &self,
        symbols: [&str; 2],
        [load, counterweight]: [f64; 2],
        direction: f64,
        steps: &mut Steps<'_>,
    ) -> [String; 2] {
        if self.reeving == 1.0 {
            return symbols.map(str::to_owned);
        }
        let [lifted, lowered] = self.sheave_losses([load, counterweight], direction);
        let help = i32::from((lifted + lowered) * direction < 0.0);
        let powers = [load, -counterweight].map(|pull| match pull * direction {
            power if power > 0.0 => -1 - help,
            power if power < 0.0 => 1 - help,
            _ => 0,
        });
        if powers != [0; 2] {
            let key = format!("{}.sheave_efficiency, {}.falls", steps.table, steps.table);
            steps.work.figure("eta_F", &ONE, self.reeving, &Source::Project { key: key.into() }, Grade::Printed);
        }
        let with = |symbol: &str, power: i32| match power {
            1 => format!("{symbol}*eta_F"),
            -1 => format!("{symbol}/eta_F"),
            -2 => format!("{symbol}/eta_F^2"),
            _ => symbol.to_owned(),
        };
        let [(first, of_first), (second, of_second)] = [(symbols[0], powers[0]), (symbols[1], powers[1])];
        [with(first, of_first), with(second, of_second)]
    }
}

impl Winder {
    /// Records the position and the radius of the roll, `r_w`, and its data.
    pub(crate) fn explain_roll(&self, position_rad: f64, steps: &mut Steps<'_>) {
        steps.position();
        for (symbol, value, key) in [
            ("D_0", self.start_diameter, "start_diameter"),
            ("D_k", self.core_diameter, "core_diameter"),
            ("D_f", self.full_diameter, "full_diameter"),
            ("s_w", self.thickness, "thickness"),
        ] {
            steps.own(symbol, &METRE, value.si(), key);
        }
        let sign = match self.winding {
            Winding::Up => "+",
            Winding::Off => "-",
        };
        let text = format!("min(max(D_0/2 {sign} s_w*q/(2*pi), D_k/2), D_f/2)");
        steps.formula("r_w", &METRE, self.radius(position_rad), text);
    }

    /// Records width and density of the web, `b_w` and `rho`.
    pub(crate) fn explain_web(&self, steps: &mut Steps<'_>) {
        steps.own("b_w", &METRE, self.width.si(), "width");
        steps.own("rho", &KILOGRAM_PER_CUBIC_METRE, self.density.si(), "density");
    }

    pub(super) fn explain(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        steps: &mut Steps<'_>,
    ) -> Parts {
        self.explain_roll(output.position_rad, steps);
        let payload = steps.payload(&Extra { mass: Mass::from_si(0.0), ..*extra });
        if steps.needs_inertia() {
            self.explain_web(steps);
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            steps.inertia(reduced, payload, &["pi/2*rho*b_w*(r_w^4 - (D_k/2)^4)".to_owned()]);
        }
        if steps.needs_holding() {
            steps.own("F_w", &NEWTON, self.tension.si(), "tension");
            let text = match self.winding {
                Winding::Up => "F_w*r_w",
                Winding::Off => "-F_w*r_w",
            };
            steps.holding(reduced, text.to_owned());
        }
        Parts::of(steps, payload)
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
        steps.position();
        steps.own("P_h", &METRE, lead, "lead");
        steps.formula("k", &METRE, lead / std::f64::consts::TAU, "P_h/(2*pi)");
        steps.own("L_s", &METRE, self.arm_length.si(), "arm_length");
        steps.own("theta_0", &RADIAN, self.angle.si(), "arm_angle");
        steps.own("z_s", &ONE, stages, "stages");
        let (base, height, rise) = self.linkage(output.position_rad);
        steps.formula("b_s", &METRE, base, "min(max(L_s*cos(theta_0) - k*q, 0), L_s*cos(pi/180))");
        steps.formula("w_s", &METRE, height, "sqrt(L_s^2 - b_s^2)");
        steps.formula("h_1", &METRE, stages * rise, "z_s*k*b_s/w_s");
        steps.own("m", &KILOGRAM, self.mass.si(), "mass");
        steps.own("m_a", &KILOGRAM, self.arm_mass.si(), "arm_mass");
        let payload = steps.payload(extra);
        let moved = carried(payload).factor();
        let slope = steps.needs_slope(reduced);
        if steps.needs_inertia() {
            steps.own("J_0", &KILOGRAM_SQUARE_METRE, self.inertia.si(), "inertia");
            let of_arms = "m_a*(k^2/4 + (z_s^2/3 - 1/12)*(h_1/z_s)^2 + L_s^2/12*(k/w_s)^2)";
            steps.inertia(reduced, payload, &[format!("{moved}*h_1^2"), of_arms.to_owned()]);
        }
        if slope {
            let bend = -stages * lead * lead * self.arm_length.si() * self.arm_length.si()
                / (std::f64::consts::TAU * std::f64::consts::TAU * height * height * height);
            steps.formula("h_2", &METRE, bend, "-z_s*k^2*L_s^2/w_s^3");
            let of_arms = "2*m_a*((z_s^2/3 - 1/12)*h_1*h_2/z_s^2 - L_s^2/12*k^3*b_s/w_s^4)";
            let text = format!("2*{moved}*h_1*h_2 + {of_arms}");
            steps.formula("J_q", &KILOGRAM_SQUARE_METRE, reduced.slope, text);
        }
        if steps.needs_holding() {
            steps.process_force(extra.force.si());
            let weight = carried(payload).and(true, "m_a/2").factor();
            steps.holding(reduced, format!("h_1*(9.80665*{weight} + F_p)"));
        }
        Parts { slope, ..Parts::of(steps, payload) }
    }
}
