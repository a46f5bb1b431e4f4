//! Judging the whole catalogue for one axis, inside the process.
//!
//! Baseline: the bare sum that every judgement contains, T_rms by its formula for the same number of inertias.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, measure, milliseconds, numpy};
use std::hint::black_box;
use std::process::ExitCode;
use std::time::Duration;
use workbench::{Language, Project, size};

const PROJECT: &str = include_str!("../../examples/indexing-table.toml");

/// The same axis with many moves, to show how the cost grows.
fn with_moves(count: usize) -> String {
    let (head, tail) = PROJECT.split_once("[[motion]]").expect("the example has a move");
    let (one, rest) = tail.split_once("[bearing]").expect("the example has bearing loads");
    format!("{head}{}[bearing]{rest}", format!("[[motion]]{one}").repeat(count))
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let project = Project::read(PROJECT, Language::En).expect("the example is valid");
    let judged = size(&project).candidates.len();
    let inertias: Vec<f64> = (0..judged).map(|index| 0.1 + 0.01 * index as f64).collect();
    let (a, c, t0) = (3.5e3_f64, 0.3_f64, 1.3_f64);
    let baseline = measure(300, || {
        for inertia in &inertias {
            let (j, friction) = (1.3 + inertia, 5.0);
            black_box(((j * j * a + friction * friction * c) / t0).sqrt());
        }
    });
    let whole = measure(300, || {
        black_box(size(black_box(&project)));
    });
    let name = ("the bare T_rms of as many candidates", baseline);
    gates.hold(&format!("judge the catalogue ({judged} actuators)"), whole, Duration::from_millis(2), name);
    // The baseline knows limits only, no band of an estimate and no gear to warm up.
    let passes = |candidate: &&workbench::Candidate| candidate.fits() && candidate.standing.utilisation <= 1.0;
    let fitting = size(&project).candidates.iter().filter(passes).count();
    // As an engineer writes it: the cycle sampled every millisecond, vectors over time, one actuator after the other.
    match numpy(&["--sampled", "1e-3"]) {
        Some((time, fit)) => {
            assert_eq!(fit, fitting, "the baseline finds other actuators");
            gates.times_faster("  the same in NumPy, vectors over time", whole, time, 50.0);
        }
        None => println!("  no Python with NumPy here: the ratio to it is not measured"),
    }
    if let Some((time, _)) = numpy(&[]) {
        // Without instants, trace, heat and energy; told for comparison, not promised.
        let ratio = time.as_secs_f64() / whole.median.as_secs_f64();
        println!(
            "  fewer checks in NumPy, vectors over the catalogue: {:.3} ms, {ratio:.2} × slower",
            time.as_secs_f64() * 1e3
        );
    }
    println!("  per actuator: {:.0} ns", whole.median.as_secs_f64() * 1e9 / judged as f64);
    for count in [10, 100, 1000] {
        let many = Project::read(&with_moves(count), Language::En).expect("the repeated example is valid");
        let time = measure(20, || {
            black_box(size(black_box(&many)));
        });
        println!(
            "  cycle of {count} moves: {:.3} ms, {:.1} × one move",
            milliseconds(time.median),
            time.median.as_secs_f64() / whole.median.as_secs_f64()
        );
    }
    gates.close()
}
