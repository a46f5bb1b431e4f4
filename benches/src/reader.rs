//! The CSV reader alone: a million rows of time and position, 20 MB.
//!
//! Baseline: `numpy.loadtxt` of the same file if NumPy is installed, else one pass over every byte.
#![allow(clippy::expect_used, clippy::print_stdout, reason = "a bench fails loudly and prints what it measured")]

use benches::{Against, Gates, loadtxt, timed};
use quantities::unit::{RADIAN, SECOND};
use recording::{ColumnSpec, Layout, read_csv};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::ExitCode;

const ROWS: usize = 1_000_000;
const ROUNDS: usize = 7;

fn text() -> String {
    let mut text = String::from("time,position\n");
    for k in 0..ROWS {
        let position = 0.75 * (1.0 - (10.0 * TAU * k as f64 / ROWS as f64).cos());
        writeln!(text, "{:.3},{position:.9}", k as f64 * 1e-3).expect("a string takes all");
    }
    text
}

/// Counts the bytes that begin a line or a cell: the minimum work of a reader.
fn scanned(text: &[u8]) -> usize {
    let mut ends = 0;
    for byte in text {
        ends += usize::from(matches!(black_box(*byte), b'\n' | b','));
    }
    ends
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let text = text();
    let column = |unit| ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
    let layout = Layout { time: column(&SECOND), position: column(&RADIAN), ..Layout::default() };
    let read = || timed(|| drop(black_box(read_csv(text.as_bytes(), &layout).expect("the file is sound"))));
    let file = std::env::temp_dir().join(format!("antrieb-reader-{}.csv", std::process::id()));
    std::fs::write(&file, &text).expect("the recording is written");
    let name = file.to_str().expect("a folder with a name");
    let pairs: Vec<_> = (0..ROUNDS).filter_map(|_| Some((read(), loadtxt(name)?))).collect();
    let _ = std::fs::remove_file(&file);
    let found = if pairs.is_empty() {
        println!("  no Python with NumPy here: the ratio to a scan of the bytes is measured");
        let scan = || {
            timed(|| {
                black_box(scanned(text.as_bytes()));
            })
        };
        let found = Against::of(&(0..ROUNDS).map(|_| (read(), scan())).collect::<Vec<_>>());
        gates.at_most("reading a million rows", &found, ("a scan of their bytes", 6.0));
        found
    } else {
        let found = Against::of(&pairs);
        gates.at_most("reading a million rows", &found, ("numpy.loadtxt of the same file", 1.0));
        found
    };
    println!("  {:.0} MB/s", text.len() as f64 / found.measured.least.as_secs_f64() / 1e6);
    gates.close()
}
