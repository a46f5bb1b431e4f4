//! Words about ordering codes: fields, tokens, rules, faults.

use crate::pick;
use crate::texts::said;
use configurator::{BrokenRule, Rule, Uncovered};
use order_code::{CodeError, Field, OrderCode};
use quantities::Language;

/// Returns the name of a field.
#[must_use]
pub fn describe_field(field: Field, language: Language) -> &'static str {
    let (en, de) = match field {
        Field::Series => ("series", "Baureihe"),
        Field::Size => ("size and version", "Baugröße und Version"),
        Field::Ratio => ("reduction ratio", "Untersetzung"),
        Field::Winding => ("motor winding and connectors", "Motorwicklung und Stecker"),
        Field::Feedback => ("motor encoder", "Motorgeber"),
        Field::Brake => ("brake", "Bremse"),
        Field::Option1 => ("option 1 (sensor)", "Option 1 (Sensor)"),
        Field::Option2 => ("option 2 (cable, connector)", "Option 2 (Leitung, Stecker)"),
        Field::Special => ("special design", "Sonderausführung"),
    };
    if language == Language::De { de } else { en }
}

/// Returns the meaning of one field of a code, as stated by the series; empty if the series states none.
#[must_use]
pub fn describe_token(code: &OrderCode, field: Field, language: Language) -> String {
    code.meaning(field).map_or_else(String::new, |[en, de]| pick(language, &en, &de).clone())
}

/// Returns a property of a code that the manual does not cover, as text.
#[must_use]
pub fn describe_uncovered(what: Uncovered, language: Language) -> String {
    match what {
        Uncovered::LongerWith { option, table, footnote } => said!(language =>
            "option {option} makes the actuator longer than the standard version; the manual does not state by how much (table {table}, footnote {footnote})"
            | "mit Option {option} ist der Antrieb länger als die Standardausführung; die Anleitung nennt das Maß nicht (Tabelle {table}, Fußnote {footnote})"
        ),
        Uncovered::SpecialDesign(_) => said!(language =>
            "special design: the tables are valid for the standard version; length and mass are not stated for the special design, other differences are known to the manufacturer only"
            | "Sonderausführung: Die Tabellen gelten für die Standardausführung; Länge und Masse der Sonderausführung sind nicht angegeben, weitere Abweichungen beim Hersteller erfragen"
        ),
        Uncovered::OutputEncoder(option) => said!(language =>
            "option {option}: the tables do not state whether length, mass and bore are valid with the output encoder and its inner hollow shaft; ask the manufacturer"
            | "Option {option}: Aus den Tabellen geht nicht hervor, ob Länge, Masse und Bohrung auch mit Abtriebsgeber und innerer Hohlwelle gelten; beim Hersteller erfragen"
        ),
    }
}

/// Returns a broken rule as text.
#[must_use]
pub fn describe_rule(code: &OrderCode, broken: &BrokenRule, language: Language) -> String {
    let token = code.token(broken.field).unwrap_or("");
    let (size, field, table) = (code.size, describe_field(broken.field, language), broken.table);
    match broken.rule {
        Rule::NotForSize => said!(language =>
            "{field} {token} does not exist for size {size} (table {table})"
            | "{field} {token} gibt es nicht für Baugröße {size} (Tabelle {table})"
        ),
        Rule::PairNotListed => said!(language =>
            "winding {} is not available with encoder {token} (table {table})"
            | "Wicklung {} ist nicht mit Geber {token} lieferbar (Tabelle {table})", code.winding
        ),
        Rule::NotInOrderingTables => said!(language =>
            "winding {token} is contained in matrix 12.1, but in no ordering table (table {table}); ask the manufacturer"
            | "Wicklung {token} ist in der Matrix 12.1, aber in keiner Bestelltabelle enthalten (Tabelle {table}); beim Hersteller erfragen"
        ),
        Rule::OnlyWith { feedback, longer: "" } => said!(language =>
            "option {token} is available with encoder {feedback} only (table {table})"
            | "Option {token} ist nur mit Geber {feedback} lieferbar (Tabelle {table})"
        ),
        Rule::OnlyWith { feedback, longer } => said!(language =>
            "option {token} is available for size {size} with encoder {feedback} only, and with a longer housing (table {table}, footnote {longer})"
            | "Option {token} ist bei Baugröße {size} nur mit Geber {feedback} und größerer Baulänge lieferbar (Tabelle {table}, Fußnote {longer})"
        ),
    }
}

/// Returns a fault in the spelling of a code as text, without the hint.
#[must_use]
pub fn describe_code_error(error: &CodeError, language: Language) -> String {
    let name = |field: &Field| describe_field(*field, language);
    match error {
        CodeError::Empty => said!(language => "the ordering code is empty" | "die Bestellbezeichnung ist leer"),
        CodeError::TooLong { most, .. } => {
            said!(language => "the ordering code is longer than {most} characters" | "die Bestellbezeichnung ist länger als {most} Zeichen")
        }
        CodeError::EmptyPart { .. } => {
            said!(language => "a field is missing at this hyphen" | "an diesem Bindestrich fehlt eine Angabe")
        }
        CodeError::UnknownToken { found, expected, .. } if expected.len() > 1 => {
            said!(language => "`{found}` is not known here" | "`{found}` ist hier nicht bekannt")
        }
        CodeError::Ambiguous { found, .. } => said!(language =>
            "`{found}` is ambiguous; write it with hyphens"
            | "`{found}` ist nicht eindeutig; mit Bindestrichen schreiben"
        ),
        CodeError::UnknownToken { field, found, .. } => {
            said!(language => "`{found}` is no known {}" | "`{found}` ist nicht bekannt ({})", name(field))
        }
        CodeError::OutOfOrder { field, found, .. } => said!(language =>
            "`{found}` ({}) is in the wrong position"
            | "`{found}` ({}) steht an der falschen Stelle", name(field)
        ),
        CodeError::Repeated { field, found, .. } => said!(language =>
            "{} is given twice, here as `{found}`"
            | "{} ist zweimal angegeben, hier als `{found}`", name(field)
        ),
        CodeError::Missing { field, .. } => said!(language => "{} is missing" | "es fehlt: {}", name(field)),
    }
}
