//! `check PROJECT`: one actuator judged for an axis.

use super::given::{arguments, number, some_product_among, text};
use super::size::{SAMPLES, SEED, draw, sampled};
use super::{AXIS, Cost, Entry, Gives, Inquiry, PlacedAxis, Reads, Record, Unanswered, argument};
use crate::answer;
use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal};
use crate::subject::stated_or_best;
use crate::tolerance::{Assessment, Draw, assess_watched};
use axis::AxisProject;
use configurator::ProductId;
use quantities::Language;
use sizing::{Reserve, SAMPLES_ANEW, reserve_watched};
use words::help;

arguments! {
    /// Arguments of `check`: axis, actuator, sampling of the tolerances.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own, else the best.
        code: Option<ProductId> = argument::code(help::check_code) => some_product_among,
        /// Number of samples.
        samples: Option<usize> = SAMPLES => number,
        /// Seed of the samples.
        seed: Option<u64> = SEED => number,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "check",
    path: "check",
    about: help::check,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Judgement>>("check")),
    writes: &[],
    example: "axis.toml --code CHA-25A-50-H-C1024",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let axes = args.axes(asked)?;
        asked.record_of_each(&axes, |project| {
            let found = args.verification(project, asked.progress)?;
            Ok((found.record(asked.language), answer::fit(&found.candidate)))
        })
    }),
};

impl Args {
    /// Returns the cost of the answer.
    #[must_use]
    pub fn cost(&self) -> Cost {
        Cost::Check { draw: draw(self.samples, self.seed) }
    }

    /// Returns the axes to judge the actuator for.
    ///
    /// # Errors
    /// Faults of the project; samples without tolerances.
    pub fn axes(&self, inquiry: &Inquiry<'_>) -> Result<Vec<PlacedAxis>, Unanswered> {
        let axes = inquiry.axes(self.axis.as_deref(), self.cost())?;
        sampled(&axes, (self.samples, self.seed), inquiry.language)?;
        Ok(axes)
    }

    /// Judges the actuator for an axis.
    ///
    /// # Errors
    /// As [`verification`].
    pub fn verification<'p>(&self, project: &'p AxisProject, progress: &Progress) -> Result<Verification<'p>, Refusal> {
        verification(project, self.code.as_ref(), draw(self.samples, self.seed), progress)
    }
}

/// One actuator judged for an axis, with its reserve and the effect of the tolerances.
#[derive(Clone, Debug)]
pub struct Verification<'p> {
    /// The axis.
    pub project: &'p AxisProject,
    /// The actuator with every check.
    pub candidate: Candidate<'p>,
    /// Largest permissible change of one quantity.
    pub reserve: Reserve,
    /// Effect of the tolerances; `None` without tolerances.
    pub assessment: Option<Assessment>,
}

/// Judges one actuator for an axis; without an identity the project's own, else the best of the catalogue.
///
/// # Errors
/// The reason why it cannot be judged.
pub fn verification<'p>(
    project: &'p AxisProject,
    id: Option<&ProductId>,
    draw: Draw,
    progress: &Progress,
) -> Result<Verification<'p>, Refusal> {
    let candidate = stated_or_best(project, id, progress)?;
    let (reserve, assessment) = margins(project, &candidate, draw, progress)?;
    Ok(Verification { project, candidate, reserve, assessment })
}

/// Computes the largest permissible change of one quantity up to which a candidate fits, and the effect of the
/// tolerances.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn margins(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    draw: Draw,
    progress: &Progress,
) -> Result<(Reserve, Option<Assessment>), Refusal> {
    // The step that may be refused comes first.
    draw.sampling(project, 1, progress.is_limited())?;
    let reserve = reserve_within(project, candidate, progress)?;
    Ok((reserve, scatter(project, candidate, draw, progress)?))
}

/// Computes the effect of the tolerances of a project on a candidate; `None` without tolerances.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn scatter(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    draw: Draw,
    progress: &Progress,
) -> Result<Option<Assessment>, Refusal> {
    let sampling = draw.sampling(project, 1, progress.is_limited())?;
    Ok(assess_watched(project, &[candidate], sampling, progress)?.into_iter().next())
}

/// Computes the largest permissible change of one quantity up to which a candidate fits: in full if the call states a
/// time limit, else within the default effort.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn reserve_within(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
) -> Result<Reserve, Refusal> {
    if !progress.is_limited() {
        return reserve_unasked(project, candidate, progress);
    }
    Ok(reserve_watched(&project.axis, candidate.parameters, usize::MAX, progress)?)
}

/// Computes the reserve of [`reserve_within`] within the default effort.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn reserve_unasked(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
) -> Result<Reserve, Refusal> {
    Ok(reserve_watched(&project.axis, candidate.parameters, SAMPLES_ANEW, progress)?)
}

impl Verification<'_> {
    /// Returns the record of the verification.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Judgement {
        answer::judgement(self.project, &self.candidate, &self.reserve, self.assessment.as_ref(), language)
    }
}
