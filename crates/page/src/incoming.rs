//! A recording before it is part of a project: dropped, pasted or opened, shown with its columns, its quality and its
//! effect, and written only when it is used.
//!
//! The body of a request is a line with the fields of the form, and the file behind it: no shell keeps the file.

mod choices;
mod examination;
mod line;
mod shown;

use crate::call::{Call, Reply, Shell};
use examination::{Request, examine, with_recording};
use quantities::Language;
use questions::Progress;
use words::page;

/// Returns the language of a request, by the line of fields before the file.
pub(crate) fn language_of(call: &Call<'_>) -> Language {
    let line = call.body.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let stated = form_urlencoded::parse(line).filter(|(name, _)| name == "lang").last();
    stated.and_then(|(_, language)| Language::of_id(&language)).unwrap_or_else(|| call.language())
}

/// Returns the preview of a file.
pub(crate) fn preview(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let request = Request::of(call);
    let found = examine(&request, shell, progress);
    if progress.is_over() {
        return Reply::text(503, page::no_result_yet(request.state.language));
    }
    Reply::of(200, crate::HTML, shown::preview(&request, &found).into_string())
}

/// Keeps the recording next to the projects and returns the text of the project that uses it.
pub(crate) fn used(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let request = Request::of(call);
    let Request { state, choices, file } = &request;
    let l = state.language;
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    if !choices.is_answered() {
        return Reply::text(422, choices.waits_for(l));
    }
    // Nothing is kept for a project that cannot name it.
    if with_recording(state, choices, file.name(), None).is_err() {
        return Reply::text(422, words::incoming::text_is_faulty(l));
    }
    let name = match folder.keep(file.name(), file.bytes()) {
        Ok(name) => name,
        Err(fault) => return crate::files::not_kept(&fault, file.name(), l),
    };
    match with_recording(state, choices, &name, choices.smoothing.as_deref()) {
        Ok((text, _)) => {
            let stem = name.split('.').next().unwrap_or_default();
            Reply::text(200, &text).with_name("x-file", &crate::names::project_name(stem))
        }
        Err(_) => Reply::text(422, words::incoming::text_is_faulty(l)),
    }
}
