//! The interface over HTTP answers with the bytes that the commands write with `--json`.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use axis::{Catalogue, Files};
use page::{Call, Method, Reply, Shell};
use quantities::Language;
use questions::Progress;
use run::{root, run_with};
use std::io::Read;
use std::sync::Arc;

/// The files beside the examples.
struct Examples;

impl Files for Examples {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(root().join("examples").join(name))?))
    }
}

struct InTheRepository;

impl Shell for InTheRepository {
    fn files(&self) -> &dyn Files {
        &Examples
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn version(&self, bytes: &[u8]) -> String {
        blake3::hash(bytes).to_hex().to_string()
    }
}

fn encoded(pairs: &[(&str, &str)]) -> String {
    let sign = |byte: u8| match byte {
        b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' => char::from(byte).to_string(),
        other => format!("%{other:02X}"),
    };
    let text = |text: &str| text.bytes().map(sign).collect::<String>();
    pairs.iter().map(|(name, value)| format!("{}={}", text(name), text(value))).collect::<Vec<_>>().join("&")
}

fn asked(path: &str, query: &[(&str, &str)], body: Option<&[u8]>) -> Reply {
    let call = Call {
        method: if body.is_some() { Method::Post } else { Method::Get },
        path: &format!("/api/v1/{path}"),
        query: &encoded(query),
        media: None,
        body: body.unwrap_or_default(),
        language: Language::default(),
    };
    page::respond(&call, &InTheRepository, &Progress::endless())
}

/// Holds an answer to that of the command: the same bytes, and 422 where the command exits with 2.
fn same(arguments: &[&str], path: &str, query: &[(&str, &str)], body: Option<&[u8]>) {
    let mut arguments = arguments.to_vec();
    arguments.push("--json");
    let command = run_with(&arguments, b"");
    let reply = asked(path, query, body);
    assert_eq!(String::from_utf8_lossy(&reply.body), command.out, "{arguments:?}");
    assert_eq!(reply.status == 422, command.code == 2, "{arguments:?}: {} and {}", reply.status, command.code);
    assert!(!command.out.is_empty(), "{arguments:?}: {}", command.err);
}

fn examples() -> Vec<String> {
    let folder = std::fs::read_dir(root().join("examples")).unwrap();
    let names = folder.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".toml")).collect();
    names.sort();
    assert!(names.len() > 8, "{names:?}");
    names
}

const CODES: [&str; 3] = ["CHA-25A-50-H-C1024", "CHA-40A-100-H-M512P-B", "CHA-14A-30-E-M128S"];

/// The query that belongs to an example, with its file named as on the command line.
fn of_file<'q>(file: &'q str, more: &[(&'q str, &'q str)]) -> Vec<(&'q str, &'q str)> {
    [&[("file", file)], more].concat()
}

#[test]
fn every_example_is_answered_with_the_bytes_of_the_command() {
    for (name, code) in examples().iter().zip(CODES.into_iter().cycle()) {
        let file = format!("examples/{name}");
        let text = std::fs::read(root().join(&file)).unwrap();
        let body = Some(text.as_slice());
        // Few samples: it is the same answer that counts, not what it says.
        let has_tolerances = file.contains("tolerances");
        let drawn: &[(&str, &str)] = if has_tolerances { &[("samples", "20"), ("seed", "7")] } else { &[] };
        let options: &[&str] = if has_tolerances { &["--samples", "20", "--seed", "7"] } else { &[] };
        let few = [&[("top", "2")], drawn].concat();
        same(&[&["size", file.as_str(), "--top", "2"], options].concat(), "size", &of_file(&file, &few), body);
        let of_code = [&[("code", code)], drawn].concat();
        let arguments = [&["check", file.as_str(), "--code", code], options].concat();
        same(&arguments, "check", &of_file(&file, &of_code), body);
    }
}

/// One axis, several, and one with loads on the flange.
#[test]
fn every_question_about_an_axis_is_answered_with_the_bytes_of_the_command() {
    let [one, two, none] = CODES;
    for file in ["examples/manual-example.toml", "examples/two-axes.toml", "examples/turntable.toml"] {
        let text = std::fs::read(root().join(file)).unwrap();
        let body = Some(text.as_slice());
        same(&["size", file, "--all", "--lang", "de"], "size", &of_file(file, &[("all", ""), ("lang", "de")]), body);
        same(&["size", file, "--axis", "none"], "size", &of_file(file, &[("axis", "none")]), body);
        same(&["check", file], "check", &of_file(file, &[]), body);
        same(&["explain", file, "--code", one], "explain", &of_file(file, &[("code", one)]), body);
        let brake = [("code", one), ("check", "brake_holding")];
        let arguments = ["explain", file, "--code", one, "--check", "brake_holding"];
        same(&arguments, "explain", &of_file(file, &brake), body);
        let both = [("code", one), ("code", two)];
        same(&["compare", file, "--code", one, "--code", two], "compare", &of_file(file, &both), body);
        let with_a_wrong_one = [("code", one), ("code", none)];
        let arguments = ["compare", file, "--code", one, "--code", none];
        same(&arguments, "compare", &of_file(file, &with_a_wrong_one), body);
        same(&["compare", file, "--code", one], "compare", &of_file(file, &[("code", one)]), body);
        same(&["bearing", file], "bearing", &of_file(file, &[]), body);
        same(&["export", file, "--table", "checks"], "export", &of_file(file, &[("table", "checks")]), body);
        same(&["mount", two, "--project", file], "mount", &of_file(file, &[("code", two)]), body);
    }
}

#[test]
fn questions_about_a_code_are_answered_with_the_bytes_of_the_command() {
    for code in CODES.into_iter().chain(["cha 20a 100 h res", "CHA-40A-30-H-C1024", "CHA-40A-50-H-RES", "x\u{1b}"]) {
        let query = [("code", code)];
        same(&["code", "parse", code], "code/parse", &query, None);
        same(&["code", "complete", code], "code/complete", &query, None);
        same(&["data", code], "data", &query, None);
        same(&["wiring", code], "wiring", &query, None);
        same(&["wiring", code, "--length", "0 m"], "wiring", &[("code", code), ("length", "0 m")], None);
        same(&["mount", code], "mount", &query, None);
        same(&["mount", code, "--bore", "Q7"], "mount", &[("code", code), ("bore", "Q7")], None);
        same(&["curve", code, "--voltage", "220 V"], "curve", &[("code", code), ("voltage", "220 V")], None);
        same(&["torsion", code, "--torque", "-60 N m"], "torsion", &[("code", code), ("torque", "-60 N m")], None);
        same(&["torsion", code, "--torque", "60"], "torsion", &[("code", code), ("torque", "60")], None);
        let upkeep = [("code", code), ("delivered", "2026-03-01"), ("hours-per-day", "10"), ("storage", "6 months")];
        let arguments = ["--delivered", "2026-03-01", "--hours-per-day", "10", "--storage", "6 months"];
        same(&[&["upkeep", code], &arguments[..]].concat(), "upkeep", &upkeep, None);
        let early = [("code", code), ("delivered", "2026-03-01"), ("today", "2026-02-01"), ("inspect", "soon")];
        let arguments = ["--delivered", "2026-03-01", "--today", "2026-02-01", "--inspect", "soon"];
        same(&[&["upkeep", code], &arguments[..]].concat(), "upkeep", &early, None);
        for form in ["sinamics", "cia402", "plain"] {
            same(&["commission", code, "--for", form], "commission", &[("code", code), ("for", form)], None);
        }
        same(&["errata", code], "errata", &[("about", code)], None);
        let faulty = ["check", "examples/two-axes.toml", "--code", code];
        let text = std::fs::read(root().join("examples/two-axes.toml")).unwrap();
        same(&faulty, "check", &[("code", code)], Some(&text));
    }
    let code = "CHA-25A-100-H-M512P-B";
    let pins = std::fs::read(root().join("examples/pins.csv")).unwrap();
    let query = [("code", code), ("file", "examples/pins.csv")];
    same(&["wiring", code, "--check", "examples/pins.csv"], "wiring", &query, Some(&pins));
    let csv = std::fs::read(root().join("examples/robot-joint.csv")).unwrap();
    let query = [("code", code), ("file", "examples/robot-joint.csv")];
    same(&["wiring", code, "--check", "examples/robot-joint.csv"], "wiring", &query, Some(&csv));
    let record = "examples/commissioning/three-faults.toml";
    let text = std::fs::read(root().join(record)).unwrap();
    same(&["commission", code, "--record", record], "commission", &[("code", code), ("file", record)], Some(&text));
}

#[test]
fn everything_else_is_answered_with_the_bytes_of_the_command() {
    let body = "disc diameter=200mm length=20mm mass=5kg";
    same(&["inertia", body, "point mass=1kg"], "inertia", &[("body", body), ("body", "point mass=1kg")], None);
    same(&["inertia", "disk"], "inertia", &[("body", "disk")], None);
    same(&["battery", "--hours-per-day", "10"], "battery", &[("hours-per-day", "10")], None);
    same(&["battery", "--hours-per-day", "many"], "battery", &[("hours-per-day", "many")], None);
    same(&["battery", "--hours-per-day", "30"], "battery", &[("hours-per-day", "30")], None);
    same(&["errata"], "errata", &[], None);
    same(&["errata", "77.2"], "errata", &[("about", "77.2")], None);
    same(&["glossary"], "glossary", &[], None);
    same(&["glossary", "T_maxx", "--lang", "de"], "glossary", &[("term", "T_maxx"), ("lang", "de")], None);
    same(
        &["code", "list", "CHA-20A-*-H", "--available"],
        "code/list",
        &[("pattern", "CHA-20A-*-H"), ("available", "1")],
        None,
    );
    same(&["catalogue", "export"], "catalogue", &[], None);
    same(&["schema"], "schema", &[], None);
    same(&["schema", "--answers"], "schema", &[("answers", "true")], None);
    same(&["licences"], "licences", &[], None);
    same(&["units"], "units", &[], None);
    let code = "CHA-25A-100-H-M512P-EC";
    same(
        &["encoder", code, "--angle", "12.5 deg", "--turn", "3", "--seed", "1", "--window", "1 deg", "--error"],
        "encoder",
        &[("code", code), ("angle", "12.5 deg"), ("turn", "3"), ("seed", "1"), ("window", "1 deg"), ("error", "1")],
        None,
    );
    same(&["encoder", code, "--decode", "10x"], "encoder", &[("code", code), ("decode", "10x")], None);
    same(&["units", "rpm"], "units", &[("quantity", "rpm")], None);
    let csv = run_with(&["catalogue", "export", "--format", "csv"], b"").out;
    assert_eq!(asked("catalogue", &[("format", "csv")], None).body, csv.into_bytes());
    let project = run_with(&["new", "arm", "--lang", "de"], b"").out;
    assert_eq!(asked("new", &[("kind", "arm"), ("lang", "de")], None).body, project.into_bytes());
}

/// Two revisions, the pictures, and a project that names nothing but what is wrong with it.
#[test]
fn revisions_pictures_and_faults_are_those_of_the_command() {
    let text = |name: &str| std::fs::read_to_string(root().join("examples").join(name)).unwrap();
    let (old, new) = (text("screw-axis.toml"), text("belt-axis.toml"));
    let both = serde_json::to_vec(&serde_json::json!({"old": old, "new": new})).unwrap();
    same(&["diff", "examples/screw-axis.toml", "examples/belt-axis.toml"], "diff", &[], Some(&both));
    let arguments = ["plot", "examples/screw-axis.toml", "--figure", "utilisation", "--theme", "dark", "--lang", "de"];
    let reply = asked("plot", &[("figure", "utilisation"), ("theme", "dark"), ("lang", "de")], Some(old.as_bytes()));
    assert_eq!(String::from_utf8(reply.body).unwrap(), run_with(&arguments, b"").out);
    let faulty = old.replace("kg", "kgg").replace("format = 1", "format = 1\nfromat = 1");
    let command = run_with(&["size", "-", "--json"], faulty.as_bytes());
    let reply = asked("size", &[], Some(faulty.as_bytes()));
    assert_eq!((reply.status, command.code), (422, 2));
    assert_eq!(String::from_utf8(reply.body).unwrap(), command.out);
}

/// A table with names of its rows, and with ends of lines of Windows.
struct Labelled;

impl Files for Labelled {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(&b"id,load.inertia [kg m^2],line\r\nA1,1.0,north\r\nB2,1.5,\r\n"[..]))
    }
}

impl Shell for Labelled {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn version(&self, _: &[u8]) -> String {
        String::new()
    }
}

#[test]
fn labels_of_a_table_are_repeated_in_its_answers() {
    let project = std::fs::read(root().join("examples/indexing-table.toml")).unwrap();
    let query = encoded(&[("table", "tasks.csv")]);
    let call = Call {
        method: Method::Post,
        path: "/api/v1/sweep",
        query: &query,
        media: None,
        body: &project,
        language: Language::default(),
    };
    let reply = page::respond(&call, &Labelled, &Progress::endless());
    let found: serde_json::Value = serde_json::from_slice(&reply.body).unwrap();
    let labels = |row: usize| found["answers"][row]["labels"].clone();
    assert_eq!(labels(0), serde_json::json!({"id": "A1", "line": "north"}), "{found}");
    assert_eq!(labels(1), serde_json::json!({"id": "B2"}), "{found}");
    assert_eq!(found["not_judged"], serde_json::json!([]), "{found}");
}
