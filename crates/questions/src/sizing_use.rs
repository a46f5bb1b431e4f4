//! Ranking the catalogue for an axis, and judging one actuator.

use crate::cited::Cited;
use crate::patience::Stopped;
use actuator::Parameters;
use configurator::{BrokenRule, Unmet, actuators, availability};
use order_code::{Option1, Option2, OrderCode};
use project::{Assumption, OwnActuator, Project};
use provenance::Datum;
use quantities::Measure;
use rayon::prelude::*;
use sizing::{
    Check, CheckId, Course, Depth, Fit, Judge, Judgement, Part, RankKey, Reserve, SAMPLES_ANEW, Scope, Standing,
    Unwatched, Verdict, Watch, finished, reserve_watched,
};
use std::sync::Arc;

pub use crate::candidate::{Candidate, CandidateId, Objection, Reason, by_importance};

/// Of which rejected actuators of a ranking every failing check is found; the others are judged until one fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejected {
    /// Of none: whether and which fit is all that is needed.
    None,
    /// Of as many as may be the nearest miss where nothing fits.
    Nearest,
    /// Of all: they are listed with their reasons.
    All,
}

/// The catalogue judged for one axis.
#[derive(Clone, Debug)]
pub struct Sizing<'p> {
    /// Name of the axis.
    pub name: &'p str,
    /// Every candidate, best first.
    pub candidates: Vec<Candidate<'p>>,
    /// How many of them fit: the first ones.
    fitting: usize,
    /// The user's own actuator, judged beside the catalogue.
    pub own: Option<Candidate<'p>>,
    /// Defaults that were taken.
    pub assumptions: &'p [Assumption],
}

impl<'p> Sizing<'p> {
    /// The candidates that fit, best first.
    #[must_use]
    pub fn fitting(&self) -> &[Candidate<'p>] {
        self.candidates.get(..self.fitting).unwrap_or_default()
    }

    /// The candidates that do not fit, the one that misses by least first.
    #[must_use]
    pub fn rejected(&self) -> &[Candidate<'p>] {
        self.candidates.get(self.fitting..).unwrap_or_default()
    }

    /// How many fit within every limit, and how many others if an estimate holds.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        let certain = self.fitting().iter().filter(|candidate| candidate.fit() == Fit::Fits).count();
        [certain, self.fitting - certain]
    }

    /// The rejected candidate that misses by least, among those that meet what the project requires and are of the right
    /// class: no other actuator's voltage or temperature range is near.
    #[must_use]
    pub fn nearest_miss(&self) -> Option<&Candidate<'p>> {
        self.rejected().iter().find(|candidate| may_be_near(candidate))
    }

    /// The best candidate, if one fits.
    #[must_use]
    pub fn answer(&self) -> Option<&Candidate<'p>> {
        self.fitting().first()
    }

    /// The candidate that every answer about the axis names: the best, else the nearest miss, else the first of the others.
    #[must_use]
    pub fn named(&self) -> Option<&Candidate<'p>> {
        self.answer().or_else(|| self.nearest_miss()).or_else(|| self.candidates.first())
    }

    /// The verdict on the best, the user's own actuator included.
    #[must_use]
    pub fn fit(&self) -> Fit {
        let best = self.answer().map_or(Fit::DoesNotFit, Candidate::fit);
        self.own.as_ref().map_or(best, |own| best.min(own.fit()))
    }

    /// Returns `true` if any candidate fits, the user's own included.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.fit().fits()
    }
}

/// Returns `true` unless an objection or a check that neither load nor pace can mend speaks against a candidate.
fn may_be_near(candidate: &Candidate<'_>) -> bool {
    let of_the_place = |check: &Check| check.verdict == Verdict::Fail && check.id.is_of_the_place();
    candidate.objections.is_empty() && !candidate.judgement.checks.iter().any(of_the_place)
}

/// Why an actuator cannot be judged.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The code breaks rules of the ordering tables.
    Broken(Vec<BrokenRule>),
    /// The manual prints no data for this code.
    NoData,
    /// The project describes no actuator of its own, and no code is given.
    NoActuator,
    /// This check is not part of the judgement of this axis and actuator.
    NotAsked(CheckId),
    /// So many samples of the tolerances cost more than is done where no time is named.
    TooManySamples {
        /// Requested.
        asked: usize,
        /// At most, for this axis and these actuators.
        most: usize,
    },
    /// So long recordings cost more than is done where no time is named.
    TooLong {
        /// Samples in use.
        samples: usize,
        /// At most under a load such as theirs.
        most: usize,
        /// How long those take, about \[s\].
        seconds: usize,
    },
    /// Several axes take longer together than is done where no time is named.
    TooManyAxes {
        /// How many.
        axes: usize,
        /// How long is waited, about \[s\].
        seconds: usize,
    },
    /// The catalogue is not judged for each of several ratios of a stage where no time is named.
    TooManyRatios {
        /// How many.
        ratios: usize,
        /// How long is waited, about \[s\].
        seconds: usize,
    },
    /// A table of the course takes more memory than the project is allowed.
    TooManyRows {
        /// Rows, at most.
        rows: usize,
        /// Bytes that they take.
        needed: u64,
        /// Bytes that are allowed.
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

/// The actuators of the catalogue with the curves of a project.
pub(crate) fn actuators_of(project: &Project, output_encoder: bool) -> &[(OrderCode, Parameters)] {
    match &project.own_catalogue {
        Some(own) => own.actuators(output_encoder),
        None => actuators(output_encoder),
    }
}

/// Judges the whole catalogue for the axis of a project and ranks it; whatever fits by every check.
///
/// Cost: O(ramps) to prepare the motion, O(ramps) per actuator, O(n log n) to rank.
#[must_use]
pub fn size(project: &Project) -> Sizing<'_> {
    finished(size_watched(project, usize::MAX, Rejected::All, &Unwatched))
}

/// Judges and ranks like [`size`], but can be cancelled; only the first `complete_count` are judged by every check, the others by those of a
/// ranking ([`Scope::Ranking`]), and those that are rejected as far as `rejected` states.
///
/// # Errors
/// Where it was stopped.
pub(crate) fn size_watched<'p, W: Watch>(
    project: &'p Project,
    complete_count: usize,
    rejected: Rejected,
    watch: &W,
) -> Result<Sizing<'p>, W::Stop> {
    let actuators = actuators_of(project, project.option_1.is_some());
    let all_complete = complete_count >= actuators.len();
    let scope = if all_complete { Scope::All } else { Scope::Ranking };
    let depth = if rejected == Rejected::All { Depth::Complete } else { Depth::UntilRejected };
    let parts = by_drivetrain(actuators);
    let begin = || {
        let mut judging = Judging::of(project, scope, depth);
        move |part: &&'p [(OrderCode, Parameters)]| judged(&mut judging, part, watch)
    };
    let mut candidates = Vec::with_capacity(actuators.len());
    in_parallel(&parts, begin)?.into_iter().for_each(|part| candidates.extend(part));
    if rejected == Rejected::Nearest && !candidates.iter().any(Candidate::fits) {
        settle_nearest(project, &mut candidates, watch)?;
    }
    let mut candidates = ranked(candidates);
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
        own: project.actuator.as_ref().map(|own| own_candidate(project, own)),
        assumptions: &project.assumptions,
    })
}

/// Judges those candidates by every check that may come first where none fits, so that the nearest miss is that of
/// [`Rejected::All`]. What was judged until a check failed misses by at least that check: the others come behind what is found.
fn settle_nearest<W: Watch>(project: &Project, candidates: &mut [Candidate<'_>], watch: &W) -> Result<(), W::Stop> {
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
    if !settle(candidates, may_be_near)? {
        settle(candidates, |_| true)?;
    }
    Ok(())
}

/// Work on each of several parts, by as many threads as there are; the answers stand in the order of the parts. Those that fit
/// are judged by more checks and stand together in the catalogue, so a thread that is done takes over parts of another.
fn in_parallel<'t, T: Sync, R: Send, S: Send, F: FnMut(&'t T) -> Result<R, S>>(
    parts: &'t [T],
    begin: impl Fn() -> F + Sync + Send,
) -> Result<Vec<R>, S> {
    parts.par_iter().map_init(begin, |one, part| one(part)).collect()
}

/// A datum in SI, where it is known.
pub(crate) fn known_si<Q: Measure>(datum: &Datum<Q>) -> Option<f64> {
    datum.known().map(|known| known.value.si())
}

/// Candidates, best first.
fn ranked(candidates: Vec<Candidate<'_>>) -> Vec<Candidate<'_>> {
    let mut order: Vec<(RankKey, usize)> = candidates.iter().map(|c| RankKey::of(&c.standing)).zip(0..).collect();
    order.sort_unstable();
    let mut open: Vec<Option<Candidate<'_>>> = candidates.into_iter().map(Some).collect();
    order.into_iter().filter_map(|(_, was)| open.get_mut(was)?.take()).collect()
}

/// A part has at least so many actuators.
const PART: usize = 8;

/// The catalogue in parts for the threads, cut where one drivetrain ends: neighbours share what is found of it.
fn by_drivetrain(actuators: &[(OrderCode, Parameters)]) -> Vec<&[(OrderCode, Parameters)]> {
    let mut parts = Vec::with_capacity(actuators.len() / PART + 1);
    let mut rest = actuators;
    while let Some((_, last)) = rest.get(PART - 1) {
        let drivetrain = &last.drivetrain;
        let same = |(_, parameters): &&(OrderCode, Parameters)| Arc::ptr_eq(&parameters.drivetrain, drivetrain);
        let (part, further) = rest.split_at(PART + rest.iter().skip(PART).take_while(same).count());
        parts.push(part);
        rest = further;
    }
    if !rest.is_empty() {
        parts.push(rest);
    }
    parts
}

/// Each actuator as a candidate, with the options that the project requires.
fn judged<'p, W: Watch>(
    judging: &mut Judging<'p>,
    actuators: &'p [(OrderCode, Parameters)],
    watch: &W,
) -> Result<Vec<Candidate<'p>>, W::Stop> {
    let project = judging.project;
    let mut candidates = Vec::with_capacity(actuators.len());
    for (code, parameters) in actuators {
        watch.step()?;
        let Some(code) = with_options(project, code) else { continue };
        candidates.push(candidate(judging, code, parameters));
    }
    Ok(candidates)
}

/// A code with the options that the project requires; `None` where its series does not have them.
pub(crate) fn with_options(project: &Project, code: &OrderCode) -> Option<OrderCode> {
    let series = code.series();
    let option_1 = project.option_1.and_then(|option| Option1::of(series, option.as_str()));
    let option_2 = project.option_2.and_then(|option| Option2::of(series, option.as_str()));
    let has_both = (option_1.is_none(), option_2.is_none()) == (project.option_1.is_none(), project.option_2.is_none());
    has_both.then_some(OrderCode { option_1, option_2, ..*code })
}

/// Judges one code for the axis of a project.
///
/// # Errors
/// [`Refusal`] where the code cannot be ordered or has no printed data.
pub fn check<'p>(project: &'p Project, code: &OrderCode) -> Result<Candidate<'p>, Refusal> {
    availability(code).map_err(Refusal::Broken)?;
    Ok(candidate(&mut Judging::of(project, Scope::All, Depth::Complete), *code, parameters_of(project, code)?))
}

/// Judges one code by the checks of one part alone: what the others cost is saved.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_part<'p>(project: &'p Project, code: &OrderCode, part: Part) -> Result<Candidate<'p>, Refusal> {
    availability(code).map_err(Refusal::Broken)?;
    Ok(candidate(&mut Judging::of_part(project, part), *code, parameters_of(project, code)?))
}

/// The data of an actuator, with the curves of a project and whatever options its code has.
///
/// # Errors
/// [`Refusal::NoData`]
pub(crate) fn parameters_of<'p>(project: &'p Project, code: &OrderCode) -> Result<&'p Parameters, Refusal> {
    let bare = OrderCode { option_1: None, option_2: None, special: false, ..*code };
    let mut known = actuators_of(project, code.has_output_encoder()).iter();
    known.find(|(known, _)| *known == bare).map(|(_, parameters)| parameters).ok_or(Refusal::NoData)
}

/// Judges one code as [`check`] does, each check with the workings of its value and its limit.
///
/// # Errors
/// As [`check`].
pub fn explain<'p>(project: &'p Project, code: &OrderCode) -> Result<Candidate<'p>, Refusal> {
    let mut candidate = check(project, code)?;
    candidate.judgement = Judging::explaining(project).judge(candidate.parameters);
    Ok(candidate)
}

/// Judges the user's own actuator as [`check_own`] does, each check with its workings.
///
/// # Errors
/// As [`check_own`].
pub fn explain_own(project: &Project) -> Result<Candidate<'_>, Refusal> {
    let mut candidate = check_own(project)?;
    candidate.judgement = Judging::explaining(project).judge(candidate.parameters);
    Ok(candidate)
}

/// Judges the user's own actuator.
///
/// # Errors
/// [`Refusal::NoActuator`] if the project describes none.
pub fn check_own(project: &Project) -> Result<Candidate<'_>, Refusal> {
    project.actuator.as_ref().map(|own| own_candidate(project, own)).ok_or(Refusal::NoActuator)
}

/// Judges the actuator of a code; without one the user's own.
///
/// # Errors
/// As [`check`] and [`check_own`].
pub(crate) fn check_one<'p>(project: &'p Project, code: Option<&OrderCode>) -> Result<Candidate<'p>, Refusal> {
    code.map_or_else(|| check_own(project), |code| check(project, code))
}

/// The cycle of a project's axis on a candidate as time series, with every sample of its recordings.
#[must_use]
pub fn course(project: &Project, candidate: &Candidate<'_>) -> Course {
    Course::of(&project.axis, candidate.parameters)
}

/// How many instants that course has at most: what a table of it has as rows.
#[must_use]
pub fn course_rows(project: &Project) -> usize {
    Course::instants_most(&project.axis)
}

/// The same as a picture of it shows, or as one of the time between two instants \[s\].
#[must_use]
pub fn course_seen(project: &Project, candidate: &Candidate<'_>, window: Option<(f64, f64)>) -> Course {
    Course::seen(&project.axis, candidate.parameters, window)
}

/// How far the axis of a project may be changed until a candidate just fits, within the usual effort.
#[must_use]
pub fn reserve_of(project: &Project, candidate: &Candidate<'_>) -> Reserve {
    finished(reserve_watched(&project.axis, candidate.parameters, SAMPLES_ANEW, &Unwatched))
}

/// Judges one actuator after the other for the axis of a project, whose keys the checks cite as its file has them.
struct Judging<'p> {
    project: &'p Project,
    judge: Judge<'p>,
    cited: Cited<'p>,
}

impl<'p> Judging<'p> {
    fn of(project: &'p Project, scope: Scope, depth: Depth) -> Self {
        Self { project, judge: Judge::new(&project.axis, scope, depth), cited: Cited::of(project) }
    }

    fn of_part(project: &'p Project, part: Part) -> Self {
        Self { project, judge: Judge::of_part(&project.axis, part), cited: Cited::of(project) }
    }

    fn explaining(project: &'p Project) -> Self {
        Self { project, judge: Judge::explaining(&project.axis), cited: Cited::of(project) }
    }

    fn judge(&mut self, parameters: &Parameters) -> Judgement {
        let Self { judge, cited, .. } = self;
        judge.next(parameters, &mut |check, governing| cited.cite(check, governing))
    }
}

fn candidate<'p>(judging: &mut Judging<'p>, code: OrderCode, parameters: &'p Parameters) -> Candidate<'p> {
    let project = judging.project;
    let judgement = judging.judge(parameters);
    let mut objections: Vec<Objection> = project.requirements.unmet(&code, parameters).map(Objection::Unmet).collect();
    // Without options the code stands in the catalogue because it is available; only options can change that.
    let optional = code.option_1.is_some() || code.option_2.is_some() || code.special;
    let on_request = match optional.then(|| availability(&code)) {
        None => Vec::new(),
        Some(Ok(found)) => found.on_request,
        Some(Err(broken)) => {
            objections.extend(broken.into_iter().map(Objection::Rule));
            Vec::new()
        }
    };
    let mass = known_si(&parameters.mass);
    let standing = Standing::of(&judgement, objections.is_empty(), code.size.number(), mass);
    Candidate { id: CandidateId::Code(code), on_request, parameters, judgement, objections, standing }
}

fn own_candidate<'p>(project: &'p Project, own: &'p OwnActuator) -> Candidate<'p> {
    let judgement = Judging::of(project, Scope::All, Depth::Complete).judge(&own.parameters);
    let objections: Vec<Objection> =
        project.requirements.unmet_by_data(&own.parameters).map(Objection::Unmet).collect();
    // Of a user's actuator little may be known: an unknown datum leaves a requirement open, it does not break it.
    let met = objections.iter().all(|objection| matches!(objection, Objection::Unmet(Unmet::NotKnown { .. })));
    let standing = Standing::of(&judgement, met, 0, known_si(&own.parameters.mass));
    Candidate {
        id: CandidateId::Own(own.name.clone()),
        on_request: Vec::new(),
        parameters: &own.parameters,
        judgement,
        objections,
        standing,
    }
}
