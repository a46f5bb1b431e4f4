//! The terminal shows no internal identifier but keys and words to type, and no English in German answers.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use quantities::Language;
use questions::list::LIST;
use questions::list::new::{template, template_kinds};
use run::{examples, few_samples, root, run_in};
use std::collections::BTreeSet;
use testkit::readers::{english, identifiers, text_of};

const CODES: [&str; 3] = ["CHA-25A-100-H-M512P-B-EC", "CHA-14A-50-E-M128S", "CHA-58A-100-H-C1024-B-EC"];

fn call(parts: &[&str]) -> Vec<String> {
    parts.iter().map(|part| (*part).to_owned()).collect()
}

/// The calls that are about an axis.
fn of_axes() -> Vec<Vec<String>> {
    let mut calls = Vec::new();
    for example in examples() {
        let own: &[&str] = if example.contains("manual-example") { &[] } else { &["--code", "CHA-25A-50-H-C1024-B"] };
        calls.push(call(&[&["size", example.as_str(), "--top", "3"], few_samples(&example)].concat()));
        // These answers are about one axis.
        if example.contains("two-axes") {
            continue;
        }
        calls.push(call(&[&["check", example.as_str()], few_samples(&example), own].concat()));
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
        for command in ["data", "wiring", "mount", "curve"] {
            calls.push(call(&[command, code]));
        }
        calls.push(call(&["code", "parse", code]));
        calls.push(call(&["encoder", code, "--angle", "30 deg"]));
        calls.push(call(&["upkeep", code, "--delivered", "2026-03-01", "--hours-per-day", "10"]));
        calls.push(call(&["torsion", code, "--torque", "20 N m"]));
        for form in ["plain", "sinamics", "cia402"] {
            calls.push(call(&["commission", code, "--for", form]));
        }
    }
    calls.push(call(&["errata"]));
    calls.push(call(&["battery", "--hours-per-day", "10", "--storage", "1 a"]));
    calls.push(call(&["commission", CODES[0], "--record", "examples/commissioning/three-faults.toml"]));
    calls
}

/// The help of every command.
fn of_help() -> Vec<Vec<String>> {
    let mut calls = vec![call(&["--help"])];
    calls.extend(LIST.iter().map(|entry| {
        // Two entries may share a command and differ in an option.
        let words = entry.command.split(' ').take_while(|word| !word.starts_with('-'));
        words.chain(["--help"]).map(str::to_owned).collect()
    }));
    calls.dedup();
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
    // In brackets of a derivation a key has no room for its words: it names the line of the file.
    found.retain(|each| words::without_keys(each, language) == each.as_str());
    // Symbols of the tables are what `antrieb data` lists and `antrieb glossary` explains: `L_brake`.
    found.retain(|each| !catalogue::glossary().iter().any(|term| term.symbol == each.as_str()));
    // A table of parameters names the key of each, to be typed.
    found.retain(|each| !each.starts_with("twin.measured."));
    // The extension of a packed table.
    found.retain(|each| each != "csv.gz");
    if language == Language::De {
        let names = catalogue::documents().iter().flat_map(|each| [each.title, each.short]);
        // Objects of CiA 402 have the names of the profile; a section is cited by its heading.
        let lines = text.lines().filter(|line| !line.trim_start().starts_with("0x"));
        // Options of a call are typed as they are.
        let is_word = |word: &&str| !word.starts_with("--");
        let lines = lines.map(|line| line.split(' ').filter(is_word).collect::<Vec<_>>().join(" "));
        let own = lines.collect::<Vec<_>>().join("\n");
        let quoted = own.split('„').skip(1).filter_map(|rest| rest.split('“').next());
        let text = quoted.fold(own.clone(), |text, title| text.replace(title, ""));
        let columns = keys_and_columns(&text);
        let found_words = english(&names.fold(text, |text, name| text.replace(name, "")));
        found.extend(found_words.into_iter().filter(|each| {
            // The columns of a recording have the names that its file gives them.
            !columns.contains(each.split(": ").next().unwrap_or_default())
        }));
    }
    found.into_iter().map(|each| format!("{place}: {each}")).collect()
}

fn are_none(mut found: Vec<String>) {
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
}

fn show_none(calls: &[Vec<String>], language: Language) {
    are_none(shown(calls, language));
}

/// Returns the faults of the answers to some calls.
fn shown(calls: &[Vec<String>], language: Language) -> Vec<String> {
    let mut found = Vec::new();
    for call in calls {
        let mut arguments: Vec<&str> = call.iter().map(String::as_str).collect();
        arguments.extend(["--lang", language.id()]);
        // Wide enough that no word is broken.
        let answer = run_in(&arguments, "2000");
        assert!(!answer.out.is_empty(), "{arguments:?}: {}", answer.err);
        let text = if answer.out.starts_with("<svg") { text_of(&answer.out) } else { answer.out + &answer.err };
        // What the user wrote is shown as written: the name of the axis.
        let project = call.iter().find_map(|part| std::fs::read_to_string(root().join(part)).ok()).unwrap_or_default();
        let names = project.lines().filter_map(|line| line.strip_prefix("name = \"")?.split('"').next());
        let text = names.fold(text, |text, name| text.replace(name, ""));
        found.extend(faults(&call.iter().take(4).cloned().collect::<Vec<_>>().join(" "), &text, language));
    }
    found
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

/// Names of commands, options and values are typed in any language, and so are the dimensions of a body.
#[test]
fn no_help_shows_an_identifier_or_the_other_language() {
    let commands = LIST.iter().flat_map(|entry| entry.command.split([' ', '-']));
    let options = LIST.iter().flat_map(|entry| entry.arguments).flat_map(|each| each.name.split('_'));
    let typed: BTreeSet<&str> =
        typed().into_iter().chain(commands).chain(options).chain(["length", "height", "mass", "from"]).collect();
    for language in Language::ALL {
        let found = shown(&of_help(), language);
        let is_typed = |fault: &String| fault.split(": ").nth(1).is_some_and(|word| typed.contains(word));
        are_none(found.into_iter().filter(|fault| !is_typed(fault)).collect());
    }
}

/// Returns the words before an equals sign, and before a unit in brackets: keys and the columns of a recording.
fn keys_and_columns(text: &str) -> BTreeSet<String> {
    let before = |line: &str, mark: char| {
        let parts: Vec<String> = line.split(mark).map(str::to_owned).collect();
        let heads = parts.iter().take(parts.len().saturating_sub(1));
        heads
            .filter_map(|head| head.split_whitespace().last().map(|word| word.trim_start_matches('#').to_owned()))
            .collect::<Vec<_>>()
    };
    text.lines().flat_map(|line| before(line, '=').into_iter().chain(before(line, '['))).collect()
}

/// Keys and values of a generated project are typed; its comments are read, and may name a key.
#[test]
fn no_comment_of_a_generated_project_shows_an_identifier_or_the_other_language() {
    let mut found = Vec::new();
    for language in Language::ALL {
        for kind in template_kinds() {
            let text = template(kind, "axis.toml", language).unwrap().text;
            let comments: Vec<&str> = text.lines().filter_map(|line| Some(line.split_once("# ")?.1)).collect();
            assert!(!comments.is_empty(), "{kind}");
            let named = keys_and_columns(&text);
            let own = faults(&format!("new {kind}"), &comments.join("\n"), language);
            found.extend(own.into_iter().filter(|fault| {
                let word = fault.split(": ").nth(1).unwrap_or_default();
                !named.contains(word)
            }));
        }
    }
    are_none(found);
}
