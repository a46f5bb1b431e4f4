//! Style and scripts. The script of others is told with version and licence in THIRD-PARTY.md.

use crate::call::Reply;

const CSS: &str = include_str!("../assets/page.css");
const SCRIPT: &str = include_str!("../assets/page.js");
const HTMX: &str = include_str!("../assets/htmx.min.js");

/// A file of the page.
pub(crate) fn asset(name: &str) -> Reply {
    const JAVASCRIPT: &str = "text/javascript; charset=utf-8";
    match name {
        "page.css" => Reply::of(200, "text/css; charset=utf-8", CSS),
        "page.js" => Reply::of(200, JAVASCRIPT, SCRIPT),
        "htmx.min.js" => Reply::of(200, JAVASCRIPT, HTMX),
        _ => Reply::text(404, ""),
    }
}
