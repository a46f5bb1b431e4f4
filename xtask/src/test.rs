//! `cargo xtask test`, a step of `ci` too: every test of the workspace, the runners' closing lines on stdout.
//!
//! cargo-nextest runs the tests, each in its own process with a time limit; documentation examples are run by cargo.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};
use crate::tidy::tree::Tree;
use crate::tools::NEXTEST;

/// Runs every test; installs cargo-nextest if missing.
///
/// # Errors
/// A test that fails or is skipped, a runner that does not start.
pub fn run(root: &Path) -> Result<(), Error> {
    let mut closing = Closing::default();
    NEXTEST.ready(root).ok();
    match NEXTEST.command(root) {
        Ok(nextest) => {
            closing.nextest(nextest, root)?;
            let mut examples = cargo(root, &["test", "--doc", "--no-fail-fast"]);
            examples.args(with_examples(root)?.iter().flat_map(|name| ["--package", name]));
            closing.cargo_test(examples, root)?;
        }
        Err(error) if crate::tools::is_ci() => return Err(error),
        Err(error) => {
            eprintln!("test: {error}; `cargo test` runs the tests instead, without a limit in time");
            closing.cargo_test(cargo(root, &["test", "--workspace", "--no-fail-fast"]), root)?;
        }
    }
    println!("tests: {closing}");
    closing.verdict()
}

/// Returns the packages whose documentation has examples: rustdoc reads every other one for nothing.
fn with_examples(root: &Path) -> Result<Vec<String>, Error> {
    let tree = Tree::read(root);
    let is_example = |line: &str| {
        let line = line.trim_start();
        line.strip_prefix("///").or_else(|| line.strip_prefix("//!")).is_some_and(|text| text.trim_start() == "```")
    };
    let has_example = |file: &str| tree.text(file).is_some_and(|text| text.lines().any(is_example));
    let packages = Workspace::ask(root)?.packages.into_iter().filter(|package| {
        let folder = package.manifest_path.parent().and_then(|folder| folder.as_std_path().strip_prefix(root).ok());
        let sources = folder.map(|folder| folder.join("src").to_string_lossy().into_owned());
        let is_tested = package.targets.iter().any(|target| target.doctest);
        is_tested && sources.is_some_and(|sources| tree.under(&sources, ".rs").any(has_example))
    });
    Ok(packages.map(|package| package.name.to_string()).collect())
}

/// Number of saves begun per signal in a night; about six of ten are killed before they end, a thousand in total.
const KILLS: &str = "1800";

/// Number of sweeps killed in a night, for each format of the answers.
const SWEEP_KILLS: &str = "60";

/// Runs the nightly campaign against a saving program, which loses no file when killed at any instant by each signal,
/// and against sweeps, each of which continues the one that was killed.
///
/// # Errors
/// A save that left a partial file, a sweep with different bytes.
pub(crate) fn kills(root: &Path) -> Result<(), Error> {
    let mut sweeps = cargo(root, &["test", "--package", "antrieb", "--test", "it", "at_any_moment"]);
    must_succeed(sweeps.args(["--", "--nocapture"]).env("ANTRIEB_SWEEP_KILLS", SWEEP_KILLS))?;
    let mut command = cargo(root, &["test", "--package", "antrieb", "--test", "it", "at_any_instant"]);
    must_succeed(command.args(["--", "--nocapture", "--test-threads", "1"]).env("ANTRIEB_SAVE_RUNS", KILLS))
}

/// Runs the digital twin of an axis for a day: 24 hours of cycles without drift, NaN or growing memory.
///
/// # Errors
/// A bound that is exceeded.
pub(crate) fn day(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["test", "--package", "twin", "--test", "it", "hours_of_cycles"]);
    must_succeed(command.args(["--", "--nocapture"]).env("ANTRIEB_TWIN_HOURS", "24"))
}

/// Sets the environment of every test run: no snapshot is rewritten, and the workspace root is given.
fn set(command: &mut Command, root: &Path) {
    command.env("INSTA_UPDATE", "no").env_remove("INSTA_FORCE_PASS").env("CI", "true");
    command.env("INSTA_WORKSPACE_ROOT", root);
}

/// Sum of all closing lines.
#[derive(Default)]
struct Closing {
    lines: u64,
    passed: u64,
    failed: u64,
    skipped: u64,
    /// Failed runs, as typed, with their status.
    broken: Vec<(String, String)>,
}

impl Closing {
    /// Runs nextest, which writes to stderr (passed on); its summary also goes to stdout.
    fn nextest(&mut self, mut command: Command, root: &Path) -> Result<(), Error> {
        command.args(["nextest", "run", "--workspace", "--no-fail-fast", "--cargo-quiet", "--color", "never"]);
        command.args(["--show-progress", "none"]).stderr(Stdio::piped());
        set(&mut command, root);
        self.watch(
            command,
            |child| child.stderr.take(),
            |closing, line| {
                eprintln!("{line}");
                if closing.add(line) {
                    println!("{}", line.trim());
                }
            },
        )
    }

    /// Runs `cargo test`, which writes a line per test to stdout: only the failures are printed, at the end.
    fn cargo_test(&mut self, mut command: Command, root: &Path) -> Result<(), Error> {
        command.stdout(Stdio::piped());
        set(&mut command, root);
        let before = self.broken.len();
        let mut talk = Vec::new();
        self.watch(
            command,
            |child| child.stdout.take(),
            |closing, line| {
                if closing.add(line) {
                    println!("{line}");
                } else if !is_good_news(line) {
                    talk.push(line.to_owned());
                }
            },
        )?;
        if self.broken.len() > before {
            eprintln!("{}", talk.join("\n"));
        }
        Ok(())
    }

    fn watch<R: Read>(
        &mut self,
        mut command: Command,
        stream: impl Fn(&mut std::process::Child) -> Option<R>,
        mut hear: impl FnMut(&mut Self, &str),
    ) -> Result<(), Error> {
        let not_started = |command: &Command, source| Error::NotStarted { command: spelled(command), source };
        let mut child = command.spawn().map_err(|source| not_started(&command, source))?;
        if let Some(stream) = stream(&mut child) {
            for line in BufReader::new(stream).split(b'\n').map_while(Result::ok) {
                hear(self, &String::from_utf8_lossy(&line));
            }
        }
        let status = child.wait().map_err(|source| not_started(&command, source))?;
        if !status.success() {
            self.broken.push((spelled(&command), status.to_string()));
        }
        Ok(())
    }

    /// Adds a closing line and returns `true`; returns `false` for any other line.
    fn add(&mut self, line: &str) -> bool {
        let line = line.trim();
        let counts = match line.strip_prefix("Summary [") {
            Some(rest) => {
                rest.split_once("tests run: ").or_else(|| rest.split_once("test run: ")).map(|(_, counts)| counts)
            }
            None => line.strip_prefix("test result: "),
        };
        let Some(counts) = counts else { return false };
        self.lines += 1;
        let mut before = "";
        for word in counts.split([' ', ';', ',', '(', ')']) {
            let count = || before.parse::<u64>().unwrap_or(0);
            match word {
                "passed" => self.passed += count(),
                // nextest counts tests that timed out or did not start separately.
                "failed" | "timed" | "exec" => self.failed += count(),
                "ignored" | "skipped" => self.skipped += count(),
                _ => {}
            }
            before = word;
        }
        true
    }

    fn verdict(&self) -> Result<(), Error> {
        if let Some((command, status)) = self.broken.first() {
            return Err(Error::Failed { command: command.clone(), status: status.clone() });
        }
        if self.lines == 0 {
            return Err(Error::NoTests);
        }
        if self.skipped > 0 {
            return Err(Error::Ignored { count: self.skipped });
        }
        Ok(())
    }
}

/// Returns `true` for lines that would hide a failure among hundreds of tests.
fn is_good_news(line: &str) -> bool {
    line.is_empty() || line.starts_with("running ") || (line.starts_with("test ") && line.ends_with(" ok"))
}

impl std::fmt::Display for Closing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} passed, {} failed, {} skipped", self.passed, self.failed, self.skipped)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Packages with an example in their documentation, and no other ones.
    #[test]
    fn only_packages_with_examples_are_documented_tests() {
        let found = with_examples(&crate::root()).unwrap();
        for name in ["quantities", "order-code", "recording", "plot"] {
            assert!(found.iter().any(|package| package == name), "{name}: {found:?}");
        }
        assert!(found.len() < 15 && !found.iter().any(|package| package == "xtask"), "{found:?}");
    }

    #[test]
    fn closing_lines_are_summed() {
        let mut closing = Closing::default();
        assert!(!closing.add("test tidy ... ok"));
        assert!(closing.add("test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out"));
        assert!(closing.add("test result: FAILED. 2 passed; 1 failed; 0 ignored; 0 measured"));
        assert!(
            closing.add("     Summary [   1.402s] 9 tests run: 7 passed (1 slow), 1 failed, 1 timed out, 0 skipped")
        );
        assert_eq!(closing.to_string(), "12 passed, 3 failed, 0 skipped");
        assert!(closing.verdict().is_ok());
    }

    #[test]
    fn a_failure_is_no_good_news() {
        assert!(is_good_news("test tidy ... ok") && is_good_news("running 3 tests"));
        assert!(!is_good_news("test tidy ... FAILED") && !is_good_news("thread 'tidy' panicked at a.rs:1:1:"));
    }

    #[test]
    fn a_test_passed_over_fails_the_step() {
        for line in
            ["test result: ok. 3 passed; 0 failed; 2 ignored", "Summary [ 1.4s] 1 test run: 1 passed, 2 skipped"]
        {
            let mut closing = Closing::default();
            assert!(closing.add(line));
            assert!(matches!(closing.verdict(), Err(Error::Ignored { count: 2 })), "{line}");
        }
    }

    #[test]
    fn no_tests_at_all_fail_the_step() {
        assert!(matches!(Closing::default().verdict(), Err(Error::NoTests)));
    }

    #[test]
    fn a_runner_that_ends_badly_fails_the_step() {
        let mut closing = Closing { lines: 1, ..Closing::default() };
        closing.cargo_test(cargo(&crate::root(), &["no-such-command"]), &crate::root()).unwrap();
        assert!(matches!(closing.verdict(), Err(Error::Failed { .. })));
    }
}
