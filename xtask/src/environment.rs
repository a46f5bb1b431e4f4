//! Environments of Python under `target/tools`, each with what its requirements pin.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, must_succeed};

/// An environment, named as the folder of its `requirements.txt` beside this crate's sources.
pub(crate) struct Environment {
    pub(crate) name: &'static str,
    /// The requirements, each with its sums.
    pub(crate) pinned: &'static str,
    /// What it means that it cannot be installed.
    pub(crate) missing: fn() -> Error,
}

/// An environment that is there.
pub(crate) struct Ready(PathBuf);

impl Ready {
    /// A program of it.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        let bin = self.0.join(if cfg!(windows) { "Scripts" } else { "bin" });
        bin.join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }
}

impl Environment {
    /// Installs it where it is not there yet, or holds something else.
    pub(crate) fn ready(&self, root: &Path) -> Result<Ready, Error> {
        let ready = Ready(Workspace::ask(root)?.target.join("tools").join(self.name));
        let whole = ready.0.join("whole");
        if fs::read_to_string(&whole).is_ok_and(|pinned| pinned == self.pinned) {
            return Ok(ready);
        }
        eprintln!("{}: installing {} …", self.name, self.name);
        let quiet = |command: &mut Command| must_succeed(command.stdin(Stdio::null())).map_err(|_| (self.missing)());
        let python = |python: &str| quiet(Command::new(python).args(["-m", "venv", "--clear"]).arg(&ready.0));
        python("python3").or_else(|_| python("python"))?;
        let mut pip = Command::new(ready.program("python"));
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-input", "--no-deps"]);
        pip.args(["--only-binary", ":all:", "--require-hashes", "--requirement"]);
        quiet(pip.arg(root.join("xtask").join(self.name).join("requirements.txt")))?;
        // An environment that is half installed is not found.
        fs::write(&whole, self.pinned).map_err(|source| Error::File { path: whole, source })?;
        Ok(ready)
    }
}
