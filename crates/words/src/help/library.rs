//! Words for the output of the library of the command line: the English of its usage lines and headings is that of the
//! library, word for word.

use crate::texts::texts;
use quantities::Language;

/// Language of the library.
pub const LANGUAGE: Language = Language::En;

texts! {
    error = "error" | "Fehler";
    more = "More: antrieb --help" | "Mehr dazu: antrieb --help --lang de";
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

/// Headings of a manual page.
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
