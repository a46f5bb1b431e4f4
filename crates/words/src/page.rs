//! Words for the web workbench.

use crate::texts::texts;

texts! {
    another_gear =
        "the limit is a gear rating of another manufacturer, not of this actuator"
        | "die Grenze ist die eines Getriebes eines anderen Herstellers, nicht dieses Antriebs";
    title = "antrieb workbench" | "antrieb im Browser";
    skip_to_result = "Go to the result" | "Zum Ergebnis springen";
    what_moves = "Load and motion" | "Last und Bewegung";
    what_it_demands = "Demand" | "Belastung";
    what_fits = "Suitable actuators" | "Geeignete Antriebe";
    what_do_you_move = "What do you want to move?" | "Was möchten Sie bewegen?";
    start_about =
        "Choose the closest match; a few values lead to a first result, and everything can be changed later."
        | "Wählen Sie die nächstliegende Anwendung; wenige Angaben führen zu einem ersten Ergebnis, alles lässt sich später ändern.";
    or_an_example = "or start with an example" | "oder mit einem Beispiel beginnen";
    what_this_is =
        "antrieb sizes servo actuators: it evaluates every actuator of the catalogue for a load and a motion, and derives each figure from its source."
        | "antrieb legt Servoantriebe aus: Für eine Last und eine Bewegung wird jeder Antrieb des Katalogs bewertet und jede Zahl aus ihrer Quelle hergeleitet.";
    or_a_file = "or open a project file" | "oder eine Projektdatei öffnen";
    first_answer = "First result" | "Erstes Ergebnis";
    new_project = "New" | "Neu";
    new_axis = "New axis" | "Neue Achse";
    new_axis_about =
        "Adds an axis to the file: choose its mechanism, and state what defines it."
        | "Ergänzt die Datei um eine Achse: Mechanik wählen und die bestimmenden Werte angeben.";
    axis_number(number) = "axis {number}" | "Achse {number}";
    bodies_of(name) = "{name} from bodies" | "{name} aus Körpern";
    body_number(number) = "Body {number}" | "Körper {number}";
    shape_of(body) = "Shape, {body}" | "Form, {body}";
    without_body = "remove" | "entfernen";
    further_body = "add a body" | "Körper hinzufügen";
    no_body(line) = "{line}: not a body" | "{line}: kein Körper";
    orientation = "Orientation" | "Lage";
    lies_parallel = "parallel to the axis of rotation" | "parallel zur Drehachse";
    lies_across = "perpendicular, lying" | "senkrecht dazu, liegend";
    material = "Material" | "Werkstoff";
    by_mass_or_density = "by mass or density" | "nach Masse oder Dichte";
    steel = "steel" | "Stahl";
    aluminium = "aluminium" | "Aluminium";
    fill_field(name, value) = "{name}: use {value}" | "{name}: {value} übernehmen";
    bodies_drawn =
        "Bodies to scale, seen along the axis of rotation" | "Körper maßstäblich, in Richtung der Drehachse gesehen";
    tools_of_actuator = "Of an actuator" | "Zu einem Antrieb";
    tools_in_general = "Calculators and reference" | "Rechner und Nachschlagen";
    power_over_time = "Power at the motor terminals over time" | "Leistung an den Motorklemmen über der Zeit";
    power_over_time_about =
        "Each axis over its own cycle from its start; how the cycles of several axes are shifted against each other is not stated in the file."
        | "Jede Achse über ihren eigenen Zyklus ab dessen Beginn; wie die Zyklen mehrerer Achsen zueinander liegen, steht nicht in der Datei.";
    open = "Open" | "Öffnen";
    save = "Save" | "Speichern";
    print = "Print the first page of the report" | "Erste Seite des Berichts drucken";
    save_as = "File name" | "Dateiname";
    undo = "Undo" | "Rückgängig";
    redo = "Redo" | "Wiederholen";
    project_file = "Project file (TOML)" | "Projektdatei (TOML)";
    report_pdf = "Report (PDF)" | "Bericht (PDF)";
    title_page = "Title page and extent of the report" | "Deckblatt und Umfang des Berichts";
    change_lines =
        "List of changes, one per line: revision; date; name; text"
        | "Änderungsliste, je Zeile: Revision; Datum; Name; Text";
    with_derivations = "with derivations and all sources" | "mit Herleitungen und allen Quellen";
    with_installation = "with wiring, mounting and commissioning" | "mit Verdrahtung, Montage und Inbetriebnahme";
    as_archive = "PDF/A for archiving" | "PDF/A zum Archivieren";
    workbook = "Workbook (XLSX)" | "Arbeitsmappe (XLSX)";
    data_json = "Data (JSON)" | "Daten (JSON)";
    link_to_this = "Link to this version" | "Link auf diesen Stand";
    other_language = "Deutsch" | "English";
    dark = "Dark" | "Dunkel";
    text_of_the_file = "File (TOML)" | "Datei (TOML)";
    text_about =
        "The same file as used by the command line and all other interfaces; changes made here appear on the page and vice versa."
        | "Dieselbe Datei, die auch Befehlszeile und alle anderen Schnittstellen verwenden; Änderungen hier erscheinen auf der Seite und umgekehrt.";
    further(count) = "1 further entry" | "1 weitere Angabe", "{count} further entries" | "{count} weitere Angaben";
    mechanism = "Mechanism" | "Mechanik";
    what_it_is = "Type" | "Art";
    load_at_the_output = "Load at the output" | "Last am Abtrieb";
    add_segment = "Add segment" | "Abschnitt hinzufügen";
    add_entry = "Add" | "Hinzufügen";
    remove(name) = "Remove {name}" | "{name} entfernen";
    move_down(name) = "Move {name} down" | "{name} nach unten";
    segments(first, last) = "Segments {first} to {last}" | "Abschnitte {first} bis {last}";
    segment(number) = "Segment {number}" | "Abschnitt {number}";
    follows(value) = "derived: {value}" | "berechnet: {value}";
    for_example(value) = "example: {value}" | "Beispiel: {value}";
    not_stated = "not stated" | "ohne Angabe";
    faults(count) = "1 fault in the project" | "1 Fehler im Projekt", "{count} faults in the project" | "{count} Fehler im Projekt";
    result_is_old =
        "The result shown belongs to the last project without faults."
        | "Das gezeigte Ergebnis gehört zum letzten fehlerfreien Projekt.";
    no_result_yet = "No result until the project is complete." | "Kein Ergebnis, bis das Projekt vollständig ist.";
    at_line(line, column) = "line {line}, column {column}" | "Zeile {line}, Spalte {column}";
    sums = "Demand and reserve" | "Belastung und Reserve";
    instant_on_the_axis = "Instant of the cycle" | "Zeitpunkt im Zyklus";
    cursor_about =
        "Moves a cursor line through all time diagrams and a point in the torque-speed plane."
        | "Bewegt eine Cursorlinie durch alle Zeitdiagramme und einen Punkt in der Drehmoment-Drehzahl-Ebene.";
    jump_to_worst = "Go to this instant" | "Zu diesem Zeitpunkt";
    checks_of(code) = "Checks of {code}" | "Nachweise von {code}";
    how_it_came_about = "Derivation" | "Herleitung";
    to_be_checked_state = "Required for the check:" | "Für den Nachweis erforderlich:";
    filter = "Filter";
    size = "Size" | "Baugröße";
    feedback = "Encoder" | "Geber";
    brake = "Brake" | "Bremse";
    any = "any" | "beliebig";
    with_brake = "with brake" | "mit Bremse";
    without_brake = "without brake" | "ohne Bremse";
    least_bore = "Min. bore, mm" | "Hohlwelle mindestens, mm";
    greatest_length = "Max. length, mm" | "Länge höchstens, mm";
    greatest_mass = "Max. mass, kg" | "Masse höchstens, kg";
    least_dc_link = "Min. U_DCmax, V" | "U_DCmax mindestens, V";
    shown_of(shown, all) = "{shown} of {all} shown" | "{shown} von {all} gezeigt";
    more_fitting(count) = "1 more fits" | "1 weiterer geeignet", "{count} more fit" | "{count} weitere geeignet";
    side_by_side = "Side by side" | "Nebeneinander";
    compare_about = "Select two to five actuators for comparison." | "Zwei bis fünf Antriebe zum Vergleich auswählen.";
    mark(code) = "Select {code}" | "{code} auswählen";
    look_at(code) = "Show {code}" | "{code} anzeigen";
    change_when_selected = "The cycle is long: select an actuator to see what would make it fit" | "Der Zyklus ist lang: Antrieb auswählen, um die notwendige Änderung zu sehen";
    no_single_change = "no single change of load, cycle time or ambient temperature" | "keine einzelne Änderung von Last, Zykluszeit oder Umgebungstemperatur";
    what_would_let_it_in = "What would make it fit" | "Notwendige Änderung";
    close = "Close" | "Schließen";
    tools = "Tools" | "Werkzeuge";
    angular_errors = "Angular errors at the output" | "Winkelfehler am Abtrieb";
    angular_error = "Error" | "Fehler";
    share_of_the_sum = "Share" | "Anteil";
    error_not_known = "not known, counted as zero" | "nicht bekannt, als null gezählt";
    sum_of_errors = "Sum, all in the same direction" | "Summe, alle in derselben Richtung";
    root_of_errors = "Root sum square, independent" | "Wurzel aus der Quadratsumme, unabhängig";
    tool_of_codes_only(name) =
        "{name} is a product of a catalogue file. Of it only what the checks need is known; this page is about ordering codes of the built-in series."
        | "{name} ist ein Produkt einer Katalogdatei. Von ihm ist nur bekannt, was die Nachweise benötigen; diese Seite gilt für Bestellbezeichnungen der eingebauten Baureihe.";
    tool_code = "Ordering code" | "Bestellbezeichnung";
    tool_data = "Data sheet" | "Datenblatt";
    tool_encoder = "Encoder signals" | "Gebersignale";
    tool_wiring = "Wiring" | "Verdrahtung";
    tool_mount = "Mounting" | "Montage";
    tool_commission = "Commissioning" | "Inbetriebnahme";
    tool_upkeep = "Maintenance" | "Wartung";
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
    under_project = "With the loads of the open project" | "Mit den Lasten des geöffneten Projekts";
    drive_sinamics = "Parameter list (SINAMICS)" | "Parameterliste (SINAMICS)";
    drive_eds = "Objects (EDS)" | "Objekte (EDS)";
    checklist_pdf = "Checklists (PDF form)" | "Prüflisten (PDF-Formular)";
    calendar_file = "Calendar (ICS)" | "Kalender (ICS)";
    record_file = "Record (TOML)" | "Messprotokoll (TOML)";
    record_as_text = "Record as text (TOML)" | "Messprotokoll als Text (TOML)";
    one_a_line(label) = "{label}; one per line" | "{label}; einer je Zeile";
    measured_elsewhere(what) =
        "Values marked “{what}” are entered and evaluated under “Measured values”."
        | "Mit „{what}“ gekennzeichnete Werte werden unter „Gemessene Werte“ eingegeben und ausgewertet.";
    folder = "Working folder, latest changes first" | "Arbeitsordner, zuletzt Geändertes zuerst";
    saved(name) = "Saved: {name}" | "Gespeichert: {name}";
    changed_on_disk(name) =
        "{name} has been changed on disk since it was opened and was not overwritten. Open it again, or save under another name."
        | "{name} wurde seit dem Öffnen auf dem Datenträger geändert und nicht überschrieben. Neu öffnen oder unter anderem Namen speichern.";
    browser_folder = "Stored in this browser" | "In diesem Browser gespeichert";
    kept_in_browser(name, button) =
        "Stored in this browser: {name}. Use “{button}” to save it as a file."
        | "In diesem Browser gespeichert: {name}. Mit „{button}“ als Datei sichern.";
    changed_in_browser(name) =
        "{name} has been saved elsewhere since it was opened here, or the name is in use; the file was not overwritten. Open it again, or save under another name."
        | "{name} wurde seit dem Öffnen an anderer Stelle gespeichert, oder der Name ist vergeben; die Datei wurde nicht überschrieben. Neu öffnen oder unter anderem Namen speichern.";
    forget_short = "Delete" | "Löschen";
    forget(name) = "Delete {name} from this browser" | "{name} aus diesem Browser löschen";
    browser_keeps_nothing =
        "The browser cannot store any more files for this page: its storage is full or disabled. Nothing was saved."
        | "Der Browser kann für diese Seite keine weiteren Dateien speichern: Sein Speicher ist voll oder abgeschaltet. Es wurde nichts gespeichert.";
    report_elsewhere =
        "The PDF report is written by the installed antrieb: `antrieb report`, or the page of `antrieb serve`."
        | "Den Bericht als PDF schreibt das installierte antrieb: `antrieb report` oder die Seite von `antrieb serve`.";
    engine_comes = "antrieb is being loaded; all calculations then run in this browser." | "antrieb wird geladen; danach wird in diesem Browser gerechnet.";
    needs_scripts = "The page computes in the browser and requires JavaScript." | "Die Seite rechnet im Browser und benötigt JavaScript.";
    no_engine =
        "antrieb cannot be loaded here: this browser has no WebAssembly, or a file of the page is missing."
        | "antrieb lässt sich hier nicht laden: Dieser Browser hat kein WebAssembly, oder eine Datei der Seite fehlt.";
    other_version(name) =
        "The version of {name} in the folder differs from the one opened here. Loading it can be undone; if you keep your version, the next save replaces the file."
        | "Der Stand von {name} im Ordner weicht vom hier geöffneten ab. Das Laden lässt sich rückgängig machen; behalten Sie Ihre Fassung, ersetzt das nächste Speichern die Datei.";
    no_version(name) =
        "{name} is no longer in the folder; the next save creates it again."
        | "{name} ist nicht mehr im Ordner; das nächste Speichern legt die Datei neu an.";
    taken_over(name) = "{name} was changed elsewhere and has been read again; ↶ reverts it." | "{name} wurde an anderer Stelle geändert und neu eingelesen; ↶ macht es rückgängig.";
    joined(name) =
        "{name} was changed elsewhere; the changes there and the unsaved ones here are joined."
        | "{name} wurde an anderer Stelle geändert; die Änderungen dort und die hier noch nicht gespeicherten sind zusammengeführt.";
    both_changed(name) = "{name} was changed elsewhere, and these values differ:" | "{name} wurde an anderer Stelle geändert, und diese Angaben unterscheiden sich:";
    here_and_there(label, here, there) = "{label}: here {here}, there {there}" | "{label}: hier {here}, dort {there}";
    keep_these = "Keep the values here" | "Angaben von hier behalten";
    take_theirs = "Take those of the file" | "Angaben der Datei übernehmen";
    load_it = "Load" | "Laden";
    keep_mine = "Keep my version" | "Eigene Fassung behalten";
    from_elsewhere = "Open another file" | "Andere Datei öffnen";
    not_a_text(name) =
        "{name} is not UTF-8; save it as UTF-8 and open it again"
        | "{name} ist nicht UTF-8; als UTF-8 speichern und erneut öffnen";
    no_such_name(name) =
        "{name} is not a valid name of a project file: letters, digits, hyphen, underscore, point, ending .toml"
        | "{name} ist kein gültiger Name einer Projektdatei: Buchstaben, Ziffern, Bindestrich, Unterstrich, Punkt, Endung .toml";
    no_recording_name(name) =
        "{name} is not a valid name of a recording: letters, digits, hyphen, underscore, point, ending .csv, .txt or .parquet"
        | "{name} ist kein gültiger Name einer Aufzeichnung: Buchstaben, Ziffern, Bindestrich, Unterstrich, Punkt, Endung .csv, .txt oder .parquet";
    add_recording = "Add recording" | "Aufzeichnung hinzufügen";
    recording_about =
        "Or paste the table of a recording anywhere on the page."
        | "Oder die Tabelle einer Aufzeichnung an beliebiger Stelle der Seite einfügen.";
    computed_here =
        "All calculations run on this computer; project and recordings do not leave it."
        | "Alles wird auf diesem Rechner berechnet; Projekt und Aufzeichnungen verlassen ihn nicht.";
    no_such_page = "There is no page at this address." | "Unter dieser Adresse gibt es keine Seite.";
    drawing_of(mechanism) = "Drawing: {mechanism}" | "Zeichnung: {mechanism}";
    play = "Play the motion" | "Bewegung abspielen";
    pause = "Pause" | "Anhalten";
    slower = "½×: slower" | "½×: langsamer";
    page_of_the_manual(number) = "page {number} of the manual" | "Seite {number} der Anleitung";
    states = "States of the page" | "Zustände der Seite";
    fault_in_the_file = "fault in the file" | "Fehler in der Datei";
    on_a_phone = "on a phone" | "auf dem Telefon";
    theory = "theory" | "Theorie";
    chapters_of_the_theory = "Chapters of the theory" | "Kapitel der Theorie";
    theory_folder = "theory/" | "theory/de/";
    about_the_theory =
        "The models of antrieb with their equations, sources and limits."
        | "Die Modelle von antrieb mit Gleichungen, Quellen und Gültigkeitsgrenzen.";
    worst_instant(time) = "at {time}\u{a0}s" | "bei {time}\u{a0}s";
    another_law = "Another law of motion" | "Anderes Bewegungsgesetz";
    what_would_fit = "What would fit" | "Was geeignet wäre";
    searching_remedies = "Searching for changes with which an actuator fits …" | "Änderungen werden gesucht, mit denen ein Antrieb geeignet ist …";
    no_remedy_found =
        "No single change was found: not of the cycle time, of payload or masses, of a ratio up to 16 times larger or smaller, nor with an intermediate stage, a counterweight or up to eight equal actuators. Change several values."
        | "Keine einzelne Änderung gefunden: weder der Zykluszeit, der Nutzlast oder der Massen, einer Übersetzung bis zum 16-Fachen nach oben oder unten noch mit einer Zwischenstufe, einem Gegengewicht oder bis zu acht gleichen Antrieben. Mehrere Angaben ändern.";
    no_remedy_yet(actuators) =
        "The cycle is long, so only the {actuators} nearest kinds of actuator were tried, and not every change of them; no single change was found among these. Others may exist: a slower motion, a smaller load, another diameter or ratio."
        | "Der Zyklus ist lang; deshalb wurden nur die {actuators} nächstliegenden Antriebsarten und nicht jede Änderung versucht. Darunter fand sich keine einzelne Änderung. Andere sind möglich: eine langsamere Bewegung, eine kleinere Last, ein anderer Durchmesser oder eine andere Übersetzung.";
    remedies_about =
        "Each change alone is sufficient; ↶ reverts it."
        | "Jede Änderung genügt für sich; ↶ macht sie rückgängig.";
    more_remedies(count) = "{count} more" | "{count} weitere";
    fits_with_proviso(proviso) = "fits {proviso}" | "geeignet, {proviso}";
    apply = "Apply" | "Anwenden";
    by_your_own_change = "To be changed in the values of the load." | "In den Angaben der Last zu ändern.";
    longer_cycle = "Longer cycle" | "Längerer Zyklus";
    every_time_longer(factor) =
        "Every time of the cycle × {factor}, pauses included." | "Jede Zeit des Zyklus × {factor}, auch die Pausen.";
    smaller_payload = "Smaller payload" | "Kleinere Nutzlast";
    smaller_load = "Smaller load" | "Kleinere Last";
    several_actuators(count) = "{count} equal actuators" | "{count} gleiche Antriebe";
    each_with_its_share(count) =
        "each carries 1/{count} of masses, forces and payloads; allow for an uneven division"
        | "jeder trägt 1/{count} der Massen, Kräfte und Nutzlasten; ungleiche Aufteilung berücksichtigen";
    one_of_several(name, count) = "{name} (one of {count} actuators)" | "{name} (einer von {count} Antrieben)";
    an_intermediate_stage = "Intermediate stage" | "Zwischenstufe";
    cancel = "Cancel" | "Abbrechen";
    was_cancelled = "Cancelled" | "Abgebrochen";
    result_before =
        "The result shown is the one before the change."
        | "Gezeigt wird das Ergebnis vor der Änderung.";
    compute_again = "Compute again" | "Erneut rechnen";
    no_answer =
        "No answer from antrieb; the last change was not applied. Is the program still running?"
        | "Keine Antwort von antrieb; die letzte Änderung wurde nicht übernommen. Läuft das Programm noch?";
    all_axes = "All axes" | "Alle Achsen";
    axes_together = "All axes together" | "Alle Achsen zusammen";
    axes_about =
        "Mass and power of all axes are added as if all power peaks occurred at the same time."
        | "Masse und Leistung aller Achsen sind addiert, als träten alle Leistungsspitzen gleichzeitig auf.";
    sum_of_known(known, all) = "sum of {known} of {all}" | "Summe von {known} aus {all}";
    sum = "sum" | "Summe";
    power_taken = "largest power drawn at the motor terminals" | "größte Leistungsaufnahme an den Motorklemmen";
    power_returned = "largest regenerative power at the motor terminals" | "größte Rückspeiseleistung an den Motorklemmen";
    tolerances = "Tolerances" | "Toleranzen";
    tolerances_about(count) =
        "1 quantity has a tolerance; the result above is valid for its nominal value."
        | "1 Größe hat eine Toleranz; das Ergebnis oben gilt für ihren Nennwert.",
        "{count} quantities have a tolerance; the result above is valid for their nominal values."
        | "{count} Größen haben eine Toleranz; das Ergebnis oben gilt für ihre Nennwerte.";
    judge_tolerances = "Evaluate the tolerances" | "Toleranzen auswerten";
    samples = "Samples" | "Stichproben";
    as_many_as_seconds_allow = "a few seconds" | "einige Sekunden";
    tolerance_of(name) = "Tolerance of {name}" | "Toleranz von {name}";
    time_shown = "Time shown" | "Gezeigte Zeit";
    zoom_in = "Zoom in" | "Vergrößern";
    zoom_out = "Zoom out" | "Verkleinern";
    window_back = "Earlier" | "Früher";
    window_on = "Later" | "Später";
    whole_cycle = "Whole cycle" | "Ganzer Zyklus";
    worst_instants = "Critical instants of the checks" | "Ungünstigste Zeitpunkte der Nachweise";
    end_of_segment(number, law) = "end of segment {number}, {law}" | "Ende von Abschnitt {number}, {law}";
    ends_at(time, way, unit) = "at {time}\u{a0}s, {way}\u{a0}{unit}" | "bei {time}\u{a0}s, {way}\u{a0}{unit}";
    grips_about =
        "Left and right arrow keys change the duration of the segment, up and down its travel; with Shift in larger steps."
        | "Pfeiltasten links und rechts ändern die Dauer des Abschnitts, auf und ab den Weg; mit Umschalttaste in größeren Schritten.";
    choose_by_picture = "Choose by picture" | "Nach Bild wählen";
    law_pictures_about =
        "From top to bottom position, speed and acceleration over time"
        | "Von oben nach unten Position, Geschwindigkeit und Beschleunigung über der Zeit";
    trapezoid_with_pause = "trapezoid with pause" | "Trapez mit Pause";
    move_up(name) = "Move {name} up" | "{name} nach oben";
    once_more(name) = "Duplicate {name}" | "{name} duplizieren";
    recognised(name) = "{name} (recognised)" | "{name} (erkannt)";
    no_column = "no column" | "keine Spalte";
    unit_of(name) = "Unit of {name}" | "Einheit von {name}";
    first_rows = "First rows of the file" | "Erste Zeilen der Datei";
    map_about = "Click a point to show the actuator." | "Ein Klick auf einen Punkt zeigt den Antrieb.";
    file = "File" | "Datei";
    export = "Export" | "Exportieren";
    changed = "changed" | "geändert";
    saved_state = "saved" | "gespeichert";
    versions = "Versions of this session" | "Stände dieser Sitzung";
    picture_shown = "Picture shown (SVG)" | "Gezeigtes Bild (SVG)";
    find = "Find a key, check, code or term" | "Angabe, Nachweis, Bestellbezeichnung oder Begriff suchen";
    keyboard = "Keyboard" | "Tastatur";
    answers_again = "antrieb answers again." | "antrieb antwortet wieder.";
    draft_found = "There are unsaved changes to this file:" | "Zu dieser Datei gibt es ungespeicherte Änderungen:";
    continue_unsaved = "Continue with unsaved changes" | "Mit ungespeicherten Änderungen weiterarbeiten";
    draft_too_large =
        "The browser has no room left for unsaved changes: save the file, or discard others on the start page."
        | "Der Browser hat keinen Platz mehr für ungespeicherte Änderungen: Datei speichern oder andere auf der Startseite verwerfen.";
    restore_draft = "Restore" | "Wiederherstellen";
    discard_draft = "Discard" | "Verwerfen";
    draft_restored =
        "The unsaved changes were restored; use Undo to discard them." | "Die ungespeicherten Änderungen wurden wiederhergestellt; mit Rückgängig verwerfen.";
    tightest = "Governing check:" | "Maßgebender Nachweis:";
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
    view_error_budget = "Error budget" | "Fehlersumme";
    full_window = "Show picture in full window" | "Bild im ganzen Fenster zeigen";
    copy_svg = "Copy SVG" | "SVG kopieren";
    copy_data = "Copy data" | "Daten kopieren";
    without_limit_head = "No limit stated" | "Ohne angegebene Grenze";
    why_not = "Rejected actuators" | "Verworfene Antriebe";
    map = "Map" | "Übersichtsdiagramm";
    sort_by(column) = "Sort by {column}" | "Nach {column} ordnen";
    load_hangs = "load not held" | "Last nicht gehalten";
    arithmetic_number_missing =
        "a number is missing after an operator" | "hinter einem Rechenzeichen fehlt eine Zahl";
    arithmetic_parenthesis = "a parenthesis has no counterpart" | "eine Klammer hat kein Gegenstück";
    arithmetic_unit_inside(unit) =
        "write the unit once, after the whole expression: 2*5 {unit}" | "die Einheit einmal hinter den ganzen Ausdruck schreiben: 2*5 {unit}";
    arithmetic_separators =
        "write numbers without separators between the digits and with a decimal point: 1000.5"
        | "Zahlen ohne Trennzeichen zwischen den Ziffern und mit Dezimalkomma schreiben: 1000,5";
    arithmetic_division_by_zero = "division by zero" | "Division durch null";
    arithmetic_out_of_range =
        "the result is too large or too small for a number" | "das Ergebnis ist für eine Zahl zu groß oder zu klein";
    arithmetic_too_long =
        "the expression is longer or deeper than a field allows (200 characters, 20 parentheses)"
        | "der Ausdruck ist länger oder tiefer, als ein Feld zulässt (200 Zeichen, 20 Klammern)";
    arithmetic_no_unit =
        "there is no unit after the expression" | "hinter dem Ausdruck steht keine Einheit";
    asked_values =
        "State what defines the machine; arithmetic such as 2*0.3 is computed. Everything else is assumed, and listed with the result."
        | "Angeben, was die Maschine bestimmt; Rechnungen wie 2*0,3 werden ausgewertet. Alles Weitere wird angenommen und mit dem Ergebnis aufgeführt.";
    core_and_full = "Diameter: core – full roll" | "Durchmesser: Hülse – voller Wickel";
    speed_of_output_missing = "state the speed of the output" | "die Drehzahl des Abtriebs angeben";
    stroke_of_platform = "Stroke of the platform" | "Hub der Plattform";
    line_speed = "Line speed of the web" | "Bahngeschwindigkeit";
    speed_of_crank = "Speed of the crank" | "Drehzahl der Kurbel";
    duration_of = "Duration of each move" | "Dauer jeder Bewegung";
    pause_of = "Pause after each move" | "Pause nach jeder Bewegung";
    choose = "choose" | "auswählen";
    inertia_is_known = "Moment of inertia known" | "Trägheitsmoment bekannt";
    inertia_from_shape = "Moment of inertia from the shape" | "Trägheitsmoment aus der Form";
    assumed_title = "Assumed" | "Angenommen";
    assumed_take = "Take" | "Übernehmen";
    assumed_change = "Change" | "Ändern";
    assumed_leave_out = "Leave out" | "Weglassen";
    assumed_not_checked = "not checked" | "nicht geprüft";
    back = "Back" | "Zurück";
    reverse(name) = "Reverse {name}" | "{name} umkehren";
    checks_wait(count) =
        "required for 1 check" | "für 1 Nachweis erforderlich", "required for {count} checks" | "für {count} Nachweise erforderlich";
    more_faults(count) = "1 more" | "1 weiterer", "{count} more" | "{count} weitere";
    nothing_found = "Nothing found" | "Nichts gefunden";
    key_panes = "Load and motion, demand, suitable actuators" | "Last und Bewegung, Belastung, geeignete Antriebe";
    key_escape = "Close the open dialog or menu" | "Offenen Dialog oder offenes Menü schließen";
    key_zoom = "At the instant: zoom in, zoom out, whole cycle" | "Am Zeitpunkt: vergrößern, verkleinern, ganzer Zyklus";
    key_arrows =
        "Instant, end of a segment, pane border, next tab" | "Zeitpunkt, Ende eines Abschnitts, Trennlinie, nächster Reiter";
    no_versions = "No changes yet." | "Noch keine Änderungen.";
    this_version = "This version is open." | "Dieser Stand ist geöffnet.";
    first_version = "Initial version" | "Anfangsstand";
    back_to_version = "Back to this version" | "Zurück zu diesem Stand";
    only_layout = "Only comments or formatting" | "Nur Kommentare oder Formatierung";
    cycle_of(time) = "cycle\u{a0}{time}\u{a0}s" | "Zyklus\u{a0}{time}\u{a0}s";
    name_is_taken(name) =
        "A file named {name} already exists and was not overwritten."
        | "Eine Datei namens {name} existiert bereits und wurde nicht überschrieben.";
    without_the_requirement(why) = "without the requirement: {why}" | "ohne die Anforderung: {why}";
    and_also(one, other) = "{one}; and {other}" | "{one}; und {other}";
    diameter_of_the_disc = "Diameter of the solid disc or cylinder" | "Durchmesser der Vollscheibe oder des Vollzylinders";
    tool_awaits = "Needed for an answer:" | "Für das Ergebnis anzugeben:";
    to_the_start = "To the start page" | "Zur Startseite";
    save_under(name) = "Save as {name}" | "Als {name} speichern";
    open_it(name) = "Open {name}" | "{name} öffnen";
    replace_it(name) = "Replace {name}" | "{name} ersetzen";
    group_geometry = "Geometry" | "Geometrie";
    group_masses = "Masses" | "Massen";
    group_forces = "Forces, friction, efficiency" | "Kräfte, Reibung, Wirkungsgrad";
    components = "Page components" | "Bausteine der Seite";
    components_type = "type" | "Schrift";
    components_buttons = "buttons and tabs" | "Knöpfe und Reiter";
    components_fields = "fields" | "Felder";
}
