//! The fuzz binary with libFuzzer: build, start, and evaluation of its output.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::instrument::Count;
use super::{Target, corpus, instrument, listed};
use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};

/// Condition that ends a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EndCondition {
    Seconds(u32),
    Cases(u64),
}

/// Result of one or several runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct EngineRuns {
    pub(super) cases: u64,
    /// Number of edges in the instrumented crates.
    pub(super) edges: u64,
    /// Number of edges taken by a case.
    pub(super) reached: u64,
    pub(super) finds: usize,
    /// Minimum number of cases that passed the first gate of their target: see [`GATE`].
    pub(super) past: u64,
}

/// Line prefix by which a target reports, in steps, the cases that passed its first gate, such as the footer of a file;
/// as in `fuzz/src/lib.rs`.
pub(super) const GATE: &str = "stat::past_the_gate:";

impl EngineRuns {
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            cases: self.cases + other.cases,
            edges: self.edges.max(other.edges),
            reached: self.reached.max(other.reached),
            finds: self.finds + other.finds,
            past: self.past + other.past,
        }
    }

    /// Reads the values in a line of output.
    fn hear(&mut self, line: &str) {
        let after = |mark: &str| {
            let rest = line.split_once(mark)?.1.trim_start();
            rest.split(|c: char| !c.is_ascii_digit()).next()?.parse::<u64>().ok()
        };
        if line.contains("inline 8-bit counters") {
            self.edges = after("(").unwrap_or(self.edges);
        }
        if let Some(cases) = after("stat::number_of_executed_units:") {
            self.cases = cases;
        }
        if let Some(past) = after(GATE) {
            self.past = past;
        }
        if line.starts_with('#') {
            self.reached = after("cov:").unwrap_or(self.reached).max(self.reached);
            self.cases = after("#").unwrap_or(self.cases).max(self.cases);
        }
    }
}

/// The binary and its folders.
pub(super) struct Engine {
    root: PathBuf,
    program: PathBuf,
    /// Folder for the results of runs: new cases of each target, finds, logs.
    work: PathBuf,
}

impl Engine {
    /// Builds the binary.
    pub(super) fn build(root: &Path) -> Result<Self, Error> {
        let workspace = Workspace::ask(root)?;
        workspace.require("fuzz")?;
        compiler()?;
        let own = instrument::own();
        let own = own.map_err(|source| Error::File { path: PathBuf::from("xtask"), source })?;
        let arguments = ["build", "--release", "--package", "fuzz", "--features", "engine", "--bin", "fuzz-target"];
        let mut command = cargo(root, &arguments);
        must_succeed(command.env("RUSTC_WORKSPACE_WRAPPER", own).env(instrument::VARIABLE, Count::Edges.word()))?;
        let file = format!("fuzz-target{}", std::env::consts::EXE_SUFFIX);
        let program = workspace.target.join("release").join(file);
        Ok(Self { root: root.to_path_buf(), program, work: workspace.target.join("fuzz-work") })
    }

    /// Writes the cases of the corpus to a folder, in the form read by the engine.
    pub(super) fn unpack(&self, target: &Target) -> Result<(), Error> {
        corpus::unpack(&target.corpus(&self.root), &self.unpacked(target))
    }

    fn unpacked(&self, target: &Target) -> PathBuf {
        self.work.join(target.name).join("corpus")
    }

    fn crashes(&self, target: &Target) -> PathBuf {
        self.root.join("fuzz").join("crashes").join(target.name)
    }

    fn folder(&self, target: &Target, of: &str) -> Result<PathBuf, Error> {
        let folder = self.work.join(target.name).join(of);
        fs::create_dir_all(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
        Ok(folder)
    }

    /// Returns the folder for the finds of a target, emptied of those of earlier runs.
    pub(super) fn finds(&self, target: &Target) -> Result<PathBuf, Error> {
        let folder = self.folder(target, "finds")?;
        for file in listed(&folder) {
            fs::remove_file(&file).map_err(|source| Error::File { path: file.clone(), source })?;
        }
        Ok(folder)
    }

    /// Returns the command for a target, with its limits.
    fn command(&self, target: &Target) -> Result<Command, Error> {
        let mut command = Command::new(&self.program);
        command.env("ANTRIEB_FUZZ_TARGET", target.name).env("ANTRIEB_FUZZ_MEMORY_MB", target.memory_mb.to_string());
        let mut prefix = self.folder(target, "finds")?.into_os_string();
        prefix.push(std::path::MAIN_SEPARATOR_STR);
        let mut artifact = std::ffi::OsString::from("-artifact_prefix=");
        artifact.push(prefix);
        command
            .arg(artifact)
            .arg(format!("-timeout={}", super::CASE_SECONDS))
            .arg(format!("-max_len={}", target.bytes));
        // The program itself needs some memory in addition to that of the case.
        command.arg(format!("-rss_limit_mb={}", target.memory_mb + 512)).current_dir(&self.work);
        Ok(command)
    }

    /// Replays the corpus and the crashes, then tries new cases.
    pub(super) fn explore(&self, target: &Target, stop: EndCondition, seed: u32) -> Result<EngineRuns, Error> {
        let new = self.folder(target, "new")?;
        let mut command = self.command(target)?;
        command.arg(match stop {
            EndCondition::Seconds(seconds) => format!("-max_total_time={seconds}"),
            EndCondition::Cases(cases) => format!("-runs={cases}"),
        });
        // The bytes are choices, so a short case is not simpler. Parallel processes use each other's finds. The
        // schedule by rare features costs a fifth of the time if a case has thousands of them.
        command.args(["-len_control=0", "-entropic=0", "-print_final_stats=1", "-reload=10"]);
        command.arg(format!("-seed={seed}"));
        command.arg(new).args([self.unpacked(target), self.crashes(target)].iter().filter(|folder| folder.is_dir()));
        self.run(command, target, &format!("{seed}.log"))
    }

    /// Runs one case and passes its output on.
    pub(super) fn repeat(&self, target: &Target, file: &Path) -> Result<(), Error> {
        let path = fs::canonicalize(file).map_err(|source| Error::File { path: file.to_path_buf(), source })?;
        must_succeed(self.command(target)?.env("ANTRIEB_FUZZ_SHOW", "1").arg(path))
    }

    /// Reduces the corpus to the fewest cases, old and new, with the same coverage.
    pub(super) fn merge(&self, target: &Target) -> Result<(), Error> {
        let (merged, new) = (self.folder(target, "merged")?, self.folder(target, "new")?);
        for old in listed(&merged) {
            fs::remove_file(&old).map_err(|source| Error::File { path: old.clone(), source })?;
        }
        let mut command = self.command(target)?;
        command.arg("-set_cover_merge=1").args([&merged, &self.unpacked(target), &new]);
        self.run(command, target, "merge.log")?;
        if listed(&merged).is_empty() {
            return Err(Error::NoCases { target: target.name });
        }
        let kept = corpus::pack(&merged, &target.corpus(&self.root))?;
        println!("fuzz: {:<9} {kept} cases in the corpus", target.name);
        Ok(())
    }

    /// Runs the binary with its output in a log; prints the end of the log after a failing case.
    fn run(&self, mut command: Command, target: &Target, log: &str) -> Result<EngineRuns, Error> {
        let log = self.folder(target, "logs")?.join(log);
        let failed = |source| Error::File { path: log.clone(), source };
        let not_started = |command: &Command, source| Error::NotStarted { command: spelled(command), source };
        let mut writer = fs::File::create(&log).map_err(failed)?;
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|source| not_started(&command, source))?;
        let mut run = EngineRuns::default();
        let mut last: Vec<String> = Vec::new();
        if let Some(stream) = child.stderr.take() {
            for line in BufReader::new(stream).split(b'\n').map_while(Result::ok) {
                let line = String::from_utf8_lossy(&line).into_owned();
                writeln!(writer, "{line}").map_err(failed)?;
                run.hear(&line);
                if !line.starts_with('#') {
                    last.push(line);
                }
            }
        }
        let status = child.wait().map_err(|source| not_started(&command, source))?;
        if !status.success() {
            run.finds = 1;
            let begin = last.len().saturating_sub(LINES_TOLD);
            eprintln!("fuzz: {} ended with {status}:", target.name);
            last.iter().skip(begin).for_each(|line| eprintln!("  {line}"));
        }
        Ok(run)
    }
}

/// Number of log lines printed for a failing case.
const LINES_TOLD: usize = 30;

/// Checks for a C++ compiler, which libFuzzer requires.
pub(super) fn compiler() -> Result<(), Error> {
    let asked = std::env::var("CXX").ok();
    let names = asked.iter().map(String::as_str).chain(["c++", "g++", "clang++", "cl"]);
    let works = |name: &str| {
        let mut command = Command::new(name);
        command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command.status().is_ok()
    };
    if names.into_iter().any(works) { Ok(()) } else { Err(Error::NoCompiler) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_engine_says_is_understood() {
        let mut run = EngineRuns::default();
        for line in [
            "INFO: Loaded 1 modules   (51234 inline 8-bit counters): 51234 [0x1, 0x2), ",
            "#2\tINITED cov: 412 ft: 413 corp: 1/1b exec/s: 0 rss: 40Mb",
            "#4096\tpulse  cov: 733 ft: 1414 corp: 101/1Kb lim: 128 exec/s: 2048 rss: 41Mb",
            "stat::past_the_gate: 1000",
            "stat::past_the_gate: 2000",
            "stat::number_of_executed_units: 5000",
        ] {
            run.hear(line);
        }
        assert_eq!(run, EngineRuns { cases: 5000, edges: 51234, reached: 733, finds: 0, past: 2000 });
    }
}
