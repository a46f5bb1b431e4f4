//! Splines through points against another hand: SciPy 1.17.1, `CubicSpline` and `make_interp_spline` of degree five.
//!
//! The values come from `validation/splines/splines.py` and were typed in; no tool may rewrite them.

#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use motion::{Closing, EndState, Ends, Motion, Points, SegmentSpec, Spline};
use quantities::{Angle, AngularAcceleration, AngularVelocity, Measure, Time};

const POINTS: [(f64, f64); 6] = [(0.0, 0.0), (0.1, 0.2), (0.25, 1.1), (0.3, 1.0), (0.55, -0.4), (0.7, 0.0)];

fn motion(spline: Spline, ends: Ends) -> Motion {
    let points = POINTS.map(|(t, q)| (Time::from_si(t), Angle::from_si(q)));
    let points = Points::new(&points, spline, ends).unwrap();
    Motion::new(&[SegmentSpec::Points(points.into())], None, Closing::SingleMove).unwrap()
}

fn stated() -> Ends {
    let end = |speed: f64, acceleration: f64| EndState {
        speed: AngularVelocity::from_si(speed),
        acceleration: AngularAcceleration::from_si(acceleration),
    };
    Ends::Stated(end(0.5, -3.0), end(-1.5, 8.0))
}

/// Instant, position, speed and acceleration, printed to twelve digits: half of the last one, and the rounding of both sides.
fn agrees(spline: Spline, ends: Ends, expected: &[[f64; 4]]) {
    let motion = motion(spline, ends);
    for [t, position, speed, acceleration] in expected {
        let after = |start: f64| *t >= start;
        let piece = motion.pieces().iter().rev().find(|piece| after(piece.start_s)).unwrap();
        let state = piece.at(t - piece.start_s);
        let close = |found: f64, expected: f64, scale: f64| (found - expected).abs() < 6e-12 * scale;
        assert!(close(state.position_rad, *position, 1.0), "{spline:?} {ends:?} {t}: {state:?}");
        assert!(close(state.speed_rad_s, *speed, 2.0), "{spline:?} {ends:?} {t}: {state:?}");
        assert!(close(state.acceleration_rad_s2, *acceleration, 100.0), "{spline:?} {ends:?} {t}: {state:?}");
    }
}

#[test]
fn the_cubic_spline_with_rest_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 0.0, 15.871657754],
        [0.07, 0.0802656684492, 2.88444919786, 66.5411764706],
        [0.2, 0.903006535948, 6.26452762923, -67.0944741533],
        [0.28, 1.07092534759, -2.67174331551, -97.8737967914],
        [0.41, 0.272171294118, -7.55318930481, 7.76213903743],
        [0.66, -0.0689164270153, 3.07789423648, -49.3528223411],
        [0.7, 0.0, 0.0, -104.541889483],
    ];
    agrees(Spline::Cubic, Ends::Rest, &expected);
}

#[test]
fn the_cubic_spline_with_natural_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 0.462648542361, 0.0],
        [0.07, 0.0851165529623, 2.72255518509, 64.5687612208],
        [0.2, 0.902329752168, 6.30843236157, -67.5664985324],
        [0.28, 1.06975958964, -2.67701188339, -93.1646747029],
        [0.41, 0.317129690006, -7.1343487048, 3.21400701034],
        [0.66, -0.180792270003, 4.23607238323, 21.2800775128],
        [0.7, 0.0, 4.66167393349, 0.0],
    ];
    agrees(Spline::Cubic, Ends::Natural, &expected);
}

#[test]
fn the_cubic_spline_with_periodic_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 2.13747554942, -56.5136347946],
        [0.07, 0.10337035554, 2.13318421355, 56.3910251985],
        [0.2, 0.894116263312, 6.48308978637, -66.1315537146],
        [0.28, 1.07108495685, -2.69797077436, -97.6202508342],
        [0.41, 0.291303872052, -7.35653324128, 5.89836842711],
        [0.66, -0.120158942456, 3.6066968895, -16.9474322096],
        [0.7, 0.0, 2.13747554942, -56.5136347946],
    ];
    agrees(Spline::Cubic, Ends::Periodic, &expected);
}

#[test]
fn the_cubic_spline_with_stated_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 0.5, -0.963539134662],
        [0.07, 0.085741798736, 2.70837238697, 64.0598930481],
        [0.2, 0.900332739156, 6.31727434776, -66.5451304489],
        [0.28, 1.07153438989, -2.67807292173, -100.03130773],
        [0.41, 0.257205518717, -7.68640758386, 9.30030140982],
        [0.66, -0.0328993147158, 2.70446691514, -72.0742613299],
        [0.7, 0.0, -1.5, -138.149084427],
    ];
    agrees(Spline::Cubic, stated(), &expected);
}

#[test]
fn the_quintic_spline_with_rest_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 0.0, 0.0],
        [0.07, 0.0748710092757, 3.02676452886, 74.2766771471],
        [0.2, 0.906581236463, 6.2477519413, -72.6513289031],
        [0.28, 1.07551347788, -2.64780079701, -117.662600277],
        [0.41, 0.110275334131, -8.77534221324, 34.4433990155],
        [0.66, -0.0238296244641, 1.59600493088, -61.4701958466],
        [0.7, 0.0, 0.0, 0.0],
    ];
    agrees(Spline::Quintic, Ends::Rest, &expected);
}

#[test]
fn the_quintic_spline_with_natural_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, -2.93590579661, 102.307529631],
        [0.07, 0.0421236780311, 4.01016672029, 89.9958406446],
        [0.2, 0.935956680952, 5.73261730688, -82.2586873864],
        [0.28, 1.06861129799, -2.56628454969, -93.0900055737],
        [0.41, 0.292656195973, -7.09754626379, 11.4294128902],
        [0.66, -0.241425078431, 4.79274629274, 62.0649585479],
        [0.7, 0.0, 7.27929837732, 62.1967499701],
    ];
    agrees(Spline::Quintic, Ends::Natural, &expected);
}

#[test]
fn the_quintic_spline_with_periodic_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 1.36375339499, -27.4467584196],
        [0.07, 0.0945586781444, 2.44626170845, 62.5213258024],
        [0.2, 0.896876989021, 6.52762081437, -72.6933819363],
        [0.28, 1.07543925224, -2.67419513177, -116.526959106],
        [0.41, 0.158733283568, -8.18542150473, 29.432504307],
        [0.66, -0.0809601246275, 2.71489299272, -32.4183781376],
        [0.7, 0.0, 1.36375339499, -27.4467584196],
    ];
    agrees(Spline::Quintic, Ends::Periodic, &expected);
}

#[test]
fn the_quintic_spline_with_stated_ends_is_that_of_scipy() {
    let expected = [
        [0.0, 0.0, 0.5, -3.0],
        [0.07, 0.0845773274701, 2.77145352539, 66.7629198122],
        [0.2, 0.896841816198, 6.42215424565, -69.5036864942],
        [0.28, 1.07768818063, -2.67501801693, -125.358580267],
        [0.41, 0.0557910439372, -9.26319166208, 41.5241589607],
        [0.66, 0.0298901927145, 0.649987057661, -89.758147809],
        [0.7, 0.0, -1.5, 8.0],
    ];
    agrees(Spline::Quintic, stated(), &expected);
}
