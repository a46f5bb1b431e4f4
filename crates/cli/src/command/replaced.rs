//! Words of a call in place of others: options by their own names, the best actuator in place of its project.

use super::folder::best_of_project;
use super::meant::{self, Called, Part, Understood};
use super::spoken::{seems_code, twin_options};
use clap::{Arg, Command};
use quantities::Language;
use questions::list::ArgumentKind;
use std::ffi::OsString;
use std::path::Path;
use words::terminal;

/// Returns a call as it is meant, with a remark on a code that it does not state.
pub(crate) fn understood(
    arguments: Vec<OsString>,
    whole: &Command,
    language: Language,
) -> (Understood, Option<String>) {
    let arguments = with_own_options(arguments, whole, language);
    let (arguments, remark) = with_best_code(arguments, whole, language);
    (meant::understood(arguments, whole, language), remark)
}

/// Returns a call about one actuator with the best one of a project that stands in place of its code, and a remark on it.
fn with_best_code(
    mut arguments: Vec<OsString>,
    whole: &Command,
    language: Language,
) -> (Vec<OsString>, Option<String>) {
    let best = || {
        let called = Called::of(&arguments, whole, language)?;
        let is_code = |position: &Arg| {
            let argument = called.entry.and_then(|_| called.argument(position.get_id().as_str()));
            argument.is_some_and(|argument| matches!(argument.kind, ArgumentKind::Code))
        };
        let texts: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let parts = called.parts(&texts)?;
        let mut bare = parts.iter().filter_map(|part| match part {
            Part::Bare(place, word) => Some((*place, *word)),
            Part::Option(..) => None,
        });
        let is_stated = bare.clone().any(|(_, word)| seems_code(word) || questions::read_code(word, language).is_ok());
        let (place, project) = bare.find(|(_, word)| called.projects.iter().any(|path| path == Path::new(word)))?;
        let is_due = called.command.get_positionals().next().is_some_and(is_code) && !is_stated;
        let code = is_due.then(|| best_of_project(&[project], language)).flatten()?;
        // The project stays where an option of the command reads it.
        let kept = called.has("project").then(|| ["--project".to_owned(), project.to_owned()]);
        Some((place, code, kept))
    };
    let Some((place, code, kept)) = best() else { return (arguments, None) };
    let remark = terminal::best_of_the_ranking(&code, language);
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
