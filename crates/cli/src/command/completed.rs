//! Calls that lack one word, with the one that is plainly meant: the only project of the folder, today, the neutral list of a drive,
//! the best of the actuators that half a code names.

use super::begun::workbook_beside;
use super::best::{BestOfPattern, ProjectOfCall, best_of_pattern};
use super::example::code_of_recorded;
use super::folder::{has_ending, projects_in, text_of};
use super::meant::{Called, Part};
use super::own::{STEP, VARY, is_of_several, is_plain_range};
use super::readings::has_battery;
use super::spoken::seems_code;
use super::typed::typed;
use crate::changed::places;
use clap::Command;
use project::written;
use quantities::{Language, Measure, Time};
use questions::list::ArgumentKind;
use questions::list::upkeep::{day_of_clock, read_date};
use std::ffi::OsString;
use std::path::Path;
use words::{spoken, terminal};

/// Hours of operation a day of a battery without a statement: a shift.
const BATTERY_HOURS: &str = "8 h";

/// Ending of a workbook.
const WORKBOOK: &str = ".xlsx";

/// Word for the duration of a run.
const DURATION: &str = "duration";

/// Days and hours above which a duration is that of an operation, not of a cycle \[s\].
const OPERATION_LEAST_S: f64 = 3600.0;

/// Seconds of a day.
const DAY_S: f64 = 86_400.0;

/// Returns a call with what it plainly lacks, and a remark on each word that was added.
pub(super) fn completed(arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, Vec<String>) {
    let (mut arguments, mut remarks) = (arguments, Vec::new());
    for step in [with_ranges, with_step, with_own_values, with_whole_codes, with_one_option] {
        let found = Called::of(&arguments, whole, language).and_then(|called| step(&called, &arguments));
        if let Some((changed, remark)) = found {
            arguments = changed;
            remarks.extend(remark);
        }
    }
    (arguments, remarks)
}

type Completed = (Vec<OsString>, Option<String>);

/// Returns a sweep with each range behind `--set` as one that is varied: `--set ambient=0..40degC`.
fn with_ranges(called: &Called<'_>, arguments: &[OsString]) -> Option<Completed> {
    let texts = texts(arguments).filter(|_| called.has(VARY))?;
    let is_range = |change: &str| change.split_once('=').is_some_and(|(_, values)| is_of_several(values));
    let mut is_changed = false;
    let words: Vec<OsString> = texts
        .iter()
        .enumerate()
        .map(|(place, word)| {
            let own = match word.strip_prefix("--set=") {
                Some(change) if is_range(change) => Some(format!("--{VARY}={change}")),
                None if *word == "--set" && texts.get(place + 1).is_some_and(|next| is_range(next)) => {
                    Some(format!("--{VARY}"))
                }
                _ => None,
            };
            is_changed |= own.is_some();
            own.map_or_else(|| OsString::from(word), OsString::from)
        })
        .collect();
    is_changed.then_some((words, None))
}

/// Returns a sweep with its step behind the only range: `--vary mass=30..60kg:5kg`.
fn with_step(called: &Called<'_>, arguments: &[OsString]) -> Option<Completed> {
    let texts = texts(arguments).filter(|_| called.has(STEP))?;
    let value = |option: &str| stated(&texts, option);
    let [(at, count, step)] = value(STEP)[..] else { return None };
    let ranges: Vec<_> = value(VARY).into_iter().filter(|(_, _, change)| is_plain_range(change)).collect();
    let [(place, length, range)] = ranges[..] else { return None };
    let is_plain =
        step.starts_with(|sign: char| sign.is_ascii_digit() || "+-.".contains(sign)) && value("steps").is_empty();
    let varied = is_plain.then(|| [format!("--{VARY}"), format!("{range}:{step}")])?;
    let words = texts.iter().enumerate().flat_map(|(each, word)| match each {
        _ if each == place => varied.to_vec(),
        _ if (place..place + length).contains(&each) || (at..at + count).contains(&each) => Vec::new(),
        _ => vec![(*word).to_owned()],
    });
    Some((words.map(OsString::from).collect(), None))
}

/// Returns the values of an option with the place and the number of their words.
fn stated<'t>(texts: &[&'t str], option: &str) -> Vec<(usize, usize, &'t str)> {
    let of = |(place, word): (usize, &&'t str)| match word.strip_prefix("--")?.strip_prefix(option)? {
        "" => Some((place, 2, *texts.get(place + 1)?)),
        rest => Some((place, 1, rest.strip_prefix('=')?)),
    };
    texts.iter().enumerate().filter_map(of).collect()
}

/// Returns the words of a call as texts.
fn texts(arguments: &[OsString]) -> Option<Vec<&str>> {
    arguments.iter().map(|word| word.to_str()).collect()
}

/// Returns a call with the program's words for the values of options: `--scenario estop`, `--delivered today`.
fn with_own_values(called: &Called<'_>, arguments: &[OsString]) -> Option<Completed> {
    let texts = texts(arguments)?;
    let mut words: Vec<String> = texts.iter().map(|word| (*word).to_owned()).collect();
    let today = || crate::call::days_since_1970().and_then(day_of_clock).map(|day| day.to_string());
    for part in called.parts(&texts)? {
        let Part::Option(option, Some(value)) = part else { continue };
        let name = option.get_long().unwrap_or_default();
        let possible = option.get_possible_values();
        let is_possible = |word: &str| possible.iter().any(|value| value.matches(word, true));
        let own = match called.argument(name).map(|argument| argument.kind) {
            Some(ArgumentKind::Date) if spoken::is_today(value) => today(),
            _ if name == "axis" => own_axis(&called.projects, value),
            _ if is_possible(value) => None,
            _ => spoken::choice(name, value).filter(|word| is_possible(word)).map(str::to_owned),
        };
        let Some(own) = own else { continue };
        for word in words.iter_mut().skip(called.begin) {
            if word == value {
                *word = own.clone();
            } else if *word == format!("--{name}={value}") {
                *word = format!("--{name}={own}");
            }
        }
    }
    let is_changed = words.iter().zip(&texts).any(|(word, text)| word != text);
    is_changed.then(|| (words.into_iter().map(OsString::from).collect(), None))
}

/// Returns the name of the axis that a word names in another case or by its number from one, in the projects of a call.
fn own_axis(projects: &[std::path::PathBuf], word: &str) -> Option<String> {
    let of = |path: &std::path::PathBuf| {
        let all = written(&text_of(path)?)?;
        let name = format!("{}name", places::axis_named(&all, word)?);
        all.into_iter().find(|each| each.path == name)?.value
    };
    projects.iter().find_map(of).filter(|name| name != word)
}

/// Returns a call with the only project of the folder, if it lacks one, and a remark on it.
pub(super) fn with_project(
    mut arguments: Vec<OsString>,
    whole: &Command,
    language: Language,
) -> (Vec<OsString>, Option<String>) {
    let Some(called) = Called::of(&arguments, whole, language) else { return (arguments, None) };
    let is_of_project = called.command.get_positionals().any(|position| position.get_id() == "project");
    let first_is_code = called.command.get_positionals().next().is_some_and(|position| called.is_code(position));
    let is_file = |word: &&str| has_ending(word, &[".toml"]) || *word == "-" || Path::new(word).exists();
    let first: Vec<&str> = called.first.iter().map(String::as_str).collect();
    let is_stated = arguments.iter().skip(called.begin).any(|word| {
        // Help is about the command.
        word.to_str().is_none_or(|word| is_file(&word) || ["-h", "--help", "--"].contains(&word))
    });
    let is_known = |word: &&str| seems_code(word) || !called.takers(word, &[]).0.is_empty() || word.contains('=');
    let is_due = match called.entry.map(|entry| entry.command) {
        None | Some("identify") => false,
        // A record states what the call does.
        Some(_) if super::json_of(&arguments) => false,
        // A word of another kind may be the name of a project.
        Some(_) if is_of_project => first.iter().all(is_known),
        Some(_) => {
            first_is_code && first.is_empty() && called.entry.is_some_and(|entry| !entry.command().contains(' '))
        }
    };
    if !is_due || is_stated || !called.projects.is_empty() {
        return (arguments, None);
    }
    let begin = called.begin;
    let [project] = &projects_in(Path::new(""))[..] else { return (arguments, None) };
    arguments.insert(begin, project.into());
    (arguments, Some(terminal::only_project(&project.to_string_lossy(), language)))
}

/// Returns a call about actuators with the best of those that each part of a code names, for the axis of its project.
fn with_whole_codes(called: &Called<'_>, arguments: &[OsString]) -> Option<Completed> {
    let language = called.language();
    let texts = texts(arguments)?;
    let takes_code = called.argument("code").is_some_and(|argument| matches!(argument.kind, ArgumentKind::Code));
    let project = called.projects.first().filter(|_| takes_code)?.to_str()?;
    let codes = called.parts(&texts)?.into_iter().filter_map(|part| match part {
        Part::Bare(_, word) if seems_code(word) => Some(word),
        Part::Option(option, Some(value)) if option.get_long() == Some("code") => Some(value),
        _ => None,
    });
    // A stated option without a value names no actuator.
    let parts: Vec<&str> =
        codes.filter(|code| !code.is_empty() && questions::read_code(code, language).is_err()).collect();
    let _ = parts.first()?;
    let project = ProjectOfCall::of_call(project, arguments, called)?;
    let mut words: Vec<String> = texts.iter().map(|word| (*word).to_owned()).collect();
    let mut remarks: Vec<String> = Vec::new();
    for part in parts {
        let pattern = questions::list::code_list::read_pattern(part, language).ok();
        let Some(found) = pattern.and_then(|pattern| best_of_pattern(&project, &pattern)) else { continue };
        let option = format!("--code={part}");
        for word in &mut words {
            if *word == part {
                word.clone_from(&found.code);
            } else if *word == option {
                *word = format!("--code={}", found.code);
            }
        }
        remarks.push(remark_on(part, &found, language));
    }
    (!remarks.is_empty()).then(|| (words.into_iter().map(OsString::from).collect(), Some(remarks.join("\n"))))
}

/// Describes the choice among the actuators that a part of a code names.
fn remark_on(part: &str, found: &BestOfPattern, language: Language) -> String {
    let BestOfPattern { code, fitting, failing } = found;
    let count = fitting.len() + failing.len();
    let part = quantities::seen(part);
    let remark = match (count, fitting.is_empty()) {
        (1, _) => terminal::only_of_pattern(&part, code, language),
        (_, true) => terminal::nearest_of_pattern(&part, &count, code, language),
        (_, false) => terminal::best_of_pattern(&part, &count, code, language),
    };
    // The verdict is not that of every reading.
    if fitting.is_empty() || failing.is_empty() {
        return remark;
    }
    let readings =
        terminal::pattern_readings(&fitting.len(), &listed(fitting), &failing.len(), &listed(failing), language);
    format!("{remark}\n{readings}")
}

/// Largest number of readings of a code that a remark lists.
const READINGS_MOST: usize = 8;

/// Returns the first of some codes as one text.
fn listed(codes: &[String]) -> String {
    let shown = codes.iter().take(READINGS_MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    if codes.len() > READINGS_MOST { format!("{shown}, …") } else { shown }
}

/// Returns a call with the option that it lacks.
fn with_one_option(called: &Called<'_>, arguments: &[OsString]) -> Option<Completed> {
    let language = called.language();
    let texts = texts(arguments)?;
    let parts = called.parts(&texts)?;
    let is_given = |names: &[&str]| {
        parts.iter().any(|part| matches!(part, Part::Option(option, _) if option.get_long().is_some_and(|long| names.contains(&long))))
    };
    let bare: Vec<&str> =
        parts.iter().filter_map(|part| if let Part::Bare(_, word) = part { Some(*word) } else { None }).collect();
    let takes = |option: &str| bare.iter().any(|word| called.takers(word, &[]).0.iter().any(|name| name == option));
    let with = |more: &[&str], remark: String| {
        let words = arguments.iter().cloned().chain(more.iter().map(OsString::from)).collect();
        Some((words, Some(remark)))
    };
    match called.entry?.command {
        // Hours without days are those of one day.
        "simulate" if is_given(&["hours-per-day"]) && !is_given(&["days"]) => {
            with(&["--days", "1"], terminal::option_assumed(&"--days 1", language))
        }
        "simulate" if !is_given(&["days", "hours-per-day"]) => {
            let language = called.language();
            let word = bare.iter().find(|word| operation(DURATION, word, language).is_some())?;
            let words = arguments.iter().filter(|other| *other != word).cloned();
            let more = operation(DURATION, word, language)?;
            let remark = terminal::option_assumed(&more.join(" "), language);
            Some((words.chain(more.into_iter().map(OsString::from)).collect(), Some(remark)))
        }
        "commission" if !is_given(&["for", "checklist", "record", "blank"]) && bare.len() == 1 => {
            with(&["--for", "plain"], terminal::option_assumed(&"--for plain", language))
        }
        "upkeep" if !is_given(&["delivered"]) && !takes("--delivered") && !bare.is_empty() => {
            let today = crate::call::days_since_1970().and_then(day_of_clock)?.to_string();
            with(&["--delivered", &today], terminal::option_assumed(&format!("--delivered {today}"), language))
        }
        // The plan of a delivery to come begins with it.
        "upkeep" if !is_given(&["today"]) => {
            let is_date = |word: &&str| called.takers(word, &[]).0.iter().any(|name| name == "--delivered");
            let delivered = parts.iter().find_map(|part| match part {
                Part::Option(option, Some(value)) if option.get_long() == Some("delivered") => Some(*value),
                Part::Bare(_, word) => Some(*word).filter(is_date),
                _ => None,
            })?;
            let read = read_date(delivered, language).ok()?;
            let today = crate::call::days_since_1970().and_then(day_of_clock)?;
            if read <= today || super::json_of(arguments) {
                return None;
            }
            with(&["--today", &read.to_string()], terminal::option_assumed(&format!("--today {read}"), language))
        }
        "plot" if !is_given(&["figure"]) && !takes("--figure") && is_given(&["svg", "png"]) => {
            with(&["--figure", "torque_speed"], terminal::option_assumed(&"--figure torque_speed", language))
        }
        // The project before and after the changes of the call.
        "diff"
            if called.projects.len() == 1 && bare.iter().filter(|word| has_ending(word, &[".toml"])).count() == 1 =>
        {
            let is_changed = is_given(&["set", "scale"]) || takes("--set") || takes("--scale");
            let project = called.projects.first().filter(|_| is_changed)?;
            let place = arguments.iter().position(|word| project.as_os_str() == word)?;
            let mut words = arguments.to_vec();
            words.insert(place + 1, project.into());
            Some((words, None))
        }
        // The workbook beside the project, as the report.
        "export" if !is_given(&["out", "table", "format"]) && !super::json_of(arguments) => {
            called.projects.first().filter(|_| !takes("--table") && !takes("--out"))?;
            let file = workbook_beside(&called.projects, WORKBOOK);
            with(&["--out", &file], terminal::option_assumed(&typed(["--out", &file]), language))
        }
        "identify" if !is_given(&["code"]) && !super::json_of(arguments) => {
            let code = code_of_recorded(arguments, called, &|| None)?;
            with(&["--code", &code], terminal::best_of_the_ranking(&code, language))
        }
        // The answers beside the table, in a file that does not exist.
        "sweep" if !is_given(&["out", VARY]) && !super::json_of(arguments) => {
            let is_table = |word: &&str| called.takers(word, &[]).0.iter().any(|name| name == "--table");
            let mut tables = parts.iter().filter_map(|part| match part {
                Part::Option(option, Some(value)) if option.get_long() == Some("table") => Some(*value),
                Part::Bare(_, word) => Some(*word).filter(is_table),
                _ => None,
            });
            // A second one is the file for the answers.
            let table = tables.next().filter(|_| tables.next().is_none());
            let file = answers_beside(Path::new(table.filter(|table| *table != "-")?))?;
            with(&["--out", &file], terminal::option_assumed(&typed(["--out", &file]), language))
        }
        "battery" => {
            // A code without a battery stays, and is refused.
            let code = bare.iter().find(|word| has_battery(word, language) == Some(true));
            if bare.iter().any(|word| has_battery(word, language) == Some(false)) {
                return None;
            }
            let words = arguments.iter().filter(|word| code.is_none_or(|code| *word != code)).cloned();
            let mut words: Vec<OsString> = words.collect();
            if is_given(&["hours-per-day"]) || takes("--hours-per-day") {
                return code.map(|_| (words, None));
            }
            words.extend(["--hours-per-day".into(), BATTERY_HOURS.into()]);
            let option = format!("--hours-per-day \"{BATTERY_HOURS}\"");
            Some((words, Some(terminal::option_assumed(&option, language))))
        }
        _ => None,
    }
}

/// Largest number of names that are tried for a file of answers.
const NAMES_MOST: u32 = 999;

/// Returns the name of a file for the answers of a table beside it: in Parquet if the table is, else in CSV.
fn answers_beside(table: &Path) -> Option<String> {
    let stem = table.file_name()?.to_str()?.split('.').next()?;
    let is_parquet = has_ending(table.to_str()?, &[".parquet", ".pq"]);
    let ending = if is_parquet { "parquet" } else { "csv" };
    let name = |number: u32| match number {
        1 => format!("{stem}_answers.{ending}"),
        _ => format!("{stem}_answers_{number}.{ending}"),
    };
    let is_free = |path: &std::path::PathBuf| path.symlink_metadata().is_err();
    let found = (1..=NAMES_MOST).map(|number| table.with_file_name(name(number))).find(is_free)?;
    found.to_str().map(str::to_owned)
}

/// Returns the options of a run for a duration of an hour or more: `--time 8h` of a simulation.
pub(super) fn operation(name: &str, value: &str, language: Language) -> Option<Vec<String>> {
    let duration =
        spoken::is_duration(name).then(|| questions::read_quantity::<Time>(value, language).ok()).flatten()?;
    let seconds = duration.si();
    if seconds < OPERATION_LEAST_S {
        return None;
    }
    let (days, hours) =
        if seconds <= DAY_S { (1.0, value.to_owned()) } else { ((seconds / DAY_S).round(), "24 h".to_owned()) };
    let is_whole = seconds <= DAY_S || (days * DAY_S - seconds).abs() < 1.0;
    is_whole.then(|| vec!["--days".to_owned(), format!("{days:.0}"), "--hours-per-day".to_owned(), hours])
}
