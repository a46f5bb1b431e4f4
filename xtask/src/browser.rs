//! The page in a real browser, with and without a server: package `browser`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;
use crate::cargo::{Workspace, must_succeed, program};
use crate::{lint, site, tools};

/// The browser under the names that it has, and the program that drives it.
const CHROMIUM: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const DRIVER: [&str; 2] = ["chromedriver", "chromium.chromedriver"];

/// Goes the ways through the page that are named so, or all; the folder of `cargo xtask site` is built where it is missing.
///
/// # Errors
/// When there is no Chromium or no driver for it, something does not build, or a way fails.
pub fn run(root: &Path, names: &[String]) -> Result<(), Error> {
    let browser = Browser::find(root)?;
    let folder = site::folder(root)?;
    if !folder.join("sw.js").is_file() {
        site::run(root)?;
    }
    lint::release(root)?;
    let antrieb = Workspace::ask(root)?.target.join("release").join(format!("antrieb{}", std::env::consts::EXE_SUFFIX));
    must_succeed(browser.command(root, &antrieb)?.arg("--site").arg(folder).args(names))
}

/// The step of a night: every way, with a server and without one.
pub(crate) fn both(root: &Path) -> Result<(), Error> {
    run(root, &[])
}

/// The step of a push: every way with a server, the one that the tests have built.
pub(crate) fn served(root: &Path) -> Result<(), Error> {
    let browser = Browser::find(root)?;
    must_succeed(&mut browser.command(root, &program(root, "antrieb")?)?)
}

/// What the tests of the page need beside the workspace.
struct Browser {
    chromium: PathBuf,
    driver: PathBuf,
    axe: PathBuf,
}

impl Browser {
    fn find(root: &Path) -> Result<Self, Error> {
        Ok(Self {
            chromium: found(&CHROMIUM).ok_or(Error::NoBrowser { program: CHROMIUM[0] })?,
            driver: found(&DRIVER).ok_or(Error::NoBrowser { program: DRIVER[0] })?,
            axe: tools::axe(root)?,
        })
    }

    fn command(&self, root: &Path, antrieb: &Path) -> Result<Command, Error> {
        let mut command = Command::new(program(root, "browser")?);
        command.arg(antrieb).args([&self.axe, &self.chromium, &self.driver]);
        Ok(command)
    }
}

/// The first of these programs that is on the `PATH`.
fn found(names: &[&str]) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let all = |name: &&str| {
        let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
        std::env::split_paths(&path).map(move |folder| folder.join(&file)).find(|program| program.is_file())
    };
    names.iter().find_map(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_found_where_the_path_leads() {
        assert!(found(&["no-such-program", "cargo"]).is_some_and(|path| path.ends_with("cargo")));
        assert_eq!(found(&["no-such-program"]), None);
    }
}
