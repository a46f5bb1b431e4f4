//! `inertia BODY…`: the moment of inertia of solid bodies.

use super::given::{arguments, lines};
use super::{Answer, Argument, ArgumentForm, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::reading::Unread;
use axis::{InertiaAnswer, inertia};
use words::{help, help::values};

arguments! {
    /// Arguments of `inertia`: bodies about an axis.
    pub struct Args {
        /// Bodies, one per line: the line of a fault is the number of the body.
        body: String = Argument::option("body", values::body, help::inertia_body).form(ArgumentForm::Each).required() => lines,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "inertia",
    path: "inertia",
    about: help::inertia,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Inertia>("inertia")),
    writes: &[],
    example: "\"disc diameter=200mm length=20mm density=7850kg/m^3\"",
    answer: Some(|inquiry| Ok(Answer::record(&answer::inertia(&found(inquiry)?)))),
};

/// Computes the moment of inertia.
///
/// # Errors
/// Every fault of the bodies.
pub fn found(inquiry: &Inquiry<'_>) -> Result<InertiaAnswer, Unanswered> {
    let text = Args::read(&inquiry.given)?.body;
    inertia(&text).map_err(|faults| Unanswered::unread(Unread::Faults(faults), "body", &text, inquiry.language))
}
