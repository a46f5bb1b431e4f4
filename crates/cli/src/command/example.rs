//! Calls that work, with the words of a faulty one.

use super::best::{best_of_axes, best_of_project};
use super::folder::{has_ending, project_name, projects_in, recordings};
use super::meant::{Called, Part, Stray, understood};
use super::own::VARY;
use super::readings::{has_battery, readings};
use super::typed::typed;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use project::{Hint, written};
use quantities::seen;
use questions::list::recognises;
use std::ffi::OsString;
use std::path::Path;
use words::{Usage, UsageHint};

/// Largest number of further words that a call is filled with.
const FILLED_MOST: usize = 8;

/// Splits an example into its words.
pub(super) fn split(example: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (place, part) in example.split('"').enumerate() {
        if place % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}

/// Returns a call, with what it lacks taken from the example of the command; `None` if it is faulty in another way.
pub(super) fn filled(arguments: &[OsString], called: &Called<'_>) -> Option<String> {
    let mut whole = super::build_for(arguments, called.language());
    // An argument has its text when the command is built.
    whole.build();
    let understood = understood(arguments.to_vec(), &whole, called.language());
    if understood.stray.is_some() {
        return None;
    }
    let mut words = understood.arguments;
    let called = Called::of(&words, &whole, called.language())?;
    let example = match called.entry {
        Some(entry) => split(entry.example),
        // A command that only the command line has.
        None => super::examples()
            .iter()
            .find_map(|(_, call)| call.strip_prefix(&format!("{} ", called.name)).map(split))
            .unwrap_or_default(),
    };
    let of_example: Vec<&str> =
        std::iter::repeat_n("", called.begin).chain(example.iter().map(String::as_str)).collect();
    let parts = called.parts(&of_example)?;
    for _ in 0..FILLED_MOST {
        let Err(error) = whole.clone().try_get_matches_from(&words) else {
            words.extend(of_recorded(&words, &called).into_iter().flat_map(|code| ["--code".into(), code.into()]));
            let texts: Option<Vec<&str>> = words.iter().map(|word| word.to_str()).collect();
            // The name of the program as it is typed, not its path.
            return Some(typed(std::iter::once(super::NAME).chain(texts?.into_iter().skip(1))));
        };
        if error.kind() != ErrorKind::MissingRequiredArgument {
            return None;
        }
        let missing = match error.get(ContextKind::InvalidArg)? {
            ContextValue::Strings(names) => names.clone(),
            ContextValue::String(name) => vec![name.clone()],
            _ => return None,
        };
        let texts: Vec<&str> = words.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let mut more: Vec<String> = Vec::new();
        let places: Vec<usize> = called.parts(&texts)?.iter().filter_map(Part::place).collect();
        let (mut bare, behind) = (places.len(), places.last().map_or(called.begin, |last| last + 1));
        let mut before: Vec<String> = Vec::new();
        let mut is_begun = false;
        if missing.iter().any(|name| name.contains("--table")) && called.has(VARY) {
            return called.with_example_range(&words);
        }
        for name in &missing {
            let argument = called.command.get_arguments().find(|argument| argument.to_string() == *name);
            match argument.and_then(clap::Arg::get_long) {
                Some(long) => more.extend(option(long, &called, (&parts, &texts)).unwrap_or_default()),
                // A group of options: the first of the example.
                None if name.contains("--") => {
                    let options = parts.iter().find_map(|part| match part {
                        Part::Option(option, _) => option.get_long(),
                        Part::Bare(..) => None,
                    });
                    more.extend(options.and_then(|long| option(long, &called, (&parts, &texts))).unwrap_or_default());
                }
                None if named_code(&called, name) && best_of_project(&texts, called.language()).is_some() => {
                    before.extend(best_of_project(&texts, called.language()));
                    bare += 1;
                }
                None => {
                    let word = parts.iter().filter_map(|part| match part {
                        Part::Bare(_, word) => Some((*word).to_owned()),
                        Part::Option(..) => None,
                    });
                    let is_project = argument.is_some_and(|argument| argument.get_id() == "project");
                    // The only file of a call about a recording may be the project.
                    let is_stated = is_project && texts.iter().any(|word| has_ending(word, &[".toml"]));
                    let is_recording = is_stated || argument.is_some_and(|argument| argument.get_id() == TRACE);
                    if is_recording {
                        let own = recordings().into_iter().next().unwrap_or_else(|| RUN.to_owned());
                        words.insert(called.begin, own.into());
                        is_begun = true;
                        break;
                    }
                    let own = if is_project { projects_in(Path::new("")) } else { Vec::new() };
                    let own = own.iter().find_map(|path| path.to_str()).map(str::to_owned);
                    let word = own.or_else(|| word.clone().nth(bare)).or_else(|| word.clone().next_back())?;
                    before.push(word);
                    bare += 1;
                }
            }
        }
        if is_begun {
            continue;
        }
        if more.is_empty() && before.is_empty() {
            return None;
        }
        // Words without an option stand before the options.
        words.splice(behind..behind, before.into_iter().map(OsString::from));
        words.extend(more.into_iter().map(OsString::from));
    }
    None
}

/// Argument that is a recorded run, and the name of one in a folder without any.
const TRACE: &str = "trace";
const RUN: &str = "run.csv";

/// Returns the actuator of a recorded run as [`code_of_recorded`], else that of the example.
fn of_recorded(words: &[OsString], called: &Called<'_>) -> Option<String> {
    let of_example = || {
        let example = called.entry.map(|entry| split(entry.example)).unwrap_or_default();
        example.into_iter().skip_while(|word| word != "--code").nth(1)
    };
    code_of_recorded(words, called, &of_example)
}

/// Returns the actuator of a recorded run, if neither the call nor its project states one: the best of the ranking, else another
/// one.
pub(super) fn code_of_recorded(
    words: &[OsString],
    called: &Called<'_>,
    otherwise: &dyn Fn() -> Option<String>,
) -> Option<String> {
    let _ = called.entry.filter(|entry| entry.arguments.iter().any(|argument| argument.name == TRACE))?;
    let texts: Vec<&str> = words.iter().filter_map(|word| word.to_str()).collect();
    let is_stated = texts.iter().any(|word| word.split('=').next() == Some("--code"));
    let has_own = |text: String| written(&text).is_some_and(|all| all.iter().any(|each| each.path == "actuator"));
    if is_stated || called.project_text().is_some_and(has_own) {
        return None;
    }
    best_of_project(&texts, called.language()).or_else(otherwise)
}

/// Returns the call that simulates the recorded run of another call, where its file does not exist.
pub(super) fn simulated_run(call: &str) -> Option<String> {
    let words = split(call);
    let [_, command, run, project, more @ ..] = &words[..] else { return None };
    let is_due = command == "identify" && !Path::new(run).exists() && has_ending(project, &[".toml"]);
    let mut code = more.iter().skip_while(|word| *word != "--code").skip(1);
    let mut simulate = vec!["antrieb", "simulate", project];
    if let Some(code) = code.next() {
        simulate.extend(["--code", code]);
    }
    simulate.extend(["--out", run]);
    is_due.then(|| typed(simulate))
}

/// Returns `true` if the missing argument with this text is an ordering code.
fn named_code(called: &Called<'_>, name: &str) -> bool {
    let argument = called.command.get_arguments().find(|argument| argument.to_string() == name);
    argument.is_some_and(|argument| called.is_code(argument))
}

/// Largest number of readings of a part of a code that a refusal proposes.
const READINGS_MOST: usize = 3;

/// Pattern of the ordering codes whose encoder is buffered by a battery.
const BUFFERED: &str = "CHA-*-M128S-*";

impl Stray {
    /// Creates a word that no option of the call takes.
    pub(super) fn of(place: usize, word: &str) -> Self {
        Self { place, word: word.to_owned(), options: Vec::new(), given: None }
    }

    /// Returns the fault of the word, and the calls that work in place of the given one.
    pub(crate) fn fault(&self, called: &Called<'_>, arguments: &[OsString]) -> (Usage, Option<UsageHint>) {
        let written = seen(&self.word).into_owned();
        let is_exact = self.options.iter().all(|(_, value)| *value == self.word);
        let texts: Vec<&str> = arguments.iter().skip(called.begin).filter_map(|word| word.to_str()).collect();
        if self.options.is_empty() && called.stands_for_project(&self.word, &texts) {
            let project = project_name(&self.word);
            let new = typed(["antrieb", "new", "recording", "--from", &self.word, "--out", &project]);
            let asked = arguments.iter().filter_map(|word| word.to_str()).skip(1);
            let asked = asked.map(|word| if word == self.word { project.as_str() } else { word });
            let asked = typed(std::iter::once(super::NAME).chain(asked));
            return (Usage::Recording { written }, Some(UsageHint::Calls(vec![new, asked])));
        }
        let mut readings = readings(&self.word, called.language());
        // The simplest ones first: those without options.
        readings.sort_by_key(String::len);
        let is_about_batteries = called.entry.is_some_and(|entry| entry.command == "battery");
        let is_buffered = |code: &String| has_battery(code, called.language()) == Some(true);
        let is_unbuffered = || has_battery(&self.word, called.language()) == Some(false);
        if is_about_batteries && (is_unbuffered() || !readings.is_empty() && !readings.iter().any(is_buffered)) {
            let own: &[&str] = if readings.is_empty() { &["code", "parse"] } else { &["code", "list"] };
            let own = std::iter::once("antrieb").chain(own.iter().copied()).chain([&*self.word]);
            let calls = vec![typed(own), typed(["antrieb", "code", "list", BUFFERED])];
            return (Usage::NoBattery { code: written }, Some(UsageHint::Calls(calls)));
        }
        if is_about_batteries {
            readings.retain(is_buffered);
        }
        let is_for_code = called.command.get_positionals().next().is_some_and(|position| called.is_code(position));
        if is_for_code && called.is_of_several_axes(&self.word) && self.options.is_empty() && self.given.is_none() {
            let axes = best_of_axes(&self.word, called.language());
            let names: Vec<&str> = axes.iter().map(|(name, _)| name.as_str()).collect();
            let of_axis = |(axis, code): &(String, Option<String>)| {
                let _ = code.as_ref()?;
                let words: Option<Vec<&str>> = arguments.iter().skip(1).map(|word| word.to_str()).collect();
                Some(typed(std::iter::once(super::NAME).chain(words?).chain(["--axis", axis])))
            };
            let calls: Vec<String> = axes.iter().filter_map(of_axis).take(READINGS_MOST).collect();
            return (Usage::SeveralAxes { names: names.join(", ") }, Some(UsageHint::Calls(calls)));
        }
        if readings.len() > 1 && self.options.is_empty() && self.given.is_none() && called.projects.is_empty() {
            let with = |code: &String| {
                let own = arguments.iter().enumerate().skip(1).filter_map(|(at, word)| Some((at, word.to_str()?)));
                let own = own.map(|(at, word)| if at == self.place { code.as_str() } else { word });
                typed(std::iter::once(super::NAME).chain(own))
            };
            let calls = readings.iter().take(READINGS_MOST).map(with);
            let calls = calls.chain([typed(["antrieb", "code", "list", &self.word])]).collect();
            return (Usage::SeveralCodes { written, count: readings.len() }, Some(UsageHint::Calls(calls)));
        }
        if let Some(fault) =
            self.of_required(called, &texts).filter(|_| self.options.is_empty() && self.given.is_none())
        {
            return fault;
        }
        let usage = match (&self.given, &self.options[..]) {
            (Some(name), []) => Usage::Twice { name: name.clone() },
            (_, [_, _, ..]) if is_exact => {
                let options = self.options.iter().map(|(option, _)| option.clone()).collect();
                Usage::SeveralOptions { written, options }
            }
            _ => Usage::NoSuchArgument { written, command: called.name.clone() },
        };
        let without = |words: &[&str]| -> Vec<OsString> {
            let (head, tail) = arguments.split_at(self.place.min(arguments.len()));
            let tail = tail.iter().skip(1);
            head.iter().cloned().chain(words.iter().map(OsString::from)).chain(tail.cloned()).collect()
        };
        let mut calls: Vec<String> =
            self.options.iter().filter_map(|(option, value)| filled(&without(&[option, value]), called)).collect();
        if calls.is_empty() {
            let own = called.other_command(&self.word);
            let behind = (self.place, self.place + 1);
            calls.extend(called.swept(arguments));
            calls.extend(own.or_else(|| called.with_command_of_value(&self.word, behind, arguments)));
            // The pins of an actuator are the same for every drive.
            let is_about_pins = called.entry.is_some_and(|entry| entry.command == "wiring");
            calls.extend(filled(&without(&[]), called).filter(|_| is_about_pins));
        }
        if calls.is_empty() && called.projects.len() > 1 && called.is_project_of_call(&self.word) {
            calls.extend(called.calls_of_projects(arguments, self.place));
        }
        if calls.is_empty() {
            let given: Vec<&str> = texts.iter().filter_map(|text| text.strip_prefix("--")).collect();
            let given: Vec<&str> = given.iter().filter_map(|name| name.split('=').next()).collect();
            let options = self.as_quantity(called, &given);
            calls.extend(options.iter().filter_map(|(option, value)| filled(&without(&[option, value]), called)));
        }
        if calls.is_empty() {
            let left = without(&[]);
            // The value of an example in place of a typed number would answer another question.
            let is_filled = |call: &String| split(call).len() > left.len();
            let is_other = |call: &String| is_statement(&self.word) && (is_filled(call) || !called.projects.is_empty());
            calls.extend(filled(&left, called).filter(|call| !is_other(call)));
        }
        calls.dedup();
        let hint = if calls.is_empty() { UsageHint::Help } else { UsageHint::Calls(calls) };
        (usage, Some(hint))
    }
}

/// Returns `true` if a word begins like a number.
fn is_number_like(word: &str) -> bool {
    word.trim_start_matches(['-', '+']).starts_with(|sign: char| sign.is_ascii_digit())
}

/// Returns `true` if a word states something that a call without it would not answer: a number, a code.
fn is_statement(word: &str) -> bool {
    word.contains(|sign: char| sign.is_ascii_digit())
}

impl Stray {
    /// Returns the options that take the word with a decimal point or with a unit, which it lacks, each with that value.
    fn as_quantity(&self, called: &Called<'_>, given: &[&str]) -> Vec<(String, String)> {
        if !is_number_like(&self.word) || self.word.matches([',', '.']).count() > 1 {
            return Vec::new();
        }
        let number = self.word.replace(',', ".");
        let units = VALUES.iter().filter_map(|value| value.split_once(' ')).map(|(_, unit)| unit);
        let with_units = units.filter(|_| number.parse::<f64>().is_ok()).map(|unit| format!("{number} {unit}"));
        let mut found: Vec<(String, String)> = Vec::new();
        for value in std::iter::once(number.clone()).chain(with_units) {
            let (names, _) = called.takers(&value, given);
            found.extend(names.into_iter().map(|name| (name, value.clone())));
        }
        found
    }

    /// Returns the fault of the word as the value of an option that the call lacks and whose values are known.
    fn of_required(&self, called: &Called<'_>, texts: &[&str]) -> Option<(Usage, Option<UsageHint>)> {
        let is_lacking = |option: &&clap::Arg| {
            let long = option.get_long().map(|long| format!("--{long}"));
            option.is_required_set()
                && long.is_some_and(|long| !texts.iter().any(|text| text.split('=').next() == Some(&long)))
        };
        let option = called.options().find(|option| is_lacking(option) && !option.get_possible_values().is_empty())?;
        let values = option.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
        let usage =
            Usage::BadValue { written: seen(&self.word).into_owned(), name: format!("--{}", option.get_long()?) };
        Some((usage, Some(UsageHint::Words(Hint::ValidAre(values)))))
    }
}

/// Values of the arguments that no example states.
const VALUES: [&str; 8] = ["10 m", "10 s", "10 deg", "10 N m", "24 V", "20 degC", "2026-03-01", "1"];

/// Returns an option with its value in the example, else with one of its form; a file is named like the project of the
/// call.
fn option(long: &str, called: &Called<'_>, (example, texts): (&[Part<'_>], &[&str])) -> Option<Vec<String>> {
    let project = texts.iter().find(|text| text.ends_with(".toml") && !text.starts_with('-'));
    let stated = example.iter().find_map(|part| match part {
        Part::Option(option, value) if option.get_long() == Some(long) => *value,
        _ => None,
    });
    let of_form = || {
        let argument = called.argument(long)?;
        let value = VALUES.into_iter().find(|value| recognises(argument, value, called.language()))?;
        Some(value.to_owned())
    };
    let value = stated.map(str::to_owned).or_else(|| called.file_name(long)).or_else(of_form)?;
    let own = project.and_then(|project| {
        let ending = value.strip_prefix("axis")?;
        Some(format!("{}{ending}", Path::new(project).with_extension("").to_str()?))
    });
    Some(vec![format!("--{long}"), own.unwrap_or(value)])
}
