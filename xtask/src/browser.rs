//! The page in a real browser, with and without a server: package `browser`.

use std::path::{Path, PathBuf};

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed};
use crate::{site, tools};

/// The browser under the names that it has, and the program that drives it.
const CHROMIUM: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const DRIVER: [&str; 2] = ["chromedriver", "chromium.chromedriver"];

/// Goes the ways through the page that are named so, or all; the folder of `cargo xtask site` is built where it is missing.
///
/// # Errors
/// When there is no Chromium or no driver for it, something does not build, or a way fails.
pub fn run(root: &Path, names: &[String]) -> Result<(), Error> {
    let chromium = found(&CHROMIUM).ok_or(Error::NoBrowser { program: CHROMIUM[0] })?;
    let driver = found(&DRIVER).ok_or(Error::NoBrowser { program: DRIVER[0] })?;
    let axe = tools::axe(root)?;
    let folder = site::folder(root)?;
    if !folder.join("sw.js").is_file() {
        site::run(root)?;
    }
    must_succeed(&mut cargo(root, &["build", "--release", "--package", "antrieb"]))?;
    let program = format!("antrieb{}", std::env::consts::EXE_SUFFIX);
    let program = Workspace::ask(root)?.target.join("release").join(program);
    let mut command = cargo(root, &["run", "--quiet", "--package", "browser", "--"]);
    must_succeed(command.arg(program).arg(folder).arg(axe).arg(chromium).arg(driver).args(names))
}

/// The step of CI: the folder was built by the step before it.
pub(crate) fn step(root: &Path) -> Result<(), Error> {
    run(root, &[])
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
