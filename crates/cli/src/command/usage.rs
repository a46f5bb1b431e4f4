//! Calls that the command-line library rejects, as faults like all others.

use crate::answer::{Answer, written};
use answers::{Fault, Faults};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use project::Hint;
use quantities::{Language, seen};
use std::error::Error as _;
use words::help::library;
use words::{Usage, UsageHint, usage_hint, usage_text};

/// Returns the answer to a call that cannot be parsed.
pub(crate) fn refused(error: &clap::Error, as_json: bool, language: Language) -> Answer {
    let (usage, hint) = (usage_of(error), hint_of(error));
    let (message, hint) = (usage_text(&usage, language), hint.map(|hint| usage_hint(&hint, language)));
    let shown = hint.as_ref().map(|hint| format!("  {hint}\n")).unwrap_or_default();
    let talk = format!("{}: {message}\n{shown}\n{}\n", library::error(language), library::more(language));
    let option = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(name)) => name.strip_prefix("--").map(|name| {
            name.chars().take_while(|sign| sign.is_ascii_alphanumeric() || *sign == '-').collect::<String>()
        }),
        _ => None,
    };
    let fault =
        Fault { id: Some("usage"), option: option.filter(|name| !name.is_empty()), message, hint, ..Fault::default() };
    let faults = Faults::from(vec![fault]);
    let data = if as_json { written(&faults) } else { String::new() };
    Answer { data, talk, code: 2 }
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

fn hint_of(error: &clap::Error) -> Option<UsageHint> {
    let near = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    if let Some(near) = near.into_iter().find_map(|kind| context(error, kind)).filter(|near| !near.is_empty()) {
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
