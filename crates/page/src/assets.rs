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

#[cfg(test)]
mod tests {
    use super::*;

    /// The script of others is the one that was published as htmx 4.0.1 (`dist/htmx.min.js`), to the byte.
    #[test]
    fn the_script_of_others_is_as_it_was_published() {
        let sum = blake3::hash(HTMX.as_bytes()).to_hex();
        assert_eq!(sum.as_str(), "2b78dc2b44f6117680c5863fb5dd9a261c2a769feace82c358a295fe735c83e4");
    }

    /// What a browser fetches before it shows the first page, and its weight as it is sent, packed by nobody.
    #[test]
    fn the_page_stays_light() {
        assert!(CSS.len() + SCRIPT.len() + HTMX.len() < 80_000, "{}", CSS.len() + SCRIPT.len() + HTMX.len());
    }
}
