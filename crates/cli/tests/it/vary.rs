//! `sweep --vary`: rows that a call states in place of a table, and the columns beside the answers.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run::{Run, run, run_at};
use serde_json::Value;
use std::fs;
use std::path::Path;

const BELT: &str = "format = 1\n[mechanism.belt]\nmass = \"18 kg\"\npulley_diameter = \"120 mm\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"900 mm\"\ntime = \"1.5 s\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-900 mm\"\n\
    time = \"1.5 s\"\n[requirements]\nambient = \"30 degC\"\n";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("axis.toml"), BELT).unwrap();
    folder
}

fn sweep(folder: &Path, more: &[&str]) -> Run {
    run_at(folder, &[&["sweep", "axis.toml"], more].concat())
}

/// Returns the lines of a file as cells.
fn cells(folder: &Path, file: &str, separator: char) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.join(file)).unwrap();
    text.lines().map(|line| line.split(separator).map(str::to_owned).collect()).collect()
}

/// Stated values have the answers of a table with the same rows, in a file, as JSON and on the terminal.
#[test]
fn stated_values_are_answered_like_a_table() {
    let folder = folder();
    let here = folder.path();
    let rows = "mechanism.belt.mass [kg],motion[1].time [s]\n10,1.2\n10,1.5\n25,1.2\n25,1.5\n";
    fs::write(here.join("tasks.csv"), rows).unwrap();
    let vary = ["--vary", "mass=10;25kg", "--vary", "motion[1].time = 1.2; 1.5 s"];
    assert!(sweep(here, &["--table", "tasks.csv", "--inputs", "table", "--out", "one.csv"]).code < 2);
    let found = sweep(here, &[&vary[..], &["--out", "other.csv"]].concat());
    assert!(found.code < 2, "{}", found.err);
    let (one, other) = (cells(here, "one.csv", ','), cells(here, "other.csv", ','));
    assert_eq!(one, other);
    assert_eq!(one[0][7..], ["mechanism.belt.mass [kg]", "motion[1].time [s]"]);
    assert_eq!(one[3][7..], ["25.0", "1.2"]);
    let json = sweep(here, &[&vary[..], &["--json"]].concat());
    let json: Value = serde_json::from_str(&json.out).unwrap();
    let shown = sweep(here, &vary);
    for (line, answer) in one[1..].iter().zip(json["answers"].as_array().unwrap()) {
        assert_eq!(answer["code"].as_str().unwrap(), line[2]);
        assert!(shown.out.contains(&line[2]), "{}", shown.out);
    }
    assert_eq!(json["answers"][2]["labels"]["mechanism.belt.mass [kg]"], "25");
    assert_eq!(json["rows"], 4);
}

/// A range has as many values as are requested, its ends included.
#[test]
fn a_range_is_divided_into_steps() {
    let folder = folder();
    for (words, expected) in [
        (
            &["mass=10..20kg"][..],
            &["10.0", "11.0", "12.0", "13.0", "14.0", "15.0", "16.0", "17.0", "18.0", "19.0", "20.0"][..],
        ),
        (&["mass=10:20 kg", "--steps", "3"], &["10.0", "15.0", "20.0"]),
        (&["mass=5..20 kg log", "--steps", "3"], &["5.0", "10.0", "20.0"]),
        // A range with its step, by every way to write it.
        (&["mass=10:20:2.5kg"], &["10.0", "12.5", "15.0", "17.5", "20.0"]),
        (&["mass=10kg:20kg:5000g"], &["10.0", "15.0", "20.0"]),
        (&["mass=10kg..20kg:5kg"], &["10.0", "15.0", "20.0"]),
        (&["mass=10-20:5 kg"], &["10.0", "15.0", "20.0"]),
        (&["mass=10..20:5kg"], &["10.0", "15.0", "20.0"]),
        (&["mass=10..20kg", "--step", "5kg"], &["10.0", "15.0", "20.0"]),
        (&["mass=10..20kg", "--step=5"], &["10.0", "15.0", "20.0"]),
        (&["mass=20..10kg", "--step", "2,5kg"], &["20.0", "17.5", "15.0", "12.5", "10.0"]),
        (&["mass=10..10.3kg", "--step", "100g"], &["10.0", "10.1", "10.2", "10.3"]),
        (&["ambient=20..30degC", "--step", "5K"], &["20.0", "25.0", "30.0"]),
    ] {
        let call = [&["--vary"], words, &["--out", "steps.csv", "--force"]].concat();
        let found = sweep(folder.path(), &call);
        assert!(found.code < 2, "{words:?}: {}", found.err);
        let lines = cells(folder.path(), "steps.csv", ',');
        let values: Vec<&str> = lines[1..].iter().map(|line| line[7].as_str()).collect();
        assert_eq!(values, expected, "{words:?}");
    }
}

/// A file with all inputs states every value of the project once, and has the numbers of the one with points.
#[test]
fn inputs_and_decimal_commas_stand_in_the_file() {
    let folder = folder();
    let here = folder.path();
    let vary = ["--vary", "mass=10,25.5kg", "--inputs", "all"];
    assert!(sweep(here, &[&vary[..], &["--out", "points.csv"]].concat()).code < 2);
    assert!(sweep(here, &[&vary[..], &["--out", "commas.csv", "--decimal-comma"]].concat()).code < 2);
    let (points, commas) = (cells(here, "points.csv", ','), cells(here, "commas.csv", ';'));
    let headings = [
        "mechanism.belt.mass [kg]",
        "mechanism.belt.pulley_diameter [mm]",
        "motion[1].law",
        "motion[1].distance [mm]",
        "motion[1].time [s]",
        "motion[2].law",
        "motion[2].distance [mm]",
        "motion[2].time [s]",
        "requirements.ambient [degC]",
    ];
    assert_eq!(points[0][7..], headings);
    assert_eq!(points[1][7..], ["10.0", "120.0", "trapezoid", "900.0", "1.5", "trapezoid", "-900.0", "1.5", "30.0"]);
    assert_eq!(points[0], commas[0]);
    for (one, other) in points[1..].iter().zip(&commas[1..]) {
        assert_eq!(one, &other.iter().map(|cell| cell.replace(',', ".")).collect::<Vec<_>>());
        assert!(other[7].contains(','), "{other:?}");
    }
    let parquet = sweep(here, &["--vary", "mass=10;25kg", "--out", "best.parquet", "--decimal-comma"]);
    assert!(parquet.code == 2 && parquet.err.contains("--decimal-comma"), "{}", parquet.err);
    // A value of the call is one of the project.
    assert!(sweep(here, &[&vary[..], &["--set", "ambient=20 degC", "--out", "set.csv"]].concat()).code < 2);
    assert_eq!(cells(here, "set.csv", ',')[1].last().unwrap(), "20.0");
}

#[test]
fn a_statement_that_is_not_understood_is_refused_with_what_to_write() {
    let folder = folder();
    for (statement, language, parts) in [
        ("mass=10,20", "en", &["no unit", "--vary \"mechanism.belt.mass=10,20 kg\""][..]),
        ("mass=10kg,20g", "en", &["key with values"]),
        ("mass", "en", &["key with values", "payload=0,5,10kg"]),
        ("mass=,", "en", &["key with values"]),
        ("time=1,2,3", "en", &["no unit", "--vary \"time=1,2,3 s\""]),
        ("mas=1kg,2kg", "en", &["mechanism.belt.mass"]),
        ("mass=0,5kg", "de", &["mehrdeutig", "mass=0;5kg", "mass=0.5kg"]),
        ("motion[3].time=1s,2s", "en", &["motion[3]", "no such entry"]),
        ("mass=30:60:7kg", "en", &["steps of 7 kg", "mass=30:60:6kg", "mass=30:60:7.5kg"]),
        ("mass=30:5:60kg", "en", &["mass=30:60:5kg"]),
        ("mass=30:60:5", "en", &["no unit", "mechanism.belt.mass=30:60:5 kg"]),
        ("mass=30:60:0kg", "en", &["above zero"]),
        ("mass=30:60:1s", "en", &["unit"]),
        ("mass=30kg:60kg:1s", "de", &["andere Größe"]),
        ("mass=30:60:5kg log", "de", &["--steps"]),
    ] {
        let found = sweep(folder.path(), &["--vary", statement, "--lang", language]);
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{statement}: {}", found.err);
        for part in parts {
            assert!(found.err.contains(part), "{statement}: {part}\n{}", found.err);
        }
    }
    // In German a list of an odd number of pieces, or with semicolons, is plain.
    for statement in ["masse=10,20,30kg", "masse=10;20,5kg"] {
        let found = sweep(folder.path(), &["--vary", statement, "--lang", "de"]);
        assert!(found.code < 2, "{statement}: {}", found.err);
    }
}

/// A step that no single range takes is refused, and one beside a number of steps.
#[test]
fn a_step_belongs_to_one_range() {
    let folder = folder();
    for (words, part) in [
        (&["--vary", "mass=10,20,30kg", "--step", "5kg"][..], "one range"),
        (&["--vary", "mass=10..20kg", "--vary", "time=1..2s", "--step", "5kg"], "one range"),
        (&["--vary", "mass=10:20:5kg", "--step", "5kg"], "one range"),
        (&["--vary", "mass=10:20:5kg", "--steps", "3"], "range"),
        (&["--vary", "mass=10..20kg", "--steps", "3", "--step", "5kg"], "--step"),
        (&["--vary", "mass=10..20kg", "--step", "x"], "one range"),
        (&["--vary", "mass=10..20kg", "--step", "3kg"], "--vary mass=10:20:2.5kg"),
    ] {
        let found = sweep(folder.path(), words);
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{words:?}: {}", found.err);
        assert!(found.err.contains(part), "{words:?}: {}", found.err);
    }
    // By the name of the key too.
    let found = sweep(folder.path(), &["--mass", "10:20:5", "--json"]);
    assert_eq!(found.code, 2, "{}", found.err);
    for words in [&["--mass", "10:20:5kg"][..], &["--mass", "10..20kg", "--step", "5kg"]] {
        let found = sweep(folder.path(), &[words, &["--json"]].concat());
        let json: Value = serde_json::from_str(&found.out).unwrap_or_default();
        assert_eq!(json["rows"], 3, "{words:?}: {}", found.err);
    }
}

/// Factors of the load are those of `--scale load=`: the answer of each row is that of `size` with the factor.
#[test]
fn factors_of_the_load_are_those_of_a_scaled_axis() {
    for example in
        ["examples/indexing-table.toml", "examples/belt-axis.toml", "examples/hoist.toml", "examples/slewing-arm.toml"]
    {
        let table = run(&["sweep", example, "--vary", "load=0.5,1,1.5", "--json"]);
        let table: Value =
            serde_json::from_str(&table.out).unwrap_or_else(|why| panic!("{example}: {why} {}", table.err));
        for (row, factor) in table["answers"].as_array().unwrap().iter().zip(["0.5", "1", "1.5"]) {
            let alone = run(&["size", example, "--scale", &format!("load={factor}"), "--json"]);
            let alone: Value = serde_json::from_str(&alone.out).unwrap();
            assert_eq!(row["code"], alone["answer"], "{example} {factor}");
            assert_eq!(row["labels"]["load ×"], Value::from(factor), "{example}");
        }
    }
    for call in [
        &["--vary", "load=1,1.2", "--vary", "motion[1].payload=1kg,2kg"][..],
        &["--scale", "load=1.15", "--vary", "mechanism.arm.mass=4kg,5kg"],
        &[
            "--set",
            "requirements.ambient=30degC",
            "--scale",
            "mechanism.arm.mass=1.2",
            "--vary",
            "mechanism.arm.mass=4kg,5kg",
        ],
    ] {
        let run = run(&[&["sweep", "examples/tilting-arm.toml"], call].concat());
        assert!(run.code == 2 && run.out.is_empty() && run.err.contains("given twice"), "{call:?}: {}", run.err);
    }
}
