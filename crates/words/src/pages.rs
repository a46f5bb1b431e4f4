//! Words for the reference pages generated from the program: commands and project file.

use crate::texts::texts;

texts! {
    title = "Project file, key by key" | "Projektdatei, Schlüssel für Schlüssel";
    introduction =
        "This page is generated from the description used by the program to read project files. The guide shows with examples how the keys work together: [project file](../guide/project-file.md). Keys in bold are required. The default of any other key is stated with its meaning; if there is no default, a check that requires the value is reported as not checked and names the value."
        | "Diese Seite wird aus der Beschreibung erzeugt, nach der das Programm Projektdateien liest. Wie die Schlüssel zusammenwirken, zeigt die Anleitung an Beispielen: [Projektdatei](../anleitung/project-file.md). Fett gesetzte Schlüssel sind Pflicht. Der Standardwert der übrigen steht bei ihrer Bedeutung; fehlt ein Standardwert, wird ein Nachweis, der den Wert benötigt, als nicht geprüft ausgewiesen und nennt ihn.";
    root = "Root of the file" | "Wurzel der Datei";
    columns_of_keys =
        "| key | value | example | meaning |" | "| Schlüssel | Wert | Beispiel | Bedeutung |";
    columns_of_kinds(by) = "| `{by}` | required | optional |" | "| `{by}` | erforderlich | zulässig |";
    every_kind_may_have(keys) = "Optional for all of them: {keys}." | "Bei allen zulässig: {keys}.";
    several_axes(keys) =
        "With several axes, each is an `[[axis]]` with a `name` and its own {keys}, as described at the root."
        | "Bei mehreren Achsen ist jede eine `[[axis]]` mit einem `name` und eigenen Tabellen {keys}, wie oben für die Wurzel beschrieben.";
    from_to(low, high) = "{low} to {high}" | "{low} bis {high}";
    at_most(count) = ", at most {count}" | ", höchstens {count}";
    number = "number" | "Zahl";
    numbers = "list of numbers" | "Liste von Zahlen";
    integer = "whole number" | "ganze Zahl";
    text = "text" | "Text";
    texts = "list of texts" | "Liste von Texten";
    list_of = "list of" | "Liste aus";
    rows_of = "rows of" | "Zeilen aus";
    or = "or" | "oder";
    table = "table" | "Tabelle";
    tables = "tables" | "Tabellen";
    table_or_tables = "table, or several" | "Tabelle, oder mehrere";
    bodies = "list of texts, one per body" | "Liste von Texten, je ein Körper";
    quantities_title = "Quantities and their units" | "Größen und ihre Einheiten";
    quantities_about(example) =
        "A quantity is a text with number and unit, optionally with a tolerance: {example}. The usual unit is listed first; other spellings of a unit are also accepted."
        | "Eine Größe ist ein Text mit Zahl und Einheit, wahlweise mit Toleranz: {example}. Die übliche Einheit steht zuerst; andere Schreibweisen einer Einheit sind ebenfalls zulässig.";
    columns_of_quantities = "| quantity | units |" | "| Größe | Einheiten |";
    glossary_title = "Glossary" | "Glossar";
    glossary_about =
        "Terms and symbols of the program in both languages with their definitions, one term for one thing. This page is generated from the glossary data; `antrieb glossary TERM` looks up a term."
        | "Begriffe und Formelzeichen des Programms in beiden Sprachen mit Definition, ein Begriff für eine Sache. Diese Seite wird aus den Daten des Glossars erzeugt; `antrieb glossary BEGRIFF` schlägt einen Begriff nach.";
    glossary_words = "Terms" | "Begriffe";
    glossary_terms = "Symbols of the tables" | "Formelzeichen der Tabellen";
    glossary_terms_about =
        "As used in the catalogue and its export, with the identifier used in project files and the unit of the manual."
        | "Wie in Katalog und Export verwendet, mit der Kennung aus Projektdateien und der Einheit der Anleitung.";
    glossary_steps = "Symbols of derivations and drive settings" | "Formelzeichen der Herleitungen und der Einstellwerte für den Servoregler";
    glossary_steps_about =
        "Symbols shown by `antrieb explain` and `antrieb commission` in addition to those of the tables. A symbol with several meanings is listed several times."
        | "Formelzeichen, die `antrieb explain` und `antrieb commission` zusätzlich zu denen der Tabellen verwenden. Ein Formelzeichen mit mehreren Bedeutungen ist mehrfach aufgeführt.";
    columns_of_words = "| English | German | meaning |" | "| Englisch | Deutsch | Bedeutung |";
    columns_of_terms = "| symbol | name | unit | English | German | remark |" | "| Formelzeichen | Name | Einheit | Englisch | Deutsch | Bemerkung |";
    columns_of_steps = "| symbol | English | German |" | "| Formelzeichen | Englisch | Deutsch |";
    commands = "Commands" | "Befehle";
    commands_about =
        "All commands with their arguments, as in `antrieb help`. This page is generated from the command line; the guide explains the answers."
        | "Alle Befehle mit ihren Argumenten, wie in `antrieb help`. Diese Seite wird aus der Befehlszeile erzeugt; die Antworten erklärt die Anleitung.";
    every_command_takes = "Options of all commands" | "Optionen aller Befehle";
    columns_of_arguments = "| argument | meaning |" | "| Argument | Bedeutung |";
    one_of(words) = "one of {words}" | "eines von {words}";
    without_it(value) = "default {value}" | "ohne Angabe {value}";
    required = "required" | "erforderlich";
    several = "may be repeated" | "mehrfach möglich";
}
