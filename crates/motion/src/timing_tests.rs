use super::*;
use crate::generated::Noise;
use crate::held::held;
use crate::resolution::mean_interval;
use crate::{HeldValues, MadeUp, Recorded, Remark, Spurious, SteppedColumn, TimeStamps, Treatment};

/// Returns position and speed of a move of 1.5 rad in 1 s and back in 1.2 s, with rests; the law by its number.
fn motion(law: u32, t: f64) -> (f64, f64) {
    let one = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        match law {
            // 10x³ − 15x⁴ + 6x⁵
            0 => (x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), 30.0 * x * x * (1.0 - x) * (1.0 - x)),
            // Inclined sine.
            1 => {
                let turn = std::f64::consts::TAU * x;
                (x - turn.sin() / std::f64::consts::TAU, 1.0 - turn.cos())
            }
            // Trapezoid of thirds.
            _ if x < 1.0 / 3.0 => (2.25 * x * x, 4.5 * x),
            _ if x < 2.0 / 3.0 => (0.25 + 1.5 * (x - 1.0 / 3.0), 1.5),
            _ => (1.0 - 2.25 * (1.0 - x) * (1.0 - x), 4.5 * (1.0 - x)),
        }
    };
    let (forth, back) = (one((t - 0.3003) / 1.0), one((t - 1.8107) / 1.2));
    (1.5 * (forth.0 - back.0), 1.5 * (forth.1 - back.1 / 1.2))
}

/// Duration of the motion \[s\].
const END: f64 = 3.4;

/// Rms of the inertia torque of 1.3 kgm², by a fine sum of differences of the law's speed.
fn truth(law: u32) -> f64 {
    let h = 1e-5;
    let square = (0..340_000_u32).map(|k| {
        let t = f64::from(k) * h;
        let alpha = (motion(law, t + h).1 - motion(law, t).1) / h;
        (1.3 * alpha).powi(2) * h
    });
    (square.sum::<f64>() / END).sqrt()
}

/// Returns the values of a recording, whose acceleration is constant between two samples.
fn rms(recorded: &Recorded) -> f64 {
    let intervals = recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2));
    let square = intervals.map(|(t, w)| (1.3 * (w[1] - w[0])).powi(2) / (t[1] - t[0])).sum::<f64>();
    (square / recorded.duration_s()).sqrt()
}

fn samples(time: &[f64], values: Vec<f64>, column: SteppedColumn) -> Samples {
    let time_s = Arc::new(time.to_vec());
    match column {
        SteppedColumn::Position => Samples { time_s, position_rad: Some(values.into()), ..Samples::default() },
        SteppedColumn::Speed => Samples { time_s, speed_rad_s: Some(values.into()), ..Samples::default() },
    }
}

const COLUMNS: [SteppedColumn; 2] = [SteppedColumn::Position, SteppedColumn::Speed];

fn of(law: u32, t: f64, column: SteppedColumn) -> f64 {
    let (position, speed) = motion(law, t);
    if column == SteppedColumn::Position { position } else { speed }
}

/// Rows of a logger at intervals of `h`, and the values of a source at those of `period`, read `phase` late.
fn logged(law: u32, column: SteppedColumn, h: f64, period: f64, phase: f64) -> (Vec<f64>, Vec<f64>) {
    let time: Vec<f64> = (0..=(END / h).round() as u32).map(|k| f64::from(k) * h).collect();
    let value = |t: &f64| of(law, (((t - phase) / period + 1e-9).floor() * period).max(0.0), column);
    let values = time.iter().map(value).collect();
    (time, values)
}

fn interpolated_values() -> Treatment {
    Treatment { held_values: HeldValues::Interpolated, ..Treatment::default() }
}

/// Values held over rows are found with their period; one value for each update leaves the torque of the motion.
#[test]
fn held_values_are_found_and_interpolated() {
    for law in 0..3 {
        let truth = truth(law);
        for column in COLUMNS {
            for (h, period) in [
                (0.002, 0.004),
                (0.002, 0.008),
                (0.002, 0.040),
                (0.001, 0.010),
                (0.000_125, 0.004),
                // The bus is no multiple of the logger.
                (0.002, 0.005),
                (0.002, 0.003),
                (0.004, 0.010),
                (0.003, 0.010),
            ] {
                for phase in [0.0, 0.37 * period] {
                    let (time, values) = logged(law, column, h, period, phase);
                    let plain = Recorded::new(samples(&time, values.clone(), column), Treatment::default()).unwrap();
                    let what = format!("law {law} {column:?} h {h} period {period} phase {phase}");
                    let Some(MadeUp { cause: Spurious::Held { period_s }, .. }) = plain.made_up() else {
                        panic!("{what}: {:?}, rms {} of {truth}", plain.made_up(), rms(&plain));
                    };
                    assert!((period_s / period - 1.0).abs() < 0.02, "{what}: {period_s}");
                    let found = Recorded::new(samples(&time, values, column), interpolated_values()).unwrap();
                    let error = rms(&found) / truth - 1.0;
                    // The corners of a trapezoid are rounded by half a period.
                    let most = if law == 2 { 0.05 } else { 0.015 };
                    assert!(error.abs() < most, "{what}: {error}, without {}", rms(&plain) / truth);
                    assert!(!matches!(found.made_up(), Some(MadeUp { cause: Spurious::Held { .. }, .. })), "{what}");
                }
            }
        }
    }
}

/// The period of held values, and the interval of the rows, do not depend on the rounding of the time stamps nor on gaps.
#[test]
fn rounded_stamps_do_not_change_the_period_of_held_values() {
    for law in 0..3 {
        for column in COLUMNS {
            for (h, rows) in [(0.0015, 4), (0.0015, 6), (0.0013, 5), (0.0018, 4), (0.0025, 8), (0.00125, 4)] {
                let period = h * f64::from(rows);
                let (time, values) = logged(law, column, h, period, 0.0);
                for gap in [0.0, 3.0] {
                    // A millisecond is the last digit of the stamps; a gap lies in the middle.
                    let shift = |k: usize| if k > time.len() / 2 { gap } else { 0.0 };
                    let stamps: Vec<f64> =
                        time.iter().enumerate().map(|(k, t)| (1e3 * t).round() * 1e-3 + shift(k)).collect();
                    let what = format!("law {law} {column:?} h {h} rows {rows} gap {gap}");
                    let found = held(&stamps, &values).unwrap_or_else(|| panic!("{what}"));
                    assert!((found / period - 1.0).abs() < 0.01, "{what}: {found} for {period}");
                    let interval = mean_interval(&stamps);
                    assert!((interval / h - 1.0).abs() < 0.01, "{what}: {interval} for {h}");
                }
            }
        }
    }
}

/// The difference stated for held values is the error of the acceleration that they cause.
#[test]
fn the_acceleration_stated_for_held_values_is_their_error() {
    for column in COLUMNS {
        let (time, values) = logged(0, column, 0.002, 0.008, 0.0);
        let plain = Recorded::new(samples(&time, values, column), Treatment::default()).unwrap();
        let error = plain.time_s().windows(2).zip(plain.speed_rad_s().windows(2)).map(|(t, w)| {
            let exact = (motion(0, t[1]).1 - motion(0, t[0]).1) / (t[1] - t[0]);
            ((w[1] - w[0]) / (t[1] - t[0]) - exact).abs()
        });
        let error = error.fold(0.0, f64::max);
        let stated = plain.made_up().unwrap().acceleration_rad_s2;
        assert!((stated / error - 1.0).abs() < 0.1, "{column:?}: {stated} for {error}");
    }
}

/// Steps, noise, rest and values that differ from row to row are not held.
#[test]
fn other_signals_are_not_held() {
    let mut noise = Noise(5);
    for law in 0..3 {
        for column in COLUMNS {
            for h in [0.0005, 0.002, 0.01] {
                for step in [0.0, 1e-6, 1e-4, 1e-3, 5e-3] {
                    for size in [0.0, 1.0, 4.0] {
                        let (time, exact) = logged(law, column, h, h, 0.0);
                        let written = exact.iter().map(|value| {
                            let noisy = value + size * step * noise.next();
                            if step > 0.0 { (noisy / step).round() * step } else { noisy }
                        });
                        let values: Vec<f64> = written.collect();
                        assert_eq!(held(&time, &values), None, "law {law} {column:?} h {h} step {step} noise {size}");
                    }
                }
            }
        }
    }
}

/// Stamps that scatter about an even grid are found; evenly spaced instants leave the torque of the motion.
#[test]
fn scattered_stamps_are_found_and_replaced() {
    let mut noise = Noise(9);
    let even = Treatment { time_stamps: TimeStamps::Even, ..Treatment::default() };
    for law in 0..3 {
        let truth = truth(law);
        for column in COLUMNS {
            for (h, kind) in [(0.0015, 0), (0.0024, 0), (0.002, 1), (0.010, 1), (0.002, 2)] {
                let count = (END / h).round() as u32;
                // Rows that the logger lost.
                let kept = (0..=count).filter(|k| kind != 2 || !(700..720).contains(k));
                let exact: Vec<f64> = kept.map(|k| f64::from(k) * h).collect();
                let values: Vec<f64> = exact.iter().map(|t| of(law, *t, column)).collect();
                let stamps: Vec<f64> = match kind {
                    0 => exact.iter().map(|t| (t * 1e3).round() * 1e-3).collect(),
                    _ => exact.iter().map(|t| t + 0.4 * h * noise.next()).collect(),
                };
                let what = format!("law {law} {column:?} h {h} kind {kind}");
                let plain = Recorded::new(samples(&stamps, values.clone(), column), Treatment::default()).unwrap();
                let Some(MadeUp { cause: Spurious::Stamps { scatter_s }, .. }) = plain.made_up() else {
                    panic!("{what}: {:?}, rms {} of {truth}", plain.made_up(), rms(&plain));
                };
                let meant = if kind == 0 { 1e-3 / 12.0_f64.sqrt() } else { 0.4 * h / 3.0_f64.sqrt() };
                assert!((scatter_s / meant - 1.0).abs() < 0.3, "{what}: {scatter_s} for {meant}");
                let found = Recorded::new(samples(&stamps, values, column), even).unwrap();
                let error = rms(&found) / truth - 1.0;
                assert!(error.abs() < 0.015, "{what}: {error}, without {}", rms(&plain) / truth);
                assert_eq!(found.made_up(), None, "{what}");
                assert_eq!(found.remarks(), [], "{what}");
            }
        }
    }
}

/// Stamps rounded more coarsely than the rows, equal ones among them, are replaced by even ones, over lost rows and
/// together with held values too.
#[test]
fn equal_stamps_are_replaced() {
    for law in 0..3 {
        let truth = truth(law);
        for column in COLUMNS {
            for (h, rounded, lost, held) in [
                (0.0004, 1e-3, false, 1),
                (0.0002, 1e-3, false, 1),
                (0.0001, 1e-3, false, 1),
                (0.0007, 1e-3, false, 1),
                (0.0004, 1e-3, true, 1),
                (0.0002, 1e-3, true, 1),
                (0.0004, 1e-3, false, 5),
            ] {
                let count = (END / h).round() as u32;
                let kept = (0..=count).filter(|k| !lost || !(700..780).contains(k));
                let exact: Vec<f64> = kept.map(|k| f64::from(k) * h).collect();
                let at = |t: &f64| (t / (h * f64::from(held)) + 1e-9).floor() * h * f64::from(held);
                let values: Vec<f64> = exact.iter().map(|t| of(law, at(t), column)).collect();
                let stamps: Vec<f64> = exact.iter().map(|t| (t / rounded + 1e-9).floor() * rounded).collect();
                let what = format!("law {law} {column:?} h {h} lost {lost} held {held}");
                let plain = Recorded::new(samples(&stamps, values.clone(), column), Treatment::default());
                assert!(matches!(plain, Err(RecordedFault::NotIncreasing { .. })), "{what}");
                let held_values = if held > 1 { HeldValues::Interpolated } else { HeldValues::Kept };
                let treatment = Treatment { time_stamps: TimeStamps::Even, held_values, ..Treatment::default() };
                let found = Recorded::new(samples(&stamps, values, column), treatment).unwrap();
                let error = rms(&found) / truth - 1.0;
                assert!(error.abs() < 0.02, "{what}: {error}");
                assert_eq!(found.remarks(), [], "{what}");
            }
        }
    }
}

/// A key without an effect is named: even stamps that become even, values that are not held; a recording at rest too.
/// Evenly spaced rows last as long as the run, however coarse their stamps are: by a row, and by what the beginning of a step within
/// a row leaves open.
#[test]
fn evenly_spaced_rows_last_as_long_as_the_run() {
    for step in [1.0, 0.1, 0.001] {
        for rate in [10.0, 20.0, 50.0, 100.0, 250.0, 1000.0] {
            for duration in [2.0, 2.5, 3.37, 8.0, 41.0] {
                for phase in [0.0, 0.031, 0.49, 0.93] {
                    for to_nearest in [false, true] {
                        let rows = (duration * rate + 1e-9_f64).floor();
                        let stamp = |k: f64| {
                            let t = (k / rate + phase) / step;
                            step * if to_nearest { t.round() } else { (t + 1e-9).floor() }
                        };
                        let time: Vec<f64> = (0_u32..).take(rows as usize + 1).map(|k| stamp(f64::from(k))).collect();
                        let even = evenly_spaced(&time).unwrap();
                        let (found, expected) = (even[even.len() - 1] - even[0], rows / rate);
                        let open =
                            if step > 1.5 / rate { 1.5 * duration / (duration - 2.0 * step).max(step) } else { 0.5 };
                        assert!(
                            (found - expected).abs() <= open / rate,
                            "{step} s {rate} Hz {duration} s {phase} {to_nearest}: {found} for {expected}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn keys_without_an_effect_are_named() {
    for law in 0..4 {
        for column in COLUMNS {
            for h in [0.0005, 0.001, 0.01] {
                let (time, moving) = logged(law.min(2), column, h, h, 0.0);
                let values = if law == 3 { vec![0.0; moving.len()] } else { moving };
                let both = Treatment { time_stamps: TimeStamps::Even, ..interpolated_values() };
                let found = Recorded::new(samples(&time, values.clone(), column), both).unwrap();
                assert_eq!(found.remarks(), [Remark::NotHeld, Remark::EvenAlready], "law {law} {column:?} {h}");
                let plain = Recorded::new(samples(&time, values, column), Treatment::default()).unwrap();
                assert_eq!(plain.remarks(), []);
            }
        }
    }
    let (time, values) = logged(0, SteppedColumn::Speed, 0.001, 0.004, 0.0);
    let held_torque =
        Samples { torque_nm: Some(values.into()), ..samples(&time, time.clone(), SteppedColumn::Position) };
    assert_eq!(Recorded::new(held_torque, interpolated_values()).unwrap().remarks(), [], "a held torque suffices");
}

/// True instants, however irregular, are kept: uneven sampling, lost rows, another rate in the middle; the last is no
/// even grid and refused as one.
#[test]
fn true_stamps_are_kept() {
    let mut noise = Noise(3);
    for law in 0..3 {
        for column in COLUMNS {
            for kind in 0..3 {
                let mut stamps: Vec<f64> = vec![0.0];
                while stamps.last().is_some_and(|last| *last < END) {
                    let last = stamps[stamps.len() - 1];
                    stamps.push(match kind {
                        0 => (stamps.len() as f64 + 0.4 * noise.next()) * 0.002,
                        1 => last + if stamps.len().is_multiple_of(50) { 0.012 } else { 0.002 },
                        _ => last + if last < 1.0 { 0.002 } else { 0.01 },
                    });
                }
                let values: Vec<f64> = stamps.iter().map(|t| of(law, *t, column)).collect();
                let found = Recorded::new(samples(&stamps, values.clone(), column), Treatment::default()).unwrap();
                assert_eq!(found.made_up(), None, "law {law} {column:?} kind {kind}");
                let even = Treatment { time_stamps: TimeStamps::Even, ..Treatment::default() };
                let forced = Recorded::new(samples(&stamps, values, column), even);
                assert_eq!(kind == 2, matches!(forced, Err(RecordedFault::StampsUneven { .. })), "{kind}");
                if kind == 0 {
                    assert_eq!(forced.unwrap().remarks(), [Remark::FollowsStamps], "law {law} {column:?}");
                }
            }
        }
    }
}

/// Noise at rest, held over several rows, is rest once the values are interpolated, with a window or without.
#[test]
fn held_noise_at_rest_is_rest() {
    let mut noise = Noise(21);
    for (h, period) in [(0.002, 0.008), (0.001, 0.004), (0.002, 0.005)] {
        for size in [1e-5, 1e-3, 1e-2] {
            let time: Vec<f64> = (0..=(END / h).round() as u32).map(|k| f64::from(k) * h).collect();
            let updates = (END / period).ceil() as usize + 1;
            let noisy: Vec<f64> = (0..updates)
                .map(|k| {
                    let speed = motion(0, k as f64 * period).1;
                    if speed == 0.0 { size * noise.normal() } else { speed }
                })
                .collect();
            let values: Vec<f64> = time.iter().map(|t| noisy[(t / period + 1e-9).floor() as usize]).collect();
            for smoothing in [None, Some(quantities::Measure::from_si(0.03))] {
                let treatment = Treatment { smoothing, ..interpolated_values() };
                let samples = samples(&time, values.clone(), SteppedColumn::Speed);
                let found = Recorded::new(samples, treatment).unwrap();
                let still = found.speed_rad_s().iter().filter(|speed| **speed == 0.0).count() as f64 * h;
                // Rests of 0.3, 0.51 and 0.39 s, less an update and the window at both ends of the moves.
                let meant = 0.3003 + 0.5104 + 0.3893;
                assert!(
                    (-0.2..0.03).contains(&(still - meant)),
                    "h {h} period {period} noise {size} {smoothing:?}: {still}"
                );
            }
        }
    }
}
