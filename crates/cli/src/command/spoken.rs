//! Calls as people write them: words in any case and in both languages, a code or a check without its option.

use clap::Command;
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind, LIST};
use std::ffi::OsString;
use words::spoken::{COMMANDS, OPTIONS, language_of};

/// Returns the option that a word stands for, among those that a command has.
pub(super) fn option_meant(written: &str, command: &Command) -> Option<String> {
    let word = written.trim_start_matches('-').split('=').next().unwrap_or_default().to_lowercase();
    let (_, meant) = OPTIONS.iter().find(|(other, _)| *other == word)?;
    let has = |name: &&&str| command.get_arguments().any(|argument| argument.get_long() == Some(**name));
    meant.iter().find(has).map(|name| format!("--{name}"))
}

/// Returns a command as the program names it.
fn command_named(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let own = LIST.iter().map(|entry| entry.command().split(' ').next().unwrap_or_default());
    own.chain(["serve", "drive", "help", "man", "completions"])
        .find(|name| *name == word)
        .or_else(|| COMMANDS.iter().find(|(other, _)| *other == word).map(|(_, name)| *name))
}

/// Returns the arguments with the command and the language by their own words.
pub(crate) fn with_own_words(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let text =
        |arguments: &[OsString], place: usize| arguments.get(place).and_then(|word| word.to_str()).map(str::to_owned);
    let put = |arguments: &mut [OsString], place: usize, word: &str| {
        if let Some(old) = arguments.get_mut(place) {
            *old = word.into();
        }
    };
    let mut place = 1;
    let mut is_command_due = true;
    while let Some(word) = text(&arguments, place) {
        if word == "--" {
            break;
        }
        if word == "--lang" {
            if let Some(language) = text(&arguments, place + 1).and_then(|word| language_of(&word)) {
                put(&mut arguments, place + 1, language.id());
            }
            place += 1;
        } else if let Some(language) = word.strip_prefix("--lang=").and_then(language_of) {
            put(&mut arguments, place, &format!("--lang={}", language.id()));
        } else if is_command_due && !word.starts_with('-') {
            if let Some(name) = command_named(&word) {
                put(&mut arguments, place, name);
            }
            // `help COMMAND` names a command too.
            is_command_due = word == "help" || word == "hilfe";
        }
        place += 1;
    }
    arguments
}

/// Returns the arguments with each word that no position of the command takes behind the option that it belongs to: an
/// ordering code behind `--code`, the word of a single option behind that one. Other words stay.
pub(crate) fn with_options(arguments: Vec<OsString>, whole: &Command, language: Language) -> Vec<OsString> {
    let words: Vec<Option<&str>> = arguments.iter().map(|word| word.to_str()).collect();
    let (mut command, mut name, mut begin) = (whole, String::new(), None);
    let mut place = 1;
    while let Some(Some(word)) = words.get(place) {
        if *word == "--lang" {
            place += 1;
        } else if !word.starts_with('-') {
            let Some(below) = command.find_subcommand(word) else { break };
            (command, begin) = (below, Some(place + 1));
            name = if name.is_empty() { (*word).to_owned() } else { format!("{name} {word}") };
        }
        place += 1;
    }
    let (Some(begin), Some(entry)) = (begin, LIST.iter().find(|entry| entry.command() == name)) else {
        return arguments;
    };
    let positions: Vec<_> = command.get_positionals().collect();
    if positions.iter().any(|position| position.get_num_args().is_some_and(|range| range.max_values() > 1)) {
        return arguments;
    }
    let most = positions.len();
    let options: Vec<&Argument> =
        entry.arguments.iter().filter(|argument| argument.form == ArgumentForm::Option).collect();
    let taken = |option: &str| {
        words
            .iter()
            .flatten()
            .any(|word| word.strip_prefix("--").is_some_and(|rest| rest.split('=').next() == Some(option)))
    };
    let belongs = |word: &str| {
        // A file that no position takes is the required one: `sweep axis.toml tasks.csv`.
        let is_table = [".csv", ".csv.gz", ".parquet"].iter().any(|ending| word.to_lowercase().ends_with(ending));
        let of_file = |argument: &&&Argument| matches!(argument.kind, ArgumentKind::File) && argument.required;
        if let Some(file) = options.iter().find(of_file).filter(|file| is_table && !taken(file.name)) {
            return Some(format!("--{}", file.name));
        }
        let is_code = |argument: &&&Argument| {
            matches!(argument.kind, ArgumentKind::Code) && questions::read_code(word, language).is_ok()
        };
        let has_word = |argument: &&&Argument| matches!(argument.kind, ArgumentKind::Word(_)) && argument.takes(word);
        let mut found = options.iter().filter(is_code).chain(options.iter().filter(has_word));
        // A code with a slip is none of the words; the question names the nearest ones.
        let seems_code = word.contains('-') && !word.contains(['.', '/', '\\']);
        let code = || options.iter().find(|argument| seems_code && matches!(argument.kind, ArgumentKind::Code));
        let one = match (found.next(), found.next()) {
            (Some(one), None) => one,
            (None, _) => code()?,
            _ => return None,
        };
        (one.repeated || !taken(one.name)).then(|| format!("--{}", one.name))
    };
    let (mut out, mut bare, mut is_value) = (Vec::new(), 0, false);
    // With a code before the file, the code is not the file.
    for (place, argument) in arguments.iter().enumerate() {
        let word = argument.to_str().unwrap_or_default();
        let is_bare = place >= begin && !is_value && !(word.starts_with('-') && word != "-");
        let is_file = || word == "-" || std::path::Path::new(word).exists();
        if is_bare {
            bare += 1;
            let spare = bare > most || most == 1 && !is_file() && questions::read_code(word, language).is_ok();
            if let Some(option) = spare.then(|| belongs(word)).flatten() {
                bare -= 1;
                out.push(option.into());
            }
        }
        let takes = |rest: &str| {
            !rest.contains('=')
                && command
                    .get_arguments()
                    .chain(whole.get_arguments())
                    .any(|argument| argument.get_long() == Some(rest) && argument.get_action().takes_values())
        };
        is_value = !is_value && (word.strip_prefix("--").is_some_and(takes) || word == "-o");
        out.push(argument.clone());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::build;

    fn call(text: &str) -> Vec<String> {
        let words = std::iter::once("antrieb").chain(text.split(' ')).map(OsString::from).collect();
        let whole = build(Language::En);
        let understood = with_options(with_own_words(words), &whole, Language::En);
        understood.into_iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect()
    }

    #[test]
    fn calls_are_understood_as_they_are_meant() {
        for (written, meant) in [
            ("Bericht a.toml --lang DE", "report a.toml --lang de"),
            ("--lang=Deutsch PRÜFEN a.toml", "--lang=de check a.toml"),
            ("check a.toml CHA-25A-50-H-C1024", "check a.toml --code CHA-25A-50-H-C1024"),
            ("check CHA-25A-50-H-C1024 a.toml", "check --code CHA-25A-50-H-C1024 a.toml"),
            ("explain a.toml cha-25a-50-h-c1024 thermal", "explain a.toml --code cha-25a-50-h-c1024 --check thermal"),
            ("simulate a.toml --at 1 emergency_stop", "simulate a.toml --at 1 --scenario emergency_stop"),
            (
                "compare a.toml CHA-25A-50-H-C1024 CHA-20A-100-H-C1024-B",
                "compare a.toml --code CHA-25A-50-H-C1024 --code CHA-20A-100-H-C1024-B",
            ),
            (
                "plot a.toml torque_speed -o CHA-25A-50-H-C1024",
                "plot a.toml --figure torque_speed -o CHA-25A-50-H-C1024",
            ),
            ("data CHA-25A-50-H-C1024", "data CHA-25A-50-H-C1024"),
            ("diff a.toml b.toml", "diff a.toml b.toml"),
            ("check a.toml --code X CHA-25A-50-H-C1024", "check a.toml --code X CHA-25A-50-H-C1024"),
            ("size a.toml b.toml", "size a.toml b.toml"),
            ("check a.toml CHA-25A-5O-H-C1o24", "check a.toml --code CHA-25A-5O-H-C1o24"),
            ("sweep a.toml t.csv -o best.csv", "sweep a.toml --table t.csv -o best.csv"),
            ("sweep a.toml --table t.csv u.csv", "sweep a.toml --table t.csv u.csv"),
            ("hilfe bericht", "help report"),
        ] {
            assert_eq!(call(written).join(" "), meant, "{written}");
        }
    }

    #[test]
    fn every_other_word_is_none_of_the_program_and_leads_to_one() {
        let whole = build(Language::En);
        for (other, name) in COMMANDS {
            assert!(whole.find_subcommand(name).is_some() || *name == "help", "{name}");
            assert!(other == name || whole.find_subcommand(other).is_none(), "{other}");
        }
        assert!(COMMANDS.windows(2).all(|two| two[0].0 < two[1].0), "sorted");
        assert!(OPTIONS.windows(2).all(|two| two[0].0 < two[1].0), "sorted");
        for (_, meant) in OPTIONS {
            for option in *meant {
                let has =
                    |command: &Command| command.get_arguments().any(|argument| argument.get_long() == Some(option));
                assert!(whole.get_subcommands().any(has) || has(&whole), "{option}");
            }
        }
    }
}
