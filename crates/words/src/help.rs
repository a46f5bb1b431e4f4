//! Help of the command line.

pub mod library;
pub mod values;

use crate::texts::texts;

texts! {
    ordering_code = "Ordering code" | "Bestellbezeichnung";
    not_in_this_build = "not in this build" | "in dieser Ausführung nicht enthalten";
    project = "Project file (TOML); - reads standard input" | "Projektdatei (TOML); - liest die Standardeingabe";
    projects =
        "Project file (TOML); - reads standard input. Several are compared, a line for each axis"
        | "Projektdatei (TOML); - liest die Standardeingabe. Mehrere werden verglichen, je Achse eine Zeile";
    axis = "Only this axis of a project with several" | "Nur diese Achse eines Projekts mit mehreren";
    samples =
        "Samples within the tolerances of the project (10000, fewer for projects that are expensive to compute)"
        | "Stichproben in den Toleranzen des Projekts (10000, weniger bei rechenaufwendigen Projekten)";
    memory =
        "Memory limit for the recordings of the project (512 MiB, or variable ANTRIEB_MEMORY)"
        | "Speichergrenze für die Aufzeichnungen des Projekts (512 MiB, oder Variable ANTRIEB_MEMORY)";
    set =
        "Value of a key for this call, in place of that of the file, such as mechanism.belt.mass=20kg"
        | "Wert eines Schlüssels für diesen Aufruf, anstelle dessen der Datei, etwa mechanism.belt.mass=20kg";
    catalogue_file =
        "Catalogue file in TOML or CSV, whose products are evaluated together with the built-in series"
        | "Katalogdatei in TOML oder CSV, deren Produkte zusammen mit der mitgelieferten Baureihe bewertet werden";
    scale =
        "Factor for this call: load=1.15 (the moved mass, inertia or material, not counterweight and mechanism), payload=2, time=0.8, distance=2, or a key of the project"
        | "Faktor für diesen Aufruf: load=1,15 (bewegte Masse, Trägheit oder Material, ohne Gegengewicht und Mechanik), payload=2, time=0,8, distance=2, oder ein Schlüssel des Projekts";
    deadline =
        "Time limit, such as \"30 s\"; when it is exceeded, the command stops without an answer"
        | "Zeitgrenze der Berechnung, etwa \"30 s\"; danach Abbruch ohne Ergebnis";
    seed =
        "Seed of the samples; same seed, same samples (1)"
        | "Startwert der Stichproben; gleicher Startwert, gleiche Stichproben (1)";
    commands = "Commands" | "Befehle";
    arguments = "Arguments" | "Argumente";
    options = "Options" | "Optionen";
    help_flag = "Print this help" | "Diese Hilfe zeigen";
    version_flag = "Print the version" | "Die Version zeigen";
    examples = "Examples" | "Beispiele";
    example = "Example" | "Beispiel";
    size = "Rank the whole catalogue for an axis" | "Den ganzen Katalog für eine Achse bewerten und ordnen";
    size_top = "Number of fitting actuators shown (10)" | "Anzahl der gezeigten geeigneten Antriebe (10)";
    size_all =
        "Show all actuators, rejected ones with the reason"
        | "Alle Antriebe zeigen, verworfene mit Grund";
    size_report = "Write the report on the best actuator as PDF" | "Bericht über den besten Antrieb als PDF schreiben";
    check =
        "Evaluate one actuator, every check with its margin"
        | "Alle Nachweise eines Antriebs mit ihrer Reserve";
    check_code =
        "Ordering code; default: the project's own [actuator]"
        | "Bestellbezeichnung; ohne Angabe der eigene [actuator] des Projekts";
    explain =
        "Show the derivation of the checks of one actuator with numbers substituted"
        | "Herleitung der Nachweise eines Antriebs mit eingesetzten Zahlen zeigen";
    explain_code =
        "Ordering code; default: the project's own [actuator]"
        | "Bestellbezeichnung; ohne Angabe der eigene [actuator] des Projekts";
    explain_check =
        "One check, for example continuous_torque; default: all"
        | "Ein Nachweis, zum Beispiel continuous_torque; ohne Angabe alle";
    simulate =
        "Simulate an axis with one actuator: motor, gear, load, control, scenario"
        | "Eine Achse mit einem Antrieb simulieren: Motor, Getriebe, Last, Regelung, Szenario";
    simulate_scenario =
        "Scenario; default: that of the project, otherwise the cycle"
        | "Szenario; ohne Angabe das des Projekts, sonst der Zyklus";
    simulate_at =
        "Time of the event, such as \"300 ms\"; default: the worst instant of the cycle, which the answer states"
        | "Zeitpunkt des Ereignisses, etwa \"300 ms\"; ohne Angabe der ungünstigste Zeitpunkt des Zyklus, den die Antwort nennt";
    simulate_reaction =
        "Stop reaction of the drive; default: ramp" | "Stillsetzreaktion des Servoreglers; ohne Angabe ramp (Rampe)";
    simulate_failure =
        "Type of encoder failure in the encoder scenario; default: signal loss"
        | "Art des Geberausfalls im Geberszenario; ohne Angabe Signalverlust";
    simulate_cycles = "Number of cycles simulated (1)" | "Anzahl der simulierten Zyklen (1)";
    simulate_cold =
        "Start at ambient temperature instead of in thermal steady state"
        | "Start auf Umgebungstemperatur statt im thermischen Beharrungszustand";
    simulate_days =
        "Additionally simulate this number of days with the mean losses of the cycle: temperatures over the day, energy"
        | "Zusätzlich diese Anzahl Tage mit den mittleren Verlusten des Zyklus rechnen: Temperaturen über den Tag, Energie";
    simulate_hours = "Operation per day in hours (24)" | "Betriebsstunden je Tag (24)";
    moves_every =
        "Setpoints at the cycle of a controller, for example \"2 ms\": time, position, speed, acceleration in the units of the axis"
        | "Sollwerte im Takt einer Steuerung, zum Beispiel \"2 ms\": Zeit, Position, Geschwindigkeit, Beschleunigung in den Einheiten der Achse";
    moves_out = "Write the setpoints as .csv or .parquet" | "Sollwerte als .csv oder .parquet schreiben";
    setpoints_by_moves(call) =
        "Setpoints for a controller, in the units of the axis: {call}"
        | "Sollwerte für eine Steuerung, in den Einheiten der Achse: {call}";
    simulate_every =
        "Sampling interval of the trace (\"1 ms\")" | "Abtastintervall des Verlaufs (\"1 ms\")";
    signals = "Signals" | "Größen";
    simulate_signals =
        "Signals of the trace, separated by commas; default: all"
        | "Größen des Verlaufs, durch Komma getrennt; ohne Angabe alle";
    simulate_format =
        "json for the summary (default), csv or parquet for the trace or the days, svg for a picture"
        | "json für die Zusammenfassung (Vorgabe), csv oder parquet für den Verlauf oder die Tage, svg für ein Bild";
    simulate_seed =
        "Seed of the gear and encoder errors (0)" | "Startwert der Getriebe- und Geberfehler (0)";
    sweep =
        "Evaluate many axes: a table whose columns are keys of the project"
        | "Viele Achsen bewerten: eine Tabelle, deren Spalten Schlüssel des Projekts sind";
    sweep_table =
        "Table of the rows, CSV or Parquet; headings such as \"motion[1].time [s]\", \"requirements.ambient [°C]\", \"code\""
        | "Tabelle der Zeilen, CSV oder Parquet; Überschriften wie \"motion[1].time [s]\", \"requirements.ambient [°C]\", \"code\"";
    sweep_check =
        "All ordering codes of every row with verdict and utilisation of this check; may be repeated"
        | "Alle Bestellbezeichnungen jeder Zeile mit Ergebnis und Auslastung dieses Nachweises; mehrfach möglich";
    sweep_front =
        "For each row the ordering codes that are Pareto-optimal in mass, length and margin"
        | "Je Zeile die in Masse, Länge und Reserve Pareto-optimalen Bestellbezeichnungen";
    sweep_vary =
        "In place of a table: a key with its values or a range, payload=0,5,10kg, time=1..3s or payload=0:10:2kg (with its step); repeated for every combination; without --out the answers are shown"
        | "Statt einer Tabelle: ein Schlüssel mit Werten oder Bereich, payload=0;5;10kg, time=1..3s oder payload=0:10:2kg (mit Schritt); mehrfach für alle Kombinationen; ohne --out werden die Antworten angezeigt";
    sweep_steps =
        "Values of each range without a step (11)" | "Werte je Bereich ohne Schritt (11)";
    sweep_step =
        "Step of the range, for example \"5 kg\" for 30..60kg; its end must be met"
        | "Schritt des Bereichs, zum Beispiel \"5 kg\" bei 30..60kg; das Ende muss getroffen werden";
    data_beside =
        "Further actuator, two to five in all: their main data side by side in place of the data sheet"
        | "weiterer Antrieb, insgesamt zwei bis fünf: ihre Hauptdaten nebeneinander anstelle des Datenblatts";
    sweep_inputs =
        "Columns beside the results: those of the table, with all also the values that the project states"
        | "Spalten neben den Ergebnissen: die der Tabelle, mit all auch die im Projekt angegebenen Werte";
    sweep_decimal_comma =
        "CSV with decimal commas, and semicolons between the columns"
        | "CSV mit Dezimalkomma und Semikolon zwischen den Spalten";
    sweep_out =
        "Write the results as .csv, .csv.gz or .parquet; an interrupted run is continued"
        | "Ergebnisse als .csv, .csv.gz oder .parquet schreiben; ein unterbrochener Lauf wird fortgesetzt";
    new_key =
        "For `new sweep`: a key with its range or values, \"motion[1].time [s] = 1..3 log\"; may be repeated"
        | "Für `new sweep`: ein Schlüssel mit Bereich oder Werten, \"motion[1].time [s] = 1..3 log\"; mehrfach möglich";
    new_samples =
        "For `new sweep`: number of sampled rows, or steps per range of a grid (100)"
        | "Für `new sweep`: Anzahl der Stichprobenzeilen, oder Stufen je Bereich eines Gitters (100)";
    new_by =
        "For `new sweep`: sampling method (sobol)"
        | "Für `new sweep`: Stichprobenverfahren (sobol)";
    new_from =
        "Recording to begin the project with (.csv or .parquet): the columns are recognised, the rest is commented"
        | "Aufzeichnung, mit der das Projekt beginnt (.csv oder .parquet): die Spalten werden erkannt, der Rest ist kommentiert";
    new_set =
        "Value of a key of the new project, such as mass=200kg; may be repeated"
        | "Wert eines Schlüssels des neuen Projekts, etwa mass=200kg; mehrfach möglich";
    new_seed = "For `new sweep`: seed of the samples (1)" | "Für `new sweep`: Startwert der Stichproben (1)";
    identify =
        "Estimate load, friction and torque constant from a recorded run"
        | "Last, Reibung und Drehmomentkonstante aus einem aufgezeichneten Lauf schätzen";
    identify_trace =
        "Recorded run (.csv or .parquet) with the columns of a trace file; its position is the angle of the mechanism, times the ratio of a stage, from the same zero"
        | "Aufgezeichneter Lauf (.csv oder .parquet) mit den Spalten einer Verlaufsdatei; die Position darin ist der Winkel der Mechanik, mal der Übersetzung einer Zwischenstufe, vom selben Nullpunkt gezählt";
    simulate_figure =
        "Picture: the trace, or the frequency responses of the control loops (simulation)"
        | "Bild: der Verlauf oder die Frequenzgänge der Regelkreise (simulation)";
    simulate_trace = "Write the trace as .csv or .parquet; of operation over days, without signals and interval, the temperatures of the first and the last day" | "Den Verlauf als .csv oder .parquet schreiben; bei Betrieb über Tage, ohne Größen und Abtastintervall, die Temperaturen des ersten und des letzten Tages";
    code = "Read, list and complete ordering codes" | "Bestellbezeichnungen lesen, auflisten und ergänzen";
    code_parse = "Read an ordering code and explain each field" | "Eine Bestellbezeichnung lesen und jedes Feld erklären";
    code_example =
        "Ordering code, for example CHA-20A-100-H-C1024-B"
        | "Bestellbezeichnung, zum Beispiel CHA-20A-100-H-C1024-B";
    code_list = "List the valid ordering codes" | "Die gültigen Bestellbezeichnungen auflisten";
    code_list_pattern =
        "Partial ordering code, for example CHA-20A-*-H; default: all"
        | "Unvollständige Bestellbezeichnung, zum Beispiel CHA-20A-*-H; ohne Angabe alle";
    code_list_available = "Only ordering codes available without enquiry" | "Nur Bestellbezeichnungen, die ohne Anfrage lieferbar sind";
    code_complete =
        "Complete a partial ordering code and show the possible continuations"
        | "Eine unvollständige Bestellbezeichnung ergänzen und mögliche Fortsetzungen zeigen";
    code_complete_pattern =
        "Partial ordering code; * stands for any value of a field"
        | "Unvollständige Bestellbezeichnung; * steht für jeden Wert eines Feldes";
    data =
        "Data sheet of one actuator, each value with its source table"
        | "Datenblatt eines Antriebs, jeder Wert mit Quelltabelle";
    wiring =
        "Connectors, pins and cables of one actuator, and check of a pin list"
        | "Stecker, Stifte und Leitungen eines Antriebs, dazu Vergleich einer Stiftliste";
    wiring_check =
        "Compare this list (CSV: connector, pin, signal; optionally colour and shield) with the manual; - is standard input"
        | "Diese Liste (CSV: Stecker, Stift, Signal; wahlweise Farbe und Schirm) mit der Anleitung vergleichen; - ist die Standardeingabe";
    wiring_length =
        "Cable length, such as \"15 m\": voltage drop of brake and encoder supply"
        | "Leitungslänge, etwa \"15 m\": Spannungsabfall von Bremse und Geberversorgung";
    wiring_section =
        "Conductor cross-section, such as \"1 mm²\""
        | "Leiterquerschnitt, etwa \"1 mm²\"";
    wiring_connector =
        "With --svg or --png: motor, feedback (motor encoder, default) or output_encoder"
        | "Mit --svg oder --png: motor, feedback (Motorgeber, Vorgabe) oder output_encoder (Abtriebsgeber)";
    encoder =
        "Encoder signals and data words at an angle; decoding of a word"
        | "Signale und Datenwörter der Geber bei einem Winkel; Decodieren eines Worts";
    encoder_angle =
        "Angle of the motor shaft, clockwise seen from the front, such as \"30 deg\""
        | "Winkel der Motorwelle, rechtsdrehend von vorne gesehen, etwa \"30 deg\"";
    encoder_turn = "Whole turns of the motor shaft before this angle" | "Ganze Umdrehungen der Motorwelle vor diesem Winkel";
    encoder_speed =
        "Speed of the motor shaft, such as \"300 rad/s\""
        | "Drehzahl der Motorwelle, etwa \"300 rad/s\"";
    encoder_seed =
        "Seed of the encoder error within its accuracy; default: no error"
        | "Startwert der Geberabweichung innerhalb der Genauigkeit; ohne Angabe keine Abweichung";
    encoder_window =
        "Angle range of the signals shown, such as \"2 deg\"; default: two periods each"
        | "Winkelbereich der gezeigten Signale, etwa \"2 deg\"; ohne Angabe je zwei Perioden";
    encoder_battery_lost =
        "Battery and supply have failed at the same time (M128S)"
        | "Batterie und Versorgung sind gleichzeitig ausgefallen (M128S)";
    encoder_error = "The encoder reports an error (EnDat)" | "Der Geber meldet einen Fehler (EnDat)";
    encoder_decode =
        "Decode this word (bits in the order sent) and report its errors"
        | "Dieses Wort decodieren (Bits in Senderichtung) und Fehler melden";
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
        "Errors and doubtful values in the manual, and the values used instead"
        | "Druckfehler und zweifelhafte Werte der Anleitung und die verwendeten Werte";
    errata_about =
        "Ordering code, table number, or id of an erratum; default: all"
        | "Bestellbezeichnung, Tabellennummer oder Kennung eines Druckfehlers; ohne Angabe alle";
    commission =
        "Settings for the drive, checklists, and evaluation of measured values"
        | "Einstellwerte für den Servoregler, Prüflisten und Auswertung gemessener Werte";
    commission_for =
        "Format of the settings: sinamics, cia402, plain"
        | "Format der Einstellwerte: sinamics, cia402, plain (neutral)";
    commission_ambient =
        "Temperature at which winding and sensors are measured (20 °C)"
        | "Temperatur, bei der Wicklung und Sensoren gemessen werden (20 °C)";
    commission_out =
        "Write the settings to this file: parameters line by line, an EDS, or JSON"
        | "Einstellwerte in diese Datei schreiben: Parameter zeilenweise, ein EDS oder JSON";
    commission_checklist = "Write the checklists to this PDF, a form to be completed on screen or on paper; not for archiving (no PDF/A)" | "Prüflisten in dieses PDF schreiben, ein Formular zum Ausfüllen am Bildschirm oder auf Papier; nicht zur Archivierung (kein PDF/A)";
    commission_record =
        "Evaluate the measured values in this file and state likely causes"
        | "Gemessene Werte dieser Datei auswerten und wahrscheinliche Ursachen nennen";
    commission_blank =
        "Write an empty record for measured values"
        | "Ein leeres Messprotokoll schreiben";
    commission_exit =
        "With --record: exit code 0 all values within tolerance, 1 values out of tolerance, 2 the file cannot be read."
        | "Mit --record: Rückgabewert 0 alle Werte in der Toleranz, 1 Werte außerhalb der Toleranz, 2 Datei nicht lesbar.";
    catalogue = "The whole catalogue" | "Der ganze Katalog";
    catalogue_export =
        "Every cell of the manufacturer's tables in long format"
        | "Jede Zelle der Herstellertabellen im Langformat";
    catalogue_check =
        "Check catalogue files: faults with line and column, then implausible values with their reasons"
        | "Katalogdateien prüfen: Fehler mit Zeile und Spalte, dann unplausible Werte mit Begründung";
    catalogue_check_files =
        "Catalogue files in TOML or CSV; - reads standard input"
        | "Katalogdateien in TOML oder CSV; - liest die Standardeingabe";
    catalogue_check_fix_units =
        "Propose cells with other units or shifted decimal marks that resolve findings; writes nothing"
        | "Zellen mit anderen Einheiten oder verschobenem Komma vorschlagen, die Befunde auflösen; schreibt nichts";
    catalogue_check_exit =
        "Exit code: 0 no finding, 1 implausible values, 2 faults of a file"
        | "Rückgabewert: 0 kein Befund, 1 unplausible Werte, 2 Fehler einer Datei";
    catalogue_format = "Format of the catalogue" | "Format des Katalogs";
    antrieb =
        "Engineering workbench for hollow-shaft servo actuators of the CHA series"
        | "Auslegungswerkzeug für Hohlwellen-Servoantriebe der Baureihe CHA";
    exit_codes =
        "Exit code: 0 fits or answered, 1 does not fit, 2 no answer possible."
        | "Rückgabewert: 0 geeignet oder beantwortet, 1 nicht geeignet, 2 keine Antwort möglich.";
    json = "Answer as JSON" | "Antwort als JSON";
    lang =
        "Language of the answer, en or de (or variable ANTRIEB_LANG)"
        | "Sprache der Antwort, en oder de (oder Variable ANTRIEB_LANG)";
    torsion =
        "Torsion of the gear under a torque, or the torque for an angle"
        | "Torsion des Getriebes unter einem Drehmoment oder das Drehmoment zu einem Winkel";
    torsion_angle =
        "Torsion angle, for example \"1 arcmin\", instead of the torque"
        | "Torsionswinkel, zum Beispiel \"1 arcmin\", statt des Drehmoments";
    torsion_torque = "Torque at the output, for example \"60 N m\"" | "Drehmoment am Abtrieb, zum Beispiel \"60 N m\"";
    bearing =
        "Output bearing of every size under the loads of a project"
        | "Abtriebslager jeder Baugröße unter den Lasten eines Projekts";
    battery = "Battery life of a buffered encoder" | "Lebensdauer der Batterie eines gepufferten Gebers";
    battery_hours = "Hours of operation per day, 0 to 24" | "Betriebsstunden je Tag, 0 bis 24";
    battery_storage =
        "Storage before operation, for example \"1 a\"; default: none"
        | "Lagerung vor dem Betrieb, zum Beispiel \"1 a\"; ohne Angabe keine";
    mount =
        "Mounting of an actuator: fits, screws and their utilisation, mass"
        | "Montage eines Antriebs: Passungen, Schrauben und ihre Auslastung, Masse";
    mount_bore =
        "Bore for both pilots: a tolerance zone such as K7, or limit deviations such as \"+12/-3 µm\"; default: H7, as recommended in the manual"
        | "Bohrung für beide Zentrierungen: ein Toleranzfeld wie K7 oder Grenzabmaße wie \"+12/-3 µm\"; ohne Angabe H7 nach Empfehlung der Anleitung";
    mount_bore_load = "Bore of the load, if different" | "Bohrung der Last, falls abweichend";
    mount_bore_housing = "Bore of the machine, if different" | "Bohrung der Maschine, falls abweichend";
    mount_project =
        "Project whose torques and flange loads are used instead of the limits"
        | "Projekt, dessen Drehmomente und Flanschlasten anstelle der Grenzwerte gelten";
    upkeep =
        "Maintenance plan with dates, from storage to disposal"
        | "Wartungsplan mit Terminen, von der Lagerung bis zur Entsorgung";
    upkeep_delivered = "Date of delivery, for example 2026-03-01" | "Lieferdatum, zum Beispiel 2026-03-01";
    upkeep_storage =
        "Storage before operation: a time such as \"1 a\" or \"6 months\", or the date on which it ends"
        | "Lagerung vor dem Betrieb: eine Dauer wie \"1 a\" oder \"6 Monate\" oder das Datum, an dem sie endet";
    upkeep_hours =
        "Hours of operation per day, 0 to 24, for the encoder battery"
        | "Betriebsstunden je Tag, 0 bis 24, für die Geberbatterie";
    upkeep_inspect =
        "Interval for work the manual calls for regularly, such as \"6 months\"; default: one year, listed as assumed"
        | "Intervall für laut Anleitung regelmäßige Arbeiten, etwa \"6 Monate\"; ohne Angabe ein Jahr, als Annahme ausgewiesen";
    upkeep_today =
        "Reference date: marks overdue dates and the next date of each series"
        | "Bezugsdatum: kennzeichnet überschrittene Termine und den nächsten Termin jeder Reihe";
    upkeep_ical = "Write the plan as an iCalendar file (.ics)" | "Den Plan als iCalendar-Datei (.ics) schreiben";
    upkeep_name =
        "Name of the actuator in the calendar, to distinguish actuators with the same ordering code"
        | "Name des Antriebs im Kalender zur Unterscheidung bei gleicher Bestellbezeichnung";
    drive =
        "Virtual drive with the CiA 402 objects, for testing a controller"
        | "Virtueller Servoregler mit den Objekten nach CiA 402, zum Test einer Steuerung";
    drive_project =
        "Project of the axis: load, supply, gains; default: an inertia without friction"
        | "Projekt der Achse: Last, Versorgung, Verstärkungen; ohne Angabe ein reibungsfreies Massenträgheitsmoment";
    drive_inertia =
        "Moment of inertia of the load if no project is given, such as \"2 kg m²\"; default: that of the actuator"
        | "Massenträgheitsmoment der Last, wenn kein Projekt angegeben ist, etwa \"2 kg m²\"; ohne Angabe das des Antriebs";
    drive_protocol = "Communication protocol of the clients" | "Kommunikationsprotokoll der Clients";
    drive_time =
        "Time base: real time, or stepped by the client with a request or with each SYNC message by the period of 60C2h"
        | "Zeitbasis: Echtzeit oder schrittweise durch den Client, per Anfrage oder mit jeder SYNC-Nachricht um die Periode aus 60C2h";
    drive_port =
        "Port; 0 selects a free port (29535, for CAN 29536, or a free port if this one is in use)"
        | "Port; 0 wählt einen freien Port (29535, für CAN 29536, oder einen freien, wenn dieser belegt ist)";
    drive_node = "CANopen node ID" | "CANopen-Knotennummer";
    drive_eds =
        "Print the electronic data sheet (EDS, CiA 306) and exit"
        | "Elektronisches Datenblatt (EDS, CiA 306) ausgeben und beenden";
    serve = "Workbench in the browser, on this computer" | "Auslegungswerkzeug im Browser, auf diesem Rechner";
    serve_folder =
        "Folder with the project files; nothing outside it is read or written (current folder)"
        | "Ordner mit den Projektdateien; außerhalb wird nichts gelesen oder geschrieben (aktueller Ordner)";
    serve_port =
        "Port; 0 selects a free port (8377, or a free port if this one is in use)"
        | "Port; 0 wählt einen freien Port (8377, oder einen freien, wenn dieser belegt ist)";
    serve_open = "Open the browser" | "Den Browser öffnen";
    serve_listen(one, all) =
        "Network address to listen on instead of this computer only, such as {one}, or {all} for all addresses"
        | "Netzwerkadresse, unter der der Server statt nur auf diesem Rechner erreichbar ist, etwa {one}, oder {all} für alle Adressen";
    serve_no_token =
        "Accept requests without the token of the address shown: every user and program on this computer can then read and write the projects in the folder"
        | "Anfragen ohne das Token der ausgegebenen Adresse annehmen: jeder Benutzer und jedes Programm auf diesem Rechner kann dann die Projekte des Ordners lesen und schreiben";
    new = "Create a commented project file to fill in" | "Kommentierte Projektdatei zum Ausfüllen erzeugen";
    new_example =
        "An example of a machine with all that it may have, instead of the plain file"
        | "Ein Beispiel einer Maschine mit allem, was sie haben kann, statt der einfachen Datei";
    new_out =
        "Project file to write; for kind recording, an example recording is written beside it"
        | "Zu schreibende Projektdatei; bei der Art recording mit einer Beispielaufzeichnung daneben";
    glossary =
        "Terms and symbols with their definitions, in both languages"
        | "Begriffe und Formelzeichen mit Definition, in beiden Sprachen";
    glossary_term =
        "Symbol, identifier or term, for example T_rms; default: all"
        | "Formelzeichen, Kennung oder Begriff, zum Beispiel T_rms; ohne Angabe alle";
    units =
        "Accepted units with all spellings and their value in SI"
        | "Zulässige Einheiten mit allen Schreibweisen und ihrem Wert in SI";
    units_quantity =
        "Quantity or unit, for example torque or rpm; default: all"
        | "Größe oder Einheit, zum Beispiel Drehmoment oder Nm; ohne Angabe alle";
    licences =
        "Licences of antrieb and of all components included, fonts too"
        | "Lizenzen von antrieb und allen enthaltenen Komponenten einschließlich der Schriften";
    completions = "Completion script for a shell" | "Vervollständigung für eine Shell";
    help = "Help on a command" | "Hilfe zu einem Befehl";
    help_command = "Command; default: all" | "Befehl; ohne Angabe alle";
    man = "Manual page (roff)" | "Handbuchseite (roff)";
    man_command = "Command; default: antrieb itself" | "Befehl; ohne Angabe antrieb selbst";
    schema = "JSON Schema of the project file, or of the answers" | "JSON-Schema der Projektdatei oder der Antworten";
    schema_answers = "Output of --json for each command" | "Ausgabe von --json je Befehl";
    shapes =
        "Shapes and their keys (axis: parallel or perpendicular to the axis of rotation):"
        | "Formen und ihre Schlüssel (axis: parallel oder perpendicular, senkrecht zur Drehachse):";
    shapes_all =
        "All: mass or density; distance from the axis of rotation (0), angle (0), count evenly spaced (1).\n(length), (height): with density, or with axis=perpendicular."
        | "Alle: mass oder density; distance von der Drehachse (0), angle (0), count gleichmäßig verteilt (1).\n(length), (height): mit density oder axis=perpendicular.";
    inertia = "Moment of inertia of solid bodies" | "Massenträgheitsmoment von Vollkörpern";
    inertia_body =
        "Each body in quotes, for example \"disc diameter=200mm length=20mm density=7850kg/m^3\""
        | "Jeder Körper in Anführungszeichen, etwa \"disc diameter=200mm length=20mm density=7850kg/m^3\"";
    curve = "Curves of the torque-speed plane" | "Kennlinien in der Drehmoment-Drehzahl-Ebene";
    curve_voltage =
        "Motor terminal voltage, rms, for example \"220 V\"; default: the range of the manufacturer's data"
        | "Klemmenspannung des Motors, effektiv, zum Beispiel \"220 V\"; ohne Angabe gilt der Bereich der Herstellerangaben";
    plot =
        "Diagram of an axis with an actuator, as SVG or PNG"
        | "Diagramm einer Achse mit einem Antrieb, als SVG oder PNG";
    own_or_best_code =
        "Ordering code; default: the project's own [actuator], otherwise the best of the catalogue"
        | "Bestellbezeichnung; ohne Angabe der eigene [actuator] des Projekts, sonst der beste des Katalogs";
    plot_by =
        "Abscissa of candidate_map" | "Abszisse von candidate_map";
    plot_without_files =
        "Without --svg and --png, the SVG is written to standard output."
        | "Ohne --svg und --png wird das SVG auf die Standardausgabe geschrieben.";
    svg = "Draw into this SVG file; - is standard output" | "In diese SVG-Datei zeichnen; - ist die Standardausgabe";
    png = "Draw into this PNG file" | "In diese PNG-Datei zeichnen";
    theme = "Colours of the picture" | "Farben des Bildes";
    width =
        "Width of the picture, for example \"160 mm\"; default: by its content"
        | "Breite des Bildes, zum Beispiel \"160 mm\"; ohne Angabe nach dem Inhalt";
    height =
        "Height of the picture, for example \"100 mm\"; increased if the content requires it"
        | "Höhe des Bildes, zum Beispiel \"100 mm\"; wird vergrößert, wenn der Inhalt es erfordert";
    compare =
        "Two to five actuators side by side, check by check"
        | "Zwei bis fünf Antriebe nebeneinander, Nachweis für Nachweis";
    compare_code =
        "Ordering code; repeat for each actuator"
        | "Bestellbezeichnung; für jeden Antrieb einmal anzugeben";
    diff =
        "Changes in each check between two revisions of a project"
        | "Änderungen in jedem Nachweis zwischen zwei Ständen eines Projekts";
    diff_old = "Project file before" | "Projektdatei vorher";
    diff_new =
        "Project file after, with the changed values of the call; only with such values it may be omitted. Its verdict determines the exit code"
        | "Projektdatei nachher, mit den geänderten Werten des Aufrufs; nur mit solchen Werten kann sie entfallen. Ihr Ergebnis bestimmt den Rückgabewert";
    diff_code =
        "Ordering code; default: the project's own [actuator], otherwise the best one before"
        | "Bestellbezeichnung; ohne Angabe der eigene [actuator] des Projekts, sonst der beste vorher";
    export =
        "The results as a workbook, or one table as CSV, JSON or Parquet"
        | "Die Ergebnisse als Arbeitsmappe, oder eine Tabelle als CSV, JSON oder Parquet";
    export_code =
        "Ordering code; default: the project's own [actuator], otherwise the best one"
        | "Bestellbezeichnung; ohne Angabe der eigene [actuator] des Projekts, sonst der beste";
    export_out =
        "File to write, by its ending: .xlsx, .csv, .json, .parquet; - or none: CSV to standard output"
        | "Zieldatei, nach ihrer Endung: .xlsx, .csv, .json, .parquet; - oder keine: CSV auf die Standardausgabe";
    export_table =
        "One table: inputs, assumptions, demand, motion, candidates, checks, course"
        | "Eine Tabelle: inputs, assumptions, demand, motion, candidates, checks, course";
    export_top =
        "Number of ranked actuators in the tables (20)"
        | "Anzahl der Antriebe der Rangfolge in den Tabellen (20)";
    export_revision = "Revision on the first sheet" | "Revision auf dem ersten Blatt";
    export_date =
        "Date on the first sheet; default: none, so that the same call gives the same bytes"
        | "Datum auf dem ersten Blatt; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes ergibt";
    report = "The results as a PDF to sign" | "Die Ergebnisse als PDF zum Unterschreiben";
    report_out =
        "PDF file to write (that beside the project, with its name)"
        | "Zu schreibende PDF-Datei (die neben dem Projekt, mit seinem Namen)";
    report_full =
        "Include the derivation of every check, all sources and all ordering codes as appendices"
        | "Mit Herleitung jedes Nachweises, allen Quellen und allen Bestellbezeichnungen im Anhang";
    report_installation =
        "Include wiring, mounting and commissioning of the ordering code, and maintenance if --delivered is given"
        | "Mit Verdrahtung, Montage und Inbetriebnahme zur Bestellbezeichnung; mit Wartung, wenn --delivered angegeben ist";
    report_delivered =
        "Date of delivery, for example 2026-03-01; start of the maintenance plan"
        | "Lieferdatum, zum Beispiel 2026-03-01; Beginn des Wartungsplans";
    date =
        "Date of the document, for example 2026-11-21; default: none, so that the same call gives the same bytes"
        | "Datum des Dokuments, zum Beispiel 2026-11-21; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes ergibt";
    revision = "Revision of the document" | "Revision des Dokuments";
    title = "Project, plant or order" | "Projekt, Anlage oder Auftrag";
    number = "Document number" | "Dokumentnummer";
    author = "Author" | "Bearbeitet von";
    company = "Company or office" | "Firma oder Büro";
    customer = "Customer" | "Kunde";
    order = "Number of the order" | "Auftragsnummer";
    change =
        "Line of the list of changes, for example \"B; 2026-11-21; E. Example; longer stroke\"; may be repeated"
        | "Zeile der Änderungsliste, zum Beispiel \"B; 2026-11-21; E. Beispiel; längerer Hub\"; mehrfach möglich";
    archive = "As PDF/A for archiving; requires --date" | "Als PDF/A zum Archivieren; erfordert --date";
    force = "Replace an existing file" | "Eine vorhandene Datei ersetzen";
    usage = "Usage" | "Aufruf";
}
