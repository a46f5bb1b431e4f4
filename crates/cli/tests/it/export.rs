//! `export`, `compare` and `diff` as a script uses them.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use run::{root, run, run_with};
use serde_json::Value;
use std::path::Path;

const TABLES: [&str; 7] = ["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"];
const PROJECT: &str = "examples/indexing-table.toml";

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

#[test]
fn a_workbook_is_written_once_and_replaced_only_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let out = path(folder.path(), "result.xlsx");
    let first = run(&["export", PROJECT, "--out", &out]);
    assert_eq!((first.code, first.err.as_str()), (0, ""));
    assert!(first.out.contains("CHA-32A-50-H-C1024: fits") && first.out.contains("candidates 20"), "{}", first.out);
    let bytes = std::fs::read(&out).unwrap();
    let again = run(&["export", PROJECT, "--out", &out]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("--force"), "{}", again.err);
    let other = run(&["export", PROJECT, "--out", &out, "--force", "--top", "1", "--json"]);
    let record: Value = serde_json::from_str(&other.out).unwrap();
    assert_eq!((&record["verdict"], record["tables"].as_array().unwrap().len()), (&"fits".into(), 7));
    assert_ne!(std::fs::read(&out).unwrap(), bytes);
    run(&["export", PROJECT, "--out", &out, "--force"]);
    assert_eq!(std::fs::read(&out).unwrap(), bytes, "the same call gives the same bytes");
    assert_eq!(names(folder.path()), ["result.xlsx"], "nothing else is left");
}

#[test]
fn one_table_goes_into_every_format_and_to_standard_output() {
    let folder = tempfile::tempdir().unwrap();
    for table in TABLES {
        for ending in ["csv", "json", "parquet", "xlsx"] {
            let out = path(folder.path(), &format!("{table}.{ending}"));
            let run = run(&["export", PROJECT, "--table", table, "--out", &out, "--top", "2"]);
            assert_eq!((run.code, run.err.as_str()), (0, ""), "{out}");
        }
        let csv = std::fs::read_to_string(folder.path().join(format!("{table}.csv"))).unwrap();
        assert_eq!(run(&["export", PROJECT, "--table", table, "--top", "2"]).out, csv);
        assert_eq!(run(&["export", PROJECT, "--table", table, "--top", "2", "--out", "-"]).out, csv);
        let json = std::fs::read_to_string(folder.path().join(format!("{table}.json"))).unwrap();
        assert_eq!(run(&["export", PROJECT, "--table", table, "--top", "2", "--json"]).out, json);
        let rows = serde_json::from_str::<Value>(&json).unwrap()["rows"].as_array().unwrap().len();
        assert!(rows > 0 && csv.lines().count() > rows, "{table}");
    }
    assert_eq!(names(folder.path()).len(), 28);
}

#[test]
fn a_fault_writes_nothing_and_says_what_helps() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| path(folder.path(), name);
    std::fs::create_dir(folder.path().join("x.xlsx")).unwrap();
    for (arguments, wanted) in [
        (vec!["--table", "check", "--out", &at("a.csv")], "did you mean `checks`?"),
        (vec!["--table", "prices", "--out", &at("a.csv")], "valid here: inputs, assumptions"),
        (vec!["--out", &at("a.csv")], "--table"),
        (vec!["--out", &at("a.ods")], ".parquet"),
        (vec!["--out", &at("a")], ".parquet"),
        (vec!["--out", &at("none/a.xlsx")], "there is no such folder"),
        (vec!["--out", &at("x.xlsx"), "--force"], "this is a folder"),
        (vec!["--out", &at("a.xlsx"), "--code", "CHA-32A-51-H-C1024"], "nearest valid ordering codes"),
        (vec!["--out", &at("a.xlsx"), "--axis", "lift"], "has no axis"),
        (vec!["--out", &at("a.xlsx"), "--top", "0"], "--top"),
    ] {
        let arguments: Vec<&str> = [vec!["export", PROJECT], arguments].concat();
        let run = run(&arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(run.err.contains(wanted), "{arguments:?}: {}", run.err);
    }
    let missing = run(&["export", "examples/none.toml", "--out", &at("a.xlsx")]);
    assert_eq!(missing.code, 2);
    assert_eq!(names(folder.path()), ["x.xlsx"]);
}

/// A workbook has every axis, of one project or of several; a table and a code belong to one axis.
#[test]
fn of_two_axes_a_workbook_has_both_and_a_table_one() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| path(folder.path(), name);
    let out = at("both.xlsx");
    let both = run(&["export", "examples/two-axes.toml", "--out", &out]);
    assert!(both.code < 2 && both.out.contains("swivel: ") && both.out.contains("lift: "), "{}{}", both.out, both.err);
    let again = run(&["export", "examples/two-axes.toml", "--out", &out]);
    assert_eq!(again.code, 2, "an existing file is kept");
    let json = run(&["export", PROJECT, "examples/tilting-arm.toml", "--out", &at("two.xlsx"), "--json"]);
    let json: Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!((json["axes"].as_array().unwrap().len(), &json["code"]), (2, &Value::Null));
    assert!(json["axes"][1]["tables"].as_array().unwrap().len() == 7 && json["axes"][0]["axis"] != "", "{json}");
    let codes = run(&["export", "examples/two-axes.toml", "--code", "CHA-25A-100-H-C1024", "--out", &at("c.xlsx")]);
    assert!(codes.code == 2 && codes.err.contains("--axis lift"), "{}", codes.err);
    for call in [&["examples/two-axes.toml"][..], &[PROJECT, "examples/tilting-arm.toml"]] {
        let table = run(&[&["export"], call, &["--table", "checks", "--out", &at("t.csv")]].concat());
        assert!(table.code == 2 && table.err.contains(".xlsx"), "{}", table.err);
    }
    assert_eq!(names(folder.path()), ["both.xlsx", "two.xlsx"]);
    let out = at("lift.xlsx");
    assert_eq!(run(&["export", "examples/two-axes.toml", "--axis", "lift", "--out", &out]).code, 0);
    let inputs = run(&["export", "examples/two-axes.toml", "--axis", "lift", "--table", "inputs"]).out;
    assert!(inputs.contains("axis[2].mechanism.belt.mass") && !inputs.contains("axis[1]"), "{inputs}");
}

#[test]
fn the_verdict_of_the_chosen_one_is_the_exit_code() {
    let misfit = run(&["export", PROJECT, "--code", "CHA-25A-100-H-C1024", "--table", "checks", "--top", "1"]);
    assert_eq!(misfit.code, 1);
    let second = misfit.out.lines().nth(1).unwrap();
    assert!(second.starts_with("CHA-25A-100-H-C1024,"), "the code asked for stands first: {second}");
    let own = run(&["export", "examples/manual-example.toml", "--table", "checks", "--top", "1"]);
    assert!(own.out.lines().nth(1).unwrap().starts_with("CanisDrive-25A-50,"));
}

#[test]
fn a_comparison_in_json_marks_the_better_one() {
    let codes = ["--code", "CHA-32A-50-H-C1024", "--code", "CHA-25A-50-H-C1024"];
    let answer = run(&[&["compare", PROJECT, "--json"][..], &codes].concat());
    assert_eq!(answer.code, 0, "one of them fits");
    let value: Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!((&value["better"], value["candidates"].as_array().unwrap().len()), (&0.into(), 2));
    let find = |list: &str, key: &str, name: &str| {
        value[list].as_array().unwrap().iter().find(|each| each[key] == name).unwrap().clone()
    };
    assert_eq!(find("checks", "id", "peak_torque")["better"], 0);
    assert_eq!(find("checks", "id", "peak_speed")["better"], 1);
    assert_eq!(find("checks", "id", "mean_speed")["better"], Value::Null, "both are the same");
    assert_eq!(find("data", "symbol", "m")["values"], serde_json::json!([6.6, 4.9]));
    for check in value["checks"].as_array().unwrap() {
        assert_eq!(check["answers"].as_array().unwrap().len(), 2);
    }
    let misfit = ["--code", "CHA-25A-100-H-C1024", "--code", "CHA-25A-80-H-C1024"];
    assert_eq!(run(&[&["compare", PROJECT][..], &misfit].concat()).code, 1);
    assert_eq!(run(&["compare", PROJECT, "--code", "CHA-25A-50-H-C1024"]).code, 2, "one is no comparison");
    assert_eq!(
        run(&["compare", "examples/two-axes.toml", "--code", "CHA-14A-50-N-D2048-B", "--code", "CHA-17A-50-H-M128S"])
            .code,
        0
    );
}

#[test]
fn a_difference_in_json_tells_inputs_demand_and_checks() {
    let old = std::fs::read_to_string(root().join(PROJECT)).unwrap();
    let heavier = old.replace("1.3 kg m^2", "4.5 kg m^2").replace("accelerate = \"0.1 s\"", "accelerate = \"100 ms\"");
    let code = "CHA-32A-50-H-C1024";
    let answer = run_with(&["diff", PROJECT, "-", "--code", code, "--json"], heavier.as_bytes());
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    let value: Value = serde_json::from_str(&answer.out).unwrap();
    let inputs = value["inputs"].as_array().unwrap();
    assert_eq!(inputs.len(), 1, "another spelling is no change: {inputs:?}");
    assert_eq!(inputs[0]["path"], "load.inertia");
    assert_eq!((&value["before"]["verdict"], &value["after"]["verdict"]), (&"fits".into(), &"does_not_fit".into()));
    let checks = value["checks"].as_array().unwrap();
    assert_eq!(checks[0]["after"]["verdict"], "fail", "what fails now stands first");
    assert_eq!(checks[0]["before"]["verdict"], "pass");
    let by = checks[0]["change"].as_f64().unwrap();
    let each = |when: &str| checks[0][when]["utilisation"].as_f64().unwrap();
    assert!((each("after") - each("before") - by).abs() < 1e-9);
    assert_ne!(value["best_before"], value["best_after"]);

    let same = run(&["diff", PROJECT, PROJECT]);
    assert_eq!(same.code, 0);
    assert!(same.out.contains("no input changed") && same.out.contains("demand unchanged"), "{}", same.out);
    let broken = run_with(&["diff", PROJECT, "-"], b"format = 1\n");
    assert_eq!((broken.code, broken.out.as_str()), (2, ""));
}

#[test]
fn axes_are_compared_with_those_of_the_same_name() {
    let old = std::fs::read_to_string(root().join("examples/two-axes.toml")).unwrap();
    let new = old.replace("name = \"swivel\"", "name = \"turn\"").replace("mass = \"9 kg\"", "mass = \"10 kg\"");
    let answer = run_with(&["diff", "examples/two-axes.toml", "-", "--json"], new.as_bytes());
    assert!(answer.err.contains("axis \"swivel\" is only in examples/two-axes.toml"), "{}", answer.err);
    assert!(answer.err.contains("axis \"turn\" is only in stdin"), "{}", answer.err);
    let value: Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!(value["axis"], "lift");
    assert_eq!(value["inputs"], serde_json::json!([{ "path": "mechanism.belt.mass", "old": "9 kg", "new": "10 kg" }]));
    let none = run_with(&["diff", "examples/two-axes.toml", "-"], old.replace("name = \"", "name = \"x").as_bytes());
    assert_eq!(none.code, 2);
}

/// A run that was written as Parquet is identified as the one that was written as CSV, whose numbers are shorter.
#[test]
fn a_run_is_identified_from_either_format() {
    let folder = tempfile::tempdir().unwrap();
    let code = "CHA-25A-50-H-C1024";
    let estimates = |ending: &str| {
        let out = path(folder.path(), &format!("run.{ending}"));
        let wrote = run(&["simulate", PROJECT, "--code", code, "--out", &out, "--cold"]);
        assert!(wrote.code <= 1, "{}", wrote.err);
        let found = run(&["identify", &out, PROJECT, "--code", code, "--json"]);
        assert_eq!(found.code, 0, "{}", found.err);
        serde_json::from_str::<Value>(&found.out).unwrap()["estimates"].as_array().unwrap().clone()
    };
    let (csv, parquet) = (estimates("csv"), estimates("parquet"));
    assert!(csv.len() == parquet.len() && csv.len() >= 2, "{csv:?}");
    for (one, other) in csv.iter().zip(&parquet) {
        let [value, again] = [&one["value"], &other["value"]].map(|n| n.as_f64().unwrap());
        assert!((value - again).abs() <= 1e-9 + 1e-6 * value.abs(), "{one} {other}");
    }
}
