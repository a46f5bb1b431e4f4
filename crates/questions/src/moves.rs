//! The solved motion: every segment with stated and derived values.

use axis::{AxisProject, RecordingRead, SegmentLoadKey};
use project::SegmentLaw;
use quantities::unit::{
    DEGREE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, MILLIMETRE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE,
};
use quantities::{Measure, Time, Unit};
use std::collections::BTreeMap;

/// One segment of the motion.
#[derive(Clone, Debug)]
pub struct Move<'p> {
    /// Instant of the beginning.
    pub start: Time,
    /// Duration.
    pub duration: Time,
    /// Motion law of the segment: a law, the manual's move, rest, or a recording.
    pub law: SegmentLaw,
    /// Distance, largest speed and largest acceleration, in SI at the output or along the line; `None` at rest.
    pub course: Option<[f64; 3]>,
    /// Recording of the segment, if it is one.
    pub recording: Option<&'p RecordingRead>,
    /// Loads as they act in the segment, in SI, in the order of [`Moves::loads`].
    pub loads: Vec<f64>,
}

/// The segments of a motion.
#[derive(Clone, Debug)]
pub struct Moves<'p> {
    /// `true` if the course is that of the output; otherwise it is that along the line.
    pub turns: bool,
    /// Units of distance, speed and acceleration.
    pub units: [&'static Unit; 3],
    /// Quantity along the line, or after a stage, per quantity at the output, both in SI.
    pub per_output: f64,
    /// Loads that at least one segment states.
    pub loads: Vec<SegmentLoadKey>,
    /// The segments in the order of the motion.
    pub moves: Vec<Move<'p>>,
}

/// Returns the solved segments of a project's motion; along the line if the mechanism has one.
#[must_use]
pub fn moves(project: &AxisProject) -> Moves<'_> {
    let travel = project.axis.mechanism.travel_m_per_rad();
    let units = match travel {
        Some(_) => [&MILLIMETRE, &METRE_PER_SECOND, &METRE_PER_SECOND_SQUARED],
        None => [&DEGREE, &REVOLUTION_PER_MINUTE, &RADIAN_PER_SECOND_SQUARED],
    };
    // The file states the motion of the mechanism, after a stage.
    let factor = travel.unwrap_or_else(|| 1.0 / project.axis.mechanism.stage_ratio());
    let motion = &project.axis.motion;
    let loads = project.segment_loads();
    let mut recordings = project.recordings.iter();
    let course = |index: usize| {
        let solved = motion.stretches().get(index).and_then(|stretch| stretch.solved);
        solved.map(|solved| [solved.distance.si(), solved.speed.si(), solved.acceleration.si()])
    };
    let placed: BTreeMap<usize, &motion::Placed> =
        motion.recordings().iter().map(|each| (each.segment, each)).collect();
    let moves: Vec<Move<'_>> = motion
        .stretches()
        .iter()
        .enumerate()
        .filter_map(|(index, stretch)| {
            let placed = placed.get(&index);
            let at_output = placed.map(|placed| placed.course()).or_else(|| course(index));
            let recording = placed.and_then(|_| recordings.next());
            Some(Move {
                law: project.law(index)?,
                start: stretch.start,
                duration: stretch.duration,
                course: at_output.map(|values| values.map(|value| value * factor)),
                recording,
                loads: loads.iter().filter_map(|load| project.acting_load(*load, index)).collect(),
            })
        })
        .collect();
    Moves { turns: travel.is_none(), units, per_output: factor, loads, moves }
}
