//! `size PROJECT`: the whole catalogue ranked for an axis.

use super::given::{arguments, count, flag, number, text};
use super::{
    AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Inquiry, OutputFile, PlacedAxis, Reads, Record, Unanswered,
    argument, media,
};
use crate::answer;
pub use crate::catalogue_reserve::{CatalogueReach, catalogue_reserve};
pub use crate::gearing_proposals::{GearingProposal, SharedLoad, gearing_proposals, shared_load};
use crate::progress::Progress;
pub use crate::proposals::{LawProposal, Proposals, law_proposal};
use crate::sizing_use::{Candidate, Refusal, Rejected, Sizing, size_watched};
use crate::tolerance::{Assessment, Draw, SAMPLES_MOST, SEED_USUAL, assess_watched};
use axis::AxisProject;
use configurator::ProductId;
use quantities::Language;
pub use sizing::{AxisChange, Reach};
use words::{help, help::values, terminal};

#[allow(clippy::cast_possible_truncation, reason = "a million")]
pub(super) const SAMPLES: Argument =
    Argument::option("samples", values::n, help::samples).of(ArgumentKind::Whole(1, SAMPLES_MOST as u64));
pub(super) const SEED: Argument = Argument::option("seed", values::n, help::seed).of(ArgumentKind::Whole(0, u64::MAX));

arguments! {
    /// Arguments of `size`: axis, number of candidates, sampling of the tolerances.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// Number of candidates reported in full.
        top: usize = argument::top("10", help::size_top) => count,
        /// Reports every candidate in full.
        all: bool = Argument::flag("all", help::size_all) => flag,
        /// Number of samples.
        samples: Option<usize> = SAMPLES => number,
        /// Seed of the samples.
        seed: Option<u64> = SEED => number,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "size",
    path: "size",
    about: help::size,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Sizing>>("size")),
    writes: &[OutputFile::of("report", &[media::PDF], help::size_report)],
    example: "axis.toml --top 5",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let axes = args.axes(asked)?;
        asked.record_of_each(&axes, |project| {
            let found = args.ranking(project, asked.progress)?;
            Ok((found.record(asked.language), found.sizing.fit().into()))
        })
    }),
};

impl Args {
    /// Returns the number of candidates reported in full.
    #[must_use]
    pub const fn complete(&self) -> usize {
        if self.all { usize::MAX } else { self.top }
    }

    fn draw(&self) -> Draw {
        draw(self.samples, self.seed)
    }

    /// Returns the axes to rank the catalogue for.
    ///
    /// # Errors
    /// Faults of the project; samples without tolerances.
    pub fn axes(&self, inquiry: &Inquiry<'_>) -> Result<Vec<PlacedAxis>, Unanswered> {
        let axes = inquiry.axes(self.axis.as_deref(), self.cost())?;
        sampled(&axes, (self.samples, self.seed), inquiry.language)?;
        Ok(axes)
    }

    /// Returns the cost of the answer.
    #[must_use]
    pub fn cost(&self) -> Cost {
        Cost::Ranking { complete: self.complete(), draw: self.draw() }
    }

    /// Ranks the catalogue for an axis.
    ///
    /// # Errors
    /// As [`ranking`].
    pub fn ranking<'p>(&self, project: &'p AxisProject, progress: &Progress) -> Result<Ranking<'p>, Refusal> {
        ranking(project, self.complete(), self.draw(), progress)
    }
}

/// Reports a number of samples, or a seed, for axes without tolerances, of which nothing is sampled.
///
/// # Errors
/// The first of both that is given.
pub(super) fn sampled(
    axes: &[PlacedAxis],
    (samples, seed): (Option<usize>, Option<u64>),
    language: Language,
) -> Result<(), Unanswered> {
    let given = samples.map(|_| SAMPLES.name).or(seed.map(|_| SEED.name));
    let Some(option) = given.filter(|_| axes.iter().all(|(_, project)| project.tolerances.is_empty())) else {
        return Ok(());
    };
    let fault = terminal::nothing_to_sample(language).to_owned();
    Err(Unanswered::option(option, (fault, Some(terminal::state_a_tolerance(language).to_owned()))))
}

/// Returns the sampling of the tolerances.
pub(super) fn draw(samples: Option<usize>, seed: Option<u64>) -> Draw {
    Draw { samples, seed: seed.unwrap_or(SEED_USUAL) }
}

/// Largest number of candidates of a ranking whose tolerances are judged.
pub(crate) const ASSESSED_MOST: usize = 10;

/// The catalogue ranked for an axis, with the effect of the tolerances on the best candidates.
#[derive(Clone, Debug)]
pub struct Ranking<'p> {
    /// The axis.
    pub project: &'p AxisProject,
    /// Every candidate, best first, and the project's own actuator.
    pub sizing: Sizing<'p>,
    /// Number of candidates reported in full.
    pub top: usize,
    /// Changes with which an actuator fits, if none does.
    pub proposals: Proposals,
    /// Smallest changes of load and cycle time with which an actuator fits; `None` if one fits already, or if the cycle is
    /// too long for the search.
    pub reached: Option<Vec<CatalogueReach>>,
    /// Tolerances judged for the first of these candidates and for the project's own actuator; empty without
    /// tolerances.
    pub assessed: Vec<(ProductId, Assessment)>,
}

/// Ranks the catalogue for an axis.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn ranking<'p>(
    project: &'p AxisProject,
    top: usize,
    draw: Draw,
    progress: &Progress,
) -> Result<Ranking<'p>, Refusal> {
    let complete = top.min(ASSESSED_MOST) + usize::from(project.actuator.is_some());
    let sampling = draw.sampling(project, complete, progress.is_limited())?;
    let sizing = sized(project, top, Rejected::Reasons, progress)?;
    let chosen: Vec<&Candidate<'_>> = sizing.fitting().iter().take(top.min(ASSESSED_MOST)).chain(&sizing.own).collect();
    // Without tolerances there is no assessment and no pair.
    let found = assess_watched(project, &chosen, sampling, progress)?;
    let assessed = chosen.iter().map(|candidate| candidate.id.clone()).zip(found).collect();
    let (proposals, reached) = if sizing.fits() {
        (Proposals::default(), None)
    } else {
        (Proposals::of(project, progress)?, catalogue_reserve(project, progress)?)
    };
    Ok(Ranking { project, sizing, top, proposals, reached, assessed })
}

/// Judges and ranks the catalogue for an axis, without its tolerances; it can be cancelled. The first `complete` are
/// judged by every check if they fit; for the others the regenerated energy is omitted, unless the project limits it.
/// `rejected` states for which of the others every failing check is required.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn sized<'p>(
    project: &'p AxisProject,
    complete: usize,
    rejected: Rejected,
    progress: &Progress,
) -> Result<Sizing<'p>, Refusal> {
    Ok(size_watched(project, complete, rejected, progress)?)
}

impl Ranking<'_> {
    /// Iterates over the candidates whose tolerances are judged.
    pub fn assessed(&self) -> impl Iterator<Item = (&Candidate<'_>, &Assessment)> {
        let candidates = || self.sizing.candidates.iter().chain(&self.sizing.own);
        self.assessed.iter().filter_map(move |(id, found)| Some((candidates().find(|each| each.id == *id)?, found)))
    }

    /// Returns the record of the ranking.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Sizing {
        let reached = self.reached.iter().flatten().map(answer::would_fit_after).collect();
        let record = answer::sizing(&self.sizing, self.project, &self.assessed, &self.proposals, self.top, language);
        answers::Sizing { would_fit_after: reached, ..record }
    }
}
