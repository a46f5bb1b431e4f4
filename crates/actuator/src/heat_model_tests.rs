//! Tests of the heat model.

use super::*;
use crate::{Heat, Parameters};
use provenance::{CellRef, Datum, Grade, Source, Sourced};
use quantities::unit::{AMPERE_PER_REVOLUTION_PER_MINUTE, REVOLUTION_PER_MINUTE};
use quantities::{ElectricalResistance, NoLoadCurrentConstant, TorqueConstant};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("26.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

fn constant(milliampere: f64) -> Datum<NoLoadCurrentConstant> {
    known(NoLoadCurrentConstant::new_in(milliampere * 1e-3, &AMPERE_PER_REVOLUTION_PER_MINUTE))
}

/// CHA-20A-50, table 26.1, with w = 0.45.
fn actuator() -> Parameters {
    Parameters::from(Drivetrain {
        ratio: known(50.0),
        speed_motor_rated: known(rpm(3500.0)),
        stall_torque: known(Torque::from_si(32.0)),
        stall_current: known(ElectricCurrent::from_si(2.1)),
        no_load_starting_current: known(ElectricCurrent::from_si(0.17)),
        no_load_current_constant_cold: constant(4.0),
        no_load_current_constant_warm: constant(2.0),
        no_load_temperatures: known([303.15, 353.15].map(ThermodynamicTemperature::from_si)),
        friction_printed_from: known(ThermodynamicTemperature::from_si(293.15)),
        torque_constant_out: known(TorqueConstant::from_si(16.5)),
        torque_constant_motor: known(TorqueConstant::from_si(0.36)),
        resistance_ll: known(ElectricalResistance::from_si(5.9)),
        heat: Heat {
            housing_share: known(0.45),
            stall_loss_factor: known(1.0),
            loss_band: known((0.85, 1.15)),
            intermittent_cycle: known(Time::from_si(60.0)),
            intermittent_band_high: Datum::NotPrinted,
            gear_band: known(0.02),
            ambient_reference: known(ThermodynamicTemperature::from_si(313.15)),
            winding_warning: known(ThermodynamicTemperature::from_si(353.15)),
            winding_shutdown: known(ThermodynamicTemperature::from_si(363.15)),
            winding_time_constant: known(Time::from_si(60.0)),
            housing_time_constant: known(Time::from_si(2400.0)),
        },
        ..Drivetrain::unknown()
    })
}

fn rpm(n: f64) -> AngularVelocity {
    AngularVelocity::new_in(n, &REVOLUTION_PER_MINUTE)
}

fn model() -> HeatModel {
    HeatModel::of(&actuator()).unwrap()
}

const MINUTE: f64 = 60.0;

fn torque(n: f64, duty: f64, edge: f64) -> f64 {
    model().torque(rpm(n), duty, Time::from_si(MINUTE), edge).0.si()
}

/// P_0 = 1.5·5.9·1.2358·2.1² = 48.23 W; T = 16.5 (2.1 − 0.17) = 31.845 Nm at standstill by the loss alone.
#[test]
fn standstill_by_hand() {
    assert!((model().stall_loss().si() - 1.5 * 5.9 * 1.2358 * 4.41).abs() < 1e-9);
    assert!((torque(0.0, 1.0, 1.0) - 16.5 * (2.1 - 0.17)).abs() < 1e-9);
    let steady = model().network().steady(
        Losses { copper_w: model().stall_loss().si(), friction_w: 0.0 },
        ThermodynamicTemperature::from_si(313.15),
    );
    assert!((steady.winding.si() - 353.15).abs() < 1e-9);
}

/// Solved independently by bisection over the temperature of the housing: 20 Nm at 70 1/min settle at a housing of
/// 66.5018 °C with 26.3073 W in the winding and 44.7048 W in the housing, a winding of 78.5014 °C.
#[test]
fn a_published_point_by_another_solution() {
    let (share, settled) = model().rise_share(Torque::from_si(20.0), rpm(70.0), 1.0, Time::from_si(MINUTE));
    assert!((settled.friction.celsius() - 66.5018).abs() < 1e-4, "{}", settled.friction.celsius());
    assert!((settled.losses.copper_w - 26.3073).abs() < 1e-4, "{:?}", settled.losses);
    assert!((settled.losses.friction_w - 44.7048).abs() < 1e-4, "{:?}", settled.losses);
    assert!((40.0 * share - 38.5014).abs() < 1e-4, "{share}");
}

/// Two independent solutions of the same balance: the torque for a rise, and the rise of that torque.
#[test]
fn torque_and_rise_are_inverse() {
    for n in [0.0, 3.0, 25.0, 70.0] {
        for (duty, edge) in [(1.0, 1.0), (1.0, 0.85), (0.5, 1.0), (0.25, 1.15)] {
            let torque = Torque::from_si(torque(n, duty, edge));
            if n == 0.0 {
                continue; // At rest the torque is that at the onset of motion, the rise that of a resting shaft.
            }
            let (share, _) = model().rise_share(torque, rpm(n), duty, Time::from_si(MINUTE));
            assert!((share - edge).abs() < 1e-9, "{n} {duty} {edge}: {share}");
        }
    }
}

#[test]
fn speed_and_heat_only_take_and_rest_only_gives() {
    let mut last = f64::INFINITY;
    for n in 0..=100 {
        let n = f64::from(n);
        let here = torque(n, 1.0, 1.0);
        assert!(here <= last);
        assert!(torque(n, 0.5, 1.0) >= here && torque(n, 0.25, 1.0) >= torque(n, 0.5, 1.0));
        assert!(torque(n, 1.0, 0.85) <= here && here <= torque(n, 1.0, 1.15));
        last = here;
    }
}

/// Limits: without friction the torque does not depend on the speed; with w → 0 friction acts through its current only.
#[test]
fn an_ideal_gear_and_an_ideal_plate() {
    let mut ideal = actuator();
    ideal.no_load_starting_current = known(ElectricCurrent::from_si(0.0));
    ideal.no_load_current_constant_cold = constant(0.0);
    ideal.no_load_current_constant_warm = constant(0.0);
    let ideal = HeatModel::of(&ideal).unwrap();
    let at = |n| ideal.torque(rpm(n), 1.0, Time::from_si(MINUTE), 1.0).0.si();
    assert!((at(0.0) - 16.5 * 2.1).abs() < 1e-9 && (at(70.0) - at(0.0)).abs() < 1e-9);
    let mut cold = actuator();
    cold.heat.housing_share = known(1e-9);
    let cold = HeatModel::of(&cold).unwrap();
    let (torque, settled) = cold.torque(rpm(70.0), 1.0, Time::from_si(MINUTE), 1.0);
    let expected = 16.5 * (2.1 - settled.friction.current(rpm(70.0)).si());
    assert!((torque.si() - expected).abs() < 1e-5);
    assert!((settled.friction.celsius() - 40.0).abs() < 1e-5, "the housing stays as cold as the air");
}

#[test]
fn the_settled_housing_balances_its_heat() {
    let means = LossMeans {
        torque_current_square: 2.3,
        torque_current_direction: -0.4,
        torque_current_speed: -1.1,
        moving: 0.6,
        speed_magnitude: 2.2,
        speed_square: 11.0,
    };
    for (further, ambient) in [(0.0, 293.15), (7.2, 313.15), (0.0, 263.15)] {
        let ambient = ThermodynamicTemperature::from_si(ambient);
        let settled = model().settle(&means, Power::from_si(further), ambient);
        let [_, r_ha] = model().network().resistances_k_per_w();
        let rise = r_ha * settled.losses.total().si();
        assert!((settled.housing.si() - ambient.si() - rise).abs() < 1e-8, "{settled:?}");
    }
}

#[test]
fn what_is_missing_is_named() {
    let mut actuator = actuator();
    actuator.heat = Heat::default();
    assert_eq!(HeatModel::of(&actuator).unwrap_err().symbol, "stall_loss_factor");
    actuator.resistance_ll = Datum::NotPrinted;
    assert_eq!(HeatModel::of(&actuator).unwrap_err().symbol, "R_LL");
}

/// The band has zero width downwards at standstill, where T_0 is known, and full width at n_N/i.
#[test]
fn the_band_opens_with_the_speed() {
    assert_eq!(model().band(rpm(0.0)), (1.0, 1.15));
    let (low, _) = model().band(rpm(35.0));
    assert!((low - 0.925).abs() < 1e-12);
    assert_eq!(model().band(rpm(500.0)), (0.85, 1.15));
}
