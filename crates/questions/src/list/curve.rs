//! `curve CODE`: the curves of the torque-speed plane.

use super::given::{arguments, product, some};
use super::{Answer, Argument, ArgumentForm, CODE, Entry, Gives, Inquiry, PICTURE, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_quantity;
use crate::plane::{Plane, plane_of};
use crate::sizing_use::{not_offered, without_datum};
use configurator::ProductId;
use quantities::ElectricPotential;
use words::{help, help::values};

arguments! {
    /// Arguments of `curve`: actuator and supply.
    pub struct Args {
        /// Ordering code of the actuator.
        code: ProductId = CODE.form(ArgumentForm::Bare) => product,
        /// Terminal voltage of the motor.
        voltage: Option<ElectricPotential> =
            Argument::option("voltage", values::voltage, help::curve_voltage) => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "curve",
    path: "curve",
    about: help::curve,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Curves>("curve")),
    writes: &PICTURE,
    example: "CHA-20A-100-H-C1024 --voltage \"220 V\"",
    answer: Some(|inquiry| {
        let (code, plane) = found(inquiry)?;
        Ok(Answer::record(&answer::curves(&code, &plane.curves, inquiry.language)))
    }),
};

/// Returns the torque-speed plane of an actuator with its curves.
///
/// # Errors
/// Every fault of the arguments; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(ProductId, Plane), Unanswered> {
    let Args { code, voltage } = Args::read(&inquiry.given)?;
    let product = inquiry.catalogue.product(&code).ok_or_else(|| not_offered(&**inquiry.catalogue, &code))?;
    let plane = plane_of(product, voltage).map_err(|missing| without_datum(product, missing.symbol))?;
    Ok((code, plane))
}
