//! Words about ordering codes: fields, tokens, rules, faults.

use crate::pick;
use crate::texts::said;
use configurator::{BrokenRule, Rule, Uncovered};
use order_code::{CodeError, Field, OrderCode};
use quantities::Language;

/// The name of a field.
#[must_use]
pub fn describe_field(field: Field, language: Language) -> &'static str {
    let (en, de) = match field {
        Field::Series => ("series", "Baureihe"),
        Field::Size => ("size and version", "Baugröße und Version"),
        Field::Ratio => ("reduction ratio", "Untersetzung"),
        Field::Winding => ("motor winding and connectors", "Motorwicklung und Stecker"),
        Field::Feedback => ("motor feedback", "Motorfeedbacksystem"),
        Field::Brake => ("brake", "Bremse"),
        Field::Option1 => ("option 1 (sensor)", "Option 1 (Sensor)"),
        Field::Option2 => ("option 2 (cable, connector)", "Option 2 (Kabel, Stecker)"),
        Field::Special => ("special design", "Sonderausführung"),
    };
    if language == Language::De { de } else { en }
}

/// What one field of a code means, as the series states it.
#[must_use]
pub fn describe_token(code: &OrderCode, field: Field, language: Language) -> String {
    code.meaning(field).map_or_else(String::new, |[en, de]| pick(language, &en, &de).clone())
}

/// What the printed tables do not cover of a code, in words.
#[must_use]
pub fn describe_uncovered(what: Uncovered, language: Language) -> String {
    match what {
        Uncovered::LongerWith { option, table, footnote } => said!(language =>
            "option {option} makes the actuator longer than the standard; by how much is not printed (table {table}, footnote {footnote})"
            | "mit Option {option} ist der Antrieb länger als der Standard; um wie viel, ist nicht abgedruckt (Tabelle {table}, Fußnote {footnote})"
        ),
        Uncovered::SpecialDesign(_) => said!(language =>
            "special design: the tables hold for the standard; length and mass are not printed for it, and what else differs only the maker knows"
            | "Sonderausführung: Die Tabellen gelten für den Standard; Länge und Masse sind für sie nicht abgedruckt, weitere Abweichungen kennt nur der Hersteller"
        ),
        Uncovered::OutputEncoder(option) => said!(language =>
            "option {option}: the tables do not say whether length, mass and bore hold with the output encoder and its inner hollow shaft; ask the maker"
            | "Option {option}: Die Tabellen sagen nicht, ob Länge, Masse und Bohrung mit dem Abtriebsgeber und seiner inneren Hohlwelle gelten; beim Hersteller fragen"
        ),
    }
}

/// A broken rule in words.
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
            "winding {} is not offered with feedback {token} (table {table})"
            | "Wicklung {} wird nicht mit Feedback {token} angeboten (Tabelle {table})", code.winding
        ),
        Rule::NotInOrderingTables => said!(language =>
            "winding {token} stands in the matrix 12.1, but no ordering table lists it (table {table}); ask the maker"
            | "Wicklung {token} steht in der Matrix 12.1, aber in keiner Bestelltabelle (Tabelle {table}); beim Hersteller fragen"
        ),
        Rule::OnlyWith { feedback, longer: "" } => said!(language =>
            "option {token} exists with feedback {feedback} only (table {table})"
            | "Option {token} gibt es nur mit Feedback {feedback} (Tabelle {table})"
        ),
        Rule::OnlyWith { feedback, longer } => said!(language =>
            "option {token} exists for size {size} with feedback {feedback} only, and with a longer housing (table {table}, footnote {longer})"
            | "Option {token} gibt es bei Baugröße {size} nur mit Feedback {feedback} und größerer Baulänge (Tabelle {table}, Fußnote {longer})"
        ),
    }
}

/// A fault of a code's spelling in words, without the hint.
#[must_use]
pub fn describe_code_error(error: &CodeError, language: Language) -> String {
    let name = |field: &Field| describe_field(*field, language);
    match error {
        CodeError::Empty => said!(language => "the code is empty" | "der Code ist leer"),
        CodeError::TooLong { most, .. } => {
            said!(language => "the code is longer than {most} characters" | "der Code ist länger als {most} Zeichen")
        }
        CodeError::EmptyPart { .. } => {
            said!(language => "nothing stands at this hyphen" | "an diesem Bindestrich steht nichts")
        }
        CodeError::UnknownToken { found, expected, .. } if expected.len() > 1 => {
            said!(language => "`{found}` is not known here" | "`{found}` ist hier nicht bekannt")
        }
        CodeError::Ambiguous { found, .. } => said!(language =>
            "`{found}` can be read in more than one way; write the hyphens"
            | "`{found}` lässt sich auf mehr als eine Weise lesen; bitte mit Bindestrichen schreiben"
        ),
        CodeError::UnknownToken { field, found, .. } => {
            said!(language => "`{found}` is not known as: {}" | "`{found}` ist nicht bekannt als: {}", name(field))
        }
        CodeError::OutOfOrder { field, found, .. } => said!(language =>
            "`{found}` ({}) stands in the wrong place"
            | "`{found}` ({}) steht an der falschen Stelle", name(field)
        ),
        CodeError::Repeated { field, found, .. } => said!(language =>
            "{} is given twice, here as `{found}`"
            | "{} ist zweimal angegeben, hier als `{found}`", name(field)
        ),
        CodeError::Missing { field, .. } => said!(language => "{} is missing" | "es fehlt: {}", name(field)),
    }
}
