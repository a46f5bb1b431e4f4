//! Steps of `ci` done by unmodified standard tools: spelling, links, licences. Their settings are in each tool's own
//! file at the root: `_typos.toml`, `lychee.toml`, `deny.toml`.

use std::path::Path;

use crate::Error;
use crate::cargo::must_succeed;
use crate::tidy::tree::Tree;
use crate::tools::{DENY, LYCHEE, TYPOS};
use crate::yanked;

pub(crate) fn typos(root: &Path) -> Result<(), Error> {
    must_succeed(TYPOS.command(root)?.args(["--color", "never"]))
}

/// Checks the links of the documents tracked by git; files in the target directory are excluded.
pub(crate) fn links(root: &Path) -> Result<(), Error> {
    let tree = Tree::read(root);
    must_succeed(LYCHEE.command(root)?.args(tree.under("", ".md")))
}

pub(crate) fn deny(root: &Path) -> Result<(), Error> {
    let words = ["--color", "never", "--workspace", "check", "--hide-inclusion-graph", "licenses", "bans", "sources"];
    must_succeed(DENY.command(root)?.args(words))?;
    yanked::check(root)
}
