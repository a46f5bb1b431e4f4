//! How words are set: what stays on one line, and where a long word may be cut.

/// Whether a number belongs to a word before it, as in "table 12.1", and stands on its line.
#[must_use]
pub fn stands_before_a_number(word: &str) -> bool {
    const WORDS: [&str; 12] = [
        "table",
        "Tabelle",
        "eq.",
        "Gl.",
        "section",
        "Abschnitt",
        "footnote",
        "Fußnote",
        "page",
        "Seite",
        "Teil",
        "part",
    ];
    WORDS.contains(&word)
}

/// Whether a letter is a vowel in either language.
#[must_use]
pub fn is_vowel(letter: char) -> bool {
    "aeiouyäöüAEIOUYÄÖÜ".contains(letter)
}
