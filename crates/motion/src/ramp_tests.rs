use crate::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::unit::{DEGREE_PER_SECOND, REVOLUTION_PER_MINUTE};
use quantities::{Angle, AngularAcceleration, AngularJerk, AngularVelocity, Measure, Time};

struct Random(u64);

impl Random {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// A move by limits, in degrees.
#[derive(Clone, Copy, Debug)]
struct Ramp {
    law: Law,
    distance: f64,
    speed: f64,
    acceleration: f64,
    jerk: f64,
    end: f64,
}

impl Ramp {
    fn segment(&self) -> SegmentSpec {
        let given = Given {
            distance: Some(Angle::from_si(self.distance.to_radians())),
            speed: Some(AngularVelocity::new_in(self.speed, &DEGREE_PER_SECOND)),
            acceleration: Some(AngularAcceleration::from_si(self.acceleration.to_radians())),
            jerk: (self.law == Law::Jerk).then(|| AngularJerk::from_si(self.jerk.to_radians())),
            end_speed: (self.end != 0.0).then(|| AngularVelocity::new_in(self.end, &DEGREE_PER_SECOND)),
            time: None,
        };
        SegmentSpec::Move(self.law, given)
    }

    /// Distance of a plain change of speed, computed in degrees.
    fn plain(&self, first: f64) -> f64 {
        let change = (self.end - first).abs();
        let time = match self.law {
            Law::Jerk if change * self.jerk < self.acceleration * self.acceleration => {
                2.0 * (change / self.jerk).sqrt()
            }
            Law::Jerk => change / self.acceleration + self.acceleration / self.jerk,
            _ => change / self.acceleration,
        };
        0.5 * (first + self.end) * time
    }
}

fn constant(speed: AngularVelocity, time: f64) -> SegmentSpec {
    let given = Given { speed: Some(speed), time: Some(Time::from_si(time)), ..Given::default() };
    SegmentSpec::Move(Law::Constant, given)
}

fn motion(segments: &[SegmentSpec]) -> Motion {
    Motion::new(segments, None, Closing::Speed).unwrap()
}

fn state(motion: &Motion, t: f64) -> crate::State {
    let piece = motion.pieces().iter().rfind(|piece| piece.start_s <= t).unwrap();
    piece.at((t - piece.start_s).min(piece.duration_s))
}

/// Draws whole numbers, some digits and full digits.
fn number(random: &mut Random, low: f64, high: f64) -> f64 {
    let value = random.within(low, high);
    match random.within(0.0, 3.0) as u32 {
        0 => value.round(),
        1 => (value * 10.0).round() / 10.0,
        _ => value,
    }
}

/// A ramp up, a run and a ramp down as segments of their own are the one segment from rest to rest: the same pieces,
/// and the same states, for both laws with limits, in both directions, with distances up to rounding of their last
/// digits, a limit of speed above the speed reached or at it, and the speed of the run in another unit.
#[test]
fn a_move_in_three_segments_is_the_move_in_one() {
    let mut random = Random(17);
    for case in 0..6_000_u32 {
        let law = if case % 2 == 0 { Law::Trapezoid } else { Law::Jerk };
        let sign = if case % 3 == 0 { -1.0 } else { 1.0 };
        let speed = number(&mut random, 10.0, 180.0);
        let (acceleration, jerk) = (number(&mut random, 30.0, 700.0), number(&mut random, 100.0, 20_000.0));
        let up = Ramp { law, distance: 0.0, speed, acceleration, jerk, end: sign * speed };
        let off = [0.0, 2e-16, -2e-16, 1e-14, -1e-14, 2e-10, -2e-10][(case / 3 % 7) as usize];
        let distance = up.plain(0.0) * (1.0 + off);
        let (above, run) = (if case % 5 == 0 { 1.3 } else { 1.0 }, random.within(0.1, 1.0));
        let up = Ramp { distance, speed: above * speed, ..up };
        let down = Ramp { end: 0.0, ..up };
        let velocity = AngularVelocity::new_in(sign * speed, &DEGREE_PER_SECOND);
        // The same speed by another way, with rounding of its own.
        let written = AngularVelocity::new_in(sign * speed / 6.0, &REVOLUTION_PER_MINUTE);
        let run_at = if case % 4 < 2 { velocity } else { written };
        let three = motion(&[up.segment(), constant(run_at, run), down.segment()]);
        let whole = Ramp { distance: 2.0 * distance + sign * speed * run, speed, end: 0.0, ..up };
        let one = motion(&[whole.segment()]);
        assert_eq!(three.pieces().len(), one.pieces().len(), "{case} {up:?}\n{:?}\n{:?}", three.pieces(), one.pieces());
        assert!((three.net().si() / one.net().si() - 1.0).abs() < 2e-9, "{case} {up:?}");
        assert!((three.duration().si() / one.duration().si() - 1.0).abs() < 2e-9, "{case} {up:?}");
        assert!(three.stretches().iter().all(|stretch| stretch.overrun.is_none()), "{case} {up:?}");
        for (a, b) in three.pieces().iter().zip(one.pieces()) {
            let duration = one.duration().si();
            assert!((a.duration_s - b.duration_s).abs() < 2e-9 * duration, "{case} {up:?}: {a:?} {b:?}");
            for u in [0.0, 0.3, 1.0] {
                let (a, b) = (a.at(u * a.duration_s), b.at(u * b.duration_s));
                let acceleration = (a.acceleration_rad_s2 - b.acceleration_rad_s2).abs();
                assert!(acceleration < 1e-8 * up.acceleration.to_radians(), "{case} {up:?}: {a:?} {b:?}");
                assert!((a.speed_rad_s - b.speed_rad_s).abs() < 1e-8 * velocity.si().abs(), "{case} {up:?}");
            }
        }
        for k in 0..=50 {
            let share = f64::from(k) / 50.0;
            let (a, b) = (state(&three, share * three.duration().si()), state(&one, share * one.duration().si()));
            assert!((a.position_rad - b.position_rad).abs() < 2e-8 * one.net().si().abs(), "{case} {up:?}");
        }
    }
}

/// A change between two speeds accelerates in one direction where its distance is that of the change; where it is
/// shorter, the axis comes back and the move reports the distance that it lacks.
#[test]
fn a_plain_change_of_speed_has_one_direction_of_acceleration() {
    let mut random = Random(23);
    let (mut plain, mut short) = (0, 0);
    for case in 0..6_000_u32 {
        let law = if case % 2 == 0 { Law::Trapezoid } else { Law::Jerk };
        let (first, end) = (number(&mut random, 0.0, 150.0), number(&mut random, -80.0, 150.0));
        if first == 0.0 && end == 0.0 {
            continue;
        }
        let (acceleration, jerk) = (number(&mut random, 30.0, 700.0), number(&mut random, 100.0, 20_000.0));
        let change = Ramp { law, distance: 0.0, speed: first.max(end.abs()), acceleration, jerk, end };
        let full = change.plain(first);
        if full.abs() < 1e-3 || (first - end).abs() < 1e-3 {
            continue;
        }
        let off = [0.0, 2e-16, -2e-16, 1e-13, -1e-13, 5e-10, -5e-10, -1e-4, -1e-6][(case % 9) as usize];
        let change = Ramp { distance: full * (1.0 + off), ..change };
        let start = AngularVelocity::new_in(first, &DEGREE_PER_SECOND);
        let segments = [constant(start, 0.1), change.segment()];
        let segments = if first == 0.0 { &segments[1..] } else { &segments };
        let motion = Motion::new(segments, None, Closing::SingleMove).unwrap();
        let states = motion.pieces().iter().flat_map(|piece| [piece.at(0.0), piece.at(piece.duration_s)]);
        let accelerations: Vec<f64> = states.map(|state| state.acceleration_rad_s2).collect();
        let low = accelerations.iter().copied().fold(0.0, f64::min);
        let high = accelerations.iter().copied().fold(0.0, f64::max);
        let overrun = motion.stretches().last().unwrap().overrun;
        if off < -1e-9 {
            if end >= 0.0 {
                short += 1;
                assert!(low < 0.0 && high > 0.0, "{case} {first} {change:?}: {accelerations:?}");
                assert!((overrun.unwrap().si() / full.to_radians() - 1.0).abs() < 1e-12, "{case} {overrun:?}");
            }
        } else {
            plain += 1;
            let bound = acceleration.to_radians() * 2e-9;
            assert!(low.abs().min(high) < bound, "{case} {first} {off:e} {change:?}: {accelerations:?}");
            assert!(low.abs().max(high) <= acceleration.to_radians() * (1.0 + 2e-9), "{case} {change:?}");
            assert_eq!(overrun, None, "{case} {change:?}");
        }
    }
    assert!(plain > 3_000 && short > 500, "{plain} {short}");
}

/// A limit of speed that is the speed of the axis in another unit accelerates nothing.
#[test]
fn a_speed_at_the_limit_is_the_limit() {
    let mut random = Random(41);
    for _ in 0..2_000 {
        let speed = number(&mut random, 10.0, 180.0);
        let at = AngularVelocity::new_in(speed / 6.0, &REVOLUTION_PER_MINUTE);
        let law = if random.within(0.0, 1.0) < 0.5 { Law::Trapezoid } else { Law::Jerk };
        let brake = Ramp { law, distance: 0.0, speed, acceleration: 500.0, jerk: 9e3, end: 0.0 };
        let brake = Ramp { distance: 1.5 * brake.plain(speed), ..brake };
        let motion = motion_from(&[constant(at, 0.2), brake.segment()]);
        let mut ends = motion.pieces().iter().flat_map(|piece| [piece.at(0.0), piece.at(piece.duration_s)]);
        assert!(ends.all(|state| state.acceleration_rad_s2 <= 1e-9), "{speed} {:?}", motion.pieces());
    }
}

fn motion_from(segments: &[SegmentSpec]) -> Motion {
    Motion::new(segments, None, Closing::SingleMove).unwrap()
}

/// A trapezoid whose quantities leave no time to run is a triangle.
#[test]
fn a_trapezoid_without_a_run_is_a_triangle() {
    let mut random = Random(43);
    for _ in 0..3_000 {
        let (speed, time) = (number(&mut random, 1.0, 20.0), number(&mut random, 0.6, 3.0));
        let (distance, acceleration) = (0.5 * speed * time, 2.0 * speed / time);
        let of = |distance: Option<f64>, time: Option<f64>, speed: Option<f64>, acceleration: Option<f64>| {
            let given = Given {
                distance: distance.map(Angle::from_si),
                time: time.map(Time::from_si),
                speed: speed.map(AngularVelocity::from_si),
                acceleration: acceleration.map(AngularAcceleration::from_si),
                ..Given::default()
            };
            motion(&[SegmentSpec::Move(Law::Trapezoid, given)])
        };
        let (s, t, v, a) = (Some(distance), Some(time), Some(speed), Some(acceleration));
        for found in [of(s, None, v, a), of(None, t, v, a), of(s, t, None, a)] {
            assert_eq!(found.pieces().len(), 2, "{speed} {time}: {:?}", found.pieces());
            assert!((found.net().si() / distance - 1.0).abs() < 1e-9);
        }
    }
}
