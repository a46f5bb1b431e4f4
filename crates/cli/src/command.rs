//! The commands and their help, in English and German.

use crate::answer::CommandAnswer;
use clap::builder::{PossibleValuesParser, Styles};
use clap::{Arg, ArgAction, ArgMatches, Command};
use quantities::Language;
use questions::CheckId;
use questions::list::{Entry, LIST, Unanswered};
use std::ffi::OsString;
use words::help::values;
use words::{Usage, Word, help, usage_text};

pub(crate) use folder::{RECORDINGS, text_of_kind};

const NAME: &str = "antrieb";
const LANG_VARIABLE: &str = "ANTRIEB_LANG";

pub(crate) mod argument;
pub(crate) mod begun;
mod best;
pub(crate) mod checks;
mod completed;
pub(crate) mod effects;
mod example;
mod folder;
mod kind;
pub(crate) mod library;
pub(crate) mod meant;
mod names;
pub(crate) mod own;
pub(crate) mod parsed;
mod proposed;
mod question;
mod ratio;
mod readings;
pub(crate) mod remedy;
pub(crate) mod replaced;
mod solid;
pub(crate) mod spoken;
pub(crate) mod typed;
mod unknown;
pub(crate) mod usage;
pub(crate) mod verified;

/// Returns the requested language: `--lang`, else the variable `ANTRIEB_LANG`, else English. The locale of the machine
/// is not used: the same call gives the same bytes everywhere.
pub(crate) fn language_of(arguments: impl Iterator<Item = OsString>) -> Language {
    let mut wanted = std::env::var(LANG_VARIABLE).ok();
    let mut arguments = arguments.map(|argument| argument.to_string_lossy().into_owned());
    while let Some(argument) = arguments.next() {
        if argument == "--" {
            break;
        } else if argument == "--lang" {
            wanted = arguments.next();
        } else if let Some(value) = argument.strip_prefix("--lang=") {
            wanted = Some(value.to_owned());
        }
    }
    wanted.and_then(|wanted| words::spoken::language_of(&wanted)).unwrap_or_default()
}

/// Returns `true` if a call states its language, or the variable `ANTRIEB_LANG` does.
pub(crate) fn states_language(arguments: &[OsString]) -> bool {
    let is_option = |argument: &OsString| {
        argument.to_str().is_some_and(|text| {
            text == "--lang" || text.starts_with("--lang=") || words::spoken::language_of(text).is_some()
        })
    };
    std::env::var_os(LANG_VARIABLE).is_some() || arguments.iter().any(is_option)
}

/// Returns `true` if JSON is requested, even if the rest of the call is faulty.
pub(crate) fn json_of(arguments: &[OsString]) -> bool {
    let is_json =
        |argument: &OsString| argument.to_str().is_some_and(|text| text == "--json" || text.starts_with("--json="));
    arguments.iter().skip(1).take_while(|argument| *argument != "--").any(is_json)
}

/// Returns the arguments with `--json=1` replaced by the flag, and without `--json=0`.
fn with_plain_flag(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut options = true;
    let plain = |argument: OsString| {
        options &= argument != "--";
        match argument.to_str().filter(|_| options) {
            Some("--json=1" | "--json=true") => Some("--json".into()),
            Some("--json=0" | "--json=false") => None,
            _ => Some(argument),
        }
    };
    arguments.filter_map(plain).collect()
}

fn deadline(language: Language) -> Arg {
    argument::text("deadline", values::time(language), help::deadline(language))
}

/// Builds the whole command line.
pub(crate) fn build(language: Language) -> Command {
    built(language, &|_| true)
}

/// Builds the command line for one call: commands that the call does not name are listed without their arguments, which
/// saves a quarter of a millisecond at each start.
pub(crate) fn build_for(arguments: &[OsString], language: Language) -> Command {
    built(language, &|entry| arguments.iter().any(|word| word == question::last(entry)))
}

fn built(language: Language, is_whole: &dyn Fn(&Entry) -> bool) -> Command {
    library::usage(headed(commands(language, is_whole), "", &examples(), language), language)
}

/// Adds headings and a help flag in the language to a command and all its subcommands; `above` are the words before its name.
fn headed(command: Command, above: &str, examples: &[(&str, String)], language: Language) -> Command {
    let reads_a_project =
        command.get_arguments().any(|argument| ["project", "old"].contains(&argument.get_id().as_str()));
    let command = if reads_a_project {
        command
            .args(own::changes(language))
            .arg(own::catalogue_files(language))
            .arg(deadline(language))
            .arg(own::memory(language))
    } else if PRODUCTS.contains(&command.get_name()) {
        command.arg(own::catalogue_files(language))
    } else {
        command
    };
    let mut command = command
        .disable_help_flag(true)
        .disable_help_subcommand(true)
        .help_template(format!("{{about}}\n\n{}: {{usage}}\n\n{{all-args}}{{after-help}}", help::usage(language)))
        .subcommand_help_heading(help::commands(language))
        .mut_args(|argument| {
            let heading = if argument.is_positional() { help::arguments(language) } else { help::options(language) };
            let takes_value = argument.get_action().takes_values();
            let argument = argument::with_choice_and_default(argument, language);
            argument.help_heading(heading).hide_default_value(takes_value).hide_possible_values(takes_value)
        })
        .arg(
            Arg::new("help")
                .short('h')
                .long("help")
                .action(ArgAction::Help)
                .help_heading(help::options(language))
                .help(help::help_flag(language)),
        );
    if command.get_name() == NAME {
        command = command.disable_version_flag(true).arg(
            Arg::new("version")
                .short('V')
                .long("version")
                .action(ArgAction::Version)
                .help_heading(help::options(language))
                .help(help::version_flag(language)),
        );
    }
    let words = format!("{above} {}", command.get_name()).trim_start().to_owned();
    let example = examples.iter().find(|(name, _)| *name == words);
    if let Some((_, call)) = example {
        let tail = command.get_after_help().map(|text| format!("{text}\n\n")).unwrap_or_default();
        let more = if words == NAME { &EVERYDAY[..] } else { &[] };
        let head = if more.is_empty() { help::example(language) } else { help::examples(language) };
        let calls: String = more.iter().map(|call| format!("\n  {call}")).collect();
        command = command.after_help(format!("{tail}{head}:\n  {call}{calls}"));
    }
    let above = if command.get_name() == NAME { "" } else { words.as_str() };
    command.mut_subcommands(|subcommand| headed(subcommand, above, examples, language))
}

/// Commands about a product without a project.
const PRODUCTS: [&str; 2] = ["curve", "torsion"];

/// Example calls of the commands that only the command line has.
const EXAMPLES: [(&str, &str); 9] = [
    (NAME, "antrieb new screw --out axis.toml && antrieb size axis.toml"),
    ("code", "antrieb code parse CHA-20A-100-H-C1024-B"),
    ("catalogue", "antrieb catalogue export --format csv"),
    ("serve", "antrieb serve --open"),
    ("drive", "antrieb drive CHA-25A-100-H-M512P-B --protocol socketcand"),
    ("completions", "antrieb completions bash"),
    ("man", "antrieb man size"),
    ("help", "antrieb help size"),
    ("schema", "antrieb schema"),
];

/// Further calls below the help of the program, which spare a look at that of a command: another value, a table of values,
/// an event, the temperatures of a day, setpoints, a recording.
pub(crate) const EVERYDAY: [&str; 6] = [
    "antrieb check axis.toml --set motion.1.time=1s --scale load=1.15",
    "antrieb sweep axis.toml --vary mass=20:60:10kg --vary motion.1.time=0.6:1:0.2s",
    "antrieb simulate axis.toml --scenario power_failure",
    "antrieb simulate axis.toml --hours-per-day 16",
    "antrieb moves axis.toml --every 4ms --out setpoints.csv",
    "antrieb size recording.csv",
];

/// Returns one call of each command, by its words; all of them are tested.
pub(crate) fn examples() -> Vec<(&'static str, String)> {
    let own = EXAMPLES.iter().map(|(name, call)| (*name, (*call).to_owned()));
    let call = |entry: &Entry| format!("{NAME} {} {}", entry.command, entry.example).trim_end().to_owned();
    let of_list = LIST.iter().filter(|entry| entry.option().is_none()).map(|entry| (entry.command(), call(entry)));
    own.chain(of_list).collect()
}

/// Returns the arguments with `help COMMAND` replaced by `COMMAND --help`, also behind options that all commands have.
pub(crate) fn with_help_asked(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut arguments = spoken::with_own_words(with_plain_flag(arguments));
    let mut index = 1;
    while let Some(argument) = arguments.get(index).and_then(|argument| argument.to_str()) {
        match argument {
            "--lang" => index += 2,
            "--json" => index += 1,
            "help" if let Some(command) = spoken::helping(arguments.get(index + 1)) => {
                if let Some(word) = arguments.get_mut(index) {
                    *word = command.into();
                }
                return arguments;
            }
            "help" => {
                let _ = arguments.remove(index);
                // The flag stands before the rest, because the call that needs help may be incomplete.
                let words = arguments.iter().skip(index).take_while(|word| !word.to_string_lossy().starts_with('-'));
                let end = index + words.count();
                arguments.insert(end, "--help".into());
                return arguments;
            }
            other if other.starts_with("--lang=") => index += 1,
            _ => return arguments,
        }
    }
    arguments
}

/// Commands with subcommands.
const ABOVE: [(&str, Word); 2] = [("code", help::code), ("catalogue", help::catalogue)];

fn commands(language: Language, is_whole: &dyn Fn(&Entry) -> bool) -> Command {
    let mut languages = Language::ALL.map(Language::id);
    languages.sort_unstable();
    let mut root = Command::new(NAME)
        .version(env!("CARGO_PKG_VERSION"))
        .about(help::antrieb(language))
        .after_help(help::exit_codes(language))
        .styles(Styles::styled())
        .subcommand_required(true)
        .arg_required_else_help(true)
        .arg(argument::flag("json", help::json(language)).global(true))
        .arg(
            argument::text("lang", values::lang(language), help::lang(language))
                .global(true)
                .value_parser(PossibleValuesParser::new(languages)),
        );
    for entry in LIST.iter().filter(|entry| entry.option().is_none()) {
        let command =
            if is_whole(entry) { question::command(entry, language) } else { question::listed(entry, language) };
        let above = ABOVE.iter().find(|(above, _)| entry.command().split(' ').next() == Some(above));
        root = match above {
            Some((above, about)) if *above != command.get_name() => {
                if root.find_subcommand(above).is_none() {
                    let required = Command::new(*above).subcommand_required(true).arg_required_else_help(true);
                    root = root.subcommand(required.about(about(language)));
                }
                root.mut_subcommand(above, |above| above.subcommand(command))
            }
            _ => root.subcommand(command),
        };
    }
    of_this_face(root, language)
}

/// Adds the commands that only the command line has.
fn of_this_face(root: Command, language: Language) -> Command {
    let shells = ["bash", "elvish", "fish", "powershell", "zsh"];
    let command = || Arg::new("command").value_name(values::command(language));
    root.subcommand(own::serve(language))
        .subcommand(own::drive(language))
        .subcommand(
            Command::new("completions").about(help::completions(language)).arg(
                Arg::new("shell")
                    .value_name(values::shell(language))
                    .required(true)
                    .value_parser(PossibleValuesParser::new(shells))
                    .help(shells.join(", ")),
            ),
        )
        .subcommand(
            Command::new("help")
                .about(help::help(language))
                .arg(command().num_args(0..).help(help::help_command(language))),
        )
        .subcommand(Command::new("man").about(help::man(language)).arg(command().help(help::man_command(language))))
}

/// Returns the completion script of a shell.
pub(crate) fn completions(matches: &ArgMatches, language: Language) -> CommandAnswer {
    let mut out = Vec::new();
    let mut command = build(language);
    let shell = matches.get_one::<String>("shell").and_then(|name| name.parse::<clap_complete::Shell>().ok());
    if let Some(shell) = shell {
        clap_complete::generate(shell, &mut command, NAME, &mut out);
    }
    CommandAnswer::data(String::from_utf8_lossy(&out).into_owned())
}

/// Returns help on the check that a call of `help` names.
pub(crate) fn help_on_check(matches: &ArgMatches, language: Language) -> CommandAnswer {
    let words: Vec<String> = matches.get_many::<String>("command").into_iter().flatten().cloned().collect();
    let check =
        |entry: &Entry| entry.arguments.iter().find(|argument| argument.name == "check")?.word(&words.join(" "));
    let check_of = |id: &str| CheckId::ALL.iter().copied().find(|check| check.id() == id);
    let found = LIST.iter().copied().filter(|entry| entry.command == "explain").find_map(check);
    let Some(id) = found.and_then(check_of) else { return CommandAnswer::none() };
    let about = (&*words::check_title(id, language), id.id(), words::check_meaning(id, language));
    CommandAnswer::data(checks::what_a_check_is(about, language))
}

/// Returns a manual page.
pub(crate) fn man(matches: &ArgMatches, language: Language) -> Result<CommandAnswer, Unanswered> {
    let mut whole = build(language);
    whole.build();
    let wanted = matches.get_one::<String>("command");
    let page = match wanted {
        None => Some(whole),
        Some(name) => whole.find_subcommand(name).map(|found| found.clone().display_name(format!("{NAME}-{name}"))),
    };
    let Some(page) = page else {
        let written = wanted.cloned().unwrap_or_default();
        return Err(Unanswered::message(usage_text(&Usage::UnknownCommand { written }, language)));
    };
    let mut out = Vec::new();
    clap_mangen::Man::new(page).render(&mut out).map_err(|error| Unanswered::message(error.to_string()))?;
    Ok(CommandAnswer::data(library::headings(&String::from_utf8_lossy(&out), language)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Visits every option with a value of every command.
    fn each_option(command: &Command, path: &str, visit: &mut impl FnMut(&str, &Arg)) {
        for option in command.get_arguments().filter(|option| !option.is_positional()) {
            if option.get_action().takes_values() {
                visit(path, option);
            }
        }
        for below in command.get_subcommands() {
            each_option(below, &format!("{path} {}", below.get_name()), visit);
        }
    }

    #[test]
    fn the_help_of_an_option_names_its_choice_its_default_and_a_value_with_its_unit() {
        let placeholders = |language| {
            [values::time, values::length, values::angle, values::torque, values::speed, values::quantity]
                .map(|word| word(language))
        };
        for language in Language::ALL {
            let mut whole = build(language);
            whole.build();
            let mut count = 0;
            each_option(&whole, NAME, &mut |path, option| {
                let help = option.get_help().map(ToString::to_string).unwrap_or_default();
                let name = format!("{path} --{}", option.get_id());
                for usual in option.get_default_values() {
                    let usual = usual.to_string_lossy();
                    assert!(help.contains(&*usual), "{name}: default {usual}\n{help}");
                    count += 1;
                }
                let choice = option.get_possible_values();
                if (2..=argument::CHOICE_MOST).contains(&choice.len()) {
                    for word in choice {
                        assert!(help.contains(word.get_name()), "{name}: {}\n{help}", word.get_name());
                        count += 1;
                    }
                }
                let value = option.get_value_names().unwrap_or_default();
                if value.iter().any(|value| placeholders(language).contains(&&**value)) {
                    let has_unit = help.split(['"', '(']).skip(1).any(|part| {
                        part.starts_with(|sign: char| sign.is_ascii_digit()) && part.contains(char::is_alphabetic)
                    });
                    assert!(has_unit, "{name}: no value with its unit\n{help}");
                    count += 1;
                }
            });
            assert!(count > 100, "{count}");
        }
    }

    #[test]
    fn the_help_of_every_command_fits_a_hundred_columns() {
        fn check(command: &mut Command, path: &str) {
            let help = command.clone().term_width(100).render_help().to_string();
            for line in help.lines() {
                assert!(line.chars().count() <= 100, "{path}: {line}");
            }
            for below in command.get_subcommands_mut() {
                check(below, &format!("{path} {}", below.get_name()));
            }
        }
        for language in Language::ALL {
            let mut whole = build(language);
            whole.build();
            check(&mut whole, NAME);
        }
    }

    /// Compares the messages of the library for rejected calls.
    #[test]
    fn a_command_line_for_one_call_answers_as_the_whole_one() {
        let commands = || LIST.iter().filter(|entry| entry.option().is_none()).map(|entry| entry.command().to_owned());
        let calls = commands().flat_map(|command| {
            ["--help", "--no-such-option", "--tolerance", "a b c d e"].map(|tail| format!("{command} {tail}"))
        });
        let others =
            ["", "--help", "sizes", "size --jso", "code", "code --help", "code pars", "help", "--lang xx size"];
        for call in calls.chain(others.map(str::to_owned)) {
            let words = || std::iter::once(NAME).chain(call.split_whitespace()).map(OsString::from);
            let arguments = with_help_asked(words());
            for language in Language::ALL {
                let of = |command: Command| {
                    let found = command.try_get_matches_from(&arguments);
                    found.map_or_else(|refusal| refusal.to_string(), |_| "read".to_owned())
                };
                assert_eq!(of(build_for(&arguments, language)), of(build(language)), "{call}");
            }
        }
    }
}
