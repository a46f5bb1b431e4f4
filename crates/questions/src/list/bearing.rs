//! `bearing PROJECT`: the output bearing of every size under the loads of a project.

use super::given::{arguments, text};
use super::{AXIS, Cost, Entry, Gives, Reads, Record, Unanswered};
use crate::answer;
pub use crate::chapters::{bearing_checks, bearing_of_each_size};
use crate::progress::Progress;
use crate::sizing_use::Candidate;
use axis::AxisProject;
use quantities::Language;
use sizing::Verdict;
use words::{help, terms};

arguments! {
    /// Arguments of `bearing`: the axis.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "bearing",
    path: "bearing",
    about: help::bearing,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Bearings>>("bearing")),
    writes: &[],
    example: "axis.toml",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let axes = asked.axes(args.axis.as_deref(), Cost::Other)?;
        asked.record_of_each(&axes, |project| {
            let found = sizes(project, asked.progress, asked.language)?;
            Ok((answer::bearings(&found, project, asked.language), answers::Fit::of(fits(&found))))
        })
    }),
};

/// Judges one actuator of each size.
///
/// # Errors
/// If the project has no loads on the flange, or the work was cancelled.
pub fn sizes<'p>(
    project: &'p AxisProject,
    progress: &Progress,
    language: Language,
) -> Result<Vec<Candidate<'p>>, Unanswered> {
    // Without a load no size differs from another.
    if !project.axis.bearing.as_ref().is_some_and(|duty| duty.has_loads) {
        return Err(Unanswered::message(terms::no_flange_loads(language)));
    }
    Ok(bearing_of_each_size(project, progress)?)
}

/// Returns `true` if the bearing of at least one size carries the loads.
#[must_use]
pub fn fits(sizes: &[Candidate<'_>]) -> bool {
    let fails = |candidate| bearing_checks(candidate).any(|check| check.verdict == Verdict::Fail);
    sizes.iter().any(|candidate| !fails(candidate))
}
