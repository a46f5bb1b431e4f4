//! Test of the README's commands as printed, and of the answers shown in the documents: the first commands a reader
//! types must work.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use crate::readme_words::{ReadmeWord, split};
use crate::samples::desk;
use crate::{Error, picture, samples};

const PREFIX: &str = "cargo run -- ";
/// Time limit for a command shown in the README, generous for a slow, loaded machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// Runs the commands in their order in a new folder with a copy of `examples/`, so that one command may read the output
/// of an earlier one and the working tree stays clean.
pub(crate) fn run(root: &Path) -> Result<(), Error> {
    let readme = root.join("README.md");
    let text = fs::read_to_string(&readme).map_err(|source| Error::File { path: readme, source })?;
    let lines = commands(&text)?;
    if lines.is_empty() {
        return Err(Error::NoReadmeCommand);
    }
    let desk = desk(root)?;
    // Built first: the time limit applies to the program, not to the compiler.
    let program = samples::built(root)?;
    lines.iter().try_for_each(|line| line.try_in(&program, &desk))?;
    samples::check(root)?;
    picture::check(root)
}

#[derive(Debug, PartialEq)]
struct Line {
    number: usize,
    printed: String,
    words: Vec<String>,
    into: Option<String>,
}

impl Line {
    fn try_in(&self, program: &Path, desk: &Path) -> Result<(), Error> {
        eprintln!("readme: {}", self.printed);
        let mut command = Command::new(program);
        command.args(&self.words).current_dir(desk).stdin(Stdio::null());
        match &self.into {
            None => command.stdout(Stdio::null()),
            Some(name) => {
                let path = desk.join(name);
                command.stdout(File::create(&path).map_err(|source| Error::File { path, source })?)
            }
        };
        let child = command.spawn().map_err(|source| self.not_started(source))?;
        match self.wait(child)? {
            Some(status) if status.success() => Ok(()),
            Some(status) => Err(self.failed(status.to_string())),
            None => Err(self.failed(format!("still running after {} s", PATIENCE.as_secs()))),
        }
    }

    fn wait(&self, mut child: Child) -> Result<Option<ExitStatus>, Error> {
        let begin = Instant::now();
        loop {
            if let Some(status) = child.try_wait().map_err(|source| self.not_started(source))? {
                return Ok(Some(status));
            }
            if begin.elapsed() > PATIENCE {
                child.kill().and_then(|()| child.wait()).map_err(|source| self.not_started(source))?;
                return Ok(None);
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn not_started(&self, source: std::io::Error) -> Error {
        Error::NotStarted { command: self.printed.clone(), source }
    }

    fn failed(&self, status: String) -> Error {
        Error::ReadmeCommand { line: self.number, command: self.printed.clone(), status }
    }
}

/// Returns the commands in fenced blocks that start with `cargo run -- `, with or without a prompt `$ `.
fn commands(readme: &str) -> Result<Vec<Line>, Error> {
    let mut found = Vec::new();
    let mut fenced = false;
    let mut open: Option<(usize, String)> = None;
    for (number, raw) in (1..).zip(readme.lines()) {
        let line = raw.trim();
        if line.starts_with("```") {
            fenced = !fenced;
            continue;
        }
        let (start, text) = match open.take() {
            Some((start, before)) => (start, format!("{before} {line}")),
            None => {
                let line = line.strip_prefix("$ ").unwrap_or(line);
                if !fenced || !line.starts_with(PREFIX) {
                    continue;
                }
                (number, line.to_owned())
            }
        };
        match text.strip_suffix('\\') {
            Some(before) => open = Some((start, before.trim_end().to_owned())),
            None => found.push(command(start, &text)?),
        }
    }
    Ok(found)
}

fn command(number: usize, printed: &str) -> Result<Line, Error> {
    let syntax = |why| Error::ReadmeSyntax { line: number, why };
    let mut words = split(printed.strip_prefix(PREFIX).unwrap_or(printed)).map_err(syntax)?;
    let into = match words.iter().position(|word| word == &ReadmeWord::Into) {
        None => None,
        Some(at) => {
            let tail = words.split_off(at);
            match tail.as_slice() {
                [ReadmeWord::Into, ReadmeWord::Text(name)] => Some(name.clone()),
                _ => return Err(syntax("after `>` stands one file name and nothing else")),
            }
        }
    };
    let words = words.into_iter().filter_map(ReadmeWord::text).collect();
    Ok(Line { number, printed: printed.to_owned(), words, into })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_fenced_commands_count() {
        let readme = "cargo run -- not this\n```sh\n$ cargo run -- new table > axis.toml\n\
                      cargo build\ncargo run -- torsion X \\\n  --torque \"60 N m\"  # a remark\n```\n";
        let lines = commands(readme).unwrap();
        assert_eq!(lines.len(), 2);
        assert_eq!((lines[0].number, lines[0].into.as_deref()), (3, Some("axis.toml")));
        assert_eq!(lines[0].words, ["new", "table"]);
        assert_eq!((lines[1].number, lines[1].into.as_deref()), (5, None));
        assert_eq!(lines[1].words, ["torsion", "X", "--torque", "60 N m"]);
    }

    #[test]
    fn what_no_plain_command_is_is_reported() {
        for text in ["size a.toml | head", "size \"a", "size > ", "size > a b"] {
            let readme = format!("```\n{PREFIX}{text}\n```\n");
            let error = commands(&readme).unwrap_err();
            assert!(matches!(error, Error::ReadmeSyntax { line: 2, .. }), "{text}: {error}");
        }
    }
}
