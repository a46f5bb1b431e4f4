//! The report as PDF, by the release binary: process start, judging, pictures, typesetting, file.
//!
//! Baseline: `size` on the same project, which does all but pictures and typesetting.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, binary, process};
use std::process::ExitCode;
use std::time::Duration;

fn main() -> ExitCode {
    let binary = binary().expect("the release binary is built");
    let mut gates = Gates::default();
    let file = std::env::temp_dir().join(format!("antrieb-bench-{}.pdf", std::process::id()));
    let out = file.to_str().expect("a folder with a name");
    for example in ["indexing-table", "tilting-arm", "robot-joint"] {
        let project = &format!("examples/{example}.toml");
        let baseline = ("size", process(&binary, 3, &["size", project]));
        let pdf = process(&binary, 3, &["report", project, "--force", "--date", "2026-11-21", "--out", out]);
        let bytes = std::fs::metadata(&file).map_or(0, |found| found.len());
        let _ = std::fs::remove_file(&file);
        gates.hold(&format!("report of {example} as PDF"), pdf, Duration::from_millis(PROMISED_MS), baseline);
        println!("  {} kB, promised 2000 at most", bytes / 1000);
        assert!((1..=2_000_000).contains(&bytes), "{bytes} bytes");
    }
    gates.close()
}

/// From start to file; the typesetting takes most of it.
const PROMISED_MS: u64 = 300;
