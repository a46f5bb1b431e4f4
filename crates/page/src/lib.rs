//! The web workbench as a pure function: a request in, HTML or JSON out.
//!
//! It knows no socket and no file. A shell hands in what it has of the world ([`Shell`]): the server that `antrieb serve`
//! starts, or the browser itself, where the engine runs as WebAssembly. Both give the same bytes. Nothing is computed here,
//! and no sentence written: the numbers are of `workbench`, the texts of `words`.

mod api;
mod assets;
mod call;
mod chapters;
mod demand;
mod detail;
mod files;
mod fits;
mod form;
mod frame;
mod sketch;
mod start;
mod state;

pub use api::{methods, misdirected, wrong_method};
pub use call::{Call, Entry, Folder, Method, Reply, ReportAsked, SaveFault, Shell, WritesReport};

use workbench::Patience;

/// Answers a request.
#[must_use]
pub fn respond(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    if let Some(name) = call.path.strip_prefix("/assets/") {
        return assets::asset(name);
    }
    if api::is_path(call.path) {
        return api::respond(call, shell, patience);
    }
    let html = |page: maud::Markup| Reply::of(200, HTML, page.into_string());
    match (call.method, call.path) {
        (Method::Get, "/health") => Reply::text(200, "ok\n"),
        (Method::Get, "/") if call.field("open").is_some() => files::opened(call, shell, patience),
        (_, "/") => html(frame::whole(call, shell, patience)),
        (Method::Get, "/begin") => html(start::asked(files::place(call), call.language())),
        (Method::Post, "/begin") => files::begun(call, shell, patience),
        (Method::Post, "/work") => html(frame::work(state::State::of(call), shell, patience)),
        (Method::Post, "/explain") => html(frame::explained(call, shell, patience)),
        (Method::Post, "/compare") => html(frame::compared(call, shell, patience)),
        (Method::Post, "/tools") => html(chapters::tools(call)),
        (Method::Post, "/save") => files::saved(call, shell),
        (Method::Post, RECORDING) => files::recorded(call, shell),
        _ => Reply::text(404, workbench::text::page::no_such_page(call.language())),
    }
}

/// Where a recording is brought; its body may be larger than that of others.
pub const RECORDING: &str = "/recording";

const HTML: &str = "text/html; charset=utf-8";
