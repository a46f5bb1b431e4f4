//! Why a figure cannot be drawn.

use workbench::Language;
use workbench::text::{pictures, terms};

/// Why a figure cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFigure {
    /// The project names no loads on the flange.
    NoFlangeLoads,
    /// The stiffness of the gear is not known.
    NoStiffness,
}

impl NoFigure {
    /// The reason in a sentence.
    #[must_use]
    pub fn message(self, language: Language) -> &'static str {
        match self {
            Self::NoFlangeLoads => terms::no_flange_loads(language),
            Self::NoStiffness => pictures::no_stiffness(language),
        }
    }
}
