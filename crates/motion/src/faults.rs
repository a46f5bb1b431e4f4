//! Why a description is no motion.

use quantities::{Angle, AngularAcceleration, AngularVelocity, Time};

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
    /// A table of points begins with another speed than the axis has.
    PointsSpeedJumps {
        /// Speed at its first point.
        first: AngularVelocity,
        /// Speed of the axis before it.
        before: AngularVelocity,
    },
    /// A recording begins at another speed than the axis has.
    RecordingSpeedJumps {
        /// Speed at its first sample.
        first: AngularVelocity,
        /// Speed of the axis before it.
        before: AngularVelocity,
    },
    /// A recording begins at another position than where the axis stands.
    RecordingPositionJumps {
        /// Position at its first sample minus that of the axis.
        gap: Angle,
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

/// Why samples are no motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RecordedFault {
    /// Fewer than three samples.
    TooFew {
        /// How many there are.
        samples: usize,
    },
    /// Neither position nor speed.
    NoCourse,
    /// The columns do not have the same number of samples.
    Uneven,
    /// A sample is not a finite number.
    NotFinite {
        /// Its index.
        index: usize,
    },
    /// An instant is not after the one before it.
    NotIncreasing {
        /// Its index.
        index: usize,
    },
    /// Somewhere the smoothing window holds too few samples for a parabola.
    WindowTooShort {
        /// A width that is enough everywhere.
        least: Time,
    },
    /// The smoothing window holds more samples than is sensible.
    WindowTooLong {
        /// The most it may hold.
        most: usize,
    },
    /// Position and speed are both recorded and do not tell of the same motion.
    Contradiction {
        /// Largest distance between the recorded and the integrated position, as a share of the travel.
        share: f64,
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
