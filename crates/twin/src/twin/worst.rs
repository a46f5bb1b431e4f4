//! Instant of an event that the call leaves open: that with the worst effect.

mod moves;

use super::start::RUN_UP_MOST_S;
use super::{PERIOD_S, Twin};
use crate::control::POSITION_EVERY;
use crate::drive::Phase;
use crate::scenario::{EventKind, Part, Scenario, ScenarioId};
use crate::setup::{Fault, Setup};
use crate::summary::Gathered;
pub use moves::MotionDirection;
use moves::{AT_REST, BEYOND, EXAMINED_S, POWER, SPEED, Stretch, TRAVEL};
use quantities::identified;

identified! {
    /// Effect by which the worst instant of an event is chosen.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum EventEffect {
        /// Largest distance from the place of the event until the axis is at rest \[rad\].
        Travel = "travel",
        /// Largest torque through the gear after the event \[Nm\].
        Torque = "torque",
        /// Lowest voltage of the DC link after the event \[V\].
        Link = "link_voltage",
        /// Speed of the motion at the event, if the event has no effect [rad/s].
        Speed = "speed",
    }
}

/// Worst instant of one direction of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstOf {
    /// Direction of the motion at the instant.
    pub direction: MotionDirection,
    /// Instant \[s\].
    pub at_s: f64,
    /// Effect of the event, in SI.
    pub value: f64,
    /// The axis comes to rest within the examined time, or the event does not stop it.
    pub rests: bool,
}

/// Worst instants of an event, by direction of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstInstant {
    /// Effect by which they are chosen.
    pub effect: EventEffect,
    /// Number of instants examined.
    pub examined: u32,
    /// The search left instants out because of its largest number of periods.
    pub is_cut: bool,
    /// Worst instant of every direction, the worst of all first.
    pub directions: Vec<WorstOf>,
    /// Events after which the axis leaves the range of its motion farthest, one for each end that it passes; empty if the
    /// cycle does not end where it starts.
    pub overruns: Vec<EndOverrun>,
}

/// Farthest way beyond an end of the motion after an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndOverrun {
    /// Direction of the end: [`MotionDirection::Positive`] beyond the highest position of the motion.
    pub end: MotionDirection,
    /// Instant of the event \[s\].
    pub at_s: f64,
    /// Distance of the farthest position from the end of the motion \[rad\].
    pub beyond_rad: f64,
    /// The axis comes to rest within the examined time.
    pub rests: bool,
}

/// Largest number of instants examined: four moves by direction and property, three at each of three standstills, twelve in
/// the search about the worst of each direction and about the farthest beyond each end.
pub const INSTANTS_MOST: u32 = 2 * 4 * MOVES + 3 * RESTS + (3 + 2) * 2 * ROUNDS;

/// Number of instants below which a search is not begun.
const INSTANTS_LEAST: u32 = 12;

/// Longest cycle that is run to reach its instants \[s\]: in a longer one every instant has its own run-up, of at most
/// [`RUN_UP_MOST_S`], which is less work.
const RUN_WHOLE_S: f64 = RUN_UP_MOST_S * INSTANTS_MOST as f64;

/// Moves of each direction, by each of four properties.
const MOVES: u32 = 4;

/// Standstills, each at beginning, middle and end.
const RESTS: u32 = 3;

/// Rounds of the search about the worst instant; the first step is an eighth of the move, and half as
/// long in each further round.
const ROUNDS: u32 = 6;
const FIRST_STEP: f64 = 0.125;

/// Way beyond an end of the motion from which it counts, relative to the range of the motion: less is the following error
/// of any stop at the end.
const OVERRUN_LEAST: f64 = 1e-3;

/// Time after the event at which a drive that still runs is left \[s\].
const RUNNING_S: f64 = 0.5;

/// Duration of standstill that ends the examination, besides the closing time of the brake \[s\].
const RESTED_S: f64 = 0.1;

/// Number of states of the run from which the instants are reached.
const STATES: u32 = 64;

/// Periods between two polls of the caller: 64 ms.
const AT_ONCE: u64 = 1024;

/// Periods between two evaluations of the standstill: 10 ms.
const CHUNK: u64 = 160;

/// An examined instant.
#[derive(Clone, Copy, Debug)]
struct Seen {
    at_s: f64,
    stretch: usize,
    rests: bool,
    travel_rad: f64,
    /// Torque, negative voltage or speed.
    second: f64,
    /// Distance beyond the lower and the upper end of the motion \[rad\], negative within.
    beyond_rad: [f64; 2],
}

impl Seen {
    fn is_worse_than(&self, other: &Self) -> bool {
        // A difference within rounding is none: the earlier candidate is kept.
        let over = |a: f64, b: f64| a > b + 1e-9 * b.abs();
        match (self.rests, other.rests) {
            (false, true) => true,
            (true, false) => false,
            _ if over(self.travel_rad, other.travel_rad) => true,
            _ if over(other.travel_rad, self.travel_rad) => false,
            _ => over(self.second, other.second),
        }
    }
}

/// Chooses the worst instant of the event of a scenario within the first cycle, or within the part: that after which the
/// axis travels farthest until it is at rest, or with the largest torque of a collision or a blocked load, or with the
/// lowest DC link if a drop of the supply stops nothing.
///
/// In every move speed, power, and travel and end of travel of a rigid body under friction, load and brake give the first
/// instants, and a search about the worst of each direction, and about the farthest beyond each end of a motion that
/// returns, the further ones; from each the run itself goes on until rest. Standstills have beginning, middle and end. In
/// a cycle longer than 202 s each instant is reached by a run-up of its own.
///
/// With `periods_most` the search ends before it computes more periods of the current loop than that;
/// [`search_periods`] has the number that suffices.
///
/// # Source
/// docs/theory/twin.md
/// # Valid
/// at most [`INSTANTS_MOST`] instants and 2 s after each; a motion with more moves has the worst by their
/// rigid travel, speed and power
/// # Errors
/// [`Fault`] of [`Twin::new`]; `Ok(None)` if the scenario has no instant, the setup states it, or the caller cancels
pub fn worst_instant(
    setup: &Setup<'_>,
    periods_most: Option<u64>,
    mut goes_on: impl FnMut() -> bool,
) -> Result<Option<WorstInstant>, Fault> {
    if !setup.scenario.id.has_instant() || setup.scenario.at_s.is_some() {
        return Ok(None);
    }
    let mut base = Twin::new(setup)?;
    base.happens_s = None;
    let ends_rad = base.course.ends_rad();
    let stretches = base.stretches(ends_rad);
    let end_s = base.course.first_cycle_s();
    let whole = periods_of(end_s);
    let left = periods_most.unwrap_or(u64::MAX).saturating_sub(if end_s > RUN_WHOLE_S { 0 } else { whole });
    let states_most = if end_s > RUN_WHOLE_S { 1 } else { STATES };
    let mut states = vec![base];
    for place in 1..states_most {
        let until = tick_of(end_s * f64::from(place) / f64::from(STATES));
        let Some(mut next) = states.last().cloned() else { break };
        if !next.advance_watched(until, &mut goes_on) {
            return Ok(None);
        }
        next.gathered = Gathered::new(setup.settled_rad);
        states.push(next);
    }
    let mut search = Search {
        setup,
        states,
        stretches,
        end_s,
        ends_rad,
        seen: Vec::new(),
        left,
        is_cut: false,
        goes_on: &mut goes_on,
    };
    search.found()
}

/// Returns the smallest and the largest number of periods of the current loop of a search in a cycle.
#[must_use]
pub fn search_periods(cycle: u64) -> [u64; 2] {
    let whole = periods_of(RUN_WHOLE_S);
    let (to_reach, each_s) = if cycle > whole { (0, RUN_UP_MOST_S + EXAMINED_S) } else { (cycle, EXAMINED_S) };
    [INSTANTS_LEAST, INSTANTS_MOST].map(|instants| to_reach + u64::from(instants) * periods_of(each_s))
}

struct Search<'s, 'a> {
    setup: &'s Setup<'a>,
    /// States of the run to go on from; the first alone in a long cycle.
    states: Vec<Twin<'a>>,
    stretches: Vec<Stretch>,
    end_s: f64,
    ends_rad: Option<[f64; 2]>,
    seen: Vec<Seen>,
    /// Periods that may still be computed.
    left: u64,
    is_cut: bool,
    goes_on: &'s mut dyn FnMut() -> bool,
}

/// Ends of the motion, with their place in a pair.
const ENDS: [(MotionDirection, usize); 2] = [(MotionDirection::Positive, 1), (MotionDirection::Negative, 0)];

impl<'a> Search<'_, 'a> {
    /// Returns the worst instants; `None` if the caller cancels or there is no instant.
    fn found(&mut self) -> Result<Option<WorstInstant>, Fault> {
        // A search that is cut has half its periods for the moves and half for the instants about the worst.
        let kept = if self.left == u64::MAX { 0 } else { self.left / 2 };
        self.left -= kept;
        for (at_s, stretch) in self.first() {
            if !self.examine(at_s, stretch)? {
                return Ok(None);
            }
        }
        self.left += kept;
        for direction in MotionDirection::ALL {
            if !self.refine(|search| search.worst_of(direction))? {
                return Ok(None);
            }
        }
        for (direction, end) in ENDS {
            // A load that sags at standstill is no reason to leave the move towards the end unexamined.
            if !self.refine(|search| search.farthest(end, |search, stretch| search.is_of(stretch, direction)))? {
                return Ok(None);
            }
        }
        Ok(self.chosen())
    }

    /// Examines instants about that which is the worst so far; `false` if the caller cancels.
    fn refine(&mut self, worst: impl Fn(&Self) -> Option<Seen>) -> Result<bool, Fault> {
        let Some(mut found) = worst(self) else { return Ok(true) };
        let Some(stretch) = self.stretches.get(found.stretch) else { return Ok(true) };
        let (from_s, until_s) = (stretch.from_s, stretch.until_s);
        let mut step = FIRST_STEP * (until_s - from_s);
        for _ in 0..ROUNDS {
            for way in [-step, step] {
                let at_s = (found.at_s + way).clamp(from_s, until_s);
                if !self.examine(at_s, found.stretch)? {
                    return Ok(false);
                }
            }
            found = worst(self).unwrap_or(found);
            step *= 0.5;
        }
        Ok(true)
    }

    /// Returns the worst of the examined instants.
    fn chosen(&self) -> Option<WorstInstant> {
        let mut found: Vec<(MotionDirection, Seen)> = MotionDirection::ALL
            .into_iter()
            .filter_map(|direction| Some((direction, self.worst_of(direction)?)))
            .collect();
        // Stable: of equal effects the direction of the fastest move stays first.
        found.sort_by(|(_, a), (_, b)| {
            let order = |is_worse: bool, order| is_worse.then_some(order);
            order(a.is_worse_than(b), std::cmp::Ordering::Less)
                .or(order(b.is_worse_than(a), std::cmp::Ordering::Greater))
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        let (_, first) = *found.first()?;
        let effect = match self.setup.scenario.id {
            _ if first.travel_rad > 0.0 => EventEffect::Travel,
            ScenarioId::BlockedLoad | ScenarioId::Collision => EventEffect::Torque,
            ScenarioId::LinkSag => EventEffect::Link,
            _ => EventEffect::Speed,
        };
        let directions = found.into_iter().map(|(direction, seen)| WorstOf {
            direction,
            at_s: seen.at_s,
            value: match effect {
                EventEffect::Travel => seen.travel_rad,
                EventEffect::Link => -seen.second,
                EventEffect::Torque | EventEffect::Speed => seen.second,
            },
            rests: seen.rests,
        });
        let least_rad = self.ends_rad.map_or(f64::INFINITY, |[lower, upper]| OVERRUN_LEAST * (upper - lower));
        let overruns = ENDS.into_iter().filter_map(|(end, place)| {
            let seen = self.farthest(place, |_, _| true)?;
            let beyond_rad = *seen.beyond_rad.get(place)?;
            (beyond_rad > least_rad).then_some(EndOverrun { end, at_s: seen.at_s, beyond_rad, rests: seen.rests })
        });
        #[allow(clippy::cast_possible_truncation, reason = "some dozens")]
        let examined = self.seen.len() as u32;
        Some(WorstInstant {
            effect,
            examined,
            is_cut: self.is_cut,
            directions: directions.collect(),
            overruns: overruns.collect(),
        })
    }

    /// Returns the instant after which the axis is farthest beyond an end of the motion, by the place of the end, among those
    /// in some stretches.
    fn farthest(&self, end: usize, of: impl Fn(&Self, usize) -> bool) -> Option<Seen> {
        let beyond = |seen: &Seen| seen.beyond_rad.get(end).copied().unwrap_or(f64::NEG_INFINITY);
        let all = self.seen.iter().filter(|seen| of(self, seen.stretch) && beyond(seen).is_finite());
        all.copied().reduce(|most, seen| if beyond(&seen) > beyond(&most) { seen } else { most })
    }

    fn worst_of(&self, direction: MotionDirection) -> Option<Seen> {
        let own = self.seen.iter().filter(|seen| self.is_of(seen.stretch, direction));
        own.copied().reduce(|worst, seen| if seen.is_worse_than(&worst) { seen } else { worst })
    }

    fn is_of(&self, stretch: usize, direction: MotionDirection) -> bool {
        self.stretches.get(stretch).is_some_and(|each| each.direction == direction)
    }

    /// Returns the first instants, each with its stretch, those of the largest properties first.
    fn first(&self) -> Vec<(f64, usize)> {
        let mut found: Vec<(f64, usize)> = Vec::new();
        let scenario = self.setup.scenario.id;
        let ranked = |direction: MotionDirection, property: usize| {
            let value = |stretch: &Stretch| stretch.properties.get(property).copied().unwrap_or_default();
            let own = self.stretches.iter().enumerate().filter(|(_, each)| each.direction == direction);
            let mut all: Vec<(f64, f64, usize)> =
                own.map(|(place, each)| (value(each).0, value(each).1, place)).collect();
            all.sort_by(|a, b| b.0.total_cmp(&a.0));
            all
        };
        if scenario != ScenarioId::HangingLoad {
            let properties = [SPEED, TRAVEL, POWER, BEYOND].into_iter();
            let ranks: Vec<_> = properties
                .filter(|property| *property != BEYOND || self.ends_rad.is_some())
                .flat_map(|property| {
                    [MotionDirection::Positive, MotionDirection::Negative].map(|way| ranked(way, property))
                })
                .collect();
            for rank in 0..MOVES as usize {
                found.extend(ranks.iter().filter_map(|all| all.get(rank)).map(|&(_, at_s, place)| (at_s, place)));
            }
        }
        if scenario != ScenarioId::Collision {
            for &(_, _, place) in ranked(MotionDirection::Standstill, TRAVEL).iter().take(RESTS as usize) {
                let Some(Stretch { from_s, until_s, .. }) = self.stretches.get(place) else { continue };
                found.extend([*from_s, f64::midpoint(*from_s, *until_s), *until_s].map(|at_s| (at_s, place)));
            }
        }
        found
    }

    /// Returns the run at an instant: on the way through the cycle, or in a long cycle after a run-up at the instant
    /// itself; `None` if the caller cancels.
    fn reached(&mut self, tick: u64) -> Result<Option<Twin<'a>>, Fault> {
        let place = self.states.partition_point(|state| state.tick <= tick).saturating_sub(1);
        let Some(state) = self.states.get(place) else { return Ok(None) };
        if self.end_s <= RUN_WHOLE_S {
            let mut fork = state.clone();
            return Ok(fork.advance_watched(tick, self.goes_on).then_some(fork));
        }
        let from_s = self.setup.part.map_or(0.0, |part| part.from_s) + time_of(tick);
        let part = Part { from_s, for_s: (self.end_s - time_of(tick)).max(PERIOD_S) };
        let scenario = Scenario { at_s: Some(0.0), ..self.setup.scenario };
        Twin::new(&Setup { part: Some(part), scenario, ..*self.setup }).map(Some)
    }

    /// Examines an instant; `false` if the caller cancels.
    fn examine(&mut self, at_s: f64, stretch: usize) -> Result<bool, Fault> {
        let tick = tick_of(at_s);
        // The instant at which the drive reacts, if the axis is in the same state there.
        let exact_s = time_of(tick);
        let Some(course) = self.states.first().map(|state| &state.course) else { return Ok(true) };
        let stands = |time: f64| course.at(time).state[1].abs() < AT_REST;
        let at_s = if stands(at_s) == stands(exact_s) { exact_s } else { at_s };
        let is_wrong = match self.setup.scenario.id {
            ScenarioId::HangingLoad => !stands(at_s),
            ScenarioId::Collision => stands(at_s),
            _ => false,
        };
        if is_wrong || at_s >= self.end_s || self.seen.iter().any(|seen| (seen.at_s - at_s).abs() < 0.5 * PERIOD_S) {
            return Ok(true);
        }
        let is_long = self.end_s > RUN_WHOLE_S;
        let [most, running, run_up] = [EXAMINED_S, RUNNING_S, RUN_UP_MOST_S].map(periods_of);
        let needed = most + if is_long { run_up } else { 0 };
        if self.left < needed {
            self.is_cut = true;
            return Ok(true);
        }
        let speed = course.at(at_s).state[1].abs();
        let settled_rad = self.setup.settled_rad;
        let Some(mut fork) = self.reached(tick)? else { return Ok(false) };
        let begin = fork.tick;
        fork.gathered = Gathered::new(settled_rad);
        fork.happens_s = Some(if is_long { time_of(begin) } else { at_s });
        (fork.end_tick, fork.latest_tick) = (begin + most, begin + most);
        let rested_s = RESTED_S + fork.brake.delays()[1];
        let mut rested = 0.0;
        while !fork.is_over() && rested < rested_s {
            if !(self.goes_on)() {
                return Ok(false);
            }
            fork.advance(CHUNK);
            let runs = fork.follows();
            if runs && fork.tick > begin + running {
                break;
            }
            rested = if !runs && fork.gathered.is_stopped() { rested + time_of(CHUNK) } else { 0.0 };
        }
        self.left = self.left.saturating_sub(fork.tick - begin + needed - most);
        let stops = !fork.follows();
        let (second, counts) = match self.setup.scenario.id {
            ScenarioId::BlockedLoad | ScenarioId::Collision => (fork.gathered.torque_nm(), false),
            ScenarioId::LinkSag => (-fork.gathered.link_low_v(), stops),
            _ => (speed, stops),
        };
        let [lowest, highest] = fork.gathered.reached_rad();
        self.seen.push(Seen {
            at_s,
            stretch,
            rests: !counts || fork.gathered.is_stopped(),
            travel_rad: if counts { fork.gathered.travel_rad() } else { 0.0 },
            second,
            beyond_rad: match self.ends_rad {
                Some([lower, upper]) if counts => [lower - lowest, highest - upper],
                _ => [f64::NEG_INFINITY; 2],
            },
        });
        Ok(true)
    }
}

/// Returns the first period of the position loop at or after a time.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a time of the run")]
fn tick_of(time_s: f64) -> u64 {
    #[allow(clippy::cast_precision_loss, reason = "eight")]
    let every = POSITION_EVERY as f64 * PERIOD_S;
    (time_s / every - 1e-6).ceil().max(0.0) as u64 * POSITION_EVERY
}

/// Returns the number of periods of the current loop in a time.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a time of the run")]
fn periods_of(time_s: f64) -> u64 {
    (time_s / PERIOD_S) as u64
}

#[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
fn time_of(tick: u64) -> f64 {
    tick as f64 * PERIOD_S
}

impl Twin<'_> {
    /// Returns `true` while the drive follows the motion.
    fn follows(&self) -> bool {
        matches!(self.phase, Phase::Running | Phase::Resting)
    }

    /// Advances to a period; `false` if the caller cancels.
    fn advance_watched(&mut self, until: u64, goes_on: &mut dyn FnMut() -> bool) -> bool {
        while self.tick < until && !self.is_over() {
            if !goes_on() {
                return false;
            }
            self.advance((until - self.tick).min(AT_ONCE));
        }
        true
    }

    /// Returns `true` if a run at its end continues: the drive has stopped the axis, which still moves.
    pub(super) fn runs_out(&self) -> bool {
        let is_possible = self.tick < self.latest_tick && self.happened && !self.follows();
        is_possible
            && !self.gathered.is_stopped()
            && self.state.x.motor_rad_s.abs() <= 1.1 * self.machine.speed_max
            && !self.has(EventKind::Diverged)
    }
}
