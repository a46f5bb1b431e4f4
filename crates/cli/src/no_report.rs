//! `report` in a program built without the typesetting engine: it says so, and names the way to get it. If cargo has
//! started the program, cargo builds the one with the engine, and that one answers.

use crate::answer::CommandAnswer;
use crate::call::Call;
use answers::Commissioning;
use clap::ArgMatches;
use quantities::Language;
use questions::list::{Inquiry, LIST, Unanswered};
use std::path::Path;
use std::process::Command;
use words::terminal;

/// Writers of reports and forms over HTTP; none in this program.
pub const PRESS: Option<page::Press> = None;

/// Makes cargo build and run the program with the engine, if this one was started by `cargo run` and the command needs
/// it.
///
/// Returns the exit code of that program; `None` if the command is answered here.
pub(crate) fn by_cargo(matches: &ArgMatches, language: Language) -> Option<u8> {
    let (command, found) = matches.subcommand()?;
    let entry = LIST.iter().find(|entry| entry.command() == command)?;
    let needs_engine = entry.files().any(|file| file.is_pdf() && found.contains_id(file.option));
    let cargo = std::env::var_os("CARGO").filter(|_| needs_engine)?;
    eprintln!("{}", terminal::cargo_builds_the_report(language));
    let mut command = Command::new(cargo);
    command.args(["run", "--package", "antrieb", "--manifest-path"]);
    command.arg(concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml"));
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    // If cargo cannot be started, the refusal names the way to get the report.
    let status = command.arg("--").args(std::env::args_os().skip(1)).status().ok()?;
    Some(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(2))
}

/// `antrieb report PROJECT --out FILE`
pub(crate) fn report(call: &Call<'_>, _: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    Err(refusal(call.language))
}

/// `antrieb size PROJECT --report FILE`
pub(crate) fn write(call: &Call<'_>, _: &Inquiry<'_>, _: &Path, _: bool) -> Result<CommandAnswer, Unanswered> {
    Err(refusal(call.language))
}

/// `antrieb commission CODE --checklist FILE`
pub(crate) fn checklist(_: &Commissioning, language: Language) -> Result<Vec<u8>, Unanswered> {
    Err(refusal(language))
}

fn refusal(language: Language) -> Unanswered {
    Unanswered::message(terminal::built_without_report(language))
}
