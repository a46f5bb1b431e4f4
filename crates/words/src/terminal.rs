//! What the command line answers, besides the answers proper.

use crate::texts::texts;

texts! {
    battery(life, grade) =
        "battery of the encoder: {life} a in use ({grade}, model battery)"
        | "Batterie des Gebers: {life} a im Betrieb ({grade}, Modell Batterie)";
    battery_exchange(recommended, latest) =
        "exchange of the encoder: recommended after {recommended} a, at the latest {latest} a after delivery"
        | "Tausch des Gebers: empfohlen nach {recommended} a, spätestens {latest} a nach Lieferung";
    recording_not_written(recording, kind) =
        "{recording} is not written to standard output; `antrieb new {kind} --out FILE` writes both"
        | "{recording} geht nicht auf die Standardausgabe; `antrieb new {kind} --out DATEI` schreibt beide";
    nearest_valid_codes = "nearest valid codes" | "nächste gültige Codes";
    code = "code" | "Code";
    understood_as(code) = "understood as {code}" | "verstanden als {code}";
    first_in_the_ranking = "first in the ranking" | "erster in der Reihenfolge";
    lowest_utilisation = "lowest utilisation" | "geringste Auslastung";
    figure = "figure" | "Größe";
    two_to_five_codes(count) =
        "two to five codes can be compared, not {count}: give --code once for each"
        | "zwei bis fünf Codes lassen sich vergleichen, nicht {count}: --code für jeden einmal angeben";
    table = "table" | "Tabelle";
    note = "note" | "Hinweis";
    errata_of_this_table = "errata of this table" | "Druckfehler dieser Tabelle";
    see = "see" | "siehe";
    value_of_the_standard(value) = "not printed (standard {value})" | "nicht abgedruckt (Standard {value})";
    value_and_print(value, printed) = "{value} (printed {printed})" | "{value} (im Druck {printed})";
    torsion(code, angle, radian, torque, region) =
        "{code}: {angle} arcmin ({radian} mrad) under {torque} Nm, stiffness region {region}"
        | "{code}: {angle} arcmin ({radian} mrad) unter {torque} Nm, Steifigkeitsbereich {region}";
    torsion_curve(t1, t2, k1, k2, k3, table) =
        "T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (table {table}); mean values, blocked motor"
        | "T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (Tabelle {table}); Mittelwerte, Motor blockiert";
    torque_or_angle =
        "one of torque and angle is needed; the other follows from it"
        | "eines von torque und angle ist nötig; das andere folgt daraus";
    most_lost(name, angle, source) = "{name}: at most {angle} arcmin ({source})" | "{name}: höchstens {angle} arcmin ({source})";
    no_common_axis =
        "the two projects have no axis of the same name"
        | "die beiden Projekte haben keine Achse gleichen Namens";
    none_fits = "none fits" | "keiner ist geeignet";
    best_of_the_catalogue = "best of the catalogue" | "bester des Katalogs";
    as_before = "as before" | "wie vorher";
    no_input_changed = "no input changed" | "keine Eingabe geändert";
    input = "input" | "Eingabe";
    before = "before" | "vorher";
    after = "after" | "nachher";
    same_demand = "the demand is the same" | "der Bedarf ist derselbe";
    change = "change" | "Änderung";
    unchanged = "unchanged" | "unverändert";
    axis_is_only_in(name, file) = "axis \"{name}\" is only in {file}" | "Achse „{name}“ gibt es nur in {file}";
    no_erratum = "no erratum" | "kein Druckfehler";
    as_printed = "as printed" | "wie im Druck";
    checks = "checks" | "Nachweise";
    to_state = "to be stated" | "anzugeben";
    see_above = "see above" | "siehe oben";
    rows = "rows" | "Zeilen";
    export_is_of_one_axis(names) =
        "an export is of one axis; choose one with --axis: {names}"
        | "ein Export gilt einer Achse; eine mit --axis wählen: {names}";
    error = "error" | "Fehler";
    help = "help" | "Hilfe";
    file_too_large(project_max_bytes) =
        "the file is larger than {project_max_bytes} bytes; a project file is text of a few kilobytes"
        | "die Datei ist größer als {project_max_bytes} Byte; eine Projektdatei ist Text von wenigen Kilobyte";
    not_utf_8(line) = "line {line}: not UTF-8 text" | "Zeile {line}: kein UTF-8-Text";
    in_derivations = "in derivations" | "in Herleitungen";
    nothing_in_the_glossary(wanted) =
        "the glossary has nothing about `{wanted}`"
        | "das Glossar enthält nichts zu „{wanted}“";
    no_such_unit(wanted) =
        "`{wanted}` is neither a quantity nor a unit"
        | "„{wanted}“ ist weder eine Größe noch eine Einheit";
    also_written = "also written" | "auch geschrieben";
    in_si = "in SI";
    no_actuator_fits = "no actuator of the catalogue fits" | "kein Antrieb des Katalogs ist geeignet";
    ratio_of_the_stage = "ratio of the stage" | "Übersetzung der Stufe";
    own_actuator_of_the_project = "own actuator of the project" | "eigener Antrieb des Projekts";
    ordering_rule = "ordering rule" | "Bestellregel";
    all_shows_each = "--all shows each with its reason" | "--all zeigt jeden mit Grund";
    nearest_miss = "nearest miss" | "knapp daneben";
    kept_out_by_limits = "kept out by limits of the project alone" | "nur an Grenzen des Projekts gescheitert";
    requirement_not_checked = "requirement not checked" | "Anforderung nicht geprüft";
    more_fit(more) =
        "{more} more fit; --top N or --all shows them"
        | "{more} weitere sind geeignet; --top N oder --all zeigt sie";
    demand_on(id) = "demand on {id}" | "Bedarf an {id}";
    more_segments(more) = "{more} more; --json has them all" | "{more} weitere; --json hat alle";
    outside_the_window(left) = "{left} outside the window" | "{left} außerhalb des Fensters";
    built_without_report =
        "this antrieb was built without the typesetting engine and writes no report; `cargo install --path crates/cli` builds it with the report"
        | "dieses antrieb ist ohne Satzsystem gebaut und schreibt keinen Bericht; `cargo install --path crates/cli` baut es mit Bericht";
    cargo_builds_the_report =
        "the report needs the typesetting engine: cargo runs the program that includes it; the first build takes some minutes"
        | "der Bericht braucht das Satzsystem: cargo startet das Programm, das es enthält; der erste Bau dauert einige Minuten";
    png_needs_a_file =
        "--png needs a file: pixels do not go to standard output"
        | "--png braucht eine Datei: Pixel gehen nicht auf die Standardausgabe";
    picture_too_large = "the picture is too large for pixels" | "das Bild ist zu groß für Pixel";
    several_axes(names) =
        "the project has several axes; name one with --axis: {names}"
        | "das Projekt hat mehrere Achsen; eine mit --axis nennen: {names}";
    sides_of_a_picture(least, most) =
        "a picture has sides of {least} mm to {most} mm"
        | "ein Bild hat Seiten von {least} mm bis {most} mm";
    report_is_a_pdf(display) =
        "a report is a PDF: name a file that ends in .pdf, not {display}"
        | "ein Bericht ist ein PDF: eine Datei mit der Endung .pdf nennen, nicht {display}";
    code_is_for_one_axis(names) =
        "--code is for one axis, and the project has several; name it with --axis: {names}"
        | "--code gilt für eine Achse, und das Projekt hat mehrere; sie mit --axis nennen: {names}";
    fits_up_to = "fits up to, one at a time" | "geeignet bis zu, je für sich";
    checks_pass_up_to = "all checks pass up to, one at a time" | "alle Nachweise sind erfüllt bis zu, je für sich";
    would_fit_with_other_gearing = "would fit with another gearing, one of" | "wäre geeignet mit anderer Übersetzung, einer von";
    a_stage(ratio) = "a stage of ratio {ratio}" | "eine Stufe mit der Übersetzung {ratio}";
    would_fit_with_one_of = "would fit with one of" | "wäre geeignet mit einem von";
    checks_would_pass_with_one_of = "all checks would pass with one of" | "alle Nachweise wären erfüllt mit einem von";
    would_fit_with_this_asked_for = "would fit if only this were required" | "wäre geeignet, wenn nur dies gefordert wäre";
    not_sought = "not sought" | "nicht gesucht";
    load_and_pace_not_sought(samples, most) =
        "other loads and other cycle times; each step of that search would find the load of {samples} samples anew, and of more than {most} only where --deadline of check, size or report says how long it may take"
        | "andere Lasten und andere Zykluszeiten; jeder Schritt dieser Suche müsste die Last von {samples} Abtastwerten neu bestimmen, und von mehr als {most} nur, wo --deadline bei check, size oder report sagt, wie lange es dauern darf";
    load_not_sought(samples, most) =
        "other loads; each step of that search would find the load of {samples} samples anew, and of more than {most} only where --deadline of check, size or report says how long it may take"
        | "andere Lasten; jeder Schritt dieser Suche müsste die Last von {samples} Abtastwerten neu bestimmen, und von mehr als {most} nur, wo --deadline bei check, size oder report sagt, wie lange es dauern darf";
    payload_factor(factor) = "payload × {factor}" | "Nutzlast × {factor}";
    load_factor(factor) = "all masses and inertias × {factor}" | "alle Massen und Trägheiten × {factor}";
    cycle_time(time) = "cycle of {time} s" | "Zyklus von {time} s";
    ambient(ambient) = "ambient {ambient} °C" | "Umgebung {ambient} °C";
    no_own_actuator =
        "the project has no [actuator]; name one of the catalogue with --code"
        | "das Projekt hat keinen [actuator]; einen aus dem Katalog mit --code nennen";
    no_data =
        "the manual prints no data for this code: it is on request only"
        | "für diesen Code druckt die Anleitung keine Daten: er ist nur auf Anfrage lieferbar";
    no_such_axis(wanted, join) =
        "the project has no axis \"{wanted}\"; it has: {join}"
        | "das Projekt hat keine Achse „{wanted}“; es hat: {join}";
    check_not_asked(title) =
        "{title}: this check is not part of this axis and actuator"
        | "{title}: dieser Nachweis gehört nicht zu dieser Achse und diesem Antrieb";
    too_many_samples(asked, most) =
        "{asked} samples of these tolerances take more than some ten seconds; at most {most} are judged by default: state fewer with --samples, or how long the answer may take with --deadline"
        | "{asked} Stichproben dieser Toleranzen dauern länger als etwa zehn Sekunden; ohne Angabe werden höchstens {most} beurteilt: mit --samples weniger angeben, oder mit --deadline, wie lange die Antwort dauern darf";
    too_long(samples, most, seconds) =
        "{samples} samples of recordings take more than some {seconds} seconds; by default at most {most} are read, half as many under a load that hangs on the position or has losses: state how long the answer may take with --deadline, or use fewer with from and to"
        | "{samples} Abtastwerte von Aufzeichnungen dauern länger als etwa {seconds} Sekunden; ohne Angabe werden höchstens {most} gelesen, halb so viele unter einer Last, die von der Stellung abhängt oder Verluste hat: mit --deadline angeben, wie lange die Antwort dauern darf, oder mit from und to weniger verwenden";
    too_many_axes(axes, seconds) =
        "{axes} axes take together more than some {seconds} seconds: name one with --axis, or state how long the answer may take with --deadline"
        | "{axes} Achsen dauern zusammen länger als etwa {seconds} Sekunden: mit --axis eine nennen oder mit --deadline angeben, wie lange die Antwort dauern darf";
    too_many_ratios(ratios, seconds) =
        "to judge the catalogue for each of {ratios} ratios of the stage takes more than some {seconds} seconds: state fewer in stage.ratios, or how long the answer may take with --deadline"
        | "den Katalog für jede von {ratios} Übersetzungen der Zwischenstufe zu beurteilen, dauert länger als etwa {seconds} Sekunden: in stage.ratios weniger angeben oder mit --deadline, wie lange die Antwort dauern darf";
    too_many_rows(rows, needed, most) =
        "the table of the course has up to {rows} rows, which take {needed} MiB; {most} MiB are allowed: allow more with --memory, or use fewer samples with from and to"
        | "die Tabelle des Verlaufs hat bis zu {rows} Zeilen, die {needed} MiB belegen; erlaubt sind {most} MiB: mit --memory mehr erlauben oder mit from und to weniger Abtastwerte verwenden";
    not_in_time(most) =
        "not answered within {most} s; allow more with --deadline, or reduce the work: fewer samples, a shorter cycle, one axis with --axis"
        | "in {most} s keine Antwort; mit --deadline mehr erlauben oder den Umfang verringern: weniger Stichproben, kürzerer Zyklus, mit --axis eine einzelne Achse";
    on_no_sheet(most) =
        "on no sheet, for it has more than {most} rows" | "auf keinem Blatt, weil länger als {most} Zeilen";
    calculating_share(share) = "calculating {share} %" | "rechnet {share} %";
    no_axis_possible = "no axis possible" | "keine Achse möglich";
    inside_the_band = "inside the band" | "im Innern des Bands";
    none = "none" | "keine";
    tolerances_head(samples, seed) =
        "tolerances: {samples} samples, seed {seed}"
        | "Toleranzen: {samples} Stichproben, Startwert {seed}";
    corner_searched(all_corners_most) =
        "more than {all_corners_most} quantities: the corner was searched by one quantity at a time, not every corner was looked at"
        | "mehr als {all_corners_most} Größen: die Ecke wurde Größe um Größe gesucht, nicht jede Ecke angesehen";
    calculating = "calculating" | "rechnet";
    segment_of_motion = "move" | "Abschnitt";
    from_s = "from s" | "ab s";
    time_s = "time s" | "Zeit s";
    recording_read(file, count, columns) =
        "{file}, {count} samples, {columns}"
        | "{file}, {count} Abtastwerte, {columns}";
    asked = "asked" | "verlangt";
    permitted = "permitted" | "zulässig";
    up_to_nm = "up to Nm" | "bis Nm";
    size = "size" | "Größe";
    symbol = "symbol" | "Symbol";
    name = "name" | "Benennung";
    errata_counted(count, corrected, flagged) =
        "1 erratum"
        | "1 Druckfehler",
        "{count} errata: {corrected} corrected, {flagged} flagged"
        | "{count} Druckfehler: {corrected} korrigiert, {flagged} offen";
    used_by_checks(used, corrected) =
        "{used} by checks, {corrected} elsewhere"
        | "{used} in Nachweisen, sonst {corrected}";
    where_it_stands = "where" | "wo";
    recovered = "recovered" | "gelesen";
    as_in_print = "printed" | "im Druck";
    used = "used" | "verwendet";
    evidence = "evidence" | "Beleg";
    inertia_explained =
        "m, J_own and m r² of one piece; J = z (J_own + m r²)"
        | "m, J_own und m r² eines Stücks; J = z (J_own + m r²)";
    centre_on_the_axis = "centre of mass on the axis of rotation" | "Schwerpunkt auf der Drehachse";
    centre_of_mass(radius, angle, gravity) =
        "centre of mass {radius} mm from the axis of rotation at {angle}°\ntorque of its weight with the axis horizontal: at most {gravity} Nm"
        | "Schwerpunkt {radius} mm von der Drehachse bei {angle}°\nDrehmoment des Gewichts bei waagerechter Achse: höchstens {gravity} Nm";
    word = "word" | "Wort";
    other_language = "German" | "englisch";
    meaning = "meaning" | "Bedeutung";
    sign = "symbol" | "Zeichen";
    identifier = "name" | "Name";
    near(names) = "near: {names}" | "ähnlich: {names}";
    judged(fitting, total) =
        "{total} actuators judged, 1 fits"
        | "{total} Antriebe beurteilt, 1 geeignet",
        "{total} actuators judged, {fitting} fit"
        | "{total} Antriebe beurteilt, {fitting} geeignet";
    remarks_on(id) = "remarks on {id}" | "Bemerkungen zu {id}";
    move_number(number) = "move {number}" | "Bewegung {number}";
    at_s = "at s" | "bei s";
    grade_and_source = "grade, source of the limit" | "Güte, Quelle der Grenze";
    rejected_count(count) = "rejected {count}" | "verworfen {count}";
    worst_percent = "worst %" | "Ecke %";
    at_the_worst_corner = "at the worst corner" | "in der schlimmsten Ecke";
    passes_percent = "passes %" | "geeignet %";
    dominated_by = "dominated by" | "bestimmt durch";
    by_percent = "by %" | "zu %";
    share_passing(passes, low, high) =
        "passes {passes} % of the samples, 95 % interval {low} % to {high} %"
        | "geeignet bei {passes} % der Stichproben, 95-%-Intervall {low} % bis {high} %";
    quantiles(p05, p50, p95, max) =
        "utilisation {p05} %, {p50} %, {p95} % at 5, 50, 95 % of the samples, largest {max} %"
        | "Auslastung {p05} %, {p50} %, {p95} % bei 5, 50, 95 % der Stichproben, größte {max} %";
    worst_corner(worst, word) = "worst corner {worst} %, {word}" | "schlimmste Ecke {worst} %, {word}";
    impossible_samples(count) =
        "with {count} samples no axis is possible; none of them passes"
        | "bei {count} Stichproben ist keine Achse möglich; bei keiner ist er geeignet";
    quantity = "quantity" | "Größe";
    from = "from" | "von";
    to = "to" | "bis";
    worst = "worst" | "schlimmst";
    influence_percent = "influence %" | "Einfluss %";
    available = "available" | "verfügbar";
    field = "field" | "Feld";
    token = "token" | "Zeichen";
    codes_counted(count, available, on_request) =
        "{count} codes: {available} available, {on_request} on request"
        | "{count} Codes: {available} verfügbar, {on_request} auf Anfrage";
    may_be = "may be (○ on request)" | "möglich (○ auf Anfrage)";
    nothing = "nothing" | "nichts";
    codes(count) = "1 code" | "1 Code", "{count} codes" | "{count} Codes";
    more_than_fifty_errors = "more than 50 errors" | "mehr als 50 Fehler";
    errors(count) = "1 error" | "1 Fehler", "{count} errors" | "{count} Fehler";
    nothing_was_calculated = "nothing was calculated" | "es wurde nichts gerechnet";
    ending_says_the_format =
        "the ending of the file says the format: .xlsx, .csv, .json or .parquet"
        | "die Endung der Datei sagt das Format: .xlsx, .csv, .json oder .parquet";
    name_one_table(names) =
        "name one table with --table: {names}; or write the whole workbook with --out FILE.xlsx"
        | "eine Tabelle mit --table nennen: {names}; oder die ganze Mappe mit --out DATEI.xlsx schreiben";
    report_without_axis = "a report needs at least one axis" | "ein Bericht braucht mindestens eine Achse";
    not_a_date(text) = "`{text}` is not a date" | "`{text}` ist kein Datum";
    archive_needs_a_date = "an archive file (PDF/A) needs a date" | "eine Archivdatei (PDF/A) braucht ein Datum";
    report_not_typeset(message) =
        "the report cannot be typeset: {message}"
        | "der Bericht lässt sich nicht setzen: {message}";
    report_not_written(message) =
        "the report cannot be written as PDF: {message}"
        | "der Bericht lässt sich nicht als PDF schreiben: {message}";
    page_not_drawn(page) =
        "page {page} cannot be written as picture"
        | "Seite {page} lässt sich nicht als Bild schreiben";
    workbook_not_written(message) =
        "the workbook cannot be written: {message}"
        | "die Arbeitsmappe lässt sich nicht schreiben: {message}";
    parquet_not_written(message) =
        "the Parquet file cannot be written: {message}"
        | "die Parquet-Datei lässt sich nicht schreiben: {message}";
}
