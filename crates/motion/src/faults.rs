//! Faults in the description of a motion.

use quantities::{Angle, AngularAcceleration, AngularVelocity, Time};

/// Quantities that determine a move of a law.
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

impl Needed {
    /// Returns the largest number of quantities that determine the move; more contradict each other or repeat one.
    #[must_use]
    pub const fn most(self) -> usize {
        match self {
            Self::TwoOfFour | Self::DistanceAndTime | Self::SpeedAndTimeOrDistance => 2,
            Self::TwoOrThreeOfFour | Self::DistanceSpeedAcceleration => 3,
            Self::DistanceAndLimits => 4,
        }
    }
}

/// A fault of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveFault {
    /// The motion has no segment.
    NoSegment,
    /// The cycle has zero duration.
    NoDuration,
    /// A change of speed has no time.
    NoTimeToChangeSpeed {
        /// The braking time is zero; otherwise the acceleration time.
        braking: bool,
    },
    /// Too few or too many quantities are stated.
    NotDetermined {
        /// Number of quantities stated.
        given: usize,
        /// Quantities that would determine the move.
        needed: Needed,
    },
    /// A quantity by which the law divides is zero or not finite.
    OutOfRange,
    /// The speed is too low to cover the distance in the time.
    SpeedTooLow {
        /// Lower limit of the speed, exclusive.
        above: AngularVelocity,
    },
    /// The speed is too high: even without a constant phase the move takes less than the time.
    SpeedTooHigh {
        /// Upper limit of the speed.
        most: AngularVelocity,
    },
    /// The acceleration is too low for distance, time or speed.
    AccelerationTooLow {
        /// Lower limit of the acceleration.
        least: AngularAcceleration,
    },
    /// The law is defined from rest to rest only.
    RestToRestOnly,
    /// A speed at an end of the move exceeds its speed limit.
    EndSpeedAboveLimit,
    /// A dwell, or a law from rest, begins while the axis is moving.
    StillMoving {
        /// Speed at that instant.
        speed: AngularVelocity,
    },
    /// The speed at the first point differs from that of the axis.
    PointsSpeedJumps {
        /// Speed at the first point.
        first: AngularVelocity,
        /// Speed of the axis before the first point.
        before: AngularVelocity,
    },
    /// The speed at the first sample differs from that of the axis.
    RecordingSpeedJumps {
        /// Speed at the first sample.
        first: AngularVelocity,
        /// Speed of the axis before the recording.
        before: AngularVelocity,
    },
    /// The position at the first sample differs from that of the axis.
    RecordingPositionJumps {
        /// Position at the first sample minus that of the axis.
        gap: Angle,
    },
    /// The speed at the end of the cycle differs from that at its beginning.
    SpeedNotClosed {
        /// Speed at the end.
        end: AngularVelocity,
        /// Speed at the beginning.
        start: AngularVelocity,
    },
    /// The position at the end of the cycle differs from that at its beginning.
    PositionNotClosed {
        /// Final minus initial position.
        gap: Angle,
    },
}

/// Fault that prevents samples from being a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RecordedFault {
    /// Fewer than three samples.
    TooFew {
        /// Number of samples.
        samples: usize,
    },
    /// Neither positions nor speeds are recorded.
    NoCourse,
    /// The columns differ in their number of samples.
    Uneven,
    /// A sample is not a finite number.
    NotFinite {
        /// Index of the sample.
        index: usize,
    },
    /// An instant is not later than the one before it.
    NotIncreasing {
        /// Index of the later sample.
        index: usize,
    },
    /// The smoothing window contains too few samples for a parabola at some instant.
    WindowTooShort {
        /// Width of a window that suffices everywhere; `None` if it would be wider than the recording.
        least: Option<Time>,
    },
    /// The smoothing window is wider than the recording is long.
    WindowOverMotion {
        /// Width of the window.
        window: Time,
        /// Duration of the recording.
        duration: Time,
    },
    /// The smoothing window contains too many samples.
    WindowTooLong {
        /// Largest permitted number of samples.
        most: usize,
    },
    /// The rows are not evenly spaced, as `time_stamps` states.
    StampsUneven {
        /// Standard deviation of the time stamps from evenly spaced instants.
        scatter: Time,
        /// Interval of these instants.
        interval: Time,
    },
    /// Recorded positions and speeds contradict each other.
    Contradiction {
        /// Largest difference between recorded and integrated position, relative to the travel.
        share: f64,
        /// Factor of the speed to that of the position, if both differ by it alone \[1\].
        factor: Option<f64>,
    },
}

/// A fault of a segment or of the whole motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionFault {
    /// Index of the segment; `None` for the whole motion.
    pub segment: Option<usize>,
    /// Kind of fault.
    pub fault: MoveFault,
}
