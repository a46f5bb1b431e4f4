//! Kinds of new projects by their names.

use questions::list::{ArgumentKind, new};

/// Largest number of words in the name of a kind.
const KIND_MOST: usize = 3;

/// Returns the kind of a new file at the beginning of some words, and the number of words that name it.
pub(super) fn kind(words: &[&str]) -> Option<(String, usize)> {
    let argument = new::Args::ARGUMENTS.iter().find(|argument| matches!(argument.kind, ArgumentKind::Word(_)))?;
    let (kind, count) = (1..=words.len().min(KIND_MOST)).rev().find_map(|count| {
        let title = words.get(..count)?.join(" ");
        Some((argument.word(&title)?.to_owned(), count))
    })?;
    // A second word for the same kind states nothing else: `rotary table disc`.
    let further = words.iter().skip(count).take_while(|word| argument.word(word) == Some(&*kind)).count();
    Some((kind, count + further))
}
