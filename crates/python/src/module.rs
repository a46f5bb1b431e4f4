//! The module `antrieb._antrieb`.

mod capsules;
mod table;

use crate::{CallOutcome, ForkedAtWork, QuestionCall, SourceText, within};
use pyo3::exceptions::PyRuntimeError;
use pyo3::intern;
use pyo3::prelude::*;
use quantities::Language;
use questions::Progress;
use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Interval at which a call checks for an interrupt.
const TICK: Duration = Duration::from_millis(20);

/// Runs work on a thread of its own while the interpreter continues; an interrupt or a deadline ends it before its next
/// step.
pub(crate) fn beside<T: Send>(
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
fn forked_at_work() -> PyErr {
    PyRuntimeError::new_err(
        "this process was forked while another thread was in a call of antrieb; what that thread held can never be had here. Fork \
         before, or start processes with the method 'spawn' or 'forkserver'",
    )
}

/// A text or a file, as the functions of the package pass it: text, name, folder; a file without a text.
type Handed = (Option<String>, String, PathBuf);

fn text((text, name, folder): Handed) -> SourceText {
    match text {
        Some(text) => SourceText::Is { text, name, folder },
        None => SourceText::At(PathBuf::from(name)),
    }
}

/// Returns the exception with the faults of a record.
fn refused(py: Python<'_>, record: &str) -> PyErr {
    let made = || {
        let record = py.import(intern!(py, "json"))?.call_method1("loads", (record,))?;
        py.import(intern!(py, "antrieb._call"))?.getattr("AntriebError")?.call1((record,))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}

/// Native part of antrieb, called by the functions of the package.
#[pymodule(gil_used = false)]
mod _antrieb {
    use super::*;

    #[pymodule_export]
    use super::table::{Sweep, Table};

    /// Answers a question: its media type and the answer. Faults are raised as `AntriebError`.
    #[pyfunction]
    #[pyo3(signature = (command, texts, pairs, lang, deadline, memory))]
    fn ask(
        py: Python<'_>,
        command: String,
        texts: Vec<Handed>,
        pairs: Vec<(String, String)>,
        lang: &str,
        deadline: Option<&str>,
        memory: Option<String>,
    ) -> PyResult<(&'static str, Cow<'static, [u8]>)> {
        let language = Language::of_id(lang).unwrap_or_default();
        let deadline = deadline.map(|text| antrieb::deadline_of(text, language)).transpose();
        let deadline = deadline.map_err(|why| refused(py, &why.record(None, language)))?;
        let texts = texts.into_iter().map(text).collect();
        let call = QuestionCall { command, texts, pairs, deadline, memory, language };
        let progress = call.progress();
        match beside(py, &progress, deadline, || call.answer(&progress))? {
            CallOutcome::Answered(reply) => Ok((reply.media, reply.body.into())),
            CallOutcome::Refused(record) => Err(refused(py, &record)),
        }
    }

    /// Answers a call of the command line, the name of the program first; gives the exit code.
    #[pyfunction]
    fn run(py: Python<'_>, call: Vec<std::ffi::OsString>) -> PyResult<u8> {
        py.detach(|| within(|| antrieb::run(call))).map_err(|ForkedAtWork| forked_at_work())
    }

    /// Notes that this process is the child of a fork.
    #[pyfunction]
    fn forked() {
        crate::forked();
    }

    /// The version.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
