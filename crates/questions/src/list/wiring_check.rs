//! `wiring CODE --check FILE`: a list of pins compared with the manual.

use super::given::{arguments, code};
use super::{Answer, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::sizing_use::Refusal;
use crate::wiring::read_list;
use answers::WiringCheck;
use installation::wiring::{LISTED_BYTES_MAX, wiring};
use order_code::OrderCode;
use words::{file_trouble, requests};

arguments! {
    /// Arguments of `wiring --check`: the actuator.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "wiring --check",
    path: "wiring",
    about: requests::pins_compared,
    reads: Reads::Pins,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::WiringCheck>("wiring --check")),
    writes: &[],
    example: "",
    answer: Some(|inquiry| {
        let found = found(inquiry)?;
        let agrees = found.agrees;
        Ok(Answer::record(&found).fits(agrees))
    }),
};

/// Compares the list with the manual.
///
/// # Errors
/// Faults of the code and of the list.
pub fn found(inquiry: &Inquiry<'_>) -> Result<WiringCheck, Unanswered> {
    let found = wiring(&Args::read(&inquiry.given)?.code).ok_or(Refusal::NoData)?;
    let source = inquiry.source()?;
    let refused = |message, is_too_large| Unanswered::File { name: source.name.clone(), message, is_too_large };
    if source.bytes.len() > LISTED_BYTES_MAX {
        return Err(refused(words::wiring::pin_list_too_large(&LISTED_BYTES_MAX, inquiry.language), true));
    }
    let read = read_list(&found, &source.bytes, inquiry.language);
    match read.map_err(|error| refused(file_trouble(&error, inquiry.language), false))? {
        Ok(comparison) => Ok(answer::wiring_check(&found, &comparison, inquiry.language)),
        Err((text, faults)) => Err(Unanswered::Text { name: source.name.clone(), text, faults }),
    }
}
