//! `upkeep CODE --ical FILE`: the maintenance plan as a calendar; a face writes it.

use super::given::{arguments, label};
use super::upkeep::{DELIVERED, HOURS, INSPECT, STORAGE, TODAY};
use super::{Argument, CODE, Entry, Gives, Inquiry, OutputFile, Reads, Unanswered, media};
use installation::upkeep::Upkeep;
use words::{help, help::values, requests};

const NAME: Argument = Argument::option("name", values::text, help::upkeep_name);

arguments! {
    /// Arguments of `upkeep --ical`: those of the plan, and a name.
    pub struct Args {
        /// The name of the actuator in the calendar.
        name: Option<String> = NAME => label,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "upkeep --ical",
    path: "upkeep/calendar",
    about: requests::upkeep_calendar,
    reads: Reads::Nothing,
    arguments: &[CODE, DELIVERED, STORAGE, HOURS, INSPECT, TODAY, NAME],
    gives: Gives::Media(&[media::CALENDAR]),
    writes: &[OutputFile::of("ical", &[media::CALENDAR], help::upkeep_ical)],
    example: "",
    answer: None,
};

/// Returns the plan, its record, and the name of the actuator.
///
/// # Errors
/// Every fault of the arguments; a delivery in the future.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(Upkeep, answers::Upkeep, Option<String>), Unanswered> {
    let name = Args::read(&inquiry.given)?.name;
    let (plan, record) = super::upkeep::found(inquiry)?;
    Ok((plan, record, name))
}
