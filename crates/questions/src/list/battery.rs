//! `battery`: the life of the battery of a buffered encoder.

use super::given::{arguments, one, some};
use super::{Answer, Argument, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::{battery, read_hours, read_quantity};
use actuator::BatteryLife;
use quantities::{Measure, Time};
use words::{help, help::values};

arguments! {
    /// Arguments of `battery`: operation and storage of an actuator.
    pub struct Args {
        /// Hours of operation a day.
        hours_per_day: Time = Argument::option("hours-per-day", values::hours, help::battery_hours).required()
            => one(read_hours),
        /// Storage before operation.
        storage: Option<Time> = Argument::option("storage", values::time, help::battery_storage)
            => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "battery",
    path: "battery",
    about: help::battery,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Battery>("battery")),
    writes: &[],
    example: "--hours-per-day 10",
    answer: Some(|inquiry| Ok(Answer::record(&answer::battery(&found(inquiry)?)))),
};

/// Returns the life of the battery.
///
/// # Errors
/// Every fault of the arguments.
pub fn found(inquiry: &Inquiry<'_>) -> Result<BatteryLife, Unanswered> {
    let Args { hours_per_day, storage } = Args::read(&inquiry.given)?;
    let storage = storage.unwrap_or_else(|| Time::from_si(0.0));
    battery(&inquiry.catalogue.battery(), hours_per_day, storage, inquiry.language)
        .map_err(|message| Unanswered::option("hours-per-day", (message, None)))
}
