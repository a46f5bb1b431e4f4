//! One word for one thing: the answers to every example, in both languages, without the twins that the glossary names.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use run::{examples, few_samples, run};

/// Words that are not used, in a language.
fn twins(language: &str) -> Vec<String> {
    let words = catalogue::words().iter().flat_map(|word| if language == "de" { word.not_de } else { word.not_en });
    let twins: Vec<String> = words.map(|twin| twin.to_lowercase()).collect();
    assert!(!twins.is_empty());
    twins
}

/// The first twin that begins at the beginning of a word.
fn twin_in(text: &str, twins: &[String]) -> Option<String> {
    let text = text.to_lowercase();
    twins.iter().find_map(|twin| {
        let (at, _) = text.match_indices(twin.as_str()).find(|(at, _)| {
            !text.get(..*at).unwrap_or_default().ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '-')
        })?;
        let from = text.get(..at).map_or(0, |head| head.char_indices().rev().nth(30).map_or(0, |(index, _)| index));
        Some(format!("{twin}: {}", text.get(from..).unwrap_or_default().chars().take(80).collect::<String>()))
    })
}

fn answers(language: &str) {
    let twins = twins(language);
    let mut texts: Vec<(String, String)> = Vec::new();
    let mut ask = |arguments: &[&str]| {
        let all: Vec<&str> = arguments.iter().copied().chain(["--lang", language]).collect();
        let found = run(&all);
        assert!(!found.out.is_empty(), "{all:?}: {}", found.err);
        texts.push((all.join(" "), found.out + &found.err));
    };
    for example in examples() {
        ask(&[&["size", example.as_str(), "--top", "1"], few_samples(&example)].concat());
        let own = example.contains("manual-example");
        let code: &[&str] = if own { &[] } else { &["--code", "CHA-25A-50-H-C1024-B"] };
        // One axis of each kind is enough for what the engine derives.
        if language == "de" || own || example.contains("stage") {
            ask(&[&["check", example.as_str()], few_samples(&example), code].concat());
        }
        if own || example.contains("slewing") {
            ask(&[&["explain", example.as_str()], code].concat());
        }
    }
    for figure in ["torque_speed", "cycle", "utilisation", "torsion", "candidate_map"] {
        ask(&["plot", "examples/indexing-table.toml", "--figure", figure]);
    }
    ask(&["compare", "examples/belt-axis.toml", "--code", "CHA-14A-50-N-D2048", "--code", "CHA-17A-50-H-M128S-B"]);
    ask(&["mount", "CHA-25A-100-H-M512P-B"]);
    ask(&["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--hours-per-day", "10"]);
    for table in ["inputs", "assumptions", "demand", "motion", "candidates", "checks"] {
        ask(&["export", "examples/tilting-arm.toml", "--table", table, "--out", "-"]);
    }
    for command in ["size", "check", "explain", "report", "compare", "diff", "export", "code", "plot", "new"] {
        ask(&[command, "--help"]);
    }
    let found: Vec<(&String, String)> =
        texts.iter().filter_map(|(call, text)| Some((call, twin_in(text, &twins)?))).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn no_german_answer_has_a_second_word_for_a_thing() {
    answers("de");
}

#[test]
fn no_english_answer_has_a_second_word_for_a_thing() {
    answers("en");
}

#[test]
fn a_twin_is_found_where_a_word_begins() {
    let twins = vec!["passt".to_owned()];
    assert!(twin_in("der Antrieb passt nicht", &twins).is_some());
    assert!(twin_in("wird angepasst", &twins).is_none());
}

/// Every answer keeps to the width of the terminal.
#[test]
fn no_line_is_wider_than_the_terminal() {
    for columns in ["60", "110", "200"] {
        for arguments in [
            ["check", "examples/manual-example.toml", "--lang", "de"].as_slice(),
            &["explain", "examples/manual-example.toml", "--lang", "en"],
            &["glossary", "torque", "--lang", "en"],
            &["mount", "CHA-25A-100-H-M512P-B", "--lang", "de"],
            &["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--hours-per-day", "10", "--lang", "de"],
            &["size", "--help", "--lang", "de"],
        ] {
            let found = run::run_in(arguments, columns);
            let most: usize = columns.parse().unwrap();
            for line in found.out.lines() {
                assert!(line.chars().count() <= most, "{columns} {arguments:?}: {line}");
            }
        }
    }
}

/// The calls that `--help` shows are calls.
#[test]
fn every_help_shows_an_example_and_help_of_a_command_is_its_help() {
    let commands = run(&["--help"]).out;
    let names: Vec<&str> = commands
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| line.starts_with("  "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(names.len() > 20, "{names:?}");
    for name in names.into_iter().filter(|name| *name != "help") {
        for (language, head) in [("en", "Example:"), ("de", "Beispiel:")] {
            let help = run(&[name, "--help", "--lang", language]);
            assert_eq!(help.code, 0, "{name}: {}", help.err);
            let call = help.out.split(head).nth(1).unwrap_or_else(|| panic!("{name}: no example in {language}"));
            let call = call.trim();
            assert!(call.starts_with(&format!("antrieb {name}")), "{name}: {call}");
            assert!(language == "en" || !help.out.contains("[OPTIONS]"), "{}", help.out);
            let asked = run(&["help", name, "--lang", language]);
            assert_eq!((asked.out, asked.code), (help.out.clone(), 0), "{name}");
        }
    }
}

#[test]
fn a_new_project_is_written_with_its_name_and_its_recording() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shoulder.toml");
    let file = path.to_str().unwrap();
    let made = run(&["new", "recording", "--out", file, "--lang", "de"]);
    assert_eq!(made.code, 0, "{}", made.err);
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("antrieb size shoulder.toml") && text.contains("file = \"shoulder.csv\""), "{text}");
    assert!(folder.path().join("shoulder.csv").is_file());
    assert_eq!(run(&["size", file]).code, 0);
    let again = run(&["new", "recording", "--out", file]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("--force"), "{}", again.err);
}

#[test]
fn the_program_carries_the_licences_of_what_is_in_it() {
    let text = run(&["licences"]).out;
    for wanted in ["MIT License", "SIL OPEN FONT LICENSE", "Apache License", "Inter", "typst-assets"] {
        assert!(text.contains(wanted), "{wanted}");
    }
    let json: serde_json::Value = serde_json::from_str(&run(&["licences", "--json"]).out).unwrap();
    let names = json["texts"].as_array().unwrap().iter().map(|text| text["name"].as_str().unwrap());
    assert_eq!(names.collect::<Vec<_>>(), ["LICENSE", "THIRD-PARTY.md", "third-party/two-face.md"]);
}

#[test]
fn the_glossary_answers_in_text_and_json() {
    let text = run(&["glossary", "Nachweis"]);
    assert!(text.code == 0 && text.out.contains("check"), "{}", text.out);
    let json: serde_json::Value = serde_json::from_str(&run(&["glossary", "T_max", "--json"]).out).unwrap();
    assert_eq!(json.pointer("/terms/0/identifier").and_then(serde_json::Value::as_str), Some("torque_max"));
    let none = run(&["glossary", "torque_maxx", "--json"]);
    assert_eq!(none.code, 2);
    let json: serde_json::Value = serde_json::from_str(&none.out).unwrap();
    assert!(json.pointer("/errors/0/hint").is_some(), "{json}");
}
