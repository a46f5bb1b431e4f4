//! The loads on the output bearing over the cycle.

use crate::project::Project;
use crate::sizing_use::Candidate;
use quantities::{Force, Time, Torque};

/// What the output bearing bears in one segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlangeSegment {
    /// Instant of its beginning.
    pub start: Time,
    /// Duration.
    pub duration: Time,
    /// Radial force.
    pub radial_force: Force,
    /// Axial force.
    pub axial_force: Force,
    /// Tilting moment; `None` where the offset R of the bearing is not known.
    pub tilting_moment: Option<Torque>,
}

/// The loads on the output bearing of a candidate, segment by segment; `None` where the project names none.
#[must_use]
pub fn flange_course(project: &Project, candidate: &Candidate<'_>) -> Option<Vec<FlangeSegment>> {
    let duty = project.axis.bearing.as_ref()?;
    let offset = candidate.parameters.output_bearing.offset.known();
    let stretches = project.axis.motion.stretches().iter();
    let segments = stretches.zip(&duty.loads).map(|(stretch, load)| FlangeSegment {
        start: stretch.start,
        duration: stretch.duration,
        radial_force: load.radial_force,
        axial_force: load.axial_force,
        tilting_moment: offset.map(|offset| actuator::tilting_moment(load, offset.value)),
    });
    Some(segments.collect())
}
