//! Assumptions of an axis: every answer that rests on them states them, in the record and on the terminal.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run::{Run, run_at};
use questions::list::{LIST, Reads};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Axes with many assumptions: nothing is stated beyond what the mechanism needs.
const PROJECTS: [(&str, &str); 3] = [
    (
        "arm.toml",
        "format = 1\n[axis]\nsingle_move = true\n[mechanism.arm]\nlength = \"300 mm\"\nmass = \"3 kg\"\n[[motion]]\n\
         law = \"open\"\ndistance = \"90 deg\"\ntime = \"0.6 s\"\n",
    ),
    (
        "winder.toml",
        "format = 1\n[axis]\nsingle_move = true\n[mechanism.winder]\ntension = \"40 N\"\nwidth = \"300 mm\"\n\
         thickness = \"0.2 mm\"\ndensity = \"1200 kg/m^3\"\ncore_diameter = \"80 mm\"\nfull_diameter = \"200 mm\"\n\
         [[motion]]\nlaw = \"web\"\nspeed = \"20 m/min\"\n",
    ),
    (
        "table.toml",
        "format = 1\n[mechanism.turntable]\n[[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"600 mm\"\n\
         mass = \"20 kg\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\n\
         law = \"dwell\"\ntime = \"1 s\"\n[bearing]\nmechanism = \"add\"\naxial_force = \"200 N\"\n\
         axial_distance = \"10 mm\"\n",
    ),
];

/// Calls of the questions about an axis, behind the project.
const CALLS: [(&str, &[&str]); 9] = [
    ("size", &[]),
    ("check", &[]),
    ("explain", &["--check", "peak_torque"]),
    ("simulate", &[]),
    ("compare", &["CHA-40A-50-H-C1024", "CHA-50A-50-H-C1024"]),
    ("sweep", &["--vary", "requirements.ambient=20 degC,25 degC"]),
    ("bearing", &[]),
    ("moves", &[]),
    ("mount", &["CHA-40A-50-H-C1024"]),
];

/// Questions about an axis whose answer is a document or a table of its own with the assumptions in it, a picture, or an
/// estimate from a recorded run.
const OTHERS: [&str; 4] = ["export", "identify", "plot", "report"];

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in PROJECTS {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn call(folder: &Path, project: &str, (question, more): (&str, &[&str]), last: &[&str]) -> Run {
    let words = if question == "mount" {
        [&[question][..], more, &["--project", project], last].concat()
    } else {
        [&[question, project][..], more, last].concat()
    };
    run_at(folder, &words)
}

/// Returns the texts of the assumptions in a record, of whatever form.
fn texts(record: &Value) -> BTreeSet<String> {
    match record {
        Value::Object(members) => {
            let own = members.iter().filter(|(name, _)| *name == "assumptions").filter_map(|(_, list)| list.as_array());
            let own = own.flatten().filter_map(|each| Some(each["why"].as_str()?.to_owned()));
            own.chain(members.values().flat_map(texts)).collect()
        }
        Value::Array(all) => all.iter().flat_map(texts).collect(),
        _ => BTreeSet::new(),
    }
}

fn flowing(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_answer_about_an_axis_states_its_assumptions() {
    let folder = folder();
    let here = folder.path();
    for (project, _) in PROJECTS {
        let record = |of: (&str, &[&str])| -> Value {
            let run = call(here, project, of, &["--json"]);
            serde_json::from_str(&run.out)
                .unwrap_or_else(|why| panic!("{project} {of:?}: {why}\n{}{}", run.out, run.err))
        };
        let all = texts(&record(CALLS[0]));
        assert!(all.len() >= 5, "{project}: {all:?}");
        for of in CALLS {
            // A roll takes longer than a run without a time limit may.
            if of.0 == "simulate" && project == "winder.toml" {
                continue;
            }
            let stated = texts(&record(of));
            match of.0 {
                // The answer has no load, the motion only.
                "moves" => assert!(stated.is_subset(&all), "{project}: {stated:?}"),
                // The table states the ambient temperature.
                "sweep" => {
                    let missing: Vec<&String> = all.difference(&stated).collect();
                    assert!(missing.len() == 1 && missing[0].contains("ambient"), "{project}: {missing:?}");
                }
                _ => assert!(stated.is_superset(&all), "{project} {of:?}: {:?}", all.difference(&stated)),
            }
            for language in ["en", "de"] {
                let run = call(here, project, of, &["--json", "--lang", language]);
                let stated = texts(&serde_json::from_str(&run.out).unwrap());
                let shown = flowing(&call(here, project, of, &["--lang", language]).out);
                for why in stated {
                    assert!(shown.contains(&flowing(&why)), "{project} {of:?}: {why}\n{shown}");
                }
            }
        }
    }
    let moves = call(here, "arm.toml", ("moves", &[]), &[]);
    assert!(moves.out.contains("assumed: "), "{}", moves.out);
}

#[test]
fn no_question_about_an_axis_is_left_out() {
    let of_projects = LIST.iter().filter(|entry| entry.reads == Reads::Project);
    for entry in of_projects {
        let name = entry.command().split(' ').next().unwrap();
        assert!(CALLS.iter().any(|(known, _)| *known == name) || OTHERS.contains(&name), "{name}");
    }
}
