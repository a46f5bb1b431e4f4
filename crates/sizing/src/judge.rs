//! Judges actuators for one axis, one after the other.

use crate::axis::Axis;
use crate::bearing_checks::Borne;
use crate::check::{Check, CheckId, Checks, Fit, Margin, Part, Verdict};
use crate::currents::Currents;
use crate::demand::{Demand, ManualDemand};
use crate::electrics::Electrics;
use crate::energy;
use crate::list::{Case, SharedBy, Stage};
use crate::notes::Note;
use actuator::{Drivetrain, Parameters};
use derivation::Workings;
use numeric::at_least;
use std::sync::Arc;

/// Result of judging one actuator for one axis: demand and checks.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Demand by exact integrals, which the checks use. `None` if the own inertia is unknown.
    pub demand: Option<Demand>,
    /// Demand by the manual's equations; see [`Judgement::by_the_manual`].
    pub manual: Option<ManualDemand>,
    /// Results of the checks.
    pub checks: Checks,
}

/// Conditions under which an actuator fits though a check is beyond its limit; none for [`Fit::Fits`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Proviso {
    /// A value is within the band of an estimate, which must hold.
    pub estimate: bool,
    /// A value is beyond a rating of another manufacturer's gear, which must not apply.
    pub rating: bool,
}

impl Judgement {
    /// Returns `true` if no check fails.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.fit().fits()
    }

    /// Returns the verdict by the checks alone.
    #[must_use]
    pub fn fit(&self) -> Fit {
        if any_fails(&self.checks) {
            Fit::DoesNotFit
        } else if self.checks.unordered().any(Check::is_inside_band) {
            Fit::FitsIfEstimate
        } else {
            Fit::Fits
        }
    }

    /// Returns the conditions of a fitting actuator.
    #[must_use]
    pub fn proviso(&self) -> Proviso {
        let beyond = || self.checks.unordered().filter(|check| check.is_inside_band());
        Proviso {
            estimate: beyond().any(|check| !check.is_of_another_gear()),
            rating: beyond().any(Check::is_of_another_gear),
        }
    }

    /// Returns the demand by the manual's equations if they describe the axis: eq. 69.2 takes the torque of the acceleration
    /// for the braking, which is right for equal times only.
    #[must_use]
    pub fn by_the_manual(&self) -> Option<&ManualDemand> {
        self.manual.as_ref().filter(|manual| !manual.braking_assumed)
    }

    /// Returns the governing check, see [`governing`].
    #[must_use]
    pub fn governing(&self) -> Option<&Check> {
        governing(&self.checks)
    }

    /// Returns the check that governs a verdict on the actuator: none if only a requirement rejects it.
    #[must_use]
    pub fn governing_in(&self, verdict: Fit) -> Option<&Check> {
        self.governing().filter(|check| verdict.fits() || check.verdict == Verdict::Fail)
    }

    /// Returns the governing check if it fails.
    #[must_use]
    pub fn worst_failure(&self) -> Option<&Check> {
        self.governing().filter(|check| check.verdict == Verdict::Fail)
    }

    /// Returns the utilisation of the governing check; infinite if it fails and has none, because its limit is zero or
    /// a range; zero if no check has a margin.
    #[must_use]
    pub fn utilisation(&self) -> f64 {
        self.governing().map_or(0.0, Check::severity)
    }

    /// Returns the number of failing checks.
    #[must_use]
    pub fn failing(&self) -> usize {
        self.checks.unordered().filter(|check| check.verdict == Verdict::Fail).count()
    }

    /// Returns `true` if gravity or tension acts on the axis and nothing holds it without power.
    #[must_use]
    pub fn leaves_load_unheld(&self) -> bool {
        let holding = self.checks.of(CheckId::BrakeHolding);
        holding.is_some_and(|check| check.notes.contains(&Note::NothingHoldsWithoutPower))
    }
}

/// Returns the governing check: of the failing checks the one that exceeds its limit most; if none fails, the one with
/// the largest utilisation among those with a margin.
///
/// Two checks may have the same utilisation, as those of the mean speed at the output and at the motor, up to the
/// rounding of the machine; of these the one with the highest `precedence` is returned, on every machine.
#[must_use]
pub fn governing(checks: &Checks) -> Option<&Check> {
    let fails = any_fails(checks);
    let contends = |check: &&Check| match fails {
        true => check.verdict == Verdict::Fail,
        false => check.id.has_margin() && check.utilisation.is_some(),
    };
    let contenders = || checks.unordered().filter(contends);
    let largest = contenders().map(Check::severity).max_by(f64::total_cmp)?;
    contenders().filter(|check| at_least(check.severity(), largest)).max_by_key(|check| precedence(check))
}

fn any_fails(checks: &Checks) -> bool {
    checks.unordered().any(|check| check.verdict == Verdict::Fail)
}

/// Order of checks with the same utilisation: a limit of the actuator above a rating of another manufacturer's gear, then
/// the order of the checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Precedence {
    is_own_limit: bool,
    id: CheckId,
}

impl Precedence {
    /// Returns the precedence of a check whose limit is one of the actuator.
    pub(crate) const fn of_own_limit(id: CheckId) -> Self {
        Self { is_own_limit: true, id }
    }
}

/// Returns the precedence of a check.
pub(crate) fn precedence(check: &Check) -> Precedence {
    Precedence { is_own_limit: !check.is_of_another_gear(), id: check.id }
}

/// Returns the check of the highest precedence among those whose share equals the largest up to rounding.
pub(crate) fn first_of_equal(shares: impl IntoIterator<Item = (f64, Precedence)>, largest: f64) -> Option<CheckId> {
    let equal = shares.into_iter().filter(|(share, _)| at_least(*share, largest));
    equal.map(|(_, precedence)| precedence).max().map(|found| found.id)
}

/// Selection of the checks of a judgement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Every check of the axis.
    All,
    /// Every check of the axis but the regenerated energy, whose value costs a pass over the cycle, unless the project
    /// limits it.
    Ranking,
    /// The checks that can fail or have a margin: verdict, utilisation and governing check are those of [`Scope::All`].
    /// Left out are recommendations, values without a limit of the project, and the demand by the manual's equations.
    Deciding,
}

/// Effort for an actuator that a check rejects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Every selected check is made.
    Complete,
    /// Once a check fails, those that evaluate the cycle once more are made only if they fail too. Verdict, failing
    /// checks, utilisation and governing check are those of [`Depth::Complete`].
    Failing,
    /// The checks that evaluate the cycle once more are made only if no other check fails. The verdict is that of
    /// [`Depth::Complete`]; so are utilisation and governing check of an actuator that fits.
    UntilRejected,
}

/// Judges one actuator for one axis by every selected check.
#[must_use]
pub fn judge(axis: &Axis, actuator: &Parameters, scope: Scope) -> Judgement {
    Judge::new(axis, scope, Depth::Complete).next(actuator, &mut |_, _| {})
}

/// Callback for each check, called once before the check is returned, with the index of the move that governs by the
/// manual; it names the sources of the project as its file does.
pub type Naming<'n> = &'n mut dyn FnMut(&mut Check, usize);

/// Judges one actuator after another for one axis.
///
/// Neighbours in the catalogue have the same drivetrain or the same output bearing; results that depend on it alone are
/// computed once (see `Shared`).
pub struct Judge<'a> {
    axis: &'a Axis,
    scope: Scope,
    depth: Depth,
    explain: bool,
    checks: Selected,
    shared: Shared,
}

/// Checks that a judge makes, by the actuators that share their results, each list in order.
#[derive(Clone, Default)]
struct Selected {
    own: Vec<CheckId>,
    of_drivetrain: Vec<CheckId>,
    of_bearing: Vec<CheckId>,
}

impl Selected {
    /// Returns the checks that satisfy a condition.
    fn of(is_selected: impl Fn(CheckId) -> bool) -> Self {
        let mut selected = Self::default();
        for id in CheckId::ALL.iter().copied().filter(|id| is_selected(*id)) {
            match id.shared_by() {
                SharedBy::Nothing => selected.own.push(id),
                SharedBy::Drivetrain => selected.of_drivetrain.push(id),
                SharedBy::Bearing => selected.of_bearing.push(id),
            }
        }
        selected
    }
}

impl<'a> Judge<'a> {
    /// Creates a judge of actuators for an axis.
    #[must_use]
    pub fn new(axis: &'a Axis, scope: Scope, depth: Depth) -> Self {
        Self::by(axis, scope, depth, |id| scope != Scope::Deciding || id.can_fail(axis))
    }

    /// Creates a judge by the checks of one part of the actuator.
    #[must_use]
    pub fn of_part(axis: &'a Axis, part: Part) -> Self {
        Self::by(axis, Scope::All, Depth::Complete, |id| id.part() == part)
    }

    fn by(axis: &'a Axis, scope: Scope, depth: Depth, is_selected: impl Fn(CheckId) -> bool) -> Self {
        let checks = Selected::of(|id| id.is_made(axis) && is_selected(id));
        Self { axis, scope, depth, explain: false, checks, shared: Shared::default() }
    }

    /// Creates a judge by every check, each result with the workings of its value and its limit.
    #[must_use]
    pub fn explaining(axis: &'a Axis) -> Self {
        Self { explain: true, ..Self::new(axis, Scope::All, Depth::Complete) }
    }

    /// Judges one actuator.
    pub fn next(&mut self, actuator: &Parameters, naming: Naming<'_>) -> Judgement {
        if let Some(axis) = self.axis.braked_by(&actuator.brake) {
            let (checks, shared) = (self.checks.clone(), Shared::default());
            return Judge { axis: &axis, checks, shared, ..*self }.next(actuator, naming);
        }
        let Self { axis, scope, depth, explain, ref checks, ref mut shared } = *self;
        let inertia = actuator.inertia_out.known().map(|known| known.value);
        let demand = inertia.map(|inertia| axis.demand(inertia));
        let manual = inertia.filter(|_| scope != Scope::Deciding).and_then(|inertia| axis.manual_demand(inertia));
        let governing = manual.as_ref().map_or(0, |manual| manual.governing);
        let electrics = &shared.begin(axis, actuator, governing);
        let currents = Currents::of(axis, actuator, electrics);
        let bearing = axis.bearing.as_ref().map(|duty| Borne::of(axis, duty, &actuator.output_bearing));
        let mut case = Case {
            axis,
            actuator,
            demand: demand.as_ref(),
            manual: manual.as_ref(),
            electrics,
            currents: currents.as_ref(),
            bearing: bearing.as_ref(),
            only_failing: false,
        };
        // Adds the result of a check, if it applies, and returns `true` if it fails.
        let mut add = |id: CheckId, case: &Case<'_>, made: &mut Vec<Check>| {
            let place = made.len();
            made.extend(answered(id, case, explain));
            made.get_mut(place).is_some_and(|check| {
                naming(check, governing);
                check.verdict == Verdict::Fail
            })
        };
        let mut all = |ids: &[CheckId]| {
            let mut made = Vec::with_capacity(ids.len());
            for id in ids {
                add(*id, &case, &mut made);
            }
            Arc::from(made)
        };
        let of_drivetrain = shared.of_drivetrain.get_or_insert_with(|| all(&checks.of_drivetrain));
        let of_bearing = shared.of_bearing.get_or_insert_with(|| all(&checks.of_bearing));

        let mut made = Checks::sharing([Arc::clone(of_drivetrain), Arc::clone(of_bearing)], checks.own.len());
        let mut is_rejected = any_fails(&made);
        for &id in &checks.own {
            if depth == Depth::UntilRejected && is_rejected && id.stage() > Stage::First {
                break;
            }
            if id == CheckId::Regeneration && is_energy_left_out(scope, &case, &made) {
                continue;
            }
            case.only_failing = depth == Depth::Failing && is_rejected;
            is_rejected |= add(id, &case, made.own());
        }
        Judgement { demand, manual, checks: made }
    }
}

/// Results that hold for several actuators, until one with another drivetrain or output bearing is judged.
#[derive(Default)]
struct Shared {
    /// Drivetrain, with its current, heat and voltage laws.
    drivetrain: Option<(Arc<Drivetrain>, Arc<Electrics>)>,
    /// Results of [`SharedBy::Drivetrain`] for that drivetrain.
    of_drivetrain: Option<Arc<[Check]>>,
    /// Results of [`SharedBy::Bearing`] for the bearing of that drivetrain.
    of_bearing: Option<Arc<[Check]>>,
    /// Index of the governing move, which the sources of the results name.
    governing: usize,
}

impl Shared {
    /// Discards the results that do not hold for an actuator, and returns the laws of its drivetrain.
    fn begin(&mut self, axis: &Axis, actuator: &Parameters, governing: usize) -> Arc<Electrics> {
        if self.governing != governing {
            (self.of_drivetrain, self.of_bearing) = (None, None);
            self.governing = governing;
        }
        if let Some((drivetrain, electrics)) = &self.drivetrain
            && Arc::ptr_eq(drivetrain, &actuator.drivetrain)
        {
            return Arc::clone(electrics);
        }
        let is_of_bearing = |drivetrain: &Drivetrain| drivetrain.output_bearing == actuator.output_bearing;
        if !self.drivetrain.as_ref().is_some_and(|(drivetrain, _)| is_of_bearing(drivetrain)) {
            self.of_bearing = None;
        }
        self.of_drivetrain = None;
        let electrics = Arc::new(Electrics::of(axis, actuator));
        self.drivetrain = Some((Arc::clone(&actuator.drivetrain), Arc::clone(&electrics)));
        electrics
    }
}

/// Returns the answer of a check, with its workings if an explanation is requested.
fn answered(id: CheckId, case: &Case<'_>, explain: bool) -> Option<Check> {
    if !explain {
        return id.of(case, &mut Workings::off());
    }
    let mut work = Workings::on();
    let mut check = id.of(case, &mut work)?;
    check.workings = work.into_steps().into();
    Some(check)
}

/// Returns `true` if a scope leaves the regenerated energy out: in a ranking if the project does not limit it and it can be
/// computed; among the deciding checks if by its bounds it is sure to pass with a utilisation below that of another check.
fn is_energy_left_out(scope: Scope, case: &Case<'_>, found: &Checks) -> bool {
    match scope {
        Scope::All => false,
        Scope::Ranking => {
            !CheckId::Regeneration.can_fail(case.axis) && !energy::is_missing(case.actuator, case.currents)
        }
        Scope::Deciding => {
            let has_share = |check: &Check| check.id.has_margin() && check.id.margin() != Margin::Range;
            let counted = found.unordered().filter(|check| check.verdict == Verdict::Fail || has_share(check));
            let largest = counted.map(Check::severity).fold(0.0, f64::max);
            energy::is_below(case.axis, case.actuator, case.currents, largest.min(1.0))
        }
    }
}
