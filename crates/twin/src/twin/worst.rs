//! Instant of an event that the call leaves open: that with the worst effect.

use super::{PERIOD_S, Twin};
use crate::control::POSITION_EVERY;
use crate::drive::Phase;
use crate::scenario::{EventKind, Reaction, ScenarioId};
use crate::setup::{Fault, Setup};
use crate::summary::Gathered;
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

identified! {
    /// Direction of the motion at an event.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum MotionDirection {
        /// The position increases.
        Positive = "positive",
        /// The position decreases.
        Negative = "negative",
        /// The setpoint is at rest.
        Standstill = "standstill",
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
    /// Worst instant of every direction, the worst of all first.
    pub directions: Vec<WorstOf>,
}

/// Largest number of instants examined: three by direction, direction and property, nine at rest, eight in the search
/// about each of three.
pub const INSTANTS_MOST: u32 = 2 * 3 * MOVES + 3 * RESTS + 3 * 2 * ROUNDS;

/// Longest time after the event that is examined \[s\].
pub const EXAMINED_S: f64 = 2.0;

/// Moves of each direction, by each of three properties.
const MOVES: u32 = 4;

/// Standstills, each at beginning, middle and end.
const RESTS: u32 = 3;

/// Rounds of the search about the worst instant of a direction; the first step is an eighth of the move, and half as
/// long in each further round.
const ROUNDS: u32 = 4;
const FIRST_STEP: f64 = 0.125;

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

/// Stretch of the motion in one direction, or at rest, within one segment.
struct Stretch {
    direction: MotionDirection,
    from_s: f64,
    until_s: f64,
    /// Largest values of the properties, with their instants.
    properties: [(f64, f64); 3],
}

/// An examined instant.
#[derive(Clone, Copy, Debug)]
struct Seen {
    at_s: f64,
    stretch: usize,
    rests: bool,
    travel_rad: f64,
    /// Torque, negative voltage or speed.
    second: f64,
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
/// In every move speed, power and the travel of a rigid body under friction, load and brake give the first instants, and a
/// search about the worst of each direction the further ones; from each the run itself goes on until rest. Standstills
/// have beginning, middle and end.
///
/// # Source
/// docs/theory/twin.md
/// # Valid
/// at most [`INSTANTS_MOST`] instants and [`EXAMINED_S`] after each; a motion with more moves has the worst by their
/// rigid travel, speed and power
/// # Errors
/// [`Fault`] of [`Twin::new`]; `Ok(None)` if the scenario has no instant, the setup states it, or the caller cancels
pub fn worst_instant(setup: &Setup<'_>, mut goes_on: impl FnMut() -> bool) -> Result<Option<WorstInstant>, Fault> {
    if !setup.scenario.id.has_instant() || setup.scenario.at_s.is_some() {
        return Ok(None);
    }
    let mut base = Twin::new(setup)?;
    base.happens_s = None;
    let stretches = base.stretches();
    let end_s = base.course.first_cycle_s();
    let mut states = vec![base];
    for place in 1..STATES {
        let until = tick_of(end_s * f64::from(place) / f64::from(STATES));
        let Some(mut next) = states.last().cloned() else { break };
        if !next.advance_watched(until, &mut goes_on) {
            return Ok(None);
        }
        next.gathered = Gathered::new(setup.settled_rad);
        states.push(next);
    }
    let mut search = Search { setup, states, stretches, end_s, seen: Vec::new(), goes_on: &mut goes_on };
    Ok(search.found())
}

struct Search<'s, 'a> {
    setup: &'s Setup<'a>,
    states: Vec<Twin<'a>>,
    stretches: Vec<Stretch>,
    end_s: f64,
    seen: Vec<Seen>,
    goes_on: &'s mut dyn FnMut() -> bool,
}

impl Search<'_, '_> {
    /// Returns the worst instants; `None` if the caller cancels or there is no instant.
    fn found(&mut self) -> Option<WorstInstant> {
        for (at_s, stretch) in self.first() {
            self.examine(at_s, stretch)?;
        }
        for direction in MotionDirection::ALL {
            let Some(mut worst) = self.worst_of(direction) else { continue };
            let Some(stretch) = self.stretches.get(worst.stretch) else { continue };
            let (from_s, until_s) = (stretch.from_s, stretch.until_s);
            let mut step = FIRST_STEP * (until_s - from_s);
            for _ in 0..ROUNDS {
                for way in [-step, step] {
                    let at_s = (worst.at_s + way).clamp(from_s, until_s);
                    self.examine(at_s, worst.stretch)?;
                }
                worst = self.worst_of(direction)?;
                step *= 0.5;
            }
        }
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
        #[allow(clippy::cast_possible_truncation, reason = "some dozens")]
        let examined = self.seen.len() as u32;
        Some(WorstInstant { effect, examined, directions: directions.collect() })
    }

    fn worst_of(&self, direction: MotionDirection) -> Option<Seen> {
        let own = self.seen.iter().filter(|seen| self.is_of(seen.stretch, direction));
        own.copied().reduce(|worst, seen| if seen.is_worse_than(&worst) { seen } else { worst })
    }

    fn is_of(&self, stretch: usize, direction: MotionDirection) -> bool {
        self.stretches.get(stretch).is_some_and(|each| each.direction == direction)
    }

    /// Returns the first instants, each with its stretch.
    fn first(&self) -> Vec<(f64, usize)> {
        let mut found: Vec<(f64, usize)> = Vec::new();
        let scenario = self.setup.scenario.id;
        let ranked = |direction: MotionDirection, property: usize, most: u32| {
            let value = |stretch: &Stretch| stretch.properties.get(property).copied().unwrap_or_default();
            let own = self.stretches.iter().enumerate().filter(|(_, each)| each.direction == direction);
            let mut all: Vec<(f64, f64, usize)> =
                own.map(|(place, each)| (value(each).0, value(each).1, place)).collect();
            all.sort_by(|a, b| b.0.total_cmp(&a.0));
            all.truncate(most as usize);
            all
        };
        if scenario != ScenarioId::HangingLoad {
            for property in [SPEED, TRAVEL, POWER] {
                for direction in [MotionDirection::Positive, MotionDirection::Negative] {
                    found.extend(ranked(direction, property, MOVES).iter().map(|&(_, at_s, place)| (at_s, place)));
                }
            }
        }
        if scenario != ScenarioId::Collision {
            for (_, _, place) in ranked(MotionDirection::Standstill, TRAVEL, RESTS) {
                let Some(Stretch { from_s, until_s, .. }) = self.stretches.get(place) else { continue };
                found.extend([*from_s, f64::midpoint(*from_s, *until_s), *until_s].map(|at_s| (at_s, place)));
            }
        }
        found
    }

    /// Examines an instant; `None` if the caller cancels.
    fn examine(&mut self, at_s: f64, stretch: usize) -> Option<()> {
        let tick = tick_of(at_s);
        // The instant at which the drive reacts, if the axis is in the same state there.
        let exact_s = time_of(tick);
        let place = self.states.partition_point(|state| state.tick <= tick).saturating_sub(1);
        let state = self.states.get(place)?;
        let stands = |time: f64| state.course.at(time).state[1].abs() < AT_REST;
        let at_s = if stands(at_s) == stands(exact_s) { exact_s } else { at_s };
        let is_wrong = match self.setup.scenario.id {
            ScenarioId::HangingLoad => !stands(at_s),
            ScenarioId::Collision => stands(at_s),
            _ => false,
        };
        if is_wrong || at_s >= self.end_s || self.seen.iter().any(|seen| (seen.at_s - at_s).abs() < 0.5 * PERIOD_S) {
            return Some(());
        }
        let speed = state.course.at(at_s).state[1].abs();
        let mut fork = state.clone();
        if !fork.advance_watched(tick, self.goes_on) {
            return None;
        }
        fork.gathered = Gathered::new(self.setup.settled_rad);
        fork.happens_s = Some(at_s);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "two seconds")]
        let [most, running] = [EXAMINED_S, RUNNING_S].map(|time| (time / PERIOD_S) as u64);
        (fork.end_tick, fork.latest_tick) = (tick + most, tick + most);
        let rested_s = RESTED_S + fork.brake.delays()[1];
        let mut rested = 0.0;
        while !fork.is_over() && rested < rested_s {
            if !(self.goes_on)() {
                return None;
            }
            fork.advance(CHUNK);
            let runs = fork.follows();
            if runs && fork.tick > tick + running {
                break;
            }
            #[allow(clippy::cast_precision_loss, reason = "a count")]
            let chunk_s = CHUNK as f64 * PERIOD_S;
            rested = if !runs && fork.gathered.is_stopped() { rested + chunk_s } else { 0.0 };
        }
        let stops = !fork.follows();
        let (second, counts) = match self.setup.scenario.id {
            ScenarioId::BlockedLoad | ScenarioId::Collision => (fork.gathered.torque_nm(), false),
            ScenarioId::LinkSag => (-fork.gathered.link_low_v(), stops),
            _ => (speed, stops),
        };
        self.seen.push(Seen {
            at_s,
            stretch,
            rests: !counts || fork.gathered.is_stopped(),
            travel_rad: if counts { fork.gathered.travel_rad() } else { 0.0 },
            second,
        });
        Some(())
    }
}

/// Places of the properties of a stretch.
const SPEED: usize = 0;
const TRAVEL: usize = 1;
const POWER: usize = 2;

/// Speed below which the setpoint is at rest [rad/s].
const AT_REST: f64 = 1e-9;

/// Returns the first period of the position loop at or after a time.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a time of the run")]
fn tick_of(time_s: f64) -> u64 {
    #[allow(clippy::cast_precision_loss, reason = "eight")]
    let every = POSITION_EVERY as f64 * PERIOD_S;
    (time_s / every - 1e-6).ceil().max(0.0) as u64 * POSITION_EVERY
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

    /// Returns the stretches of the first cycle, with the instants of their largest properties.
    fn stretches(&self) -> Vec<Stretch> {
        let mut found: Vec<Stretch> = Vec::new();
        let mut segment = usize::MAX;
        for time in self.course.instants() {
            let point = self.course.at(time);
            let speed = point.state[1];
            let direction = match speed {
                _ if speed.abs() < AT_REST => MotionDirection::Standstill,
                _ if speed > 0.0 => MotionDirection::Positive,
                _ => MotionDirection::Negative,
            };
            let properties = self.properties(time);
            match found.last_mut() {
                Some(last) if last.direction == direction && segment == point.segment => {
                    last.until_s = time;
                    for (known, value) in last.properties.iter_mut().zip(properties) {
                        if value > known.0 {
                            *known = (value, time);
                        }
                    }
                }
                _ => found.push(Stretch {
                    direction,
                    from_s: time,
                    until_s: time,
                    properties: properties.map(|value| (value, time)),
                }),
            }
            segment = point.segment;
        }
        found
    }

    /// Returns speed, travel of the rigid body after the event, and power of the motion at an instant; at rest the travel
    /// of the unbraked load.
    fn properties(&self, time: f64) -> [f64; 3] {
        let point = self.course.at(time);
        let [position, speed, acceleration] = point.state;
        let Some(local) = self.load.linearised(point.segment, position, speed, acceleration) else {
            return [speed.abs(), 0.0, 0.0];
        };
        let inertia = self.plant.inertia_kgm2 + local.inertia_kgm2;
        let load_nm = local.torque(position, speed);
        let way = if speed.abs() < AT_REST { -load_nm.signum() } else { speed.signum() };
        let rubbed = self.plant.friction_nm + self.plant.viscous_nms * speed.abs() + local.coulomb_nm;
        let free = (-way * load_nm - rubbed) / inertia;
        let power = speed * (inertia * acceleration + load_nm) + speed.abs() * rubbed;
        let reaction = self.setup.scenario.reaction;
        let is_stop = self.setup.scenario.id == ScenarioId::EmergencyStop;
        let travel = match self.machine.brake {
            _ if is_stop && reaction == Reaction::Ramp && self.limits.ramp_rad_s2 > 0.0 => {
                speed * speed / (2.0 * self.limits.ramp_rad_s2)
            }
            Some(brake) if !(is_stop && reaction == Reaction::Coast) => {
                let [closing, at_closing] = glided(speed.abs(), free, brake.closing_s);
                closing + glided(at_closing, free - brake.torque_nm / inertia, EXAMINED_S)[0]
            }
            _ => glided(speed.abs(), free, EXAMINED_S)[0],
        };
        [speed.abs(), travel, power]
    }
}

/// Returns way and final speed of a body under constant acceleration, until it stops or the time ends.
fn glided(speed: f64, acceleration: f64, time: f64) -> [f64; 2] {
    if speed + acceleration * time <= 0.0 {
        let way = if acceleration < 0.0 { speed * speed / (-2.0 * acceleration) } else { 0.0 };
        [way, 0.0]
    } else {
        [speed * time + 0.5 * acceleration * time * time, speed + acceleration * time]
    }
}
