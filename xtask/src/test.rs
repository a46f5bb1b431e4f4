//! The test step of `ci`: every test of the workspace, the runner's closing lines on stdout.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;

use crate::Error;
use crate::cargo::{cargo, spelled};

pub(crate) fn run(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["test", "--workspace", "--no-fail-fast"]);
    command.env("INSTA_UPDATE", "no").env_remove("INSTA_FORCE_PASS").env("CI", "true").stdout(Stdio::piped());
    let mut child = command.spawn().map_err(|source| Error::NotStarted { command: spelled(&command), source })?;

    let mut closing = Closing::default();
    let mut talk = Vec::new();
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).split(b'\n').map_while(Result::ok) {
            let line = String::from_utf8_lossy(&line).into_owned();
            if closing.add(&line) {
                println!("{line}");
            } else if !is_good_news(&line) {
                talk.push(line);
            }
        }
    }
    let status = child.wait().map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
    println!("tests: {closing}");
    if !status.success() {
        eprintln!("{}", talk.join("\n"));
        return Err(Error::Failed { command: spelled(&command), status: status.to_string() });
    }
    closing.verdict()
}

/// Lines that would bury the one failure among hundreds of tests.
fn is_good_news(line: &str) -> bool {
    line.is_empty() || line.starts_with("running ") || (line.starts_with("test ") && line.ends_with(" ok"))
}

/// The sum of all `test result:` lines.
#[derive(Default)]
struct Closing {
    lines: u64,
    passed: u64,
    failed: u64,
    ignored: u64,
}

impl Closing {
    /// Adds a line if it is a closing one, and says whether it was.
    fn add(&mut self, line: &str) -> bool {
        let Some(counts) = line.strip_prefix("test result: ") else { return false };
        self.lines += 1;
        let mut before = "";
        for word in counts.split([' ', ';']) {
            let count = || before.parse::<u64>().unwrap_or(0);
            match word {
                "passed" => self.passed += count(),
                "failed" => self.failed += count(),
                "ignored" => self.ignored += count(),
                _ => {}
            }
            before = word;
        }
        true
    }

    fn verdict(&self) -> Result<(), Error> {
        if self.lines == 0 {
            return Err(Error::NoTests);
        }
        if self.ignored > 0 {
            return Err(Error::Ignored { count: self.ignored });
        }
        Ok(())
    }
}

impl std::fmt::Display for Closing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} passed, {} failed, {} ignored", self.passed, self.failed, self.ignored)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closing_lines_are_summed() {
        let mut closing = Closing::default();
        assert!(!closing.add("test tidy ... ok"));
        assert!(closing.add("test result: ok. 3 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out"));
        assert!(closing.add("test result: FAILED. 2 passed; 1 failed; 0 ignored; 0 measured"));
        assert_eq!(closing.to_string(), "5 passed, 1 failed, 0 ignored");
        assert!(closing.verdict().is_ok());
    }

    #[test]
    fn a_failure_is_no_good_news() {
        assert!(is_good_news("test tidy ... ok") && is_good_news("running 3 tests"));
        assert!(!is_good_news("test tidy ... FAILED") && !is_good_news("thread 'tidy' panicked at a.rs:1:1:"));
    }

    #[test]
    fn an_ignored_test_fails_the_step() {
        let mut closing = Closing::default();
        closing.add("test result: ok. 3 passed; 0 failed; 2 ignored; 0 measured");
        assert!(matches!(closing.verdict(), Err(Error::Ignored { count: 2 })));
    }

    #[test]
    fn no_tests_at_all_fail_the_step() {
        assert!(matches!(Closing::default().verdict(), Err(Error::NoTests)));
    }
}
