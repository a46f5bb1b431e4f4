//! Reads the grammar of every series in `data/` and embeds it.
#![allow(clippy::print_stdout, reason = "a build script speaks to cargo over stdout")]

use series_files::{Code, CodeField, WordMeaning, variant_of};
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let mut faults = Vec::new();
    for folder in series_files::series_folders(&root, &mut faults) {
        println!("cargo::rerun-if-changed={}", folder.join("code.toml").display());
    }
    // A new series comes with its manual.
    println!("cargo::rerun-if-changed={}", root.join("sources.toml").display());
    let codes = series_files::codes(&root, &mut faults);
    series_files::write_out("grammars.rs", &text(&codes), &faults)
}

fn text(codes: &[Code]) -> String {
    let mut out =
        String::from("// Generated from data/ by the build script; do not edit.\nstatic EMBEDDED: &[Grammar] = &[\n");
    for code in codes {
        let fields: Vec<String> = code.fields.iter().map(|field| record(code, field)).collect();
        let _ = writeln!(out, "Grammar {{ series: {:?}, fields: &[{}] }},", code.series, fields.join(", "));
    }
    out.push_str("];\n");
    let words = |field: &str| codes.iter().flat_map(|code| code.words(field)).collect::<Vec<_>>();
    for (field, name) in [("feedback", "FEEDBACKS"), ("option_1", "OPTIONS_1"), ("option_2", "OPTIONS_2")] {
        let _ = writeln!(
            out,
            "/// The words of this field in the embedded series.\npub const {name}: &[&str] = &{:?};",
            words(field)
        );
    }
    out
}

fn record(code: &Code, field: &CodeField) -> String {
    let of = |word: &String| code.feedbacks.iter().find(|feedback| feedback.word == *word);
    let found = field.words.iter().filter_map(of);
    let kinds = found.map(|feedback| format!("FeedbackKind::{}", variant_of(&feedback.kind)));
    let kinds: Vec<String> = if field.id == "feedback" { kinds.collect() } else { Vec::new() };
    let meanings: Vec<String> = field.meanings.iter().map(meaning).collect();
    format!(
        "FieldWords {{ field: Field::{}, is_optional: {}, words: &{:?}, kinds: &[{}], meanings: &[{}] }}",
        variant_of(&field.id),
        field.optional,
        field.words,
        kinds.join(", "),
        meanings.join(", "),
    )
}

fn meaning(meaning: &WordMeaning) -> String {
    let when: Vec<String> =
        meaning.when.iter().map(|(field, words)| format!("(Field::{}, &{words:?})", variant_of(field))).collect();
    format!(
        "Meaning {{ word: {:?}, when: &[{}], en: {:?}, de: {:?} }}",
        meaning.word,
        when.join(", "),
        meaning.en,
        meaning.de
    )
}
