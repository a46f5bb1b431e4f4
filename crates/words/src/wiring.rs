//! Words for connectors, pins and cables.

mod checked;

pub use checked::{difference_action, difference_text, list_fault, list_fault_hint};

use crate::pick;
use crate::texts::{said, texts};
use catalogue::Cell;
use installation::wiring::{
    Absent, CableFor, CableRole, Circuit, DropVerdict, Polarity, Protocol, Role, Severity, SignalMeaning, TrackForm,
    WiringSignal,
};
use quantities::Language;

texts! {
    title(code) = "Wiring of {code}" | "Verdrahtung von {code}";
    pin = "pin" | "Stift";
    signal = "signal" | "Signal";
    colour = "colour" | "Farbe";
    joined(pin) = "(wire of {pin})" | "(Ader von {pin})";
    mating_coupling(number) = "mating coupling: material number {number}" | "Kabelkupplung: Materialnummer {number}";
    outer_diameter(value) = "outer diameter {value} mm" | "Außendurchmesser {value} mm";
    length_of_coupling(value) = "length {value} mm" | "Länge {value} mm";
    same_colour(colour, pins) =
        "colour {colour} on pins {pins}: wire by pin, not by colour"
        | "Farbe {colour} an den Stiften {pins}: nach Stift verdrahten, nicht nach Farbe";
    at_the_end_of_a_cable = "at the end of a cable" | "am Leitungsende";
    in_the_housing = "in the housing" | "im Gehäuse";
    cables = "cables" | "Leitungen";
    no_cables = "the manual lists no cable for this ordering code" | "die Anleitung nennt für diese Bestellbezeichnung keine Leitung";
    material_number = "material number" | "Materialnummer";
    length = "length" | "Länge";
    connects = "connects" | "verbindet";
    goes_to = "for" | "für";
    length_in_number(letters) =
        "{letters} in a material number stands for the cable length; the length codes are defined by the drive manufacturer and not contained in the manual"
        | "{letters} in einer Materialnummer steht für die Leitungslänge; die Kennbuchstaben legt der Hersteller des Servoreglers fest, die Anleitung enthält sie nicht";
    not_available = "not available / not stated" | "nicht vorhanden / nicht angegeben";
    rules = "rules and hazards" | "Regeln und Gefahren";
    sense_lines(supply, ground) =
        "the sense lines (pins {supply} and {ground}) report the voltage at the encoder to the drive; only drives that evaluate them compensate the voltage drop of the wires"
        | "die Sense-Leitungen (Stifte {supply} und {ground}) melden dem Servoregler die Spannung am Geber; nur Servoregler mit Auswertung dieser Leitungen gleichen den Spannungsabfall der Adern aus";
    empty_field(table, pin) = "table {table}, pin {pin}: empty field" | "Tabelle {table}, Stift {pin}: leeres Feld";
    held_brake = "brake holding current" | "Haltestrom der Bremse";
    voltage_drop(length) = "voltage drop over {length} m of cable (supply and return)" | "Spannungsabfall auf {length} m Leitung (Hin- und Rückleiter)";
    circuit = "circuit" | "Stromkreis";
    at_20_degc = "V at 20 °C" | "V bei 20 °C";
    at_70_degc = "V at 70 °C" | "V bei 70 °C";
    nominal_v = "U_nom V" | "U_nenn V";
    least_v = "U_min V";
    least_mm2 = "required mm²" | "erf. Querschnitt mm²";
    copper =
        "annealed copper at 20 °C, and at 70 °C (assumed: limit of PVC insulation); supply at its nominal voltage (assumed)"
        | "weichgeglühtes Kupfer bei 20 °C und bei 70 °C (angenommen: Grenze der PVC-Isolierung); Versorgung mit Nennspannung (angenommen)";
    sense_makes_up =
        "with sense lines the drive may compensate the voltage drop"
        | "mit Sense-Leitungen kann der Servoregler den Spannungsabfall ausgleichen";
    length_must_be_positive(most) =
        "the cable length must be greater than zero and at most {most} m"
        | "die Leitungslänge muss größer als null und höchstens {most} m sein";
    section_must_be_positive(most) =
        "the cross-section must be greater than zero and at most {most} mm²"
        | "der Querschnitt muss größer als null und höchstens {most} mm² sein";
    check_or_draw =
        "--check compares a list and draws nothing: omit --svg and --png"
        | "--check vergleicht eine Liste und zeichnet nicht: --svg und --png weglassen";
    no_such_connector(code, roles) =
        "{code} has no such connector; it has {roles}"
        | "{code} hat keinen solchen Stecker; es gibt {roles}";
    no_pins_to_draw = "the pins of this connector are not stated for this ordering code" | "die Stifte dieses Steckers sind für diese Bestellbezeichnung nicht angegeben";
    drive_values =
        "Values and encoder settings for the servo drive"
        | "Werte und Gebereinstellungen für den Servoregler";
    agrees(rows) = "{rows} rows agree with the manual" | "{rows} Zeilen stimmen mit der Anleitung überein";
    differs(agreeing, rows) =
        "{agreeing} of {rows} rows agree with the manual"
        | "{agreeing} von {rows} Zeilen stimmen mit der Anleitung überein";
    severity = "severity" | "Schwere";
    line = "line" | "Zeile";
    connector = "connector" | "Stecker";
    finding = "difference and remedy" | "Abweichung und Abhilfe";
    pin_list_too_large(most) = "the list is longer than {most} bytes" | "die Liste ist länger als {most} Bytes";
    mating_face = "mating face" | "Steckgesicht";
    face_of_a_code =
        "use `antrieb wiring CODE --svg FILE` to draw a mating face"
        | "Steckgesicht zeichnen mit `antrieb wiring CODE --svg DATEI`";
    schematic =
        "schematic: arrangement of the pins differs from the insert, whose figure is not contained in the text of the manual; the numbers on the insert apply"
        | "schematisch: die Anordnung der Stifte entspricht nicht der des Einsatzes, dessen Abbildung im Text der Anleitung fehlt; es gelten die Nummern auf dem Einsatz";
    face_described(poles, thread, pins) =
        "Connector with {poles} poles, {thread}. Pins: {pins}."
        | "Stecker mit {poles} Polen, {thread}. Stifte: {pins}.";
}

/// Returns a printed cell in the language; a dash without a cell.
#[must_use]
pub fn cell_or_dash(cell: Option<&'static Cell>, language: Language) -> &'static str {
    cell.map_or("-", |cell| crate::cell_text(cell, language))
}

/// Returns the name of a connector.
#[must_use]
pub const fn role_name(role: Role, language: Language) -> &'static str {
    match role {
        Role::Motor => pick(language, "motor connector", "Motorstecker"),
        Role::Feedback => pick(language, "connector of the motor encoder", "Stecker des Motorgebers"),
        Role::OutputEncoder => {
            pick(language, "connector of the output encoder (EC)", "Stecker des Abtriebsgebers (EC)")
        }
    }
}

/// Returns the meaning of a signal, with its end of the pair.
#[must_use]
pub fn signal_meaning(signal: WiringSignal, language: Language) -> String {
    let named = |en: &str, de: &str, name: char| format!("{} {name}", pick(language, en, de));
    let serial = |protocol| match protocol {
        Protocol::EnDat => "EnDat",
        Protocol::Ssi => "SSI",
    };
    let text = match signal.meaning {
        SignalMeaning::Phase(name) => named("motor phase", "Motorphase", name),
        SignalMeaning::ProtectiveEarth => said!(language => "protective earth" | "Schutzleiter"),
        SignalMeaning::Brake => said!(language => "supply of the holding brake" | "Versorgung der Haltebremse"),
        SignalMeaning::Ptc => said!(language =>
            "PTC thermistors of the winding, one of the two terminals, no polarity"
            | "Kaltleiter (PTC) der Wicklung, einer der beiden Anschlüsse, polungsfrei"
        ),
        SignalMeaning::Kty => said!(language =>
            "temperature sensor KTY 84-130 of the winding"
            | "Temperatursensor KTY 84-130 der Wicklung"
        ),
        SignalMeaning::Supply => said!(language => "supply of the encoder" | "Versorgung des Gebers"),
        SignalMeaning::Ground => said!(language => "ground of the encoder supply" | "Masse der Geberversorgung"),
        SignalMeaning::SupplySense => said!(language => "sense line of the supply" | "Sense-Leitung der Versorgung"),
        SignalMeaning::GroundSense => said!(language => "sense line of the ground" | "Sense-Leitung der Masse"),
        SignalMeaning::Track(name, form) => {
            let form = match form {
                TrackForm::Sinusoidal => said!(language => "sinusoidal" | "sinusförmig"),
                TrackForm::Sine => said!(language => "sine" | "Sinus"),
                TrackForm::Cosine => said!(language => "cosine" | "Kosinus"),
                TrackForm::Square => said!(language => "square wave RS422" | "Rechteck RS422"),
            };
            format!("{}, {form}", named("incremental track", "Inkrementalspur", name))
        }
        SignalMeaning::Reference => said!(language => "reference signal" | "Referenzsignal"),
        SignalMeaning::Zero => said!(language => "reference signal, RS422" | "Referenzsignal, RS422"),
        SignalMeaning::CommutationTrack(name) => {
            format!(
                "{}, {}",
                named("commutation track", "Kommutierungsspur", name),
                said!(language => "sinusoidal" | "sinusförmig")
            )
        }
        SignalMeaning::CommutationPhase(name) => {
            format!("{}, RS422", named("commutation signal", "Kommutierungssignal", name))
        }
        SignalMeaning::Data(protocol) => said!(language => "{} data" | "{}-Daten", serial(protocol)),
        SignalMeaning::Clock(protocol) => said!(language => "{} clock" | "{}-Takt", serial(protocol)),
        SignalMeaning::ResolverSine => {
            said!(language => "sine winding of the resolver" | "Sinuswicklung des Resolvers")
        }
        SignalMeaning::ResolverCosine => {
            said!(language => "cosine winding of the resolver" | "Kosinuswicklung des Resolvers")
        }
        SignalMeaning::Excitation => said!(language => "excitation of the resolver" | "Erregung des Resolvers"),
        SignalMeaning::Shield => said!(language => "inner shield of the cable" | "innerer Schirm der Leitung"),
    };
    match signal.polarity {
        None => text,
        Some(Polarity::Plus) => format!("{text}, {}", said!(language => "plus" | "Plus")),
        Some(Polarity::Minus) => format!("{text}, {}", said!(language => "minus" | "Minus")),
    }
}

/// Returns the text of a pin without a signal.
#[must_use]
pub const fn unconnected(has_wire: bool, language: Language) -> &'static str {
    if has_wire {
        pick(language, "no signal; the wire is present", "kein Signal; die Ader ist vorhanden")
    } else {
        pick(language, "not connected", "nicht belegt")
    }
}

/// Returns the part of the actuator that a cable connects.
#[must_use]
pub const fn cable_role(role: CableRole, language: Language) -> &'static str {
    match role {
        CableRole::Motor => pick(language, "motor", "Motor"),
        CableRole::Feedback => pick(language, "motor encoder", "Motorgeber"),
        CableRole::OutputEncoder => pick(language, "output encoder", "Abtriebsgeber"),
        CableRole::Set => pick(language, "cable set; contents not stated", "Leitungssatz; Inhalt nicht angegeben"),
    }
}

/// Returns the counterpart to which a cable leads.
#[must_use]
pub const fn cable_goal(goal: CableFor, language: Language) -> &'static str {
    match goal {
        CableFor::SinamicsSmc => pick(language, "SINAMICS S120 with SMC module", "SINAMICS S120 mit SMC-Modul"),
        CableFor::SinamicsSmc20 => pick(language, "SINAMICS S120 with SMC20", "SINAMICS S120 mit SMC20"),
        CableFor::Simodrive => "SIMODRIVE",
        CableFor::YukonDrive => "YukonDrive",
        CableFor::OpenEnd => pick(language, "open end", "offenes Leitungsende"),
    }
}

/// Returns the missing part or datum, in a sentence.
#[must_use]
pub const fn absent_text(absent: Absent, language: Language) -> &'static str {
    let (en, de) = match absent {
        Absent::Brake => (
            "no brake with this ordering code: pins BR+ and BR- are not connected",
            "keine Bremse bei dieser Bestellbezeichnung: Stifte BR+ und BR- nicht belegt",
        ),
        Absent::MotorPins => (
            "pin assignment of the motor connector: stated for 14A and 17A only; this size is available on request, ask the manufacturer",
            "Belegung des Motorsteckers: nur für 14A und 17A angegeben; diese Baugröße ist auf Anfrage lieferbar, beim Hersteller erfragen",
        ),
        Absent::Ptc => ("PTC thermistor: not on the motor connector", "Kaltleiter (PTC): nicht auf dem Motorstecker"),
        Absent::Kty => {
            ("temperature sensor KTY: not on the encoder connector", "Temperatursensor KTY: nicht auf dem Geberstecker")
        }
        Absent::Sense => ("sense lines of the encoder supply", "Sense-Leitungen der Geberversorgung"),
        Absent::ShieldPin => (
            "a pin for the inner shield; its connection is not stated",
            "ein Stift für den inneren Schirm; die Schirmauflage ist nicht angegeben",
        ),
        Absent::Colours => {
            ("wire colours: not stated for this connector", "Aderfarben: für diesen Stecker nicht angegeben")
        }
        Absent::MatingSize => (
            "outer diameter and length of the mating coupling: not stated",
            "Außendurchmesser und Länge der Kabelkupplung: nicht angegeben",
        ),
        Absent::SinamicsCable => {
            ("SINAMICS cables for motor and motor encoder", "SINAMICS-Leitungen für Motor und Motorgeber")
        }
        Absent::OpenCable => ("a cable set with open end", "ein Leitungssatz mit offenem Leitungsende"),
        Absent::YukonCable => (
            "a YukonDrive cable set for motor and motor encoder",
            "ein YukonDrive-Leitungssatz für Motor und Motorgeber",
        ),
        Absent::SimodriveCable => {
            ("SIMODRIVE cables for motor and motor encoder", "SIMODRIVE-Leitungen für Motor und Motorgeber")
        }
        Absent::Arrangement => (
            "positions of the pins in the insert: the figures are missing in the available text of the manual; use the numbers on the insert",
            "Anordnung der Stifte im Einsatz: die Abbildungen fehlen im vorliegenden Text der Anleitung; es gelten die Nummern auf dem Einsatz",
        ),
        Absent::Gender => (
            "which connector half has pins and which has sockets: not stated",
            "welche Steckverbinderhälfte Stifte und welche Buchsen hat: nicht angegeben",
        ),
        Absent::CrossSection => ("conductor cross-sections: not stated", "Leiterquerschnitte: nicht angegeben"),
        Absent::ExitOption => (
            "changes of connectors and pins with option 2: not stated; the standard version is shown",
            "Änderungen an Steckern und Stiften durch Option 2: nicht angegeben; gezeigt ist die Standardausführung",
        ),
    };
    pick(language, en, de)
}

/// Returns the circuit in whose wires the voltage drops.
#[must_use]
pub const fn circuit_name(circuit: Circuit, language: Language) -> &'static str {
    match circuit {
        Circuit::Brake => pick(language, "brake opening current", "Öffnungsstrom der Bremse"),
        Circuit::Feedback => pick(language, "supply of the motor encoder", "Versorgung des Motorgebers"),
        Circuit::OutputEncoder => pick(language, "supply of the output encoder", "Versorgung des Abtriebsgebers"),
    }
}

/// Returns the reason for the verdict on a voltage drop; empty for a plain pass.
#[must_use]
pub const fn drop_reason(verdict: DropVerdict, language: Language) -> &'static str {
    match verdict {
        DropVerdict::Pass => "",
        DropVerdict::Fail => pick(
            language,
            "with a warm conductor, the voltage falls below the minimum",
            "bei warmem Leiter wird die Mindestspannung unterschritten",
        ),
        DropVerdict::NoCrossSection => pick(language, "no --cross-section given", "kein --cross-section angegeben"),
        DropVerdict::NoTolerance => {
            pick(language, "no tolerance of the supply is stated", "keine Toleranz der Versorgung angegeben")
        }
        DropVerdict::NoOpeningCurrent => pick(
            language,
            "the opening current is not stated; voltage drop computed with the holding current",
            "der Öffnungsstrom ist nicht angegeben; Spannungsabfall mit dem Haltestrom gerechnet",
        ),
        DropVerdict::NoNominal => pick(
            language,
            "a range is stated: the drive must supply the minimum voltage plus the voltage drop",
            "angegeben ist ein Bereich: der Servoregler muss Mindestspannung zuzüglich Spannungsabfall liefern",
        ),
    }
}

/// Returns the severity of a finding.
#[must_use]
pub const fn severity_word(severity: Severity, language: Language) -> &'static str {
    match severity {
        Severity::Danger => pick(language, "danger", "Gefahr"),
        Severity::Fault => pick(language, "fault", "Fehler"),
        Severity::Advice => pick(language, "note", "Hinweis"),
    }
}
