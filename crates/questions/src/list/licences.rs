//! `licences`: whose work the program is, and under which terms.

use super::given::arguments;
use super::{Answer, Entry, Gives, Reads, Record};
pub use crate::licences::licences;
use words::help;

arguments! {
    /// Nothing.
    pub struct Args {
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "licences",
    path: "licences",
    about: help::licences,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Licences>("licences")),
    writes: &[],
    example: "",
    answer: Some(|_| Ok(Answer::record(&licences()))),
};
