//! The corpora and what was once a crash, without the engine.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "a test fails loudly")]

use fuzz::{TARGETS, Target};
use std::path::{Path, PathBuf};

/// All corpora together: what is in the tree is read by everyone who clones it.
const BYTES_MAX: u64 = 2 << 20;

fn cases(of: &str, target: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join(target);
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

fn replay(target: &Target, files: &[PathBuf]) {
    for file in files {
        println!("{}", file.display());
        (target.run)(&std::fs::read(file).unwrap());
    }
}

#[test]
fn what_was_once_hard_is_no_longer() {
    let mut count = 0;
    for target in TARGETS {
        let files = cases("crashes", target.name);
        count += files.len();
        replay(&target, &files);
    }
    assert!(count > 40, "{count}");
}

#[test]
fn the_corpora_keep_the_promises() {
    for target in TARGETS {
        let files = cases("corpus", target.name);
        assert!(!files.is_empty(), "no corpus of {}", target.name);
        // Not optimised, sizing takes a second: here a part, all of it in the step `fuzz` of CI.
        let part = match target.name {
            "axis" => 8,
            "request" => 24,
            _ => 150,
        };
        let step = files.len().div_ceil(part).max(1);
        let part: Vec<PathBuf> = files.into_iter().step_by(step).collect();
        replay(&target, &part);
    }
}

#[test]
fn the_corpora_stay_small() {
    let sizes = TARGETS.iter().flat_map(|target| cases("corpus", target.name));
    let bytes: u64 = sizes.map(|file| file.metadata().unwrap().len()).sum();
    assert!(bytes <= BYTES_MAX, "{bytes} bytes, at most {BYTES_MAX}: `cargo xtask fuzz` merges them");
}
