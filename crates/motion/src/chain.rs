//! The chain of segments that makes a cycle.

use crate::faults::{MotionFault, MoveFault};
use crate::law::{Given, Law, Solved};
use crate::piece::Piece;
use crate::points::Points;
use crate::recorded::{Placed, Recorded};
use quantities::{Angle, AngularAcceleration, AngularVelocity, Measure, Time};
use std::sync::Arc;

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

/// What holds the axis at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// The motor carries the load.
    #[default]
    Motor,
    /// The closed brake carries the load; the motor has no current.
    Brake,
    /// Nothing holds: only for a load that stays where it is.
    Free,
}

/// What a segment does.
#[derive(Clone, Debug, PartialEq)]
pub enum SegmentSpec {
    /// A move of the manual's cycle.
    Manual(ManualMove),
    /// A move by a law, from the speed that the segment before ends with.
    Move(Law, Given),
    /// A move through points, from where the axis stands.
    Points(Arc<Points>),
    /// Rest.
    Dwell(Time, Hold),
    /// What was recorded.
    Recorded(Arc<Recorded>),
}

/// What must agree at the end of the cycle and at its beginning. The speed always must.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// Only the speed: an axis that turns endlessly under a load that does not depend on its position.
    Speed,
    /// The position too, up to whole revolutions.
    Revolutions,
    /// The position too.
    Position,
    /// Nothing: a single move.
    SingleMove,
}

/// One segment on the time axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Instant of its beginning.
    pub start: Time,
    /// Duration.
    pub duration: Time,
    /// What holds at rest within it.
    pub hold: Hold,
    /// The move with everything solved; `None` for rest and for recordings.
    pub solved: Option<Solved>,
}

/// A motion over one cycle: a chain of pieces and recordings, continuous in position and speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    pieces: Vec<Piece>,
    recordings: Vec<Placed>,
    duration: Time,
    net: Angle,
    stretches: Vec<Stretch>,
    manual: Option<Vec<ManualMove>>,
}

impl Motion {
    /// Chains segments from a start position; without one from where a first recording or table of points says it stands,
    /// else from zero.
    ///
    /// # Errors
    /// Every [`MotionFault`] of the segments, or those of the closing.
    pub fn new(segments: &[SegmentSpec], start: Option<Angle>, closing: Closing) -> Result<Self, Vec<MotionFault>> {
        let (mut chain, initial_error) = Chain::beginning(segments.first(), start);
        let (first, initial) = (chain.position, chain.speed);
        let mut faults = Vec::new();
        let mut stretches = Vec::with_capacity(segments.len());
        for (index, segment) in segments.iter().enumerate() {
            let (from, at) = (chain.pieces.len(), chain.clock);
            let fault = match segment {
                SegmentSpec::Manual(each) => chain.manual(each, index),
                SegmentSpec::Dwell(time, _) => chain.rest(time.si(), index),
                SegmentSpec::Recorded(recorded) => chain.recorded(recorded, index),
                SegmentSpec::Points(points) => chain.points(points, index),
                SegmentSpec::Move(law, given) => match law.pieces(given, chain.speed) {
                    Ok(mut pieces) => {
                        // The law says where the move ends; rounding must not add up over the segments.
                        pieces.retain(|piece| piece.duration_s > 0.0);
                        if let Some(piece) = pieces.last_mut().filter(|_| *law != Law::Constant) {
                            *piece = piece.ending_with(given.end_speed.map_or(0.0, Measure::si));
                        }
                        pieces.into_iter().for_each(|piece| chain.push(piece, index));
                        Ok(())
                    }
                    Err(fault) => Err(fault),
                },
            };
            if let Err(fault) = fault {
                faults.push(MotionFault { segment: Some(index), fault });
                chain.speed = 0.0;
            }
            let moved = matches!(segment, SegmentSpec::Move(..) | SegmentSpec::Manual(_) | SegmentSpec::Points(_));
            stretches.push(Stretch {
                start: Time::from_si(at),
                duration: Time::from_si(chain.clock - at),
                hold: if let SegmentSpec::Dwell(_, hold) = segment { *hold } else { Hold::Motor },
                solved: moved.then(|| solved(chain.pieces.get(from..).unwrap_or_default())),
            });
        }
        if segments.is_empty() {
            faults.push(MotionFault { segment: None, fault: MoveFault::NoSegment });
        } else if faults.is_empty() {
            faults.extend(closing_fault(&chain, (initial, initial_error), first, closing));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let manual = |segment: &SegmentSpec| if let SegmentSpec::Manual(each) = segment { Some(*each) } else { None };
        let manual = segments.iter().map(manual).collect();
        let (duration, net) = (Time::from_si(chain.clock), Angle::from_si(chain.position - first));
        Ok(Self { pieces: chain.pieces, recordings: chain.recordings, duration, net, stretches, manual })
    }

    /// The same motion run through in another time: every instant times `factor`.
    ///
    /// q'(t) = q(t/f), ω' = ω/f, α' = α/f²
    #[must_use]
    pub fn stretched(&self, factor: f64) -> Self {
        let speed = |speed: AngularVelocity| AngularVelocity::from_si(speed.si() / factor);
        let time = |time: Time| Time::from_si(time.si() * factor);
        Self {
            pieces: self.pieces.iter().map(|piece| piece.stretched(factor)).collect(),
            recordings: self
                .recordings
                .iter()
                .map(|placed| Placed {
                    start_s: placed.start_s * factor,
                    stretch: placed.stretch * factor,
                    ..placed.clone()
                })
                .collect(),
            duration: time(self.duration),
            net: self.net,
            stretches: self
                .stretches
                .iter()
                .map(|stretch| Stretch {
                    start: time(stretch.start),
                    duration: time(stretch.duration),
                    solved: stretch.solved.map(|solved| Solved {
                        time: time(solved.time),
                        speed: speed(solved.speed),
                        acceleration: AngularAcceleration::from_si(solved.acceleration.si() / (factor * factor)),
                        ..solved
                    }),
                    ..*stretch
                })
                .collect(),
            manual: self.manual.as_ref().map(|moves| {
                moves
                    .iter()
                    .map(|each| ManualMove {
                        speed: speed(each.speed),
                        accelerate: time(each.accelerate),
                        run: time(each.run),
                        brake: time(each.brake),
                        pause: time(each.pause),
                    })
                    .collect()
            }),
        }
    }

    /// The same motion in front of a stage that turns `ratio` times as far, at the same instants.
    ///
    /// q' = n q, ω' = n ω, α' = n α
    #[must_use]
    pub fn geared(&self, ratio: f64) -> Self {
        if ratio == 1.0 {
            return self.clone();
        }
        Self {
            pieces: self.pieces.iter().map(|piece| piece.geared(ratio)).collect(),
            recordings: self
                .recordings
                .iter()
                .map(|placed| Placed {
                    recorded: Arc::new(placed.recorded.geared(ratio)),
                    offset_rad: placed.offset_rad * ratio,
                    ..placed.clone()
                })
                .collect(),
            net: Angle::from_si(self.net.si() * ratio),
            stretches: self
                .stretches
                .iter()
                .map(|stretch| Stretch {
                    solved: stretch.solved.map(|solved| Solved {
                        distance: Angle::from_si(solved.distance.si() * ratio),
                        speed: AngularVelocity::from_si(solved.speed.si() * ratio),
                        acceleration: AngularAcceleration::from_si(solved.acceleration.si() * ratio),
                        ..solved
                    }),
                    ..*stretch
                })
                .collect(),
            manual: self.manual.as_ref().map(|moves| {
                let geared = |each: &ManualMove| ManualMove {
                    speed: AngularVelocity::from_si(each.speed.si() * ratio),
                    ..*each
                };
                moves.iter().map(geared).collect()
            }),
            ..self.clone()
        }
    }

    /// The pieces of the laws, in order, each of positive duration.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The recordings, in order.
    #[must_use]
    pub fn recordings(&self) -> &[Placed] {
        &self.recordings
    }

    /// The segments on the time axis.
    #[must_use]
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// The manual's moves, if the cycle consists of nothing else.
    #[must_use]
    pub fn manual(&self) -> Option<&[ManualMove]> {
        self.manual.as_deref()
    }

    /// t_0: duration of the whole cycle.
    #[must_use]
    pub const fn duration(&self) -> Time {
        self.duration
    }

    /// Position at the end minus position at the beginning.
    #[must_use]
    pub const fn net(&self) -> Angle {
        self.net
    }
}

/// So much of the largest recorded speed or of the recorded travel may a recording miss where it joins or closes:
/// a recording never contains an exact zero.
const JOINT: f64 = 1e-3;

/// Where the speed is a slope of positions its error at that end is allowed for too, but never more than this share of
/// the largest speed: samples so far apart tell nothing of the end.
const JOINT_MOST: f64 = 0.1;

/// By how much a recorded speed may miss the one it joins, the error of its slope being known.
fn joint(fastest: f64, slope_error: f64) -> f64 {
    (JOINT * fastest + slope_error).min(JOINT_MOST * fastest)
}

/// So much of the largest speed two speeds may differ that are the same but for rounding.
const SAME_SPEED: f64 = 1e-9;

/// From the lowest to the highest of some positions.
fn way(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), q| (a.min(*q), b.max(*q)));
    high - low
}

struct Chain {
    position: f64,
    speed: f64,
    /// What the speed may be wrong by, where it is a slope of recorded positions.
    speed_error: f64,
    clock: f64,
    pieces: Vec<Piece>,
    recordings: Vec<Placed>,
}

impl Chain {
    /// Before the first segment, and what its speed there may be wrong by: the speed is that of a constant run, of a
    /// recording or of points, else rest.
    fn beginning(first: Option<&SegmentSpec>, start: Option<Angle>) -> (Self, f64) {
        let (position, speed, error) = match first {
            Some(SegmentSpec::Move(Law::Constant, given)) => (0.0, given.speed.map_or(0.0, Measure::si), 0.0),
            Some(SegmentSpec::Points(points)) => (points.first().si(), points.first_speed().si(), 0.0),
            Some(SegmentSpec::Recorded(recorded)) => {
                let position = if recorded.is_placed() { recorded.ends_rad().0 } else { 0.0 };
                (position, recorded.end_speeds_rad_s().0, recorded.end_errors_rad_s().0)
            }
            _ => (0.0, 0.0, 0.0),
        };
        let position = start.map_or(position, Measure::si);
        let (pieces, recordings) = (Vec::new(), Vec::new());
        (Self { position, speed, speed_error: 0.0, clock: 0.0, pieces, recordings }, error)
    }

    /// A recording with positions stands where they say, shifted only if the motion begins with it at a stated angle;
    /// one without goes on from where the axis is.
    fn recorded(&mut self, recorded: &Arc<Recorded>, segment: usize) -> Result<(), MoveFault> {
        let (first, last) = recorded.ends_rad();
        let (speed, end_speed) = recorded.end_speeds_rad_s();
        let most = recorded.speed_rad_s().iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let (first_error, last_error) = recorded.end_errors_rad_s();
        if (speed - self.speed).abs() > joint(most, first_error + self.speed_error) {
            return Err(MoveFault::RecordingSpeedJumps {
                first: AngularVelocity::from_si(speed),
                before: AngularVelocity::from_si(self.speed),
            });
        }
        let gap = self.position - first;
        let shifted = self.clock == 0.0 || !recorded.is_placed();
        if !shifted && gap.abs() > JOINT * way(recorded.position_rad()) {
            return Err(MoveFault::RecordingPositionJumps { gap: Angle::from_si(-gap) });
        }
        let offset_rad = if shifted { gap } else { 0.0 };
        self.recordings.push(Placed {
            recorded: Arc::clone(recorded),
            start_s: self.clock,
            offset_rad,
            stretch: 1.0,
            segment,
        });
        // What ends as near to rest as its samples can tell is at rest: a dwell or a law may follow.
        let rests = end_speed.abs() <= joint(most, last_error);
        (self.position, self.speed) = (last + offset_rad, if rests { 0.0 } else { end_speed });
        self.speed_error = last_error;
        self.clock += recorded.duration_s();
        Ok(())
    }

    /// The points say how far it goes; their positions are met without the rounding of the pieces before.
    fn points(&mut self, points: &Points, segment: usize) -> Result<(), MoveFault> {
        let (from, first) = (self.position, points.first_speed());
        let fastest = points.pieces().fold(first.si().abs(), |most, (_, (_, speed))| most.max(speed.abs()));
        if (first.si() - self.speed).abs() > SAME_SPEED * fastest {
            return Err(MoveFault::PointsSpeedJumps { first, before: AngularVelocity::from_si(self.speed) });
        }
        for (piece, (travelled, _)) in points.pieces() {
            self.push(piece, segment);
            self.position = from + travelled;
        }
        Ok(())
    }

    fn push(&mut self, piece: Piece, segment: usize) {
        if piece.duration_s <= 0.0 {
            return;
        }
        let piece =
            Piece { start_s: self.clock, position_rad: self.position, speed_rad_s: self.speed, segment, ..piece };
        let end = piece.end();
        self.position = end.position_rad;
        (self.speed, self.speed_error) = (end.speed_rad_s, 0.0);
        self.clock += piece.duration_s;
        self.pieces.push(piece);
    }

    fn at_rest(&self) -> Result<(), MoveFault> {
        if self.speed == 0.0 {
            Ok(())
        } else {
            Err(MoveFault::StillMoving { speed: AngularVelocity::from_si(self.speed) })
        }
    }

    fn rest(&mut self, time: f64, segment: usize) -> Result<(), MoveFault> {
        self.at_rest()?;
        if !time.is_finite() || time < 0.0 {
            return Err(MoveFault::OutOfRange);
        }
        self.push(Piece::ramp(time, 0.0), segment);
        Ok(())
    }

    fn manual(&mut self, each: &ManualMove, segment: usize) -> Result<(), MoveFault> {
        self.at_rest()?;
        let times = [each.accelerate, each.run, each.brake, each.pause].map(Measure::si);
        let speed = each.speed.si();
        if !speed.is_finite() || times.iter().any(|t| !t.is_finite() || *t < 0.0) {
            return Err(MoveFault::OutOfRange);
        }
        let [t1, t2, t3, tp] = times;
        if speed == 0.0 {
            self.push(Piece::ramp(t1 + t2 + t3 + tp, 0.0), segment);
            return Ok(());
        }
        if t1 <= 0.0 || t3 <= 0.0 {
            return Err(MoveFault::NoTimeToChangeSpeed { braking: t1 > 0.0 });
        }
        self.push(Piece::ramp(t1, speed / t1).ending_with(speed), segment);
        self.push(Piece::ramp(t2, 0.0), segment);
        self.push(Piece::ramp(t3, -speed / t3).ending_with(0.0), segment);
        self.push(Piece::ramp(tp, 0.0), segment);
        Ok(())
    }
}

/// `initial`: the speed at the beginning, and what it may be wrong by.
fn closing_fault(
    chain: &Chain,
    (initial, first_error): (f64, f64),
    start: f64,
    closing: Closing,
) -> Option<MotionFault> {
    let whole = |fault| Some(MotionFault { segment: None, fault });
    if chain.clock <= 0.0 {
        return whole(MoveFault::NoDuration);
    }
    if closing == Closing::SingleMove {
        return None;
    }
    let recorded = chain.recordings.iter().flat_map(|placed| placed.recorded.speed_rad_s());
    let fastest =
        chain.pieces.iter().map(|piece| &piece.speed_rad_s).chain(recorded).fold(0.0, |most: f64, w| most.max(w.abs()));
    let recorded = !chain.recordings.is_empty();
    let permitted = if recorded { joint(fastest, chain.speed_error + first_error) } else { SAME_SPEED * fastest };
    if (chain.speed - initial).abs() > permitted {
        return whole(MoveFault::SpeedNotClosed {
            end: AngularVelocity::from_si(chain.speed),
            start: AngularVelocity::from_si(initial),
        });
    }
    let travelled: f64 =
        chain.pieces.iter().map(|piece| (piece.end().position_rad - piece.position_rad).abs()).sum::<f64>()
            + chain.recordings.iter().map(|placed| way(placed.recorded.position_rad())).sum::<f64>();
    let gap = match closing {
        Closing::Position => chain.position - start,
        Closing::Revolutions => {
            let turns = (chain.position - start) / std::f64::consts::TAU;
            (turns - turns.round()) * std::f64::consts::TAU
        }
        Closing::Speed | Closing::SingleMove => 0.0,
    };
    if gap.abs() > if recorded { JOINT } else { 1e-6 } * travelled {
        return whole(MoveFault::PositionNotClosed { gap: Angle::from_si(gap) });
    }
    None
}

/// What a move came out as.
fn solved(pieces: &[Piece]) -> Solved {
    let (mut speed, mut acceleration, mut time) = (0.0_f64, 0.0_f64, 0.0);
    for piece in pieces {
        time += piece.duration_s;
        // The extremes lie at the ends or where the acceleration or its slope vanishes.
        let mut instants = vec![0.0, piece.duration_s];
        if piece.speed_degree().is_none_or(|degree| degree > 1) {
            instants.extend(piece.acceleration_roots());
            instants.extend(piece.jerk_roots());
        }
        for state in instants.into_iter().map(|t| piece.at(t)) {
            speed = speed.max(state.speed_rad_s.abs());
            acceleration = acceleration.max(state.acceleration_rad_s2.abs());
        }
    }
    let travelled = pieces.first().zip(pieces.last()).map_or(0.0, |(a, b)| b.end().position_rad - a.position_rad);
    Solved {
        distance: Angle::from_si(travelled),
        time: Time::from_si(time),
        speed: AngularVelocity::from_si(speed),
        acceleration: AngularAcceleration::from_si(acceleration),
    }
}

#[cfg(test)]
#[path = "chain_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "closing_tests.rs"]
mod closing_tests;
