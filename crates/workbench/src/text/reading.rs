//! Messages of the project reader.

use super::either;
use crate::project::Kind;
use actuator::{BatteryFault, CurveFault};
use mechanism::TableFault;
use motion::{MoveFault, RecordedFault};
use quantities::{Dimension, Language};

/// The messages of the project reader in a language.
pub(crate) trait Speak: Copy {
    fn toml_syntax(self, message: &str) -> String;
    fn missing_key(self, path: &str, key: &str, array: bool) -> String;
    fn unknown_key(self, path: &str, key: &str) -> String;
    fn for_example(self, line: &str) -> String;
    fn did_you_mean(self, name: &str) -> String;
    fn valid_are(self, names: &[&str]) -> String;
    fn bare_number(self, path: &str, dimension: Dimension) -> String;
    fn write_with_unit(self, written: &str, unit: &str, dimension: Dimension) -> String;
    fn number_out_of_range(self, path: &str, low: f64, high: f64) -> String;
    fn quantity_out_of_range(self, path: &str, text: &str, positive: bool) -> String;
    fn below_absolute_zero(self, path: &str, text: &str) -> String;
    fn implausible(self, path: &str, text: &str, low: f64, high: f64) -> String;
    fn text_too_long(self, path: &str, most: usize) -> String;
    fn control_character(self, path: &str) -> String;
    fn wrong_type(self, path: &str, expected: &str, found: &str) -> String;
    fn not_a_choice(self, path: &str, text: &str) -> String;
    fn a_text(self) -> String;
    fn a_table(self) -> String;
    fn too_many(self, path: &str, most: usize) -> String;
    fn not_a_row(self, path: &str, names: &[&str]) -> String;
    fn key_of_another_kind(self, path: &str, by: &str, kind: &str) -> String;
    fn motion_fault(self, fault: &MoveFault) -> (String, Option<String>);
    fn recording_fault(self, fault: &recording::Fault) -> (String, Option<String>);
    fn recorded_fault(self, fault: &RecordedFault) -> (&'static str, String, Option<String>);
    fn file_trouble(self, name: &str, error: &std::io::Error) -> String;
    fn unknown_unit(self, written: &str) -> String;
    fn joint_without_torque(self) -> String;
    fn recording_not_closed(self) -> String;
    fn too_many_revolutions(self, found: &sizing::TooManyRevolutions) -> (String, String);
    fn no_tolerance(self) -> String;
    fn no_such_code(self, written: &str) -> String;
    fn battery_fault(self, fault: &BatteryFault) -> String;
    fn without_effect(self, key: &str) -> String;
    fn one_axis_only(self) -> String;
    fn outside_the_axes(self, key: &str) -> String;
    fn no_mechanism(self) -> String;
    fn too_many_mechanisms(self) -> String;
    fn no_line(self, path: &str) -> String;
    fn rod_too_short(self) -> String;
    fn no_table(self, fault: TableFault) -> String;
    fn kind(self, kind: &Kind) -> String;
    fn file_too_large(self, bytes: usize, most: usize) -> String;
    fn more_faults(self, count: usize) -> String;
    fn no_curve(self, fault: CurveFault) -> String;
}

fn place(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

impl Speak for Language {
    fn toml_syntax(self, message: &str) -> String {
        either(self, format!("not valid TOML: {message}"), format!("kein gültiges TOML: {message}"))
    }

    fn missing_key(self, path: &str, key: &str, array: bool) -> String {
        let name = if array { format!("[[{key}]]") } else { place(path, key) };
        either(self, format!("`{name}` is missing"), format!("`{name}` fehlt"))
    }

    fn unknown_key(self, path: &str, key: &str) -> String {
        let key: String = key.chars().take(60).collect();
        let name = place(path, &key);
        either(self, format!("unknown key `{name}`"), format!("unbekannter Schlüssel `{name}`"))
    }

    fn for_example(self, line: &str) -> String {
        either(self, format!("for example: {line}"), format!("zum Beispiel: {line}"))
    }

    fn did_you_mean(self, name: &str) -> String {
        either(self, format!("did you mean `{name}`?"), format!("gemeint ist vielleicht `{name}`"))
    }

    fn valid_are(self, names: &[&str]) -> String {
        let names = names.join(", ");
        either(self, format!("valid here: {names}"), format!("hier gültig: {names}"))
    }

    fn bare_number(self, path: &str, dimension: Dimension) -> String {
        let name = dimension.name(self);
        either(
            self,
            format!("`{path}`: a number without a unit; expected: {name}"),
            format!("`{path}`: Zahl ohne Einheit; erwartet: {name}"),
        )
    }

    fn write_with_unit(self, written: &str, unit: &str, dimension: Dimension) -> String {
        let units: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
        let units = units.join(", ");
        either(
            self,
            format!("write \"{written} {unit}\" if that is the unit meant; units: {units}"),
            format!("\"{written} {unit}\" schreiben, falls diese Einheit gemeint ist; Einheiten: {units}"),
        )
    }

    fn number_out_of_range(self, path: &str, low: f64, high: f64) -> String {
        #[allow(clippy::float_cmp, reason = "bounds that are written equal")]
        if low == high {
            return either(self, format!("`{path}` must be {low}"), format!("`{path}` muss {low} sein"));
        }
        either(
            self,
            format!("`{path}` must be a number from {low} to {high}"),
            format!("`{path}` muss eine Zahl von {low} bis {high} sein"),
        )
    }

    fn quantity_out_of_range(self, path: &str, text: &str, positive: bool) -> String {
        let (en, de) = if positive {
            ("must be greater than zero", "muss größer als null sein")
        } else {
            ("must not be negative", "darf nicht negativ sein")
        };
        either(self, format!("`{path}` {en}, not \"{text}\""), format!("`{path}` {de}, nicht „{text}“"))
    }

    fn below_absolute_zero(self, path: &str, text: &str) -> String {
        either(
            self,
            format!("`{path}`: \"{text}\" is below absolute zero"),
            format!("`{path}`: „{text}“ liegt unter dem absoluten Nullpunkt"),
        )
    }

    fn implausible(self, path: &str, text: &str, low: f64, high: f64) -> String {
        either(
            self,
            format!(
                "`{path}`: no machine has \"{text}\"; read are magnitudes from {low:e} to {high:e} in SI, and zero"
            ),
            format!(
                "`{path}`: „{text}“ hat keine Maschine; gelesen werden Beträge von {low:e} bis {high:e} in SI, und null"
            ),
        )
    }

    fn text_too_long(self, path: &str, most: usize) -> String {
        either(
            self,
            format!("`{path}` is longer than {most} characters"),
            format!("`{path}` ist länger als {most} Zeichen"),
        )
    }

    fn control_character(self, path: &str) -> String {
        either(self, format!("`{path}` contains a control character"), format!("`{path}` enthält ein Steuerzeichen"))
    }

    fn wrong_type(self, path: &str, expected: &str, found: &str) -> String {
        let german = match found {
            "string" => "Text",
            "integer" => "ganze Zahl",
            "float" => "Zahl",
            "boolean" => "Wahrheitswert",
            "datetime" => "Datum",
            "array" => "Liste",
            "table" => "Tabelle",
            other => other,
        };
        either(
            self,
            format!("`{path}` must be {expected}, found {found}"),
            format!("`{path}`: erwartet {expected}, gefunden {german}"),
        )
    }

    fn not_a_choice(self, path: &str, text: &str) -> String {
        let text: String = text.chars().take(60).collect();
        either(
            self,
            format!("`{path}`: \"{text}\" is not a valid choice"),
            format!("`{path}`: „{text}“ steht hier nicht zur Wahl"),
        )
    }

    fn a_text(self) -> String {
        either(self, "a text in quotes", "Text in Anführungszeichen")
    }

    fn a_table(self) -> String {
        either(self, "a table", "Tabelle")
    }

    fn too_many(self, path: &str, most: usize) -> String {
        either(self, format!("`{path}` has more than {most} entries"), format!("`{path}` hat mehr als {most} Einträge"))
    }

    fn not_a_row(self, path: &str, names: &[&str]) -> String {
        let row: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
        let row = row.join(", ");
        either(
            self,
            format!("`{path}`: a point is written [{row}]"),
            format!("`{path}`: ein Punkt wird als [{row}] geschrieben"),
        )
    }

    fn key_of_another_kind(self, path: &str, by: &str, kind: &str) -> String {
        either(
            self,
            format!("`{path}` has no meaning with {by} = \"{kind}\""),
            format!("`{path}` hat bei {by} = \"{kind}\" keine Bedeutung"),
        )
    }

    fn motion_fault(self, fault: &MoveFault) -> (String, Option<String>) {
        super::motion::fault(fault, self)
    }

    fn recording_fault(self, fault: &recording::Fault) -> (String, Option<String>) {
        super::recording::fault(fault, self)
    }

    fn recorded_fault(self, fault: &RecordedFault) -> (&'static str, String, Option<String>) {
        super::motion::recorded_fault(fault, self)
    }

    fn file_trouble(self, name: &str, error: &std::io::Error) -> String {
        format!("{name}: {}", file_trouble(error, self))
    }

    fn unknown_unit(self, written: &str) -> String {
        let written: String = written.chars().take(40).collect();
        either(self, format!("unknown unit \"{written}\""), format!("unbekannte Einheit „{written}“"))
    }

    fn no_such_code(self, written: &str) -> String {
        either(
            self,
            format!("no actuator of the catalogue has a code like `{written}`"),
            format!("kein Antrieb des Katalogs hat einen Code wie `{written}`"),
        )
    }

    fn too_many_revolutions(self, found: &sizing::TooManyRevolutions) -> (String, String) {
        let [found, most] = [found.revolutions, found.most].map(|count| format!("{count:.0}"));
        (
            either(
                self,
                format!(
                    "the cycle turns {found} times at changing speed under a load that depends on the position; at most {most} are calculated"
                ),
                format!(
                    "der Zyklus dreht sich {found}-mal mit veränderlicher Drehzahl unter einer Last, die von der Lage abhängt; höchstens {most} Umdrehungen werden gerechnet"
                ),
            ),
            either(
                self,
                "change speed in fewer revolutions and run at constant speed between, or describe a shorter cycle",
                "die Drehzahl in weniger Umdrehungen ändern und dazwischen konstant fahren, oder einen kürzeren Zyklus beschreiben",
            ),
        )
    }

    fn recording_not_closed(self) -> String {
        either(
            self,
            "choose the window with from and to, state standstill, or write single_move = true under [axis]",
            "das Fenster mit from und to wählen, standstill angeben oder unter [axis] single_move = true schreiben",
        )
    }

    fn no_tolerance(self) -> String {
        either(
            self,
            "no tolerance here: the window of a recording is read once",
            "hier keine Toleranz: das Fenster einer Aufzeichnung wird einmal gelesen",
        )
    }

    fn joint_without_torque(self) -> String {
        either(
            self,
            "the torque of a joint comes with its motion: every [[motion]] must be recorded, with a column of torque",
            "das Moment eines Gelenks kommt mit seiner Bewegung: jedes [[motion]] muss aufgezeichnet sein und eine Momentenspalte haben",
        )
    }

    fn battery_fault(self, fault: &BatteryFault) -> String {
        match fault {
            BatteryFault::OperationOutOfRange { .. } => {
                either(self, "a day has 0 h to 24 h of operation", "ein Tag hat 0 h bis 24 h Betrieb")
            }
            _ => either(
                self,
                "the battery model covers 0 a to 3 a of storage",
                "das Batteriemodell gilt für 0 a bis 3 a Lagerung",
            ),
        }
    }

    fn without_effect(self, key: &str) -> String {
        either(self, format!("`{key}` has no effect on this load"), format!("`{key}` hat auf diese Last keine Wirkung"))
    }

    fn one_axis_only(self) -> String {
        either(self, "one axis is asked for, the file has several", "gefragt ist eine Achse, die Datei hat mehrere")
    }

    fn outside_the_axes(self, key: &str) -> String {
        either(
            self,
            format!("with several axes `{key}` belongs inside [[axis]]"),
            format!("bei mehreren Achsen gehört `{key}` in [[axis]]"),
        )
    }

    fn no_mechanism(self) -> String {
        either(
            self,
            "`[load]` is missing, or one table of `[mechanism.…]`",
            "`[load]` fehlt, oder eine Tabelle aus `[mechanism.…]`",
        )
    }

    fn too_many_mechanisms(self) -> String {
        either(
            self,
            "an axis has one load: `[load]` or one table of `[mechanism.…]`",
            "eine Achse hat eine Last: `[load]` oder eine Tabelle aus `[mechanism.…]`",
        )
    }

    fn no_line(self, path: &str) -> String {
        either(
            self,
            format!("`{path}` is written along a line, but this load has no fixed travel per revolution"),
            format!("`{path}` ist längs einer Linie angegeben, diese Last hat aber keinen festen Weg je Umdrehung"),
        )
    }

    fn rod_too_short(self) -> String {
        either(
            self,
            "`mechanism.slider_crank.rod` must be longer than the crank",
            "`mechanism.slider_crank.rod` muss länger als der Kurbelradius sein",
        )
    }

    fn no_table(self, fault: TableFault) -> String {
        match fault {
            TableFault::TooFewPoints => {
                either(self, "a table needs at least two points", "eine Tabelle braucht mindestens zwei Punkte")
            }
            TableFault::PositionsNotAscending => either(
                self,
                "the positions of a table must grow from point to point",
                "die Stellungen einer Tabelle müssen von Punkt zu Punkt wachsen",
            ),
            _ => either(
                self,
                "a moment of inertia must not be negative",
                "ein Massenträgheitsmoment darf nicht negativ sein",
            ),
        }
    }

    fn kind(self, kind: &Kind) -> String {
        match kind {
            Kind::Quantity(dimension, _) => {
                let (name, example) = (dimension.name(self), dimension.example());
                either(
                    self,
                    format!("a quantity with its unit ({name}, for example \"{example}\")"),
                    format!("Zahl mit Einheit ({name}, zum Beispiel \"{example}\")"),
                )
            }
            Kind::Number(..) => either(self, "a number", "Zahl"),
            Kind::Numbers(..) => either(self, "a list of numbers", "Liste von Zahlen"),
            Kind::Integer(..) => either(self, "a whole number", "ganze Zahl"),
            Kind::Bool => either(self, "true or false", "true oder false"),
            Kind::Text => self.a_text(),
            Kind::OneOf(words) => {
                either(self, format!("one of {}", words.join(", ")), format!("eines von {}", words.join(", ")))
            }
            Kind::ListOf(words) => {
                either(self, format!("a list of {}", words.join(", ")), format!("Liste aus {}", words.join(", ")))
            }
            Kind::Along(turning, line, _) => {
                let (turning, example) = (turning.name(self), turning.example());
                let line = line.name(self);
                either(
                    self,
                    format!("a quantity with its unit ({turning} or {line}, for example \"{example}\")"),
                    format!("Zahl mit Einheit ({turning} oder {line}, zum Beispiel \"{example}\")"),
                )
            }
            Kind::Rows(_) => either(self, "a list of points", "Liste von Punkten"),
            Kind::Table(_) | Kind::OneOrMany(..) => self.a_table(),
            Kind::Bodies => either(self, "a list of bodies", "Liste von Körpern"),
            Kind::Variants(_) => either(self, "an array of tables, [[…]]", "Liste von Tabellen, [[…]]"),
        }
    }

    fn file_too_large(self, bytes: usize, most: usize) -> String {
        either(
            self,
            format!("the project file has {bytes} bytes; {most} are read at most"),
            format!("die Projektdatei hat {bytes} Byte; gelesen werden höchstens {most}"),
        )
    }

    fn more_faults(self, count: usize) -> String {
        if count == 1 {
            either(self, "and 1 more fault", "und 1 weiterer Fehler")
        } else {
            either(self, format!("and {count} more faults"), format!("und {count} weitere Fehler"))
        }
    }

    fn no_curve(self, fault: CurveFault) -> String {
        match fault {
            CurveFault::TooFewPoints => {
                either(self, "a curve needs at least two points", "eine Kennlinie braucht mindestens zwei Punkte")
            }
            CurveFault::DoesNotStartAtZero => {
                either(self, "a curve starts at standstill, 0 1/min", "eine Kennlinie beginnt im Stillstand, 0 1/min")
            }
            CurveFault::SpeedsNotAscending => either(
                self,
                "the speeds of a curve must grow from point to point",
                "die Drehzahlen einer Kennlinie müssen von Punkt zu Punkt wachsen",
            ),
            _ => either(
                self,
                "the torques of a curve must not be negative",
                "die Drehmomente einer Kennlinie dürfen nicht negativ sein",
            ),
        }
    }
}

/// What the system says about a file that cannot be read.
#[must_use]
pub fn file_trouble(error: &std::io::Error, language: Language) -> String {
    use std::io::ErrorKind;
    let (en, de) = match error.kind() {
        ErrorKind::NotFound => ("there is no such file", "diese Datei gibt es nicht"),
        ErrorKind::PermissionDenied => ("permission denied", "kein Zugriff"),
        ErrorKind::IsADirectory => ("this is a folder, not a file", "das ist ein Ordner, keine Datei"),
        ErrorKind::FileTooLarge => ("the file is too large", "die Datei ist zu groß"),
        ErrorKind::Unsupported => {
            ("files cannot be read from here", "von hier aus können keine Dateien gelesen werden")
        }
        _ => return error.to_string(),
    };
    either(language, en, de)
}
