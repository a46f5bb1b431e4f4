//! `report PROJECT`: the results as a PDF to sign; a face typesets it.

use super::given::{arguments, flag, label, some_code, text};
use super::{AXIS, Argument, Asked, Axis, Cost, Entry, Gives, OutputFile, Reads, Unanswered, argument, media};
use crate::subject::names;
use order_code::OrderCode;
use words::{help, help::values, terminal};

/// The day of the document.
pub const DATE: Argument = Argument::option("date", values::date, help::date);

arguments! {
    /// Which axes, which actuator, which chapters.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best.
        code: Option<OrderCode> = argument::code(help::own_or_best_code) => some_code,
        /// With the derivations.
        full: bool = Argument::flag("full", help::report_full) => flag,
        /// With wiring, mounting and commissioning.
        installation: bool = Argument::flag("installation", help::report_installation) => flag,
        /// The day of the document.
        date: Option<String> = DATE => label,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "report",
    path: "report",
    about: help::report,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::PDF]),
    writes: &[OutputFile::of("out", &[media::PDF], help::report_out).required()],
    example: "axis.toml --out axis.pdf",
    answer: None,
};

impl Args {
    /// The axes that are reported.
    ///
    /// # Errors
    /// Faults of the project, a code for several axes.
    pub fn axes(&self, asked: &Asked<'_>) -> Result<Vec<Axis>, Unanswered> {
        let axes = asked.axes(self.axis.as_deref(), Cost::Report)?;
        if axes.len() > 1 && self.code.is_some() {
            let names = names(axes.iter().map(|(_, project)| project));
            return Err(Unanswered::message(terminal::code_is_for_one_axis(&names, asked.language)));
        }
        Ok(axes)
    }
}
