//! From start to answer: the release binary as a user runs it.
//!
//! Baseline: the same binary with `--version`, which starts and does nothing.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, binary, process};
use std::process::ExitCode;
use std::time::Duration;

fn main() -> ExitCode {
    let binary = binary().expect("the release binary is built");
    let mut gates = Gates::default();
    let baseline = ("antrieb --version", process(&binary, 21, &["--version"]));
    let parse = process(&binary, 21, &["code", "parse", "CHA-20A-100-H-C1024-B"]);
    gates.hold("code parse", parse, Duration::from_millis(10), baseline);
    let size = process(&binary, 21, &["size", "examples/indexing-table.toml"]);
    gates.hold("size on the example", size, Duration::from_millis(30), baseline);
    gates.close()
}
