//! What the library of the command line says in English only, in German.

use clap::{Arg, Command};
use workbench::Language;

/// What stands for a value, in German.
const GERMAN_VALUES: [(&str, &str); 27] = [
    ("AXIS", "ACHSE"),
    ("BODY", "KÖRPER"),
    ("CHECK", "NACHWEIS"),
    ("COMMAND", "BEFEHL"),
    ("DATE", "DATUM"),
    ("FIGURE", "BILD"),
    ("FILE", "DATEI"),
    ("HOURS", "STUNDEN"),
    ("KIND", "ART"),
    ("LANG", "SPRACHE"),
    ("LENGTH", "LÄNGE"),
    ("NEW", "NEU"),
    ("OLD", "ALT"),
    ("PATTERN", "MUSTER"),
    ("PROJECT", "PROJEKT"),
    ("SIZE", "GRÖSSE"),
    ("TERM", "BEGRIFF"),
    ("THEME", "FARBEN"),
    ("TIME", "ZEIT"),
    ("TORQUE", "MOMENT"),
    ("VOLTAGE", "SPANNUNG"),
    ("WHAT", "WAS"),
    ("shell", "SHELL"),
    ("FORMAT", "FORMAT"),
    ("CODE", "CODE"),
    ("NAME", "NAME"),
    ("TEXT", "TEXT"),
];

pub(super) fn value(argument: Arg) -> Arg {
    let Some([name]) = argument.get_value_names() else { return argument };
    let german = GERMAN_VALUES.iter().find(|(en, _)| *en == name.as_str()).map(|(_, de)| *de);
    match german {
        Some(german) => argument.value_name(german),
        None => argument,
    }
}

/// The usage lines of a built command in German; the library writes its own words there.
pub(super) fn usage(mut command: Command) -> Command {
    let whole = command.render_usage().to_string();
    let line = whole.trim_start_matches("Usage:").trim();
    command = command.override_usage(line.replace("[OPTIONS]", "[OPTIONEN]").replace("<COMMAND>", "<BEFEHL>"));
    command.mut_subcommands(usage)
}

/// The page with the headings of the language; the library writes English ones.
pub(super) fn headings(page: &str, language: Language) -> String {
    const GERMAN: [(&str, &str); 8] = [
        (".SH NAME", ".SH BEZEICHNUNG"),
        (".SH SYNOPSIS", ".SH ÜBERSICHT"),
        (".SH DESCRIPTION", ".SH BESCHREIBUNG"),
        (".SH OPTIONS", ".SH OPTIONEN"),
        (".SH ARGUMENTS", ".SH ARGUMENTE"),
        (".SH SUBCOMMANDS", ".SH BEFEHLE"),
        (".SH EXTRA", ".SH WEITERES"),
        (".SH VERSION", ".SH VERSION"),
    ];
    let line = |line: &str| {
        let german = GERMAN.iter().find(|(en, _)| *en == line.trim_end()).map(|(_, de)| *de);
        format!("{}\n", german.filter(|_| language == Language::De).unwrap_or(line))
    };
    page.lines().map(line).collect()
}
