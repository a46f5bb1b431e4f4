//! The checks of current and voltage.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Note, Notes, Verdict};
use crate::comparison::{Comparison, cite, explained, not_checked};
use crate::trace::{Extent, Node};
use crate::workings;
use actuator::{MotorVoltage, Parameters};
use derivation::Workings;
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{
    AMPERE, AMPERE_PER_REVOLUTION_PER_MINUTE, NEWTON_METRE_PER_AMPERE, ONE, REVOLUTION_PER_MINUTE, VOLT,
};
use quantities::{AngularVelocity, ElectricCurrent, Measure, Time};
use std::borrow::Cow;

/// The motor current at every instant.
///
/// I = T/k_Tout + σ (I_NLS + K_INL |n|). Friction that opposes the torque counts with the 30 °C value of K_INL, friction
/// that helps with the 80 °C value: either way the larger current.
pub(crate) struct Currents {
    pub(crate) inertia: f64,
    torque_constant: f64,
    starting: f64,
    cold: f64,
    warm: f64,
    pub(crate) grade: Grade,
    errata: [&'static [&'static str]; 2],
}

impl Currents {
    pub(crate) fn of(actuator: &Parameters) -> Result<Self, Missing> {
        let inertia = actuator.inertia_out.require("J_out")?;
        let torque_constant = actuator.torque_constant_out.require("k_Tout")?;
        let starting = actuator.no_load_starting_current.require("I_NLS")?;
        let cold = actuator.no_load_current_constant_30.require("K_INL")?;
        let warm = actuator.no_load_current_constant_80.known().unwrap_or(cold);
        let grades = [inertia.grade, torque_constant.grade, starting.grade, cold.grade];
        Ok(Self {
            inertia: inertia.value.si(),
            torque_constant: torque_constant.value.si(),
            starting: starting.value.si(),
            cold: cold.value.si(),
            warm: warm.value.si(),
            grade: grades.into_iter().fold(Grade::Computed, Grade::worst),
            errata: [inertia.errata, torque_constant.errata],
        })
    }

    /// How friction counts, and the errata of the inputs.
    fn notes(&self) -> Notes {
        let mut notes: Notes = Cow::Borrowed(&[Note::FrictionTemperatures]);
        for errata in self.errata {
            cite(&mut notes, errata);
        }
        notes
    }

    /// The current at an instant \[A\].
    pub(crate) fn at(&self, node: &Node) -> f64 {
        let torque = self.inertia * node.acceleration + node.load;
        self.with(node, torque * node.direction < 0.0)
    }

    /// The current at an instant at the border of a time with one sign of T σ: friction as within that time \[A\].
    pub(crate) fn with(&self, node: &Node, braking: bool) -> f64 {
        let torque = self.inertia * node.acceleration + node.load;
        let constant = if braking { self.warm } else { self.cold };
        torque / self.torque_constant + node.direction * (self.starting + constant * node.speed.abs())
    }

    /// The current as a weighted sum of (α, T_L, σ, ω), where friction has one sign over all nodes: `power_sign` is that
    /// of T σ.
    pub(crate) fn weights(&self, power_sign: f64) -> [f64; 4] {
        let constant = if power_sign < 0.0 { self.warm } else { self.cold };
        [self.inertia / self.torque_constant, 1.0 / self.torque_constant, self.starting, constant]
    }

    /// The current of friction as such a sum \[A\], times σ.
    pub(crate) const fn friction_weights(&self) -> [f64; 4] {
        [0.0, 0.0, self.starting, self.cold]
    }

    /// The part of it that friction takes, by magnitude \[A\].
    pub(crate) fn friction(&self, node: &Node) -> f64 {
        node.direction.abs() * (self.starting + self.cold * node.speed.abs())
    }

    /// No current of a block of nodes is above this.
    fn bound(&self, extent: &Extent) -> f64 {
        extent.torque(self.inertia) / self.torque_constant + self.starting + self.cold.max(self.warm) * extent.speed
    }

    /// The largest magnitude and its instant.
    fn largest(&self, axis: &Axis) -> (f64, Node) {
        axis.trace.largest(|extent| self.bound(extent), |node| self.at(node).abs())
    }

    /// The workings of [`Self::at`]; the result is `I`.
    pub(crate) fn explain(&self, node: &Node, actuator: &Parameters, work: &mut Workings) {
        if !work.is_on() {
            return;
        }
        workings::torque_at(node, actuator, work);
        let torque = self.inertia * node.acceleration + node.load;
        let constant = &actuator.no_load_current_constant_80;
        let warm = if torque * node.direction < 0.0 { constant.known() } else { None };
        let data = (actuator.torque_constant_out.known(), actuator.no_load_starting_current.known());
        if let (Some(torque_constant), Some(starting)) = data {
            work.given("k_Tout", &NEWTON_METRE_PER_AMPERE, torque_constant);
            work.given("I_NLS", &AMPERE, starting);
        }
        if let Some(constant) = warm.or_else(|| actuator.no_load_current_constant_30.known()) {
            work.given("K_INL", &AMPERE_PER_REVOLUTION_PER_MINUTE, constant);
        }
        work.found("n", &REVOLUTION_PER_MINUTE, node.speed, "speed at t", &workings::DEMAND, Grade::Computed);
        work.found("sigma", &ONE, node.direction, "direction at t", &workings::DEMAND, Grade::Computed);
        let text = "T/k_Tout + sigma*(I_NLS + K_INL*abs(n))";
        work.formula("I", &AMPERE, self.at(node), text, &Source::Model { name: "current" });
    }
}

/// U ≤ (U_DC/√2) · reserve: the motor's terminal voltage at every instant of the cycle, winding hot.
pub(crate) fn voltage(
    axis: &Axis,
    actuator: &Parameters,
    currents: Result<&Currents, &Missing>,
    work: &mut Workings,
) -> Check {
    let id = CheckId::Voltage;
    let Some((supply, reserve)) = axis.supply else {
        return not_checked(id, Missing { symbol: "requirements.supply" });
    };
    let (motor, currents) = match MotorVoltage::of(actuator).and_then(|m| Ok((m, currents.map_err(|m| *m)?))) {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let typed = |node: &Node| (AngularVelocity::from_si(node.speed), ElectricCurrent::from_si(currents.at(node)));
    // The voltage of a block is below the one at its largest current and speed together.
    let bound = |extent: &Extent| {
        motor.at(AngularVelocity::from_si(extent.speed), ElectricCurrent::from_si(currents.bound(extent))).si()
    };
    let (highest, at) = axis.trace.largest(bound, |node| {
        let (speed, current) = typed(node);
        motor.at(speed, current).si()
    });
    // Between two instants the voltage may rise above both; speed and current are taken as straight.
    currents.explain(&at, actuator, work);
    let (speed, current) = typed(&at);
    motor.explain(actuator, speed, current, work);
    let worst = axis.trace.largest_between(highest, bound, |a, b, found| {
        let (a, b) = (typed(a), typed(b));
        let together = motor.at(a.0.abs().max(b.0.abs()), a.1.abs().max(b.1.abs())).si();
        if together <= found { together } else { motor.largest([a, b]).si() }
    });
    let model = Source::Model { name: "voltage" };
    let limit = supply.si() / std::f64::consts::SQRT_2 * reserve;
    if work.is_on() {
        if worst > highest {
            let text = "upper bound of U_LL between this instant and the next";
            work.found("U", &VOLT, worst, text, &model, Grade::Computed);
        } else {
            work.formula("U", &VOLT, worst, "U_LL", &model);
        }
        work.value("U");
        let key = |key: &'static str| Source::Project { key: key.into() };
        work.figure("U_DC", &VOLT, supply.si(), &key("requirements.supply"), Grade::Printed);
        work.figure("m", &ONE, reserve, &key("requirements.modulation_reserve"), Grade::Printed);
        work.formula("U_M", &VOLT, limit, "U_DC/sqrt(2)*m", &model);
        work.limit("U_M");
    }
    Comparison {
        id,
        unit: &VOLT,
        value: worst,
        value_source: Source::Model { name: "voltage" },
        at: Some(Time::from_si(at.time)),
        limit,
        limit_source: &Source::Project { key: "requirements.supply".into() },
        grade: motor.grade.worst(currents.grade),
        errata: &[],
        notes: currents.notes(),
    }
    .answer(Verdict::Fail)
}

/// I_peak ≤ I_max, and I_peak ≤ I_E, at which demagnetisation begins.
pub(crate) fn current_checks(
    axis: &Axis,
    actuator: &Parameters,
    currents: Result<&Currents, &Missing>,
    explain: bool,
) -> [Check; 2] {
    let peak = currents.ok().map(|currents| currents.largest(axis));
    let limits = [
        (CheckId::PeakCurrent, "I_max", actuator.current_max.require("I_max")),
        (CheckId::Demagnetisation, "I_E", actuator.current_demagnetisation.require("I_E")),
    ];
    let check = |id, symbol, limit: Result<&Sourced<ElectricCurrent>, Missing>, work: &mut Workings| {
        let (limit, currents, (current, node)) = match (limit, currents, peak) {
            (Ok(limit), Ok(currents), Some(peak)) => (limit, currents, peak),
            (Err(missing), ..) => return not_checked(id, missing),
            (_, Err(missing), _) => return not_checked(id, *missing),
            _ => return not_checked(id, Missing { symbol: "J_out" }),
        };
        let source = Source::Model { name: "current" };
        currents.explain(&node, actuator, work);
        work.formula("I_peak", &AMPERE, current, "abs(I)", &source);
        work.value("I_peak");
        work.given(symbol, &AMPERE, limit);
        work.limit(symbol);
        Comparison {
            id,
            unit: &AMPERE,
            value: current,
            value_source: source,
            at: Some(Time::from_si(node.time)),
            limit: limit.value.si(),
            limit_source: &limit.source,
            grade: currents.grade.worst(limit.grade),
            errata: limit.errata,
            notes: currents.notes(),
        }
        .answer(Verdict::Fail)
    };
    limits.map(|(id, symbol, limit)| explained(explain, |work| check(id, symbol, limit, work)))
}
