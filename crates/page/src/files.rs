//! Projects that come and go: begun, opened, saved, downloaded.

use crate::call::{Call, Reply, SaveFault, Shell};
use crate::frame;
use crate::start::BEGINS;
use crate::state::State;
use workbench::Patience;
use workbench::text::{file_trouble, page};

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
            // A text that is changed by being shown would be lost by being saved.
            let Ok(text) = std::str::from_utf8(&bytes) else {
                return Reply::text(422, &page::not_a_text(&name, call.language()));
            };
            with_text(call, text, &name, &known(&shell.version(&bytes), &name), shell, patience)
        }
        Some(Err(error)) => Reply::text(404, &file_trouble(&error, call.language())),
        None => Reply::text(404, page::no_such_page(call.language())),
    }
}

/// The version of a file and its name, as the page carries them.
fn known(version: &str, name: &str) -> String {
    format!("{version} {name}")
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
    // Of a file with another name no version is known.
    let opened = state.known.split_once(' ').filter(|(_, name)| *name == state.file);
    match folder.save(&state.file, state.text.as_bytes(), opened.map(|(version, _)| version)) {
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

/// Keeps a recording beside the projects; answers with the name that it has there.
pub(crate) fn recorded(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let l = call.language();
    let name = call.field("name").unwrap_or_default();
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    match folder.keep(&name, call.body) {
        Ok(name) => Reply::text(200, &name),
        Err(SaveFault::Disk(error)) => Reply::text(409, &file_trouble(&error, l)),
        Err(SaveFault::Name | SaveFault::Changed) => Reply::text(422, &page::no_recording_name(&name, l)),
    }
}
