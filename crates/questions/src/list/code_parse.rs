//! `code parse CODE`: meaning of an ordering code, field by field.

use super::given::{arguments, text};
use super::{Answer, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
pub use crate::codes::explain_code;
use crate::codes::{CodeReading, read_code};
pub use configurator::uncovered;
use words::help;

arguments! {
    /// Arguments of `code parse`: the code.
    pub struct Args {
        /// The code in the spelling of the user.
        code: Option<String> = super::Argument { about: help::code_example, ..CODE } => text,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "code parse",
    path: "code/parse",
    about: help::code_parse,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::CodeReading>("code parse")),
    writes: &[],
    example: "CHA-20A-100-H-C1024-B",
    answer: Some(|inquiry| Ok(Answer::record(&answer::code_reading(&reading(inquiry)?, inquiry.language)))),
};

/// Reads the code.
///
/// # Errors
/// The reason why the text is no code.
pub fn reading(inquiry: &Inquiry<'_>) -> Result<CodeReading, Unanswered> {
    let text = Args::read(&inquiry.given)?.code.unwrap_or_default();
    read_code(&text, inquiry.language).map_err(|refusal| Unanswered::Code { text, refusal, among: false })
}
