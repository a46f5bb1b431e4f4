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
    let commands = ["data", "wiring", "curve", "encoder", "mount", "commission", "upkeep", "torsion"];
    for command in commands {
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

#[test]
fn a_battery_is_that_of_an_encoder_which_has_one() {
    let folder = tempfile::tempdir().unwrap();
    for (word, count) in [("CHA-17A", 3), ("CHA-17A-100-*", 3), ("CHA-25A", 0), ("CHA-25A-100-H-RES", 0)] {
        let refused = call(folder.path(), &format!("antrieb battery {word}"));
        let calls = named(&refused.err);
        let of_battery = calls.iter().filter(|call| call.starts_with("antrieb battery"));
        assert!(refused.code == 2 && of_battery.count() == count, "{word}\n{}", refused.err);
        for meant in &calls {
            assert_eq!(call(folder.path(), meant).code, 0, "{meant}");
        }
    }
}

/// Project of two axes that differ in load and motion.
const TWO_AXES: &str = include_str!("../../../../examples/two-axes.toml");

#[test]
fn a_question_about_one_axis_names_the_call_for_each() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(here.join("two.toml"), TWO_AXES).unwrap();
    let with_words = |command: &str| match command {
        "plot" => "--figure cycle".to_owned(),
        "sweep" => "--vary ambient=20..30degC".to_owned(),
        "export" => "--table checks".to_owned(),
        "torsion" => "--torque 10Nm".to_owned(),
        _ => String::new(),
    };
    let of_code = ["data", "wiring", "curve", "encoder", "mount", "commission", "upkeep", "torsion"];
    let of_project = ["export", "moves", "plot", "sweep"];
    for command in of_code.into_iter().chain(of_project) {
        let words = with_words(command);
        let refused = call(here, &format!("antrieb {command} two.toml {words}"));
        let calls = named(&refused.err);
        assert!(refused.code == 2 && calls.len() == 2, "{command}\n{}", refused.err);
        for (axis, meant) in ["swivel", "lift"].iter().zip(&calls) {
            assert!(meant.contains(&format!("--axis {axis}")), "{meant}");
            assert!(call(here, meant).code < 2, "{meant}\n{}", call(here, meant).err);
        }
    }
}

#[test]
fn a_factor_of_some_axes_alone_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    // The second axis states its torque, which no factor of a load changes.
    let torque = "[[axis]]\nname = \"press\"\n[axis.requirements]\nsupply = \"560 V\"\n[axis.mechanism.table]\npoints = [[\"0 deg\", \"1.3 kg m^2\", \"5 N m\"], [\"90 deg\", \"1.6 kg m^2\", \"8 N m\"]]\n[[axis.motion]]\nlaw = \"modified_sine\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[[axis.motion]]\nlaw = \"modified_sine\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n";
    std::fs::write(here.join("three.toml"), format!("{TWO_AXES}\n{torque}")).unwrap();
    assert!(call(here, "antrieb size three.toml").code < 2, "{}", call(here, "antrieb size three.toml").err);
    let refused = call(here, "antrieb size three.toml --scale load=1.2");
    assert!(refused.code == 2 && refused.err.contains("press"), "{}", refused.err);
    assert!(refused.err.contains("swivel, lift"), "{}", refused.err);
    assert!(call(here, "antrieb size three.toml --axis lift --scale load=1.2").code < 2);
    assert!(call(here, "antrieb size three.toml --scale time=1.2").code < 2);
}

#[test]
fn a_factor_of_a_key_is_its_percentage() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(here.join("two.toml"), TWO_AXES).unwrap();
    for (factor, percentage) in [("1.15", "+15%"), ("0.8", "-20%"), ("x2", "+100%"), ("1.033", "+3.3%")] {
        for key in ["axis[2].mechanism.belt.mass", "axis[2].motion[1].payload", "axis[2].requirements.supply"] {
            let scaled = call(here, &format!("antrieb size two.toml --scale {key}={factor} --json"));
            let set = call(here, &format!("antrieb size two.toml --set {key}={percentage} --json"));
            assert!(scaled.code < 2 && scaled.out == set.out, "{key} {factor}\n{}{}", scaled.err, set.err);
        }
    }
}

#[test]
fn a_project_with_changes_is_compared_with_itself() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for (table, _) in LOADS {
        let kind = table.rsplit('.').next().unwrap();
        if ["joint", "table", "load"].contains(&kind) {
            continue;
        }
        assert_eq!(call(here, &format!("antrieb new {kind} --out {kind}.toml")).code, 0);
        let changed = call(here, &format!("antrieb diff {kind}.toml --set ambient=31degC --json"));
        assert!(changed.code < 2, "{kind} {}", changed.err);
        let record: Value = serde_json::from_str(&changed.out).unwrap();
        let inputs = record["inputs"].as_array().unwrap();
        assert!(inputs.len() == 1 && inputs[0]["new"].as_str().unwrap().starts_with("31"), "{kind} {inputs:?}");
    }
    // Without a change there is nothing to compare with.
    assert_eq!(call(here, "antrieb diff arm.toml").code, 2);
}
