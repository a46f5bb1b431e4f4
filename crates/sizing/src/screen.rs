//! Many axes and the whole catalogue: the fitting actuators and the best of them, without judging each by every check.
//!
//! For most checks of most actuators a lower and an upper bound of the utilisation are quick to compute ([`bounds`]).
//! If both are on one side of the limit the verdict is decided; otherwise the check itself is made. The utilisation is
//! computed only for the few actuators that may be the best, by the checks whose bounds allow the largest value.
//! Verdicts and values are always those of [`judge`](crate::judge()): a bound decides nothing within
//! [`ROOM`](bounds::ROOM) of a limit.

mod bounds;
mod catalogue;
mod figures;
mod losses;

use crate::axis::Axis;
use crate::bearing_checks::Borne;
use crate::check::{Check, CheckId, Fit, Part, Verdict};
use crate::currents::Currents;
use crate::electrics::Electrics;
use crate::judge::{Depth, Judge, Judgement, Precedence, Scope, first_of_equal, judge, precedence};
use crate::list::{Answer, Case, SharedBy};
use crate::notes::Note;
use crate::rank::{RankKey, Standing};
use actuator::Parameters;
use bounds::{Bounds, BoundsOfOne};
use catalogue::{Conditions, Group, Member};
use derivation::Workings;
use figures::Figures;
use motion::Hold;
use quantities::Measure;
use std::cell::RefCell;
use std::sync::Arc;

pub use catalogue::{Entrant, Screen};

/// Result of a screening for one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Number of actuators that fit within every limit.
    pub fit: usize,
    /// Number of further actuators that fit if an estimate holds.
    pub fit_if_estimate: usize,
    /// Best of them.
    pub best: Option<Ranked>,
    /// If none fits, the actuator with the smallest excess among those that meet the requirements and are of the right
    /// class.
    pub miss: Option<Ranked>,
}

/// An actuator with its ranking data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// Index among the entrants.
    pub entrant: usize,
    /// Utilisation of its governing check.
    pub utilisation: f64,
    /// Governing check.
    pub tightest: Option<CheckId>,
}

/// Judges one axis after another.
pub struct Screening<'s> {
    screen: &'s Screen,
    conditions: Option<Conditions<'s>>,
    figures: Figures,
    bounds: Vec<Bounds>,
}

/// State of a group of actuators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Fits { holds: bool, is_inside_band: bool },
    Fails,
}

impl<'s> Screening<'s> {
    /// Creates a screening without data of an axis.
    #[must_use]
    pub fn of(screen: &'s Screen) -> Self {
        Self { screen, conditions: None, figures: Figures::default(), bounds: Vec::new() }
    }

    /// Returns the number of fitting actuators, and the best of them; `meets`: for each entrant, `true` if it meets the
    /// requirements other than the checks.
    pub fn found(&mut self, axis: &Axis, meets: &[bool]) -> Found {
        let screen = self.screen;
        let known = self.conditions.take().filter(|known| known.are_of(screen, axis));
        let conditions = self.conditions.insert(known.unwrap_or_else(|| Conditions::of(screen, axis)));
        let has_outline = self.figures.take(axis, conditions);
        let figures = &self.figures;
        self.bounds.resize_with(conditions.fours.len(), || Bounds::UNKNOWN);
        for (bounds, four) in self.bounds.iter_mut().zip(&conditions.fours) {
            if has_outline {
                bounds.update(figures, four);
            } else {
                *bounds = Bounds::UNKNOWN;
            }
        }
        let (of_bearing, others): (Vec<CheckId>, Vec<CheckId>) =
            others(axis).into_iter().partition(|id| id.shared_by() == SharedBy::Bearing);
        let borne = RefCell::new(vec![None; screen.bearings]);
        let row = Row { axis, meets, others, of_bearing, borne, has_outline, conditions };
        row.found(figures, &mut self.bounds)
    }
}

/// Returns the checks that can fail and have no bounds; those of the brake only if they may matter.
fn others(axis: &Axis) -> Vec<CheckId> {
    let no_brake = is_without_brake(axis);
    let no_loads = axis.bearing.as_ref().is_none_or(|duty| !duty.has_loads);
    let is_other = |id: &CheckId| {
        let is_of_the_brake = id.part() == Part::Brake;
        let is_of_the_bearing = id.shared_by() == SharedBy::Bearing;
        !(bounds::COVERED.contains(id) || (is_of_the_brake && no_brake) || (is_of_the_bearing && no_loads))
    };
    CheckId::ALL.iter().copied().filter(|id| id.is_made(axis) && id.can_fail(axis)).filter(is_other).collect()
}

/// Returns `true` if no check of the brake can fail or have a relevant utilisation: the load is balanced, no segment is
/// held by a brake, and there are no requirements on it.
fn is_without_brake(axis: &Axis) -> bool {
    let asked = &axis.asked;
    let nothing_hangs = axis.moments().holding_torque.si() <= 0.0;
    let held = axis.motion.stretches().iter().any(|stretch| stretch.hold != Hold::Motor);
    nothing_hangs
        && !held
        && asked.stop_angle_max.is_none()
        && asked.emergency_stops.is_none()
        && asked.service_life.is_none()
}

/// Axis of a row.
struct Row<'r> {
    axis: &'r Axis,
    meets: &'r [bool],
    others: Vec<CheckId>,
    /// Checks shared by actuators with the same output bearing, and their results for each bearing.
    of_bearing: Vec<CheckId>,
    borne: RefCell<Vec<Option<Arc<OfBearing>>>>,
    has_outline: bool,
    conditions: &'r Conditions<'r>,
}

/// A group that meets the requirements: its index and its state.
struct Open {
    four: usize,
    place: usize,
    size: u32,
    state: State,
}

impl Open {
    /// Returns the class that decides the order of fitting groups first, see [`RankKey`].
    const fn class(&self) -> Option<Class> {
        match self.state {
            State::Fits { holds, is_inside_band } => Some((!holds, is_inside_band, self.size)),
            State::Fails => None,
        }
    }
}

/// Load not held, fits only if an estimate holds, and frame size.
type Class = (bool, bool, u32);

/// Results of the checks of an output bearing.
#[derive(Debug, Default)]
struct OfBearing {
    fails: bool,
    is_inside_band: bool,
    shares: Vec<(f64, CheckId)>,
}

impl Row<'_> {
    fn found(&self, figures: &Figures, bounds: &mut [Bounds]) -> Found {
        let (mut fit, mut fit_if_estimate) = (0, 0);
        let mut open: Vec<Open> = Vec::with_capacity(self.conditions.groups.len());
        for (four, (groups, bounds)) in self.conditions.groups.chunks(4).zip(bounds.iter()).enumerate() {
            for (place, group) in groups.iter().enumerate() {
                let meeting = group.members.iter().filter(|member| self.meets(member.entrant)).count();
                if meeting == 0 {
                    continue;
                }
                let state = self.state(group, bounds.of_one(place));
                match state {
                    State::Fits { is_inside_band: false, .. } => fit += meeting,
                    State::Fits { is_inside_band: true, .. } => fit_if_estimate += meeting,
                    State::Fails => {}
                }
                open.push(Open { four, place, size: group.size, state });
            }
        }
        // The best is in the class that comes first; the one with the smallest excess may be any.
        let first = open.iter().filter_map(Open::class).min();
        for open in open.iter().filter(|open| open.class() == first) {
            if let (Some(bounds), Some(four)) = (bounds.get_mut(open.four), self.conditions.fours.get(open.four)) {
                bounds.look_below(figures, four);
            }
        }
        let found = Found { fit, fit_if_estimate, best: None, miss: None };
        match first {
            Some(first) => Found { best: self.best(&open, bounds, first), ..found },
            None => Found { miss: self.miss(&open, bounds, false).or_else(|| self.miss(&open, bounds, true)), ..found },
        }
    }

    /// Returns a group with its bounds.
    fn group<'b>(&self, open: &Open, bounds: &'b [Bounds]) -> Option<(&Group, BoundsOfOne<'b>)> {
        let group = self.conditions.groups.get(4 * open.four + open.place)?;
        Some((group, bounds.get(open.four)?.of_one(open.place)))
    }

    fn meets(&self, entrant: usize) -> bool {
        self.meets.get(entrant).copied().unwrap_or(false)
    }

    /// Returns the lightest member that meets the requirements.
    fn lightest<'g>(&self, group: &'g Group) -> Option<&'g Member> {
        let members = group.members.iter().filter(|member| self.meets(member.entrant));
        members.min_by(|a, b| a.mass_kg.total_cmp(&b.mass_kg).then(a.entrant.cmp(&b.entrant)))
    }

    /// Returns the state of a group, by its bounds and, if these are not sufficient, by the checks themselves.
    fn state(&self, group: &Group, bounds: BoundsOfOne<'_>) -> State {
        if bounds.fails() {
            return State::Fails;
        }
        if self.borne(group).is_some_and(|borne| borne.fails) {
            return State::Fails;
        }
        if bounds.is_unknown() {
            let judgement = self.judged(&group.representative);
            let holds = !judgement.leaves_load_unheld();
            return match judgement.fit() {
                Fit::DoesNotFit => State::Fails,
                fit => State::Fits { holds, is_inside_band: fit == Fit::FitsIfEstimate },
            };
        }
        let near = bounds.exceeding();
        let mut is_inside_band = self.borne(group).is_some_and(|borne| borne.is_inside_band);
        let is_certain = near.is_empty() || bounds.open().is_empty() && bounds.is_beyond_a_limit();
        if is_certain && self.others.is_empty() && self.has_outline {
            return State::Fits { holds: true, is_inside_band: is_inside_band || !near.is_empty() };
        }
        let mut holds = true;
        let mut fails = false;
        let ids: Vec<CheckId> = near.iter().chain(self.others.iter().copied()).collect();
        self.with_case(group, &ids, |case| {
            for id in ids.iter().copied() {
                let Some(check) = checked(id, case) else { continue };
                holds &= id != CheckId::BrakeHolding || !check.notes.contains(&Note::NothingHoldsWithoutPower);
                is_inside_band |= check.is_inside_band();
                if check.verdict == Verdict::Fail {
                    fails = true;
                    return;
                }
            }
        });
        if fails { State::Fails } else { State::Fits { holds, is_inside_band } }
    }

    /// Returns the results of the checks of the output bearing, made for the first actuator that has it.
    fn borne(&self, group: &Group) -> Option<Arc<OfBearing>> {
        let duty = self.axis.bearing.as_ref().filter(|_| !self.of_bearing.is_empty())?;
        let mut all = self.borne.borrow_mut();
        let known = all.get_mut(group.bearing)?;
        let found = known.get_or_insert_with(|| {
            let borne = Borne::of(self.axis, duty, &group.representative.output_bearing);
            let mut found = OfBearing::default();
            for id in &self.of_bearing {
                let Answer::Bearing(answer) = id.answer() else { continue };
                let Ok(check) = answer(&borne, &mut Workings::off()) else { continue };
                found.fails |= check.verdict == Verdict::Fail;
                found.is_inside_band |= check.is_inside_band();
                found.shares.extend(check.utilisation.filter(|_| id.has_margin()).map(|share| (share, *id)));
            }
            Arc::new(found)
        });
        Some(Arc::clone(found))
    }

    fn judged(&self, actuator: &Parameters) -> Judgement {
        Judge::new(self.axis, Scope::Deciding, Depth::UntilRejected).next(actuator, &mut |_, _| {})
    }

    /// Returns the best of the fitting groups, with its best member; `first`: the class that comes first.
    fn best(&self, open: &[Open], bounds: &[Bounds], first: Class) -> Option<Ranked> {
        let (is_unheld, is_inside_band, size) = first;
        let fit = if is_inside_band { Fit::FitsIfEstimate } else { Fit::Fits };
        let key = |utilisation: f64, mass_kg: f64| {
            RankKey::of(&Standing { fit, holds: !is_unheld, size, utilisation, failing: 0, mass_kg })
        };
        let mut best: Option<(RankKey, usize, Ranked)> = None;
        let candidate = |open: &Open| {
            let (group, bounds) = self.group(open, bounds)?;
            Some((key(bounds.least(), 0.0), group, bounds))
        };
        let of_the_class = open.iter().filter(|open| open.class() == Some(first));
        let mut candidates: Vec<(RankKey, &Group, BoundsOfOne<'_>)> = of_the_class.filter_map(candidate).collect();
        while let Some(at) = least_of(&candidates, |(key, ..)| *key) {
            let (least, group, bounds) = candidates.swap_remove(at);
            if best.as_ref().is_some_and(|(key, ..)| least > *key) {
                break;
            }
            let (utilisation, tightest) = self.utilisation(group, bounds);
            let Some(member) = self.lightest(group) else { continue };
            let key = key(utilisation, member.mass_kg);
            if best.as_ref().is_none_or(|(other, entrant, _)| (key, member.entrant) < (*other, *entrant)) {
                best = Some((key, member.entrant, Ranked { entrant: member.entrant, utilisation, tightest }));
                candidates.retain(|(least, ..)| *least <= key);
            }
        }
        best.map(|(.., ranked)| ranked)
    }

    /// Returns the largest utilisation of a fitting group, by the checks whose bounds allow it.
    fn utilisation(&self, group: &Group, bounds: BoundsOfOne<'_>) -> (f64, Option<CheckId>) {
        if bounds.is_unknown() {
            let judgement = self.judged(&group.representative);
            return (judgement.utilisation(), judgement.governing().map(|check| check.id));
        }
        let ids: Vec<CheckId> =
            bounds.contenders().iter().chain(self.others.iter().copied()).filter(|id| id.has_margin()).collect();
        let mut shares: Vec<(f64, Precedence)> = Vec::new();
        self.with_case(group, &ids, |case| {
            let borne = self.borne(group);
            let known = borne.iter().flat_map(|borne| &borne.shares);
            let known = known.map(|(share, id)| (*share, Precedence::of_own_limit(*id)));
            let shared = |id: &CheckId| {
                let check = checked(*id, case)?;
                Some((check.utilisation?, precedence(&check)))
            };
            shares.extend(ids.iter().filter_map(shared).chain(known));
        });
        let largest = shares.iter().map(|(share, _)| *share).fold(0.0, f64::max);
        (largest, first_of_equal(shares, largest))
    }

    /// Returns the group with the smallest excess among those that do not fit: without those that the place of
    /// installation excludes, or `elsewhere` these alone.
    fn miss(&self, open: &[Open], bounds: &[Bounds], elsewhere: bool) -> Option<Ranked> {
        let key = |group: &Group, utilisation: f64, failing: usize, mass_kg: f64| {
            let fit = Fit::DoesNotFit;
            RankKey::of(&Standing { fit, holds: true, size: group.size, utilisation, failing, mass_kg })
        };
        let mut best: Option<(RankKey, usize, Ranked)> = None;
        let candidate = |open: &Open| {
            let (group, bounds) = self.group(open, bounds)?;
            (elsewhere || !bounds.is_of_another_place()).then(|| (key(group, bounds.least_failing(), 0, 0.0), group))
        };
        let mut candidates: Vec<(RankKey, &Group)> = open.iter().filter_map(candidate).collect();
        while let Some(at) = least_of(&candidates, |(key, _)| *key) {
            let (least, group) = candidates.swap_remove(at);
            if best.as_ref().is_some_and(|(key, ..)| least > *key) {
                break;
            }
            // The bound is below every failing check, so every check is made.
            let judgement = judge(self.axis, &group.representative, Scope::Deciding);
            let excludes = |check: &Check| check.verdict == Verdict::Fail && check.id.is_of_the_place();
            if judgement.checks.iter().any(excludes) != elsewhere {
                continue;
            }
            let utilisation = judgement.utilisation();
            let Some(member) = self.lightest(group) else { continue };
            let key = key(group, utilisation, judgement.failing(), member.mass_kg);
            if best.as_ref().is_none_or(|(other, entrant, _)| (key, member.entrant) < (*other, *entrant)) {
                let tightest = judgement.worst_failure().map(|check| check.id);
                best = Some((key, member.entrant, Ranked { entrant: member.entrant, utilisation, tightest }));
                candidates.retain(|(least, _)| *least <= key);
            }
        }
        best.map(|(.., ranked)| ranked)
    }
}

/// Returns the index of the first of the least ones.
fn least_of<T>(all: &[T], key: impl Fn(&T) -> RankKey) -> Option<usize> {
    all.iter().enumerate().min_by_key(|(_, each)| key(each)).map(|(place, _)| place)
}

/// Makes a check of an actuator as [`judge`](crate::judge()) does.
fn checked(id: CheckId, case: &Case<'_>) -> Option<Check> {
    id.of(case, &mut Workings::off())
}

/// Returns `true` if a check uses currents, voltages or heat.
fn is_electric(id: CheckId) -> bool {
    id.shared_by() == SharedBy::Nothing
        && !matches!(id, CheckId::PeakTorque | CheckId::ScrewJointLoad | CheckId::ScrewJointHousing)
}

impl Row<'_> {
    /// Provides the data that some checks of an actuator use.
    fn with_case(&self, group: &Group, ids: &[CheckId], look: impl FnOnce(&Case<'_>)) {
        let (axis, actuator) = (self.axis, &group.representative);
        let made;
        let electrics = if ids.iter().copied().any(is_electric) {
            let is_limited =
                ids.iter().any(|id| matches!(id, CheckId::ContinuousTorque | CheckId::OverloadI2t | CheckId::Altitude));
            made = match self.conditions.drive(group.drive) {
                Some((drive, place)) => place.electrics(axis, drive, is_limited),
                None => Electrics::of(axis, actuator),
            };
            &made
        } else {
            &Electrics::UNKNOWN
        };
        let demand = actuator.inertia_out.known().map(|inertia| axis.demand(inertia.value));
        let currents = Currents::of(axis, actuator, electrics);
        let bearing = axis.bearing.as_ref().map(|duty| Borne::of(axis, duty, &actuator.output_bearing));
        look(&Case {
            axis,
            actuator,
            demand: demand.as_ref(),
            manual: None,
            electrics,
            currents: currents.as_ref(),
            bearing: bearing.as_ref(),
            only_failing: false,
        });
    }
}
