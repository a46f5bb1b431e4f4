//! Runs the binary as a user does, from the root of the repository.

#![allow(dead_code, reason = "each test file uses its part")]

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

pub(crate) struct Run {
    pub(crate) out: String,
    pub(crate) err: String,
    pub(crate) code: i32,
}

pub(crate) fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn run(arguments: &[&str]) -> Run {
    run_with(arguments, b"")
}

pub(crate) fn run_with(arguments: &[&str], input: &[u8]) -> Run {
    run_as(arguments, input, "100")
}

/// On a terminal of so many columns.
pub(crate) fn run_in(arguments: &[&str], columns: &str) -> Run {
    run_as(arguments, b"", columns)
}

/// The program of the package whose tests these are.
const PROGRAM: &str = match (option_env!("CARGO_BIN_EXE_antrieb"), option_env!("CARGO_BIN_EXE_antrieb-quick")) {
    (Some(program), _) | (None, Some(program)) => program,
    (None, None) => "antrieb",
};

fn run_as(arguments: &[&str], input: &[u8], columns: &str) -> Run {
    let mut child = Command::new(PROGRAM)
        .args(arguments)
        .current_dir(root())
        .env_remove("ANTRIEB_LANG")
        // Cargo runs the tests; the program would let it build the report.
        .env_remove("CARGO")
        .env_remove("CLICOLOR_FORCE")
        .env("COLUMNS", columns)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that refuses early closes its input; that is its right.
    let _ = child.stdin.take().unwrap().write_all(input);
    let output = child.wait_with_output().unwrap();
    Run {
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
        code: output.status.code().unwrap(),
    }
}

/// Everything a user sees, for snapshots.
pub(crate) fn shown(arguments: &[&str]) -> String {
    let run = run(arguments);
    format!("$ antrieb {}\n{}--- stderr\n{}--- exit {}\n", arguments.join(" "), run.out, run.err, run.code)
}
