//! Words for the views of the middle pane: cursor, editor of the motion, simulation.

use crate::texts::texts;

texts! {
    place_on_the_axis = "Place on the horizontal axis" | "Stelle auf der waagerechten Achse";
    across_about =
        "Moves a line through the plane; the row shows the value of each curve there. The pointer over the plane does the same."
        | "Bewegt eine Linie durch die Ebene; die Zeile zeigt den Wert jeder Kurve an dieser Stelle. Der Zeiger über der Ebene bewirkt dasselbe.";
    candidate_by_mass = "Candidate, by ascending mass" | "Kandidat nach steigender Masse";
    zoom_about =
        "Also by dragging over a diagram, by the wheel with Ctrl, and by double click for the whole cycle"
        | "Auch durch Ziehen über ein Diagramm, mit Strg und Mausrad; Doppelklick zeigt den ganzen Zyklus";
    peak_of_segment(number, law) = "peak speed of segment {number}, {law}" | "Höchstgeschwindigkeit von Abschnitt {number}, {law}";
    peak_about =
        "A higher peak shortens the segment, a lower one lengthens it; what is stated of time, speed and acceleration follows"
        | "Eine höhere Spitze verkürzt den Abschnitt, eine niedrigere verlängert ihn; die angegebenen Werte von Zeit, Geschwindigkeit und Beschleunigung folgen";
    way_back_follows = "Adjust the return move" | "Rückweg angleichen";
    single_move = "Make it a single move" | "Als einmalige Bewegung";
    law = "Law" | "Gesetz";
    distance = "Distance" | "Weg";
    time = "Time" | "Zeit";
    cell_of_segment(name, number) = "{name}, segment {number}" | "{name}, Abschnitt {number}";
    follows_about = "Follows from the stated values" | "Folgt aus den angegebenen Werten";
    paste_about =
        "Rows of a spreadsheet can be pasted into a cell; with headings they replace the motion"
        | "Zeilen einer Tabelle lassen sich in eine Zelle einfügen; mit Überschriften ersetzen sie die Bewegung";
    peaks_about =
        "Peak factors of VDI 2143: largest speed over mean speed, largest acceleration times time squared over distance"
        | "Kennwerte nach VDI 2143: größte durch mittlere Geschwindigkeit, größte Beschleunigung mal Zeitquadrat durch Weg";
    keep_run = "Keep run for comparison" | "Lauf zum Vergleich merken";
    discard_run = "End comparison" | "Vergleich beenden";
    kept_run = "Kept run" | "Gemerkter Lauf";
    slider = "slider" | "Schieber";
    default_gain = "default value" | "Standardwert";
    margin = "margin" | "Reserve";
    next_steps = "Next steps" | "Nächste Schritte";
    is_stated = "stated" | "angegeben";
    is_open = "still open" | "noch offen";
    then_actuators = "The suitable actuators then appear here, each with its checks." | "Danach stehen hier die geeigneten Antriebe mit ihren Nachweisen.";
    load_not_sought(samples) =
        "A smaller load was not searched: each trial computes the load at {samples} instants again."
        | "Eine kleinere Last wurde nicht gesucht: Jeder Versuch berechnet die Last an {samples} Zeitpunkten neu.";
    seek_load = "Search it" | "Suchen";
    part_of_cycle = "Part of the cycle" | "Teil des Zyklus";
    part_from = "from" | "ab";
    part_for = "for" | "Dauer";
    part_start = "Beginning of the part" | "Beginn des Teils";
    part_duration = "Duration of the part" | "Dauer des Teils";
    run_part = "Simulate this part" | "Diesen Teil rechnen";
    whole_cycle = "Whole cycle" | "Ganzer Zyklus";
    part_shown(from, until, whole) =
        "Simulated: {from} to {until} of the cycle of {whole}. Times count from the beginning of this part."
        | "Gerechnet: {from} bis {until} des Zyklus von {whole}. Die Zeiten zählen ab Beginn dieses Teils.";
    part_is_warm =
        "Winding and housing begin at the temperatures of the sizing in the steady cycle."
        | "Wicklung und Gehäuse beginnen mit den Temperaturen der Auslegung im eingeschwungenen Zyklus.";
    part_outside(whole, least) =
        "The part must lie within the cycle, 0 to {whole}, and last at least {least}."
        | "Der Teil muss innerhalb des Zyklus liegen, 0 bis {whole}, und mindestens {least} dauern.";
    part_around(long, time, checks) = "{long} around {time}: {checks}" | "{long} um {time}: {checks}";
    long_way(turns) =
        "{turns} turns of the output in one segment: is the number right?"
        | "{turns} Umdrehungen des Abtriebs in einem Abschnitt: stimmt die Zahl?";
    in_quotes(words) = "“{words}”" | "„{words}“";
    line_gaps = "gaps" | "Lücken";
    line_held_values = "held values" | "gehaltene Werte";
    line_time_stamps = "time stamps" | "Zeitstempel";
    line_smoothing = "smoothing" | "Glättung";
    line_standstill = "limit of standstill" | "Grenze des Stillstands";
    line_from = "start of the window" | "Beginn des Fensters";
    line_to = "end of the window" | "Ende des Fensters";
}
