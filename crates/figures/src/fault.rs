//! Reasons why a figure cannot be drawn.

use quantities::Language;
use questions::Refusal;
use questions::answer::refusal_text;
use words::{check_missing, pictures, simulation, terms, wiring};

/// Reason why a figure cannot be drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum NoFigure {
    /// The project states no loads on the flange.
    NoFlangeLoads,
    /// The loads on the flange follow from the mechanism, but a value that they need is not stated.
    FlangeLoadsOpen(&'static str),
    /// The stiffness of the gear is unknown.
    NoStiffness,
    /// The figure belongs to an ordering code, not to a project.
    OfACode,
    /// The figure belongs to a simulated run.
    OfARun,
    /// The result to be drawn was refused.
    Refused(Refusal),
}

impl NoFigure {
    /// Returns the reason in a sentence; `waited_s` is the deadline of the caller.
    #[must_use]
    pub fn message(&self, waited_s: Option<f64>, language: Language) -> String {
        match self {
            Self::NoFlangeLoads => terms::no_flange_loads(language).to_owned(),
            Self::FlangeLoadsOpen(missing) => terms::flange_loads_open(&check_missing(missing, language), language),
            Self::OfACode => wiring::face_of_a_code(language).to_owned(),
            Self::OfARun => simulation::picture_of_a_run(language).to_owned(),
            Self::NoStiffness => pictures::no_stiffness(language).to_owned(),
            Self::Refused(refusal) => refusal_text(refusal, waited_s, language),
        }
    }
}
