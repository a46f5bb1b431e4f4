//! `diff OLD NEW`: what another revision of a project does to an actuator.

use super::given::{arguments, some_code, text};
use super::{AXIS, Asked, Axis, Cost, Entry, Gives, Reads, Record, Unanswered, argument};
use crate::answer;
pub use crate::compare::{CheckChange, Difference, difference};
use crate::subject::paired;
use answers::Answered;
use order_code::OrderCode;
use project::input_changes;
use words::{help, terminal};

arguments! {
    /// Which axis, which actuator.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best before.
        code: Option<OrderCode> = argument::code(help::diff_code) => some_code,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "diff",
    path: "diff",
    about: help::diff,
    reads: Reads::TwoProjects,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Difference>>("diff")),
    writes: &[],
    example: "before.toml after.toml",
    answer: Some(|asked| {
        let revisions = revisions(asked)?;
        let (mut records, mut faults, mut fits) = (Vec::new(), Vec::new(), true);
        for (before, after) in revisions.pairs()? {
            let inputs = input_changes((revisions.old_text, before.0), (revisions.new_text, after.0));
            match difference(&before.1, &after.1, revisions.code.as_ref(), asked.patience) {
                Ok(found) => {
                    fits &= found.after.fits();
                    records.push(answer::difference(&found, &inputs, &after.1.name, asked.language));
                }
                Err(refusal) => faults.push(refusal.into()),
            }
        }
        if !faults.is_empty() {
            return Err(Unanswered::together(faults));
        }
        let remarks = revisions.unpaired(asked);
        Ok(super::Answer { remarks, ..super::Answer::record(&Answered::of(records, fits)).fits(fits) })
    }),
};

/// Two revisions of a project.
pub struct Revisions<'a> {
    /// The axes of the one before.
    pub old: Vec<Axis>,
    /// The axes of the one after.
    pub new: Vec<Axis>,
    /// The places of those that belong together.
    pub paired: Vec<(usize, usize)>,
    /// The text of the one before.
    pub old_text: &'a str,
    /// The text of the one after.
    pub new_text: &'a str,
    /// The actuator.
    pub code: Option<OrderCode>,
    none: Unanswered,
}

impl Revisions<'_> {
    /// A line for each axis that only one of the revisions has.
    #[must_use]
    pub fn unpaired(&self, asked: &Asked<'_>) -> String {
        let line = |axis: &Axis, place: usize| {
            let file = asked.sources.get(place).map_or("", |source| source.name.as_str());
            format!("{}\n", terminal::axis_is_only_in(&axis.1.name, &file, asked.language))
        };
        let old = self.old.iter().enumerate().filter(|(place, _)| self.paired.iter().all(|pair| pair.0 != *place));
        let new = self.new.iter().enumerate().filter(|(place, _)| self.paired.iter().all(|pair| pair.1 != *place));
        old.map(|(_, axis)| line(axis, 0)).chain(new.map(|(_, axis)| line(axis, 1))).collect()
    }

    /// The axes that belong together.
    ///
    /// # Errors
    /// Where there are none.
    pub fn pairs(&self) -> Result<Vec<(&Axis, &Axis)>, Unanswered> {
        if self.paired.is_empty() {
            return Err(self.none.clone());
        }
        let both = |(before, after): &(usize, usize)| Some((self.old.get(*before)?, self.new.get(*after)?));
        Ok(self.paired.iter().filter_map(both).collect())
    }
}

/// Both revisions, read.
///
/// # Errors
/// Every fault of the arguments, else those of the projects.
pub fn revisions<'a>(asked: &'a Asked<'_>) -> Result<Revisions<'a>, Unanswered> {
    let args = Args::read(&asked.given)?;
    let none = Unanswered::message(terminal::no_common_axis(asked.language));
    let [before, after] = asked.sources.as_slice() else { return Err(none) };
    let (old_text, new_text) = (before.text(asked.language)?, after.text(asked.language)?);
    let wanted = args.axis.as_deref();
    let (old, new) = (asked.axes_of(before, wanted)?, asked.axes_of(after, wanted)?);
    asked.within(Cost::Other, old.iter().chain(&new))?;
    let paired = paired(&old, &new);
    Ok(Revisions { old, new, paired, old_text, new_text, code: args.code, none })
}
