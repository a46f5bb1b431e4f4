//! Facts in prose, each with its signal word and source.

use crate::table::paragraph;
use workbench::Language;
use workbench::answers::Fact;
use workbench::text::signal_word;

/// The facts as paragraphs.
pub(crate) fn facts_text(facts: &[Fact], language: Language) -> String {
    let word = |fact: &Fact| fact.signal.map_or("", |signal| signal_word(*signal, language));
    let widest = facts.iter().map(|fact| word(fact).chars().count()).max().unwrap_or(0);
    let line =
        |fact: &Fact| paragraph(&format!("{:<widest$}  ", word(fact)), &format!("{} ({})", fact.text, fact.source));
    facts.iter().map(line).collect()
}
