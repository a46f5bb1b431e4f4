//! Steady states are the formulas of the sizing.

use super::{NOTHING, load, one_move, parameters, replaced};
use actuator::{MotorCurrent, MotorVoltage, NoLoadFriction, OperatingPoint, emergency_stop};
use mechanism::{Friction, Mechanism};
use quantities::unit::{AMPERE, REVOLUTION_PER_MINUTE};
use quantities::{
    AngularVelocity, ElectricCurrent, Measure, MomentOfInertia, ThermodynamicTemperature, Time, Torque, ViscousFriction,
};
use twin::{EventKind, Reaction, Scenario, ScenarioId, Setup, Supply, Switches, Twin};

/// Means of i_q/√2 and U_LL at a constant speed under a load torque, the gear at 30 °C.
fn running(code: &str, rpm: f64, torque: f64) -> (f64, f64) {
    let mut parameters = parameters(code);
    replaced(&mut parameters.actuator.heat.housing_time_constant, 1e12);
    replaced(&mut parameters.actuator.heat.winding_time_constant, 1e12);
    let mechanism =
        Mechanism { friction: Friction { external: Torque::from_si(torque), ..Friction::none() }, ..load(1.0, 0.0) };
    let (motion, extras) = (one_move(rpm, 0.3, 1.4, 0.1), NOTHING());
    let switches = Switches { hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let setup = Setup { switches, start_k: Some([303.15; 2]), ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    twin.advance(20_000);
    let (mut current, mut voltage, mut count) = (0.0, 0.0, 0.0);
    while twin.time_s() < 1.65 {
        twin.advance(1);
        let now = twin.sample();
        current += now.current_q_a / std::f64::consts::SQRT_2;
        voltage += (1.5 * (now.voltage_d_v.powi(2) + now.voltage_q_v.powi(2))).sqrt();
        count += 1.0;
    }
    (current / count, voltage / count)
}

/// I = T/k_Tout + I_NLS + K n and U of the voltage model, at 30 °C; of no load to the printed digits: 0.49 A + 4.1 mA min.
#[test]
fn current_and_voltage_of_a_constant_speed_are_those_of_the_sizing() {
    let code = "CHA-20A-100-H-C1024";
    let parameters = parameters(code);
    let actuator = &parameters.actuator;
    let (speed, cold) =
        (AngularVelocity::new_in(25.0, &REVOLUTION_PER_MINUTE), ThermodynamicTemperature::from_si(303.15));
    let friction = NoLoadFriction::of(actuator).unwrap().at(cold);
    for torque in [0.0, 12.0, 30.0] {
        let point = OperatingPoint { torque_nm: torque, speed_rad_s: speed.si(), direction: 1.0 };
        let wanted = MotorCurrent::of(actuator).unwrap().at(&point, &friction);
        let (current, voltage) = running(code, 25.0, torque);
        assert!((current / wanted - 1.0).abs() < 5e-4, "{torque}: {current} {wanted}");
        let volts =
            MotorVoltage::with_winding(actuator, cold).unwrap().at(speed, ElectricCurrent::from_si(wanted)).si();
        assert!((voltage / volts - 1.0).abs() < 5e-4, "{torque}: {voltage} {volts}");
    }
    // Table 26.1: I_NLS and K_INL at 30 degC of ratio 100.
    let (idle, _) = running(code, 25.0, 0.0);
    let starting = actuator.no_load_starting_current.known().unwrap().value.in_unit(&AMPERE);
    let constant = actuator.no_load_current_constant_cold.known().unwrap().value.si() * std::f64::consts::TAU / 60.0;
    assert!((idle - (starting + 25.0 * constant)).abs() < 5e-4, "{idle} {starting} {constant}");
}

/// The current at T_0 is I_0 for a winding whose k_Tout includes the friction.
#[test]
fn at_the_stall_torque_the_windings_of_48_volt_take_the_stall_current() {
    let parameters = parameters("CHA-14A-100-E-RES");
    let actuator = &parameters.actuator;
    let (torque, current) =
        (actuator.stall_torque.known().unwrap().value.si(), actuator.stall_current.known().unwrap().value.si());
    let mechanism =
        Mechanism { friction: Friction { external: Torque::from_si(torque), ..Friction::none() }, ..load(0.1, 0.0) };
    let mut parameters = parameters.clone();
    replaced(&mut parameters.actuator.no_load_current_constant_cold, 1e-9);
    replaced(&mut parameters.actuator.no_load_current_constant_warm, 1e-9);
    replaced(&mut parameters.actuator.heat.winding_time_constant, 1e12);
    replaced(&mut parameters.actuator.heat.housing_time_constant, 1e12);
    let (motion, extras) = (one_move(2.0, 0.2, 1.4, 0.1), NOTHING());
    let switches = Switches { hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let setup = Setup {
        switches,
        supply: Supply::of(48.0),
        start_k: Some([303.15; 2]),
        ..Setup::of(&parameters, &mechanism, &motion, &extras)
    };
    let mut twin = Twin::new(&setup).unwrap();
    while twin.time_s() < 1.5 {
        twin.advance(1);
    }
    let found = twin.sample().current_q_a / std::f64::consts::SQRT_2;
    assert!((found / current - 1.0).abs() < 1e-3, "{found} {current}");
}

/// Without friction the brake stops the axis as eq. of docs/theory/brake.md: time, angle and heat; its delay is the printed one.
#[test]
fn a_stop_by_the_brake_is_that_of_the_sizing() {
    let mut parameters = parameters("CHA-20A-100-H-C1024-B");
    parameters.model.gear_damping_ratio.value = 0.3;
    let (mechanism, motion, extras) = (load(1.3, 0.0), one_move(30.0, 0.3, 0.5, 0.1), NOTHING());
    let switches =
        Switches { friction: false, hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let scenario = Scenario { id: ScenarioId::PowerFailure, at_s: Some(0.6), ..Scenario::default() };
    let setup = Setup { switches, scenario, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    twin.advance(u64::MAX);
    let brake = &parameters.actuator.brake;
    let (holding, closing) = (brake.holding_torque.known().unwrap().value, brake.closing_time.known().unwrap().value);
    let total = MomentOfInertia::from_si(1.3 + parameters.actuator.inertia_out.known().unwrap().value.si());
    let speed = AngularVelocity::new_in(30.0, &REVOLUTION_PER_MINUTE);
    let actuator::StopOutcome::Stops(stop) = emergency_stop(total, speed, holding, Torque::from_si(0.0), closing)
    else {
        panic!("does not stop")
    };
    let summary = twin.summary();
    let when = |kind| twin.events().iter().find(|event| event.kind == kind).map(|event| event.time_s);
    assert!((when(EventKind::BrakeClosedMoving).unwrap() - 0.6 - closing.si()).abs() < 6e-4, "{:?}", twin.events());
    assert!(
        (summary.energies.brake_j / stop.energy.si() - 1.0).abs() < 0.03,
        "{} {:?}",
        summary.energies.brake_j,
        stop
    );
    assert!((summary.stop_rad.unwrap() / stop.angle.si() - 1.0).abs() < 0.02, "{:?} {stop:?}", summary.stop_rad);
    assert_eq!(summary.brake_closings, [0, 1]);
}

/// A constant k = I/I_0 from cold trips after τ ln(k²/(k² − 1)); held by a clamped load.
#[test]
fn the_overload_supervision_trips_at_its_time() {
    let mut parameters = parameters("CHA-20A-100-H-C1024");
    let stall = parameters.actuator.stall_current.known().unwrap().value.si();
    // A winding that trips within a second, and stays cold.
    replaced(&mut parameters.actuator.heat.winding_time_constant, 0.5);
    replaced(&mut parameters.actuator.heat.housing_time_constant, 1e12);
    replaced(&mut parameters.actuator.heat.winding_shutdown, 1e6);
    let torque = Torque::from_si(1.4 * stall * parameters.actuator.torque_constant_out.known().unwrap().value.si());
    let mechanism = Mechanism { friction: Friction { external: torque, ..Friction::none() }, ..load(1.3, 0.0) };
    let motion = motion::Motion::new(
        &[motion::SegmentSpec::Dwell(Time::from_si(2.0), motion::Hold::Motor)],
        None,
        motion::Closing::SingleMove,
    )
    .unwrap();
    let switches =
        Switches { friction: false, hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let extras = NOTHING();
    let scenario = Scenario { reaction: Reaction::Coast, ..Scenario::default() };
    let setup = Setup { switches, scenario, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    let current = twin.sample().current_q_a / std::f64::consts::SQRT_2;
    twin.advance(u64::MAX);
    let square = (current / stall).powi(2);
    let wanted = 0.5 * (square / (square - 1.0)).ln();
    let tripped = twin.events().iter().find(|event| event.kind == EventKind::Overload).unwrap().time_s;
    assert!((tripped - wanted).abs() < 2e-3, "{tripped} {wanted}");
}

/// If no connector has contacts for the KTY, the PTC protects the winding: without a lag it responds when the winding
/// passes T_NAT, with a lag L when W_0 exp(−t/L) + ∫ W(s) exp(−(t − s)/L) ds/L does. A clamped load holds the axis on a
/// hot housing.
#[test]
fn the_ptc_responds_where_no_kty_is_led_out() {
    let (motion, extras) = (
        motion::Motion::new(
            &[motion::SegmentSpec::Dwell(Time::from_si(1.5), motion::Hold::Motor)],
            None,
            motion::Closing::SingleMove,
        )
        .unwrap(),
        NOTHING(),
    );
    let run = |code: &str, lag_s: f64, held: f64| {
        let mut parameters = parameters(code);
        replaced(&mut parameters.actuator.heat.winding_time_constant, 0.5);
        replaced(&mut parameters.actuator.heat.housing_time_constant, 1e12);
        parameters.model.ptc_lag.value = lag_s;
        let stall = parameters.actuator.stall_current_motor.known().unwrap().value.si();
        let constant = parameters.actuator.torque_constant_out.known().unwrap().value.si();
        let torque = Torque::from_si(held * stall * constant);
        let mechanism = Mechanism { friction: Friction { external: torque, ..Friction::none() }, ..load(1.3, 0.0) };
        let scenario = Scenario { reaction: Reaction::Coast, ..Scenario::default() };
        let start_k = Some([273.15 + 119.0, 273.15 + 110.0]);
        let setup = Setup { scenario, start_k, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
        let mut twin = Twin::new(&setup).unwrap();
        let mut winding = vec![twin.sample().winding_k];
        while !twin.is_over() {
            // A millisecond.
            twin.advance(16);
            winding.push(twin.sample().winding_k);
        }
        let when = |kind| twin.events().iter().find(|event| event.kind == kind).map(|event| event.time_s);
        (when(EventKind::PtcResponse), when(EventKind::WindingShutdown), winding)
    };
    let limit = 273.15 + 120.0;
    let (at_once, shutdown, winding) = run("CHA-17A-100-N-D2048", 0.0, 0.8);
    let passed = winding.iter().position(|kelvin| *kelvin > limit).unwrap();
    assert_eq!(shutdown, None);
    #[allow(clippy::cast_precision_loss, reason = "some hundred")]
    let passed = passed as f64 * 1e-3;
    assert!((at_once.unwrap() - passed).abs() < 1.5e-3, "{at_once:?} {passed}");
    let lag = 0.3;
    let (later, _, winding) = run("CHA-17A-100-N-D2048", lag, 0.8);
    let later = later.unwrap();
    let at = |index: usize| winding[index] * (-(later - index as f64 * 1e-3) / lag).exp();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundred")]
    let last = (later * 1e3).round() as usize;
    let integral: f64 = (0..last).map(|index| 0.5e-3 * (at(index) + at(index + 1))).sum();
    let sensor = winding[0] * (-later / lag).exp() + integral / lag;
    assert!((sensor - limit).abs() < 0.05 && later > passed, "{sensor} {later} {passed}");
    // Held cool, it does not respond; and where the KTY is read, that is first.
    assert_eq!(run("CHA-17A-100-N-D2048", 0.0, 0.0).0, None);
    let (ptc, shutdown, _) = run("CHA-17A-100-N-RES", 0.0, 0.8);
    assert!(shutdown.is_some_and(|at| at < 2e-3) && ptc.is_none_or(|at| at >= shutdown.unwrap()));
}

/// Held at a torque for long the winding ends where the thermal network says.
#[test]
fn the_thermal_end_value_is_that_of_the_network() {
    let mut parameters = parameters("CHA-20A-100-H-C1024");
    replaced(&mut parameters.actuator.heat.winding_time_constant, 0.05);
    replaced(&mut parameters.actuator.heat.housing_time_constant, 0.2);
    // A winding that is so quick is overloaded while it accelerates; the supervision leaves it on.
    replaced(&mut parameters.actuator.stall_current, 10.0);
    let (mechanism, motion, extras) = (load(1.3, 5.0), one_move(20.0, 0.1, 3.8, 0.1), NOTHING());
    let switches = Switches { kinematic_error: false, hysteresis: false, noise: false, ..Switches::default() };
    let setup = Setup { switches, ambient_k: 313.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    while twin.time_s() < 3.8 {
        twin.advance(1);
    }
    let now = twin.sample();
    let heat = actuator::HeatModel::of(&parameters.actuator).unwrap();
    let at = |kelvin| ThermodynamicTemperature::from_si(kelvin);
    let current = now.current_q_a / std::f64::consts::SQRT_2;
    let friction = heat.friction().at(at(now.housing_k));
    let point = OperatingPoint { torque_nm: 5.0, speed_rad_s: 20.0 * std::f64::consts::TAU / 60.0, direction: 1.0 };
    let mut losses =
        actuator::LossLaw::of(&parameters.actuator, at(now.winding_k)).unwrap().at(&point, current, &friction);
    // The teeth lose their share of the torque, which the sizing does not count as heat of the housing.
    let (out, motor) = (
        parameters.actuator.torque_constant_out.known().unwrap().value.si(),
        100.0 * parameters.actuator.torque_constant_motor.known().unwrap().value.si(),
    );
    losses.friction_w += (motor / out - 1.0) * 5.0 * point.speed_rad_s;
    let steady = heat.network().steady(losses, at(313.15));
    assert!((now.winding_k - steady.winding.si()).abs() < 0.05, "{} {:?}", now.winding_k, steady);
    assert!((now.housing_k - steady.housing.si()).abs() < 0.05, "{} {:?}", now.housing_k, steady);
}

/// Viscous friction and Coulomb friction of a load add their torques.
#[test]
fn friction_of_the_load_takes_its_torque() {
    let (parameters, motion, extras) = (parameters("CHA-20A-100-H-C1024"), one_move(20.0, 0.3, 1.0, 0.1), NOTHING());
    let friction = Friction {
        coulomb: Torque::from_si(5.0),
        viscous: ViscousFriction::from_si(3.0),
        external: Torque::from_si(2.0),
    };
    let mechanism = Mechanism { friction, ..load(0.5, 0.0) };
    let switches = Switches { hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let mut twin = Twin::new(&Setup { switches, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).unwrap();
    while twin.time_s() < 1.29 {
        twin.advance(1);
    }
    let wanted = 7.0 + 3.0 * 20.0 * std::f64::consts::TAU / 60.0;
    assert!((twin.sample().torque_nm / wanted - 1.0).abs() < 2e-3, "{} {wanted}", twin.sample().torque_nm);
}

/// Held against a torque the gear is twisted by eq. 73.1 to 73.4 of the sizing, in each of its three parts.
#[test]
fn the_twist_at_rest_is_the_torsion_of_the_sizing() {
    let parameters = parameters("CHA-20A-100-H-C1024");
    let torsion = parameters.actuator.gear.torsion().unwrap();
    let (motion, extras) = (one_move(10.0, 0.2, 0.1, 1.5), NOTHING());
    let switches =
        Switches { friction: false, hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    for torque in [4.0, 16.0, 48.0] {
        let torque = Torque::from_si(torque);
        let mechanism = Mechanism { friction: Friction { external: torque, ..Friction::none() }, ..load(0.5, 0.0) };
        let setup = Setup { switches, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
        let mut twin = Twin::new(&setup).unwrap();
        twin.advance(u64::MAX);
        let now = twin.sample();
        let (twist, said) = (now.motor_rad - now.position_rad, torsion.angle(torque).si());
        assert!((twist / said - 1.0).abs() < 1e-3, "{torque:?}: {twist} {said}");
    }
}
