//! Calls from Python: work beside the interpreter, and exceptions.

use crate::{ForkedAtWork, SourceText, within};
use pyo3::exceptions::PyRuntimeError;
use pyo3::intern;
use pyo3::prelude::*;
use questions::Progress;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Interval at which a call checks for an interrupt.
const TICK: Duration = Duration::from_millis(20);

/// Runs work on a thread of its own while the interpreter continues; an interrupt or a deadline ends it before its next
/// step.
pub(super) fn interruptible<T: Send>(
    py: Python<'_>,
    progress: &Progress,
    deadline: Option<Duration>,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let begin = Instant::now();
    py.detach(|| {
        std::thread::scope(|scope| {
            let (done, is_done) = channel::<()>();
            let worker = scope.spawn(move || {
                let _done = done;
                within(work)
            });
            let mut interrupted = None;
            while is_done.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                if deadline.is_some_and(|most| begin.elapsed() > most) {
                    progress.expire();
                }
                if interrupted.is_none()
                    && let Err(interrupt) = Python::attach(|py| py.check_signals())
                {
                    interrupted = Some(interrupt);
                    progress.cancel();
                }
            }
            let found = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            match interrupted {
                Some(interrupt) => Err(interrupt),
                None => found.map_err(|ForkedAtWork| forked_at_work()),
            }
        })
    })
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
