use super::*;
use crate::Parameters;
use provenance::{Datum, Grade, Source, Sourced};
use quantities::unit::DEGREE_CELSIUS;
use quantities::{ElectricCurrent, NoLoadCurrentConstant, TorqueConstant};

fn known<T>(value: T) -> Datum<T> {
    Datum::Known(Sourced { value, source: Source::Model { name: "current" }, grade: Grade::Printed, errata: &[] })
}

/// k_Tout = 40 Nm/A, k_TM = 0.5 Nm/A, i = 100: η = 0.8; 2 Ω at 20 °C.
fn actuator() -> Parameters {
    Parameters::from(Drivetrain {
        ratio: known(100.0),
        torque_constant_out: known(TorqueConstant::from_si(40.0)),
        torque_constant_motor: known(TorqueConstant::from_si(0.5)),
        resistance_ll: known(ElectricalResistance::from_si(2.0)),
        ..Drivetrain::unknown()
    })
}

/// I_NLS = 0.2 A, all of it counted, K = 0.1 A/(rad/s).
fn friction() -> FrictionAt {
    FrictionAt {
        temperature: celsius(30.0),
        starting: ElectricCurrent::from_si(0.2),
        counted: ElectricCurrent::from_si(0.2),
        constant: NoLoadCurrentConstant::from_si(0.1),
    }
}

fn celsius(value: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(value, &DEGREE_CELSIUS)
}

fn point(torque_nm: f64, speed_rad_s: f64) -> OperatingPoint {
    let direction = if speed_rad_s == 0.0 { 0.0 } else { speed_rad_s.signum() };
    OperatingPoint { torque_nm, speed_rad_s, direction }
}

/// 80 Nm at 3 rad/s: 2 A for the torque, 0.2 A and 0.3 A for friction.
#[test]
fn friction_adds_while_driving_and_helps_while_braking() {
    let current = MotorCurrent::of(&actuator()).unwrap();
    let at = |torque, speed| current.at(&point(torque, speed), &friction());
    assert!((at(80.0, 3.0) - 2.5).abs() < 1e-15);
    assert!((at(80.0, -3.0) - 1.5).abs() < 1e-15);
    assert!((at(-80.0, -3.0) + 2.5).abs() < 1e-15);
    assert_eq!(at(80.0, 0.0), 2.0);
}

/// The weighted sum yields the same current: 0.7 kgm² at 20 rad/s² and 66 Nm are the 80 Nm.
#[test]
fn the_weights_make_the_current() {
    let current = MotorCurrent::of(&actuator()).unwrap();
    let [a, t, s, w] = current.weights(0.7, &friction());
    let sum = a * 20.0 + t * 66.0 - s - w * 3.0;
    assert!((sum - current.at(&point(80.0, -3.0), &friction())).abs() < 1e-14);
}

/// 1.5 · 2 Ω · (1 + 0.00393 · 60) at 80 °C, and 0.5 Nm/A times the friction current (0.2 + 0.3 A) at 300 rad/s.
#[test]
fn losses_by_hand() {
    let losses = LossLaw::of(&actuator(), celsius(80.0)).unwrap();
    let found = losses.at(&point(80.0, 3.0), 2.5, &friction());
    assert!((found.copper_w - 3.0 * 1.2358 * 6.25).abs() < 1e-12, "{}", found.copper_w);
    assert!((found.friction_w - 75.0).abs() < 1e-12);
    // There is no friction loss at rest.
    assert_eq!(losses.at(&point(80.0, 0.0), 2.0, &friction()).friction_w, 0.0);
}

/// The power at the terminals equals that at the flange plus the losses of copper, friction and gear: T ω (1/η − 1) in
/// the gear while driving, the same of the torque it receives while driven.
#[test]
fn energy_is_kept() {
    let actuator = actuator();
    let (current, cold) = (MotorCurrent::of(&actuator).unwrap(), celsius(20.0));
    let power = TerminalPower::of(&actuator, cold).unwrap();
    let losses = LossLaw::of(&actuator, cold).unwrap();
    for (torque, speed) in [(80.0, 3.0), (80.0, -3.0), (-50.0, 2.0), (-50.0, -2.0), (0.0, 4.0), (30.0, 0.0)] {
        let point = point(torque, speed);
        let amperes = power.current(&current, &point, &friction());
        let lost = losses.at(&point, amperes, &friction());
        let in_the_gear = (torque * speed).abs() * (1.0 / 0.8 - 1.0);
        let flange = torque * speed;
        let whole = flange + lost.copper_w + lost.friction_w + in_the_gear;
        assert!((power.at(&current, &point, &friction()) - whole).abs() < 1e-9, "{torque} {speed}");
    }
}

/// A weakly driving load regenerates nothing: friction and gear consume all of it.
#[test]
fn little_power_comes_back_and_never_more_than_the_load_gives() {
    let actuator = actuator();
    let current = MotorCurrent::of(&actuator).unwrap();
    let power = TerminalPower::of(&actuator, celsius(20.0)).unwrap();
    let at = |torque, speed| power.at(&current, &point(torque, speed), &friction());
    assert!(at(-10.0, 3.0) > 0.0);
    assert!(at(-200.0, 3.0) < 0.0 && at(-200.0, 3.0) > -600.0);
}

#[test]
fn what_is_not_known_is_named() {
    assert_eq!(MotorCurrent::of(&Parameters::unknown()).unwrap_err().symbol, "k_Tout");
    assert_eq!(TerminalPower::of(&Parameters::unknown(), celsius(20.0)).unwrap_err().symbol, "R_LL");
}
