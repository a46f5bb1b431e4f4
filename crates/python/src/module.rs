//! The module `antrieb._antrieb`.

mod call;
mod capsules;
mod cells;
mod table;

use crate::{CallOutcome, ForkedAtWork, QuestionCall, TextChange, ValueFault, within};
use call::{Handed, Watch, forked_at_work, interruptible, refused, text};
use pyo3::prelude::*;
use quantities::Language;
use std::borrow::Cow;
use std::sync::Arc;

/// Native part of antrieb, called by the functions of the package.
#[pymodule(gil_used = false)]
mod _antrieb {
    use super::*;

    #[pymodule_export]
    use super::table::{Sweep, Table};

    /// Answers a question: its media type and the answer. Faults are raised as `AntriebError`.
    #[pyfunction]
    #[allow(clippy::too_many_arguments, reason = "those of the function of the package")]
    #[pyo3(signature = (command, texts, pairs, lang, deadline, memory, by_axes))]
    fn ask(
        py: Python<'_>,
        command: String,
        texts: Vec<Handed>,
        pairs: Vec<(String, String)>,
        lang: &str,
        deadline: Option<&str>,
        memory: Option<String>,
        by_axes: bool,
    ) -> PyResult<(&'static str, Cow<'static, [u8]>)> {
        let language = Language::of_id(lang).unwrap_or_default();
        let deadline = deadline.map(|text| antrieb::deadline_of(text, language)).transpose();
        let deadline = deadline.map_err(|why| refused(py, &why.record(None, language)))?;
        let texts = texts.into_iter().map(text).collect();
        let call = QuestionCall { command, texts, pairs, deadline, memory, by_axes, language };
        let watch = Watch::of(Arc::new(call.progress()), deadline);
        match interruptible(py, &watch, move |progress| call.answer(progress))? {
            CallOutcome::Answered(reply) => Ok((reply.media, reply.body.into())),
            CallOutcome::Refused(record) => Err(refused(py, &record)),
        }
    }

    /// Returns the faults of the values of a project text that lacks other parts: line, fault, and what is expected.
    #[pyfunction]
    fn value_faults(text: &str, lang: &str) -> Vec<ValueFault> {
        crate::value_faults(text, Language::of_id(lang).unwrap_or_default())
    }

    /// Returns a project text with changes that keep its comments: path, value as typed (empty for a table), and whether a
    /// `value`, a `table` or nothing (`gone`) is there then; `None` if one cannot be made.
    #[pyfunction]
    fn edited(text: &str, changes: Vec<(String, String, String)>) -> Option<String> {
        let change = |typed, kind: &str| match kind {
            "value" => TextChange::Value(typed),
            "table" => TextChange::Table,
            _ => TextChange::Gone,
        };
        let changes = changes.iter().map(|(path, typed, kind)| (path.as_str(), change(typed.as_str(), kind)));
        crate::edited(text, changes).ok()
    }

    /// Answers a call of the command line, the name of the program first; gives the exit code.
    #[pyfunction]
    fn run(py: Python<'_>, call: Vec<std::ffi::OsString>) -> PyResult<u8> {
        py.detach(|| within(|| antrieb::run(call))).map_err(|ForkedAtWork| forked_at_work())
    }

    /// Returns the progress of a sweep in one line: completed rows, rows per second and the time left; `seconds` is the time
    /// since the first row.
    #[pyfunction]
    fn progress_line(done: u64, all: u64, seconds: f64, lang: &str) -> String {
        antrieb::rows_line(done, all, seconds, Language::of_id(lang).unwrap_or_default())
    }

    /// Returns the words by which answers are shown, by their names.
    #[pyfunction]
    fn labels(lang: &str) -> Vec<(&'static str, &'static str)> {
        crate::labels(Language::of_id(lang).unwrap_or_default())
    }

    /// Returns the number of checks that lack data, of all checks, and the number of requirements that do.
    #[pyfunction]
    fn missing_data(checks: usize, all: usize, requirements: usize, lang: &str) -> String {
        words::missing_data_text([checks, all], requirements, Language::of_id(lang).unwrap_or_default())
    }

    /// Returns `true` for a key of the project that states the limit of a check.
    #[pyfunction]
    fn is_limit(key: &str) -> bool {
        questions::CheckId::is_limit(key)
    }

    /// Returns the symbol of a figure as it is displayed: `theta_w` is `ϑ_w`.
    #[pyfunction]
    fn symbol(name: &str) -> String {
        words::symbol_shown(name)
    }

    /// Waits before a fork until interrupted calls have ended.
    #[pyfunction]
    fn settle(py: Python<'_>) {
        py.detach(crate::settle);
    }

    /// Returns a unit of a quantity (by its English name) in SI, from any of its spellings; `None` for a unit of another quantity.
    #[pyfunction]
    fn unit_in_si(quantity: &str, spelling: &str) -> Option<f64> {
        let of = quantities::Dimension::ALL.iter().find(|of| of.name(Language::default()) == quantity)?;
        Some(quantities::Unit::of_dimension(*of, spelling)?.to_si(1.0))
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
