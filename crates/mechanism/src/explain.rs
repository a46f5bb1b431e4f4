//! Derivation of the load torque at one instant: the law of each mechanism with its values.

use crate::equations::Reduced;
use crate::stage::with_losses;
use crate::{
    Extra, FourBar, Hoist, Joint, Linear, LinearKind, Mechanism, MechanismId, MechanismKind, Output, Rotor, RotorKind,
    ScissorLift, SliderCrank, Table, Winder, Winding,
};
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM, KILOGRAM_PER_CUBIC_METRE, KILOGRAM_SQUARE_METRE, METRE, NEWTON, NEWTON_METRE,
    NEWTON_METRE_SECOND_PER_RADIAN, ONE, RADIAN, RADIAN_PER_SECOND, RADIAN_PER_SECOND_SQUARED,
};
use quantities::{Mass, Measure, Torque, Unit};

/// Model of the mechanisms.
const MODEL: Source = Source::Model { name: "mechanisms" };

/// Model of a stage.
const STAGE: Source = Source::Model { name: "stage" };

/// State of the actuator's output at an instant, with the additions of its segment.
#[derive(Clone, Copy, Debug)]
pub struct At {
    /// Instant of the cycle \[s\].
    pub time_s: f64,
    /// State of the output.
    pub output: Output,
    /// Additions of the segment.
    pub extra: Extra,
    /// Recorded torque \[Nm\], if there is a recording.
    pub recorded_nm: f64,
    /// Index of the segment.
    pub segment: usize,
}

/// Selects the formula with the acceleration and the speed of the mechanism: those of the output, or those behind a stage.
macro_rules! sided {
    ($staged:expr, $($part:tt)*) => {
        if $staged { concat!($(sided!(@behind $part)),*) } else { concat!($(sided!(@plain $part)),*) }
    };
    (@behind alpha) => { "alpha_2" };
    (@plain alpha) => { "alpha" };
    (@behind omega) => { "omega_2" };
    (@plain omega) => { "omega" };
    (@behind $text:literal) => { $text };
    (@plain $text:literal) => { $text };
}

/// Steps of one derivation.
pub(crate) struct Steps<'w> {
    pub(crate) work: &'w mut Workings,
    /// Table of the mechanism in the project file.
    table: String,
    /// Number of the segment.
    segment: usize,
}

impl<'w> Steps<'w> {
    /// Creates the steps of a mechanism in a segment.
    pub(crate) fn of(id: MechanismId, segment: usize, work: &'w mut Workings) -> Self {
        let table = match id {
            MechanismId::Load => "load".to_owned(),
            id => format!("mechanism.{}", id.key()),
        };
        Self { work, table, segment }
    }

    /// Records a value of the mechanism's table.
    pub(crate) fn own(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, key: &str) {
        let key = format!("{}.{key}", self.table);
        self.work.figure(symbol, unit, si, &Source::Project { key: key.into() }, Grade::Printed);
    }

    /// Records a value of the segment, if it is not zero; returns `true` if it is recorded.
    pub(crate) fn of_segment(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, key: &str) -> bool {
        if si != 0.0 {
            let key = format!("motion[{}].{key}", self.segment + 1);
            self.work.figure(symbol, unit, si, &Source::Project { key: key.into() }, Grade::Printed);
        }
        si != 0.0
    }

    /// Records the process force of mechanism and segment.
    fn process_force(&mut self, si: f64) {
        let key = format!("{}.process_force, motion[{}].process_force", self.table, self.segment + 1);
        self.work.figure("F_p", &NEWTON, si, &Source::Project { key: key.into() }, Grade::Printed);
    }

    fn formula(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, text: &'static str) {
        self.work.formula(symbol, unit, si, text, &MODEL);
    }

    pub(crate) fn found(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, what: Finding) {
        self.work.found(symbol, unit, si, what, &MODEL, Grade::Computed);
    }
}

/// Torques of a derivation beside that of the inertia.
#[derive(Clone, Copy, Default)]
struct Parts {
    /// J_M is recorded.
    inertia: bool,
    /// T_h is recorded.
    holding: bool,
    /// T_g is recorded.
    guide: bool,
    /// J' is recorded.
    slope: bool,
    /// T_x is recorded.
    other: bool,
}

impl Mechanism {
    /// Returns the load torque at a state of the output \[Nm\], as the derivation computes it.
    #[must_use]
    pub fn torque_at(&self, at: &At) -> f64 {
        self.torque(&at.output, &at.laden())
    }

    /// Returns `true` if the derivation of the load torque uses the acceleration: all but the recorded torque of a joint.
    #[must_use]
    pub fn explains_by_acceleration(&self) -> bool {
        !matches!(self.kind, MechanismKind::Joint(_)) || self.gearing().is_some()
    }

    /// Records the derivation of the load torque `T_L` at an instant `t` with the acceleration `alpha`, which are recorded
    /// before: inertia, weight, process, friction, losses and stage. `torque_nm` is the torque as computed elsewhere, equal
    /// but for rounding.
    pub fn explain_torque(&self, at: &At, torque_nm: f64, work: &mut Workings) {
        if !work.is_on() {
            return;
        }
        let stage = self.gearing().copied();
        let output = stage.as_ref().map_or(at.output, |stage| stage.behind(&at.output));
        let extra = at.laden();
        let reduced = self.kind.reduced(output.position_rad, &extra);
        let staged = stage.is_some();
        let mut steps = Steps::of(self.id(), at.segment, work);
        if let Some(stage) = &stage {
            steps.work.figure("i_s", &ONE, stage.ratio, &key("stage.ratio"), Grade::Printed);
            let (unit, value) = (&RADIAN_PER_SECOND_SQUARED, output.acceleration_rad_s2);
            steps.work.formula("alpha_2", unit, value, "alpha/i_s", &STAGE);
        }
        if self.depends_on_position() {
            let turned = if let MechanismKind::SliderCrank(crank) = &self.kind { crank.angle.si() } else { 0.0 };
            steps.found("q", &RADIAN, output.position_rad + turned, Finding::PositionAt);
        }
        let has_speed = self.friction.viscous.si() != 0.0 || reduced.slope != 0.0;
        if has_speed {
            steps.found("omega", &RADIAN_PER_SECOND, at.output.speed_rad_s, Finding::SpeedAt);
            if staged {
                steps.work.formula("omega_2", &RADIAN_PER_SECOND, output.speed_rad_s, "omega/i_s", &STAGE);
            }
        }
        if reduced.coulomb != 0.0 || self.friction.coulomb.si() != 0.0 || self.has_lossy_sheaves() {
            steps.found("sigma", &ONE, output.direction, Finding::DirectionAt);
        }
        // The couple of the segment and the recorded torque are recorded with the external one.
        let couple = extra.torque.si();
        let alone = Reduced { holding: reduced.holding - couple, ..reduced };
        let mut parts = match &self.kind {
            MechanismKind::Rotor(rotor) => rotor.explain(&alone, &at.extra, &mut steps),
            MechanismKind::Linear(linear) => linear.explain(&alone, &at.extra, &mut steps),
            MechanismKind::SliderCrank(crank) => crank.explain(&alone, (&output, &at.extra), &mut steps),
            MechanismKind::Table(table) => table.explain(&alone, &at.extra, &mut steps),
            MechanismKind::Joint(joint) => joint.explain(&mut steps),
            MechanismKind::Hoist(hoist) => hoist.explain(&alone, &at.extra, &mut steps),
            MechanismKind::Winder(winder) => winder.explain(&alone, (&output, &at.extra), &mut steps),
            MechanismKind::ScissorLift(lift) => lift.explain(&alone, (&output, &at.extra), &mut steps),
            MechanismKind::FourBar(linkage) => linkage.explain(&alone, &at.extra, &mut steps),
        };
        parts.other = self.explain_others(at, &mut steps);
        let (useful, _) = self.useful(&reduced, &output, &extra);
        if let (MechanismKind::Hoist(_), true) = (&self.kind, self.has_lossy_sheaves()) {
            let own = reduced.inertia * output.acceleration_rad_s2
                + 0.5 * reduced.slope * output.speed_rad_s * output.speed_rad_s
                + reduced.holding
                + self.friction.external.si();
            steps.formula("T_w", &NEWTON_METRE, own, parts.text(staged));
            steps.found("T_r", &NEWTON_METRE, useful - own, Finding::RopesThroughSheaves);
            steps.formula("T_u", &NEWTON_METRE, useful, "T_w + T_r");
        } else {
            steps.formula("T_u", &NEWTON_METRE, useful, parts.text(staged));
        }
        self.explain_losses((useful, torque_nm), &output, &mut steps);
    }

    /// Records the torque with losses and friction, and that in front of a stage.
    fn explain_losses(&self, (useful, torque_nm): (f64, f64), output: &Output, steps: &mut Steps<'_>) {
        let stage = self.gearing();
        let staged = stage.is_some();
        let (coulomb, viscous) = (self.friction.coulomb.si() != 0.0, self.friction.viscous.si() != 0.0);
        if coulomb {
            steps.own("T_c", &NEWTON_METRE, self.friction.coulomb.si(), "friction_torque");
        }
        if viscous {
            steps.own("b", &NEWTON_METRE_SECOND_PER_RADIAN, self.friction.viscous.si(), "viscous_friction");
        }
        let power = useful * output.direction;
        let (driving, driven) =
            (power > 0.0 && self.efficiency_driving != 1.0, power < 0.0 && self.efficiency_driven != 1.0);
        if driving {
            steps.own("eta_1", &ONE, self.efficiency_driving, "efficiency");
        }
        if driven {
            steps.own("eta_2", &ONE, self.efficiency_driven, "efficiency_back");
        }
        let text = match (driving, driven, coulomb, viscous) {
            (true, _, true, true) => sided!(staged, "T_u/eta_1 + T_c*sigma + b*" omega),
            (true, _, true, false) => "T_u/eta_1 + T_c*sigma",
            (true, _, false, true) => sided!(staged, "T_u/eta_1 + b*" omega),
            (true, _, false, false) => "T_u/eta_1",
            (_, true, true, true) => sided!(staged, "T_u*eta_2 + T_c*sigma + b*" omega),
            (_, true, true, false) => "T_u*eta_2 + T_c*sigma",
            (_, true, false, true) => sided!(staged, "T_u*eta_2 + b*" omega),
            (_, true, false, false) => "T_u*eta_2",
            (_, _, true, true) => sided!(staged, "T_u + T_c*sigma + b*" omega),
            (_, _, true, false) => "T_u + T_c*sigma",
            (_, _, false, true) => sided!(staged, "T_u + b*" omega),
            (_, _, false, false) => "T_u",
        };
        let own = self.passed(useful, output);
        let Some(stage) = stage else {
            steps.formula("T_L", &NEWTON_METRE, torque_nm, text);
            return;
        };
        steps.formula("T_M", &NEWTON_METRE, own, text);
        let handed_on = stage.handed_on(own, output);
        let lossy = with_losses(1.0, handed_on * output.direction, [stage.efficiency_driving, stage.efficiency_driven]);
        let text = match (handed_on * output.direction, lossy != 1.0) {
            (power, true) if power > 0.0 => {
                let value = stage.efficiency_driving;
                steps.work.figure("eta_s1", &ONE, value, &key("stage.efficiency"), Grade::Printed);
                "(T_M + J_2*alpha_2)/(i_s*eta_s1) + J_1*alpha"
            }
            (power, true) if power < 0.0 => {
                let value = stage.efficiency_driven;
                steps.work.figure("eta_s2", &ONE, value, &key("stage.efficiency_back"), Grade::Printed);
                "(T_M + J_2*alpha_2)*eta_s2/i_s + J_1*alpha"
            }
            _ => "(T_M + J_2*alpha_2)/i_s + J_1*alpha",
        };
        let inertias = [
            ("J_1", stage.inertia_driving, "stage.inertia_driving"),
            ("J_2", stage.inertia_driven, "stage.inertia_driven"),
        ];
        for (symbol, value, name) in inertias {
            steps.work.figure(symbol, &KILOGRAM_SQUARE_METRE, value.si(), &key(name), Grade::Printed);
        }
        steps.work.formula("T_L", &NEWTON_METRE, torque_nm, text, &STAGE);
    }

    /// Records `T_x`, the sum of the torques without a law of the mechanism; returns `true` if there are some.
    fn explain_others(&self, at: &At, steps: &mut Steps<'_>) -> bool {
        let external = self.friction.external.si();
        let process = steps.of_segment("T_p", &NEWTON_METRE, at.extra.torque.si(), "process_torque");
        let recorded = at.recorded_nm != 0.0 || matches!(self.kind, MechanismKind::Joint(_));
        if recorded {
            steps.found("tau", &NEWTON_METRE, at.recorded_nm, Finding::RecordedTorqueAt);
        }
        if external != 0.0 {
            steps.own("T_e", &NEWTON_METRE, external, "external_torque");
        }
        let text = match (process, recorded, external != 0.0) {
            (false, false, false) => return false,
            (true, false, false) => "T_p",
            (false, true, false) => "tau",
            (false, false, true) => "T_e",
            (true, true, false) => "T_p + tau",
            (true, false, true) => "T_p + T_e",
            (false, true, true) => "tau + T_e",
            (true, true, true) => "T_p + tau + T_e",
        };
        steps.formula("T_x", &NEWTON_METRE, at.extra.torque.si() + at.recorded_nm + external, text);
        true
    }
}

fn key(name: &'static str) -> Source {
    Source::Project { key: name.into() }
}

impl At {
    /// Returns the additions of the segment with the recorded torque.
    fn laden(&self) -> Extra {
        Extra { torque: self.extra.torque + Torque::from_si(self.recorded_nm), ..self.extra }
    }
}

impl Parts {
    /// Returns the formula of the useful torque.
    fn text(self, staged: bool) -> &'static str {
        let Self { inertia, holding, guide, slope, other } = self;
        match (inertia, holding, guide, slope, other) {
            (false, .., true) => "T_x",
            (false, .., false) => "0",
            (true, false, _, _, false) => sided!(staged, "J_M*" alpha),
            (true, false, _, _, true) => sided!(staged, "J_M*" alpha " + T_x"),
            (true, true, false, false, false) => sided!(staged, "J_M*" alpha " + T_h"),
            (true, true, false, false, true) => sided!(staged, "J_M*" alpha " + T_h + T_x"),
            (true, true, true, _, false) => sided!(staged, "J_M*" alpha " + T_h + T_g*sigma"),
            (true, true, true, _, true) => sided!(staged, "J_M*" alpha " + T_h + T_g*sigma + T_x"),
            (true, true, false, true, false) => sided!(staged, "J_M*" alpha " + J_q*" omega "^2/2 + T_h"),
            (true, true, false, true, true) => sided!(staged, "J_M*" alpha " + J_q*" omega "^2/2 + T_h + T_x"),
        }
    }
}

/// Records the additions of a segment to the inertia, and returns which there are: payload and payload inertia.
fn payload(extra: &Extra, steps: &mut Steps<'_>) -> (bool, bool) {
    (
        steps.of_segment("m_p", &KILOGRAM, extra.mass.si(), "payload"),
        steps.of_segment("J_p", &KILOGRAM_SQUARE_METRE, extra.inertia.si(), "payload_inertia"),
    )
}

const INERTIA: (&str, &Unit) = ("J_M", &KILOGRAM_SQUARE_METRE);

impl Rotor {
    fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, (output, extra): (&Output, &Extra), steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, _steps: &mut Steps<'_>) -> Parts {
        Parts::default()
    }
}

impl Hoist {
    fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, (output, extra): (&Output, &Extra), steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, (output, extra): (&Output, &Extra), steps: &mut Steps<'_>) -> Parts {
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
    fn explain(&self, reduced: &Reduced, extra: &Extra, steps: &mut Steps<'_>) -> Parts {
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
