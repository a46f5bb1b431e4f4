//! The questions over HTTP: each returns the bytes that its command writes with `--json`.
//!
//! The list of `questions` gives the routes, the arguments of a request and the content of `/api/v1/openapi.json`. This
//! module holds the transport, and the answers that are drawn, typeset or written as tables.

pub(crate) mod inquiry;
#[cfg(feature = "interface")]
mod made;
#[cfg(feature = "interface")]
mod openapi;

use crate::{Call, Method, Reply, Shell};
use answers::{Fault, Faults};
use quantities::Language;
use questions::answer::written;
use questions::list::{Argument, Entry, FILE, Gives, Inquiry, LIST, Reads, Unanswered, media};
use questions::{Progress, answer};
use words::requests;

/// Prefix of all paths of the interface.
const ROOT: &str = "/api/v1/";

/// The question that only HTTP has: the OpenAPI description of all questions.
const OPENAPI: Entry = Entry {
    command: "",
    path: "openapi.json",
    about: requests::endpoints,
    reads: Reads::Nothing,
    arguments: &[],
    gives: Gives::Json,
    writes: &[],
    example: "",
    answer: None,
};

/// Returns every question that has a path.
fn entries() -> impl Iterator<Item = &'static Entry> {
    LIST.iter().copied().chain([&OPENAPI])
}

/// Returns the method of a question: POST if it reads a text, else GET.
pub(crate) fn method(entry: &Entry) -> Method {
    if entry.reads == Reads::Nothing { Method::Get } else { Method::Post }
}

/// Returns the query parameters of a question: its arguments, and the name of its body.
fn parameters(entry: &Entry) -> Vec<Argument> {
    let mut found = entry.arguments.to_vec();
    if matches!(entry.reads, Reads::Project | Reads::Pins | Reads::Measured) {
        let behind = found.iter().position(|argument| argument.name == "axis");
        let place = behind.map_or(found.len(), |axis| axis + 1);
        found.insert(place, FILE);
    }
    found
}

/// Returns the reply with a record.
fn record(status: u16, record: &impl serde::Serialize) -> Reply {
    Reply::of(status, media::JSON, written(record))
}

/// Returns the reply to a request that is no question, with a hint.
#[must_use]
pub fn misdirected(status: u16, message: &str, hint: Option<String>) -> Reply {
    let fault = Fault { id: Some("request"), message: message.to_owned(), hint, ..Fault::default() };
    record(status, &Faults::from(vec![fault]))
}

/// Returns `true` if a path belongs to the interface.
pub(crate) fn is_path(path: &str) -> bool {
    path == "/api" || path.starts_with("/api/")
}

/// Returns the methods of a path of the interface; empty if there is no such path.
pub fn methods(path: &str) -> Vec<Method> {
    let here = path.strip_prefix(ROOT).unwrap_or_default();
    entries().filter(|entry| entry.path == here).map(method).collect()
}

/// Answers a question.
#[cfg(feature = "interface")]
pub(crate) fn respond(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let here = call.path.strip_prefix(ROOT).unwrap_or_default();
    let valid = methods(call.path);
    if valid.is_empty() {
        return no_such_path(call);
    }
    let language = call.query_language();
    let Some(entry) = entries().find(|entry| entry.path == here && method(entry) == call.method) else {
        return wrong_method(call.path, call.method.id(), &valid, language);
    };
    if let Some(refused) = inquiry::wrong_media(entry.reads, call, language) {
        return refused;
    }
    let answered =
        inquiry::read_inquiry(entry, call, shell, progress).and_then(|inquiry| reply(entry, &inquiry, shell));
    answered.unwrap_or_else(|unanswered| refused(&unanswered, shell, language))
}

/// Answers a question: with its record, or with the picture, document or table that is made of it.
///
/// # Errors
/// Faults of the question, or the reason why it has no answer.
#[cfg(feature = "interface")]
pub fn reply(entry: &Entry, inquiry: &Inquiry<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let Some(answer) = entry.answer else { return made::reply(entry.command, inquiry, shell) };
    let answer = answer(inquiry)?;
    let reply = Reply::of(200, answer.media, answer.text);
    Ok(match answer.file {
        Some(file) => reply.saved_as(&file),
        None => reply,
    })
}

/// Returns the faults with their HTTP status.
fn refused(unanswered: &Unanswered, shell: &dyn Shell, language: Language) -> Reply {
    if unanswered.is_stopped() {
        let waited = shell.time_limit().unwrap_or_default().as_secs();
        return record(503, &answer::fault(&requests::not_in_time(&waited, language)));
    }
    let status = if unanswered.is_too_large() { 413 } else { 422 };
    Reply::of(status, media::JSON, unanswered.record(None, language))
}

/// Returns the reply for an unknown path.
fn no_such_path(call: &Call<'_>) -> Reply {
    let language = call.query_language();
    let message = requests::no_such_path(&quantities::seen(call.path), language);
    misdirected(404, &message, Some(requests::paths_are_listed(language).to_owned()))
}

/// Returns the reply to a method that a path does not have.
#[must_use]
pub fn wrong_method(path: &str, method: &str, valid: &[Method], language: Language) -> Reply {
    let names: Vec<&str> = valid.iter().flat_map(|method| method.names()).copied().collect();
    let names = names.join(", ");
    let path = quantities::seen(path);
    misdirected(405, &requests::wrong_method(&path, &method, &names, language), None).with("allow", names)
}

#[cfg(test)]
mod tests;
