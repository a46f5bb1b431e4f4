//! Every answer as JSON is what the schema of the answers says.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]
#![allow(clippy::indexing_slicing, reason = "JSON answers null for a missing key")]

use crate::run;

use run::{few_samples, run};
use serde_json::{Map, Value};

/// The schema of one command's answer, with the records that all share.
fn schema_of(schema: &Value, command: &str) -> Value {
    let mut one: Map<String, Value> = schema["properties"][command].as_object().unwrap().clone();
    one.insert("$schema".into(), schema["$schema"].clone());
    one.insert("$defs".into(), schema["$defs"].clone());
    Value::Object(one)
}

#[test]
fn every_answer_keeps_to_the_schema() {
    let schema: Value = serde_json::from_str(&run(&["schema", "--answers"]).out).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("cycle.svg").display().to_string();
    let table = folder.path().join("checks.csv").display().to_string();
    let objects = folder.path().join("motor.eds").display().to_string();
    let code = "CHA-25A-50-H-C1024";
    let mut asked: Vec<(String, Vec<String>)> = Vec::new();
    let mut ask = |command: &str, arguments: &[&str]| {
        asked.push((command.to_owned(), arguments.iter().map(|each| (*each).to_owned()).collect()));
    };
    // One of each kind: plain, linear, recorded, with tolerances, with a stage, with an actuator of its own, several axes.
    for name in ["screw-axis", "robot-joint", "tolerances", "manual-example", "two-axes"] {
        let file = format!("examples/{name}.toml");
        ask("size", &[&["size", file.as_str()], few_samples(&file)].concat());
        ask("check", &[&["check", file.as_str(), "--code", code], few_samples(&file)].concat());
    }
    let file = "examples/screw-axis.toml";
    ask("explain", &["explain", file, "--code", code]);
    ask("compare", &["compare", file, "--code", code, "--code", "CHA-32A-50-H-C1024"]);
    ask("diff", &["diff", file, "examples/belt-axis.toml"]);
    ask("bearing", &["bearing", "examples/turntable.toml"]);
    ask("curve", &["curve", "CHA-20A-100-H-C1024"]);
    ask("torsion", &["torsion", "CHA-20A-100-H-C1024", "--torque", "60 N m"]);
    ask("battery", &["battery", "--hours-per-day", "10"]);
    ask("inertia", &["inertia", "disc diameter=200mm length=20mm mass=5kg", "point mass=1kg distance=100mm"]);
    let record = "examples/commissioning/three-faults.toml";
    ask("commission", &["commission", "CHA-14A-50-E-M128S", "--for", "plain"]);
    ask("commission", &["commission", "CHA-25A-100-H-M512P-B", "--for", "sinamics"]);
    ask("commission", &["commission", "CHA-25A-100-H-M512P-B-EC", "--for", "cia402"]);
    ask("commission --record", &["commission", "CHA-25A-100-H-M512P-B", "--record", record]);
    ask("commission --out", &["commission", "CHA-25A-100-H-M512P-B", "--for", "cia402", "--out", &objects]);
    ask("code parse", &["code", "parse", "CHA-14A-50-E-RES-K-SP"]);
    ask("code list", &["code", "list", "CHA-20A-*-H"]);
    ask("code complete", &["code", "complete", "CHA-20A-120-H-C1024"]);
    ask("data", &["data", "CHA-20A-100-H-M512P-B-EC-SP"]);
    ask("wiring", &["wiring", "CHA-20A-100-H-M512P-B-EC", "--length", "10 m"]);
    ask("wiring", &["wiring", "CHA-58A-50-H-RES", "--length", "10 m", "--cross-section", "1 mm^2"]);
    ask("wiring --check", &["wiring", "CHA-25A-100-H-M512P-B", "--check", "examples/pins.csv"]);
    ask("errata", &["errata"]);
    ask("catalogue export", &["catalogue", "export"]);
    ask("faults of a code", &["code", "parse", "CHA-14A-120-H-D2048"]);
    ask("faults of a code", &["code", "complete", "CHA-40A-30"]);
    ask("export --table", &["export", file, "--table", "checks"]);
    ask("export --out", &["export", file, "--table", "checks", "--out", &table]);
    ask("plot", &["plot", file, "--figure", "cycle", "--svg", &picture]);
    // What cannot be answered: an option, a code, a file, a question about every axis.
    ask("faults", &["battery", "--hours-per-day", "many"]);
    ask("faults", &["torsion", "CHA-20A-100-H-C1024", "--torque", "60"]);
    ask("faults", &["wiring", "CHA-25A-100-H-M512P-B", "--check", "examples/robot-joint.csv"]);
    ask("faults", &["wiring", "CHA-25A-100-H-M512P-B", "--length", "0 m"]);
    ask("faults", &["check", "examples/two-axes.toml", "--code", "CHA-58A-50-H-RES"]);
    ask("faults", &["check", "examples/nowhere.toml"]);
    for (command, arguments) in asked {
        let mut arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        arguments.push("--json");
        let answer = run(&arguments);
        assert_eq!(answer.code == 2, command.starts_with("faults"), "{arguments:?}: {}", answer.err);
        let value: Value = serde_json::from_str(&answer.out).unwrap_or_else(|fault| panic!("{arguments:?}: {fault}"));
        let mut compiler = boon::Compiler::new();
        compiler.add_resource("answer.json", schema_of(&schema, &command)).unwrap();
        let mut schemas = boon::Schemas::new();
        let index = compiler.compile("answer.json", &mut schemas).unwrap();
        if let Err(fault) = schemas.validate(&value, index) {
            panic!("{arguments:?}: {fault:#}");
        }
    }
}

/// A schema that lets everything pass holds nothing.
#[test]
fn the_schema_refuses_what_is_no_answer() {
    let schema: Value = serde_json::from_str(&run(&["schema", "--answers"]).out).unwrap();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("answer.json", schema_of(&schema, "check")).unwrap();
    let mut schemas = boon::Schemas::new();
    let index = compiler.compile("answer.json", &mut schemas).unwrap();
    let right: Value = serde_json::from_str(&run(&["check", "examples/manual-example.toml", "--json"]).out).unwrap();
    assert!(schemas.validate(&right, index).is_ok());
    let mut wrong = right.clone();
    wrong["checks"][0]["verdict"] = "perhaps".into();
    assert!(schemas.validate(&wrong, index).is_err());
    let mut wrong = right;
    wrong["demand"]["T_rms"] = "38.9 Nm".into();
    assert!(schemas.validate(&wrong, index).is_err());
}
