//! Judges actuators for one axis, one after the other.

use crate::axis::Axis;
use crate::bearing_checks::Borne;
use crate::check::{Check, CheckId, Fit, Margin, Part as Concerns, Verdict};
use crate::currents::Currents;
use crate::demand::{Demand, ManualDemand};
use crate::electrics::Electrics;
use crate::energy;
use crate::list::{Answer, Case, Stage};
use crate::notes::Note;
use crate::watch::Watch;
use actuator::{Drivetrain, Parameters};
use derivation::Workings;
use numeric::at_least;
use std::sync::{Arc, LazyLock};

/// Room for the checks of one actuator that is rejected, without those of its drivetrain, and for all of one that is not,
/// so that judging many does not grow one vector after the other.
const ROOM: [usize; 2] = [8, 24];

/// Room for the checks that actuators of one drivetrain, or with one output bearing, share.
const ROOM_SHARED: usize = 8;

/// Everything there is to say about one actuator for one axis.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// The demand by exact integrals; checks use it. `None` if the own inertia is not known.
    pub demand: Option<Demand>,
    /// The demand by the manual's equations, shown beside it.
    pub manual: Option<ManualDemand>,
    /// Every check, in a fixed order.
    pub checks: Checks,
}

impl Judgement {
    /// Returns `true` if no check fails.
    #[must_use]
    pub fn fits(&self) -> bool {
        !self.checks.any_fails()
    }

    /// Verdict by the checks alone.
    #[must_use]
    pub fn fit(&self) -> Fit {
        match self.checks.extremes() {
            Extremes { failing: Some(_), .. } => Fit::DoesNotFit,
            Extremes { is_inside_band: true, .. } => Fit::FitsIfEstimate,
            Extremes { .. } => Fit::Fits,
        }
    }

    /// The check that decides: the failing one that is exceeded most; where none fails, the one with a margin whose
    /// utilisation is the largest.
    ///
    /// Two checks may have the same utilisation, as those of the mean speed at the output and at the motor; they differ in the
    /// rounding of one machine at most, and the last of them in the order of the checks is meant on every machine.
    #[must_use]
    pub fn governing(&self) -> Option<&Check> {
        self.checks.governing()
    }

    /// The governing check where it fails.
    #[must_use]
    pub fn worst_failure(&self) -> Option<&Check> {
        self.governing().filter(|check| check.verdict == Verdict::Fail)
    }

    /// Utilisation of the governing check; infinite where it fails and has none, since its limit is zero or a range.
    #[must_use]
    pub fn utilisation(&self) -> f64 {
        let Extremes { failing, margin, .. } = self.checks.extremes();
        failing.unwrap_or(margin)
    }

    /// Whether the load hangs and nothing holds it without power.
    #[must_use]
    pub fn leaves_load_unheld(&self) -> bool {
        let held = |check: &&Check| check.id == CheckId::BrakeHolding;
        let found = self.checks.own.iter().find(held);
        found.is_some_and(|check| check.notes.contains(&Note::NothingHoldsWithoutPower))
    }

    /// Adds the energy that comes back to a judgement that left it out, at its place; see [`energies`].
    pub fn complete(&mut self, mut energy: Check, naming: Naming<'_>) {
        naming(&mut energy, self.manual.as_ref().map_or(0, |manual| manual.governing));
        let own = &mut self.checks.own;
        let place = own.iter().position(|check| check.id.place() > energy.id.place());
        own.insert(place.unwrap_or(own.len()), energy);
    }

    /// Whether it says what energy comes back, or why that is not known.
    #[must_use]
    pub fn tells_energy(&self) -> bool {
        self.checks.own.iter().any(|check| check.id.stage() == Stage::Pass)
    }
}

/// The governing check of some, see [`Judgement::governing`].
fn governing<'c>(checks: impl Iterator<Item = &'c Check> + Clone) -> Option<&'c Check> {
    let fails = checks.clone().any(|check| check.verdict == Verdict::Fail);
    let counts = move |check: &&Check| match fails {
        true => check.verdict == Verdict::Fail,
        false => check.id.has_margin() && check.utilisation.is_some(),
    };
    let largest = checks.clone().filter(counts).map(Check::severity).max_by(f64::total_cmp)?;
    last_of_equal(checks.filter(counts).map(|check| (check.severity(), check)), largest)
}

/// The last of those whose share is the largest but for rounding.
pub(crate) fn last_of_equal<T>(shares: impl IntoIterator<Item = (f64, T)>, largest: f64) -> Option<T> {
    shares.into_iter().filter(|(share, _)| at_least(*share, largest)).last().map(|(_, of)| of)
}

/// How far a judgement goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Every check.
    Full,
    /// The checks that look at the cycle once more only if none of the others fails.
    Survivors,
    /// The same without the energy that comes back, which costs a pass over the whole cycle: many find it together, see
    /// [`energies`]. Without a required limit it affects no verdict and no utilisation.
    Ranking,
    /// Every check that can fail or has a margin: what is only shown or advised is left out, and so is the demand by
    /// the manual, and the energy that comes back where its bounds are below another utilisation. Verdict and utilisation
    /// are those of [`Depth::Full`].
    Margins,
    /// The same, but the checks that look at the cycle once more only if none of the others fails. Verdict and utilisation are
    /// those of [`Depth::Survivors`].
    Rank,
}

impl Depth {
    /// Whether what can neither fail nor has a margin is left out.
    const fn is_bare(self) -> bool {
        match self {
            Self::Margins | Self::Rank => true,
            Self::Full | Self::Survivors | Self::Ranking => false,
        }
    }

    /// Whether the checks that look at the cycle once more are made of those only that no other rejects.
    const fn is_of_survivors(self) -> bool {
        match self {
            Self::Survivors | Self::Ranking | Self::Rank => true,
            Self::Full | Self::Margins => false,
        }
    }
}

/// What decides among some checks.
#[derive(Clone, Copy, Debug, Default)]
struct Extremes {
    /// Largest severity of those that fail, if any does.
    failing: Option<f64>,
    /// Largest utilisation of those with a margin; zero where none has one.
    margin: f64,
    is_inside_band: bool,
}

impl Extremes {
    fn of(checks: &[Check]) -> Self {
        checks.iter().fold(Self::default(), |found, check| {
            found.and(Self {
                failing: (check.verdict == Verdict::Fail).then(|| check.severity()),
                margin: check.utilisation.filter(|_| check.id.has_margin()).unwrap_or(0.0),
                is_inside_band: check.is_inside_band(),
            })
        })
    }

    fn and(self, other: Self) -> Self {
        let both = [self.failing, other.failing];
        Self {
            failing: both.into_iter().flatten().reduce(f64::max),
            margin: self.margin.max(other.margin),
            is_inside_band: self.is_inside_band || other.is_inside_band,
        }
    }
}

/// The largest utilisation among some checks that fail or have a margin; zero where none has one.
fn largest(checks: &[Check]) -> f64 {
    let share = |check: &Check| match check.utilisation {
        None if check.verdict == Verdict::Fail && check.id.margin() != Margin::Range => f64::INFINITY,
        share => share.unwrap_or(0.0),
    };
    let counted = checks.iter().filter(|check| check.id.has_margin() || check.verdict == Verdict::Fail);
    counted.map(share).fold(0.0, f64::max)
}

/// The checks of an actuator in a fixed order. What hangs on the axis and on the drivetrain alone is shared by the
/// judgements of all actuators with that drivetrain, what hangs on the output bearing by all with that bearing.
#[derive(Clone, Debug, Default)]
pub struct Checks {
    own: Vec<Check>,
    shared: [Part; 2],
}

/// Checks that several actuators share, with their places among those of one.
#[derive(Clone, Debug, Default)]
struct Part {
    shared: Option<Arc<Shared>>,
    /// Bit k: whether the check at that place is the next one of these.
    places: u64,
}

impl Part {
    fn checks(&self) -> &[Check] {
        self.shared.as_ref().map_or(&[], |shared| &shared.checks)
    }
}

/// The checks of a drivetrain or of an output bearing for one axis.
#[derive(Debug)]
struct Shared {
    checks: Vec<Check>,
    extremes: Extremes,
}

impl Checks {
    fn shared(&self) -> impl Iterator<Item = &Shared> {
        self.shared.iter().filter_map(|part| part.shared.as_deref())
    }

    /// How many they are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.own.len() + self.shared().map(|shared| shared.checks.len()).sum::<usize>()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Each in its order.
    #[must_use]
    pub fn iter(&self) -> InOrder<'_> {
        InOrder { own: self.own.iter(), shared: self.shared.each_ref().map(|part| (part.checks().iter(), part.places)) }
    }

    /// The check that decides, see [`Judgement::governing`].
    #[must_use]
    pub fn governing(&self) -> Option<&Check> {
        governing(self.iter())
    }

    fn extremes(&self) -> Extremes {
        self.shared().map(|shared| shared.extremes).fold(Extremes::of(&self.own), Extremes::and)
    }

    /// Returns `true` if one of them fails.
    fn any_fails(&self) -> bool {
        self.shared().any(|shared| shared.extremes.failing.is_some())
            || self.own.iter().any(|check| check.verdict == Verdict::Fail)
    }
}

/// The checks of an actuator, one after the other.
#[derive(Clone, Debug)]
pub struct InOrder<'c> {
    own: std::slice::Iter<'c, Check>,
    shared: [(std::slice::Iter<'c, Check>, u64); 2],
}

impl<'c> Iterator for InOrder<'c> {
    type Item = &'c Check;

    #[inline]
    fn next(&mut self) -> Option<&'c Check> {
        let mut from = &mut self.own;
        for (checks, places) in &mut self.shared {
            if *places & 1 == 1 {
                from = checks;
            }
            *places >>= 1;
        }
        from.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.own.len() + self.shared.iter().map(|(checks, _)| checks.len()).sum::<usize>();
        (left, Some(left))
    }
}

impl<'c> IntoIterator for &'c Checks {
    type Item = &'c Check;
    type IntoIter = InOrder<'c>;

    fn into_iter(self) -> InOrder<'c> {
        self.iter()
    }
}

/// Judges one actuator for one axis.
#[must_use]
pub fn judge(axis: &Axis, actuator: &Parameters, depth: Depth) -> Judgement {
    Judge::of(axis, depth).next(actuator, &mut |_, _| {})
}

/// Receives each check once, before it is returned, with the index of the move that governs by the manual: to
/// name the sources of the project as its file names them.
pub type Naming<'n> = &'n mut dyn FnMut(&mut Check, usize);

/// Judges one actuator after the other for one axis. Of neighbours with the same drivetrain what does not hang on feedback
/// and brake is found once.
pub struct Judge<'a> {
    axis: &'a Axis,
    depth: Depth,
    explain: bool,
    /// Judges what is rejected by the further checks that can fail, too.
    completes: bool,
    /// The checks of the axis in the order of their stages.
    listed: Vec<CheckId>,
    known: Option<Known>,
}

/// Every check in the order in which it is judged: by stages, within one by the list.
static IN_STAGES: LazyLock<Vec<CheckId>> = LazyLock::new(|| {
    let mut all = CheckId::ALL.to_vec();
    all.sort_by_key(|id| id.place());
    all
});

/// What was found of a drivetrain.
struct Known {
    drivetrain: Arc<Drivetrain>,
    electrics: Electrics,
    checks: Option<Named>,
    of_bearing: Option<Named>,
}

/// Checks named for a governing move.
type Named = (usize, Arc<Shared>);

/// The checks of one actuator on their way.
struct Gathered {
    own: Vec<Check>,
    count: u32,
    drivetrain: Gathering,
    bearing: Gathering,
}

/// Checks that several actuators share, on their way.
struct Gathering {
    known: Option<Arc<Shared>>,
    /// Where they are not known yet.
    new: Vec<Check>,
    places: u64,
}

impl Gathering {
    fn of(named: Option<&Named>, governing: usize) -> Self {
        let known = named.filter(|(named, _)| *named == governing).map(|(_, shared)| Arc::clone(shared));
        let new = Vec::with_capacity(if known.is_none() { ROOM_SHARED } else { 0 });
        Self { known, new, places: 0 }
    }

    fn take(&mut self, place: u32, check: impl FnOnce() -> Option<Check>) {
        self.places |= 1 << place;
        if self.known.is_none() {
            self.new.extend(check());
        }
    }

    /// All of them; what is new is named and kept for the next.
    fn all(mut self, governing: usize, naming: Naming<'_>, kept: &mut Option<Named>) -> Part {
        let shared = self.known.unwrap_or_else(|| {
            self.new.iter_mut().for_each(|check| naming(check, governing));
            let found = Arc::new(Shared { extremes: Extremes::of(&self.new), checks: self.new });
            *kept = Some((governing, Arc::clone(&found)));
            found
        });
        Part { shared: Some(shared), places: self.places }
    }
}

impl Gathered {
    fn own(&mut self, check: Check) {
        self.own.push(check);
        self.count += 1;
    }

    fn of_drivetrain(&mut self, check: impl FnOnce() -> Option<Check>) {
        self.drivetrain.take(self.count, check);
        self.count += 1;
    }

    fn of_bearing(&mut self, check: impl FnOnce() -> Option<Check>) {
        self.bearing.take(self.count, check);
        self.count += 1;
    }
}

impl<'a> Judge<'a> {
    /// Judges to some depth.
    #[must_use]
    pub fn of(axis: &'a Axis, depth: Depth) -> Self {
        let bare = depth.is_bare();
        let mut listed = Vec::with_capacity(IN_STAGES.len());
        listed.extend(IN_STAGES.iter().copied().filter(|id| id.is_listed(axis, bare)));
        Self { axis, depth, explain: false, completes: false, listed, known: None }
    }

    /// Judges to some depth, and what is rejected by every check that can fail: its failing checks and its governing check are
    /// then those of [`Depth::Full`].
    #[must_use]
    pub fn completing(axis: &'a Axis, depth: Depth) -> Self {
        Self { completes: true, ..Self::of(axis, depth) }
    }

    /// Judges by the checks of one part alone.
    #[must_use]
    pub fn of_part(axis: &'a Axis, part: Concerns) -> Self {
        let mut judge = Self::of(axis, Depth::Full);
        judge.listed.retain(|id| id.part() == part);
        judge
    }

    /// Judges by every check, each with the workings of its value and its limit.
    #[must_use]
    pub fn explaining(axis: &'a Axis) -> Self {
        Self { explain: true, ..Self::of(axis, Depth::Full) }
    }

    /// The judgement of one actuator.
    pub fn next(&mut self, actuator: &Parameters, naming: Naming<'_>) -> Judgement {
        let (axis, depth, explain) = (self.axis, self.depth, self.explain);
        let before = self.known.take();
        let is_same = |known: &Known| Arc::ptr_eq(&known.drivetrain, &actuator.drivetrain);
        let known = self.known.insert(match before {
            Some(known) if is_same(&known) => known,
            other => Known {
                drivetrain: Arc::clone(&actuator.drivetrain),
                electrics: Electrics::of(axis, actuator),
                checks: None,
                of_bearing: other
                    .filter(|other| other.drivetrain.output_bearing == actuator.output_bearing)
                    .and_then(|other| other.of_bearing),
            },
        });
        let inertia = actuator.inertia_out.known().map(|known| known.value);
        let demand = inertia.map(|inertia| axis.demand(inertia));
        let bare = depth.is_bare();
        let manual = inertia.filter(|_| !bare).and_then(|inertia| axis.manual_demand(inertia));
        let governing = manual.as_ref().map_or(0, |manual| manual.governing);
        let [rejected, all] = ROOM;
        let only_survivors = depth.is_of_survivors();
        let mut checks = Gathered {
            own: Vec::with_capacity(if only_survivors { rejected } else { all }),
            count: 0,
            drivetrain: Gathering::of(known.checks.as_ref(), governing),
            bearing: Gathering::of(known.of_bearing.as_ref(), governing),
        };
        let electrics = &known.electrics;
        let currents = Currents::of(axis, actuator, electrics);
        let bearing = axis.bearing.as_ref().map(|duty| Borne::of(axis, duty, &actuator.output_bearing));
        let case = &Case {
            axis,
            actuator,
            demand: demand.as_ref(),
            manual: manual.as_ref(),
            electrics,
            currents: currents.as_ref(),
            bearing: bearing.as_ref(),
        };
        let begin = self.listed.partition_point(|id| id.stage() == Stage::First);
        let (first, further) = self.listed.split_at(begin);
        first_checks(case, first, explain, &mut checks);
        let Gathered { own, drivetrain, bearing, .. } = checks;
        let shared = [
            drivetrain.all(governing, naming, &mut known.checks),
            bearing.all(governing, naming, &mut known.of_bearing),
        ];
        let mut checks = Checks { own, shared };
        let is_rejected = only_survivors && checks.any_fails();
        if !is_rejected || self.completes {
            let own = &mut checks.own;
            own.reserve_exact(all - own.len().min(all));
            // What neither fails nor has a margin says nothing about a rejection.
            let made = further.iter().copied().filter(|id| !is_rejected || id.can_fail(axis));
            further_checks(case, made, (depth, explain), own);
        }
        checks.own.iter_mut().for_each(|check| naming(check, governing));
        Judgement { demand, manual, checks }
    }
}

/// The check that [`Depth::Ranking`] leaves out, for several actuators in one pass over the cycle.
///
/// # Errors
/// Where it was stopped.
pub fn energies<W: Watch>(axis: &Axis, actuators: &[&Parameters], watch: &W) -> Result<Vec<Check>, W::Stop> {
    energy::regenerations(axis, actuators, watch)
}

/// The answer of a check, with its workings if an explanation is requested.
#[inline]
fn answered(id: CheckId, case: &Case<'_>, explain: bool) -> Option<Check> {
    if !explain {
        return id.of(case, &mut Workings::off());
    }
    let mut work = Workings::on();
    let mut check = id.of(case, &mut work)?;
    check.workings = work.into_steps().into();
    Some(check)
}

/// The checks that every actuator goes through.
fn first_checks(case: &Case<'_>, listed: &[CheckId], explain: bool, to: &mut Gathered) {
    for id in listed {
        let answer = || answered(*id, case, explain);
        match id.answer() {
            Answer::Actuator(_) | Answer::Concerned(_) => answer().into_iter().for_each(|check| to.own(check)),
            Answer::Drivetrain(_) => to.of_drivetrain(answer),
            Answer::Bearing(_) if case.bearing.is_none() => {}
            Answer::Bearing(_) => to.of_bearing(answer),
        }
    }
}

/// The checks that look at the cycle once more, and the rest.
fn further_checks(
    case: &Case<'_>,
    listed: impl Iterator<Item = CheckId>,
    (depth, explain): (Depth, bool),
    checks: &mut Vec<Check>,
) {
    let &Case { axis, actuator, currents, .. } = case;
    for id in listed {
        let is_made = id.stage() != Stage::Pass
            || match depth {
                Depth::Full | Depth::Survivors => true,
                Depth::Ranking => energy::is_missing(actuator, currents),
                // What passes and is below another utilisation changes neither verdict nor margin.
                Depth::Margins | Depth::Rank => !energy::is_below(axis, actuator, currents, largest(checks).min(1.0)),
            };
        if is_made {
            checks.extend(answered(id, case, explain));
        }
    }
}
