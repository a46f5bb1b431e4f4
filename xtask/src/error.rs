use std::fmt;
use std::path::PathBuf;

/// Why a chore did not come to a good end.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// A program could not be started at all.
    NotStarted {
        /// The command as it would be typed.
        command: String,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A program ran and ended badly.
    Failed {
        /// The command as it would be typed.
        command: String,
        /// Its exit status in words.
        status: String,
    },
    /// A file or folder could not be read or written.
    File {
        /// The file or folder.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// Cargo could not say what the workspace holds.
    Metadata {
        /// What it said instead.
        source: Box<cargo_metadata::Error>,
    },
    /// A standard tool is neither there nor to be had.
    NoTool {
        /// The program.
        program: &'static str,
        /// The crate that builds it.
        from_crate: &'static str,
    },
    /// A target of the compiler is neither there nor to be had.
    NoTarget {
        /// Its name.
        target: &'static str,
    },
    /// There is no browser for the tests, or nothing that drives it.
    NoBrowser {
        /// The program.
        program: &'static str,
    },
    /// What a browser fetches has become too heavy.
    Heavy {
        /// Bytes that it has.
        bytes: usize,
        /// Bytes that it may have.
        most: usize,
    },
    /// A list of words is neither there nor to be had.
    NoWords {
        /// The package that holds it.
        package: &'static str,
    },
    /// German documents contain unknown words; they have been printed.
    UnknownWords {
        /// How many.
        count: usize,
    },
    /// There is no C++ compiler.
    NoCompiler,
    /// The tool that tries the interface is neither there nor to be had.
    NoSchemathesis,
    /// The clients of the virtual drive are neither there nor to be had.
    NoCanopen,
    /// There is no Python, or it has no way to make environments and to fill them.
    NoPython,
    /// A tool of LLVM is not there that comes with a component of the toolchain.
    NoCoverageTool {
        /// The program.
        program: &'static str,
    },
    /// A fuzz target has found a failing case; it has been printed.
    Finds {
        /// The target.
        target: &'static str,
        /// How many runs ended so.
        count: usize,
        /// Where the cases are.
        folder: PathBuf,
    },
    /// A fuzz target ran nothing.
    NoCases {
        /// The target.
        target: &'static str,
    },
    /// A word of the command line is wrong.
    Word {
        /// The word.
        word: String,
        /// What is wrong with it.
        why: String,
    },
    /// A package that a step needs is not in the workspace.
    NoPackage {
        /// Its name.
        name: &'static str,
    },
    /// Tests were skipped.
    Ignored {
        /// How many.
        count: u64,
    },
    /// The test runner printed no closing line.
    NoTests,
    /// The README shows no command that could be tried.
    NoReadmeCommand,
    /// A README command cannot be tried as it stands.
    ReadmeSyntax {
        /// Line in the README, from 1.
        line: usize,
        /// What is wrong with it.
        why: &'static str,
    },
    /// A README command ended badly or not at all.
    ReadmeCommand {
        /// Line in the README, from 1.
        line: usize,
        /// The command as printed there.
        command: String,
        /// Exit status in words, or that it did not end.
        status: String,
    },
    /// Documents show answers that are not given; they have been printed.
    Samples {
        /// How many lines.
        count: usize,
    },
    /// A file that is made from others is not what they say now.
    Stale {
        /// The file.
        file: &'static str,
        /// The first line that differs, from 1.
        line: usize,
        /// What makes it anew.
        command: &'static str,
    },
    /// A lock file with a yanked crate passes for one without.
    BlindToYanked {
        /// The crate.
        name: &'static str,
        /// Its yanked version.
        version: &'static str,
    },
    /// A dependency comes under no licence that is taken.
    Licence {
        /// Its name.
        package: String,
        /// What its manifest says.
        offered: String,
    },
    /// House rules are broken; the findings have been printed.
    Untidy {
        /// How many findings.
        count: usize,
    },
    /// `ci` has no step of this name.
    NoStep {
        /// The name given.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A step of `ci` failed.
    Step {
        /// Name of the step.
        name: &'static str,
        /// Why.
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
