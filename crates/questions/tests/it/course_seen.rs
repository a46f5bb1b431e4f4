//! The picture of a long recording has few instants, but all that is largest in it, heated by every sample.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use axis::Files;
use quantities::Language;
use questions::{Course, Sample};
use std::fmt::Write as _;

const COUNT: u32 = 300_000;

/// A swing with noise as torque and single peaks of one sample.
struct Log;

impl Files for Log {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let mut text = String::from("t [s],w [rad/s],T [Nm]\n");
        for k in 0..=COUNT {
            let share = f64::from(k) / f64::from(COUNT);
            let speed = 1.5 * (share * 24.0 * std::f64::consts::TAU).sin();
            let torque = f64::from((k * 7919) % 1000) * 1e-3 + if k % 40_009 == 7 { 12.0 } else { 0.0 };
            let _ = writeln!(text, "{:.3},{speed:.9},{torque}", f64::from(k) * 1e-3);
        }
        Ok(Box::new(std::io::Cursor::new(text)))
    }
}

const AXIS: &str = r#"
format = 1
[axis]
single_move = true
[load]
inertia = "0.3 kg m^2"
friction_torque = "1 N m"
[[motion]]
law = "recorded"
file = "log.csv"
columns = { time = "t", speed = "w", torque = "T" }
[requirements]
ambient = "25 degC"
"#;

#[test]
fn a_picture_of_a_long_recording_has_its_peaks_and_its_heat() {
    let project = questions::read_all(AXIS, &Log).unwrap().pop().unwrap();
    let code = questions::read_code("CHA-20A-100-H-C1024", Language::En).unwrap().parsed.code;
    let candidate = questions::check(&project, &code).unwrap();
    let all = questions::course(&project, &candidate);
    let seen = questions::course_seen(&project, &candidate, None);
    assert_eq!(all.samples.len(), 2 * COUNT as usize);
    assert!(seen.samples.len() < 14 << 14, "{}", seen.samples.len());
    assert!(seen.samples.is_sorted_by(|a, b| a.time_s <= b.time_s));
    let signals: [fn(&Sample) -> f64; 6] = [
        |sample| sample.position_rad,
        |sample| sample.speed_rad_s,
        |sample| sample.acceleration_rad_s2,
        |sample| sample.torque_nm,
        |sample| sample.current_a.unwrap(),
        |sample| sample.power_w.unwrap(),
    ];
    for signal in signals {
        let range = |course: &Course| {
            let values = || course.samples.iter().map(signal);
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
        };
        assert_eq!(range(&all), range(&seen));
    }
    let mut others = all.samples.iter();
    let mut warmest = 0.0_f64;
    for sample in &seen.samples {
        let same = |other: &&Sample| other.time_s == sample.time_s && other.torque_nm == sample.torque_nm;
        let same = others.find(same).unwrap();
        for (found, expected) in [(sample.winding_k, same.winding_k), (sample.housing_k, same.housing_k)] {
            let (found, expected) = (found.unwrap(), expected.unwrap());
            assert!((found - expected).abs() < 1e-3, "{found} {expected} at {}", sample.time_s);
            warmest = warmest.max(expected);
        }
        let (found, expected) = (sample.overload.unwrap(), same.overload.unwrap());
        assert!((found - expected).abs() < 1e-4 * (1.0 + expected), "{found} {expected} at {}", sample.time_s);
    }
    assert!(warmest > 299.0, "{warmest}");
    // A time with fewer samples is seen one by one.
    let (from, until) = (100.0, 140.0);
    let within = |course: &Course| {
        let inside = |sample: &&Sample| sample.time_s > from && sample.time_s < until;
        course.samples.iter().filter(inside).map(|sample| (sample.time_s, sample.torque_nm)).collect::<Vec<_>>()
    };
    let window = questions::course_seen(&project, &candidate, Some((from, until)));
    let (found, expected) = (within(&window), within(&all));
    // At its ends a group may reach into it.
    let inner = |seen: &[(f64, f64)]| seen.iter().filter(|(t, _)| *t > from + 0.1 && *t < until - 0.1).count();
    assert_eq!(inner(&found), inner(&expected));
    assert!(expected.len() > 79_000);
    assert!(window.samples.len() < (14 << 14) + 2 * 41_000, "{}", window.samples.len());
}
