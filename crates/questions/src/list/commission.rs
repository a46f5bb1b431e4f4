//! `commission CODE`: values for the drive, and checklists.

use super::given::{arguments, by_id, code, some, word};
use super::{Answer, Argument, ArgumentKind, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_quantity;
pub use crate::commission::{Commissioning, DriveForm, commission, usual_ambient};
use crate::sizing_use::Refusal;
use answers::CommissionAnswer;
use order_code::OrderCode;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{Language, Measure, ThermodynamicTemperature};
use words::help;
use words::help::values;
use words::spoken::DRIVES;
use words::{commission as texts, simulation};

pub(super) const FORM: Argument = Argument::option("for", values::drive, help::commission_for);
pub(super) const AMBIENT: Argument =
    Argument::option("ambient", values::temperature, help::commission_ambient).signed();

arguments! {
    /// Arguments of `commission`: actuator, drive, temperature of the measurement.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// The form of the values.
        form: Option<DriveForm> = FORM.of(ArgumentKind::Word(|| DriveForm::ALL.map(DriveForm::id).to_vec())).titled(drives)
            => word(by_id(&DriveForm::ALL, DriveForm::id)),
        /// Temperature of winding and sensors.
        ambient: Option<ThermodynamicTemperature> = AMBIENT => some(read_ambient),
    }
}

/// Returns the names of drives and of their interfaces, each with the form of its values.
fn drives() -> Vec<(String, &'static str)> {
    let of = |(form, names): &(&'static str, &[&str])| {
        let form = *form;
        names.iter().map(move |name| ((*name).to_owned(), form)).collect::<Vec<_>>()
    };
    DRIVES.iter().flat_map(of).collect()
}

/// Temperatures at which a winding is measured \[°C\]: a choice, wider than any place where an actuator is permitted, and within the
/// range in which the resistance of copper is linear.
const AMBIENT_C: std::ops::RangeInclusive<f64> = -50.0..=150.0;

/// Reads the temperature at which winding and sensors are measured.
///
/// # Errors
/// A text that is no temperature; one at which no measurement is made.
pub(super) fn read_ambient(
    text: &str,
    language: Language,
) -> Result<ThermodynamicTemperature, (String, Option<String>)> {
    let found: ThermodynamicTemperature = read_quantity(text, language)?;
    if AMBIENT_C.contains(&found.in_unit(&DEGREE_CELSIUS)) {
        return Ok(found);
    }
    let [low, high] = [AMBIENT_C.start(), AMBIENT_C.end()].map(|end| format!("{end} °C"));
    Err((simulation::refused_range(&"ambient", language), Some(texts::between(&low, &high, language))))
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
    answer: Some(|inquiry| {
        let (sheet, objects) = found(inquiry)?;
        let is_objects = Args::read(&inquiry.given)?.form == Some(DriveForm::Cia402);
        Ok(Answer::record(&if is_objects {
            CommissionAnswer::Objects(objects)
        } else {
            CommissionAnswer::Sheet(Box::new(sheet))
        }))
    }),
};

/// Returns the sheet of values, with the objects of CiA 402 if this form is requested.
///
/// # Errors
/// Every fault of the arguments; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(answers::Commissioning, Vec<answers::DriveObject>), Unanswered> {
    let Args { code, form, ambient } = Args::read(&inquiry.given)?;
    let about = about(&code)?;
    let form = form.unwrap_or(DriveForm::Plain);
    let objects = if form == DriveForm::Cia402 { answer::drive_objects(&about, inquiry.language) } else { Vec::new() };
    Ok((answer::commissioning(&about, form, ambient.unwrap_or_else(usual_ambient), inquiry.language), objects))
}

/// Returns the data for the commissioning of a code.
///
/// # Errors
/// No data in the manual.
pub fn about(code: &OrderCode) -> Result<Commissioning, Unanswered> {
    Ok(commission(code).ok_or(Refusal::NoData)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ambient_at_which_nobody_measures_is_refused() {
        let read = |text: &str| read_ambient(text, Language::En);
        for text in ["-50 degC", "20 degC", "150 degC"] {
            assert!(read(text).is_ok(), "{text}");
        }
        for text in ["-51 degC", "-300 degC", "151 degC", "1e300 degC", "-1 K"] {
            let (message, hint) = read(text).unwrap_err();
            assert!(message.contains("out of range") && hint.unwrap() == "-50 °C to 150 °C", "{text}: {message}");
        }
    }
}
