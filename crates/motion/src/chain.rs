//! Chain of the segments of a cycle.

use crate::faults::{MotionFault, MoveFault};
use crate::joint::{JOINT, joint};
use crate::law::{Given, Law, Solved};
use crate::piece::Piece;
use crate::placed::Placed;
use crate::points::Points;
use crate::recorded::Recorded;
use quantities::{Angle, AngularAcceleration, AngularVelocity, Measure, Time};
use std::sync::Arc;

/// A move of the manual's cycle (section 7.1): from rest to `speed`, and back to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ManualMove {
    /// n_2: output speed in the constant phase; its sign is the direction of the move.
    pub speed: AngularVelocity,
    /// t_1: acceleration time from rest.
    pub accelerate: Time,
    /// t_2: time at constant speed.
    pub run: Time,
    /// t_3: braking time to rest.
    pub brake: Time,
    /// t_p: pause at rest after the move.
    pub pause: Time,
}

/// Means of holding the axis at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// The motor holds the load.
    #[default]
    Motor,
    /// The closed brake holds the load; the motor has no current.
    Brake,
    /// No holding: only for a load that stays in place by itself.
    Free,
}

/// Content of a segment.
#[derive(Clone, Debug, PartialEq)]
pub enum SegmentSpec {
    /// A move of the manual's cycle.
    Manual(ManualMove),
    /// A move by a law, starting at the end speed of the previous segment.
    Move(Law, Given),
    /// A move through points, starting at the present position.
    Points(Arc<Points>),
    /// A dwell at rest.
    Dwell(Time, Hold),
    /// A recorded motion.
    Recorded(Arc<Recorded>),
}

impl SegmentSpec {
    /// Returns the speed with which the segment ends, and its error, if it follows from the segment alone [rad/s].
    fn end_speed(&self) -> Option<(f64, f64)> {
        match self {
            Self::Manual(_) | Self::Dwell(..) => Some((0.0, 0.0)),
            Self::Move(Law::Constant, given) => given.speed.map(|speed| (speed.si(), 0.0)),
            Self::Move(_, given) => Some((given.end_speed.map_or(0.0, Measure::si), 0.0)),
            Self::Points(points) => points.pieces().last().map(|(_, (_, speed))| (speed, 0.0)),
            Self::Recorded(recorded) => Some(end_of(recorded)),
        }
    }
}

/// End of a segment that cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unread {
    /// The segment ends at rest, whatever its quantities are.
    EndsAtRest,
    /// The segment may end with a speed.
    EndsMoving,
}

/// Condition on the position at the end of the cycle; the speed must always equal the initial speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Closing {
    /// No condition: an endlessly turning axis under a load independent of its position.
    Speed,
    /// Equal to the initial position up to whole revolutions.
    Revolutions,
    /// Equal to the initial position.
    Position,
    /// Neither position nor speed must agree: a single move.
    SingleMove,
}

/// A segment on the time axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Start of the segment.
    pub start: Time,
    /// Duration of the segment.
    pub duration: Time,
    /// Means of holding the axis when it is at rest.
    pub hold: Hold,
    /// Move with all its quantities; `None` for dwells and recordings.
    pub solved: Option<Solved>,
    /// Distance of the plain change of speed, if that of the move is shorter ([`Law::overrun`]).
    pub overrun: Option<Angle>,
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
    /// Chains segments, beginning at `start`; if it is `None`, at the first position of a recording or a table of
    /// points in the first segment, else at zero.
    ///
    /// # Errors
    /// Returns the [`MotionFault`]s of all segments, or that of the closing.
    pub fn new(segments: &[SegmentSpec], start: Option<Angle>, closing: Closing) -> Result<Self, Vec<MotionFault>> {
        let (mut chain, initial_error) = Chain::beginning(segments.first(), start);
        let (first, initial) = (chain.position, chain.speed);
        let mut faults = Vec::new();
        let mut stretches = Vec::with_capacity(segments.len());
        for (index, segment) in segments.iter().enumerate() {
            let (from, at) = (chain.pieces.len(), chain.clock);
            let overrun = match segment {
                SegmentSpec::Move(law, given) => law.overrun(given, chain.speed),
                _ => None,
            };
            if let Err(fault) = chain.add(segment, index) {
                faults.push(MotionFault { segment: Some(index), fault });
                chain.pass(segment.end_speed(), segments.get(index + 1));
            }
            let moved = matches!(segment, SegmentSpec::Move(..) | SegmentSpec::Manual(_) | SegmentSpec::Points(_));
            stretches.push(Stretch {
                start: Time::from_si(at),
                duration: Time::from_si(chain.clock - at),
                hold: if let SegmentSpec::Dwell(_, hold) = segment { *hold } else { Hold::Motor },
                solved: moved.then(|| Solved::of(chain.pieces.get(from..).unwrap_or_default())),
                overrun,
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

    /// Returns the faults of segments some of which cannot be read: [`Unread`]. Faults of the closing are not among them.
    #[must_use]
    pub fn faults(segments: &[Result<SegmentSpec, Unread>], start: Option<Angle>) -> Vec<MotionFault> {
        let first = segments.first().and_then(|first| first.as_ref().ok());
        let (mut chain, _) = Chain::beginning(first, start);
        let mut faults = Vec::new();
        for (index, segment) in segments.iter().enumerate() {
            let next = segments.get(index + 1).and_then(|next| next.as_ref().ok());
            match segment {
                Ok(segment) => {
                    if let Err(fault) = chain.add(segment, index) {
                        faults.push(MotionFault { segment: Some(index), fault });
                        chain.pass(segment.end_speed(), next);
                    }
                }
                Err(Unread::EndsAtRest) => chain.pass(Some((0.0, 0.0)), next),
                Err(Unread::EndsMoving) => chain.pass(None, next),
            }
        }
        if segments.is_empty() {
            faults.push(MotionFault { segment: None, fault: MoveFault::NoSegment });
        } else if faults.is_empty() && chain.clock <= 0.0 && segments.iter().all(Result::is_ok) {
            faults.push(MotionFault { segment: None, fault: MoveFault::NoDuration });
        }
        faults
    }

    /// Returns the motion with all times multiplied by `factor`.
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

    /// Returns the motion at the input of a stage that turns `ratio` times as far, at the same instants.
    ///
    /// q' = n q, ω' = n ω, α' = n α
    #[must_use]
    pub fn geared(&self, ratio: f64) -> Self {
        if ratio == 1.0 {
            return self.clone();
        }
        // A recording that is placed several times remains one.
        let mut recordings: Vec<Placed> = Vec::with_capacity(self.recordings.len());
        for placed in &self.recordings {
            let mut others = self.recordings.iter().zip(&recordings);
            let known = others.find(|(other, _)| Arc::ptr_eq(&other.recorded, &placed.recorded));
            let recorded = match known {
                Some((_, geared)) => Arc::clone(&geared.recorded),
                None => Arc::new(placed.recorded.geared(ratio)),
            };
            recordings.push(Placed { recorded, offset_rad: placed.offset_rad * ratio, ..placed.clone() });
        }
        Self {
            pieces: self.pieces.iter().map(|piece| piece.geared(ratio)).collect(),
            recordings,
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
                    overrun: stretch.overrun.map(|plain| Angle::from_si(plain.si() * ratio)),
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

    /// Returns the pieces of the laws in order, each of positive duration.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Returns the recordings in order.
    #[must_use]
    pub fn recordings(&self) -> &[Placed] {
        &self.recordings
    }

    /// Returns the segments on the time axis.
    #[must_use]
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// Returns the manual's moves, if the cycle consists of nothing else.
    #[must_use]
    pub fn manual(&self) -> Option<&[ManualMove]> {
        self.manual.as_deref()
    }

    /// Returns t_0, the duration of the cycle.
    #[must_use]
    pub const fn duration(&self) -> Time {
        self.duration
    }

    /// Returns the final position minus the initial position.
    #[must_use]
    pub const fn net(&self) -> Angle {
        self.net
    }

    /// Returns `true` if the final position is the initial one: within a millionth of the angle travelled, in a cycle with
    /// recordings within a thousandth of the range of positions. The samples of a recording carry noise, and smoothing
    /// shifts its ends; without this tolerance such an axis would count as one that always turns in one direction.
    #[must_use]
    pub fn ends_where_it_starts(&self, travelled: Angle, range: Angle) -> bool {
        let permitted = if self.recordings.is_empty() { 1e-6 * travelled.si() } else { JOINT * range.si() };
        self.net.si().abs() <= permitted
    }
}

/// Tolerance for equal speeds, relative to the largest speed: rounding only.
const SAME_SPEED: f64 = 1e-9;

/// Returns the difference of the highest and the lowest position.
fn way(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), q| (a.min(*q), b.max(*q)));
    high - low
}

/// Returns the largest recorded speed [rad/s].
fn fastest(recorded: &Recorded) -> f64 {
    recorded.speed_rad_s().iter().fold(0.0_f64, |most, value| most.max(value.abs()))
}

/// Returns the speed with which a recording ends, and its error [rad/s]. One that ends at rest within the tolerance of
/// its samples is at rest: a dwell or a law may follow.
fn end_of(recorded: &Recorded) -> (f64, f64) {
    let ((_, speed), (_, error)) = (recorded.end_speeds_rad_s(), recorded.end_errors_rad_s());
    (if speed.abs() <= joint(fastest(recorded), error) { 0.0 } else { speed }, error)
}

struct Chain {
    position: f64,
    /// The position is known: no segment before it is faulty.
    is_placed: bool,
    speed: f64,
    /// Error of the speed, if it is a slope of recorded positions [rad/s].
    speed_error: f64,
    clock: f64,
    pieces: Vec<Piece>,
    recordings: Vec<Placed>,
}

impl Chain {
    /// Creates the chain before the first segment, with the error of its initial speed [rad/s]: the speed is that of a
    /// constant run, of a recording or of points, else zero.
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
        (Self { position, is_placed: true, speed, speed_error: 0.0, clock: 0.0, pieces, recordings }, error)
    }

    /// Adds a segment.
    fn add(&mut self, segment: &SegmentSpec, index: usize) -> Result<(), MoveFault> {
        match segment {
            SegmentSpec::Manual(each) => self.manual(each, index),
            SegmentSpec::Dwell(time, _) => self.rest(time.si(), index),
            SegmentSpec::Recorded(recorded) => self.recorded(recorded, index),
            SegmentSpec::Points(points) => self.points(points, index),
            SegmentSpec::Move(law, given) => {
                let mut pieces = law.pieces(given, self.speed)?;
                // Set to the end speed of the law, so that rounding errors do not accumulate over the segments.
                pieces.retain(|piece| piece.duration_s > 0.0);
                if let Some(piece) = pieces.last_mut().filter(|_| *law != Law::Constant) {
                    *piece = piece.ending_with(given.end_speed.map_or(0.0, Measure::si));
                }
                pieces.into_iter().for_each(|piece| self.push(piece, index));
                Ok(())
            }
        }
    }

    /// Goes on behind a faulty segment: with its end speed, or, if none follows from it, as the next segment begins.
    /// Neither the speed of the next segment nor the position of a recording behind it is judged by the faulty one.
    fn pass(&mut self, end_speed: Option<(f64, f64)>, next: Option<&SegmentSpec>) {
        self.is_placed = false;
        (self.speed, self.speed_error) = end_speed.unwrap_or_else(|| {
            let (begun, error) = Self::beginning(next, None);
            (begun.speed, error)
        });
    }

    /// Adds a recording. One with positions keeps them, unless the motion begins with it at a stated angle; one without
    /// starts at the present position.
    fn recorded(&mut self, recorded: &Arc<Recorded>, segment: usize) -> Result<(), MoveFault> {
        let (first, last) = recorded.ends_rad();
        let (speed, _) = recorded.end_speeds_rad_s();
        let (most, (first_error, _)) = (fastest(recorded), recorded.end_errors_rad_s());
        if (speed - self.speed).abs() > joint(most, first_error + self.speed_error) {
            return Err(MoveFault::RecordingSpeedJumps {
                first: AngularVelocity::from_si(speed),
                before: AngularVelocity::from_si(self.speed),
            });
        }
        if !self.is_placed && recorded.is_placed() {
            (self.position, self.is_placed) = (first, true);
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
        self.position = last + offset_rad;
        (self.speed, self.speed_error) = end_of(recorded);
        self.clock += recorded.duration_s();
        Ok(())
    }

    /// Adds a move through points, whose positions are met without the rounding errors of the preceding pieces.
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

/// Returns the fault of the closing, if there is one; `initial` is the initial speed with its error [rad/s].
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

#[cfg(test)]
#[path = "chain_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "closing_tests.rs"]
mod closing_tests;
