//! Actuators that a call chooses: for the project as the call changes it, of every mechanism.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::refusals::{call, named};
use project::LOADS;
use serde_json::Value;

/// Values of `--scale` that change the choice.
const CHANGE: &str = "--scale load=2.5";

#[test]
fn a_pattern_and_the_partner_of_a_comparison_are_those_of_the_changed_project() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let (mut tried, mut differing) = (0, 0);
    for (table, _) in LOADS {
        let kind = table.rsplit('.').next().unwrap();
        // A joint reads a recording; a table of torques has no load.
        if ["joint", "table", "load"].contains(&kind) {
            continue;
        }
        assert_eq!(call(here, &format!("antrieb new {kind} --out {kind}.toml")).code, 0);
        let best = |change: &str| -> Option<String> {
            let sized = call(here, &format!("antrieb size {kind}.toml {change} --json"));
            assert!(sized.code < 2, "{kind} {change}: {}", sized.err);
            let record: Value = serde_json::from_str(&sized.out).unwrap();
            (record["verdict"] == "fits").then(|| record["answer"].as_str().unwrap().to_owned())
        };
        let Some(of_change) = best(CHANGE) else { continue };
        tried += 1;
        differing += u32::from(best("") != Some(of_change.clone()));
        for written in [
            format!("check {kind}.toml --code=CHA-* {CHANGE}"),
            format!("check {kind}.toml --code CHA-* --scale load=2.5"),
        ] {
            let checked = call(here, &format!("antrieb {written}"));
            assert!(checked.code == 0 && checked.err.contains(&of_change), "{written}: {of_change}\n{}", checked.err);
        }
        let compared = call(here, &format!("antrieb compare {kind}.toml {CHANGE}"));
        assert!(compared.err.contains(&of_change), "{kind}: {of_change}\n{}", compared.err);
    }
    assert!(tried >= 6 && differing >= 3, "{tried} {differing}");
}

#[test]
fn a_pattern_is_every_actuator_that_it_may_mean() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(call(folder.path(), "antrieb new turntable --out axis.toml").code, 0);
    for command in ["data", "wiring"] {
        for pattern in ["CHA-25A", "CHA-25A-1?0-H-C1024", "CHA-25A-100-H-M*", "CHA-17A-*-M128S"] {
            let refused = call(folder.path(), &format!("antrieb {command} {pattern}"));
            let calls = named(&refused.err);
            assert!(refused.code == 2 && refused.err.contains("stands for"), "{command} {pattern}\n{}", refused.err);
            assert!(!refused.err.contains("did you mean") && calls.len() > 1, "{command} {pattern}\n{}", refused.err);
            for meant in &calls {
                assert!(call(folder.path(), meant).code < 2, "{meant}");
            }
        }
    }
}
