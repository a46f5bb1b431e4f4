//! Derivation of the load torque at one instant: the law of each mechanism with its values.

mod laws;

use crate::equations::Reduced;
use crate::stage::with_losses;
use crate::{Extra, LinearKind, Mechanism, MechanismId, MechanismKind, Output};
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM_SQUARE_METRE, NEWTON, NEWTON_METRE, NEWTON_METRE_SECOND_PER_RADIAN, ONE, RADIAN, RADIAN_PER_SECOND,
    RADIAN_PER_SECOND_SQUARED,
};
use quantities::{Measure, Torque, Unit};

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

    /// Records the force along the axis of a screw, `F_l`: the torque of what it moves by its travel per angle, without the
    /// inertia that turns with it. Returns `false`, and records nothing, for another mechanism and with additions to the load
    /// that this derivation does not have.
    pub(crate) fn explain_thrust(&self, at: &At, thrust_n: f64, work: &mut Workings) -> bool {
        let kind = &self.kind;
        let is_screw = match kind {
            MechanismKind::Linear(linear) => linear.kind == LinearKind::Screw,
            kind => matches!(kind, MechanismKind::ScissorLift(_)),
        };
        if !is_screw || at.recorded_nm != 0.0 || at.extra.inertia.si() != 0.0 {
            return false;
        }
        let reduced = kind.reduced(at.output.position_rad, &at.extra);
        let alone = Reduced { holding: reduced.holding - at.extra.torque.si(), ..reduced };
        let mut steps = Steps::of(self.id(), at.segment, work);
        let (output, extra) = (&at.output, &at.extra);
        if self.depends_on_position() {
            steps.found("q", &RADIAN, output.position_rad, Finding::PositionAt);
        }
        let (unit, alpha) = (&RADIAN_PER_SECOND_SQUARED, output.acceleration_rad_s2);
        steps.found("alpha", unit, alpha, Finding::AccelerationAt);
        if reduced.slope != 0.0 {
            steps.found("omega", &RADIAN_PER_SECOND, output.speed_rad_s, Finding::SpeedAt);
        }
        if reduced.coulomb != 0.0 {
            steps.found("sigma", &ONE, output.direction, Finding::DirectionAt);
        }
        let parts = match kind {
            MechanismKind::Linear(linear) => linear.explain(&alone, extra, &mut steps),
            MechanismKind::ScissorLift(lift) => lift.explain(&alone, (output, extra), &mut steps),
            _ => return false,
        };
        let text = match (parts.guide, parts.slope) {
            (true, _) => "((J_M - J_0)*alpha + T_h + T_g*sigma)/k",
            (false, true) => "((J_M - J_0)*alpha + J_q*omega^2/2 + T_h)/k",
            (false, false) => "((J_M - J_0)*alpha + T_h)/k",
        };
        steps.work.formula("F_l", &NEWTON, thrust_n, text, &Source::Model { name: "flange-loads" });
        true
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
