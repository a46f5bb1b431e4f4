//! The page without a server: the engine that runs in the browser, and the few files around it.
//!
//! `page` answers; this crate passes requests of the browser to it and its replies back, as bytes ([`PageEngine`]). The
//! working folder is in memory ([`Store`]); the script of the page stores its files in the browser.

mod engine;
mod exports;
#[cfg(not(target_family = "wasm"))]
mod folder;
mod store;

pub use engine::PageEngine;
#[cfg(not(target_family = "wasm"))]
pub use folder::files;
pub use store::Store;
