//! Pictures of results: which there are, what belongs into each, and what it says in words.
//!
//! Lays out what `workbench` found; computes nothing and touches no file.

mod bearing;
mod cycle;
mod drawing;
mod face;
mod fault;
mod map;
mod plane;
mod thin;
mod torsion;
mod utilisation;
mod words;

pub use bearing::bearing_load;
pub use cycle::cycle;
pub use drawing::{Drawing, Figure, side_mm};
pub use face::{mating_face, mating_face_beside_pins};
pub use fault::NoFigure;
pub use map::{By, candidate_map};
pub use plane::{curves, torque_speed};
pub use plot::{Picture, Size, Style, Theme};
pub use torsion::torsion;
pub use utilisation::utilisation;

use workbench::{Candidate, Language, Project};

/// One figure of a candidate; the map is that of all candidates, this one marked.
///
/// # Errors
/// [`NoFigure`] where the project or the actuator gives nothing to draw.
pub fn draw(
    figure: Figure,
    project: &Project,
    candidate: &Candidate<'_>,
    by: By,
    language: Language,
) -> Result<Drawing, NoFigure> {
    match figure {
        Figure::TorqueSpeed => Ok(torque_speed(project, candidate, language)),
        Figure::Cycle => Ok(cycle(project, candidate, language)),
        Figure::Utilisation => Ok(utilisation(candidate, language)),
        Figure::Torsion => torsion(project, candidate, language),
        Figure::BearingLoad => bearing_load(project, candidate, language),
        Figure::MatingFace => Err(NoFigure::OfACode),
        Figure::CandidateMap => Ok(candidate_map(&workbench::size(project), by, Some(&candidate.id), language)),
    }
}
