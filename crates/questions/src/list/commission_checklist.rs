//! `commission CODE --checklist FILE`: the checklists as a form to fill in; a face typesets it.

use super::given::{arguments, code, some};
use super::{CODE, Entry, Gives, Inquiry, OutputFile, Reads, Unanswered, commission, media};
use crate::answer;
use crate::commission::{DriveForm, usual_ambient};
use order_code::OrderCode;
use quantities::ThermodynamicTemperature;
use words::{help, requests};

arguments! {
    /// Arguments of `commission --checklist`: actuator, temperature of the measurement.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// Temperature of winding and sensors.
        ambient: Option<ThermodynamicTemperature> = commission::AMBIENT => some(commission::read_ambient),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "commission --checklist",
    path: "commission/checklist",
    about: requests::commission_checklist,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::PDF]),
    writes: &[OutputFile::of("checklist", &[media::PDF], help::commission_checklist)],
    example: "",
    answer: None,
};

/// Returns the sheet that contains the checklists.
///
/// # Errors
/// Every fault of the arguments; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<answers::Commissioning, Unanswered> {
    let Args { code, ambient } = Args::read(&inquiry.given)?;
    let ambient = ambient.unwrap_or_else(usual_ambient);
    Ok(answer::commissioning(&commission::about(&code)?, DriveForm::Plain, ambient, inquiry.language))
}
