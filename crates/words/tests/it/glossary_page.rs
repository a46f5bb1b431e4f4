//! The reference pages of the glossary say what its data say.
#![allow(missing_docs, clippy::unwrap_used, reason = "a test fails loudly")]

use quantities::Language;
use std::path::Path;

fn pages() -> [(&'static str, String); 2] {
    [("glossary.md", Language::En), ("glossar.md", Language::De)]
        .map(|(file, language)| (file, words::glossary_page(language)))
}

#[test]
fn the_pages_are_those_of_the_data() {
    for (file, page) in pages() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference").join(file);
        if std::env::var_os("INSTA_UPDATE").is_some_and(|value| value == "always") {
            std::fs::write(&path, &page).unwrap();
        }
        let stored = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(stored == page, "docs/reference/{file} is out of date: cargo xtask snapshots writes it anew");
    }
}

#[test]
fn every_word_and_every_term_stands_there_in_both_languages() {
    for (file, page) in pages() {
        let terms = catalogue::glossary().iter().map(|term| (format!("`{}`", term.symbol), term.en, term.de));
        let words = catalogue::words().iter().map(|word| (String::new(), word.en, word.de));
        for (symbol, en, de) in terms.chain(words) {
            let line = page
                .lines()
                .find(|line| line.starts_with(&format!("| {symbol}")) && line.contains(&format!("| {en} | {de} |")));
            assert!(line.is_some(), "{file}: {symbol} {en} {de}");
        }
    }
}
