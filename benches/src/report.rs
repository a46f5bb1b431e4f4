//! The report as PDF, by the release binary: process start, judging, pictures, typesetting, file.
//!
//! Baseline: sorting two million numbers, since no other part of antrieb does similar work to the typesetting engine.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{Gates, against, binary, run, sort};
use std::process::ExitCode;

fn main() -> ExitCode {
    let binary = binary().expect("the release binary is built");
    let mut gates = Gates::default();
    let file = std::env::temp_dir().join(format!("antrieb-bench-{}.pdf", std::process::id()));
    let out = file.to_str().expect("a folder with a name");
    for example in ["indexing-table", "tilting-arm", "robot-joint"] {
        let project = &format!("examples/{example}.toml");
        let report = || run(&binary, &["report", project, "--force", "--date", "2026-11-21", "--out", out]);
        let found = against(9, || sort(2_000_000), report);
        let bytes = std::fs::metadata(&file).map_or(0, |found| found.len());
        let _ = std::fs::remove_file(&file);
        gates.at_most(&format!("report of {example} as PDF"), &found, ("sorting two million numbers", 20.0));
        println!("  {} kB, promised 2000 at most", bytes / 1000);
        assert!((1..=2_000_000).contains(&bytes), "{bytes} bytes");
    }
    gates.close()
}
