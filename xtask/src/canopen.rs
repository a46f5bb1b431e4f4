//! Test of the virtual drive with an external client: python-canopen takes it through the states of CiA 402, moves it,
//! causes a fault and resets it, over python-can's interface for socketcand.

use std::path::Path;
use std::process::{Command, Stdio};

use crate::cargo::must_succeed;
use crate::environment::Environment;
use crate::{Error, samples};

/// Requirements of the clients, each with its hashes.
const PINNED: &str = include_str!("../canopen/requirements.txt");

/// Runs the script of `validation/drive`.
pub(crate) fn run(root: &Path) -> Result<(), Error> {
    let (list, missing) = ("canopen/requirements.txt", || Error::NoCanopen);
    let environment = Environment { name: "canopen", list, pinned: PINNED, missing };
    let python = environment.ready(root)?.program("python");
    let program = samples::built(root)?;
    let script = root.join("validation").join("drive").join("canopen402.py");
    must_succeed(Command::new(python).arg(script).arg(program).stdin(Stdio::null()))
}
