//! Options and arguments of the command-line library.

use clap::builder::{
    IntoResettable, PossibleValue, PossibleValuesParser, StringValueParser, StyledStr, TypedValueParser,
};
use clap::{Arg, ArgAction, Command, value_parser};
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind};
use std::ffi::OsStr;

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
