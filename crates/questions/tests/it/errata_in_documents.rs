//! The documents that claim to list errata list all of them.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use std::path::Path;

fn document(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap()
}

#[test]
fn every_value_that_checks_replace_is_in_the_concept_of_numbers() {
    let page = document("docs/concepts/numbers.md");
    let named: Vec<&str> = page.split(|c: char| c == '|' || c == ',' || c.is_whitespace()).collect();
    let replaced = || catalogue::errata().iter().filter(|erratum| erratum.checks_use.is_some());
    assert!(replaced().count() > 10);
    for erratum in replaced() {
        assert!(named.contains(&erratum.id), "{} is not in docs/concepts/numbers.md", erratum.id);
        assert!(page.contains(&erratum.checks_use.unwrap().replace(',', ".")), "{}", erratum.id);
    }
}

#[test]
fn every_corrected_value_is_in_the_changelog() {
    let page = document("CHANGELOG.md");
    let corrected = |erratum: &&catalogue::Erratum| {
        erratum.corrected_here
            && erratum.kind != catalogue::ErratumKind::Recovery
            && erratum.corrected != erratum.printed
    };
    for erratum in catalogue::errata().iter().filter(corrected) {
        assert!(page.contains(erratum.id), "{} is not in CHANGELOG.md", erratum.id);
    }
}
