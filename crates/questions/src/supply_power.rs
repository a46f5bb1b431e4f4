//! Power that several axes draw from their supply.

use crate::sizing_use::{Candidate, course_seen};
use axis::AxisProject;

/// Electrical power of an axis at the motor terminals over its cycle \[W\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerOverCycle {
    /// Largest power drawn; not less than zero.
    pub taken_w: f64,
    /// Largest power returned; not less than zero.
    pub returned_w: f64,
}

/// Computes the power of a candidate over the cycle; `None` if a required datum of the actuator is not known.
#[must_use]
pub fn power_over_cycle(project: &AxisProject, candidate: &Candidate<'_>) -> Option<PowerOverCycle> {
    // The largest values of either sign are among the instants of a picture.
    let course = course_seen(project, candidate, None);
    let mut powers = course.samples.iter().filter_map(|sample| sample.power_w).peekable();
    let _ = powers.peek()?;
    let none = PowerOverCycle { taken_w: 0.0, returned_w: 0.0 };
    Some(powers.fold(none, |found, power| PowerOverCycle {
        taken_w: found.taken_w.max(power),
        returned_w: found.returned_w.max(-power),
    }))
}

/// Returns the sum of the known values, and their number.
#[must_use]
pub fn sum_of_known(values: &[Option<f64>]) -> (f64, usize) {
    (values.iter().flatten().sum(), values.iter().flatten().count())
}
