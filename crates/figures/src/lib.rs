//! Pictures of results: which there are, what belongs into each, and what it says in words.
//!
//! Lays out what `questions` found; computes nothing and touches no file.

mod bearing;
mod cycle;
mod drawing;
mod face;
mod fault;
mod labels;
mod map;
mod plane;
mod simulation;
mod thin;
mod torsion;
mod tracks;
mod utilisation;

pub use bearing::{bearing_load, bearing_load_within};
pub use cycle::{CyclePanels, cycle, cycle_within};
pub use drawing::{Drawing, Figure, side_mm};
pub use face::{mating_face, mating_face_beside_pins};
pub use fault::NoFigure;
pub use map::{By, MapPoint, candidate_map, nearest};
pub use plane::{curves, torque_speed};
pub use plot::{Picture, Size, Style, Theme};
pub use simulation::{control_loops, of_a_run, simulation, simulation_within};
pub use torsion::{torsion, torsion_curve};
pub use tracks::encoder_tracks;
pub use utilisation::utilisation;

use project::Project;
use quantities::Language;
use questions::{Candidate, Patience};

/// One figure of a candidate, of those over time only what lies between two instants \[s\].
///
/// # Errors
/// [`NoFigure`] where the project or the actuator gives nothing to draw.
pub fn draw_within(
    figure: Figure,
    project: &Project,
    candidate: &Candidate<'_>,
    window: Option<(f64, f64)>,
    patience: &Patience,
    language: Language,
) -> Result<Drawing, NoFigure> {
    match figure {
        Figure::Cycle => Ok(cycle_within(project, candidate, CyclePanels::All, window, language)),
        Figure::BearingLoad => bearing_load_within(project, candidate, window, language),
        other => draw(other, project, candidate, By::Mass, patience, language),
    }
}

/// One figure of a candidate; the map is that of all candidates, this one marked.
///
/// # Errors
/// [`NoFigure`] if the project or the actuator gives nothing to draw, or the map was cancelled.
pub fn draw(
    figure: Figure,
    project: &Project,
    candidate: &Candidate<'_>,
    by: By,
    patience: &Patience,
    language: Language,
) -> Result<Drawing, NoFigure> {
    match figure {
        Figure::TorqueSpeed => Ok(torque_speed(project, candidate, language)),
        Figure::Cycle => Ok(cycle(project, candidate, language)),
        Figure::Utilisation => Ok(utilisation(candidate, language)),
        Figure::Torsion => torsion(project, candidate, language),
        Figure::BearingLoad => bearing_load(project, candidate, language),
        Figure::MatingFace | Figure::EncoderTracks => Err(NoFigure::OfACode),
        // A run is drawn by those who have it.
        Figure::Simulation | Figure::ControlLoops => Err(NoFigure::OfARun),
        Figure::CandidateMap => {
            let sizing = questions::list::size::sized(project, 0, patience).map_err(NoFigure::Refused)?;
            Ok(candidate_map(&sizing, by, Some(&candidate.id), language))
        }
    }
}
