//! A cycle that begins in motion begins in the state of its first instant.

use super::{NOTHING, load, one_move, parameters};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Measure, Time};
use twin::{EventKind, Limits, Operation, Scenario, ScenarioId, Setup, Summary, Twin, averaged, settled};

const CODE: &str = "CHA-25A-50-H-C1024";

/// Returns a motion at one speed.
fn constant(rpm: f64, time_s: f64) -> Motion {
    let speed = Some(AngularVelocity::new_in(rpm, &REVOLUTION_PER_MINUTE));
    let given = Given { speed, time: Some(Time::from_si(time_s)), ..Given::default() };
    Motion::new(&[SegmentSpec::Move(Law::Constant, given)], None, Closing::Speed).unwrap()
}

/// Returns the results of a number of cycles.
fn run(setup: &Setup<'_>, cycles: u32) -> Summary {
    let scenario = Scenario { cycles, ..setup.scenario };
    let mut twin = Twin::new(&Setup { scenario, ..*setup }).unwrap();
    twin.advance(u64::MAX);
    assert!(!twin.events().iter().any(|event| event.kind == EventKind::Diverged));
    twin.summary()
}

/// Over directions, speeds and loads, in cycles of one turn (the error of the gear is that of the turn): torque, speed, current and following error of the first
/// cycle are those of three, the energy balance closes, and a small limit of the following error trips nothing.
#[test]
fn the_first_cycle_is_like_the_others() {
    let parameters = parameters(CODE);
    let extras = NOTHING();
    for (rpm, time_s, inertia, friction) in
        [(60.0, 1.0, 0.5, 3.0), (-60.0, 1.0, 0.5, 3.0), (100.0, 0.6, 0.1, 0.0), (25.0, 2.4, 3.0, 10.0)]
    {
        let (mechanism, motion) = (load(inertia, friction), constant(rpm, time_s));
        let setup = Setup::of(&parameters, &mechanism, &motion, &extras);
        let (one, three) = (run(&setup, 1), run(&setup, 3));
        let near = |a: f64, b: f64, share: f64, what: &str| {
            assert!((a / b - 1.0).abs() < share, "{what} of {rpm} 1/min, {inertia} kgm²: {a} {b}");
        };
        near(one.speed_peak_rad_s, three.speed_peak_rad_s, 2e-3, "speed");
        near(one.torque_peak_nm, three.torque_peak_nm, 0.05, "torque");
        near(one.torque_rms_nm, three.torque_rms_nm, 0.05, "rms torque");
        near(one.current_peak_a, three.current_peak_a, 0.05, "current");
        near(one.following_peak_rad, three.following_peak_rad, 0.1, "following error");
        assert!(one.unaccounted_j.abs() < 1e-9 * one.throughput_j.max(1.0), "{one:?}");
        let limits = Limits { following_rad: Some(0.003), ..*Twin::new(&setup).unwrap().limits() };
        let mut twin = Twin::new(&Setup { limits: Some(limits), ..setup }).unwrap();
        twin.advance(u64::MAX);
        assert!(!twin.events().iter().any(|event| event.kind == EventKind::FollowingError), "{:?}", twin.events());
    }
}

/// The first row is the state of the motion: speed of axis and motor, torque of the load, and current of the sizing within
/// the ripple of the gear, which is off here.
#[test]
fn the_first_row_is_in_balance() {
    let (parameters, extras) = (parameters(CODE), NOTHING());
    let (mechanism, motion) = (load(0.5, 3.0), constant(60.0, 0.5));
    let switches =
        twin::Switches { hysteresis: false, kinematic_error: false, noise: false, ..twin::Switches::default() };
    let mut twin = Twin::new(&Setup { switches, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).unwrap();
    let (first, speed) = (twin.sample(), REVOLUTION_PER_MINUTE.to_si(60.0));
    twin.advance(4000);
    let later = twin.sample();
    for row in [first, later] {
        assert!(
            (row.speed_rad_s / speed - 1.0).abs() < 1e-4 && (row.motor_rad_s / speed - 1.0).abs() < 1e-4,
            "{row:?}"
        );
        assert!((row.torque_nm / 3.0 - 1.0).abs() < 1e-3, "{row:?}");
    }
    assert!((first.current_q_a / later.current_q_a - 1.0).abs() < 1e-3, "{first:?} {later:?}");
    assert!(first.time_s == 0.0 && first.wanted_rad == 0.0 && first.overload == 0.0, "{first:?}");
}

/// The settled state is that of operation over a day, also where the first estimate from cold is above the shutdown
/// temperature (100 min⁻¹), and it is kept over further cycles.
#[test]
fn the_warm_start_is_that_of_days() {
    let (parameters, extras) = (parameters(CODE), NOTHING());
    for rpm in [60.0, 100.0] {
        let (mechanism, motion) = (load(0.5, 3.0), constant(rpm, 1.0));
        let setup = Setup { ambient_k: 313.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
        let start_k = settled(&setup, || true).unwrap().unwrap();
        let operation = Operation { periods: 1, period_s: 86_400.0, running_s: 86_400.0 };
        let day = averaged(&setup, operation, || true).unwrap().unwrap();
        assert!((start_k[0] - day.peak_k[0]).abs() < 1.0, "{rpm}: {start_k:?} {day:?}");
        assert!((start_k[1] - day.peak_k[1]).abs() < 1.0, "{rpm}: {start_k:?} {day:?}");
    }
}

/// A scenario whose run goes on behind the motion does not stop the axis at a blow there.
#[test]
fn the_axis_runs_on_behind_the_motion() {
    let (parameters, extras) = (parameters(CODE), NOTHING());
    let (mechanism, motion) = (load(0.5, 3.0), constant(60.0, 0.5));
    let cycle = Setup::of(&parameters, &mechanism, &motion, &extras);
    let scenario = Scenario { id: ScenarioId::LinkSag, at_s: Some(0.1), ..Scenario::default() };
    let (sag, plain) = (run(&Setup { scenario, ..cycle }, 1), run(&cycle, 3));
    assert!(sag.time_s > 0.9 && sag.torque_peak_nm < 1.05 * plain.torque_peak_nm, "{sag:?}");
}

/// A motion that begins at rest has no run-up: its first row is at rest.
#[test]
fn a_cycle_from_rest_begins_at_rest() {
    let (parameters, mechanism, extras) = (parameters(CODE), load(0.5, 3.0), NOTHING());
    let motion = one_move(30.0, 0.1, 0.2, 0.1);
    let first = Twin::new(&Setup::of(&parameters, &mechanism, &motion, &extras)).unwrap().sample();
    assert!(first.speed_rad_s == 0.0 && first.motor_rad_s == 0.0 && first.torque_nm == 0.0, "{first:?}");
}
