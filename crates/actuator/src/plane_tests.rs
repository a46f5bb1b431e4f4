//! Tests of the torque-speed plane.

use super::*;
use crate::Parameters;
use provenance::CellRef;
use quantities::unit::{
    AMPERE_PER_REVOLUTION_PER_MINUTE, MILLIHENRY, REVOLUTION_PER_MINUTE, VOLT_PER_THOUSAND_REVOLUTIONS,
};
use quantities::{
    ElectricCurrent, ElectricalResistance, Inductance, NoLoadCurrentConstant, Time, TorqueConstant, VoltageConstant,
};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("26.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

fn rpm(n: f64) -> AngularVelocity {
    AngularVelocity::new_in(n, &REVOLUTION_PER_MINUTE)
}

/// Returns an actuator with round figures: i = 50, T_max = 56 Nm, 6000 and 3500 1/min at the motor.
fn actuator() -> Parameters {
    Parameters::from(Drivetrain {
        ratio: known(50.0),
        torque_max: known(Torque::from_si(56.0)),
        stall_torque: known(Torque::from_si(32.0)),
        stall_current: known(ElectricCurrent::from_si(2.0)),
        speed_motor_max: known(rpm(6000.0)),
        speed_motor_rated: known(rpm(3500.0)),
        current_max: known(ElectricCurrent::from_si(4.0)),
        no_load_starting_current: known(ElectricCurrent::from_si(0.2)),
        no_load_current_constant_cold: known(NoLoadCurrentConstant::new_in(0.004, &AMPERE_PER_REVOLUTION_PER_MINUTE)),
        no_load_current_constant_warm: known(NoLoadCurrentConstant::new_in(0.002, &AMPERE_PER_REVOLUTION_PER_MINUTE)),
        no_load_temperatures: known([303.15, 353.15].map(quantities::ThermodynamicTemperature::from_si)),
        friction_printed_from: known(quantities::ThermodynamicTemperature::from_si(293.15)),
        torque_constant_out: known(TorqueConstant::from_si(16.0)),
        torque_constant_motor: known(TorqueConstant::from_si(0.36)),
        voltage_constant_motor: known(VoltageConstant::new_in(23.0, &VOLT_PER_THOUSAND_REVOLUTIONS)),
        resistance_ll: known(ElectricalResistance::from_si(6.0)),
        inductance_ll: known(Inductance::new_in(8.0, &MILLIHENRY)),
        pole_pairs: known(5.0),
        heat: crate::Heat {
            housing_share: known(0.45),
            stall_loss_factor: known(1.0),
            loss_band: known((0.85, 1.15)),
            intermittent_cycle: known(Time::from_si(60.0)),
            intermittent_band_high: Datum::NotPrinted,
            gear_band: known(0.02),
            ambient_reference: known(quantities::ThermodynamicTemperature::from_si(313.15)),
            winding_warning: known(quantities::ThermodynamicTemperature::from_si(353.15)),
            winding_shutdown: known(quantities::ThermodynamicTemperature::from_si(363.15)),
            winding_time_constant: known(Time::from_si(60.0)),
            housing_time_constant: known(Time::from_si(2400.0)),
        },
        ..Drivetrain::unknown()
    })
}

/// Returns the limit with a gear at 30 °C.
fn limit(actuator: &Parameters, speed: AngularVelocity, voltage: Option<ElectricPotential>) -> f64 {
    let friction = cold_friction(&self::actuator()).unwrap();
    let [limit, _] = ShortTime::of(actuator, voltage, &friction).unwrap().at(speed);
    limit.si()
}

fn torque(n: f64, volts: Option<f64>) -> f64 {
    limit(&actuator(), rpm(n), volts.map(ElectricPotential::from_si))
}

/// k_Tout (I_max − I_f): 16 (4 − 0.2) = 60.8 > 56; at 120 1/min 16 (4 − 0.68) = 53.12.
#[test]
fn without_a_voltage_torque_and_current_limit() {
    assert!((torque(0.0, None) - 56.0).abs() < 1e-12);
    assert!((torque(120.0, None) - 53.12).abs() < 1e-9);
    assert!((torque(-120.0, None) - 53.12).abs() < 1e-9);
    assert_eq!(torque(120.001, None), 0.0);
    assert!((torque(50.0, Some(600.0)) - torque(50.0, None)).abs() < 1e-12);
}

#[test]
fn a_small_voltage_cuts_the_fast_end() {
    // Below the back-EMF of 138 V no torque remains.
    assert_eq!(torque(120.0, Some(137.0)), 0.0);
    let mut last = f64::INFINITY;
    for n in 0..=120 {
        let now = torque(f64::from(n), Some(160.0));
        assert!(now <= last && now <= torque(f64::from(n), Some(180.0)));
        last = now;
    }
    assert!(last > 0.0 && last < 40.0);
    // At the limit the current needs exactly the voltage.
    let current = last / 16.0 + 0.2 + 0.004 * 120.0;
    let volts = MotorVoltage::of(&actuator()).unwrap().at(rpm(120.0), ElectricCurrent::from_si(current)).si();
    assert!((volts - 160.0).abs() < 1e-9);
}

#[test]
fn the_four_curves_are_drawn_in_order_and_nested() {
    let voltage = Some(ElectricPotential::from_si(160.0));
    let curves = performance_curves(&actuator(), voltage).unwrap();
    let kinds: Vec<_> = curves.iter().map(|curve| curve.kind).collect();
    let s3 = |duty| CurveKind::S3 { duty: Ratio::from_si(duty), cycle: Time::from_si(60.0) };
    assert_eq!(kinds, [CurveKind::Continuous, s3(0.5), s3(0.25), CurveKind::ShortTime]);
    for curve in &curves {
        assert!(curve.points.len() >= 17);
        assert_eq!(curve.grade, Grade::Estimated);
        assert!(curve.points.iter().all(|point| point.torque.si() >= 0.0 && point.torque.si() <= 56.0));
        assert!(curve.points.iter().zip(curve.points.iter().skip(1)).all(|(a, b)| b.speed.si() >= a.speed.si()));
        assert_eq!(curve.points.last().unwrap().torque.si(), 0.0);
        if curve.kind != CurveKind::ShortTime {
            for (low, high) in curve.points.iter().zip(curve.upper.iter().flatten()) {
                assert!(high.torque.si() >= low.torque.si());
            }
        }
    }
    let end = |index: usize| curves.get(index).unwrap().points.last().unwrap().speed.in_unit(&REVOLUTION_PER_MINUTE);
    assert!((end(0) - 70.0).abs() < 1e-9);
    assert!((end(1) - 120.0).abs() < 1e-9);
    assert!((end(3) - 120.0).abs() < 1e-9);
}

/// A duty of half a minute on and half a minute off by hand, at rest, with τ_w = 60 s and τ_h = 2400 s as two lags.
#[test]
fn intermittent_duty_by_hand() {
    let limit = intermittent_torque(&actuator(), rpm(0.0), Ratio::from_si(0.5), None).unwrap();
    let model = HeatModel::of(&actuator()).unwrap();
    let [quick, slow] = model.network().time_constants().map(Time::si);
    let share = |tau: f64| 1.0 / (1.0 + (-30.0 / tau).exp());
    let [g_quick, g_slow] = model.network().winding().copper;
    let per_watt = g_quick * share(quick) + g_slow * share(slow);
    let current = |edge: f64| (edge * 40.0 / per_watt / model.losses().copper_ohm()).sqrt();
    // T_0 is known at rest, so that the lower edge has no distance there; the upper one has.
    assert!((limit.limit.value.si() - 16.0 * (current(1.0) - 0.2)).abs() < 1e-9, "{}", limit.limit.value.si());
    assert!((limit.upper.si() - 16.0 * (current(1.15) - 0.2)).abs() < 1e-9, "{}", limit.upper.si());
    // The slow housing averages the loss, the winding does not: the loss is between once and twice that of continuous
    // duty.
    let factor = current(1.0).powi(2) / 4.0;
    assert!(factor > 1.6 && factor < 2.0, "{factor}");
    // A gear with T_A = 32 Nm withstands 32 · 2^(1/3) = 40.32 Nm for half of the time.
    let mut geared = actuator();
    geared.gear.average_torque_max = known(Torque::from_si(32.0));
    let limit = intermittent_torque(&geared, rpm(0.0), Ratio::from_si(0.5), None).unwrap();
    assert!((limit.upper.si() - 1.02 * 32.0 * 2.0_f64.cbrt()).abs() < 1e-9);
    // 70 1/min is the largest mean speed, hence 93 1/min for three quarters of the time.
    let fast = intermittent_torque(&actuator(), rpm(94.0), Ratio::from_si(0.75), None).unwrap();
    assert_eq!(fast.limit.value.si(), 0.0);
}

fn curve(points: &[(f64, f64)]) -> Datum<Curve> {
    let points = points.iter().map(|&(n, t)| CurvePoint { speed: rpm(n), torque: Torque::from_si(t) }).collect();
    known(Curve::new(points).unwrap())
}

#[test]
fn published_curves_win_and_are_cut_at_the_printed_torque() {
    let mut actuator = actuator();
    actuator.continuous_curve = curve(&[(0.0, 34.0), (20.0, 34.0), (70.0, 24.0)]);
    actuator.short_time_curve = curve(&[(0.0, 56.0), (120.0, 50.0)]);
    actuator.terminal_voltage_min = known(ElectricPotential::from_si(220.0));
    let curves = performance_curves(&actuator, None).unwrap();
    let corners: Vec<(f64, f64)> = curves
        .first()
        .unwrap()
        .points
        .iter()
        .map(|point| (point.speed.in_unit(&REVOLUTION_PER_MINUTE).round(), point.torque.si()))
        .collect();
    // 34 decreases to 32 at a fifth of the range from 20 to 70.
    assert_eq!(corners, [(0.0, 32.0), (20.0, 32.0), (30.0, 32.0), (70.0, 24.0), (70.0, 0.0)]);
    let at = |volts: f64| limit(&actuator, rpm(120.0), Some(ElectricPotential::from_si(volts)));
    assert!((at(220.0) - 50.0).abs() < 1e-9);
    assert!(at(160.0) < 40.0, "below the printed voltage the model answers");
    actuator.s3_curves = [curve(&[(0.0, 42.0), (120.0, 30.0)]), Datum::NotPrinted];
    let grade = |volts: f64| {
        let curves = performance_curves(&actuator, Some(ElectricPotential::from_si(volts))).unwrap();
        curves.get(1).unwrap().grade
    };
    assert_eq!((grade(220.0), grade(160.0)), (Grade::Printed, Grade::Estimated));
}

#[test]
fn an_actuator_without_data_has_no_curves() {
    assert_eq!(performance_curves(&Parameters::unknown(), None).unwrap_err().symbol, "n_N");
    let friction = cold_friction(&actuator()).unwrap();
    assert_eq!(ShortTime::of(&Parameters::unknown(), None, &friction).unwrap_err().symbol, "T_max");
    let published =
        Parameters::from(Drivetrain { continuous_curve: curve(&[(0.0, 1.0), (1.0, 1.0)]), ..Drivetrain::unknown() });
    assert_eq!(performance_curves(&published, None).unwrap().len(), 1);
}
