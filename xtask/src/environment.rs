//! Python environments under `target/tools` with pinned packages, and empty ones.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, must_succeed};

/// An environment with the packages of a list.
pub(crate) struct Environment {
    /// Name of the folder under `target/tools`.
    pub(crate) name: &'static str,
    /// Path of the list under `xtask`.
    pub(crate) list: &'static str,
    /// Content of the list, each package with its hashes.
    pub(crate) pinned: &'static str,
    /// Error if the packages cannot be installed.
    pub(crate) missing: fn() -> Error,
}

/// Folder of an installed environment.
pub(crate) struct Ready(PathBuf);

impl Environment {
    /// Installs the environment if it is missing or has other packages.
    pub(crate) fn ready(&self, root: &Path) -> Result<Ready, Error> {
        let folder = Workspace::ask(root)?.target.join("tools").join(self.name);
        let whole = folder.join("whole");
        if fs::read_to_string(&whole).is_ok_and(|pinned| pinned == self.pinned) {
            return Ok(Ready(folder));
        }
        eprintln!("{}: installing what xtask/{} lists …", self.name, self.list);
        let made = Ready::empty(folder, self.missing)?;
        let mut pip = made.pip();
        pip.args(["--only-binary", ":all:", "--require-hashes", "--requirement"]);
        must_succeed(pip.arg(root.join("xtask").join(self.list))).map_err(|_| (self.missing)())?;
        // Written last, so that a partly installed environment is not used.
        fs::write(&whole, self.pinned).map_err(|source| Error::File { path: whole, source })?;
        Ok(made)
    }
}

impl Ready {
    /// Creates an environment without packages.
    pub(crate) fn empty(folder: PathBuf, missing: fn() -> Error) -> Result<Self, Error> {
        let made = |python: &str| {
            let mut command = Command::new(python);
            must_succeed(command.args(["-m", "venv", "--clear"]).arg(&folder).stdin(Stdio::null()))
        };
        made("python3").or_else(|_| made("python")).map_err(|_| missing())?;
        Ok(Self(folder))
    }

    /// Returns the path of a program in the environment.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        let bin = self.0.join(if cfg!(windows) { "Scripts" } else { "bin" });
        bin.join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }

    /// Installs a wheel without its dependencies.
    pub(crate) fn install(&self, wheel: &Path) -> Result<(), Error> {
        must_succeed(self.pip().args(["--no-index", "--force-reinstall"]).arg(wheel))
    }

    fn pip(&self) -> Command {
        let mut pip = Command::new(self.program("python"));
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-input", "--no-deps"]);
        pip.stdin(Stdio::null()).env("PIP_ROOT_USER_ACTION", "ignore");
        pip
    }
}
