//! Texts about requests over HTTP: the available addresses, and the reasons for refusing a request.

use crate::texts::texts;

texts! {
    title = "antrieb over HTTP" | "antrieb über HTTP";
    about =
        "The use cases of the command line. A response is identical, byte for byte, to the output of the same command with --json when it reads the project from standard input; if there is no answer, the response has status 422 and lists all faults."
        | "Die Anwendungsfälle der Befehlszeile. Eine Antwort stimmt Byte für Byte mit der Ausgabe desselben Befehls mit --json überein, wenn dieser das Projekt von der Standardeingabe liest; ist keine Antwort möglich, hat sie den Status 422 und nennt alle Fehler.";
    answered = "the answer" | "die Antwort";
    not_answered = "reasons why there is no answer" | "Gründe, warum keine Antwort möglich ist";
    project_body = "the text of a project file (TOML)" | "der Text einer Projektdatei (TOML)";
    two_projects_body = "the texts of two project files" | "die Texte zweier Projektdateien";
    pins_body = "a pin list (CSV)" | "eine Stiftliste (CSV)";
    measured_body =
        "measured values (TOML), or a catalogue file (TOML or CSV)"
        | "gemessene Werte (TOML) oder eine Katalogdatei (TOML oder CSV)";
    lang = "Language of the texts, en (default) or de" | "Sprache der Texte, en (ohne Angabe) oder de";
    file =
        "Name of the project in faults and files (stdin)"
        | "Name des Projekts in Fehlern und Dateien (stdin)";
    format =
        "json, csv or parquet for one table, xlsx for the workbook; default: json if a table is named, otherwise xlsx"
        | "json, csv oder parquet für eine Tabelle, xlsx für die Arbeitsmappe; ohne Angabe json, wenn eine Tabelle genannt ist, sonst xlsx";
    figure = "Picture" | "Bild";
    kind = "Kind of the file" | "Art der Datei";
    kind_manual =
        "load as moment of inertia and torque, moves as in the manual"
        | "Last als Massenträgheitsmoment und Moment, Bewegungen wie in der Anleitung";
    kind_load =
        "load as moment of inertia and torque, to and fro"
        | "Last als Massenträgheitsmoment und Moment, hin und zurück";
    kind_table =
        "turntable or drum of solid bodies, the same file as turntable"
        | "Drehtisch oder Trommel aus Vollkörpern, dieselbe Datei wie turntable";
    kind_recording =
        "recorded motion and torque (CSV or Parquet), the same file as joint"
        | "aufgezeichnete Bewegung mit Drehmoment (CSV oder Parquet), dieselbe Datei wie joint";
    of_a_workbook_only =
        "only the first sheet of a workbook states it; leave out --table" | "nur das erste Blatt einer Mappe nennt es; --table weglassen";
    kind_unwinder =
        "a roll that a web is drawn from, its diameter decreases" | "Wickel, von dem eine Bahn abgezogen wird, der Durchmesser nimmt ab";
    kind_sweep = "table of many axes for antrieb sweep" | "Tabelle vieler Achsen für antrieb sweep";
    no_step_of_setpoints = "the step is a positive time, such as 2ms" | "der Takt ist eine positive Zeit, etwa 2ms";
    too_many_setpoints(most, least) =
        "more than {most} rows; state at least {least} ms" | "mehr als {most} Zeilen; mindestens {least} ms angeben";
    moves =
        "Motion of an axis, every segment with the derived quantities"
        | "Bewegung einer Achse, jeder Abschnitt mit den abgeleiteten Größen";
    endpoints = "Description of the interface (OpenAPI)" | "Beschreibung der Schnittstelle (OpenAPI)";
    mounted_in_project =
        "Mounting of an actuator with the torques and loads of a project"
        | "Montage eines Antriebs mit den Drehmomenten und Lasten eines Projekts";
    pins_compared = "Comparison of a pin list with the manual" | "Vergleich einer Stiftliste mit der Anleitung";
    measured_judged = "Evaluation of measured values with likely causes" | "Auswertung gemessener Werte mit wahrscheinlichen Ursachen";
    commission_drive =
        "Drive settings as a file: parameters line by line (sinamics), or an EDS (cia402)"
        | "Einstellwerte für den Servoregler als Datei: Parameter zeilenweise (sinamics) oder ein EDS (cia402)";
    commission_checklist =
        "Checklists as PDF, a form to be completed on screen or on paper"
        | "Prüflisten als PDF, ein Formular zum Ausfüllen am Bildschirm oder auf Papier";
    encoder_trace =
        "The digital signals of an encoder over time, as a value change dump (VCD)"
        | "Die digitalen Signale eines Gebers über der Zeit, als VCD-Datei";
    upkeep_calendar = "The maintenance plan as iCalendar" | "Der Wartungsplan als iCalendar";
    no_such_path(path) = "there is no resource at {path}" | "unter {path} gibt es keine Ressource";
    paths_are_listed =
        "GET /api/v1/openapi.json lists all requests"
        | "GET /api/v1/openapi.json nennt alle Anfragen";
    wrong_method(path, method, valid) =
        "{path} does not accept {method}; valid: {valid}"
        | "{path} lässt {method} nicht zu; zulässig: {valid}";
    wrong_media(media, valid) =
        "a body of type {media} is not accepted here; send {valid}"
        | "ein Rumpf vom Typ {media} wird hier nicht angenommen; zulässig: {valid}";
    body_larger_than(most) =
        "the body has more than {most} bytes"
        | "der Rumpf hat mehr als {most} Bytes";
    body_too_slow(most) =
        "the body was not received within {most} s"
        | "der Rumpf wurde nicht innerhalb von {most} s empfangen";
    body_broken = "the body is incomplete or invalid" | "der Rumpf ist unvollständig oder ungültig";
    foreign_host(address) =
        "this server accepts requests for {address} and localhost only"
        | "dieser Server nimmt nur Anfragen für {address} und localhost an";
    foreign_site =
        "requests from other sites are not accepted"
        | "Anfragen anderer Websites werden nicht angenommen";
    of_a_sweep_only =
        "only the table of many axes has it: `new sweep`" | "das hat nur die Tabelle vieler Achsen: `new sweep`";
    token_missing =
        "the token is missing: open the whole address that `antrieb serve` printed in its window; programs send the token as bearer token"
        | "das Token fehlt: die ganze Adresse öffnen, die `antrieb serve` in seinem Fenster ausgegeben hat; Programme senden das Token als Bearer-Token";
    busy = "too many requests are waiting; try again in a moment" | "zu viele wartende Anfragen; in Kürze erneut versuchen";
    not_in_time(most) =
        "not answered within {most} s; reduce the work: fewer samples, a shorter cycle, one axis of several"
        | "in {most} s keine Antwort; Umfang verringern: weniger Stichproben, kürzerer Zyklus, eine Achse von mehreren";
    failed_inside =
        "internal error of the program; nothing was changed"
        | "interner Fehler des Programms; es wurde nichts geändert";
    no_two_projects(line, column) =
        "line {line}, column {column}: the body is not JSON with the texts `old` and `new`"
        | "Zeile {line}, Spalte {column}: der Rumpf ist kein JSON mit den Texten `old` und `new`";
    format_needs_a_table(format) =
        "{format} contains one table; name it with `table`"
        | "{format} enthält genau eine Tabelle; mit `table` angeben";
    workbook_has_all_tables =
        "the workbook contains all tables; omit `table`, or request csv, json or parquet"
        | "die Arbeitsmappe enthält alle Tabellen; `table` weglassen oder csv, json oder parquet anfordern";
}
