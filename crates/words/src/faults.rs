//! Words about the faults of what the user wrote.

use super::quantity::hint_of_several;
use super::{bodies, either, motion, quantity_fault, recording};
use crate::geometry::geometry;
use actuator::{BatteryFault, CurveFault};
use mechanism::{BodyError, TableFault};
use project::{Column, Diagnostic, Expected, Fault, FileTrouble, Hint, Range, Unopened};
use quantities::unit::DEGREE;
use quantities::{Language, Unit, format_number, format_significant};
use std::ops::Range as Span;

/// A fault in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Worded {
    /// Its identifier in data exchange.
    pub id: &'static str,
    /// Offending part of the text, in bytes.
    pub span: Span<usize>,
    /// Line, from one.
    pub line: usize,
    /// Column in characters, from one.
    pub column: usize,
    /// What is wrong, one sentence.
    pub message: String,
    /// What was expected, or the nearest valid choice.
    pub hint: Option<String>,
}

impl Worded {
    /// A fault with its words at a place of a text.
    #[must_use]
    pub fn at(text: &str, span: Span<usize>, id: &'static str, message: String, hint: Option<String>) -> Self {
        let (line, column) = project::place(text, span.start);
        Self { id, span, line, column, message, hint }
    }
}

/// Every fault in words, in their order.
#[must_use]
pub fn worded(faults: &[Diagnostic], language: Language) -> Vec<Worded> {
    faults.iter().map(|fault| fault_worded(fault, language)).collect()
}

fn fault_worded(found: &Diagnostic, language: Language) -> Worded {
    let hint = found.hint.as_ref().map(|hint| hint_text(hint, language));
    Worded {
        id: found.fault.id(),
        span: found.span.clone(),
        line: found.line,
        column: found.column,
        message: fault_text(&found.fault, language),
        hint: hint.or_else(|| own_hint(&found.fault, language)),
    }
}

/// What is wrong, in one sentence.
#[must_use]
pub fn fault_text(fault: &Fault, language: Language) -> String {
    let e = |en: String, de: String| either(language, en, de);
    let t = |en: &str, de: &str| either(language, en, de);
    match fault {
        Fault::FileTooLarge { bytes, most } => e(
            format!("the project file has {bytes} bytes; {most} are read at most"),
            format!("die Projektdatei hat {bytes} Byte; gelesen werden höchstens {most}"),
        ),
        Fault::Syntax { message } => e(format!("not valid TOML: {message}"), format!("kein gültiges TOML: {message}")),
        Fault::MissingKey { path, list } => {
            let name = if *list { format!("[[{path}]]") } else { path.clone() };
            e(format!("`{name}` is missing"), format!("`{name}` fehlt"))
        }
        Fault::UnknownKey { path } => e(format!("unknown key `{path}`"), format!("unbekannter Schlüssel `{path}`")),
        Fault::KeyOfAnotherKind { path, by, kind } => e(
            format!("`{path}` has no meaning with {by} = \"{kind}\""),
            format!("`{path}` hat bei {by} = \"{kind}\" keine Bedeutung"),
        ),
        Fault::OutsideTheAxes { key } => e(
            format!("with several axes `{key}` belongs inside [[axis]]"),
            format!("bei mehreren Achsen gehört `{key}` in [[axis]]"),
        ),
        Fault::OneAxisOnly => t(
            "a single axis is required, the file has several",
            "gefordert ist eine einzelne Achse, die Datei enthält mehrere",
        ),
        Fault::More { count } => more(*count, language),
        Fault::Code(error) => super::describe_code_error(error, language),
        Fault::NoSuchCode { written } => e(
            format!("no actuator of the catalogue has a code like `{written}`"),
            format!("kein Antrieb des Katalogs hat einen Code wie `{written}`"),
        ),
        Fault::Curve(fault) => curve(*fault, language),
        Fault::Table(fault) => table(*fault, language),
        Fault::Points(fault) => motion::points_fault(*fault, language),
        Fault::Battery(fault) => battery_fault(fault, language),
        Fault::File { name, trouble } => format!("{name}: {}", trouble_text(trouble, language)),
        Fault::FileOutOfReach { name } => e(
            format!("{name}: only files in the folder of the project and below it are read here"),
            format!("{name}: hier werden nur Dateien im Ordner des Projekts und darunter gelesen"),
        ),
        Fault::Recording { name, fault } => format!("{name}: {}", recording::fault(fault, language).0),
        Fault::Recorded { name, fault } => format!("{name}: {}", motion::recorded_fault(fault, language).0),
        Fault::Move { fault, travel_m_per_rad } => motion::fault(fault, *travel_m_per_rad, language).0,
        Fault::Instants(found) => {
            let [found, most] = [found.instants, found.most].map(|count| format!("{count:.0}"));
            e(
                format!("the cycle must be looked at at {found} instants; at most {most} are calculated"),
                format!("der Zyklus muss an {found} Stellen betrachtet werden; höchstens {most} werden gerechnet"),
            )
        }
        Fault::InBody { path, fault } => format!("`{path}`: {}", fault_text(fault, language)),
        Fault::Body(error) => bodies::fault(error, language),
        Fault::ImpossibleWithin { values, why } => impossible(values, why.as_deref(), language),
        Fault::BareNumber { path, dimension } => {
            let name = dimension.name(language);
            e(
                format!("`{path}`: a number without a unit; expected: {name}"),
                format!("`{path}`: Zahl ohne Einheit; erwartet: {name}"),
            )
        }
        Fault::Quantity { path, error, .. } => format!("`{path}`: {}", quantity_fault(error, language)),
        #[allow(clippy::float_cmp, reason = "bounds that are written equal")]
        Fault::NumberOutOfRange { path, low, high } if low == high => {
            e(format!("`{path}` must be {low}"), format!("`{path}` muss {low} sein"))
        }
        Fault::NumberOutOfRange { path, low, high } => e(
            format!("`{path}` must be a number from {low} to {high}"),
            format!("`{path}` muss eine Zahl von {low} bis {high} sein"),
        ),
        Fault::QuantityOutOfRange { path, written, positive } => {
            let (en, de) = if *positive {
                ("must be greater than zero", "muss größer als null sein")
            } else {
                ("must not be negative", "darf nicht negativ sein")
            };
            e(format!("`{path}` {en}, not \"{written}\""), format!("`{path}` {de}, nicht „{written}“"))
        }
        Fault::BelowAbsoluteZero { path, written } => e(
            format!("`{path}`: \"{written}\" is below absolute zero"),
            format!("`{path}`: „{written}“ liegt unter dem absoluten Nullpunkt"),
        ),
        Fault::Implausible { path, written, low, high } => e(
            format!(
                "`{path}`: no machine has \"{written}\"; read are magnitudes from {low:e} to {high:e} in SI, and zero"
            ),
            format!(
                "`{path}`: „{written}“ hat keine Maschine; gelesen werden Beträge von {low:e} bis {high:e} in SI, und null"
            ),
        ),
        Fault::TextTooLong { path, most } => {
            e(format!("`{path}` is longer than {most} characters"), format!("`{path}` ist länger als {most} Zeichen"))
        }
        Fault::ControlCharacter { path } => e(
            format!("`{path}` contains a control character, or one that turns the direction of the text"),
            format!("`{path}` enthält ein Steuerzeichen oder eines, das die Schreibrichtung wendet"),
        ),
        Fault::WrongType { path, expected, found } => {
            let (expected, german) = (expected_text(*expected, language), type_in_german(found));
            e(
                format!("`{path}` must be {expected}, found {found}"),
                format!("`{path}`: erwartet {expected}, gefunden {german}"),
            )
        }
        Fault::NotAChoice { path, written } => e(
            format!("`{path}`: \"{written}\" is not a valid choice"),
            format!("`{path}`: „{written}“ steht hier nicht zur Wahl"),
        ),
        Fault::TooManyEntries { path, most } => {
            e(format!("`{path}` has more than {most} entries"), format!("`{path}` hat mehr als {most} Einträge"))
        }
        Fault::NotARow { path, columns } => {
            let or = either(language, " or ", " oder ");
            let of = |column: &Column| column.iter().map(|each| each.name(language)).collect::<Vec<_>>().join(&or);
            let row: Vec<String> = columns.iter().map(|column| format!("\"{}\"", of(column))).collect();
            let row = row.join(", ");
            e(
                format!("`{path}`: a point is written [{row}]"),
                format!("`{path}`: ein Punkt wird als [{row}] geschrieben"),
            )
        }
        Fault::RatioCount { most } => e(
            format!("`stage.ratios` must be a list of 1 to {most} numbers"),
            format!("`stage.ratios` muss eine Liste aus 1 bis {most} Zahlen sein"),
        ),
        Fault::ToleranceEnd { path, end, unit, range } => {
            let end = shown(*end, unit, language);
            let (en, de) = match range {
                Range::Positive => ("it must be greater than zero", "muss größer als null sein"),
                Range::NotNegative => ("it must not be negative", "darf nicht negativ sein"),
                Range::Any => ("that is below absolute zero", "liegt unter dem absoluten Nullpunkt"),
            };
            e(
                format!("`{path}`: with this tolerance the value reaches {end}; {en}"),
                format!("`{path}`: mit dieser Toleranz erreicht der Wert {end}; er {de}"),
            )
        }
        Fault::TooManyTolerances { most } => e(
            format!("more than {most} quantities with a tolerance"),
            format!("mehr als {most} Größen mit einer Toleranz"),
        ),
        Fault::UnknownUnit { written } => {
            e(format!("unknown unit \"{written}\""), format!("unbekannte Einheit „{written}“"))
        }
        Fault::NoTolerance => either(
            language,
            "no tolerance here: the window of a recording is read once",
            "hier keine Toleranz: das Fenster einer Aufzeichnung wird einmal gelesen",
        ),
        Fault::RatioAndRatios => t(
            "`stage.ratio` is one ratio, `stage.ratios` several to choose from: one of them",
            "`stage.ratio` ist eine Übersetzung, `stage.ratios` mehrere zur Auswahl: eines von beiden",
        ),
        Fault::NoRatioInACoupling { key } => e(
            format!("`stage.{key}`: a coupling has the ratio 1 and no wheels"),
            format!("`stage.{key}`: eine Kupplung hat die Übersetzung 1 und keine Räder"),
        ),
        Fault::UnlikeFirstPoint => t(
            "a point states the same quantities as the first one: times or angles of the master, angles or lengths",
            "ein Punkt nennt dieselben Größen wie der erste: Zeiten oder Winkel des Leitantriebs, Winkel oder Längen",
        ),
        Fault::SupplyAndMains => t(
            "`supply` and `mains` are both stated: the DC link follows from one of them",
            "`supply` und `mains` sind beide angegeben: der Zwischenkreis folgt aus einem von beiden",
        ),
        Fault::MasterOfTimes => t(
            "`master_speed` has no effect: the points are stated over the time",
            "`master_speed` hat keine Wirkung: die Punkte sind über der Zeit angegeben",
        ),
        Fault::WithoutEffect { key } => {
            e(format!("`{key}` has no effect on this load"), format!("`{key}` hat auf diese Last keine Wirkung"))
        }
        Fault::NoMechanism => t(
            "`[load]` is missing, or one table of `[mechanism.…]`",
            "`[load]` fehlt, oder eine Tabelle aus `[mechanism.…]`",
        ),
        Fault::TooManyMechanisms => t(
            "an axis has one load: `[load]` or one table of `[mechanism.…]`",
            "eine Achse hat eine Last: `[load]` oder eine Tabelle aus `[mechanism.…]`",
        ),
        Fault::Tabular(fault) => crate::sweeps::fault(fault, language),
        Fault::NoLine { path } => e(
            format!("`{path}` is written along a line, but this load has no fixed travel per revolution"),
            format!("`{path}` ist längs einer Linie angegeben, diese Last hat aber keinen festen Weg je Umdrehung"),
        ),
        Fault::RodTooShort => t(
            "`mechanism.slider_crank.rod` must be longer than the crank",
            "`mechanism.slider_crank.rod` muss länger als der Kurbelradius sein",
        ),
        Fault::Geometry(fault) => geometry(*fault, language).to_owned(),
        Fault::BeyondRange { position_rad, range_rad: (low, high) } => {
            let shown = |angle: f64| format!("{}°", format_significant(DEGREE.from_si(angle), 5, language));
            let (reached, farthest) = (shown(*position_rad), shown(if position_rad > high { *high } else { *low }));
            e(
                format!("the motion reaches {reached} at the mechanism; its geometry ends at {farthest}"),
                format!("die Bewegung erreicht {reached} am Mechanismus; seine Geometrie endet bei {farthest}"),
            )
        }
        Fault::NoFlangeLoads => t(
            "no loads on the flange follow from this load: its masses and their places are not described",
            "aus dieser Last folgen keine Flanschlasten: ihre Massen und deren Lage sind nicht beschrieben",
        ),
        Fault::ReplacesEverything { key } => e(
            format!(
                "`bearing.{key}` would replace the loads of the mechanism in every segment; write mechanism = \"ignore\" or \"add\""
            ),
            format!(
                "`bearing.{key}` würde die Lasten des Mechanismus in jedem Abschnitt ersetzen; mechanism = \"ignore\" oder \"add\" schreiben"
            ),
        ),
        Fault::BeltOrTeeth => t(
            "`belt_tension` is of a belt, `pressure_angle` of teeth: one of them",
            "`belt_tension` gehört zu einem Riemen, `pressure_angle` zu einer Verzahnung: eines von beiden",
        ),
        Fault::ToothAngle { key, most_deg } => {
            let most = format_number(*most_deg, 0, language);
            e(
                format!("`bearing.{key}` must be at most {most}°"),
                format!("`bearing.{key}` darf höchstens {most}° sein"),
            )
        }
        Fault::BodiesTwice => t(
            "the bodies of a turntable are given as texts, `bodies`, or as tables, `body`: one of them",
            "die Körper eines Drehtisches stehen als Texte in `bodies` oder als Tabellen in `body`: eines von beiden",
        ),
        Fault::JointWithoutTorque => t(
            "the torque of a joint comes with its motion: every [[motion]] must be recorded, with a column of torque",
            "das Moment eines Gelenks kommt mit seiner Bewegung: jedes [[motion]] muss aufgezeichnet sein und eine Momentenspalte haben",
        ),
        Fault::BodyMissing => t("a body is missing", "ein Körper fehlt"),
        Fault::ShapeMissing => {
            t("the shape of the body is missing; it stands first", "die Form des Körpers fehlt; sie steht zuerst")
        }
        Fault::NoShape { written } => e(format!("`{written}` is not a shape"), format!("`{written}` ist keine Form")),
        Fault::NoKey { written } => e(
            format!("`{written}` has no key; expected: key=value"),
            format!("`{written}` hat keinen Schlüssel; erwartet: Schlüssel=Wert"),
        ),
        Fault::KeyOfAnotherShape { key, shape } => {
            e(format!("`{key}` is not a key of `{shape}`"), format!("`{key}` ist kein Schlüssel von `{shape}`"))
        }
        Fault::Twice { key } => e(format!("`{key}` is given twice"), format!("`{key}` steht zweimal da")),
        Fault::Count { written } => e(
            format!("`count` must be a whole number from 1 to {}, not \"{written}\"", u32::MAX),
            format!("`count` muss eine ganze Zahl von 1 bis {} sein, nicht „{written}“", u32::MAX),
        ),
        Fault::BodyAxis { written } => {
            e(format!("`axis` cannot be \"{written}\""), format!("`axis` kann nicht „{written}“ sein"))
        }
    }
}

/// What a fault itself says about what would be right.
#[must_use]
pub fn own_hint(fault: &Fault, language: Language) -> Option<String> {
    let example = |line: &str| Some(hint_text(&Hint::Example(line.to_owned()), language));
    match fault {
        Fault::Quantity { error, also, .. } => hint_of_several(error, also, language),
        Fault::Code(error) => match error.nearest() {
            Some(near) => Some(hint_text(&Hint::DidYouMean(near.to_owned()), language)),
            None if error.expected().is_empty() => None,
            None => {
                let valid = error.expected().iter().map(|word| (*word).to_owned()).collect();
                Some(hint_text(&Hint::ValidAre(valid), language))
            }
        },
        Fault::Move { fault, travel_m_per_rad } => motion::fault(fault, *travel_m_per_rad, language).1,
        Fault::Recording { fault, .. } => recording::fault(fault, language).1,
        Fault::Recorded { fault, .. } => motion::recorded_fault(fault, language).1,
        Fault::Instants(_) => Some(either(
            language,
            "describe a shorter cycle; where the load depends on the position, each revolution at changing speed takes 192 instants and all those at constant speed together no more than two",
            "einen kürzeren Zyklus beschreiben; wo die Last von der Lage abhängt, kostet jede Umdrehung mit veränderlicher Drehzahl 192 Stellen, und alle mit konstanter zusammen nicht mehr als zwei",
        )),
        Fault::Body(BodyError::NoMass) => example("mass=0.6kg"),
        Fault::Body(BodyError::DistanceOutOfRange { .. }) => example("distance=80mm angle=180deg"),
        Fault::InBody { fault, .. } => own_hint(fault, language),
        Fault::ImpossibleWithin { why: Some(why), .. } => own_hint(why, language),
        _ => None,
    }
}

/// What would be right.
#[must_use]
pub fn hint_text(hint: &Hint, language: Language) -> String {
    let e = |en: String, de: String| either(language, en, de);
    match hint {
        Hint::Example(line) => e(format!("for example: {line}"), format!("zum Beispiel: {line}")),
        Hint::DidYouMean(name) => e(format!("did you mean `{name}`?"), format!("gemeint ist vielleicht `{name}`")),
        Hint::ValidAre(names) => {
            let names = names.join(", ");
            e(format!("valid here: {names}"), format!("hier gültig: {names}"))
        }
        Hint::WithUnit { written, dimension } => {
            let units: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
            let (unit, units) = (units.first().copied().unwrap_or_default(), units.join(", "));
            e(
                format!("write \"{written} {unit}\" if that is the unit meant; units: {units}"),
                format!("\"{written} {unit}\" schreiben, falls diese Einheit gemeint ist; Einheiten: {units}"),
            )
        }
        Hint::MechanismsWithLoads => either(
            language,
            "loads follow from every mechanism but table and joint",
            "Lasten folgen aus jedem Mechanismus außer table und joint",
        ),
        Hint::CloseTheRecording => either(
            language,
            "choose the window with from and to, state standstill, or write single_move = true under [axis]",
            "das Fenster mit from und to wählen, standstill angeben oder unter [axis] single_move = true schreiben",
        ),
    }
}

/// Further faults, counted only.
fn more(count: usize, language: Language) -> String {
    match count {
        1 => either(language, "and 1 more fault", "und 1 weiterer Fehler"),
        _ => either(language, format!("and {count} more faults"), format!("und {count} weitere Fehler")),
    }
}

fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format!("{} {}", format_significant(unit.from_si(si), 5, language), unit.symbol)
}

/// Values within the tolerances at which there is no such axis, and why.
fn impossible(values: &[(String, f64, &Unit)], why: Option<&Fault>, language: Language) -> String {
    // More quantities than this are not named.
    const NAMED_MOST: usize = 4;
    let mut named: Vec<String> = values
        .iter()
        .take(NAMED_MOST)
        .map(|(path, value, unit)| format!("{path} = {}", shown(*value, unit, language)))
        .collect();
    if values.len() > NAMED_MOST {
        named.push("…".to_owned());
    }
    let named = named.join(", ");
    let why = why.map(|fault| format!(": {}", fault_text(fault, language))).unwrap_or_default();
    if values.len() == 1 {
        return either(
            language,
            format!("with this tolerance the axis is not possible, at {named}{why}"),
            format!("mit dieser Toleranz ist die Achse nicht möglich, bei {named}{why}"),
        );
    }
    either(
        language,
        format!("with these tolerances together the axis is not possible, at {named}{why}"),
        format!("mit diesen Toleranzen zusammen ist die Achse nicht möglich, bei {named}{why}"),
    )
}

/// The name of a type of TOML.
fn type_in_german(name: &str) -> &str {
    match name {
        "string" => "Text",
        "integer" => "ganze Zahl",
        "float" => "Zahl",
        "boolean" => "Wahrheitswert",
        "datetime" => "Datum",
        "array" => "Liste",
        "table" => "Tabelle",
        other => other,
    }
}

fn expected_text(expected: Expected, language: Language) -> String {
    let e = |en: String, de: String| either(language, en, de);
    let t = |en: &str, de: &str| either(language, en, de);
    match expected {
        Expected::Quantity(dimension) => {
            let (name, example) = (dimension.name(language), dimension.example());
            e(
                format!("a quantity with its unit ({name}, for example \"{example}\")"),
                format!("Zahl mit Einheit ({name}, zum Beispiel \"{example}\")"),
            )
        }
        Expected::Along(turning, line) => {
            let (turning, line, example) = (turning.name(language), line.name(language), turning.example());
            e(
                format!("a quantity with its unit ({turning} or {line}, for example \"{example}\")"),
                format!("Zahl mit Einheit ({turning} oder {line}, zum Beispiel \"{example}\")"),
            )
        }
        Expected::Number => t("a number", "Zahl"),
        Expected::Numbers => t("a list of numbers", "Liste von Zahlen"),
        Expected::Integer => t("a whole number", "ganze Zahl"),
        Expected::Bool => t("true or false", "true oder false"),
        Expected::Text => t("a text in quotes", "Text in Anführungszeichen"),
        Expected::OneOf(words) => e(format!("one of {}", words.join(", ")), format!("eines von {}", words.join(", "))),
        Expected::ListOf(words) => {
            e(format!("a list of {}", words.join(", ")), format!("Liste aus {}", words.join(", ")))
        }
        Expected::Rows => t("a list of points", "Liste von Punkten"),
        Expected::Table => t("a table", "Tabelle"),
        Expected::Bodies => t("a list of bodies", "Liste von Körpern"),
        Expected::Tables => t("an array of tables, [[…]]", "Liste von Tabellen, [[…]]"),
    }
}

fn curve(fault: CurveFault, language: Language) -> String {
    let (en, de) = match fault {
        CurveFault::TooFewPoints => {
            ("a curve needs at least two points", "eine Kennlinie braucht mindestens zwei Punkte")
        }
        CurveFault::DoesNotStartAtZero => {
            ("a curve starts at standstill, 0 1/min", "eine Kennlinie beginnt im Stillstand, 0 1/min")
        }
        CurveFault::SpeedsNotAscending => (
            "the speeds of a curve must grow from point to point",
            "die Drehzahlen einer Kennlinie müssen von Punkt zu Punkt wachsen",
        ),
        CurveFault::TorqueOutOfRange => {
            ("the torques of a curve must not be negative", "die Drehmomente einer Kennlinie dürfen nicht negativ sein")
        }
    };
    either(language, en, de)
}

fn table(fault: TableFault, language: Language) -> String {
    let (en, de) = match fault {
        TableFault::TooFewPoints => {
            ("a table needs at least two points", "eine Tabelle braucht mindestens zwei Punkte")
        }
        TableFault::PositionsNotAscending => (
            "the positions of a table must grow from point to point",
            "die Stellungen einer Tabelle müssen von Punkt zu Punkt wachsen",
        ),
        TableFault::NegativeInertia => {
            ("a moment of inertia must not be negative", "ein Massenträgheitsmoment darf nicht negativ sein")
        }
    };
    either(language, en, de)
}

/// What is wrong with the times for the battery.
#[must_use]
pub fn battery_fault(fault: &BatteryFault, language: Language) -> String {
    let (en, de) = match fault {
        BatteryFault::OperationOutOfRange { .. } => {
            ("a day has 0 h to 24 h of operation", "ein Tag hat 0 h bis 24 h Betrieb")
        }
        BatteryFault::StorageOutOfRange { .. } => {
            ("the battery model covers 0 a to 3 a of storage", "das Batteriemodell gilt für 0 a bis 3 a Lagerung")
        }
    };
    either(language, en, de)
}

/// What the system says about a file that cannot be read.
#[must_use]
pub fn file_trouble(error: &std::io::Error, language: Language) -> String {
    trouble_text(&error.into(), language)
}

pub(crate) fn trouble_text(trouble: &FileTrouble, language: Language) -> String {
    use std::io::ErrorKind;
    let (en, de) = match (trouble.unopened, trouble.kind, trouble.code) {
        (Some(Unopened::NoRegularFile), ..) => (
            "this is a pipe, a device or a socket, not a regular file",
            "das ist eine Pipe, ein Gerät oder ein Socket, keine gewöhnliche Datei",
        ),
        (Some(Unopened::NoRecordingName), ..) => (
            "only recordings are opened here: names that end with .csv, .txt or .parquet (or .csv.gz, .txt.zst), none of whose parts begins with a dot",
            "hier werden nur Aufzeichnungen geöffnet: Namen, die auf .csv, .txt oder .parquet (oder .csv.gz, .txt.zst) enden und von denen kein Teil mit einem Punkt beginnt",
        ),
        (_, ErrorKind::NotFound, _) => ("there is no such file", "diese Datei gibt es nicht"),
        (_, ErrorKind::PermissionDenied, _) => ("permission denied", "kein Zugriff"),
        (_, ErrorKind::IsADirectory, _) => ("this is a folder, not a file", "das ist ein Ordner, keine Datei"),
        (_, ErrorKind::NotADirectory, _) => {
            ("a part of the path is a file, not a folder", "ein Teil des Pfads ist eine Datei, kein Ordner")
        }
        (_, ErrorKind::FileTooLarge, _) => ("the file is too large", "die Datei ist zu groß"),
        (_, ErrorKind::Unsupported, _) => {
            ("files cannot be read from here", "von hier aus können keine Dateien gelesen werden")
        }
        (_, ErrorKind::StorageFull, _) => ("no space is left on the device", "auf dem Datenträger ist kein Platz mehr"),
        (_, ErrorKind::QuotaExceeded, _) => {
            ("the quota of the disk is used up", "das Kontingent des Datenträgers ist erschöpft")
        }
        (_, ErrorKind::ReadOnlyFilesystem, _) => {
            ("the file system is read-only", "das Dateisystem ist schreibgeschützt")
        }
        (_, ErrorKind::InvalidFilename, _) => ("no file can have such a name", "so kann keine Datei heißen"),
        (_, ErrorKind::AlreadyExists, _) => ("the file exists already", "die Datei gibt es schon"),
        (_, ErrorKind::BrokenPipe, _) => {
            ("the reader of the output has closed it", "der Leser der Ausgabe hat sie geschlossen")
        }
        (_, ErrorKind::TimedOut, _) => ("the time is over", "die Zeit ist abgelaufen"),
        (_, ErrorKind::Interrupted, _) => ("it was interrupted", "es wurde unterbrochen"),
        (_, ErrorKind::UnexpectedEof, _) => ("the file ends too early", "die Datei endet zu früh"),
        (_, ErrorKind::InvalidData, _) => ("the data are damaged", "die Daten sind beschädigt"),
        (_, ErrorKind::InvalidInput, _) => ("the system refuses this input", "das System weist diese Eingabe zurück"),
        (_, ErrorKind::WouldBlock, _) => ("the source has no data at present", "die Quelle hat zurzeit keine Daten"),
        (_, ErrorKind::OutOfMemory, _) => ("there is not enough memory", "der Speicher reicht nicht"),
        (_, ErrorKind::ResourceBusy | ErrorKind::ExecutableFileBusy, _) => {
            ("another program uses it", "ein anderes Programm benutzt sie")
        }
        (_, ErrorKind::AddrInUse, _) => ("the address is in use", "die Adresse ist belegt"),
        (_, ErrorKind::AddrNotAvailable, _) => {
            ("this machine does not have the address", "diese Maschine hat die Adresse nicht")
        }
        // Numbers of POSIX systems, for which the library has no kind.
        (_, _, Some(5)) if cfg!(unix) => ("the device reports an error", "das Gerät meldet einen Fehler"),
        (_, _, Some(9)) if cfg!(unix) => ("it is closed", "sie ist geschlossen"),
        (_, _, Some(23 | 24)) if cfg!(unix) => ("too many files are open", "zu viele Dateien sind offen"),
        (_, _, Some(40 | 62)) if cfg!(unix) => ("links lead in a circle", "Verknüpfungen führen im Kreis"),
        (_, _, Some(code)) => {
            return either(
                language,
                trouble.system.clone(),
                format!("Fehler {code} des Betriebssystems („{}“)", trouble.system),
            );
        }
        (_, _, None) => return either(language, trouble.system.clone(), format!("„{}“", trouble.system)),
    };
    either(language, en, de)
}
