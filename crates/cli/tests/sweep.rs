//! `sweep` and `new sweep` as a script uses them.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

mod run;

use run::{run, run_with};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;
use std::time::{Duration, Instant};

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn put(folder: &Path, name: &str, text: &str) -> String {
    std::fs::write(folder.join(name), text).unwrap();
    path(folder, name)
}

#[test]
fn a_written_table_is_answered_in_both_formats_alike() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = path(folder, "tasks.csv");
    let keys = ["--key", "load.inertia [kg m^2] = 0.1..300 log", "--key", "motion[0].time [s] = 0.05..2"];
    let new = [&["new", "sweep", "--samples", "40", "--out", &table][..], &keys].concat();
    assert_eq!(run(&new).code, 0);
    let text = std::fs::read_to_string(&table).unwrap();
    assert_eq!(text.lines().next(), Some("load.inertia [kg m^2],motion[0].time [s]"));
    assert_eq!(text.lines().count(), 41);
    let (csv, parquet) = (path(folder, "best.csv"), path(folder, "best.parquet"));
    let first = run(&["sweep", &axis, "--table", &table, "--out", &csv]);
    assert_eq!(first.code, 0, "{}", first.err);
    assert!(first.out.contains("40 rows") && first.err.contains("motion[1].time"), "{} {}", first.out, first.err);
    let answers = std::fs::read_to_string(&csv).unwrap();
    assert_eq!(answers.lines().next(), Some("row,fit,code,utilisation,tightest,error"));
    assert!(answers.lines().skip(1).any(|line| line.contains("CHA-")));
    let second = run(&["sweep", &axis, "--table", &table, "--out", &parquet, "--json"]);
    let record: Value = serde_json::from_str(&second.out).unwrap();
    assert_eq!(record["rows"], 40);
    assert!(record["fitting"].as_u64().unwrap() > 5 && !record["none_fits"].as_array().unwrap().is_empty(), "{record}");
    // What was written is a table again; of its headings `code` alone is one.
    let again = run(&["sweep", &axis, "--table", &parquet, "--out", &path(folder, "x.csv"), "--json"]);
    let faults: Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!((again.code, faults["errors"].as_array().unwrap().len()), (2, 5), "{faults}");
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 4, "nothing else is left");
}

#[test]
fn every_fault_of_a_table_is_reported_with_heading_and_row() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = put(
        folder,
        "tasks.csv",
        "load.inertia [kg m^2],motion[0].law,code\n1,trapezoid,CHA-25A-50-H-C1024\nheavy,trapezoyd,CHA-25A-50-H-C1025\n,constant,\n",
    );
    let out = path(folder, "best.csv");
    let found = run(&["sweep", &axis, "--table", &table, "--out", &out]);
    assert_eq!(found.code, 2);
    insta::assert_snapshot!("faults_of_cells", found.err.replace(&folder.display().to_string(), ""));
    let table = put(
        folder,
        "heads.csv",
        "load.inerta [kg m^2],load.friction_torque,motion[0].time [kg],motion[4].time [s]\n1,1,1,1\n",
    );
    let found = run(&["sweep", &axis, "--table", &table, "--out", &out]);
    insta::assert_snapshot!("faults_of_headings", found.err.replace(&folder.display().to_string(), ""));
    let table = put(folder, "empty.csv", "load.inertia [kg m^2]\n");
    assert!(run(&["sweep", &axis, "--table", &table, "--out", &out]).err.contains("no row"));
    assert!(!Path::new(&out).exists());
}

/// A run that is killed leaves finished parts, with which the next one continues; the answer has the bytes of a run in one go.
#[test]
fn a_killed_run_continues_with_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    // Quick rows first: they are refused.
    let mut text = String::from("load.inertia [kg m^2],motion[0].time [s]\n");
    for row in 0..36_000 {
        let inertia = if row < 33_000 { -1.0 } else { 0.1 + f64::from(row % 97) };
        writeln!(text, "{inertia},{}", 0.2 + f64::from(row % 13) / 10.0).unwrap();
    }
    let table = put(folder, "tasks.csv", &text);
    let whole = path(folder, "whole.parquet");
    assert_eq!(run(&["sweep", &axis, "--table", &table, "--out", &whole]).code, 0);
    // The name of the answer is part of the mark of its parts, not of its bytes.
    let out = path(folder, "best.parquet");
    let arguments = ["sweep", &axis, "--table", &table, "--out", &out];
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_antrieb")).args(arguments).spawn().unwrap();
    let second = folder.join("best.parquet.parts/part-00000001.parquet");
    let begun = Instant::now();
    while !second.exists() && begun.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(second.exists() && !Path::new(&out).exists());
    let resumed = run(&arguments);
    assert_eq!(resumed.code, 0, "{}", resumed.err);
    assert!(resumed.err.contains("2 parts with 32768 rows of an interrupted run are kept"), "{}", resumed.err);
    assert_eq!(std::fs::read(&out).unwrap(), std::fs::read(&whole).unwrap());
    assert!(!second.exists());
    // Parts of another project are not continued.
    std::fs::create_dir(folder.join("other.csv.parts")).unwrap();
    put(&folder.join("other.csv.parts"), "sweep", "of another");
    let other = put(folder, "few.csv", "load.inertia [kg m^2]\n1\n");
    let anew = run(&["sweep", &axis, "--table", &other, "--out", &path(folder, "other.csv")]);
    assert!(anew.code == 0 && anew.err.contains("removed"), "{}", anew.err);
}

#[test]
fn a_deadline_ends_a_run_and_says_where_its_parts_are() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let rows: String = (0..20_000).map(|row| format!("{}\n", 1.0 + f64::from(row) / 1e4)).collect();
    let table = put(folder, "tasks.csv", &format!("load.inertia [kg m^2]\n{rows}"));
    let out = path(folder, "best.csv");
    let late = run_with(&["sweep", &axis, "--table", &table, "--out", &out, "--deadline", "0.5 s"], &[]);
    assert!(late.code == 2 && late.err.contains("best.csv.parts"), "{} {}", late.code, late.err);
    assert!(!Path::new(&out).exists());
}
