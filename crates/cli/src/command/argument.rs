//! Options and arguments of the command-line library.

use clap::builder::{
    IntoResettable, PossibleValue, PossibleValuesParser, StringValueParser, StyledStr, TypedValueParser,
};
use clap::{Arg, ArgAction, Command, value_parser};
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind};
use std::ffi::OsStr;
use words::pages;

/// Creates an option with a value.
pub(super) fn text(name: &'static str, value: &'static str, help: impl IntoResettable<StyledStr>) -> Arg {
    Arg::new(name).long(name).value_name(value).help(help)
}

/// Creates an option without a value.
pub(super) fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
}

/// Words that the help lists as the possible values; the question itself reports invalid ones.
#[derive(Clone)]
struct AnyOf(Vec<&'static str>);

impl TypedValueParser for AnyOf {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(PossibleValue::new)))
    }
}

/// Words of which one is meant, in any spelling that the argument takes; the library reports others.
#[derive(Clone)]
struct OneOf(Argument, Vec<&'static str>);

impl TypedValueParser for OneOf {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        match value.to_str() {
            Some(text) if self.0.takes(text) => Ok(text.to_owned()),
            _ => PossibleValuesParser::new(self.1.clone()).parse_ref(command, arg, value),
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.1.iter().map(PossibleValue::new)))
    }
}

/// Largest number of words of a choice that the help of an option lists.
pub(super) const CHOICE_MOST: usize = 12;

/// Returns an argument whose help names the words of its choice and its default, as they are declared.
pub(super) fn with_choice_and_default(argument: Arg, language: Language) -> Arg {
    if argument.is_positional() || !argument.get_action().takes_values() {
        return argument;
    }
    let mut help = argument.get_help().map(ToString::to_string).unwrap_or_default();
    let words = words_of(&argument);
    if (2..=CHOICE_MOST).contains(&words.len()) && !words.iter().all(|word| help.contains(word)) {
        help = format!("{help}; {}", pages::one_of(&words.join(", "), language));
    }
    let usual = usual_of(&argument);
    let is_named = words.is_empty() && help.contains(&usual);
    if !usual.is_empty() && !is_named {
        help = format!("{help} ({usual})");
    }
    argument.help(help)
}

/// Returns the words of the choice of an argument.
fn words_of(argument: &Arg) -> Vec<String> {
    argument.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect()
}

/// Returns the declared default of an argument; empty without one.
fn usual_of(argument: &Arg) -> String {
    let usual = argument.get_default_values().iter().map(|value| value.to_string_lossy().into_owned());
    usual.collect::<Vec<_>>().join(", ")
}

/// Returns the help of an argument without the words of its choice and without its default.
#[cfg(test)]
pub(crate) fn plain_help(argument: &Arg, language: Language) -> String {
    let help = argument.get_help().map(ToString::to_string).unwrap_or_default();
    let listed = words_of(argument).join(", ");
    let help = help.strip_suffix(&format!(" ({})", usual_of(argument))).unwrap_or(&help);
    let choice = format!("; {}", pages::one_of(&listed, language));
    help.strip_suffix(&choice).or_else(|| help.strip_suffix(&format!(": {listed}"))).unwrap_or(help).to_owned()
}

/// Converts an argument for the command-line library.
pub(super) fn of(argument: &Argument, language: Language) -> Arg {
    let words = argument.words();
    let about = if argument.required && !words.is_empty() {
        // A call without a valid word fails, so the help lists them.
        format!("{}: {}", (argument.about)(language), words.join(", "))
    } else {
        (argument.about)(language).to_owned()
    };
    let mut arg = Arg::new(argument.name).help(about).required(argument.required);
    arg = match argument.form {
        ArgumentForm::Option => arg.long(argument.name),
        ArgumentForm::Bare => arg,
        ArgumentForm::Words | ArgumentForm::Each if argument.required => arg.num_args(1..),
        ArgumentForm::Words | ArgumentForm::Each => arg.num_args(0..),
    };
    if let ArgumentKind::Flag = argument.kind {
        return arg.action(ArgAction::SetTrue);
    }
    arg = arg.value_name((argument.value)(language)).allow_hyphen_values(argument.signed);
    arg = match argument.kind {
        ArgumentKind::Whole(least, most) => arg.value_parser(value_parser!(u64).range(least..=most)),
        // A list, or a title, is no possible value for the library.
        ArgumentKind::Word(_) if argument.is_list() || argument.titles.is_some() => arg.value_parser(AnyOf(words)),
        ArgumentKind::Word(_) => arg.value_parser(OneOf(*argument, words)),
        ArgumentKind::Text | ArgumentKind::Code | ArgumentKind::Date | ArgumentKind::File | ArgumentKind::Flag => arg,
    };
    if argument.repeated && argument.form == ArgumentForm::Option {
        arg = arg.action(ArgAction::Append);
    }
    if let Some(usual) = argument.usual {
        arg = arg.default_value(usual);
    }
    if let Some(needs) = argument.needs {
        arg = arg.requires(needs);
    }
    match argument.instead_of {
        Some(other) => arg.conflicts_with(other),
        None => arg,
    }
}
