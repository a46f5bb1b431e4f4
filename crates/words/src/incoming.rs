//! Words for a recording before it is part of a project.

use crate::texts::texts;

texts! {
    tile = "Recording" | "Aufzeichnung";
    tile_about =
        "Open a CSV or Parquet file, drop it anywhere on the page, or paste a table."
        | "Eine CSV- oder Parquet-Datei öffnen, irgendwo auf die Seite ziehen oder eine Tabelle einfügen.";
    title(name) = "Recording {name}" | "Aufzeichnung {name}";
    drop_here = "Drop a project file or a recording" | "Projektdatei oder Aufzeichnung hier ablegen";
    one_file = "One file at a time: the first one is read." | "Nur eine Datei auf einmal: Die erste wird gelesen.";
    too_large(most) =
        "The file is larger than {most} MB and was not read. Packed with gzip or Zstandard or saved as Parquet it is smaller; a part is selected by its rows."
        | "Die Datei ist größer als {most} MB und wurde nicht gelesen. Mit gzip oder Zstandard gepackt oder als Parquet gespeichert ist sie kleiner; ein Teil lässt sich über seine Zeilen auswählen.";
    columns = "Columns" | "Spalten";
    heading = "Heading" | "Überschrift";
    beginning = "First rows" | "Erste Zeilen";
    used_as = "Used as" | "Verwendung";
    used_as_of(column) = "Use of {column}" | "Verwendung von {column}";
    not_used = "not used" | "nicht verwendet";
    unit_stated(unit) = "{unit} (file)" | "{unit} (Datei)";
    unit_of_column(column) = "Unit of {column}" | "Einheit von {column}";
    ratio = "Ratio to the output" | "Übersetzung zum Abtrieb";
    ratio_of(column) = "Ratio to the output of {column}" | "Übersetzung zum Abtrieb von {column}";
    ratio_about =
        "Ratio: turns at the place of recording per turn of the output, negative where the directions differ; empty: recorded at the output."
        | "Übersetzung: Umdrehungen am Ort der Aufzeichnung je Umdrehung des Abtriebs, negativ bei entgegengesetzter Drehrichtung; leer: am Abtrieb aufgezeichnet.";
    more_columns(count) =
        "1 more column is not used." | "1 weitere Spalte wird nicht verwendet.",
        "{count} more columns are not used." | "{count} weitere Spalten werden nicht verwendet.";
    from_position(name) = "{name}, derived from the position" | "{name}, aus der Position abgeleitet";
    range_of(name, low, high, unit) = "{name}: {low} to {high} {unit}" | "{name}: {low} bis {high} {unit}";
    found = "Found in the file" | "Befund der Datei";
    rows = "Rows" | "Zeilen";
    period = "Period" | "Dauer";
    sample_time = "Sample time" | "Abtastzeit";
    sample_time_varies(median, least, most) =
        "{median} (median), {least} to {most}" | "{median} (Median), {least} bis {most}";
    step_of(column) = "Step, {column}" | "Quantisierungsschritt, {column}";
    noise_of(column) = "Noise (1σ), {column}" | "Rauschen (1σ), {column}";
    ends_of(column) = "Beginning and end, {column}" | "Anfang und Ende, {column}";
    from_to(from, to) = "{from}, {to}" | "{from}; {to}";
    outliers(count, column, value, time) =
        "{column}: one value far from those before and after, {value} at {time}. If it is a recording error, delete its row: a single peak determines the actuator."
        | "{column}: ein Wert weit neben den Werten davor und danach, {value} bei {time}. Ist er ein Fehler der Aufzeichnung, seine Zeile löschen: Eine Spitze entscheidet über den Antrieb.",
        "{column}: {count} values far from those before and after, the farthest {value} at {time}. If they are recording errors, delete their rows: a single peak determines the actuator."
        | "{column}: {count} Werte weit neben den Werten davor und danach, der äußerste {value} bei {time}. Sind sie Fehler der Aufzeichnung, ihre Zeilen löschen: Eine Spitze entscheidet über den Antrieb.";
    jump(change, time) =
        "The position jumps by {change} at {time}, from one row to the next: it was set anew, or rows are missing. Use the part before or behind it."
        | "Die Position springt bei {time} von einer Zeile zur nächsten um {change}: Sie wurde neu gesetzt, oder Zeilen fehlen. Den Teil davor oder dahinter verwenden.";
    choose_below = "choose column and unit in the table below" | "Spalte und Einheit unten in der Tabelle wählen";
    column_number(number) = "column {number}" | "Spalte {number}";
    unit_of(column) = "unit of {column}" | "Einheit von {column}";
    ratio_of_column(column) = "ratio of {column}" | "Übersetzung von {column}";
    at_most(value) = "at most {value}" | "höchstens {value}";
    none_found = "none found" | "keiner gefunden";
    steps_alone(alone, motion) =
        "The steps of the file alone produce accelerations of up to {alone}; the motion itself has {motion}."
        | "Allein die Quantisierungsschritte der Datei ergeben Beschleunigungen bis {alone}; die Bewegung selbst hat {motion}.";
    noise_alone(alone, motion) =
        "The noise of the recorded values alone produces accelerations of up to {alone}; the motion itself has {motion}."
        | "Allein das Rauschen der aufgezeichneten Werte ergibt Beschleunigungen bis {alone}; die Bewegung selbst hat {motion}.";
    in_the_peak = "The peak torque contains this." | "Das Spitzendrehmoment enthält diesen Anteil.";
    in_the_actuator_alone =
        "The recorded torque does not contain this, the torque for the actuator's own inertia does."
        | "Das aufgezeichnete Drehmoment enthält diesen Anteil nicht, das für die Eigenträgheit des Antriebs schon.";
    not_with_this =
        "no result: the cycle does not close, or the window is too narrow"
        | "kein Ergebnis: Der Zyklus schließt nicht, oder das Fenster ist zu schmal";
    held_alone(period, alone, motion) =
        "The values are updated every {period} only; this alone produces accelerations of up to {alone}; the motion itself has {motion}."
        | "Die Werte werden nur alle {period} aktualisiert; allein daraus folgen Beschleunigungen bis {alone}; die Bewegung selbst hat {motion}.";
    stamps_alone(scatter, alone, motion) =
        "The time stamps scatter by {scatter}; this alone produces accelerations of up to {alone}; the motion itself has {motion}."
        | "Die Zeitstempel streuen um {scatter}; allein daraus folgen Beschleunigungen bis {alone}; die Bewegung selbst hat {motion}.";
    interpolate = "Interpolate between the updates" | "Zwischen den Aktualisierungen interpolieren";
    even_rows = "Take the rows as evenly spaced" | "Gleiche Zeitabstände annehmen";
    smoothing = "Smoothing" | "Glättung";
    smoothing_about =
        "Peak torque of the load for each width of the smoothing window, without the moment of inertia of the actuator:"
        | "Spitzendrehmoment der Last je Breite des Glättungsfensters, ohne das Massenträgheitsmoment des Antriebs:";
    acceleration_about =
        "Largest acceleration for each width of the smoothing window:" | "Größte Beschleunigung je Breite des Glättungsfensters:";
    no_smoothing = "none" | "keine";
    removes_steps = "proposed: reduces the effect of the steps to a twentieth" | "Vorschlag: verringert den Einfluss der Quantisierungsschritte auf ein Zwanzigstel";
    other_window = "other width" | "andere Breite";
    peak_later =
        "The peak torque follows with the answer about the torque and a load." | "Das Spitzendrehmoment folgt mit der Angabe zum Drehmoment und einer Last.";
    torque_question = "What is the recorded torque or force?" | "Was ist das aufgezeichnete Drehmoment oder die Kraft?";
    torque_whole = "The whole load" | "Die gesamte Last";
    torque_whole_about =
        "inertia, friction and process together; only the inertia of the actuator itself is added"
        | "Massenträgheit, Reibung und Prozess zusammen; hinzu kommt nur das Massenträgheitsmoment des Antriebs";
    torque_process = "A torque or force of the process" | "Ein Prozessmoment oder eine Prozesskraft";
    torque_process_about =
        "it is added to inertia, gravity and friction described in the project"
        | "wird zu Massenträgheit, Schwerkraft und Reibung des Projekts addiert";
    torque_unused = "Not to be used" | "Nicht verwenden";
    torque_unused_about =
        "the torque is computed from the load in the project" | "das Drehmoment wird aus der Last des Projekts berechnet";
    is_added(list) = "The recorded torque is added to: {list}." | "Das aufgezeichnete Drehmoment wird addiert zu: {list}.";
    is_added_to_nothing =
        "The project describes no load yet that the recorded torque is added to."
        | "Das Projekt beschreibt noch keine Last, zu der das aufgezeichnete Drehmoment addiert wird.";
    is_removed(list) =
        "The recorded torque replaces the load of the project. Removed: {list}. Undo restores it."
        | "Das aufgezeichnete Drehmoment ersetzt die Last des Projekts. Entfernt: {list}. Rückgängig stellt sie wieder her.";
    place = "Motion of the axis" | "Bewegung der Achse";
    replaces = "replaces the motion" | "ersetzt die Bewegung";
    is_added_behind = "is appended to the motion" | "wird an die Bewegung angehängt";
    runs_once = "Single move: the axis is not required to end as it begins" | "Einmalige Bewegung: Die Achse muss nicht so enden, wie sie beginnt";
    load_later = "Optional: it can also be stated later." | "Optional: Die Angabe kann auch später folgen.";
    load_missing = "The load is missing: choose its mechanism" | "Die Last fehlt: die Mechanik wählen";
    line_missing =
        "a motion along a line needs a constant travel per revolution"
        | "eine Bewegung längs einer Geraden erfordert einen festen Weg je Umdrehung";
    mechanism_about =
        "Its travel per revolution relates the recording along a line to the output."
        | "Ihr Weg je Umdrehung rechnet die Aufzeichnung längs einer Geraden auf den Abtrieb um.";
    state_mechanism = "State the mechanism first." | "Zuerst die Mechanik angeben.";
    still_open = "Still open in the project afterwards" | "Danach im Projekt noch offen";
    unusable = "The file cannot be used like this" | "So lässt sich die Datei nicht verwenden";
    no_table(name) = "{name} contains no table of numbers." | "{name} enthält keine Tabelle mit Zahlen.";
    text_is_faulty =
        "The text of the project is not valid TOML; the recording can be used once it has been corrected."
        | "Der Text des Projekts ist kein gültiges TOML; danach lässt sich die Aufzeichnung verwenden.";
    use_it = "Use it" | "Verwenden";
    answer_first = "Answer the question about the torque first." | "Zuerst die Frage zum Drehmoment beantworten.";
    not_written_yet = "Nothing is written until then." | "Bis dahin wird nichts geschrieben.";
}
