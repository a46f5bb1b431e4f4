use super::*;
use crate::Parameters;
use crate::{Curve, CurvePoint};
use provenance::{CellRef, Datum};
use quantities::unit::{
    AMPERE, MILLIAMPERE_PER_REVOLUTION_PER_MINUTE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, OHM, REVOLUTION_PER_MINUTE,
};
use quantities::{
    ElectricCurrent, ElectricalResistance, NoLoadCurrentConstant, ThermodynamicTemperature, TorqueConstant,
};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("26.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

fn heat() -> crate::Heat {
    crate::Heat {
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
    }
}

/// CHA-20A-50, table 26.1.
fn actuator_20a_50() -> Parameters {
    let current = |a| ElectricCurrent::new_in(a, &AMPERE);
    Parameters::from(Drivetrain {
        ratio: known(50.0),
        speed_max: known(AngularVelocity::new_in(120.0, &REVOLUTION_PER_MINUTE)),
        speed_motor_max: known(AngularVelocity::new_in(6000.0, &REVOLUTION_PER_MINUTE)),
        speed_motor_rated: known(AngularVelocity::new_in(3500.0, &REVOLUTION_PER_MINUTE)),
        stall_torque: known(Torque::new_in(32.0, &NEWTON_METRE)),
        stall_current: known(current(2.1)),
        no_load_starting_current: known(current(0.17)),
        no_load_current_constant_cold: known(NoLoadCurrentConstant::new_in(
            4.0,
            &MILLIAMPERE_PER_REVOLUTION_PER_MINUTE,
        )),
        no_load_current_constant_warm: known(NoLoadCurrentConstant::new_in(
            2.0,
            &MILLIAMPERE_PER_REVOLUTION_PER_MINUTE,
        )),
        no_load_temperatures: known([303.15, 353.15].map(ThermodynamicTemperature::from_si)),
        friction_printed_from: known(ThermodynamicTemperature::from_si(293.15)),
        torque_constant_out: known(TorqueConstant::new_in(16.5, &NEWTON_METRE_PER_AMPERE)),
        torque_constant_motor: known(TorqueConstant::new_in(0.36, &NEWTON_METRE_PER_AMPERE)),
        resistance_ll: known(ElectricalResistance::new_in(5.9, &OHM)),
        heat: heat(),
        ..Drivetrain::unknown()
    })
}

fn rpm(n: f64) -> AngularVelocity {
    AngularVelocity::new_in(n, &REVOLUTION_PER_MINUTE)
}

#[test]
fn speed_limits_are_the_exact_quotients() {
    let mut actuator = actuator_20a_50();
    actuator.ratio = known(160.0);
    assert!((speed_max(&actuator).unwrap().value.in_unit(&REVOLUTION_PER_MINUTE) - 37.5).abs() < 1e-12, "printed 38");
    assert!((speed_rated_out(&actuator).unwrap().value.in_unit(&REVOLUTION_PER_MINUTE) - 21.875).abs() < 1e-12);
    actuator.ratio = Datum::NotPrinted;
    assert!((speed_max(&actuator).unwrap().value.in_unit(&REVOLUTION_PER_MINUTE) - 120.0).abs() < 1e-12, "n_max");
    assert_eq!(speed_rated_out(&actuator).unwrap_err().symbol, "i");
}

#[test]
fn copper_is_warmer_by_its_coefficient() {
    let hot = copper_resistance(ElectricalResistance::from_si(1.0), ThermodynamicTemperature::from_si(393.15));
    assert!((hot.si() - 1.393).abs() < 1e-12);
}

#[test]
fn the_estimate_starts_at_the_stall_torque_and_falls_with_speed() {
    let actuator = actuator_20a_50();
    let at = |n| estimated_continuous_torque(&actuator, rpm(n)).unwrap();
    assert!((at(0.0).limit.value.si() - 32.0).abs() < 0.5, "{:?}", at(0.0));
    let mut last = f64::INFINITY;
    for n in 0..=70 {
        let limit = at(f64::from(n));
        assert!(limit.limit.value.si() <= last && limit.upper.si() >= limit.limit.value.si());
        assert!(limit.upper.si() <= 32.0);
        assert_eq!(limit.limit.grade, Grade::Estimated);
        last = limit.limit.value.si();
    }
    assert_eq!(at(700.0), at(70.0), "beyond n_N/i the mean speed has a check of its own");
}

#[test]
fn a_curve_wins_over_the_estimate_but_never_over_the_stall_torque() {
    let mut actuator = actuator_20a_50();
    let point = |n, torque| CurvePoint { speed: rpm(n), torque: Torque::from_si(torque) };
    actuator.continuous_curve = known(Curve::new(vec![point(0.0, 33.0), point(70.0, 20.0)]).unwrap());
    assert!((continuous_torque(&actuator, rpm(0.0)).unwrap().limit.value.si() - 32.0).abs() < 1e-12);
    assert!((continuous_torque(&actuator, rpm(70.0)).unwrap().limit.value.si() - 20.0).abs() < 1e-12);
}

#[test]
fn what_is_missing_is_named() {
    let mut actuator = actuator_20a_50();
    actuator.resistance_ll = Datum::NotPrinted;
    assert_eq!(continuous_torque(&actuator, rpm(1.0)).unwrap_err().symbol, "R_LL");
    assert_eq!(continuous_torque(&Parameters::unknown(), rpm(1.0)).unwrap_err().symbol, "T_0");
}

/// A 48 V winding has I_0 = T_0/k_Tout, without the starting current.
#[test]
fn the_convention_of_the_48_v_winding_is_kept() {
    let mut actuator = actuator_20a_50();
    actuator.stall_current_includes_friction = false;
    actuator.stall_current = known(ElectricCurrent::from_si(32.0 / 16.5));
    let stall = estimated_continuous_torque(&actuator, rpm(0.0)).unwrap();
    assert!((stall.limit.value.si() - 32.0).abs() < 1e-9);
}
