//! Files of the folder: the first page, the engine, and the assets of the page.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use maud::{DOCTYPE, PreEscaped, html};
use page::{Call, Method, respond};
use quantities::Language;
use questions::Progress;
use std::io::Write;
use words::requests;

/// Permitted sources and connections: none external. The page itself creates the worker and, in a folder opened as a
/// file, the modules (`blob:`).
const POLICY: &str = "default-src 'self'; img-src 'self' data: blob:; style-src 'self'; \
    script-src 'self' blob: 'wasm-unsafe-eval'; worker-src 'self' blob:; connect-src 'self'; base-uri 'none'; \
    form-action 'self'; object-src 'none'";

/// Script with the larger engine.
const PACKED: &str = "interface.js";

const SITE_JS: &str = include_str!("../assets/site.js");
const WORKER_JS: &str = include_str!("../assets/sw.js");

/// Returns the files with their paths in the folder, for the engine and the larger one that includes the interface.
///
/// # Errors
/// Errors while packing the engine.
pub fn files([engine, interface]: [&[u8]; 2], notices: &str) -> std::io::Result<Vec<(String, Vec<u8>)>> {
    let mut files = vec![
        ("index.html".to_owned(), index().into_bytes()),
        ("site.js".to_owned(), SITE_JS.into()),
        ("engine.wasm".to_owned(), engine.to_vec()),
        ("interface.wasm".to_owned(), interface.to_vec()),
        (PACKED.to_owned(), packed(interface)?.into_bytes()),
        ("THIRD-PARTY.md".to_owned(), notices.into()),
    ];
    let assets = page::ASSETS.iter().map(|(name, _)| format!("assets/{name}"));
    for name in assets.chain(page::theory_files()) {
        let path = format!("/{name}");
        let call =
            Call { method: Method::Get, path: &path, query: "", media: None, body: &[], language: Language::default() };
        let reply = respond(&call, &crate::Store::default(), &Progress::endless());
        files.push((name, reply.body));
    }
    files.extend(page::FONTS.iter().map(|(name, font)| (format!("assets/{name}"), font.to_vec())));
    let worker = kept(&files);
    files.push(("sw.js".to_owned(), worker.into_bytes()));
    Ok(files)
}

/// Returns the page shown until the engine has answered.
fn index() -> String {
    let both = |word: fn(Language) -> &'static str| html! { @for l in Language::ALL { p lang=(l.id()) { (word(l)) } } };
    let policy = html! {
        meta http-equiv="content-security-policy" content=(PreEscaped(POLICY));
        meta name="referrer" content="same-origin";
    };
    let scripts = html! {
        link rel="preload" as="script" href="assets/htmx.min.js";
        @for l in Language::ALL {
            template lang=(l.id()) data-failed=(requests::failed_inside(l)) data-full=(words::page::browser_keeps_nothing(l))
                data-none=(words::page::no_engine(l)) {}
        }
        script src="site.js" {}
    };
    html! {
        (DOCTYPE)
        html lang="en" {
            (page::head(&policy, words::page::title(Language::default()), "assets/page.css", &scripts))
            body {
                header { h1 { "antrieb" } }
                main.start id="waiting" role="status" { (both(words::page::engine_comes)) noscript { (both(words::page::needs_scripts)) } }
            }
        }
    }
    .into_string()
}

/// Returns the packed engine as text in a script.
fn packed(engine: &[u8]) -> std::io::Result<String> {
    let mut packer = DeflateEncoder::new(Vec::new(), Compression::best());
    packer.write_all(engine)?;
    Ok(format!("self.antriebEngine='{}';\n", STANDARD.encode(packer.finish()?)))
}

/// Returns the service worker script; its version is derived from the content of the files.
fn kept(files: &[(String, Vec<u8>)]) -> String {
    let mut version = blake3::Hasher::new();
    let mut names = vec!["./"];
    for (name, bytes) in files {
        let _ = version.update(name.as_bytes()).update(&(bytes.len() as u64).to_le_bytes()).update(bytes);
        // Only a folder opened as a file needs the packed engine, and it has no service worker.
        if name != PACKED {
            names.push(name);
        }
    }
    let version: String = version.finalize().to_hex().chars().take(16).collect();
    WORKER_JS.replace("@version@", &version).replace("@files@", &serde_json::json!(names).to_string())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;

    fn text(files: &[(String, Vec<u8>)], name: &str) -> String {
        let found = files.iter().find(|(path, _)| path == name).unwrap();
        String::from_utf8(found.1.clone()).unwrap()
    }

    #[test]
    fn every_path_is_relative_and_there() {
        let files = files([b"engine", b"interface"], "notices").unwrap();
        let index = text(&files, "index.html");
        for (mark, end) in [("href=\"", '"'), ("src=\"", '"')] {
            for path in index.split(mark).skip(1).filter_map(|rest| rest.split(end).next()) {
                assert!(path.starts_with("data:") || files.iter().any(|(name, _)| name == path), "{path}");
            }
        }
        let worker = text(&files, "sw.js");
        assert!(
            !worker.contains('@') && worker.contains("\"./\"") && worker.contains("\"assets/page.js\""),
            "{worker}"
        );
        assert!(!index.contains("<style") && !index.contains(" style=") && !index.contains(" on"), "{index}");
    }

    #[test]
    fn another_engine_is_another_version() {
        let version = |engine: &[u8]| {
            text(&files([engine, b"interface"], "").unwrap(), "sw.js").lines().nth(1).unwrap().to_owned()
        };
        assert_eq!(version(b"one"), version(b"one"));
        assert_ne!(version(b"one"), version(b"two"));
    }
}
