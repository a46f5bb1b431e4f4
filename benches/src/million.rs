//! The hard case of a recording: a million positions on a millisecond grid, rounded to 9 digits as a controller writes them,
//! of a load so light and slow that four fifths of the catalogue survive. The catalogue judged on it, and the reserves of
//! the best of it searched.
//!
//! Baseline: reading the same file.
#![allow(clippy::expect_used, reason = "a bench fails loudly")]

use benches::{Gates, measure};
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::ExitCode;
use workbench::{Files, Language, Project, reserve_of, size};

const SAMPLES: usize = 1_000_000;

const PROJECT: &str = r#"
format = 1
[axis]
name = "slow sine"
[load]
inertia = "1 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "recorded"
file = "sine.csv"
units = { time = "s", position = "rad" }
[requirements]
supply = "560 V"
"#;

/// Ten swings of 1.5 rad in 1000 s.
fn recording() -> String {
    let last = (SAMPLES - 1) as f64;
    let mut text = String::from("time,position\n");
    for k in 0..SAMPLES {
        let position = 0.75 * (1.0 - (20.0 * PI * k as f64 / last).cos());
        writeln!(text, "{:.3},{position:.9}", k as f64 * 1e-3).expect("a string takes all");
    }
    text
}

struct Given(String);

impl Files for Given {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone())))
    }
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let files = Given(recording());
    let read = || Project::read_all(PROJECT, &files, Language::En).expect("the project is valid");
    let reading = measure(1, || drop(black_box(read())));
    let projects = read();
    let project = projects.first().expect("one axis");
    let sizing = size(project);
    let fitting = sizing.candidates.iter().filter(|candidate| candidate.fits()).count();
    assert!(fitting > 200, "the hard case is one that most survive: {fitting}");
    let best = sizing.candidates.first().expect("the catalogue is judged");
    let judged = measure(1, || drop(black_box(size(project))));
    gates.at_most_times("size on a million positions, against reading them", judged, reading, 20.0);
    let reserves = measure(1, || {
        black_box(reserve_of(project, best));
    });
    gates.at_most_times("reserves of one code on them, against reading them", reserves, reading, 8.0);
    gates.close()
}
