use super::*;
use crate::generated::{Noise, poly, recorded, samples};
use crate::{Recorded, Spurious, Treatment};

/// Samples of a motion by 90° there and back, in counts of an encoder and with decimals of a degree.
struct Printed {
    time: Vec<f64>,
    /// Exact positions \[rad\].
    exact: Vec<f64>,
    /// Positions as they stand in the file \[rad\].
    position: Vec<f64>,
    /// Step of the encoder and of the print \[rad\].
    steps: [f64; 2],
}

impl Printed {
    fn new(count_deg: f64, decimals: i32, h: f64, (offset_deg, floors): (f64, bool)) -> Self {
        let print = 10_f64.powi(decimals);
        let rows = (2.95 / h).round() as u32;
        let time: Vec<f64> = (0..rows).map(|k| f64::from(k) * h).collect();
        let exact: Vec<f64> = time.iter().map(|t| poly(90.0, 1.0, t - 0.2).0 - poly(90.0, 1.0, t - 1.7).0).collect();
        let counted = |q: f64| {
            let counts = (q + offset_deg) / count_deg;
            let whole = if floors { counts.floor() } else { (counts + 0.5).floor() };
            ((whole * count_deg * print).round() / print).to_radians()
        };
        Self {
            position: exact.iter().map(|q| counted(*q)).collect(),
            exact: exact.iter().map(|q| q.to_radians()).collect(),
            time,
            steps: [count_deg.to_radians(), (1.0 / print).to_radians()],
        }
    }
}

/// Counts of 10 to 17 bits with one to four decimals: the step is that of the encoder where it is the coarser one, to within
/// a hundredth, and that of the print where the encoder is finer.
#[test]
fn counts_of_an_encoder_are_found_behind_the_rounding_of_the_file() {
    let mut seen = 0;
    for bits in 10..18 {
        for decimals in 1..5 {
            for (offset, floors) in [(0.0, false), (12_345.678, false), (0.0, true)] {
                let count_deg = 360.0 / f64::from(1_u32 << bits);
                let printed = Printed::new(count_deg, decimals, 2e-3, (offset, floors));
                let [count, print] = printed.steps;
                let grid = Grid::of(&printed.position);
                let what = format!("{bits} bit, {decimals} decimals, {offset}: {grid:?}");
                if count > 1.5 * print {
                    seen += 1;
                    assert!((grid.step / count - 1.0).abs() < 0.01, "{what}, {count}");
                } else if count < print {
                    assert!((grid.step / print - 1.0).abs() < 1e-6, "{what}, {print}");
                }
            }
        }
    }
    assert!(seen > 60, "{seen}");
}

/// Values on a grid by chance have no step other than that of the grid: random whole numbers, squares, dense and sparse ones.
#[test]
fn no_coarser_step_is_found_in_values_that_have_none() {
    let mut noise = Noise(0x5eed_0123_4567_89ab);
    for count in [20, 100, 1000, 5000] {
        for range in [50.0, 1000.0, 1e5].into_iter().filter(|range| count > 100 || *range < 1e4) {
            let values: Vec<f64> = (0..count).map(|_| (noise.next() * range).round() * 1e-3).collect();
            let step = Grid::of(&values).step;
            assert!((step / 1e-3 - 1.0).abs() < 1e-6, "{count} of {range}: {step}");
            let exact: Vec<f64> = (0..count).map(|_| noise.next() * range).collect();
            assert!(Grid::of(&exact).step < 1e-8 * range, "{count} of {range}: {:?}", Grid::of(&exact));
        }
    }
}

fn accelerations(time: &[f64], position: &[f64]) -> Vec<f64> {
    let found = recorded(samples(time, Some(position), None));
    let pairs = found.speed_rad_s().windows(2).zip(found.time_s().windows(2));
    pairs.map(|(w, t)| (w[1] - w[0]) / (t[1] - t[0])).collect()
}

fn largest(found: &Recorded) -> f64 {
    let pairs = found.speed_rad_s().windows(2).zip(found.time_s().windows(2));
    pairs.map(|(w, t)| ((w[1] - w[0]) / (t[1] - t[0])).abs()).fold(0.0, f64::max)
}

/// A rounding of counts and print that raises the largest acceleration by a tenth is named as steps with the size of
/// the artefact within a factor of about two and the acceleration of the motion within a quarter; held values are not named.
#[test]
fn the_artefact_of_printed_counts_is_named_with_its_size() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for bits in 10..18 {
        for decimals in 1..5 {
            for h in [1e-3, 2e-3, 4e-3, 1e-2] {
                let count_deg = 360.0 / f64::from(1_u32 << bits);
                if 0.1_f64.powi(decimals) > 8.0 * count_deg {
                    continue;
                }
                let printed = Printed::new(count_deg, decimals, h, (0.0, false));
                let found = recorded(samples(&printed.time, Some(&printed.position), None));
                let motion = largest(&recorded(samples(&printed.time, Some(&printed.exact), None)));
                let artefact = largest(&found) - motion;
                let [with, without] = [&printed.position, &printed.exact].map(|q| accelerations(&printed.time, q));
                let error = with.iter().zip(&without).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let what = format!("{bits} bit, {decimals} decimals, {h} s: {error:.3} beside {motion:.3}, ");
                match found.made_up() {
                    None if artefact > 0.1 * motion => wrong.push(what + "silent"),
                    None => {}
                    Some(made_up) => {
                        seen += 1;
                        let Spurious::Steps { smoothing_s, .. } = made_up.cause else {
                            wrong.push(format!("{what}{made_up:?}"));
                            continue;
                        };
                        let ratio = made_up.acceleration_rad_s2 / error;
                        let is_sized = (0.5..=2.5).contains(&ratio);
                        let is_motion = (made_up.motion_rad_s2 / motion - 1.0).abs() < 0.25;
                        if !is_sized || !is_motion {
                            wrong.push(format!("{what}{ratio:.2} {made_up:?}"));
                        }
                        let smoothing = smoothing_s.filter(|_| h > 3e-3).map(quantities::Measure::from_si);
                        if smoothing.is_none() {
                            continue;
                        }
                        let treatment = Treatment { smoothing, ..Treatment::default() };
                        let smooth =
                            Recorded::new(samples(&printed.time, Some(&printed.position), None), treatment).unwrap();
                        if largest(&smooth) > 1.15 * motion {
                            wrong.push(format!("{what}smoothed {:.3} {made_up:?}", largest(&smooth)));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {seen}: {wrong:#?}", wrong.len());
    assert!(seen > 60, "{seen}");
}

/// A constant speed that advances by a few steps of the print per row has levels at equal distances too: the step is that of the
/// print.
#[test]
fn a_constant_speed_is_no_grid_of_an_encoder() {
    for rows in [1.3, 1.7, 2.3, 3.37, 5.21, 17.13] {
        let (h, print) = (1e-3, 0.01_f64.to_radians());
        let ramp = |t: f64| rows * print / h * (t.clamp(0.1, 0.9) - 0.1);
        let time: Vec<f64> = (0..1000_u32).map(|k| f64::from(k) * h).collect();
        let position: Vec<f64> = time.iter().map(|t| (ramp(*t) / print).round() * print).collect();
        let found = recorded(samples(&time, Some(&position), None)).made_up();
        match found.map(|found| found.cause) {
            Some(Spurious::Steps { step, .. }) => assert!((step / print - 1.0).abs() < 1e-6, "{rows}: {step}"),
            other => panic!("{rows}: {other:?}"),
        }
    }
}
