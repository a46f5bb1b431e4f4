//! Progress and cancellation of an answer.

use sizing::Watch;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

/// Progress and cancellation of an answer. Shared between threads: one works, another shows the progress or cancels it, such as
/// at a deadline; the work itself has no clock.
#[derive(Debug, Default)]
pub struct Patience {
    limited: bool,
    cancelled: Arc<AtomicBool>,
    late: AtomicBool,
    displaced: AtomicBool,
    heard: AtomicBool,
    done: AtomicUsize,
    expected: AtomicUsize,
}

impl Patience {
    /// Until the answer is there.
    #[must_use]
    pub fn endless() -> Self {
        Self::default()
    }

    /// With a deadline that the caller measures and enforces.
    #[must_use]
    pub fn limited() -> Self {
        Self { limited: true, ..Self::default() }
    }

    /// Ends the work before its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// The flag that is set where it is cancelled.
    #[must_use]
    pub fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.cancelled)
    }

    /// Ends it because the time is over.
    pub fn expire(&self) {
        self.late.store(true, Ordering::Relaxed);
        self.cancel();
    }

    /// Ends the work before its next step for one that is shorter; it is begun again later.
    pub fn displace(&self) {
        self.displaced.store(true, Ordering::Relaxed);
    }

    /// Lets the work be begun again after [`Self::displace`]. Returns `true` if it was ended by that, `false` if it was done before
    /// it noticed.
    pub fn resume(&self) -> bool {
        self.displaced.store(false, Ordering::Relaxed);
        self.done.store(0, Ordering::Relaxed);
        self.expected.store(0, Ordering::Relaxed);
        self.heard.swap(false, Ordering::Relaxed)
    }

    /// So many steps are to come.
    pub fn expect_steps(&self, steps: usize) {
        self.expect(steps);
    }

    /// Whether it ended by the deadline, not by a cancellation.
    #[must_use]
    pub fn is_late(&self) -> bool {
        self.late.load(Ordering::Relaxed)
    }

    /// Whether there is an end to it.
    #[must_use]
    pub const fn is_limited(&self) -> bool {
        self.limited
    }

    /// Whether it is cancelled.
    #[must_use]
    pub fn is_over(&self) -> bool {
        let is_over = self.cancelled.load(Ordering::Relaxed) || self.displaced.load(Ordering::Relaxed);
        if is_over {
            self.heard.store(true, Ordering::Relaxed);
        }
        is_over
    }

    /// The steps that are done, and how many there are to be where that is known.
    #[must_use]
    pub fn progress(&self) -> (usize, Option<usize>) {
        let expected = self.expected.load(Ordering::Relaxed);
        (self.done.load(Ordering::Relaxed), (expected > 0).then_some(expected))
    }
}

impl Watch for Patience {
    type Stop = Stopped;

    fn expect(&self, steps: usize) {
        self.expected.store(self.done.load(Ordering::Relaxed) + steps, Ordering::Relaxed);
    }

    fn step(&self) -> Result<(), Stopped> {
        self.done.fetch_add(1, Ordering::Relaxed);
        if self.is_over() { Err(Stopped) } else { Ok(()) }
    }
}
