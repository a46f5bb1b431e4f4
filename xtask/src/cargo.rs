//! Invocation of cargo, and its metadata about the workspace.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use cargo_metadata::{Metadata, MetadataCommand, Package};

use crate::Error;

/// Creates a cargo command in the repository's root, without colour.
pub(crate) fn cargo(root: &Path, args: &[&str]) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.args(args).current_dir(root).env("CARGO_TERM_COLOR", "never");
    command
}

/// Returns the path of a program of the workspace, built together with the tests.
///
/// cargo unifies the features of the packages built together: building one package alone would compile most
/// dependencies a second time.
pub(crate) fn program(root: &Path, name: &str) -> Result<PathBuf, Error> {
    must_succeed(&mut cargo(root, &["test", "--quiet", "--workspace", "--no-run"]))?;
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    Ok(Workspace::ask(root)?.target.join("debug").join(file))
}

/// Runs a command to its end, its output passed on.
pub(crate) fn must_succeed(command: &mut Command) -> Result<(), Error> {
    let status = command.status().map_err(|source| Error::NotStarted { command: spelled(command), source })?;
    if status.success() {
        return Ok(());
    }
    Err(Error::Failed { command: spelled(command), status: status.to_string() })
}

/// Returns the command as it would be typed.
pub(crate) fn spelled(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default();
    let mut text = program.to_string_lossy().into_owned();
    for word in command.get_args() {
        text.push(' ');
        text.push_str(&word.to_string_lossy());
    }
    text
}

/// Reads the cargo metadata of the tree at `root`.
pub(crate) fn metadata(
    root: &Path,
    set: impl FnOnce(&mut MetadataCommand) -> &mut MetadataCommand,
) -> Result<Metadata, Error> {
    let mut command = MetadataCommand::new();
    command.manifest_path(root.join("Cargo.toml"));
    set(&mut command).exec().map_err(|source| Error::Metadata { source: Box::new(source) })
}

/// Metadata of the workspace.
pub(crate) struct Workspace {
    pub(crate) packages: Vec<Package>,
    pub(crate) target: PathBuf,
}

impl Workspace {
    pub(crate) fn ask(root: &Path) -> Result<Self, Error> {
        let found = metadata(root, |command| command.no_deps())?;
        Ok(Self { packages: found.packages, target: found.target_directory.into_std_path_buf() })
    }

    /// Returns an error if a package required by a step is missing; a step is never skipped.
    pub(crate) fn require(&self, name: &'static str) -> Result<(), Error> {
        if self.packages.iter().any(|package| package.name == name) {
            return Ok(());
        }
        Err(Error::NoPackage { name })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_package_is_an_error_that_names_it() {
        let workspace = Workspace::ask(&crate::root()).unwrap();
        assert!(workspace.require("xtask").is_ok());
        let error = workspace.require("no-such-room").unwrap_err();
        assert_eq!(error.to_string(), "no package `no-such-room` in the workspace");
    }

    #[test]
    fn a_folder_without_a_workspace_is_an_error() {
        assert!(matches!(Workspace::ask(&crate::root().join("docs")), Err(Error::Metadata { .. })));
    }
}
