//! Words for recordings that cannot be read.

mod advice;
mod beyond;
mod counter;
mod foreign;
mod headings;
mod modulo;
mod scaled;
mod tables;

use crate::texts::said;
use crate::{file_trouble, pick};
use advice::{advised, below_rows};
use beyond::{beyond, damage};
use counter::counter;
use foreign::foreign;
use headings::{
    LIST_MOST, columns, columns_and_names, header, heading_missing, heading_of_units, list, toml_text,
    unit_without_column, valid_units,
};
use modulo::{position_jumps, scale_unknown, several_axes, step_undecided, turn_begun};
use quantities::unit::SECOND;
use quantities::{Language, Measure, Time, format_significant, with_symbol};
use recording::{Encoding, Fault, FileRow, GAP_FACTOR, KnownBy, MAGNITUDE_MAX, Role, STEP_MIN_S, Stamp};

pub use scaled::role_key;
pub use tables::table_text;

/// Returns the fault of a file of a recording, in one sentence.
#[must_use]
pub fn recording_text(found: &Fault, language: Language) -> String {
    fault(found, language).0
}

/// A row with more or fewer cells than the header.
fn ragged(line: u64, found: usize, expected: usize, language: Language) -> String {
    if found == 1 {
        return said!(language =>
            "line {line}: 1 cell, the header has {expected}" | "Zeile {line}: 1 Zelle, die Kopfzeile hat {expected}"
        );
    }
    said!(language =>
        "line {line}: {found} cells, the header has {expected}"
        | "Zeile {line}: {found} Zellen, die Kopfzeile hat {expected}"
    )
}

/// Returns the message of a fault of a recording, and the advice that removes it.
pub(super) fn fault(fault: &Fault, language: Language) -> (String, Option<String>) {
    let q = |text: &str| quoted(text, language);
    match fault {
        Fault::ReadFailed { line, kind } => {
            let why = file_trouble(&(*kind).into(), language);
            let text = said!(language =>
                "line {line}: the rest of the file cannot be read: {why}"
                | "Zeile {line}: der Rest der Datei ist nicht lesbar: {why}"
            );
            (text, None)
        }
        Fault::NoHeader => (
            said!(language => "the file has no header line" | "die Datei hat keine Kopfzeile"),
            Some(said!(language =>
                "the first line names the columns, for example time [s];q [deg]"
                | "die erste Zeile nennt die Spalten, zum Beispiel time [s];q [deg]"
            )),
        ),
        Fault::LineTooLong { line, most } => (
            said!(language => "line {line}: longer than {} KiB" | "Zeile {line}: länger als {} KiB", most / 1024),
            Some(said!(language =>
                "is this a CSV file with one sample per line?"
                | "ist dies eine CSV-Datei mit einem Abtastwert je Zeile?"
            )),
        ),
        Fault::QuoteOpen { line } => (
            said!(language =>
                "line {line}: a cell in quotes does not end in this line"
                | "Zeile {line}: eine Zelle in Anführungszeichen endet nicht in dieser Zeile"
            ),
            None,
        ),
        Fault::Ragged { line, found, expected } => (ragged(*line, *found, *expected, language), None),
        Fault::CommasTwice { line, found, expected } => (
            said!(language =>
                "{}: commas separate the cells and are decimal signs as well"
                | "{}: Kommas trennen die Zellen und sind zugleich Dezimalzeichen", ragged(*line, *found, *expected, language)
            ),
            Some(said!(language =>
                "export with ; or tabs between the cells, with decimal points, or with the numbers in quotes"
                | "mit ; oder Tabulatoren zwischen den Zellen, mit Dezimalpunkten oder mit den Zahlen in Anführungszeichen ausgeben"
            )),
        ),
        Fault::SpacesOnly => (
            said!(language =>
                "the numbers are separated by spaces alone, which also stand within headings"
                | "die Zahlen sind nur durch Leerzeichen getrennt, die auch in Überschriften stehen"
            ),
            Some(said!(language =>
                "export with ;, tabs or commas between the cells, in Python numpy.savetxt(…, delimiter=\",\", header=\"t [s],q [deg]\", comments=\"\")"
                | "mit ;, Tabulatoren oder Kommas zwischen den Zellen ausgeben, in Python numpy.savetxt(…, delimiter=\",\", header=\"t [s],q [deg]\", comments=\"\")"
            )),
        ),
        Fault::WindowReversed { from, to } => {
            let (from, to) = (seconds(*from, language), seconds(*to, language));
            (
                said!(language =>
                    "the window ends at {to}, before it begins at {from}"
                    | "das Zeitfenster endet bei {to}, bevor es bei {from} beginnt"
                ),
                None,
            )
        }
        Fault::TooFewSamples { found, least, outside, span } => (
            match outside {
                0 => said!(language =>
                    "the file has {found} samples; at least {least} are required"
                    | "die Datei hat {found} Abtastwerte; erforderlich sind mindestens {least}"
                ),
                _ => said!(language =>
                    "{found} samples are inside the window and {outside} outside; at least {least} are required"
                    | "im Zeitfenster liegen {found} Abtastwerte, außerhalb {outside}; erforderlich sind mindestens {least}"
                ),
            },
            span.filter(|_| *outside > 0).map(|[first, last]| {
                let (first, last) = (stamp(first, language), stamp(last, language));
                said!(language => "the file runs from {first} to {last}" | "die Datei reicht von {first} bis {last}")
            }),
        ),
        Fault::HeadingMissing { columns } => heading_missing(*columns, language),
        Fault::HeadingOfUnits { columns } => heading_of_units(columns, language),
        Fault::TimesDiffer { at, column, numbers: [first, second] } => (
            said!(language =>
                "{}: the columns {first} and {second} are both named {} and contain different times"
                | "{}: die Spalten {first} und {second} heißen beide {} und enthalten verschiedene Zeiten", place(*at, language), q(column)
            ),
            Some(said!(language =>
                "state which one counts, columns = {{ time = \"#{first}\" }}, or export all channels at the same instants"
                | "die maßgebende angeben, columns = {{ time = \"#{first}\" }}, oder alle Kanäle zu denselben Zeitpunkten ausgeben"
            )),
        ),
        Fault::Foreign { format } => {
            let (what, remedy) = foreign(*format, language);
            (
                said!(language => "this is {what}, not a CSV or Parquet" | "das ist {what}, kein CSV oder Parquet"),
                Some(remedy),
            )
        }
        Fault::Stopped => (said!(language => "reading was cancelled" | "das Lesen wurde abgebrochen"), None),
        Fault::TooManySamples { most } => (
            said!(language => "the file has more than {most} samples" | "die Datei hat mehr als {most} Abtastwerte"),
            Some(
                said!(language => "select a part: from = \"…\", to = \"…\"" | "einen Abschnitt wählen: from = \"…\", to = \"…\""),
            ),
        ),
        Fault::ParquetUnreadable { reason } => {
            let reason = damage(reason, language);
            (
                said!(language =>
                    "the Parquet file cannot be read: {reason}"
                    | "die Parquet-Datei ist nicht lesbar: {reason}"
                ),
                Some(said!(language =>
                    "uncompressed, snappy, zstd, gzip, brotli and lz4 files without encryption are read"
                    | "gelesen werden unverschlüsselte Dateien ohne Kompression oder mit snappy, zstd, gzip, brotli, lz4"
                )),
            )
        }
        Fault::Beyond { limit, found, most } => beyond(*limit, *found, *most, language),
        Fault::More { count: 0, .. } => {
            (said!(language => "the rest of the file was not read" | "der Rest der Datei wurde nicht gelesen"), None)
        }
        Fault::More { count, stopped } => (
            {
                let (faults, further) = match count {
                    1 => ("1 more fault".to_owned(), "1 weiterer Fehler".to_owned()),
                    count => (format!("{count} more faults"), format!("{count} weitere Fehler")),
                };
                match stopped {
                    false => said!(language => "and {faults}" | "und {further}"),
                    true => said!(language =>
                        "and {faults}; the rest of the file was not read"
                        | "und {further}; der Rest der Datei wurde nicht gelesen"
                    ),
                }
            },
            None,
        ),
        Fault::ColumnUnknown { role, name, nearest, headers } => (
            said!(language =>
                "no column is named {} ({})"
                | "keine Spalte heißt {} ({})", q(name), role_text(*role, language)
            ),
            Some(match nearest {
                Some(nearest) => said!(language => "did you mean {}?" | "ist {} gemeint?", q(nearest)),
                None => columns(headers, language),
            }),
        ),
        Fault::ClockUnknown { column, text } => (
            said!(language =>
                "{} in {} is a time in a form that is not known"
                | "{} in {} ist eine Zeit in unbekannter Schreibweise", q(text), q(column)
            ),
            Some(said!(language =>
                "export the time as a number with its unit, or in one of these forms: 2025-04-17T17:00:08.005 (also with Z or +02:00), 17.04.2025 17:00:08,005, 4/17/2025 5:00:08.005 PM, 17-Apr-2025 17:00:08, 17:00:08.005, 0 days 00:00:00.002, 00:01,5"
                | "die Zeit als Zahl mit Einheit ausgeben oder in einer dieser Schreibweisen: 2025-04-17T17:00:08.005 (auch mit Z oder +02:00), 17.04.2025 17:00:08,005, 4/17/2025 5:00:08.005 PM, 17-Apr-2025 17:00:08, 17:00:08.005, 0 days 00:00:00.002, 00:01,5"
            )),
        ),
        Fault::ColumnTwice { column, roles: [first, second] } => {
            let (first, second) = (role_text(*first, language), role_text(*second, language));
            (
                said!(language =>
                    "the column {} is assigned to both {first} and {second}"
                    | "die Spalte {} ist sowohl {first} als auch {second} zugeordnet", q(column)
                ),
                None,
            )
        }
        Fault::SeveralAxes { columns } => several_axes(columns, language),
        Fault::ScaleUnknown { column, scale } => scale_unknown(column, scale, language),
        Fault::StepUndecided { at, time, step, count } => step_undecided(*at, *time, *step, *count, language),
        Fault::TurnBegun { at, jump, has_speed } => turn_begun(*at, *jump, *has_speed, language),
        Fault::NoTable => (
            said!(language =>
                "this is not a table of numbers: there is no number below the first line"
                | "das ist keine Tabelle aus Zahlen: unter der ersten Zeile steht keine Zahl"
            ),
            Some(said!(language =>
                "the first line names the columns, for example time [s];q [deg], and a row of numbers follows"
                | "die erste Zeile nennt die Spalten, zum Beispiel time [s];q [deg], dann folgt eine Zeile mit Zahlen"
            )),
        ),
        Fault::NotText => (
            said!(language =>
                "this is neither text nor a Parquet file" | "das ist weder Text noch eine Parquet-Datei"
            ),
            Some(said!(language =>
                "export the columns as CSV or Parquet" | "die Spalten als CSV oder Parquet ausgeben"
            )),
        ),
        Fault::TimeMissing { headers, near } => (
            said!(language => "no time column found" | "keine Zeitspalte gefunden"),
            Some(columns_and_names(headers, near, &[Role::Time], language)),
        ),
        Fault::CourseMissing { headers, near } => (
            said!(language =>
                "neither a position column nor a speed column found"
                | "weder eine Positions- noch eine Geschwindigkeitsspalte gefunden"
            ),
            Some(columns_and_names(headers, near, &[Role::Position, Role::Speed], language)),
        ),
        Fault::UnitWithoutColumn { role, headers, near } => unit_without_column(*role, headers, near, language),
        Fault::Ambiguous { role, columns, numbers } => {
            let (role, key) = (role_text(*role, language), role_key(*role));
            let first = columns.first().map_or("", String::as_str);
            // Columns with the same name are distinguished by their numbers.
            let is_alike = columns.iter().any(|name| columns.iter().filter(|other| *other == name).count() > 1);
            let (list, line) = if is_alike {
                let named =
                    columns.iter().zip(numbers).map(|(name, number)| format!("#{number} {}", quoted(name, language)));
                let named: Vec<String> = named.take(LIST_MOST).collect();
                (named.join(", "), numbers.first().map_or_else(String::new, |number| format!("\"#{number}\"")))
            } else {
                (list(columns, language), toml_text(first))
            };
            (
                said!(language =>
                    "several columns could be the {role}: {list}"
                    | "mehrere Spalten kommen für {role} in Frage: {list}"
                ),
                Some(said!(language =>
                    "state the right one, for example columns = {{ {key} = {line} }}"
                    | "die richtige angeben, zum Beispiel columns = {{ {key} = {line} }}"
                )),
            )
        }
        Fault::UnitMissing { role, column } => (
            said!(language => "the unit of {} is missing" | "die Einheit von {} fehlt", q(column)),
            Some(said!(language =>
                "state it after the name, for example {}, in a row below the header, or in the project: units = {{ {} = \"…\" }}"
                | "hinter dem Namen angeben, zum Beispiel {}, in einer Zeile unter der Kopfzeile oder im Projekt: units = {{ {} = \"…\" }}", header(column, *role), role_key(*role)
            )),
        ),
        Fault::UnitUnknown { role, column, text, by, nearest } => (
            said!(language =>
                "{} is not a known unit ({}, {})"
                | "{} ist keine bekannte Einheit ({}, {})", q(text), q(column), known_by(*by, language)
            ),
            scaled::of_column(*role, text, language).or_else(|| {
                Some(match nearest {
                    Some(unit) => said!(language => "did you mean {}?" | "ist {} gemeint?", q(unit.ascii)),
                    None => {
                        let (valid, key) = (valid_units(*role, language), role_key(*role));
                        said!(language =>
                            "{valid}; regardless of the file, units = {{ {key} = \"…\" }} states it in the project"
                            | "{valid}; unabhängig von der Datei gibt units = {{ {key} = \"…\" }} sie im Projekt an"
                        )
                    }
                })
            }),
        ),
        Fault::UnitWrong { role, column, unit, by } => {
            let (measures, by) = (unit.dimension.name(language), known_by(*by, language));
            let of_share = scaled::of_column(*role, unit.ascii, language);
            let (unit, column, role_name) = (q(unit.ascii), q(column), role_text(*role, language));
            (
                said!(language =>
                    "{unit} is a unit of {measures}, {column} is read as {role_name} ({by})"
                    | "{unit} ist eine Einheit für {measures}, {column} wird als {role_name} gelesen ({by})"
                ),
                of_share.or_else(|| Some(valid_units(*role, language))),
            )
        }
        Fault::UnitScaled { column, text } => headings::scaled(&q(column), &q(text), language),
        Fault::UnitContradiction { column, units: [first, second], by: [first_by, second_by] } => {
            let (first_by, second_by) = (known_by(*first_by, language), known_by(*second_by, language));
            (
                said!(language =>
                    "two units for {}: {} ({first_by}) and {} ({second_by})"
                    | "zwei Einheiten für {}: {} ({first_by}) und {} ({second_by})", q(column), first.ascii, second.ascii
                ),
                None,
            )
        }
        Fault::CourseMixed { position, speed } => {
            let (position, speed) = (position.name_with_article(language), speed.name_with_article(language));
            (
                said!(language =>
                    "position and speed do not belong together: {position} and {speed}"
                    | "Position und Geschwindigkeit widersprechen sich: {position} und {speed}"
                ),
                Some(said!(language => "omit one of the two columns" | "eine der beiden Spalten weglassen")),
            )
        }
        Fault::ColumnType { column, found } => (
            said!(language =>
                "the column {} contains {found}, which is not read as numbers"
                | "die Spalte {} enthält {found}; dieser Typ wird nicht als Zahl gelesen", q(column)
            ),
            Some(said!(language =>
                "read are float, double, half floats, integers up to 64 bits and decimals, for the time also types of time; convert the column to double"
                | "gelesen werden float, double, halbgenaue Gleitkommazahlen, ganze Zahlen bis 64 Bit und decimal, für die Zeit auch Zeittypen; die Spalte in double umwandeln"
            )),
        ),
        Fault::ValueMissing { at, column } => (
            said!(language =>
                "{}: the value of {} is missing"
                | "{}: der Wert von {} fehlt", place(*at, language), q(column)
            ),
            None,
        ),
        Fault::ValueUnreadable { at, column, text } => (
            match text {
                Some(text) => said!(language =>
                    "{}: {} in {} is not a number"
                    | "{}: {} in {} ist keine Zahl", place(*at, language), q(text), q(column)
                ),
                None => said!(language =>
                    "{}: the value of {} is not a number"
                    | "{}: der Wert von {} ist keine Zahl", place(*at, language), q(column)
                ),
            },
            None,
        ),
        Fault::UnitOfCell { at, column, text, unit } => {
            let (at, column, unit) = (place(*at, language), q(column), q(unit.ascii));
            (
                match text {
                    Some(text) => said!(language =>
                        "{at}: {} in {column} is not in {unit}, the unit of the first cell"
                        | "{at}: {} in {column} steht nicht in {unit}, der Einheit der ersten Zelle", q(text)
                    ),
                    None => said!(language =>
                        "{at}: the value of {column} is not a number in {unit}, the unit of the first cell"
                        | "{at}: der Wert von {column} ist keine Zahl in {unit}, der Einheit der ersten Zelle"
                    ),
                },
                Some(said!(language =>
                    "state all values of a column in one unit" | "alle Werte einer Spalte in einer Einheit angeben"
                )),
            )
        }
        Fault::ValueNotFinite { at, column, text } => (
            said!(language =>
                "{}: {} in {} is not a finite number"
                | "{}: {} in {} ist keine endliche Zahl", place(*at, language), q(text), q(column)
            ),
            None,
        ),
        Fault::ValueImplausible { at, column, text } => {
            let most = format_significant(MAGNITUDE_MAX, 1, language);
            (
                said!(language =>
                    "{}: {} in {} is implausible; permitted are magnitudes up to {most} in SI units"
                    | "{}: {} in {} ist unplausibel; zulässig sind Beträge bis {most} in SI-Einheiten", place(*at, language), q(text), q(column)
                ),
                Some(said!(language => "is the unit of the column correct?" | "stimmt die Einheit der Spalte?")),
            )
        }
        Fault::TooClose { at, length } => {
            let (length, least) = (seconds(*length, language), seconds(Time::from_si(STEP_MIN_S), language));
            (
                said!(language =>
                    "{}: only {length} after the previous sample; at least {least} are required"
                    | "{}: nur {length} nach dem vorigen Abtastwert; erforderlich sind mindestens {least}", place(*at, language)
                ),
                Some(said!(language => "is the unit of time correct?" | "stimmt die Einheit der Zeit?")),
            )
        }
        Fault::DecimalMixed { line, column, text, decided } => (
            said!(language =>
                "line {line}: {} in {} has a different decimal separator than line {decided}"
                | "Zeile {line}: {} in {} hat ein anderes Dezimaltrennzeichen als Zeile {decided}", q(text), q(column)
            ),
            Some(said!(language =>
                "use either points or commas throughout the file, and no thousands separators"
                | "in der ganzen Datei entweder Punkt oder Komma, keine Tausendertrennzeichen"
            )),
        ),
        Fault::ThousandsGrouped { at, column, text } => (
            said!(language =>
                "{}: {} in {} has thousands separators"
                | "{}: {} in {} hat Tausendertrennzeichen", place(*at, language), q(text), q(column)
            ),
            Some(said!(language =>
                "export the numbers without thousands separators: 1234.5 or 1234,5"
                | "die Zahlen ohne Tausendertrennzeichen exportieren: 1234,5 oder 1234.5"
            )),
        ),
        Fault::ThousandsPossible { line, column, text } => {
            // In the notation of the file.
            let (whole, decimal) = (q(&text.replace(['.', ','], "")), q(&format!("{text}0")));
            (
                said!(language =>
                    "line {line}: {} in {} is ambiguous: {whole} with a thousands separator or {decimal} with a decimal separator; the column has numbers up to 999 without a separator and others with exactly three digits after it"
                    | "Zeile {line}: {} in {} ist mehrdeutig: {whole} mit Tausendertrennzeichen oder {decimal} mit Dezimaltrennzeichen; die Spalte enthält Zahlen bis 999 ohne Trennzeichen und andere mit genau drei Ziffern dahinter", q(text), q(column)
                ),
                Some(said!(language =>
                    "export without thousands separators: {whole}; if the separator is decimal, with another number of decimals: {decimal}"
                    | "ohne Tausendertrennzeichen exportieren: {whole}; ist das Trennzeichen dezimal, mit anderer Stellenzahl: {decimal}"
                )),
            )
        }
        Fault::PositionJumps { .. } => position_jumps(fault, language),
        Fault::Backwards { at, time, before } => {
            let hint = counter(*before, *time, language);
            let (time, before) = (stamp(*time, language), stamp(*before, language));
            (
                said!(language =>
                    "{}: time runs backwards, {time} follows {before}"
                    | "{}: die Zeit läuft rückwärts, {time} folgt auf {before}", place(*at, language)
                ),
                hint,
            )
        }
        Fault::SameTime { at, first, time } => {
            let (at, first, time) = (place(*at, language), place(*first, language), stamp(*time, language));
            (
                said!(language => "{at}: the same time as {first}, {time}" | "{at}: dieselbe Zeit wie {first}, {time}"),
                None,
            )
        }
        Fault::Gap { at, length, median } => {
            let (length, median) = (seconds(*length, language), seconds(*median, language));
            let factor = format_significant(GAP_FACTOR, 2, language);
            (
                said!(language => "{}: a gap of {length} before this sample, more than {factor} times the median interval of {median}" | "{}: vor diesem Abtastwert liegt eine Lücke von {length}, mehr als das {factor}-Fache des mittleren \
                         Abstands (Median) von {median}", place(*at, language)),
                Some(said!(language =>
                    "select a part, from = \"…\" and to = \"…\", or accept gaps with gaps = \"allow\""
                    | "einen Abschnitt wählen, from = \"…\" und to = \"…\", oder Lücken mit gaps = \"allow\" zulassen"
                )),
            )
        }
        Fault::BelowRows { first, count, last } => below_rows(first, *count, *last, language),
        Fault::Advised { fault, remedy } => advised(fault, *remedy, language),
        Fault::Repeated { first, more } => {
            let (message, hint) = self::fault(first, language);
            let more =
                said!(language => "{message}; {more} more of this kind" | "{message}; {more} weitere dieser Art");
            (more, hint)
        }
    }
}

/// Returns the assumed encoding of a text; `None` if the encoding was known.
#[must_use]
pub fn encoding_guess(encoding: Option<Encoding>, language: Language) -> Option<String> {
    let name = match encoding? {
        Encoding::Utf8 | Encoding::Utf16 => return None,
        Encoding::Utf16Guessed => "UTF-16",
        Encoding::Windows1252Guessed => "Windows-1252",
    };
    Some(crate::terminal::text_read_as(&name, language))
}

pub(crate) fn quoted(text: &str, language: Language) -> String {
    said!(language => "\"{text}\"" | "„{text}“")
}

fn place(at: FileRow, language: Language) -> String {
    match at {
        FileRow::Line(number) => said!(language => "line {number}" | "Zeile {number}"),
        FileRow::Row(number) => said!(language => "row {number}" | "Reihe {number}"),
    }
}

fn seconds(time: Time, language: Language) -> String {
    format!("{} {}", format_significant(time.si(), 5, language), SECOND.symbol)
}

/// Formats a time with all digits of the file.
fn stamp(stamp: Stamp, language: Language) -> String {
    let number = stamp.value.to_string().replace('.', pick(language, ".", ","));
    with_symbol(&number, stamp.unit.symbol_in(language))
}

/// Returns the quantity in a column of a recording.
#[must_use]
pub fn role_text(role: Role, language: Language) -> String {
    match role {
        Role::Time => said!(language => "time" | "Zeit"),
        Role::Position => said!(language => "position" | "Position"),
        Role::Speed => said!(language => "speed" | "Geschwindigkeit"),
        Role::Torque => said!(language => "torque or force" | "Drehmoment oder Kraft"),
    }
}

fn known_by(by: KnownBy, language: Language) -> String {
    match by {
        KnownBy::Header => said!(language => "in the header" | "in der Kopfzeile"),
        KnownBy::UnitRow => said!(language => "in the row of units" | "in der Einheitenzeile"),
        KnownBy::Metadata => said!(language => "in the metadata" | "in den Metadaten"),
        KnownBy::Values => said!(language => "in the values" | "in den Werten"),
        KnownBy::Layout => said!(language => "in the project file" | "in der Projektdatei"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use recording::{Layout, read_csv};

    fn sentences(text: &str, language: Language) -> Vec<String> {
        let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
        faults.iter().map(|found| fault(found, language).0).collect()
    }

    #[test]
    fn faults_name_their_line_in_both_languages() {
        let text = "t [s];q [deg]\n0;1,5\n1;x\n0,5;2\n";
        assert_eq!(
            sentences(text, Language::En),
            ["line 3: the value of \"q [deg]\" is not a number", "line 4: time runs backwards, 0.5 s follows 1 s",]
        );
        assert_eq!(
            sentences(text, Language::De),
            [
                "Zeile 3: der Wert von „q [deg]“ ist keine Zahl",
                "Zeile 4: die Zeit läuft rückwärts, 0,5 s folgt auf 1 s",
            ]
        );
    }

    #[test]
    fn only_a_guess_is_reported() {
        let sentences = |encoding| encoding_guess(Some(encoding), Language::En);
        assert_eq!((sentences(Encoding::Utf8), sentences(Encoding::Utf16)), (None, None));
        assert_eq!(sentences(Encoding::Windows1252Guessed).as_deref(), Some("text read as Windows-1252 (assumed)"));
        assert!(sentences(Encoding::Utf16Guessed).is_some());
    }

    #[test]
    fn a_gap_says_how_to_go_on() {
        let text = "t [ms],q [deg]\n0,0\n1,0\n2,0\n3,0\n14.5,0\n";
        let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
        let (message, hint) = fault(&faults[0], Language::En);
        assert_eq!(
            message,
            "line 6: a gap of 0.011500 s before this sample, more than 10 times the median interval of 0.0010000 s"
        );
        assert!(hint.unwrap().contains("gaps = \"allow\""));
    }

    #[test]
    fn units_are_asked_for_and_corrected() {
        let faults = read_csv("t,q [arcmim],n [deg]\n0,1,2\n".as_bytes(), &Layout::default()).unwrap_err();
        let said: Vec<(String, Option<String>)> = faults.iter().map(|found| fault(found, Language::De)).collect();
        assert_eq!(said[0].0, "die Einheit von „t“ fehlt");
        assert!(said[0].1.as_ref().unwrap().contains("t [s]"));
        assert_eq!(said[1].1.as_deref(), Some("ist „arcmin“ gemeint?"));
        assert_eq!(
            said[2].0,
            "„deg“ ist eine Einheit für Winkel, „n [deg]“ wird als Geschwindigkeit gelesen (in der Kopfzeile)"
        );
        let (message, hint) = fault(&faults[2], Language::En);
        assert_eq!(message, "\"deg\" is a unit of angle, \"n [deg]\" is read as speed (in the header)");
        assert!(hint.unwrap().starts_with("expected a rotational speed (1/min, rad/s,"));
    }
}
