//! Upkeep of an actuator: the question from outside.

use chrono::NaiveDate;
use installation::calendar::{Interval, read_date as date, read_interval as interval};
use installation::upkeep::{Storage, Upkeep, UpkeepAsked};
use order_code::OrderCode;
use quantities::Language;
use words::upkeep::{date_fault, interval_fault, upkeep_fault};

/// A fault of an option: its name, what is wrong, and what would be right.
pub(crate) type OptionFault = (&'static str, String, Option<String>);

/// The plan of an actuator.
///
/// # Errors
/// The option concerned, what is wrong with it, and a hint.
pub fn upkeep(code: &OrderCode, asked: &UpkeepAsked, language: Language) -> Result<Upkeep, OptionFault> {
    installation::upkeep::upkeep(code, asked).map_err(|fault| upkeep_fault(&fault, language))
}

/// Reads a day of the command line.
///
/// # Errors
/// What is wrong with the text, and a hint.
pub fn read_date(text: &str, language: Language) -> Result<NaiveDate, (String, Option<String>)> {
    date(text).map_err(|fault| date_fault(&fault, language))
}

/// The day so many days after the first of 1970, as clocks count; `None` beyond the calendar.
#[must_use]
pub fn day_of_clock(days: u64) -> Option<NaiveDate> {
    NaiveDate::default().checked_add_days(chrono::Days::new(days))
}

/// Reads an interval of the command line.
///
/// # Errors
/// What is wrong with the text, and a hint.
pub fn read_interval(text: &str, language: Language) -> Result<Interval, (String, Option<String>)> {
    interval(text).map_err(|fault| interval_fault(&fault, language))
}

/// Reads a storage of the command line: a time, or the day on which it ends.
///
/// # Errors
/// What is wrong with the text, and a hint.
pub(crate) fn read_storage(text: &str, language: Language) -> Result<Storage, (String, Option<String>)> {
    // A day has a dash where a time has a unit.
    let is_day = text.trim().get(1..).is_some_and(|rest| rest.contains('-'));
    if is_day { read_date(text, language).map(Storage::Until) } else { read_interval(text, language).map(Storage::For) }
}
