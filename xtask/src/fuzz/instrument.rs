//! Compiling the crates of the workspace so that the engine sees which edges a case takes.
//!
//! cargo calls a wrapper for the compiler of workspace members; this program is that wrapper. Dependencies are compiled as for
//! any release build and shared with it. So no nightly compiler, no further tool and no second copy of the dependencies is
//! needed: docs/decisions/0013-libfuzzer.md.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::sync::OnceLock;

/// The variable that makes this program the wrapper.
pub(super) const VARIABLE: &str = "ANTRIEB_INSTRUMENT";

/// Counters on the edges and traced comparisons, as cargo-fuzz sets them; faults of arithmetic end a case; places in the
/// sources for what is told of one. One unit of code: with several, nothing is inlined across them.
const FLAGS: [&str; 11] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Ccodegen-units=1",
    "-Cdebug-assertions=on",
    "-Coverflow-checks=on",
    "-Cstrip=none",
    "-Cdebuginfo=line-tables-only",
    "-Cforce-frame-pointers=yes",
];

/// Where this program was when it began.
static OWN: OnceLock<PathBuf> = OnceLock::new();

/// The path of this program. A step of `ci` that builds the workspace with other features puts another build of it at the
/// same place; a question for its path would then be answered with one that does not exist.
///
/// # Errors
/// Those of [`std::env::current_exe`].
pub(super) fn own() -> io::Result<PathBuf> {
    OWN.get().map_or_else(std::env::current_exe, |path| Ok(path.clone()))
}

/// Compiles if cargo has called this program as its wrapper; `None` if a person has. To be asked before anything else.
#[must_use]
pub fn as_wrapper() -> Option<ExitCode> {
    if let Ok(path) = std::env::current_exe() {
        OWN.get_or_init(|| path);
    }
    std::env::var_os(VARIABLE)?;
    let mut words = std::env::args_os().skip(1);
    let compiler = words.next()?;
    let words: Vec<OsString> = words.collect();
    let mut command = Command::new(compiler);
    command.args(&words);
    if is_of_the_target(&words) {
        command.args(FLAGS);
    }
    let code = command.status().ok()?.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1);
    Some(ExitCode::from(code))
}

/// What cargo builds to run itself, build scripts and what they use, is not optimised and has no engine to report to.
fn is_of_the_target(words: &[OsString]) -> bool {
    let has = |wanted: &str| words.iter().any(|word| word == OsStr::new(wanted));
    has("opt-level=3") && !has("build_script_build")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_runs_while_building_is_left_as_it_is() {
        let words = |text: &str| text.split(' ').map(OsString::from).collect::<Vec<_>>();
        assert!(is_of_the_target(&words("--crate-name order_code -C opt-level=3 -C embed-bitcode=no")));
        assert!(!is_of_the_target(&words("--crate-name quantities -C embed-bitcode=no")));
        assert!(!is_of_the_target(&words("--crate-name build_script_build -C opt-level=3")));
    }
}
