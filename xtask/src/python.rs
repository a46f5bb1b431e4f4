//! The Python package: the wheel installed into an empty environment, its tests, examples and types; at night the
//! release wheel with the engine of clusters.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};
use crate::environment::{Environment, Ready};

/// Packages installed next to the wheel in a push, and in a night.
const PUSH: Environment = Environment {
    name: "python",
    list: "python/push.txt",
    pinned: include_str!("../python/push.txt"),
    missing: || Error::NoPython,
};
const NIGHT: Environment = Environment {
    name: "python-night",
    list: "python/night.txt",
    pinned: include_str!("../python/night.txt"),
    missing: || Error::NoPython,
};

/// Path of the package.
const PACKAGE: &str = "crates/python";

/// Builds the wheel from the artifacts of the workspace tests, runs its tests in an empty environment and with table
/// libraries, and checks the types.
///
/// # Errors
/// There is no Python, something does not build, or a test fails.
pub(crate) fn push(root: &Path) -> Result<(), Error> {
    let work = TestFolder::clear(root, "python")?;
    let tools = PUSH.ready(root)?;
    // With the features of the workspace tests: alone it would compile most dependencies a second time.
    let all = ["build", "--quiet", "--workspace", "--lib", "--bins", "--tests", "--features", "python/extension"];
    must_succeed(&mut cargo(root, &all))?;
    let library = Workspace::ask(root)?.target.join("debug").join(library());
    let mut pack = Command::new(tools.program("python"));
    pack.arg(root.join("xtask").join("python").join("pack.py"));
    let wheel =
        printed(pack.arg(root.join(PACKAGE).join("pyproject.toml")).arg(&library).arg(work.folder.join("wheel")))?;
    let wheel = PathBuf::from(wheel.trim());

    let empty = Ready::empty(work.folder.join("empty"), PUSH.missing)?;
    empty.install(&wheel)?;
    must_succeed(work.at(empty.program("antrieb")).arg("--version"))?;
    must_succeed(work.at(empty.program("python")).args(["-m", "antrieb.examples", "alone"]))?;

    tools.install(&wheel)?;
    must_succeed(work.at(tools.program("python")).args(["-m", "antrieb.examples", "pictures"]))?;
    shown(root, &work.folder.join("pictures"))?;
    let python = root.join(PACKAGE);
    let tests = ["-m", "unittest", "discover", "--start-directory"];
    must_succeed(work.at(tools.program("python")).args(tests).arg(python.join("tests").join("push")))?;
    types(root, &work, &tools)
}

/// Checks that the guides show the heat map drawn by the examples.
fn shown(root: &Path, pictures: &Path) -> Result<(), Error> {
    const DRAW: &str = "python -m antrieb.examples; it is one of the pictures in target/xtask/python/pictures";
    for (guide, file) in [
        ("docs/guide/pictures/heat-map.svg", "heat-map-en.svg"),
        ("docs/anleitung/pictures/heat-map.svg", "heat-map-de.svg"),
    ] {
        let read = |path: PathBuf| fs::read_to_string(&path).map_err(|source| Error::File { path, source });
        let (stored, drawn) = (read(root.join(guide))?, read(pictures.join(file))?);
        if stored != drawn {
            let same = stored.lines().zip(drawn.lines()).take_while(|(stored, drawn)| stored == drawn).count();
            return Err(Error::Stale { file: guide, line: same + 1, command: DRAW });
        }
    }
    Ok(())
}

/// Checks the types: the package with two checkers, and the stub of the native part against the module.
fn types(root: &Path, work: &TestFolder, tools: &Ready) -> Result<(), Error> {
    let (settings, sources) =
        (root.join(PACKAGE).join("pyproject.toml"), root.join(PACKAGE).join("python").join("antrieb"));
    must_succeed(work.at(tools.program("mypy")).arg("--config-file").arg(&settings).arg(&sources))?;
    let mut stub = work.at(tools.program("python"));
    must_succeed(stub.args(["-m", "mypy.stubtest", "antrieb._antrieb", "--mypy-config-file"]).arg(&settings))?;
    // pyright as a package that needs no download of its own.
    let mut pyright = work.at(tools.program("basedpyright"));
    pyright.arg("--project").arg(&settings).arg("--pythonpath").arg(tools.program("python"));
    must_succeed(pyright.arg(&sources))
}

/// Builds the release wheel and tests it with the engine of clusters, a cluster that loses a worker and a node, and measures
/// the cost of the way through Python.
///
/// # Errors
/// There is no Python, something does not build, or a test fails.
pub(crate) fn night(root: &Path) -> Result<(), Error> {
    let work = TestFolder::clear(root, "python-night")?;
    let (makers, tools) = (PUSH.ready(root)?, NIGHT.ready(root)?);
    let folder = work.folder.join("wheel");
    let mut build = Command::new(makers.program("maturin"));
    build.args(["build", "--locked", "--manifest-path"]).arg(root.join(PACKAGE).join("Cargo.toml"));
    must_succeed(build.arg("--out").arg(&folder).current_dir(root))?;
    let wheels = fs::read_dir(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
    for wheel in wheels.filter_map(Result::ok) {
        tools.install(&wheel.path())?;
    }
    // The same rows without Python, against which its cost is measured.
    let kernel =
        ["build", "--quiet", "--release", "--package", "python", "--no-default-features", "--example", "kernel"];
    must_succeed(&mut cargo(root, &kernel))?;
    let kernel = Workspace::ask(root)?.target.join("release").join("examples").join("kernel");
    let tests = root.join(PACKAGE).join("tests").join("night");
    // Without an isolated network the engine searches one outside.
    let alone = Command::new("unshare").args(["--net", "true"]).stderr(Stdio::null()).status();
    let mut run = if alone.is_ok_and(|status| status.success()) {
        let mut run = work.at(PathBuf::from("unshare"));
        run.args(["--net", "sh", "-c", "ip link set lo up; exec \"$@\"", "sh"]).arg(tools.program("python"));
        run
    } else {
        work.at(tools.program("python"))
    };
    run.args(["-m", "unittest", "discover", "--verbose", "--start-directory"]).arg(tests);
    // Its settings and the token that it writes stay in the folder of the run.
    must_succeed(run.env("HOME", &work.folder).env("RAY_USAGE_STATS_ENABLED", "0").env("ANTRIEB_KERNEL", kernel))
}

/// Folder for one run.
struct TestFolder {
    folder: PathBuf,
}

impl TestFolder {
    fn clear(root: &Path, name: &str) -> Result<Self, Error> {
        let folder = Workspace::ask(root)?.target.join("xtask").join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
        }
        fs::create_dir_all(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
        Ok(Self { folder })
    }

    /// Creates a command that runs in this folder, so that no package is found through the current directory.
    fn at(&self, program: PathBuf) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.folder).stdin(Stdio::null()).env("PYTHONDONTWRITEBYTECODE", "1");
        command
    }
}

/// Returns the file name of the library that cargo builds.
fn library() -> String {
    format!("{}_antrieb{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// Runs a program and returns its output.
fn printed(command: &mut Command) -> Result<String, Error> {
    let output = command.stdin(Stdio::null()).stderr(Stdio::inherit()).output();
    let output = output.map_err(|source| Error::NotStarted { command: spelled(command), source })?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(Error::Failed { command: spelled(command), status: output.status.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_beside_the_wheel_is_pinned_with_its_sums() {
        for beside in [PUSH, NIGHT] {
            let text = beside.pinned.replace("\\\n", " ");
            let entries: Vec<&str> = text.lines().filter(|line| line.contains("==")).collect();
            assert!(
                entries.len() > 5 && entries.iter().all(|entry| entry.contains("--hash=sha256:")),
                "{}",
                beside.list
            );
        }
        assert!(["maturin==", "mypy==", "basedpyright=="].iter().all(|tool| PUSH.pinned.contains(tool)));
        assert!(NIGHT.pinned.contains("ray=="));
    }
}
