//! What several axes take from their supply.

use crate::sizing_use::{Candidate, course_seen};
use project::Project;

/// The electrical power of an axis at the motor terminals over its cycle \[W\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerOverCycle {
    /// The largest that is taken; not less than zero.
    pub taken_w: f64,
    /// The largest that is returned; not less than zero.
    pub returned_w: f64,
}

/// The power of a candidate over the cycle; `None` where a datum of the actuator that it needs is not known.
#[must_use]
pub fn power_over_cycle(project: &Project, candidate: &Candidate<'_>) -> Option<PowerOverCycle> {
    // The largest values of either sign are among what a picture shows.
    let course = course_seen(project, candidate, None);
    let mut powers = course.samples.iter().filter_map(|sample| sample.power_w).peekable();
    let _ = powers.peek()?;
    let none = PowerOverCycle { taken_w: 0.0, returned_w: 0.0 };
    Some(powers.fold(none, |found, power| PowerOverCycle {
        taken_w: found.taken_w.max(power),
        returned_w: found.returned_w.max(-power),
    }))
}

/// The sum of what is known, and of how many it is one.
#[must_use]
pub fn sum_of_known(values: &[Option<f64>]) -> (f64, usize) {
    (values.iter().flatten().sum(), values.iter().flatten().count())
}
