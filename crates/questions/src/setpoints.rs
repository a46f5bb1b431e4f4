//! Setpoints of a motion at the cycle of a controller.

use crate::moves::Moves;
use axis::AxisProject;
use quantities::unit::SECOND;
use quantities::{Measure, Time, Unit};

/// Largest number of rows.
pub const SETPOINTS_MOST: usize = 1_000_000;

/// Share of a step within which the end of the cycle lies on a step: rounding only.
const SAME_INSTANT: f64 = 1e-6;

/// Setpoints over one cycle, its end included.
#[derive(Clone, Debug, PartialEq)]
pub struct Setpoints {
    /// Time between two rows.
    pub every: Time,
    /// `true` if the values are those of the output; otherwise they are those along the line.
    pub turns: bool,
    /// Units of time, position, speed and acceleration.
    pub units: [&'static Unit; 4],
    /// Time, position, speed and acceleration of each row, in SI.
    pub rows: Vec<[f64; 4]>,
    /// The cycle is no multiple of the step: the last row is nearer to the one before it than the others \[s\].
    pub rest: Option<Time>,
}

/// Reason why a motion has no setpoints at a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoSetpoints {
    /// The step is no positive time.
    NoStep,
    /// More rows than are permitted.
    TooMany,
}

/// Share of the largest value of a move below which a value is zero: rounding only.
const ZERO: f64 = 1e-12;

/// Sets values that are zero but for rounding, beside the largest of each column.
fn without_rounding(rows: &mut [[f64; 4]], largest: [f64; 4]) {
    for (cell, largest) in rows.iter_mut().flat_map(|row| row.iter_mut().zip(largest)) {
        if cell.abs() < ZERO * largest {
            *cell = 0.0;
        }
    }
}

/// Returns the setpoints of a motion at equal steps: closed forms of its laws, a recording with linear speed between its samples.
///
/// # Errors
/// A step that is not positive or too small.
pub fn setpoints(project: &AxisProject, moves: &Moves<'_>, every: Time) -> Result<Setpoints, NoSetpoints> {
    let (step, motion) = (every.si(), &project.axis.motion);
    let end = motion.duration().si();
    if !(step > 0.0 && step.is_finite()) {
        return Err(NoSetpoints::NoStep);
    }
    let whole = (end / step + SAME_INSTANT).floor();
    #[allow(clippy::cast_precision_loss, reason = "a million")]
    if whole >= SETPOINTS_MOST as f64 {
        return Err(NoSetpoints::TooMany);
    }
    let rest = end - whole * step;
    let rest = (rest > SAME_INSTANT * step).then_some(rest);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a million")]
    let whole = whole as u32;
    let at = |time: f64| {
        let state = motion.at(Time::from_si(time));
        let values = [state.position_rad, state.speed_rad_s, state.acceleration_rad_s2];
        let [position, speed, acceleration] = values.map(|value| value * moves.per_output);
        [time, position, speed, acceleration]
    };
    // The last step is the end itself.
    let instants = (0..=whole).map(|place| f64::from(place) * step).map(|time| time.min(end));
    let mut rows: Vec<[f64; 4]> = instants.chain(rest.map(|_| end)).map(at).collect();
    let courses = || moves.moves.iter().filter_map(|each| each.course);
    let largest = |of: fn([f64; 3]) -> f64| courses().map(|course| of(course).abs()).fold(0.0, f64::max);
    let (speed, acceleration) = (largest(|[_, speed, _]| speed), largest(|[.., acceleration]| acceleration));
    without_rounding(&mut rows, [end, speed * end, speed, acceleration]);
    let [position, speed, acceleration] = moves.units;
    Ok(Setpoints {
        every,
        turns: moves.turns,
        units: [&SECOND, position, speed, acceleration],
        rows,
        rest: rest.map(Time::from_si),
    })
}
