//! Calls that the command-line library rejects, as faults like all others.

use super::example::{filled, simulated_run};
use super::folder::{has_ending, projects_in};
use super::kind::kind;
use super::meant::{Called, Stray};
use super::proposed::may_mean;
use super::spoken::{option_meant, seems_code};
use super::typed::typed;
use crate::answer::{CommandAnswer, written};
use answers::{Fault, Faults};
use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use project::{Hint, nearest_name};
use quantities::{Language, seen};
use questions::list::new::kind_about;
use questions::list::{Argument, ArgumentKind, Entry, LIST, Reads};
use std::error::Error as _;
use std::ffi::OsString;
use std::path::Path;
use words::help::library;
use words::{Usage, UsageHint, usage_hint, usage_text};

/// Selection of the calls that a hint proposes; `None` if none of them remains.
pub(crate) type Keep<'k> = &'k dyn Fn(UsageHint) -> Option<UsageHint>;

/// Returns the answer to a call that cannot be parsed.
///
/// `call` is the whole command line and the arguments of the call; `keep` selects the proposed calls.
pub(crate) fn refused(
    error: &clap::Error,
    call: (&Command, &[OsString]),
    keep: Keep<'_>,
    as_json: bool,
    language: Language,
) -> CommandAnswer {
    let Refusal { usage, option, hints, kinds } = refusal(error, call, language);
    let is_call = hints.iter().any(|hint| matches!(hint, UsageHint::Calls(_)));
    let mut hints: Vec<UsageHint> = hints.into_iter().filter_map(keep).collect();
    if is_call && hints.is_empty() {
        hints.push(UsageHint::Help);
    }
    let owner = || {
        let Usage::UnknownOption { written } = &usage else { return None };
        let [UsageHint::Calls(calls), ..] = &hints[..] else { return None };
        Called::of(call.1, call.0, language)?.owner_of_option(written, calls)
    };
    let usage = owner().unwrap_or(usage);
    said((&usage, option), &hints, kinds, (as_json, language))
}

/// Returns the hints of a call that cannot be parsed, with proposed calls as they are.
pub(super) fn hints(error: &clap::Error, call: (&Command, &[OsString]), language: Language) -> Vec<UsageHint> {
    refusal(error, call, language).hints
}

/// Reason why a call cannot be parsed.
struct Refusal {
    usage: Usage,
    /// Option of which the value is at fault.
    option: Option<String>,
    hints: Vec<UsageHint>,
    /// Kinds of project files with a line each, if the kind is missing.
    kinds: String,
}

fn refusal(error: &clap::Error, (command, arguments): (&Command, &[OsString]), language: Language) -> Refusal {
    let missing = &missing(error, command, arguments)[..];
    // Behind an unknown option every word is one too many; the option is what is wrong.
    let unknown = match error.kind() {
        ErrorKind::UnknownArgument => Called::of(arguments, command, language)
            .and_then(|called| called.unknown_option(arguments))
            .map(|word| seen(&word).into_owned())
            .or_else(|| context(error, ContextKind::InvalidArg)),
        _ => None,
    };
    let usage_of = |error| match &unknown {
        Some(written) => Usage::UnknownOption { written: written.clone() },
        None => usage_of(error),
    };
    let whole = Called::of(arguments, command, language);
    let meant = unknown.as_deref().and_then(|word| {
        let suggested = || {
            let is_same = context(error, ContextKind::InvalidArg).as_deref() == Some(word);
            context(error, ContextKind::SuggestedArg).filter(|near| is_same && !near.is_empty() && may_mean(word, near))
        };
        let near = || whole.as_ref()?.near_option(word);
        option_meant(word, called(command, arguments)).or_else(suggested).or_else(near)
    });
    let calls = match error.kind() {
        ErrorKind::UnknownArgument => {
            let word = unknown.clone().unwrap_or_default();
            whole.as_ref().map(|called| called.calls_instead_of(&word, meant.as_deref(), arguments)).unwrap_or_default()
        }
        _ => Vec::new(),
    };
    let calls = if calls.is_empty() { of_folder(first_calls(error, arguments)) } else { calls };
    if !calls.is_empty() {
        let hints = vec![UsageHint::Calls(calls)];
        return Refusal { usage: usage_of(error), option: None, hints, kinds: String::new() };
    }
    let hint = meant.map(|option| UsageHint::Words(Hint::DidYouMean(option))).or_else(|| hint_of(error, missing));
    let call = (error.kind() == ErrorKind::MissingRequiredArgument)
        .then(|| filled(arguments, &Called::of(arguments, command, language)?))
        .flatten();
    // In a folder without a project, the first call creates one.
    let calls = call.map(|call| {
        let before = missing_project(&usage_of(error), &call).into_iter().chain(simulated_run(&call));
        before.chain([call.clone()]).collect()
    });
    let hints: Vec<UsageHint> = match (hint, calls) {
        (None | Some(UsageHint::Help), Some(calls)) => vec![UsageHint::Calls(calls)],
        (hint, calls) => hint.into_iter().chain(calls.map(UsageHint::Calls)).collect(),
    };
    let option = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(name)) => name.strip_prefix("--").map(|name| {
            name.chars().take_while(|sign| sign.is_ascii_alphanumeric() || *sign == '-').collect::<String>()
        }),
        _ => None,
    };
    let option = option.filter(|name| !name.is_empty());
    Refusal { usage: usage_of(error), option, hints, kinds: kinds(missing, language) }
}

/// Returns examples about a project of the folder, else with one that creates their project first.
fn of_folder(calls: Vec<String>) -> Vec<String> {
    const PROJECT: &str = "axis.toml";
    let own = projects_in(Path::new("")).into_iter().find_map(|path| path.to_str().map(str::to_owned));
    let is_written = calls.iter().any(|call| call.contains("--out axis.toml"));
    let reads = calls.iter().any(|call| call.split(' ').any(|word| word == PROJECT));
    match own {
        // A new project has a file of its own.
        Some(own) => calls
            .iter()
            .map(|call| if call.contains("--out axis.toml") { call.clone() } else { call.replace(PROJECT, &own) })
            .collect(),
        None if reads && !is_written => {
            std::iter::once(typed(["antrieb", "new", "screw", "--out", PROJECT])).chain(calls).collect()
        }
        None => calls,
    }
}

/// Returns calls to begin with, for one without a command, with an unknown one, or with the first words of several: the examples of
/// the commands that it may mean.
fn first_calls(error: &clap::Error, arguments: &[OsString]) -> Vec<String> {
    /// Commands that show most of the program.
    const MOST: [&str; 4] = ["new", "size", "check", "report"];
    let examples = super::examples();
    let named = |name: &str| examples.iter().find(|(of, _)| *of == name).map(|(_, call)| call.clone());
    let words: Vec<&str> =
        arguments.iter().skip(1).filter_map(|word| word.to_str()).filter(|word| !word.starts_with('-')).collect();
    let is_near = matches!(error.kind(), ErrorKind::InvalidSubcommand)
        && context(error, ContextKind::SuggestedSubcommand).is_some_and(|near| !near.is_empty());
    match (error.kind(), &words[..]) {
        (ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand, []) => {
            MOST.into_iter().filter_map(named).collect()
        }
        (
            ErrorKind::MissingSubcommand
            | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
            | ErrorKind::InvalidSubcommand,
            [above, ..],
        ) if super::ABOVE.iter().any(|(name, _)| name == above) => {
            let begin = format!("{above} ");
            examples.iter().filter(|(of, _)| of.starts_with(&begin)).map(|(_, call)| call.clone()).collect()
        }
        (ErrorKind::InvalidSubcommand, [word, ..]) => {
            let meant = words::spoken::commands_meant(word);
            if meant.is_empty() && !is_near {
                let calls = calls_of_words(&words);
                if !calls.is_empty() {
                    return calls;
                }
            }
            let meant = if meant.is_empty() && !is_near { &MOST } else { meant };
            meant.iter().filter_map(|name| named(name)).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns calls about the things that the words of a call without a command name: its projects, its code, the kind of a machine.
fn calls_of_words(words: &[&str]) -> Vec<String> {
    /// Commands about a code that show most.
    const OF_A_CODE: [&str; 2] = ["code", "data"];
    let projects: Vec<&str> =
        words.iter().copied().filter(|word| has_ending(word, &[".toml"]) && Path::new(word).exists()).collect();
    if let [first, ..] = projects[..] {
        return vec![typed([super::NAME, "size"].into_iter().chain(projects)), typed([super::NAME, "report", first])];
    }
    if let Some(code) = words.iter().find(|word| seems_code(word)) {
        let about =
            |entry: &&Entry| entry.reads == Reads::Nothing && entry.arguments.iter().any(|each| each.name == "code");
        let named = LIST.iter().copied().filter(about).filter_map(|entry| {
            let of_words =
                |argument: &&Argument| matches!(argument.kind, ArgumentKind::Word(_)) && argument.name != "code";
            let (argument, word) = entry
                .arguments
                .iter()
                .filter(of_words)
                .find_map(|argument| words.iter().find_map(|word| Some((argument.name, argument.word(word)?))))?;
            let words = [super::NAME].into_iter().chain(entry.command().split(' '));
            let option = format!("--{argument}");
            Some(typed(words.chain([*code, &option, word])))
        });
        let named: Vec<String> = named.take(1).collect();
        let plain = || OF_A_CODE.map(|command| typed([super::NAME, command, code])).to_vec();
        return if named.is_empty() { plain() } else { named };
    }
    // A sentence in quotation marks is one word.
    let single: Vec<&str> =
        words.iter().flat_map(|word| word.split([' ', ','])).filter(|word| !word.is_empty()).collect();
    let found = (0..single.len()).find_map(|from| kind(single.get(from..)?)).map(|(kind, _)| kind);
    let calls = |kind: String| {
        let file = format!("{kind}.toml");
        vec![typed([super::NAME, "new", &kind, "--out", &file]), typed([super::NAME, "size", &file])]
    };
    found.map(calls).unwrap_or_default()
}

/// Returns the call that creates the project of a call that lacks it, in a folder without projects.
fn missing_project(usage: &Usage, call: &str) -> Option<String> {
    let is_missing =
        matches!(usage, Usage::Missing { names } if names.contains("<PROJECT>") || names.contains("<PROJEKT>"));
    let out = call
        .split(' ')
        .find(|word| word.ends_with(".toml"))
        .filter(|_| is_missing && projects_in(Path::new("")).is_empty())?;
    Some(typed(["antrieb", "new", "screw", "--out", out]))
}

/// Returns the answer to a call with a word that nothing takes.
pub(crate) fn stray(
    stray: &Stray,
    (command, arguments): (&Command, &[OsString]),
    keep: Keep<'_>,
    as_json: bool,
    language: Language,
) -> CommandAnswer {
    let Some(called) = Called::of(arguments, command, language) else { return CommandAnswer::none() };
    let (usage, hint) = match called.missing_project() {
        Some(missing) => {
            let own = projects_in(Path::new(""));
            let names: Vec<&str> = own.iter().filter_map(|path| path.to_str()).collect();
            let hint = if names.is_empty() { UsageHint::Help } else { UsageHint::Words(nearest_name(missing, &names)) };
            (Usage::NoFile { written: seen(missing).into_owned() }, Some(hint))
        }
        None => stray.fault(&called, arguments),
    };
    let is_call = matches!(hint, Some(UsageHint::Calls(_)));
    let hint = hint.and_then(keep).or(is_call.then_some(UsageHint::Help));
    said((&usage, None), hint.as_slice(), String::new(), (as_json, language))
}

/// Returns a fault with its hints: for the terminal the last one below those that `shown` replaces.
fn said(
    (usage, option): (&Usage, Option<String>),
    hints: &[UsageHint],
    kinds: String,
    (as_json, language): (bool, Language),
) -> CommandAnswer {
    let message = usage_text(usage, language);
    let texts: Vec<String> = hints.iter().map(|hint| usage_hint(hint, language)).collect();
    let line = |hint: &String| format!("  {}\n", hint.replace('\n', "\n  "));
    let shown = if kinds.is_empty() { texts.iter().map(line).collect() } else { kinds };
    let talk = format!("{}: {message}\n{shown}\n{}\n", library::error(language), library::more(language));
    let hint = (!texts.is_empty()).then(|| texts.join("\n"));
    let fault = Fault { id: Some("usage"), option, message, hint, ..Fault::default() };
    let data = if as_json { written(&Faults::from(vec![fault])) } else { String::new() };
    CommandAnswer { data, talk, code: 2, ..CommandAnswer::none() }
}

/// Returns the command that is called.
fn called<'c>(command: &'c Command, arguments: &[OsString]) -> &'c Command {
    arguments.iter().skip(1).fold(command, |of, word| of.find_subcommand(word).unwrap_or(of))
}

/// Returns the valid values of the argument that a call lacks; empty if it lacks none, several, or one whose values cannot
/// be listed.
fn missing(error: &clap::Error, command: &Command, arguments: &[OsString]) -> Vec<String> {
    let name = match (error.kind(), error.get(ContextKind::InvalidArg)) {
        (ErrorKind::MissingRequiredArgument, Some(ContextValue::Strings(names))) if names.len() == 1 => names.first(),
        _ => None,
    };
    let Some(name) = name else { return Vec::new() };
    let argument = called(command, arguments).get_arguments().find(|argument| argument.to_string() == *name);
    let values = argument.map(clap::Arg::get_possible_values).unwrap_or_default();
    values.iter().map(|value| value.get_name().to_owned()).collect()
}

/// Returns the kinds of project files with a line each; empty if other values are missing.
fn kinds(missing: &[String], language: Language) -> String {
    let width = missing.iter().map(String::len).max().unwrap_or(0);
    let line = |kind: &String| Some(format!("  {kind:width$}  {}\n", kind_about(kind, language)?));
    missing.iter().map(line).collect::<Option<String>>().unwrap_or_default()
}

fn context(error: &clap::Error, kind: ContextKind) -> Option<String> {
    let text = match error.get(kind)? {
        ContextValue::String(text) => text.clone(),
        ContextValue::Strings(texts) => texts.join(", "),
        _ => return None,
    };
    Some(seen(&text).into_owned())
}

fn usage_of(error: &clap::Error) -> Usage {
    let of = |kind| context(error, kind).unwrap_or_default();
    let name = || of(ContextKind::InvalidArg);
    match error.kind() {
        ErrorKind::InvalidSubcommand => Usage::UnknownCommand { written: of(ContextKind::InvalidSubcommand) },
        ErrorKind::UnknownArgument => Usage::UnknownOption { written: name() },
        ErrorKind::MissingRequiredArgument => Usage::Missing { names: name() },
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => match of(ContextKind::InvalidValue) {
            written if written.is_empty() => Usage::ValueMissing { name: name() },
            written => Usage::BadValue { written, name: name() },
        },
        ErrorKind::ArgumentConflict => Usage::Twice { name: name() },
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => Usage::NoCommand,
        ErrorKind::InvalidUtf8 => Usage::NotUtf8,
        _ => Usage::Other,
    }
}

fn hint_of(error: &clap::Error, missing: &[String]) -> Option<UsageHint> {
    if !missing.is_empty() {
        return Some(UsageHint::Words(Hint::ValidAre(missing.to_vec())));
    }
    let near = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    let unknown = context(error, ContextKind::InvalidArg).unwrap_or_default();
    let is_meant = |near: &String| !near.is_empty() && may_mean(&unknown, near);
    if let Some(near) = near.into_iter().find_map(|kind| context(error, kind)).filter(is_meant) {
        return Some(UsageHint::Words(Hint::DidYouMean(near)));
    }
    if let Some(ContextValue::Strings(valid)) = error.get(ContextKind::ValidValue)
        && !valid.is_empty()
    {
        return Some(UsageHint::Words(Hint::ValidAre(valid.clone())));
    }
    match error.kind() {
        // The reason of the library holds the bounds; a text that is no number has none.
        ErrorKind::ValueValidation => {
            let reason = error.source().map(ToString::to_string).unwrap_or_default();
            let bounds = reason.split_once(" is not in ").and_then(|(_, range)| range.split_once(".."));
            Some(match bounds {
                Some((from, to)) => UsageHint::Range(from.to_owned(), to.trim_start_matches('=').to_owned()),
                None => UsageHint::WholeNumber,
            })
        }
        _ => Some(UsageHint::Help),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::build_for;
    use questions::list::new::template_kinds;

    /// Returns the answer to a call with an argument missing.
    fn refused_for(call: &str, as_json: bool, language: Language) -> CommandAnswer {
        let arguments: Vec<OsString> = call.split(' ').map(OsString::from).collect();
        let mut command = build_for(&arguments, language);
        let error = command.try_get_matches_from_mut(&arguments).unwrap_err();
        refused(&error, (&command, &arguments), &Some, as_json, language)
    }

    #[test]
    fn a_missing_word_of_a_fixed_set_is_answered_by_the_set() {
        for (language, scissor, valid) in [
            (Language::En, "scissor lift with a screw", "valid here"),
            (Language::De, "Scherenhubtisch mit Spindel", "zulässig"),
        ] {
            let found = refused_for("antrieb new", false, language);
            assert_eq!((found.code, found.data.as_str()), (2, ""), "{language:?}");
            for kind in template_kinds().chain(["sweep", "catalogue"]) {
                let about = kind_about(kind, language).unwrap();
                let line = found.talk.lines().find(|line| line.trim_start().starts_with(&format!("{kind} "))).unwrap();
                assert!(line.ends_with(about) && about.len() > 9, "{kind}: {line}");
            }
            assert!(found.talk.contains(scissor), "{}", found.talk);
            assert!(refused_for("antrieb new", true, language).data.contains("manual, table, arm"));
            let talk = refused_for("antrieb plot axis.toml", false, language).talk;
            assert!(talk.contains("candidate_map") && talk.contains(valid), "{talk}");
            // Several ways to go on, and a file, have no list of values.
            assert!(refused_for("antrieb commission CHA-25A-50-H-C1024", false, language).talk.contains("--help"));
            assert!(refused_for("antrieb sweep", false, language).talk.contains("--help"));
        }
    }
}
