//! Judges actuators for one axis, one after the other.

use crate::axis::Axis;
use crate::bearing_checks;
use crate::brake_checks;
use crate::check::{Check, CheckId, Verdict};
use crate::checks;
use crate::comparison::explained;
use crate::currents::{self, Currents};
use crate::demand::{Demand, ManualDemand};
use crate::electric_checks;
use crate::electrics::Electrics;
use crate::energy;
use crate::feedback_checks;
use crate::gear_checks;
use crate::heat_checks;
use crate::joint_checks;
use crate::watch::Watch;
use actuator::{Drivetrain, Parameters};
use std::ops::Range;
use std::sync::Arc;

/// Room for the checks of one actuator that is rejected, without those of its drivetrain, and for all of one that is not,
/// so that judging many does not grow one vector after the other.
const ROOM: [usize; 2] = [8, 24];

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
    /// Whether no check fails.
    #[must_use]
    pub fn fits(&self) -> bool {
        !self.checks.any_fails()
    }

    /// The failing check that is exceeded most, if any.
    #[must_use]
    pub fn worst_failure(&self) -> Option<&Check> {
        let key = |check: &Check| check.utilisation.unwrap_or(f64::INFINITY);
        self.checks.iter().filter(|c| c.verdict == Verdict::Fail).max_by(|a, b| key(a).total_cmp(&key(b)))
    }

    /// The largest utilisation among the checks with a margin; infinite where a limit of zero
    /// is exceeded.
    #[must_use]
    pub fn utilisation(&self) -> f64 {
        let shared = self.checks.shared.as_ref().map_or(0.0, |shared| shared.utilisation);
        utilisation(&self.checks.own).max(shared)
    }

    /// Adds the energy that comes back to a judgement that left it out, at its place; see [`energies`].
    pub fn complete(&mut self, mut energy: Check, naming: Naming<'_>) {
        naming(&mut energy, self.manual.as_ref().map_or(0, |manual| manual.governing));
        let own = &mut self.checks.own;
        let before = own.iter().position(|check| check.id == CheckId::OverloadI2t);
        own.insert(before.map_or(own.len(), |before| before + 1), energy);
    }

    /// Whether it says what energy comes back, or why that is not known.
    #[must_use]
    pub fn tells_energy(&self) -> bool {
        self.checks.own.iter().any(|check| check.id == CheckId::Regeneration)
    }

    /// The check with that utilisation.
    #[must_use]
    pub fn tightest(&self) -> Option<&Check> {
        self.checks
            .iter()
            .filter(|check| check.id.has_margin() && check.utilisation.is_some())
            .max_by(|a, b| a.utilisation.unwrap_or(0.0).total_cmp(&b.utilisation.unwrap_or(0.0)))
    }
}

/// How far a judgement goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Every check.
    Full,
    /// The checks that look at the cycle once more only if none of the others fails.
    Survivors,
    /// The same without the energy that comes back, which costs a pass over the whole cycle: many find it together, see
    /// [`energies`]. Without a limit that is asked for it takes part in no verdict and no utilisation.
    Ranking,
    /// Every check that can fail or has a margin: what is only shown or advised is left out, and so is the demand by
    /// the manual, and the energy that comes back where its bounds are below another utilisation. Verdict and utilisation
    /// are those of [`Depth::Full`].
    Margins,
}

/// The largest utilisation among some checks, see [`Judgement::utilisation`]; zero where none has one.
fn utilisation(checks: &[Check]) -> f64 {
    let share = |check: &Check| match check.utilisation {
        None if check.verdict == Verdict::Fail && check.id != CheckId::Ambient => f64::INFINITY,
        share => share.unwrap_or(0.0),
    };
    let counted = checks.iter().filter(|check| check.id.has_margin() || check.verdict == Verdict::Fail);
    counted.map(share).fold(0.0, f64::max)
}

/// The checks of an actuator in a fixed order. What hangs on the axis and on the drivetrain alone is shared by the
/// judgements of all actuators with that drivetrain.
#[derive(Clone, Debug, Default)]
pub struct Checks {
    own: Vec<Check>,
    shared: Option<Arc<Shared>>,
    /// Bit k: whether the check at that place is the next one of those that are shared.
    places: u64,
}

/// The checks of a drivetrain for one axis.
#[derive(Debug)]
struct Shared {
    checks: Vec<Check>,
    /// Those of the output bearing, one after the other.
    bearing: Range<usize>,
    /// Whether one of them fails.
    fail: bool,
    utilisation: f64,
}

impl Checks {
    fn shared(&self) -> &[Check] {
        self.shared.as_ref().map_or(&[], |shared| &shared.checks)
    }

    /// How many they are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.own.len() + self.shared().len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Each in its order.
    #[must_use]
    pub fn iter(&self) -> InOrder<'_> {
        InOrder { own: self.own.iter(), shared: self.shared().iter(), places: self.places }
    }

    /// Whether one of them fails.
    fn any_fails(&self) -> bool {
        self.shared.as_ref().is_some_and(|shared| shared.fail)
            || self.own.iter().any(|check| check.verdict == Verdict::Fail)
    }
}

/// The checks of an actuator, one after the other.
#[derive(Clone, Debug)]
pub struct InOrder<'c> {
    own: std::slice::Iter<'c, Check>,
    shared: std::slice::Iter<'c, Check>,
    places: u64,
}

impl<'c> Iterator for InOrder<'c> {
    type Item = &'c Check;

    #[inline]
    fn next(&mut self) -> Option<&'c Check> {
        let is_shared = self.places & 1 == 1;
        self.places >>= 1;
        if is_shared { self.shared.next() } else { self.own.next() }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.own.len() + self.shared.len();
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

/// Whoever is handed each check once, before anybody sees it, with the index of the move that governs by the manual: to
/// name the sources of the project as its file names them.
pub type Naming<'n> = &'n mut dyn FnMut(&mut Check, usize);

/// Judges one actuator after the other for one axis. Of neighbours with the same drivetrain what does not hang on feedback
/// and brake is found once.
pub struct Judge<'a> {
    axis: &'a Axis,
    depth: Depth,
    explain: bool,
    known: Option<Known>,
}

/// What was found of a drivetrain.
struct Known {
    drivetrain: Arc<Drivetrain>,
    electrics: Electrics,
    /// Its checks, named for a governing move.
    checks: Option<(usize, Arc<Shared>)>,
}

/// The checks of one actuator on their way.
struct Gathered {
    all: Checks,
    count: u32,
    /// Those of the drivetrain, where they are not known yet.
    new: Vec<Check>,
    /// Which of them are those of the output bearing.
    bearing: Range<usize>,
    /// Another drivetrain with the same output bearing, whose checks of it serve.
    same_bearing: Option<Arc<Shared>>,
}

impl Gathered {
    fn own(&mut self, check: Check) {
        self.all.own.push(check);
        self.count += 1;
    }

    fn of_drivetrain(&mut self, check: impl FnOnce() -> Check) {
        self.all.places |= 1 << self.count;
        self.count += 1;
        if self.all.shared.is_none() {
            self.new.push(check());
        }
    }

    fn of_bearing(&mut self, check: impl FnOnce() -> Check) {
        if self.all.shared.is_some() {
            self.of_drivetrain(check);
            return;
        }
        let place = self.new.len();
        if self.bearing.is_empty() {
            self.bearing.start = place;
        }
        let number = place - self.bearing.start;
        let of_bearing = |same: &Arc<Shared>| same.checks.get(same.bearing.clone())?.get(number).cloned();
        let known = self.same_bearing.as_ref().and_then(of_bearing);
        self.of_drivetrain(|| known.unwrap_or_else(check));
        self.bearing.end = self.new.len();
    }
}

impl<'a> Judge<'a> {
    /// Judges to some depth.
    #[must_use]
    pub const fn of(axis: &'a Axis, depth: Depth) -> Self {
        Self { axis, depth, explain: false, known: None }
    }

    /// Judges by every check, each with the workings of its value and its limit.
    #[must_use]
    pub const fn explaining(axis: &'a Axis) -> Self {
        Self { axis, depth: Depth::Full, explain: true, known: None }
    }

    /// The judgement of one actuator.
    pub fn next(&mut self, actuator: &Parameters, naming: Naming<'_>) -> Judgement {
        let (axis, depth, explain) = (self.axis, self.depth, self.explain);
        let before = self.known.take();
        let is_same = before.as_ref().is_some_and(|known| Arc::ptr_eq(&known.drivetrain, &actuator.drivetrain));
        let (known, other) = if is_same { (before, None) } else { (None, before) };
        let known = self.known.insert(known.unwrap_or_else(|| Known {
            drivetrain: Arc::clone(&actuator.drivetrain),
            electrics: Electrics::of(axis, actuator),
            checks: None,
        }));
        let other = other.filter(|other| other.drivetrain.output_bearing == actuator.output_bearing);
        let inertia = actuator.inertia_out.known().map(|known| known.value);
        let demand = inertia.map(|inertia| axis.demand(inertia));
        let bare = depth == Depth::Margins;
        let manual = inertia.filter(|_| !bare).and_then(|inertia| axis.manual_demand(inertia));
        let governing = manual.as_ref().map_or(0, |manual| manual.governing);
        let shared = known.checks.as_ref().filter(|(named, _)| *named == governing);
        let [rejected, all] = ROOM;
        let only_survivors = matches!(depth, Depth::Survivors | Depth::Ranking);
        let room = if only_survivors { rejected } else { all };
        let shared = shared.map(|(_, shared)| Arc::clone(shared));
        let mut checks = Gathered {
            all: Checks { own: Vec::with_capacity(room), shared, places: 0 },
            count: 0,
            new: Vec::new(),
            bearing: 0..0,
            same_bearing: other.and_then(|other| other.checks).filter(|(named, _)| *named == governing).map(|(_, s)| s),
        };
        let demands = (demand.as_ref(), manual.as_ref());
        let electrics = &known.electrics;
        let currents = Currents::of(axis, actuator, electrics);
        let currents = currents.as_ref();
        first_checks(axis, actuator, (demands, electrics, currents), (bare, explain), &mut checks);
        if checks.all.shared.is_none() {
            let (mut found, bearing) = (std::mem::take(&mut checks.new), checks.bearing.clone());
            let is_named = |place: usize| checks.same_bearing.is_some() && bearing.contains(&place);
            let new = found.iter_mut().enumerate().filter(|(place, _)| !is_named(*place));
            new.for_each(|(_, check)| naming(check, governing));
            let fail = found.iter().any(|check| check.verdict == Verdict::Fail);
            let found = Arc::new(Shared { bearing, fail, utilisation: utilisation(&found), checks: found });
            known.checks = Some((governing, Arc::clone(&found)));
            checks.all.shared = Some(found);
        }
        if !only_survivors || !checks.all.any_fails() {
            let own = &mut checks.all.own;
            own.reserve_exact(all - own.len().min(all));
            further_checks(axis, actuator, (electrics, currents), (depth, explain), own);
        }
        let mut checks = checks.all;
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

/// What the first checks look at.
type Looked<'l> = (checks::Demands<'l>, &'l Electrics, Result<&'l Currents<'l>, &'l provenance::Missing>);

/// The checks that every actuator goes through.
fn first_checks(
    axis: &Axis,
    actuator: &Parameters,
    (demands, electrics, currents): Looked<'_>,
    (bare, explain): (bool, bool),
    to: &mut Gathered,
) {
    let drivetrain: &Drivetrain = actuator;
    to.own(explained(explain, |work| checks::peak_torque(axis, actuator, demands, work)));
    to.of_drivetrain(|| explained(explain, |work| checks::peak_speed(axis, drivetrain, work)));
    to.of_drivetrain(|| explained(explain, |work| checks::mean_speed(axis, drivetrain, work)));
    to.own(explained(explain, |work| heat_checks::continuous_torque(axis, actuator, electrics, demands, work)));
    currents::current_checks(axis, actuator, currents, explain, &mut |check| to.own(check));
    if axis.supply.is_some() {
        to.own(explained(explain, |work| currents::voltage(axis, actuator, (electrics, currents), work)));
    }
    if !bare {
        to.own(explained(explain, |work| checks::inertia_ratio(axis, actuator, work)));
    }
    gear_checks::judge(axis, drivetrain, (bare, explain), &mut |check| to.of_drivetrain(check));
    if !bare || axis.asked.natural_frequency_min.is_some() {
        to.own(explained(explain, |work| crate::resonance::natural_frequency(axis, actuator, work)));
    }
    bearing_checks::judge(axis, &drivetrain.output_bearing, explain, &mut |check| to.of_bearing(check));
    if let Some(stated) = axis.ambient {
        to.of_drivetrain(|| explained(explain, |work| checks::ambient(stated, drivetrain, work)));
    }
    if let Some((supply, _)) = axis.supply {
        to.of_drivetrain(|| {
            explained(explain, |work| electric_checks::dc_link(supply, axis.asked.dc_link_rise, drivetrain, work))
        });
    }
}

/// The checks that look at the cycle once more.
fn further_checks(
    axis: &Axis,
    actuator: &Parameters,
    (electrics, currents): (&Electrics, Result<&Currents<'_>, &provenance::Missing>),
    (depth, explain): (Depth, bool),
    checks: &mut Vec<Check>,
) {
    let bare = depth == Depth::Margins;
    checks.push(explained(explain, |work| electric_checks::torque_speed_trace(axis, actuator, currents, work)));
    checks.push(explained(explain, |work| heat_checks::thermal(axis, actuator, currents, work)));
    checks.push(explained(explain, |work| heat_checks::overload(axis, actuator, (electrics, currents), work)));
    let is_told = match depth {
        Depth::Full | Depth::Survivors => true,
        Depth::Ranking => energy::is_missing(actuator, currents),
        // What passes and is below another utilisation changes neither verdict nor margin.
        Depth::Margins => {
            let share = || utilisation(checks).min(1.0);
            axis.asked.regeneration_power_max.is_some() && !energy::is_below(axis, actuator, currents, share())
        }
    };
    if is_told {
        checks.push(explained(explain, |work| energy::regeneration(axis, actuator, currents, work)));
    }
    gear_checks::judge_further(axis, actuator, (bare, explain), checks);
    checks.extend(brake_checks::judge(axis, actuator, explain));
    let asked = &axis.asked;
    let of_feedback =
        asked.absolute == Some(true) || asked.resolution_max.is_some() || asked.battery_life_min.is_some();
    if !bare || of_feedback {
        checks.extend(feedback_checks::judge(axis, actuator, explain));
    }
    joint_checks::judge(axis, actuator, explain, checks);
}
