//! The manual's cycle: accelerate, run, brake, pause; several moves may follow each other.

use quantities::{AngularAcceleration, AngularVelocity, Measure, Time};

/// One move of the manual's cycle (section 7.1): from rest to `speed`, and back to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ManualMove {
    /// n_2: speed at the output while running; its sign is the direction of the move.
    pub speed: AngularVelocity,
    /// t_1: duration of the acceleration from rest.
    pub accelerate: Time,
    /// t_2: duration at constant speed.
    pub run: Time,
    /// t_3: duration of the braking to rest.
    pub brake: Time,
    /// t_p: pause at rest after the move.
    pub pause: Time,
}

/// What a segment is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The magnitude of the speed grows.
    Accelerate,
    /// The speed is constant and not zero.
    Run,
    /// The magnitude of the speed falls.
    Brake,
    /// Rest.
    Pause,
}

/// A linear ramp of the output speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// What it is for.
    pub phase: Phase,
    /// Index of the move it belongs to.
    pub of_move: usize,
    /// Instant at which it begins, counted from the start of the cycle.
    pub start: Time,
    /// Duration, greater than zero.
    pub duration: Time,
    /// Speed at its beginning.
    pub speed_start: AngularVelocity,
    /// Speed at its end.
    pub speed_end: AngularVelocity,
    /// Direction of the move: +1 or -1; 0 at rest.
    pub direction: f64,
}

impl Segment {
    /// α = (ω_end − ω_start) / t, constant over the ramp.
    #[must_use]
    pub fn acceleration(&self) -> AngularAcceleration {
        quantities::acceleration_of(self.speed_end - self.speed_start, self.duration)
    }
}

/// A cycle that repeats: at least one move, with a positive duration.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    moves: Vec<ManualMove>,
}

/// Why a list of moves is no cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CycleFault {
    /// There is no move at all.
    NoMove,
    /// A time is negative or not finite.
    TimeOutOfRange {
        /// Index of the move.
        of_move: usize,
    },
    /// A move with a speed must accelerate and brake in a time greater than zero.
    NoTimeToChangeSpeed {
        /// Index of the move.
        of_move: usize,
    },
    /// All times of the cycle are zero.
    NoDuration,
    /// A speed is not finite.
    SpeedOutOfRange {
        /// Index of the move.
        of_move: usize,
    },
}

impl Cycle {
    /// A cycle from its moves.
    ///
    /// # Errors
    /// The first [`CycleFault`] of each move, all moves looked at.
    pub fn new(moves: Vec<ManualMove>) -> Result<Self, Vec<CycleFault>> {
        let mut faults: Vec<CycleFault> =
            moves.iter().enumerate().filter_map(|(of_move, each)| fault_of(of_move, each)).collect();
        if moves.is_empty() {
            faults.push(CycleFault::NoMove);
        } else if faults.is_empty() && total(&moves).si() <= 0.0 {
            faults.push(CycleFault::NoDuration);
        }
        if faults.is_empty() { Ok(Self { moves }) } else { Err(faults) }
    }

    /// The moves, in order; never empty.
    #[must_use]
    pub fn moves(&self) -> &[ManualMove] {
        &self.moves
    }

    /// t_0 = Σ (t_1 + t_2 + t_3 + t_p): duration of the whole cycle.
    #[must_use]
    pub fn duration(&self) -> Time {
        total(&self.moves)
    }

    /// Σ (t_1 + t_2 + t_3): time in motion.
    #[must_use]
    pub fn moving_time(&self) -> Time {
        self.moves.iter().fold(Time::from_si(0.0), |sum, each| sum + each.accelerate + each.run + each.brake)
    }

    /// The ramps of the cycle, in order, without those of zero duration.
    pub fn segments(&self) -> impl Iterator<Item = Segment> + '_ {
        let rest = AngularVelocity::from_si(0.0);
        let mut clock = Time::from_si(0.0);
        self.moves.iter().enumerate().flat_map(move |(of_move, each)| {
            let direction = if each.speed.si() == 0.0 { 0.0 } else { each.speed.si().signum() };
            let parts = [
                (Phase::Accelerate, each.accelerate, rest, each.speed),
                (Phase::Run, each.run, each.speed, each.speed),
                (Phase::Brake, each.brake, each.speed, rest),
                (Phase::Pause, each.pause, rest, rest),
            ]
            .map(|(phase, duration, speed_start, speed_end)| {
                let start = clock;
                clock += duration;
                let still = direction == 0.0 || phase == Phase::Pause;
                Segment {
                    phase: if still { Phase::Pause } else { phase },
                    of_move,
                    start,
                    duration,
                    speed_start,
                    speed_end,
                    direction: if still { 0.0 } else { direction },
                }
            });
            parts.into_iter().filter(|segment| segment.duration.si() > 0.0)
        })
    }
}

fn total(moves: &[ManualMove]) -> Time {
    moves.iter().fold(Time::from_si(0.0), |sum, each| sum + each.accelerate + each.run + each.brake + each.pause)
}

fn fault_of(of_move: usize, each: &ManualMove) -> Option<CycleFault> {
    let times = [each.accelerate, each.run, each.brake, each.pause].map(Measure::si);
    if times.iter().any(|t| !t.is_finite() || *t < 0.0) {
        return Some(CycleFault::TimeOutOfRange { of_move });
    }
    if !each.speed.si().is_finite() {
        return Some(CycleFault::SpeedOutOfRange { of_move });
    }
    let [accelerate, _, brake, _] = times;
    let moves = each.speed.si() != 0.0;
    (moves && (accelerate <= 0.0 || brake <= 0.0)).then_some(CycleFault::NoTimeToChangeSpeed { of_move })
}

#[cfg(test)]
#[path = "cycle_tests.rs"]
mod tests;
