//! Calls from Python: work beside the interpreter, and exceptions.

use crate::{ForkedAtWork, SourceText, leave, within};
use pyo3::exceptions::PyRuntimeError;
use pyo3::intern;
use pyo3::prelude::*;
use questions::Progress;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Interval at which a call checks for an interrupt and reports its progress.
const TICK: Duration = Duration::from_millis(20);

/// Time after an interrupt in which the work ends by itself; later it is left to its thread, which ends at its next step.
const GRACE: Duration = Duration::from_millis(60);

/// Number of values that are converted between two checks for an interrupt.
const CONVERTED: u32 = 4096;

/// Values of Python that are converted while the interpreter waits; every [`CONVERTED`] of them it checks for an interrupt.
#[derive(Debug, Default)]
pub(super) struct Conversion {
    since: u32,
}

impl Conversion {
    /// Counts a value.
    ///
    /// # Errors
    /// The exception of an interrupt.
    pub(super) fn count(&mut self, py: Python<'_>) -> PyResult<()> {
        self.since += 1;
        if self.since < CONVERTED {
            return Ok(());
        }
        self.since = 0;
        py.check_signals()
    }
}

/// A call while it works: cancellation, time limit and the Python function that is called with its progress.
pub(super) struct Watch<'p> {
    pub(super) progress: Arc<Progress>,
    pub(super) deadline: Option<Duration>,
    pub(super) observer: Option<&'p Bound<'p, PyAny>>,
}

impl Watch<'_> {
    /// Returns a call without a function for its progress.
    pub(super) const fn of(progress: Arc<Progress>, deadline: Option<Duration>) -> Self {
        Self { progress, deadline, observer: None }
    }

    /// Handles signals, and calls the function with the number of completed steps and of all, once the number of all is
    /// known.
    fn report(&self, py: Python<'_>) -> PyResult<()> {
        py.check_signals()?;
        match (self.observer, self.progress.progress()) {
            (Some(observer), (done, Some(all))) => observer.call1((done.min(all), all)).map(drop),
            _ => Ok(()),
        }
    }
}

/// Runs work on a thread of its own while the interpreter continues; an interrupt, an exception of the function for the
/// progress or a deadline ends it before its next step.
pub(super) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    watch: &Watch<'_>,
    work: impl FnOnce(&Progress) -> T + Send + 'static,
) -> PyResult<T> {
    let begin = Instant::now();
    let (done, is_done) = channel();
    // A receiver is of one thread; the lock is never waited for.
    let is_done = Mutex::new(is_done);
    let wait = |time: Duration| is_done.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(time);
    let progress = Arc::clone(&watch.progress);
    let worker = std::thread::Builder::new().spawn(move || {
        // Without a receiver the call was interrupted.
        let _ = done.send(within(|| work(&progress)));
    })?;
    loop {
        match py.detach(|| wait(TICK)) {
            Ok(found) => {
                // Only the end of the work is reported to be the end.
                let ended = if found.is_ok() { watch.report(py) } else { Ok(()) };
                ended?;
                return found.map_err(|ForkedAtWork| forked_at_work());
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => match py.detach(|| worker.join()) {
                Err(panic) => std::panic::resume_unwind(panic),
                Ok(()) => return Err(PyRuntimeError::new_err("the work ended without an answer")),
            },
        }
        if watch.deadline.is_some_and(|most| begin.elapsed() > most) {
            watch.progress.expire();
        }
        if let Err(interrupt) = watch.report(py) {
            watch.progress.cancel();
            if matches!(py.detach(|| wait(GRACE)), Err(RecvTimeoutError::Timeout)) {
                leave(worker);
            }
            return Err(interrupt);
        }
    }
}

/// Returns the exception of a process that was forked while a call was running.
pub(super) fn forked_at_work() -> PyErr {
    PyRuntimeError::new_err(
        "this process was forked while another thread was in a call of antrieb; what that thread held can never be had here. Fork \
         before, or start processes with the method 'spawn' or 'forkserver'",
    )
}

/// A text or a file, as the functions of the package pass it: text, name, folder, recordings by name; a file without a text.
pub(super) type Handed = (Option<String>, String, PathBuf, BTreeMap<String, Vec<u8>>);

/// Returns the text or the file that a function of the package passes.
pub(super) fn text((text, name, folder, held): Handed) -> SourceText {
    match text {
        Some(text) => {
            let held = held.into_iter().map(|(name, content)| (name, content.into()));
            SourceText::Is { text, name, folder, recordings: Arc::new(held.collect()) }
        }
        None => SourceText::At(PathBuf::from(name)),
    }
}

/// Returns the exception with the faults of a record.
pub(super) fn refused(py: Python<'_>, record: &str) -> PyErr {
    let made = || {
        let record = py.import(intern!(py, "json"))?.call_method1("loads", (record,))?;
        py.import(intern!(py, "antrieb._call"))?.getattr("AntriebError")?.call1((record,))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}
