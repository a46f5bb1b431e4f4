//! Words of the reference pages that are made from the program: of the commands, of the project file.

use crate::texts::texts;

texts! {
    title = "Project file, key by key" | "Projektdatei, Schlüssel für Schlüssel";
    introduction =
        "This page is made from the description by which the program reads a project file. The guide shows with examples how the keys work together: [project file](../guide/project-file.md). A key in bold is required. The default of any other key is part of its meaning; without a default a check that needs the value is not checked and names it."
        | "Diese Seite entsteht aus der Beschreibung, nach der das Programm eine Projektdatei liest. Wie die Schlüssel zusammenwirken, zeigt die Anleitung an Beispielen: [Projektdatei](../anleitung/project-file.md). Ein fetter Schlüssel ist Pflicht. Der Standardwert jedes anderen steht bei seiner Bedeutung; ohne Standardwert ist ein Nachweis, der den Wert braucht, nicht geprüft und nennt ihn.";
    root = "Root of the file" | "Wurzel der Datei";
    columns_of_keys =
        "| key | value | example | meaning |" | "| Schlüssel | Wert | Beispiel | Bedeutung |";
    columns_of_kinds(by) = "| `{by}` | needs | may have |" | "| `{by}` | braucht | darf haben |";
    every_kind_may_have(keys) = "Every one of them may have {keys}." | "Alle dürfen {keys} haben.";
    several_axes(keys) =
        "Of several axes each is an `[[axis]]` with a `name` and with {keys} inside it, as they are described at the root."
        | "Von mehreren Achsen ist jede eine `[[axis]]` mit einem `name` und mit {keys} darin, wie sie an der Wurzel beschrieben sind.";
    from_to(low, high) = "{low} to {high}" | "{low} bis {high}";
    at_most(count) = ", at most {count}" | ", höchstens {count}";
    number = "number" | "Zahl";
    numbers = "list of numbers" | "Liste von Zahlen";
    integer = "whole number" | "ganze Zahl";
    text = "text" | "Text";
    list_of = "list of" | "Liste aus";
    rows_of = "rows of" | "Zeilen aus";
    or = "or" | "oder";
    table = "table" | "Tabelle";
    tables = "tables" | "Tabellen";
    table_or_tables = "table, or several" | "Tabelle, oder mehrere";
    bodies = "list of texts, a body each" | "Liste von Texten, je ein Körper";
    quantities_title = "Quantities and their units" | "Größen und ihre Einheiten";
    quantities_about(example) =
        "A quantity is a text with number and unit, perhaps with a tolerance: {example}. The usual unit stands first; other spellings of a unit are understood too."
        | "Eine Größe ist ein Text mit Zahl und Einheit, vielleicht mit Toleranz: {example}. Die übliche Einheit steht zuerst; andere Schreibweisen einer Einheit werden auch verstanden.";
    columns_of_quantities = "| quantity | units |" | "| Größe | Einheiten |";
    glossary_title = "Glossary" | "Glossar";
    glossary_about =
        "Words of the product and symbols of its answers in both languages, one word for one thing. This page is made from the data of the glossary; `antrieb glossary TERM` looks one up."
        | "Wörter des Programms und Formelzeichen seiner Antworten in beiden Sprachen, ein Wort für eine Sache. Diese Seite entsteht aus den Daten des Glossars; `antrieb glossary BEGRIFF` schlägt nach.";
    glossary_words = "Words" | "Wörter";
    glossary_terms = "Symbols of the tables" | "Formelzeichen der Tabellen";
    glossary_terms_about =
        "As the catalogue and its export write them, with the name that a project file uses and the unit of the print."
        | "Wie der Katalog und sein Export sie schreiben, mit dem Namen, den eine Projektdatei nutzt, und der Einheit des Drucks.";
    glossary_steps = "Symbols of derivations and of values for a drive" | "Formelzeichen der Herleitungen und der Werte für den Regler";
    glossary_steps_about =
        "What `antrieb explain` and `antrieb commission` show beside the symbols of the tables. A symbol with several meanings stands several times."
        | "Was `antrieb explain` und `antrieb commission` neben den Formelzeichen der Tabellen zeigen. Ein Zeichen mit mehreren Bedeutungen steht mehrfach.";
    columns_of_words = "| English | German | meaning |" | "| Englisch | Deutsch | Bedeutung |";
    columns_of_terms = "| symbol | name | unit | English | German | remark |" | "| Formelzeichen | Name | Einheit | Englisch | Deutsch | Bemerkung |";
    columns_of_steps = "| symbol | English | German |" | "| Formelzeichen | Englisch | Deutsch |";
    commands = "Commands" | "Befehle";
    commands_about =
        "Every command with its arguments, as in `antrieb help`. This page is generated from the command line; the guide explains the answers."
        | "Jeder Befehl mit seinen Argumenten, wie in `antrieb help`. Diese Seite ist aus der Befehlszeile erzeugt; die Antworten erklärt die Anleitung.";
    every_command_takes = "Options of every command" | "Optionen jedes Befehls";
    columns_of_arguments = "| argument | meaning |" | "| Argument | Bedeutung |";
    one_of(words) = "one of {words}" | "eines von {words}";
    without_it(value) = "{value} without it" | "ohne Angabe {value}";
    required = "required" | "nötig";
    several = "more than once" | "mehrfach";
}
