//! Calls as people write them: words in any case and in both languages, a code or a check without its option.

use super::folder::projects_in;
use clap::Command;
use quantities::Language;
use questions::list::{LIST, glossary};
use std::ffi::OsString;
use std::path::Path;
use words::spoken::{OPTIONS, TWIN_OPTIONS, folded, language_of};

/// Returns the option that a word stands for, among those that a command has.
pub(super) fn option_meant(written: &str, command: &Command) -> Option<String> {
    let word = written.trim_start_matches('-').split('=').next().unwrap_or_default().to_lowercase();
    let (_, meant) = OPTIONS.iter().find(|(other, _)| *other == word)?;
    let has = |name: &&&str| command.get_arguments().any(|argument| argument.get_long() == Some(**name));
    meant.iter().find(has).map(|name| format!("--{name}"))
}

/// Returns the options that take the values of another name; the first that a command has is meant.
pub(super) fn twin_options(written: &str) -> &'static [&'static str] {
    let written = folded(written);
    TWIN_OPTIONS.iter().find(|(other, _)| folded(other) == written).map_or(&[], |(_, meant)| meant)
}

/// Options behind a command that request the version of the program.
const VERSION: [&str; 3] = [SHORT, "-V", "--version"];

/// Option that requests the version behind a command alone; behind the words of a call a longer answer is meant, which has no
/// short option.
const SHORT: &str = "-v";
const LONGER: &str = "--verbose";

/// Returns an option in small letters; the options of every command by their own names.
fn plain_option(word: &str) -> Option<String> {
    let (name, value) =
        word.strip_prefix("--")?.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
    let name = name.trim_start_matches('-').to_lowercase();
    let of_all =
        TWIN_OPTIONS.iter().find(|(other, _)| folded(other) == folded(&name)).and_then(|(_, meant)| meant.first());
    let name = of_all.filter(|name| ["lang", "help", "json"].contains(name)).map_or(name.as_str(), |name| name);
    let plain = value.map_or_else(|| format!("--{name}"), |value| format!("--{name}={value}"));
    (plain != word).then_some(plain)
}

/// Returns a command as the program names it.
pub(super) fn command_named(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    named(&word).or_else(|| named(word.strip_suffix('s')?))
}

/// Returns a command by its name or another word, in small letters.
fn named(word: &str) -> Option<&'static str> {
    let own = LIST.iter().map(|entry| entry.command().split(' ').next().unwrap_or_default());
    own.chain(["serve", "drive", "help", "man", "completions"])
        .find(|name| *name == word)
        .or_else(|| words::spoken::command(word))
}

/// Returns `true` if the command of a call is named by a German word, so that the answer is German.
pub(crate) fn is_german(arguments: &[OsString]) -> bool {
    let words = arguments.iter().skip(1).map_while(|word| word.to_str());
    let mut bare = words.skip_while(|word| word.starts_with('-'));
    bare.next().is_some_and(words::spoken::is_german_command)
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
    // The version has an option.
    let is_version = text(&arguments, 1).is_some_and(|first| first == "-v" || first.to_lowercase() == "version");
    if is_version && arguments.len() == 2 {
        put(&mut arguments, 1, "--version");
    }
    // No command has a longer answer or a version of its own.
    let is_of_version = |word: &OsString| VERSION.iter().any(|version| word == version);
    let mut options = arguments.iter().skip(2).take_while(|word| *word != "--");
    let is_bare = options.all(|word| is_of_version(word) || word.to_str().is_some_and(|word| word.starts_with('-')));
    if !is_bare {
        for place in 2..arguments.len() {
            if text(&arguments, place).as_deref() == Some(SHORT) {
                put(&mut arguments, place, LONGER);
            }
        }
    }
    let mut options = arguments.iter().skip(2).take_while(|word| *word != "--");
    if options.any(is_of_version) {
        return vec![arguments.first().cloned().unwrap_or_default(), "--version".into()];
    }
    let mut place = 1;
    let mut is_command_due = true;
    while let Some(mut word) = text(&arguments, place) {
        if word == "--" {
            break;
        }
        if let Some(plain) = plain_option(&word) {
            put(&mut arguments, place, &plain);
            word = plain;
        }
        let before = text(&arguments, place - 1).unwrap_or_default();
        // `cha 20a` has the series before the size.
        let is_alone = before == "--code" || !before.starts_with('-') && !before.eq_ignore_ascii_case(SERIES);
        if let Some(code) = of_frame_size(&word).filter(|_| is_alone) {
            put(&mut arguments, place, &code);
            word = code;
        }
        if word == "--lang" {
            if let Some(language) = text(&arguments, place + 1).and_then(|word| language_of(&word)) {
                put(&mut arguments, place + 1, language.id());
            }
            place += 1;
        } else if let Some(language) = word.strip_prefix("--lang=").and_then(language_of) {
            put(&mut arguments, place, &format!("--lang={}", language.id()));
        } else if is_command_due && !word.starts_with('-') {
            // `why not CODE`, `warum nicht CODE`
            if command_named(&word) == Some("explain")
                && text(&arguments, place + 1).is_some_and(|next| ["not", "nicht"].contains(&&*next.to_lowercase()))
            {
                let _ = arguments.remove(place + 1);
            }
            match (command_named(&word), language_of(&word)) {
                (Some(name), _) => {
                    put(&mut arguments, place, name);
                    // `help COMMAND` names a command too.
                    is_command_due = name == "help";
                }
                // `de size axis.toml`
                (None, Some(language)) => put(&mut arguments, place, &format!("--lang={}", language.id())),
                (None, None) => is_command_due = false,
            }
        }
        place += 1;
    }
    arguments
}

/// Series of the ordering codes.
const SERIES: &str = "CHA";

/// Returns the part of a code that a frame size begins, as in `25A` or `32a-100-h`; `None` for a file.
fn of_frame_size(word: &str) -> Option<String> {
    let (size, _) = word.split_once('-').unwrap_or((word, ""));
    let digits = size.strip_suffix(['a', 'A'])?;
    let is_size = digits.len() == 2 && digits.chars().all(|sign| sign.is_ascii_digit());
    let code = format!("{SERIES}-{word}");
    let is_read = || questions::list::code_list::read_pattern(&code, Language::default()).is_ok();
    (is_size && is_read() && !Path::new(word).exists()).then_some(code)
}

/// Command that explains others.
pub(super) const HELP: &str = "help";

/// Returns the command that explains a word which is none: a check is derived, a term is in the glossary.
pub(super) fn helping(word: Option<&OsString>) -> Option<&'static str> {
    let word = word?.to_str().filter(|word| !word.starts_with('-') && command_named(word).is_none())?;
    let is_check = LIST
        .iter()
        .filter(|entry| entry.command == "explain")
        .any(|entry| entry.arguments.iter().any(|argument| argument.name == "check" && argument.takes(word)))
        // A symbol alone is explained by the glossary.
        && words::spoken::choice("check", word).is_none();
    // Without the project that is plainly meant the help names the check.
    if is_check {
        return Some(if projects_in(Path::new("")).len() == 1 { "explain" } else { HELP });
    }
    glossary::glossary(Some(word), Language::default()).is_ok().then_some("glossary")
}

/// Returns `true` if a word looks like a code, or like one with a slip.
pub(super) fn seems_code(word: &str) -> bool {
    let is_sign = |sign: char| sign.is_alphanumeric() || "-?*…_#.".contains(sign);
    // A file name has no hyphen behind its first point.
    let is_file = word
        .rsplit_once('.')
        .is_some_and(|(_, ending)| !ending.contains(['-', '.']) && ending.starts_with(char::is_alphabetic));
    word.contains(['-', '_'])
        && !is_file
        && word.starts_with(char::is_alphabetic)
        && word.chars().all(is_sign)
        && word.chars().any(|sign| sign.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::build;
    use crate::command::replaced::understood;
    use words::spoken::COMMANDS;

    fn call(text: &str) -> Vec<String> {
        let words = std::iter::once("antrieb").chain(text.split(' ')).map(OsString::from).collect();
        let whole = build(Language::En);
        let (understood, _) = understood(with_own_words(words), false, &whole, Language::En);
        understood.arguments.into_iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect()
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
            ("plot a.toml torque_speed --svg p.svg", "plot a.toml --figure torque_speed --svg p.svg"),
            ("data CHA-25A-50-H-C1024", "data CHA-25A-50-H-C1024"),
            ("diff a.toml b.toml", "diff a.toml b.toml"),
            ("check a.toml --code X CHA-25A-50-H-C1024", "check a.toml --code X CHA-25A-50-H-C1024"),
            ("size a.toml b.toml", "size a.toml b.toml"),
            ("check a.toml CHA-25A-5O-H-C1o24", "check a.toml --code CHA-25A-5O-H-C1o24"),
            ("sweep a.toml t.csv -o best.csv", "sweep a.toml --table t.csv -o best.csv"),
            ("sweep a.toml --table t.csv u.csv", "sweep a.toml --table t.csv --out u.csv"),
            ("hilfe bericht", "help report"),
            ("WAERME a.toml", "simulate a.toml"),
            ("Wärme a.toml --Hoehe 80mm", "simulate a.toml --height 80mm"),
            ("Mappe a.toml", "export a.toml"),
            ("DE SIZE a.toml", "--lang=de size a.toml"),
            ("size a.toml DE", "size a.toml --lang de"),
            ("size a.toml --TOP 5 --Lang=Deutsch", "size a.toml --top 5 --lang=de"),
            ("explain a.toml --Nachweis thermal --sprache EN", "explain a.toml --check thermal --lang en"),
            ("report a.toml --Ausgabe x.pdf --kunde=AG", "report a.toml --out x.pdf --customer=AG"),
            ("bericht --hilfe", "report --help"),
            ("size a.toml -v", "size a.toml --verbose"),
            ("size -v", "--version"),
            ("check a.toml 25A", "check a.toml --code CHA-25A"),
            ("compare a.toml 25a-50-h 32A", "compare a.toml --code CHA-25a-50-h --code CHA-32A"),
            ("check a.toml --axis 14A", "check a.toml --axis 14A"),
            ("code list 14a", "code list CHA-14a"),
            ("code parse cha 14a 100 n d2048", "code parse cha 14a 100 n d2048"),
            ("check --version", "--version"),
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
        assert!(TWIN_OPTIONS.windows(2).all(|two| two[0].0 < two[1].0), "sorted");
        let has_long = |command: &Command, name: &str| {
            let own = command.get_subcommands().flat_map(Command::get_arguments);
            command.get_arguments().chain(own).any(|argument| argument.get_long() == Some(name))
        };
        for (other, _) in TWIN_OPTIONS {
            assert!(!has_long(&whole, other) && OPTIONS.iter().all(|(meant, _)| meant != other), "{other}");
        }
        for (_, meant) in OPTIONS.iter().chain(TWIN_OPTIONS) {
            for option in *meant {
                let has =
                    |command: &Command| command.get_arguments().any(|argument| argument.get_long() == Some(option));
                assert!(whole.get_subcommands().any(has) || has(&whole), "{option}");
            }
        }
    }
}
