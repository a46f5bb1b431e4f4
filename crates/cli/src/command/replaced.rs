//! Words of a call in place of others: options by their own names, the best actuator in place of its project.

use super::best::{ProjectOfCall, best_coded, best_products};
use super::completed;
use super::folder::is_project;
use super::kind::kind;

use super::meant::{self, Called, Part, Understood};
use super::solid;
use super::spoken::{seems_code, twin_options};
use super::typed::typed;
use super::unknown;
use crate::changed::Statements;
use clap::Command;
use quantities::Language;
use std::ffi::OsString;
use std::path::Path;
use words::terminal;

/// Returns a call as it is meant, with remarks on what it does not state; `is_begun` says that its command was added.
pub(crate) fn understood(
    arguments: Vec<OsString>,
    is_begun: bool,
    whole: &Command,
    language: Language,
) -> (Understood, Option<String>) {
    let arguments = with_one_word_for_kind(arguments, whole, language);
    let (arguments, is_named) = with_ending_of_project(arguments, whole, language);
    let (arguments, project) = completed::with_project(arguments, whole, language);
    let arguments = with_own_options(arguments, whole, language);
    let (arguments, is_changed) = unknown::with_meaning(arguments, whole, language);
    let (arguments, is_otherwise) = solid::with_own_words(arguments, whole, language);
    let (arguments, is_of_code) = without_project(arguments, whole, language);
    let (arguments, completed) = completed::completed(arguments, whole, language);
    let (arguments, remark) = with_best_code(arguments, whole, language);
    let (arguments, compared) = with_compared_codes(arguments, whole, language);
    let understood = meant::understood(arguments, whole, language);
    let is_whole = (is_begun || is_named || is_changed || is_otherwise || is_of_code) && understood.stray.is_none();
    let call = is_whole.then(|| {
        let words = understood.arguments.iter().skip(1).filter_map(|word| word.to_str());
        terminal::call_understood(&typed(std::iter::once(super::NAME).chain(words)), language)
    });
    let remarks: Vec<String> =
        project.into_iter().chain(completed).chain([call, remark, compared].into_iter().flatten()).collect();
    (understood, (!remarks.is_empty()).then(|| remarks.join("\n")))
}

/// Returns a call about a new project with the name of its kind as one word.
fn with_one_word_for_kind(mut arguments: Vec<OsString>, whole: &Command, language: Language) -> Vec<OsString> {
    let Some(called) = Called::of(&arguments, whole, language) else { return arguments };
    let is_of_project = called.command.get_positionals().any(|position| position.get_id() == "project");
    let words: Vec<&str> = called.first.iter().map(String::as_str).collect();
    let kind = kind(&words).filter(|(_, count)| is_of_project && *count > 1);
    let begin = called.begin;
    if let Some((kind, count)) = kind {
        arguments.splice(begin..begin + count, [OsString::from(kind)]);
    }
    arguments
}

/// Returns a call with the file of a project that it names without its ending, and `true` if there was one: `size lift`.
fn with_ending_of_project(mut arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let file = Called::of(&arguments, whole, language).and_then(|called| {
        let word = called.first.first().filter(|word| !word.contains(['.', '*', '?']) && !Path::new(word).exists())?;
        let file = format!("{word}.toml");
        let position = called.command.get_positionals().next()?;
        let reads = called.entry.is_some_and(|entry| !entry.command().contains(' '))
            && (["project", "old"].contains(&position.get_id().as_str()) || called.is_code(position));
        (reads && is_project(Path::new(&file))).then_some((called.begin, file))
    });
    let Some((place, file)) = file else { return (arguments, false) };
    if let Some(word) = arguments.get_mut(place) {
        *word = file.into();
    }
    (arguments, true)
}

/// Returns a comparison with the best actuators of the project behind the only code that it states, or in place of codes, and
/// a remark on them.
fn with_compared_codes(
    mut arguments: Vec<OsString>,
    whole: &Command,
    language: Language,
) -> (Vec<OsString>, Option<String>) {
    let more = || {
        let called = Called::of(&arguments, whole, language)?;
        // A record states what the call does; a call with options is complete.
        let is_plain = !super::json_of(&arguments) && arguments.iter().all(|word| word != "--code");
        called.entry.filter(|entry| entry.command == "compare" && is_plain)?;
        let texts: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let project = called.projects.first()?.to_str()?;
        let codes: Vec<String> =
            called.parts(&texts)?.iter().filter_map(|part| code_of(part, &called, language)).collect();
        more_codes(&ProjectOfCall::of_call(project, &arguments, &called)?, &codes)
    };
    let Some(more) = more() else { return (arguments, None) };
    for code in &more {
        arguments.extend(["--code".into(), code.into()]);
    }
    (arguments, Some(terminal::compared_with_the_best(&more.join(", "), language)))
}

/// Smallest number of actuators that are compared.
const COMPARED_LEAST: usize = 2;

/// Returns the best codes of a project that a comparison of some codes lacks; `None` if it lacks none, or there are too few.
pub(super) fn more_codes(project: &ProjectOfCall, codes: &[String]) -> Option<Vec<String>> {
    let due = COMPARED_LEAST.checked_sub(codes.len()).filter(|due| *due > 0)?;
    let best = best_products(project, COMPARED_LEAST + codes.len(), |_| true);
    let more: Vec<String> = best.into_iter().filter(|code| !codes.contains(code)).take(due).collect();
    (more.len() == due).then_some(more)
}

/// Returns the code that a part of a call states.
pub(super) fn code_of(part: &Part<'_>, called: &Called<'_>, language: Language) -> Option<String> {
    let word = match part {
        Part::Bare(_, word) if seems_code(word) || called.is_product(word) => word,
        Part::Option(option, Some(value)) if option.get_long() == Some("code") => value,
        _ => return None,
    };
    Some(questions::read_code(word, language).map_or_else(|_| (*word).to_owned(), |read| read.parsed.code.to_string()))
}

/// Changes of a project, and their words in the call.
type OfBest = (Statements, Vec<OsString>);

/// Removes the changes of a project from a call about an ordering code, whose command has no options for them: they decide which
/// actuator is the best.
fn with_changes_of_best(arguments: &mut Vec<OsString>, whole: &Command, language: Language) -> Option<OfBest> {
    let called = Called::of(arguments, whole, language)?;
    let is_of_code = called.command.get_positionals().next().is_some_and(|position| called.is_code(position));
    if !is_of_code || called.has("set") || called.projects.is_empty() {
        return None;
    }
    let of_project: &[&str] = if called.has("axis") { &["--set", "--scale"] } else { &["--set", "--scale", "--axis"] };
    let is_change = |word: &OsString| {
        word.to_str().is_some_and(|word| of_project.iter().any(|option| word.split('=').next() == Some(option)))
    };
    let (mut kept, mut taken) = (Vec::new(), Vec::new());
    let mut words = arguments.iter().cloned();
    while let Some(word) = words.next() {
        if !is_change(&word) {
            kept.push(word);
            continue;
        }
        let has_value = word.to_str().is_some_and(|word| word.contains('='));
        taken.push(word);
        taken.extend((!has_value).then(|| words.next()).flatten());
    }
    let texts: Vec<&str> = taken.iter().filter_map(|word| word.to_str()).collect();
    let stated = (!texts.is_empty()).then(|| Statements::of_words(&texts))?;
    *arguments = kept;
    Some((stated, taken))
}

/// Returns a call about an ordering code without the project that it names besides, which the answer does not depend on, and `true`
/// if there was one: `commission axis.toml CODE`.
fn without_project(mut arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let place = || {
        let called = Called::of(&arguments, whole, language)?;
        called.command.get_positionals().next().filter(|position| called.is_code(position))?;
        let texts: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let parts = called.parts(&texts)?;
        let bare = || {
            parts.iter().filter_map(|part| match part {
                Part::Bare(place, word) => Some((*place, *word)),
                Part::Option(..) => None,
            })
        };
        let is_project = |word: &str| called.projects.iter().any(|path| path == Path::new(word));
        let is_code = |word: &str| seems_code(word) && questions::read_code(word, language).is_ok();
        let (place, _) = bare().find(|(_, word)| is_project(word))?;
        // The project stays where an option of the command reads it.
        bare().any(|(_, word)| is_code(word)).then(|| (place, called.has("project")))
    };
    let Some((place, is_read)) = place() else { return (arguments, false) };
    if is_read {
        arguments.insert(place, "--project".into());
    } else {
        arguments.remove(place);
    }
    (arguments, true)
}

/// Returns a call about one actuator with the best one of a project that stands in place of its code, and a remark on it.
fn with_best_code(
    mut arguments: Vec<OsString>,
    whole: &Command,
    language: Language,
) -> (Vec<OsString>, Option<String>) {
    let stated = with_changes_of_best(&mut arguments, whole, language);
    let best = || {
        let called = Called::of(&arguments, whole, language)?;
        let texts: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let parts = called.parts(&texts)?;
        let mut bare = parts.iter().filter_map(|part| match part {
            Part::Bare(place, word) => Some((*place, *word)),
            Part::Option(..) => None,
        });
        let is_stated = bare.clone().any(|(_, word)| {
            seems_code(word) || called.is_product(word) || questions::read_code(word, language).is_ok()
        });
        let (place, project) = bare.find(|(_, word)| called.projects.iter().any(|path| path == Path::new(word)))?;
        let is_due =
            called.command.get_positionals().next().is_some_and(|position| called.is_code(position)) && !is_stated;
        let of_project = || match &stated {
            Some((stated, _)) => ProjectOfCall::changed(project, stated, &arguments, language),
            None => ProjectOfCall::of_call(project, &arguments, &called),
        };
        let code = is_due.then(of_project).flatten().and_then(|project| best_coded(&project))?;
        // The project stays where an option of the command reads it.
        let kept = called.has("project").then(|| ["--project".to_owned(), project.to_owned()]);
        Some((place, code, kept))
    };
    let Some((place, code, kept)) = best() else {
        // Without a choice the options stay, and are refused.
        arguments.extend(stated.into_iter().flat_map(|(_, words)| words));
        return (arguments, None);
    };
    let mut remark = terminal::best_of_the_ranking(&code, language);
    if let Some((Statements { sets, scales, .. }, _)) = &stated {
        let made: Vec<String> = sets.iter().chain(scales).cloned().collect();
        if !made.is_empty() {
            remark = format!("{}\n{remark}", terminal::changed_for_this_call(&made.join("; "), language));
        }
    }
    let words = std::iter::once(code).chain(kept.into_iter().flatten());
    arguments.splice(place..=place, words.map(OsString::from));
    (arguments, Some(remark))
}

/// Returns a call with each option of another name by that of the command.
fn with_own_options(mut arguments: Vec<OsString>, whole: &Command, language: Language) -> Vec<OsString> {
    let Some(called) = Called::of(&arguments, whole, language) else { return arguments };
    let is_known = |name: &str| called.options().any(|option| option.get_long() == Some(name));
    for word in arguments.iter_mut().skip(called.begin).take_while(|word| *word != "--") {
        let Some((name, value)) = word.to_str().and_then(|word| word.strip_prefix("--")).map(|word| {
            let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
            (name.to_owned(), value.map(str::to_owned))
        }) else {
            continue;
        };
        if is_known(&name) {
            continue;
        }
        if let Some(meant) = twin_options(&name).iter().find(|meant| is_known(meant)) {
            *word = value.map_or_else(|| format!("--{meant}"), |value| format!("--{meant}={value}")).into();
        }
    }
    arguments
}
