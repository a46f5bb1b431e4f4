//! Words of a call as they are typed: those of a shell, numbers with their units.

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

/// Splits a number from its unit.
pub(crate) fn number_and_unit(text: &str) -> (&str, &str) {
    let is_number = |sign: char| sign.is_ascii_digit() || ".,+-".contains(sign);
    let end = text.find(|sign| !is_number(sign)).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    (number, unit.trim())
}

/// Returns `true` if a word is a number with a minus sign, and no option.
pub(super) fn is_negative(word: &str) -> bool {
    word.strip_prefix('-').is_some_and(|rest| rest.starts_with(|sign: char| sign.is_ascii_digit() || sign == '.'))
}
