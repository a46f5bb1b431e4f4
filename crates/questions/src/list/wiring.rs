//! `wiring CODE`: connectors, pins and cables.

use super::given::{arguments, code, some};
use super::{Answer, Argument, CODE, Entry, Gives, Inquiry, PICTURE, Reads, Record, Unanswered};
use crate::answer;
use crate::sizing_use::Refusal;
use crate::wiring::{cable_length, cross_section};
pub use installation::wiring::{CodeWiring, Connector, Role, SignalGroup, wiring};
use order_code::OrderCode;
use quantities::{Area, Length};
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `wiring`: actuator and cable.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// Length of the cable.
        length: Option<Length> = Argument::option("length", values::length, help::wiring_length) => some(cable_length),
        /// Cross-section of its wires.
        cross_section: Option<Area> = Argument::option("cross-section", values::area, help::wiring_section)
            .with("length") => some(cross_section),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "wiring",
    path: "wiring",
    about: help::wiring,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Wiring>("wiring")),
    writes: &PICTURE,
    example: "CHA-25A-100-H-M512P-B --check pins.csv",
    answer: Some(|inquiry| Ok(Answer::record(&found(inquiry)?.1))),
};

/// Returns the wiring, and its record.
///
/// # Errors
/// Every fault of the arguments; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(CodeWiring, answers::Wiring), Unanswered> {
    let Args { code, length, cross_section } = Args::read(&inquiry.given)?;
    let found = wiring(&code).ok_or(Refusal::NoData)?;
    let record = answer::wiring(&found, length.map(|length| (length, cross_section)), inquiry.language);
    Ok((found, record))
}
