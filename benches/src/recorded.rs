//! A recorded motion of a million samples: the pass that makes sums and bounds, and the catalogue judged on it.
//!
//! Baseline: one pass over the same arrays that only sums them.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, against};
use mechanism::{Joint, Mechanism, MechanismKind};
use motion::{Closing, Motion, Recorded, Samples, SegmentSpec, Treatment};
use quantities::{Measure, MomentOfInertia, Torque};
use std::hint::black_box;
use std::process::ExitCode;
use std::sync::Arc;

const SAMPLES: usize = 1_000_000;

/// Returns the samples of a robot joint at 1 kHz: a slow swing with quicker moves on it, gravity and inertia in the
/// torque.
fn samples() -> Samples {
    let time_s: Vec<f64> = (0..SAMPLES).map(|k| k as f64 * 1e-3).collect();
    let speed = |t: f64| 0.8 * (0.9 * t).sin() + 0.5 * (3.1 * t).sin() + 0.2 * (12.0 * t).sin();
    let torque = |t: f64| 14.0 * (0.45 * t).cos() + 6.0 * (3.1 * t).cos() + 5.0 * (12.0 * t).cos();
    Samples {
        speed_rad_s: Some(Arc::new(time_s.iter().map(|t| speed(*t)).collect())),
        torque_nm: Some(Arc::new(time_s.iter().map(|t| torque(*t)).collect())),
        position_rad: None,
        time_s: time_s.into(),
    }
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let recorded = Arc::new(Recorded::new(samples(), Treatment::default()).expect("the samples are a motion"));
    let motion = Motion::new(&[SegmentSpec::Recorded(Arc::clone(&recorded))], None, Closing::SingleMove)
        .expect("one recording is a motion");
    let joint = MechanismKind::Joint(Joint { inertia: None, holding_torque: None });
    let joint = Mechanism { kind: joint, ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0)) };
    let direct = Mechanism::direct(MomentOfInertia::from_si(0.4), Torque::from_si(2.0));
    let sum = |values: &[f64]| values.iter().sum::<f64>();
    let baseline = || {
        black_box(sum(recorded.time_s()) + sum(recorded.speed_rad_s()));
        black_box(sum(recorded.position_rad()) + recorded.torque_nm().map_or(0.0, sum));
    };
    for (what, mechanism) in [("joint", joint), ("inertia and friction", direct)] {
        let pass = against(60, baseline, || {
            black_box(sizing::Axis::new(mechanism.clone(), motion.clone(), Vec::new()));
        });
        let what = format!("pass over {SAMPLES} samples, {what}");
        gates.at_most(&what, &pass, ("the sums of the same arrays", 6.0));
        println!("  per sample: {:.1} ns", pass.measured.median.as_secs_f64() * 1e9 / SAMPLES as f64);
    }
    gates.close()
}
