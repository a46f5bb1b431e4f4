//! Limits of instants on the page of the limits are those of the code.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use mechanism::Mechanism;
use motion::{Closing, Motion};
use project::SegmentLaw;
use quantities::{Measure, MomentOfInertia, Torque};
use sizing::Axis;

fn page() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/limits.md")).unwrap()
}

/// One move by each law, under an inertia with Coulomb friction.
#[test]
fn the_page_names_the_instants_of_every_law() {
    let page = page();
    let mut listed = Vec::new();
    for law in SegmentLaw::all().filter(|law| *law != SegmentLaw::Dwell) {
        let Some(spec) = axis::law_sample(law) else { continue };
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(1.0));
        let motion = Motion::new(&[spec], None, Closing::SingleMove).unwrap();
        listed.push(format!("`{}` {}", law.id(), Axis::new(load, motion, Vec::new()).instants()));
    }
    let sentence = listed.join(", ");
    assert!(page.contains(&sentence), "{sentence}");
}

#[test]
fn the_page_names_the_longest_cycle_with_another_gearing() {
    let page = page();
    let row = page.lines().find(|line| line.contains("another gearing is proposed")).unwrap();
    let number: String = row.chars().filter(char::is_ascii_digit).collect();
    assert_eq!(number, questions::GEARING_INSTANTS_MOST.to_string());
}
