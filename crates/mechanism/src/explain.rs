//! Derivation of the load torque at one instant: the law of each mechanism with its values.

mod laws;
mod linkage;
mod sum;

use crate::equations::Reduced;
use crate::stage::with_losses;
use crate::{Extra, Hoist, Mechanism, MechanismId, MechanismKind, Output, Stage};
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::unit::{
    KILOGRAM_SQUARE_METRE, NEWTON, NEWTON_METRE, NEWTON_METRE_SECOND_PER_RADIAN, ONE, RADIAN, RADIAN_PER_SECOND,
    RADIAN_PER_SECOND_SQUARED,
};
use quantities::{Measure, Torque, Unit};
use std::borrow::Cow;
pub(crate) use sum::Sum;

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

/// Quantities that a derivation needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LawScope {
    /// Inertia, its slope and all torques.
    Torque,
    /// Inertia only.
    Inertia,
    /// Torque that holds the load at rest only.
    Holding,
}

/// Steps of one derivation.
pub(crate) struct Steps<'w> {
    pub(crate) work: &'w mut Workings,
    /// Table of the mechanism in the project file.
    table: String,
    /// Number of the segment.
    segment: usize,
    scope: LawScope,
    /// Position of the mechanism \[rad\], until it is recorded.
    position: Option<(f64, Finding)>,
    /// Symbol of the inertia.
    inertia: &'static str,
}

impl<'w> Steps<'w> {
    /// Creates the steps of a mechanism in a segment.
    pub(crate) fn of(id: MechanismId, segment: usize, work: &'w mut Workings) -> Self {
        let table = match id {
            MechanismId::Load => "load".to_owned(),
            id => format!("mechanism.{}", id.key()),
        };
        Self { work, table, segment, scope: LawScope::Torque, position: None, inertia: "J_M" }
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

    fn formula(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, text: impl Into<Cow<'static, str>>) {
        self.work.formula(symbol, unit, si, text, &MODEL);
    }

    pub(crate) fn found(&mut self, symbol: &'static str, unit: &'static Unit, si: f64, what: Finding) {
        self.work.found(symbol, unit, si, what, &MODEL, Grade::Computed);
    }

    /// Sets the position of the mechanism, which is recorded on first use.
    pub(crate) const fn place(&mut self, position_rad: f64, what: Finding) {
        self.position = Some((position_rad, what));
    }

    /// Records the position of the mechanism, `q`, on first use.
    fn position(&mut self) {
        if let Some((position_rad, what)) = self.position.take() {
            self.found("q", &RADIAN, position_rad, what);
        }
    }

    /// Records acceleration and, as far as a formula needs them, speed and direction of the output at `t`.
    pub(crate) fn motion(&mut self, output: &Output, has_speed: bool, has_direction: bool) {
        let alpha = output.acceleration_rad_s2;
        self.found("alpha", &RADIAN_PER_SECOND_SQUARED, alpha, Finding::AccelerationAt);
        if has_speed {
            self.found("omega", &RADIAN_PER_SECOND, output.speed_rad_s, Finding::AngularVelocityAt);
        }
        if has_direction {
            self.found("sigma", &ONE, output.direction, Finding::DirectionAt);
        }
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
    /// J_p is recorded.
    payload_inertia: bool,
}

/// Symbols of acceleration and speed of the mechanism: those of the output, or those behind a stage.
const fn rates(is_staged: bool) -> [&'static str; 2] {
    if is_staged { ["alpha_2", "omega_2"] } else { ["alpha", "omega"] }
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
        let mut steps = Steps::of(self.id(), at.segment, work);
        let Some(stage) = self.gearing() else {
            let (text, _) = self.explain_own(at, None, &mut steps);
            steps.formula("T_L", &NEWTON_METRE, torque_nm, text);
            return;
        };
        let handed_on = self.explain_behind(at, stage, &mut steps);
        let direction = at.output.direction;
        let lossy = with_losses(1.0, handed_on * direction, [stage.efficiency_driving, stage.efficiency_driven]) != 1.0;
        let power = handed_on * direction;
        let shared = match (power, lossy) {
            (power, true) if power > 0.0 => {
                stage_efficiency(stage, steps.work);
                "(T_M + J_2*alpha_2)/(i_s*eta_s1)"
            }
            (power, true) if power < 0.0 => {
                let value = stage.efficiency_driven;
                steps.work.figure("eta_s2", &ONE, value, &key("stage.efficiency_back"), Grade::Printed);
                "(T_M + J_2*alpha_2)*eta_s2/i_s"
            }
            _ => "(T_M + J_2*alpha_2)/i_s",
        };
        let value = stage.inertia_driving.si();
        steps.work.figure("J_1", &KILOGRAM_SQUARE_METRE, value, &key("stage.inertia_driving"), Grade::Printed);
        let text = Sum::of(shared).and(true, "J_1*alpha").text();
        steps.work.formula("T_L", &NEWTON_METRE, torque_nm, text, &STAGE);
    }

    /// Records the torque of the mechanism behind a stage, `T_M`, and the inertia of the stage on that side, `J_2`; the
    /// acceleration `alpha` is recorded before. Returns T_M + J_2 α_2 \[Nm\].
    pub(crate) fn explain_behind(&self, at: &At, stage: &Stage, steps: &mut Steps<'_>) -> f64 {
        let (text, own) = self.explain_own(at, Some(stage), steps);
        steps.formula("T_M", &NEWTON_METRE, own, text);
        let value = stage.inertia_driven.si();
        steps.work.figure("J_2", &KILOGRAM_SQUARE_METRE, value, &key("stage.inertia_driven"), Grade::Printed);
        stage.handed_on(own, &stage.behind(&at.output))
    }

    /// Records the parts of the torque of the mechanism, on its side of a stage, and returns its formula and its value \[Nm\].
    fn explain_own(&self, at: &At, stage: Option<&Stage>, steps: &mut Steps<'_>) -> (String, f64) {
        let output = stage.map_or(at.output, |stage| stage.behind(&at.output));
        let extra = at.laden();
        let reduced = self.kind.reduced(output.position_rad, &extra);
        let is_staged = stage.is_some();
        let [alpha, omega] = rates(is_staged);
        if let Some(stage) = stage {
            stage_ratio(stage, steps.work);
            let (unit, value) = (&RADIAN_PER_SECOND_SQUARED, output.acceleration_rad_s2);
            steps.work.formula("alpha_2", unit, value, "alpha/i_s", &STAGE);
        }
        let (coulomb, viscous) = (self.friction.coulomb.si() != 0.0, self.friction.viscous.si() != 0.0);
        if viscous || reduced.slope != 0.0 {
            steps.found("omega", &RADIAN_PER_SECOND, at.output.speed_rad_s, Finding::AngularVelocityAt);
            if is_staged {
                steps.work.formula("omega_2", &RADIAN_PER_SECOND, output.speed_rad_s, "omega/i_s", &STAGE);
            }
        }
        if reduced.coulomb != 0.0 || coulomb {
            steps.found("sigma", &ONE, output.direction, Finding::DirectionAt);
        }
        // The couple of the segment and the recorded torque are recorded with the external one.
        let alone = Reduced { holding: reduced.holding - extra.torque.si(), ..reduced };
        let parts = self.explain_parts(&alone, (&output, &at.extra), Finding::PositionAt, steps);
        let parts = Parts { other: self.explain_others(at, steps), ..parts };
        let (useful, _) = self.useful(&reduced, &output, &extra);
        let text = match &self.kind {
            MechanismKind::Hoist(hoist) if hoist.reeving != 1.0 => {
                let torques = hoist.explain_ropes(&alone, (&output, &at.extra), rates(is_staged), steps);
                let [load, counterweight] = hoist.explain_sheaves(["T_f1", "T_f2"], torques, output.direction, steps);
                let turning = Sum::of("J_0").and(parts.payload_inertia, "J_p").factor();
                let sum = Sum::of(format!("{turning}*{alpha}")).and(true, load);
                sum.less(hoist.counterweight.si() != 0.0, counterweight).and(parts.other, "T_x").text()
            }
            _ => parts.text(is_staged),
        };
        steps.formula("T_u", &NEWTON_METRE, useful, text);
        if coulomb {
            steps.own("T_c", &NEWTON_METRE, self.friction.coulomb.si(), "friction_torque");
        }
        if viscous {
            steps.own("b", &NEWTON_METRE_SECOND_PER_RADIAN, self.friction.viscous.si(), "viscous_friction");
        }
        let power = useful * output.direction;
        let useful_text = if power > 0.0 && self.efficiency_driving != 1.0 {
            self.explain_efficiency(steps);
            "T_u/eta_1"
        } else if power < 0.0 && self.efficiency_driven != 1.0 {
            steps.own("eta_2", &ONE, self.efficiency_driven, "efficiency_back");
            "T_u*eta_2"
        } else {
            "T_u"
        };
        let text = Sum::of(useful_text).and(coulomb, "T_c*sigma").and(viscous, format!("b*{omega}")).text();
        (text, self.passed(useful, &output))
    }

    /// Records the efficiency while driving, `eta_1`.
    pub(crate) fn explain_efficiency(&self, steps: &mut Steps<'_>) {
        steps.own("eta_1", &ONE, self.efficiency_driving, "efficiency");
    }

    /// Records inertia, its slope and the torques that do not depend on the motion, as far as the derivation needs them, at a
    /// state of the mechanism, whose position `what` names.
    fn explain_parts(
        &self,
        reduced: &Reduced,
        (output, extra): (&Output, &Extra),
        what: Finding,
        steps: &mut Steps<'_>,
    ) -> Parts {
        let turned = if let MechanismKind::SliderCrank(crank) = &self.kind { crank.angle.si() } else { 0.0 };
        if self.depends_on_position() {
            steps.place(output.position_rad + turned, what);
        }
        match &self.kind {
            MechanismKind::Rotor(rotor) => rotor.explain(reduced, extra, steps),
            MechanismKind::Linear(linear) => linear.explain(reduced, extra, steps),
            MechanismKind::SliderCrank(crank) => crank.explain(reduced, (output, extra), steps),
            MechanismKind::Table(table) => table.explain(reduced, (output, extra), steps),
            MechanismKind::Joint(_) => Parts::default(),
            MechanismKind::Hoist(hoist) => hoist.explain(reduced, extra, steps),
            MechanismKind::Winder(winder) => winder.explain(reduced, (output, extra), steps),
            MechanismKind::ScissorLift(lift) => lift.explain(reduced, (output, extra), steps),
            MechanismKind::FourBar(linkage) => linkage.explain(reduced, (output, extra), steps),
        }
    }

    /// Records the parts of the torque of what moves along a line, without the inertia that turns in front of it, at an instant
    /// `t`; returns its formula, to be divided by the travel per angle. A recorded torque is one of the line.
    pub(crate) fn explain_line(&self, at: &At, steps: &mut Steps<'_>) -> (Sum, bool) {
        let reduced = self.kind.reduced(at.output.position_rad, &at.extra);
        let alone = Reduced { holding: reduced.holding - at.extra.torque.si(), ..reduced };
        steps.motion(&at.output, reduced.slope != 0.0, reduced.coulomb != 0.0);
        let parts = self.explain_parts(&alone, (&at.output, &at.extra), Finding::PositionAt, steps);
        let recorded = at.recorded_nm != 0.0;
        if recorded {
            steps.found("tau", &NEWTON_METRE, at.recorded_nm, Finding::RecordedTorqueAt);
        }
        let moved = Sum::of("J_M").less(true, "J_0").less(parts.payload_inertia, "J_p").factor();
        let text = Sum::of(format!("{moved}*alpha"))
            .and(parts.slope, "J_q*omega^2/2")
            .and(parts.holding, "T_h")
            .and(parts.guide, "T_g*sigma")
            .and(recorded, "tau");
        (text, parts.payload_inertia)
    }

    /// Records the torques of the ropes of a hoist at an instant `t`, without those of the segment and the recorded one, and
    /// returns them \[Nm\].
    pub(crate) fn explain_ropes_at(&self, hoist: &Hoist, at: &At, steps: &mut Steps<'_>) -> [f64; 2] {
        let reduced = self.kind.reduced(at.output.position_rad, &at.extra);
        let alone = Reduced { holding: reduced.holding - at.extra.torque.si(), ..reduced };
        steps.motion(&at.output, reduced.slope != 0.0, false);
        self.explain_parts(&alone, (&at.output, &at.extra), Finding::PositionAt, steps);
        hoist.explain_ropes(&alone, (&at.output, &at.extra), rates(false), steps)
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
        let text = Sum::default().and(process, "T_p").and(recorded, "tau").and(external != 0.0, "T_e");
        let is_stated = !text.is_empty();
        if is_stated {
            steps.formula("T_x", &NEWTON_METRE, at.extra.torque.si() + at.recorded_nm + external, text.text());
        }
        is_stated
    }

    /// Records the derivation of the torque that holds the load at rest at a position of the actuator's output, under `T_hold`:
    /// weight, process and external torque, through a stage.
    pub fn explain_holding(&self, position_rad: f64, (segment, extra): (usize, &Extra), work: &mut Workings) {
        if !work.is_on() {
            return;
        }
        let holding = self.holding_torque(position_rad, extra).si().abs();
        let mut steps = Steps::of(self.id(), segment, work);
        if let MechanismKind::Joint(joint) = &self.kind {
            let stated = joint.holding_torque.map_or(0.0, Measure::si);
            steps.own("T_h", &NEWTON_METRE, stated, "holding_torque");
            let text = self.in_front("T_h".to_owned(), &mut steps);
            steps.formula("T_hold", &NEWTON_METRE, holding, text);
            return;
        }
        steps.scope = LawScope::Holding;
        let (reduced, output) = self.at_rest(position_rad, extra);
        let alone = Reduced { holding: reduced.holding - extra.torque.si(), ..reduced };
        let parts = self.explain_parts(&alone, (&output, extra), Finding::PositionOfLargestHolding, &mut steps);
        let process = steps.of_segment("T_p", &NEWTON_METRE, extra.torque.si(), "process_torque");
        let external = self.friction.external.si();
        if external != 0.0 {
            steps.own("T_e", &NEWTON_METRE, external, "external_torque");
        }
        let sum = Sum::default().and(parts.holding, "T_h").and(process, "T_p").and(external != 0.0, "T_e");
        let text = if sum.is_empty() { "0".to_owned() } else { format!("abs({})", sum.text()) };
        let text = self.in_front(text, &mut steps);
        steps.formula("T_hold", &NEWTON_METRE, holding, text);
    }

    /// Records the derivation of the inertia of the load at a position of the actuator's output, under a symbol.
    pub fn explain_inertia(
        &self,
        symbol: &'static str,
        (position_rad, what): (f64, Finding),
        (segment, extra): (usize, &Extra),
        work: &mut Workings,
    ) {
        if !work.is_on() {
            return;
        }
        let inertia = self.inertia(position_rad, extra).si();
        let mut steps = Steps::of(self.id(), segment, work);
        let stage = self.gearing();
        steps.inertia = if stage.is_some() { "J_M" } else { symbol };
        if let MechanismKind::Joint(joint) = &self.kind {
            let stated = joint.inertia.map_or(0.0, Measure::si);
            steps.own(steps.inertia, &KILOGRAM_SQUARE_METRE, stated, "inertia");
        } else {
            steps.scope = LawScope::Inertia;
            let (reduced, output) = self.at_rest(position_rad, extra);
            self.explain_parts(&reduced, (&output, extra), what, &mut steps);
        }
        let Some(stage) = stage else { return };
        stage_ratio(stage, steps.work);
        let inertias = [
            ("J_1", stage.inertia_driving, "stage.inertia_driving"),
            ("J_2", stage.inertia_driven, "stage.inertia_driven"),
        ];
        for (symbol, value, name) in inertias {
            steps.work.figure(symbol, &KILOGRAM_SQUARE_METRE, value.si(), &key(name), Grade::Printed);
        }
        steps.work.formula(symbol, &KILOGRAM_SQUARE_METRE, inertia, "(J_M + J_2)/i_s^2 + J_1", &STAGE);
    }

    /// Returns the load at rest at a position of the actuator's output.
    fn at_rest(&self, position_rad: f64, extra: &Extra) -> (Reduced, Output) {
        let position_rad = position_rad / self.stage_ratio();
        let output = Output { position_rad, speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction: 0.0 };
        (self.kind.reduced(position_rad, extra), output)
    }

    /// Returns a torque of the mechanism in front of a stage, whose ratio is recorded.
    fn in_front(&self, text: String, steps: &mut Steps<'_>) -> String {
        let Some(stage) = self.gearing().filter(|stage| stage.ratio != 1.0) else { return text };
        stage_ratio(stage, steps.work);
        format!("{text}/i_s")
    }
}

/// Records the ratio of a stage, `i_s`.
pub(crate) fn stage_ratio(stage: &Stage, work: &mut Workings) {
    work.figure("i_s", &ONE, stage.ratio, &key("stage.ratio"), Grade::Printed);
}

/// Records the efficiency of a stage while driving, `eta_s1`.
pub(crate) fn stage_efficiency(stage: &Stage, work: &mut Workings) {
    work.figure("eta_s1", &ONE, stage.efficiency_driving, &key("stage.efficiency"), Grade::Printed);
}

pub(crate) fn key(name: &'static str) -> Source {
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
    fn text(self, is_staged: bool) -> String {
        let [alpha, omega] = rates(is_staged);
        let sum = Sum::default()
            .and(self.inertia, format!("J_M*{alpha}"))
            .and(self.slope, format!("J_q*{omega}^2/2"))
            .and(self.holding, "T_h")
            .and(self.guide, "T_g*sigma")
            .and(self.other, "T_x");
        sum.text()
    }
}

#[cfg(test)]
#[path = "explain_tests.rs"]
mod tests;
