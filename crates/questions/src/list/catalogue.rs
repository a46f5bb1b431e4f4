//! `catalogue export`: every cell of the manufacturer's tables.

use super::given::{arguments, word};
use super::{Answer, Argument, ArgumentKind, Entry, Gives, Reads, Record, media};
use crate::answer;
pub use crate::export::export_csv;
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `catalogue export`: the format.
    pub struct Args {
        /// `true` for CSV.
        format: Option<bool> = Argument::option("format", values::format, help::catalogue_format)
            .of(ArgumentKind::Word(|| vec!["json", "csv"])) => word(|format| Some(format == "csv")),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "catalogue export",
    path: "catalogue",
    about: help::catalogue_export,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::RecordOr(Record::of::<Vec<answers::CatalogueCell>>("catalogue export"), &[media::CSV]),
    writes: &[],
    example: "--format csv",
    answer: Some(|asked| {
        if Args::read(&asked.given)?.format.unwrap_or_default() {
            return Ok(Answer::text(media::CSV, export_csv()));
        }
        Ok(Answer::record(&answer::catalogue_cells()))
    }),
};
