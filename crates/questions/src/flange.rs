//! Loads on the output bearing over the cycle.

use crate::sizing_use::Candidate;
use axis::AxisProject;
use sizing::FlangeSample;

/// Returns the loads on the output bearing of a candidate at instants over the cycle; `None` if they are not known.
///
/// Stated loads are constant within a segment, of which both ends are returned.
#[must_use]
pub fn flange_course(project: &AxisProject, candidate: &Candidate<'_>) -> Option<Vec<FlangeSample>> {
    let offset = candidate.parameters.output_bearing.offset.known().map(|offset| offset.value);
    Some(project.axis.flange_course(offset)).filter(|course| !course.is_empty())
}
