//! `commission CODE --record FILE`: measured values, judged.

use super::given::{arguments, code};
use super::{Answer, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered, commission};
use crate::answer;
pub use crate::commission::{judge, measured};
use crate::reading::Unread;
use answers::{Fit, Recorded};
use order_code::OrderCode;
use words::requests;

arguments! {
    /// Arguments of `commission --record`: the actuator.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "commission --record",
    path: "commission",
    about: requests::measured_judged,
    reads: Reads::Measured,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Recorded>("commission --record")),
    writes: &[],
    example: "",
    answer: Some(|inquiry| {
        let found = found(inquiry)?;
        Ok(Answer::record(&found).fits(found.verdict == Fit::Fits))
    }),
};

/// Returns the measured values with their verdicts.
///
/// # Errors
/// Faults of the code and of the record.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Recorded, Unanswered> {
    let about = commission::about(&Args::read(&inquiry.given)?.code)?;
    let source = inquiry.source()?;
    let text = source.text(inquiry.language)?;
    let measured = measured(text)
        .map_err(|faults| Unanswered::unread(Unread::Faults(faults), &source.name, text, inquiry.language))?;
    Ok(answer::recorded(&about, &judge(&about, &measured), inquiry.language))
}
