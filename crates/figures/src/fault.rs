//! Why a figure cannot be drawn.

use crate::words::say;
use workbench::Language;

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
            Self::NoFlangeLoads => say(
                language,
                "the project has no loads on the flange: [bearing] is missing",
                "das Projekt hat keine Lasten am Flansch: [bearing] fehlt",
            ),
            Self::NoStiffness => say(
                language,
                "the torsional stiffness of this actuator is not known",
                "die Torsionssteifigkeit dieses Antriebs ist nicht bekannt",
            ),
        }
    }
}
