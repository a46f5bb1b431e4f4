//! Compiling the crates of the workspace so that the engine sees which edges a case takes.
//!
//! cargo calls a wrapper for the compiler of workspace members; this program is that wrapper. Dependencies are compiled as for
//! any release build and shared with it. So no nightly compiler, no further tool and no second copy of the dependencies is
//! needed: docs/decisions/0013-libfuzzer.md.

use std::ffi::{OsStr, OsString};
use std::process::{Command, ExitCode};

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

/// Compiles if cargo has called this program as its wrapper; `None` if a person has.
#[must_use]
pub fn as_wrapper() -> Option<ExitCode> {
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
