//! Recordings on the time axis of a cycle, interval by interval.

use crate::law::without_rounding;
use crate::recorded::Recorded;
use std::sync::Arc;

/// A recording on the time axis of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// Recorded motion.
    pub recorded: Arc<Recorded>,
    /// Instant of the first sample, from the start of the cycle \[s\].
    pub start_s: f64,
    /// Offset added to the recorded positions \[rad\].
    pub offset_rad: f64,
    /// Factor of the recorded times \[1\]; speeds are divided by it.
    pub stretch: f64,
    /// Index of the segment.
    pub segment: usize,
}

/// The interval between two samples: speed and torque linear, acceleration constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Instant of the first sample, from the start of the cycle \[s\].
    pub start_s: f64,
    /// Duration \[s\].
    pub duration_s: f64,
    /// Positions at both ends \[rad\].
    pub position_rad: [f64; 2],
    /// Speeds at both ends [rad/s].
    pub speed_rad_s: [f64; 2],
    /// Recorded torques at both ends \[Nm\]; zero if none is recorded.
    pub torque_nm: [f64; 2],
}

impl Interval {
    /// Returns the acceleration α [rad/s²].
    #[must_use]
    pub fn acceleration_rad_s2(&self) -> f64 {
        let [first, last] = self.speed_rad_s;
        (last - first) / self.duration_s
    }

    /// Returns position, speed and torque at a share u of the interval.
    ///
    /// q = q_0 + u (q_1 − q_0) − α h² u (1 − u)/2: the recorded positions at the ends, with the curvature of the speed
    /// in between
    #[must_use]
    pub fn at(&self, u: f64) -> (f64, f64, f64) {
        let straight = |[a, b]: [f64; 2]| a + u * (b - a);
        let bow = 0.5 * (self.speed_rad_s[1] - self.speed_rad_s[0]) * self.duration_s * u * (1.0 - u);
        (straight(self.position_rad) - bow, straight(self.speed_rad_s), straight(self.torque_nm))
    }
}

impl Placed {
    /// Returns the number of intervals between samples.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.recorded.len().saturating_sub(1)
    }

    /// Returns the interval that begins with a sample; `None` at the last one.
    #[must_use]
    pub fn interval(&self, index: usize) -> Option<Interval> {
        let pair = |values: &[f64]| values.get(index).copied().zip(values.get(index + 1).copied());
        let recorded = &*self.recorded;
        let (from, to) = pair(recorded.time_s())?;
        let (q0, q1) = pair(recorded.position_rad())?;
        let (w0, w1) = pair(recorded.speed_rad_s())?;
        let (m0, m1) = recorded.torque_nm().and_then(pair).unwrap_or((0.0, 0.0));
        Some(Interval {
            start_s: self.start_s + from * self.stretch,
            duration_s: (to - from) * self.stretch,
            position_rad: [q0 + self.offset_rad, q1 + self.offset_rad],
            speed_rad_s: [w0 / self.stretch, w1 / self.stretch],
            torque_nm: [m0, m1],
        })
    }

    /// Returns the distance from the first to the last sample, the largest |ω| and the largest |α| [rad, rad/s,
    /// rad/s²].
    #[must_use]
    pub fn course(&self) -> [f64; 3] {
        let (first, last) = self.recorded.ends_rad();
        let farthest = self.recorded.position_rad().iter().fold(0.0, |most: f64, q| most.max(q.abs()));
        let intervals = (0..self.intervals()).filter_map(|index| self.interval(index));
        intervals.fold(
            [without_rounding(last - first, farthest), 0.0, 0.0],
            |[distance, speed, acceleration], interval| {
                let fastest = interval.speed_rad_s.into_iter().fold(speed, |most, w| most.max(w.abs()));
                [distance, fastest, acceleration.max(interval.acceleration_rad_s2().abs())]
            },
        )
    }

    /// Returns the duration on the time axis \[s\].
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.recorded.duration_s() * self.stretch
    }
}
