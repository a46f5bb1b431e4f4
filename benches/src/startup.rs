//! Time from start to answer of the release binary, as a user runs it.
//!
//! Baseline: the same binary with `--version`, which only starts.
#![allow(clippy::expect_used, reason = "a bench fails loudly")]

use benches::{Gates, against, binary, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    let binary = binary().expect("the release binary is built");
    let mut gates = Gates::default();
    let start = || run(&binary, &["--version"]);
    let parse = against(41, start, || run(&binary, &["code", "parse", "CHA-20A-100-H-C1024-B"]));
    gates.at_most("code parse", &parse, ("starting", 3.0));
    let size = against(41, start, || run(&binary, &["size", "examples/indexing-table.toml"]));
    gates.at_most("size on the example", &size, ("starting", 20.0));
    gates.close()
}
