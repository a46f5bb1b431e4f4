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

#[test]
fn a_change_of_another_axis_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(here.join("two.toml"), TWO_AXES).unwrap();
    let all = project::written(TWO_AXES).unwrap();
    let mut tried = 0;
    for (own, other, prefix) in [("swivel", "lift", "axis[2]."), ("lift", "swivel", "axis[1].")] {
        for key in all.iter().filter(|key| key.path.starts_with(prefix)) {
            let Some(value) = key.value.as_deref().filter(|value| value.contains(' ') && !value.contains("box")) else {
                continue;
            };
            // Twice the value, so that there is a change.
            let refused = call(here, &format!("antrieb size two.toml --axis {own} --scale {}=2", key.path));
            assert!(refused.code == 2 && refused.err.contains(other), "{} {value}\n{}", key.path, refused.err);
            let plain = call(here, &format!("antrieb size two.toml --axis {other} --scale {}=1.01 --json", key.path));
            assert!(plain.code < 2 || plain.err.contains("cycle"), "{}\n{}", key.path, plain.err);
            tried += 1;
        }
    }
    assert!(tried > 12, "{tried}");
}

#[test]
fn what_one_factor_has_multiplied_another_one_does_not() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    assert_eq!(call(here, "antrieb new hoist --out axis.toml").code, 0);
    let refused = call(here, "antrieb size axis.toml --scale load=1.15 --scale mechanism.hoist.mass=1.15");
    assert!(refused.code == 2 && refused.err.contains("mechanism.hoist.mass"), "{}", refused.err);
    // A factor of a value that the call states is one of that value.
    let both = call(here, "antrieb size axis.toml --set mass=50kg --scale load=1.2 --json");
    let plain = call(here, "antrieb size axis.toml --set mass=60kg --json");
    assert!(both.code < 2 && both.out == plain.out, "{}{}", both.err, plain.err);
}

#[test]
fn a_comma_with_three_digits_is_asked() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    assert_eq!(call(here, "antrieb new hoist --out axis.toml").code, 0);
    for written in ["0,500", "1,500", "12,125", "1,5", "0,05"] {
        let refused = call(here, &format!("antrieb sweep axis.toml --vary mass={written}kg"));
        let calls = named(&refused.err);
        assert!(refused.code == 2 && calls.len() == 2, "{written}\n{}", refused.err);
    }
    for written in ["10,20", "100,200", "0,90", "10,20,30"] {
        let swept = call(here, &format!("antrieb sweep axis.toml --vary mass={written}kg"));
        assert!(swept.code < 2 || !swept.err.contains("decimal"), "{written}\n{}", swept.err);
    }
}

#[test]
fn a_word_for_what_is_meant_leads_to_an_answer() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    assert_eq!(call(here, "antrieb new arm --out arm.toml").code, 0);
    // Understood as they are.
    for words in [
        "explain arm.toml T_rms",
        "explain arm.toml temperature",
        "why not CHA-14A-50-N-D2048-B arm.toml",
        "power failure arm.toml",
        "stromausfall arm.toml",
        "sweep arm.toml --set ambient=20..30degC --steps 2",
        "diff arm.toml mass=60kg",
    ] {
        let answered = call(here, &format!("antrieb {words}"));
        assert!(answered.code < 2, "{words}\n{}", answered.err);
    }
    // Refused with a call that works.
    for words in ["size arm.toml --set gear=2", "size arm.toml --set ratio=2", "map arm.toml payload time"] {
        let refused = call(here, &format!("antrieb {words}"));
        let calls = named(&refused.err);
        assert!(refused.code == 2 && !calls.is_empty(), "{words}\n{}", refused.err);
        assert!(calls.iter().all(|meant| call(here, meant).code < 2), "{words}\n{}", refused.err);
    }
    let pins = call(here, "antrieb wiring CHA-25A-100-H-C1024 sinamics");
    let calls = named(&pins.err);
    let of_both = ["antrieb wiring", "antrieb commission"];
    assert!(of_both.iter().all(|begin| calls.iter().any(|meant| meant.starts_with(begin))), "{}", pins.err);
    // A code is never dropped.
    let refused = call(here, "antrieb check arm.toml ...-25A-100-H-C1024");
    assert!(
        refused.code == 2 && !named(&refused.err).iter().any(|meant| meant.ends_with("arm.toml")),
        "{}",
        refused.err
    );
}

#[test]
fn a_stated_figure_is_no_figure_of_the_template() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let of_template = |file: &str| -> Vec<String> {
        let record: Value = serde_json::from_str(&call(here, &format!("antrieb size {file} --json")).out).unwrap();
        let all = record["assumptions"].as_array().unwrap().clone();
        let own = all.into_iter().filter(|each| each["why"].as_str().is_some_and(|why| why.contains("template")));
        own.filter_map(|each| each["key"].as_str().map(str::to_owned)).collect()
    };
    let mut tried = 0;
    for (table, _) in LOADS {
        let kind = table.rsplit('.').next().unwrap();
        if ["joint", "table", "load"].contains(&kind) {
            continue;
        }
        assert_eq!(call(here, &format!("antrieb new {kind} --out {kind}.toml --force")).code, 0);
        let text = std::fs::read_to_string(here.join(format!("{kind}.toml"))).unwrap();
        let figures = of_template(&format!("{kind}.toml"));
        for path in figures.iter().take(2) {
            let all = project::written(&text).unwrap();
            let value = all.iter().find(|each| each.path == *path).and_then(|each| each.value.clone()).unwrap();
            assert_eq!(
                call(here, &format!("antrieb new {kind} --set \"{path}={value}\" --out own.toml --force")).code,
                0
            );
            let left = of_template("own.toml");
            tried += 1;
            assert!(!left.contains(path), "{kind} {path} = {value}: {left:?}");
        }
    }
    assert!(tried > 12, "{tried}");
}
