//! Samples of a recording, and how they are used.

use quantities::{AngularVelocity, Time};
use std::sync::Arc;

/// Samples read from a file, in SI at the output; unchanged columns are shared with the motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// Instants \[s\], strictly increasing.
    pub time_s: Arc<Vec<f64>>,
    /// Positions \[rad\].
    pub position_rad: Option<Arc<Vec<f64>>>,
    /// Speeds [rad/s].
    pub speed_rad_s: Option<Arc<Vec<f64>>>,
    /// Torques of the actuator on the load, positive in the positive direction \[Nm\].
    pub torque_nm: Option<Arc<Vec<f64>>>,
}

/// Processing of samples before they become a motion; none by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Treatment {
    /// Width of the window of a moving parabola, fitted by least squares.
    pub smoothing: Option<Time>,
    /// Speeds below this value count as standstill; if `None`, those identified as noise at rest do.
    pub standstill: Option<AngularVelocity>,
    /// Use of values held over several rows.
    pub held_values: HeldValues,
    /// Use of the time stamps.
    pub time_stamps: TimeStamps,
    /// The samples are a cycle that repeats: where its ends move alike, the window goes over its seam.
    pub repeats: bool,
}

/// Use of values that are held over several rows because their source is slower than the logger.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HeldValues {
    /// Unchanged.
    #[default]
    Kept,
    /// One value for each update, with the motion straight in speed between them.
    Interpolated,
}

/// Use of the time stamps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeStamps {
    /// Unchanged.
    #[default]
    Kept,
    /// Evenly spaced instants fitted to them.
    Even,
}
