//! Command of a question: arguments and files from the list, and the options of its layout.

use super::own;
use crate::layout::Layout;
use clap::builder::{PossibleValue, PossibleValuesParser, StringValueParser, TypedValueParser};
use clap::{Arg, ArgAction, Command, value_parser};
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind, Entry, Gives, OutputFile, Reads, media};
use std::ffi::OsStr;
use words::help::{self, values};

/// Returns the command of a question without its arguments, for the list of commands.
pub(super) fn listed(entry: &Entry, language: Language) -> Command {
    let is_pdf = matches!(entry.gives, Gives::Media(media) if media.contains(&media::PDF));
    Command::new(super::last(entry)).about(with_report(is_pdf, (entry.about)(language), language))
}

/// Returns the command of a question.
pub(super) fn command(entry: &'static Entry, language: Language) -> Command {
    let questions: Vec<&Entry> = std::iter::once(entry).chain(entry.others()).collect();
    // The extension of a file decides its format, so that no argument is needed.
    let by_ending = entry.files().any(|file| file.media.len() > 1);
    let mut arguments: Vec<&Argument> = Vec::new();
    for argument in questions.iter().flat_map(|question| question.arguments) {
        let is_known = arguments.iter().any(|known| known.name == argument.name);
        let is_said_by_ending = by_ending && argument.name == "format";
        if !is_known && !is_said_by_ending {
            arguments.push(argument);
        }
    }
    let mut command = listed(entry, language);
    // A file without an option stands before the project that it is about.
    let is_first =
        |argument: &&Argument| matches!((argument.kind, argument.form), (ArgumentKind::File, ArgumentForm::Bare));
    command = command
        .args(arguments.iter().copied().filter(|argument| is_first(argument)).map(|argument| of(argument, language)));
    command = command.args(sources(entry, language));
    for argument in arguments.iter().copied().filter(|argument| !is_first(argument)) {
        let option = of(argument, language);
        let option = match arguments.iter().find(|other| other.instead_of == Some(argument.name)) {
            Some(other) => option.required_unless_present(other.name),
            None => option,
        };
        command = command.arg(option);
    }
    command = command.args(questions.iter().skip(1).flat_map(|other| sources(other, language)));
    command = command.args(entry.files().map(|file| output(file, language)));
    if let Some(layout) = Layout::of(entry) {
        command = (layout.own)(command, language);
    }
    if entry.files().next().is_some() {
        command = command.arg(own::flag("force", help::force(language)));
    }
    command
}

/// Returns a help text; for a PDF with a remark if the program was built without the typesetting engine.
fn with_report(is_pdf: bool, help: &str, language: Language) -> String {
    if is_pdf && cfg!(not(feature = "report")) {
        format!("{help} ({})", help::not_in_this_build(language))
    } else {
        help.to_owned()
    }
}

fn file(name: &'static str, value: &'static str, help: &str) -> Arg {
    Arg::new(name).value_name(value).value_parser(value_parser!(std::path::PathBuf)).help(help.to_owned())
}

/// Creates the option of an output file.
fn output(written: &OutputFile, language: Language) -> Arg {
    let help = with_report(written.is_pdf(), (written.about)(language), language);
    let mut option =
        file(written.option, values::file(language), &help).long(written.option).required(written.required);
    if written.option == "out" {
        option = option.short('o');
    }
    match written.needs {
        Some(needs) => option.requires(needs),
        None => option,
    }
}

/// Returns the arguments for the files that a question is about: those of an option, else the words behind the command.
fn sources(entry: &Entry, language: Language) -> Vec<Arg> {
    let l = language;
    if let Some(option) = entry.option() {
        let help = match entry.reads {
            Reads::Project => help::mount_project(l),
            Reads::Pins => help::wiring_check(l),
            Reads::Measured => help::commission_record(l),
            // The option names an output file.
            Reads::Nothing | Reads::TwoProjects => return Vec::new(),
        };
        return vec![file(option, values::file(l), help).long(option)];
    }
    let words = match entry.reads {
        Reads::Project => vec![file("project", values::project(l), help::project(l))],
        Reads::TwoProjects => vec![
            file("old", values::old(l), help::diff_old(l)),
            file("new", values::new(l), help::diff_new(l)).display_order(2),
        ],
        Reads::Nothing | Reads::Pins | Reads::Measured => Vec::new(),
    };
    words.into_iter().map(|word| word.required(true)).collect()
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
        ArgumentKind::Word(_) => arg.value_parser(PossibleValuesParser::new(words)),
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
