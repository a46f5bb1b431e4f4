//! Running cargo and asking it what the workspace holds.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;

/// A cargo command in the repository's root, without colour.
pub(crate) fn cargo(root: &Path, args: &[&str]) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.args(args).current_dir(root).env("CARGO_TERM_COLOR", "never");
    command
}

/// Runs a command to its end, its output passed on.
pub(crate) fn must_succeed(command: &mut Command) -> Result<(), Error> {
    let status = command.status().map_err(|source| Error::NotStarted { command: spelled(command), source })?;
    if status.success() {
        return Ok(());
    }
    Err(Error::Failed { command: spelled(command), status: status.to_string() })
}

/// The command as a person would type it.
pub(crate) fn spelled(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default();
    let mut text = program.to_string_lossy().into_owned();
    for word in command.get_args() {
        text.push(' ');
        text.push_str(&word.to_string_lossy());
    }
    text
}

/// What `cargo metadata` says about the workspace.
pub(crate) struct Workspace {
    packages: Vec<String>,
    pub(crate) target: PathBuf,
}

impl Workspace {
    pub(crate) fn ask(root: &Path) -> Result<Self, Error> {
        let mut command = cargo(root, &["metadata", "--no-deps", "--format-version", "1"]);
        let output = command
            .stderr(Stdio::inherit())
            .output()
            .map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
        if !output.status.success() {
            let status = output.status.to_string();
            return Err(Error::Failed { command: spelled(&command), status });
        }
        Self::parse(&output.stdout)
    }

    fn parse(json: &[u8]) -> Result<Self, Error> {
        let document: serde_json::Value = serde_json::from_slice(json).map_err(|_| Error::Metadata { entry: "." })?;
        let packages = document
            .get("packages")
            .and_then(|list| list.as_array())
            .ok_or(Error::Metadata { entry: "packages" })?
            .iter()
            .map(|package| package.get("name").and_then(|name| name.as_str()).map(String::from))
            .collect::<Option<Vec<String>>>()
            .ok_or(Error::Metadata { entry: "packages.name" })?;
        let target = document
            .get("target_directory")
            .and_then(|path| path.as_str())
            .map(PathBuf::from)
            .ok_or(Error::Metadata { entry: "target_directory" })?;
        Ok(Self { packages, target })
    }

    /// A step that needs a package fails without it; it is never skipped.
    pub(crate) fn require(&self, name: &'static str) -> Result<(), Error> {
        if self.packages.iter().any(|package| package == name) {
            return Ok(());
        }
        Err(Error::NoPackage { name })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const METADATA: &[u8] = br#"{"packages":[{"name":"antrieb"},{"name":"xtask"}],"target_directory":"t"}"#;

    #[test]
    fn a_missing_package_is_an_error_that_names_it() {
        let workspace = Workspace::parse(METADATA).unwrap();
        assert!(workspace.require("antrieb").is_ok());
        let error = workspace.require("fuzz").unwrap_err();
        assert_eq!(error.to_string(), "no package `fuzz` in the workspace");
    }

    #[test]
    fn metadata_without_packages_is_an_error() {
        assert!(Workspace::parse(br#"{"target_directory":"t"}"#).is_err());
        assert!(Workspace::parse(b"warning: no").is_err());
    }

    #[test]
    fn the_real_workspace_names_this_package() {
        let workspace = Workspace::ask(&crate::root()).unwrap();
        assert!(workspace.require("xtask").is_ok());
    }
}
