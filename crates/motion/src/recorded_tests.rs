use super::*;
use quantities::{AngularVelocity, Time};

fn times(n: u32, h: f64) -> Vec<f64> {
    // Intentionally irregular: every third step is a fifth longer.
    let mut t = 3.0;
    (0..n)
        .map(|k| {
            let here = t;
            t += if k % 3 == 0 { 1.2 * h } else { h };
            here
        })
        .collect()
}

fn of(time: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
    time.iter().map(|t| f(*t)).collect()
}

#[test]
fn a_parabola_of_positions_is_differentiated_exactly() {
    let time = times(40, 0.01);
    let position = of(&time, |t| 0.3 + 2.0 * t - 1.5 * t * t);
    let samples = Samples { time_s: time.clone().into(), position_rad: Some(position.into()), ..Samples::default() };
    for smoothing in [None, Some(Time::from_si(0.1))] {
        let treatment = Treatment { smoothing, ..Treatment::default() };
        let recorded = Recorded::new(samples.clone(), treatment).unwrap();
        assert!(recorded.is_placed());
        for (t, speed) in time.iter().zip(recorded.speed_rad_s()) {
            assert!((speed - (2.0 - 3.0 * t)).abs() < 1e-9, "{smoothing:?} at {t}: {speed}");
        }
    }
}

/// For sin t the error of the slope is h²/6 of the third derivative inside.
#[test]
fn the_error_of_the_difference_falls_with_the_square_of_the_step() {
    let worst = |n: u32, h: f64| {
        let time = times(n, h);
        let position = of(&time, f64::sin);
        let samples =
            Samples { time_s: time.clone().into(), position_rad: Some(position.into()), ..Samples::default() };
        let recorded = Recorded::new(samples, Treatment::default()).unwrap();
        time.iter().zip(recorded.speed_rad_s()).map(|(t, w)| (w - t.cos()).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (worst(100, 0.02), worst(200, 0.01));
    assert!(coarse < 0.03_f64.powi(2) / 3.0, "{coarse}");
    assert!((coarse / fine - 4.0).abs() < 0.3, "{coarse} {fine}");
}

#[test]
fn smoothing_takes_the_noise_and_leaves_the_motion() {
    let time: Vec<f64> = (0..2000).map(|k| f64::from(k) * 1e-3).collect();
    // Two samples above, two below by one encoder step: the worst case for central differences.
    let noisy = |k: usize, t: f64| (2.0 * t).sin() + if k % 4 < 2 { 1e-5 } else { -1e-5 };
    let position: Vec<f64> = time.iter().enumerate().map(|(k, t)| noisy(k, *t)).collect();
    let samples = Samples { time_s: time.clone().into(), position_rad: Some(position.into()), ..Samples::default() };
    let worst = |treatment| {
        let recorded = Recorded::new(samples.clone(), treatment).unwrap();
        let pairs = recorded.speed_rad_s().windows(2).zip(time.iter());
        pairs
            .map(|(pair, t)| ((pair[1] - pair[0]) / 1e-3 + 4.0 * (2.0 * (t + 5e-4)).sin()).abs())
            .skip(50)
            .take(1900)
            .fold(0.0, f64::max)
    };
    let raw = worst(Treatment::default());
    let smooth = worst(Treatment { smoothing: Some(Time::from_si(0.04)), ..Treatment::default() });
    assert!(raw > 5.0 && smooth < 0.01 * raw, "{raw} {smooth}");
}

#[test]
fn speeds_are_integrated_and_standstill_is_cut() {
    let time = vec![0.0, 1.0, 2.0, 4.0];
    let samples =
        Samples { time_s: time.into(), speed_rad_s: Some(vec![0.0, 2.0, 2.0, 0.001].into()), ..Samples::default() };
    let recorded = Recorded::new(samples.clone(), Treatment::default()).unwrap();
    assert_eq!(recorded.position_rad()[..3], [0.0, 1.0, 3.0]);
    assert!((recorded.ends_rad().1 - 5.001).abs() < 1e-12);
    assert!(!recorded.is_placed());
    let treatment = Treatment { standstill: Some(AngularVelocity::from_si(0.01)), ..Treatment::default() };
    assert_eq!(Recorded::new(samples, treatment).unwrap().end_speeds_rad_s(), (0.0, 0.0));
}

#[test]
fn what_is_no_motion_is_reported() {
    let new = |time: &[f64], position: Option<&[f64]>, speed: Option<&[f64]>, window: Option<f64>| {
        let samples = Samples {
            time_s: time.to_vec().into(),
            position_rad: position.map(|values| values.to_vec().into()),
            speed_rad_s: speed.map(|values| values.to_vec().into()),
            torque_nm: None,
        };
        Recorded::new(samples, Treatment { smoothing: window.map(Time::from_si), ..Treatment::default() }).err()
    };
    let ramp: &[f64] = &[0.0, 1.0, 2.0];
    assert_eq!(new(&[0.0, 1.0], Some(&[0.0, 1.0]), None, None), Some(RecordedFault::TooFew { samples: 2 }));
    assert_eq!(new(ramp, None, None, None), Some(RecordedFault::NoCourse));
    assert_eq!(new(ramp, Some(&[0.0]), None, None), Some(RecordedFault::Uneven));
    assert_eq!(new(ramp, Some(&[0.0, f64::NAN, 1.0]), None, None), Some(RecordedFault::NotFinite { index: 1 }));
    assert_eq!(new(&[0.0, 1.0, 1.0], Some(ramp), None, None), Some(RecordedFault::NotIncreasing { index: 2 }));
    assert_eq!(new(ramp, Some(ramp), Some(&[1.0, 1.0, 1.0]), None), None);
    assert!(matches!(
        new(ramp, Some(ramp), Some(&[57.3, 57.3, 57.3]), None),
        Some(RecordedFault::Contradiction { share, factor: Some(factor) }) if share > 0.9 && (factor - 57.3).abs() < 1e-9
    ));
    assert_eq!(new(ramp, Some(ramp), None, Some(1.0)), Some(RecordedFault::WindowTooShort { least: None }));
}

/// A smoothing window is accepted up to the duration of the recording and refused beyond it with both durations; the
/// width that is proposed for a window with too few samples is accepted.
#[test]
fn a_window_wider_than_the_recording_is_refused() {
    for samples in [4_u32, 6, 7, 8, 20, 301] {
        for interval in [1e-3, 0.05] {
            let time: Vec<f64> = (0..samples).map(|k| 7.0 + interval * f64::from(k)).collect();
            let duration = interval * f64::from(samples - 1);
            let wave: Vec<f64> = time.iter().map(|t| (3.0 * (t - 7.0) / duration).sin()).collect();
            for is_speed in [false, true] {
                let with = |window: f64| {
                    let column = Some(wave.clone().into());
                    let (position_rad, speed_rad_s) = if is_speed { (None, column) } else { (column, None) };
                    let samples = Samples { time_s: time.clone().into(), position_rad, speed_rad_s, torque_nm: None };
                    let treatment = Treatment { smoothing: Some(Time::from_si(window)), ..Treatment::default() };
                    Recorded::new(samples, treatment).err()
                };
                for share in [1.01, 2.0, 1e3] {
                    let Some(RecordedFault::WindowOverMotion { window, duration: stated }) = with(share * duration)
                    else {
                        panic!("{samples} {interval} {share}: {:?}", with(share * duration))
                    };
                    assert!((window.si() - share * duration).abs() < 1e-9 * window.si());
                    assert!((stated.si() - duration).abs() < 1e-9);
                }
                let widest = with(duration);
                let Some(RecordedFault::WindowTooShort { least }) = with(2.0 * interval) else { panic!("{samples}") };
                assert_eq!((widest.is_none(), least.is_some()), (samples > 6, samples > 6), "{samples}: {widest:?}");
                assert_eq!(least.and_then(|least| with(least.si())), None);
            }
        }
    }
}

/// Speeds that differ from the positions by a factor, of a unit or a ratio, are refused with it from 2 % on, also with
/// noise and coarse positions; other differences are tolerated up to 5 % of the travel.
#[test]
fn a_factor_between_position_and_speed_is_refused_with_it() {
    let mut noise = crate::generated::Noise(13);
    for law in crate::generated::Law::ALL {
        let cycle = crate::generated::Cycle { law, way: 1.5, rest: 0.3 };
        let time = cycle.rows(0.002);
        for size in [0.0, 1e-3] {
            let mut noisy = |k: usize| time.iter().map(|t| cycle.at(*t)[k] + size * noise.next()).collect::<Vec<f64>>();
            let (position, speed) = (noisy(0), noisy(1));
            for factor in [1.0, 1.01, 0.8, 80.0 / 83.0, 1.03, 1.25, -1.0, 0.0125, 57.3] {
                let scaled: Vec<f64> = speed.iter().map(|speed| speed * factor).collect();
                let samples = crate::generated::samples(&time, Some(&position), Some(&scaled));
                match Recorded::new(samples, Treatment::default()) {
                    Err(RecordedFault::Contradiction { factor: Some(found), .. }) => {
                        assert!((found / factor - 1.0).abs() < 2e-3, "{law:?} {size} {factor}: {found}");
                    }
                    Ok(_) => assert!((factor - 1.0_f64).abs() < 0.02, "{law:?} {size} {factor}"),
                    Err(other) => panic!("{law:?} {size} {factor}: {other:?}"),
                }
            }
            // A drift of the speed is no factor.
            let drifting: Vec<f64> = speed.iter().map(|speed| speed + 0.015).collect();
            let samples = crate::generated::samples(&time, Some(&position), Some(&drifting));
            assert!(Recorded::new(samples, Treatment::default()).is_ok(), "{law:?} {size}");
        }
    }
}

/// The states of a recording are those of its intervals, at any pace and behind a stage.
#[test]
fn rest_and_turning_are_those_of_the_intervals() {
    let mut noise = crate::generated::Noise(11);
    for case in 0..200 {
        // Never, rarely, mostly and always at zero.
        let still = [-1.0, -0.6, 0.6, 1.0][case % 4];
        let speed: Vec<f64> =
            (0..12).map(|k| if noise.next() < still { 0.0 } else { 1.0 + f64::from(k) * 0.1 }).collect();
        let time: Vec<f64> = (0..12).map(|k| 0.01 * f64::from(k)).collect();
        let samples = Samples { time_s: time.into(), speed_rad_s: Some(speed.into()), ..Samples::default() };
        let Ok(recorded) = Recorded::new(samples, Treatment::default()) else { continue };
        for recorded in [recorded.geared(-3.0), recorded] {
            let placed =
                crate::Placed { recorded: recorded.into(), start_s: 0.0, offset_rad: 0.0, stretch: 1.7, segment: 0 };
            let intervals: Vec<_> = (0..placed.intervals()).filter_map(|index| placed.interval(index)).collect();
            let rests = intervals.iter().any(|interval| interval.speed_rad_s == [0.0; 2]);
            let turns = intervals.iter().any(|interval| interval.speed_rad_s != [0.0; 2]);
            assert_eq!((placed.recorded.rests(), placed.recorded.turns()), (rests, turns), "{:?}", placed.recorded);
        }
    }
}

/// A recorded speed whose integral returns to the start has no distance, whatever the rounding of its sums.
#[test]
fn a_recorded_return_to_the_start_has_no_distance() {
    for rows in [41_u32, 163, 1001] {
        for top in [0.1, 3.7, 61.3] {
            let time: Vec<f64> = (0..rows).map(|k| 0.007 * f64::from(k)).collect();
            let turn = std::f64::consts::TAU / f64::from(rows - 1);
            let speed: Vec<f64> = (0..rows).map(|k| top * (turn * f64::from(k)).sin()).collect();
            let samples = Samples { time_s: time.into(), speed_rad_s: Some(speed.into()), ..Samples::default() };
            let recorded = Recorded::new(samples, Treatment::default()).unwrap();
            let placed =
                crate::Placed { recorded: recorded.into(), start_s: 0.0, offset_rad: 0.3, stretch: 1.0, segment: 0 };
            let [distance, speed, _] = placed.course();
            assert_eq!(distance, 0.0, "{rows} {top}");
            assert!((speed / top - 1.0).abs() < 0.01);
        }
    }
}
