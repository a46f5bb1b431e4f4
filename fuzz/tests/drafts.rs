//! The generated projects reach the code they are meant for: a generator of refusals only would test nothing.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "a test fails loudly")]

use arbitrary::Unstructured;
use fuzz::{TARGETS, draft, project};

/// Returns bytes without correlation between cases (splitmix64).
fn bytes(case: u64) -> Vec<u8> {
    let mut state = case.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut next = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (mixed ^ (mixed >> 31)).to_le_bytes()
    };
    (0..64).flat_map(|_| next()).collect()
}

#[test]
fn most_drafts_are_valid_and_all_kinds_are_among_them() {
    const CASES: u64 = 400;
    let (mut valid, mut read) = (0, String::new());
    let mut refusals: Vec<String> = Vec::new();
    for case in 0..CASES {
        let bytes = bytes(case);
        let text = draft::project(&mut Unstructured::new(&bytes), true).unwrap();
        match questions::read_all(&text, &::axis::NoFiles) {
            Ok(_) => {
                valid += 1;
                read.push_str(&text);
            }
            Err(faults) => {
                let worded = words::worded(&faults, quantities::Language::En);
                refusals.extend(worded.into_iter().map(|fault| fault.message));
            }
        }
    }
    println!("{valid} of {CASES} are valid");
    assert!(valid * 10 > CASES * 7, "{valid} of {CASES} are valid; refused: {refusals:#?}");
    let kinds = [
        "[load]",
        "turntable",
        "arm",
        "screw",
        "belt",
        "conveyor",
        "slider_crank",
        "mechanism.table",
        "[stage]",
        "ratios",
        "[actuator]",
        "[[curve]]",
        "[[axis]]",
        "±",
        "motion.bearing",
        "overhang",
        "payload",
        "single_move",
    ];
    let laws = [
        "manual",
        "trapezoid",
        "triangle",
        "jerk",
        "polynomial_5",
        "modified_sine",
        "modified_trapezoid",
        "simple_sine",
        "inclined_sine",
        "parabola",
        "constant",
        "dwell",
    ];
    for law in laws {
        assert!(read.contains(&format!("law = \"{law}\"")), "no valid draft with {law}");
    }
    for kind in kinds {
        assert!(read.contains(kind), "no valid draft with {kind}");
    }
}

#[test]
fn every_target_holds_for_some_cases() {
    for target in TARGETS {
        // Sizing is slow in a build without optimisation.
        let cases = if target.name == "axis" { 4 } else { 60 };
        (0..cases).for_each(|case| (target.run)(&bytes(case)));
    }
}

#[test]
fn the_examples_keep_the_promises() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&entry).unwrap();
        if !text.contains("recorded") {
            assert!(project::hold(&text).is_some(), "{}", entry.display());
            count += 1;
        }
    }
    assert!(count > 8);
}

/// Generated projects with `[twin]` are simulated or refused with a reason; some of them run.
#[test]
fn drafts_are_simulated() {
    let code = order_code::parse("CHA-25A-100-H-C1024-B").unwrap().code.into();
    let (mut ran, mut refused) = (0, 0);
    for case in 0..1800 {
        let bytes = bytes(case);
        let text = draft::project(&mut Unstructured::new(&bytes), false).unwrap();
        if !text.contains("[twin]") {
            continue;
        }
        let Ok(projects) = questions::read_all(&text, &::axis::NoFiles) else { continue };
        for project in &projects {
            match fuzz::axis::twin_of(project, &code, quantities::Language::En) {
                Some(Ok(_)) => ran += 1,
                Some(Err(_)) => refused += 1,
                None => {}
            }
        }
    }
    println!("{ran} run, {refused} are refused");
    assert!(ran > 10, "{ran} run, {refused} are refused");
}
