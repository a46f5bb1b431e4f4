//! Why a figure cannot be drawn.

use workbench::Language;
use workbench::text::{pictures, terms, wiring};

/// Why a figure cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFigure {
    /// The project names no loads on the flange.
    NoFlangeLoads,
    /// The stiffness of the gear is not known.
    NoStiffness,
    /// The figure is one of an ordering code, not of a project.
    OfACode,
}

impl NoFigure {
    /// The reason in a sentence.
    #[must_use]
    pub fn message(self, language: Language) -> &'static str {
        match self {
            Self::NoFlangeLoads => terms::no_flange_loads(language),
            Self::OfACode => wiring::face_of_a_code(language),
            Self::NoStiffness => pictures::no_stiffness(language),
        }
    }
}
