//! Cancellation: work can be stopped between two steps.

use std::convert::Infallible;

/// The caller's side of a long computation. Each long loop polls it before every step, and a step is short: one judgement of an actuator,
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

/// Never cancels: the work runs to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Watch for Unwatched {
    type Stop = Infallible;

    fn expect(&self, _: usize) {}

    fn step(&self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// The result of work that cannot be cancelled.
pub fn finished<T>(result: Result<T, Infallible>) -> T {
    match result {
        Ok(found) => found,
        Err(never) => match never {},
    }
}
