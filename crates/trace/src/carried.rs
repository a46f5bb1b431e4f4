//! Rest segments in which the actuator carries the load only part of the time.

use quantities::{Measure, Time};

/// Part of a rest segment during which the load acts on the output.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Carried {
    /// The whole segment.
    #[default]
    Throughout,
    /// The start until the brake has closed and the end while it opens; both together no longer than the segment.
    AtItsEnds {
        /// Time at the start.
        first: Time,
        /// Time at the end.
        last: Time,
    },
    /// No part of the segment.
    Never,
}

impl Carried {
    /// Returns start and end of the interval in which the load is not carried, from the start of a rest of the given
    /// duration \[s\].
    #[must_use]
    pub fn ends(self, duration_s: f64) -> (f64, f64) {
        match self {
            Self::Throughout => (duration_s, duration_s),
            Self::AtItsEnds { first, last } => (first.si(), duration_s - last.si()),
            Self::Never => (0.0, duration_s),
        }
    }
}
