//! Projects that come and go: begun, opened, saved, downloaded.

use crate::call::{Call, Reply, SaveFault, Shell};
use crate::frame;
use crate::start::BEGINS;
use crate::state::State;
use workbench::text::{file_trouble, page};
use workbench::{Draw, Patience, Request, ask};

/// Which way to begin is asked for.
pub(crate) fn place(call: &Call<'_>) -> usize {
    call.field("kind").and_then(|kind| kind.parse().ok()).unwrap_or(usize::MAX)
}

/// The page with a project that was begun with a few figures.
pub(crate) fn begun(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    let Some(begin) = BEGINS.get(place(call)) else { return Reply::text(404, page::no_such_page(call.language())) };
    let text = begin.text(|path| call.field(path).map(std::borrow::Cow::into_owned));
    with_text(call, &text, "", "", shell, patience)
}

/// The page with a project of the folder.
pub(crate) fn opened(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    let name = call.field("open").unwrap_or_default();
    let read = shell.folder().map(|folder| folder.read(&name));
    match read {
        Some(Ok(bytes)) => {
            let text = String::from_utf8_lossy(&bytes).into_owned();
            with_text(call, &text, &name, &shell.version(&bytes), shell, patience)
        }
        Some(Err(error)) => Reply::text(404, &file_trouble(&error, call.language())),
        None => Reply::text(404, page::no_such_page(call.language())),
    }
}

/// The whole page about a text.
fn with_text(call: &Call<'_>, text: &str, file: &str, known: &str, shell: &dyn Shell, patience: &Patience) -> Reply {
    let mut query = form_urlencoded::Serializer::new(String::new());
    let language = call.language().id();
    for (key, value) in [("text", text), ("file", file), ("known", known), ("lang", language)] {
        let _ = query.append_pair(key, value);
    }
    let query = query.finish();
    let inner = Call { path: "/", query: &query, media: None, body: &[], ..*call };
    Reply::of(200, crate::HTML, frame::whole(&inner, shell, patience).into_string())
}

/// Saves the text in the folder; a file that changed since it was opened is left as it is.
pub(crate) fn saved(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let state = State::of(call);
    let l = state.language;
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    let known = (!state.known.is_empty()).then_some(state.known.as_str());
    match folder.save(&state.file, state.text.as_bytes(), known) {
        Ok(()) => {
            let mut reply = Reply::text(200, &page::saved(&state.file, l));
            reply.headers.push(("x-version", shell.version(state.text.as_bytes())));
            reply
        }
        Err(SaveFault::Changed) => Reply::text(409, &page::changed_on_disk(&state.file, l)),
        Err(SaveFault::Name) => Reply::text(422, &page::no_such_name(&state.file, l)),
        Err(SaveFault::Disk(error)) => Reply::text(409, &file_trouble(&error, l)),
    }
}

/// The project's text as a file.
pub(crate) fn project(call: &Call<'_>) -> Reply {
    let state = State::of(call);
    let name = if state.file.is_empty() { "axis.toml" } else { &state.file };
    Reply::of(200, "application/toml; charset=utf-8", state.text.clone()).saved_as(name)
}

/// The answer as JSON, the same as the command line gives it.
pub(crate) fn data(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    let mut state = State::of(call);
    let held = state.hold(shell.files(), patience);
    let Some(project) = held.projects.get(state.axis) else {
        return Reply::text(422, page::no_result_yet(state.language));
    };
    let request = Request::Size { top: 10, draw: Draw::default() };
    match ask(project, &request, state.language, patience) {
        Ok(found) => {
            let text = serde_json::to_string_pretty(&found).unwrap_or_default();
            Reply::of(200, "application/json", text).saved_as("axis.json")
        }
        Err(_) => Reply::text(422, page::no_result_yet(state.language)),
    }
}
