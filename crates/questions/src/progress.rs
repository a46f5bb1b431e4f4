//! Progress and cancellation of an answer.

use sizing::StepObserver;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The work was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

/// Progress and cancellation of an answer. Shared between threads: one works, another displays the progress or cancels,
/// for example at a deadline; the work itself reads no clock.
#[derive(Debug, Default)]
pub struct Progress {
    limited: bool,
    cancelled: Arc<AtomicBool>,
    late: AtomicBool,
    displaced: AtomicBool,
    heard: AtomicBool,
    done: AtomicUsize,
    expected: AtomicUsize,
}

impl Progress {
    /// Creates a state without a time limit.
    #[must_use]
    pub fn endless() -> Self {
        Self::default()
    }

    /// Creates a state with a time limit that the caller measures and enforces.
    #[must_use]
    pub fn limited() -> Self {
        Self { limited: true, ..Self::default() }
    }

    /// Cancels the work before its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Returns the flag that a cancellation sets.
    #[must_use]
    pub fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.cancelled)
    }

    /// Cancels the work because of its time limit.
    pub fn expire(&self) {
        self.late.store(true, Ordering::Relaxed);
        self.cancel();
    }

    /// Interrupts the work before its next step in favour of a shorter one; it is restarted later.
    pub fn displace(&self) {
        self.displaced.store(true, Ordering::Relaxed);
    }

    /// Permits a restart after [`Self::displace`]. Returns `true` if the work was interrupted, `false` if it was
    /// completed first.
    pub fn resume(&self) -> bool {
        self.displaced.store(false, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
        self.expected.store(0, Ordering::Relaxed);
        self.heard.swap(false, Ordering::Relaxed)
    }

    /// Announces a number of further steps.
    pub fn expect_steps(&self, steps: usize) {
        self.expect(steps);
    }

    /// Returns `true` if the work ended at its time limit, not by a cancellation.
    #[must_use]
    pub fn is_late(&self) -> bool {
        self.late.load(Ordering::Relaxed)
    }

    /// Returns `true` if the work has a time limit.
    #[must_use]
    pub const fn is_limited(&self) -> bool {
        self.limited
    }

    /// Returns `true` if the work is cancelled or interrupted.
    #[must_use]
    pub fn is_over(&self) -> bool {
        let is_over = self.cancelled.load(Ordering::Relaxed) || self.displaced.load(Ordering::Relaxed);
        if is_over {
            self.heard.store(true, Ordering::Relaxed);
        }
        is_over
    }

    /// Returns the number of completed steps, and the expected total if it is known.
    #[must_use]
    pub fn progress(&self) -> (usize, Option<usize>) {
        let expected = self.expected.load(Ordering::Relaxed);
        (self.done.load(Ordering::Relaxed), (expected > 0).then_some(expected))
    }
}

impl StepObserver for Progress {
    type Stop = Stopped;

    fn expect(&self, steps: usize) {
        self.expected.store(self.done.load(Ordering::Relaxed) + steps, Ordering::Relaxed);
    }

    fn step(&self) -> Result<(), Stopped> {
        self.done.fetch_add(1, Ordering::Relaxed);
        if self.is_over() { Err(Stopped) } else { Ok(()) }
    }
}
