use super::*;
use crate::{MoveFault, Needed};
use quantities::Measure;

const NORMALISED: [Law; 7] = [
    Law::Trapezoid,
    Law::Triangle,
    Law::Polynomial5,
    Law::ModifiedSine,
    Law::ModifiedTrapezoid,
    Law::SimpleSine,
    Law::InclinedSine,
];

/// Returns position and speed at the end of a chain of pieces, and its largest speed and acceleration.
fn run(pieces: &[Piece]) -> (f64, f64, f64, f64) {
    let (mut q, mut w, mut v_max, mut a_max) = (0.0, 0.0, 0.0_f64, 0.0_f64);
    for piece in pieces {
        let piece = Piece { position_rad: q, speed_rad_s: w, ..*piece };
        for step in 0..=1000 {
            let state = piece.at(piece.duration_s * f64::from(step) / 1000.0);
            v_max = v_max.max(state.speed_rad_s.abs());
            a_max = a_max.max(state.acceleration_rad_s2.abs());
        }
        (q, w) = (piece.end().position_rad, piece.end().speed_rad_s);
    }
    (q, w, v_max, a_max)
}

/// Characteristic values of VDI 2143 as stated in tables of cam design, compared to their last digit.
#[test]
#[allow(clippy::approx_constant, reason = "printed digits")]
fn the_characteristic_values_are_the_published_ones() {
    let published = [
        (Law::Triangle, 2.0, 4.0),
        (Law::Polynomial5, 1.88, 5.77),
        (Law::ModifiedSine, 1.76, 5.53),
        (Law::ModifiedTrapezoid, 2.0, 4.89),
        (Law::SimpleSine, 1.57, 4.93),
        (Law::InclinedSine, 2.0, 6.283),
    ];
    for (law, c_v, c_a) in published {
        let (v, a) = law.characteristics();
        assert!((v - c_v).abs() <= 0.0051 && (a - c_a).abs() <= 0.0051, "{law:?}: {v} {a}");
    }
}

#[test]
fn every_law_arrives_at_rest_with_its_characteristic_values() {
    for law in NORMALISED {
        let (s, t) = (1.7, 0.6);
        let (q, w, v_max, a_max) = run(&law.normalised(s, t));
        let (c_v, c_a) = law.characteristics();
        assert!((q - s).abs() < 1e-12, "{law:?} arrives at {q}");
        assert!(w.abs() < 1e-12, "{law:?} ends with {w}");
        assert!((v_max / (c_v * s / t) - 1.0).abs() < 2e-6, "{law:?} v {v_max}");
        assert!((a_max / (c_a * s / (t * t)) - 1.0).abs() < 2e-6, "{law:?} a {a_max}");
    }
}

fn given(distance: Option<f64>, time: Option<f64>, speed: Option<f64>, acceleration: Option<f64>) -> Given {
    Given {
        distance: distance.map(Angle::from_si),
        time: time.map(Time::from_si),
        speed: speed.map(AngularVelocity::from_si),
        acceleration: acceleration.map(AngularAcceleration::from_si),
        ..Given::default()
    }
}

/// Any two quantities determine the same move as any other two.
#[test]
fn any_two_of_four_give_the_same_move() {
    for law in NORMALISED {
        let (s, t) = (-2.5, 0.8);
        let (c_v, c_a) = law.characteristics();
        let (v, a) = (c_v * s / t, c_a * s.abs() / (t * t));
        let pairs = [
            given(Some(s), Some(t), None, None),
            given(Some(s), None, Some(v), None),
            given(Some(s), None, None, Some(a)),
            given(None, Some(t), Some(v), None),
            given(None, None, Some(v), Some(a)),
        ];
        for pair in pairs {
            let pieces = law.pieces(&pair, 0.0).unwrap();
            let (q, w, ..) = run(&pieces);
            let duration: f64 = pieces.iter().map(|piece| piece.duration_s).sum();
            assert!((q - s).abs() < 1e-12 && w.abs() < 1e-12 && (duration - t).abs() < 1e-12, "{law:?} {pair:?}");
        }
        // Time and acceleration have no direction: the move goes forward.
        let (q, ..) = run(&law.pieces(&given(None, Some(t), None, Some(a)), 0.0).unwrap());
        assert!((q + s).abs() < 1e-12, "{law:?}");
    }
}

#[test]
fn three_of_four_give_the_same_trapezoid() {
    // 0.2 s at 10 rad/s², 0.5 s at 2 rad/s, 0.2 s back: 1.4 rad in 0.9 s.
    for three in [
        given(Some(1.4), Some(0.9), Some(2.0), None),
        given(Some(1.4), Some(0.9), None, Some(10.0)),
        given(Some(1.4), None, Some(2.0), Some(10.0)),
        given(None, Some(0.9), Some(2.0), Some(10.0)),
    ] {
        let pieces = Law::Trapezoid.pieces(&three, 0.0).unwrap();
        let (q, w, v, a) = run(&pieces);
        assert!((q - 1.4).abs() < 1e-12 && w.abs() < 1e-12, "{three:?}");
        assert!((v - 2.0).abs() < 1e-12 && (a - 10.0).abs() < 1e-10, "{three:?}");
    }
}

#[test]
fn impossible_moves_say_what_would_be_possible() {
    let fault = |law: Law, given: Given| law.pieces(&given, 0.0).unwrap_err();
    assert_eq!(
        fault(Law::Trapezoid, given(Some(1.0), Some(1.0), Some(0.9), None)),
        MoveFault::SpeedTooLow { above: AngularVelocity::from_si(1.0) }
    );
    assert_eq!(
        fault(Law::Trapezoid, given(Some(1.0), Some(1.0), Some(2.1), None)),
        MoveFault::SpeedTooHigh { most: AngularVelocity::from_si(2.0) }
    );
    assert_eq!(
        fault(Law::Trapezoid, given(Some(1.0), Some(1.0), None, Some(3.9))),
        MoveFault::AccelerationTooLow { least: AngularAcceleration::from_si(4.0) }
    );
    assert!(matches!(
        fault(Law::Triangle, given(Some(1.0), None, None, None)),
        MoveFault::NotDetermined { given: 1, .. }
    ));
    assert!(matches!(
        fault(Law::SimpleSine, given(Some(1.0), Some(1.0), Some(1.0), None)),
        MoveFault::NotDetermined { given: 3, .. }
    ));
    assert_eq!(Law::ModifiedSine.pieces(&given(Some(1.0), Some(1.0), None, None), 0.5), Err(MoveFault::RestToRestOnly));
}

#[test]
fn boundary_speeds_are_met() {
    let quintic = Given { end_speed: Some(AngularVelocity::from_si(-0.4)), ..given(Some(1.0), Some(0.7), None, None) };
    let piece = Law::Polynomial5.pieces(&quintic, 0.9).unwrap()[0];
    let end = Piece { speed_rad_s: 0.9, ..piece }.end();
    assert!((end.position_rad - 1.0).abs() < 1e-12 && (end.speed_rad_s + 0.4).abs() < 1e-12);
    assert!(end.acceleration_rad_s2.abs() < 1e-10);
    let ramped =
        Given { end_speed: Some(AngularVelocity::from_si(1.0)), ..given(Some(1.4), None, Some(2.0), Some(10.0)) };
    let mut state = (0.0, 0.5);
    for piece in Law::Trapezoid.pieces(&ramped, 0.5).unwrap() {
        let end = Piece { position_rad: state.0, speed_rad_s: state.1, ..piece }.end();
        state = (end.position_rad, end.speed_rad_s);
    }
    assert!((state.0 - 1.4).abs() < 1e-12 && (state.1 - 1.0).abs() < 1e-12, "{state:?}");
}

/// With all four quantities every law has too many of them, and with none too few.
#[test]
fn all_quantities_are_more_than_a_law_needs() {
    for law in Law::ALL {
        for (value, is_over) in [(Some(1.0), true), (None, false)] {
            let found = law.pieces(&given(value, value, value, value), 0.0);
            let Err(MoveFault::NotDetermined { given, needed }) = found else { panic!("{law:?}") };
            // Limits of the jerk need the jerk beside distance, speed and acceleration instead of the time.
            assert_eq!(given > needed.most(), is_over && needed != Needed::DistanceAndLimits, "{law:?} {needed:?}");
        }
    }
}
