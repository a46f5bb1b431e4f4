//! `commission CODE --record FILE`: measured values, judged.

use super::given::{arguments, code};
use super::{Answer, Asked, CODE, Entry, Gives, Reads, Record, Unanswered, commission};
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
    answer: Some(|asked| {
        let found = found(asked)?;
        Ok(Answer::record(&found).fits(found.verdict == Fit::Fits))
    }),
};

/// Returns the measured values with their verdicts.
///
/// # Errors
/// Faults of the code and of the record.
pub fn found(asked: &Asked<'_>) -> Result<Recorded, Unanswered> {
    let about = commission::about(&Args::read(&asked.given)?.code)?;
    let source = asked.source()?;
    let text = source.text(asked.language)?;
    let measured = measured(text)
        .map_err(|faults| Unanswered::unread(Unread::Faults(faults), &source.name, text, asked.language))?;
    Ok(answer::recorded(&about, &judge(&about, &measured), asked.language))
}
