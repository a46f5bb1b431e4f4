//! Words for faults in the input of the user.

use super::quantity::hint_of_several;
use super::quantity_fault;
use crate::file_trouble::trouble_text;
use crate::texts::said;
use crate::toml_syntax;
use project::{ColumnDimensions, Diagnostic, Expected, Fault, Hint, Range};
use quantities::unit::DEGREE;
use quantities::{Language, Unit, format_number, format_significant, with_symbol};
use std::ops::Range as Span;

/// A fault as text, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Worded {
    /// Identifier of the fault in data exchange.
    pub id: &'static str,
    /// Offending part of the text, in bytes.
    pub span: Span<usize>,
    /// Line, from one.
    pub line: usize,
    /// Column in characters, from one.
    pub column: usize,
    /// The fault in one sentence.
    pub message: String,
    /// Expected input, or the nearest valid choice.
    pub hint: Option<String>,
}

impl Worded {
    /// Creates a fault from its texts and its place in a text.
    #[must_use]
    pub fn at(text: &str, span: Span<usize>, id: &'static str, message: String, hint: Option<String>) -> Self {
        let (line, column) = project::place(text, span.start);
        Self { id, span, line, column, message, hint }
    }
}

/// A fault with words.
pub trait FaultWords {
    /// Returns its identifier in data exchange.
    fn id(&self) -> &'static str;
    /// Returns it in one sentence.
    fn text(&self, language: Language) -> String;
    /// Returns the hint that follows from it alone.
    fn own_hint(&self, language: Language) -> Option<String>;
}

impl FaultWords for Fault {
    fn id(&self) -> &'static str {
        self.id()
    }

    fn text(&self, language: Language) -> String {
        file_fault_text(self, language)
    }

    fn own_hint(&self, language: Language) -> Option<String> {
        file_own_hint(self, language)
    }
}

/// Returns the fault in one sentence.
#[must_use]
pub fn fault_text(fault: &impl FaultWords, language: Language) -> String {
    fault.text(language)
}

/// Returns the hint that follows from the fault alone.
#[must_use]
pub fn own_hint(fault: &impl FaultWords, language: Language) -> Option<String> {
    fault.own_hint(language)
}

/// Returns every fault as text, in the same order.
#[must_use]
pub fn worded<F: FaultWords>(faults: &[Diagnostic<F>], language: Language) -> Vec<Worded> {
    faults.iter().map(|fault| fault_worded(fault, language)).collect()
}

fn fault_worded<F: FaultWords>(found: &Diagnostic<F>, language: Language) -> Worded {
    let hint = found.hint.as_ref().map(|hint| hint_text(hint, language));
    Worded {
        id: found.fault.id(),
        span: found.span.clone(),
        line: found.line,
        column: found.column,
        message: found.fault.text(language),
        hint: hint.or_else(|| found.fault.own_hint(language)),
    }
}

/// Returns the fault of a file in one sentence.
pub(crate) fn file_fault_text(fault: &Fault, language: Language) -> String {
    match fault {
        // Of a larger file one byte beyond the limit is read, so that its size is not known.
        Fault::FileTooLarge { bytes, most } if *bytes == most + 1 => said!(language =>
            "the file has more than {most} bytes, the limit"
            | "die Datei hat mehr als {most} Byte, die Grenze"
        ),
        Fault::FileTooLarge { bytes, most } => said!(language =>
            "the file has {bytes} bytes; the limit is {most}"
            | "die Datei hat {bytes} Byte; zulässig sind höchstens {most}"
        ),
        Fault::NotUtf8 { byte: Some(byte) } => said!(language =>
            "byte {byte:02X} is not UTF-8: save the file as UTF-8"
            | "Byte {byte:02X} ist kein UTF-8: Datei als UTF-8 speichern"
        ),
        Fault::NotUtf8 { byte: None } => said!(language =>
            "the file is UTF-16: save it as UTF-8" | "die Datei liegt in UTF-16 vor: als UTF-8 speichern"
        ),
        Fault::Syntax { message, hides } => {
            let message = if language == Language::De { toml_syntax::in_german(message) } else { message.clone() };
            if *hides {
                said!(language =>
                    "not valid TOML: {message}; until it is corrected, other faults of the file may be hidden"
                    | "kein gültiges TOML: {message}; bis zur Korrektur können weitere Fehler der Datei verdeckt sein"
                )
            } else {
                said!(language => "not valid TOML: {message}" | "kein gültiges TOML: {message}")
            }
        }
        Fault::MissingKey { path, list } => {
            let name = if *list { format!("[[{path}]]") } else { path.clone() };
            said!(language => "`{name}` is missing" | "`{name}` fehlt")
        }
        Fault::UnknownKey { path } => said!(language => "unknown key `{path}`" | "unbekannter Schlüssel `{path}`"),
        Fault::KeyOfAnotherKind { path, by, kind } => said!(language =>
            "`{path}` has no meaning with {by} = \"{kind}\""
            | "`{path}` hat bei {by} = \"{kind}\" keine Bedeutung"
        ),
        Fault::OutsideTheAxes { key } => said!(language =>
            "with several axes `{key}` belongs inside [[axis]]"
            | "bei mehreren Achsen gehört `{key}` in [[axis]]"
        ),
        Fault::AxisNamedTwice { name, first, line, is_alike: true } => said!(language =>
            "\"{name}\" is the name of `{first}` in line {line} as well"
            | "„{name}“ ist bereits der Name von `{first}` in Zeile {line}"
        ),
        Fault::AxisNamedTwice { name, first, line, is_alike: false } => said!(language =>
            "\"{name}\" differs from the name of `{first}` in line {line} in case or spaces only"
            | "„{name}“ unterscheidet sich vom Namen von `{first}` in Zeile {line} nur durch Groß- und Kleinschreibung oder Leerzeichen"
        ),
        Fault::EmptyList { path } => said!(language =>
            "`{path}` is an empty list: omit the key if nothing is required"
            | "`{path}` ist eine leere Liste: ohne Anforderung den Schlüssel weglassen"
        ),
        Fault::OneAxisOnly => said!(language =>
            "a single axis is required, the file has several"
            | "erforderlich ist eine einzelne Achse, die Datei enthält mehrere"
        ),
        Fault::More { count } => more(*count, language),
        Fault::ReadingStopped { line } => said!(language =>
            "reading stopped at line {line} because of the number of faults"
            | "das Lesen endete wegen der Anzahl der Fehler in Zeile {line}"
        ),
        Fault::InvisibleCharacter { sign } => {
            let (code, name) = (*sign as u32, toml_syntax::invisible(*sign, language));
            said!(language =>
                "{name} (U+{code:04X}) in a key or beside it: delete it"
                | "{name} (U+{code:04X}) in einem Schlüssel oder daneben: löschen"
            )
        }
        Fault::Code(error) => super::describe_code_error(error, language),
        Fault::NoSuchCode { written } => said!(language =>
            "no actuator in the catalogue has an ordering code matching `{written}`"
            | "kein Antrieb des Katalogs hat eine Bestellbezeichnung wie `{written}`"
        ),
        Fault::File { name, trouble } => format!("{name}: {}", trouble_text(trouble, language)),
        Fault::FileOutOfReach { name } => said!(language =>
            "{name}: only files in the folder of the project and below it are read here"
            | "{name}: hier werden nur Dateien im Ordner des Projekts und darunter gelesen"
        ),
        Fault::InBody { path, fault } => format!("`{path}`: {}", file_fault_text(fault, language)),
        Fault::BareNumber { path, dimension } => {
            let name = dimension.name(language);
            said!(language =>
                "`{path}`: a number without a unit; expected: {name}"
                | "`{path}`: Zahl ohne Einheit; erwartet: {name}"
            )
        }
        Fault::Quantity { path, error, .. } => format!("`{path}`: {}", quantity_fault(error, language)),
        #[allow(clippy::float_cmp, reason = "bounds that are written equal")]
        Fault::NumberOutOfRange { path, low, high } => {
            let [least, most] = [low, high].map(|bound| bound_text(*bound, language));
            if low == high {
                return said!(language => "`{path}` must be {least}" | "`{path}` muss {least} sein");
            }
            said!(language =>
                "`{path}` must be a number from {least} to {most}"
                | "`{path}` muss eine Zahl von {least} bis {most} sein"
            )
        }
        Fault::RatioTooSmall { path, magnitude } => {
            let [least, most] = [magnitude.0, magnitude.1].map(|bound| bound_text(bound, language));
            said!(language =>
                "`{path}` must be a number from {least} to {most}, or such a negative one"
                | "`{path}` muss eine Zahl von {least} bis {most} oder von −{most} bis −{least} sein"
            )
        }
        Fault::QuantityOutOfRange { path, written, positive } => {
            let (en, de) = if *positive {
                ("must be greater than zero", "muss größer als null sein")
            } else {
                ("must not be negative", "darf nicht negativ sein")
            };
            said!(language => "`{path}` {en}: \"{written}\"" | "`{path}` {de}: „{written}“")
        }
        Fault::BelowAbsoluteZero { path, written } => said!(language =>
            "`{path}`: \"{written}\" is below absolute zero"
            | "`{path}`: „{written}“ liegt unter dem absoluten Nullpunkt"
        ),
        Fault::Implausible { path, written, low, high } => {
            let [low, high] = [low, high].map(|bound| power_text(*bound, language));
            said!(language =>
                "`{path}`: \"{written}\" is implausible; permitted are magnitudes from {low} to {high} in SI units, and zero"
                | "`{path}`: „{written}“ ist unplausibel; zulässig sind Beträge von {low} bis {high} in SI-Einheiten und null"
            )
        }
        Fault::TextTooLong { path, most } => {
            said!(language => "`{path}` is longer than {most} characters" | "`{path}` ist länger als {most} Zeichen")
        }
        Fault::ControlCharacter { path } => said!(language =>
            "`{path}` contains a control character or a character that reverses the text direction"
            | "`{path}` enthält ein Steuerzeichen oder ein Zeichen, das die Schreibrichtung umkehrt"
        ),
        Fault::WrongType { path, expected, found } => {
            let (expected, german) = (expected_text(*expected, language), type_in_german(found));
            said!(language =>
                "`{path}` must be {expected}, found {found}"
                | "`{path}`: erwartet {expected}, gefunden {german}"
            )
        }
        Fault::NotAChoice { path, written } => said!(language =>
            "`{path}`: \"{written}\" is not a valid choice"
            | "`{path}`: „{written}“ ist hier keine gültige Auswahl"
        ),
        Fault::TooManyEntries { path, most } => {
            said!(language => "`{path}` has more than {most} entries" | "`{path}` hat mehr als {most} Einträge")
        }
        Fault::NotARow { path, columns } => {
            let or = said!(language => " or " | " oder ");
            let of =
                |column: &ColumnDimensions| column.iter().map(|each| each.name(language)).collect::<Vec<_>>().join(&or);
            let row: Vec<String> = columns.iter().map(|column| format!("\"{}\"", of(column))).collect();
            let row = row.join(", ");
            said!(language =>
                "`{path}`: a point is written [{row}]"
                | "`{path}`: ein Punkt wird als [{row}] geschrieben"
            )
        }
        Fault::RatioCount { most } => said!(language =>
            "`stage.ratios` must be a list of 1 to {most} numbers"
            | "`stage.ratios` muss eine Liste aus 1 bis {most} Zahlen sein"
        ),
        Fault::ToleranceEnd { path, end, unit, range } => {
            let end = shown(*end, unit, language);
            let (en, de) = match range {
                Range::Positive => ("it must be greater than zero", "muss größer als null sein"),
                Range::NotNegative => ("it must not be negative", "darf nicht negativ sein"),
                Range::Any => ("that is below absolute zero", "liegt unter dem absoluten Nullpunkt"),
            };
            said!(language =>
                "`{path}`: with this tolerance the value reaches {end}; {en}"
                | "`{path}`: mit dieser Toleranz erreicht der Wert {end}; er {de}"
            )
        }
        Fault::TooManyTolerances { most } => said!(language =>
            "more than {most} quantities with a tolerance"
            | "mehr als {most} Größen mit einer Toleranz"
        ),
        Fault::UnknownUnit { written } => {
            said!(language => "unknown unit \"{written}\"" | "unbekannte Einheit „{written}“")
        }
        Fault::NoTolerance => said!(language =>
            "no tolerance permitted here: the window of a recording is read only once"
            | "Toleranz hier nicht zulässig: das Fenster einer Aufzeichnung wird nur einmal gelesen"
        ),
        Fault::RatioAndRatios => said!(language =>
            "`stage.ratio` states one ratio, `stage.ratios` several to choose from: use only one of the two keys"
            | "`stage.ratio` nennt eine Übersetzung, `stage.ratios` mehrere zur Auswahl: nur einen der beiden Schlüssel verwenden"
        ),
        Fault::NoRatioInACoupling { key } => said!(language =>
            "`stage.{key}`: a coupling has the ratio 1 and no pulleys or gear wheels"
            | "`stage.{key}`: eine Kupplung hat die Übersetzung 1 und weder Scheiben noch Räder"
        ),
        Fault::UnlikeFirstPoint => said!(language =>
            "all points must state the same quantities as the first one: times or master angles, angles or lengths"
            | "alle Punkte müssen dieselben Größen angeben wie der erste: Zeiten oder Winkel des Leitantriebs, Winkel oder Längen"
        ),
        Fault::WrongOrder { lower, upper } => {
            said!(language => "`{lower}` is above `{upper}`" | "`{lower}` ist größer als `{upper}`")
        }
        Fault::SupplyAndMains => said!(language =>
            "`supply` and `mains` are both stated: state only one of them for the DC link"
            | "`supply` und `mains` sind beide angegeben: für den Zwischenkreis nur eines davon angeben"
        ),
        Fault::MasterOfTimes => said!(language =>
            "`master_speed` has no effect: the points are stated over time"
            | "`master_speed` hat keine Wirkung: die Punkte sind über der Zeit angegeben"
        ),
        Fault::WithoutEffect { key } => {
            said!(language => "`{key}` has no effect on this load" | "`{key}` hat auf diese Last keine Wirkung")
        }
        Fault::OnlyBeside { key, needs } => said!(language =>
            "`{key}` has no effect without `{needs}`" | "`{key}` hat ohne `{needs}` keine Wirkung"
        ),
        Fault::NoMechanism => said!(language =>
            "`[load]` or a table `[mechanism.…]` is missing"
            | "`[load]` oder eine Tabelle `[mechanism.…]` fehlt"
        ),
        Fault::TooManyMechanisms => said!(language =>
            "an axis has one load only: either `[load]` or one table `[mechanism.…]`"
            | "eine Achse hat nur eine Last: entweder `[load]` oder eine Tabelle `[mechanism.…]`"
        ),
        Fault::Tabular(fault) => crate::sweeps::fault(fault, language),
        Fault::MotorSide { name, headings, .. } => {
            let headings: Vec<String> =
                headings.iter().map(|heading| crate::recording::quoted(heading, language)).collect();
            let headings = headings.join(", ");
            said!(language =>
                "{name}: {headings}: recorded at the motor, the ratio to the output is not stated"
                | "{name}: {headings}: motorseitig aufgezeichnet, die Übersetzung zum Abtrieb ist nicht angegeben"
            )
        }
        Fault::NoColumnWithRatio { path } => said!(language =>
            "`{path}` has no effect: no column of angles, speeds or torques has this role"
            | "`{path}` hat keine Wirkung: keine Spalte mit Winkeln, Drehzahlen oder Drehmomenten hat diese Rolle"
        ),
        Fault::NoLine { path } => said!(language =>
            "`{path}` is stated as a linear quantity, but this load has no fixed travel per revolution"
            | "`{path}` ist als lineare Größe angegeben, diese Last hat aber keinen festen Weg je Umdrehung"
        ),
        Fault::StrokeBeyond { possible_m } => {
            let [down, up] = possible_m.map(|stroke| format_number(1e3 * stroke, 1, language));
            said!(language =>
                "the platform cannot make this stroke: from here it can move by {down} mm to {up} mm"
                | "diesen Hub kann die Plattform nicht ausführen: von hier aus sind {down} mm bis {up} mm möglich"
            )
        }
        Fault::StrokeFromUnknown => said!(language =>
            "the revolutions for a stroke depend on the height at which it begins, which is not known: state the distance of each segment before it"
            | "die Umdrehungen für einen Hub hängen von der Höhe ab, bei der er beginnt; diese ist nicht bekannt: für jeden Abschnitt davor den Weg angeben"
        ),
        Fault::NoWeb => said!(language =>
            "a web run requires a winder" | "ein Bahnlauf erfordert einen Wickler"
        ),
        Fault::WebNotAlone => said!(language =>
            "a web run goes from the initial roll to the full one or to the core: beside it there are dwells only"
            | "ein Bahnlauf reicht vom Anfangswickel bis zum vollen Wickel oder zur Hülse: daneben sind nur Rasten möglich"
        ),
        Fault::WebSpeed => said!(language =>
            "`speed` of a web run is a line speed greater than zero"
            | "`speed` eines Bahnlaufs ist eine Bahngeschwindigkeit größer als null"
        ),
        Fault::WebTooShort { length_m, ramps_m } => {
            let [length, ramps] = [length_m, ramps_m].map(|metres| format_significant(*metres, 4, language));
            said!(language =>
                "the roll has {length} m of web; accelerating and braking take up {ramps} m"
                | "der Wickel hat {length} m Bahn; Beschleunigen und Bremsen erfordern {ramps} m"
            )
        }
        Fault::RodTooShort => said!(language =>
            "`mechanism.slider_crank.rod` must be longer than the crank"
            | "`mechanism.slider_crank.rod` muss länger als der Kurbelradius sein"
        ),
        Fault::BeyondRange { position_rad, range_rad: (low, high) } => {
            let shown = |angle: f64| format!("{}°", format_significant(DEGREE.from_si(angle), 5, language));
            let (reached, farthest) = (shown(*position_rad), shown(if position_rad > high { *high } else { *low }));
            said!(language =>
                "the motion reaches {reached} at the mechanism; its geometry ends at {farthest}"
                | "die Bewegung erreicht {reached} an der Mechanik; deren Geometrie endet bei {farthest}"
            )
        }
        Fault::NoFlangeLoads => said!(language =>
            "no flange loads can be derived from this load: its masses and their positions are not described"
            | "aus dieser Last lassen sich keine Flanschlasten ableiten: Massen und deren Positionen sind nicht beschrieben"
        ),
        Fault::FlangeLoadsUndecided { key, section } => said!(language =>
            "`{key}` states a load on the flange, and the mechanism has its own: write `mechanism = \"add\"` in [{section}] if both act, `\"replace\"` if those of a segment take the place of the mechanism's there, `\"ignore\"` if the stated loads are all of them"
            | "`{key}` gibt eine Last am Flansch an, und die Mechanik hat eigene: `mechanism = \"add\"` in [{section}], wenn beide wirken, `\"replace\"`, wenn die eines Abschnitts dort an die Stelle derer aus der Mechanik treten, `\"ignore\"`, wenn die angegebenen alle sind"
        ),
        Fault::ReplacesEverything { key } => said!(language =>
            "`bearing.{key}` would replace the loads of the mechanism in every segment; state mechanism = \"ignore\" or \"add\""
            | "`bearing.{key}` würde die Lasten der Mechanik in jedem Abschnitt ersetzen; mechanism = \"ignore\" oder \"add\" angeben"
        ),
        Fault::BeltOrTeeth => said!(language =>
            "`belt_tension` applies to a belt, `pressure_angle` to gear teeth: state only one of them"
            | "`belt_tension` gehört zu einem Riemen, `pressure_angle` zu einer Verzahnung: nur eines davon angeben"
        ),
        Fault::ToothAngle { key, most_deg } => {
            let most = format_number(*most_deg, 0, language);
            said!(language => "`bearing.{key}` must be at most {most}°" | "`bearing.{key}` darf höchstens {most}° sein")
        }
        Fault::BodiesTwice => said!(language =>
            "the bodies of a turntable are given either as texts in `bodies` or as tables in `body`, not both"
            | "die Körper eines Drehtisches stehen entweder als Texte in `bodies` oder als Tabellen in `body`, nicht in beiden"
        ),
        Fault::JointWithoutTorque { columns } if !columns.is_empty() => {
            let first = columns.first().cloned().unwrap_or_default();
            let all: Vec<String> = columns.iter().map(|column| crate::recording::quoted(column, language)).collect();
            let all = all.join(", ");
            said!(language =>
                "the torque of a joint is recorded with its motion, and no column is recognised as the torque of the load; it may be one of {all}: columns = {{ torque = \"{first}\" }} with that name; if none of them is the whole load, state [load] or the mechanism in place of [mechanism.joint]"
                | "das Moment eines Gelenks wird mit der Bewegung aufgezeichnet, und keine Spalte ist als Lastmoment erkannt; infrage kommen {all}: columns = {{ torque = \"{first}\" }} mit diesem Namen; ist keine davon die ganze Last, statt [mechanism.joint] [load] oder die Mechanik angeben"
            )
        }
        Fault::JointWithoutTorque { .. } => said!(language =>
            "the torque of a joint is recorded with its motion: every [[motion]] must be a recording with a torque column"
            | "das Moment eines Gelenks wird mit der Bewegung aufgezeichnet: jedes [[motion]] muss eine Aufzeichnung mit Momentenspalte sein"
        ),
        Fault::BodyMissing => said!(language => "a body is missing" | "ein Körper fehlt"),
        Fault::ShapeMissing => said!(language =>
            "the shape of the body is missing; it must come first"
            | "die Form des Körpers fehlt; sie muss am Anfang stehen"
        ),
        Fault::NoShape { written } => said!(language => "`{written}` is not a shape" | "`{written}` ist keine Form"),
        Fault::NoKey { written } => said!(language =>
            "`{written}` has no key; expected: key=value"
            | "`{written}` hat keinen Schlüssel; erwartet: Schlüssel=Wert"
        ),
        Fault::KeyOfAnotherShape { key, shape } => {
            said!(language => "`{key}` is not a key of `{shape}`" | "`{key}` ist kein Schlüssel von `{shape}`")
        }
        Fault::Twice { key } => said!(language => "`{key}` is given twice" | "`{key}` ist doppelt angegeben"),
        Fault::Count { written } => said!(language =>
            "`count` must be a whole number from 1 to {}, not \"{written}\""
            | "`count` muss eine ganze Zahl von 1 bis {} sein, nicht „{written}“", u32::MAX
        ),
        Fault::BodyAxis { written } => {
            said!(language => "`axis` cannot be \"{written}\"" | "`axis` kann nicht „{written}“ sein")
        }
    }
}

/// Returns the hint that follows from the fault of a file alone.
pub(crate) fn file_own_hint(fault: &Fault, language: Language) -> Option<String> {
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
        Fault::Tabular(fault) => crate::sweeps::hint(fault, language),
        Fault::InBody { fault, .. } => file_own_hint(fault, language),
        Fault::MotorSide { ratios, .. } => {
            let ratio = |(key, ratio): &(&str, Option<f64>)| format!("{key} = {}", ratio.unwrap_or(80.0));
            let ratios: Vec<String> = ratios.iter().map(ratio).collect();
            let ratios = ratios.join(", ");
            Some(said!(language =>
                "recorded_ratio = {{ {ratios} }} with the ratio of the recorded gear instead of 80, negative where the motor turns against the output, with 1 where a column is recorded at the output after all"
                | "recorded_ratio = {{ {ratios} }} mit der Übersetzung des aufgezeichneten Getriebes statt 80, negativ, wo der Motor gegen den Abtrieb dreht, mit 1, wo eine Spalte doch am Abtrieb aufgezeichnet ist"
            ))
        }
        _ => None,
    }
}

/// Returns a hint as text.
#[must_use]
pub fn hint_text(hint: &Hint, language: Language) -> String {
    match hint {
        Hint::Example(line) => said!(language => "for example: {line}" | "zum Beispiel: {line}"),
        Hint::DidYouMean(name) => said!(language => "did you mean `{name}`?" | "gemeint ist vielleicht `{name}`"),
        Hint::ValidAre(names) => {
            let names = names.join(", ");
            said!(language => "valid here: {names}" | "zulässig: {names}")
        }
        Hint::WithUnit { written, dimension } => {
            let units: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
            let (unit, units) = (units.first().copied().unwrap_or_default(), units.join(", "));
            said!(language =>
                "write \"{written} {unit}\" if this unit is intended; units: {units}"
                | "\"{written} {unit}\" schreiben, falls diese Einheit gemeint ist; Einheiten: {units}"
            )
        }
        Hint::MechanismsWithLoads => said!(language =>
            "flange loads can be derived from every mechanism except table and joint"
            | "Flanschlasten lassen sich aus jeder Mechanik außer table und joint ableiten"
        ),
        Hint::KeyOfTable { key, table } => said!(language =>
            "`{key}` is a key of {table}" | "`{key}` gehört in {table}"
        ),
        Hint::KeysOfQuantity { dimension, keys } => {
            let (what, keys) = (dimension.name(language), keys.join(", "));
            said!(language =>
                "keys of this table for this quantity ({what}): {keys}"
                | "Schlüssel dieser Tabelle für diese Größe ({what}): {keys}"
            )
        }
        Hint::WebOfWinder { web_m_s, start_m, core_m } => {
            crate::motion::web_of_winder(*web_m_s, [*start_m, *core_m], language)
        }
        Hint::TimeOfClock => crate::motion::time_of_clock(language),
        Hint::CloseTheRecording => crate::motion::close_the_recording(language),
    }
}

/// Returns the number of further faults as text.
fn more(count: usize, language: Language) -> String {
    match count {
        1 => said!(language => "and 1 more fault" | "und 1 weiterer Fehler"),
        _ => said!(language => "and {count} more faults" | "und {count} weitere Fehler"),
    }
}

/// Returns a very large or small bound, a power of ten without its factor of one.
fn power_text(bound: f64, language: Language) -> String {
    let exponent = bound.abs().log10().round();
    let text = format_significant(bound, 4, language);
    let is_power = (bound / 10_f64.powf(exponent) - 1.0).abs() < 1e-12;
    match text.split_once('·') {
        Some((_, power)) if is_power => power.to_owned(),
        _ => text,
    }
}

/// Returns a bound of a plain number with all of its digits.
fn bound_text(bound: f64, language: Language) -> String {
    let text = bound.to_string().replace('-', "−");
    if language == Language::De { text.replace('.', ",") } else { text }
}

pub(crate) fn shown(si: f64, unit: &Unit, language: Language) -> String {
    with_symbol(&format_significant(unit.from_si(si), 5, language), unit.symbol_in(language))
}

/// Returns the German name of a type of TOML.
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
    match expected {
        Expected::Quantity(dimension) => {
            let (name, example) = (dimension.name(language), dimension.example());
            said!(language =>
                "a quantity with its unit ({name}, for example \"{example}\")"
                | "Zahl mit Einheit ({name}, zum Beispiel \"{example}\")"
            )
        }
        Expected::Along(turning, line) => {
            let (turning, line, example) = (turning.name(language), line.name(language), turning.example());
            said!(language =>
                "a quantity with its unit ({turning} or {line}, for example \"{example}\")"
                | "Zahl mit Einheit ({turning} oder {line}, zum Beispiel \"{example}\")"
            )
        }
        Expected::Number => said!(language => "a number" | "Zahl"),
        Expected::Numbers => said!(language => "a list of numbers" | "Liste von Zahlen"),
        Expected::Integer => said!(language => "a whole number" | "ganze Zahl"),
        Expected::Bool => said!(language => "true or false" | "true oder false"),
        Expected::Text => said!(language => "a text in quotes" | "Text in Anführungszeichen"),
        Expected::Texts => said!(language => "a list of texts in quotes" | "Liste von Texten in Anführungszeichen"),
        Expected::OneOf(words) => said!(language => "one of {}" | "eines von {}", words.join(", ")),
        Expected::ListOf(words) => said!(language => "a list of {}" | "Liste aus {}", words.join(", ")),
        Expected::Rows => said!(language => "a list of points" | "Liste von Punkten"),
        Expected::Table => said!(language => "a table" | "Tabelle"),
        Expected::Bodies => said!(language => "a list of bodies" | "Liste von Körpern"),
        Expected::Tables => said!(language => "an array of tables, [[…]]" | "Liste von Tabellen, [[…]]"),
    }
}
