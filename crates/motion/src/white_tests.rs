use super::*;
use crate::generated::Noise;
use crate::{MadeUp, Recorded, Samples, Spurious, Treatment};
use quantities::{Measure, Time};
use std::sync::Arc;

/// Position and speed of a move of 1.5 rad in 1 s and back in 1.2 s, with rests, by x³ (10 − 15 x + 6 x²).
fn motion(t: f64) -> (f64, f64) {
    let one = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        (x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), 30.0 * x * x * (1.0 - x) * (1.0 - x))
    };
    let (forth, back) = (one(t - 0.3), one((t - 1.8) / 1.2));
    (1.5 * (forth.0 - back.0), 1.5 * (forth.1 - back.1 / 1.2))
}

/// Largest speed of the motion [rad/s].
const SPEED: f64 = 1.5 * 1.875;

/// Effective torque of an inertia of 0.6 kgm² with a friction of 4 Nm while the axis moves.
fn effective_torque(recorded: &Recorded) -> f64 {
    let steps = recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2));
    let square = steps.map(|(t, w)| {
        let (h, mean) = (t[1] - t[0], 0.5 * (w[0] + w[1]));
        let friction = if mean == 0.0 { 0.0 } else { 4.0 * mean.signum() };
        (0.6 * (w[1] - w[0]) / h + friction).powi(2) * h
    });
    (square.sum::<f64>() / recorded.duration_s()).sqrt()
}

/// Noise of position, of speed or of both: the effective torque keeps its value, or the remark covers the error within a factor of
/// two; where both are recorded the axis is at rest.
#[test]
fn the_effect_of_noise_is_zero_or_stated() {
    let mut stated = 0;
    for h in [1e-3, 2e-3, 4e-3] {
        let time: Vec<f64> = (0_u32..).map(|k| f64::from(k) * h).take_while(|t| *t <= 3.4).collect();
        for share in [0.0, 1e-6, 1e-5, 1e-4, 1e-3] {
            for (has_position, has_speed) in [(true, false), (false, true), (true, true)] {
                for seed in 1..=3_u64 {
                    let mut noise = Noise(seed * 7919);
                    let position: Vec<f64> = time.iter().map(|t| motion(*t).0 + 1.5 * share * noise.normal()).collect();
                    let speed: Vec<f64> = time.iter().map(|t| motion(*t).1 + SPEED * share * noise.normal()).collect();
                    let samples = |position: &[f64], speed: &[f64]| Samples {
                        time_s: Arc::new(time.clone()),
                        position_rad: has_position.then(|| Arc::new(position.to_vec())),
                        speed_rad_s: has_speed.then(|| Arc::new(speed.to_vec())),
                        ..Samples::default()
                    };
                    let clean: (Vec<f64>, Vec<f64>) = time.iter().map(|t| motion(*t)).unzip();
                    let truth = Recorded::new(samples(&clean.0, &clean.1), Treatment::default()).unwrap();
                    let found = Recorded::new(samples(&position, &speed), Treatment::default()).unwrap();
                    let (expected, torque) = (effective_torque(&truth), effective_torque(&found));
                    let what = format!("{h} s {share} {has_position} {has_speed} {seed}: {torque} for {expected}");
                    if has_speed {
                        let ends = [100_usize, 200].map(|at| found.speed_rad_s()[at / (h / 1e-3) as usize]);
                        assert!(ends == [0.0; 2], "{what}: rest at the beginning");
                    }
                    let error = torque * torque - expected * expected;
                    match found.made_up() {
                        Some(MadeUp { cause: Spurious::Noise { rms_rad_s2, .. }, .. }) => {
                            stated += 1;
                            let size = (0.6 * rms_rad_s2).powi(2);
                            // The noise acts while the axis moves, 65 % of the time, or at its rests too.
                            // Beside it noise hides the ends of the rests, where friction begins and ends to act.
                            let ends = 1.2e-2 * expected * expected;
                            let is_covered = (0.5 * size - ends..=2.0 * size + ends).contains(&error);
                            assert!(is_covered, "{what}: {error} for {size}");
                        }
                        None => assert!((torque / expected - 1.0).abs() < 4e-3, "{what}"),
                        Some(other) => panic!("{what}: {other:?}"),
                    }
                }
            }
        }
    }
    assert!(stated > 20, "{stated}");
}

/// Noise is stated with its size also where rows are lost, stamps scatter or the instants are random; what a lost row changes in it is
/// small.
#[test]
fn noise_is_found_at_uneven_instants_too() {
    let (h, share) = (2e-3, 1e-3);
    let even: Vec<f64> = (0_u32..).map(|k| f64::from(k) * h).take_while(|t| *t <= 3.4).collect();
    let mut random = Noise(5);
    let lost = |every: usize| -> Vec<f64> {
        even.iter().enumerate().filter(|(at, _)| *at % every != every - 1).map(|(_, t)| *t).collect()
    };
    let scattered: Vec<f64> =
        even.iter().enumerate().map(|(at, t)| if at == 0 { 0.0 } else { t + 2e-5 * random.normal() }).collect();
    for (what, time) in
        [("one lost", lost(1500)), ("a tenth lost", lost(10)), ("half lost", lost(2)), ("scattered", scattered)]
    {
        for has_speed in [true, false] {
            let mut noise = Noise(7919);
            let mut with = |of: fn((f64, f64)) -> f64, scale: f64| -> Vec<f64> {
                time.iter().map(|t| of(motion(*t)) + scale * share * noise.normal()).collect()
            };
            let samples = match has_speed {
                true => Samples { speed_rad_s: Some(Arc::new(with(|(_, speed)| speed, SPEED))), ..Samples::default() },
                false => {
                    Samples { position_rad: Some(Arc::new(with(|(position, _)| position, 1.5))), ..Samples::default() }
                }
            };
            let samples = Samples { time_s: Arc::new(time.clone()), ..samples };
            let found = Recorded::new(samples, Treatment::default()).unwrap();
            let Some(MadeUp { cause: Spurious::Noise { deviation, rms_rad_s2, .. }, .. }) = found.made_up() else {
                panic!("{what} {has_speed}: {:?}", found.made_up());
            };
            let planted = share * if has_speed { SPEED } else { 1.5 };
            assert!((deviation / planted - 1.0).abs() < 0.15, "{what} {has_speed}: {deviation} for {planted}");
            assert!(rms_rad_s2 > 0.0, "{what} {has_speed}");
        }
    }
}

/// Noise of a recorded torque is named with its size at even and uneven instants, none where there is none, and none that smoothing took
/// out.
#[test]
fn noise_of_a_recorded_torque_has_its_size() {
    for uneven in [0.0, 5e-4] {
        for share in [0.0, 1e-6, 3e-3, 0.03, 0.2] {
            let mut noise = Noise(104_729);
            let time: Vec<f64> =
                (0_u32..1700).map(|k| 2e-3 * f64::from(k) + uneven * (noise.normal().tanh())).collect();
            let torque: Vec<f64> = time
                .iter()
                .map(|t| {
                    let friction = if motion(*t).1 == 0.0 { 0.0 } else { 4.0 * motion(*t).1.signum() };
                    20.0 * (3.0 * t).sin() + friction + 20.0 * share * noise.normal()
                })
                .collect();
            let samples = Samples {
                position_rad: Some(Arc::new(time.iter().map(|t| motion(*t).0).collect())),
                torque_nm: Some(Arc::new(torque)),
                time_s: Arc::new(time),
                ..Samples::default()
            };
            let found = Recorded::new(samples.clone(), Treatment::default()).unwrap().torque_noise_nm();
            if share < 0.01 {
                assert_eq!(found, 0.0, "{share} {uneven}");
            } else {
                assert!((found / (20.0 * share) - 1.0).abs() < 0.12, "{share} {uneven}: {found}");
            }
            let smoothed = Treatment { smoothing: Some(Time::from_si(0.08)), ..Treatment::default() };
            let smoothed = Recorded::new(samples, smoothed).unwrap().torque_noise_nm();
            assert!(smoothed <= 0.4 * found, "{share} {uneven}: {smoothed}");
        }
    }
}

/// At random instants the largest acceleration is that of the rows that are closest to each other: the stated size is near what noise
/// alone makes of the rows.
#[test]
fn noise_between_random_instants_has_the_size_of_the_closest_rows() {
    for has_speed in [true, false] {
        let mut ratios = Vec::new();
        for seed in 1..=12_u64 {
            let mut noise = Noise(seed * 104_729);
            let mut now = 0.0;
            let mut time: Vec<f64> = std::iter::repeat_with(|| {
                now += 3e-4 + 2e-3 * noise.normal().abs();
                now
            })
            .take_while(|t| *t < 3.4)
            .collect();
            time.insert(0, 0.0);
            let share = 1e-4;
            let only: Vec<f64> = time.iter().map(|_| share * noise.normal()).collect();
            let of = |values: Vec<f64>| {
                let values = Some(Arc::new(values));
                let samples = Samples { time_s: Arc::new(time.clone()), ..Samples::default() };
                let samples = match has_speed {
                    true => Samples { speed_rad_s: values, ..samples },
                    false => Samples { position_rad: values, ..samples },
                };
                Recorded::new(samples, Treatment::default()).unwrap()
            };
            let scale = if has_speed { SPEED } else { 1.5 };
            let clean = |t: f64| if has_speed { motion(t).1 } else { motion(t).0 };
            let noisy = of(time.iter().zip(&only).map(|(t, noise)| clean(*t) + scale * noise).collect());
            // What the noise makes of the rows: the difference to the recording without it.
            let without = of(time.iter().map(|t| clean(*t)).collect());
            let slopes = |recorded: &Recorded| -> Vec<f64> {
                let ends = recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2));
                ends.map(|(t, w)| (w[1] - w[0]) / (t[1] - t[0])).collect()
            };
            let differences = slopes(&noisy).into_iter().zip(slopes(&without)).map(|(one, other)| (one - other).abs());
            let largest = differences.fold(0.0, f64::max);
            let Some(MadeUp { cause: Spurious::Noise { .. }, acceleration_rad_s2, .. }) = noisy.made_up() else {
                panic!("{has_speed} {seed}: {:?}", noisy.made_up());
            };
            ratios.push(largest / acceleration_rad_s2);
        }
        ratios.sort_by(f64::total_cmp);
        let median = ratios[6];
        let ends = [ratios[0], ratios[11]];
        assert!((0.75..1.35).contains(&median) && ends[0] > 0.5 && ends[1] < 2.0, "{has_speed}: {ratios:?}");
    }
}

/// At evenly spaced instants the divided differences are the differences; at random ones they give the planted deviation of noise on a
/// polynomial, and none without noise.
#[test]
fn divided_differences_are_those_of_evenly_spaced_values() {
    let mut noise = Noise(11);
    let time: Vec<f64> = (0_u32..2000).map(|k| 0.5 * f64::from(k)).collect();
    let values: Vec<f64> = time.iter().map(|t| 1e-3 * t * t + 0.3 * noise.normal()).collect();
    let (even, any) = (deviation(&values), deviation_at(&time, &values));
    assert!((even / any - 1.0).abs() < 1e-9 && (even / 0.3 - 1.0).abs() < 0.1, "{even} {any}");
    let mut now = 0.0;
    let time: Vec<f64> = std::iter::repeat_with(|| {
        now += 0.2 + noise.normal().abs();
        now
    })
    .take(2000)
    .collect();
    let smooth = |t: f64| (t / 40.0).sin();
    let values: Vec<f64> = time.iter().map(|t| smooth(*t) + 0.05 * noise.normal()).collect();
    assert!((deviation_at(&time, &values) / 0.05 - 1.0).abs() < 0.1);
    let values: Vec<f64> = time.iter().map(|t| smooth(*t)).collect();
    assert_eq!(deviation_at(&time, &values), 0.0);
}

/// A motion without noise, however coarsely it is sampled, shows none.
#[test]
fn a_motion_without_noise_shows_none() {
    for count in [64_u32, 70, 100, 200, 1000, 10_000] {
        let values = |at: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (0..count).map(|k| at(3.4 * f64::from(k) / f64::from(count))).collect()
        };
        assert_eq!(deviation(&values(&|t| motion(t).0)), 0.0, "{count}");
        assert_eq!(deviation(&values(&|t| motion(t).1)), 0.0, "{count}");
        assert_eq!(deviation(&values(&|t| (7.0 * t).sin())), 0.0, "{count}");
    }
}
