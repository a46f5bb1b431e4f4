//! Words for a list of pins: reasons why it cannot be read, and its differences.

use super::role_name;
use crate::hint_text;
use crate::pick;
use crate::texts::said;
use installation::wiring::{ListFault, PinColumn, PinDifference, PinFinding, Role, SignalGroup};
use project::Hint;
use quantities::Language;

fn group_name(group: SignalGroup, language: Language) -> &'static str {
    let (en, de) = match group {
        SignalGroup::Phase => ("motor phases", "Motorphasen"),
        SignalGroup::Earth => ("protective earth", "Schutzleiter"),
        SignalGroup::Brake => ("brake", "Bremse"),
        SignalGroup::Ptc => ("PTC thermistor", "Kaltleiter"),
        SignalGroup::Kty => ("temperature sensor KTY", "Temperatursensor KTY"),
        SignalGroup::Supply => ("encoder supply", "Geberversorgung"),
        SignalGroup::Sense => ("sense lines", "Sense-Leitungen"),
        SignalGroup::Incremental => ("incremental track", "Inkrementalspur"),
        SignalGroup::Reference => ("reference signal", "Referenzsignal"),
        SignalGroup::Commutation => ("commutation", "Kommutierung"),
        SignalGroup::Serial => ("data and clock", "Daten und Takt"),
        SignalGroup::Resolver => ("resolver winding", "Resolverwicklung"),
        SignalGroup::Shield => ("inner shield", "innerer Schirm"),
    };
    pick(language, en, de)
}

/// Returns a difference, in one sentence.
#[must_use]
pub fn difference_text(finding: &PinFinding, language: Language) -> String {
    let PinFinding { pin, expected, .. } = finding;
    let connector = role_name(finding.role, language);
    match &finding.difference {
        PinDifference::NoSuchConnector => {
            said!(language => "the ordering code has no {connector}" | "die Bestellbezeichnung hat keinen {connector}")
        }
        PinDifference::ConnectorNotListed => {
            said!(language => "{connector}: not in the list" | "{connector}: nicht in der Liste")
        }
        PinDifference::PinsNotPrinted => said!(language =>
            "{connector}: the pins are not stated for this ordering code"
            | "{connector}: die Stifte sind für diese Bestellbezeichnung nicht angegeben"
        ),
        PinDifference::OtherEncoder { of } => said!(language =>
            "this is the pin assignment of the {}: same connector, supply and ground interchanged"
            | "dies ist die Belegung: {}; gleiche Kupplung, Versorgung und Masse vertauscht", role_name(*of, language)
        ),
        PinDifference::NoSuchPin => said!(language => "there is no pin `{pin}`" | "einen Stift `{pin}` gibt es nicht"),
        PinDifference::PinTwice { first } => {
            said!(language => "pin {pin} is already listed in line {first}" | "Stift {pin} ist bereits in Zeile {first} aufgeführt")
        }
        PinDifference::Reversed { group, with } => {
            let name = group_name(*group, language);
            said!(language =>
                "{name}: polarity reversed, pins {pin} and {with} are interchanged"
                | "{name}: verpolt, die Stifte {pin} und {with} sind vertauscht"
            )
        }
        PinDifference::Swapped { with, written, .. } => said!(language =>
            "pins {pin} and {with} are interchanged: {pin} is {expected}, not {written}"
            | "die Stifte {pin} und {with} sind vertauscht: {pin} ist {expected}, nicht {written}"
        ),
        PinDifference::WrongPin { written, belongs, .. } => {
            let belongs = belongs.join(", ");
            if *expected == "-" {
                return said!(language =>
                    "{written} on pin {pin}, which is not connected; it belongs on pin {belongs}"
                    | "{written} auf Stift {pin}, der nicht belegt ist; es gehört auf Stift {belongs}"
                );
            }
            said!(language =>
                "{written} on pin {pin}, which is {expected}; it belongs on pin {belongs}"
                | "{written} auf Stift {pin}, der {expected} ist; es gehört auf Stift {belongs}"
            )
        }
        PinDifference::ForeignSignal { written } => said!(language =>
            "this connector has no signal {written}; pin {pin} is {expected}"
            | "ein Signal {written} hat dieser Stecker nicht; Stift {pin} ist {expected}"
        ),
        PinDifference::UnknownSignal { written, nearest } => {
            let near = nearest.map(|near| said!(language => ", perhaps {near}" | ", vielleicht {near}"));
            let near = near.unwrap_or_default();
            said!(language =>
                "unknown signal `{written}`{near}; pin {pin} is {expected}"
                | "unbekanntes Signal `{written}`{near}; Stift {pin} ist {expected}"
            )
        }
        PinDifference::NotConnected { written } => said!(language =>
            "{written} on pin {pin}, which is not connected"
            | "{written} auf Stift {pin}, der nicht belegt ist"
        ),
        PinDifference::LeftOpen { .. } => said!(language =>
            "pin {pin} is left open; it must carry {expected}"
            | "Stift {pin} ist nicht angeschlossen; er führt {expected}"
        ),
        PinDifference::Missing { .. } => said!(language =>
            "pin {pin} ({expected}) is not in the list"
            | "Stift {pin} ({expected}) fehlt in der Liste"
        ),
        PinDifference::Unshielded => {
            said!(language => "wire of pin {pin} without a shield" | "Ader von Stift {pin} ohne Schirm")
        }
        PinDifference::Colour { written, printed } => said!(language =>
            "pin {pin}: colour {written}, manual {printed}"
            | "Stift {pin}: Farbe {written}, laut Anleitung {printed}"
        ),
    }
}

/// Returns the action for a difference.
#[must_use]
pub const fn difference_action(finding: &PinFinding, language: Language) -> &'static str {
    let (en, de) = match (&finding.difference, finding.role) {
        (PinDifference::OtherEncoder { .. }, _) => (
            "do not connect: mark both connectors and wire each according to its own table",
            "nicht stecken: beide Stecker kennzeichnen und jeden nach seiner Tabelle verdrahten",
        ),
        (PinDifference::Reversed { group: SignalGroup::Supply, .. }, Role::Feedback | Role::OutputEncoder) => (
            "interchange before switching on the supply: reversed supply can destroy the encoder; the output encoder has supply and ground reversed on the same connector",
            "vor dem Einschalten tauschen: verpolte Versorgung kann den Geber zerstören; beim Abtriebsgeber liegen Versorgung und Masse auf der gleichen Kupplung umgekehrt",
        ),
        (PinDifference::Reversed { group: SignalGroup::Brake, .. }, _) => {
            ("interchange before supplying the brake", "vor dem Einschalten der Bremsenversorgung tauschen")
        }
        (PinDifference::Reversed { group: SignalGroup::Kty, .. }, _) => (
            "interchange: a KTY with reversed polarity reports a wrong temperature, and the winding is not protected",
            "tauschen: ein verpolter KTY meldet eine falsche Temperatur, und die Wicklung ist nicht geschützt",
        ),
        (
            PinDifference::Swapped { group: SignalGroup::Phase, .. }
            | PinDifference::WrongPin { group: SignalGroup::Phase, .. },
            _,
        ) => (
            "correct the phase sequence before the first motion: with wrong phases the motor does not follow its encoder and can run away",
            "Phasenfolge vor der ersten Bewegung berichtigen: bei falschen Phasen folgt der Motor seinem Geber nicht und kann durchgehen",
        ),
        (
            PinDifference::Swapped { group: SignalGroup::Earth, .. }
            | PinDifference::WrongPin { group: SignalGroup::Earth, .. }
            | PinDifference::LeftOpen { group: SignalGroup::Earth }
            | PinDifference::Missing { group: SignalGroup::Earth },
            _,
        ) => (
            "connect the protective earth to PE before switching on any voltage",
            "Schutzleiter vor jedem Einschalten mit PE verbinden",
        ),
        (
            PinDifference::Missing { group: SignalGroup::Shield }
            | PinDifference::LeftOpen { group: SignalGroup::Shield },
            _,
        ) => ("connect the inner shield", "den inneren Schirm anschließen"),
        (
            PinDifference::Missing { group: SignalGroup::Sense }
            | PinDifference::LeftOpen { group: SignalGroup::Sense },
            _,
        ) => ("only for a drive without sense inputs", "nur bei einem Servoregler ohne Sense-Eingänge"),
        (PinDifference::Unshielded, _) => {
            ("all connecting cables must be shielded", "alle Anschlussleitungen müssen geschirmt sein")
        }
        (PinDifference::Colour { .. }, _) => {
            ("wire by pin, colours repeat", "nach Stift verdrahten, Farben wiederholen sich")
        }
        (PinDifference::NoSuchPin, _) => {
            ("use the pin numbers of `antrieb wiring`", "Stiftnummern nach `antrieb wiring` verwenden")
        }
        (PinDifference::PinTwice { .. }, _) => ("keep one row only", "nur eine Zeile behalten"),
        (PinDifference::NoSuchConnector, _) => {
            ("remove its rows from the list", "seine Zeilen aus der Liste entfernen")
        }
        (PinDifference::ConnectorNotListed, _) => ("not compared", "nicht verglichen"),
        (PinDifference::PinsNotPrinted, _) => ("ask the manufacturer", "beim Hersteller erfragen"),
        (PinDifference::Missing { .. } | PinDifference::LeftOpen { .. }, _) => {
            ("add, or state the reason", "ergänzen oder begründen")
        }
        _ => ("wire as stated in the manual", "nach Anleitung verdrahten"),
    };
    pick(language, en, de)
}

/// Returns the heading of a column, as in the documentation.
const fn column_name(column: PinColumn, language: Language) -> &'static str {
    match column {
        PinColumn::Connector => pick(language, "connector", "Stecker"),
        PinColumn::Pin => pick(language, "pin", "Stift"),
        PinColumn::Signal => pick(language, "signal", "Signal"),
        PinColumn::Colour => pick(language, "colour", "Farbe"),
        PinColumn::Shield => pick(language, "shield", "Schirm"),
    }
}

/// Returns the reason why a list cannot be read, in one sentence.
#[must_use]
pub fn list_fault(fault: &ListFault, language: Language) -> String {
    match fault {
        ListFault::Empty => said!(language => "the list is empty" | "die Liste ist leer"),
        ListFault::NoRows => {
            said!(language => "the list has a header but no rows" | "die Liste hat eine Kopfzeile, aber keine Zeilen")
        }
        ListFault::ColumnMissing { column, found } => {
            let (name, found) = (column_name(*column, language), found.join(", "));
            said!(language => "no column `{name}`; columns found: {found}" | "keine Spalte `{name}`; vorhandene Spalten: {found}")
        }
        ListFault::ColumnTwice { column, .. } => {
            let name = column_name(*column, language);
            said!(language => "two columns for `{name}`" | "zwei Spalten für `{name}`")
        }
        ListFault::ColumnUnknown { head, .. } => {
            said!(language => "unknown column `{head}`" | "unbekannte Spalte `{head}`")
        }
        ListFault::Ragged { found, expected, .. } => said!(language =>
            "{found} cells; the header has {expected}"
            | "{found} Zellen; die Kopfzeile hat {expected}"
        ),
        ListFault::CellEmpty { column, .. } => {
            let name = column_name(*column, language);
            said!(language => "`{name}` is empty" | "`{name}` ist leer")
        }
        ListFault::ConnectorUnknown { written, .. } => {
            said!(language => "unknown connector `{written}`" | "unbekannter Stecker `{written}`")
        }
        ListFault::ShieldUnclear { written, .. } => said!(language =>
            "`{written}` does not state whether the wire is shielded"
            | "`{written}` gibt nicht an, ob die Ader geschirmt ist"
        ),
        ListFault::More => {
            said!(language => "there are more faults than listed here" | "es gibt mehr Fehler als hier aufgeführt")
        }
    }
}

/// Returns the expected content instead.
#[must_use]
pub fn list_fault_hint(fault: &ListFault, language: Language) -> Option<String> {
    let valid = |names: &[&str]| {
        let names = names.iter().map(|name| (*name).to_owned()).collect();
        Some(hint_text(&Hint::ValidAre(names), language))
    };
    match fault {
        ListFault::Empty | ListFault::NoRows | ListFault::ColumnMissing { .. } => {
            let line = "connector,pin,signal / motor,1,U";
            Some(hint_text(&Hint::Example(line.to_owned()), language))
        }
        ListFault::ColumnUnknown { .. } => {
            let names: Vec<&str> = PinColumn::ALL.iter().map(|column| column_name(*column, language)).collect();
            valid(&names)
        }
        ListFault::ConnectorUnknown { .. } => {
            let names: Vec<&str> = Role::ALL.iter().map(|role| role.id()).collect();
            valid(&names)
        }
        ListFault::ShieldUnclear { .. } => valid(&[pick(language, "yes", "ja"), pick(language, "no", "nein")]),
        ListFault::ColumnTwice { .. } | ListFault::Ragged { .. } | ListFault::CellEmpty { .. } | ListFault::More => {
            None
        }
    }
}
