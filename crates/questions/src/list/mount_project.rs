//! `mount CODE --project FILE`: mounting of an actuator under the loads of a project.

use super::given::{arguments, code_among, some, text};
use super::mount::{BORE, BORE_HOUSING, BORE_LOAD, bores, mounted};
use super::{AXIS, CODE, Cost, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer::assumptions;
use crate::mount::{joint_loads, read_bore};
use answers::Mount;
use installation::fit::Bore;
use installation::mount::MountInputs;
use order_code::OrderCode;
use words::requests;

arguments! {
    /// Arguments of `mount --project`: actuator, bores, axis.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code_among,
        /// Bore over both pilots.
        bore: Option<Bore> = BORE => some(read_bore),
        /// Bore of the load.
        bore_load: Option<Bore> = BORE_LOAD => some(read_bore),
        /// Bore of the machine.
        bore_housing: Option<Bore> = BORE_HOUSING => some(read_bore),
        /// The axis of a project with several.
        axis: Option<String> = AXIS.with("project") => text,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "mount --project",
    path: "mount",
    about: requests::mounted_in_project,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Mount>("mount")),
    writes: &[],
    example: "",
    answer: Some(|inquiry| found(inquiry).map(|found| mounted(&found))),
};

/// Returns the mounting of the actuator.
///
/// # Errors
/// Every fault of the arguments, else those of the project.
pub fn found(inquiry: &Inquiry<'_>) -> Result<Mount, Unanswered> {
    let Args { code, bore, bore_load, bore_housing, axis } = Args::read(&inquiry.given)?;
    let (_, project) = inquiry.axis(axis.as_deref(), Cost::Other)?;
    let loads = MountInputs { axis: joint_loads(&project, &code)?, ..MountInputs::default() };
    let question = bores(bore, bore_load, bore_housing, loads);
    let found = super::mount::under(&code, &question, Some(&project.name), inquiry.language)?;
    Ok(Mount { assumptions: assumptions(&project, inquiry.language), ..found })
}
