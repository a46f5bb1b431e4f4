//! What the library of the command line says in its own language only, in the one that is asked for.

use clap::Command;
use workbench::Language;
use workbench::text::help::library;

/// A fault of the command line in a language that the library does not speak.
pub(crate) fn fault(error: &clap::Error, language: Language) -> Option<String> {
    if library::is_its_own(language) {
        return None;
    }
    use clap::error::{ContextKind, ContextValue, ErrorKind};
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        Some(ContextValue::Strings(texts)) => Some(texts.join(", ")),
        _ => None,
    };
    let what = match error.kind() {
        ErrorKind::InvalidSubcommand => library::unknown_command(&context(ContextKind::InvalidSubcommand)?, language),
        ErrorKind::UnknownArgument => library::unknown_option(&context(ContextKind::InvalidArg)?, language),
        ErrorKind::MissingRequiredArgument => library::missing_arguments(&context(ContextKind::InvalidArg)?, language),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            library::invalid_value(&context(ContextKind::InvalidValue)?, &context(ContextKind::InvalidArg)?, language)
        }
        _ => return None,
    };
    let mut text = format!("{}: {what}", library::error(language));
    for (kind, head) in [
        (ContextKind::ValidValue, library::valid_values(language)),
        (ContextKind::SuggestedSubcommand, library::similar(language)),
        (ContextKind::SuggestedArg, library::similar(language)),
        (ContextKind::SuggestedValue, library::similar(language)),
    ] {
        if let Some(found) = context(kind).filter(|found| !found.is_empty()) {
            text.push_str(&format!("\n  {head}: {found}"));
        }
    }
    text.push_str(&format!("\n\n{}\n", library::more(language)));
    Some(text)
}

/// The usage lines of a command in the language; the library writes its own words there.
pub(super) fn usage(mut command: Command, language: Language) -> Command {
    if library::is_its_own(language) {
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

/// The page with the headings of the language; the library writes English ones.
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
