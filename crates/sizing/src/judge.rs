//! Judges actuators for one axis, one after the other.

use crate::axis::Axis;
use crate::bearing_checks::Borne;
use crate::check::{Check, CheckId, Fit, Margin, Part, Verdict};
use crate::currents::Currents;
use crate::demand::{Demand, ManualDemand};
use crate::electrics::Electrics;
use crate::energy;
use crate::list::{Case, SharedBy, Stage};
use crate::notes::Note;
use actuator::{Drivetrain, OutputBearing, Parameters};
use derivation::Workings;
use numeric::at_least;
use std::ops::Deref;
use std::sync::{Arc, LazyLock};

/// Result of judging one actuator for one axis: demand and checks.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Demand by exact integrals, which the checks use. `None` if the own inertia is unknown.
    pub demand: Option<Demand>,
    /// Demand by the manual's equations; see [`Judgement::by_the_manual`].
    pub manual: Option<ManualDemand>,
    /// Results of the checks, in the order in which they are judged.
    pub checks: Vec<Checked>,
}

/// Result of a check in a judgement. Most belong to one actuator and are stored in place: an allocation for each would take
/// a third of the time of a ranking.
#[derive(Clone, Debug)]
pub enum Checked {
    /// Result for one actuator.
    Own(Check),
    /// Result that holds for several actuators.
    Shared(Arc<Check>),
}

impl Deref for Checked {
    type Target = Check;

    fn deref(&self) -> &Check {
        match self {
            Self::Own(check) => check,
            Self::Shared(check) => check,
        }
    }
}

impl AsRef<Check> for Checked {
    fn as_ref(&self) -> &Check {
        self
    }
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
        } else if self.checks.iter().any(|check| check.is_inside_band()) {
            Fit::FitsIfEstimate
        } else {
            Fit::Fits
        }
    }

    /// Returns the conditions of a fitting actuator.
    #[must_use]
    pub fn proviso(&self) -> Proviso {
        let beyond = || self.checks.iter().map(Checked::as_ref).filter(|check| check.is_inside_band());
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
        self.checks.iter().filter(|check| check.verdict == Verdict::Fail).count()
    }

    /// Returns `true` if gravity or tension acts on the axis and nothing holds it without power.
    #[must_use]
    pub fn leaves_load_unheld(&self) -> bool {
        let mut holding = self.checks.iter().filter(|check| check.id == CheckId::BrakeHolding);
        holding.any(|check| check.notes.contains(&Note::NothingHoldsWithoutPower))
    }
}

/// Returns the governing check: of the failing checks the one that exceeds its limit most; if none fails, the one with
/// the largest utilisation among those with a margin.
///
/// Two checks may have the same utilisation, as those of the mean speed at the output and at the motor, up to the
/// rounding of the machine; of these the last in the order of the checks is returned, on every machine.
#[must_use]
pub fn governing(checks: &[Checked]) -> Option<&Check> {
    let largest = contenders(checks).map(Check::severity).max_by(f64::total_cmp)?;
    last_of_equal(contenders(checks).map(|check| (check.severity(), check)), largest)
}

/// Returns the checks among which the governing one is: those that fail; if none fails, those with a margin.
fn contenders(checks: &[Checked]) -> impl Iterator<Item = &Check> {
    let fails = any_fails(checks);
    checks.iter().map(Checked::as_ref).filter(move |check| match fails {
        true => check.verdict == Verdict::Fail,
        false => check.id.has_margin() && check.utilisation.is_some(),
    })
}

fn any_fails(checks: &[Checked]) -> bool {
    checks.iter().any(|check| check.verdict == Verdict::Fail)
}

/// Returns the last of those whose share equals the largest up to rounding.
pub(crate) fn last_of_equal<T>(shares: impl IntoIterator<Item = (f64, T)>, largest: f64) -> Option<T> {
    shares.into_iter().filter(|(share, _)| at_least(*share, largest)).last().map(|(_, of)| of)
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
/// Neighbours in the catalogue have the same drivetrain or the same output bearing; answers that depend on it alone are
/// computed once (see `Shared`).
pub struct Judge<'a> {
    axis: &'a Axis,
    scope: Scope,
    depth: Depth,
    explain: bool,
    checks: Vec<CheckId>,
    shared: Shared,
}

/// Checks in the order in which they are judged.
static IN_ORDER: LazyLock<Vec<CheckId>> = LazyLock::new(|| {
    let mut checks = CheckId::ALL.to_vec();
    checks.sort_by_key(|id| id.place());
    checks
});

impl<'a> Judge<'a> {
    /// Creates a judge of actuators for an axis.
    #[must_use]
    pub fn new(axis: &'a Axis, scope: Scope, depth: Depth) -> Self {
        let mut checks = IN_ORDER.clone();
        checks.retain(|id| id.is_made(axis) && (scope != Scope::Deciding || id.can_fail(axis)));
        Self { axis, scope, depth, explain: false, checks, shared: Shared::default() }
    }

    /// Creates a judge by the checks of one part of the actuator.
    #[must_use]
    pub fn of_part(axis: &'a Axis, part: Part) -> Self {
        let mut judge = Self::new(axis, Scope::All, Depth::Complete);
        judge.checks.retain(|id| id.part() == part);
        judge
    }

    /// Creates a judge by every check, each answer with the workings of its value and its limit.
    #[must_use]
    pub fn explaining(axis: &'a Axis) -> Self {
        Self { explain: true, ..Self::new(axis, Scope::All, Depth::Complete) }
    }

    /// Judges one actuator.
    pub fn next(&mut self, actuator: &Parameters, naming: Naming<'_>) -> Judgement {
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

        let mut found: Vec<Checked> = Vec::with_capacity(checks.len());
        let mut is_rejected = false;
        for &id in checks {
            if depth == Depth::UntilRejected && is_rejected && id.stage() > Stage::First {
                break;
            }
            if id == CheckId::Regeneration && is_energy_left_out(scope, &case, &found) {
                continue;
            }
            let check = match shared.get(id) {
                Some(known) => Checked::Shared(Arc::clone(known)),
                None => {
                    case.only_failing = depth == Depth::Failing && is_rejected;
                    let Some(mut check) = answered(id, &case, explain) else { continue };
                    naming(&mut check, governing);
                    shared.store(check)
                }
            };
            is_rejected |= check.verdict == Verdict::Fail;
            found.push(check);
        }
        Judgement { demand, manual, checks: found }
    }
}

/// Answers that hold for several actuators, each under the condition under which it may be used again.
struct Shared {
    /// Answers of [`SharedBy::Drivetrain`] and current, heat and voltage laws: the same drivetrain.
    drivetrain: Option<(Arc<Drivetrain>, Arc<Electrics>)>,
    /// Answers of [`SharedBy::Bearing`]: an equal output bearing.
    bearing: Option<OutputBearing>,
    /// Index of the governing move, which the sources of all stored answers name.
    governing: usize,
    /// Stored answers, by the position of their check in [`CheckId::ALL`].
    answers: [Option<Arc<Check>>; CheckId::ALL.len()],
}

impl Default for Shared {
    fn default() -> Self {
        Self { drivetrain: None, bearing: None, governing: 0, answers: [const { None }; CheckId::ALL.len()] }
    }
}

impl Shared {
    /// Discards the answers that do not hold for an actuator, and returns the laws of its drivetrain.
    fn begin(&mut self, axis: &Axis, actuator: &Parameters, governing: usize) -> Arc<Electrics> {
        let electrics = match &self.drivetrain {
            Some((drivetrain, electrics)) if Arc::ptr_eq(drivetrain, &actuator.drivetrain) => Arc::clone(electrics),
            _ => {
                self.forget(|check| check.id.shared_by() == SharedBy::Drivetrain);
                let electrics = Arc::new(Electrics::of(axis, actuator));
                self.drivetrain = Some((Arc::clone(&actuator.drivetrain), Arc::clone(&electrics)));
                electrics
            }
        };
        if self.bearing.as_ref() != Some(&actuator.output_bearing) {
            self.forget(|check| check.id.shared_by() == SharedBy::Bearing);
            self.bearing = Some(actuator.output_bearing.clone());
        }
        if self.governing != governing {
            self.forget(|_| true);
            self.governing = governing;
        }
        electrics
    }

    fn forget(&mut self, is_outdated: impl Fn(&Check) -> bool) {
        for answer in &mut self.answers {
            answer.take_if(|check| is_outdated(check));
        }
    }

    fn get(&self, id: CheckId) -> Option<&Arc<Check>> {
        self.answers.get(id as usize)?.as_ref()
    }

    /// Keeps an answer if it holds for several actuators, and returns it.
    fn store(&mut self, check: Check) -> Checked {
        if check.id.shared_by() == SharedBy::Nothing {
            return Checked::Own(check);
        }
        let check = Arc::new(check);
        if let Some(answer) = self.answers.get_mut(check.id as usize) {
            *answer = Some(Arc::clone(&check));
        }
        Checked::Shared(check)
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
fn is_energy_left_out(scope: Scope, case: &Case<'_>, found: &[Checked]) -> bool {
    match scope {
        Scope::All => false,
        Scope::Ranking => {
            !CheckId::Regeneration.can_fail(case.axis) && !energy::is_missing(case.actuator, case.currents)
        }
        Scope::Deciding => {
            let has_share = |check: &&Checked| check.id.has_margin() && check.id.margin() != Margin::Range;
            let counted = found.iter().filter(|check| check.verdict == Verdict::Fail || has_share(check));
            let largest = counted.map(|check| check.severity()).fold(0.0, f64::max);
            energy::is_below(case.axis, case.actuator, case.currents, largest.min(1.0))
        }
    }
}
