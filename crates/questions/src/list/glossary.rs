//! `glossary`: words and symbols with their meaning.

use super::given::{arguments, label};
use super::{Answer, Argument, ArgumentForm, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer::not_in_glossary;
pub use crate::glossary::{glossary, meaning_of_symbol, meaning_of_word};
use answers::Glossary;
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `glossary`: the term.
    pub struct Args {
        /// A symbol, a name or a word; all terms without it.
        term: Option<String> = Argument::option("term", values::term, help::glossary_term).form(ArgumentForm::Words) => label,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "glossary",
    path: "glossary",
    about: help::glossary,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Glossary>("glossary")),
    writes: &[],
    example: "T_rms",
    answer: Some(|inquiry| Ok(Answer::record(&found(inquiry)?))),
};

/// Returns the terms.
///
/// # Errors
/// If there is no term with this name.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Glossary, Unanswered> {
    let term = Args::read(&inquiry.given)?.term;
    let wanted = term.as_deref();
    glossary(wanted, inquiry.language)
        .map_err(|nearest| Unanswered::Message(not_in_glossary(wanted.unwrap_or_default(), &nearest, inquiry.language)))
}
