//! The reference pages of the glossary say what its data say.
#![allow(missing_docs, clippy::unwrap_used, reason = "a test fails loudly")]

use quantities::Language;

fn pages() -> [(&'static str, String); 2] {
    [("glossary.md", Language::En), ("glossar.md", Language::De)]
        .map(|(file, language)| (file, words::glossary_page(language)))
}

#[test]
fn the_pages_are_those_of_the_data() {
    for (file, page) in pages() {
        testkit::generated::is_current(&format!("docs/reference/{file}"), &page);
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
