//! The page for a browser that brings no token: a sentence, and the script that sends the token which the browser has kept.

use crate::call::Reply;
use maud::{DOCTYPE, html};
use quantities::Language;
use words::page;

/// Where files lie that are the same for everyone and hold nothing of a project: a shell may give them to a client without a token.
const OPEN_TO_ALL: [&str; 2] = ["/assets/", "/theory/"];

/// Returns `true` if a path leads to such a file.
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
