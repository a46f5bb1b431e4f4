//! Pictures of results: list of figures, their content, and their descriptions in words.
//!
//! Lays out the results of `questions`; computes nothing and uses no file.

mod axes;
mod bearing;
mod cycle;
mod drawing;
mod face;
mod fault;
mod labels;
mod map;
mod plane;
mod recording;
mod simulation;
mod thin;
mod torsion;
mod tracks;
mod utilisation;
mod values;

pub use axes::power_of_axes;
pub use bearing::bearing_load;
pub use cycle::{CyclePanels, cycle};
pub use drawing::{Drawing, Figure, side_mm};
pub use face::{PinTexts, mating_face};
pub use fault::NoFigure;
pub use map::{By, MapPoint, candidate_map, has_points, nearest};
pub use plane::{curves, torque_speed};
pub use plot::{Picture, Size, Style, Theme};
pub use recording::recording;
pub use simulation::{control_loops, of_a_run, simulation};
pub use torsion::{torsion, torsion_curve};
pub use tracks::encoder_tracks;
pub use utilisation::utilisation;
pub use values::{CurveName, CurveValues};

use axis::AxisProject;
use quantities::Language;
use questions::{Candidate, Progress, Rejected};

/// Draws one figure of a candidate; the map shows all candidates with this one marked.
///
/// # Errors
/// [`NoFigure`] if the project or the actuator gives nothing to draw, or the map was cancelled.
pub fn draw(
    figure: Figure,
    project: &AxisProject,
    candidate: &Candidate<'_>,
    by: By,
    progress: &Progress,
    language: Language,
) -> Result<Drawing, NoFigure> {
    match figure {
        Figure::TorqueSpeed => Ok(torque_speed(project, candidate, language)),
        Figure::Cycle => Ok(cycle(project, candidate, CyclePanels::All, None, language)),
        Figure::Utilisation => Ok(utilisation(candidate, language)),
        Figure::Torsion => torsion(project, candidate, language),
        Figure::BearingLoad => bearing_load(project, candidate, None, language),
        Figure::MatingFace | Figure::EncoderTracks => Err(NoFigure::OfACode),
        // A run is drawn from its results.
        Figure::Simulation | Figure::ControlLoops => Err(NoFigure::OfARun),
        Figure::CandidateMap => {
            let sizing =
                questions::list::size::sized(project, 0, Rejected::All, progress).map_err(NoFigure::Refused)?;
            Ok(candidate_map(&sizing, by, Some(&candidate.id), language))
        }
    }
}
