use super::*;
use quantities::AngularJerk;
use quantities::unit::{REVOLUTION_PER_MINUTE, SECOND};
use std::sync::Arc;

fn one(speed: f64, [t1, t2, t3, tp]: [f64; 4]) -> SegmentSpec {
    let s = |t| Time::new_in(t, &SECOND);
    SegmentSpec::Manual(ManualMove {
        speed: AngularVelocity::new_in(speed, &REVOLUTION_PER_MINUTE),
        accelerate: s(t1),
        run: s(t2),
        brake: s(t3),
        pause: s(tp),
    })
}

fn chain(segments: &[SegmentSpec]) -> Result<Motion, Vec<MotionFault>> {
    Motion::new(segments, Some(Angle::from_si(0.0)), Closing::Speed)
}

fn jerk(distance: f64, end_speed: f64) -> SegmentSpec {
    SegmentSpec::Move(
        Law::Jerk,
        Given {
            distance: Some(Angle::from_si(distance)),
            speed: Some(AngularVelocity::from_si(3.0)),
            acceleration: Some(AngularAcceleration::from_si(20.0)),
            jerk: Some(AngularJerk::from_si(400.0)),
            end_speed: Some(AngularVelocity::from_si(end_speed)),
            time: None,
        },
    )
}

#[test]
fn the_pieces_follow_each_other_without_a_jump() {
    let motion = chain(&[
        one(40.0, [0.1, 0.2, 0.3, 1.0]),
        one(-20.0, [0.2, 0.0, 0.2, 0.0]),
        jerk(1.5, 1.0),
        jerk(-2.0, 0.0),
        SegmentSpec::Dwell(Time::from_si(0.4), Hold::Brake),
    ])
    .unwrap();
    for pair in motion.pieces().windows(2) {
        let end = pair[0].end();
        assert!((pair[0].start_s + pair[0].duration_s - pair[1].start_s).abs() < 1e-12);
        assert!((end.speed_rad_s - pair[1].speed_rad_s).abs() < 1e-12, "speed jumps");
        assert!((end.position_rad - pair[1].position_rad).abs() < 1e-12, "position jumps");
    }
    let sum: f64 = motion.stretches().iter().map(|stretch| stretch.duration.si()).sum();
    assert!((sum - motion.duration().si()).abs() < 1e-12);
    let solved = motion.stretches()[2].solved.unwrap();
    assert!((solved.distance.si() - 1.5).abs() < 1e-12);
    assert!(solved.speed.si() <= 3.0 + 1e-12 && solved.acceleration.si() <= 20.0 + 1e-9);
    assert!(motion.manual().is_none(), "not only the manual's moves");
}

#[test]
fn a_move_without_speed_is_rest() {
    let motion = chain(&[one(0.0, [0.0, 1.0, 0.0, 1.0])]).unwrap();
    assert!(motion.pieces().iter().all(Piece::is_rest));
}

#[test]
fn what_is_no_motion_is_refused_with_every_fault() {
    let whole = |fault| Err(vec![MotionFault { segment: None, fault }]);
    assert_eq!(chain(&[]), whole(MoveFault::NoSegment));
    assert_eq!(chain(&[one(0.0, [0.0; 4])]), whole(MoveFault::NoDuration));
    assert_eq!(
        chain(&[one(1.0, [0.0, 1.0, 1.0, 0.0]), one(1.0, [1.0, -1.0, 1.0, 0.0])]),
        Err(vec![
            MotionFault { segment: Some(0), fault: MoveFault::NoTimeToChangeSpeed { braking: false } },
            MotionFault { segment: Some(1), fault: MoveFault::OutOfRange },
        ])
    );
    assert_eq!(
        chain(&[jerk(1.0, 0.5), SegmentSpec::Dwell(Time::from_si(1.0), Hold::Motor)]),
        Err(vec![MotionFault {
            segment: Some(1),
            fault: MoveFault::StillMoving { speed: AngularVelocity::from_si(0.5) }
        }])
    );
    assert_eq!(
        chain(&[jerk(1.0, 0.5)]),
        whole(MoveFault::SpeedNotClosed { end: AngularVelocity::from_si(0.5), start: AngularVelocity::from_si(0.0) })
    );
}

#[test]
fn the_closing_asks_for_what_the_load_needs() {
    let there = [jerk(1.5, 0.0)];
    let at = |closing| Motion::new(&there, Some(Angle::from_si(0.2)), closing);
    assert!(at(Closing::Speed).is_ok());
    assert!(at(Closing::SingleMove).is_ok());
    assert!(matches!(at(Closing::Position).unwrap_err()[0].fault, MoveFault::PositionNotClosed { .. }));
    assert!(matches!(at(Closing::Revolutions).unwrap_err()[0].fault, MoveFault::PositionNotClosed { .. }));
    let back = [jerk(1.5, 0.0), jerk(-1.5, 0.0)];
    assert!(Motion::new(&back, Some(Angle::from_si(0.0)), Closing::Position).is_ok());
    let round = [jerk(std::f64::consts::TAU, 0.0)];
    assert!(Motion::new(&round, Some(Angle::from_si(0.0)), Closing::Revolutions).is_ok());
}

fn recorded(samples: crate::Samples) -> SegmentSpec {
    SegmentSpec::Recorded(Arc::new(Recorded::new(samples, crate::Treatment::default()).unwrap()))
}

fn half_turn() -> crate::Samples {
    let time_s: Vec<f64> = (0..=100).map(|k| f64::from(k) * 0.01).collect();
    let position = time_s.iter().map(|t| 0.5 - 0.5 * (std::f64::consts::TAU * t).cos());
    crate::Samples {
        position_rad: Some(Arc::new(position.collect())),
        time_s: time_s.into(),
        ..crate::Samples::default()
    }
}

#[test]
fn a_recording_stands_where_it_says_unless_the_start_is_stated() {
    let segments = [recorded(half_turn())];
    let begin = |start: Option<f64>| {
        let motion = Motion::new(&segments, start.map(Angle::from_si), Closing::Position).unwrap();
        motion.recordings()[0].interval(0).unwrap().position_rad[0]
    };
    assert_eq!(begin(None), 0.0);
    assert_eq!(begin(Some(1.5)), 1.5);
    let motion = Motion::new(&segments, None, Closing::Position).unwrap();
    assert!((motion.duration().si() - 1.0).abs() < 1e-12 && motion.net().si().abs() < 1e-12);
    let slow = motion.stretched(2.0);
    let (a, b) = (motion.recordings()[0].interval(10).unwrap(), slow.recordings()[0].interval(10).unwrap());
    assert!((b.start_s - 2.0 * a.start_s).abs() < 1e-12 && (b.duration_s - 2.0 * a.duration_s).abs() < 1e-12);
    assert!((b.speed_rad_s[1] - a.speed_rad_s[1] / 2.0).abs() < 1e-12);
    assert_eq!(slow.duration().si(), 2.0);
}

#[test]
fn a_recording_that_jumps_or_does_not_close_is_reported() {
    let fault = |segments: &[SegmentSpec]| Motion::new(segments, None, Closing::Position).unwrap_err()[0].fault;
    let mut open = half_turn();
    Arc::make_mut(open.position_rad.as_mut().unwrap()).truncate(60);
    Arc::make_mut(&mut open.time_s).truncate(60);
    assert!(matches!(fault(&[recorded(open.clone())]), MoveFault::SpeedNotClosed { .. }));
    assert!(Motion::new(&[recorded(open.clone())], None, Closing::SingleMove).is_ok());
    let dwell = SegmentSpec::Dwell(Time::from_si(0.1), Hold::Motor);
    assert!(matches!(fault(&[recorded(open), dwell.clone()]), MoveFault::StillMoving { .. }));
    let mut elsewhere = half_turn();
    Arc::make_mut(elsewhere.position_rad.as_mut().unwrap()).iter_mut().for_each(|q| *q += 0.3);
    assert!(matches!(
        fault(&[recorded(half_turn()), recorded(elsewhere)]),
        MoveFault::RecordingPositionJumps { gap } if (gap.si() - 0.3).abs() < 1e-9
    ));
    let mut moving = half_turn();
    Arc::make_mut(&mut moving.time_s).drain(..20);
    Arc::make_mut(moving.position_rad.as_mut().unwrap()).drain(..20);
    assert!(matches!(fault(&[dwell, recorded(moving)]), MoveFault::RecordingSpeedJumps { .. }));
}

/// The distance of a list of points that returns to its start is zero, at any position and through any number of points.
#[test]
fn a_return_to_the_start_has_no_distance() {
    for count in 3..60_u32 {
        for start in [0.0, 0.3, -17.0, 400.0] {
            let at = |k: u32| {
                let turned = if k == count { 0.0 } else { (f64::from(k) * 0.7).sin() };
                (Time::from_si(0.1 * f64::from(k)), Angle::from_si(start + turned))
            };
            let points: Vec<_> = (0..=count).map(at).collect();
            let made = Points::new(&points, crate::Spline::Quintic, crate::Ends::Rest).unwrap();
            let motion = chain(&[SegmentSpec::Points(Arc::new(made))]).unwrap();
            assert_eq!(motion.stretches()[0].solved.unwrap().distance.si(), 0.0, "{count} {start}");
        }
    }
}
