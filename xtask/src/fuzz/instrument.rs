//! Compilation of the workspace crates with counters, for the edges taken by a case or the lines run.
//!
//! cargo calls a wrapper instead of the compiler for workspace members; this program is that wrapper. Dependencies are
//! compiled as for any release build and shared with it. Thus no nightly compiler, no further tool and no second copy
//! of the dependencies is needed: docs/decisions/0013-libfuzzer.md.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::sync::OnceLock;

/// Environment variable that turns this program into the wrapper.
pub(super) const VARIABLE: &str = "ANTRIEB_INSTRUMENT";

/// Counters added to the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Count {
    /// Edges, for the engine.
    Edges,
    /// Lines of the sources, for a report.
    Lines,
}

impl Count {
    /// Returns the value of the environment variable.
    pub(super) const fn word(self) -> &'static str {
        match self {
            Self::Edges => "edges",
            Self::Lines => "lines",
        }
    }

    fn of(word: &OsStr) -> Option<Self> {
        [Self::Edges, Self::Lines].into_iter().find(|count| word == count.word())
    }

    /// Returns the compiler flags for a crate.
    fn flags(self, words: &[OsString]) -> Vec<&'static str> {
        match self {
            Self::Edges if is_compared(words) => [&FLAGS[..], &[COMPARED]].concat(),
            Self::Edges => FLAGS.to_vec(),
            Self::Lines => vec!["-Cinstrument-coverage", "-Cdebug-assertions=on", "-Coverflow-checks=on"],
        }
    }
}

/// Counters on the edges, as set by cargo-fuzz; arithmetic errors end a case; source positions for the report. One
/// codegen unit: with several, nothing is inlined across them.
const FLAGS: [&str; 10] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Ccodegen-units=1",
    "-Cdebug-assertions=on",
    "-Coverflow-checks=on",
    "-Cstrip=none",
    "-Cdebuginfo=line-tables-only",
    "-Cforce-frame-pointers=yes",
];

/// Flag that traces comparisons, set only where bytes of the case are compared directly. Elsewhere derived values are
/// compared, of which the engine can use none, and tracing them takes longer than everything else.
const COMPARED: &str = "-Cllvm-args=-sanitizer-coverage-trace-compares";

/// Crates that read any text or bytes.
const READERS: [&str; 2] = ["quantities", "recording"];

fn is_compared(words: &[OsString]) -> bool {
    words.windows(2).any(|pair| match pair {
        [key, name] => key == "--crate-name" && READERS.iter().any(|reader| name == reader),
        _ => false,
    })
}

/// Path of this program at its start.
static OWN: OnceLock<PathBuf> = OnceLock::new();

/// Returns the path of this program. A step of `ci` that builds the workspace with other features replaces it at the
/// same place; a later query of the path could return one that does not exist.
///
/// # Errors
/// Errors of [`std::env::current_exe`].
pub(super) fn own() -> io::Result<PathBuf> {
    OWN.get().map_or_else(std::env::current_exe, |path| Ok(path.clone()))
}

/// Compiles if cargo has called this program as its wrapper; returns `None` if it was called by a user. Must be called
/// first.
#[must_use]
pub fn as_wrapper() -> Option<ExitCode> {
    if let Ok(path) = std::env::current_exe() {
        OWN.get_or_init(|| path);
    }
    let count = Count::of(&std::env::var_os(VARIABLE)?)?;
    let mut words = std::env::args_os().skip(1);
    let compiler = words.next()?;
    let words: Vec<OsString> = words.collect();
    let mut command = Command::new(compiler);
    command.args(&words);
    if is_of_the_target(&words) {
        command.args(count.flags(&words));
    }
    let code = command.status().ok()?.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1);
    Some(ExitCode::from(code))
}

/// Returns `true` for crates of the target; build scripts and their dependencies are not optimised and have no engine
/// to report to.
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

    #[test]
    fn comparisons_are_traced_where_bytes_are_read() {
        let flags = |count: Count, name: &str| count.flags(&["--crate-name", name].map(OsString::from));
        assert!(flags(Count::Edges, "quantities").contains(&COMPARED));
        assert!(!flags(Count::Edges, "sizing").contains(&COMPARED));
        assert!(flags(Count::Edges, "sizing").contains(&"-Cllvm-args=-sanitizer-coverage-inline-8bit-counters"));
        assert_eq!(flags(Count::Lines, "quantities").first(), Some(&"-Cinstrument-coverage"));
        assert_eq!(Count::of(OsStr::new("lines")), Some(Count::Lines));
        assert_eq!(Count::of(OsStr::new("1")), None);
    }
}
