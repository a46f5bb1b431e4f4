//! `code complete CODE`: completions of a partial code.

use super::given::{arguments, begun};
use super::{Answer, Argument, ArgumentKind, CODE, Entry, Gives, Reads, Record, Unanswered};
use crate::answer;
pub use crate::codes::completion;
use crate::codes::list_codes;
use order_code::Pattern;
use words::help;

arguments! {
    /// Arguments of `code complete`: the partial code.
    pub struct Args {
        /// The partial code.
        code: Option<Pattern> =
            Argument { about: help::code_complete_pattern, ..CODE }.of(ArgumentKind::Text) => begun,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "code complete",
    path: "code/complete",
    about: help::code_complete,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Completion>("code complete")),
    writes: &[],
    example: "CHA-14A-100-N",
    answer: Some(|asked| {
        let pattern = pattern_of(&asked.given)?;
        let codes = list_codes(Some(&pattern));
        Ok(Answer::record(&answer::completion(&pattern, &codes, asked.language)))
    }),
};

/// Returns the partial code.
///
/// # Errors
/// The reason why the text is no partial code.
pub fn pattern_of(given: &super::Given) -> Result<Pattern, Unanswered> {
    Args::read(given)?.code.ok_or(Unanswered::Refused(crate::Refusal::NoData, None))
}
