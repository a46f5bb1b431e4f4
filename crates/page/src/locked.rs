//! The page for a browser without a token: a sentence, and the script that sends the token stored in the browser.

use crate::call::Reply;
use maud::{DOCTYPE, html};
use quantities::Language;
use words::page;

/// Folders of the files that are the same for all clients and contain nothing of a project: a shell may send them to a
/// client without a token.
const OPEN_TO_ALL: [&str; 2] = ["/assets/", "/theory/"];

/// Returns `true` if a path leads to a file that is open to all clients.
#[must_use]
pub fn is_open_to_all(path: &str) -> bool {
    OPEN_TO_ALL.iter().any(|folder| path.starts_with(folder))
}

/// Returns the page with a sentence in place of the one that was requested.
#[must_use]
pub fn locked(message: &str, language: Language) -> Reply {
    let script = html! { script src="/assets/enter.js" defer {} };
    let head = crate::frame::head(&html! {}, page::title(language), "/assets/page.css", &script);
    let page = html! {
        (DOCTYPE)
        html lang=(language.id()) data-locked { (head) body { main.start role="status" { p { (message) } } } }
    };
    Reply::of(401, crate::HTML, page.into_string())
}
