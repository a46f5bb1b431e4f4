//! Words about sweeps: many axes in a table.

use crate::pick;
use crate::texts::{said, texts};
use project::TabularFault;
use quantities::Language;

texts! {
    written(rows, file) =
        "{file}: {rows} row" | "{file}: {rows} Zeile",
        "{file}: {rows} rows" | "{file}: {rows} Zeilen";
    fitting(rows, share) =
        "an actuator fits: {rows} row ({share} %)" | "ein Antrieb ist geeignet: {rows} Zeile ({share} %)",
        "an actuator fits: {rows} rows ({share} %)" | "ein Antrieb ist geeignet: {rows} Zeilen ({share} %)";
    none_fits(rows, share) =
        "none fits: {rows} row ({share} %)" | "keiner ist geeignet: {rows} Zeile ({share} %)",
        "none fits: {rows} rows ({share} %)" | "keiner ist geeignet: {rows} Zeilen ({share} %)";
    not_judged(rows, share) =
        "not judged: {rows} row ({share} %)" | "nicht beurteilt: {rows} Zeile ({share} %)",
        "not judged: {rows} rows ({share} %)" | "nicht beurteilt: {rows} Zeilen ({share} %)";
    tightest = "tightest check of the nearest miss" | "engster Nachweis des nächstbesten Antriebs";
    no_class = "no actuator of the required class" | "kein Antrieb der geforderten Klasse";
    reason = "reason" | "Grund";
    row(row) = "row {row}" | "Zeile {row}";
    further = "further reasons" | "weitere Gründe";
    keys(keys) = "columns: {keys}" | "Spalten: {keys}";
    resumed(parts, rows) =
        "{parts} part with {rows} rows of an interrupted run is kept"
        | "{parts} Teil mit {rows} Zeilen eines unterbrochenen Laufs wird übernommen",
        "{parts} parts with {rows} rows of an interrupted run are kept"
        | "{parts} Teile mit {rows} Zeilen eines unterbrochenen Laufs werden übernommen";
    begun_anew =
        "the parts of an interrupted run belong to another project, table or version and are removed"
        | "die Teile eines unterbrochenen Laufs gehören zu einem anderen Projekt, einer anderen Tabelle oder Version und werden entfernt";
    ending_of_a_table =
        "the ending of a table is .csv or .parquet" | "die Endung einer Tabelle ist .csv oder .parquet";
    unreadable(file, why) = "{file}: not readable as a table: {why}" | "{file}: als Tabelle nicht lesbar: {why}";
    too_many_rows(rows, most) =
        "the table has {rows} rows; {most} are judged here at most, more by `antrieb sweep`"
        | "die Tabelle hat {rows} Zeilen; hier werden höchstens {most} beurteilt, mehr mit `antrieb sweep`";
    kept(folder) =
        "finished parts are kept in {folder}; the same call continues with them"
        | "fertige Teile bleiben in {folder}; derselbe Aufruf setzt mit ihnen fort";
    too_many_samples(count, most) =
        "{count} rows; at most {most} are written" | "{count} Zeilen; geschrieben werden höchstens {most}";
    sample_key(written) =
        "\"{written}\" is no key with its values" | "„{written}“ ist kein Schlüssel mit seinen Werten";
    sample_key_hint =
        "write \"motion[0].time [s] = 1..3\", \"… = 1..3 log\" or \"… = 1; 2; 3\""
        | "„motion[0].time [s] = 1..3“, „… = 1..3 log“ oder „… = 1; 2; 3“ schreiben";
    no_sample_keys = "no key is stated" | "kein Schlüssel angegeben";
    log_needs_positive(key) =
        "`{key}`: a logarithmic range begins above zero" | "`{key}`: ein logarithmischer Bereich beginnt über null";
    too_many_dimensions(count, most) =
        "{count} keys with ranges; the Sobol sequence has {most} dimensions here"
        | "{count} Schlüssel mit Bereichen; die Sobol-Folge hat hier {most} Dimensionen";
}

/// What is wrong with a table whose columns are keys, in one sentence.
pub(crate) fn fault(fault: &TabularFault, language: Language) -> String {
    match fault {
        TabularFault::NoColumn { path } => said!(language =>
            "`{path}` cannot be a column: its values do not stand in a cell"
            | "`{path}` kann keine Spalte sein: die Werte passen nicht in eine Zelle"
        ),
        TabularFault::UnitOfNoQuantity { path, unit } => said!(language =>
            "`{path}` is measured in no unit, the heading states \"{unit}\""
            | "`{path}` hat keine Einheit, die Überschrift nennt „{unit}“"
        ),
        TabularFault::ColumnTwice { path } => {
            said!(language => "two columns have the key `{path}`" | "zwei Spalten haben den Schlüssel `{path}`")
        }
        TabularFault::NoEntry { path, count } => said!(language =>
            "`{path}`: the project has no such entry, its list has {count}"
            | "`{path}`: diesen Eintrag hat das Projekt nicht, die Liste hat {count}"
        ),
        TabularFault::NoValue { path } => {
            said!(language => "`{path}`: the cell is empty" | "`{path}`: die Zelle ist leer")
        }
        TabularFault::NotANumber { path, written } => {
            said!(language => "`{path}`: \"{written}\" is not a number" | "`{path}`: „{written}“ ist keine Zahl")
        }
        TabularFault::NoText { path, written } => said!(language =>
            "`{path}`: the number {written} stands where a word belongs"
            | "`{path}`: die Zahl {written} steht, wo ein Wort stehen muss"
        ),
        TabularFault::CellType { path, found } => said!(language =>
            "`{path}`: a column of the type {found} is not read; its cells must be numbers or texts"
            | "`{path}`: eine Spalte vom Typ {found} wird nicht gelesen; ihre Zellen müssen Zahlen oder Texte sein"
        ),
        TabularFault::Ragged { line, found, expected } => {
            let cells = pick(language, ("cell", "cells"), ("Zelle", "Zellen"));
            let cells = if *found == 1 { cells.0 } else { cells.1 };
            said!(language =>
                "line {line} has {found} {cells}, the headings are {expected}"
                | "Zeile {line} hat {found} {cells}, die Überschriften sind {expected}"
            )
        }
        TabularFault::OpenQuote { line } => said!(language =>
            "line {line}: a quoted cell does not end in this line"
            | "Zeile {line}: eine Zelle in Anführungszeichen endet nicht in dieser Zeile"
        ),
        TabularFault::NotUtf8 { line } => said!(language => "line {line} is not UTF-8" | "Zeile {line} ist kein UTF-8"),
        TabularFault::LongLine { line, most } => said!(language =>
            "line {line} is longer than {most} bytes" | "Zeile {line} ist länger als {most} Byte"
        ),
        TabularFault::NoRows => said!(language => "the table has no row" | "die Tabelle hat keine Zeile"),
        TabularFault::NoColumns => said!(language => "the table has no column" | "die Tabelle hat keine Spalte"),
    }
}
