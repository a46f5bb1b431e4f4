use super::*;
use mechanism::{Extra, Mechanism, Output};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use quantities::Angle;

fn axis(inertia: f64, friction: f64, moves: &[(f64, [f64; 4])]) -> Axis {
    let s = Time::from_si;
    let moves = moves
        .iter()
        .map(|(speed, [t1, t2, t3, tp])| {
            SegmentSpec::Manual(ManualMove {
                speed: AngularVelocity::from_si(*speed),
                accelerate: s(*t1),
                run: s(*t2),
                brake: s(*t3),
                pause: s(*tp),
            })
        })
        .collect::<Vec<_>>();
    let load = Mechanism::direct(MomentOfInertia::from_si(inertia), Torque::from_si(friction));
    Axis::new(load, Motion::new(&moves, Some(Angle::from_si(0.0)), Closing::Speed).unwrap(), Vec::new())
}

const MOVES: &[(f64, [f64; 4])] =
    &[(4.0, [0.1, 0.2, 0.3, 0.4]), (-2.0, [0.5, 0.0, 0.1, 0.0]), (1.0, [0.2, 1.0, 0.2, 2.0])];

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * a.abs().max(b.abs()), "{a} {b}");
}

/// The integral of T² over each ramp, summed ramp by ramp instead of through the moments.
#[test]
fn the_moments_give_the_same_as_summing_the_ramps() {
    let axis = axis(1.3, 5.0, MOVES);
    let own = MomentOfInertia::from_si(0.7);
    let mut sum = 0.0;
    for piece in axis.motion.pieces() {
        let acceleration = piece.polynomial[0];
        let output = Output {
            position_rad: 0.0,
            speed_rad_s: 0.0,
            acceleration_rad_s2: acceleration,
            direction: if piece.is_rest() { 0.0 } else { piece.at(0.5 * piece.duration_s).speed_rad_s.signum() },
        };
        let torque = axis.mechanism.torque(&output, &Extra::none()) + own.si() * acceleration;
        sum += torque * torque * piece.duration_s;
    }
    close(axis.demand(own).torque_rms.si(), (sum / axis.motion.duration().si()).sqrt());
}

#[test]
fn without_friction_and_load_nothing_is_demanded() {
    let axis = axis(0.0, 0.0, MOVES);
    let demand = axis.demand(MomentOfInertia::from_si(0.0));
    assert_eq!((demand.torque_rms.si(), demand.torque_peak.si()), (0.0, 0.0));
}

#[test]
fn torque_scales_with_inertia_and_friction() {
    let own = MomentOfInertia::from_si(0.0);
    let (one, two) = (axis(1.0, 3.0, MOVES).demand(own), axis(2.0, 6.0, MOVES).demand(own));
    close(2.0 * one.torque_rms.si(), two.torque_rms.si());
    close(2.0 * one.torque_peak.si(), two.torque_peak.si());
}

#[test]
fn the_direction_of_a_move_changes_no_magnitude() {
    let mirrored: Vec<(f64, [f64; 4])> = MOVES.iter().map(|(speed, times)| (-speed, *times)).collect();
    let own = MomentOfInertia::from_si(0.7);
    let (a, b) = (axis(1.3, 5.0, MOVES), axis(1.3, 5.0, &mirrored));
    close(a.demand(own).torque_rms.si(), b.demand(own).torque_rms.si());
    close(a.demand(own).torque_peak.si(), b.demand(own).torque_peak.si());
    let rms = |axis: &Axis| axis.manual_demand(own).unwrap().demand.torque_rms.si();
    close(rms(&a), rms(&b));
}

#[test]
fn manual_and_integral_agree_where_braking_mirrors_accelerating() {
    let moves: &[(f64, [f64; 4])] = &[(4.0, [0.1, 0.2, 0.1, 0.4]), (-2.0, [0.5, 0.0, 0.5, 0.0])];
    let axis = axis(1.3, 5.0, moves);
    let own = MomentOfInertia::from_si(0.7);
    let (manual, exact) = (axis.manual_demand(own).unwrap(), axis.demand(own));
    assert!(!manual.braking_assumed);
    close(manual.demand.torque_rms.si(), exact.torque_rms.si());
    close(manual.demand.torque_peak.si(), exact.torque_peak.si());
    close(manual.demand.speed_mean.si(), exact.speed_mean.si());
    close(manual.demand.duty_factor, exact.duty_factor);
}

/// Braking in a third of the time needs three times the torque; eq. 69.2 does not see it, the integral does.
#[test]
fn short_braking_is_seen_by_the_integral_only() {
    let axis = axis(2.0, 0.0, &[(3.0, [0.3, 0.0, 0.1, 0.0])]);
    let own = MomentOfInertia::from_si(0.0);
    let (manual, exact) = (axis.manual_demand(own).unwrap(), axis.demand(own));
    assert!(manual.braking_assumed);
    close(manual.demand.torque_peak.si(), 20.0);
    close(exact.torque_peak.si(), 60.0);
    close(exact.torque_peak_at.si(), 0.3);
}

#[test]
fn the_governing_move_is_the_one_with_the_largest_torque() {
    let manual = axis(1.3, 5.0, MOVES).manual_demand(MomentOfInertia::from_si(0.7)).unwrap();
    assert_eq!(manual.governing, 0);
    assert_eq!(manual.moves.len(), 3);
    close(manual.demand.torque_peak.si(), manual.moves[0].accelerate.si());
}

#[test]
fn a_standing_axis_demands_nothing() {
    let axis = axis(1.0, 5.0, &[(0.0, [0.0, 1.0, 0.0, 1.0])]);
    let own = MomentOfInertia::from_si(1.0);
    assert_eq!(axis.demand(own).torque_rms.si(), 0.0);
    assert_eq!(axis.manual_demand(own).unwrap().demand.torque_rms.si(), 0.0);
    assert_eq!(axis.demand(own).duty_factor, 0.0);
}
