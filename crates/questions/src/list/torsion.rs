//! `torsion CODE`: the torsion of a gear under a torque, or the torque of an angle.

use super::given::{arguments, product, some};
use super::{Answer, Argument, ArgumentForm, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_quantity;
use crate::sizing_use::{not_offered, without_datum};
use crate::torsion::{TorsionAnswer, Twist, torsion};
use configurator::ProductId;
use quantities::{Angle, Torque};
use words::{help, help::values};

arguments! {
    /// Arguments of `torsion`: a gear, and a torque or an angle.
    pub struct Args {
        /// Ordering code of the actuator.
        code: ProductId = CODE.form(ArgumentForm::Bare) => product,
        /// Torque at the output.
        torque: Option<Torque> = Argument::option("torque", values::torque, help::torsion_torque).signed()
            => some(read_quantity),
        /// Angle of torsion.
        angle: Option<Angle> =
            Argument::option("angle", values::angle, help::torsion_angle).signed().instead_of("torque")
            => some(read_quantity),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "torsion",
    path: "torsion",
    about: help::torsion,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Torsion>("torsion")),
    writes: &[],
    example: "CHA-20A-100-H-C1024 --torque \"60 N m\"",
    answer: Some(|inquiry| {
        let (code, found) = found(inquiry)?;
        Ok(Answer::record(&answer::torsion(&code, &found, inquiry.language)))
    }),
};

/// Returns a gear under a torque, or twisted by an angle.
///
/// # Errors
/// Every fault of the arguments; no stiffness in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(ProductId, TorsionAnswer), Unanswered> {
    let Args { code, torque, angle } = Args::read(&inquiry.given)?;
    let one = || Unanswered::option("torque", (words::terminal::torque_or_angle(inquiry.language).to_owned(), None));
    let twist = Twist::of(torque, angle).ok_or_else(one)?;
    let product = inquiry.catalogue.product(&code).ok_or_else(|| not_offered(&**inquiry.catalogue, &code))?;
    let found = torsion(&product.parameters, twist).ok_or_else(|| without_datum(product, "K_1"))?;
    Ok((code, found))
}
