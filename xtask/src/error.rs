use std::fmt;
use std::path::PathBuf;

/// Reason why a command of `xtask` failed.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// A program could not be started.
    NotStarted {
        /// Command as it would be typed.
        command: String,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// A program returned a failure.
    Failed {
        /// Command as it would be typed.
        command: String,
        /// Exit status as text.
        status: String,
    },
    /// A file or folder could not be read or written.
    File {
        /// Path of the file or folder.
        path: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// Cargo could not return the metadata of the workspace.
    Metadata {
        /// Error of cargo.
        source: Box<cargo_metadata::Error>,
    },
    /// A standard tool is missing and cannot be installed.
    NoTool {
        /// Name of the program.
        program: &'static str,
        /// Crate that builds the program.
        from_crate: &'static str,
    },
    /// A target of the compiler is missing and cannot be installed.
    NoTarget {
        /// Name of the target.
        target: &'static str,
    },
    /// There is no browser for the tests, or no driver for it.
    NoBrowser {
        /// Name of the program.
        program: &'static str,
    },
    /// A file fetched by a browser exceeds its limit.
    Heavy {
        /// Size \[bytes\].
        bytes: usize,
        /// Limit \[bytes\].
        most: usize,
    },
    /// A list of words is missing and cannot be installed.
    NoWords {
        /// Package that contains the list.
        package: &'static str,
    },
    /// German documents contain unknown words; they have been printed.
    UnknownWords {
        /// Number of unknown words.
        count: usize,
    },
    /// There is no C++ compiler.
    NoCompiler,
    /// The tool that tests the interface is missing and cannot be installed.
    NoSchemathesis,
    /// The clients of the virtual drive are missing and cannot be installed.
    NoCanopen,
    /// There is no Python, or it cannot create and fill environments.
    NoPython,
    /// An LLVM tool that comes with a component of the toolchain is missing.
    NoCoverageTool {
        /// Name of the program.
        program: &'static str,
    },
    /// A fuzz target has found a failing case; it has been printed.
    Finds {
        /// Name of the target.
        target: &'static str,
        /// Number of runs with a failing case.
        count: usize,
        /// Folder of the failing cases.
        folder: PathBuf,
    },
    /// A fuzz target ran nothing.
    NoCases {
        /// Name of the target.
        target: &'static str,
    },
    /// A word of the command line is wrong.
    Word {
        /// Argument as given.
        word: String,
        /// Reason.
        why: String,
    },
    /// A package that a step requires is not in the workspace.
    NoPackage {
        /// Name of the package.
        name: &'static str,
    },
    /// Tests were skipped.
    Ignored {
        /// Number of skipped tests.
        count: u64,
    },
    /// The test runner printed no closing line.
    NoTests,
    /// The README contains no command to run.
    NoReadmeCommand,
    /// A README command cannot be parsed.
    ReadmeSyntax {
        /// Line in the README, counted from 1.
        line: usize,
        /// Reason.
        why: &'static str,
    },
    /// A README command failed or did not end.
    ReadmeCommand {
        /// Line in the README, counted from 1.
        line: usize,
        /// Command as written there.
        command: String,
        /// Exit status as text, or a note that it did not end.
        status: String,
    },
    /// Documents show answers that the program does not give; they have been printed.
    Samples {
        /// Number of lines.
        count: usize,
    },
    /// A generated file differs from its sources.
    Stale {
        /// Path of the file.
        file: &'static str,
        /// First line that differs, counted from 1.
        line: usize,
        /// Command that regenerates the file.
        command: &'static str,
    },
    /// The check does not find a yanked crate in a lock file that contains one.
    BlindToYanked {
        /// Name of the crate.
        name: &'static str,
        /// Yanked version.
        version: &'static str,
    },
    /// A dependency has no accepted licence.
    Licence {
        /// Name of the package.
        package: String,
        /// Licence stated in its manifest.
        offered: String,
    },
    /// House rules are violated; the findings have been printed.
    Untidy {
        /// Number of findings.
        count: usize,
    },
    /// `ci` has no step with this name.
    NoStep {
        /// Name as given.
        name: String,
        /// Names of the existing steps.
        known: String,
    },
    /// A step of `ci` failed.
    Step {
        /// Name of the step.
        name: &'static str,
        /// Reason.
        source: Box<Error>,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotStarted { command, source } => {
                write!(f, "cannot start `{command}`: {source}")
            }
            Self::Failed { command, status } => write!(f, "`{command}` failed: {status}"),
            Self::File { path, source } => write!(f, "{}: {source}", path.display()),
            Self::Metadata { source } => write!(f, "`cargo metadata` has no answer: {source}"),
            Self::NoTool { program, from_crate } => write!(
                f,
                "{program} is not here and could not be installed; get it with `cargo install --locked {from_crate}`"
            ),
            Self::NoTarget { target } => {
                write!(f, "the compiler has no target {target}; get it with `rustup target add {target}`")
            }
            Self::NoBrowser { program } => write!(
                f,
                "no {program} is here to try the page with; Debian: apt-get install chromium chromium-driver, for Firefox apt-get install firefox-esr and cargo install --locked geckodriver"
            ),
            Self::Heavy { bytes, most } => {
                write!(f, "the engine has {bytes} bytes, packed; it may have {most}")
            }
            Self::NoWords { package } => {
                write!(f, "{package} is not here and could not be installed; it takes Python with pip")
            }
            Self::UnknownWords { count } => write!(
                f,
                "{count} words are not known as German; one that is right belongs into xtask/german-words.txt"
            ),
            Self::NoCompiler => write!(
                f,
                "no C++ compiler is here, and the fuzzing engine is built with one; get g++ or clang++ (Debian: apt-get install g++)"
            ),
            Self::NoSchemathesis => write!(
                f,
                "schemathesis is not here and could not be installed; it takes Python 3.11 or later with venv and pip"
            ),
            Self::NoCanopen => write!(
                f,
                "python-canopen is not here and could not be installed; it takes Python 3.11 or later with venv and pip"
            ),
            Self::NoPython => write!(
                f,
                "Python 3.11 or later with venv and pip is not here, or an index of packages cannot be reached: \
                 apt-get install python3-venv"
            ),
            Self::NoCoverageTool { program } => {
                write!(f, "{program} is not here; get it with `rustup component add llvm-tools`")
            }
            Self::Finds { target, count, folder } => write!(
                f,
                "target `{target}` has {count} finds; the cases are in {}; when mended they belong into fuzz/crashes/{target}",
                folder.display()
            ),
            Self::NoCases { target } => write!(f, "target `{target}` ran no case"),
            Self::Word { word, why } => write!(f, "`{word}`: {why}"),
            Self::NoPackage { name } => write!(f, "no package `{name}` in the workspace"),
            Self::Ignored { count } => {
                write!(f, "{count} tests were ignored; every test runs or goes")
            }
            Self::NoTests => write!(f, "the test runner printed no `test result:` line"),
            Self::NoReadmeCommand => {
                write!(f, "no `cargo run -- …` line in a fenced block of README.md")
            }
            Self::ReadmeSyntax { line, why } => write!(f, "README.md:{line}: {why}"),
            Self::ReadmeCommand { line, command, status } => {
                write!(f, "README.md:{line}: `{command}`: {status}")
            }
            Self::Samples { count } => write!(
                f,
                "the documents show {count} lines that the program does not give; `cargo xtask samples` mends what it can"
            ),
            Self::Stale { file, line, command } => {
                write!(f, "{file}:{line} is out of date; what makes it anew: {command}")
            }
            Self::BlindToYanked { name, version } => {
                write!(f, "the check for yanked crates does not find {name} {version}, which was yanked")
            }
            Self::Licence { package, offered } => {
                write!(f, "{package} comes under `{offered}`: no licence of xtask/src/notices.rs")
            }
            Self::Untidy { count: 1 } => write!(f, "1 finding"),
            Self::Untidy { count } => write!(f, "{count} findings"),
            Self::NoStep { name, known } => write!(f, "no step `{name}`; there are: {known}"),
            Self::Step { name, source } => write!(f, "step `{name}` failed: {source}"),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::NotStarted { source, .. } | Self::File { source, .. } => Some(source),
            Self::Metadata { source } => Some(source.as_ref()),
            Self::Step { source, .. } => Some(source.as_ref()),
            _ => None,
        }
    }
}
