//! Solution of a move: pieces from a sufficient set of distance, time, speed and acceleration.

use crate::faults::{MoveFault, Needed};
use crate::law::{Given, Law};
use crate::piece::Piece;
use crate::seven_phase::{self, Limits, SAME};
use quantities::{Angle, AngularAcceleration, AngularVelocity, Measure};

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
            Self::Jerk => match self.limited(given) {
                Some((distance, limits)) => within(distance, first, last, limits),
                None => Err(move_of.undetermined(Needed::DistanceAndLimits, usize::from(given.jerk.is_some()))),
            },
            Self::Trapezoid if boundary => match self.limited(given) {
                Some((distance, limits)) => within(distance, first, last, limits),
                None => Err(move_of.undetermined(Needed::DistanceSpeedAcceleration, 0)),
            },
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

    /// Returns the distance of the plain change of speed if that of the move, in the direction of its end speeds, is
    /// shorter: the axis passes its end, or its end speed, and comes back with the full acceleration.
    ///
    /// # Valid
    /// trapezoid and seven-phase move with a speed at one end; a difference up to 10⁻⁹ is rounding
    #[must_use]
    pub fn overrun(self, given: &Given, first: f64) -> Option<Angle> {
        let last = given.end_speed.map_or(0.0, Measure::si);
        let (distance, limits) = self.limited(given).filter(|_| first != 0.0 || last != 0.0)?;
        seven_phase::overrun(distance, first, last, &limits).map(Angle::from_si)
    }

    /// Returns distance and limits of a move that is the shortest within limits; `None` for other laws and quantities.
    fn limited(self, given: &Given) -> Option<(f64, Limits)> {
        let jerk = match self {
            Self::Jerk => given.jerk.map(Measure::si).filter(|jerk| jerk.is_finite() && *jerk > 0.0)?,
            Self::Trapezoid => f64::INFINITY,
            _ => return None,
        };
        let (speed, acceleration) = (given.speed?.si().abs(), given.acceleration?.si());
        given.time.is_none().then_some((given.distance?.si(), Limits { speed, acceleration, jerk }))
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
            if v * t <= s * (1.0 + SAME) {
                return Err(MoveFault::SpeedTooLow { above: AngularVelocity::from_si(s / t) });
            }
            if v * t > 2.0 * s * (1.0 + SAME) {
                return Err(MoveFault::SpeedTooHigh { most: AngularVelocity::from_si(2.0 * s / t) });
            }
            (v, v / (t - s / v), t)
        }
        (Some(s), Some(t), None, Some(a)) => {
            let least = 4.0 * s / (t * t);
            // A triangle meets the bound with equality and must not be rejected because of rounding.
            if a < least * (1.0 - SAME) {
                return Err(MoveFault::AccelerationTooLow { least: AngularAcceleration::from_si(least) });
            }
            // The smaller root of v² − a T v + a s, without cancellation; rounding of a double root would be a run.
            let root = if a <= least * (1.0 + SAME) { 0.0 } else { (a * a * t * t - 4.0 * a * s).sqrt() };
            (2.0 * a * s / (a * t + root), a, t)
        }
        (Some(s), None, Some(v), Some(a)) => {
            return within(sign * s, 0.0, 0.0, Limits { speed: v, acceleration: a, jerk: f64::INFINITY });
        }
        (None, Some(t), Some(v), Some(a)) => {
            let least = 2.0 * v / t;
            if a < least * (1.0 - SAME) {
                return Err(MoveFault::AccelerationTooLow { least: AngularAcceleration::from_si(least) });
            }
            (v, a, t)
        }
        _ => return Err(wanted.undetermined(Needed::TwoOrThreeOfFour, 0)),
    };
    // A run or a ramp that differs from half of the time by rounding leaves a triangle.
    let half = 0.5 * time;
    let ramp = if v / a >= half * (1.0 - SAME) { half } else { v / a };
    let v = distance.map_or(v, |distance| distance / (time - ramp));
    let a = sign * v / ramp;
    let mut pieces = vec![Piece::ramp(ramp, a), Piece::ramp(time - 2.0 * ramp, 0.0), Piece::ramp(ramp, -a)];
    pieces.retain(|piece| piece.duration_s > 0.0);
    Ok(pieces)
}

/// Returns the shortest move within limits, which must also include the end speeds.
fn within(distance: f64, first: f64, last: f64, limits: Limits) -> Result<Vec<Piece>, MoveFault> {
    if first.abs().max(last.abs()) > limits.speed * (1.0 + SAME) {
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
    let same = |other: f64| (other - speed).abs() <= SAME * speed.abs();
    if !same(first) || last.is_some_and(|last| !same(last)) {
        return Err(MoveFault::StillMoving { speed: AngularVelocity::from_si(first) });
    }
    Ok(vec![Piece::ramp(time, 0.0)])
}
