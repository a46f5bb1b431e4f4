use super::*;
use quantities::unit::{REVOLUTION_PER_MINUTE, SECOND};

fn one(speed: f64, [t1, t2, t3, tp]: [f64; 4]) -> ManualMove {
    let s = |t| Time::new_in(t, &SECOND);
    ManualMove {
        speed: AngularVelocity::new_in(speed, &REVOLUTION_PER_MINUTE),
        accelerate: s(t1),
        run: s(t2),
        brake: s(t3),
        pause: s(tp),
    }
}

#[test]
fn the_segments_follow_each_other_without_a_gap() {
    let cycle = Cycle::new(vec![one(40.0, [0.1, 0.2, 0.3, 1.0]), one(-20.0, [0.2, 0.0, 0.2, 0.0])]).unwrap();
    let segments: Vec<Segment> = cycle.segments().collect();
    assert_eq!(segments.len(), 6, "a run of zero duration and a pause of zero duration are no segments");
    for pair in segments.windows(2) {
        let end = pair[0].start + pair[0].duration;
        assert!((end.si() - pair[1].start.si()).abs() < 1e-15);
        assert!((pair[0].speed_end.si() - pair[1].speed_start.si()).abs() < 1e-15, "speed jumps");
    }
    let sum: f64 = segments.iter().map(|segment| segment.duration.si()).sum();
    assert!((sum - cycle.duration().si()).abs() < 1e-12);
}

#[test]
fn a_reversed_move_accelerates_against_the_positive_direction() {
    let cycle = Cycle::new(vec![one(-30.0, [0.5, 0.1, 0.5, 0.0])]).unwrap();
    let first = cycle.segments().next().unwrap();
    assert_eq!(first.phase, Phase::Accelerate);
    assert!((first.acceleration().si() - -(30.0 * std::f64::consts::TAU / 60.0) / 0.5).abs() < 1e-12);
    assert_eq!(first.direction, -1.0);
}

#[test]
fn a_move_without_speed_is_rest() {
    let cycle = Cycle::new(vec![one(0.0, [0.0, 1.0, 0.0, 1.0])]).unwrap();
    assert!(cycle.segments().all(|segment| segment.phase == Phase::Pause && segment.direction == 0.0));
}

#[test]
fn what_is_no_cycle_is_refused_with_every_fault() {
    assert_eq!(Cycle::new(vec![]), Err(vec![CycleFault::NoMove]));
    assert_eq!(Cycle::new(vec![one(0.0, [0.0; 4])]), Err(vec![CycleFault::NoDuration]));
    assert_eq!(
        Cycle::new(vec![one(1.0, [0.0, 1.0, 1.0, 0.0]), one(1.0, [1.0, -1.0, 1.0, 0.0])]),
        Err(vec![CycleFault::NoTimeToChangeSpeed { of_move: 0 }, CycleFault::TimeOutOfRange { of_move: 1 }])
    );
    assert_eq!(
        Cycle::new(vec![one(f64::NAN, [1.0, 1.0, 1.0, 0.0])]),
        Err(vec![CycleFault::SpeedOutOfRange { of_move: 0 }])
    );
}
