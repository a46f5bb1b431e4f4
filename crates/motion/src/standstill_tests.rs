use crate::generated::{Noise, forth_and_back, recorded, samples};
use crate::{Recorded, Samples, Treatment};

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

/// Ramps of equal steps, whose speeds are a few levels, keep each of their samples beside noise at rest of any size that is rest.
#[test]
fn a_ramp_of_equal_steps_keeps_its_first_sample() {
    let mut noise = Noise(53);
    for h in [5e-4, 1e-3, 2e-3, 4e-3, 5e-3, 1e-2] {
        for steps in [2_i32, 5, 20, 25, 30, 100] {
            for size in [1e-17, 1e-15, 1e-13, 1e-11, 1e-10, 1e-9, 1e-8, 1e-6] {
                let (even, pause) = (steps, 50);
                let ramp = |k: i32| k.min(2 * steps + even - k).clamp(0, steps);
                let length = 2 * steps + even;
                let move_and_rest = |k: i32| if k < length + pause { ramp(k) } else { -ramp(k - length - pause) };
                let count = 2 * (length + pause);
                let speed: Vec<f64> = (0..count).map(|k| f64::from(move_and_rest(k)) / f64::from(steps)).collect();
                let time: Vec<f64> = (0..count).map(|k| f64::from(k) * h).collect();
                let mut position = vec![0.0];
                for k in 1..speed.len() {
                    position.push(position[k - 1] + 0.5 * (speed[k] + speed[k - 1]) * h);
                }
                for kind in 0..3 {
                    let mut noisy: Vec<f64> = speed.clone();
                    let last = noisy.len() - 1;
                    for (k, w) in noisy.iter_mut().enumerate().filter(|(k, w)| **w == 0.0 && (1..last).contains(k)) {
                        *w = size
                            * match kind {
                                0 => noise.normal(),
                                1 => noise.next(),
                                _ => [1.0, -1.0][k % 2],
                            };
                    }
                    for position in [None, Some(position.as_slice())] {
                        let found = recorded(samples(&time, position, Some(&noisy)));
                        let kept = found.speed_rad_s().iter().zip(&speed).filter(|(_, speed)| **speed != 0.0);
                        let lost = kept.filter(|(found, _)| **found == 0.0).count();
                        let case = format!("h {h}, {steps} steps, noise {size:e} {kind}, {}", position.is_some());
                        assert_eq!(lost, 0, "{case}");
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

/// Returns the speed, relative to its mean, of a law from rest to rest at a share of its duration: polynomial, sine,
/// trapezoid with thirds, triangle.
fn shape(law: usize, x: f64) -> f64 {
    if !(0.0..=1.0).contains(&x) {
        return 0.0;
    }
    let y = x.min(1.0 - x);
    match law {
        0 => 30.0 * x * x * (1.0 - x) * (1.0 - x),
        1 => std::f64::consts::FRAC_PI_2 * (std::f64::consts::PI * x).sin(),
        2 => 1.5 * (3.0 * y).min(1.0),
        _ => 4.0 * y,
    }
}

/// Returns T_rms of J α + T_c sgn ω with straight speeds between the samples.
fn rms(recorded: &Recorded, inertia: f64, friction: f64) -> f64 {
    let mut sum = 0.0;
    for (t, w) in recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2)) {
        let (h, alpha) = (t[1] - t[0], (w[1] - w[0]) / (t[1] - t[0]));
        let mut add = |share: f64, direction: f64| {
            let torque = inertia * alpha + friction * direction;
            sum += share * h * torque * torque;
        };
        if w[0] * w[1] < 0.0 {
            let share = w[0] / (w[0] - w[1]);
            add(share, w[0].signum());
            add(1.0 - share, w[1].signum());
        } else {
            let direction = w[0] + w[1];
            add(1.0, if direction == 0.0 { 0.0 } else { direction.signum() });
        }
    }
    (sum / recorded.duration_s()).sqrt()
}

/// Noise at rest up to 3 · 10⁻³ of the largest speed changes T_rms by less than 10⁻³, with and without positions that
/// stand still, for recordings of two thousand samples and more.
#[test]
fn visible_noise_at_rest_has_no_friction() {
    let mut noise = Noise(29);
    let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0_f64);
    for case in 0..60_usize {
        let h = [0.0005, 0.001, 0.002][case % 3];
        let (duration, rest) = (1.4 + 0.4 * noise.next(), 1.4 + 0.8 * noise.next());
        let (steps, still) = ((duration / h).round(), (rest / h).round());
        let total = (2.0 * (steps + still)) as usize;
        let speed: Vec<f64> = (0..=total)
            .map(|k| {
                let k = k as f64;
                shape(case % 4, k / steps) - shape(case % 4, (k - steps - still) / steps)
            })
            .map(|w| if w.abs() < 1e-12 { 0.0 } else { w })
            .collect();
        let time: Vec<f64> = (0..=total).map(|k| k as f64 * h).collect();
        let mut position = vec![0.0];
        for k in 1..=total {
            position.push(position[k - 1] + 0.5 * (speed[k] + speed[k - 1]) * h);
        }
        let most = speed.iter().fold(0.0_f64, |most, w| most.max(*w));
        // From pure friction to as much inertia as friction.
        let (inertia, friction) = (0.02 + 0.02 * noise.next(), 1.0);
        let clean = rms(&recorded(samples(&time, None, Some(&speed))), inertia, friction);
        for size in [1e-6, 1e-4, 2e-4, 3e-4, 5e-4, 1e-3, 2e-3, 3e-3] {
            let noisy = |w: &f64| if *w == 0.0 { size * most * noise.normal() } else { *w };
            let mut noisy: Vec<f64> = speed.iter().map(noisy).collect();
            // A single sample before the move is no rest.
            noisy[0] = 0.0;
            for position in [None, Some(position.as_slice())] {
                let found = recorded(samples(&time, position, Some(&noisy)));
                let off = rms(&found, inertia, friction) / clean - 1.0;
                assert!(off.abs() < 1e-3, "{case} {size:e} {} {total}: {off:e}", position.is_some());
                assert!(found.alternating().is_none(), "{case} {size:e}: {:?}", found.alternating());
                assert!(found.rest_noise().is_some());
                (worst, sum, count) = (worst.max(off.abs()), sum + off, count + 1.0);
            }
        }
    }
    assert!((sum / count).abs() < 2e-4, "mean {:e} worst {worst:e}", sum / count);
}

/// An oscillation of four samples per period and more that leaves its place, a slow sine, creeping and a ramp stay motion at every speed,
/// with some noise on top and with positions.
#[test]
fn oscillations_and_creeping_are_no_noise() {
    let mut noise = Noise(31);
    let h = 0.002;
    let periods = [4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 8.5, 9.0, 10.0, 13.0, 20.0, 50.0, 200.0, 1000.0];
    let kinds: Vec<(usize, f64)> = periods.map(|period| (0, period)).into_iter().chain([(1, 0.0), (2, 0.0)]).collect();
    for case in 0..300_usize {
        let (kind, period) = kinds[case % kinds.len()];
        let size = 1.2e-3 * 30.0_f64.powf(0.5 + 0.5 * noise.next());
        let (share, long) = (0.15 + 0.15 * noise.next(), 40 + (noise.next().abs() * 1500.0) as usize);
        // A stretch of noise far shorter than the period of an oscillation hides it.
        let long = long.max((1.5 * period) as usize);
        let steps = 400.0;
        let [mut time, mut speed] = [vec![], vec![]];
        for k in 0..=400_u32 {
            time.push(f64::from(k) * h);
            speed.push(shape(case % 4, f64::from(k) / steps));
        }
        let from = speed.len();
        let phase = 3.0 * noise.next();
        for k in 1..=long {
            let x = k as f64;
            let slow = match kind {
                0 => (std::f64::consts::TAU * x / period + phase).sin(),
                1 => 1.0,
                _ => x / long as f64 - 0.5,
            };
            time.push((steps + x) * h);
            speed.push(1.8 * size * (slow + share * noise.normal()));
        }
        let to = speed.len();
        for k in 0..=400_u32 {
            time.push((steps + long as f64 + 1.0 + f64::from(k)) * h);
            speed.push(-shape(case % 4, f64::from(k) / steps));
        }
        let mut position = vec![0.0];
        for k in 1..time.len() {
            position.push(position[k - 1] + 0.5 * (speed[k] + speed[k - 1]) * (time[k] - time[k - 1]));
        }
        for position in [None, Some(position.as_slice())] {
            let found = recorded(samples(&time, position, Some(&speed)));
            let still = found.speed_rad_s()[from..to].iter().filter(|speed| **speed == 0.0).count();
            // By its size it is a rest: 2.5·10⁻⁴ of the travel, or the noise of the speeds without positions.
            let most = 2.0 * 1.8 * size * h * period / std::f64::consts::TAU;
            if kind == 0 && most < 4e-4 * 0.8 {
                continue;
            }
            assert!(
                10 * still <= long,
                "{case}: kind {kind} period {period} size {size:e} noise {share} {long} {}: {still}",
                position.is_some()
            );
        }
    }
}

/// Noise at rest that is not distinguished from motion, here filtered, is reported with a `standstill` that removes it.
#[test]
fn noise_that_counts_as_motion_is_reported() {
    let mut noise = Noise(37);
    for (size, filter) in [(0.02, 0.5), (0.005, 0.45), (0.03, 0.0)] {
        let [time, _, mut speed] = forth_and_back(0.002, 2.0, 1.5);
        let most = speed.iter().fold(0.0_f64, |most, w| most.max(*w));
        let mut before = 0.0;
        for w in speed.iter_mut().filter(|w| **w == 0.0) {
            before = filter * before + noise.normal();
            *w = size * most * before;
        }
        let found = recorded(samples(&time, None, Some(&speed)));
        let alternating = found.alternating().unwrap();
        assert!(alternating.share > 0.02 && alternating.share < 0.3, "{alternating:?}");
        let standstill = Some(quantities::Measure::from_si(alternating.speed_rad_s));
        let found = Recorded::new(samples(&time, None, Some(&speed)), Treatment { standstill, ..Treatment::default() })
            .unwrap();
        assert_eq!(found.alternating(), None);
        let rest = found.time_s().iter().zip(found.speed_rad_s()).filter(|(t, _)| **t > 1.05 && **t < 2.95);
        assert!(rest.clone().filter(|(_, w)| **w != 0.0).count() * 50 < rest.count(), "{size}");
    }
    let [time, position, speed] = forth_and_back(0.002, 2.0, 1.5);
    assert_eq!(recorded(samples(&time, Some(&position), Some(&speed))).alternating(), None);
}

/// The width of the smoothing window changes no rest: with noise at rest at least what is at rest without noise, and nothing of the moves.
#[test]
fn no_window_turns_a_rest_with_noise_into_motion() {
    let (h, rest) = (0.002, 1.5);
    let [time, position, speed] = forth_and_back(h, rest, 0.9);
    let still: Vec<bool> = speed.iter().map(|speed| *speed == 0.0).collect();
    let rests = still.iter().filter(|still| **still).count();
    let step = 0.001_f64.to_radians();
    let mut wrong = Vec::new();
    for seed in 1..=8 {
        let mut noise = Noise(seed);
        // A last digit that is up or down at random for some samples, sparse or at each sample.
        let (mut digit, often) = (0.0, [0.02, 0.1, 0.5, 1.0][(seed % 4) as usize]);
        let dithered: Vec<f64> = position
            .iter()
            .zip(&still)
            .map(|(q, still)| {
                if noise.next().abs() < often {
                    digit = if noise.next() > 0.0 { step } else { 0.0 };
                }
                (q / step).round() * step + if *still { digit } else { 0.0 }
            })
            .collect();
        let rounded: Vec<f64> = position.iter().map(|q| (q / step).round() * step).collect();
        let noisy: Vec<f64> =
            speed.iter().zip(&still).map(|(w, still)| w + if *still { 1e-3 * noise.normal() } else { 0.0 }).collect();
        for window in [0.0, 0.02, 0.03, 0.06, 0.1, 0.2, 0.4] {
            let treated = |samples: Samples| {
                let smoothing = Some(quantities::Measure::from_si(window)).filter(|_| window > 0.0);
                let treated = Recorded::new(samples, Treatment { smoothing, ..Treatment::default() }).unwrap();
                at_rest(&treated)
            };
            for (kind, noisy, clean) in [
                ("positions", samples(&time, Some(&dithered), None), samples(&time, Some(&rounded), None)),
                ("speeds", samples(&time, None, Some(&noisy)), samples(&time, None, Some(&speed))),
                ("both", samples(&time, Some(&position), Some(&noisy)), samples(&time, Some(&position), Some(&speed))),
            ] {
                let (found, without) = (treated(noisy), treated(clean));
                let count = |all: &[bool]| all.iter().filter(|rest| **rest).count();
                let moving = found.iter().zip(&still).filter(|(found, still)| **found && !**still).count();
                // Neighbours of a rest move less than one step.
                // Neighbours of a rest move less than one step of the position, or less than the noise.
                let all = count(&found);
                let is_right = moving <= 44 && all + 24 >= count(&without) && all <= rests + 44;
                let least = count(&without);
                wrong.extend(
                    (!is_right)
                        .then(|| format!("{kind}, {often}, {seed}, {window} s: {all}, {least} of {rests}, {moving}")),
                );
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
