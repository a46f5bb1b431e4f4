//! Words for sweeps: many axes in a table.

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
    on_a_condition(check) = "{check}; fits on a condition" | "{check}; bedingt geeignet";
    fitting_if_estimate(rows, share) =
        "{rows} of them only if an estimate holds or the gear rating of another manufacturer does not apply ({share} %)"
        | "davon {rows} nur, sofern eine Schätzung zutrifft oder die Getriebegrenze eines anderen Herstellers nicht gilt ({share} %)";
    none_fits(rows, share) =
        "none fits: {rows} row ({share} %)" | "keiner ist geeignet: {rows} Zeile ({share} %)",
        "none fits: {rows} rows ({share} %)" | "keiner ist geeignet: {rows} Zeilen ({share} %)";
    not_judged(rows, share) =
        "not evaluated: {rows} row ({share} %)" | "nicht bewertet: {rows} Zeile ({share} %)",
        "not evaluated: {rows} rows ({share} %)" | "nicht bewertet: {rows} Zeilen ({share} %)";
    tightest = "governing check of the actuator with the smallest excess" | "maßgebender Nachweis des Antriebs mit der geringsten Überschreitung";
    no_class = "no actuator meets the requirements" | "kein Antrieb erfüllt die Anforderungen";
    reason = "reason" | "Grund";
    row(row) = "row {row}" | "Zeile {row}";
    further = "further reasons" | "weitere Gründe";
    keys(keys) = "columns: {keys}" | "Spalten: {keys}";
    columns_meant(columns, keys) =
        "columns that are not named as keys, {columns}, state: {keys}"
        | "nicht als Schlüssel benannte Spalten, {columns}, geben an: {keys}";
    resumed(parts, rows) =
        "{parts} part with {rows} rows of an interrupted run is kept"
        | "{parts} Teil mit {rows} Zeilen eines unterbrochenen Laufs wird übernommen",
        "{parts} parts with {rows} rows of an interrupted run are kept"
        | "{parts} Teile mit {rows} Zeilen eines unterbrochenen Laufs werden übernommen";
    begun_anew(parts, inputs) =
        "{parts} part of an interrupted run is discarded; different: {inputs}"
        | "{parts} Teil eines unterbrochenen Laufs wird verworfen; abweichend: {inputs}",
        "{parts} parts of an interrupted run are discarded; different: {inputs}"
        | "{parts} Teile eines unterbrochenen Laufs werden verworfen; abweichend: {inputs}";
    other_run(parts, folder, inputs) =
        "{folder} holds {parts} finished part of an interrupted run, which this call does not continue; different: {inputs}"
        | "{folder} enthält {parts} fertigen Teil eines unterbrochenen Laufs, den dieser Aufruf nicht fortsetzt; abweichend: {inputs}",
        "{folder} holds {parts} finished parts of an interrupted run, which this call does not continue; different: {inputs}"
        | "{folder} enthält {parts} fertige Teile eines unterbrochenen Laufs, den dieser Aufruf nicht fortsetzt; abweichend: {inputs}";
    other_run_hint =
        "continue that run with its own call, write to another file, or begin anew with --force, which removes its parts"
        | "jenen Lauf mit seinem Aufruf fortsetzen, in eine andere Datei schreiben oder mit --force neu beginnen, was seine Teile entfernt";
    of_program = "version of antrieb" | "Version von antrieb";
    of_catalogue = "catalogue" | "Katalog";
    of_project = "project" | "Projekt";
    of_table = "table" | "Tabelle";
    of_recordings = "recordings" | "Aufzeichnungen";
    parts_foreign(folder) =
        "{folder} exists and was not made by antrieb; it remains unchanged: move it, or write the answers to another file"
        | "{folder} ist schon vorhanden und nicht von antrieb angelegt; es bleibt unverändert: verschieben oder die Antworten in eine andere Datei schreiben";
    parts_foreign_file(file) =
        "{file}: in place of a part there is a link, a folder, a file of another user or one without its checksum; it remains unchanged"
        | "{file}: anstelle eines Teils steht hier eine Verknüpfung, ein Ordner, eine Datei eines anderen Benutzers oder eine ohne Prüfsumme; sie bleibt unverändert";
    parts_busy(folder) =
        "another sweep is writing to the same file; it uses {folder}"
        | "ein anderer Lauf schreibt gerade in dieselbe Datei; er benutzt {folder}";
    parts_changed =
        "the table or a recording was changed while the sweep ran: its parts are removed, the same call starts again"
        | "die Tabelle oder eine Aufzeichnung wurde während des Laufs geändert: die Teile werden entfernt, derselbe Aufruf beginnt von vorn";
    decimal_comma_of_csv =
        "only a text file (.csv) has decimal commas; a Parquet file has no decimal signs"
        | "nur eine Textdatei (.csv) hat Dezimalkommas; eine Parquet-Datei hat keine Dezimalzeichen";
    ending_of_a_table =
        "the file name of the results must end in .csv, .csv.gz or .parquet"
        | "der Dateiname der Ergebnisse muss auf .csv, .csv.gz oder .parquet enden";
    parquet_elsewhere =
        "a Parquet table is read by `antrieb sweep` of the command line and in Python only"
        | "eine Parquet-Tabelle lesen nur `antrieb sweep` auf der Befehlszeile und Python";
    unreadable(file, why) = "{file}: not readable as a table: {why}" | "{file}: als Tabelle nicht lesbar: {why}";
    rest_unchecked(faults) =
        "{faults}; the rest of the table was not checked"
        | "{faults}; der Rest der Tabelle wurde nicht geprüft";
    headings_refused =
        "the table was not checked to its end, because its headings are faulty"
        | "wegen der fehlerhaften Überschriften wurde die Tabelle nicht bis zum Ende geprüft";
    too_many_rows(rows, most) =
        "the table has {rows} rows; at most {most} are evaluated here, more with `antrieb sweep`"
        | "die Tabelle hat {rows} Zeilen; hier werden höchstens {most} bewertet, mehr mit `antrieb sweep`";
    answers_too_large(rows, memory, most) =
        "the table has {rows} rows, whose answers exceed the permitted memory of {memory} MiB: raise the limit (memory, such as 2 GiB), or pass at most {most} rows at a time to Sweep.batch"
        | "die Tabelle hat {rows} Zeilen, deren Antworten den zulässigen Speicher von {memory} MiB überschreiten: Grenze erhöhen (memory, etwa 2 GiB) oder höchstens {most} Zeilen auf einmal an Sweep.batch übergeben";
    column_of_the_answer(name) =
        "the answer has a column `{name}` already" | "die Antwort hat schon eine Spalte `{name}`";
    rename_it = "rename the column of the table" | "die Spalte der Tabelle umbenennen";
    as_a_label(name) = "as a label call the column \"{name}\"" | "als Beschriftung heißt die Spalte „{name}“";
    carried(names) = "carried into the answer: {names}" | "in die Antwort übernommen: {names}";
    rows_done(done, all, rate, left) =
        "{done} of {all} rows · {rate} rows/s · {left} left" | "{done} von {all} Zeilen · {rate} Zeilen/s · noch {left}";
    rows_read(rows) =
        "{rows} rows of the table read" | "{rows} Zeilen der Tabelle gelesen";
    rows_begun(done, all) = "{done} of {all} rows" | "{done} von {all} Zeilen";
    kept(folder) =
        "completed parts are kept in {folder}; the same call continues from them"
        | "fertige Teile bleiben in {folder}; derselbe Aufruf setzt mit ihnen fort";
    interrupted(rows, all, folder) =
        "interrupted: the answers of {rows} of {all} rows are kept in {folder}; the same call continues from them"
        | "abgebrochen: die Antworten von {rows} von {all} Zeilen bleiben in {folder}; derselbe Aufruf setzt mit ihnen fort";
    interrupted_early(part) =
        "interrupted before the first part of {part} rows was complete: the same call starts again"
        | "abgebrochen, bevor der erste Teil von {part} Zeilen fertig war: derselbe Aufruf beginnt von vorn";
    too_many_samples(count, most) =
        "{count} rows; at most {most} are written" | "{count} Zeilen; geschrieben werden höchstens {most}";
    sample_key(written) =
        "\"{written}\" is not a key with values" | "„{written}“ ist kein Schlüssel mit Werten";
    sample_key_hint =
        "write \"motion[1].time [s] = 1..3\", \"… = 1..9:2\", \"… = 1..3 log\" or \"… = 1; 2; 3\""
        | "„motion[1].time [s] = 1..3“, „… = 1..9:2“, „… = 1..3 log“ oder „… = 1; 2; 3“ schreiben";
    step_misses(range, step) =
        "\"{range}\": steps of {step} do not meet the end of the range"
        | "„{range}“: Schritte von {step} treffen das Ende des Bereichs nicht";
    steps_that_meet(steps) =
        "steps that meet it: {steps}" | "Schritte, die es treffen: {steps}";
    step_too_small(range, step, most) =
        "\"{range}\": a step is a number above zero, with at most {most} values in the range; \"{step}\" is none"
        | "„{range}“: ein Schritt ist eine Zahl über null mit höchstens {most} Werten im Bereich, „{step}“ nicht";
    step_of_log(range) =
        "\"{range}\": a range of equal ratios has no step, --steps states the number of its values"
        | "„{range}“: ein Bereich gleicher Verhältnisse hat keinen Schritt, --steps nennt die Anzahl seiner Werte";
    step_of_another_quantity(step, range) =
        "the step {step} has another quantity than the range \"{range}\""
        | "der Schritt {step} hat eine andere Größe als der Bereich „{range}“";
    vary_form(written) =
        "\"{written}\" is not a key with values" | "„{written}“ ist kein Schlüssel mit Werten";
    vary_form_hint =
        "write payload=0,5,10kg, time=1..3s or payload=0:10:2kg, `time=1..8 s log` for equal ratios"
        | "payload=0;5;10kg, time=1..3s oder payload=0:10:2kg schreiben, `time=1..8 s log` für gleiche Verhältnisse";
    no_entry(path, count) =
        "`{path}`: the project has no such entry, its list has {count}"
        | "`{path}`: diesen Eintrag hat das Projekt nicht, die Liste hat {count}";
    vary_no_cycle(key) =
        "`{key}`: no dwell of the project states the cycle"
        | "„{key}“: keine Rast des Projekts nennt den Zyklus";
    vary_replaces(key) =
        "`{key}` is not stated by the moves: it replaces another of their values first"
        | "„{key}“ steht nicht in den Bewegungen: es ersetzt zuerst eine andere Angabe";
    vary_unit(key) = "`{key}`: the values have no unit" | "`{key}`: die Werte haben keine Einheit";
    vary_commas(written) =
        "\"{written}\" is ambiguous: commas separate values or are decimal signs"
        | "„{written}“ ist mehrdeutig: Kommas trennen Werte oder sind Dezimalzeichen";
    shown_rows(shown, all) =
        "{shown} of {all} rows are shown; --json and --out have all of them"
        | "{shown} von {all} Zeilen angezeigt; --json und --out enthalten alle";
    no_sample_keys = "no key is stated" | "kein Schlüssel angegeben";
    front_or_checks =
        "`front` and `check` exclude each other; state one of them"
        | "`front` und `check` schließen sich aus; nur eines davon angeben";
    log_needs_positive(key) =
        "`{key}`: a logarithmic range must begin above zero" | "`{key}`: ein logarithmischer Bereich muss über null beginnen";
    too_many_dimensions(count, most) =
        "{count} keys with ranges; the Sobol sequence has {most} dimensions here"
        | "{count} Schlüssel mit Bereichen; die Sobol-Folge hat hier {most} Dimensionen";
}

/// Returns the sentence about a line with more or fewer cells than there are headings.
fn ragged(line: u64, found: usize, expected: usize, language: Language) -> String {
    let cells = pick(language, ("cell", "cells"), ("Zelle", "Zellen"));
    let cells = if found == 1 { cells.0 } else { cells.1 };
    match expected {
        1 => said!(language =>
            "line {line} has {found} {cells}, but there is 1 heading"
            | "Zeile {line} hat {found} {cells}, es gibt jedoch nur 1 Überschrift"
        ),
        _ => said!(language =>
            "line {line} has {found} {cells}, but there are {expected} headings"
            | "Zeile {line} hat {found} {cells}, es gibt jedoch {expected} Überschriften"
        ),
    }
}

/// Returns what to do about a fault of a table, where it does not follow from its sentence.
pub(crate) fn hint(fault: &TabularFault, language: Language) -> Option<String> {
    match fault {
        TabularFault::NoHeading { .. } => Some(said!(language =>
            "name it by a key of the project with its unit, or leave it out; in pandas: to_csv(…, index=False)"
            | "mit einem Schlüssel des Projekts und der Einheit benennen oder weglassen; in pandas: to_csv(…, index=False)"
        )),
        TabularFault::CommasTwice { .. } => Some(said!(language =>
            "export with ; or tabs between the cells, with decimal points, or with the numbers in quotes"
            | "mit ; oder Tabulatoren zwischen den Zellen, mit Dezimalpunkten oder mit den Zahlen in Anführungszeichen ausgeben"
        )),
        TabularFault::NotANumber { written, .. } if recording::is_grouped(written) => Some(said!(language =>
            "write numbers without separators of thousands" | "Zahlen ohne Tausendertrennzeichen schreiben"
        )),
        TabularFault::UnitOfCell { .. } => Some(said!(language =>
            "state all numbers of a column in one unit" | "alle Zahlen einer Spalte in einer Einheit angeben"
        )),
        _ => None,
    }
}

/// Returns the fault of a table whose columns are keys, in one sentence.
pub(crate) fn fault(fault: &TabularFault, language: Language) -> String {
    match fault {
        TabularFault::NoColumn { path } => said!(language =>
            "`{path}` cannot be a column: its values do not fit in a cell"
            | "`{path}` kann keine Spalte sein: die Werte passen nicht in eine Zelle"
        ),
        TabularFault::UnitOfNoQuantity { path, unit } => said!(language =>
            "`{path}` has no unit, but the heading states \"{unit}\""
            | "`{path}` hat keine Einheit, die Überschrift nennt jedoch „{unit}“"
        ),
        TabularFault::CountsFromZero { path } => said!(language =>
            "`{path}`: the headings count the entries of a list from zero, the first entry is [1]"
            | "`{path}`: die Überschriften zählen die Einträge einer Liste ab null, der erste Eintrag ist [1]"
        ),
        TabularFault::NoHeading { number } => {
            said!(language => "column {number} has no heading" | "Spalte {number} hat keine Überschrift")
        }
        TabularFault::ColumnTwice { path } => {
            said!(language => "two columns state the key `{path}`" | "zwei Spalten nennen den Schlüssel `{path}`")
        }
        TabularFault::NoEntry { path, count } => no_entry(path, count, language),
        TabularFault::NoCycle { path } => said!(language =>
            "`{path}`: no dwell of the project states `cycle`; write it in the last dwell in place of `time`, or add a dwell with it"
            | "`{path}`: keine Rast des Projekts nennt `cycle`; in der letzten Rast statt `time` angeben oder eine Rast damit anfügen"
        ),
        TabularFault::NoValue { path } => {
            said!(language => "`{path}`: the cell is empty" | "`{path}`: die Zelle ist leer")
        }
        TabularFault::NotANumber { path, written } => {
            said!(language => "`{path}`: \"{written}\" is not a number" | "`{path}`: „{written}“ ist keine Zahl")
        }
        TabularFault::UnitOfCell { path, written, unit } => {
            let unit = unit.ascii;
            if recording::with_unit(written).is_some() {
                return said!(language =>
                    "`{path}`: \"{written}\" has another unit than its column, {unit}"
                    | "`{path}`: „{written}“ hat eine andere Einheit als die Spalte, {unit}"
                );
            }
            said!(language =>
                "`{path}`: \"{written}\" has no unit, unlike the cells above in {unit}"
                | "`{path}`: „{written}“ hat keine Einheit, anders als die Zellen darüber in {unit}"
            )
        }
        TabularFault::NoText { path, written } => said!(language =>
            "`{path}`: a word is expected instead of the number {written}"
            | "`{path}`: statt der Zahl {written} wird ein Wort erwartet"
        ),
        TabularFault::CellType { path, found } => said!(language =>
            "`{path}`: a column of the type {found} is not read; its cells must be numbers or texts"
            | "`{path}`: eine Spalte vom Typ {found} wird nicht gelesen; ihre Zellen müssen Zahlen oder Texte sein"
        ),
        TabularFault::Ragged { line, found, expected } => ragged(*line, *found, *expected, language),
        TabularFault::CommasTwice { line, found, expected } => said!(language =>
            "{}: commas separate the cells and are decimal signs as well"
            | "{}: Kommas trennen die Zellen und sind zugleich Dezimalzeichen", ragged(*line, *found, *expected, language)
        ),
        TabularFault::OpenQuote { line } => said!(language =>
            "line {line}: a quoted cell does not end in this line"
            | "Zeile {line}: eine Zelle in Anführungszeichen endet nicht in dieser Zeile"
        ),
        TabularFault::DecimalMixed { path, written, has_comma: true } => said!(language =>
            "`{path}`: \"{written}\" has a decimal comma, numbers before it have a decimal point"
            | "`{path}`: „{written}“ hat ein Dezimalkomma, Zahlen davor haben einen Dezimalpunkt"
        ),
        TabularFault::DecimalMixed { path, written, has_comma: false } => said!(language =>
            "`{path}`: \"{written}\" has a decimal point, numbers before it have a decimal comma"
            | "`{path}`: „{written}“ hat einen Dezimalpunkt, Zahlen davor haben ein Dezimalkomma"
        ),
        TabularFault::ThousandsPossible { path, written } => {
            let (whole, decimal) = (written.replace(['.', ','], ""), format!("{written}0"));
            said!(language =>
                "`{path}`: \"{written}\" is ambiguous, with a thousands separator or a decimal separator; write {whole} or {decimal}"
                | "`{path}`: „{written}“ ist mehrdeutig, mit Tausender- oder Dezimaltrennzeichen; {whole} oder {decimal} schreiben"
            )
        }
        TabularFault::LongLine { line, most } => said!(language =>
            "line {line} is longer than {most} bytes" | "Zeile {line} ist länger als {most} Byte"
        ),
        TabularFault::NoRows => said!(language => "the table has no rows" | "die Tabelle hat keine Zeilen"),
        TabularFault::NoColumns => said!(language => "the table has no columns" | "die Tabelle hat keine Spalten"),
    }
}
