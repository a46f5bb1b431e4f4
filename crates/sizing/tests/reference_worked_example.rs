//! Reference values by other hands; no tool rewrites this file.
//!
//! The worked example of cha-manual section 7.1 (tables 71.1 and 71.3). The figures of the solution are lost with
//! the drawing; the exact values below were computed by hand from eqs. 69.1 to 69.4, the rounded ones are printed in
//! the English edition 1018854 (8/2018, V03, page 72).
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use mechanism::Mechanism;
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use quantities::unit::{KILOGRAM_SQUARE_METRE, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Angle, AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use sizing::Axis;
use testkit::agrees;

fn example() -> (Axis, MomentOfInertia) {
    let s = |t| Time::new_in(t, &SECOND);
    let only = SegmentSpec::Manual(ManualMove {
        speed: AngularVelocity::new_in(40.0, &REVOLUTION_PER_MINUTE),
        accelerate: s(0.1),
        run: s(0.1),
        brake: s(0.1),
        pause: s(1.0),
    });
    let motion = Motion::new(&[only], Some(Angle::from_si(0.0)), Closing::Speed).unwrap();
    let load =
        Mechanism::direct(MomentOfInertia::new_in(1.3, &KILOGRAM_SQUARE_METRE), Torque::new_in(5.0, &NEWTON_METRE));
    (Axis::new(load, motion, Vec::new()), MomentOfInertia::new_in(1.063, &KILOGRAM_SQUARE_METRE))
}

#[test]
fn the_manual_procedure_gives_the_worked_example() {
    let (axis, own) = example();
    let manual = axis.manual_demand(own).unwrap();
    let [only] = &manual.moves[..] else { panic!("one move") };
    assert!(agrees(only.accelerate.in_unit(&NEWTON_METRE), "103.98"), "T_1");
    assert!(agrees(only.run.in_unit(&NEWTON_METRE), "5.00"), "T_2");
    assert!(agrees(only.brake.in_unit(&NEWTON_METRE), "-93.98"), "T_3");
    assert!(agrees(manual.demand.torque_rms.in_unit(&NEWTON_METRE), "38.90"), "T_rms");
    assert!(agrees(manual.demand.speed_mean.in_unit(&REVOLUTION_PER_MINUTE), "6.15"), "n_av");
    assert!(agrees(manual.demand.duty_factor * 100.0, "23.08"), "ED");
    assert!(!manual.braking_assumed);
}

#[test]
fn the_exact_integral_gives_the_same() {
    let (axis, own) = example();
    let (manual, exact) = (axis.manual_demand(own).unwrap().demand, axis.demand(own));
    for (a, b) in [
        (manual.torque_rms.si(), exact.torque_rms.si()),
        (manual.torque_peak.si(), exact.torque_peak.si()),
        (manual.speed_mean.si(), exact.speed_mean.si()),
        (manual.duty_factor, exact.duty_factor),
    ] {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
    }
}

/// The print rounds coarsely; its figures are met within 0.3 % of torque and within the last digit of n_av and ED.
#[test]
fn the_printed_solution_is_met_within_its_rounding() {
    let (axis, own) = example();
    let manual = axis.manual_demand(own).unwrap();
    for (value, printed) in [
        (manual.moves[0].accelerate.si(), 103.8),
        (manual.moves[0].brake.si(), -93.8),
        (manual.demand.torque_rms.si(), 38.8),
    ] {
        assert!(((value - printed) / printed).abs() < 0.003, "{value} {printed}");
    }
    assert!(agrees(manual.demand.speed_mean.in_unit(&REVOLUTION_PER_MINUTE), "6"));
    assert!(agrees(manual.demand.duty_factor * 100.0, "23"));
    assert!(((3.0 * own.si()) - 3.19).abs() < 0.005, "3 J_out");
}

/// Compares the same example for FHA-25C-50L in the English edition 12/2015 (V01, page 67): J_out = 0.86, computed
/// 95.5, 35.6.
#[test]
fn the_older_example_with_another_inertia() {
    let (axis, _) = example();
    let manual = axis.manual_demand(MomentOfInertia::from_si(0.86)).unwrap();
    assert!(agrees(manual.moves[0].accelerate.si(), "95.5"));
    assert!(agrees(manual.demand.torque_rms.si(), "35.6"));
}
