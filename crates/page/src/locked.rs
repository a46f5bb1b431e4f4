//! The page for a browser without a token: a sentence, and the script that sends the token stored in the browser.

use crate::call::Reply;
use maud::{DOCTYPE, Markup, html};
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
    sentence(401, &script, (message, None), language)
}

/// Returns a page with a sentence in place of the one that was requested, and a link to the start page.
pub(crate) fn with_way_back(status: u16, message: &str, language: Language) -> Reply {
    let start = format!("/?lang={}", language.id());
    sentence(status, &html! {}, (message, Some(&start)), language)
}

fn sentence(status: u16, script: &Markup, (message, start): (&str, Option<&str>), language: Language) -> Reply {
    let head = crate::frame::head(&html! {}, page::title(language), "/assets/page.css", script);
    let page = html! {
        (DOCTYPE)
        html lang=(language.id()) data-locked[status == 401] { (head) body { main.start {
            h1 { "antrieb" }
            p role="status" { (message) }
            @if let Some(start) = start { p { a href=(start) { (page::to_the_start(language)) } } }
        } } }
    };
    Reply::of(status, crate::HTML, page.into_string())
}
