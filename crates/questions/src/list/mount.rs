//! `mount CODE`: mounting of an actuator under the limits of the manual.

use super::given::{arguments, code_among, some};
use super::{Answer, Argument, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
pub use crate::mount::joint_loads;
use crate::mount::read_bore;
use crate::sizing_use::Refusal;
use answers::{Fit, Mount};
use installation::fit::Bore;
pub use installation::mount::{MountInputs, mount};
use order_code::OrderCode;
use quantities::Language;
use words::help;
use words::help::values;

pub(super) const BORE: Argument = Argument::option("bore", values::bore, help::mount_bore).signed();
pub(super) const BORE_LOAD: Argument = Argument::option("bore-load", values::bore, help::mount_bore_load).signed();
pub(super) const BORE_HOUSING: Argument =
    Argument::option("bore-housing", values::bore, help::mount_bore_housing).signed();

arguments! {
    /// Arguments of `mount`: actuator and bores.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code_among,
        /// Bore over both pilots.
        bore: Option<Bore> = BORE => some(read_bore),
        /// Bore of the load.
        bore_load: Option<Bore> = BORE_LOAD => some(read_bore),
        /// Bore of the machine.
        bore_housing: Option<Bore> = BORE_HOUSING => some(read_bore),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "mount",
    path: "mount",
    about: help::mount,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Mount>("mount")),
    writes: &[],
    example: "CHA-25A-100-H-M512P-B --bore K7",
    answer: Some(|inquiry| found(inquiry).map(|found| mounted(&found))),
};

pub(super) fn bores(both: Option<Bore>, load: Option<Bore>, housing: Option<Bore>, under: MountInputs) -> MountInputs {
    MountInputs { bore_load: load.or(both), bore_housing: housing.or(both), ..under }
}

pub(super) fn mounted(found: &Mount) -> Answer {
    Answer::record(found).fits(found.verdict == Fit::Fits)
}

/// Returns the mounting of the actuator.
///
/// # Errors
/// Every fault of the arguments; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Mount, Unanswered> {
    let Args { code, bore, bore_load, bore_housing } = Args::read(&inquiry.given)?;
    let question = bores(bore, bore_load, bore_housing, MountInputs::default());
    under(&code, &question, None, inquiry.language)
}

/// Returns the mounting of an actuator, under the loads of an axis if one is named.
pub(super) fn under(
    code: &OrderCode,
    question: &MountInputs,
    axis: Option<&str>,
    language: Language,
) -> Result<Mount, Unanswered> {
    let found = mount(code, question).ok_or(Refusal::NoData)?;
    Ok(answer::mount(&found, question, axis, language))
}
