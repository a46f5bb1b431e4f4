//! The digital twin: the full actuator with its load, and the linear drive beside SciPy.
//!
//! Baselines: sorting a million numbers; LSODA of SciPy on the speed step of `validation/twin`, where there is a Python with it.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, against, root, sort};
use mechanism::{Extra, Mechanism};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use std::hint::black_box;
use std::process::{Command, ExitCode};
use std::time::Duration;
use twin::{Parameters, Scenario, Setup, Switches, Twin};

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
    let found = against(9, || sort(1_000_000), || run(&full, seconds));
    let real = seconds / found.measured.median.as_secs_f64();
    let best = seconds / found.measured.least.as_secs_f64();
    println!("full actuator, steps of 10.4 µs: {real:.0} × real time, at best {best:.0} ×");
    gates.at_most("five simulated seconds of the full actuator", &found, ("a million numbers sorted", FULL_AT_MOST));

    let linear = Setup { switches: Switches::none(), speed_step: Some(0.05), ..full };
    let step = against(9, || sort(1_000_000), || run(&linear, 0.05));
    match scipy() {
        Some(other) => gates.times_faster("  the speed step of 0.05 s by LSODA of SciPy", step.measured, other, 100.0),
        None => println!("  no Python with SciPy here: the ratio to it is not measured"),
    }
    gates.close()
}

/// So many times as long as the baseline five simulated seconds may take.
const FULL_AT_MOST: f64 = 9.0;

/// The baseline in SciPy; `None` where there is none.
fn scipy() -> Option<Duration> {
    let script = root().join("benches/baseline/twin_scipy.py");
    let answer = Command::new("python3").arg(script).output().ok().filter(|answer| answer.status.success())?;
    let text = String::from_utf8(answer.stdout).ok()?;
    let (_, rest) = text.split_once("\"seconds\": ")?;
    rest.split('}').next()?.trim().parse().ok().map(Duration::from_secs_f64)
}
