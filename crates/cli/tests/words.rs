//! What a user reads, word by word. Rewritten by `cargo xtask snapshots`, read by eye.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

mod run;

use run::{run_with, shown};

macro_rules! shows {
    ($($name:ident: $arguments:expr;)*) => {$(
        #[test]
        fn $name() {
            let arguments: &[&str] = &$arguments;
            insta::assert_snapshot!(shown(arguments));
        }
    )*};
}

shows! {
    size_in_english: ["size", "examples/indexing-table.toml"];
    size_in_german: ["size", "examples/indexing-table.toml", "--lang", "de", "--top", "3"];
    size_with_every_reason: ["size", "examples/two-way-shuttle.toml", "--all"];
    check_of_the_worked_example: ["check", "examples/manual-example.toml"];
    check_that_fails_in_german: ["check", "examples/indexing-table.toml", "--code", "CHA-25A-50-H-M512P", "--lang", "de"];
    check_as_json: ["check", "examples/manual-example.toml", "--json"];
    code_explained: ["code", "parse", "CHA-20A-100-H-C1024-B-EC-K-SP"];
    code_understood_loosely: ["code", "parse", "cha", "20a", "100", "h", "c1024", "b", "--lang", "de"];
    code_with_three_faults: ["code", "parse", "CHA-21A-101-H-C1025"];
    code_that_breaks_rules: ["code", "parse", "CHA-14A-120-H-D2048-R", "--lang", "de"];
    code_as_json: ["code", "parse", "CHA-14A-100-N-D2048", "--json"];
    code_faults_as_json: ["code", "parse", "CHA-20A-100-L-C1024", "--json"];
    code_completed: ["code", "complete", "CHA-14A-100-N-*"];
    codes_listed: ["code", "list", "CHA-58A-160-H-M512P-B"];
    data_sheet: ["data", "CHA-25A-50-H-M512P-B"];
    data_sheet_in_german: ["data", "CHA-17A-80-E-D2048", "--lang", "de"];
    no_data: ["data", "CHA-58A-50-H-RES"];
    help_in_english: ["--help"];
    help_in_german: ["size", "--help", "--lang", "de"];
    unknown_command: ["siz", "x"];
    missing_file: ["size", "examples/none.toml"];
    schema: ["schema"];
}

#[test]
fn every_fault_of_a_project() {
    let text = "format = 1\n[load]\ninertia = \"1,3 kg m^2\"\nfriction = \"5 N m\"\n[[motion]]\nlaw = \"manuel\"\n\
                speed = 40\naccelerate = \"0.1 m\"\nrun = \"-0.1 s\"\nbrake = \"0.1\"\n[requirements]\nfeedback = [\"M512\"]\n";
    for language in ["en", "de"] {
        let run = run_with(&["size", "-", "--lang", language], text.as_bytes());
        assert_eq!(run.code, 2);
        assert_eq!(run.out, "");
        insta::assert_snapshot!(format!("every_fault_of_a_project_{language}"), run.err);
    }
}
