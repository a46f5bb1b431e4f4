//! Messages of the parser of project files in German; in English they are its own.

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
    ("invalid date-time", "ungültiges Datum"),
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

#[cfg(test)]
mod tests {
    use super::*;
    use axis::{AxisFault, AxisProject, NoCatalogue, NoFiles};
    use project::Fault;

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
