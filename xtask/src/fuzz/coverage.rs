//! Line coverage of the code that reads user input, by the corpora and the crashes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::instrument::Count;
use super::{Target, corpus, instrument, listed};
use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};

/// A reported part: name, and its folders and files under `crates/`.
const PARTS: [(&str, &[&str]); 7] = [
    ("quantities", &["quantities/src/"]),
    ("order-code", &["order-code/src/"]),
    ("recording", &["recording/src/"]),
    ("project and axis", &["project/src/", "axis/src/"]),
    ("configurator, its reading of codes", &["configurator/src/codes.rs", "configurator/src/nearest.rs"]),
    ("questions, its reading", &["questions/src/codes.rs", "questions/src/reading.rs"]),
    ("page and interface", &["page/src/"]),
];

/// Number of lines in the files of a part, and of those that were run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Lines {
    all: u64,
    run: u64,
}

/// Builds the targets with line counters, replays the cases under `fuzz/`, and prints the share of lines run.
pub(super) fn tell(root: &Path, targets: &[&Target]) -> Result<(), Error> {
    let workspace = Workspace::ask(root)?;
    workspace.require("fuzz")?;
    let (profdata, cov) = (tool(root, "llvm-profdata")?, tool(root, "llvm-cov")?);
    let work = workspace.target.join("fuzz-work").join("lines");
    let file = |path: &Path| {
        let path = path.to_path_buf();
        move |source| Error::File { path, source }
    };
    if work.exists() {
        fs::remove_dir_all(&work).map_err(file(&work))?;
    }
    fs::create_dir_all(&work).map_err(file(&work))?;
    let program = build(root, &workspace, &work)?;
    let mut cases = 0;
    for target in targets {
        let unpacked = work.join(target.name);
        corpus::unpack(&target.corpus(root), &unpacked)?;
        let crashes = root.join("fuzz").join("crashes").join(target.name);
        let files: Vec<PathBuf> = [unpacked, crashes].iter().flat_map(|folder| listed(folder)).collect();
        cases += files.len();
        // Few enough for the command line of every system.
        for (part, files) in files.chunks(200).enumerate() {
            let profile = work.join(format!("{}-{part}.profraw", target.name));
            let mut command = Command::new(&program);
            command.env("ANTRIEB_FUZZ_TARGET", target.name).env("LLVM_PROFILE_FILE", profile).args(files);
            must_succeed(command.stdout(Stdio::null()).stderr(Stdio::null()))?;
        }
    }
    let merged = work.join("merged.profdata");
    let profiles = listed(&work).into_iter().filter(|path| path.extension().is_some_and(|end| end == "profraw"));
    must_succeed(Command::new(profdata).args(["merge", "-sparse", "-o"]).arg(&merged).args(profiles))?;
    let mut command = Command::new(cov);
    command.args(["export", "-format=lcov", "-summary-only", "-instr-profile"]).arg(&merged).arg(&program);
    let printed = command.stderr(Stdio::inherit()).output();
    let printed = printed.map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
    if !printed.status.success() {
        return Err(Error::Failed { command: spelled(&command), status: printed.status.to_string() });
    }
    let text = String::from_utf8_lossy(&printed.stdout);
    println!("lines that the {cases} cases of the corpora and crashes run:");
    let mut sum = Lines::default();
    for (name, paths) in PARTS {
        let lines = counted(&text, paths);
        sum = Lines { all: sum.all + lines.all, run: sum.run + lines.run };
        print(name, lines);
    }
    print("all of these", sum);
    if sum.run == 0 { Err(Error::NoCases { target: "coverage" }) } else { Ok(()) }
}

fn print(name: &str, lines: Lines) {
    let share = 100.0 * lines.run as f64 / lines.all.max(1) as f64;
    println!("{name:<36} {:>6} of {:>6} {share:>6.1} %", lines.run, lines.all);
}

/// Sums the counts for the files of a part, in lcov format: `SF:` a file, `LF:` its lines, `LH:` those run.
fn counted(printed: &str, paths: &[&str]) -> Lines {
    let (mut sum, mut is_part) = (Lines::default(), false);
    for line in printed.lines() {
        if let Some(file) = line.strip_prefix("SF:") {
            let file = file.replace('\\', "/");
            let inside = file.rsplit_once("crates/").map_or("", |(_, inside)| inside);
            is_part = paths.iter().any(|path| inside.starts_with(path));
        }
        let number = |key: &str| line.strip_prefix(key).and_then(|number| number.parse::<u64>().ok());
        if let (true, Some(all)) = (is_part, number("LF:")) {
            sum.all += all;
        }
        if let (true, Some(run)) = (is_part, number("LH:")) {
            sum.run += run;
        }
    }
    sum
}

/// Builds the binary with line counters for the crates of the workspace. Its wrapper has another path than that of the
/// engine's build, so that cargo keeps both.
fn build(root: &Path, workspace: &Workspace, work: &Path) -> Result<PathBuf, Error> {
    super::engine::compiler()?;
    let own = instrument::own().map_err(|source| Error::File { path: PathBuf::from("xtask"), source })?;
    let wrapper = workspace.target.join(format!("count-lines{}", std::env::consts::EXE_SUFFIX));
    fs::copy(own, &wrapper).map_err(|source| Error::File { path: wrapper.clone(), source })?;
    let arguments = ["build", "--release", "--package", "fuzz", "--features", "engine", "--bin", "fuzz-target"];
    let mut command = cargo(root, &arguments);
    must_succeed(command.env("RUSTC_WORKSPACE_WRAPPER", wrapper).env(instrument::VARIABLE, Count::Lines.word()))?;
    let name = format!("fuzz-target{}", std::env::consts::EXE_SUFFIX);
    let built = workspace.target.join("release").join(&name);
    let program = work.join(name);
    fs::copy(&built, &program).map_err(|source| Error::File { path: built, source })?;
    Ok(program)
}

/// Returns the path of an LLVM tool in the version of the compiler, as installed by rustup.
fn tool(root: &Path, name: &'static str) -> Result<PathBuf, Error> {
    let asked = |arguments: &[&str]| {
        let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
        command.args(arguments).current_dir(root);
        let printed = command.output().map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
        Ok(String::from_utf8_lossy(&printed.stdout).into_owned())
    };
    let version = asked(&["-vV"])?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
    let folder = Path::new(asked(&["--print", "sysroot"])?.trim()).join("lib/rustlib").join(host).join("bin");
    let program = folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    if program.is_file() { Ok(program) } else { Err(Error::NoCoverageTool { program: name }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lines_of_a_part_are_added_up() {
        let printed = "SF:/a/crates/quantities/src/parse.rs\nLF:10\nLH:9\nend_of_record\n\
                    SF:crates/quantities/src/unit.rs\nLF:5\nLH:5\nend_of_record\n\
                    SF:/a/crates/project/src/lib.rs\nLF:100\nLH:1\nend_of_record\n";
        assert_eq!(counted(printed, &["quantities/src/"]), Lines { all: 15, run: 14 });
        assert_eq!(counted(printed, &["project/src/"]), Lines { all: 100, run: 1 });
        assert_eq!(counted(printed, &["recording/src/"]), Lines::default());
    }

    #[test]
    fn every_part_is_there() {
        for path in PARTS.iter().flat_map(|(_, paths)| *paths) {
            assert!(crate::root().join("crates").join(path).exists(), "{path}");
        }
    }
}
