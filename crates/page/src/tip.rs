//! Explanations of terms: a button whose explanation is shown while it is pointed at or has the focus.

use crate::chapters::symbol;
use maud::{Markup, html};
use quantities::Language;
use questions::list::glossary::{meaning_of_symbol, meaning_of_word};
use words::capitalised;

/// Returns a symbol with its meaning.
pub(crate) fn of_symbol(name: &str, language: Language) -> Markup {
    with(&symbol(name), meaning_of_symbol(name, language).as_deref())
}

/// Returns a word with an upper-case first letter, with its meaning if the glossary has it.
pub(crate) fn of_word(word: &str, language: Language) -> Markup {
    with(&html! { (capitalised(word)) }, meaning_of_word(word, language))
}

fn with(shown: &Markup, meaning: Option<&str>) -> Markup {
    html! { @match meaning {
        Some(meaning) => span.tip { button.term type="button" { (shown) span.tip-text role="tooltip" { (meaning) } } },
        None => (shown),
    } }
}
