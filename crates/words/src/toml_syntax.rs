//! Messages of the parser of project files in German; in English they are its own.

use crate::texts::said;
use quantities::Language;

/// Messages of the parser, as it writes them, and in German.
const MESSAGES: &[(&str, &str)] = &[
    ("duplicate key", "Schlüssel doppelt angegeben"),
    ("carriage return must be followed by newline", "auf einen Wagenrücklauf muss ein Zeilenende folgen"),
    ("missing opening quote", "öffnendes Anführungszeichen fehlt"),
    ("missing comma between array elements", "Komma zwischen den Einträgen der Liste fehlt"),
    ("missing comma between key-value pairs", "zwischen den Angaben fehlt ein Komma"),
    ("missing assignment between key-value pairs", "Gleichheitszeichen zwischen Schlüssel und Wert fehlt"),
    ("extra assignment between key-value pairs", "Gleichheitszeichen zu viel"),
    ("extra `=`", "Gleichheitszeichen zu viel"),
    ("unexpected `=` in array", "Gleichheitszeichen in einer Liste"),
    ("extra comma in array", "Komma zu viel in der Liste"),
    ("extra comma in inline table", "Komma zu viel in der Tabelle in geschweiften Klammern"),
    ("unclosed array", "Liste nicht geschlossen"),
    ("unclosed inline table", "Tabelle in geschweiften Klammern nicht geschlossen"),
    ("unclosed table", "Überschrift der Tabelle nicht geschlossen"),
    ("unclosed array table", "Überschrift des Tabelleneintrags nicht geschlossen"),
    ("missing table open", "öffnende Klammer der Überschrift fehlt"),
    ("missing array opening", "öffnende Klammer der Liste fehlt"),
    ("missing inline table opening", "öffnende geschweifte Klammer fehlt"),
    ("missing key for inline table element", "Schlüssel in der Tabelle in geschweiften Klammern fehlt"),
    ("invalid inline table element", "ungültige Angabe in der Tabelle in geschweiften Klammern"),
    ("missing value", "Wert fehlt"),
    ("missing value for key", "Wert des Schlüssels fehlt"),
    ("key with no value", "Schlüssel ohne Wert"),
    ("invalid value", "ungültiger Wert"),
    ("invalid boolean", "weder true noch false"),
    ("invalid date-time", "ungültige Angabe von Datum und Uhrzeit"),
    ("invalid datetime", "ungültige Angabe von Datum und Uhrzeit"),
    ("invalid date", "ungültiges Datum"),
    ("invalid time", "ungültige Uhrzeit"),
    ("invalid offset", "ungültige Abweichung von der koordinierten Weltzeit"),
    ("invalid string", "ungültiger Text"),
    ("invalid key", "ungültiger Schlüssel"),
    ("invalid table", "ungültige Tabelle"),
    ("invalid float", "ungültige Zahl"),
    ("invalid mantissa", "ungültige Zahl"),
    ("invalid fraction", "ungültige Nachkommastellen"),
    ("invalid exponent", "ungültiger Exponent"),
    ("invalid integer number", "ungültige ganze Zahl"),
    ("invalid binary number", "ungültige Binärzahl"),
    ("invalid octal number", "ungültige Oktalzahl"),
    ("invalid hexadecimal number", "ungültige Hexadezimalzahl"),
    ("invalid key-value pair", "ungültige Angabe von Schlüssel und Wert"),
    ("invalid unquoted key", "ungültiger Schlüssel ohne Anführungszeichen"),
    ("unquoted keys cannot be empty", "ein Schlüssel ohne Anführungszeichen darf nicht leer sein"),
    ("keys cannot be multi-line literal strings", "ein Schlüssel darf nicht über mehrere Zeilen gehen"),
    ("keys cannot be multi-line basic strings", "ein Schlüssel darf nicht über mehrere Zeilen gehen"),
    ("string values must be quoted", "ein Text muss in Anführungszeichen stehen"),
    ("unexpected key or value", "Schlüssel oder Wert an dieser Stelle nicht zulässig"),
    ("unexpected content", "Inhalt an dieser Stelle nicht zulässig"),
    ("unexpected content between comment and newline", "Inhalt zwischen Kommentar und Zeilenende nicht zulässig"),
    ("missing comment start", "Beginn des Kommentars fehlt"),
    ("invalid comment character", "unzulässiges Zeichen im Kommentar"),
    ("invalid basic string", "ungültiger Text in Anführungszeichen"),
    ("invalid literal string", "ungültiger Text in einfachen Anführungszeichen"),
    ("invalid multi-line basic string", "ungültiger mehrzeiliger Text"),
    ("invalid multi-line literal string", "ungültiger mehrzeiliger Text"),
    ("missing escaped value", "Zeichen hinter dem umgekehrten Schrägstrich fehlt"),
    ("too few unicode value digits", "zu wenige Ziffern im Unicode-Wert"),
    ("unexpected leading zero", "führende Null nicht zulässig"),
    ("unexpected sign", "Vorzeichen an dieser Stelle nicht zulässig"),
    ("redundant numeric sign", "Vorzeichen doppelt"),
    ("redundant integer number prefix", "Präfix der ganzen Zahl doppelt"),
    ("integers with a radix cannot be signed", "eine Zahl mit Präfix darf kein Vorzeichen haben"),
    ("radix must be lowercase", "das Präfix einer Zahl muss aus Kleinbuchstaben bestehen"),
    ("`_` may only go between digits", "`_` darf nur zwischen Ziffern stehen"),
    ("integer number overflowed", "ganze Zahl zu groß"),
    ("floating-point number overflowed", "Zahl zu groß"),
    ("cannot recurse further; max recursion depth met", "zu tief verschachtelt"),
    ("recursion limit", "zu tief verschachtelt"),
    (
        "cannot extend value of type inline table with a dotted key",
        "eine Tabelle in geschweiften Klammern lässt sich nicht ergänzen",
    ),
    ("cannot extend value of type array with a dotted key", "eine Liste lässt sich nicht durch Schlüssel ergänzen"),
    ("cannot extend value of type string with a dotted key", "ein Text lässt sich nicht durch Schlüssel ergänzen"),
    (
        "cannot extend value of type integer with a dotted key",
        "eine ganze Zahl lässt sich nicht durch Schlüssel ergänzen",
    ),
    ("cannot extend value of type float with a dotted key", "eine Zahl lässt sich nicht durch Schlüssel ergänzen"),
    (
        "cannot extend value of type boolean with a dotted key",
        "ein Wahrheitswert lässt sich nicht durch Schlüssel ergänzen",
    ),
    ("cannot extend value of type datetime with a dotted key", "ein Datum lässt sich nicht durch Schlüssel ergänzen"),
    ("cannot extend value of type table with a dotted key", "eine Tabelle lässt sich nicht ergänzen"),
    ("could not allocate for string", "zu wenig Arbeitsspeicher für den Text"),
];

/// Expected items that the parser describes in words.
const EXPECTED: &[(&str, &str)] = &[
    ("key", "Schlüssel"),
    ("value", "Wert"),
    ("newline", "Zeilenende"),
    ("numbers", "Ziffern"),
    ("digits", "Ziffern"),
    ("letters", "Buchstaben"),
    ("characters", "Zeichen"),
    ("printable characters", "druckbare Zeichen"),
    ("literal string", "Text in einfachen Anführungszeichen"),
    ("basic string", "Text in Anführungszeichen"),
    ("multi-line basic string", "mehrzeiliger Text"),
    ("unicode hexadecimal value", "hexadezimaler Unicode-Wert"),
    ("non-single-quote visible characters", "sichtbare Zeichen außer dem einfachen Anführungszeichen"),
    ("non-single-quote characters", "Zeichen außer dem einfachen Anführungszeichen"),
    ("non-double-quote visible characters", "sichtbare Zeichen außer dem Anführungszeichen"),
    ("nothing", "nichts"),
    ("`-` (YYYY-MM) or `:` (HH:MM)", "`-` (JJJJ-MM) oder `:` (hh:mm)"),
    ("`-` (MM-DD)", "`-` (MM-TT)"),
    ("`:` (HH:MM)", "`:` (hh:mm)"),
    ("`T` between date and time", "`T` zwischen Datum und Uhrzeit"),
    ("+OFFSET", "`+hh:mm`"),
    ("-OFFSET", "`-hh:mm`"),
    ("a four-digit year (YYYY)", "Jahr mit vier Ziffern (JJJJ)"),
    ("a two-digit month (MM)", "Monat mit zwei Ziffern (MM)"),
    ("a two-digit day (DD)", "Tag mit zwei Ziffern (TT)"),
    ("a two-digit hour (HH)", "Stunde mit zwei Ziffern (hh)"),
    ("a two-digit minute (MM)", "Minute mit zwei Ziffern (mm)"),
    ("a two-digit second (SS)", "Sekunde mit zwei Ziffern (ss)"),
    ("month between 01 and 12", "Monat von 01 bis 12"),
    ("day between 01 and 28", "Tag von 01 bis 28"),
    ("day between 01 and 29", "Tag von 01 bis 29"),
    ("day between 01 and 30", "Tag von 01 bis 30"),
    ("day between 01 and 31", "Tag von 01 bis 31"),
    ("hour between 00 and 23", "Stunde von 00 bis 23"),
    ("hours between 00 and 23", "Stunden von 00 bis 23"),
    ("minute between 00 and 59", "Minute von 00 bis 59"),
    ("minutes between 00 and 59", "Minuten von 00 bis 59"),
    ("second between 00 and 60", "Sekunde von 00 bis 60"),
    ("year or hour", "Jahr oder Stunde"),
    ("month", "Monat"),
    ("day", "Tag"),
    ("hour", "Stunde"),
    ("minute", "Minute"),
    ("second", "Sekunde"),
    ("nanosecond", "Nanosekunde"),
    ("nanoseconds overflowed", "höchstens neun Nachkommastellen"),
];

fn german<'t>(table: &[(&str, &'t str)], text: &str) -> Option<&'t str> {
    table.iter().find(|(english, _)| *english == text).map(|(_, german)| *german)
}

/// Returns a message of the parser in German; one that is not known is quoted, with a general statement.
pub(crate) fn in_german(message: &str) -> String {
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    let Some(what) = german(MESSAGES, what) else {
        return format!("Schreibweise an dieser Stelle nicht zulässig (Meldung „{message}“)");
    };
    if expected.is_empty() {
        return what.to_owned();
    }
    let expected: Vec<&str> = expected.split(", ").map(|item| german(EXPECTED, item).unwrap_or(item)).collect();
    format!("{what}, erwartet: {}", expected.join(", "))
}

/// Returns the name of an invisible character.
pub(crate) fn invisible(sign: char, language: Language) -> String {
    match sign {
        '\u{feff}' => said!(language => "byte order mark" | "Byte-Reihenfolge-Markierung"),
        '\u{200b}' => said!(language => "zero-width space" | "Leerzeichen ohne Breite"),
        '\u{a0}' | '\u{202f}' | '\u{2007}' => said!(language => "no-break space" | "geschütztes Leerzeichen"),
        '\u{ad}' => said!(language => "soft hyphen" | "bedingter Trennstrich"),
        '\u{c}' => said!(language => "form feed" | "Seitenvorschub"),
        '\0'..='\u{1f}' | '\u{7f}'..='\u{9f}' => said!(language => "control character" | "Steuerzeichen"),
        sign if sign.is_whitespace() => said!(language => "special space" | "besonderes Leerzeichen"),
        _ => said!(language => "invisible character" | "unsichtbares Zeichen"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axis::{AxisFault, AxisProject, NoCatalogue, NoFiles};
    use project::Fault;

    /// Returns the messages of the parser about a text.
    fn messages(text: &str) -> Vec<String> {
        let faults = AxisProject::read_all(text, &NoFiles, &NoCatalogue::shared(), &|_, _| None).unwrap_err();
        let message = |fault: AxisFault| match fault {
            AxisFault::Stated(Fault::Syntax { message, .. }) => Some(message),
            _ => None,
        };
        faults.into_iter().filter_map(|found| message(found.fault)).collect()
    }

    /// Requires German words for every part of a message; words in code spans are signs of the file.
    fn assert_german(message: &str) {
        let german = in_german(message);
        let english: Vec<String> = message
            .split(", expected ")
            .flat_map(|part| part.split(", "))
            .filter(|part| !part.starts_with('`') && part.chars().filter(char::is_ascii_lowercase).count() > 3)
            .map(str::to_owned)
            .collect();
        assert!(!german.contains("Meldung"), "{message}: {german}");
        for part in english {
            assert!(!german.contains(&part), "{message}: {german}");
        }
    }

    /// Every message about a date, a time, an offset or a number that one changed, missing or additional character causes is in
    /// German.
    #[test]
    fn every_message_about_a_date_is_german() {
        let mut kinds = std::collections::BTreeSet::new();
        let values = [
            "1979-02-28T07:32:00.999-07:30",
            "07:32:00.5",
            "1979-12-31 23:59:59Z",
            "2024-02-29",
            "1e3",
            "0x1F",
            "-1_0.5",
        ];
        for value in values {
            for at in 0..=value.len() {
                let (before, behind) = value.split_at(at);
                let mut all = vec![before.to_owned()];
                for sign in "09-:+.TZ_ ".chars() {
                    all.push(format!("{before}{sign}{behind}"));
                    all.push(format!("{before}{sign}{}", behind.get(1..).unwrap_or_default()));
                    all.push(format!("{before}{}", behind.get(1..).unwrap_or_default()));
                    all.push(format!("{before}{sign}"));
                }
                for each in all {
                    kinds.extend(messages(&format!("a = {each}\n")));
                }
            }
        }
        kinds.extend(
            ["1979-02-30", "2024-02-30", "1979-04-31", "1979-01-32", "1979-13-01"]
                .iter()
                .flat_map(|day| messages(&format!("a = {day}"))),
        );
        assert!(kinds.len() > 25, "{kinds:#?}");
        kinds.iter().for_each(|message| assert_german(message));
    }

    /// A key within a value of every type is reported in German.
    #[test]
    fn a_key_within_a_value_is_german() {
        let mut tried = 0;
        for value in ["1", "1.5", "true", "\"x\"", "1979-02-28", "[1]", "{ b = 1 }"] {
            for text in [
                format!("a = {value}\na.c = 1\n"),
                format!("a = {value}\n[a.c]\nd = 1\n"),
                format!("a = {value}\n[[a.c]]\n"),
            ] {
                for message in messages(&text) {
                    tried += 1;
                    assert_german(&message);
                }
            }
        }
        assert!(tried >= 20, "{tried}");
    }

    /// The faults that occur when a project file is typed are in German, with what the parser expected.
    #[test]
    fn usual_faults_of_the_syntax_are_german() {
        let texts = [
            "format = = 1",
            "format 1",
            "format =",
            "format = 1 1",
            "name = text",
            "[load",
            "[[motion]",
            "[load]\ninertia = \"1",
            "a = [1 2]",
            "a = [1, 2",
            "a = { b = 1",
            "a = { b = 1 c = 2 }",
            "a = 1\na = 2",
            "a = 01",
            "a = 1__0",
            "a = 'b",
            "a = \"\\q\"",
            "= 1",
            "a.b. = 1",
            "[load]]",
            "a = 1,5",
            "a = [1,,2]",
            "a = {,}",
            "[]",
            "a b = 1",
            "a = +-1",
            "a = 99999999999999999999",
            "a = \"1\" \"2\"",
            "a = { b }",
            "[load]\n[load]",
            "a = 0X1",
            "ä = 1",
            "a = \"\"\"b",
        ];
        let (mut tried, mut unknown) = (0, Vec::new());
        for text in texts {
            let faults = AxisProject::read_all(text, &NoFiles, &NoCatalogue::shared(), &|_, _| None).unwrap_err();
            for fault in faults {
                let AxisFault::Stated(Fault::Syntax { message, .. }) = &fault.fault else { continue };
                let german = in_german(message);
                if german.contains("Meldung") || german.contains("expected") || german.contains("missing") {
                    unknown.push((text, message.clone(), german));
                }
                tried += 1;
            }
        }
        assert!(unknown.is_empty(), "{unknown:#?}");
        assert!(tried >= texts.len() - 4, "{tried}");
        assert_eq!(
            in_german("unclosed array, expected `]`, value, newline"),
            "Liste nicht geschlossen, erwartet: `]`, Wert, Zeilenende"
        );
        assert!(in_german("a new message").contains("„a new message“"));
    }
}
