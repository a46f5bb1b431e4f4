//! Many axes against the whole catalogue: rows of one move each with inertia, friction, time and distance of their own.
//!
//! Baseline: the NumPy script with vectors over the catalogue, which makes no checks of instants, heat and energy.
#![allow(
    clippy::print_stdout,
    clippy::expect_used,
    clippy::panic,
    reason = "a bench fails loudly and prints what it measured"
)]

use benches::{Gates, against, numpy, sort};
use project::NoFiles;
use questions::Patience;
use questions::sweep::{Cells, Judged, Options, Sweep};
use std::hint::black_box;
use std::process::ExitCode;

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

const HEADINGS: [&str; 4] =
    ["load.inertia [kg m^2]", "load.friction_torque [N m]", "motion[0].time [s]", "motion[0].distance [deg]"];

/// From and to of each column; the inertia in equal ratios.
type Ranges = [(f64, f64); 4];

/// Some two thirds of the catalogue fit on average.
const MIXED: Ranges = [(0.05, 5.0), (0.0, 20.0), (0.3, 2.0), (20.0, 180.0)];

/// Nothing is rejected: every check of every actuator counts.
const HARD: Ranges = [(1e-3, 1e-2), (0.0, 0.3), (2.0, 5.0), (10.0, 90.0)];

/// Rows of a measurement, or as many as the variable says.
fn rows() -> usize {
    std::env::var("ROWS").ok().and_then(|rows| rows.parse().ok()).unwrap_or(2_000)
}

#[allow(clippy::cast_precision_loss, reason = "53 bits")]
fn table(ranges: &Ranges, rows: usize) -> Vec<Cells<'static>> {
    let mut state = 7_u64;
    let mut share = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut columns = vec![Vec::with_capacity(rows); ranges.len()];
    for _ in 0..rows {
        for (place, (column, (low, high))) in columns.iter_mut().zip(ranges).enumerate() {
            let share = share();
            column.push(Some(if place == 0 { low * (high / low).powf(share) } else { low + share * (high - low) }));
        }
    }
    columns.into_iter().map(Cells::Numbers).collect()
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let rows = rows();
    let sweep = Sweep::new(("axis.toml", MOVE), Box::new(NoFiles), &HEADINGS, Options::default());
    let sweep = sweep.unwrap_or_else(|why| panic!("the table is valid: {why:?}"));
    let pool = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let (one, two) = (pool(1), pool(2));
    let mut measured = Vec::new();
    for (name, ranges) in [("mixed rows", MIXED), ("rows that reject no actuator", HARD)] {
        let cells = table(&ranges, rows);
        let judge = || sweep.judge(&cells, &Patience::endless()).expect("nothing cancels it");
        let fit = |answer: &questions::sweep::Answer| match answer {
            Ok(Judged::Best(best)) => f64::from(best.fit),
            other => panic!("{other:?}"),
        };
        let fitting: f64 = one.install(judge).iter().map(fit).sum();
        let found = against(
            5,
            || sort(10_000),
            || {
                black_box(one.install(judge));
            },
        );
        let by_two = against(
            5,
            || sort(10_000),
            || {
                black_box(two.install(judge));
            },
        );
        let each = |times: benches::Times| times.least.as_secs_f64() / rows as f64 * 1e6;
        println!("{name}: {:.1} of the catalogue fit on average", fitting / rows as f64);
        println!("  one thread: {:.1} µs a row, {:.0} rows a second", each(found.measured), 1e6 / each(found.measured));
        let gain = each(found.measured) / each(by_two.measured);
        println!("  two threads: {:.1} µs a row, {gain:.2} × as quick", each(by_two.measured));
        let of_row = |time: std::time::Duration| time.div_f64(rows as f64);
        let benches::Times { least, median, most } = found.measured;
        measured.push((name, benches::Times { least: of_row(least), median: of_row(median), most: of_row(most) }));
    }
    match numpy(&[]) {
        Some((time, _)) => measured.iter().for_each(|(name, row)| {
            gates.times_faster(&format!("{name}, against NumPy over the catalogue"), *row, time, 1.5);
        }),
        None => println!("  no Python with NumPy here: the ratio to it is not measured"),
    }
    gates.close()
}
