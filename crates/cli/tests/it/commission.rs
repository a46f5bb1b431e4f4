//! `commission` from outside: files that are written, a record that is judged, and one that cannot be read.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]
#![allow(clippy::indexing_slicing, reason = "JSON answers null for a missing key")]

use crate::run;

use run::run;
use serde_json::Value;

const CODE: &str = "CHA-25A-100-H-M512P-B";
const FAULTY: &str = "examples/commissioning/three-faults.toml";

#[test]
fn three_planted_faults_are_found_with_their_causes() {
    let answer = run(&["commission", CODE, "--record", FAULTY, "--json"]);
    assert_eq!(answer.code, 1, "{}", answer.err);
    let value: Value = serde_json::from_str(&answer.out).unwrap();
    let off: Vec<(&str, &str)> = value["measurements"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|each| each["verdict"] == "fail" || each["verdict"] == "advice")
        .map(|each| (each["id"].as_str().unwrap(), each["cause"].as_str().unwrap_or("none")))
        .collect();
    assert_eq!(off, [("resistance_ll", "one_phase"), ("emf", "amplitude"), ("direction_flange", "same_direction")]);
    assert_eq!((&value["off"], &value["verdict"]), (&Value::from(3), &Value::from("does_not_fit")));
}

#[test]
fn a_record_without_fault_exits_with_zero() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("values.toml");
    let text = std::fs::read_to_string(run::root().join(FAULTY)).unwrap();
    let sound =
        text.replace("1.88 ohm", "3.76 ohm").replace("52.1 V", "36.8 V").replace("flange = \"cw\"", "flange = \"ccw\"");
    std::fs::write(&path, sound).unwrap();
    let path = path.display().to_string();
    let answer = run(&["commission", CODE, "--record", &path]);
    assert_eq!(answer.code, 0, "{}{}", answer.out, answer.err);
}

#[test]
fn a_record_that_cannot_be_read_tells_every_fault_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("values.toml");
    std::fs::write(&path, "format = 1\n[winding]\ntemperature = \"20 degC\"\nresistance_ll = \"3.7 mH\"\n[brake]\nvoltage = 24\nopening_curent = \"0.9 A\"\n").unwrap();
    let path = path.display().to_string();
    let answer = run(&["commission", CODE, "--record", &path]);
    assert_eq!((answer.code, answer.out.as_str()), (2, ""));
    for shown in [":4:", "unit of inductance", ":6:", "without a unit", ":7:", "opening_current"] {
        assert!(answer.err.contains(shown), "{shown}: {}", answer.err);
    }
    let json = run(&["commission", CODE, "--record", &path, "--json"]);
    let value: Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(value["errors"].as_array().unwrap().len(), 3);
    assert_eq!(run(&["commission", CODE, "--record", "nowhere.toml"]).code, 2);
    assert_eq!(run(&["commission", CODE, "--record", &path, "--for", "plain"]).code, 2);
    assert_eq!(run(&["commission", "CHA-58A-50-H-RES", "--for", "plain"]).code, 2);
    let plain = run(&["commission", CODE]);
    assert!(plain.code == 0 && plain.err.contains("--for plain"), "{}", plain.err);
    assert_eq!(run(&["commission", CODE, "--for", "plain", "--ambient", "20"]).code, 2);
}

#[test]
fn forms_and_an_empty_record_are_written_and_never_over_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (script, eds, blank) = (path("motor.txt"), path("motor.eds"), path("values.toml"));
    assert_eq!(run(&["commission", CODE, "--for", "sinamics", "--out", &script]).code, 0);
    assert_eq!(run(&["commission", CODE, "--for", "cia402", "--out", &eds, "--blank", &blank]).code, 0);
    assert!(std::fs::read_to_string(&script).unwrap().contains("p0350[0] = 1.85"));
    assert!(std::fs::read_to_string(&eds).unwrap().contains("[6075]\nParameterName=Motor rated current\n"));
    let before = std::fs::read(&blank).unwrap();
    assert_eq!(run(&["commission", CODE, "--blank", &blank]).code, 2);
    assert_eq!(std::fs::read(&blank).unwrap(), before);
    // Nothing measured: nothing is off, and everything is not checked.
    let judged = run(&["commission", CODE, "--record", &blank, "--json"]);
    assert_eq!(judged.code, 0, "{}", judged.err);
    let value: Value = serde_json::from_str(&judged.out).unwrap();
    assert!(value["measurements"].as_array().unwrap().iter().all(|each| each["verdict"] == "not_checked"));
}
