//! The use cases over HTTP: each answers with the bytes that its command writes with `--json`.
//!
//! There is one list of endpoints ([`list::ENDPOINTS`]). It dispatches, it says what a request may ask, and it is what
//! `/api/v1/openapi.json` tells of; an endpoint that stands in it is described, one that does not stand in it does not exist.

pub(crate) mod asked;
pub(crate) mod axis;
pub(crate) mod code;
pub(crate) mod library;
mod list;
#[cfg(feature = "interface")]
mod openapi;
#[cfg(feature = "interface")]
mod tables;

use crate::{Call, Method, Reply, Shell};
use asked::Asked;
use workbench::answer::written;
use workbench::answers::{CodeFaults, Fault, Faults};
use workbench::text::{Word, requests};
use workbench::{Language, Patience};

/// What all paths begin with.
const ROOT: &str = "/api/v1/";

/// Media type of a record.
const JSON: &str = "application/json";

/// One thing that can be asked.
pub(crate) struct Endpoint {
    pub(crate) method: Method,
    /// Its path below the root.
    pub(crate) path: &'static str,
    pub(crate) about: Word,
    body: Body,
    pub(crate) parameters: &'static [Parameter],
    output: Output,
    #[cfg(feature = "interface")]
    answer: fn(&Asked<'_>) -> Result<Reply, Unanswered>,
}

/// What a request brings.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Body {
    None,
    /// The text of a project file.
    Project,
    /// A list of pins.
    Pins,
    /// Measured values.
    Measured,
    /// JSON with the texts of two project files.
    TwoProjects,
}

/// What an endpoint answers with.
#[derive(Clone, Copy)]
pub(crate) enum Output {
    /// The record of a command, by its name in the schema of the answers.
    Record(&'static str),
    /// The same, and bytes of these media types where the query asks for them.
    RecordOr(&'static str, &'static [&'static str]),
    /// A record with this name among those that the answers share.
    Shared(&'static str),
    /// JSON that tells its own form.
    Json,
    /// Bytes of these media types.
    Media(&'static [&'static str]),
}

/// What the query may say; the names are those of the options of the command line.
#[derive(Clone, Copy)]
pub(crate) struct Parameter {
    pub(crate) name: &'static str,
    pub(crate) about: Word,
    pub(crate) kind: Kind,
    pub(crate) required: bool,
    pub(crate) repeated: bool,
}

/// What a value may be.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    /// A text; a quantity and a code are read by the use case.
    Text,
    /// A day; it is read by the use case.
    Date,
    /// True or false; a name without a value is true.
    Flag,
    /// A whole number from and to.
    Whole(u64, u64),
    /// One of these words.
    Word(fn() -> Vec<&'static str>),
}

impl Parameter {
    const fn of(name: &'static str, about: Word, kind: Kind) -> Self {
        Self { name, about, kind, required: false, repeated: false }
    }

    const fn required(self) -> Self {
        Self { required: true, ..self }
    }

    const fn repeated(self) -> Self {
        Self { repeated: true, ..self }
    }
}

/// Why a question has no answer.
pub(crate) enum Unanswered {
    /// The faults, with the status that they have.
    Faults(u16, Faults),
    /// Those of a code that a question is about.
    Code(CodeFaults),
}

impl From<Faults> for Unanswered {
    fn from(faults: Faults) -> Self {
        Self::Faults(422, faults)
    }
}

impl Unanswered {
    /// The faults, whichever record has them, for a question in which each is told once.
    fn reply(&self) -> Reply {
        match self {
            Self::Faults(status, faults) => record(*status, faults),
            Self::Code(faults) => record(422, faults),
        }
    }
}

/// The reply with a record.
fn record(status: u16, record: &impl serde::Serialize) -> Reply {
    Reply::of(status, JSON, written(record))
}

/// What stands where a question could not even be put, with a hint.
#[must_use]
pub fn misdirected(status: u16, message: &str, hint: Option<String>) -> Reply {
    let fault = Fault { id: Some("request"), message: message.to_owned(), hint, ..Fault::default() };
    record(status, &Faults { errors: vec![fault] })
}

/// The endpoint that a method asks for at a path below the root.
pub(crate) fn endpoint(method: Method, path: &str) -> Option<&'static Endpoint> {
    list::ENDPOINTS.iter().find(|endpoint| endpoint.path == path && endpoint.method == method)
}

/// Whether a path is one of the interface's.
pub(crate) fn is_path(path: &str) -> bool {
    path == "/api" || path.starts_with("/api/")
}

/// The methods that a path of the interface answers to; none where there is no such path.
pub fn methods(path: &str) -> Vec<Method> {
    let here = path.strip_prefix(ROOT).unwrap_or_default();
    list::ENDPOINTS.iter().filter(|endpoint| endpoint.path == here).map(|endpoint| endpoint.method).collect()
}

/// Answers a question.
#[cfg(feature = "interface")]
pub(crate) fn respond(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    let here = call.path.strip_prefix(ROOT).unwrap_or_default();
    let mut there = list::ENDPOINTS.iter().filter(|endpoint| endpoint.path == here).peekable();
    if there.peek().is_none() {
        return no_such_path(call);
    }
    match there.find(|endpoint| endpoint.method == call.method) {
        Some(endpoint) => {
            match Asked::of(endpoint, call, shell, patience).and_then(|asked| (endpoint.answer)(&asked)) {
                Ok(reply) => reply,
                Err(unanswered) => unanswered.reply(),
            }
        }
        None => wrong_method(call.path, call.method.id(), &methods(call.path), call.query_language()),
    }
}

/// The reply where there is nothing at a path.
fn no_such_path(call: &Call<'_>) -> Reply {
    let language = call.query_language();
    let message = requests::no_such_path(&workbench::quantities::seen(call.path), language);
    misdirected(404, &message, Some(requests::paths_are_listed(language).to_owned()))
}

/// The reply where a path does not answer to a method.
#[must_use]
pub fn wrong_method(path: &str, method: &str, valid: &[Method], language: Language) -> Reply {
    let names: Vec<&str> = valid.iter().flat_map(|method| method.names()).copied().collect();
    let names = names.join(", ");
    let path = workbench::quantities::seen(path);
    let mut reply = misdirected(405, &requests::wrong_method(&path, &method, &names, language), None);
    reply.headers.push(("allow", names));
    reply
}

#[cfg(test)]
mod tests;
