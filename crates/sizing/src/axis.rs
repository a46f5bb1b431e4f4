//! The axis: load and cycle, prepared once for all candidates.

use mechanism::DirectLoad;
use motion::{Cycle, Moments, Segment};
use quantities::ThermodynamicTemperature;

/// Load and motion of one axis, with the moments of its cycle.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What is moved.
    pub load: DirectLoad,
    /// How it is moved.
    pub cycle: Cycle,
    /// Ambient temperature, if the user stated one.
    pub ambient: Option<ThermodynamicTemperature>,
    pub(crate) moments: Moments,
    pub(crate) segments: Vec<Segment>,
}

impl Axis {
    /// Prepares an axis: one pass over the motion.
    #[must_use]
    pub fn new(load: DirectLoad, cycle: Cycle, ambient: Option<ThermodynamicTemperature>) -> Self {
        let moments = Moments::of(&cycle);
        let segments = cycle.segments().collect();
        Self { load, cycle, ambient, moments, segments }
    }

    /// The integrals of the cycle.
    #[must_use]
    pub const fn moments(&self) -> &Moments {
        &self.moments
    }
}
