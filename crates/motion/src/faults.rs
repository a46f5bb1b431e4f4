//! Why a description is no motion.

use quantities::{Angle, AngularAcceleration, AngularVelocity};

/// Which quantities determine a move of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    /// Any two of distance, time, speed and acceleration.
    TwoOfFour,
    /// Any two or three of distance, time, speed and acceleration.
    TwoOrThreeOfFour,
    /// Distance, speed, acceleration and jerk.
    DistanceAndLimits,
    /// Distance and time, because the move does not begin and end at rest.
    DistanceAndTime,
    /// Distance, speed and acceleration, because the move does not begin and end at rest.
    DistanceSpeedAcceleration,
    /// Speed and one of time and distance.
    SpeedAndTimeOrDistance,
}

/// What is wrong with one move.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MoveFault {
    /// There is no segment at all.
    NoSegment,
    /// All times of the cycle are zero.
    NoDuration,
    /// A speed cannot be reached (or left, with `braking`) in no time.
    NoTimeToChangeSpeed {
        /// Whether it is the braking time that is zero.
        braking: bool,
    },
    /// Too few or too many quantities are given.
    NotDetermined {
        /// How many are given.
        given: usize,
        /// Which would determine the move.
        needed: Needed,
    },
    /// A quantity that the law divides by is zero or not finite.
    OutOfRange,
    /// The speed is too low to cover the distance in the time.
    SpeedTooLow {
        /// What it must exceed.
        above: AngularVelocity,
    },
    /// The speed is too high: even without running at it the move takes less than the time.
    SpeedTooHigh {
        /// What it must not exceed.
        most: AngularVelocity,
    },
    /// The acceleration is too low for distance, time or speed.
    AccelerationTooLow {
        /// What it must at least be.
        least: AngularAcceleration,
    },
    /// The law moves from rest to rest only.
    RestToRestOnly,
    /// A speed at an end of the move is above the speed that limits it.
    EndSpeedAboveLimit,
    /// A dwell, or a law from rest, begins while the axis still moves.
    StillMoving {
        /// Speed at that instant.
        speed: AngularVelocity,
    },
    /// The cycle ends with another speed than it begins with.
    SpeedNotClosed {
        /// Speed at the end.
        end: AngularVelocity,
        /// Speed at the beginning.
        start: AngularVelocity,
    },
    /// The cycle ends at another position than it begins at.
    PositionNotClosed {
        /// End minus start.
        gap: Angle,
    },
}

/// A fault with the segment that has it; the whole motion without one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionFault {
    /// Index of the segment.
    pub segment: Option<usize>,
    /// What is wrong.
    pub fault: MoveFault,
}
