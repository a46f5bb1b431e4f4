//! Style and scripts. The third-party script is listed with version and licence in THIRD-PARTY.md.

use crate::call::Reply;

const CSS: &str = include_str!("../assets/page.css");
const SCRIPT: &str = include_str!("../assets/page.js");
const PANES: &str = include_str!("../assets/panes.js");
const PLOTS: &str = include_str!("../assets/plots.js");
const WAITING: &str = include_str!("../assets/waiting.js");
const FOLDER: &str = include_str!("../assets/folder.js");
const SKETCH: &str = include_str!("../assets/sketch.js");
const TOOLS: &str = include_str!("../assets/tools.js");
const HTMX: &str = include_str!("../assets/htmx.min.js");

/// The names of all files of the page, below `/assets/`.
pub const ASSETS: [&str; 9] =
    ["page.css", "page.js", "panes.js", "plots.js", "sketch.js", "waiting.js", "folder.js", "tools.js", "htmx.min.js"];

/// A file of the page.
pub(crate) fn asset(name: &str) -> Reply {
    const JAVASCRIPT: &str = "text/javascript; charset=utf-8";
    match name {
        "page.css" => Reply::of(200, "text/css; charset=utf-8", CSS),
        "page.js" => Reply::of(200, JAVASCRIPT, SCRIPT),
        "panes.js" => Reply::of(200, JAVASCRIPT, PANES),
        "plots.js" => Reply::of(200, JAVASCRIPT, PLOTS),
        "sketch.js" => Reply::of(200, JAVASCRIPT, SKETCH),
        "waiting.js" => Reply::of(200, JAVASCRIPT, WAITING),
        "folder.js" => Reply::of(200, JAVASCRIPT, FOLDER),
        "tools.js" => Reply::of(200, JAVASCRIPT, TOOLS),
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

    #[test]
    fn every_file_is_there() {
        assert!(ASSETS.iter().all(|name| asset(name).status == 200));
    }

    /// Scripts as they come over a line, packed; the promise to a slow one.
    #[test]
    fn the_page_stays_light() {
        let packed = |file: &str| {
            let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
            std::io::Write::write_all(&mut packer, file.as_bytes())
                .and_then(|()| packer.finish())
                .map_or(0, |bytes| bytes.len())
        };
        let weight: usize = [SCRIPT, PANES, FOLDER, TOOLS, PLOTS, SKETCH, WAITING, HTMX].into_iter().map(packed).sum();
        assert!((20_000..60_000).contains(&weight), "{weight}");
    }
}
