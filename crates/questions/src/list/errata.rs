//! `errata`: errors and doubtful statements of the manual, and the values in use.

use super::given::{arguments, label};
use super::{Answer, Argument, ArgumentForm, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::errata::ErrataFound;
pub use crate::errata::{ErrataRefusal, errata_about};
use crate::sizing_use::Refusal;
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `errata`: their subject.
    pub struct Args {
        /// A code, the number of a table, the identifier of an erratum; all errata without it.
        about: Option<String> = Argument::option("about", values::code_table_or_id, help::errata_about)
            .form(ArgumentForm::Words) => label,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "errata",
    path: "errata",
    about: help::errata,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Errata>("errata")),
    writes: &[],
    example: "CHA-25A-50-H-M512P",
    answer: Some(|inquiry| Ok(Answer::record(&answer::errata(&found(inquiry)?, inquiry.language)))),
};

/// Returns the errata.
///
/// # Errors
/// If the text names nothing that has errata.
pub fn found(inquiry: &Inquiry<'_>) -> Result<ErrataFound, Unanswered> {
    let text = Args::read(&inquiry.given)?.about.unwrap_or_default();
    errata_about(Some(&text), inquiry.language).map_err(|refusal| match refusal {
        ErrataRefusal::Code(refusal) => Unanswered::Code { text, refusal, among: false },
        ErrataRefusal::NoData => Refusal::NoData.into(),
        ErrataRefusal::Unknown { message, hint } => {
            Unanswered::message(hint.map_or(message.clone(), |hint| format!("{message}; {hint}")))
        }
    })
}
