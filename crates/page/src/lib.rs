//! The web workbench as a pure function: a request in, HTML or JSON out.
//!
//! It uses no socket and no file. A shell provides the resources ([`Shell`]): the server that `antrieb serve` starts,
//! or the browser itself, where the engine runs as WebAssembly. Both give the same bytes. The numbers are computed in
//! `questions`, the texts stand in `words`.

// Without the interface, only the part that the page itself uses is compiled.
#[cfg_attr(not(feature = "interface"), allow(dead_code, unused_imports))]
mod api;
mod arithmetic;
mod assets;
mod assumed;
mod axes;
mod budget;
mod by_path;
mod call;
mod chapters;
mod checks;
mod demand;
mod detail;
mod fault_lines;
mod file_lines;
mod files;
mod find;
mod fits;
mod form;
mod formula;
mod frame;
mod gains;
mod gallery;
mod head;
mod incoming;
mod laws;
mod locked;
mod markup;
mod names;
mod next;
mod overlay;
mod paper;
mod parts;
mod pasted;
mod placed;
mod places;
mod recorded;
mod rejected;
mod remedies;
mod run_part;
mod segment_line;
mod sentences;
mod shown;
mod simulated;
mod sketch;
mod start;
mod state;
mod text_change;
#[cfg(feature = "theory")]
mod theory;
mod tip;
mod tolerances;
mod tools;
mod typeset;
mod value;
mod verdict;
mod versions;
mod waiting;

#[cfg(feature = "interface")]
pub use api::reply;
pub use api::{methods, misdirected, wrong_method};
pub use assets::ASSETS;
#[cfg(not(target_arch = "wasm32"))]
pub use assets::FONTS;
pub use call::{
    Call, FileEntry, Folder, Method, Press, Reply, ReportInputs, SaveFault, Shell, Storage, WritesChecklist,
    WritesReport,
};
pub use frame::head;
pub use gallery::{GalleryState, STATES};
pub use locked::{is_open_to_all, locked};
pub use names::{is_project_name, recording_names};
#[cfg(feature = "theory")]
pub use theory::theory_files;

use questions::Progress;

/// Answers a request.
#[must_use]
pub fn respond(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let mut reply = answer(call, shell, progress);
    if call.path == "/" && reply.status >= 400 && reply.media.starts_with("text/plain") {
        // Who opens an address reads the reason on a page with a way back.
        let message = String::from_utf8_lossy(&reply.body).into_owned();
        reply = locked::with_way_back(reply.status, &message, call.language());
    }
    if reply.media == HTML {
        let page = String::from_utf8(std::mem::take(&mut reply.body));
        reply.body = page.map_or_else(std::string::FromUtf8Error::into_bytes, |page| {
            typeset::typeset(&page, language_of(call)).into_bytes()
        });
    }
    reply
}

/// Returns the language of an answer: that of a chapter by its address, else that of the call.
fn language_of(call: &Call<'_>) -> quantities::Language {
    #[cfg(feature = "theory")]
    if let Some(language) = theory::language_of(call.path) {
        return language;
    }
    if call.path == PREVIEW { incoming::language_of(call) } else { call.language() }
}

fn answer(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    if !IS_WHOLE && is_for_the_larger(call) {
        return Reply::text(MISDIRECTED, "");
    }
    if let Some(name) = call.path.strip_prefix("/assets/").filter(|_| IS_WHOLE) {
        return assets::asset(name);
    }
    #[cfg(feature = "theory")]
    if let Some(file) = theory::file(call.path) {
        return file;
    }
    #[cfg(feature = "interface")]
    if api::is_path(call.path) {
        return api::respond(call, shell, progress);
    }
    let html = |page: maud::Markup| Reply::of(200, HTML, page.into_string());
    match (call.method, call.path) {
        (Method::Get, "/health") => Reply::text(200, "ok\n"),
        (Method::Get, "/") if call.field("open").is_some() => files::opened(call, shell, progress),
        (Method::Get, "/") if call.field("begin").is_some() => files::begun(call, shell, progress),
        (_, "/") => html(frame::whole(call, shell, progress)),
        (Method::Get, "/begin") => html(start::asked(call.begin(), call.field("further").is_some(), call.language())),
        (Method::Get, "/axis") => html(start::further(call.language())),
        (Method::Get, "/begin/drawing") => html(start::drawing_of(call)),
        (Method::Post, "/work") => frame::worked(call, shell, progress),
        (Method::Post, "/tolerances") if IS_WHOLE => html(tolerances::judged(call, shell, progress)),
        (Method::Get, PROGRESS) => waiting::progress(call, shell),
        (Method::Post, CANCEL) => waiting::cancelled(call, shell),
        (Method::Post, "/explain") if IS_WHOLE => html(frame::explained(call, shell, progress)),
        (Method::Post, "/compare") if IS_WHOLE => html(frame::compared(call, shell, progress)),
        (Method::Post, "/tools") if IS_WHOLE => html(tools::pane(call, shell, progress)),
        (Method::Post, "/paper") if IS_WHOLE => html(paper::first_page(call, shell, progress)),
        (Method::Get, "/find") => html(find::found(call)),
        (Method::Get, "/gallery") if IS_WHOLE => html(gallery::shown(call)),
        (Method::Get, "/keys") => html(find::keyboard(call)),
        (Method::Post, "/versions") if IS_WHOLE => html(versions::listed(call)),
        (Method::Post, "/picture") => frame::picture(call, shell, progress),
        (Method::Post, "/let-in") if IS_WHOLE => html(rejected::changes(call, shell, progress)),
        (Method::Post, "/would-fit") => html(remedies::cards(call, shell, progress)),
        (Method::Post, "/curves") => frame::curves(call, shell, progress),
        (Method::Post, "/values") => frame::values(call, shell, progress),
        (Method::Get, "/example") => html(start::example_verdict(call, shell, progress)),
        (Method::Get, "/files") => html(files::listed(call, shell)),
        (Method::Post, "/merge") if IS_WHOLE => files::merge(call, shell),
        (Method::Get, "/watch") => files::watched(call, shell),
        (Method::Get, "/text") => files::text(call, shell),
        (Method::Post, "/example") => files::example(call, shell, progress),
        (Method::Post, "/save") => files::saved(call, shell),
        (Method::Post, RECORDING) if IS_WHOLE => incoming::used(call, shell),
        (Method::Post, PREVIEW) if IS_WHOLE => incoming::preview(call, shell, progress),
        _ => Reply::text(404, words::page::no_such_page(call.language())),
    }
}

/// The complete page. The engine that a browser fetches first answers what a motion and its verdict need; the larger
/// one, fetched with the first request for it, answers everything.
pub const IS_WHOLE: bool = cfg!(feature = "interface");

/// Status of a request that only the larger engine answers.
pub const MISDIRECTED: u16 = 421;

/// Returns true for the requests that only the larger engine answers: `/api/`, tools, simulation, tolerances,
/// recordings, versions, two versions in one, the gallery, the printed page, derivations, the comparison, and what would
/// let a rejected actuator in.
fn is_for_the_larger(call: &Call<'_>) -> bool {
    let path = [
        "/tools",
        "/compare",
        "/tolerances",
        "/versions",
        "/explain",
        "/let-in",
        "/gallery",
        "/merge",
        "/paper",
        RECORDING,
        PREVIEW,
    ];
    let simulation = state::View::Simulation.id();
    call.path.starts_with("/api/")
        || path.contains(&call.path)
        || (call.path == "/"
            && (call.field("tool").is_some() || call.field("check").is_some() || call.all("mark").nth(1).is_some()))
        || call.fields().filter(|(name, _)| name == "view").last().is_some_and(|(_, view)| view == simulation)
}

/// Path that keeps a recording and returns the project that uses it; its body is a line of fields and the file.
pub const RECORDING: &str = "/recording";

/// Path that shows a recording before it is used; its body is that of [`RECORDING`].
pub const PREVIEW: &str = "/recording/preview";

/// Largest number of bytes of a recording that a page accepts: a million samples of three quantities, as loggers write
/// them.
pub const RECORDING_BYTES_MAX: usize = 64 << 20;

/// Path of the progress of a work; a shell answers it while the work runs.
pub const PROGRESS: &str = "/progress";

/// Path that cancels a work; a shell answers it while the work runs.
pub const CANCEL: &str = "/cancel";

const HTML: &str = "text/html; charset=utf-8";
