//! Checks of the motor that look at every instant: torque-speed trace, temperature, overload.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Figure, Note, Verdict};
use crate::comparison::{Comparison, explained, not_checked};
use crate::currents::Currents;
use crate::trace::{Block, Node};
use crate::workings;
use actuator::{FRICTION_LOSS_SHARE, Parameters, Thermal, WINDING_TEMPERATURE_CONTINUOUS, WINDING_TIME_CONSTANT};
use derivation::Workings;
use provenance::{CellRef, Grade, Missing, Source};
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, KELVIN_DIFFERENCE, NEWTON_METRE, ONE, REVOLUTION_PER_MINUTE, SECOND, VOLT, WATT,
};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, Measure, Power, Ratio, ThermodynamicTemperature, Time,
};
use std::borrow::Cow;

/// Shutdown threshold of the winding, table 62.3: 90 °C, in kelvin.
const WINDING_SHUTDOWN: f64 = 363.15;

/// The ambient temperature up to which the printed data hold, 40 °C, in kelvin: assumed where none is stated.
pub(crate) const AMBIENT_REFERENCE: f64 = 313.15;

/// A hundredth of τ_w \[s\]: over blocks not longer than this the mean loss stands for its course. What the temperature
/// of the winding swings within a block is left out, at most a hundredth of what the peak loss would make it rise to.
const SHORT_BLOCK: f64 = 0.01 * WINDING_TIME_CONSTANT;

/// Picks ω out of (α, T_L, σ, ω).
pub(crate) const SPEED: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

/// The checks that look at every instant and have a limit in any case.
pub(crate) fn judge(
    axis: &Axis,
    actuator: &Parameters,
    currents: Result<&Currents, &Missing>,
    explain: bool,
    checks: &mut Vec<Check>,
) {
    checks.push(explained(explain, |work| torque_speed_trace(axis, actuator, work)));
    checks.push(explained(explain, |work| thermal(axis, actuator, currents, work)));
    checks.push(explained(explain, |work| overload(axis, actuator, currents, work)));
}

/// U_DC ≤ U_DCmax, the largest *stationary* voltage. What energy that comes back adds may pass it for a short time while
/// braking (glossary of the manual), nobody says how far and how long: with the rise that the project permits above
/// U_DCmax the answer is advice.
pub(crate) fn dc_link(
    supply: ElectricPotential,
    rise: Option<ElectricPotential>,
    actuator: &Parameters,
    work: &mut Workings,
) -> Check {
    let id = CheckId::DcLink;
    let limit = match actuator.dc_link_max.require("U_DCmax") {
        Ok(limit) => limit,
        Err(missing) => return not_checked(id, missing),
    };
    let source = Source::Project { key: "requirements.supply".into() };
    work.figure("U_DC", &VOLT, supply.si(), &source, Grade::Printed);
    // A supply that is too high is the fault, whatever comes on top of it.
    let top =
        rise.map(|rise| supply + rise).filter(|top| supply.si() <= limit.value.si() && top.si() > limit.value.si());
    let check = match (top, rise) {
        (Some(top), Some(rise)) => {
            let asked = Source::Project { key: "requirements.dc_link_rise".into() };
            work.figure("dU", &VOLT, rise.si(), &asked, Grade::Printed);
            work.formula("U_top", &VOLT, top.si(), "U_DC + dU", &asked);
            work.value("U_top");
            let free = limit.value - supply;
            let notes = Cow::Owned(vec![Note::DcLinkRises { to: top, free }]);
            Comparison { notes, ..Comparison::with(id, &VOLT, top.si(), asked, limit) }.answer(Verdict::Advice)
        }
        _ => {
            work.value("U_DC");
            Comparison::with(id, &VOLT, supply.si(), source, limit).answer(Verdict::Fail)
        }
    };
    work.given("U_DCmax", &VOLT, limit);
    work.limit("U_DCmax");
    check
}

/// |T| ≤ short-time torque at the speed of every instant; while braking the voltage helps, and T_max is the limit.
fn torque_speed_trace(axis: &Axis, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::TorqueSpeedTrace;
    let terminal = axis.terminal_voltage();
    let limit = |speed: f64| actuator::short_time_torque(actuator, AngularVelocity::from_si(speed), terminal);
    let found = (|| {
        let inertia = actuator.inertia_out.require("J_out")?.value.si();
        let highest = actuator.torque_max.require("T_max")?.value.si();
        limit(0.0)?;
        Ok((inertia, highest))
    })();
    let (inertia, highest) = match found {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let torque = |node: &Node| inertia * node.acceleration + node.load;
    // Neighbouring instants often share their speed.
    let last = std::cell::Cell::new((0.0, limit(0.0).map_or(0.0, |limit| limit.value.si())));
    let at_speed = |speed: f64| {
        let (known, torque) = last.get();
        if known == speed.abs() {
            return torque;
        }
        let torque = limit(speed).map_or(0.0, |limit| limit.value.si());
        last.set((speed.abs(), torque));
        torque
    };
    let share = |torque: f64, limit: f64| {
        if torque == 0.0 {
            0.0
        } else if limit > 0.0 {
            torque.abs() / limit
        } else {
            f64::MAX
        }
    };
    let (_, worst) = axis.trace.largest(
        |extent| share(extent.torque(inertia), at_speed(extent.speed)),
        |node| {
            let torque = torque(node);
            share(torque, if torque * node.direction < 0.0 { highest } else { at_speed(node.speed) })
        },
    );
    let braking = torque(&worst) * worst.direction < 0.0;
    if work.is_on() {
        workings::torque_at(&worst, actuator, work);
        work.formula("T_at", &NEWTON_METRE, torque(&worst).abs(), "abs(T)", &workings::DEMAND);
        work.value("T_at");
    }
    let speed = AngularVelocity::from_si(worst.speed);
    let found = if braking {
        actuator.torque_max.require("T_max").inspect(|limit| work.given("T_max", &NEWTON_METRE, limit)).cloned()
    } else {
        let source = &workings::DEMAND;
        work.found("n", &REVOLUTION_PER_MINUTE, worst.speed, "speed at t", source, Grade::Computed);
        actuator::short_time_torque_with(actuator, speed, terminal, work)
    };
    let curve = match found {
        Ok(curve) => curve,
        Err(missing) => return not_checked(id, missing),
    };
    work.limit(if braking { "T_max" } else { "T_short" });
    Comparison {
        at: Some(Time::from_si(worst.time)),
        ..Comparison::with(id, &NEWTON_METRE, torque(&worst).abs(), Source::Model { name: "demand" }, &curve)
    }
    .answer(Verdict::Fail)
}

/// Current and loss at every instant, for the models of heat.
pub(crate) struct Losses<'a> {
    currents: &'a Currents,
    /// R_LL at 80 °C, 1.5 times: copper loss per square of the current \[Ω\].
    copper_ohm: f64,
    /// w k_TM i: share of the friction loss per friction current and output speed [V/(rad/s)].
    friction_vs: f64,
}

impl Losses<'_> {
    /// 1.5 R I² + w I_f k_TM ω_mot
    pub(crate) fn at(&self, node: &Node) -> f64 {
        let current = self.currents.at(node);
        self.copper_ohm * current * current + self.friction_vs * self.currents.friction(node) * node.speed.abs()
    }

    /// Its integral over a block at once, where friction has one sign there.
    fn whole(&self, block: &Block) -> Option<f64> {
        let sign = block.extent.power_sign(self.currents.inertia)?;
        let copper = self.copper_ohm * block.gram.square(self.currents.weights(sign));
        // I_f |ω| = (I_NLS σ + K_INL ω) ω
        Some(copper + self.friction_vs * block.gram.product(self.currents.friction_weights(), SPEED))
    }
}

pub(crate) fn losses<'a>(
    actuator: &Parameters,
    currents: Result<&'a Currents, &Missing>,
) -> Result<Losses<'a>, Missing> {
    let currents = currents.map_err(|missing| *missing)?;
    let resistance = actuator.resistance_ll.require("R_LL")?;
    let torque_constant = actuator.torque_constant_motor.require("k_TM")?;
    let ratio = actuator.ratio.require("i")?;
    Ok(Losses {
        currents,
        copper_ohm: actuator::copper_loss(resistance.value, ElectricCurrent::from_si(1.0)).si(),
        friction_vs: FRICTION_LOSS_SHARE * torque_constant.value.si() * ratio.value,
    })
}

/// ϑ_w ≤ 80 °C in the steady cycle: above it the warning threshold is passed, above 90 °C the drive switches off.
fn thermal(axis: &Axis, actuator: &Parameters, currents: Result<&Currents, &Missing>, work: &mut Workings) -> Check {
    let id = CheckId::Thermal;
    let (losses, model) = match losses(actuator, currents).and_then(|l| Ok((l, Thermal::of(actuator)?))) {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let ambient = axis.ambient.unwrap_or_else(|| ThermodynamicTemperature::from_si(AMBIENT_REFERENCE));
    let steps = axis.trace.steps(SHORT_BLOCK, |block| losses.whole(block), |node| losses.at(node));
    let pieces: Vec<(Time, Power)> =
        steps.iter().map(|step| (Time::from_si(step.duration), Power::from_si(step.value))).collect();
    let cycle = model.cycle(&pieces, ambient);
    let energy: f64 = pieces.iter().map(|(time, power)| time.si() * power.si()).sum();
    let mean = Power::from_si(energy / axis.moments.duration.si());
    let limit = ThermodynamicTemperature::from_si(WINDING_TEMPERATURE_CONTINUOUS);
    let hottest = cycle.winding_max.si();
    let verdict = if hottest <= limit.si() {
        Verdict::Pass
    } else if hottest <= WINDING_SHUTDOWN {
        Verdict::Advice
    } else {
        Verdict::Fail
    };
    let room = limit.si() - ambient.si();
    if work.is_on() {
        let source = Thermal::SOURCE;
        let key = Source::Project { key: "requirements.ambient".into() };
        let grade = if axis.ambient.is_some() { Grade::Printed } else { Grade::Assumed };
        work.figure("theta_a", &DEGREE_CELSIUS, ambient.si(), &key, grade);
        model.explain(actuator, work);
        let text = "mean of 1.5 R_hot I² + w I_f k_TM ω_mot over the cycle";
        work.found("P_mean", &WATT, mean.si(), text, &source, Grade::Estimated);
        let steady = model.steady(mean, ambient).winding.si();
        work.estimate("theta_m", &DEGREE_CELSIUS, steady, "theta_a + 40*P_mean/P_0", &source);
        let text = "largest rise of the winding above its mean, τ_w = 60 s, τ_h = 2400 s";
        work.found("dtheta", &KELVIN_DIFFERENCE, hottest - steady, text, &source, Grade::Estimated);
        work.estimate("theta_w", &DEGREE_CELSIUS, hottest, "theta_m + dtheta", &source);
        work.value("theta_w");
        const THRESHOLD: CellRef = CellRef::of_the_manual("62.3", "T_KTY", "");
        work.figure("theta_warn", &DEGREE_CELSIUS, limit.si(), &Source::Cell(&THRESHOLD), Grade::Printed);
        work.limit("theta_warn");
    }
    Check {
        id,
        verdict,
        value: Some(Figure { si: hottest, unit: &DEGREE_CELSIUS }),
        limit: Some(Figure { si: limit.si(), unit: &DEGREE_CELSIUS }),
        // Only beyond the shutdown threshold the estimate speaks against the actuator.
        utilisation: (room > 0.0).then(|| (hottest - ambient.si()) / room),
        at: Some(cycle.at),
        grade: Some(Thermal::GRADE),
        value_source: Some(Thermal::SOURCE),
        limit_source: Some(Source::Model { name: "thermal" }),
        missing: None,
        notes: Cow::Owned(vec![Note::Housing(cycle.housing), Note::WarmUp(model.warm_up_time(mean, ambient, limit))]),
        workings: Vec::new(),
    }
}

/// The first-order mean of (I/I_0)² with τ_w stays below one: what a drive's I²t supervision looks at.
fn overload(axis: &Axis, actuator: &Parameters, currents: Result<&Currents, &Missing>, work: &mut Workings) -> Check {
    let id = CheckId::OverloadI2t;
    let (currents, stall) = match currents.map_err(|m| *m).and_then(|c| Ok((c, actuator.stall_current.require("I_0")?)))
    {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let stalled = stall.value.si() * stall.value.si();
    let square = |block: &Block| {
        let sign = block.extent.power_sign(currents.inertia)?;
        Some(block.gram.square(currents.weights(sign)) / stalled)
    };
    let steps = axis.trace.steps(SHORT_BLOCK, square, |node| currents.at(node).powi(2) / stalled);
    let pieces: Vec<(Time, Ratio)> =
        steps.iter().map(|step| (Time::from_si(step.duration), Ratio::from_si(step.value))).collect();
    let (peak, at) = actuator::overload_peak(&pieces, Time::from_si(WINDING_TIME_CONSTANT));
    let source = Source::Model { name: "overload" };
    work.given("I_0", &AMPERE, stall);
    work.figure("tau_w", &SECOND, WINDING_TIME_CONSTANT, &source, Grade::Estimated);
    let text = "largest of the first-order lag of (I/I_0)² with tau_w in the steady cycle";
    work.found("y", &ONE, peak.si(), text, &source, Grade::Estimated);
    work.value("y");
    work.figure("y_trip", &ONE, 1.0, &source, Grade::Computed);
    work.limit("y_trip");
    let one = provenance::Sourced {
        value: Ratio::from_si(1.0),
        source: stall.source.clone(),
        grade: Grade::Estimated,
        errata: stall.errata,
    };
    Comparison { at: Some(at), ..Comparison::with(id, &ONE, peak.si(), Source::Model { name: "overload" }, &one) }
        .answer(Verdict::Fail)
}
