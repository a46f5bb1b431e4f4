//! Tests of the page in a real browser, with and without a server: package `browser`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;
use crate::cargo::{Workspace, must_succeed, program};
use crate::{lint, site, tools};

/// Program names of a browser and of its driver.
struct Make {
    browser: &'static [&'static str],
    driver: &'static [&'static str],
}

const CHROMIUM: Make = Make {
    browser: &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"],
    driver: &["chromedriver", "chromium.chromedriver"],
};
const FIREFOX: Make = Make { browser: &["firefox", "firefox-esr"], driver: &["geckodriver"] };

/// Runs the browser tests with the given names, or all, in Chromium or, with `firefox` as the first word, in Firefox;
/// builds the folder of `cargo xtask site` if missing.
///
/// # Errors
/// When there is no such browser or no driver for it, something does not build, or a way fails.
pub fn run(root: &Path, names: &[String]) -> Result<(), Error> {
    match names.split_first() {
        Some((first, rest)) if first == "firefox" => with(root, &FIREFOX, rest),
        _ => with(root, &CHROMIUM, names),
    }
}

fn with(root: &Path, make: &Make, names: &[String]) -> Result<(), Error> {
    let browser = Browser::find(root, make)?;
    let folder = site::folder(root)?;
    if !folder.join("sw.js").is_file() {
        site::run(root)?;
    }
    lint::release(root)?;
    let antrieb = Workspace::ask(root)?.target.join("release").join(format!("antrieb{}", std::env::consts::EXE_SUFFIX));
    must_succeed(browser.command(root, &antrieb)?.arg("--site").arg(folder).args(names))
}

/// Runs the nightly step: every test, with and without a server, in both browsers.
pub(crate) fn both(root: &Path) -> Result<(), Error> {
    with(root, &CHROMIUM, &[])?;
    with(root, &FIREFOX, &[])
}

/// Runs the step of a push: the tests with a server but the long ones, with the program built with the tests.
pub(crate) fn served(root: &Path) -> Result<(), Error> {
    let browser = Browser::find(root, &CHROMIUM)?;
    must_succeed(&mut browser.command(root, &program(root, "antrieb")?)?)
}

/// Programs and scripts required by the browser tests.
struct Browser {
    browser: PathBuf,
    driver: PathBuf,
    axe: PathBuf,
}

impl Browser {
    fn find(root: &Path, make: &Make) -> Result<Self, Error> {
        let of = |names: &'static [&'static str]| {
            found(names).ok_or(Error::NoBrowser { program: names.first().copied().unwrap_or_default() })
        };
        Ok(Self { browser: of(make.browser)?, driver: of(make.driver)?, axe: tools::axe(root)? })
    }

    fn command(&self, root: &Path, antrieb: &Path) -> Result<Command, Error> {
        let mut command = Command::new(program(root, "browser")?);
        command.arg(antrieb).args([&self.axe, &self.browser, &self.driver]);
        Ok(command)
    }
}

/// Returns the first of these programs found on the `PATH`.
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
