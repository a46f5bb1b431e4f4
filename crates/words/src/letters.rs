//! Rules of typesetting: words that stay with a number, and places where a long word may be divided.

/// Returns `true` if a number after the word belongs to it, as in "table 12.1", and stays on its line.
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

/// Returns `true` if a letter is a vowel in either language.
#[must_use]
pub fn is_vowel(letter: char) -> bool {
    "aeiouyäöüAEIOUYÄÖÜ".contains(letter)
}
