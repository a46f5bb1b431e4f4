//! Remarks on keys of a recording that do not do what they are stated for.

use crate::examination::Stamps;
use crate::resolution::NOTABLE;
use crate::timing::{SpeedOverTime, is_even};

/// A remark on a stated treatment of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remark {
    /// Held values are to be interpolated, but no column is held.
    NotHeld,
    /// The time stamps are to become even, and they are already.
    EvenAlready,
    /// The time stamps are to become even, and the signals follow the stamps.
    FollowsStamps,
    /// The stated standstill contains speeds of the motion: the axis stops in a step.
    StandstillSteps {
        /// Stated speed [rad/s].
        speed_rad_s: f64,
        /// Largest acceleration with it \[rad/s²\].
        acceleration_rad_s2: f64,
        /// Largest acceleration without it \[rad/s²\].
        without_rad_s2: f64,
    },
}

/// Returns the remark on a standstill that adds acceleration to a motion.
pub(crate) fn of_standstill(speed_rad_s: f64, with: SpeedOverTime<'_>, without_rad_s2: f64) -> Option<Remark> {
    let acceleration_rad_s2 = with.largest_acceleration();
    let is_step = acceleration_rad_s2 > (1.0 + NOTABLE) * without_rad_s2;
    is_step.then_some(Remark::StandstillSteps { speed_rad_s, acceleration_rad_s2, without_rad_s2 })
}

/// Returns the remark on stamps that were replaced by even ones.
pub(crate) fn of_stamps(stamps: &[f64], even: &[f64], signal: Option<&[f64]>) -> Option<Remark> {
    if is_even(stamps, even) {
        return Some(Remark::EvenAlready);
    }
    let follows = Stamps::of(stamps, signal.as_slice()) == Stamps::Kept;
    follows.then_some(Remark::FollowsStamps)
}
