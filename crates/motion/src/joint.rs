//! Tolerances where a recording meets another segment, or its own beginning.

/// Tolerance for the ends of a recording, relative to its largest speed or to its travel: a recording never contains an
/// exact zero.
pub(crate) const JOINT: f64 = 1e-3;

/// Limit of the tolerance for speeds that are slopes of positions, relative to the largest speed: with an error beyond
/// it, the samples are too far apart to determine the end.
const JOINT_MOST: f64 = 0.1;

/// Returns the tolerance for a recorded speed at a joint, given the error of its slope.
pub(crate) fn joint(fastest: f64, slope_error: f64) -> f64 {
    (JOINT * fastest + slope_error).min(JOINT_MOST * fastest)
}
