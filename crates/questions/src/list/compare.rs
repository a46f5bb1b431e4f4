//! `compare PROJECT`: comparison of several actuators.

use super::given::{arguments, products, text};
use super::{AXIS, Cost, Entry, Gives, Inquiry, PlacedAxis, Reads, Record, Unanswered, argument};
use crate::answer;
pub use crate::compare::{CheckRow, Comparison, DatumRow, compare, data_of, errata_of};
use crate::sizing_use::Refusal;
use answers::Fit;
use axis::AxisProject;
use configurator::ProductId;
use words::{help, terminal};

/// Permissible numbers of actuators in a comparison.
pub const COMPARED: std::ops::RangeInclusive<usize> = 2..=5;

arguments! {
    /// Arguments of `compare`: axis and actuators.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuators.
        codes: Vec<ProductId> = argument::code(help::compare_code).required().repeated() => products,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "compare",
    path: "compare",
    about: help::compare,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Comparison>>("compare")),
    writes: &[],
    example: "axis.toml --code CHA-25A-50-H-C1024 --code CHA-32A-50-H-C1024",
    answer: Some(|inquiry| {
        let (args, axes) = read(inquiry)?;
        inquiry.record_of_each(&axes, |project| {
            let found = args.comparison(project, inquiry)?;
            let best = found.candidates.iter().map(answer::fit).min().unwrap_or(Fit::DoesNotFit);
            Ok((answer::comparison(&found, project, inquiry.language), best))
        })
    }),
};

/// Reads the arguments and the axes.
///
/// # Errors
/// Every fault of them.
pub fn read(inquiry: &Inquiry<'_>) -> Result<(Args, Vec<PlacedAxis>), Unanswered> {
    let count = inquiry.given.all("code").count();
    if !COMPARED.contains(&count) {
        return Err(Unanswered::message(terminal::two_to_five_codes(&count, inquiry.language)));
    }
    let args = Args::read(&inquiry.given)?;
    let axes = inquiry.axes(args.axis.as_deref(), Cost::Other)?;
    Ok((args, axes))
}

impl Args {
    /// Compares the actuators for an axis.
    ///
    /// # Errors
    /// The reason why one of them cannot be judged, with its code.
    pub fn comparison<'p>(
        &self,
        project: &'p AxisProject,
        inquiry: &Inquiry<'_>,
    ) -> Result<Comparison<'p>, Unanswered> {
        compare(project, &self.codes, inquiry.progress).map_err(|(index, refusal)| {
            let code = self.codes.get(index).filter(|_| refusal != Refusal::Stopped);
            Unanswered::Refused(refusal, code.cloned())
        })
    }
}
