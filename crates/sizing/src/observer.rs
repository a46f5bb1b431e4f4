//! Cancellation: work can be stopped between two steps.

use std::convert::Infallible;

/// Caller's side of a long computation. Each long loop polls it before every step, and a step is short: one judgement
/// of an actuator, or one cycle computed again, at the limits some tens of milliseconds.
pub trait StepObserver: Sync {
    /// Reason of a cancellation.
    type Stop: Send;

    /// Announces the number of steps, if it is known.
    fn expect(&self, steps: usize);

    /// Announces a step.
    ///
    /// # Errors
    /// The reason of a cancellation.
    fn step(&self) -> Result<(), Self::Stop>;
}

/// A watch that never cancels: the work runs to its end.
#[derive(Clone, Copy, Debug)]
pub struct Unobserved;

impl StepObserver for Unobserved {
    type Stop = Infallible;

    fn expect(&self, _: usize) {}

    fn step(&self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Returns the result of work that cannot be cancelled.
pub fn finished<T>(result: Result<T, Infallible>) -> T {
    match result {
        Ok(found) => found,
        Err(never) => match never {},
    }
}
