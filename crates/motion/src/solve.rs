//! Solution of a move: pieces from a sufficient set of distance, time, speed and acceleration.

use crate::faults::{MoveFault, Needed};
use crate::law::{Given, Law};
use crate::piece::Piece;
use crate::seven_phase::{self, Limits};
use quantities::{AngularAcceleration, AngularVelocity, Measure};

impl Law {
    /// Returns the pieces of a move with an initial speed [rad/s].
    ///
    /// # Errors
    /// Returns a [`MoveFault`] if the stated quantities determine no move.
    pub fn pieces(self, given: &Given, first: f64) -> Result<Vec<Piece>, MoveFault> {
        let last = given.end_speed.map_or(0.0, Measure::si);
        let move_of = Wanted {
            distance: given.distance.map(Measure::si),
            time: given.time.map(Measure::si),
            speed: given.speed.map(Measure::si),
            acceleration: given.acceleration.map(Measure::si),
        };
        move_of.in_range()?;
        let boundary = first != 0.0 || last != 0.0;
        match self {
            Self::Constant => constant(&move_of, first, given.end_speed.map(Measure::si)),
            Self::Jerk => {
                let jerk = given.jerk.map(Measure::si).filter(|jerk| jerk.is_finite() && *jerk > 0.0);
                match (move_of.distance, move_of.speed, move_of.acceleration, jerk, move_of.time) {
                    (Some(distance), Some(speed), Some(acceleration), Some(jerk), None) => {
                        within(distance, first, last, Limits { speed: speed.abs(), acceleration, jerk })
                    }
                    _ => Err(move_of.undetermined(Needed::DistanceAndLimits, usize::from(given.jerk.is_some()))),
                }
            }
            Self::Trapezoid if boundary => {
                match (move_of.distance, move_of.speed, move_of.acceleration, move_of.time) {
                    (Some(distance), Some(speed), Some(acceleration), None) => {
                        within(distance, first, last, Limits { speed: speed.abs(), acceleration, jerk: f64::INFINITY })
                    }
                    _ => Err(move_of.undetermined(Needed::DistanceSpeedAcceleration, 0)),
                }
            }
            Self::Polynomial5 if boundary => match (move_of.distance, move_of.time, move_of.count()) {
                (Some(distance), Some(time), 2) => Ok(vec![Self::quintic(distance, time, first, last)]),
                _ => Err(move_of.undetermined(Needed::DistanceAndTime, 0)),
            },
            _ if boundary => Err(MoveFault::RestToRestOnly),
            Self::Trapezoid if move_of.count() == 3 => trapezoid(&move_of),
            _ => {
                let (distance, time) = move_of.distance_and_time(self)?;
                Ok(self.normalised(distance, time))
            }
        }
    }
}

/// Stated distance, time, speed and acceleration, in SI.
struct Wanted {
    distance: Option<f64>,
    time: Option<f64>,
    speed: Option<f64>,
    acceleration: Option<f64>,
}

impl Wanted {
    fn count(&self) -> usize {
        [self.distance, self.time, self.speed, self.acceleration].iter().flatten().count()
    }

    /// Checks the stated quantities: all finite, distance and speed not zero, time and acceleration positive.
    fn in_range(&self) -> Result<(), MoveFault> {
        let signed = [self.distance, self.speed].into_iter().flatten().all(|v| v.is_finite() && v != 0.0);
        let positive = [self.time, self.acceleration].into_iter().flatten().all(|v| v.is_finite() && v > 0.0);
        if signed && positive { Ok(()) } else { Err(MoveFault::OutOfRange) }
    }

    fn undetermined(&self, needed: Needed, more: usize) -> MoveFault {
        MoveFault::NotDetermined { given: self.count() + more, needed }
    }

    /// Returns the direction, +1 or −1: the sign of the distance, else of the speed, else forward.
    fn direction(&self) -> f64 {
        self.distance.or(self.speed).map_or(1.0, f64::signum)
    }

    /// Returns distance and time from any two quantities, by v = C_v s/T and a = C_a s/T².
    fn distance_and_time(&self, law: Law) -> Result<(f64, f64), MoveFault> {
        let (c_v, c_a) = law.characteristics();
        let sign = self.direction();
        let magnitude = |value: Option<f64>| value.map(f64::abs);
        let (s, t) = match (magnitude(self.distance), self.time, magnitude(self.speed), self.acceleration) {
            (Some(s), Some(t), None, None) => (s, t),
            (Some(s), None, Some(v), None) => (s, c_v * s / v),
            (Some(s), None, None, Some(a)) => (s, (c_a * s / a).sqrt()),
            (None, Some(t), Some(v), None) => (v * t / c_v, t),
            (None, Some(t), None, Some(a)) => (a * t * t / c_a, t),
            (None, None, Some(v), Some(a)) => {
                let t = v / a * c_a / c_v;
                (v * t / c_v, t)
            }
            _ => {
                let needed = if law == Law::Trapezoid { Needed::TwoOrThreeOfFour } else { Needed::TwoOfFour };
                return Err(self.undetermined(needed, 0));
            }
        };
        Ok((sign * s, t))
    }
}

/// Returns the trapezoid from three of the four quantities, from rest to rest.
///
/// With ramps of equal length t_r: s = v (T − t_r), v = a t_r.
fn trapezoid(wanted: &Wanted) -> Result<Vec<Piece>, MoveFault> {
    let sign = wanted.direction();
    let (distance, speed) = (wanted.distance.map(f64::abs), wanted.speed.map(f64::abs));
    let (v, a, time) = match (distance, wanted.time, speed, wanted.acceleration) {
        (Some(s), Some(t), Some(v), None) => {
            if v * t <= s {
                return Err(MoveFault::SpeedTooLow { above: AngularVelocity::from_si(s / t) });
            }
            if v * t > 2.0 * s {
                return Err(MoveFault::SpeedTooHigh { most: AngularVelocity::from_si(2.0 * s / t) });
            }
            (v, v / (t - s / v), t)
        }
        (Some(s), Some(t), None, Some(a)) => {
            let least = 4.0 * s / (t * t);
            // A triangle meets the bound with equality and must not be rejected because of rounding.
            if a < least * (1.0 - 1e-12) {
                return Err(MoveFault::AccelerationTooLow { least: AngularAcceleration::from_si(least) });
            }
            // The smaller root of v² − a T v + a s, without cancellation.
            let root = (a * a * t * t - 4.0 * a * s).max(0.0).sqrt();
            (2.0 * a * s / (a * t + root), a, t)
        }
        (Some(s), None, Some(v), Some(a)) => {
            return within(sign * s, 0.0, 0.0, Limits { speed: v, acceleration: a, jerk: f64::INFINITY });
        }
        (None, Some(t), Some(v), Some(a)) => {
            let least = 2.0 * v / t;
            if a < least * (1.0 - 1e-12) {
                return Err(MoveFault::AccelerationTooLow { least: AngularAcceleration::from_si(least) });
            }
            (v, a, t)
        }
        _ => return Err(wanted.undetermined(Needed::TwoOrThreeOfFour, 0)),
    };
    let ramp = (v / a).min(0.5 * time);
    let a = sign * v / ramp;
    let mut pieces = vec![Piece::ramp(ramp, a), Piece::ramp(time - 2.0 * ramp, 0.0), Piece::ramp(ramp, -a)];
    pieces.retain(|piece| piece.duration_s > 0.0);
    Ok(pieces)
}

/// Returns the shortest move within limits, which must also include the end speeds.
fn within(distance: f64, first: f64, last: f64, limits: Limits) -> Result<Vec<Piece>, MoveFault> {
    if first.abs().max(last.abs()) > limits.speed * (1.0 + 1e-12) {
        return Err(MoveFault::EndSpeedAboveLimit);
    }
    Ok(seven_phase::pieces(distance, first, last, &limits))
}

fn constant(wanted: &Wanted, first: f64, last: Option<f64>) -> Result<Vec<Piece>, MoveFault> {
    let needed = Needed::SpeedAndTimeOrDistance;
    let (Some(speed), None) = (wanted.speed, wanted.acceleration) else {
        return Err(wanted.undetermined(needed, 0));
    };
    let time = match (wanted.time, wanted.distance) {
        (Some(time), None) => time,
        (None, Some(distance)) if distance * speed > 0.0 => distance / speed,
        (None, Some(_)) => return Err(MoveFault::OutOfRange),
        _ => return Err(wanted.undetermined(needed, 0)),
    };
    let same = |other: f64| (other - speed).abs() <= 1e-9 * speed.abs();
    if !same(first) || last.is_some_and(|last| !same(last)) {
        return Err(MoveFault::StillMoving { speed: AngularVelocity::from_si(first) });
    }
    Ok(vec![Piece::ramp(time, 0.0)])
}
