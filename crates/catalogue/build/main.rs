//! Reads `data/`, holds it to the rules of `data/README.md`, and embeds it as static tables.
//!
//! A file that breaks a rule stops the build, with all faults listed at once.
#![allow(clippy::disallowed_methods, reason = "a build script reads what it embeds, and writes it")]
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a build script speaks to cargo over stdout")]

mod embed;
mod facts;
mod read;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    println!("cargo::rerun-if-changed={}", root.display());
    let mut faults = Vec::new();
    let data = read::read_all(&root, &mut faults);
    let mut text = embed::embed(&data, &mut faults);
    facts::embed(&data.facts, &data.sources, &mut text, &mut faults);
    if !faults.is_empty() {
        for fault in &faults {
            println!("cargo::error={fault}");
        }
        return ExitCode::FAILURE;
    }
    let Some(out) = std::env::var_os("OUT_DIR") else {
        println!("cargo::error=OUT_DIR is not set");
        return ExitCode::FAILURE;
    };
    if let Err(fault) = std::fs::write(PathBuf::from(out).join("data.rs"), text) {
        println!("cargo::error=cannot write the embedded data: {fault}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
