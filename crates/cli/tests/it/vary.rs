//! `sweep --vary`: rows that a call states in place of a table, and the columns beside the answers.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run::{Run, run_at};
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
