//! Help of the command line.

pub mod library;
pub mod values;

use crate::texts::texts;

texts! {
    ordering_code = "Ordering code" | "Bestellbezeichnung";
    not_in_this_build = "not in this build" | "in dieser Ausführung nicht enthalten";
    project = "Project file (TOML); - reads standard input" | "Projektdatei (TOML); - liest die Standardeingabe";
    axis = "Only this axis of a project with several" | "Nur diese Achse eines Projekts mit mehreren";
    samples =
        "Samples within the tolerances of the project (10000, or fewer where each costs more)"
        | "Stichproben in den Toleranzen des Projekts (10000, oder weniger, wo jede mehr kostet)";
    memory =
        "Memory for the recordings of the project (512 MiB, or variable ANTRIEB_MEMORY)"
        | "Speicher für die Aufzeichnungen des Projekts (512 MiB, oder Variable ANTRIEB_MEMORY)";
    deadline =
        "How long the answer may take, such as \"30 s\"; later none is given"
        | "Wie lange die Antwort dauern darf, etwa \"30 s\"; danach gibt es keine";
    seed =
        "Seed of the samples; the same seed draws the same (1)"
        | "Startwert der Stichproben; derselbe Startwert zieht dasselbe (1)";
    commands = "Commands" | "Befehle";
    arguments = "Arguments" | "Argumente";
    options = "Options" | "Optionen";
    help_flag = "Print this help" | "Diese Hilfe zeigen";
    version_flag = "Print the version" | "Die Version zeigen";
    example = "Example" | "Beispiel";
    size = "Rank the whole catalogue for an axis" | "Den ganzen Katalog für eine Achse ordnen";
    size_top = "How many fitting actuators to show (10)" | "Wie viele geeignete Antriebe gezeigt werden (10)";
    size_all =
        "Show every actuator, the rejected ones with their reason"
        | "Alle Antriebe zeigen, die verworfenen mit Grund";
    size_report = "Write the report of the best as PDF" | "Den Bericht des besten als PDF schreiben";
    check =
        "Judge one actuator, every check with its margin"
        | "Einen Antrieb beurteilen, jeden Nachweis mit seiner Reserve";
    check_code =
        "Ordering code; without it the project's own [actuator] is judged"
        | "Bestellbezeichnung; ohne sie wird der eigene [actuator] des Projekts beurteilt";
    explain =
        "Derive the checks of one actuator, figures put in"
        | "Die Nachweise eines Antriebs herleiten, mit eingesetzten Zahlen";
    explain_code =
        "Ordering code; without it the project's own [actuator] is explained"
        | "Bestellbezeichnung; ohne sie wird der eigene [actuator] des Projekts hergeleitet";
    explain_check =
        "One check, for example continuous_torque; all without it"
        | "Einen Nachweis, zum Beispiel continuous_torque; ohne Angabe alle";
    simulate =
        "Simulate an axis with one actuator: motor, gear, load, control, scenario"
        | "Eine Achse mit einem Antrieb simulieren: Motor, Getriebe, Last, Regelung, Szenario";
    simulate_scenario =
        "What happens; without it what the project states, else the cycle"
        | "Was geschieht; ohne Angabe, was das Projekt nennt, sonst der Zyklus";
    simulate_at =
        "When it happens, such as \"300 ms\"; without it when the axis is fastest"
        | "Wann es geschieht, etwa \"300 ms\"; ohne Angabe, wenn die Achse am schnellsten ist";
    simulate_reaction =
        "How the drive ends a motion (along a ramp)" | "Wie der Regler eine Bewegung beendet (an einer Rampe)";
    simulate_failure =
        "How the encoder fails in its scenario; without it no signal arrives"
        | "Wie der Geber in seinem Szenario ausfällt; ohne Angabe kommt kein Signal an";
    simulate_cycles = "Cycles that are run (1)" | "Gerechnete Zyklen (1)";
    simulate_cold =
        "Begin as cold as the ambient air, not settled"
        | "Kalt wie die Umgebung beginnen, nicht eingeschwungen";
    simulate_days =
        "Also run so many days by the mean losses of the cycle: temperatures, energy"
        | "Zusätzlich so viele Tage mit den mittleren Verlusten des Zyklus rechnen: Temperaturen, Energie";
    simulate_hours = "Operation a day, in hours (24)" | "Betrieb am Tag in Stunden (24)";
    simulate_every =
        "Time between two rows of the trace (\"1 ms\")" | "Zeit zwischen zwei Zeilen des Verlaufs (\"1 ms\")";
    signals = "Signals" | "Größen";
    simulate_signals =
        "Signals of the trace, separated by commas; all without it"
        | "Größen des Verlaufs, durch Komma getrennt; ohne Angabe alle";
    simulate_format =
        "Json for the summary (default), csv or parquet for the trace, svg for a picture"
        | "json für die Zusammenfassung (Vorgabe), csv oder parquet für den Verlauf, svg für ein Bild";
    simulate_seed =
        "Seed of the errors of gear and encoder (0)" | "Startwert der Fehler von Getriebe und Geber (0)";
    sweep =
        "Judge many axes: a table whose columns are keys of the project"
        | "Viele Achsen beurteilen: eine Tabelle, deren Spalten Schlüssel des Projekts sind";
    sweep_table =
        "Table of the rows, .csv or .parquet; headings such as \"motion[0].time [s]\", \"requirements.ambient [degC]\", \"code\""
        | "Tabelle der Zeilen, .csv oder .parquet; Überschriften wie \"motion[0].time [s]\", \"requirements.ambient [degC]\", \"code\"";
    sweep_check =
        "Every code of every row, with verdict and utilisation of this check; several times"
        | "Jede Bestellbezeichnung jeder Zeile, mit Urteil und Auslastung dieses Nachweises; mehrmals";
    sweep_front =
        "Of each row the codes that no other fitting one beats in mass, length and margin"
        | "Je Zeile die Bestellbezeichnungen, die keine andere geeignete in Masse, Länge und Reserve übertrifft";
    sweep_out =
        "The answers as .csv or .parquet; an interrupted call continues"
        | "Die Antworten als .csv oder .parquet; ein unterbrochener Aufruf setzt fort";
    new_key =
        "For `new sweep`: a key with its range or values, \"motion[0].time [s] = 1..3 log\"; several times"
        | "Für `new sweep`: ein Schlüssel mit Bereich oder Werten, \"motion[0].time [s] = 1..3 log\"; mehrmals";
    new_samples =
        "For `new sweep`: rows that are drawn, or steps of each range of a grid (100)"
        | "Für `new sweep`: gezogene Zeilen, oder Stufen jedes Bereichs eines Gitters (100)";
    new_by =
        "For `new sweep`: how the ranges are covered (sobol)"
        | "Für `new sweep`: wie die Bereiche abgedeckt werden (sobol)";
    new_seed = "For `new sweep`: seed of the samples (1)" | "Für `new sweep`: Startwert der Stichproben (1)";
    identify =
        "Estimate load, friction and torque constant from a recorded run"
        | "Last, Reibung und Drehmomentkonstante aus einem aufgezeichneten Lauf schätzen";
    identify_trace =
        "Recorded run (.csv or .parquet) with the columns of a trace"
        | "Aufgezeichneter Lauf (.csv oder .parquet) mit den Spalten eines Verlaufs";
    simulate_figure =
        "Which picture: the course, or the responses of the control loops (simulation)"
        | "Welches Bild: der Verlauf oder die Frequenzgänge der Regelkreise (simulation)";
    simulate_trace = "Write the course as .csv or .parquet" | "Den Verlauf als .csv oder .parquet schreiben";
    code = "Read, list and complete ordering codes" | "Bestellbezeichnungen lesen, auflisten und ergänzen";
    code_parse = "Read a code and explain each field" | "Einen Code lesen und jedes Feld erklären";
    code_example =
        "Ordering code, for example CHA-20A-100-H-C1024-B"
        | "Bestellbezeichnung, zum Beispiel CHA-20A-100-H-C1024-B";
    code_list = "List the valid codes" | "Die gültigen Codes auflisten";
    code_list_pattern =
        "Partial code, for example CHA-20A-*-H; all without it"
        | "Teilcode, zum Beispiel CHA-20A-*-H; ohne ihn alle";
    code_list_available = "Only codes that are available without asking" | "Nur Codes, die ohne Anfrage verfügbar sind";
    code_complete =
        "Complete a partial code and say what may follow"
        | "Einen Teilcode ergänzen und zeigen, was folgen kann";
    code_complete_pattern =
        "Partial code; * stands for any value of a field"
        | "Teilcode; * steht für jeden Wert eines Feldes";
    data =
        "Data sheet of one actuator, each value with its table"
        | "Datenblatt eines Antriebs, jeder Wert mit seiner Tabelle";
    wiring =
        "Connectors, pins and cables of one actuator, and what is wrong in a list of pins"
        | "Stecker, Stifte und Kabel eines Antriebs, und was an einer Stiftliste falsch ist";
    wiring_check =
        "Compare this list (CSV: connector, pin, signal; colour and shield if wanted) with the print; - is standard input"
        | "Diese Liste (CSV: Stecker, Stift, Signal; auf Wunsch Farbe und Schirm) mit dem Druck vergleichen; - ist die Standardeingabe";
    wiring_length =
        "Length of the cable, such as \"15 m\": voltage lost by brake and encoder supply"
        | "Länge des Kabels, etwa \"15 m\": Spannungsverlust von Bremse und Geberversorgung";
    wiring_section =
        "Cross-section of its wires, such as \"1 mm²\""
        | "Querschnitt seiner Adern, etwa \"1 mm²\"";
    wiring_connector =
        "With --svg or --png: motor, feedback (default) or output_encoder"
        | "Mit --svg oder --png: motor, feedback (Motorfeedback, Vorgabe) oder output_encoder (Geber am Abtrieb)";
    encoder =
        "Signals and words of the encoders of one actuator at an angle; a word read back"
        | "Signale und Datenwörter der Geber eines Antriebs bei einem Winkel; Lesen eines Worts";
    encoder_angle =
        "Angle of the motor shaft, clockwise seen from the front, such as \"12.5 deg\""
        | "Winkel der Motorwelle, rechtsdrehend von vorne gesehen, etwa \"12,5 deg\"";
    encoder_turn = "Whole turns of the motor shaft before it" | "Ganze Umdrehungen der Motorwelle davor";
    encoder_speed =
        "Speed of the motor shaft, such as \"300 rad/s\""
        | "Drehzahl der Motorwelle, etwa \"300 rad/s\"";
    encoder_seed =
        "Let the encoder deviate within its accuracy, by this seed; without it the encoder sees the true angle"
        | "Den Geber in seiner Genauigkeit abweichen lassen, nach diesem Startwert; ohne ihn sieht er den wahren Winkel";
    encoder_window =
        "Angle over which the signals are shown; without it two periods of each"
        | "Winkel, über den die Signale gezeigt werden; ohne Angabe je zwei Perioden";
    encoder_battery_lost =
        "Battery and supply have failed together (M128S)"
        | "Batterie und Versorgung sind zugleich ausgefallen (M128S)";
    encoder_error = "The encoder reports an error (EnDat)" | "Der Geber meldet einen Fehler (EnDat)";
    encoder_decode =
        "Read this word, bits in the order sent, and say what is wrong with it"
        | "Dieses Wort lesen, Bits in Senderichtung, und sagen, was daran falsch ist";
    encoder_vcd =
        "Write the digital signals over time (VCD), for logic analysers such as sigrok"
        | "Die digitalen Signale über der Zeit schreiben (VCD), für Logikanalysatoren wie sigrok";
    encoder_time = "Length of the trace (--vcd)" | "Länge der Aufzeichnung (--vcd)";
    encoder_endat =
        "Command set of the EnDat word in the trace"
        | "Befehlssatz des EnDat-Worts in der Aufzeichnung";
    encoder_connector =
        "Encoder in the trace"
        | "Geber in der Aufzeichnung";
    errata =
        "What is wrong or in doubt in the print, and what is used"
        | "Was im Druck falsch oder zweifelhaft ist, und was verwendet wird";
    errata_about =
        "Ordering code, number of a table, or id of an erratum; all without it"
        | "Bestellbezeichnung, Nummer einer Tabelle oder Name eines Druckfehlers; ohne Angabe alle";
    commission =
        "Values for the drive, check-lists, and the judgement of what was measured"
        | "Werte für den Regler, Prüflisten und das Urteil über Gemessenes";
    commission_for =
        "Form of the values: sinamics, cia402, plain"
        | "Form der Werte: sinamics, cia402, plain (neutral)";
    commission_ambient =
        "Temperature at which winding and sensors are measured (20 degC)"
        | "Temperatur, bei der Wicklung und Sensoren gemessen werden (20 degC)";
    commission_out =
        "Write the form into this file: parameters line by line, an EDS, or JSON"
        | "Die Form in diese Datei schreiben: Parameter zeilenweise, eine EDS oder JSON";
    commission_checklist = "Write the check-lists into this PDF, a form to fill in on the screen or on paper; not for archiving (no PDF/A)" | "Die Prüflisten in dieses PDF schreiben, ein Formular zum Ausfüllen am Bildschirm oder auf Papier; nicht zur Archivierung (kein PDF/A)";
    commission_record =
        "Judge the measured values of this file and name likely causes"
        | "Die gemessenen Werte dieser Datei beurteilen und wahrscheinliche Ursachen nennen";
    commission_blank =
        "Write an empty record of measured values to fill in"
        | "Eine leere Datei für gemessene Werte zum Ausfüllen schreiben";
    commission_exit =
        "With --record: exit code 0 nothing is off, 1 something is, 2 the file cannot be read."
        | "Mit --record: Rückgabewert 0 nichts auffällig, 1 etwas auffällig, 2 Datei nicht lesbar.";
    catalogue = "The whole catalogue" | "Der ganze Katalog";
    catalogue_export =
        "Every cell of the maker's tables in long form"
        | "Jede Zelle der Herstellertabellen in langer Form";
    catalogue_format = "csv (default) or json" | "csv (Vorgabe) oder json";
    antrieb =
        "Engineering workbench for hollow-shaft servo actuators of the CHA series"
        | "Auslegungswerkzeug für Hohlwellen-Servoantriebe der Baureihe CHA";
    exit_codes =
        "Exit code: 0 fits or answered, 1 does not fit, 2 the question could not be answered."
        | "Rückgabewert: 0 geeignet oder beantwortet, 1 nicht geeignet, 2 die Frage ließ sich nicht beantworten.";
    json = "Answer as JSON" | "Antwort als JSON";
    lang =
        "Language of the answer, en or de (or variable ANTRIEB_LANG)"
        | "Sprache der Antwort, en oder de (oder Variable ANTRIEB_LANG)";
    torsion =
        "Torsion of the gear under a torque, or the torque of an angle"
        | "Torsion des Getriebes unter einem Drehmoment oder das Drehmoment zu einem Winkel";
    torsion_angle =
        "Angle of torsion, for example \"1 arcmin\", instead of the torque"
        | "Torsionswinkel, zum Beispiel \"1 arcmin\", statt des Drehmoments";
    torsion_torque = "Torque at the output, for example \"60 N m\"" | "Drehmoment am Abtrieb, zum Beispiel \"60 N m\"";
    bearing =
        "The output bearing of every size under a project's loads"
        | "Das Abtriebslager jeder Baugröße unter den Lasten eines Projekts";
    battery = "Life of the battery of a buffered encoder" | "Lebensdauer der Batterie eines gepufferten Gebers";
    battery_hours = "Hours of operation a day, 0 to 24" | "Betriebsstunden je Tag, 0 bis 24";
    battery_storage =
        "Storage before operation, for example \"1 a\"; none without it"
        | "Lagerung vor dem Betrieb, zum Beispiel \"1 a\"; ohne Angabe keine";
    mount =
        "Fits, screws and their utilisation, mass: how an actuator is mounted"
        | "Passungen, Schrauben und ihre Auslastung, Masse: wie ein Antrieb montiert wird";
    mount_bore =
        "Bore over both pilots: a zone such as K7, or limit deviations such as \"+12/-3 um\"; H7 without it, as the manual recommends"
        | "Bohrung auf beiden Zentrierungen: ein Toleranzfeld wie K7 oder Grenzabmaße wie \"+12/-3 um\"; ohne Angabe H7, wie die Anleitung empfiehlt";
    mount_bore_load = "Bore of the load, where it is another" | "Bohrung der Last, wo sie eine andere ist";
    mount_bore_housing = "Bore of the machine, where it is another" | "Bohrung der Maschine, wo sie eine andere ist";
    mount_project =
        "Project whose torques and loads on the flange take the place of the limits"
        | "Projekt, dessen Drehmomente und Lasten am Flansch an die Stelle der Grenzen treten";
    upkeep =
        "Plan with dates for storage, upkeep and exchange, shutting down, disposal"
        | "Plan mit Terminen für Lagerung, Wartung und Tausch, Stillsetzen, Entsorgung";
    upkeep_delivered = "Day of delivery, 2026-03-01" | "Tag der Lieferung, 2026-03-01";
    upkeep_storage =
        "Storage before service: a time such as \"1 a\" or \"6 months\", or the day on which it ends"
        | "Lagerung vor dem Betrieb: eine Zeit wie \"1 a\" oder \"6 Monate\", oder der Tag, an dem sie endet";
    upkeep_hours =
        "Hours of operation a day, 0 to 24, for the battery of the encoder"
        | "Betriebsstunden je Tag, 0 bis 24, für die Batterie des Gebers";
    upkeep_inspect =
        "Interval of what the manual wants regularly, such as \"6 months\"; a year without it, listed as assumed"
        | "Intervall für das, was die Anleitung regelmäßig verlangt, etwa \"6 Monate\"; ohne Angabe ein Jahr, als angenommen genannt";
    upkeep_today =
        "Day to look from: it marks what has passed, and the next date of each series"
        | "Tag der Betrachtung: er zeigt, was überschritten ist, und den nächsten Termin jeder Reihe";
    upkeep_ical = "Write the plan as iCalendar file (.ics)" | "Den Plan als iCalendar-Datei (.ics) schreiben";
    upkeep_name =
        "Name of the actuator in the calendar: distinguishes two of one code"
        | "Name des Antriebs im Kalender: unterscheidet zwei mit gleichem Code";
    drive =
        "A virtual drive with the objects of CiA 402, for a controller"
        | "Ein virtueller Regler mit den Objekten von CiA 402, für eine Steuerung";
    drive_project =
        "Project whose axis it drives: load, supply, gains; without it a bare moment of inertia"
        | "Projekt, dessen Achse er bewegt: Last, Versorgung, Reglerverstärkungen; ohne es ein bloßes Trägheitsmoment";
    drive_inertia =
        "Moment of inertia of the load without a project (that of the actuator)"
        | "Trägheitsmoment der Last ohne Projekt (das des Antriebs)";
    drive_protocol = "How clients talk to it" | "Sprache der Clients";
    drive_time =
        "Whether time follows the clock or the client, by a request or with each SYNC message by the period of 60C2h"
        | "Ob die Zeit der Uhr folgt oder dem Client, durch eine Anfrage oder je SYNC-Nachricht um die Periode aus 60C2h";
    drive_port =
        "Port; 0 takes a free one (29535, for CAN 29536, or a free one where that is taken)"
        | "Port; 0 nimmt einen freien (29535, für CAN 29536, oder ein freier, wo der belegt ist)";
    drive_node = "Number of its node of CANopen" | "Knotennummer in CANopen";
    drive_eds =
        "Print its electronic data sheet (CiA 306) and end"
        | "Sein elektronisches Datenblatt (CiA 306) ausgeben und enden";
    serve = "The web workbench, on this machine" | "Der Arbeitsplatz im Browser, auf dieser Maschine";
    serve_folder =
        "Folder with the project files; nothing outside of it is read or written (the current one)"
        | "Ordner mit den Projektdateien; außerhalb wird nichts gelesen oder geschrieben (der aktuelle)";
    serve_port =
        "Port; 0 takes a free one (8377, or a free one where that is taken)"
        | "Port; 0 nimmt einen freien (8377, oder ein freier, wo der belegt ist)";
    serve_open = "Open the browser" | "Den Browser öffnen";
    serve_listen(one, all) =
        "Address to listen on instead of this machine alone, such as {one}, or {all} for every one"
        | "Adresse, auf der statt nur auf dieser Maschine gelauscht wird, etwa {one}, oder {all} für jede";
    serve_no_token =
        "Answer without the token of the printed address: every user and program of this machine can then read and write the projects of the folder"
        | "Auch ohne das Token der ausgegebenen Adresse antworten: jeder Benutzer und jedes Programm dieser Maschine kann dann die Projekte des Ordners lesen und schreiben";
    new = "A commented project file to fill in" | "Eine kommentierte Projektdatei zum Ausfüllen";
    new_out =
        "Project file to write, with an example recording beside it for kind recording"
        | "Zu schreibende Projektdatei; bei der Art recording mit einer Beispielaufzeichnung daneben";
    glossary =
        "Words and symbols with their meaning, in both languages"
        | "Wörter und Zeichen mit ihrer Bedeutung, in beiden Sprachen";
    glossary_term =
        "Symbol, name or word, for example T_rms; all without it"
        | "Zeichen, Name oder Wort, zum Beispiel T_rms; ohne Angabe alle";
    units =
        "Units that are read, every spelling and its value in SI"
        | "Einheiten, die gelesen werden, jede Schreibweise und ihr Wert in SI";
    units_quantity =
        "Quantity or unit, for example torque or rpm; all without it"
        | "Größe oder Einheit, zum Beispiel Drehmoment oder Nm; ohne Angabe alle";
    licences =
        "Licences of antrieb and of all that is built into it, fonts included"
        | "Lizenzen von antrieb und von allem, was darin steckt, auch der Schriften";
    completions = "Completion script for a shell" | "Vervollständigung für eine Shell";
    help = "Help on a command" | "Hilfe zu einem Befehl";
    help_command = "Command; all of them without it" | "Befehl; ohne ihn alle";
    man = "Manual page (roff)" | "Handbuchseite (roff)";
    man_command = "Command; antrieb itself without it" | "Befehl; ohne ihn antrieb selbst";
    schema = "JSON Schema of the project file, or of the answers" | "JSON-Schema der Projektdatei oder der Antworten";
    schema_answers = "What --json writes for each command" | "Was --json bei jedem Befehl schreibt";
    shapes =
        "Shapes and their keys (axis: parallel or perpendicular to the axis of rotation):"
        | "Formen und ihre Schlüssel (axis: parallel oder perpendicular, senkrecht zur Drehachse):";
    shapes_all =
        "All: mass or density; distance from the axis of rotation (0), angle (0), count evenly spaced (1)."
        | "Alle: mass oder density; distance von der Drehachse (0), angle (0), count gleichmäßig verteilt (1).";
    inertia = "Moment of inertia of solid bodies" | "Massenträgheitsmoment fester Körper";
    inertia_body =
        "Each body in quotes, for example \"disc diameter=200mm length=20mm density=7850kg/m^3\""
        | "Jeder Körper in Anführungszeichen, etwa \"disc diameter=200mm length=20mm density=7850kg/m^3\"";
    curve = "Curves of the torque-speed plane" | "Kennlinien in der Drehmoment-Drehzahl-Ebene";
    curve_voltage =
        "Terminal voltage of the motor, rms, for example \"220 V\"; without it the maker's range holds"
        | "Klemmenspannung des Motors, effektiv, zum Beispiel \"220 V\"; ohne sie gilt der Bereich der Herstellerangaben";
    plot =
        "A picture of an axis on an actuator, as SVG or PNG"
        | "Ein Bild einer Achse mit einem Antrieb, als SVG oder PNG";
    own_or_best_code =
        "Ordering code; without it the project's own [actuator], else the best of the catalogue"
        | "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste des Katalogs";
    plot_by =
        "candidate_map over mass (default) or length"
        | "candidate_map über mass (Masse, Vorgabe) oder length (Länge)";
    plot_without_files =
        "Without --svg and --png the SVG goes to standard output."
        | "Ohne --svg und --png geht das SVG auf die Standardausgabe.";
    svg = "Draw into this SVG file; - is standard output" | "In diese SVG-Datei zeichnen; - ist die Standardausgabe";
    png = "Draw into this PNG file" | "In diese PNG-Datei zeichnen";
    theme = "light (default) or dark" | "light (hell, Vorgabe) oder dark (dunkel)";
    width = "Width of the picture, for example \"160 mm\"" | "Breite des Bildes, zum Beispiel \"160 mm\"";
    height =
        "Height of the picture; it grows if its content needs it"
        | "Höhe des Bildes; es wächst, wenn sein Inhalt es braucht";
    compare =
        "Two to five actuators side by side, check by check"
        | "Zwei bis fünf Antriebe nebeneinander, Nachweis für Nachweis";
    compare_code =
        "Ordering code; given once for each actuator"
        | "Bestellbezeichnung; für jeden Antrieb einmal anzugeben";
    diff =
        "What another revision of a project changes in each check"
        | "Was ein anderer Stand eines Projekts an jedem Nachweis ändert";
    diff_old = "Project file before" | "Projektdatei vorher";
    diff_new =
        "Project file after; its verdict is the exit code"
        | "Projektdatei nachher; ihr Urteil ist der Rückgabewert";
    diff_code =
        "Ordering code; without it the project's own [actuator], else the best before"
        | "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste vorher";
    export =
        "The results as a workbook, or one table as CSV, JSON or Parquet"
        | "Die Ergebnisse als Arbeitsmappe, oder eine Tabelle als CSV, JSON oder Parquet";
    export_code =
        "Ordering code; without it the project's own [actuator], else the best"
        | "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste";
    export_out =
        "File to write, by its ending: .xlsx, .csv, .json, .parquet; - or none: CSV to standard output"
        | "Zieldatei, nach ihrer Endung: .xlsx, .csv, .json, .parquet; - oder keine: CSV auf die Standardausgabe";
    export_table =
        "One table: inputs, assumptions, demand, motion, candidates, checks, course"
        | "Eine Tabelle: inputs, assumptions, demand, motion, candidates, checks, course";
    export_top =
        "How many of the ranking the tables hold (20)"
        | "Wie viele der Reihenfolge die Tabellen enthalten (20)";
    export_revision = "Revision for the first sheet" | "Revision für das erste Blatt";
    export_date =
        "Date for the first sheet; none without it, so that the same call gives the same bytes"
        | "Datum für das erste Blatt; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes gibt";
    report = "The results as a PDF to sign" | "Die Ergebnisse als PDF zum Unterschreiben";
    report_out = "PDF file to write" | "Zu schreibende PDF-Datei";
    report_full =
        "With the derivation of every check, all sources and all codes as appendices"
        | "Mit Herleitung jedes Nachweises, allen Quellen und allen Bestellbezeichnungen im Anhang";
    report_installation =
        "With wiring, mounting and commissioning of the code; with upkeep where --delivered states its beginning"
        | "Mit Verdrahtung, Montage und Inbetriebnahme zur Bestellbezeichnung; mit Wartung, wenn --delivered ihren Beginn nennt";
    report_delivered =
        "Day of delivery, 2026-03-01, from which the plan of upkeep counts"
        | "Tag der Lieferung, 2026-03-01, ab dem der Wartungsplan zählt";
    date =
        "Date of the document, 2026-11-21; none without it, so that the same call gives the same bytes"
        | "Datum des Dokuments, 2026-11-21; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes gibt";
    revision = "Revision of the document" | "Revision des Dokuments";
    title = "Project, plant or order" | "Projekt, Anlage oder Auftrag";
    number = "Number of the document" | "Nummer des Dokuments";
    author = "Who made it" | "Bearbeitet von";
    company = "Company or office" | "Firma oder Büro";
    archive = "As PDF/A for archiving; needs --date" | "Als PDF/A zum Archivieren; braucht --date";
    force = "Replace a file that exists" | "Eine vorhandene Datei ersetzen";
    usage = "Usage" | "Aufruf";
}
