//! What the page of the limits says of the instants of a move is what the code takes.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use mechanism::Mechanism;
use motion::{Closing, Motion};
use project::SegmentLaw;
use quantities::{Measure, MomentOfInertia, Torque};
use sizing::Axis;

/// One move by each law, under an inertia with Coulomb friction.
#[test]
fn the_page_names_the_instants_of_every_law() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/limits.md")).unwrap();
    let mut listed = Vec::new();
    for law in SegmentLaw::all().filter(|law| *law != SegmentLaw::Dwell) {
        let Some(spec) = law.sample() else { continue };
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(1.0));
        let motion = Motion::new(&[spec], None, Closing::SingleMove).unwrap();
        listed.push(format!("`{}` {}", law.id(), Axis::new(load, motion, Vec::new()).instants()));
    }
    let sentence = listed.join(", ");
    assert!(page.contains(&sentence), "{sentence}");
}
