//! Files of the tree that the program writes: reference pages, the modules of the Python package.

use std::path::Path;

/// Checks that a file of the tree is the one that the program writes now. With `INSTA_UPDATE=always`, which
/// `cargo xtask snapshots` sets, it is written anew.
///
/// # Panics
/// If the file differs or cannot be written: its test must fail.
#[allow(clippy::panic, clippy::expect_used, reason = "a file that is out of date must fail its test")]
pub fn is_current(file: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    if std::env::var_os("INSTA_UPDATE").is_some_and(|value| value == "always") {
        std::fs::write(&path, text).expect("the file can be written");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(stored == text, "{file} is out of date: cargo xtask snapshots writes it anew");
}
