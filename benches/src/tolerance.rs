//! Tolerances judged for the ten best codes, inside the process.
//!
//! Baseline: a tenth as many judgements of the nominal axis, without building it again, on one thread.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use axis::AxisProject;
use benches::{Gates, against};
use questions::{Candidate, SAMPLES_USUAL, Sampling, assess, check, size};
use std::hint::black_box;
use std::process::ExitCode;

/// Returns the worked example with three toleranced quantities.
fn project() -> AxisProject {
    let mut text = include_str!("../../examples/manual-example.toml").to_owned();
    for (exact, half) in [("1.3 kg m^2", "10 %"), ("5 N m", "20 %"), ("40 1/min", "1 1/min")] {
        text = text.replacen(&format!("\"{exact}\""), &format!("\"{exact} ± {half}\""), 1);
    }
    questions::read(&text).expect("the example is valid")
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let project = project();
    assert_eq!(project.tolerances.len(), 3, "the example has changed");
    let sizing = size(&project);
    let best: Vec<&Candidate<'_>> = sizing.candidates.iter().take(10).collect();
    let codes: Vec<_> = best.iter().map(|each| each.id.clone()).collect();
    let judgements = || {
        for _ in 0..SAMPLES_USUAL / 10 {
            for code in &codes {
                let _ = black_box(check(black_box(&project), code));
            }
        }
    };
    let whole = against(7, judgements, || {
        black_box(assess(black_box(&project), &best, Sampling::default()));
    });
    let what = format!("{SAMPLES_USUAL} samples over the {} best codes", best.len());
    gates.at_most(&what, &whole, ("a tenth as many judgements, in full", 20.0));
    gates.close()
}
