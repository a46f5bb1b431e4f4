//! What is said of requests over HTTP: what there is, and why one is not answered.

use crate::texts::texts;

texts! {
    title = "antrieb over HTTP" | "antrieb über HTTP";
    about =
        "The use cases of the command line. An answer is byte for byte what the same command writes with --json when it reads the project from standard input; a question that cannot be answered has the status 422 and every fault at once."
        | "Die Anwendungsfälle der Kommandozeile. Eine Antwort ist Byte für Byte das, was derselbe Befehl mit --json schreibt, wenn er das Projekt von der Standardeingabe liest; eine Frage, die sich nicht beantworten lässt, hat den Status 422 und alle Fehler auf einmal.";
    answered = "the answer" | "die Antwort";
    not_answered = "why there is no answer" | "warum es keine Antwort gibt";
    project_body = "the text of a project file (TOML)" | "der Text einer Projektdatei (TOML)";
    two_projects_body = "the texts of two project files" | "die Texte zweier Projektdateien";
    pins_body = "a list of pins (CSV)" | "eine Stiftliste (CSV)";
    measured_body = "measured values (TOML)" | "gemessene Werte (TOML)";
    lang = "Language of the texts, en (without it) or de" | "Sprache der Texte, en (ohne Angabe) oder de";
    file =
        "What the project is called in faults and files (stdin)"
        | "Wie das Projekt in Fehlern und Dateien heißt (stdin)";
    format =
        "json, csv or parquet for one table, xlsx for the workbook; without it json where a table is named, else xlsx"
        | "json, csv oder parquet für eine Tabelle, xlsx für die Mappe; ohne Angabe json, wo eine Tabelle genannt ist, sonst xlsx";
    figure = "Which picture" | "Welches Bild";
    kind = "Kind of the project" | "Art des Projekts";
    moves =
        "The motion of an axis, every segment with what follows from it"
        | "Die Bewegung einer Achse, jeder Abschnitt mit dem, was aus ihm folgt";
    endpoints = "What can be asked, as OpenAPI" | "Was sich fragen lässt, als OpenAPI";
    mounted_in_project =
        "How an actuator is mounted under the torques and loads of a project"
        | "Wie ein Antrieb unter den Drehmomenten und Lasten eines Projekts montiert wird";
    pins_compared = "A list of pins compared with the print" | "Eine Stiftliste, mit dem Druck verglichen";
    measured_judged = "Measured values judged, with likely causes" | "Gemessene Werte beurteilt, mit wahrscheinlichen Ursachen";
    commission_drive =
        "Values for the drive as a file: parameters line by line (sinamics), or an EDS (cia402)"
        | "Werte für den Regler als Datei: Parameter zeilenweise (sinamics) oder eine EDS (cia402)";
    commission_checklist =
        "The check-lists as PDF, a form to fill in on the screen or on paper"
        | "Die Prüflisten als PDF, ein Formular zum Ausfüllen am Bildschirm oder auf Papier";
    encoder_trace =
        "The digital signals of an encoder over time, as a value change dump (VCD)"
        | "Die digitalen Signale eines Gebers über der Zeit, als VCD-Datei";
    upkeep_calendar = "The same plan as iCalendar" | "Derselbe Plan als iCalendar";
    no_such_path(path) = "there is nothing at {path}" | "unter {path} gibt es nichts";
    paths_are_listed =
        "GET /api/v1/openapi.json lists what can be asked"
        | "GET /api/v1/openapi.json nennt, was sich fragen lässt";
    wrong_method(path, method, valid) =
        "{path} does not answer to {method}, but to {valid}"
        | "{path} beantwortet nicht {method}, sondern {valid}";
    wrong_media(media, valid) =
        "a body of type {media} is not read here; send {valid}"
        | "ein Rumpf vom Typ {media} wird hier nicht gelesen; senden: {valid}";
    body_larger_than(most) =
        "the body has more than {most} bytes"
        | "der Rumpf hat mehr als {most} Bytes";
    body_too_slow(most) =
        "the body did not come within {most} s"
        | "der Rumpf ist nicht innerhalb von {most} s gekommen";
    body_broken = "the body breaks off or is none" | "der Rumpf bricht ab oder ist keiner";
    foreign_host(address) =
        "this server answers for {address} and localhost only"
        | "dieser Server antwortet nur für {address} und localhost";
    foreign_site =
        "what another site sends is not taken"
        | "was eine andere Website schickt, wird nicht angenommen";
    token_missing =
        "the token is missing: open the address that `antrieb serve` has printed, or send it as a bearer token"
        | "das Token fehlt: die Adresse öffnen, die `antrieb serve` ausgegeben hat, oder es als Bearer-Token senden";
    busy = "too many requests are waiting; try again in a moment" | "zu viele Anfragen warten; gleich noch einmal versuchen";
    not_in_time(most) =
        "not answered within {most} s; reduce the work: fewer samples, a shorter cycle, one axis of several"
        | "in {most} s keine Antwort; Umfang verringern: weniger Stichproben, kürzerer Zyklus, eine Achse von mehreren";
    failed_inside =
        "the answer failed inside the program; nothing was changed"
        | "die Antwort ist im Programm gescheitert; es wurde nichts geändert";
    no_two_projects(line, column) =
        "line {line}, column {column}: the body is not JSON with the texts `old` and `new`"
        | "Zeile {line}, Spalte {column}: der Rumpf ist kein JSON mit den Texten `old` und `new`";
    format_needs_a_table(format) =
        "{format} holds one table; name it with `table`"
        | "{format} enthält eine Tabelle; sie mit `table` nennen";
    workbook_has_all_tables =
        "the workbook holds every table; omit `table`, or request csv, json or parquet"
        | "die Mappe enthält alle Tabellen; `table` weglassen oder csv, json oder parquet verlangen";
}
