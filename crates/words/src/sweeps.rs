//! Words about sweeps: many axes in a table.

use crate::texts::texts;

texts! {
    written(file, rows) = "{file}: {rows} rows" | "{file}: {rows} Zeilen";
    fitting(rows, share) = "an actuator fits: {rows} rows ({share} %)" | "ein Antrieb passt: {rows} Zeilen ({share} %)";
    none_fits(rows, share) = "none fits: {rows} rows ({share} %)" | "keiner passt: {rows} Zeilen ({share} %)";
    not_judged(rows, share) = "not judged: {rows} rows ({share} %)" | "nicht beurteilt: {rows} Zeilen ({share} %)";
    tightest = "tightest check of the nearest miss" | "engster Nachweis des nächstbesten Antriebs";
    no_class = "no actuator of the required class" | "kein Antrieb der geforderten Klasse";
    reason = "reason" | "Grund";
    row(row) = "row {row}" | "Zeile {row}";
    further = "further reasons" | "weitere Gründe";
    keys(keys) = "columns: {keys}" | "Spalten: {keys}";
    resumed(parts, rows) =
        "{parts} parts with {rows} rows of an interrupted run are kept"
        | "{parts} Teile mit {rows} Zeilen eines unterbrochenen Laufs werden übernommen";
    begun_anew =
        "the parts of an interrupted run belong to another project, table or version and are removed"
        | "die Teile eines unterbrochenen Laufs gehören zu einem anderen Projekt, einer anderen Tabelle oder Version und werden entfernt";
    ending_of_a_table =
        "the ending of a table is .csv or .parquet" | "die Endung einer Tabelle ist .csv oder .parquet";
    unreadable(file, why) = "{file}: not readable as a table: {why}" | "{file}: als Tabelle nicht lesbar: {why}";
    ragged(line, found, expected) =
        "line {line} has {found} cells, the headings are {expected}"
        | "Zeile {line} hat {found} Zellen, die Überschriften sind {expected}";
    not_utf_8(line) = "line {line} is not UTF-8" | "Zeile {line} ist kein UTF-8";
    open_quote(line) =
        "line {line}: a quoted cell does not end in this line"
        | "Zeile {line}: eine Zelle in Anführungszeichen endet nicht in dieser Zeile";
    long_line(line, most) =
        "line {line} is longer than {most} bytes" | "Zeile {line} ist länger als {most} Byte";
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
        "write \"load.inertia [kg m^2] = 0.1..10\", \"… = 0.1..10 log\" or \"… = 0.1; 0.5; 2\""
        | "„load.inertia [kg m^2] = 0.1..10“, „… = 0.1..10 log“ oder „… = 0.1; 0.5; 2“ schreiben";
    no_sample_keys = "no key is stated" | "kein Schlüssel angegeben";
    log_needs_positive(key) =
        "`{key}`: a logarithmic range begins above zero" | "`{key}`: ein logarithmischer Bereich beginnt über null";
    too_many_dimensions(count, most) =
        "{count} keys with ranges; the Sobol sequence has {most} dimensions here"
        | "{count} Schlüssel mit Bereichen; die Sobol-Folge hat hier {most} Dimensionen";
}
