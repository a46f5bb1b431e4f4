//! `diff OLD NEW`: effect of another revision of a project on an actuator.

use super::given::{arguments, some_product, text};
use super::{AXIS, Cost, Entry, Gives, Inquiry, PlacedAxis, Reads, Record, Unanswered, argument};
use crate::answer;
pub use crate::compare::{CheckChange, Difference, difference};
use crate::subject::paired;
use answers::Fit;
use configurator::ProductId;
use project::{InputChange, input_changes};
use words::{help, terminal};

arguments! {
    /// Arguments of `diff`: axis and actuator.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best before.
        code: Option<ProductId> = argument::code(help::diff_code) => some_product,
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
    answer: Some(|inquiry| {
        let revisions = revisions(inquiry)?;
        let record = |name: &str, found: &Difference<'_>, inputs: &[InputChange]| {
            (answer::difference(found, inputs, name, inquiry.language), answer::fit(&found.after))
        };
        let (records, fits): (Vec<_>, Vec<Fit>) = revisions.each(inquiry, record)?.into_iter().unzip();
        let verdict = Fit::of_all(fits);
        let remarks = revisions.unpaired(inquiry);
        Ok(super::Answer { remarks, ..super::Answer::record(&inquiry.answered(records, verdict)).fits(verdict.fits()) })
    }),
};

/// Two revisions of a project.
pub struct Revisions<'a> {
    /// Axes of the first revision.
    pub old: Vec<PlacedAxis>,
    /// Axes of the second revision.
    pub new: Vec<PlacedAxis>,
    /// Indices of the corresponding axes, first and second revision.
    pub paired: Vec<(usize, usize)>,
    /// Text of the first revision.
    pub old_text: &'a str,
    /// Text of the second revision.
    pub new_text: &'a str,
    /// The actuator.
    pub code: Option<ProductId>,
}

impl Revisions<'_> {
    /// Returns a line for each axis that exists in one revision only.
    #[must_use]
    pub fn unpaired(&self, inquiry: &Inquiry<'_>) -> String {
        let line = |axis: &PlacedAxis, place: usize| {
            let file = inquiry.sources.get(place).map_or("", |source| source.name.as_str());
            format!("{}\n", terminal::axis_is_only_in(&axis.1.name, &file, inquiry.language))
        };
        let old = self.old.iter().enumerate().filter(|(place, _)| self.paired.iter().all(|pair| pair.0 != *place));
        let new = self.new.iter().enumerate().filter(|(place, _)| self.paired.iter().all(|pair| pair.1 != *place));
        old.map(|(_, axis)| line(axis, 0)).chain(new.map(|(_, axis)| line(axis, 1))).collect()
    }

    /// Returns the answers about corresponding axes, from the name of the second, the difference and the changed
    /// inputs; if one of them fails, only the faults of all.
    ///
    /// # Errors
    /// If there are no corresponding axes, or there is no answer about some of them.
    pub fn each<T>(
        &self,
        inquiry: &Inquiry<'_>,
        one: impl Fn(&str, &Difference<'_>, &[InputChange]) -> T,
    ) -> Result<Vec<T>, Unanswered> {
        if self.paired.is_empty() {
            return Err(none(inquiry));
        }
        let (mut answers, mut faults) = (Vec::new(), Vec::new());
        for (before, after) in &self.paired {
            let (Some(before), Some(after)) = (self.old.get(*before), self.new.get(*after)) else { continue };
            let inputs = input_changes((self.old_text, before.0), (self.new_text, after.0));
            match difference(&before.1, &after.1, self.code.as_ref(), inquiry.progress) {
                Ok(found) => answers.push(one(&after.1.name, &found, &inputs)),
                Err(refusal) => faults.push(refusal.into()),
            }
        }
        if faults.is_empty() { Ok(answers) } else { Err(Unanswered::combined(faults)) }
    }
}

/// Returns the fault that no axis exists in both revisions.
fn none(inquiry: &Inquiry<'_>) -> Unanswered {
    Unanswered::message(terminal::no_common_axis(inquiry.language))
}

/// Reads both revisions.
///
/// # Errors
/// Every fault of the arguments, else those of the projects.
pub fn revisions<'a>(inquiry: &'a Inquiry<'_>) -> Result<Revisions<'a>, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let [before, after] = inquiry.sources.as_slice() else { return Err(none(inquiry)) };
    let (old_text, new_text) = (before.text(inquiry.language)?, after.text(inquiry.language)?);
    let wanted = args.axis.as_deref();
    let (old, new) = (inquiry.axes_of(before, wanted)?, inquiry.axes_of(after, wanted)?);
    inquiry.within(Cost::Other, old.iter().chain(&new))?;
    let paired = paired(&old, &new);
    Ok(Revisions { old, new, paired, old_text, new_text, code: args.code })
}
