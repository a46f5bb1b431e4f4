//! `data CODE`: the data sheet of an actuator.

use super::given::{arguments, code};
use super::{Answer, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
pub use crate::sheet::{Sheet, SheetMarks, SheetNote, SheetSection, sheet};
use crate::sizing_use::Refusal;
use order_code::OrderCode;
use words::help;

arguments! {
    /// Arguments of `data`: the actuator.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "data",
    path: "data",
    about: help::data,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Sheet>("data")),
    writes: &[],
    example: "CHA-20A-100-H-C1024",
    answer: Some(|inquiry| Ok(Answer::record(&answer::sheet(&found(inquiry)?, inquiry.language)))),
};

/// Returns the data sheet.
///
/// # Errors
/// Faults of the code; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Sheet, Unanswered> {
    Ok(sheet(&Args::read(&inquiry.given)?.code).ok_or(Refusal::NoData)?)
}
