//! Current, speed limits and continuous torque of the motor, seen from the output.

use crate::parameters::Parameters;
use derivation::Workings;
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{
    AMPERE, AMPERE_PER_REVOLUTION_PER_MINUTE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, OHM, ONE, REVOLUTION_PER_MINUTE,
    WATT,
};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricalResistance, Measure, NoLoadCurrentConstant, ThermodynamicTemperature,
    Torque, TorqueConstant,
};

/// w: share of the friction loss that heats the winding's limit in the estimate of the continuous curve.
///
/// Calibrated on the published corner points of CHA-20A (docs/theory/continuous-torque.md); a guess elsewhere.
pub const FRICTION_LOSS_SHARE: f64 = 0.58;

/// Winding temperature of continuous duty in the estimate: the warning threshold of table 62.3, 80 °C, in kelvin.
pub const WINDING_TEMPERATURE_CONTINUOUS: f64 = 353.15;

/// τ_w: time constant of the winding in seconds; estimated from the S3 points of CHA-20A (48 s to 70 s).
pub const WINDING_TIME_CONSTANT: f64 = 60.0;

/// Half width of the band of the estimated continuous curve at the rated speed; zero at standstill, where T_0 is printed.
const BAND_AT_RATED_SPEED: f64 = 0.15;

/// Temperature coefficient of copper at 20 °C \[1/K\] (IEC 60034-1 uses 1/(235+20) = 3.92e-3; 3.93e-3 is the handbook value).
const COPPER_TEMPERATURE_COEFFICIENT: f64 = 3.93e-3;

/// Resistance of a copper winding at a temperature.
///
/// R = R_20 (1 + 3.93e-3 (ϑ − 20 °C))
///
/// # Valid    −40 °C to 200 °C, linear law of copper
#[must_use]
pub fn copper_resistance(
    resistance_20: ElectricalResistance,
    temperature: ThermodynamicTemperature,
) -> ElectricalResistance {
    let rise = temperature.si() - 293.15;
    ElectricalResistance::from_si(resistance_20.si() * (1.0 + COPPER_TEMPERATURE_COEFFICIENT * rise))
}

/// Motor current that friction takes while the output turns.
///
/// I_f = I_NLS + K_INL |n|
///
/// # Symbols  I_NLS no-load starting current \[A\], K_INL no-load current constant [A/(1/min)] per **output** speed, n output speed [1/min]
/// # Source   cha-manual section 6, rows I_NLS and K_INL; that K_INL counts output speed follows from its growth with i
/// # Valid    while turning; at standstill friction gives at most I_NLS, and only against an outer torque
#[must_use]
pub fn friction_current(
    starting: ElectricCurrent,
    constant: NoLoadCurrentConstant,
    speed: AngularVelocity,
) -> ElectricCurrent {
    ElectricCurrent::from_si(starting.si() + constant.si() * speed.si().abs())
}

/// Motor current for a torque at the output, signed like the torque.
///
/// I = T/k_Tout + I_f σ
///
/// Friction opposes the motion (direction σ): it adds to the current while driving and helps while braking.
///
/// # Source   docs/theory/current.md; T/k_Tout + I_NLS reproduces the printed I_0 of the 680 V windings
#[must_use]
pub fn current(
    torque: Torque,
    direction: f64,
    friction: ElectricCurrent,
    torque_constant_out: TorqueConstant,
) -> ElectricCurrent {
    ElectricCurrent::from_si(torque.si() / torque_constant_out.si() + friction.si() * direction)
}

/// Largest output speed: the exact quotient n_mot,max / i, or n_max where motor speed or ratio are not known.
///
/// The printed n_max is rounded (50A with i = 120 even upwards, 30 for 29.17), therefore the quotient comes first.
///
/// # Errors
/// [`Missing`] if neither is known.
pub fn speed_max(actuator: &Parameters) -> Result<Sourced<AngularVelocity>, Missing> {
    speed_max_with(actuator, &mut Workings::off())
}

/// [`speed_max`] with its workings.
///
/// # Errors
/// As [`speed_max`].
pub fn speed_max_with(actuator: &Parameters, work: &mut Workings) -> Result<Sourced<AngularVelocity>, Missing> {
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

/// Largest mean speed at the output: n_N / i.
///
/// # Source   published corner points of CHA-20A: every continuous curve ends at n_N / i
/// # Errors
/// [`Missing`] if rated motor speed or ratio are not known.
pub fn speed_rated_out(actuator: &Parameters) -> Result<Sourced<AngularVelocity>, Missing> {
    speed_rated_out_with(actuator, &mut Workings::off())
}

/// [`speed_rated_out`] with its workings.
///
/// # Errors
/// As [`speed_rated_out`].
pub fn speed_rated_out_with(actuator: &Parameters, work: &mut Workings) -> Result<Sourced<AngularVelocity>, Missing> {
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

/// The continuous torque at a speed, and what an estimate leaves open.
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuousLimit {
    /// The limit that checks use: the published curve, or the lower edge of the estimate's band.
    pub limit: Sourced<Torque>,
    /// Upper edge of the band; equal to the limit where the curve is published.
    pub upper: Torque,
}

/// Continuous torque at a mean speed: the published or measured curve if there is one, else the estimate.
/// Neither ever exceeds the printed T_0.
///
/// # Errors
/// [`Missing`] with the first datum that neither way can do without.
pub fn continuous_torque(actuator: &Parameters, speed: AngularVelocity) -> Result<ContinuousLimit, Missing> {
    continuous_torque_with(actuator, speed, &mut Workings::off())
}

/// [`continuous_torque`] with its workings; they begin with the mean speed, `n_av`.
///
/// # Errors
/// As [`continuous_torque`].
pub fn continuous_torque_with(
    actuator: &Parameters,
    speed: AngularVelocity,
    work: &mut Workings,
) -> Result<ContinuousLimit, Missing> {
    let Some(curve) = actuator.continuous_curve.known() else {
        return estimated_continuous_torque_with(actuator, speed, work);
    };
    let mut torque = curve.value.at(speed);
    work.found("T_curve", &NEWTON_METRE, torque.si(), "continuous curve at n_av", &curve.source, curve.grade);
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

/// Estimated continuous torque at a mean speed, with its band.
///
/// 1.5 R I² + w P_f = 1.5 R I_0², T = k_Tout (I − I_f), T ≤ T_0, for |n| ≤ n_N/i
///
/// with P_f = I_f k_TM ω_mot and I_f from the 80 °C values. The loss at standstill is that of the motor
/// (the largest I_0 over the ratios), because T_0 of some ratios is limited by the gear.
/// The band is ±15 % at n_N/i and shrinks linearly to zero at standstill, where T_0 is printed; checks use its lower edge.
///
/// # Symbols  R = R_LL at 80 °C \[Ω\] (1.5 R_LL I² is the copper loss of a star winding), w = 0.58, k_TM \[Nm/A\], ω_mot [rad/s]
/// # Source   docs/theory/continuous-torque.md; calibrated on curves-20A
/// # Valid    |n| ≤ n_N/i; zero beyond
/// # Errors
/// [`Missing`] with the first datum that is not known.
pub fn estimated_continuous_torque(actuator: &Parameters, speed: AngularVelocity) -> Result<ContinuousLimit, Missing> {
    estimated_continuous_torque_with(actuator, speed, &mut Workings::off())
}

fn estimated_continuous_torque_with(
    actuator: &Parameters,
    speed: AngularVelocity,
    work: &mut Workings,
) -> Result<ContinuousLimit, Missing> {
    let stall_torque = actuator.stall_torque.require("T_0")?;
    let rated = speed_rated_out_with(actuator, work)?;
    let source = Source::Model { name: "continuous-torque" };
    let share = speed.si().abs() / rated.value.si();
    let (mut unused, beyond) = (Workings::off(), share > 1.0);
    let inside = if beyond { &mut unused } else { &mut *work };
    let thermal = thermal_torque_with(actuator, speed, 1.0, FRICTION_LOSS_SHARE, inside)?.si();
    let centre = if share > 1.0 { 0.0 } else { thermal.min(stall_torque.value.si()) };
    let band = BAND_AT_RATED_SPEED * share.min(1.0);
    let limit = centre * (1.0 - band);
    if beyond {
        let text = "n_av is above n_N_out: no continuous duty";
        work.found("T_cont", &NEWTON_METRE, limit, text, &source, Grade::Estimated);
    } else {
        work.given("T_0", &NEWTON_METRE, stall_torque);
        work.formula("band", &ONE, band, "0.15*min(abs(n_av)/n_N_out, 1)", &source);
        work.estimate("T_cont", &NEWTON_METRE, limit, "min(T_th, T_0)*(1 - band)", &source);
    }
    Ok(ContinuousLimit {
        limit: Sourced { value: Torque::from_si(limit), source, grade: Grade::Estimated, errata: stall_torque.errata },
        upper: Torque::from_si((centre * (1.0 + BAND_AT_RATED_SPEED)).min(stall_torque.value.si())),
    })
}

/// Torque at which the winding gives off a multiple of the loss of standstill; neither T_0 nor T_max counts here.
///
/// 1.5 R I² + w P_f = F · 1.5 R I_0², T = k_Tout (I − I_f), never negative; symbols and source as in
/// [`estimated_continuous_torque`], F the multiple, w the share of the friction loss
pub(crate) fn thermal_torque(
    actuator: &Parameters,
    speed: AngularVelocity,
    loss_factor: f64,
    friction_loss_share: f64,
) -> Result<Torque, Missing> {
    thermal_torque_with(actuator, speed, loss_factor, friction_loss_share, &mut Workings::off())
}

fn thermal_torque_with(
    actuator: &Parameters,
    speed: AngularVelocity,
    loss_factor: f64,
    friction_loss_share: f64,
    work: &mut Workings,
) -> Result<Torque, Missing> {
    let stall_current = match actuator.stall_current_motor.known() {
        Some(motor) => motor,
        None => actuator.stall_current.require("I_0")?,
    };
    let starting = actuator.no_load_starting_current.require("I_NLS")?;
    let constant = actuator.no_load_current_constant_80.require("K_INL")?;
    let torque_constant_out = actuator.torque_constant_out.require("k_Tout")?;
    let torque_constant_motor = actuator.torque_constant_motor.require("k_TM")?;
    let resistance = actuator.resistance_ll.require("R_LL")?;
    let ratio = actuator.ratio.require("i")?;

    let hot = copper_resistance(resistance.value, ThermodynamicTemperature::from_si(WINDING_TEMPERATURE_CONTINUOUS));
    let friction = friction_current(starting.value, constant.value, speed).si();
    let speed_motor_rad_s = speed.si().abs() * ratio.value;
    let friction_loss_w = friction * torque_constant_motor.value.si() * speed_motor_rad_s;
    let square =
        loss_factor * stall_current.value.si().powi(2) - friction_loss_share * friction_loss_w / (1.5 * hot.si());
    let counted = if actuator.stall_current_includes_friction { friction } else { friction - starting.value.si() };
    let torque = (torque_constant_out.value.si() * (square.max(0.0).sqrt() - counted)).max(0.0);
    if work.is_on() {
        let source = Source::Model { name: "continuous-torque" };
        let one = |work: &mut Workings, symbol, value| work.figure(symbol, &ONE, value, &source, Grade::Estimated);
        work.given("I_0", &AMPERE, stall_current);
        work.given("I_NLS", &AMPERE, starting);
        work.given("K_INL", &AMPERE_PER_REVOLUTION_PER_MINUTE, constant);
        work.given("k_Tout", &NEWTON_METRE_PER_AMPERE, torque_constant_out);
        work.given("k_TM", &NEWTON_METRE_PER_AMPERE, torque_constant_motor);
        work.given("R_LL", &OHM, resistance);
        work.given_number("i", ratio);
        one(work, "F", loss_factor);
        one(work, "w", friction_loss_share);
        work.formula("R_hot", &OHM, hot.si(), "R_LL*(1 + 3.93e-3*(80 - 20))", &source);
        work.formula("I_f", &AMPERE, friction, "I_NLS + K_INL*abs(n_av)", &source);
        work.formula("P_f", &WATT, friction_loss_w, "I_f*k_TM*i*abs(n_av)*2*pi/60", &source);
        let current = square.max(0.0).sqrt();
        work.estimate("I_th", &AMPERE, current, "sqrt(max(F*I_0^2 - w*P_f/(1.5*R_hot), 0))", &source);
        let text = if actuator.stall_current_includes_friction {
            "max(k_Tout*(I_th - I_f), 0)"
        } else {
            "max(k_Tout*(I_th - I_f + I_NLS), 0)"
        };
        work.estimate("T_th", &NEWTON_METRE, torque, text, &source);
    }
    Ok(Torque::from_si(torque))
}

#[cfg(test)]
#[path = "motor_tests.rs"]
mod tests;
