//! States of the drive: running, stopping, off; the brake with its delays.

use crate::control::Demand;
use crate::machine::BrakeData;
use crate::scenario::Reaction;

/// State of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Phase {
    /// Follows the setpoints of the motion.
    Running,
    /// Slows down along a ramp, with the present speed setpoint [rad/s].
    Ramp(f64),
    /// Standstill after a ramp, held by the motor until the brake is closed, with the time of its start \[s\].
    Holding(f64),
    /// Pulses off.
    Off,
    /// Pulses off while the brake holds within the cycle.
    Resting,
    /// Follows the setpoints of a caller.
    Commanded(Demand),
}

/// State of the holding brake, which follows its command after a delay.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BrakeState {
    data: Option<BrakeData>,
    /// The brake does not open.
    pub(crate) stuck: bool,
    open_wanted: bool,
    since_s: f64,
    pub(crate) closed: bool,
    /// Number of closings at rest and on a moving axis.
    pub(crate) closings: [u32; 2],
}

impl BrakeState {
    pub(crate) const fn new(data: Option<BrakeData>, closed: bool, stuck: bool) -> Self {
        let closed = data.is_some() && (closed || stuck);
        Self { data, stuck, open_wanted: !closed, since_s: f64::NEG_INFINITY, closed, closings: [0, 0] }
    }

    /// Returns `true` if the axis has a brake.
    pub(crate) const fn exists(&self) -> bool {
        self.data.is_some()
    }

    /// Returns t_o and t_c \[s\].
    pub(crate) fn delays(&self) -> [f64; 2] {
        self.data.map_or([0.0; 2], |data| [data.opening_s, data.closing_s])
    }

    /// Commands the brake; returns `true` if the command is new.
    pub(crate) fn command(&mut self, open: bool, time_s: f64) -> bool {
        if self.data.is_none() || self.open_wanted == open {
            return false;
        }
        (self.open_wanted, self.since_s) = (open, time_s);
        true
    }

    /// Follows the command after its delay; returns `true` if the state changed.
    pub(crate) fn follow(&mut self, time_s: f64) -> bool {
        let [opening, closing] = self.delays();
        let due = self.since_s + if self.open_wanted { opening } else { closing };
        let wanted = !self.open_wanted;
        if self.data.is_none() || self.closed == wanted || time_s < due - 1e-9 || (self.stuck && !wanted) {
            return false;
        }
        self.closed = wanted;
        true
    }

    /// Returns the torque of the brake \[Nm\].
    pub(crate) fn torque_nm(&self) -> f64 {
        if self.closed { self.data.map_or(0.0, |data| data.torque_nm) } else { 0.0 }
    }
}

/// Limits and reaction of the supervision of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Largest following error at the motor over i \[rad\]; `None` without this supervision.
    pub following_rad: Option<f64>,
    /// Lowest and highest voltage of the DC link \[V\].
    pub link_v: [f64; 2],
    /// Deceleration of a ramp [rad/s²].
    pub ramp_rad_s2: f64,
    /// Reaction to faults detected by the drive.
    pub reaction: Reaction,
}
