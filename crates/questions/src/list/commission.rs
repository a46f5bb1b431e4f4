//! `commission CODE`: values for the drive, and check-lists.

use super::given::{arguments, by_id, code, some, word};
use super::{Answer, Argument, ArgumentKind, Asked, CODE, Entry, Gives, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_quantity;
pub use crate::commission::{Commissioning, DriveForm, commission, usual_ambient};
use crate::sizing_use::Refusal;
use answers::CommissionAnswer;
use order_code::OrderCode;
use quantities::ThermodynamicTemperature;
use words::help;
use words::help::values;

pub(super) const FORM: Argument = Argument::option("for", values::drive, help::commission_for);
pub(super) const AMBIENT: Argument =
    Argument::option("ambient", values::temperature, help::commission_ambient).signed();

arguments! {
    /// An actuator, the drive, where it is measured.
    pub struct Args {
        /// Its code.
        code: OrderCode = CODE => code,
        /// The form of the values.
        form: Option<DriveForm> = FORM.of(ArgumentKind::Word(|| DriveForm::ALL.map(DriveForm::id).to_vec()))
            => word(by_id(&DriveForm::ALL, DriveForm::id)),
        /// Temperature of winding and sensors.
        ambient: Option<ThermodynamicTemperature> = AMBIENT => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "commission",
    path: "commission",
    about: help::commission,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::CommissionAnswer>("commission")),
    writes: &[],
    example: "CHA-25A-100-H-M512P-B --for sinamics",
    answer: Some(|asked| {
        let (sheet, objects) = found(asked)?;
        let is_objects = Args::read(&asked.given)?.form == Some(DriveForm::Cia402);
        Ok(Answer::record(&if is_objects {
            CommissionAnswer::Objects(objects)
        } else {
            CommissionAnswer::Sheet(Box::new(sheet))
        }))
    }),
};

/// The sheet of values, with the objects of CiA 402 where that is their form.
///
/// # Errors
/// Every fault of the arguments; no printed data.
pub fn found(asked: &Asked<'_>) -> Result<(answers::Commissioning, Vec<answers::DriveObject>), Unanswered> {
    let Args { code, form, ambient } = Args::read(&asked.given)?;
    let about = about(&code)?;
    let form = form.unwrap_or(DriveForm::Plain);
    let objects = if form == DriveForm::Cia402 { answer::drive_objects(&about, asked.language) } else { Vec::new() };
    Ok((answer::commissioning(&about, form, ambient.unwrap_or_else(usual_ambient), asked.language), objects))
}

/// What is known for the commissioning of a code.
///
/// # Errors
/// No printed data.
pub fn about(code: &OrderCode) -> Result<Commissioning, Unanswered> {
    Ok(commission(code).ok_or(Refusal::NoData)?)
}
