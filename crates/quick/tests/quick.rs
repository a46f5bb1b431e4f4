//! The program without the typesetting engine.
#![cfg(not(feature = "report"))]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

#[path = "../../cli/tests/it/run/mod.rs"]
mod run;

use run::run;

#[test]
fn a_report_is_refused_in_both_languages_and_no_file_is_left() {
    let file = std::env::temp_dir().join(format!("antrieb-quick-{}.pdf", std::process::id()));
    let name = file.to_str().unwrap();
    for (language, words) in [("en", "does not include the typesetting engine"), ("de", "ohne Satz-Engine gebaut")] {
        let project = "examples/indexing-table.toml";
        for arguments in [["report", project, "--out", name], ["size", project, "--report", name]] {
            let run = run(&[arguments.as_slice(), &["--lang", language]].concat());
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
            assert!(run.err.contains(words) && run.err.contains("cargo install --path crates/cli"), "{}", run.err);
            assert!(!file.exists());
        }
    }
}

#[test]
fn the_help_says_so_too() {
    for (language, words) in [("en", "not in this build"), ("de", "in dieser Ausführung nicht enthalten")] {
        for arguments in [["--help"].as_slice(), &["report", "--help"], &["size", "--help"]] {
            let run = run(&[arguments, &["--lang", language]].concat());
            let said = run.out.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(run.code == 0 && said.contains(words), "{arguments:?} {language}: {}", run.out);
        }
    }
}

#[test]
fn everything_else_is_there() {
    let run = run(&["size", "examples/indexing-table.toml", "--top", "1"]);
    assert!(run.code == 0 && run.err.starts_with("\nfurther calls:\n"), "{}", run.err);
}
