//! How long somebody waits for an answer, and how far it has come.

use sizing::Watch;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Why work did not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// Nobody waits any more.
    Cancelled,
    /// The answer was not there in this time.
    TimeOut(Duration),
}

/// Somebody who waits for an answer, for so long or until it is there. Shared between threads: one works, another shows how
/// far it is or cancels it.
#[derive(Debug)]
pub struct Patience {
    since: Instant,
    most: Option<Duration>,
    cancelled: AtomicBool,
    done: AtomicUsize,
    expected: AtomicUsize,
}

impl Patience {
    /// From now on, for so long at most; `None` without end.
    #[must_use]
    pub fn from_now(most: Option<Duration>) -> Self {
        Self {
            since: Instant::now(),
            most,
            cancelled: AtomicBool::new(false),
            done: AtomicUsize::new(0),
            expected: AtomicUsize::new(0),
        }
    }

    /// Ends the work before its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether there is an end to it.
    #[must_use]
    pub const fn is_limited(&self) -> bool {
        self.most.is_some()
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
        if self.cancelled.load(Ordering::Relaxed) {
            return Err(Stopped::Cancelled);
        }
        match self.most {
            Some(most) if self.since.elapsed() > most => Err(Stopped::TimeOut(most)),
            _ => Ok(()),
        }
    }
}
