//! From start to answer: the release binary as a user runs it.
//!
//! Baseline: the same binary with `--version`, which starts and does nothing.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, Times, binary, measure, root};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;

fn time(binary: &Path, arguments: &[&str]) -> Times {
    measure(21, || {
        let status = Command::new(binary)
            .args(arguments)
            .current_dir(root())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status();
        assert!(status.is_ok_and(|status| status.success()), "{arguments:?} failed");
    })
}

fn main() -> ExitCode {
    let binary = binary().expect("the release binary is built");
    let mut gates = Gates::default();
    let baseline = ("antrieb --version", time(&binary, &["--version"]));
    let parse = time(&binary, &["code", "parse", "CHA-20A-100-H-C1024-B"]);
    gates.hold("code parse", parse, Duration::from_millis(10), baseline);
    let size = time(&binary, &["size", "examples/indexing-table.toml"]);
    gates.hold("size on the example", size, Duration::from_millis(30), baseline);
    gates.close()
}
