//! The command line of antrieb: stdout is data, stderr is talk.
//!
//! Exit code 0: fits, or answered; 1: does not fit; 2: the question could not be answered.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "this face speaks to the terminal")]

mod answer;
mod chapter;
mod code;
mod command;
mod commission;
mod compare;
mod data;
mod diff;
mod errata;
mod explain;
mod export;
mod fault;
mod glossary;
mod inertia;
mod judge;
mod laid_out;
mod licences;
mod mount;
mod moves;
mod plot;
#[cfg(test)]
mod reference;
#[cfg_attr(not(feature = "report"), path = "no_report.rs")]
mod report;
mod reserve;
mod save;
mod serve;
mod subject;
mod table;
mod tolerance;
mod upkeep;
mod waiting;
mod wiring;

use answer::Answer;
use clap::ArgMatches;
use std::process::ExitCode;
use std::time::Duration;
use workbench::Language;
use workbench::quantities::{Measure, Time};

fn main() -> ExitCode {
    let language = command::language_of(std::env::args_os());
    let arguments = command::with_help_asked(std::env::args_os());
    let as_json = command::json_of(&arguments);
    let matches = match command::build(language).try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) if error.use_stderr() => return command::usage::refused(&error, as_json, language).write(language),
        Err(help) => {
            // A closed pipe is the reader's business.
            let _ = help.print();
            return ExitCode::SUCCESS;
        }
    };
    let json = matches.get_flag("json");
    let most = match deadline(&matches, json, language) {
        Ok(most) => most,
        Err(answer) => return answer.write(language),
    };
    // Who serves waits for others, and nobody for him.
    let waiting = (matches.subcommand_name() != Some("serve")).then(|| waiting::Waiting::begin(language, most));
    let answer = dispatch(&matches, language);
    drop(waiting);
    answer.write(language)
}

/// How long the answer may take, where a command can be told so.
fn deadline(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Option<Duration>, Answer> {
    let Some((_, found)) = matches.subcommand() else { return Ok(None) };
    if found.try_contains_id("deadline").is_err() {
        return Ok(None);
    }
    let time: Option<Time> = fault::quantity(found, "deadline", as_json, language)?;
    // A day is as good as for ever.
    Ok(time.map(|time| Duration::from_secs_f64(time.si().clamp(0.0, 86_400.0))))
}

fn dispatch(matches: &ArgMatches, language: Language) -> Answer {
    let json = matches.get_flag("json");
    match matches.subcommand() {
        Some(("size", found)) => judge::size(found, json, language),
        Some(("check", found)) => judge::check(found, json, language),
        Some(("report", found)) => report::report(found, json, language),
        Some(("explain", found)) => explain::explain(found, json, language),
        Some(("compare", found)) => compare::compare(found, json, language),
        Some(("diff", found)) => diff::diff(found, json, language),
        Some(("export", found)) => export::export(found, json, language),
        Some(("code", found)) => code::dispatch(found, json, language),
        Some(("data", found)) => data::sheet(found, json, language),
        Some(("wiring", found)) => wiring::wiring(found, json, language),
        Some(("errata", found)) => errata::errata(found, json, language),
        Some(("catalogue", found)) => data::catalogue(found, json),
        Some(("curve", found)) => chapter::curve(found, json, language),
        Some(("plot", found)) => plot::plot(found, json, language),
        Some(("bearing", found)) => chapter::bearing(found, json, language),
        Some(("battery", found)) => chapter::battery(found, json, language),
        Some(("mount", found)) => mount::mount(found, json, language),
        Some(("upkeep", found)) => upkeep::upkeep(found, json, language),
        Some(("new", found)) => chapter::template(found, json, language),
        Some(("commission", found)) => commission::commission(found, json, language),
        Some(("torsion", found)) => data::torsion(found, json, language),
        Some(("inertia", found)) => inertia::inertia(found, json, language),
        Some(("glossary", found)) => glossary::glossary(found, json, language),
        Some(("serve", found)) => serve::serve(found, json, language),
        Some(("licences", _)) => licences::licences(json),
        Some(("schema", found)) if found.get_flag("answers") => Answer::record(&workbench::answers::schema()),
        Some(("schema", _)) => Answer::record(&workbench::schema(language)),
        Some(("completions", found)) => command::completions(found, language),
        Some(("man", found)) => command::man(found, json, language),
        _ => Answer::none(),
    }
}
