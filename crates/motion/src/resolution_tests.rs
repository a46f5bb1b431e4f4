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

/// Time stamps up to about a duration: dense rows in the middle third, four dense rows only, alternating and jittering
/// steps; the largest step is `h`.
fn uneven(kind: u32, h: f64, duration: f64) -> Vec<f64> {
    let mut noise = crate::generated::Noise(0x9e37_79b9_7f4a_7c15 + u64::from(kind));
    let (mut time, mut t) = (Vec::new(), 0.0);
    while t <= duration {
        let row = time.len();
        time.push(t);
        let is_dense = match kind {
            0 => (duration / 3.0..duration / 1.5).contains(&t),
            1 => (200..204).contains(&row),
            _ => row % 2 == 0,
        };
        t += match kind {
            3 => h * (1.0 + 0.4 * noise.next()) / 1.4,
            _ if is_dense => 0.25 * h,
            _ => h,
        };
    }
    time
}

/// With unequal time steps the acceleration reported is the error that the steps of the positions cause, and the motion
/// is that of the exact positions; the proposed window is accepted and leaves no spurious acceleration.
#[test]
fn unequal_time_steps_have_the_error_of_their_places() {
    let mut seen = [0; 4];
    for kind in 0..4_u32 {
        for step in [std::f64::consts::TAU / 131_072.0, 1e-4_f64.to_radians(), 1e-3_f64.to_radians()] {
            for h in [1e-3, 2e-3, 4e-3] {
                for way in [0.02, 1.5] {
                    let time = uneven(kind, h, 2.0);
                    let exact: Vec<f64> = time.iter().map(|t| poly(way, 2.0, *t).0).collect();
                    let rounded: Vec<f64> = exact.iter().map(|q| (q / step).round() * step).collect();
                    let found = recorded(samples(&time, Some(&rounded), None));
                    let slopes = |values: &[f64]| crate::recorded::slopes(&time, values);
                    let (with, without) = (slopes(&rounded), slopes(&exact));
                    let error =
                        |k: usize| ((with[k + 1] - without[k + 1]) - (with[k] - without[k])) / (time[k + 1] - time[k]);
                    let errors = (1..time.len() - 2).map(|k| error(k).abs()).fold(0.0, f64::max);
                    let motion = 5.7735 * way / 4.0;
                    let what = format!("kind {kind}, step {step}, h {h}, way {way}: {errors} beside {motion}");
                    let Some(made_up) = found.made_up() else {
                        assert!(errors < 0.1 * motion, "{what}");
                        continue;
                    };
                    // Four dense rows in a motion of few steps resemble stamps that scatter.
                    if kind == 1 && matches!(made_up.cause, Spurious::Stamps { .. }) && way < 0.1 {
                        continue;
                    }
                    seen[kind as usize] += 1;
                    let size = made_up.acceleration_rad_s2;
                    assert!(size > 0.8 * errors && size < 2.5 * errors + 1.1 * motion, "{what}: {made_up:?}");
                    assert!((made_up.motion_rad_s2 / motion - 1.0).abs() < 0.25, "{what}: {made_up:?}");
                    let Spurious::Steps { step: found, smoothing_s } = made_up.cause else { panic!("{made_up:?}") };
                    assert!((found / step - 1.0).abs() < 1e-6, "{what}: {made_up:?}");
                    if let Some(smoothing) = smoothing_s.map(quantities::Measure::from_si) {
                        let treatment = Treatment { smoothing: Some(smoothing), ..Treatment::default() };
                        let smooth = Recorded::new(samples(&time, Some(&rounded), None), treatment).unwrap();
                        assert_eq!(smooth.made_up(), None, "{what}");
                    }
                    if kind == 0 {
                        assert!((made_up.interval_s / (0.25 * h) - 1.0).abs() < 1e-6, "{what}: {made_up:?}");
                    }
                }
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 8), "{seen:?}");
}

/// Exact values at unequal time steps are no rounded ones, though their differences are multiples of a step.
#[test]
fn exact_samples_at_unequal_time_steps_have_no_steps() {
    for kind in 0..4 {
        let time = uneven(kind, 4e-3, 1.0);
        let ramp: Vec<f64> = time.iter().map(|t| 3.0 * t).collect();
        assert_eq!(recorded(samples(&time, Some(&ramp), None)).made_up(), None, "{kind}");
        assert_eq!(recorded(samples(&time, None, Some(&ramp))).made_up(), None, "{kind}");
        let parabola: Vec<f64> = time.iter().map(|t| 0.5 * t * t).collect();
        assert_eq!(recorded(samples(&time, Some(&parabola), None)).made_up(), None, "{kind}");
    }
}

/// A proposed window contains four samples at sparse rows too, so that smoothing accepts it; where it would be long none is
/// proposed.
#[test]
fn a_proposed_window_is_accepted_at_sparse_rows() {
    let (h, step) = (1e-3, 1e-4_f64.to_radians());
    let (mut proposed, mut none) = (0, 0);
    for sparse in [1.0, 5.0, 20.0, 30.0, 300.0] {
        let dense = (0..3000_u32).map(|k| f64::from(k) * h);
        let time: Vec<f64> = dense.chain((1..9_u32).map(|k| 2.999 + f64::from(k) * sparse * h)).collect();
        let rounded: Vec<f64> = time.iter().map(|t| (poly(0.3, 3.0, *t).0 / step).round() * step).collect();
        let made_up = recorded(samples(&time, Some(&rounded), None)).made_up().unwrap();
        let Spurious::Steps { smoothing_s, .. } = made_up.cause else { panic!("{made_up:?}") };
        let Some(smoothing) = smoothing_s.map(quantities::Measure::from_si) else {
            none += 1;
            continue;
        };
        proposed += 1;
        let treatment = Treatment { smoothing: Some(smoothing), ..Treatment::default() };
        assert!(Recorded::new(samples(&time, Some(&rounded), None), treatment).is_ok(), "{sparse}: {made_up:?}");
    }
    assert_eq!((proposed, none), (4, 1));
}
