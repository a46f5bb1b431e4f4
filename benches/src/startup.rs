//! From start to answer: the release binary as a user runs it.
//!
//! Baseline: the same binary with `--version`, which starts and does nothing.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, Times, measure};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;

/// The release binary, built by the same cargo into the target folder that this bench runs from.
fn binary() -> PathBuf {
    let bench = std::env::current_exe().expect("the bench has a path");
    let release = bench.parent().and_then(Path::parent).expect("target/release/deps");
    let target = release.parent().expect("target/release");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--release", "--package", "antrieb", "--target-dir"])
        .arg(target)
        .current_dir(root())
        .status();
    assert!(built.is_ok_and(|status| status.success()), "the release build failed");
    let binary = release.join(format!("antrieb{}", std::env::consts::EXE_SUFFIX));
    assert!(binary.is_file(), "cargo built no {}", binary.display());
    binary
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

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
    let binary = binary();
    let mut gates = Gates::default();
    let baseline = ("antrieb --version", time(&binary, &["--version"]));
    let parse = time(&binary, &["code", "parse", "CHA-20A-100-H-C1024-B"]);
    gates.hold("code parse", parse, Duration::from_millis(10), baseline);
    let size = time(&binary, &["size", "examples/indexing-table.toml"]);
    gates.hold("size on the example", size, Duration::from_millis(30), baseline);
    gates.close()
}
