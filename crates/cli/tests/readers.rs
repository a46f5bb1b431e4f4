//! What the terminal shows: no internal identifier but keys and words to type, and no English in German answers.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

mod run;

use quantities::Language;
use questions::list::LIST;
use questions::list::new::{template, template_kinds};
use run::{root, run_in};
use std::collections::BTreeSet;
use testkit::readers::{english, identifiers, text_of};

const CODES: [&str; 3] = ["CHA-25A-100-H-M512P-B-EC", "CHA-14A-50-E-M128S", "CHA-58A-100-H-C1024-B-EC"];

fn examples() -> Vec<String> {
    let entries = std::fs::read_dir(root().join("examples")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut found: Vec<String> =
        names.filter(|name| name.ends_with(".toml")).map(|name| format!("examples/{name}")).collect();
    found.sort();
    found
}

fn call(parts: &[&str]) -> Vec<String> {
    parts.iter().map(|part| (*part).to_owned()).collect()
}

/// The calls that are about an axis.
fn of_axes() -> Vec<Vec<String>> {
    let mut calls = Vec::new();
    for example in examples() {
        let own: &[&str] = if example.contains("manual-example") || example.contains("two-axes") {
            &[]
        } else {
            &["--code", "CHA-25A-50-H-C1024-B"]
        };
        calls.push(call(&["size", &example, "--top", "3", "--samples", "50"]));
        calls.push(call(&[&["check", example.as_str(), "--samples", "50"], own].concat()));
        calls.push(call(&["moves", &example]));
        if ["tilting-arm", "turntable", "stage", "hoist"].iter().any(|kind| example.contains(kind)) {
            calls.push(call(&[&["explain", example.as_str()], own].concat()));
        }
    }
    calls.push(call(&["simulate", "examples/slewing-arm.toml", "--code", "CHA-25A-50-H-C1024-B"]));
    let pair = ["--code", "CHA-14A-50-N-D2048", "--code", "CHA-17A-50-H-M128S-B"];
    calls.push(call(&[&["compare", "examples/belt-axis.toml"], &pair[..]].concat()));
    for figure in ["torque_speed", "cycle", "utilisation", "torsion", "bearing_load", "candidate_map"] {
        calls.push(call(&["plot", "examples/tilting-arm.toml", "--figure", figure, "--svg", "-"]));
    }
    calls
}

/// The calls that are about a code.
fn of_codes() -> Vec<Vec<String>> {
    let mut calls = Vec::new();
    for code in CODES {
        for command in ["data", "wiring", "mount", "battery", "curve"] {
            calls.push(call(&[command, code]));
        }
        calls.push(call(&["code", "parse", code]));
        calls.push(call(&["encoder", code, "--angle", "30 deg"]));
        calls.push(call(&["upkeep", code, "--delivered", "2026-03-01", "--hours-per-day", "10"]));
        calls.push(call(&["torsion", code, "--torque", "20 N m"]));
        for form in ["plain", "sinamics", "cia402"] {
            calls.push(call(&["commission", code, "--for", form]));
        }
        calls.push(call(&["commission", code, "--checklist"]));
    }
    calls.push(call(&["errata"]));
    calls.push(call(&["commission", CODES[0], "--record", "examples/commissioning/three-faults.toml"]));
    calls
}

/// The help of every command.
fn of_help() -> Vec<Vec<String>> {
    let mut calls = vec![call(&["--help"])];
    calls.extend(LIST.iter().map(|entry| {
        let mut words: Vec<String> = entry.command.split(' ').map(str::to_owned).collect();
        words.push("--help".to_owned());
        words
    }));
    calls
}

/// Words that a reader types: those of arguments, and signals.
fn typed() -> BTreeSet<&'static str> {
    let arguments = LIST.iter().flat_map(|entry| entry.arguments);
    let signals = questions::SIGNALS.iter().map(|signal| signal.id);
    arguments.flat_map(questions::list::Argument::words).chain(signals).collect()
}

/// Identifiers, and English words in a German text.
fn faults(place: &str, text: &str, language: Language) -> Vec<String> {
    let text = words::without_keys(text, language).into_owned();
    let typed = typed();
    let mut found: Vec<String> = identifiers(&text).into_iter().filter(|each| !typed.contains(each.as_str())).collect();
    // Identifiers of errata are what `antrieb errata` takes.
    found.retain(|each| !catalogue::errata().iter().any(|known| known.id.contains(each.as_str())));
    if language == Language::De {
        let names = catalogue::documents().iter().flat_map(|each| [each.title, each.short]);
        found.extend(english(&names.fold(text, |text, name| text.replace(name, ""))));
    }
    found.into_iter().map(|each| format!("{place}: {each}")).collect()
}

fn are_none(mut found: Vec<String>) {
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
}

fn show_none(calls: &[Vec<String>], language: Language) {
    let mut found = Vec::new();
    for call in calls {
        let mut arguments: Vec<&str> = call.iter().map(String::as_str).collect();
        arguments.extend(["--lang", language.id()]);
        // Wide enough that no word is broken.
        let answer = run_in(&arguments, "2000");
        assert!(!answer.out.is_empty(), "{arguments:?}: {}", answer.err);
        let text = if answer.out.starts_with("<svg") { text_of(&answer.out) } else { answer.out + &answer.err };
        found.extend(faults(&call.iter().take(4).cloned().collect::<Vec<_>>().join(" "), &text, language));
    }
    are_none(found);
}

#[test]
fn no_english_answer_about_an_axis_shows_an_identifier() {
    show_none(&of_axes(), Language::En);
}

#[test]
fn no_german_answer_about_an_axis_shows_an_identifier_or_english() {
    show_none(&of_axes(), Language::De);
}

#[test]
fn no_answer_about_a_code_shows_an_identifier_or_the_other_language() {
    for language in Language::ALL {
        show_none(&of_codes(), language);
    }
}

#[test]
fn no_help_shows_an_identifier_or_the_other_language() {
    for language in Language::ALL {
        show_none(&of_help(), language);
    }
}

/// Keys and values of a generated project are typed; its comments are read.
#[test]
fn no_comment_of_a_generated_project_shows_an_identifier_or_the_other_language() {
    let mut found = Vec::new();
    for language in Language::ALL {
        for kind in template_kinds() {
            let text = template(kind, "axis.toml", language).unwrap().text;
            let comments: Vec<&str> = text.lines().filter_map(|line| Some(line.split_once("# ")?.1)).collect();
            assert!(!comments.is_empty(), "{kind}");
            found.extend(faults(&format!("new {kind}"), &comments.join("\n"), language));
        }
    }
    are_none(found);
}
