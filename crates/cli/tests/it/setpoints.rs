//! `moves --every`: the setpoints of a motion, and the calls that lead there.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run::{Run, run_at};
use serde_json::Value;
use std::fs;
use std::path::Path;

const ARM: &str = "format = 1\n[mechanism.arm]\nlength = \"300 mm\"\nmass = \"3 kg\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
    distance = \"90 deg\"\ntime = \"0.6 s\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"0.4 s\"\n";

fn call(folder: &Path, words: &str) -> Run {
    run_at(folder, &words.split(' ').collect::<Vec<_>>())
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("arm.toml"), ARM).unwrap();
    folder
}

#[test]
fn a_table_of_setpoints_has_both_ends_in_the_units_of_the_axis() {
    let folder = folder();
    let here = folder.path();
    let done = call(here, "moves arm.toml --every 2ms --out sp.csv");
    // The motion is that of the answer, with what is assumed about it.
    assert!(done.code == 0 && done.err.starts_with("assumed: ") && !done.err.contains("error"), "{}", done.err);
    let text = fs::read_to_string(here.join("sp.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "time [s],position [deg],speed [1/min],acceleration [rad/s^2]");
    assert_eq!(lines.len(), 502);
    assert!(lines[1].starts_with("0,0,0,") && lines[301].starts_with("0.6,90,0,"), "{} {}", lines[1], lines[301]);
    assert!(lines[501].starts_with("1,0,0,"), "{}", lines[501]);
    assert_eq!(call(here, "moves arm.toml --every 2ms").out, text);
    let rest = call(here, "moves arm.toml --every 7ms");
    assert!(rest.err.contains("6 ms") && rest.out.lines().last().unwrap().starts_with("1,0,0,"), "{}", rest.err);
    let json: Value = serde_json::from_str(&call(here, "moves arm.toml --every 10ms --json").out).unwrap();
    assert_eq!((&json["setpoints"]["rows"], &json["setpoints"]["units"]["position"]), (&101.into(), &"deg".into()));
    assert_eq!(json["setpoints"]["position"][60], 90.0);
    let json: Value = serde_json::from_str(&call(here, "moves arm.toml --json").out).unwrap();
    assert_eq!(json["setpoints"], Value::Null);
    assert_eq!(call(here, "moves arm.toml --every 2ms --out sp.parquet").code, 0);
    assert_eq!(call(here, "moves arm.toml --every 2ms --out sp.csv").code, 2, "an existing file is kept");
}

#[test]
fn a_call_for_setpoints_names_the_one_that_writes_them() {
    let folder = folder();
    let write = "antrieb moves arm.toml --every 2ms --out setpoints.csv";
    for words in [
        "export arm.toml --motion --for twincat",
        "export arm.toml --setpoints",
        "export arm.toml --setpoints --out sp.csv",
        "simulate arm.toml --setpoints",
        "moves arm.toml --setpoints",
    ] {
        let found = call(folder.path(), words);
        assert!(found.code == 2 && found.err.contains(write), "{words}: {}", found.err);
    }
    assert!(call(folder.path(), "moves arm.toml").out.contains(write));
    for command in ["export", "simulate"] {
        assert!(call(folder.path(), &format!("{command} --help")).out.contains("antrieb moves axis.toml --every 2ms"));
    }
    for (words, part) in [
        ("moves arm.toml --every 0s", "positive time"),
        ("moves arm.toml --every -1s", "positive time"),
        ("moves arm.toml --every 1ns", "1000000 rows"),
        ("moves arm.toml --every 2ms --out sp.xlsx", ".csv or .parquet"),
        ("moves arm.toml --out sp.csv", "--every"),
    ] {
        let found = call(folder.path(), words);
        assert!(found.code == 2 && found.err.contains(part), "{words}: {}", found.err);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}
