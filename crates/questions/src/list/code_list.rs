//! `code list`: the valid codes.

use super::given::{arguments, flag, pattern};
use super::{Answer, Argument, ArgumentForm, Entry, Gives, Reads, Record};
use crate::answer;
pub use crate::codes::{list_codes, read_pattern};
pub use configurator::Availability;
use order_code::{OrderCode, Pattern};
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `code list`: selection of the codes.
    pub struct Args {
        /// A partial code.
        pattern: Option<Pattern> =
            Argument::option("pattern", values::pattern, help::code_list_pattern).form(ArgumentForm::Bare) => pattern,
        /// Restricts the list to codes without fields on request.
        available: bool = Argument::flag("available", help::code_list_available) => flag,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "code list",
    path: "code/list",
    about: help::code_list,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<Vec<answers::ListedCode>>("code list")),
    writes: &[],
    example: "CHA-20A-*-H --available",
    answer: Some(|asked| {
        let found = Args::read(&asked.given)?.codes();
        Ok(Answer::record(&answer::listed(&found, asked.language)).fits(!found.is_empty()))
    }),
};

impl Args {
    /// Returns the codes.
    #[must_use]
    pub fn codes(&self) -> Vec<&'static (OrderCode, Availability)> {
        let mut codes = list_codes(self.pattern.as_ref());
        codes.retain(|(_, found)| !self.available || found.is_available());
        codes
    }
}
