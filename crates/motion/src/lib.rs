//! What the output shaft is asked to do: moves, the ramps they consist of, and the moments of a cycle.
//!
//! Everything is referred to the output of the actuator. A [`Cycle`] is a list of [`ManualMove`]s, the cycle of
//! the manual's figure in 7.1; its [`Segment`]s are exact linear ramps of speed, so every integral over them is a
//! closed form ([`Moments`]) and no sampling is involved.

mod cycle;
mod moments;

pub use cycle::{Cycle, CycleFault, ManualMove, Phase, Segment};
pub use moments::Moments;
