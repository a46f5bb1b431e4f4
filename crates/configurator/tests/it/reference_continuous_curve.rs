//! Reference values by other hands; no tool rewrites this file.
//!
//! Corner points of the continuous curves of CHA-20A, published with page 39 of the English edition 8/2018 V03:
//! output speed [1/min], torque \[Nm\].
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use order_code::parse;
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE};
use quantities::{AngularVelocity, Measure};

const PUBLISHED: [(u16, &[(f64, f64)]); 4] = [
    (30, &[(0.0, 20.0), (40.0, 20.0), (120.0, 14.0)]),
    (50, &[(0.0, 32.0), (25.0, 31.0), (70.0, 20.0)]),
    (80, &[(0.0, 48.0), (25.0, 48.0), (45.0, 33.0)]),
    (120, &[(0.0, 50.0), (29.0, 50.0)]),
];

fn parameters(ratio: u16) -> actuator::Parameters {
    let code = parse(&format!("CHA-20A-{ratio}-H-C1024")).unwrap().code;
    configurator::parameters(&code).unwrap()
}

#[test]
fn the_catalogue_holds_the_published_points() {
    for (ratio, points) in PUBLISHED {
        let actuator = parameters(ratio);
        let curve = &actuator.continuous_curve.known().expect("published").value;
        let found: Vec<(f64, f64)> = curve
            .points()
            .iter()
            .map(|point| (point.speed.in_unit(&REVOLUTION_PER_MINUTE), point.torque.in_unit(&NEWTON_METRE)))
            .collect();
        assert_eq!(found.len(), points.len());
        for ((n, t), (pn, pt)) in found.iter().zip(points) {
            assert!((n - pn).abs() < 1e-9 && (t - pt).abs() < 1e-9, "i = {ratio}");
        }
    }
    for cut_off in [100, 160] {
        assert!(parameters(cut_off).continuous_curve.known().is_none(), "cut off in the source");
    }
}

/// The estimate that serves the other sizes is held against every published point: the lower edge, which checks use,
/// never promises more than is published, and the upper edge never less.
#[test]
fn the_band_of_the_estimate_covers_every_published_point() {
    for (ratio, points) in PUBLISHED {
        let actuator = parameters(ratio);
        let stall = actuator.stall_torque.known().unwrap().value.si();
        let rated = actuator::speed_rated_out(&actuator).unwrap().value.in_unit(&REVOLUTION_PER_MINUTE);
        for (n, torque) in points {
            // The published speeds are rounded (45 for 43.75); the estimate ends at the exact quotient.
            let speed = AngularVelocity::new_in(n.min(rated * 0.999_999), &REVOLUTION_PER_MINUTE);
            let estimate = actuator::estimated_continuous_torque(&actuator, speed).unwrap();
            let published = torque.min(stall);
            let (low, high) = (estimate.limit.value.si(), estimate.upper.si());
            assert!(
                low <= published + 0.5 && published <= high + 0.5,
                "i = {ratio}, n = {n}: {low} {published} {high}"
            );
        }
    }
}

/// The continuous curve ends at n_N/i (3500/30 = 117, printed 120; 70; 44, printed 45; 29).
#[test]
fn the_curves_end_at_the_rated_speed() {
    for (ratio, points) in PUBLISHED {
        let actuator = parameters(ratio);
        let rated = actuator::speed_rated_out(&actuator).unwrap().value.in_unit(&REVOLUTION_PER_MINUTE);
        let end = points.last().unwrap().0;
        assert!((end - rated).abs() <= 0.03 * rated, "i = {ratio}: {end} {rated}");
    }
}
