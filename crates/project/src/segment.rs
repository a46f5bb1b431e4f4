//! What a segment of the motion follows.

use motion::Law;

/// What a segment follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentLaw {
    /// A law of motion.
    Law(Law),
    /// The manual's move: a trapezoid with a pause.
    Manual,
    /// Rest.
    Dwell,
    /// A recording.
    Recorded,
}

impl SegmentLaw {
    /// The identifier used in project files and data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Law(law) => law.id(),
            Self::Manual => "manual",
            Self::Dwell => "dwell",
            Self::Recorded => "recorded",
        }
    }
}
