//! Replay of the corpora and of former crashes, without the engine.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "a test fails loudly")]

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use fuzz::{TARGETS, Target};
use std::path::Path;

/// Maximum size of all corpora together, which every clone of the repository contains.
const BYTES_MAX: usize = 2 << 20;

/// Returns the packed cases of a target: one per line, in base64.
fn corpus(target: &Target) -> Vec<Vec<u8>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(format!("{}.txt", target.name));
    let text = std::fs::read_to_string(path).unwrap();
    let cases: Vec<Vec<u8>> = text.lines().map(|line| STANDARD.decode(line).unwrap()).collect();
    assert!(!cases.is_empty() && cases.is_sorted_by(|a, b| a < b), "{}: each case once, sorted", target.name);
    cases
}

/// Number of cases replayed in a push for the targets that size axes: without optimisation a case takes a second. The
/// other targets are replayed completely, and these every night.
fn most(target: &Target) -> usize {
    match target.name {
        "axis" => 16,
        "request" => 60,
        "project" => 300,
        _ => usize::MAX,
    }
}

/// Returns the cases of a corpus, or a number of them, evenly spread.
fn replay(name: &str) {
    let target = TARGETS.iter().find(|target| target.name == name).unwrap();
    let cases = corpus(target);
    for case in cases.iter().step_by(cases.len().div_ceil(most(target))) {
        let held = std::panic::catch_unwind(|| (target.run)(case));
        assert!(held.is_ok(), "{name}: {}", STANDARD.encode(case));
    }
}

#[test]
fn what_was_once_hard_is_no_longer() {
    let mut count = 0;
    for target in TARGETS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("crashes").join(target.name);
        for entry in std::fs::read_dir(folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            println!("{}", path.display());
            (target.run)(&std::fs::read(path).unwrap());
            count += 1;
        }
    }
    assert!(count > 40, "{count}");
}

/// The corpora keep the promises: one test per target, so that they run in parallel.
mod the_corpus_of {
    use super::replay;

    #[test]
    fn code() {
        replay("code");
    }

    #[test]
    fn encoder() {
        replay("encoder");
    }

    #[test]
    fn quantity() {
        replay("quantity");
    }

    #[test]
    fn project() {
        replay("project");
    }

    #[test]
    fn csv() {
        replay("csv");
    }

    #[test]
    fn parquet() {
        replay("parquet");
    }

    #[test]
    fn packed() {
        replay("packed");
    }

    #[test]
    fn run() {
        replay("run");
    }

    #[test]
    fn table() {
        replay("table");
    }

    #[test]
    fn axis() {
        replay("axis");
    }

    #[test]
    fn request() {
        replay("request");
    }
}

#[test]
fn every_corpus_is_replayed() {
    let tests = include_str!("replay.rs");
    for target in TARGETS {
        assert!(tests.contains(&format!("replay(\"{}\")", target.name)), "{}", target.name);
    }
}

#[test]
fn the_corpora_stay_small() {
    let bytes: usize = TARGETS.iter().flat_map(corpus).map(|case| case.len()).sum();
    assert!(bytes <= BYTES_MAX, "{bytes} bytes, at most {BYTES_MAX}: `cargo xtask fuzz` merges them");
}
