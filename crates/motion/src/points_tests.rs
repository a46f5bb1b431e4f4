use super::*;
use crate::{Closing, Motion, MoveFault, SegmentSpec};

fn points(points: &[(f64, f64)]) -> Vec<(Time, Angle)> {
    points.iter().map(|(t, q)| (Time::from_si(*t), Angle::from_si(*q))).collect()
}

/// Returns unevenly spaced instants with the values of a function there.
fn of(f: impl Fn(f64) -> f64, count: u32) -> Vec<(Time, Angle)> {
    let at = |k: u32| {
        let s = f64::from(k) / f64::from(count - 1);
        let t = 0.2 + s + 0.3 * s * s;
        (t, f(t))
    };
    points(&(0..count).map(at).collect::<Vec<_>>())
}

fn motion(made: Points) -> Motion {
    Motion::new(&[SegmentSpec::Points(made.into())], None, Closing::SingleMove).unwrap()
}

fn stated(at: [f64; 2], derivatives: impl Fn(f64) -> (f64, f64)) -> Ends {
    let [first, last] = at.map(|t| {
        let (speed, acceleration) = derivatives(t);
        EndState { speed: AngularVelocity::from_si(speed), acceleration: AngularAcceleration::from_si(acceleration) }
    });
    Ends::Stated(first, last)
}

#[test]
fn a_polynomial_of_its_degree_is_met_exactly() {
    let cubic = |t: f64| 0.3 - t + 2.0 * t * t - 1.5 * t * t * t;
    let cubic_slopes = |t: f64| (-1.0 + 4.0 * t - 4.5 * t * t, 4.0 - 9.0 * t);
    let quintic = |t: f64| cubic(t) + 0.7 * t.powi(4) - 0.4 * t.powi(5);
    let quintic_slopes = |t: f64| {
        let (speed, acceleration) = cubic_slopes(t);
        (speed + 2.8 * t.powi(3) - 2.0 * t.powi(4), acceleration + 8.4 * t * t - 8.0 * t.powi(3))
    };
    for count in [2, 3, 12, 400] {
        type Both<'a> = (&'a dyn Fn(f64) -> f64, &'a dyn Fn(f64) -> (f64, f64));
        let of_degree: [(Spline, Both<'_>); 2] =
            [(Spline::Cubic, (&cubic, &cubic_slopes)), (Spline::Quintic, (&quintic, &quintic_slopes))];
        for (spline, (f, slopes)) in of_degree {
            let made = Points::new(&of(f, count), spline, stated([0.2, 1.5], slopes)).unwrap();
            for piece in motion(made).pieces() {
                for share in [0.0, 0.3, 1.0] {
                    let t = share * piece.duration_s;
                    let (state, at) = (piece.at(t), 0.2 + piece.start_s + t);
                    let (speed, acceleration) = slopes(at);
                    let scale = f64::from(count * count);
                    assert!((state.position_rad - f(at)).abs() < 1e-13, "{spline:?} {count} {at}");
                    assert!((state.speed_rad_s - speed).abs() < 1e-13 * scale, "{spline:?} {count} {at}");
                    assert!(
                        (state.acceleration_rad_s2 - acceleration).abs() < 1e-12 * scale,
                        "{spline:?} {count} {at}"
                    );
                }
            }
        }
    }
}

/// Returns speed, acceleration, jerk and the derivative of the jerk at a time of a piece.
fn derivatives(piece: &Piece, t: f64) -> [f64; 4] {
    let (state, [_, c1, c2, c3]) = (piece.at(t), piece.polynomial);
    [state.speed_rad_s, state.acceleration_rad_s2, c1 + t * (2.0 * c2 + t * 3.0 * c3), 2.0 * c2 + t * 6.0 * c3]
}

#[test]
fn as_many_derivatives_are_continuous_as_it_says() {
    let scale = [1.0, 10.0, 1e3, 1e5];
    for (spline, continuity) in [(Spline::Cubic, 2), (Spline::Quintic, 4)] {
        for ends in [Ends::Rest, Ends::Natural, Ends::Periodic] {
            let motion = motion(Points::new(&of(|t| (4.0 * t).sin() + t, 9), spline, ends).unwrap());
            let pieces = motion.pieces();
            let joints = pieces.iter().zip(pieces.iter().skip(1));
            let closing = pieces.last().zip(pieces.first()).filter(|_| ends == Ends::Periodic);
            for (before, after) in joints.chain(closing) {
                let sides = derivatives(before, before.duration_s).into_iter().zip(derivatives(after, 0.0));
                let mut jumps = sides.zip(scale).map(|((a, b), scale)| (a - b).abs() / scale);
                assert!(jumps.by_ref().take(continuity).all(|jump| jump < 1e-11), "{spline:?} {ends:?}");
                assert!(jumps.next().is_none_or(|jump| jump > 1e-6), "{spline:?} {ends:?}");
            }
        }
    }
}

/// With free ends, ∫α² dt of the cubic and ∫j² dt of the quintic are the least of all curves through the points.
#[test]
fn free_ends_bend_least() {
    let at = of(|t| (4.0 * t).sin(), 7);
    for (spline, bent) in [(Spline::Cubic, 1), (Spline::Quintic, 2)] {
        let effort = |ends: Ends| {
            let motion = motion(Points::new(&at, spline, ends).unwrap());
            let of_piece = |piece: &Piece| {
                let square =
                    |s: f64| derivatives(piece, s * piece.duration_s).get(bent).map_or(0.0, |value| value * value);
                numeric::lobatto(6).iter().map(|(s, w)| w * square(*s) * piece.duration_s).sum::<f64>()
            };
            motion.pieces().iter().map(of_piece).sum::<f64>()
        };
        let least = effort(Ends::Natural);
        assert!(least < effort(Ends::Rest) && least < effort(Ends::Periodic), "{spline:?}");
    }
}

#[test]
fn two_points_at_rest_are_the_polynomial_3_4_5() {
    let made = Points::new(&points(&[(0.0, 0.0), (0.6, 1.7)]), Spline::Quintic, Ends::Rest).unwrap();
    let expected = crate::Law::quintic(1.7, 0.6, 0.0, 0.0);
    let (found, _) = made.pieces().next().unwrap();
    for (a, b) in found.polynomial.iter().zip(expected.polynomial) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{found:?} {expected:?}");
    }
}

#[test]
fn every_fault_of_the_points_is_found() {
    let fault = |at: &[(f64, f64)], ends: Ends| Points::new(&points(at), Spline::Quintic, ends).unwrap_err();
    assert_eq!(fault(&[(0.0, 1.0)], Ends::Rest), [PointsFault::TooFew { points: 1, least: 2 }]);
    assert_eq!(fault(&[(0.0, 1.0), (1.0, 1.0)], Ends::Natural), [PointsFault::TooFew { points: 2, least: 3 }]);
    assert_eq!(
        fault(&[(0.0, 1.0), (0.0, 2.0), (1.0, f64::NAN), (0.5, 0.0), (0.4, 0.0)], Ends::Rest),
        [
            PointsFault::NotFinite { index: 2 },
            PointsFault::NotIncreasing { index: 1 },
            PointsFault::NotIncreasing { index: 4 }
        ]
    );
    assert_eq!(fault(&[(0.0, 0.0), (1e-200, 1.0), (1.0, 0.0)], Ends::Rest), [PointsFault::Uneven]);
}

#[test]
fn a_table_begins_where_the_axis_stands_and_as_fast_as_it_is() {
    let rest = Points::new(&points(&[(0.0, 0.5), (0.4, 1.5), (1.0, 1.0)]), Spline::Cubic, Ends::Rest).unwrap();
    let rest = SegmentSpec::Points(rest.into());
    let chain = |segments: &[SegmentSpec], start: Option<Angle>| Motion::new(segments, start, Closing::SingleMove);
    let twice = chain(&[rest.clone(), rest.clone()], None).unwrap();
    let starts: Vec<f64> = twice.pieces().iter().map(|piece| piece.position_rad).collect();
    assert!(starts.iter().zip([0.5, 1.5, 1.0, 2.0]).all(|(a, b)| (a - b).abs() < 1e-15), "{starts:?}");
    let elsewhere = chain(std::slice::from_ref(&rest), Some(Angle::from_si(3.0))).unwrap();
    assert_eq!(elsewhere.pieces().first().unwrap().position_rad, 3.0);
    let running = Points::new(&points(&[(0.0, 0.0), (0.4, 1.0), (1.0, 1.0)]), Spline::Cubic, Ends::Natural).unwrap();
    let running = SegmentSpec::Points(running.into());
    assert!(chain(std::slice::from_ref(&running), None).is_ok());
    let faults = chain(&[rest, running], None).unwrap_err();
    assert!(matches!(faults[0].fault, MoveFault::PointsSpeedJumps { before, .. } if before.si() == 0.0), "{faults:?}");
}
