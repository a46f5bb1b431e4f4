use super::*;
use crate::{Recorded, Samples, Treatment};

/// Pseudorandom numbers, uniform from −1 to 1 and normal.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Returns the sum of twelve uniform numbers, with standard deviation 1.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.next()).sum::<f64>() / 2.0
    }
}

/// Returns position and speed of the polynomial 10τ³ − 15τ⁴ + 6τ⁵ from rest to rest.
fn poly(way: f64, duration: f64, t: f64) -> (f64, f64) {
    let x = (t / duration).clamp(0.0, 1.0);
    let q = way * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
    (q, way / duration * 30.0 * x * x * (1.0 - x) * (1.0 - x))
}

/// Returns instants, positions and speeds of a move of one second, a rest, the move back and a rest.
fn forth_and_back(h: f64, rest: f64, way: f64) -> [Vec<f64>; 3] {
    let count = ((2.0 + 2.0 * rest) / h).round() as usize + 1;
    let time: Vec<f64> = (0..count).map(|k| k as f64 * h).collect();
    let state = |t: f64| {
        let (forth, back) = (poly(way, 1.0, t), poly(way, 1.0, t - 1.0 - rest));
        (forth.0 - back.0, forth.1 - back.1)
    };
    let position = time.iter().map(|t| state(*t).0).collect();
    let speed = time.iter().map(|t| if state(*t).1.abs() < 1e-15 { 0.0 } else { state(*t).1 }).collect();
    [time, position, speed]
}

fn samples(time: &[f64], position: Option<&[f64]>, speed: Option<&[f64]>) -> Samples {
    let shared = |values: &[f64]| std::sync::Arc::new(values.to_vec());
    Samples {
        time_s: shared(time),
        position_rad: position.map(shared),
        speed_rad_s: speed.map(shared),
        torque_nm: None,
    }
}

fn recorded(samples: Samples) -> Recorded {
    Recorded::new(samples, Treatment::default()).unwrap()
}

/// Returns `true` for each instant at rest.
fn at_rest(recorded: &Recorded) -> Vec<bool> {
    recorded.speed_rad_s().iter().map(|speed| *speed == 0.0).collect()
}

/// With noise of any size found at rest, the same samples are at rest as without it.
#[test]
fn noise_at_rest_is_rest() {
    let mut noise = Noise(7);
    for h in [0.001, 0.004, 0.01] {
        for rest in [0.5, 4.0, 9.0] {
            for (way, size) in [(1.5, 1e-15), (1.5, 1e-9), (1.5, 1e-7), (0.2, 1e-6), (6.0, 1.7e-5), (30.0, 1e-4)] {
                for kind in 0..3 {
                    let [time, position, speed] = forth_and_back(h, rest, way);
                    let mut noisy = |speed: &f64| {
                        speed
                            + size
                                * match kind {
                                    0 => noise.normal(),
                                    1 => noise.next(),
                                    // One digit up and down.
                                    _ => noise.next().round(),
                                }
                    };
                    let mut recorded_speed: Vec<f64> = speed.iter().map(&mut noisy).collect();
                    recorded_speed[0] = 0.0;
                    let clean = recorded(samples(&time, Some(&position), Some(&speed)));
                    for with_position in [true, false] {
                        let position = with_position.then_some(position.as_slice());
                        let found = recorded(samples(&time, position, Some(&recorded_speed)));
                        let (still, meant) = (at_rest(&found), at_rest(&clean));
                        let wrong = still.iter().zip(&meant).filter(|(one, other)| one != other).count();
                        // At the ends of a move the speeds pass through the noise.
                        let passing = speed.iter().filter(|speed| **speed != 0.0 && speed.abs() <= 12.0 * size).count();
                        assert!(
                            wrong <= passing,
                            "h {h} rest {rest} way {way} noise {size:e} {kind} {with_position}: {wrong} of {}",
                            time.len()
                        );
                        let reported = found.rest_noise().unwrap();
                        assert!(
                            reported.speed_rad_s <= 8.0 * size && reported.duration_s > 1.9 * rest - 0.1,
                            "{reported:?}"
                        );
                    }
                }
            }
        }
    }
}

/// A recording without noise is unchanged, however finely it is sampled and coarsely its positions are rounded.
#[test]
fn a_recording_without_noise_stays_as_it_is() {
    for h in [1e-4, 1e-3, 2e-3, 1e-2] {
        for rest in [0.0, 0.3, 2.0] {
            for way in [0.2, 1.5, 30.0] {
                for step in [None, Some(0.0), Some(1e-9), Some(1e-3)] {
                    let [time, position, speed] = forth_and_back(h, rest, way);
                    let written: Option<Vec<f64>> = step.map(|step| {
                        let rounded = |q: &f64| if step > 0.0 { (q / step).round() * step } else { *q };
                        position.iter().map(rounded).collect()
                    });
                    let found = recorded(samples(&time, written.as_deref(), Some(&speed)));
                    // Speeds within the rounding error of two numbers are no motion.
                    let most = speed.iter().fold(0.0_f64, |most, speed| most.max(*speed));
                    let kept = found.speed_rad_s().iter().zip(&speed).filter(|(_, speed)| speed.abs() > 1e-9 * most);
                    assert!(kept.into_iter().all(|(found, speed)| found == speed), "{h} {rest} {way} {step:?}");
                }
            }
        }
    }
}

/// Slow motion with travel is no rest at any speed: creeping, oscillating, and both below the noise of the speed.
#[test]
fn slow_motion_is_no_rest() {
    let mut noise = Noise(11);
    for share in [3e-8, 1e-6, 1e-4, 9e-4] {
        // An oscillation by less than 10⁻⁴ of the travel stays in place.
        let all = [(0.0, false), (0.3, false), (2.0, false), (0.0, true), (0.3, true)];
        for (noisy, swinging) in all.into_iter().filter(|(_, swinging)| !swinging || share >= 1e-4) {
            let [mut time, _, mut speed] = forth_and_back(0.004, 0.5, 1.5);
            let most = speed.iter().fold(0.0_f64, |most, speed| most.max(*speed));
            let fast = time.len();
            let end = time[fast - 1];
            for k in 1..=50_000_u32 {
                let t = f64::from(k) * 0.004;
                time.push(end + t);
                let way = if swinging { (t * 0.2).sin() } else { 1.0 };
                speed.push(share * most * (way + noisy * noise.normal()));
            }
            let mut position = vec![0.0];
            for k in 1..time.len() {
                position.push(position[k - 1] + 0.5 * (speed[k] + speed[k - 1]) * (time[k] - time[k - 1]));
            }
            // Without positions, noise larger than the motion hides it.
            for with_position in [true, false].into_iter().filter(|with| *with || noisy < 1.0) {
                let found = recorded(samples(&time, with_position.then_some(position.as_slice()), Some(&speed)));
                let still = found.speed_rad_s()[fast + 10..].iter().filter(|speed| **speed == 0.0).count();
                assert!(
                    still < 2500,
                    "{share:e} noise {noisy} swinging {swinging} positions {with_position}: {still} at rest"
                );
            }
        }
    }
}

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
    assert!((made_up.step / (1e-6 * degree) - 1.0).abs() < 1e-6, "{made_up:?}");
    assert!((made_up.motion_rad_s2 / 0.31 - 1.0).abs() < 0.15, "{made_up:?}");
    let largest = |found: &Recorded| {
        let pairs = found.speed_rad_s().windows(2).zip(found.time_s().windows(2));
        pairs.map(|(w, t)| ((w[1] - w[0]) / (t[1] - t[0])).abs()).fold(0.0, f64::max)
    };
    // The largest second difference equals the acceleration reported.
    assert!((largest(&found) / made_up.acceleration_rad_s2 - 1.0).abs() < 0.15, "{} {made_up:?}", largest(&found));
    let smoothing = made_up.smoothing_s.map(quantities::Measure::from_si);
    let smooth =
        Recorded::new(samples(&time, Some(&position), None), Treatment { smoothing, standstill: None }).unwrap();
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
                        assert!((made_up.step / step - 1.0).abs() < 1e-6, "{step} {h} {way}: {made_up:?}");
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
