//! A call from its words to the arguments of the command-line library.

use super::meant::{Called, Stray, Understood};
use super::{begun, build_for, json_of, language_of, ratio, replaced, spoken, states_language, with_help_asked};
use clap::{ArgMatches, Command};
use quantities::Language;
use std::ffi::OsString;

/// A call as it is meant, with the command line that reads it.
pub(crate) struct ParsedCall {
    pub(crate) arguments: Vec<OsString>,
    pub(crate) command: Command,
    pub(crate) language: Language,
    pub(crate) as_json: bool,
    /// Remark on what the call does not state.
    pub(crate) remark: Option<String>,
    pub(crate) matches: Result<ArgMatches, Misread>,
}

/// Reason why a call cannot be parsed.
pub(crate) enum Misread {
    /// A word that nothing takes.
    Stray(Stray),
    /// Error of the library, or its help.
    Library(clap::Error),
}

impl ParsedCall {
    /// Parses a call, whose first word is the name of the program.
    pub(crate) fn of(call: Vec<OsString>) -> Self {
        let is_german = spoken::is_german(&call);
        let mut arguments = with_help_asked(call.into_iter());
        if is_german && !states_language(&arguments) {
            arguments.insert(1, "--lang=de".into());
        }
        let mut language = language_of(arguments.iter().cloned());
        let (arguments, is_begun) = begun::with_command(arguments, language);
        let (arguments, is_of_ratio) = ratio::with_codes(arguments, language);
        let is_begun = is_begun || is_of_ratio;
        let as_json = json_of(&arguments);
        let mut command = build_for(&arguments, language);
        let arguments = with_help_alone(arguments, &command, language);
        let (found, remark) = replaced::understood(arguments, is_begun, &command, language);
        let Understood { arguments, stray } = found;
        // A language without its option is known only now.
        let meant = language_of(arguments.iter().cloned());
        if meant != language {
            language = meant;
            command = build_for(&arguments, language);
        }
        let matches = match stray {
            Some(stray) => Err(Misread::Stray(stray)),
            None => command.try_get_matches_from_mut(&arguments).map_err(Misread::Library),
        };
        Self { arguments, command, language, as_json, remark, matches }
    }
}

/// Returns a call that requests the help of its command without its other words, which the help does not depend on: the library
/// reads the words first, and refuses those that only have a meaning to [`replaced::understood`].
fn with_help_alone(mut arguments: Vec<OsString>, whole: &Command, language: Language) -> Vec<OsString> {
    let Some(begin) = Called::of(&arguments, whole, language).map(|called| called.begin) else { return arguments };
    let mut words = arguments.iter().skip(begin).take_while(|word| *word != "--");
    if words.any(|word| word == "--help" || word == "-h") {
        arguments.truncate(begin);
        arguments.extend([format!("--lang={}", language.id()), "--help".to_owned()].map(OsString::from));
    }
    arguments
}
