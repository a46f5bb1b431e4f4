//! Effect of the tolerances of a project on an actuator: the worst corner of their bands, the share of samples with
//! which it fits, and the quantity with the largest influence.

mod corners;
mod draws;
mod statistics;
pub(crate) mod work;

use crate::sizing_use::{Candidate, Objection, Refusal};
use axis::{AxisProject, Variant, Varied};
use configurator::Product;
use draws::Draws;
use rayon::prelude::*;
use sizing::{CheckId, Depth, Fit, Judge, Judgement, Proviso, Scope, StepObserver, Unobserved, finished};
use statistics::{Ranks, wilson};
use std::ops::Range;

/// Largest number of samples of one question.
pub const SAMPLES_MOST: usize = 1_000_000;

/// Default number of samples.
pub const SAMPLES_USUAL: usize = 10_000;

/// Default seed.
pub(crate) const SEED_USUAL: u64 = 1;

/// Number of parts into which the samples are divided for the threads; the result has the same bits as with one part.
const PARTS: usize = 8;

/// Sampling of the tolerances: every quantity uniform within its band, independent of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Number of samples, 1 to [`SAMPLES_MOST`].
    pub samples: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// Requested sampling of the tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draw {
    /// Number of samples; `None` for the number that some seconds allow, at most [`SAMPLES_USUAL`].
    pub samples: Option<usize>,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Default for Draw {
    fn default() -> Self {
        Self { samples: None, seed: SEED_USUAL }
    }
}

impl Draw {
    /// Returns the sampling for a project and some actuators.
    ///
    /// # Errors
    /// [`Refusal::TooManySamples`] if the samples exceed the usual time and the call states no time limit; with one,
    /// [`SAMPLES_MOST`] are permitted.
    pub fn sampling(self, project: &AxisProject, actuators: usize, in_time: bool) -> Result<Sampling, Refusal> {
        let most = if in_time { SAMPLES_MOST } else { work::samples_most(project, actuators) };
        let samples = self.samples.unwrap_or_else(|| work::samples_usual(project, actuators));
        if samples > most && !project.tolerances.is_empty() {
            return Err(Refusal::TooManySamples { asked: samples, most });
        }
        Ok(Sampling { samples, seed: self.seed })
    }

    /// Returns `true` if the computation is fast enough to be repeated at every keystroke.
    #[must_use]
    pub fn is_quick(self, project: &AxisProject, actuators: usize) -> bool {
        let sampling = self.sampling(project, actuators, false);
        sampling.is_ok_and(|sampling| work::is_quick(project, actuators, sampling.samples))
    }
}

impl Default for Sampling {
    fn default() -> Self {
        Self { samples: SAMPLES_USUAL, seed: SEED_USUAL }
    }
}

/// Quantiles of the largest utilisation of the samples; infinite if an axis is not possible or a limit of zero is
/// exceeded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// 5 %.
    pub p05: f64,
    /// 50 %.
    pub p50: f64,
    /// 95 %.
    pub p95: f64,
    /// The largest.
    pub max: f64,
}

/// Kind of the worst point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointKind {
    /// The worst of all corners.
    Corner,
    /// The worst corner found by a search; there are too many to evaluate each.
    SearchedCorner,
    /// A sample that is worse than every corner, so the dependence is not monotone.
    Sample,
}

/// The worst point within the bands.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// Kind of the point.
    pub place: PointKind,
    /// Value of each toleranced quantity at the point, in SI and in the order of [`AxisProject::tolerances`].
    pub values: Vec<f64>,
    /// Verdict on the actuator.
    pub fit: Fit,
    /// Largest utilisation.
    pub utilisation: f64,
    /// The failing check with the largest excess, else the governing check; `None` if no axis is possible.
    pub check: Option<CheckId>,
}

/// Share of a quantity in the spread of the utilisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// Index in [`AxisProject::tolerances`].
    pub quantity: usize,
    /// ρ² of this quantity by the sum of all, ρ the rank correlation with the utilisation.
    pub share: f64,
}

/// Samples with which an actuator fits on a condition only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Conditional {
    /// Number of samples.
    pub samples: usize,
    /// Conditions, each of at least one sample.
    pub proviso: Proviso,
}

/// The tolerances judged for one actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Sampling in use.
    pub sampling: Sampling,
    /// Number of samples with which the actuator fits.
    pub passes: usize,
    /// Samples among `passes` with which it fits on a condition.
    pub conditional: Conditional,
    /// Number of samples with which no axis is possible; none of them passes.
    pub impossible: usize,
    /// 95 % interval of the share of passes, by Wilson.
    pub interval: (f64, f64),
    /// Largest utilisation over the samples.
    pub utilisation: Quantiles,
    /// The worst point.
    pub worst: Worst,
    /// Influences of the quantities, the dominating one first; empty if the utilisation does not depend on any.
    pub influence: Vec<Influence>,
}

impl Conditional {
    const fn add(&mut self, samples: usize, proviso: Proviso) {
        self.samples += samples;
        self.proviso.estimate |= proviso.estimate;
        self.proviso.rating |= proviso.rating;
    }
}

impl Assessment {
    /// Returns the share of the samples that pass.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "counts are bounded by SAMPLES_MOST")]
    pub fn share(&self) -> f64 {
        self.passes as f64 / self.sampling.samples as f64
    }
}

/// Judges the tolerances of a project for actuators that were judged at the nominal values; one answer for each, in the
/// same order. Empty if the project has no tolerance.
///
/// # Source
/// docs/theory/tolerances.md
/// # Valid
/// corners are the extremes where the utilisation is monotone in each quantity; a sample that is worse than
/// every corner is reported instead
#[must_use]
pub fn assess(project: &AxisProject, candidates: &[&Candidate<'_>], sampling: Sampling) -> Vec<Assessment> {
    finished(assess_watched(project, candidates, sampling, &Unobserved))
}

/// Judges like [`assess`], but can be cancelled.
///
/// # Errors
/// If it was cancelled.
pub(crate) fn assess_watched<W: StepObserver>(
    project: &AxisProject,
    candidates: &[&Candidate<'_>],
    sampling: Sampling,
    watch: &W,
) -> Result<Vec<Assessment>, W::Stop> {
    assess_with(project, candidates, sampling, (PARTS, watch))
}

fn assess_with<W: StepObserver>(
    project: &AxisProject,
    candidates: &[&Candidate<'_>],
    sampling: Sampling,
    (parts, watch): (usize, &W),
) -> Result<Vec<Assessment>, W::Stop> {
    let Some(varied) = Varied::new(project) else { return Ok(Vec::new()) };
    let samples = sampling.samples.clamp(1, SAMPLES_MOST);
    let sampling = Sampling { samples, ..sampling };
    let judged: Vec<Judged<'_>> = candidates.iter().map(|each| Judged::of(project, each)).collect();
    let draws = Draws { seed: sampling.seed, quantities: project.tolerances.len() };
    watch.expect(samples);
    let sampled = sample(&varied, &judged, (draws, samples), (parts, watch))?;

    let ranks: Vec<Ranks> =
        sampled.iter().map(|each| Ranks::of(each.utilisations.iter().map(|u| u.to_bits()))).collect();
    let correlations: Vec<Vec<f64>> = (0..draws.quantities)
        .map(|quantity| {
            let own = Ranks::of(draws.column(quantity, samples));
            ranks.iter().map(|of| own.correlation(of)).collect()
        })
        .collect();
    let of_candidate =
        |index: usize| -> Vec<f64> { correlations.iter().map(|row| row.get(index).copied().unwrap_or(0.0)).collect() };
    let rising: Vec<Vec<f64>> = (0..judged.len()).map(of_candidate).collect();
    let corners = corners::worst((project, &varied), &judged, &rising, watch)?;

    let mut answers = Vec::with_capacity(judged.len());
    for ((((judged, sampled), ranks), rising), corner) in
        judged.iter().zip(sampled).zip(&ranks).zip(&rising).zip(corners)
    {
        let mut worst = corner;
        // A sample that is worse by rounding only is not reported.
        let beyond = (sampled.worst.fit, sampled.worst.utilisation) > (worst.fit, worst.utilisation * (1.0 + 1e-9));
        if beyond {
            let values = draws.sample(sampled.worst.index, &project.tolerances);
            worst = Point::judged_at(&mut varied.clone(), judged, &values).at(values, PointKind::Sample);
        }
        let quantile = |share: f64| ranks.quantile(share).map_or(0.0, f64::from_bits);
        answers.push(Assessment {
            sampling,
            passes: sampled.passes,
            conditional: sampled.conditional,
            impossible: sampled.impossible,
            interval: wilson(sampled.passes, samples),
            utilisation: Quantiles {
                p05: quantile(0.05),
                p50: quantile(0.50),
                p95: quantile(0.95),
                max: quantile(1.0),
            },
            worst,
            influence: influence(rising),
        });
    }
    Ok(answers)
}

/// Returns the shares of the explained variance, the largest first; equal ones keep the order of the file.
fn influence(correlations: &[f64]) -> Vec<Influence> {
    let total: f64 = correlations.iter().map(|rho| rho * rho).sum();
    if total <= 0.0 {
        return Vec::new();
    }
    let mut found: Vec<Influence> = correlations
        .iter()
        .enumerate()
        .map(|(quantity, rho)| Influence { quantity, share: rho * rho / total })
        .collect();
    found.sort_by(|a, b| b.share.total_cmp(&a.share));
    found
}

/// An actuator with the objections that are independent of the values.
#[derive(Clone, Debug)]
struct Judged<'c> {
    candidate: &'c Candidate<'c>,
    /// `true` if a requirement without tolerance is not met, or a rule is broken.
    hopeless: bool,
}

impl<'c> Judged<'c> {
    fn of(project: &AxisProject, candidate: &'c Candidate<'c>) -> Self {
        let own = candidate.product.is_of_project();
        let touched = |table: &str| project.tolerances.iter().any(|each| each.path.starts_with(table));
        let varies = touched("requirements.") || (own && touched("actuator."));
        let speaks = |objection: &Objection| match objection {
            Objection::Unmet(unmet) => !varies && unmet.rejects(candidate.product),
            Objection::Rule(_) => true,
        };
        Self { candidate, hopeless: candidate.objections.iter().any(speaks) }
    }

    /// Returns the judgement for a variant, by the judge of its axis, and the verdict on the actuator.
    fn judge(&self, project: &AxisProject, variant: &Variant, judge: &mut Judge<'_>) -> (Judgement, Fit) {
        let own = variant.actuator.as_ref().filter(|_| self.candidate.product.is_of_project());
        let product = own.unwrap_or(self.candidate.product);
        let judgement = judge.next(&product.parameters, &mut |_, _| {});
        let is_met = !self.hopeless && self.meets(project, variant, product);
        let fit = if is_met { judgement.fit() } else { Fit::DoesNotFit };
        (judgement, fit)
    }

    fn meets(&self, project: &AxisProject, variant: &Variant, product: &Product) -> bool {
        if variant.requirements.is_none() && variant.actuator.is_none() {
            return true;
        }
        let requirements = variant.requirements.as_ref().unwrap_or(&project.requirements);
        requirements.are_met(&self.candidate.id, product)
    }
}

/// Creates the judge of a variant that determines only verdict and utilisation.
fn judge_of(variant: &Variant) -> Judge<'_> {
    Judge::new(&variant.axis, Scope::Deciding, Depth::Complete)
}

/// Result at one point of the bands.
#[derive(Clone, Copy, Debug)]
struct Point {
    fit: Fit,
    utilisation: f64,
    check: Option<CheckId>,
}

impl Point {
    const IMPOSSIBLE: Self = Self { fit: Fit::DoesNotFit, utilisation: f64::INFINITY, check: None };

    fn of(judged: &Judged<'_>, project: &AxisProject, variant: &Variant) -> Self {
        let (judgement, fit) = judged.judge(project, variant, &mut judge_of(variant));
        let check = judgement.governing_in(fit).map(|check| check.id);
        Self { fit, utilisation: number(judgement.utilisation()), check }
    }

    fn judged_at(varied: &mut Varied<'_>, judged: &Judged<'_>, values: &[f64]) -> Self {
        let project = varied.project();
        varied.at(values).map_or(Self::IMPOSSIBLE, |variant| Self::of(judged, project, &variant))
    }

    /// Returns `true` if this point is worse: it does not fit while the other does, or its utilisation is larger.
    fn is_worse_than(&self, other: &Self) -> bool {
        (self.fit, self.utilisation) > (other.fit, other.utilisation)
    }

    const fn at(self, values: Vec<f64>, place: PointKind) -> Worst {
        Worst { place, values, fit: self.fit, utilisation: self.utilisation, check: self.check }
    }
}

/// Replaces NaN by infinity, so that it is worse than every number.
const fn number(utilisation: f64) -> f64 {
    if utilisation.is_nan() { f64::INFINITY } else { utilisation }
}

/// The worst sample.
#[derive(Clone, Copy, Debug)]
struct WorstSample {
    index: usize,
    fit: Fit,
    utilisation: f64,
}

/// The samples of one actuator.
#[derive(Clone, Debug)]
struct Sampled {
    utilisations: Vec<f64>,
    passes: usize,
    conditional: Conditional,
    impossible: usize,
    worst: WorstSample,
}

impl Sampled {
    fn empty(samples: usize) -> Self {
        let worst = WorstSample { index: 0, fit: Fit::Fits, utilisation: -1.0 };
        let conditional = Conditional::default();
        Self { utilisations: Vec::with_capacity(samples), passes: 0, conditional, impossible: 0, worst }
    }

    fn add(&mut self, index: usize, fit: Fit, utilisation: f64) {
        self.utilisations.push(utilisation);
        self.passes += usize::from(fit.fits());
        if (fit, utilisation) > (self.worst.fit, self.worst.utilisation) {
            self.worst = WorstSample { index, fit, utilisation };
        }
    }

    /// Appends the later samples; among equally bad ones the first stays the worst.
    fn append(&mut self, mut later: Self) {
        self.utilisations.append(&mut later.utilisations);
        self.passes += later.passes;
        self.conditional.add(later.conditional.samples, later.conditional.proviso);
        self.impossible += later.impossible;
        if (later.worst.fit, later.worst.utilisation) > (self.worst.fit, self.worst.utilisation) {
            self.worst = later.worst;
        }
    }
}

/// Judges every sample, in fixed parts that are joined in their order. A sample depends on the seed and its number
/// alone, so the result is independent of the number and the speed of the threads.
fn sample<W: StepObserver>(
    varied: &Varied<'_>,
    judged: &[Judged<'_>],
    (draws, samples): (Draws, usize),
    (parts, watch): (usize, &W),
) -> Result<Vec<Sampled>, W::Stop> {
    let part = samples.div_ceil(parts);
    let ranges: Vec<Range<usize>> =
        (0..parts).map(|index| (index * part).min(samples)..((index + 1) * part).min(samples)).collect();
    let run = |range: Range<usize>| judge_samples(varied.clone(), judged, draws, range, watch);
    let found: Vec<Vec<Sampled>> = ranges.into_par_iter().map(run).collect::<Result<_, _>>()?;
    let join = |mut all: Vec<Sampled>, later: Vec<Sampled>| {
        all.iter_mut().zip(later).for_each(|(all, later)| all.append(later));
        all
    };
    Ok(found.into_iter().reduce(join).unwrap_or_default())
}

fn judge_samples<W: StepObserver>(
    mut varied: Varied<'_>,
    judged: &[Judged<'_>],
    draws: Draws,
    range: Range<usize>,
    watch: &W,
) -> Result<Vec<Sampled>, W::Stop> {
    let project = varied.project();
    let mut all: Vec<Sampled> = judged.iter().map(|_| Sampled::empty(range.len())).collect();
    let mut values = vec![0.0; draws.quantities];
    let mut stream = draws.from(range.start);
    for index in range {
        watch.step()?;
        stream.next_into(&project.tolerances, &mut values);
        match varied.at(&values).ok() {
            None => {
                for sampled in &mut all {
                    sampled.impossible += 1;
                    sampled.add(index, Fit::DoesNotFit, f64::INFINITY);
                }
            }
            Some(variant) => {
                let mut judge = judge_of(&variant);
                for (sampled, judged) in all.iter_mut().zip(judged) {
                    let (judgement, fit) = judged.judge(project, &variant, &mut judge);
                    sampled.add(index, fit, number(judgement.utilisation()));
                    if fit == Fit::FitsIfEstimate {
                        sampled.conditional.add(1, judgement.proviso());
                    }
                }
            }
        }
    }
    Ok(all)
}

#[cfg(test)]
#[path = "tolerance_tests.rs"]
mod tests;
