//! The answer to a question of the list.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::command::own::VARY;
use crate::layout::Layout;
use crate::save::not_to_stdout;
use clap::ArgMatches;
use quantities::Language;
use questions::list::{LIST, Reads, Unanswered};
use std::path::PathBuf;

/// Answers a question of the list: as a record, or in the layout of the terminal.
pub(crate) fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<CommandAnswer, Unanswered> {
    let Some((command, mut found)) = matches.subcommand() else { return Ok(CommandAnswer::none()) };
    let mut command = command.to_owned();
    while let Some((below, matches)) = found.subcommand() {
        command = format!("{command} {below}");
        found = matches;
    }
    let is_given = |option: &str| found.try_contains_id(option).unwrap_or(false);
    let mut entries = LIST.iter().copied().filter(|entry| entry.command() == command);
    let Some(first) = entries.next() else { return Ok(CommandAnswer::none()) };
    let other = entries.find(|entry| entry.reads != Reads::Nothing && entry.option().is_some_and(is_given));
    let entry = other.unwrap_or(first);
    // A file that cannot be written is reported before anything is read.
    let path = |option| found.try_get_one::<PathBuf>(option).ok().flatten();
    let mut pdfs = entry.files().filter(|file| file.is_pdf()).filter_map(|file| path(file.option));
    if let Some(path) = pdfs.find(|path| path.as_os_str() == "-") {
        return Err(not_to_stdout(path, language));
    }
    let call = Call::read(entry, found, as_json, language)?;
    let inquiry = call.inquiry(entry)?;
    // Rows that the call states are no argument of the question.
    let has_own_rows = !call.texts(VARY).is_empty();
    let is_record = as_json && entry.answer.is_some() && entry.gives.is_record() && !call.writes() && !has_own_rows;
    let shown = match Layout::of(entry) {
        Some(layout) if !is_record => (layout.show)(&call, &inquiry)?,
        _ => call.record(&inquiry)?,
    };
    Ok(CommandAnswer { talk: call.understood(&inquiry) + &shown.talk, ..shown })
}
