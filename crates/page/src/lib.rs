//! The web workbench as a pure function: a request in, HTML or JSON out.
//!
//! It knows no socket and no file. A shell hands in what it has of the world ([`Shell`]): the server that `antrieb serve`
//! starts, or the browser itself, where the engine runs as WebAssembly. Both give the same bytes. Nothing is computed here,
//! and no sentence written: the numbers are of `workbench`, the texts of `words`.

mod api;
mod call;

pub use api::{methods, misdirected, wrong_method};
pub use call::{Call, Entry, Folder, Method, Reply, SaveFault, Shell};

use workbench::Patience;

/// Answers a request.
#[must_use]
pub fn respond(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    match call.path {
        path if api::is_path(path) => api::respond(call, shell, patience),
        "/health" => Reply::text(200, "ok\n"),
        _ => Reply::text(404, ""),
    }
}
