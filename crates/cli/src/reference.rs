//! Reference page of the commands in Markdown, from the definitions that parse the command line. Only its test uses it.

use crate::command::argument::plain_help;
use crate::command::build;
use clap::{Arg, Command};
use quantities::Language;
use words::pages;

/// Returns the page in a language.
fn page(language: Language) -> String {
    let mut root = build(language);
    root.build();
    let mut page = format!("# {}\n\n{}\n", pages::commands(language), pages::commands_about(language));
    page.push_str(&format!("\n## {}\n", pages::every_command_takes(language)));
    arguments(&mut page, root.get_arguments().filter(|argument| is_listed_once(argument)), language);
    for command in root.get_subcommands() {
        write_command(&mut page, "antrieb", command, language);
    }
    if let Some(after) = root.get_after_help() {
        page.push_str(&block("text", &after.to_string()));
    }
    page
}

/// Writes a command, then its subcommands.
fn write_command(page: &mut String, before: &str, command: &Command, language: Language) {
    let name = format!("{before} {}", command.get_name());
    page.push_str(&format!("\n## `{name}`\n"));
    if let Some(about) = command.get_about() {
        page.push_str(&format!("\n{about}.\n"));
    }
    let usage = command.clone().render_usage().to_string();
    let usage = usage.split_once(": ").map_or(usage.as_str(), |(_, call)| call);
    page.push_str(&block("text", usage));
    arguments(page, command.get_arguments().filter(|argument| !is_listed_once(argument)), language);
    if let Some(after) = command.get_after_help() {
        page.push_str(&block("text", &after.to_string()));
    }
    for below in command.get_subcommands() {
        write_command(page, &name, below, language);
    }
}

/// Returns `true` for options of every command, which are listed once.
fn is_listed_once(argument: &Arg) -> bool {
    argument.is_global_set() || ["help", "version"].contains(&argument.get_id().as_str())
}

fn arguments<'a>(page: &mut String, arguments: impl Iterator<Item = &'a Arg>, language: Language) {
    let rows: Vec<String> = arguments.map(|argument| row(argument, language)).collect();
    if !rows.is_empty() {
        page.push_str(&format!("\n{}\n|---|---|\n{}", pages::columns_of_arguments(language), rows.concat()));
    }
}

fn row(argument: &Arg, language: Language) -> String {
    let takes = argument.get_action().takes_values();
    let names = argument.get_value_names().unwrap_or_default().iter().map(|name| name.as_str());
    let value = names.collect::<Vec<_>>().join(" ");
    let spelled = match (argument.get_short(), argument.get_long()) {
        (Some(short), Some(long)) => format!("-{short}, --{long}"),
        (_, Some(long)) => format!("--{long}"),
        _ => value.clone(),
    };
    let spelled = if takes && argument.get_long().is_some() { format!("{spelled} {value}") } else { spelled };
    // The page lists words and default once, as code.
    let help = plain_help(argument, language);
    let words = argument.get_possible_values();
    let mut parts = vec![help];
    if takes && !words.is_empty() {
        let words: Vec<String> = words.iter().map(|word| format!("`{}`", word.get_name())).collect();
        parts.push(pages::one_of(&words.join(" "), language));
    }
    if takes && let Some(value) = argument.get_default_values().first() {
        parts.push(pages::without_it(&format!("`{}`", value.to_string_lossy()), language));
    }
    if argument.is_required_set() {
        parts.push(pages::required(language).to_owned());
    }
    let most = argument.get_num_args().map_or(1, |range| range.max_values());
    if matches!(argument.get_action(), clap::ArgAction::Append) || most > 1 {
        parts.push(pages::several(language).to_owned());
    }
    format!("| `{spelled}` | {} |\n", parts.join("; ").replace('|', "\\|"))
}

fn block(info: &str, text: &str) -> String {
    format!("\n```{info}\n{}\n```\n", text.trim_end())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot panic cannot fail")]

    use super::*;
    use std::path::Path;

    const PAGES: [(&str, Language); 2] = [("commands.md", Language::En), ("befehle.md", Language::De)];

    #[test]
    fn the_pages_are_those_of_the_command_line() {
        for (file, language) in PAGES {
            testkit::generated::is_current(&format!("docs/reference/{file}"), &page(language));
        }
    }

    #[test]
    fn every_command_and_every_option_is_reported() {
        fn every<'c>(command: &'c Command, found: &mut Vec<&'c Command>) {
            found.push(command);
            command.get_subcommands().for_each(|below| every(below, found));
        }
        for (_, language) in PAGES {
            let (root, page) = (build(language), page(language));
            let mut commands = Vec::new();
            every(&root, &mut commands);
            assert!(commands.len() > 20, "{}", commands.len());
            for command in commands {
                assert!(page.contains(&format!("{}`\n", command.get_name())) || command.get_name() == "antrieb");
                for long in command.get_arguments().filter_map(Arg::get_long) {
                    assert!(page.contains(&format!("--{long}")), "{long}");
                }
            }
        }
    }

    /// Compares the README with the program: each command, and each check of drive, gear, energy, brake, feedback and
    /// screws.
    #[test]
    fn the_readme_lists_every_command_and_check() {
        use questions::{CheckId, Part};
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
        let readme = std::fs::read_to_string(path).unwrap();
        let root = build(Language::En);
        let commands = root.get_subcommands().map(|command| format!("`{} ", command.get_name()));
        let plain = |start: &String| start.replace(' ', "`");
        let missing: Vec<String> =
            commands.filter(|start| !readme.contains(start) && !readme.contains(&plain(start))).collect();
        assert!(missing.is_empty(), "commands: {missing:?}");
        let listed = CheckId::ALL.iter().filter(|check| check.part() != Part::OutputBearing);
        let missing: Vec<&str> =
            listed.map(|check| check.id()).filter(|id| !readme.contains(&format!("`{id}`"))).collect();
        assert!(missing.is_empty(), "checks: {missing:?}");
    }

    /// Requires that every question of the list is a command with all its arguments, is described on the page, and has
    /// a layout.
    #[test]
    fn every_question_of_the_list_is_a_command() {
        use questions::list::{LIST, Reads};
        for entry in LIST {
            let mut whole = build(Language::En);
            whole.build();
            let words = entry.command().split(' ');
            let command = words.fold(&whole, |above, word| above.find_subcommand(word).unwrap());
            assert!(command.get_about().is_some(), "{}", entry.command);
            let has = |name: &str| command.get_arguments().any(|argument| argument.get_id() == name);
            for argument in entry.arguments {
                // The format of a table follows from the extension of its file.
                assert!(has(argument.name) || argument.name == "format", "{} {}", entry.command, argument.name);
            }
            assert!(entry.option().is_none_or(has), "{}", entry.command);
            assert!(page(Language::En).contains(&format!("## `antrieb {}`\n", entry.command())), "{}", entry.command);
            let writes = entry.option().is_some() && entry.reads == Reads::Nothing;
            assert!(
                crate::layout::Layout::of(entry).is_some() || writes || entry.answer.is_some(),
                "{} is not shown",
                entry.command
            );
        }
    }
}
