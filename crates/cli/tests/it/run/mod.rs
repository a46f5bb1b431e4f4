//! Runs the binary as a user does, from the root of the repository.

#![allow(dead_code, reason = "the tests of the quick program use a part of it")]
#![allow(clippy::unwrap_used, reason = "a test that cannot panic cannot fail")]

use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

pub(crate) struct Run {
    pub(crate) out: String,
    pub(crate) err: String,
    pub(crate) code: i32,
}

pub(crate) fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns the project files of the examples, sorted, from the root.
pub(crate) fn examples() -> Vec<String> {
    let entries = std::fs::read_dir(root().join("examples")).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut found: Vec<String> =
        names.filter(|name| name.ends_with(".toml")).map(|name| format!("examples/{name}")).collect();
    found.sort();
    assert!(found.len() > 8, "{found:?}");
    found
}

/// Returns the number of samples of the tolerances of a project; nothing for one without tolerances.
pub(crate) fn few_samples(project: &str) -> &'static [&'static str] {
    if project.contains("tolerances") { &["--samples", "50"] } else { &[] }
}

pub(crate) fn run(arguments: &[&str]) -> Run {
    run_with(arguments, b"")
}

pub(crate) fn run_with(arguments: &[&str], input: &[u8]) -> Run {
    run_as(arguments, input, "100")
}

/// Runs in a folder.
pub(crate) fn run_at(folder: &std::path::Path, arguments: &[&str]) -> Run {
    ended(command(arguments).current_dir(folder), b"")
}

/// Runs on a terminal of `columns` columns.
pub(crate) fn run_in(arguments: &[&str], columns: &str) -> Run {
    run_as(arguments, b"", columns)
}

/// The program of the package whose tests these are.
const PROGRAM: &str = match (option_env!("CARGO_BIN_EXE_antrieb"), option_env!("CARGO_BIN_EXE_antrieb-quick")) {
    (Some(program), _) | (None, Some(program)) => program,
    (None, None) => "antrieb",
};

/// The program as it is without settings of the machine, its streams at hand.
fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command
        .args(arguments)
        .current_dir(root())
        .env_remove("ANTRIEB_LANG")
        .env_remove("ANTRIEB_MEMORY")
        // Cargo runs the tests; the program would let it build the report.
        .env_remove("CARGO")
        .env_remove("CLICOLOR_FORCE")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// A program that runs until it is ended, here with the test at the latest; its first line says where it is reached.
pub(crate) struct Started {
    child: Child,
    pub(crate) line: String,
}

impl Started {
    pub(crate) fn new(arguments: &[&str]) -> Self {
        let mut child = command(arguments).stdin(Stdio::null()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
        Self { child, line: line.trim_end().to_owned() }
    }

    /// Ends it by a signal, of which it takes note; gives what it said on the way.
    pub(crate) fn ended_by(&mut self, signal: &str) -> String {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args([signal, &id]).status().unwrap().success());
        assert_eq!(self.child.wait().unwrap().code(), Some(0), "{signal}");
        let mut said = String::new();
        self.child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        said
    }
}

impl Drop for Started {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn run_as(arguments: &[&str], input: &[u8], columns: &str) -> Run {
    ended(command(arguments).env("COLUMNS", columns), input)
}

fn ended(command: &mut Command, input: &[u8]) -> Run {
    let mut child = command.spawn().unwrap();
    // A program that refuses early closes its input; that is its right.
    let _ = child.stdin.take().unwrap().write_all(input);
    let output = child.wait_with_output().unwrap();
    Run {
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
        code: output.status.code().unwrap(),
    }
}

/// Returns the whole output for a user, for snapshots.
pub(crate) fn shown(arguments: &[&str]) -> String {
    let run = run(arguments);
    format!("$ antrieb {}\n{}--- stderr\n{}--- exit {}\n", arguments.join(" "), run.out, run.err, run.code)
}
