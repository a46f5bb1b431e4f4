//! Words for the tables and the workbook: titles, meanings of columns, the first sheet, the charts.

use crate::texts::texts;

texts! {
    key = "key" | "Schlüssel";
    key_about = "key of the project file" | "Schlüssel der Projektdatei";
    written = "as entered" | "Eingabe";
    written_about = "text in the project file" | "Text in der Projektdatei";
    value_of_input_about = "numerical value, in the stated unit" | "Zahlenwert in der angegebenen Einheit";
    tolerance = "± tolerance" | "± Toleranz";
    tolerance_about =
        "half-width of the tolerance, in the same unit"
        | "halbe Breite der Toleranz, in derselben Einheit";
    unit_of_input_about = "unit of value and tolerance" | "Einheit von Wert und Toleranz";
    inputs_about = "all values of the project file" | "alle Werte der Projektdatei";
    number_about = "consecutive number" | "laufende Nummer";
    assumption = "assumption" | "Annahme";
    assumption_about = "assumption for a value not stated" | "Annahme für einen nicht angegebenen Wert";
    assumptions_about = "assumptions for values that are not stated" | "Annahmen für nicht angegebene Werte";
    at_the_output = "at the output" | "am Abtrieb";
    along_the_line = "linear";
    segment_about = "number of the segment" | "Nummer des Abschnitts";
    law_about = "motion law, or dwell" | "Bewegungsgesetz oder Rast";
    from = "start" | "Beginn";
    from_about = "start time of the segment" | "Beginn des Abschnitts";
    recording_about = "file of the recording" | "Datei der Aufzeichnung";
    motion_about =
        "segments of the motion, stated and derived quantities: distance, maximum speed and acceleration"
        | "Abschnitte der Bewegung, angegebene und abgeleitete Größen: Weg, maximale Drehzahl und Beschleunigung";
    time_of_course_about = "instant; listed twice at discontinuities" | "Zeitpunkt; an Sprungstellen doppelt";
    angle = "angle" | "Winkel";
    of_the_output = "of the output" | "des Abtriebs";
    torque = "torque" | "Drehmoment";
    torque_of_course_about =
        "of the actuator at the output, including its own inertia"
        | "des Antriebs am Abtrieb, mit der eigenen Trägheit";
    torque_of_the_load_about =
        "of the load at the output; the inertia of the actuator is not known and not included"
        | "der Last am Abtrieb, ohne die nicht bekannte Trägheit des Antriebs";
    motor_current = "motor current" | "Motorstrom";
    motor_current_about = "rms, with the sign of the torque" | "effektiv, mit dem Vorzeichen des Drehmoments";
    power = "power" | "Leistung";
    power_about = "electrical, at the motor terminals" | "elektrisch, an den Motorklemmen";
    temperature_about =
        "temperature in the steady-state cycle; estimated, model thermal"
        | "Temperatur im eingeschwungenen Zyklus; geschätzt, Modell Erwärmung";
    overload = "I²t";
    overload_about =
        "filtered square of current / I_0, 1 is the limit; model overload"
        | "gefiltertes Quadrat von Strom/I_0, 1 ist die Grenze; Modell Überlast";
    course_about =
        "cycle of the selected actuator as time series"
        | "Zyklus des gewählten Antriebs als Zeitreihe";
    course = "Time series" | "Verlauf";
    utilisation_of_check_about =
        "utilisation of this check, 1 (100 %) is the limit"
        | "Auslastung dieses Nachweises, 1 (100 %) ist die Grenze";
    ordering_code_about =
        "ordering code, or name of the project's own actuator"
        | "Bestellbezeichnung oder Name des eigenen Antriebs";
    whole_cycle_about =
        "over the whole cycle, including own inertia"
        | "über den ganzen Zyklus, mit der eigenen Trägheit";
    governing_torque_about = "of the governing move, eq. 69.1 and 69.2" | "der maßgebenden Bewegung, Gl. 69.1 und 69.2";
    mode = "mode" | "Verfahren";
    mode_about =
        "equations 69.1 to 69.4 of the manual, or exact integral over the motion, which the checks use"
        | "Gleichungen 69.1 bis 69.4 der Anleitung oder exaktes Integral über die Bewegung, das die Nachweise verwenden";
    at = "time" | "Zeitpunkt";
    peak_torque_at_about = "instant of the peak torque" | "Zeitpunkt des Spitzendrehmoments";
    mean_speed_about = "mean of |n|, including pauses" | "Mittelwert von |n| einschließlich Pausen";
    peak_speed_about = "largest |n|" | "größtes |n|";
    duty_factor_about = "share of the cycle in motion" | "Anteil der Bewegung am Zyklus";
    t_1_accelerating = "T_1 accelerating" | "T_1 Beschleunigen";
    t_2_running = "T_2 constant speed" | "T_2 Konstantfahrt";
    t_3_braking = "T_3 braking" | "T_3 Bremsen";
    governing_move = "governing move" | "maßgebende Bewegung";
    governing_move_about =
        "number of the move to which T_1 to T_3 belong"
        | "Nummer der Bewegung, zu der T_1 bis T_3 gehören";
    demand_about =
        "demand on each candidate, by the equations of the manual and by exact integrals"
        | "Belastung jedes Kandidaten, nach den Gleichungen der Anleitung und nach exakten Integralen";
    data_sheet_about = "from the data sheet" | "aus dem Datenblatt";
    rank_about =
        "rank; empty if the actuator does not fit"
        | "Rang; leer, wenn nicht geeignet";
    candidate_verdict_about =
        "suitable if no check fails and every requirement is met; if a check lies in the band of an estimate, only if the estimate holds"
        | "geeignet, wenn kein Nachweis verletzt und jede Anforderung erfüllt ist; liegt ein Nachweis im Band einer Schätzung, nur sofern diese zutrifft";
    highest_utilisation_about = "utilisation of the governing check, 1 (100 %) is the limit" | "Auslastung des maßgebenden Nachweises, 1 (100 %) ist die Grenze";
    tightest_check_about = "governing check: the failing one exceeded most, otherwise the one with the highest utilisation; none if only a requirement rejects the actuator" | "maßgebender Nachweis: der am weitesten überschrittene, sonst der mit der höchsten Auslastung; keiner, wenn allein eine Anforderung den Antrieb ausschließt";
    margin_about = "1 − utilisation" | "1 − Auslastung";
    open_questions = "open points" | "offene Punkte";
    open_questions_about =
        "number of checks and requirements for which data are missing"
        | "Anzahl der Nachweise und Anforderungen, für die eine Angabe fehlt";
    on_request_about = "fields of the ordering code available on request only" | "nur auf Anfrage lieferbare Felder der Bestellbezeichnung";
    errata_of_data = "errata" | "Druckfehler";
    errata_of_data_about =
        "errata of the data in this row: the value shown may differ from that stated in the manual"
        | "Druckfehler bei den Daten dieser Zeile: der angezeigte Wert kann von der Angabe der Anleitung abweichen";
    objections = "requirements not met" | "nicht erfüllt";
    objections_about = "requirements not met and rules violated" | "nicht erfüllte Anforderungen und verletzte Regeln";
    candidates_about =
        "candidates in ranking order, with the utilisation of every check"
        | "Kandidaten in der Rangfolge mit der Auslastung jedes Nachweises";
    input = "quantity" | "Größe";
    input_about = "table and purpose of the value in the project file" | "Tabelle und Bedeutung des Werts in der Projektdatei";
    check_id = "id" | "Kennung";
    check_id_about = "id of the check" | "Kennung des Nachweises";
    check_title_about = "title of the check" | "Titel des Nachweises";
    check_verdict_about = "result of the check" | "Ergebnis des Nachweises";
    value_of_check_about = "value required by the axis" | "von der Achse geforderter Wert";
    limit_about = "limit of the actuator, or required limit" | "Grenze des Antriebs oder geforderte Grenze";
    unit_of_check_about = "unit of value and limit" | "Einheit von Wert und Grenze";
    mode_manual = "equations of the manual" | "Gleichungen der Anleitung";
    mode_integral = "exact integral" | "exaktes Integral";
    at_most = "at most" | "höchstens";
    at_least = "at least" | "mindestens";
    direction = "direction" | "Richtung";
    direction_about =
        "required relation of the value to the limit"
        | "geforderte Beziehung des Werts zur Grenze";
    utilisation_about = "1 (100 %) is the limit" | "1 (100 %) ist die Grenze";
    worst_at_about = "instant of the worst case within the cycle" | "Zeitpunkt des ungünstigsten Falls im Zyklus";
    grade_about = "lowest grade of the input values" | "niedrigste Güte der Eingangswerte";
    source_about = "source of the limit; source of the value" | "Quelle der Grenze; Quelle des Werts";
    missing_data = "missing data" | "fehlende Angabe";
    missing_about = "data missing for a check that was not made" | "fehlende Angabe eines nicht geführten Nachweises";
    remarks_about = "remarks on the check" | "Bemerkungen zum Nachweis";
    checks_about = "all checks of the candidates shown" | "alle Nachweise der gezeigten Kandidaten";
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
    setpoints = "setpoints" | "Sollwerte";
    setpoints_about =
        "setpoints of the motion at the cycle of a controller, by the closed form of its laws at every instant"
        | "Sollwerte der Bewegung im Takt einer Steuerung, in jedem Zeitpunkt aus der geschlossenen Form der Bewegungsgesetze";
    overview = "Overview" | "Übersicht";
    t_rms_from_the_course = "T_rms from the time series" | "T_rms aus dem Verlauf";
    t_rms_from_the_course_about =
        "formula over the time series sheet, torque linear between the instants"
        | "Formel über das Blatt „Verlauf“, Drehmoment zwischen den Zeitpunkten linear";
    t_rms_exact = "T_rms exact" | "T_rms exakt";
    difference = "difference" | "Differenz";
    difference_about = "deviation due to sampling" | "Abweichung durch die Abtastung";
    too_many_rows(count, name) =
        "{count}, too many for a sheet: antrieb export --table {name}"
        | "{count}, zu viele für ein Blatt: antrieb export --table {name}";
    about_antrieb =
        "antrieb is an open engineering workbench for servo actuators; it is not affiliated with any of their manufacturers."
        | "antrieb ist ein offenes Auslegungswerkzeug für Servoantriebe; es steht in keiner Verbindung zu deren Herstellern.";
    project_file = "project file" | "Projektdatei";
    antrieb_version = "antrieb, version" | "antrieb, Version";
    rms_torque_computed_twice = "Rms torque, computed in two ways" | "Effektives Drehmoment, auf zwei Wegen gerechnet";
    t_rms_exact_about = "exact integral, used by the checks" | "exaktes Integral, Grundlage der Nachweise";
    sheets = "Sheets" | "Blätter";
    how_to_read_it = "Legend" | "Legende";
    legend_fine = "up to 80 % of a limit, or passed" | "bis 80 % einer Grenze oder erfüllt";
    legend_near = "above 80 % of a limit, or a note" | "über 80 % einer Grenze oder Hinweis";
    legend_over = "above a limit, or failed" | "über einer Grenze oder nicht erfüllt";
    legend_open =
        "no utilisation: data are missing (not checked), or no limit is stated"
        | "keine Auslastung: eine Angabe fehlt (nicht geprüft), oder es ist keine Grenze angegeben";
    rows(count) = "1 row" | "1 Zeile", "{count} rows" | "{count} Zeilen";
}
