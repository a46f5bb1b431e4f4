//! Ranking of the catalogue for an axis, and judgement of one actuator.

use crate::input_keys::InputKeys;
use crate::progress::Stopped;
use actuator::Parameters;
use axis::Assumption;
use axis::{AxisProject, Catalogue};
use configurator::{BrokenRule, Product, ProductId, Unmet};
use provenance::Datum;
use quantities::Measure;
use rayon::prelude::*;
use sizing::{
    Check, CheckId, Course, Depth, Fit, Judge, Judgement, Part, RankKey, Reserve, SAMPLES_ANEW, Scope, Standing,
    StepObserver, Unobserved, Verdict, finished, reserve_watched,
};
use std::sync::Arc;

pub use crate::candidate::{Candidate, Objection, Reason, by_importance};

/// Rejected actuators of a ranking for which every failing check is determined; the others are judged up to the first
/// failing check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejected {
    /// No actuator: only the fitting ones are required.
    None,
    /// Every actuator that may have the smallest excess if none fits.
    Nearest,
    /// Every actuator, for a list with reasons. A check that passes may be left out, see [`Depth::Failing`].
    Reasons,
    /// Every actuator, with all its checks.
    All,
}

/// The catalogue judged for one axis.
#[derive(Clone, Debug)]
pub struct Sizing<'p> {
    /// Name of the axis.
    pub name: &'p str,
    /// Every candidate, best first.
    pub candidates: Vec<Candidate<'p>>,
    /// Number of fitting candidates, which come first.
    fitting: usize,
    /// `true` if products without frame sizes compete, so that the lighter is preferred to the smaller.
    pub by_mass: bool,
    /// The user's own actuator, judged besides the catalogue.
    pub own: Option<Candidate<'p>>,
    /// Default values in use.
    pub assumptions: &'p [Assumption],
}

impl<'p> Sizing<'p> {
    /// Returns the fitting candidates, best first.
    #[must_use]
    pub fn fitting(&self) -> &[Candidate<'p>] {
        self.candidates.get(..self.fitting).unwrap_or_default()
    }

    /// Returns the candidates that do not fit, the one with the smallest excess first.
    #[must_use]
    pub fn rejected(&self) -> &[Candidate<'p>] {
        self.candidates.get(self.fitting..).unwrap_or_default()
    }

    /// Returns the number of candidates that fit within every limit, and of those that fit only if an estimate holds.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        let certain = self.fitting().iter().filter(|candidate| candidate.fit() == Fit::Fits).count();
        [certain, self.fitting - certain]
    }

    /// Returns the number of candidates that count as fitting though no check that can reject them could be made.
    #[must_use]
    pub fn not_evaluated(&self) -> usize {
        self.fitting().iter().filter(|candidate| candidate.is_not_evaluated()).count()
    }

    /// Returns the fitting candidates with at least one check that can reject them, each with its rank from 1.
    pub fn ranked(&self) -> impl Iterator<Item = (usize, &Candidate<'p>)> {
        (1..).zip(self.fitting()).filter(|(_, candidate)| !candidate.is_not_evaluated())
    }

    /// Returns the rejected candidate with the smallest excess, among those that meet the requirements of the project
    /// and are of the right class: an actuator for another voltage or temperature range is no alternative. Where none
    /// fits and each is excluded in this way, the one with the smallest excess that meets the requirements; where a
    /// requirement excludes each, the one that misses the fewest requirements and limits.
    #[must_use]
    pub fn nearest_miss(&self) -> Option<&Candidate<'p>> {
        let near = self.rejected().iter().find(|candidate| may_be_near(candidate));
        let excluded = || {
            let permitted = self.rejected().iter().find(|candidate| candidate.objections.is_empty());
            permitted.or_else(|| self.rejected().iter().min_by_key(|candidate| misses(candidate)))
        };
        near.or_else(|| excluded().filter(|_| self.fitting == 0))
    }

    /// Returns the best candidate, if one fits.
    #[must_use]
    pub fn answer(&self) -> Option<&Candidate<'p>> {
        self.fitting().first()
    }

    /// Returns the candidate that every answer about the axis names: the best, else the one with the smallest excess.
    #[must_use]
    pub fn named(&self) -> Option<&Candidate<'p>> {
        self.answer().or_else(|| self.nearest_miss())
    }

    /// Returns the verdict on the best candidate, the user's own actuator included.
    #[must_use]
    pub fn fit(&self) -> Fit {
        let best = self.answer().map_or(Fit::DoesNotFit, Candidate::fit);
        self.own.as_ref().map_or(best, |own| best.min(own.fit()))
    }

    /// Returns `true` if any candidate fits, the user's own actuator included.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.fit().fits()
    }
}

/// Returns `true` unless an objection or a check independent of load and cycle time excludes a candidate.
fn may_be_near(candidate: &Candidate<'_>) -> bool {
    let of_the_place = |check: &Check| check.verdict == Verdict::Fail && check.id.is_of_the_place();
    candidate.objections.is_empty() && !candidate.judgement.checks.iter().any(of_the_place)
}

/// Returns the number of requirements and limits that a candidate does not meet.
fn misses(candidate: &Candidate<'_>) -> usize {
    let failing = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
    candidate.objections.len() + failing.count()
}

/// Reasons why an actuator cannot be judged.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The code breaks rules of the ordering tables.
    Broken(Vec<BrokenRule>),
    /// The manual prints no data for this code.
    NoData,
    /// The catalogue file does not state a datum of a product that the answer needs.
    NotStated {
        /// Name of the product.
        name: String,
        /// Symbol of the datum.
        symbol: &'static str,
    },
    /// No catalogue file has a product of this name.
    NoProduct {
        /// Name as given.
        name: String,
        /// The name of a product that is spelt similarly.
        near: Option<String>,
    },
    /// The project describes no actuator of its own, and no code is given.
    NoActuator,
    /// This check is not part of the judgement of this axis and actuator.
    NotAsked(CheckId),
    /// The number of samples of the tolerances exceeds the limit without a time limit.
    TooManySamples {
        /// Requested number.
        asked: usize,
        /// Largest number for this axis and these actuators.
        most: usize,
    },
    /// The recordings exceed the limit without a time limit.
    TooLong {
        /// Number of samples in use.
        samples: usize,
        /// Largest number under a load of this kind.
        most: usize,
        /// Approximate computing time of the largest number \[s\].
        seconds: usize,
    },
    /// Several axes together exceed the limit without a time limit.
    TooManyAxes {
        /// Number of axes.
        axes: usize,
        /// Approximate limit of the computing time \[s\].
        seconds: usize,
    },
    /// The ratios of a stage exceed the limit without a time limit, since the catalogue is judged for each.
    TooManyRatios {
        /// Number of ratios.
        ratios: usize,
        /// Approximate limit of the computing time \[s\].
        seconds: usize,
    },
    /// A table of the course exceeds the memory that a project may use.
    TooManyRows {
        /// Largest number of rows.
        rows: usize,
        /// Memory of these rows \[byte\].
        needed: u64,
        /// Permissible memory \[byte\].
        most: u64,
    },
    /// The call was cancelled.
    Stopped,
}

impl From<Stopped> for Refusal {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}

/// Returns the products that are offered for an axis, with the encoder at the output if the project requires it.
pub(crate) fn products_of(project: &AxisProject) -> &[Product] {
    project.catalogue().products(project.option_1.is_some())
}

/// Judges the whole catalogue for the axis of a project by every check and ranks it.
///
/// Cost: O(ramps) to prepare the motion, O(ramps) per actuator, O(n log n) to rank.
#[must_use]
pub fn size(project: &AxisProject) -> Sizing<'_> {
    finished(size_watched(project, usize::MAX, Rejected::All, &Unobserved))
}

/// Judges and ranks like [`size`], but can be cancelled; only the first `complete_count` are judged by every check. The
/// others are judged by those of a ranking ([`Scope::Ranking`]), or, where no reasons for rejections are required, by those
/// that decide the order ([`Scope::Deciding`]); the rejected ones as far as `rejected` states.
///
/// # Errors
/// If it was cancelled.
pub(crate) fn size_watched<'p, W: StepObserver>(
    project: &'p AxisProject,
    complete_count: usize,
    rejected: Rejected,
    watch: &W,
) -> Result<Sizing<'p>, W::Stop> {
    let products = products_of(project);
    let all_complete = complete_count >= products.len();
    let scope = match rejected {
        _ if all_complete => Scope::All,
        Rejected::Reasons | Rejected::All => Scope::Ranking,
        Rejected::None | Rejected::Nearest => Scope::Deciding,
    };
    let depth = match rejected {
        Rejected::None | Rejected::Nearest => Depth::UntilRejected,
        Rejected::Reasons => Depth::Failing,
        Rejected::All => Depth::Complete,
    };
    let parts = by_drivetrain(products);
    let begin = || {
        let mut judging = Judging::of(project, scope, depth);
        move |part: &&'p [Product]| judged(&mut judging, part, watch)
    };
    let mut candidates = Vec::with_capacity(products.len());
    in_parallel(&parts, begin)?.into_iter().for_each(|part| candidates.extend(part));
    if rejected == Rejected::Nearest && !candidates.iter().any(Candidate::fits) {
        settle_nearest(project, &mut candidates, watch)?;
    }
    // Best first.
    candidates.sort_by_cached_key(|candidate| RankKey::of(&candidate.standing));
    let fitting = candidates.partition_point(Candidate::fits);
    if !all_complete {
        let mut judging = Judging::of(project, Scope::All, Depth::Complete);
        for candidate in candidates.iter_mut().take(complete_count) {
            watch.step()?;
            candidate.judgement = judging.judge(candidate.parameters);
        }
    }
    Ok(Sizing {
        name: &project.name,
        candidates,
        fitting,
        by_mass: project.catalogue().has_files(),
        own: project.actuator.as_ref().map(|own| own_candidate(project, own)),
        assumptions: &project.assumptions,
    })
}

/// Judges by every check the candidates that may come first if none fits, so that the actuator with the smallest excess
/// is that of [`Rejected::All`]. A candidate judged up to its first failing check exceeds the limits at least by this
/// check, so the remaining ones rank behind the result.
fn settle_nearest<W: StepObserver>(
    project: &AxisProject,
    candidates: &mut [Candidate<'_>],
    watch: &W,
) -> Result<(), W::Stop> {
    let mut judging = Judging::of(project, Scope::Deciding, Depth::Complete);
    let mut settle = |candidates: &mut [Candidate<'_>], counts: fn(&Candidate<'_>) -> bool| {
        let keys = candidates.iter().map(|candidate| RankKey::of(&candidate.standing)).zip(0..);
        let mut order: Vec<(RankKey, usize)> = keys.collect();
        order.sort_unstable();
        let mut first: Option<RankKey> = None;
        for (least, place) in order {
            if first.is_some_and(|first| least > first) {
                break;
            }
            let Some(candidate) = candidates.get_mut(place).filter(|candidate| counts(candidate)) else { continue };
            watch.step()?;
            candidate.judgement = judging.judge(candidate.parameters);
            candidate.stand();
            if counts(candidate) {
                let key = RankKey::of(&candidate.standing);
                first = Some(first.map_or(key, |first| first.min(key)));
            }
        }
        Ok::<_, W::Stop>(first.is_some())
    };
    if settle(candidates, may_be_near)? {
        return Ok(());
    }
    // Each is excluded by a requirement: the one that misses the fewest is known only when all are judged.
    for candidate in candidates {
        watch.step()?;
        candidate.judgement = judging.judge(candidate.parameters);
        candidate.stand();
    }
    Ok(())
}

/// Processes the parts with all threads; the results are in the order of the parts. Fitting actuators are judged by
/// more checks and are adjacent in the catalogue, so an idle thread takes over parts of another.
fn in_parallel<'t, T: Sync, R: Send, S: Send, F: FnMut(&'t T) -> Result<R, S>>(
    parts: &'t [T],
    begin: impl Fn() -> F + Sync + Send,
) -> Result<Vec<R>, S> {
    parts.par_iter().map_init(begin, |one, part| one(part)).collect()
}

/// Returns a datum in SI, if it is known.
pub(crate) fn known_si<Q: Measure>(datum: &Datum<Q>) -> Option<f64> {
    datum.known().map(|known| known.value.si())
}

/// Smallest number of actuators in a part.
const PART: usize = 8;

/// Splits the catalogue into parts for the threads, at the boundaries of drivetrains: neighbours share the results for
/// their drivetrain.
fn by_drivetrain(products: &[Product]) -> Vec<&[Product]> {
    let mut parts = Vec::with_capacity(products.len() / PART + 1);
    let mut rest = products;
    while let Some(last) = rest.get(PART - 1) {
        let drivetrain = &last.parameters.drivetrain;
        let same = |product: &&Product| Arc::ptr_eq(&product.parameters.drivetrain, drivetrain);
        let (part, further) = rest.split_at(PART + rest.iter().skip(PART).take_while(same).count());
        parts.push(part);
        rest = further;
    }
    if !rest.is_empty() {
        parts.push(rest);
    }
    parts
}

/// Judges each product as a candidate, with the options that the project requires.
fn judged<'p, W: StepObserver>(
    judging: &mut Judging<'p>,
    products: &'p [Product],
    watch: &W,
) -> Result<Vec<Candidate<'p>>, W::Stop> {
    let project = judging.project;
    let mut candidates = Vec::with_capacity(products.len());
    for product in products {
        watch.step()?;
        let Some(id) = product.with_options(project.option_1, project.option_2) else { continue };
        candidates.push(candidate(judging, id, product));
    }
    Ok(candidates)
}

/// Judges one product for the axis of a project: of the catalogue, or the actuator that the project describes.
///
/// # Errors
/// [`Refusal`] if the product cannot be ordered or has no data.
pub fn check<'p, I>(project: &'p AxisProject, id: &I) -> Result<Candidate<'p>, Refusal>
where
    for<'i> ProductId: From<&'i I>,
{
    check_with(project, id.into(), Judging::of(project, Scope::All, Depth::Complete))
}

/// Judges one product by the checks of one part alone, without the cost of the others.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_part<'p>(project: &'p AxisProject, id: &ProductId, part: Part) -> Result<Candidate<'p>, Refusal> {
    check_with(project, id.clone(), Judging::of_part(project, part))
}

fn check_with<'p>(project: &'p AxisProject, id: ProductId, mut judging: Judging<'p>) -> Result<Candidate<'p>, Refusal> {
    id.availability().map_err(Refusal::Broken)?;
    let own = project.actuator.as_ref().filter(|own| own.id == id);
    let product = own.or_else(|| project.catalogue().product(&id));
    let product = product.ok_or_else(|| not_offered(&**project.catalogue(), &id))?;
    Ok(candidate(&mut judging, id, product))
}

/// Returns the reason why an answer about a product lacks a datum.
pub(crate) fn without_datum(product: &Product, symbol: &'static str) -> Refusal {
    if product.is_described() { Refusal::NotStated { name: product.id.to_string(), symbol } } else { Refusal::NoData }
}

/// Returns the reason why a catalogue has no product with an identity.
pub(crate) fn not_offered(catalogue: &dyn Catalogue, id: &ProductId) -> Refusal {
    if id.order_code().is_some() {
        return Refusal::NoData;
    }
    let name = id.to_string();
    let names: Vec<String> = catalogue.products(false).iter().map(|product| product.id.to_string()).collect();
    let near = match project::nearest_name(&name, &names.iter().map(String::as_str).collect::<Vec<_>>()) {
        project::Hint::DidYouMean(near) => Some(near),
        _ => None,
    };
    Refusal::NoProduct { name, near }
}

/// Judges one product like [`check`], each check with the workings of its value and its limit.
///
/// # Errors
/// As [`check`].
pub fn explain<'p, I>(project: &'p AxisProject, id: &I) -> Result<Candidate<'p>, Refusal>
where
    for<'i> ProductId: From<&'i I>,
{
    Ok(explained(project, check(project, id)?))
}

/// Judges a candidate again, each check with the workings of its value and its limit.
pub(crate) fn explained<'p>(project: &'p AxisProject, mut candidate: Candidate<'p>) -> Candidate<'p> {
    candidate.judgement = Judging::explaining(project).judge(candidate.parameters);
    candidate
}

/// Judges the user's own actuator like [`check_own`], each check with its workings.
///
/// # Errors
/// As [`check_own`].
pub fn explain_own(project: &AxisProject) -> Result<Candidate<'_>, Refusal> {
    Ok(explained(project, check_own(project)?))
}

/// Judges the user's own actuator.
///
/// # Errors
/// [`Refusal::NoActuator`] if the project describes none.
pub fn check_own(project: &AxisProject) -> Result<Candidate<'_>, Refusal> {
    project.actuator.as_ref().map(|own| own_candidate(project, own)).ok_or(Refusal::NoActuator)
}

/// Judges a product; without one the user's own actuator.
///
/// # Errors
/// As [`check`] and [`check_own`].
pub(crate) fn check_one<'p>(project: &'p AxisProject, id: Option<&ProductId>) -> Result<Candidate<'p>, Refusal> {
    id.map_or_else(|| check_own(project), |id| check(project, id))
}

/// Returns the cycle of a project's axis on a candidate as time series, with every sample of its recordings.
#[must_use]
pub fn course(project: &AxisProject, candidate: &Candidate<'_>) -> Course {
    Course::of(&project.axis, candidate.parameters)
}

/// Returns the largest number of instants of this course, which is the number of rows of its table.
#[must_use]
pub fn course_rows(project: &AxisProject) -> usize {
    Course::instants_most(&project.axis)
}

/// Returns the course with the instants of a picture, over the cycle or between two instants \[s\].
#[must_use]
pub fn course_seen(project: &AxisProject, candidate: &Candidate<'_>, window: Option<(f64, f64)>) -> Course {
    Course::seen(&project.axis, candidate.parameters, window)
}

/// Computes the largest permissible changes of the axis of a project up to which a candidate fits, within the default
/// effort.
#[must_use]
pub fn reserve_of(project: &AxisProject, candidate: &Candidate<'_>) -> Reserve {
    finished(reserve_watched(&project.axis, candidate.parameters, SAMPLES_ANEW, &Unobserved))
}

/// Judges actuators one after the other for the axis of a project; the checks cite the keys of its file.
struct Judging<'p> {
    project: &'p AxisProject,
    judge: Judge<'p>,
    cited: InputKeys<'p>,
}

impl<'p> Judging<'p> {
    fn of(project: &'p AxisProject, scope: Scope, depth: Depth) -> Self {
        Self { project, judge: Judge::new(&project.axis, scope, depth), cited: InputKeys::of(project) }
    }

    fn of_part(project: &'p AxisProject, part: Part) -> Self {
        Self { project, judge: Judge::of_part(&project.axis, part), cited: InputKeys::of(project) }
    }

    fn explaining(project: &'p AxisProject) -> Self {
        Self { project, judge: Judge::explaining(&project.axis), cited: InputKeys::of(project) }
    }

    fn judge(&mut self, parameters: &Parameters) -> Judgement {
        let Self { judge, cited, .. } = self;
        judge.next(parameters, &mut |check, governing| cited.cite(check, governing))
    }
}

fn candidate<'p>(judging: &mut Judging<'p>, id: ProductId, product: &'p Product) -> Candidate<'p> {
    let project = judging.project;
    let parameters = &product.parameters;
    let judgement = judging.judge(parameters);
    let (unmet, open_requirements): (Vec<Unmet>, Vec<Unmet>) =
        project.requirements.unmet(&id, product).partition(|unmet| unmet.rejects(product));
    let mut objections: Vec<Objection> = unmet.into_iter().map(Objection::Unmet).collect();
    // A product without options is in the catalogue because it is available; only options can change that.
    let on_request = match id.has_options().then(|| id.availability()) {
        None => Vec::new(),
        Some(Ok(found)) => found.on_request,
        Some(Err(broken)) => {
            objections.extend(broken.into_iter().map(Objection::Rule));
            Vec::new()
        }
    };
    let met = objections.is_empty();
    let is_among_makers = project.catalogue().has_files();
    let size = product.rank_size(is_among_makers);
    let standing = Standing::of(&judgement, met, size, known_si(&parameters.mass));
    Candidate {
        id,
        product,
        parameters,
        on_request,
        judgement,
        objections,
        open_requirements,
        standing,
        is_best_of_ranking: false,
        is_among_makers,
    }
}

fn own_candidate<'p>(project: &'p AxisProject, own: &'p Product) -> Candidate<'p> {
    candidate(&mut Judging::of(project, Scope::All, Depth::Complete), own.id.clone(), own)
}
