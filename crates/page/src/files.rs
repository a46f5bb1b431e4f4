//! Beginning, opening, saving and downloading of projects.

use crate::call::{Call, FileEntry, Folder, Reply, SaveFault, Shell, Storage, query};
use crate::frame;
use crate::head::USUAL_NAME;
use crate::markup::label_of;
use crate::names::project_name;
use crate::start::BEGINS;
use crate::state::PageState;
use crate::value::said;
use maud::{Markup, html};
use project::{Clash, Prefer, Unmerged, merged};
use quantities::Language;
use questions::Progress;
use questions::list::new;
use questions::list::upkeep::day_of_clock;
use std::io::ErrorKind;
use words::{file_trouble, page, upkeep};

/// Returns the page with a project that was begun with a few values.
pub(crate) fn begun(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let Some(begin) = BEGINS.get(call.begin()) else { return Reply::text(404, page::no_such_page(call.language())) };
    with_text(call, &crate::start::typed(begin, call), "", "", shell, progress)
}

/// Returns the page with a project of the folder.
pub(crate) fn opened(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let name = call.field("open").unwrap_or_default();
    let read = shell.folder().map(|folder| folder.read(&name));
    match read {
        Some(Ok(bytes)) => {
            // A lossy conversion would be written back when the project is saved.
            let Ok(text) = std::str::from_utf8(&bytes) else {
                return Reply::text(422, &page::not_a_text(&name, call.language()));
            };
            if questions::list::commission_record::measured(text).is_ok() {
                return with_record(call, &name, shell, progress);
            }
            with_text(call, text, &name, &known(&shell.version(&bytes), &name), shell, progress)
        }
        Some(Err(error)) => Reply::text(404, &format!("{name}: {}", file_trouble(&error, call.language()))),
        None => Reply::text(404, page::no_such_page(call.language())),
    }
}

/// Joins the version of a file and its name as the page holds them.
fn known(version: &str, name: &str) -> String {
    format!("{version} {name}")
}

/// Returns the whole page about a text.
fn with_text(call: &Call<'_>, text: &str, file: &str, known: &str, shell: &dyn Shell, progress: &Progress) -> Reply {
    let fields = [("text", text), ("file", file), ("known", known), ("lang", call.language().id())];
    whole(call, &fields, shell, progress)
}

/// Returns the whole page with these fields in place of those of the call.
fn whole(call: &Call<'_>, fields: &[(&str, &str)], shell: &dyn Shell, progress: &Progress) -> Reply {
    let query = query(fields.iter().copied());
    let inner = Call { path: "/", query: &query, media: None, body: &[], ..*call };
    Reply::of(200, crate::HTML, frame::whole(&inner, shell, progress).into_string())
}

/// Returns the page with a record of measured values: it is not a project and opens in its tool.
fn with_record(call: &Call<'_>, name: &str, shell: &dyn Shell, progress: &Progress) -> Reply {
    let l = call.language();
    // The name of a record may begin with the code that it belongs to.
    let about = name.split("-measured").next().unwrap_or_default();
    let fields = [("tool", "record"), ("asked", "record"), ("about", about), ("t_open", name), ("lang", l.id())];
    whole(call, &fields, shell, progress)
}

/// Saves the text in the folder. A file that has changed since it was opened is left unchanged; a deleted one is
/// written again.
pub(crate) fn saved(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let state = PageState::of(call);
    let l = state.language;
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    let name = project_name(&state.file);
    // The version is known only for the file that was opened.
    let opened = state.known.split_once(' ').filter(|(_, known)| *known == name).map(|(version, _)| version);
    let is_gone = || folder.read(&name).is_err_and(|error| error.kind() == ErrorKind::NotFound);
    let opened = opened.filter(|_| !is_gone());
    match folder.save(&name, state.text.as_bytes(), opened) {
        Ok(()) => {
            let text = match folder.place() {
                Storage::Disk => page::saved(&name, l),
                Storage::Browser => page::kept_in_browser(&name, &page::project_file(l), l),
            };
            Reply::text(200, &text).with("x-version", shell.version(state.text.as_bytes())).with_name("x-file", &name)
        }
        Err(SaveFault::Changed) if opened.is_none() => {
            Reply::text(409, &page::name_is_taken(&name, l)).with_name("x-file", &name)
        }
        Err(SaveFault::Changed) => {
            let text = match folder.place() {
                Storage::Disk => page::changed_on_disk(&name, l),
                Storage::Browser => page::changed_in_browser(&name, l),
            };
            Reply::text(409, &text)
        }
        Err(SaveFault::Name) => Reply::text(422, &page::no_such_name(&state.file, l)),
        Err(SaveFault::Disk(error)) => Reply::text(409, &file_trouble(&error, l)),
    }
}

/// Returns the page with an example and keeps the recording of the example next to the projects.
pub(crate) fn example(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let l = call.language();
    let kind = call.field("kind").unwrap_or_default();
    let Some(found) = new::example(&kind, USUAL_NAME, l) else { return Reply::text(404, page::no_such_page(l)) };
    let mut text = found.text;
    if let (Some((name, bytes)), Some(folder)) = (found.recording, shell.folder()) {
        match folder.keep(&name, bytes.as_bytes()) {
            // Another recording may have the name; the text then names the new one.
            Ok(kept) => text = text.replace(&name, &kept),
            Err(fault) => return not_kept(&fault, &name, l),
        }
    }
    with_text(call, &text, USUAL_NAME, "", shell, progress)
}

/// Returns the project files of the folder, and the control that opens a file from elsewhere.
pub(crate) fn listed(call: &Call<'_>, shell: &dyn Shell) -> Markup {
    let l = call.language();
    let inside = html! {
        p { button type="button" data-open="" { (page::from_elsewhere(l)) } }
        (in_folder(shell, l))
    };
    crate::markup::drawer(page::open(l), &inside, l)
}

/// Returns the project files of the folder with the day of their last change, the latest first.
pub(crate) fn in_folder(shell: &dyn Shell, language: Language) -> Markup {
    const DAY_S: u64 = 86_400;
    let found = shell.folder().and_then(|folder| folder.list().ok()).unwrap_or_default();
    let of_browser = shell.folder().is_some_and(|folder| folder.place() == Storage::Browser);
    let day = |entry: &FileEntry| day_of_clock(entry.modified_s / DAY_S).map(upkeep::date_text);
    html! { @if !found.is_empty() {
        h3 { @if of_browser { (page::browser_folder(language)) } @else { (page::folder(language)) } }
        ul.plain { @for each in &found { li {
            a href={ "/?" (query([("open", each.name.as_str()), ("lang", language.id())])) } { (each.name) }
            @if let Some(day) = day(each) { " " span.small { (day) } }
            @if of_browser { " " button.small type="button" data-forget=(each.name) aria-label=(page::forget(&each.name, language)) { (page::forget_short(language)) } }
        } } }
    } }
}

/// Compares the opened file with the one in the folder and, if they differ, returns the version there and the choices of
/// the user for a file that cannot be read.
pub(crate) fn watched(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let l = call.language();
    let known = call.field("known").unwrap_or_default();
    let Some((version, name)) = known.split_once(' ') else { return Reply::text(204, "") };
    let Some(folder) = shell.folder() else { return Reply::text(204, "") };
    let (now, notice) = match folder.read(name) {
        Ok(bytes) if shell.version(&bytes) == version => return Reply::text(204, ""),
        Ok(bytes) => (shell.version(&bytes), html! {}),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            (String::new(), html! { span { (page::no_version(&name, l)) } " " (keep_mine("", l)) })
        }
        Err(error) => (String::new(), html! { span { (file_trouble(&error, l)) } " " (keep_mine("", l)) }),
    };
    Reply::of(200, crate::HTML, notice.into_string()).with("x-version", now)
}

/// Largest number that is tried behind the name of a file.
const COPIES_MOST: usize = 999;

/// Returns a similar name that no file of the folder has.
fn free_name(name: &str, folder: &dyn Folder) -> Option<String> {
    let stem = name.strip_suffix(".toml").unwrap_or(name);
    (2..=COPIES_MOST)
        .map(|number| format!("{stem}-{number}.toml"))
        .find(|free| folder.read(free).is_err_and(|error| error.kind() == ErrorKind::NotFound))
}

fn keep_mine(known: &str, language: Language) -> Markup {
    html! { button type="button" data-disk="mine" data-known=(known) { (page::keep_mine(language)) } }
}

/// Merges the text of the page with the file of the folder, which another has changed since it was opened (`base`). Returns
/// form fields: `text` and `base` for the page, `known` for the next save, `said` for the user; or `notice`, the question
/// which of two values holds.
pub(crate) fn merge(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let state = PageState::of(call);
    let l = state.language;
    let name = state.known.split_once(' ').map_or(&*state.known, |(_, name)| name);
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    let bytes = match folder.read(name) {
        Ok(bytes) => bytes,
        Err(error) => return Reply::text(404, &file_trouble(&error, l)),
    };
    let version = known(&shell.version(&bytes), name);
    let fields = |fields: &[(&str, &str)]| Reply::text(200, &query(fields.iter().copied()));
    let ask = |notice: Markup| fields(&[("notice", &notice.into_string())]);
    let whole = || {
        html! {
            span { (page::other_version(&name, l)) } " "
            button type="button" data-disk="load" data-name=(name) { (page::load_it(l)) } " " (keep_mine(&version, l))
        }
    };
    // A file of this name that was not opened here is another axis: nothing of both is joined.
    if state.known.starts_with(' ') {
        return ask(html! {
            span { (page::name_is_taken(&name, l)) } " "
            @if let Some(free) = free_name(name, folder) {
                button.primary type="button" data-disk="as" data-name=(free) { (page::save_under(&free, l)) } " "
            }
            button type="button" data-disk="load" data-name=(name) { (page::open_it(&name, l)) } " "
            button type="button" data-disk="over" data-known=(version) { (page::replace_it(&name, l)) }
        });
    }
    let Ok(theirs) = String::from_utf8(bytes) else { return ask(whole()) };
    let base = call.field("base").unwrap_or_default().replace("\r\n", "\n");
    let prefer = match call.field("prefer").as_deref() {
        Some("ours") => Some(Prefer::Ours),
        Some("theirs") => Some(Prefer::Theirs),
        _ => None,
    };
    match merged(&base, &state.text, &theirs, prefer) {
        Ok(text) => {
            let said = if text == theirs { page::taken_over(&name, l) } else { page::joined(&name, l) };
            fields(&[("text", &text), ("base", &theirs), ("known", &version), ("said", &said)])
        }
        // An entry of a list has no value to choose.
        Err(Unmerged::Clashes(clashes)) if clashes.iter().all(|clash| clash.ours != clash.theirs) => ask(html! {
            span { (page::both_changed(&name, l)) " " @for (place, clash) in clashes.iter().enumerate() {
                @if place > 0 { "; " } (clash_text(clash, l))
            } "." } " "
            button type="button" data-disk="merge" data-prefer="ours" { (page::keep_these(l)) } " "
            button type="button" data-disk="merge" data-prefer="theirs" { (page::take_theirs(l)) }
        }),
        Err(Unmerged::Clashes(_) | Unmerged::Text) => ask(whole()),
    }
}

/// Describes both values of a key.
fn clash_text(clash: &Clash, language: Language) -> String {
    let label = label_of(&clash.path, language).unwrap_or_else(|| clash.path.clone());
    let shown = |value: &Option<String>| {
        value.as_ref().map_or_else(|| page::not_stated(language).to_owned(), |value| said(value, language))
    };
    page::here_and_there(&label, &shown(&clash.ours), &shown(&clash.theirs), language)
}

/// Returns the text of a project file of the folder.
pub(crate) fn text(call: &Call<'_>, shell: &dyn Shell) -> Reply {
    let l = call.language();
    let name = call.field("file").unwrap_or_default();
    let Some(folder) = shell.folder() else { return Reply::text(404, page::no_such_page(l)) };
    match folder.read(&name) {
        Ok(bytes) if std::str::from_utf8(&bytes).is_err() => Reply::text(422, &page::not_a_text(&name, l)),
        Ok(bytes) => {
            let version = shell.version(&bytes);
            Reply::of(200, "text/plain; charset=utf-8", bytes).with("x-version", version)
        }
        Err(error) => Reply::text(404, &file_trouble(&error, l)),
    }
}

/// Returns the reply for a recording that could not be kept.
pub(crate) fn not_kept(fault: &SaveFault, name: &str, language: Language) -> Reply {
    match fault {
        SaveFault::Disk(error) => Reply::text(409, &file_trouble(error, language)),
        SaveFault::Name | SaveFault::Changed => Reply::text(422, &page::no_recording_name(&name, language)),
    }
}
