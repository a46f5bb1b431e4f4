//! The answer to a question of the list.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::chapter;
use crate::command::effects;
use crate::command::own::{BESIDE, VARY};
use crate::layout::Layout;
use crate::save::not_to_stdout;
use crate::sweep;
use clap::ArgMatches;
use quantities::Language;
use questions::list::{Entry, LIST, Reads, Unanswered};
use std::path::{Path, PathBuf};

/// The question of a call, and the arguments of its command; `None` for a command that only the command line has.
fn asked(matches: &ArgMatches) -> Option<(&'static Entry, &ArgMatches)> {
    let (command, mut found) = matches.subcommand()?;
    let mut command = command.to_owned();
    while let Some((below, matches)) = found.subcommand() {
        command = format!("{command} {below}");
        found = matches;
    }
    let is_given = |option: &str| found.try_contains_id(option).unwrap_or(false);
    let mut entries = LIST.iter().copied().filter(|entry| entry.command() == command);
    let first = entries.next()?;
    let other = entries.find(|entry| entry.reads != Reads::Nothing && entry.option().is_some_and(is_given));
    Some((other.unwrap_or(first), found))
}

/// Reads what a call is about, without answering it.
///
/// # Errors
/// Faults of the arguments, of the files and of the values that the call states.
pub(crate) fn read(matches: &ArgMatches, language: Language) -> Result<(), Unanswered> {
    let Some((entry, found)) = asked(matches) else { return Ok(()) };
    if let Some(refusal) = effects::refusal(entry.command(), found, language) {
        return Err(refusal);
    }
    let call = Call::read(entry, found, false, language)?;
    let inquiry = call.inquiry(entry)?;
    match entry.command {
        "new" => return chapter::made(&call, &inquiry).map(|_| ()),
        "sweep" => sweep::readable(&call, &inquiry)?,
        "identify" => {
            let name = call.text("trace").unwrap_or_default();
            if !Path::new(name).is_file() {
                return Err(Unanswered::File { name: name.to_owned(), message: String::new(), is_too_large: false });
            }
        }
        _ => {}
    }
    let reads_projects = matches!(entry.reads, Reads::Project | Reads::TwoProjects);
    for source in inquiry.sources.iter().filter(|_| reads_projects) {
        let projects = source.projects(inquiry.catalogue, inquiry.progress, language)?;
        inquiry.given.all("axis").next().map_or(Ok(()), |axis| {
            let is_there = projects.iter().any(|project| project.name == axis);
            if is_there { Ok(()) } else { Err(Unanswered::message(axis.to_owned())) }
        })?;
    }
    Ok(())
}

/// Answers a question of the list: as a record, or in the layout of the terminal.
pub(crate) fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<CommandAnswer, Unanswered> {
    let Some((entry, found)) = asked(matches) else { return Ok(CommandAnswer::none()) };
    if let Some(refusal) = effects::refusal(entry.command(), found, language) {
        return Err(refusal);
    }
    // A file that cannot be written is reported before anything is read.
    let path = |option| found.try_get_one::<PathBuf>(option).ok().flatten();
    let mut pdfs = entry.files().filter(|file| file.is_pdf()).filter_map(|file| path(file.option));
    if let Some(path) = pdfs.find(|path| path.as_os_str() == "-") {
        return Err(not_to_stdout(path, language));
    }
    let call = Call::read(entry, found, as_json, language)?;
    let inquiry = call.inquiry(entry)?;
    // Rows and further actuators that the call states are no arguments of the question.
    let has_own_rows = [VARY, BESIDE].iter().any(|option| !call.texts(option).is_empty());
    let is_record = as_json && entry.answer.is_some() && entry.gives.is_record() && !call.writes() && !has_own_rows;
    let shown = match Layout::of(entry) {
        Some(layout) if !is_record => (layout.show)(&call, &inquiry)?,
        _ => call.record(&inquiry)?,
    };
    Ok(CommandAnswer { talk: call.understood(&inquiry) + &shown.talk, ..shown })
}
