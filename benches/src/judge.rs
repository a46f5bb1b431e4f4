//! Judging the whole catalogue for one axis, within the process.
//!
//! Baselines: sorting ten thousand numbers; and the NumPy script of an engineer, if NumPy is installed.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, against, numpy, size, sort};
use questions::{check, reserve_of};
use std::hint::black_box;
use std::process::ExitCode;

const PROJECT: &str = include_str!("../../examples/indexing-table.toml");

/// Returns the axis with many moves, all different, so that no result is reused.
fn with_moves(count: usize) -> String {
    let (head, tail) = PROJECT.split_once("[[motion]]").expect("the example has a move");
    let (one, rest) = tail.split_once("[bearing]").expect("the example has bearing loads");
    let moves: String = (0..count)
        .map(|k| format!("[[motion]]{}", one.replace("40 1/min", &format!("{} 1/min", 40.0 - 0.015 * k as f64))))
        .collect();
    format!("{head}{moves}[bearing]{rest}")
}

/// Returns moves back and forth by a law with curvature throughout, each time a little farther.
fn with_smooth_moves(count: usize) -> String {
    let moves: String = (0..count)
        .map(|k| {
            let angle = (40.0 + 0.05 * (k / 2) as f64) * if k % 2 == 0 { 1.0 } else { -1.0 };
            format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{angle} deg\"\ntime = \"0.7 s\"\n")
        })
        .collect();
    format!(
        "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n{moves}[requirements]\n\
         supply = \"560 V\"\nambient = \"35 degC\"\n"
    )
}

/// Returns the station with a law with curvature throughout, with the rest of the cycle as a dwell.
fn with_a_smooth_move() -> String {
    let (head, tail) = PROJECT.split_once("[[motion]]").expect("the example has a move");
    let (_, rest) = tail.split_once("[bearing]").expect("the example has bearing loads");
    let smooth = "law = \"modified_sine\"\ndistance = \"48 deg\"\ntime = \"0.3 s\"\n";
    format!("{head}[[motion]]\n{smooth}[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[bearing]{rest}")
}

/// Returns an arm that swings a thousand times under its weight, all different, so that no result is reused.
fn swings() -> String {
    let moves: String = (0..1000)
        .map(|k| {
            let angle = (40.0 + 0.05 * f64::from(k / 2)) * if k % 2 == 0 { 1.0 } else { -1.0 };
            format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{angle} deg\"\ntime = \"0.7 s\"\n")
        })
        .collect();
    format!(
        "format = 1\n[mechanism.arm]\ninertia = \"0.5 kg m^2\"\nmass = \"2 kg\"\ncentre_distance = \"200 mm\"\n\
         axis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n{moves}[requirements]\nsupply = \"560 V\"\nambient = \"30 degC\"\n"
    )
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let project = questions::read(PROJECT).expect("the example is valid");
    let judged = size(&project).candidates.len();
    let whole = against(
        400,
        || sort(10_000),
        || {
            black_box(size(black_box(&project)));
        },
    );
    let baseline = "sorting ten thousand numbers";
    gates.at_most(&format!("judge the catalogue ({judged} actuators)"), &whole, (baseline, 12.0));
    // The baseline uses limits only, without bands of estimates and without the warm-up of a gear.
    let passes = |candidate: &&questions::Candidate| candidate.fits() && candidate.standing.utilisation <= 1.0;
    let fitting = size(&project).candidates.iter().filter(passes).count();
    // The usual way: the cycle sampled every millisecond, vectors over time, one actuator after the other.
    match numpy(&["--sampled", "1e-3"]) {
        Some((time, fit)) => {
            assert_eq!(fit, fitting, "the baseline finds other actuators");
            gates.times_faster("  the same in NumPy, vectors over time", whole.measured, time, 12.0);
        }
        None => println!("  no Python with NumPy here: the ratio to it is not measured"),
    }
    if let Some((time, _)) = numpy(&[]) {
        // Without instants, trace, heat and energy; for comparison only, without a gate.
        let ratio = time.as_secs_f64() / whole.measured.median.as_secs_f64();
        println!(
            "  fewer checks in NumPy, vectors over the catalogue: {:.3} ms, {ratio:.2} × slower",
            time.as_secs_f64() * 1e3
        );
    }
    println!("  per actuator: {:.0} ns", whole.measured.median.as_secs_f64() * 1e9 / judged as f64);
    let smooth = questions::read(&with_a_smooth_move()).expect("the example with a smooth law is valid");
    let one = || {
        black_box(size(black_box(&project)));
    };
    let found = against(100, one, || {
        black_box(size(black_box(&smooth)));
    });
    gates.at_most("one move of a smooth law", &found, ("one move of three ramps", 10.0));
    for (count, promise) in [(10, 6.0), (100, 15.0), (1000, 40.0)] {
        let many = questions::read(&with_moves(count)).expect("the repeated example is valid");
        let one = || {
            black_box(size(black_box(&project)));
        };
        let found = against(30, one, || {
            black_box(size(black_box(&many)));
        });
        gates.at_most(&format!("cycle of {count} moves, all different"), &found, ("one move", promise));
    }
    let many = questions::read(&with_smooth_moves(1000)).expect("a thousand smooth moves are valid");
    let found = against(10, one, || {
        black_box(size(black_box(&many)));
    });
    gates.at_most("cycle of 1000 smooth moves, all different", &found, ("one move", 220.0));
    let hard = questions::read(&swings()).expect("a thousand swings are valid");
    let code = questions::read_code("CHA-25A-100-H-C1024", quantities::Language::En).expect("a code").parsed.code;
    let numbers = || sort(2_000_000);
    let ranked = against(3, numbers, || {
        black_box(size(black_box(&hard)));
    });
    gates.at_most("rank for a thousand different swings of an arm", &ranked, ("sorting two million numbers", 10.0));
    let checked = against(3, numbers, || {
        let candidate = check(&hard, &code).expect("the code is in the catalogue");
        black_box(reserve_of(&hard, &candidate));
    });
    gates.at_most("  check of one code, with its reserves", &checked, ("sorting two million numbers", 100.0));
    gates.close()
}
