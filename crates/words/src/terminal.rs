//! Texts of the command line besides the answers.

use crate::texts::texts;

texts! {
    battery_under(hours, storage) =
        "battery of the encoder M128S at 25 °C, {hours} h of operation a day, {storage} years of storage before it"
        | "Batterie des Gebers M128S bei 25 °C, {hours} h Betrieb je Tag, zuvor {storage} Jahre Lagerung";
    battery(life, grade) =
        "encoder battery: life {life} years in operation ({grade}, model battery)"
        | "Geberbatterie: Lebensdauer {life} Jahre im Betrieb ({grade}, Modell Batterie)";
    battery_exchange(recommended, latest) =
        "replacement of the encoder: recommended after {recommended} years, at the latest {latest} years after delivery"
        | "Austausch des Gebers: empfohlen nach {recommended} Jahren, spätestens {latest} Jahre nach Lieferung";
    recording_not_written(recording, kind) =
        "{recording} is not written to standard output; use `antrieb new {kind} --out FILE` to write both files"
        | "{recording} wird nicht auf die Standardausgabe geschrieben; `antrieb new {kind} --out DATEI` schreibt beide Dateien";
    nearest_valid_codes = "nearest valid ordering codes" | "nächstliegende gültige Bestellbezeichnungen";
    code = "code" | "Bestellbezeichnung";
    understood_as(code) = "interpreted as {code}" | "gelesen als {code}";
    first_in_the_ranking = "first in the ranking" | "Erster der Rangfolge";
    lowest_utilisation = "lowest utilisation" | "geringste Auslastung";
    figure = "figure" | "Größe";
    two_to_five_codes(count) =
        "two to five ordering codes can be compared, not {count}: state --code once for each"
        | "vergleichbar sind zwei bis fünf Bestellbezeichnungen, nicht {count}: --code für jede einmal angeben";
    no_record_of_several =
        "the data of several actuators have no JSON; one record for each: antrieb data CODE --json"
        | "die Daten mehrerer Antriebe gibt es nicht als JSON; ein Datensatz für jeden: antrieb data CODE --json";
    help_on_check(title, id, meaning) =
        "{title}: the check `{id}`. {meaning} Requirement, limit and utilisation of an actuator are in the answer of `antrieb check`, formula, inputs and sources in that of `antrieb explain`:"
        | "{title}: der Nachweis „{id}“. {meaning} Anforderung, Grenzwert und Auslastung eines Antriebs nennt `antrieb check`, Formel, Eingangsgrößen und Quellen nennt `antrieb explain`:";
    table = "table" | "Tabelle";
    note = "note" | "Hinweis";
    errata_of_this_table = "errata of this table" | "Druckfehler dieser Tabelle";
    see = "see" | "siehe";
    value_of_the_standard(value) = "not stated (standard version {value})" | "nicht angegeben (Standardausführung {value})";
    value_and_print(value, printed) = "{value} (manual: {printed})" | "{value} (Anleitung: {printed})";
    torsion(code, angle, radian, torque, region) =
        "{code}: {angle} arcmin ({radian} mrad) under {torque} Nm, stiffness region {region}"
        | "{code}: {angle} arcmin ({radian} mrad) unter {torque} Nm, Steifigkeitsbereich {region}";
    torsion_curve(t1, t2, k1, k2, k3, table) =
        "T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (table {table}); mean values, locked motor"
        | "T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (Tabelle {table}); Mittelwerte, Motor blockiert";
    torsion_beyond(symbol, limit, name, source) =
        "exceeds {symbol} = {limit} Nm, {name} ({source}); the curve is extrapolated"
        | "überschreitet {symbol} = {limit} Nm, {name} ({source}); die Kennlinie ist extrapoliert";
    too_many_changes(count, most) =
        "{count} changes; the report lists at most {most}"
        | "{count} Änderungen; der Bericht führt höchstens {most}";
    torque_or_angle =
        "state either torque or angle; the other one is computed"
        | "entweder torque oder angle angeben; das andere wird berechnet";
    most_lost(name, angle, source) = "{name}: at most {angle} arcmin ({source})" | "{name}: höchstens {angle} arcmin ({source})";
    no_common_axis =
        "the two projects have no axis of the same name"
        | "die beiden Projekte haben keine Achse gleichen Namens";
    none_fits = "none fits" | "keiner ist geeignet";
    best_of_the_catalogue = "best of the catalogue" | "bester Antrieb des Katalogs";
    as_before = "as before" | "wie vorher";
    no_input_changed = "no input changed" | "keine Eingabe geändert";
    input = "input" | "Eingabe";
    before = "before" | "vorher";
    after = "after" | "nachher";
    demand_not_known =
        "demand not known: data of the actuator are missing"
        | "Belastung nicht bekannt: Angaben zum Antrieb fehlen";
    same_demand = "demand unchanged" | "Belastung unverändert";
    change = "change" | "Änderung";
    unchanged = "unchanged" | "unverändert";
    axis_is_only_in(name, file) = "axis \"{name}\" is only in {file}" | "Achse „{name}“ gibt es nur in {file}";
    no_erratum = "no erratum" | "kein Druckfehler";
    as_printed = "as stated in the manual" | "laut Anleitung";
    checks = "checks" | "Nachweise";
    to_state = "to be stated" | "anzugeben";
    see_above = "see above" | "siehe oben";
    rows = "rows" | "Zeilen";
    table_is_of_one_axis(names) =
        "a single table is one of one axis, a workbook (.xlsx) has all; select one with --axis: {names}"
        | "eine einzelne Tabelle gehört zu einer Achse, eine Arbeitsmappe (.xlsx) enthält alle; eine mit --axis wählen: {names}";
    error = "error" | "Fehler";
    help = "help" | "Hilfe";
    file_too_large(project_max_bytes) =
        "the file is larger than {project_max_bytes} bytes; a project file is text of a few kilobytes"
        | "die Datei ist größer als {project_max_bytes} Byte; eine Projektdatei ist Text von wenigen Kilobyte";
    in_derivations = "in derivations" | "in Herleitungen";
    nothing_in_the_glossary(wanted) =
        "the glossary has no entry for `{wanted}`"
        | "das Glossar enthält keinen Eintrag zu „{wanted}“";
    no_such_unit(wanted) =
        "`{wanted}` is neither a quantity nor a unit"
        | "„{wanted}“ ist weder eine Größe noch eine Einheit";
    also_written = "other spellings" | "weitere Schreibweisen";
    in_si = "in SI";
    no_actuator_fits = "no actuator in the catalogue fits" | "kein Antrieb des Katalogs ist geeignet";
    ratio_of_the_stage = "ratio of the stage" | "Übersetzung der Stufe";
    own_actuator_of_the_project = "own actuator of the project" | "eigener Antrieb des Projekts";
    all_shows_each = "--all shows each actuator with its reason" | "--all zeigt jeden Antrieb mit Grund";
    no_brake_for(value) = "{value} required, no holding brake" | "{value} erforderlich, keine Haltebremse vorhanden";
    not_absolute_over(travel) =
        "no absolute encoder, the axis travels {travel}" | "kein Absolutwertgeber, die Achse fährt {travel}";
    no_holding_torque = "no holding torque" | "kein Haltemoment";
    no_torque_at_this_speed = "no torque at this speed" | "kein Drehmoment bei dieser Drehzahl";
    no_absolute_position = "no absolute position" | "keine absolute Position";
    speed_beyond_the_curve = "speed beyond the end of the curve" | "Drehzahl über dem Ende der Kennlinie";
    nearest_miss = "smallest excess" | "geringste Überschreitung";
    kept_out_by_limits = "rejected by limits of the project only" | "nur durch Grenzen des Projekts verworfen";
    requirement_not_checked = "requirement not checked" | "Anforderung nicht geprüft";
    more_fit(more) =
        "{more} more fit; use --top N or --all to show them"
        | "{more} weitere geeignet; mit --top N oder --all anzeigen";
    not_evaluated_listed = "not evaluated (data missing)" | "nicht bewertet (Angaben fehlen)";
    and_more(more) = "… {more} more" | "… {more} weitere";
    demand_on(id) = "demand on {id}" | "geforderte Werte am Abtrieb, {id}";
    more_segments(more) = "{more} more; --json lists all" | "{more} weitere; --json nennt alle";
    text_read_as(encoding) = "text read as {encoding} (assumed)" | "Text als {encoding} gelesen (Annahme)";
    comments_passed_over(count) =
        "lines skipped as comments: {count}" | "als Kommentar übergangene Zeilen: {count}";
    columns_not_used(names) = "not used: {names}" | "nicht verwendet: {names}";
    more_columns_not_used(names, more) = "not used: {names} and {more} more" | "nicht verwendet: {names} und {more} weitere";
    outside_the_window(left) = "{left} outside the window" | "{left} außerhalb des Fensters";
    built_without_report =
        "this build of antrieb does not include the typesetting engine and cannot write reports; `cargo install --path crates/cli` builds it with the report"
        | "diese antrieb-Version ist ohne Satz-Engine gebaut und schreibt keinen Bericht; `cargo install --path crates/cli` baut sie mit Bericht";
    cargo_builds_the_report =
        "the report requires the typesetting engine: cargo runs the program that includes it; the first build takes a few minutes"
        | "der Bericht benötigt die Satz-Engine: cargo startet das Programm, das sie enthält; der erste Build dauert einige Minuten";
    png_needs_a_file =
        "--png requires a file name: a PNG is not written to standard output"
        | "--png erfordert einen Dateinamen: ein PNG wird nicht auf die Standardausgabe geschrieben";
    picture_too_large(most) =
        "the picture has more than {most} million pixels: reduce its size, or write it as SVG"
        | "das Bild hat mehr als {most} Millionen Pixel: Größe verringern oder als SVG schreiben";
    several_axes(names) =
        "the project has several axes; select one with --axis: {names}"
        | "das Projekt hat mehrere Achsen; eine mit --axis wählen: {names}";
    sides_of_a_picture(least, most) =
        "width and height of a picture must be from {least} mm to {most} mm"
        | "Breite und Höhe eines Bilds müssen zwischen {least} mm und {most} mm liegen";
    report_is_a_pdf(display) =
        "a report is written as PDF: specify a file name ending in .pdf, not {display}"
        | "ein Bericht wird als PDF geschrieben: einen Dateinamen mit der Endung .pdf angeben, nicht {display}";
    code_is_for_one_axis(names) =
        "--code applies to one axis, but the project has several; select one with --axis: {names}"
        | "--code gilt für eine Achse, das Projekt hat jedoch mehrere; eine mit --axis wählen: {names}";
    fits_up_to = "fits up to (single changes)" | "geeignet bis (Einzeländerungen)";
    checks_pass_up_to = "all checks pass up to (single changes)" | "alle Nachweise erfüllt bis (Einzeländerungen)";
    next_calls = "further calls" | "weitere Aufrufe";
    smallest_change =
        "smallest change, with the actuator that then fits" | "kleinste Änderung, mit dem dann geeigneten Antrieb";
    would_fit_with_another_law =
        "another law of motion in place of the assumed one, with the actuator that then fits"
        | "anderes Bewegungsgesetz anstelle des angenommenen, mit dem dann geeigneten Antrieb";
    would_fit_with_other_gearing =
        "another value, with the actuator that then fits" | "anderer Wert, mit dem dann geeigneten Antrieb";
    a_stage_by_its_keys(ratio, number) =
        "stage with ratio {ratio} (--set stage.kind=gear --set stage.ratio={number})"
        | "Zwischenstufe mit Übersetzung {ratio} (--set stage.kind=gear --set stage.ratio={number})";
    a_stage_with_new_loads(ratio) =
        "stage with ratio {ratio}; the loads on the flange behind it are to be stated anew"
        | "Zwischenstufe mit Übersetzung {ratio}; die Lasten auf den Flansch sind mit ihr neu anzugeben";
    a_stage(ratio) = "stage with ratio {ratio}" | "Zwischenstufe mit Übersetzung {ratio}";
    would_fit_with_one_of = "would fit if one of these changed" | "wäre geeignet, wenn eine der folgenden Größen geändert wird";
    checks_would_pass_with_one_of = "all checks would pass if one of these changed" | "alle Nachweise wären erfüllt, wenn eine der folgenden Größen geändert wird";
    would_fit_with_this_asked_for = "would fit if the limit of the project were" | "wäre geeignet mit dieser Grenze des Projekts";
    only_by_the_checks_made(count) =
        "of the checks that can rule out the actuator, {count} could not be made; the changes apply to the others only"
        | "von den Nachweisen, die den Antrieb ausschließen können, fehlen {count}; die Änderungen gelten nur für die übrigen";
    not_sought = "not searched" | "nicht gesucht";
    load_and_pace_not_sought(samples, most) =
        "other loads and cycle times: each search step would have to recompute loads equivalent to {samples} recorded samples; above {most} this is done only if check, size or report is given a time limit with --deadline"
        | "andere Lasten und Zykluszeiten: jeder Suchschritt müsste Lasten im Umfang von {samples} Abtastwerten neu berechnen; über {most} geschieht dies nur, wenn bei check, size oder report mit --deadline eine Zeitgrenze angegeben ist";
    load_not_sought(samples, most) =
        "other loads: each search step would have to recompute loads equivalent to {samples} recorded samples; above {most} this is done only if check, size or report is given a time limit with --deadline"
        | "andere Lasten: jeder Suchschritt müsste Lasten im Umfang von {samples} Abtastwerten neu berechnen; über {most} geschieht dies nur, wenn bei check, size oder report mit --deadline eine Zeitgrenze angegeben ist";
    payload_factor(factor) = "payload × {factor}" | "Nutzlast × {factor}";
    load_factor(factor) = "all masses and inertias × {factor}" | "alle Massen und Trägheitsmomente × {factor}";
    cycle_time(time) =
        "cycle time {time} s, moves and dwells alike" | "Zykluszeit {time} s, Bewegungen und Rasten gleichermaßen";
    ambient(ambient) = "ambient temperature up to {ambient} °C" | "Umgebungstemperatur bis {ambient} °C";
    ambient_from(ambient) = "ambient temperature from {ambient} °C" | "Umgebungstemperatur ab {ambient} °C";
    ambient_between(least, most) =
        "ambient temperature from {least} to {most} °C" | "Umgebungstemperatur von {least} bis {most} °C";
    values_set(values) = "set: {values}" | "gesetzt: {values}";
    call_understood(call) = "understood as: {call}" | "verstanden als: {call}";
    not_scaled(axis, why, others) = "axis {axis}: {why}; select another axis with --axis: {others}" | "Achse {axis}: {why}; eine andere Achse mit --axis wählen: {others}";
    change_of_another_axis(path, axis, own) = "{path} is a value of the axis {axis}; the call is about {own} (--axis {axis})" | "{path} ist ein Wert der Achse {axis}; der Aufruf gilt für {own} (--axis {axis})";
    no_result_of_new(call) = "no actuator fits ({call})" | "kein Antrieb geeignet ({call})";
    ending_of_setpoints = "setpoints are a .csv or .parquet file" | "Sollwerte sind eine Datei .csv oder .parquet";
    setpoints_call(call) = "setpoints for a controller: {call}" | "Sollwerte für eine Steuerung: {call}";
    setpoints_written(file, rows, every) =
        "{file}: {rows} setpoints, every {every} ms" | "{file}: {rows} Sollwerte im Takt von {every} ms";
    setpoints_rest(cycle, every, rest) =
        "the cycle of {cycle} s is no multiple of {every} ms: the last row is {rest} ms behind the one before"
        | "der Zyklus von {cycle} s ist kein Vielfaches von {every} ms: die letzte Zeile liegt {rest} ms hinter der vorletzten";
    cycle_changed(before, after) = "cycle {before} → {after}" | "Zyklus {before} → {after}";
    moved_mass_with_payload(own, payload, sum) =
        "moved mass {own} (mechanism) + {payload} (payload) = {sum}"
        | "bewegte Masse {own} (Mechanik) + {payload} (Nutzlast) = {sum}";
    changed_for_this_call(change) = "for this call: {change}" | "für diesen Aufruf: {change}";
    values_of_a_new_project(values) =
        "not stated in the call, values of a new project: {values}"
        | "im Aufruf nicht angegeben, Werte eines neuen Projekts: {values}";
    new_project_as_a_file(call) = "as a file: {call}" | "als Datei: {call}";
    set_form = "the form is --set KEY=VALUE, such as --set mechanism.belt.mass=20kg" | "die Form ist --set SCHLÜSSEL=WERT, etwa --set mechanism.belt.mass=20kg";
    no_values_of_a_table =
        "a table of rows takes no --set; its columns are stated with --key"
        | "eine Tabelle von Zeilen nimmt kein --set; ihre Spalten werden mit --key angegeben";
    no_values_of_a_catalogue =
        "a catalogue file takes no --set; its products are stated in the file"
        | "eine Katalogdatei nimmt kein --set; ihre Produkte werden in der Datei angegeben";
    still_missing(faults) =
        "still to be stated before a calculation: {faults}"
        | "vor einer Berechnung noch anzugeben: {faults}";
    recording_to_mend(fault) =
        "to be put right in the recording or in its segment: {fault}"
        | "in der Aufzeichnung oder in ihrem Segment noch zu berichtigen: {fault}";
    new_project_with(name) = "(new project with {name})" | "(neues Projekt mit {name})";
    set_thousands(key, written) =
        "{key}: \"{written}\" is ambiguous, with a thousands separator or a decimal separator"
        | "{key}: „{written}“ ist mehrdeutig, mit Tausender- oder Dezimaltrennzeichen";
    set_which(key, one, other) = "{key} is ambiguous: {one} or {other}" | "{key} ist mehrdeutig: {one} oder {other}";
    set_which_axis(example) = "the project has several axes: --axis NAME, or {example}" | "das Projekt hat mehrere Achsen: --axis NAME, oder {example}";
    set_unit(key) = "`{key}`: the value has no unit" | "`{key}`: der Wert hat keine Einheit";
    distances_differ(key) =
        "`{key}`: the moves have different distances, which one value would make equal; a factor keeps their shares"
        | "„{key}“: die Wege der Bewegungen sind verschieden, ein Wert würde sie gleich machen; ein Faktor erhält ihr Verhältnis";
    two_of_a_move(names) =
        "two of these determine a move, not three: {names}"
        | "zwei dieser Angaben bestimmen eine Bewegung, nicht drei: {names}";
    cycle_of_all(cycle, moves) =
        "cycle {cycle}, the whole motion: {moves} moves with their dwells"
        | "Zyklus {cycle}, die ganze Bewegung: {moves} Bewegungen mit ihren Rasten";
    cycle_too_short(cycle, moves) =
        "the moves alone take {moves}, the cycle is {cycle}"
        | "die Bewegungen allein dauern {moves}, der Zyklus {cycle}";
    factor_undecided(written) =
        "\"{written}\" may be an increase or a share"
        | "„{written}“ kann eine Zunahme oder ein Anteil sein";
    addition_undecided(written) =
        "\"{written}\" may be an addition to the present value or the value"
        | "„{written}“ kann ein Zuschlag zum jetzigen Wert oder der Wert sein";
    no_load_to_scale =
        "the project states no load that a factor could change: its torques are recorded or stated over the position, or its load is zero"
        | "das Projekt nennt keine Last, die ein Faktor ändern könnte: die Drehmomente sind aufgezeichnet oder über der Position angegeben, oder die Last ist null";
    mass_of_no_load(word) =
        "`{word}`: the project states no load that a mass could change: its torques are recorded or stated over the position"
        | "„{word}“: das Projekt nennt keine Last, die eine Masse ändern könnte: die Drehmomente sind aufgezeichnet oder über der Position angegeben";
    mass_without_radius(word, keys, mass, inertia) =
        "`{word}`: a mass has no lever arm on this axis, whose load is stated by {keys}; {mass} at a radius of 100 mm have {inertia} kg m²"
        | "„{word}“: eine Masse hat an dieser Achse keinen Hebelarm, ihre Last ist mit {keys} angegeben; {mass} auf einem Radius von 100 mm haben {inertia} kg m²";
    no_effect_without(others) = "the option has no effect without {others}" | "die Option wirkt nur zusammen mit {others}";
    no_steps_without_a_range =
        "steps divide a range such as 10..20kg; no value of --vary is one"
        | "Schritte teilen einen Bereich wie 10..20kg; kein Wert von --vary ist einer";
    step_beside_steps =
        "--step and --steps both divide the range; state one of them"
        | "--step und --steps teilen beide den Bereich; nur eines davon angeben";
    no_step_of_one_range =
        "a step divides one range such as 30..60kg; of several each states its own behind a colon, 30..60kg:5kg"
        | "ein Schritt teilt einen Bereich wie 30..60kg; von mehreren nennt jeder seinen nach einem Doppelpunkt, 30..60kg:5kg";
    set_no_key(key) = "a project has no key \"{key}\"" | "ein Projekt hat keinen Schlüssel „{key}“";
    scale_not_possible(what) =
        "{what} cannot be scaled in this project: it has no such values, or states them as a recording"
        | "{what} lässt sich in diesem Projekt nicht skalieren: es hat keine solchen Angaben oder nennt sie als Aufzeichnung";
    best_of_the_ranking(id) =
        "no actuator is stated (--code): the best of the ranking, {id}"
        | "kein Antrieb angegeben (--code): der beste der Rangfolge, {id}";
    only_project(name) =
        "no project is stated: the only one of this folder, {name}"
        | "kein Projekt angegeben: das einzige dieses Ordners, {name}";
    only_of_pattern(part, code) =
        "{part} stands for one actuator of the ranking, {code}"
        | "{part} steht für einen Antrieb der Rangfolge, {code}";
    best_of_pattern(part, count, code) =
        "{part} stands for {count} actuators of the ranking: the best of them, {code}"
        | "{part} steht für {count} Antriebe der Rangfolge: der beste davon, {code}";
    nearest_of_pattern(part, count, code) =
        "{part} stands for {count} actuators of the ranking, none of which fits: the one with the smallest excess, {code}"
        | "{part} steht für {count} Antriebe der Rangfolge, von denen keiner geeignet ist: der mit der geringsten Überschreitung, {code}";
    pattern_readings(fit, fitting, fail, failing) =
        "{fit} of them fit: {fitting}; {fail} do not: {failing}"
        | "{fit} davon sind geeignet: {fitting}; {fail} sind es nicht: {failing}";
    option_assumed(option) = "not stated, assumed: {option}" | "nicht angegeben, angenommen: {option}";
    not_of_the_manual = "note (not from the manual)" | "Anmerkung (nicht aus der Anleitung)";
    smallest_excess_of_the_ranking(id) =
        "no actuator is stated (--code) and none fits: the one with the smallest excess, {id}"
        | "kein Antrieb angegeben (--code) und keiner geeignet: der mit der geringsten Überschreitung, {id}";
    compared_with_the_best(ids) =
        "compared with the best of the ranking: {ids}" | "verglichen mit den besten der Rangfolge: {ids}";
    no_own_actuator =
        "the project has no [actuator]; select one from the catalogue with --code"
        | "das Projekt hat keinen [actuator]; einen Antrieb des Katalogs mit --code wählen";
    no_product(name) =
        "no catalogue file has a product {name}"
        | "keine Katalogdatei enthält ein Produkt {name}";
    no_data =
        "the manual states no data for this ordering code: available on request only"
        | "für diese Bestellbezeichnung nennt die Anleitung keine Daten: nur auf Anfrage lieferbar";
    no_such_axis(wanted, join) =
        "the project has no axis \"{wanted}\"; it has: {join}"
        | "das Projekt hat keine Achse „{wanted}“; es hat: {join}";
    check_not_asked(title) =
        "{title}: this check does not apply to this axis and actuator"
        | "{title}: dieser Nachweis entfällt bei dieser Achse mit diesem Antrieb";
    nothing_to_sample =
        "the project has no tolerances: there are no samples"
        | "das Projekt hat keine Toleranzen: es gibt keine Stichproben";
    state_a_tolerance =
        "leave it out, or state one, such as mass = \"30 kg ± 5 %\""
        | "weglassen, oder eine angeben, etwa mass = '30 kg ± 5 %'";
    too_many_samples(asked, most) =
        "{asked} samples of these tolerances take more than about ten seconds; by default at most {most} are evaluated: state fewer with --samples, or a time limit with --deadline"
        | "{asked} Stichproben dieser Toleranzen dauern länger als etwa zehn Sekunden; ohne Angabe werden höchstens {most} ausgewertet: mit --samples weniger oder mit --deadline eine Zeitgrenze angeben";
    too_long(samples, most, seconds) =
        "{samples} samples of recordings take more than about {seconds} seconds; by default at most {most} are evaluated for such a load: state a time limit with --deadline, or use fewer samples (from, to)"
        | "{samples} Abtastwerte von Aufzeichnungen dauern länger als etwa {seconds} Sekunden; ohne Angabe werden bei einer solchen Last höchstens {most} ausgewertet: mit --deadline eine Zeitgrenze angeben oder weniger Abtastwerte verwenden (from, to)";
    too_many_axes(axes, seconds) =
        "{axes} axes together take more than about {seconds} seconds: select one with --axis, or state a time limit with --deadline"
        | "{axes} Achsen dauern zusammen länger als etwa {seconds} Sekunden: mit --axis eine wählen oder mit --deadline eine Zeitgrenze angeben";
    too_many_ratios(ratios, seconds) =
        "evaluating the catalogue for each of {ratios} stage ratios takes more than about {seconds} seconds: state fewer in stage.ratios, or a time limit with --deadline"
        | "die Bewertung des Katalogs für jede von {ratios} Übersetzungen der Zwischenstufe dauert länger als etwa {seconds} Sekunden: in stage.ratios weniger oder mit --deadline eine Zeitgrenze angeben";
    too_many_rows(rows, needed, most) =
        "the time series table has up to {rows} rows and requires {needed} MiB; {most} MiB are permitted: raise the limit with --memory, or use fewer samples (from, to)"
        | "die Tabelle des Verlaufs hat bis zu {rows} Zeilen und benötigt {needed} MiB; zulässig sind {most} MiB: Grenze mit --memory erhöhen oder weniger Abtastwerte verwenden (from, to)";
    deadline_not_negative(limit) =
        "the time limit must not be negative: \"{limit}\"" | "die Zeitgrenze darf nicht negativ sein: „{limit}“";
    not_in_time(most) =
        "no answer within {most} s; raise the limit with --deadline, or reduce the work: fewer samples, a shorter cycle, a single axis with --axis"
        | "keine Antwort innerhalb von {most} s; Zeitgrenze mit --deadline erhöhen oder Umfang verringern: weniger Stichproben, kürzerer Zyklus, einzelne Achse mit --axis";
    on_no_sheet(most) =
        "not on a sheet: more than {most} rows" | "auf keinem Blatt: mehr als {most} Zeilen";
    calculating_share(share) = "calculating {share} %" | "rechnet {share} %";
    no_axis_possible = "axis not feasible" | "Achse nicht ausführbar";
    inside_the_band = "within the band" | "innerhalb des Bands";
    none = "none" | "keine";
    tolerances_head(samples, seed) =
        "tolerances: {samples} samples, seed {seed}"
        | "Toleranzen: {samples} Stichproben, Startwert {seed}";
    corner_searched(all_corners_most) =
        "more than {all_corners_most} quantities: the worst corner was searched one quantity at a time; not all corners were evaluated"
        | "mehr als {all_corners_most} Größen: die ungünstigste Ecke wurde Größe für Größe gesucht; nicht alle Ecken wurden bewertet";
    calculating = "calculating" | "rechnet";
    segment_of_motion = "segment" | "Abschnitt";
    from_s = "start s" | "Beginn s";
    time_s = "time s" | "Zeit s";
    recording_read(file, count, columns) =
        "{file}, {count} samples, {columns}"
        | "{file}, {count} Abtastwerte, {columns}";
    asked = "required" | "gefordert";
    permitted = "permitted" | "zulässig";
    up_to_nm = "up to Nm" | "bis Nm";
    size = "size" | "Größe";
    symbol = "symbol" | "Formelzeichen";
    name = "name" | "Benennung";
    errata_counted(count, corrected, flagged) =
        "1 erratum"
        | "1 Druckfehler",
        "{count} errata: {corrected} corrected, {flagged} flagged"
        | "{count} Druckfehler: {corrected} berichtigt, {flagged} offen";
    value_and_used(value, used) = "{value} (checks: {used})" | "{value} (Nachweise: {used})";
    used_by_checks(used, corrected) =
        "{used} in checks, {corrected} elsewhere"
        | "{used} in Nachweisen, sonst {corrected}";
    where_it_stands = "place" | "Stelle";
    recovered = "recovered" | "gelesen";
    as_in_print = "manual" | "laut Anleitung";
    used = "used" | "verwendet";
    evidence = "evidence" | "Beleg";
    inertia_explained =
        "m, J_own and m r² per body; J = z (J_own + m r²)"
        | "m, J_own und m r² je Körper; J = z (J_own + m r²)";
    centre_on_the_axis = "centre of mass on the axis of rotation" | "Schwerpunkt auf der Drehachse";
    centre_of_mass(radius, angle, gravity) =
        "centre of mass {radius} mm from the axis of rotation at {angle}°\ngravity torque with horizontal axis: at most {gravity} Nm"
        | "Schwerpunkt {radius} mm von der Drehachse bei {angle}°\nGewichtsmoment bei waagerechter Achse: höchstens {gravity} Nm";
    word = "term" | "Begriff";
    other_language = "German" | "Englisch";
    meaning = "meaning" | "Bedeutung";
    sign = "symbol" | "Formelzeichen";
    identifier = "identifier" | "Kennung";
    near(names) = "similar: {names}" | "ähnlich: {names}";
    judged(fitting, total) =
        "{total} actuators evaluated, 1 fits"
        | "{total} Antriebe bewertet, 1 geeignet",
        "{total} actuators evaluated, {fitting} fit"
        | "{total} Antriebe bewertet, {fitting} geeignet";
    installation = "Mounting, wiring and commissioning" | "Montage, Verdrahtung und Inbetriebnahme";
    installation_not_known(code) =
        "Not known for {code}: these data come from the manual of the CHA series; those of another product are in the documents of its manufacturer."
        | "Für {code} nicht bekannt: diese Angaben stammen aus der Anleitung der Reihe CHA; die eines anderen Produkts stehen in den Unterlagen seines Herstellers.";
    without_any_check(count) =
        "1 not evaluated: data missing for every check"
        | "1 nicht bewertet: für jeden Nachweis fehlen Angaben",
        "{count} not evaluated: data missing for every check"
        | "{count} nicht bewertet: für jeden Nachweis fehlen Angaben";
    more_on_condition(count, condition) =
        "{count} more fits {condition}"
        | "{count} weiterer, {condition}",
        "{count} more fit {condition}"
        | "{count} weitere, {condition}";
    if_an_estimate_holds = "if an estimate holds" | "sofern eine Schätzung zutrifft";
    if_an_estimate_holds_or_no_rating_applies =
        "if an estimate holds or the gear rating of another manufacturer does not apply"
        | "sofern eine Schätzung zutrifft oder die Getriebegrenze eines anderen Herstellers nicht gilt";
    if_the_estimate_holds = "if the estimate holds" | "sofern die Schätzung zutrifft";
    unless_the_rating_applies =
        "unless the gear rating of another manufacturer applies"
        | "sofern die Getriebegrenze eines anderen Herstellers nicht gilt";
    if_the_estimate_holds_and_no_rating_applies =
        "if the estimate holds and the gear rating of another manufacturer does not apply"
        | "sofern die Schätzung zutrifft und die Getriebegrenze eines anderen Herstellers nicht gilt";
    remarks_on(id) = "remarks on {id}" | "Bemerkungen zu {id}";
    move_number(number) = "move {number}" | "Bewegung {number}";
    at_s = "time s" | "Zeitpunkt s";
    grade_and_source = "grade, source of the limit" | "Güte, Quelle der Grenze";
    failed_by_all = "failed by all of them" | "von allen nicht erfüllt";
    rejected_count(count) = "rejected {count}" | "verworfen {count}";
    worst_percent = "worst corner %" | "ungünstigste Ecke %";
    at_the_worst_corner = "at the worst corner" | "in der ungünstigsten Ecke";
    passes_percent = "fits %" | "geeignet %";
    dominated_by = "governed by" | "maßgebend";
    by_percent = "by %" | "zu %";
    share_passing(passes, low, high) =
        "fits for {passes} % of the samples, 95 % interval {low} % to {high} %"
        | "geeignet bei {passes} % der Stichproben, 95-%-Intervall {low} % bis {high} %";
    of_these_on_condition(count, condition) =
        "of these, 1 sample only {condition}" | "davon 1 Stichprobe nur, {condition}",
        "of these, {count} samples only {condition}" | "davon {count} Stichproben nur, {condition}";
    quantiles(p05, p50, p95, max) =
        "utilisation {p05} %, {p50} %, {p95} % at the 5, 50, 95 % quantile, maximum {max} %"
        | "Auslastung {p05} %, {p50} %, {p95} % beim 5-, 50-, 95-%-Quantil, Maximum {max} %";
    worst_corner(worst, word) = "worst corner {worst} %, {word}" | "ungünstigste Ecke {worst} %, {word}";
    impossible_samples(count) =
        "the axis is not feasible for {count} samples; they count as not fitting"
        | "bei {count} Stichproben ist die Achse nicht ausführbar; sie gelten als nicht geeignet";
    quantity = "quantity" | "Größe";
    from = "from" | "von";
    to = "to" | "bis";
    worst = "worst" | "ungünstigst";
    influence_percent = "influence %" | "Einfluss %";
    available = "available" | "lieferbar";
    field = "field" | "Feld";
    token = "token" | "Kürzel";
    codes_counted(count, available, on_request) =
        "{count} ordering codes: {available} available, {on_request} on request"
        | "{count} Bestellbezeichnungen: {available} lieferbar, {on_request} auf Anfrage";
    may_be = "possible (○ on request)" | "möglich (○ auf Anfrage)";
    nothing = "nothing" | "nichts";
    codes(count) = "1 ordering code" | "1 Bestellbezeichnung", "{count} ordering codes" | "{count} Bestellbezeichnungen";
    more_than_fifty_errors = "more than 50 errors" | "mehr als 50 Fehler";
    errors(count) = "1 error" | "1 Fehler", "{count} errors" | "{count} Fehler";
    nothing_was_calculated = "nothing was calculated" | "es wurde nichts gerechnet";
    ending_says_the_format =
        "the file name extension determines the format: .xlsx, .csv, .json or .parquet"
        | "die Dateiendung bestimmt das Format: .xlsx, .csv, .json oder .parquet";
    name_one_table(names) =
        "select one table with --table: {names}; or write the whole workbook with --out FILE.xlsx"
        | "eine Tabelle mit --table wählen: {names}; oder die ganze Arbeitsmappe mit --out DATEI.xlsx schreiben";
    report_without_axis = "a report requires at least one axis" | "ein Bericht erfordert mindestens eine Achse";
    not_a_change(text) =
        "`{text}` is no line of the list of changes: expected revision, date, author and text, separated by semicolons; the author may be omitted"
        | "`{text}` ist keine Zeile der Änderungsliste: erwartet werden Revision, Datum, Name und Text, durch Semikolon getrennt; der Name darf fehlen";
    not_a_date(text) = "`{text}` is not a date" | "`{text}` ist kein Datum";
    archive_needs_a_date = "an archive file (PDF/A) requires a date" | "eine Archivdatei (PDF/A) erfordert ein Datum";
    report_not_typeset(message) =
        "the report cannot be typeset: {message}"
        | "der Bericht lässt sich nicht setzen: {message}";
    report_not_written(message) =
        "the report cannot be written as PDF: {message}"
        | "der Bericht lässt sich nicht als PDF schreiben: {message}";
    page_not_drawn(page) =
        "page {page} cannot be written as a picture"
        | "Seite {page} lässt sich nicht als Bild schreiben";
    workbook_not_written(message) =
        "the workbook cannot be written: {message}"
        | "die Arbeitsmappe lässt sich nicht schreiben: {message}";
    parquet_not_written(message) =
        "the Parquet file cannot be written: {message}"
        | "die Parquet-Datei lässt sich nicht schreiben: {message}";
}
