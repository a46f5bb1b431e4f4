//! What the library of the command line says of itself: the English is its own, word for word, and the German ours.

use crate::texts::texts;
use quantities::Language;

/// The language that the library speaks.
pub const LANGUAGE: Language = Language::En;

/// Whether the library speaks a language itself.
#[must_use]
pub fn is_its_own(language: Language) -> bool {
    language == LANGUAGE
}

texts! {
    error = "error" | "Fehler";
    more = "For more information, try '--help'." | "Mehr dazu: antrieb --help --lang de";
    options_in_usage = "[OPTIONS]" | "[OPTIONEN]";
    command_in_usage = "<COMMAND>" | "<BEFEHL>";
    name_of_a_page = "NAME" | "BEZEICHNUNG";
    synopsis_of_a_page = "SYNOPSIS" | "ÜBERSICHT";
    description_of_a_page = "DESCRIPTION" | "BESCHREIBUNG";
    options_of_a_page = "OPTIONS" | "OPTIONEN";
    arguments_of_a_page = "ARGUMENTS" | "ARGUMENTE";
    subcommands_of_a_page = "SUBCOMMANDS" | "BEFEHLE";
    extra_of_a_page = "EXTRA" | "WEITERES";
    version_of_a_page = "VERSION";
}

/// The headings of a manual page.
pub const HEADINGS: [crate::Word; 8] = [
    name_of_a_page,
    synopsis_of_a_page,
    description_of_a_page,
    options_of_a_page,
    arguments_of_a_page,
    subcommands_of_a_page,
    extra_of_a_page,
    version_of_a_page,
];
