//! The digital twin: the full actuator with its load, a year of operation, and the linear drive compared with SciPy and
//! motulator.
//!
//! Baselines: sorting a million numbers; the speed step of `validation/twin` by LSODA of SciPy and by motulator, if
//! they are installed. Ratios are of processor time, on which a busy machine has little effect.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, baseline_s, least_processor_s, sort};
use mechanism::{Extra, Mechanism};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use std::hint::black_box;
use std::process::ExitCode;
use twin::{Operation, Parameters, Scenario, Setup, Switches, Twin, averaged};

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let code = order_code::parse("CHA-20A-100-H-C1024").expect("a code of the catalogue").code;
    let parameters = Parameters::of(&configurator::parameters(&code).expect("printed data"));
    let mechanism = Mechanism::direct(MomentOfInertia::from_si(1.3), Torque::from_si(5.0));
    let time = Time::from_si;
    let cycle = ManualMove {
        speed: AngularVelocity::new_in(30.0, &REVOLUTION_PER_MINUTE),
        accelerate: time(0.1),
        run: time(0.3),
        brake: time(0.1),
        pause: time(0.5),
    };
    let motion = Motion::new(&[SegmentSpec::Manual(cycle)], None, Closing::SingleMove).expect("a motion");
    let extras = [Extra::none()];
    let run = |setup: &Setup<'_>, until: f64| {
        let mut twin = Twin::new(setup).expect("a setup that runs");
        while twin.time_s() < until && !twin.is_over() {
            twin.advance(64);
        }
        black_box(twin.summary());
    };
    let full = Setup {
        scenario: Scenario { cycles: 5, ..Scenario::default() },
        ..Setup::of(&parameters, &mechanism, &motion, &extras)
    };
    let seconds = 5.0;
    let sorted = least_processor_s(9, 2, || sort(1_000_000));
    println!("full actuator, over real time, by processor time; a hundred times are promised at 10 µs:");
    for substeps in [6, 3, 2, 1] {
        let least = least_processor_s(9, 2, || run(&Setup { substeps, ..full }, seconds));
        println!("  steps of {:.1} µs: {:.0} ×", 62.5 / f64::from(substeps), seconds / least);
        if substeps == 6 {
            let what = "five simulated seconds of the full actuator";
            gates.share_at_most(what, least / sorted, ("a million numbers sorted", FULL_AT_MOST));
        }
    }
    let operation = Operation { periods: 365, period_s: 86_400.0, running_s: 57_600.0 };
    let year = least_processor_s(5, 1, || {
        black_box(averaged(&full, operation, || true).ok());
    });
    println!("a year of days with sixteen hours of operation: {year:.3} s by processor time; a second is promised");
    gates.share_at_most("such a year", year / sorted, ("a million numbers sorted", YEAR_AT_MOST));

    println!("common task: 0.05 s of the linear drive of validation/twin, a step of the speed, 16 kHz");
    let linear = Setup { switches: Switches::none(), speed_step: Some(0.05), ..full };
    let own = least_processor_s(9, 200, || run(&linear, 0.05));
    println!("  twin, steps of 10.4 µs: {:.3} ms", 1e3 * own);
    for (what, script, promise) in [
        ("  LSODA of SciPy, rtol 1e-6, over it", "twin_scipy.py", 100.0),
        ("  motulator 0.5.0, RK45, rtol 1e-3, over it", "twin_motulator.py", 300.0),
    ] {
        match baseline_s(script) {
            Some(other) => gates.times_faster_s(what, own, other, promise),
            None => println!("{what}: no Python with it here, not measured ({script})"),
        }
    }
    gates.close()
}

/// Largest ratio of the time of five simulated seconds to that of the baseline.
const FULL_AT_MOST: f64 = 4.0;
const YEAR_AT_MOST: f64 = 20.0;
