use super::*;
use crate::brake_times::BrakeTimes;
use crate::judge::{Scope, judge};
use crate::notes::Note;
use actuator::Drivetrain;
use mechanism::{Extra, Mechanism};
use motion::{Closing, Given, Hold, Law, ManualMove, Motion, SegmentSpec};
use provenance::{CellRef, Datum, Grade, Source, Sourced};
use quantities::{
    Angle, AngularAcceleration, AngularVelocity, ElectricCurrent, ElectricalResistance, MomentOfInertia,
    NoLoadCurrentConstant, ThermodynamicTemperature, Time, Torque, TorqueConstant,
};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("54.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

fn manual(run: f64, pause: f64) -> Axis {
    let s = Time::from_si;
    let only = SegmentSpec::Manual(ManualMove {
        speed: AngularVelocity::from_si(4.0),
        accelerate: s(0.1),
        run: s(run),
        brake: s(0.2),
        pause: s(pause),
    });
    axis(&[only])
}

/// A flywheel of 1 kgm² with a friction of 5 Nm.
fn axis(segments: &[SegmentSpec]) -> Axis {
    let motion = Motion::new(segments, None, Closing::Speed).unwrap();
    Axis::new(Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(5.0)), motion, Vec::new())
}

fn of_inertia() -> Parameters {
    Parameters { inertia_out: known(MomentOfInertia::from_si(0.5)), ..Parameters::unknown() }
}

// Data of `actuator`, typed twice: as parameters there, as plain numbers here.
const INERTIA: f64 = 1.0 + 0.5;
const FRICTION: f64 = 5.0;
const K_OUT: f64 = 10.0;
const I_S: f64 = 0.5;
const K: f64 = 0.1;
/// 1.5 R_LL \[Ω\]
const COPPER: f64 = 3.0;
/// k_TM i \[Nm/A\], so that η = 10/12.5 = 0.8: a driving load passes 2 − 1/0.8 = 0.75 of its torque to the motor.
const K_MOTOR: f64 = 12.5;
const PASSED: f64 = 0.75;

/// J_out = 0.5 kgm², k_Tout = 10 Nm/A, I_s = 0.5 A and K = 0.1 A/(rad/s) at every temperature, R_LL = 2 Ω, k_TM = 0.125 Nm/A,
/// i = 100.
fn actuator() -> Parameters {
    let constant = NoLoadCurrentConstant::from_si(K);
    Parameters {
        inertia_out: known(MomentOfInertia::from_si(0.5)),
        ..Drivetrain {
            ratio: known(100.0),
            torque_constant_out: known(TorqueConstant::from_si(K_OUT)),
            torque_constant_motor: known(TorqueConstant::from_si(0.125)),
            resistance_ll: known(ElectricalResistance::from_si(2.0)),
            no_load_starting_current: known(ElectricCurrent::from_si(I_S)),
            no_load_current_constant_cold: known(constant),
            no_load_current_constant_warm: known(constant),
            no_load_temperatures: known([303.15, 353.15].map(ThermodynamicTemperature::from_si)),
            friction_printed_from: known(ThermodynamicTemperature::from_si(293.15)),
            stall_current_includes_friction: true,
            ..Drivetrain::unknown()
        }
        .into()
    }
}

/// Motor current \[A\] and power at the terminals \[W\] of a turning flywheel, for acceleration, speed and direction.
fn instant(acceleration: f64, speed: f64, direction: f64) -> (f64, f64) {
    let torque = INERTIA * acceleration + FRICTION * direction;
    let running = direction * (I_S + K * speed.abs());
    let current = torque / K_OUT + running;
    let is_driven = torque * direction < 0.0;
    // T (2 − 1/η) at a motor that needs T/(η i k_TM) when it drives.
    let of_power = if is_driven { torque * PASSED / K_MOTOR } else { torque / K_OUT } + running;
    (current, COPPER * of_power * of_power + K_MOTOR * of_power * speed)
}

/// Independent sums over one time: ∫ I² dt, ∫ P dt where P > 0 and −∫ P dt where P < 0, max |I|, max P.
#[derive(Clone, Copy, Debug, Default)]
struct Own {
    current_square: f64,
    taken: f64,
    returned: f64,
    current: f64,
    power: f64,
}

impl Own {
    /// Midpoint rule over a time in which acceleration and speed follow `state`: the error of an integral is that of 10⁻¹⁰ of the time.
    fn add(&mut self, duration: f64, state: impl Fn(f64) -> (f64, f64)) {
        const STEPS: u32 = 100_000;
        let step = duration / f64::from(STEPS);
        for index in 0..STEPS {
            let (acceleration, speed) = state((f64::from(index) + 0.5) * step);
            let (current, power) = instant(acceleration, speed, speed.signum());
            self.current_square += current * current * step;
            self.taken += power.max(0.0) * step;
            self.returned -= power.min(0.0) * step;
        }
        for index in 0..=STEPS {
            let (acceleration, speed) = state(f64::from(index) * step);
            // At the ends the direction is that of the motion beside them.
            let direction = state(duration * 0.5).1.signum();
            let (current, power) = instant(acceleration, speed, direction);
            self.current = self.current.max(current.abs());
            self.power = self.power.max(power);
        }
    }
}

fn near(found: f64, value: f64, share: f64, what: &str) {
    assert!((found - value).abs() <= share * value.abs(), "{what}: {found} {value}");
}

/// T = 1.5·40 + 5 = 65, 5, −1.5·20 + 5 = −25 Nm over 0.1, 0.3, 0.2 s.
#[test]
fn torques_of_a_move_by_hand() {
    let found = Operation::of(&manual(0.3, 1.0), &of_inertia()).unwrap();
    let [only] = &found.segments[..] else { panic!("{found:?}") };
    let square = 65.0_f64.powi(2) * 0.1 + 25.0 * 0.3 + 625.0 * 0.2;
    assert!((only.torque_peak_nm - 65.0).abs() < 1e-9);
    assert!((only.torque_rms_nm - (square / 1.6).sqrt()).abs() < 1e-9, "{only:?}");
    assert!((only.speed_peak_rad_s - 4.0).abs() < 1e-12);
    assert!((found.cycle.torque_rms_nm - only.torque_rms_nm).abs() < 1e-9);
    assert_eq!((only.current_peak_a, found.motor), (None, None));
    assert!((found.inertia_load / found.inertia_own - 2.0).abs() < 1e-12);
}

#[test]
fn the_duty_type_follows_from_rest_and_braking() {
    let of = |run, pause| Operation::of(&manual(run, pause), &of_inertia()).unwrap().duty;
    assert_eq!(of(0.3, 1.0), DutyType::WithBraking);
    assert_eq!(of(0.3, 0.0), DutyType::ContinuousWithBraking);
    // 65²·0.1 + 25²·0.2 = 547.5 beside 25·t: a tenth from 197 s on.
    assert_eq!(of(190.0, 1.0), DutyType::WithBraking);
    assert_eq!(of(200.0, 1.0), DutyType::Intermittent);
}

/// Held by the motor a load hangs on a current at rest too; held by the brake it does not, but for the time in which it closes
/// and opens.
#[test]
fn a_load_held_by_the_brake_rests_without_current() {
    let arm = |hold| {
        let move_by = |angle: f64| {
            let (distance, time) = (Some(Angle::from_si(angle)), Some(Time::from_si(0.5)));
            SegmentSpec::Move(Law::Polynomial5, Given { distance, time, ..Given::default() })
        };
        let segments = [move_by(1.0), SegmentSpec::Dwell(Time::from_si(3.0), hold), move_by(-1.0)];
        let motion = Motion::new(&segments, None, Closing::Speed).unwrap();
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
        let extra = Extra { torque: Torque::from_si(20.0), ..Extra::none() };
        let times = BrakeTimes { closing: Time::from_si(0.07), opening: Time::from_si(0.11) };
        let axis = Axis::braked(load, motion, vec![extra; 3], times);
        Operation::of(&axis, &of_inertia()).unwrap().duty
    };
    assert_eq!(arm(Hold::Motor), DutyType::HeldAtStandstill);
    assert_eq!(arm(Hold::Brake), DutyType::WithBraking);
}

/// A load that the motor holds all the time is continuous duty; one that changes meanwhile, duty with changes of the load.
#[test]
fn a_load_that_is_only_held_is_continuous_duty() {
    let held = |torques: [f64; 2]| {
        let segments = [Hold::Motor; 2].map(|hold| SegmentSpec::Dwell(Time::from_si(3.0), hold));
        let motion = Motion::new(&segments, None, Closing::Speed).unwrap();
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
        let extras = torques.map(|torque| Extra { torque: Torque::from_si(torque), ..Extra::none() });
        Operation::of(&Axis::new(load, motion, extras.to_vec()), &of_inertia()).unwrap().duty
    };
    assert_eq!(held([20.0, 20.0]), DutyType::Continuous);
    assert_eq!(held([20.0, 35.0]), DutyType::ContinuousLoadChanges);
}

/// A trapezoidal move in closed form: I = 6.5 + 0.5 + 0.1 ω while accelerating, 0.5 + 0.5 + 0.4 A at 4 rad/s,
/// −2.5 + 0.5 + 0.1 ω while braking, none at rest; of the power while braking −1.5 + 0.5 + 0.1 ω.
#[test]
fn current_power_and_energy_of_a_trapezoidal_move_in_closed_form() {
    let found = Operation::of(&manual(0.3, 1.0), &actuator()).unwrap();
    let [only] = &found.segments[..] else { panic!("{found:?}") };
    // ∫ (a + b u)² du from 0 to 1, and ∫ (a + b u) u du.
    let square = |a: f64, b: f64| a * a + a * b + b * b / 3.0;
    let by_speed = |a: f64, b: f64| a / 2.0 + b / 3.0;
    // With u = ω/4 rising in 0.1 s and falling in 0.2 s.
    let currents = 0.1 * square(7.0, 0.4) + 0.3 * 1.4 * 1.4 + 0.2 * square(-2.0, 0.4);
    near(only.current_rms_a.unwrap(), (currents / 1.6).sqrt(), 1e-12, "I_rms");
    near(only.current_peak_a.unwrap(), 7.4, 1e-12, "I_peak");
    let power = |current: f64, speed: f64| COPPER * current * current + K_MOTOR * current * speed;
    near(only.power_peak_w.unwrap(), power(7.4, 4.0), 1e-12, "P_max");
    let accelerating = 0.1 * (COPPER * square(7.0, 0.4) + K_MOTOR * 4.0 * by_speed(7.0, 0.4));
    let running = 0.3 * power(1.4, 4.0);
    // P(u) = 3 (−1 + 0.4 u)² + 50 u (−1 + 0.4 u) = 20.48 u² − 52.4 u + 3: one zero in the move.
    let zero = (52.4 - (52.4_f64 * 52.4 - 4.0 * 20.48 * 3.0).sqrt()) / (2.0 * 20.48);
    let until = |u: f64| 0.2 * (20.48 * u.powi(3) / 3.0 - 26.2 * u * u + 3.0 * u);
    near(only.energy_taken_j.unwrap(), accelerating + running + until(zero), 1e-9, "E_mot");
    near(only.energy_returned_j.unwrap(), until(zero) - until(1.0), 1e-9, "E_reg");
    // The motor turns a hundred times as fast.
    let motor = found.motor.unwrap();
    near(motor.speed_peak_rad_s, 400.0, 1e-12, "n_mot");
    near(motor.torque_peak_nm.unwrap(), 0.125 * 7.4, 1e-12, "T_mot");
    near(motor.torque_rms_nm.unwrap(), 0.125 * (currents / 1.6).sqrt(), 1e-12, "T_mot_rms");
}

/// A polynomial forth, a dwell, a trapezoid back: each segment against sums over 10⁵ instants of its law, written out here.
#[test]
fn every_segment_is_that_of_its_own_integral() {
    let (angle, time) = (2.0, 0.8);
    let (speed, acceleration) = (3.0, 12.0);
    let rise = speed / acceleration;
    let cruise = angle / speed - rise;
    let segments = [
        SegmentSpec::Move(
            Law::Polynomial5,
            Given { distance: Some(Angle::from_si(angle)), time: Some(Time::from_si(time)), ..Given::default() },
        ),
        SegmentSpec::Dwell(Time::from_si(0.3), Hold::Motor),
        SegmentSpec::Move(
            Law::Trapezoid,
            Given {
                distance: Some(Angle::from_si(-angle)),
                speed: Some(AngularVelocity::from_si(speed)),
                acceleration: Some(AngularAcceleration::from_si(acceleration)),
                ..Given::default()
            },
        ),
    ];
    let axis = axis(&segments);
    let found = Operation::of(&axis, &actuator()).unwrap();
    let [forth, dwell, back] = &found.segments[..] else { panic!("{found:?}") };

    let mut own = Own::default();
    // s = h (10 τ³ − 15 τ⁴ + 6 τ⁵)
    own.add(time, |t| {
        let u = t / time;
        let speed = angle / time * 30.0 * (u * u - 2.0 * u.powi(3) + u.powi(4));
        (angle / time.powi(2) * 60.0 * (u - 3.0 * u * u + 2.0 * u.powi(3)), speed)
    });
    // The parts of the law are straight lines: 256 of them deviate by their curvature.
    compare(forth, &own, time, 1e-4, 1e-3);

    let of_dwell = [dwell.current_rms_a, dwell.current_peak_a, dwell.power_peak_w, dwell.energy_taken_j];
    assert_eq!(of_dwell, [Some(0.0); 4], "nothing is held");

    let mut own = Own::default();
    own.add(rise, |t| (-acceleration, -acceleration * t));
    own.add(cruise, |_| (0.0, -speed));
    own.add(rise, |t| (acceleration, -speed + acceleration * t));
    compare(back, &own, cruise + 2.0 * rise, 1e-8, 1e-8);

    // The energies of the cycle are the sums of its segments, and those of the check of the regenerated power.
    let checks = judge(&axis, &actuator(), Scope::All).checks;
    let balance = checks.iter().flat_map(|check| check.notes.iter()).find_map(|note| match note {
        Note::EnergyPerCycle { motoring, regenerated, .. } => Some([motoring.si(), regenerated.si()]),
        _ => None,
    });
    let [taken, returned] = balance.unwrap();
    let sum = |of: fn(&SegmentLoad) -> Option<f64>| found.segments.iter().map(|load| of(load).unwrap()).sum::<f64>();
    near(sum(|load| load.energy_taken_j), taken, 1e-4, "E_mot of the cycle");
    near(sum(|load| load.energy_returned_j), returned, 1e-3, "E_reg of the cycle");
    near(found.cycle.energy_taken_j.unwrap(), sum(|load| load.energy_taken_j), 1e-12, "sum");
    let squares = |load: &SegmentLoad| load.current_rms_a.unwrap().powi(2) * load.duration_s;
    let whole: f64 = found.segments.iter().map(squares).sum();
    near(squares(&found.cycle), whole, 1e-4, "I_rms of the cycle");
}

/// The only segment with a torque is the cycle: one value, not one by the instants beside one by the integral.
#[test]
fn the_only_segment_is_the_cycle() {
    let given = Given { distance: Some(Angle::from_si(2.0)), time: Some(Time::from_si(0.8)), ..Given::default() };
    let segments = [SegmentSpec::Move(Law::Polynomial5, given), SegmentSpec::Dwell(Time::from_si(0.3), Hold::Motor)];
    let found = Operation::of(&axis(&segments), &actuator()).unwrap();
    let [only, _] = &found.segments[..] else { panic!("{found:?}") };
    let square = |load: &SegmentLoad, rms: f64| rms * rms * load.duration_s;
    near(square(only, only.torque_rms_nm), square(&found.cycle, found.cycle.torque_rms_nm), 1e-12, "T_rms");
    let current = |load: &SegmentLoad| square(load, load.current_rms_a.unwrap());
    near(current(only), current(&found.cycle), 1e-12, "I_rms");
}

/// Compares a segment with its own sums, within shares of the integrals and of the energy returned, which is a small difference.
fn compare(load: &SegmentLoad, own: &Own, duration: f64, share: f64, of_returned: f64) {
    near(load.duration_s, duration, 1e-12, "t");
    near(load.current_rms_a.unwrap(), (own.current_square / duration).sqrt(), share, "I_rms");
    near(load.energy_taken_j.unwrap(), own.taken, share, "E_mot");
    near(load.energy_returned_j.unwrap(), own.returned, of_returned, "E_reg");
    near(load.current_peak_a.unwrap(), own.current, 1e-3, "I_peak");
    // As documented: a tenth of a per cent of the largest value at most.
    near(load.power_peak_w.unwrap(), own.power, 1e-3, "P_max");
    assert!(load.power_peak_w.unwrap() <= own.power * (1.0 + 1e-9), "a power that does not occur");
}

/// Rounding beside the loads of other segments, or alone, is zero, in the row of the cycle too; what is small but real stays.
#[test]
fn values_of_rounding_are_zero() {
    let load = |torque: f64, current: f64| SegmentLoad {
        torque_peak_nm: torque,
        torque_rms_nm: torque,
        current_peak_cold_a: Some(current),
        current_peak_a: Some(current),
        energy_taken_j: Some(current),
        ..SegmentLoad::default()
    };
    let of = |mut segments: Vec<SegmentLoad>, mut cycle: SegmentLoad| {
        without_rounding(&mut segments, &mut cycle);
        (segments, cycle)
    };
    let all = of(vec![load(20.0, 2.0), load(6e-16, 2.3e-17), load(1e-3, 1e-4), load(1.9e-8, 1.9e-9)], load(20.0, 2.0));
    let zero = load(0.0, 0.0);
    assert_eq!(all, (vec![load(20.0, 2.0), zero, load(1e-3, 1e-4), zero], load(20.0, 2.0)));
    assert_eq!(of(vec![load(6e-16, 2.3e-17)], load(6e-16, 2.3e-17)), (vec![zero], zero));
    assert_eq!(of(vec![load(1e-8, 1e-9)], load(1e-8, 1e-9)), (vec![load(1e-8, 1e-9)], load(1e-8, 1e-9)));
    // The energy returned is measured by the energy taken.
    let energies = |taken, returned| SegmentLoad {
        energy_taken_j: Some(taken),
        energy_returned_j: Some(returned),
        ..SegmentLoad::default()
    };
    assert_eq!(of(vec![energies(50.0, 1e-9)], energies(50.0, 1e-9)), (vec![energies(50.0, 0.0)], energies(50.0, 0.0)));
}

/// With a friction that halves when the gear warms up, each column belongs to one state: cold I = T/k + I_s + K n, settled the
/// same with the smaller K; while the load drives, the settled gear needs the larger current.
#[test]
fn a_row_belongs_to_one_state_of_the_gear() {
    let cold = known(NoLoadCurrentConstant::from_si(4.0 * K));
    let mut rough = actuator();
    std::sync::Arc::make_mut(&mut rough.drivetrain).no_load_current_constant_cold = cold;
    let found = Operation::of(&manual(0.3, 1.0), &rough).unwrap();
    let [only] = &found.segments[..] else { panic!("{found:?}") };
    // 65 Nm at 4 rad/s while accelerating; without a thermal model the settled gear is that of 80 °C.
    let current = |k: f64| 65.0 / K_OUT + I_S + k * 4.0;
    near(only.current_peak_a.unwrap(), current(K), 1e-12, "settled");
    // The ambient temperature is not above the 30 °C of the table.
    assert!(only.current_peak_cold_a.unwrap() >= current(4.0 * K) * (1.0 - 1e-12), "cold");
    for row in found.segments.iter().chain([&found.cycle]) {
        assert!(row.current_rms_a.unwrap() <= row.current_peak_a.unwrap());
    }
    let motor = found.motor.unwrap();
    near(motor.torque_peak_nm.unwrap(), 0.125 * current(K), 1e-12, "T_mot settled");
    near(motor.torque_peak_cold_nm.unwrap(), 0.125 * only.current_peak_cold_a.unwrap(), 1e-12, "T_mot cold");
    // With the friction of the settled gear alone the settled columns are the same: nothing of the cold state is in them.
    let warm = Operation::of(&manual(0.3, 1.0), &actuator()).unwrap();
    let settled = |load: &SegmentLoad| SegmentLoad { current_peak_cold_a: None, ..*load };
    assert_eq!(settled(only), settled(&warm.segments[0]));
    assert_eq!(settled(&found.cycle), settled(&warm.cycle));
}
