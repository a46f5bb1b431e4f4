//! Words of a call as they are typed into a shell.

/// Returns the words of a call as they are typed: those with spaces or signs of a shell between quotes.
pub(crate) fn typed<'w>(words: impl IntoIterator<Item = &'w str>) -> String {
    let quoted = |word: &str| {
        let is_plain = |sign: char| sign.is_alphanumeric() || "-_./=:,+@%".contains(sign);
        match word {
            "" => "\"\"".to_owned(),
            _ if word.chars().all(is_plain) => word.to_owned(),
            _ if word.contains('"') => format!("'{word}'"),
            _ => format!("\"{word}\""),
        }
    };
    words.into_iter().map(quoted).collect::<Vec<_>>().join(" ")
}
