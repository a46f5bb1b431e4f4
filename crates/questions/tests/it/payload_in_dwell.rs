//! A dwell that states no payload behind a move with one carries nothing, which is listed as assumed.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use axis::Assumption;
use quantities::{Measure, MomentOfInertia};

fn project(single: bool, dwells: [&str; 2], payload: &str) -> axis::AxisProject {
    let [first, last] = dwells;
    let text = format!(
        "format = 1\n[axis]\nsingle_move = {single}\n[mechanism.hoist]\ndrum_diameter = \"80 mm\"\nmass = \"12 kg\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"800 mm\"\ntime = \"4 s\"\n{payload}\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"5 s\"\n{first}\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-800 mm\"\ntime = \"4 s\"\n{payload}\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"5 s\"\n{last}\n"
    );
    questions::read(&text).unwrap()
}

#[test]
fn a_dwell_without_payload_is_assumed() {
    let (carried, nothing) = ("payload = \"60 kg\"", "payload = \"0 kg\"");
    let is_listed = |project: &axis::AxisProject| project.assumptions.contains(&Assumption::NoPayloadInDwell);
    for single in [false, true] {
        for (dwells, payload, expected) in [
            (["", ""], carried, true),
            ([carried, ""], carried, true),
            (["", carried], carried, true),
            ([carried, carried], carried, false),
            ([nothing, nothing], carried, false),
            (["", ""], "", false),
        ] {
            let found = project(single, dwells, payload);
            assert_eq!(is_listed(&found), expected, "{single} {dwells:?} {payload}");
        }
    }
    let torque = |dwells| project(false, dwells, carried).axis.demand(MomentOfInertia::from_si(0.1)).torque_rms.si();
    assert!(torque([carried, carried]) > 1.05 * torque(["", ""]));
}
