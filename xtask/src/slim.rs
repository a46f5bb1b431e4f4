//! The form of the program without the typesetting engine, for scripts: it builds, and its one refusal is tested.

use std::path::Path;

use crate::Error;
use crate::cargo::{cargo, must_succeed};

pub(crate) fn run(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["test", "--package", "antrieb", "--no-default-features", "--test", "slim"]))
}
