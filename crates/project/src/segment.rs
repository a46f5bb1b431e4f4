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

    /// What a word of the project file names; the quadratic parabola of VDI 2143 is the triangle.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        Some(match id {
            "manual" => Self::Manual,
            "dwell" => Self::Dwell,
            "recorded" => Self::Recorded,
            "parabola" => Self::Law(Law::Triangle),
            _ => Self::Law(Law::ALL.into_iter().find(|law| law.id() == id)?),
        })
    }
}
