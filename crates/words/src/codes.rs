//! Words about ordering codes: fields, tokens, rules, faults.

use super::either;
use configurator::{BrokenRule, Rule, Uncovered};
use order_code::{CodeError, Field, Option2, OrderCode, Winding};
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

/// What one field of a code means.
#[must_use]
pub fn describe_token(code: &OrderCode, field: Field, language: Language) -> String {
    let token = code.token(field).unwrap_or("");
    // Option 2 replaces the exit that is standard for the winding (tables 11.3 and 11.6).
    let standard_exit = code.option_2.is_none();
    let connector_exit = matches!(code.option_2, Some(Option2::R | Option2::S));
    let (en, de) = match (field, token) {
        (Field::Series, _) => ("AC servo actuators with hollow shaft", "AC-Servoantriebe mit Hohlwelle"),
        (Field::Size, size) => {
            return either(language, format!("frame size {size}"), format!("Baugröße {size}"));
        }
        (Field::Ratio, ratio) => {
            return either(language, format!("reduction ratio {ratio} : 1"), format!("Untersetzung {ratio} : 1"));
        }
        (Field::Winding, "E") if !standard_exit => {
            ("48 V DC link; M17 connectors, 8-pin and 17-pin", "Zwischenkreis 48 V; Stecker M17, 8- und 17-polig")
        }
        (Field::Winding, "E") => (
            "48 V DC link; 8-pin and 17-pin M17 connectors on the housing",
            "Zwischenkreis 48 V; Stecker M17, 8- und 17-polig, am Gehäuse",
        ),
        (Field::Winding, "N") => (
            "680 V DC link; cable exit, 8-pin and 17-pin M17 connectors",
            "Zwischenkreis 680 V; Kabelabgang, Stecker M17, 8- und 17-polig",
        ),
        (Field::Winding, "L") => (
            "named in the matrix only, not in the ordering tables",
            "nur in der Matrix genannt, nicht in den Bestelltabellen",
        ),
        (Field::Winding, _) if connector_exit => (
            "680 V DC link; M23 connectors, motor 6-pin, feedback 17-pin (resolver 12-pin)",
            "Zwischenkreis 680 V; Stecker M23, Motor 6-polig, Feedback 17-polig (Resolver 12-polig)",
        ),
        (Field::Winding, _) => (
            "680 V DC link; cable exit, M23 connectors, motor 6-pin, feedback 17-pin (resolver 12-pin)",
            "Zwischenkreis 680 V; Kabelabgang, Stecker M23, Motor 6-polig, Feedback 17-polig (Resolver 12-polig)",
        ),
        (Field::Feedback, "C1024") => (
            "incremental encoder, 1024 sine periods, with commutation track",
            "Inkrementalgeber, 1024 Sinusperioden, mit Kommutierungsspur",
        ),
        (Field::Feedback, "M512P") => (
            "multiturn absolute encoder, EnDat, 512 sine periods",
            "Multiturn-Absolutwertgeber, EnDat, 512 Sinusperioden",
        ),
        (Field::Feedback, "RES") => ("resolver, one pole pair", "Resolver, einpolpaarig"),
        (Field::Feedback, "D2048") => (
            "incremental encoder, 2048 lines, square wave, commutation signals",
            "Inkrementalgeber, 2048 Striche, Rechteck, Kommutierungssignale",
        ),
        (Field::Feedback, _) => (
            "multiturn absolute encoder, SSI, 128 sine periods, battery-buffered",
            "Multiturn-Absolutwertgeber, SSI, 128 Sinusperioden, batteriegepuffert",
        ),
        (Field::Brake, "B") => ("holding brake, 24 V", "Haltebremse, 24 V"),
        (Field::Brake, _) => ("without brake", "ohne Bremse"),
        (Field::Option1, "EC") => {
            ("single-turn absolute EnDat encoder at the output", "Singleturn-Absolutwertgeber EnDat am Abtrieb")
        }
        (Field::Option1, _) => ("without output encoder", "ohne Abtriebsgeber"),
        (Field::Option2, "K") if code.winding == Winding::E => (
            "axial cable exit, instead of the connectors on the housing",
            "axialer Kabelabgang statt der Stecker am Gehäuse",
        ),
        (Field::Option2, "K") => ("axial cable exit", "axialer Kabelabgang"),
        (Field::Option2, "R") => ("axial connector exit", "axialer Steckerabgang"),
        (Field::Option2, "S") => ("radial connector exit", "radialer Steckerabgang"),
        (Field::Option2, _) if code.winding == Winding::E => {
            ("standard, connectors on the housing", "Standard, Stecker am Gehäuse")
        }
        (Field::Option2, _) => ("standard, radial cable exit", "Standard, radialer Kabelabgang"),
        (Field::Special, "SP") => ("special design to the customer's wish", "Sonderausführung nach Kundenwunsch"),
        (Field::Special, _) => ("standard design", "Standardausführung"),
    };
    either(language, en, de)
}

/// What the printed tables do not cover of a code, in words.
#[must_use]
pub fn describe_uncovered(what: Uncovered, language: Language) -> &'static str {
    let (en, de) = match what {
        Uncovered::LongerWithK => (
            "option K makes the actuator longer than the standard; by how much is not printed (table 12.1, footnote 1)",
            "mit Option K ist der Antrieb länger als der Standard; um wie viel, ist nicht abgedruckt (Tabelle 12.1, Fußnote 1)",
        ),
        Uncovered::SpecialDesign => (
            "special design: the tables hold for the standard; length and mass are not printed for it, and what else differs only the maker knows",
            "Sonderausführung: Die Tabellen gelten für den Standard; Länge und Masse sind für sie nicht abgedruckt, weitere Abweichungen kennt nur der Hersteller",
        ),
        Uncovered::OutputEncoder => (
            "option EC: the tables do not say whether length, mass and bore hold with the output encoder and its inner hollow shaft; ask the maker",
            "Option EC: Die Tabellen sagen nicht, ob Länge, Masse und Bohrung mit dem Abtriebsgeber und seiner inneren Hohlwelle gelten; beim Hersteller fragen",
        ),
    };
    if language == Language::De { de } else { en }
}

/// A broken rule in words.
#[must_use]
pub fn describe_rule(code: &OrderCode, broken: &BrokenRule, language: Language) -> String {
    let token = code.token(broken.field).unwrap_or("");
    let (size, field, table) = (code.size, describe_field(broken.field, language), broken.table);
    match broken.rule {
        Rule::NotForSize => either(
            language,
            format!("{field} {token} does not exist for size {size} (table {table})"),
            format!("{field} {token} gibt es nicht für Baugröße {size} (Tabelle {table})"),
        ),
        Rule::PairNotListed => either(
            language,
            format!("winding {} is not offered with feedback {token} (table {table})", code.winding),
            format!("Wicklung {} wird nicht mit Feedback {token} angeboten (Tabelle {table})", code.winding),
        ),
        Rule::NotInOrderingTables => either(
            language,
            format!(
                "winding {token} stands in the matrix 12.1, but no ordering table lists it (table {table}); ask the maker"
            ),
            format!(
                "Wicklung {token} steht in der Matrix 12.1, aber in keiner Bestelltabelle (Tabelle {table}); beim Hersteller fragen"
            ),
        ),
        Rule::OnlyWithM512P => either(
            language,
            format!("option {token} exists with feedback M512P only (table {table})"),
            format!("Option {token} gibt es nur mit Feedback M512P (Tabelle {table})"),
        ),
        Rule::OnlyWithResolver => either(
            language,
            format!(
                "option {token} exists for size {size} with the resolver only, and with a longer housing (table {table}, footnote 1)"
            ),
            format!(
                "Option {token} gibt es bei Baugröße {size} nur mit Resolver und größerer Baulänge (Tabelle {table}, Fußnote 1)"
            ),
        ),
    }
}

/// A fault of a code's spelling in words, without the hint.
#[must_use]
pub fn describe_code_error(error: &CodeError, language: Language) -> String {
    let name = |field: &Field| describe_field(*field, language);
    match error {
        CodeError::Empty => either(language, "the code is empty", "der Code ist leer"),
        CodeError::TooLong { most, .. } => either(
            language,
            format!("the code is longer than {most} characters"),
            format!("der Code ist länger als {most} Zeichen"),
        ),
        CodeError::EmptyPart { .. } => {
            either(language, "nothing stands at this hyphen", "an diesem Bindestrich steht nichts")
        }
        CodeError::UnknownToken { found, expected, .. } if expected.len() > 1 => {
            either(language, format!("`{found}` is not known here"), format!("`{found}` ist hier nicht bekannt"))
        }
        CodeError::Ambiguous { found, .. } => either(
            language,
            format!("`{found}` can be read in more than one way; write the hyphens"),
            format!("`{found}` lässt sich auf mehr als eine Weise lesen; bitte mit Bindestrichen schreiben"),
        ),
        CodeError::UnknownToken { field, found, .. } => either(
            language,
            format!("`{found}` is not known as: {}", name(field)),
            format!("`{found}` ist nicht bekannt als: {}", name(field)),
        ),
        CodeError::OutOfOrder { field, found, .. } => either(
            language,
            format!("`{found}` ({}) stands in the wrong place", name(field)),
            format!("`{found}` ({}) steht an der falschen Stelle", name(field)),
        ),
        CodeError::Repeated { field, found, .. } => either(
            language,
            format!("{} is given twice, here as `{found}`", name(field)),
            format!("{} ist zweimal angegeben, hier als `{found}`", name(field)),
        ),
        CodeError::Missing { field, .. } => {
            either(language, format!("{} is missing", name(field)), format!("es fehlt: {}", name(field)))
        }
    }
}
