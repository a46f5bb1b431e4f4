//! Current, speed limits and continuous torque of the motor, referred to the output.

use crate::copper::copper_resistance;
use crate::heat_model::{HeatModel, Settled};
use crate::parameters::Drivetrain;
use derivation::{Finding, Workings};
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{
    AMPERE, AMPERE_PER_REVOLUTION_PER_MINUTE, DEGREE_CELSIUS, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, OHM, ONE,
    REVOLUTION_PER_MINUTE, WATT,
};
use quantities::{AngularVelocity, Measure, NoLoadCurrentConstant, Time, Torque};

/// Returns the largest output speed: the exact quotient n_mot,max / i, or n_max if motor speed or ratio are unknown.
///
/// The n_max of the tables is rounded (50A with i = 120 even upwards, 30 for 29.17), therefore the quotient takes
/// precedence.
///
/// # Errors
/// [`Missing`] if both are unknown.
pub fn speed_max(actuator: &Drivetrain) -> Result<Sourced<AngularVelocity>, Missing> {
    speed_max_with(actuator, &mut Workings::off())
}

/// Returns [`speed_max`] with its derivation.
///
/// # Errors
/// See [`speed_max`].
pub fn speed_max_with(actuator: &Drivetrain, work: &mut Workings) -> Result<Sourced<AngularVelocity>, Missing> {
    match (actuator.speed_motor_max.known(), actuator.ratio.known()) {
        (Some(motor), Some(ratio)) => {
            let speed = motor.value.si() / ratio.value;
            work.given("n_mot_max", &REVOLUTION_PER_MINUTE, motor);
            work.given_number("i", ratio);
            work.formula("n_max", &REVOLUTION_PER_MINUTE, speed, "n_mot_max/i", &motor.source);
            Ok(Sourced {
                value: AngularVelocity::from_si(speed),
                source: motor.source.clone(),
                grade: motor.grade.worst(Grade::Computed),
                errata: motor.errata,
            })
        }
        _ => {
            let printed = actuator.speed_max.require("n_max")?;
            work.given("n_max", &REVOLUTION_PER_MINUTE, printed);
            Ok(printed.clone())
        }
    }
}

/// Returns the largest mean speed at the output, n_N / i.
///
/// # Source
/// published corner points of CHA-20A: all continuous curves end at n_N / i
/// # Errors
/// [`Missing`] if rated motor speed or ratio are unknown.
pub fn speed_rated_out(actuator: &Drivetrain) -> Result<Sourced<AngularVelocity>, Missing> {
    speed_rated_out_with(actuator, &mut Workings::off())
}

/// Returns [`speed_rated_out`] with its derivation.
///
/// # Errors
/// See [`speed_rated_out`].
pub fn speed_rated_out_with(actuator: &Drivetrain, work: &mut Workings) -> Result<Sourced<AngularVelocity>, Missing> {
    let motor = actuator.speed_motor_rated.require("n_N")?;
    let ratio = actuator.ratio.require("i")?;
    let speed = motor.value.si() / ratio.value;
    work.given("n_N", &REVOLUTION_PER_MINUTE, motor);
    work.given_number("i", ratio);
    work.formula("n_N_out", &REVOLUTION_PER_MINUTE, speed, "n_N/i", &motor.source);
    Ok(Sourced {
        value: AngularVelocity::from_si(speed),
        source: motor.source.clone(),
        grade: motor.grade.worst(ratio.grade).worst(Grade::Computed),
        errata: motor.errata,
    })
}

/// Continuous torque at a speed, with the uncertainty of an estimate.
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuousLimit {
    /// Torque certainly permitted: the published curve, or the lower edge of the estimate's band.
    pub limit: Sourced<Torque>,
    /// Torque above which operation is certainly not permitted: upper edge of the band; equal to the limit if the curve
    /// is published.
    pub upper: Torque,
}

/// Returns the continuous torque at a mean speed: from the published or measured curve if there is one, else from the
/// estimate. Both are limited by the T_0 of the tables. Beyond n_N/i, where no mean speed is permitted, the value at
/// n_N/i is returned.
///
/// # Errors
/// [`Missing`] with the first unknown datum that both ways need.
pub fn continuous_torque(actuator: &Drivetrain, speed: AngularVelocity) -> Result<ContinuousLimit, Missing> {
    continuous_torque_with(actuator, None, speed, &mut Workings::off())
}

/// Returns [`continuous_torque`] with its derivation; `model` is the heat model of the actuator, if already available.
///
/// # Errors
/// See [`continuous_torque`].
pub fn continuous_torque_with(
    actuator: &Drivetrain,
    model: Option<&HeatModel>,
    speed: AngularVelocity,
    work: &mut Workings,
) -> Result<ContinuousLimit, Missing> {
    let Some(curve) = actuator.continuous_curve.known() else {
        actuator.stall_torque.require("T_0")?;
        return match model {
            Some(model) => estimated_continuous_torque_with(actuator, model, speed, work),
            None => estimated_continuous_torque_with(actuator, &HeatModel::of(actuator)?, speed, work),
        };
    };
    let mut torque = curve.value.at_most_to_its_end(speed);
    work.found("T_curve", &NEWTON_METRE, torque.si(), Finding::ContinuousCurve, &curve.source, curve.grade);
    if let Some(stall) = actuator.stall_torque.known() {
        torque = Torque::from_si(torque.si().min(stall.value.si()));
        work.given("T_0", &NEWTON_METRE, stall);
        work.formula("T_cont", &NEWTON_METRE, torque.si(), "min(T_curve, T_0)", &curve.source);
    } else {
        work.formula("T_cont", &NEWTON_METRE, torque.si(), "T_curve", &curve.source);
    }
    Ok(ContinuousLimit {
        limit: Sourced { value: torque, source: curve.source.clone(), grade: curve.grade, errata: curve.errata },
        upper: torque,
    })
}

/// Estimates the continuous torque at a mean speed, with its band.
///
/// T at which P_cu + w P_f = b P_0, T ≤ T_0; b the edges of the band, see [`HeatModel::band`] and [`HeatModel::torque`]
///
/// # Symbols
/// P_cu copper loss, P_f friction loss, P_0 permitted loss at standstill \[W\], w share of the housing
/// # Source
/// docs/theory/continuous-torque.md; calibrated on curves-20A, compared with fha-orientation
/// # Valid
/// |n| ≤ n_N/i, at the highest permitted ambient temperature, on the plate of the manual; beyond n_N/i the value at
/// n_N/i
/// # Errors
/// [`Missing`] with the first unknown datum.
pub fn estimated_continuous_torque(actuator: &Drivetrain, speed: AngularVelocity) -> Result<ContinuousLimit, Missing> {
    estimated_continuous_torque_with(actuator, &HeatModel::of(actuator)?, speed, &mut Workings::off())
}

/// Continuous duty as an intermittent one without rest, for which the cycle has no influence.
const ALWAYS: (f64, f64) = (1.0, 60.0);

fn estimated_continuous_torque_with(
    actuator: &Drivetrain,
    model: &HeatModel,
    speed: AngularVelocity,
    work: &mut Workings,
) -> Result<ContinuousLimit, Missing> {
    let stall_torque = actuator.stall_torque.require("T_0")?;
    let rated = speed_rated_out_with(actuator, work)?.value.si();
    let speed = AngularVelocity::from_si(speed.si().abs().min(rated));
    let (low, high) = model.band(speed);
    let (duty, cycle) = ALWAYS;
    let torque = |edge: f64| model.torque(speed, duty, Time::from_si(cycle), edge);
    let source = Source::Model { name: "continuous-torque" };
    let (thermal, settled) = torque(low);
    let limit = thermal.si().min(stall_torque.value.si());
    if work.is_on() {
        explain_continuous(actuator, model, (speed, low), &settled, work);
        work.estimate("T_th", &NEWTON_METRE, thermal.si(), "max(k_Tout*(I_th - I_f), 0)", &source);
        work.given("T_0", &NEWTON_METRE, stall_torque);
        work.estimate("T_cont", &NEWTON_METRE, limit, "min(T_th, T_0)", &source);
    }
    Ok(ContinuousLimit {
        limit: Sourced { value: Torque::from_si(limit), source, grade: Grade::Estimated, errata: stall_torque.errata },
        upper: if limit < stall_torque.value.si() {
            Torque::from_si(torque(high).0.si().min(stall_torque.value.si()).max(limit))
        } else {
            stall_torque.value
        },
    })
}

/// Records the derivation of the thermally permitted current at a speed, `I_th`, and of the friction current, `I_f`.
fn explain_continuous(
    actuator: &Drivetrain,
    model: &HeatModel,
    (speed, edge): (AngularVelocity, f64),
    settled: &Settled,
    work: &mut Workings,
) {
    let source = Source::Model { name: "continuous-torque" };
    explain_stall_loss(actuator, work);
    let heat = &actuator.heat;
    if let (Some(share), Some(constant), Some(motor)) =
        (heat.housing_share.known(), actuator.torque_constant_out.known(), actuator.torque_constant_motor.known())
    {
        work.given_number("w", share);
        work.given("k_Tout", &NEWTON_METRE_PER_AMPERE, constant);
        work.given("k_TM", &NEWTON_METRE_PER_AMPERE, motor);
    }
    work.known_number("i", &actuator.ratio);
    let what = Finding::EdgeOfBand;
    work.found("b", &ONE, edge, what, &source, Grade::Estimated);
    work.found("n", &REVOLUTION_PER_MINUTE, speed.si(), Finding::MeanSpeedUpToRated, &source, Grade::Computed);
    explain_friction(actuator, settled, work);
    let friction = settled.friction.current(speed).si();
    let text = if actuator.stall_current_includes_friction { "I_NLS + K*abs(n)" } else { "K*abs(n)" };
    work.formula("I_f", &AMPERE, friction, text, &source);
    let text = "(I_NLS + K*abs(n))*k_TM*i*abs(n)*2*pi/60";
    work.formula("P_f", &WATT, settled.losses.friction_w, text, &source);
    let current = (settled.losses.copper_w / model.losses().copper_ohm()).sqrt();
    work.estimate("I_th", &AMPERE, current, "sqrt(max(b*P_0 - w*P_f, 0)/(1.5*R_hot))", &source);
}

/// Records the derivation of the permitted loss of the winding at standstill, `P_0`.
pub fn explain_stall_loss(actuator: &Drivetrain, work: &mut Workings) {
    let current = actuator.stall_current_motor.known().or_else(|| actuator.stall_current.known());
    let resistance = actuator.resistance_ll.known();
    let factor = actuator.heat.stall_loss_factor.known();
    let (Some(current), Some(resistance), Some(factor), Some(limit), true) =
        (current, resistance, factor, actuator.heat.winding_warning.known(), work.is_on())
    else {
        return;
    };
    let source = Source::Model { name: "thermal" };
    let hot = copper_resistance(resistance.value, limit.value);
    work.given("I_0", &AMPERE, current);
    work.given("R_LL", &OHM, resistance);
    work.given_number("F", factor);
    work.given("theta_warn", &DEGREE_CELSIUS, limit);
    work.formula("R_hot", &OHM, hot.si(), "R_LL*(1 + 3.93e-3*(theta_warn - 20))", &source);
    let loss = factor.value * 1.5 * hot.si() * current.value.si().powi(2);
    work.formula("P_0", &WATT, loss, "F*1.5*R_hot*I_0^2", &source);
}

/// Records the derivation of the friction at the temperature of the housing, `K`.
pub fn explain_friction(actuator: &Drivetrain, settled: &Settled, work: &mut Workings) {
    let source = Source::Model { name: "current" };
    let (starting, cold) = (actuator.no_load_starting_current.known(), actuator.no_load_current_constant_cold.known());
    let (temperatures, from) = (actuator.no_load_temperatures.known(), actuator.friction_printed_from.known());
    let (Some(starting), Some(cold), Some(temperatures), Some(from)) = (starting, cold, temperatures, from) else {
        return;
    };
    if !work.is_on() {
        return;
    }
    let friction = &settled.friction;
    let what = Finding::GearAsHousing;
    work.found("theta_h", &DEGREE_CELSIUS, friction.temperature.si(), what, &source, Grade::Estimated);
    let warm = actuator.no_load_current_constant_warm.known();
    let is_extrapolated = friction.temperature.si() < from.value.si();
    let symbol = if warm.is_some() && is_extrapolated { "I_p" } else { "I_NLS" };
    work.given(symbol, &AMPERE, starting);
    work.given("K_cold", &AMPERE_PER_REVOLUTION_PER_MINUTE, cold);
    let constant = friction.constant.si();
    let Some(warm) = warm else {
        return work.formula("K", &AMPERE_PER_REVOLUTION_PER_MINUTE, constant, "K_cold", &source);
    };
    work.given("K_warm", &AMPERE_PER_REVOLUTION_PER_MINUTE, warm);
    // Each temperature is cited with the constant to which it applies.
    let [at_cold, at_warm] = temperatures.value;
    let cited = |value, by: &Sourced<NoLoadCurrentConstant>| Sourced {
        value,
        source: by.source.clone(),
        grade: by.grade,
        errata: &[],
    };
    work.given("theta_cold", &DEGREE_CELSIUS, &cited(at_cold, cold));
    work.given("theta_warm", &DEGREE_CELSIUS, &cited(at_warm, warm));
    let text = "K_cold*(K_warm/K_cold)^((min(theta_h, theta_warm) - theta_cold)/(theta_warm - theta_cold))";
    work.formula("K", &AMPERE_PER_REVOLUTION_PER_MINUTE, constant, text, &source);
    if is_extrapolated {
        work.given("theta_p", &DEGREE_CELSIUS, from);
        let text = "I_p*(K_cold/K_warm)^((theta_p - theta_h)/(theta_warm - theta_cold))";
        work.formula("I_NLS", &AMPERE, friction.starting.si(), text, &source);
    }
}

#[cfg(test)]
#[path = "motor_tests.rs"]
mod tests;
