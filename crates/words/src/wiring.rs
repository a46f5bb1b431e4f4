//! Words about connectors, pins and cables.

mod checked;

pub use checked::{difference_action, difference_text, list_fault, list_fault_hint};

use crate::pick;
use crate::texts::{said, texts};
use catalogue::Cell;
use installation::wiring::{
    Absent, CableFor, CableRole, Circuit, DropVerdict, Form, Meaning, Polarity, Protocol, Role, Severity, Signal,
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
    at_the_end_of_a_cable = "at the end of a cable" | "am Kabelende";
    in_the_housing = "in the housing" | "im Gehäuse";
    cables = "cables" | "Kabel";
    no_cables = "the manual lists no cable for this code" | "die Anleitung nennt für diesen Code kein Kabel";
    material_number = "material number" | "Materialnummer";
    length = "length" | "Länge";
    connects = "connects" | "verbindet";
    goes_to = "for" | "für";
    length_in_number(letters) =
        "{letters} in a material number stands for the length of the cable; its letters are those of the drive's maker and are not in the manual"
        | "{letters} in einer Materialnummer steht für die Länge des Kabels; die Kennbuchstaben sind die des Reglerherstellers und stehen nicht in der Anleitung";
    not_available = "what there is not" | "was es nicht gibt";
    rules = "rules and hazards" | "Regeln und Gefahren";
    sense_lines(supply, ground) =
        "the sense lines (pins {supply} and {ground}) report the voltage at the encoder to the drive; a drive that evaluates them compensates the voltage drop of the wires, other drives do not"
        | "die Sense-Leitungen (Stifte {supply} und {ground}) melden dem Regler die Spannung am Geber; ein Regler, der sie auswertet, gleicht den Spannungsabfall der Adern aus, andere Regler nicht";
    empty_field(table, pin) = "table {table}, pin {pin}: empty field" | "Tabelle {table}, Stift {pin}: leeres Feld";
    held_brake = "brake while it is held open" | "Bremse beim Halten";
    voltage_drop(length) = "voltage lost on {length} m of cable, forth and back" | "Spannungsverlust auf {length} m Kabel, hin und zurück";
    circuit = "circuit" | "Stromkreis";
    at_20_degc = "V at 20 °C" | "V bei 20 °C";
    at_70_degc = "V at 70 °C" | "V bei 70 °C";
    nominal_v = "nominal V" | "Nenn-V";
    least_v = "at least V" | "mindestens V";
    least_mm2 = "needs mm²" | "braucht mm²";
    copper =
        "annealed copper at 20 °C, and at 70 °C (assumed: the limit of PVC insulation); the source holds its nominal voltage (assumed)"
        | "weichgeglühtes Kupfer bei 20 °C und bei 70 °C (angenommen: Grenze der PVC-Isolierung); die Quelle hält ihre Nennspannung (angenommen)";
    sense_makes_up =
        "with sense lines the drive may make up for the loss"
        | "mit Sense-Leitungen kann der Regler den Verlust ausgleichen";
    length_must_be_positive(most) =
        "a cable is longer than zero and at most {most} m long"
        | "ein Kabel ist länger als null und höchstens {most} m lang";
    section_must_be_positive(most) =
        "a cross-section is greater than zero and at most {most} mm²"
        | "ein Querschnitt ist größer als null und höchstens {most} mm²";
    check_or_draw =
        "--check compares a list and draws nothing: leave --svg and --png out"
        | "--check vergleicht eine Liste und zeichnet nicht: --svg und --png weglassen";
    no_such_connector(code, roles) =
        "{code} has no such connector; it has {roles}"
        | "{code} hat keinen solchen Stecker; es gibt {roles}";
    no_pins_to_draw = "the pins of this connector are not printed for this code" | "die Stifte dieses Steckers sind für diesen Code nicht abgedruckt";
    agrees(rows) = "{rows} rows agree with the print" | "{rows} Zeilen stimmen mit dem Druck überein";
    differs(agreeing, rows) =
        "{agreeing} of {rows} rows agree with the print"
        | "{agreeing} von {rows} Zeilen stimmen mit dem Druck überein";
    severity = "severity" | "Schwere";
    line = "line" | "Zeile";
    connector = "connector" | "Stecker";
    finding = "what is different, and what to do" | "was anders ist und was zu tun ist";
    pin_list_too_large(most) = "the list is longer than {most} bytes" | "die Liste ist länger als {most} Bytes";
    mating_face = "mating face" | "Steckgesicht";
    face_of_a_code =
        "a mating face is drawn by `antrieb wiring CODE --svg FILE`"
        | "ein Steckgesicht zeichnet `antrieb wiring CODE --svg DATEI`";
    schematic =
        "schematic: rings and order of the pins are not those of the insert, whose figure is not in the manual's text; the numbers on the insert hold"
        | "schematisch: Kreise und Reihenfolge der Stifte sind nicht die des Einsatzes, dessen Abbildung im Text der Anleitung fehlt; es gelten die Nummern auf dem Einsatz";
    face_described(poles, thread, pins) =
        "Connector with {poles} poles, {thread}. Pins: {pins}."
        | "Stecker mit {poles} Polen, {thread}. Stifte: {pins}.";
}

/// A printed cell in the language; a dash where there is none.
#[must_use]
pub fn cell_or_dash(cell: Option<&'static Cell>, language: Language) -> &'static str {
    cell.map_or("-", |cell| crate::cell_text(cell, language))
}

/// The name of a connector.
#[must_use]
pub const fn role_name(role: Role, language: Language) -> &'static str {
    match role {
        Role::Motor => pick(language, "motor connector", "Motorstecker"),
        Role::Feedback => pick(language, "connector of the motor feedback", "Stecker des Motorfeedbacks"),
        Role::OutputEncoder => {
            pick(language, "connector of the encoder at the output (EC)", "Stecker des Gebers am Abtrieb (EC)")
        }
    }
}

/// What a signal is, with its end of the pair.
#[must_use]
pub fn signal_meaning(signal: Signal, language: Language) -> String {
    let named = |en: &str, de: &str, name: char| format!("{} {name}", pick(language, en, de));
    let serial = |protocol| match protocol {
        Protocol::EnDat => "EnDat",
        Protocol::Ssi => "SSI",
    };
    let text = match signal.meaning {
        Meaning::Phase(name) => named("motor phase", "Motorphase", name),
        Meaning::ProtectiveEarth => said!(language => "protective earth" | "Schutzleiter"),
        Meaning::Brake => said!(language => "supply of the holding brake" | "Versorgung der Haltebremse"),
        Meaning::Ptc => said!(language =>
            "PTC thermistors of the winding, one of two ends without polarity"
            | "Kaltleiter (PTC) der Wicklung, eines von zwei Enden ohne Polung"
        ),
        Meaning::Kty => said!(language =>
            "temperature sensor KTY 84-130 of the winding"
            | "Temperatursensor KTY 84-130 der Wicklung"
        ),
        Meaning::Supply => said!(language => "supply of the encoder" | "Versorgung des Gebers"),
        Meaning::Ground => said!(language => "ground of the encoder supply" | "Masse der Geberversorgung"),
        Meaning::SupplySense => said!(language => "sense line of the supply" | "Sense-Leitung der Versorgung"),
        Meaning::GroundSense => said!(language => "sense line of the ground" | "Sense-Leitung der Masse"),
        Meaning::Track(name, form) => {
            let form = match form {
                Form::Sinusoidal => said!(language => "sinusoidal" | "sinusförmig"),
                Form::Sine => said!(language => "sine" | "Sinus"),
                Form::Cosine => said!(language => "cosine" | "Kosinus"),
                Form::Square => said!(language => "square wave RS422" | "Rechteck RS422"),
            };
            format!("{}, {form}", named("incremental track", "Inkrementalspur", name))
        }
        Meaning::Reference => said!(language => "reference signal" | "Referenzsignal"),
        Meaning::Zero => said!(language => "reference signal, RS422" | "Referenzsignal, RS422"),
        Meaning::CommutationTrack(name) => {
            format!(
                "{}, {}",
                named("commutation track", "Kommutierungsspur", name),
                said!(language => "sinusoidal" | "sinusförmig")
            )
        }
        Meaning::CommutationPhase(name) => {
            format!("{}, RS422", named("commutation signal", "Kommutierungssignal", name))
        }
        Meaning::Data(protocol) => said!(language => "{} data" | "{}-Daten", serial(protocol)),
        Meaning::Clock(protocol) => said!(language => "{} clock" | "{}-Takt", serial(protocol)),
        Meaning::ResolverSine => said!(language => "sine winding of the resolver" | "Sinuswicklung des Resolvers"),
        Meaning::ResolverCosine => {
            said!(language => "cosine winding of the resolver" | "Kosinuswicklung des Resolvers")
        }
        Meaning::Excitation => said!(language => "excitation of the resolver" | "Erregung des Resolvers"),
        Meaning::Shield => said!(language => "inner shield of the cable" | "innerer Schirm des Kabels"),
    };
    match signal.polarity {
        None => text,
        Some(Polarity::Plus) => format!("{text}, {}", said!(language => "plus" | "Plus")),
        Some(Polarity::Minus) => format!("{text}, {}", said!(language => "minus" | "Minus")),
    }
}

/// What stands for a pin without a signal.
#[must_use]
pub const fn unconnected(has_wire: bool, language: Language) -> &'static str {
    if has_wire {
        pick(language, "no signal; the wire is there", "kein Signal; die Ader ist vorhanden")
    } else {
        pick(language, "not connected", "nicht belegt")
    }
}

/// What a cable connects.
#[must_use]
pub const fn cable_role(role: CableRole, language: Language) -> &'static str {
    match role {
        CableRole::Motor => pick(language, "motor", "Motor"),
        CableRole::Feedback => pick(language, "motor feedback", "Motorfeedback"),
        CableRole::OutputEncoder => pick(language, "encoder at the output", "Geber am Abtrieb"),
        CableRole::Set => {
            pick(language, "set; what it holds is not printed", "Kabelsatz; der Inhalt ist nicht abgedruckt")
        }
    }
}

/// What a cable goes to.
#[must_use]
pub const fn cable_goal(goal: CableFor, language: Language) -> &'static str {
    match goal {
        CableFor::SinamicsSmc => pick(language, "SINAMICS S120 with SMC module", "SINAMICS S120 mit SMC-Modul"),
        CableFor::SinamicsSmc20 => pick(language, "SINAMICS S120 with SMC20", "SINAMICS S120 mit SMC20"),
        CableFor::Simodrive => "SIMODRIVE",
        CableFor::YukonDrive => "YukonDrive",
        CableFor::OpenEnd => pick(language, "open end", "offenes Kabelende"),
    }
}

/// What there is not, in a sentence.
#[must_use]
pub const fn absent_text(absent: Absent, language: Language) -> &'static str {
    let (en, de) = match absent {
        Absent::Brake => (
            "no brake in this code: the pins BR+ and BR- stay free",
            "keine Bremse in diesem Code: die Stifte BR+ und BR- bleiben frei",
        ),
        Absent::MotorPins => (
            "pin-out of the motor connector: printed for 14A and 17A only; this size is on request, ask the maker",
            "Belegung des Motorsteckers: nur für 14A und 17A abgedruckt; diese Baugröße gibt es auf Anfrage, beim Hersteller erfragen",
        ),
        Absent::Ptc => ("PTC thermistor: not on the motor connector", "Kaltleiter (PTC): nicht auf dem Motorstecker"),
        Absent::Kty => (
            "temperature sensor KTY: not on the encoder connector",
            "Temperatursensor KTY: nicht auf dem Encoderstecker",
        ),
        Absent::Sense => ("sense lines of the encoder supply", "Sense-Leitungen der Geberversorgung"),
        Absent::ShieldPin => (
            "a pin for the inner shield; where the shield goes is not stated",
            "ein Stift für den inneren Schirm; wohin der Schirm gehört, ist nicht angegeben",
        ),
        Absent::Colours => {
            ("wire colours: none printed for this connector", "Aderfarben: für diesen Stecker keine abgedruckt")
        }
        Absent::MatingSize => (
            "outer diameter and length of the mating coupling: not printed",
            "Außendurchmesser und Länge der Kabelkupplung: nicht abgedruckt",
        ),
        Absent::SinamicsCable => {
            ("cables for SINAMICS to motor and motor feedback", "Kabel für SINAMICS zu Motor und Motorfeedback")
        }
        Absent::OpenCable => ("a cable set with open end", "ein Kabelsatz mit offenem Kabelende"),
        Absent::YukonCable => (
            "a cable set for YukonDrive to motor and motor feedback",
            "ein Kabelsatz für YukonDrive zu Motor und Motorfeedback",
        ),
        Absent::SimodriveCable => {
            ("cables for SIMODRIVE to motor and motor feedback", "Kabel für SIMODRIVE zu Motor und Motorfeedback")
        }
        Absent::Arrangement => (
            "places of the pins on the insert: the figures are not in the text that the manual was recovered from; go by the numbers on the insert",
            "Lage der Stifte im Einsatz: die Abbildungen fehlen im Text, aus dem die Anleitung wiederhergestellt ist; es gelten die Nummern auf dem Einsatz",
        ),
        Absent::Gender => (
            "which half has pins and which sockets: not stated",
            "welche Hälfte Stifte und welche Buchsen hat: nicht angegeben",
        ),
        Absent::CrossSection => ("cross-sections of the wires: not stated", "Querschnitte der Adern: nicht angegeben"),
        Absent::ExitOption => (
            "what option 2 changes on connectors and pins: not stated; shown is the standard",
            "was Option 2 an Steckern und Stiften ändert: nicht angegeben; gezeigt ist der Standard",
        ),
    };
    pick(language, en, de)
}

/// The circuit whose wires lose voltage.
#[must_use]
pub const fn circuit_name(circuit: Circuit, language: Language) -> &'static str {
    match circuit {
        Circuit::Brake => pick(language, "brake while it opens", "Bremse beim Öffnen"),
        Circuit::Feedback => pick(language, "supply of the motor feedback", "Versorgung des Motorfeedbacks"),
        Circuit::OutputEncoder => {
            pick(language, "supply of the encoder at the output", "Versorgung des Gebers am Abtrieb")
        }
    }
}

/// Why a loss is judged as it is; empty where it is simply enough or not.
#[must_use]
pub const fn drop_reason(verdict: DropVerdict, language: Language) -> &'static str {
    match verdict {
        DropVerdict::Pass => "",
        DropVerdict::Fail => pick(
            language,
            "less than the least voltage arrives on a warm wire",
            "bei warmer Ader kommt weniger als die Mindestspannung an",
        ),
        DropVerdict::NoCrossSection => pick(language, "no --cross-section given", "kein --cross-section angegeben"),
        DropVerdict::NoTolerance => {
            pick(language, "no tolerance of the supply is stated", "keine Toleranz der Versorgung angegeben")
        }
        DropVerdict::NoOpeningCurrent => pick(
            language,
            "the opening current is not stated; the loss is that of the holding current",
            "der Öffnungsstrom ist nicht angegeben; der Verlust ist der des Haltestroms",
        ),
        DropVerdict::NoNominal => pick(
            language,
            "a range is stated: the drive has to supply the least voltage and the loss together",
            "angegeben ist ein Bereich: der Regler muss Mindestspannung und Verlust zusammen liefern",
        ),
    }
}

/// How grave a finding is.
#[must_use]
pub const fn severity_word(severity: Severity, language: Language) -> &'static str {
    match severity {
        Severity::Danger => pick(language, "danger", "Gefahr"),
        Severity::Fault => pick(language, "fault", "Fehler"),
        Severity::Advice => pick(language, "advice", "Hinweis"),
    }
}
