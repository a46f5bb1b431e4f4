//! Words of the web workbench.

use crate::texts::texts;

texts! {
    title = "antrieb workbench" | "antrieb-Arbeitsplatz";
    skip_to_result = "Go to the result" | "Zum Ergebnis springen";
    what_moves = "What moves" | "Was sich bewegt";
    what_it_demands = "What it demands" | "Was es verlangt";
    what_fits = "What fits" | "Was geeignet ist";
    what_do_you_move = "What do you want to move?" | "Was wollen Sie bewegen?";
    start_told =
        "Choose what is nearest; a few figures lead to a first answer, and everything can be changed later."
        | "Wählen Sie, was am nächsten kommt; wenige Angaben führen zu einer ersten Antwort, und alles lässt sich später ändern.";
    or_an_example = "or begin with an example" | "oder mit einem Beispiel beginnen";
    or_a_file = "or open a project file" | "oder eine Projektdatei öffnen";
    first_answer = "First answer" | "Erste Antwort";
    new_project = "New" | "Neu";
    open = "Open" | "Öffnen";
    save = "Save" | "Speichern";
    save_as = "File name" | "Dateiname";
    undo = "Undo" | "Rückgängig";
    redo = "Redo" | "Wiederholen";
    project_file = "Project file (TOML)" | "Projektdatei (TOML)";
    report_pdf = "Report (PDF)" | "Bericht (PDF)";
    workbook = "Workbook (XLSX)" | "Arbeitsmappe (XLSX)";
    data_json = "Data (JSON)" | "Daten (JSON)";
    link_to_this = "Link to this state" | "Link auf diesen Stand";
    other_language = "Deutsch" | "English";
    dark = "Dark" | "Dunkel";
    text_of_the_file = "Project file as text (TOML)" | "Projektdatei als Text (TOML)";
    text_told =
        "The same file as every other way of using antrieb; what is changed here moves the page, and the other way round."
        | "Dieselbe Datei wie auf allen anderen Wegen zu antrieb; was hier geändert wird, bewegt die Seite, und umgekehrt.";
    further(count) = "1 further entry" | "1 weitere Angabe", "{count} further entries" | "{count} weitere Angaben";
    mechanism = "Mechanism" | "Mechanismus";
    what_it_is = "What it is" | "Was es ist";
    load_at_the_output = "Load at the output" | "Last am Abtrieb";
    add_segment = "Add segment" | "Abschnitt anfügen";
    add_entry = "Add" | "Anfügen";
    remove(name) = "Remove {name}" | "{name} entfernen";
    move_down(name) = "Move {name} down" | "{name} nach unten";
    segment(number) = "Segment {number}" | "Abschnitt {number}";
    follows(value) = "follows: {value}" | "folgt: {value}";
    for_example(value) = "e.g. {value}" | "z. B. {value}";
    not_stated = "not stated" | "nicht angegeben";
    faults(count) = "1 fault in the project" | "1 Fehler im Projekt", "{count} faults in the project" | "{count} Fehler im Projekt";
    result_is_old =
        "The result shown belongs to the last project without faults."
        | "Das gezeigte Ergebnis gehört zum letzten fehlerfreien Projekt.";
    no_result_yet = "No result before the project is whole." | "Kein Ergebnis, bevor das Projekt vollständig ist.";
    at_line(line, column) = "line {line}, column {column}" | "Zeile {line}, Spalte {column}";
    sums = "Demand and reserve" | "Bedarf und Reserve";
    instant_on_the_axis = "Instant of the cycle" | "Zeitpunkt im Zyklus";
    cursor_told =
        "Moves a line through all diagrams over time and a point in the torque-speed plane."
        | "Bewegt eine Linie durch alle Diagramme über der Zeit und einen Punkt in der Drehmoment-Drehzahl-Ebene.";
    jump_to_worst = "Go to this instant" | "Zu diesem Zeitpunkt";
    checks_of(code) = "Checks of {code}" | "Nachweise von {code}";
    how_it_came_about = "How it came about" | "Wie es zustande kam";
    to_be_checked_state = "To have it checked, state:" | "Damit es geprüft wird, angeben:";
    ranking = "Ranking" | "Rangfolge";
    filter = "Filter";
    size = "Size" | "Baugröße";
    feedback = "Feedback" | "Messsystem";
    brake = "Brake" | "Bremse";
    any = "any" | "beliebig";
    with_brake = "with brake" | "mit Bremse";
    without_brake = "without brake" | "ohne Bremse";
    least_bore = "Bore at least, mm" | "Bohrung mindestens, mm";
    greatest_length = "Length at most, mm" | "Länge höchstens, mm";
    greatest_mass = "Mass at most, kg" | "Masse höchstens, kg";
    shown_of(shown, all) = "{shown} of {all} shown" | "{shown} von {all} gezeigt";
    more_fitting(count) = "1 more fits" | "1 weiterer geeignet", "{count} more fit" | "{count} weitere geeignet";
    side_by_side = "Side by side" | "Nebeneinander";
    compare_told = "Mark two to five actuators to compare them." | "Zwei bis fünf Antriebe markieren, um sie zu vergleichen.";
    mark(code) = "Mark {code}" | "{code} markieren";
    look_at(code) = "Look at {code}" | "{code} betrachten";
    what_would_let_it_in = "What would let it in" | "Was ihn geeignet machte";
    close = "Close" | "Schließen";
    tools = "Tools" | "Werkzeuge";
    tool_code = "Ordering code" | "Bestellbezeichnung";
    tool_data = "Data sheet" | "Datenblatt";
    tool_wiring = "Wiring" | "Verdrahtung";
    tool_mount = "Mounting" | "Montage";
    tool_commission = "Commissioning" | "Inbetriebnahme";
    tool_upkeep = "Upkeep" | "Instandhaltung";
    tool_glossary = "Glossary" | "Glossar";
    tool_errata = "Errata" | "Druckfehler";
    delivered_on = "Delivered on" | "Geliefert am";
    folder = "Working folder" | "Arbeitsordner";
    saved(name) = "Saved: {name}" | "Gespeichert: {name}";
    changed_on_disk(name) =
        "{name} was changed on the disk since it was opened; it was left as it is. Open it anew, or save under another name."
        | "{name} wurde auf der Platte geändert, seit es geöffnet wurde; es blieb, wie es ist. Neu öffnen oder unter anderem Namen speichern.";
    not_a_text(name) =
        "{name} is not UTF-8; save it as UTF-8 and open it again"
        | "{name} ist nicht UTF-8; als UTF-8 speichern und erneut öffnen";
    no_such_name(name) =
        "{name} is no name of a project file: letters, digits, hyphen, underscore, point, ending .toml"
        | "{name} ist kein Name einer Projektdatei: Buchstaben, Ziffern, Bindestrich, Unterstrich, Punkt, Endung .toml";
    no_recording_name(name) =
        "{name} is no name of a recording: letters, digits, hyphen, underscore, point, ending .csv, .txt or .parquet"
        | "{name} ist kein Name einer Aufzeichnung: Buchstaben, Ziffern, Bindestrich, Unterstrich, Punkt, Endung .csv, .txt oder .parquet";
    add_recording = "Add recording" | "Aufzeichnung anfügen";
    recording_told =
        "Or paste the table of a recording anywhere into the page."
        | "Oder die Tabelle einer Aufzeichnung irgendwo in die Seite einfügen.";
    computed_here =
        "Everything is computed on this machine; project and recordings do not leave it."
        | "Alles wird auf diesem Rechner berechnet; Projekt und Aufzeichnungen verlassen ihn nicht.";
    no_such_page = "There is nothing at this address." | "Unter dieser Adresse gibt es nichts.";
    drawing_of(mechanism) = "Drawing: {mechanism}" | "Zeichnung: {mechanism}";
    worst_instant(time) = "at {time} s" | "bei {time} s";
}
