//! Work that somebody waits for: it can be stopped between two steps.

use std::convert::Infallible;

/// Whoever waits for an answer. Each long loop asks it before every step, and a step is short: one judgement of an actuator,
/// or one cycle made anew, at the limits some tens of milliseconds.
pub trait Watch: Sync {
    /// Why the work does not go on.
    type Stop: Send;

    /// How many steps are to come, where that is known.
    fn expect(&self, steps: usize);

    /// Before a step.
    ///
    /// # Errors
    /// Where the work shall not go on.
    fn step(&self) -> Result<(), Self::Stop>;
}

/// Nobody waits: the work goes on to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Watch for Unwatched {
    type Stop = Infallible;

    fn expect(&self, _: usize) {}

    fn step(&self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// The answer of work that nobody can stop.
pub fn finished<T>(result: Result<T, Infallible>) -> T {
    match result {
        Ok(found) => found,
        Err(never) => match never {},
    }
}
