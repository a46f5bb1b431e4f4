//! Rests in which what drives the axis does not carry the load all the time.

use quantities::{Measure, Time};

/// How long the load weighs on the output in a segment at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Carried {
    /// All the time.
    #[default]
    Throughout,
    /// At the beginning until a brake has closed, and at the end while it opens: both together not longer than the rest.
    AtItsEnds {
        /// Time at the beginning.
        first: Time,
        /// Time at the end.
        last: Time,
    },
    /// Never.
    Never,
}

impl Carried {
    /// The instants of a rest of a duration between which nothing is carried, from its beginning \[s\].
    #[must_use]
    pub fn ends(self, duration_s: f64) -> (f64, f64) {
        match self {
            Self::Throughout => (duration_s, duration_s),
            Self::AtItsEnds { first, last } => (first.si(), duration_s - last.si()),
            Self::Never => (0.0, duration_s),
        }
    }
}
