//! The steps of `ci` that cargo does: format, lints, documentation, the release build.

use std::path::Path;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};
use crate::tidy::layers::layer;

/// The highest layer that gets everything handed in.
const HANDED_IN_MAX: u8 = 6;
/// The highest layer without any thread.
const ONE_THREAD_MAX: u8 = 1;

pub(crate) fn fmt(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["fmt", "--all", "--check", "--", "--color=never"]))
}

/// The lints of the workspace, then what a layer must not reach for.
///
/// clippy takes one `clippy.toml` for a crate with its tests, its build script and all; so the bans of the layers stand in files
/// of their own that are put to the libraries alone.
pub(crate) fn clippy(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))?;
    let workspace = Workspace::ask(root)?;
    for (bans, highest) in [("outside-world", HANDED_IN_MAX), ("threads", ONE_THREAD_MAX)] {
        let names = workspace.packages.iter().map(|package| package.name.as_str());
        let mut command = cargo(root, &["clippy", "--quiet", "--lib", "--no-deps"]);
        for name in names.filter(|name| layer(name).is_some_and(|layer| layer <= highest)) {
            command.args(["--package", name]);
        }
        command.args(["--", "-D", "clippy::disallowed_types", "-D", "clippy::disallowed_methods"]);
        must_succeed(command.env("CLIPPY_CONF_DIR", root.join("xtask").join("clippy").join(bans)))?;
    }
    Ok(())
}

pub(crate) fn doc(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["doc", "--workspace", "--no-deps"]);
    must_succeed(command.env("RUSTDOCFLAGS", "-Dwarnings"))
}

pub(crate) fn release(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["build", "--release"]))
}
