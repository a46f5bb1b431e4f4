//! Words of the tables and of the workbook: titles, what a column means, the first sheet, the charts.

use crate::texts::texts;

texts! {
    key = "key" | "Schlüssel";
    key_about = "key of the project file" | "Schlüssel der Projektdatei";
    written = "written" | "geschrieben";
    written_about = "as it stands there" | "wie es dort steht";
    value_of_input_about = "the number, in its unit" | "die Zahl in ihrer Einheit";
    tolerance = "± tolerance" | "± Toleranz";
    tolerance_about =
        "half-width of its tolerance, in the same unit"
        | "halbe Breite der Toleranz, in derselben Einheit";
    unit_of_input_about = "unit of value and tolerance" | "Einheit von Wert und Toleranz";
    inputs_about = "every value of the project file" | "jeder Wert der Projektdatei";
    number_about = "running number" | "laufende Nummer";
    assumption = "assumption" | "Annahme";
    assumption_about = "assumed instead of a statement" | "angenommen statt angegeben";
    assumptions_about = "assumptions for values that are not stated" | "Annahmen für nicht angegebene Werte";
    at_the_output = "at the output" | "am Abtrieb";
    along_the_line = "along the line" | "entlang der Linie";
    segment_about = "number of the segment" | "Nummer des Abschnitts";
    law_about = "law of motion, or rest" | "Bewegungsgesetz, oder Rast";
    from = "from" | "ab";
    from_about = "instant of its beginning" | "Zeitpunkt des Beginns";
    recording_about = "file of the recording" | "Datei der Aufzeichnung";
    motion_about =
        "the segments of the motion, what was given and what followed: distance, largest speed and acceleration"
        | "die Abschnitte der Bewegung, was gegeben ist und was folgt: Weg, größte Drehzahl und Beschleunigung";
    time_of_course_about = "instant; twice where something jumps" | "Zeitpunkt; doppelt, wo etwas springt";
    angle = "angle" | "Winkel";
    of_the_output = "of the output" | "des Abtriebs";
    torque = "torque" | "Drehmoment";
    torque_of_course_about =
        "of the actuator at the output, its own inertia included"
        | "des Antriebs am Abtrieb, mit der eigenen Trägheit";
    motor_current = "motor current" | "Motorstrom";
    motor_current_about = "rms, signed like the torque" | "effektiv, mit dem Vorzeichen des Drehmoments";
    power = "power" | "Leistung";
    power_about = "electrical, at the motor terminals" | "elektrisch, an den Motorklemmen";
    temperature_about =
        "temperature in the steady cycle; estimated, model thermal"
        | "Temperatur im eingeschwungenen Zyklus; geschätzt, Modell Erwärmung";
    overload = "I²t";
    overload_about =
        "filtered square of the current over that of I_0, 1 is the limit; model overload"
        | "gefiltertes Quadrat des Stroms über dem von I_0, 1 ist die Grenze; Modell Überlast";
    course_about =
        "the cycle of the chosen actuator as time series"
        | "der Zyklus des gewählten Antriebs als Zeitreihe";
    course = "Course" | "Verlauf";
    utilisation_of_check_about =
        "utilisation of this check, 1 is the limit"
        | "Auslastung dieses Nachweises, 1 ist die Grenze";
    ordering_code_about =
        "ordering code, or name of the project's own actuator"
        | "Bestellbezeichnung oder Name des eigenen Antriebs";
    whole_cycle_about =
        "over the whole cycle, own inertia included"
        | "über den ganzen Zyklus, mit der eigenen Trägheit";
    governing_torque_about = "of the governing move, eq. 69.1 and 69.2" | "der maßgebenden Bewegung, Gl. 69.1 und 69.2";
    mode = "mode" | "Verfahren";
    mode_about =
        "manual: equations 69.1 to 69.4; integral: exact integral over the motion, which the checks use"
        | "manual: Gleichungen 69.1 bis 69.4; integral: exaktes Integral über die Bewegung, mit dem geprüft wird";
    at = "at" | "bei";
    peak_torque_at_about = "instant of the peak torque" | "Zeitpunkt des Spitzendrehmoments";
    mean_speed_about = "mean of |n|, pauses included" | "Mittel von |n|, mit den Pausen";
    peak_speed_about = "largest |n|" | "größtes |n|";
    duty_factor_about = "share of the cycle in motion" | "Anteil der Bewegung am Zyklus";
    t_1_accelerating = "T_1 accelerating" | "T_1 Beschleunigen";
    t_2_running = "T_2 running" | "T_2 Fahren";
    t_3_braking = "T_3 braking" | "T_3 Bremsen";
    governing_move = "governing move" | "maßgebende Bewegung";
    governing_move_about =
        "number of the move that T_1 to T_3 belong to"
        | "Nummer der Bewegung, zu der T_1 bis T_3 gehören";
    demand_about =
        "what the axis asks of each candidate, by the manual's equations and by exact integrals"
        | "was die Achse von jedem Kandidaten verlangt, nach den Gleichungen der Anleitung und nach exakten Integralen";
    data_sheet_about = "from its data sheet" | "aus seinem Datenblatt";
    rank_about =
        "place in the ranking; none where it does not fit"
        | "Platz in der Reihenfolge; keiner, wo er nicht geeignet ist";
    candidate_verdict_about = "fits: nothing speaks against it" | "fits: nichts spricht dagegen";
    highest_utilisation_about = "highest of all limits, 1 is the limit" | "höchste aller Grenzen, 1 ist die Grenze";
    tightest_check_about = "id of the check that it belongs to" | "Kennung des Nachweises, zu dem sie gehört";
    margin_about = "1 less the utilisation" | "1 weniger der Auslastung";
    open_questions = "open questions" | "offene Fragen";
    open_questions_about =
        "number of checks not made because a datum is missing"
        | "Zahl der Nachweise, für die eine Angabe fehlt";
    on_request_about = "fields of the code that are on request only" | "Felder des Codes, die es nur auf Anfrage gibt";
    objections = "requirements not met" | "nicht erfüllt";
    objections_about = "requirements not met and rules broken" | "Anforderungen nicht erfüllt, Regeln verletzt";
    candidates_about =
        "the candidates in their order, with the utilisation of every check"
        | "die Kandidaten in ihrer Reihenfolge, mit der Auslastung jedes Nachweises";
    check_id = "id" | "Kennung";
    check_id_about = "id of the check" | "Kennung des Nachweises";
    check_title_about = "its title" | "ihr Titel";
    check_verdict_about = "pass, fail, advice or not_checked" | "pass, fail, advice oder not_checked";
    value_of_check_about = "what the axis asks" | "was die Achse verlangt";
    limit_about = "limit of the actuator, or the limit required" | "Grenze des Antriebs oder geforderte Grenze";
    unit_of_check_about = "unit of value and limit" | "Einheit von Wert und Grenze";
    direction = "direction" | "Richtung";
    direction_about =
        "at_most or at_least: how the value must lie to the limit"
        | "at_most oder at_least: wie der Wert zur Grenze liegen muss";
    utilisation_about = "1 is the limit" | "1 ist die Grenze";
    worst_at_about = "instant of the worst case within the cycle" | "Zeitpunkt des ungünstigsten Falls im Zyklus";
    grade_about = "the worst grade among the inputs" | "die schlechteste Güte unter den Eingaben";
    source_about = "source of the limit; of the value" | "Quelle der Grenze; des Werts";
    missing_about = "what a check that is not answered lacks" | "was einem nicht geführten Nachweis fehlt";
    remarks_about = "what a reader must know" | "was ein Leser wissen muss";
    checks_about = "every check of the candidates shown" | "jeder Nachweis der gezeigten Kandidaten";
    sheet = "sheet" | "Blatt";
    heading = "heading" | "Überschrift";
    name_in_csv_json_parquet = "name in CSV, JSON, Parquet" | "Name in CSV, JSON, Parquet";
    meaning_and_source = "meaning and source" | "Bedeutung und Quelle";
    charts = "Charts" | "Diagramme";
    course_chart =
        "Torque and speed at the output over the cycle"
        | "Drehmoment und Drehzahl am Abtrieb über den Zyklus";
    time_in_s = "time in s" | "Zeit in s";
    torque_in_nm = "torque in Nm" | "Drehmoment in Nm";
    speed_per_minute = "speed in min⁻¹" | "Drehzahl in min⁻¹";
    checks_chart = "Utilisation of the checks, 100 % is the limit" | "Auslastung der Nachweise, 100 % ist die Grenze";
    date_format = "yyyy-mm-dd" | "dd.mm.yyyy";
    overview = "Overview" | "Übersicht";
    t_rms_from_the_course = "T_rms from the course" | "T_rms aus dem Verlauf";
    t_rms_from_the_course_about =
        "formula over the sheet of the course, torque linear between its instants"
        | "Formel über das Blatt „Verlauf“, Drehmoment zwischen den Zeitpunkten linear";
    t_rms_exact = "T_rms exact" | "T_rms exakt";
    difference = "difference" | "Unterschied";
    difference_about = "what the sampling leaves out" | "was die Abtastung weglässt";
    too_many_rows(count, name) =
        "{count}, too many for a sheet: antrieb export --table {name}"
        | "{count}, zu viele für ein Blatt: antrieb export --table {name}";
    about_antrieb =
        "antrieb is an open engineering workbench for hollow-shaft servo actuators; it is not affiliated with their maker."
        | "antrieb ist ein offenes Auslegungswerkzeug für Hohlwellen-Servoantriebe; es steht in keiner Verbindung zu deren Hersteller.";
    project_file = "project file" | "Projektdatei";
    antrieb_version = "antrieb, version" | "antrieb, Version";
    rms_torque_computed_twice = "Rms torque, computed twice" | "Effektives Drehmoment, zweimal gerechnet";
    t_rms_exact_about = "exact integral, which the checks use" | "exaktes Integral, mit dem geprüft wird";
    sheets = "Sheets" | "Blätter";
    how_to_read_it = "How to read it" | "Wie man es liest";
    legend_fine = "up to 80 % of a limit, or passed" | "bis 80 % einer Grenze, oder erfüllt";
    legend_near = "above 80 % of a limit, or advice" | "über 80 % einer Grenze, oder Hinweis";
    legend_over = "above a limit, or failed" | "über einer Grenze oder nicht erfüllt";
    legend_open =
        "not checked: a datum is missing; it counts as neither passed nor failed"
        | "nicht geprüft: eine Angabe fehlt; es zählt weder als erfüllt noch als nicht erfüllt";
    rows(count) = "1 row" | "1 Zeile", "{count} rows" | "{count} Zeilen";
}
