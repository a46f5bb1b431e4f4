use super::*;
use crate::generated::{Noise, forth_and_back};

/// Rows of a motion sampled at instants, with stamps, by the scatter relative to the interval.
struct Rows {
    time: Vec<f64>,
    position: Vec<f64>,
    speed: Vec<f64>,
    lost: usize,
}

/// Returns rows whose stamps scatter, or which are sampled at instants that scatter; one in `lost` rows is missing.
fn rows(noise: &mut Noise, h: f64, scatter: f64, lost: f64, is_true: bool) -> Rows {
    let [grid, position, speed] = forth_and_back(1e-5, 0.3, 1.5);
    let of = |values: &[f64], t: f64| {
        let x = (t / 1e-5).clamp(0.0, values.len() as f64 - 1.001);
        let k = x as usize;
        values[k] + (x - k as f64) * (values[k + 1] - values[k])
    };
    let count = (grid[grid.len() - 1] / h) as usize;
    let mut rows = Rows { time: Vec::new(), position: Vec::new(), speed: Vec::new(), lost: 0 };
    for k in 0..count {
        let (exact, stamp) = (k as f64 * h, (k as f64 + scatter * noise.next()) * h);
        if k > 20 && k + 20 < count && 0.5 * (noise.next() + 1.0) < lost {
            rows.lost += 1;
            continue;
        }
        let sampled = if is_true { stamp } else { exact };
        rows.time.push(77.0 + stamp);
        rows.position.push(of(&position, sampled));
        rows.speed.push(of(&speed, sampled));
    }
    rows
}

/// Stamps that scatter are replaced by the instants of the rows, over missing ones too, and those that the signals follow are
/// kept: with steps, noise and values held over rows.
#[test]
fn stamps_are_judged_by_the_signal_that_follows_them() {
    let mut noise = Noise(17);
    for h in [0.000_5, 0.001, 0.004] {
        for (scatter, lost) in [(0.1, 0.0), (0.3, 0.0), (0.3, 0.01), (0.3, 0.05), (0.4, 0.02)] {
            for disturbed in 0..4 {
                for is_true in [false, true] {
                    let Rows { time, position, speed, lost: missing } = rows(&mut noise, h, scatter, lost, is_true);
                    let what = format!("h {h} scatter {scatter} lost {lost} kind {disturbed} true {is_true}");
                    let seen: Vec<f64> = match disturbed {
                        0 => position,
                        1 => speed,
                        2 => position.iter().map(|q| (q / 2e-4).round() * 2e-4).collect(),
                        _ => position.iter().map(|q| q + 1e-4 * noise.normal()).collect(),
                    };
                    match Stamps::of(&time, &[&seen]) {
                        Stamps::Kept => assert!(
                            is_true,
                            "{what}: {:?}",
                            scattered(&time).map(|even| (share(&time, &even, &seen), even.scatter_s))
                        ),
                        Stamps::Scattered(even) => {
                            assert!(!is_true, "{what}");
                            let meant = scatter * h / 3.0_f64.sqrt();
                            assert!((even.scatter_s / meant - 1.0).abs() < 0.1, "{what}: {}", even.scatter_s);
                            assert!((even.interval_s / h - 1.0).abs() < 1e-3, "{what}: {}", even.interval_s);
                            let span = (even.time_s[even.time_s.len() - 1] - even.time_s[0]) / h;
                            assert!((span - (time.len() + missing - 1) as f64).abs() < 0.5, "{what}: {span}");
                            assert!((even.time_s[0] - 77.0).abs() < 0.2 * h, "{what}: {}", even.time_s[0]);
                        }
                        // Noise and steps above the motion within the scatter.
                        Stamps::Undecided { .. } => {
                            let is_hidden = disturbed > 1 && scatter * h < 2e-4;
                            assert!(is_hidden, "{what}: {:?}", share(&time, &scattered(&time).unwrap(), &seen));
                        }
                    }
                }
            }
        }
    }
}

/// Instants that scatter and are stamped with another scatter are neither those of the stamps nor even.
#[test]
fn half_true_stamps_are_undecided() {
    let mut noise = Noise(5);
    for h in [0.000_5, 0.001, 0.004] {
        let Rows { time, position, .. } = rows(&mut noise, h, 0.2, 0.0, true);
        let stamps: Vec<f64> = time.iter().map(|t| t + 0.2 * h * noise.next()).collect();
        let found = Stamps::of(&stamps, &[&position]);
        assert!(matches!(found, Stamps::Undecided { .. }), "{h}: {found:?}");
    }
}

/// A second signal decides where the first is hidden by its steps.
#[test]
fn another_signal_decides() {
    let mut noise = Noise(9);
    let Rows { time, position, speed, .. } = rows(&mut noise, 0.001, 0.1, 0.0, false);
    let coarse: Vec<f64> = position.iter().map(|q| (q / 0.02).round() * 0.02).collect();
    assert!(matches!(Stamps::of(&time, &[&coarse]), Stamps::Undecided { .. }));
    assert!(matches!(Stamps::of(&time, &[&coarse, &speed]), Stamps::Scattered(_)));
    assert_eq!(Stamps::of(&(0..4000).map(f64::from).collect::<Vec<f64>>(), &[&[]]), Stamps::Kept);
}

/// A held column has one value for each update, and values near the motion at its rows.
#[test]
fn a_held_column_has_one_value_for_each_update() {
    let [time, position, _] = forth_and_back(0.001, 0.3, 1.5);
    for rows in [2, 4, 10] {
        let values: Vec<f64> = (0..time.len()).map(|k| position[k / rows * rows]).collect();
        let held = HeldSignal::of(&time, &values).unwrap();
        assert!((held.period_s / (rows as f64 * 0.001) - 1.0).abs() < 0.01, "{rows}: {}", held.period_s);
        // Updates count half a row before the row of their change.
        let off = |(k, value): (usize, &f64)| (value - position[(k + 1).min(time.len() - 1)]).abs();
        let most = held.values.iter().enumerate().map(off).fold(0.0, f64::max);
        assert!(most < 2e-3, "{rows}: {most}");
        assert!(held.updated.len() < 2 * time.len() / rows, "{}", held.updated.len());
        assert_eq!(HeldSignal::of(&time, &position), None);
    }
}
