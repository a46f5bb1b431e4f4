//! Texts of the command-line library, which has English only, in the requested language.

use clap::Command;
use quantities::Language;
use words::help::library;

/// Returns the usage lines of a command in the language; the library has its own words in them.
pub(super) fn usage(mut command: Command, language: Language) -> Command {
    if language == library::LANGUAGE {
        return command;
    }
    command.build();
    in_language(command, language)
}

fn in_language(mut command: Command, language: Language) -> Command {
    let mut line = command.render_usage().to_string().trim_start_matches("Usage:").trim().to_owned();
    for word in [library::options_in_usage, library::command_in_usage] {
        line = line.replace(word(library::LANGUAGE), word(language));
    }
    command = command.override_usage(line);
    command.mut_subcommands(|command| in_language(command, language))
}

/// Returns the page with the headings of the language; the library writes English ones.
pub(super) fn headings(page: &str, language: Language) -> String {
    let line = |line: &str| {
        let named = line.strip_prefix(".SH ").map(str::trim_end);
        let heading = library::HEADINGS.iter().find(|heading| named == Some(heading(library::LANGUAGE)));
        match heading {
            Some(heading) => format!(".SH {}\n", heading(language)),
            None => format!("{line}\n"),
        }
    };
    page.lines().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::build;

    #[test]
    fn the_english_beside_our_german_is_what_the_library_says() {
        let own = library::LANGUAGE;
        let usage = build(own).render_usage().to_string();
        for word in [library::options_in_usage(own), library::command_in_usage(own)] {
            assert!(usage.contains(word), "{word}: {usage}");
        }
    }

    /// Collects every command with its path, and all its arguments.
    fn collect_commands(command: &Command, path: &str, found: &mut Vec<(String, String)>) {
        let text = |help: Option<&clap::builder::StyledStr>| help.map(ToString::to_string).unwrap_or_default();
        found.push((path.to_owned(), text(command.get_about())));
        for argument in command.get_arguments() {
            found.push((format!("{path} --{}", argument.get_id()), text(argument.get_help())));
        }
        for subcommand in command.get_subcommands() {
            collect_commands(subcommand, &format!("{path} {}", subcommand.get_name()), found);
        }
    }

    #[test]
    fn every_command_and_argument_has_its_help_in_both_languages() {
        let [en, de] = Language::ALL.map(|language| {
            let mut found = Vec::new();
            let mut whole = build(language);
            whole.build();
            collect_commands(&whole, "antrieb", &mut found);
            found
        });
        assert!(en.len() > 100 && en.len() == de.len(), "{} {}", en.len(), de.len());
        for (number, (path, _)) in en.iter().enumerate() {
            assert!(en.iter().skip(number + 1).all(|(other, _)| other != path), "{path} stands twice");
        }
        for ((path, en), (_, de)) in en.iter().zip(&de) {
            // A list of words that are typed literally is the same in both.
            let words = en.split(", ").all(|word| word.bytes().all(|byte| byte == b'_' || byte.is_ascii_lowercase()));
            assert!(!en.is_empty() && !de.is_empty() && (en != de || words), "{path}: {en:?} {de:?}");
        }
    }
}
