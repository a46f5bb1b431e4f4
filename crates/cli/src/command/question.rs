//! Command of a question: arguments and files from the list, and the options of its layout.

use super::argument;
use crate::layout::Layout;
use clap::{Arg, Command, value_parser};
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind, Entry, Gives, OutputFile, Reads, media};
use words::help::{self, values};

/// Returns the last word of a command.
pub(super) fn last(entry: &Entry) -> &'static str {
    entry.command().rsplit(' ').next().unwrap_or_default()
}

/// Returns the command of a question without its arguments, for the list of commands.
pub(super) fn listed(entry: &Entry, language: Language) -> Command {
    let is_pdf = matches!(entry.gives, Gives::Media(media) if media.contains(&media::PDF));
    Command::new(last(entry)).about(with_report(is_pdf, (entry.about)(language), language))
}

/// Returns the command of a question.
pub(super) fn command(entry: &'static Entry, language: Language) -> Command {
    let questions: Vec<&Entry> = std::iter::once(entry).chain(entry.others()).collect();
    // The extension of a file decides its format, so that no argument is needed besides a record on standard output.
    let by_ending = entry.gives.is_record() && entry.files().any(|file| file.media.len() > 1);
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
    command = command.args(
        arguments
            .iter()
            .copied()
            .filter(|argument| is_first(argument))
            .map(|argument| argument::of(argument, language)),
    );
    command = command.args(sources(entry, language));
    for argument in arguments.iter().copied().filter(|argument| !is_first(argument)) {
        let option = argument::of(argument, language);
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
        command = command.arg(argument::flag("force", help::force(language)));
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
        // Several axes are compared by their best actuators, or written into one workbook.
        Reads::Project if entry.command == "size" => {
            vec![file("project", values::project(l), help::projects(l)).num_args(1..)]
        }
        Reads::Project if entry.command == "export" => {
            vec![file("project", values::project(l), help::project(l)).num_args(1..)]
        }
        Reads::Project => vec![file("project", values::project(l), help::project(l))],
        Reads::TwoProjects => vec![
            file("old", values::old(l), help::diff_old(l)),
            file("new", values::new(l), help::diff_new(l)).display_order(2),
        ],
        Reads::Measured => vec![file("files", values::file(l), help::catalogue_check_files(l)).num_args(1..)],
        Reads::Nothing | Reads::Pins => Vec::new(),
    };
    words.into_iter().map(|word| word.required(true)).collect()
}
