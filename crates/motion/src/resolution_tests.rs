use super::*;
use crate::generated::{forth_and_back, poly, recorded, samples};
use crate::{Recorded, Treatment};

/// Positions with six decimals of a degree every 60 µs cause a spurious acceleration of 5 rad/s² in a motion with 0.31.
#[test]
fn steps_of_positions_are_found_with_the_acceleration_that_they_make_up() {
    let h = 60e-6;
    let degree = 1_f64.to_radians();
    let way = 0.31 / 5.773_502_691_9;
    let time: Vec<f64> = (0..16_667_u32).map(|k| f64::from(k) * h).collect();
    let position: Vec<f64> =
        time.iter().map(|t| (poly(way, 1.0, *t).0 / degree * 1e6).round() * 1e-6 * degree).collect();
    let found = recorded(samples(&time, Some(&position), None));
    let made_up = found.made_up().unwrap();
    assert_eq!(made_up.column, SteppedColumn::Position);
    let Spurious::Steps { step, smoothing_s } = made_up.cause else { panic!("{made_up:?}") };
    assert!((step / (1e-6 * degree) - 1.0).abs() < 1e-6, "{made_up:?}");
    assert!((made_up.motion_rad_s2 / 0.31 - 1.0).abs() < 0.15, "{made_up:?}");
    let largest = |found: &Recorded| {
        let pairs = found.speed_rad_s().windows(2).zip(found.time_s().windows(2));
        pairs.map(|(w, t)| ((w[1] - w[0]) / (t[1] - t[0])).abs()).fold(0.0, f64::max)
    };
    // The largest second difference equals the acceleration reported.
    assert!((largest(&found) / made_up.acceleration_rad_s2 - 1.0).abs() < 0.15, "{} {made_up:?}", largest(&found));
    let smoothing = smoothing_s.map(quantities::Measure::from_si);
    let smooth =
        Recorded::new(samples(&time, Some(&position), None), Treatment { smoothing, ..Treatment::default() }).unwrap();
    assert!((largest(&smooth) / 0.31 - 1.0).abs() < 0.1, "{} {smoothing:?}", largest(&smooth));
    assert_eq!(smooth.made_up(), None);
}

/// For encoders of 12 to 20 bits and decimals of degrees, sampled at 100 Hz to 10 kHz, the acceleration reported is the
/// error caused by the steps.
#[test]
fn the_acceleration_made_up_is_that_of_the_second_difference() {
    let mut seen = 0;
    for step in [std::f64::consts::TAU / 4096.0, std::f64::consts::TAU / 131_072.0, 1e-6, 1e-4_f64.to_radians(), 1e-3] {
        for h in [1e-4, 1e-3, 2e-3, 1e-2] {
            for way in [0.1, 1.5, 12.0] {
                let [time, position, speed] = forth_and_back(h, 0.3, way);
                let rounded: Vec<f64> = position.iter().map(|q| (q / step).round() * step).collect();
                let found = recorded(samples(&time, Some(&rounded), None));
                let slope = |k: usize| (rounded[k + 1] - rounded[k - 1]) / (2.0 * h);
                let error = |k: usize| (slope(k + 1) - slope(k)) / h - (speed[k + 1] - speed[k]) / h;
                let errors = (1..time.len() - 2).map(|k| error(k).abs()).fold(0.0, f64::max);
                let motion = speed.windows(2).map(|pair| ((pair[1] - pair[0]) / h).abs()).fold(0.0, f64::max);
                match found.made_up() {
                    Some(made_up) => {
                        seen += 1;
                        let size = made_up.acceleration_rad_s2;
                        let Spurious::Steps { step: found, .. } = made_up.cause else { panic!("{made_up:?}") };
                        assert!((found / step - 1.0).abs() < 1e-6, "{step} {h} {way}: {made_up:?}");
                        assert!(size > 0.8 * errors && size < 2.5 * errors, "{step} {h} {way}: {errors} {made_up:?}");
                    }
                    // A travel of a few steps does not reveal them; steps far below the motion do not matter.
                    None => {
                        assert!(errors < 0.1 * motion || way < 40.0 * step, "{step} {h} {way}: {errors} of {motion}")
                    }
                }
            }
        }
    }
    assert!(seen > 20, "{seen}");
}

/// Few digits alone are no steps: exact values cause no spurious acceleration.
#[test]
fn exact_samples_have_no_steps() {
    let time: Vec<f64> = (0..200_u32).map(|k| f64::from(k) * 0.01).collect();
    let ramp: Vec<f64> = time.iter().map(|t| 3.0 * t).collect();
    let stepped: Vec<f64> = (0..200_i32).map(|k| f64::from((k - 50).clamp(0, 100))).collect();
    let parabola: Vec<f64> = (0..200_u32).map(|k| f64::from(k * k)).collect();
    let sine: Vec<f64> = time.iter().map(|t| t.sin()).collect();
    let rest = vec![2.0; 200];
    for values in [ramp, stepped, parabola, sine, rest] {
        assert_eq!(recorded(samples(&time, Some(&values), None)).made_up(), None, "{:?}", &values[..3]);
        assert_eq!(recorded(samples(&time, None, Some(&values))).made_up(), None, "{:?}", &values[..3]);
    }
}
