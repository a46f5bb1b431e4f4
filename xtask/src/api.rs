//! HTTP interface test with an external tool: schemathesis reads the OpenAPI document and sends unexpected requests. No
//! answer may be a server error, deviate from the documented form, or accept forbidden input.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use crate::cargo::{Workspace, must_succeed, spelled};
use crate::environment::Environment;
use crate::{Error, samples};

/// Requirements of the tool, each with its hashes.
const PINNED: &str = include_str!("../schemathesis/requirements.txt");

/// Settings of the tool, and hints about the interface.
const SETTINGS: [(&str, &str); 2] = [
    ("schemathesis.toml", include_str!("../schemathesis/schemathesis.toml")),
    ("hooks.py", include_str!("../schemathesis/hooks.py")),
];

/// Maximum duration of the test in a push and in a night \[s\].
const TIME: [&str; 2] = ["30", "240"];

/// Check that is switched off: input is free text whose errors are reported with status 422, so the rejection of a text
/// of the right type is no failure.
const NOT_ASKED: &str = "positive_data_acceptance";

/// Runs the test for the time of a push.
pub(crate) fn push(root: &Path) -> Result<(), Error> {
    run(root, TIME[0])
}

/// Runs the test for the time of a night.
pub(crate) fn night(root: &Path) -> Result<(), Error> {
    run(root, TIME[1])
}

fn run(root: &Path, seconds: &str) -> Result<(), Error> {
    let tool = ready(root)?;
    let program = samples::built(root)?;
    let desk = Workspace::ask(root)?.target.join("xtask").join("api");
    let folder = desk.join("served");
    fs::create_dir_all(&folder).map_err(|source| Error::File { path: folder.clone(), source })?;
    let mut command = Command::new(program);
    command
        .args(["serve", "--port", "0", "--no-token"])
        .arg(&folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null());
    let spelled = spelled(&command);
    let server = command.spawn().map_err(|source| Error::NotStarted { command: spelled.clone(), source })?;
    let mut server = Ends(server);
    let mut address = String::new();
    if let Some(out) = server.0.stdout.take() {
        BufReader::new(out).read_line(&mut address).map_err(|source| Error::NotStarted { command: spelled, source })?;
    }
    let document = format!("{}/api/v1/openapi.json", address.trim().trim_end_matches('/'));
    let mut command = Command::new(tool);
    command.args(["run", &document, "--no-color", "--workers", "1", "--seed", "1", "--max-time", seconds]);
    command.args(["--phases", "coverage,fuzzing", "--exclude-checks", NOT_ASKED, "--generation-database", "none"]);
    // The tool runs next to its settings, which refer to the hints about text bodies; its files stay out of the tree.
    for (name, text) in SETTINGS {
        let path = desk.join(name);
        fs::write(&path, text).map_err(|source| Error::File { path, source })?;
    }
    command.current_dir(desk).stdin(Stdio::null());
    must_succeed(&mut command)
}

/// A server process that is terminated when the step ends.
struct Ends(Child);

impl Drop for Ends {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Returns the path of the tool, installed into its own environment if missing.
fn ready(root: &Path) -> Result<PathBuf, Error> {
    let (list, missing) = ("schemathesis/requirements.txt", || Error::NoSchemathesis);
    let environment = Environment { name: "schemathesis", list, pinned: PINNED, missing };
    Ok(environment.ready(root)?.program("schemathesis"))
}
