//! Words of the web workbench.

use crate::texts::texts;

texts! {
    title = "antrieb workbench" | "antrieb-Arbeitsplatz";
    skip_to_result = "Go to the result" | "Zum Ergebnis springen";
    what_moves = "What moves" | "Was sich bewegt";
    what_it_demands = "What it demands" | "Was es verlangt";
    what_fits = "What fits" | "Was geeignet ist";
    what_do_you_move = "What do you want to move?" | "Was wollen Sie bewegen?";
    start_about =
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
    text_of_the_file = "File (TOML)" | "Datei (TOML)";
    text_about =
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
    not_stated = "not stated" | "ohne Angabe";
    faults(count) = "1 fault in the project" | "1 Fehler im Projekt", "{count} faults in the project" | "{count} Fehler im Projekt";
    result_is_old =
        "The result shown belongs to the last project without faults."
        | "Das gezeigte Ergebnis gehört zum letzten fehlerfreien Projekt.";
    no_result_yet = "No result before the project is whole." | "Kein Ergebnis, bevor das Projekt vollständig ist.";
    at_line(line, column) = "line {line}, column {column}" | "Zeile {line}, Spalte {column}";
    sums = "Demand and reserve" | "Bedarf und Reserve";
    instant_on_the_axis = "Instant of the cycle" | "Zeitpunkt im Zyklus";
    cursor_about =
        "Moves a line through all diagrams over time and a point in the torque-speed plane."
        | "Bewegt eine Linie durch alle Diagramme über der Zeit und einen Punkt in der Drehmoment-Drehzahl-Ebene.";
    jump_to_worst = "Go to this instant" | "Zu diesem Zeitpunkt";
    checks_of(code) = "Checks of {code}" | "Nachweise von {code}";
    how_it_came_about = "How it came about" | "Wie es zustande kam";
    to_be_checked_state = "To have it checked, state:" | "Damit es geprüft wird, angeben:";
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
    least_dc_link = "DC link up to at least, V" | "Zwischenkreis bis mindestens, V";
    shown_of(shown, all) = "{shown} of {all} shown" | "{shown} von {all} gezeigt";
    more_fitting(count) = "1 more fits" | "1 weiterer geeignet", "{count} more fit" | "{count} weitere geeignet";
    side_by_side = "Side by side" | "Nebeneinander";
    compare_about = "Mark two to five actuators to compare them." | "Zwei bis fünf Antriebe markieren, um sie zu vergleichen.";
    mark(code) = "Mark {code}" | "{code} markieren";
    look_at(code) = "Look at {code}" | "{code} betrachten";
    what_would_let_it_in = "What would let it in" | "Was ihn geeignet machte";
    close = "Close" | "Schließen";
    tools = "Tools" | "Werkzeuge";
    tool_code = "Ordering code" | "Bestellbezeichnung";
    tool_data = "Data sheet" | "Datenblatt";
    tool_encoder = "Encoder signals" | "Gebersignale";
    tool_wiring = "Wiring" | "Verdrahtung";
    tool_mount = "Mounting" | "Montage";
    tool_commission = "Commissioning" | "Inbetriebnahme";
    tool_upkeep = "Upkeep" | "Instandhaltung";
    tool_glossary = "Glossary" | "Glossar";
    tool_errata = "Errata" | "Druckfehler";
    tool_curve = "Torque-speed curves" | "Kennlinien";
    tool_torsion = "Torsion";
    tool_bearing = "Output bearing" | "Abtriebslager";
    tool_inertia = "Moment of inertia" | "Massenträgheitsmoment";
    tool_battery = "Encoder battery" | "Geberbatterie";
    tool_record = "Measured values" | "Gemessene Werte";
    link_to_tool = "Link to these entries" | "Link auf diese Angaben";
    answer_is_old =
        "The answer shown belongs to the last entries without faults."
        | "Die gezeigte Antwort gehört zu den letzten fehlerfreien Angaben.";
    under_project = "Under the loads of the project that is open" | "Unter den Lasten des offenen Projekts";
    drive_sinamics = "Parameter list (SINAMICS)" | "Parameterliste (SINAMICS)";
    drive_eds = "Objects (EDS)" | "Objekte (EDS)";
    checklist_pdf = "Check-lists (PDF form)" | "Prüflisten (PDF-Formular)";
    calendar_file = "Calendar (ICS)" | "Kalender (ICS)";
    record_file = "Record (TOML)" | "Messprotokoll (TOML)";
    record_as_text = "Record as text (TOML)" | "Messprotokoll als Text (TOML)";
    one_a_line(label) = "{label}; one a line" | "{label}; je Zeile einer";
    measured_elsewhere(what) =
        "What is {what} is typed in under “Measured values” and judged there."
        | "Was {what} ist, wird unter „Gemessene Werte“ eingetippt und dort beurteilt.";
    folder = "Working folder" | "Arbeitsordner";
    saved(name) = "Saved: {name}" | "Gespeichert: {name}";
    changed_on_disk(name) =
        "{name} was changed on the disk since it was opened; it was left as it is. Open it anew, or save under another name."
        | "{name} wurde auf der Platte geändert, seit es geöffnet wurde; es blieb, wie es ist. Neu öffnen oder unter anderem Namen speichern.";
    browser_folder = "Kept in this browser" | "In diesem Browser aufbewahrt";
    kept_in_browser(name, button) =
        "Kept in this browser: {name}. “{button}” gives it to you as a file."
        | "In diesem Browser aufbewahrt: {name}. „{button}“ gibt es als Datei heraus.";
    changed_in_browser(name) =
        "{name} was saved from elsewhere since it was opened here, or the name is taken; it was left as it is. Open it anew, or save under another name."
        | "{name} wurde anderswo gespeichert, seit es hier geöffnet wurde, oder der Name ist vergeben; es blieb, wie es ist. Neu öffnen oder unter anderem Namen speichern.";
    forget_short = "Delete" | "Löschen";
    forget(name) = "Delete {name} from this browser" | "{name} aus diesem Browser löschen";
    browser_keeps_nothing =
        "The browser keeps no more files for this page: its room is full, or it is set to keep nothing. Nothing was saved."
        | "Der Browser bewahrt für diese Seite keine weiteren Dateien auf: Der Platz ist voll, oder er ist so eingestellt. Es wurde nichts gespeichert.";
    report_elsewhere =
        "The report as PDF is written by antrieb itself: `antrieb report`, or the page of `antrieb serve`."
        | "Den Bericht als PDF schreibt das installierte antrieb: `antrieb report` oder die Seite von `antrieb serve`.";
    engine_comes = "antrieb is being loaded; it then computes in this browser." | "antrieb wird geladen; es rechnet dann in diesem Browser.";
    needs_scripts = "The page computes in the browser and needs JavaScript." | "Die Seite rechnet im Browser und braucht JavaScript.";
    no_engine =
        "antrieb cannot be loaded here: this browser has no WebAssembly, or a file of the page is missing."
        | "antrieb lässt sich hier nicht laden: Dieser Browser hat kein WebAssembly, oder eine Datei der Seite fehlt.";
    other_version(name) =
        "In the folder {name} is another version than the one opened here. Loading it can be undone; keeping yours, the next save replaces it."
        | "Im Ordner steht {name} in einem anderen Stand als hier geöffnet. Das Laden lässt sich rückgängig machen; wird Ihrer behalten, ersetzt ihn das nächste Speichern.";
    no_version(name) =
        "{name} is not in the folder any more; the next save writes it anew."
        | "{name} ist nicht mehr im Ordner; das nächste Speichern schreibt die Datei neu.";
    load_it = "Load it" | "Laden";
    keep_mine = "Keep mine" | "Meinen behalten";
    from_elsewhere = "A file from elsewhere" | "Eine Datei von anderswo";
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
    recording_about =
        "Or paste the table of a recording anywhere into the page."
        | "Oder die Tabelle einer Aufzeichnung irgendwo in die Seite einfügen.";
    computed_here =
        "Everything is computed on this machine; project and recordings do not leave it."
        | "Alles wird auf diesem Rechner berechnet; Projekt und Aufzeichnungen verlassen ihn nicht.";
    no_such_page = "There is nothing at this address." | "Unter dieser Adresse gibt es nichts.";
    drawing_of(mechanism) = "Drawing: {mechanism}" | "Zeichnung: {mechanism}";
    play = "Play the motion" | "Bewegung abspielen";
    pause = "Pause" | "Anhalten";
    slower = "Slower" | "Langsamer";
    gains_in_use = "Gains in use; each leads to its field" | "Verwendete Reglerparameter; jeder führt zu seinem Feld";
    page_of_the_manual(number) = "page {number} of the manual" | "Seite {number} des Handbuchs";
    chapter_of_the_theory(name) = "theory: {name}" | "Theorie (englisch): {name}";
    worst_instant(time) = "at {time} s" | "bei {time} s";
    cancel = "Cancel" | "Abbrechen";
    was_cancelled = "Cancelled" | "Abgebrochen";
    result_before =
        "The result shown is the one from before the change."
        | "Das gezeigte Ergebnis ist das von vor der Änderung.";
    compute_again = "Compute again" | "Noch einmal rechnen";
    no_answer =
        "No answer from antrieb; the last change was not taken. Is the program still running?"
        | "Keine Antwort von antrieb; die letzte Änderung wurde nicht übernommen. Läuft das Programm noch?";
    all_axes = "All axes" | "Alle Achsen";
    axes_together = "All axes together" | "Alle Achsen zusammen";
    axes_about =
        "Mass and power of all axes are added as if each had its largest power at the same instant."
        | "Masse und Leistung aller Achsen sind addiert, als hätte jede ihre größte Leistung im selben Augenblick.";
    sum_of_known(known, all) = "sum of {known} of {all}" | "Summe von {known} aus {all}";
    sum = "sum" | "Summe";
    power_taken = "largest power taken at the motor terminals" | "größte Leistungsaufnahme an den Motorklemmen";
    power_returned = "largest power returned at the motor terminals" | "größte Rückspeiseleistung an den Motorklemmen";
    tolerances = "Tolerances" | "Toleranzen";
    tolerances_about(count) =
        "1 quantity has a tolerance; the result above is that of its nominal value."
        | "1 Größe hat eine Toleranz; das Ergebnis oben ist das ihres Nennwerts.",
        "{count} quantities have a tolerance; the result above is that of their nominal values."
        | "{count} Größen haben eine Toleranz; das Ergebnis oben ist das ihrer Nennwerte.";
    judge_tolerances = "Judge the tolerances" | "Toleranzen beurteilen";
    samples = "Samples" | "Stichproben";
    as_many_as_seconds_allow = "some seconds" | "einige Sekunden";
    tolerance_of(name) = "Tolerance of {name}" | "Toleranz von {name}";
    time_shown = "Time shown" | "Gezeigte Zeit";
    zoom_in = "Show less time, in more detail" | "Weniger Zeit zeigen, genauer";
    zoom_out = "Show more time" | "Mehr Zeit zeigen";
    window_back = "Earlier" | "Früher";
    window_on = "Later" | "Später";
    whole_cycle = "Whole cycle" | "Ganzer Zyklus";
    worst_instants = "Worst instants of the checks" | "Ungünstigste Zeitpunkte der Nachweise";
    end_of_segment(number, law) = "end of segment {number}, {law}" | "Ende von Abschnitt {number}, {law}";
    ends_at(time, way, unit) = "at {time} s, {way} {unit}" | "bei {time} s, {way} {unit}";
    grips_about =
        "Arrow keys to the side change the time of the segment, up and down its way; with Shift in larger steps."
        | "Pfeiltasten zur Seite ändern die Zeit des Abschnitts, auf und ab seinen Weg; mit Umschalttaste in größeren Schritten.";
    choose_by_picture = "Choose by its picture" | "Nach dem Bild wählen";
    law_pictures_about =
        "From top to bottom position, speed and acceleration over time"
        | "Von oben nach unten Position, Geschwindigkeit und Beschleunigung über der Zeit";
    trapezoid_with_pause = "trapezoid with pause" | "Trapez mit Pause";
    move_up(name) = "Move {name} up" | "{name} nach oben";
    once_more(name) = "Duplicate {name}" | "{name} verdoppeln";
    recognised(name) = "{name} (recognised)" | "{name} (erkannt)";
    no_column = "no column" | "keine Spalte";
    unit_of(name) = "Unit of {name}" | "Einheit von {name}";
    first_rows = "First rows of the file" | "Erste Zeilen der Datei";
    map_about = "A click on a point looks at this actuator." | "Ein Klick auf einen Punkt zeigt diesen Antrieb.";
    file = "File" | "Datei";
    export = "Export" | "Ausgabe";
    changed = "changed" | "geändert";
    saved_state = "saved" | "gespeichert";
    versions = "Versions of this session" | "Stände dieser Sitzung";
    picture_shown = "Picture shown (SVG)" | "Gezeigtes Bild (SVG)";
    find = "Find a key, check, code or term" | "Angabe, Nachweis, Bestellbezeichnung oder Begriff suchen";
    keyboard = "Keyboard" | "Tastatur";
    answers_again = "antrieb answers again." | "antrieb antwortet wieder.";
    draft_found = "There is unsaved work on this file:" | "Zu dieser Datei gibt es ungespeicherte Änderungen:";
    restore_draft = "Restore" | "Wiederherstellen";
    discard_draft = "Discard" | "Verwerfen";
    draft_restored =
        "The unsaved work was restored; undo leads back." | "Die ungespeicherten Änderungen sind wieder da; Rückgängig führt zurück.";
    tightest = "Tightest:" | "Engster Nachweis:";
    panes = "Panes" | "Bereiche";
    border_left = "Width of the left pane" | "Breite des linken Bereichs";
    border_right = "Width of the right pane" | "Breite des rechten Bereichs";
    view_cycle = "Cycle" | "Zyklus";
    view_torque_speed = "Torque-speed" | "Kennfeld";
    view_heat = "Heat" | "Erwärmung";
    view_energy = "Energy" | "Energie";
    view_bearing = "Bearing" | "Lager";
    scenario = "Scenario" | "Szenario";
    view_simulation = "Simulation";
    view_error_budget = "Error budget" | "Fehlerbudget";
    full_window = "Picture in the full window" | "Bild im ganzen Fenster";
    copy_svg = "Copy SVG" | "SVG kopieren";
    copy_data = "Copy data" | "Daten kopieren";
    without_limit_head = "Shown without a limit" | "Ohne Grenze gezeigt";
    why_not = "Why not" | "Warum nicht";
    map = "Map" | "Karte";
    sort_by(column) = "Sort by {column}" | "Nach {column} ordnen";
    load_hangs = "load not held" | "Last ungehalten";
    usual_values =
        "The values are usual ones, offered as a start; replace them by yours."
        | "Die Werte sind übliche Anfangswerte; durch eigene ersetzen.";
    back = "Back" | "Zurück";
    reverse(name) = "Reverse {name}" | "{name} umkehren";
    recording_is_there(file) =
        "{file} lies beside the projects now. It begins so:" | "{file} liegt jetzt neben den Projekten. So fängt sie an:";
    replace_motion = "Replace the motion by it" | "Bewegung dadurch ersetzen";
    checks_wait(count) =
        "1 check needs it" | "1 Nachweis braucht es", "{count} checks need it" | "{count} Nachweise brauchen es";
    more_faults(count) = "1 more" | "1 weiterer", "{count} more" | "{count} weitere";
    nothing_found = "Nothing found" | "Nichts gefunden";
    key_panes = "What moves, what it demands, what fits" | "Was sich bewegt, was es verlangt, was geeignet ist";
    key_escape = "Close what is open" | "Offenes schließen";
    key_zoom = "At the instant: less time, more time, whole cycle" | "Am Zeitpunkt: weniger Zeit, mehr Zeit, ganzer Zyklus";
    key_arrows =
        "Instant, end of a segment, border, next tab" | "Zeitpunkt, Ende eines Abschnitts, Trennlinie, nächster Reiter";
    no_versions = "Nothing was changed yet." | "Noch wurde nichts geändert.";
    this_version = "This is what is open now." | "Das ist der offene Stand.";
    first_version = "The beginning" | "Der Anfang";
    back_to_version = "Back to this version" | "Zurück zu diesem Stand";
    only_layout = "Only comments or layout" | "Nur Kommentare oder Gestaltung";
    cycle_of(time) = "cycle {time} s" | "Zyklus {time} s";
    name_is_taken(name) =
        "A file named {name} is there already; it was left as it is. Open it, or save under another name."
        | "Eine Datei namens {name} gibt es schon; sie blieb, wie sie ist. Öffnen oder unter anderem Namen speichern.";
    group_geometry = "Geometry" | "Geometrie";
    group_masses = "Masses" | "Massen";
    group_forces = "Forces, friction, efficiency" | "Kräfte, Reibung, Wirkungsgrad";
    components = "Components of the page" | "Bausteine der Seite";
    components_type = "type" | "Schrift";
    components_buttons = "buttons and tabs" | "Knöpfe und Reiter";
    components_fields = "fields" | "Felder";
}
