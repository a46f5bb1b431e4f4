//! The command line of antrieb: data on stdout, messages on stderr.
//!
//! Exit code 0: fits, or answered; 1: does not fit; 2: the question could not be answered. A library, so that programs
//! other than `antrieb` can contain it: the package for Python does.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this face speaks to the terminal")]

mod answer;
mod ask;
mod call;
mod catalogue_check;
mod changed;
mod chapter;
mod code;
mod command;
mod commission;
mod compare;
mod data;
mod diff;
mod drive;
mod encoder;
mod errata;
mod explain;
mod export;
mod fault;
mod glossary;
mod inertia;
mod judge;
mod laid_out;
mod layout;
mod licences;
mod mount;
mod moves;
#[cfg(test)]
mod new_tests;
mod plot;
mod preview;
#[cfg(test)]
mod reference;
#[cfg_attr(not(feature = "report"), path = "no_report.rs")]
mod report;
mod reserve;
mod save;
mod serve;
mod simulate;
mod source;
mod sweep;
mod table;
mod tolerance;
mod upkeep;
mod waiting;
mod wiring;

use answer::CommandAnswer;
pub use call::{days_since_1970, named_file};
use clap::ArgMatches;
use command::parsed::Misread;
pub use fault::memory::allowed_by as memory_allowed;
use quantities::Language;
use questions::list::Unanswered;
pub use report::PRESS;
pub use source::SourceFile;
use std::ffi::OsString;
use std::time::Duration;
pub use waiting::{deadline_of, rows_line};

/// Answers a call of the command line, whose first word is the name of the program; returns the exit code.
#[must_use]
pub fn run(call: Vec<OsString>) -> u8 {
    disk::refuse_large_files();
    let command::parsed::ParsedCall { arguments, command, language, as_json, remark, matches } =
        command::parsed::ParsedCall::of(call);
    let keep: command::usage::Keep<'_> = &command::verified::verified_hint;
    let matches = match matches {
        Ok(matches) => matches,
        Err(Misread::Stray(stray)) => {
            return command::usage::stray(&stray, (&command, &arguments), keep, as_json, language).write(language);
        }
        Err(Misread::Library(error)) if error.use_stderr() => {
            return command::usage::refused(&error, (&command, &arguments), keep, as_json, language).write(language);
        }
        Err(Misread::Library(help)) => return CommandAnswer::data(help.render().ansi().to_string()).write(language),
    };
    let json = matches.get_flag("json");
    let most = match deadline(&matches, language) {
        Ok(most) => most,
        Err(why) => return fault::unanswered(&why, json, language).write(language),
    };
    #[cfg(not(feature = "report"))]
    if let Some(outcome) = report::by_cargo(&matches, language) {
        return outcome;
    }
    // Nothing has been written to standard output: an answer is written when it is complete.
    let late = move || {
        let why = Unanswered::Refused(questions::Refusal::Stopped, None);
        disk::end(i32::from(fault::unanswered(&why, json, language).write(language)));
    };
    // A server waits for requests; its work has no progress.
    let waiting = (!matches!(matches.subcommand_name(), Some("serve" | "drive")))
        .then(|| waiting::Waiting::begin(language, most, late));
    let answer = dispatch(&matches, language);
    drop(waiting);
    match answer {
        Ok(answer) => answer.remarked(remark),
        Err(why) => {
            let why = command::remedy::with_whole_calls(why, &arguments, language, &command::verified::verified);
            let calls = command::remedy::calls(&why, &arguments, &command, language);
            let calls = command::verified::verified(calls);
            fault::unanswered(&why, json, language).with_calls(&calls, language)
        }
    }
    .write(language)
}

/// Returns the time limit of the command (`--deadline`), if it has one.
fn deadline(matches: &ArgMatches, language: Language) -> Result<Option<Duration>, Unanswered> {
    let Some((_, found)) = matches.subcommand() else { return Ok(None) };
    let text = found.try_get_one::<String>("deadline").ok().flatten();
    text.map(|text| deadline_of(text, language)).transpose()
}

fn dispatch(matches: &ArgMatches, language: Language) -> Result<CommandAnswer, Unanswered> {
    let json = matches.get_flag("json");
    match matches.subcommand() {
        Some(("serve", found)) => serve::serve(found, language),
        Some(("drive", found)) => drive::drive(found, language),
        Some(("completions", found)) => Ok(command::completions(found, language)),
        Some(("help", found)) => Ok(command::help_on_check(found, language)),
        Some(("man", found)) => command::man(found, language),
        _ => ask::answer(matches, json, language),
    }
}
