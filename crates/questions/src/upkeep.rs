//! Maintenance of an actuator: reading of the request.

use chrono::NaiveDate;
use installation::calendar::{Interval, read_date as date, read_interval as interval};
use installation::upkeep::{Storage, Upkeep, UpkeepInputs};
use order_code::OrderCode;
use quantities::Language;
use words::upkeep::{date_fault, interval_fault, upkeep_fault};

/// A fault of an option: name, fault, remedy.
pub(crate) type OptionFault = (&'static str, String, Option<String>);

/// Returns the maintenance plan of an actuator.
///
/// # Errors
/// The option concerned, its fault, and a hint.
pub fn upkeep(code: &OrderCode, asked: &UpkeepInputs, language: Language) -> Result<Upkeep, OptionFault> {
    installation::upkeep::upkeep(code, asked).map_err(|fault| upkeep_fault(&fault, language))
}

/// Reads a day from the command line.
///
/// # Errors
/// The fault of the text, and a hint.
pub fn read_date(text: &str, language: Language) -> Result<NaiveDate, (String, Option<String>)> {
    date(text).map_err(|fault| date_fault(&fault, language))
}

/// Returns the day with this number of days after 1 January 1970, as clocks count; `None` beyond the calendar.
#[must_use]
pub fn day_of_clock(days: u64) -> Option<NaiveDate> {
    NaiveDate::default().checked_add_days(chrono::Days::new(days))
}

/// Reads an interval from the command line.
///
/// # Errors
/// The fault of the text, and a hint.
pub fn read_interval(text: &str, language: Language) -> Result<Interval, (String, Option<String>)> {
    interval(text).map_err(|fault| interval_fault(&fault, language))
}

/// Reads a storage from the command line: a time, or the day on which it ends.
///
/// # Errors
/// The fault of the text, and a hint.
pub(crate) fn read_storage(text: &str, language: Language) -> Result<Storage, (String, Option<String>)> {
    // A day contains a dash, a time has a unit.
    let is_day = text.trim().get(1..).is_some_and(|rest| rest.contains('-'));
    if is_day { read_date(text, language).map(Storage::Until) } else { read_interval(text, language).map(Storage::For) }
}
