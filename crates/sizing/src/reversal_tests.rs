//! The direction of a move is that of its law: rounding at its ends makes no reversal, and so no jump of the friction.

use crate::axis::Axis;
use mechanism::{Extra, Mechanism, Output};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::{Angle, AngularAcceleration, AngularJerk, AngularVelocity, Measure, MomentOfInertia, Time, Torque};

/// Uniform pseudo-random numbers, the same in every run.
struct Random(u64);

impl Random {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// Returns a number over several powers of ten.
    fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }
}

fn by_time(law: Law, distance: f64, time: f64) -> SegmentSpec {
    let given = Given { distance: Some(Angle::from_si(distance)), time: Some(Time::from_si(time)), ..Given::default() };
    SegmentSpec::Move(law, given)
}

fn by_limits(law: Law, distance: f64, [speed, acceleration, jerk]: [f64; 3], end_speed: Option<f64>) -> SegmentSpec {
    SegmentSpec::Move(
        law,
        Given {
            distance: Some(Angle::from_si(distance)),
            speed: Some(AngularVelocity::from_si(speed)),
            acceleration: Some(AngularAcceleration::from_si(acceleration)),
            jerk: (law == Law::Jerk).then(|| AngularJerk::from_si(jerk)),
            end_speed: end_speed.map(AngularVelocity::from_si),
            time: None,
        },
    )
}

/// Returns a constant torque in one direction in every segment.
fn pull(segments: usize) -> Vec<Extra> {
    let mut extra = Extra::none();
    extra.torque = Torque::from_si(-20.0);
    vec![extra; segments]
}

/// Returns a load with friction and losses.
fn load() -> Mechanism {
    let mut load = Mechanism::direct(MomentOfInertia::from_si(0.3), Torque::from_si(5.0));
    load.efficiency_driving = 0.9;
    load.efficiency_driven = 0.6;
    load
}

/// Returns T_peak of densely sampled pieces, with the direction of each instant from `direction` (piece, time in it).
fn sampled(axis: &Axis, own: f64, mut direction: impl FnMut(&motion::Piece, f64) -> f64) -> f64 {
    let none = Extra::none();
    let mut peak = 0.0_f64;
    for piece in axis.motion.pieces() {
        for step in 0..=400 {
            let t = piece.duration_s * f64::from(step) / 400.0;
            let (state, direction) = (piece.at(t), direction(piece, t));
            if direction == 0.0 {
                continue;
            }
            let output = Output {
                position_rad: state.position_rad,
                speed_rad_s: state.speed_rad_s,
                acceleration_rad_s2: state.acceleration_rad_s2,
                direction,
            };
            let extra = axis.extras.get(piece.segment).unwrap_or(&none);
            peak = peak.max((own * state.acceleration_rad_s2 + axis.mechanism.torque(&output, extra)).abs());
        }
    }
    peak
}

/// The move that showed it: friction 5 Nm against a pull of 20 Nm, lowered by a modified sine and by a jerk-limited move.
/// Downwards 20 − 5 Nm hold the load, upwards nothing moves.
#[test]
fn a_move_that_ends_does_not_go_back() {
    let degrees = std::f64::consts::PI / 180.0;
    let speed = 16.2 * std::f64::consts::TAU / 60.0;
    let segments = [
        by_time(Law::ModifiedSine, -45.0 * degrees, 0.8),
        by_limits(Law::Jerk, 45.0 * degrees, [speed, 1.35, 1650.0], None),
    ];
    let load = Mechanism::direct(MomentOfInertia::from_si(0.001), Torque::from_si(5.0));
    let motion = Motion::new(&segments, None, Closing::Position).unwrap();
    let axis = Axis::new(load, motion, [vec![Extra::none()], pull(1)].concat());
    let peak = axis.demand(MomentOfInertia::from_si(0.001)).torque_peak.si();
    assert!((peak - 15.0).abs() < 0.01, "{peak}");
}

/// Requires that every law from rest to rest keeps its direction to the end, so that friction never changes its
/// direction.
#[test]
fn moves_between_rests_keep_their_direction() {
    let mut random = Random(7);
    let laws = Law::ALL.into_iter().filter(|law| *law != Law::Constant).collect::<Vec<_>>();
    for case in 0..3_000 {
        let law = laws[case % laws.len()];
        let distance = random.scale(1e-3, 60.0) * if random.within(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
        let limits = [random.scale(0.01, 50.0), random.scale(0.1, 1e3), random.scale(1.0, 1e7)];
        let segment = if law == Law::Jerk || (law == Law::Trapezoid && case % 2 == 0) {
            by_limits(law, distance, limits, None)
        } else {
            by_time(law, distance, random.scale(0.01, 10.0))
        };
        let motion = Motion::new(std::slice::from_ref(&segment), None, Closing::SingleMove).unwrap();
        for piece in motion.pieces() {
            assert_eq!(piece.reversals(), Vec::<f64>::new(), "{case}: {segment:?}");
            let runs = piece.runs();
            for share in [0.0, 1e-12, 0.5, 1.0 - 1e-12, 1.0] {
                assert_eq!(runs.direction(share * piece.duration_s), distance.signum(), "{case}: {segment:?}");
            }
        }
        let axis = Axis::new(load(), motion, pull(1));
        let own = 0.2;
        let (found, brute) = (
            axis.demand(MomentOfInertia::from_si(own)).torque_peak.si(),
            sampled(&axis, own, |_, _| distance.signum()),
        );
        assert!((found - brute).abs() <= 1e-4 * brute, "{case}: {found} {brute} {segment:?}");
        assert!((axis.moments().angle_travelled.si() - distance.abs()).abs() <= 1e-9 * distance.abs(), "{case}");
    }
}

/// Between two speeds a move reverses where its speed changes sign and nowhere else.
#[test]
fn moves_between_speeds_reverse_where_their_law_does() {
    let mut random = Random(11);
    let mut reversing = 0;
    for case in 0..2_000 {
        let limits = [random.scale(0.5, 10.0), random.scale(1.0, 100.0), random.scale(10.0, 1e5)];
        let [first, last] = [0, 1].map(|_| match random.within(0.0, 3.0) {
            kind if kind < 1.0 => 0.0,
            kind if kind < 1.5 => limits[0],
            _ => random.within(-1.0, 1.0) * limits[0],
        });
        let into = by_limits(Law::Jerk, first * 3.0 + 1e-3, limits, Some(first));
        let law = [Law::Jerk, Law::Trapezoid, Law::Polynomial5][case % 3];
        let distance = random.within(-6.0, 6.0);
        let segment = if law == Law::Polynomial5 {
            let SegmentSpec::Move(law, given) = by_time(law, distance, random.scale(0.1, 3.0)) else { return };
            SegmentSpec::Move(law, Given { end_speed: Some(AngularVelocity::from_si(last)), ..given })
        } else {
            by_limits(law, distance, limits, Some(last))
        };
        let motion = Motion::new(&[into, segment], None, Closing::SingleMove).unwrap();
        let fastest = motion.pieces().iter().flat_map(|piece| {
            (0..=400).map(|step| piece.at(piece.duration_s * f64::from(step) / 400.0).speed_rad_s.abs())
        });
        let least = 1e-9 * fastest.fold(0.0, f64::max);
        let found: usize = {
            let runs = motion.pieces().iter().flat_map(|piece| {
                let mut ends = piece.reversals();
                ends.push(piece.duration_s);
                let runs = piece.runs();
                ends.into_iter().map(move |end| runs.direction(end)).collect::<Vec<_>>()
            });
            let runs: Vec<f64> = runs.collect();
            runs.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
        };
        let mut signs = motion
            .pieces()
            .iter()
            .flat_map(|piece| (0..=400).map(|step| piece.at(piece.duration_s * f64::from(step) / 400.0).speed_rad_s));
        let (mut expected, mut sign) = (0, 0.0);
        for speed in signs.by_ref().filter(|speed| speed.abs() > least) {
            expected += usize::from(sign * speed < 0.0);
            sign = speed.signum();
        }
        // A swing back between two samples is seen by the law only.
        if found != expected {
            assert!(found > expected && law == Law::Polynomial5, "{case}: {found} {expected} {:?}", motion.pieces());
        }
        reversing += usize::from(found > 0);
        let axis = Axis::new(load(), motion, pull(2));
        let (own, mut last) = (0.2, 0.0);
        let brute = sampled(&axis, own, |piece, t| {
            let speed = piece.at(t).speed_rad_s;
            last = if speed.abs() > least { speed.signum() } else { last };
            last
        });
        let peak = axis.demand(MomentOfInertia::from_si(own)).torque_peak.si();
        assert!(peak >= brute * (1.0 - 1e-9) && peak <= brute * 1.02, "{case}: {peak} {brute}");
    }
    assert!(reversing > 250, "{reversing}");
}
