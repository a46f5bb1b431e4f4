//! Words for pictures: axes, legends, captions, and descriptions.

use crate::texts::texts;

texts! {
    radial_force = "Radial force" | "Radialkraft";
    the_radial_force = "the radial force" | "die Radialkraft";
    axial_force = "Axial force" | "Axialkraft";
    the_axial_force = "the axial force" | "die Axialkraft";
    tilting_moment = "Tilting moment" | "Kippmoment";
    the_tilting_moment = "the tilting moment" | "das Kippmoment";
    bearing_load_caption =
        "Loads as stated in the project or derived from the mechanism; tilting moment about the centre of the bearing. Each limit applies to a single load acting alone."
        | "Lasten laut Projekt oder aus der Mechanik berechnet; Kippmoment um die Lagermitte. Jede Grenze gilt für die jeweilige Last allein.";
    each_load_is_constant = "Each load is constant over the cycle." | "Jede Last ist über den Zyklus konstant.";
    utilisation_of_the_limit = "Utilisation" | "Auslastung";
    angle_at_the_output = "Angle at the output" | "Winkel am Abtrieb";
    output_speed = "Output speed" | "Abtriebsdrehzahl";
    position_along_the_line = "Linear position" | "Linearposition";
    speed_along_the_line = "Linear speed" | "Lineargeschwindigkeit";
    acceleration_along_the_line = "Linear acceleration" | "Linearbeschleunigung";
    acceleration_at_the_output = "Acceleration at the output" | "Beschleunigung am Abtrieb";
    output_torque = "Output torque" | "Abtriebsdrehmoment";
    motor_current_rms = "Motor current, rms" | "Motorstrom, effektiv";
    power_at_the_motor_terminals = "Power at the motor terminals" | "Leistung an den Motorklemmen";
    overload = "Overload" | "Überlast";
    cycle_caption =
        "Steady-state cycle on a common time axis; dashed vertical lines are segment boundaries. Torque including the inertia of the actuator. Limits far above the curve are omitted."
        | "Eingeschwungener Zyklus über gemeinsamer Zeitachse; gestrichelte senkrechte Linien sind Abschnittsgrenzen. Drehmoment einschließlich Eigenträgheit des Antriebs. Grenzen weit über dem Verlauf sind weggelassen.";
    cycle_caption_of_the_load =
        "Steady-state cycle on a common time axis; dashed vertical lines are segment boundaries. Torque of the load alone: the inertia of the actuator is not known. Limits far above the curve are omitted."
        | "Eingeschwungener Zyklus über gemeinsamer Zeitachse; gestrichelte senkrechte Linien sind Abschnittsgrenzen. Drehmoment der Last allein: die Eigenträgheit des Antriebs ist nicht bekannt. Grenzen weit über dem Verlauf sind weggelassen.";
    recording_caption =
        "Recorded values on a common time axis, as read from the file."
        | "Aufgezeichnete Größen über gemeinsamer Zeitachse, wie in der Datei gelesen.";
    temperature = "Temperature" | "Temperatur";
    limit_of_the_check = "limit" | "Grenze";
    torsion_of_the_gear = "Torsion of the gear" | "Torsion des Getriebes";
    load_on_the_output_bearing = "Load on the output bearing" | "Belastung des Abtriebslagers";
    no_stiffness =
        "the torsional stiffness of this actuator is not known"
        | "die Torsionssteifigkeit dieses Antriebs ist nicht bekannt";
    length = "Length" | "Länge";
    margin_to_the_tightest_limit = "Margin to the governing limit" | "Reserve zur maßgebenden Grenze";
    limit_exceeded = "limit exceeded" | "Grenze überschritten";
    the_best = "The best" | "Der beste";
    marked = "Marked" | "Markiert";
    candidate_map_caption(left_out, floor) =
        "Each point is an actuator of the catalogue; below the red line a limit or recommendation is exceeded. {left_out} not shown: margin below {floor}, or value not known."
        | "Jeder Punkt ist ein Antrieb des Katalogs; unter der roten Linie ist eine Grenze oder Empfehlung überschritten. {left_out} nicht gezeigt: Reserve unter {floor} oder Angabe nicht bekannt.";
    no_candidate_can_be_shown(count, floor) =
        "No candidate can be shown: each of the {count} exceeds its governing limit so far that its margin is below {floor}, or one of its values is not known."
        | "Kein Kandidat lässt sich zeigen: Jeder der {count} überschreitet seine maßgebende Grenze so weit, dass seine Reserve unter {floor} liegt, oder eine Angabe zu ihm ist nicht bekannt.";
    how_many_fit(all, fitting) = "{all} actuators, {fitting} fit." | "{all} Antriebe, {fitting} davon geeignet.";
    candidate_without_margin(id, figure) =
        "{id}, {figure}, without margin: a limit is zero"
        | "{id}, {figure}, ohne Reserve: eine Grenze ist null";
    candidate_not_checked(id, figure) =
        "{id}, {figure}, margin not known: no check could be made"
        | "{id}, {figure}, Reserve nicht bekannt: kein Nachweis konnte geführt werden";
    candidate_with_margin(id, figure, margin) = "{id}, {figure}, margin {margin}" | "{id}, {figure}, Reserve {margin}";
    mean = "mean" | "Mittelwert";
    peaks = "peaks" | "Spitzenwerte";
    short_time_limit_known_in_part =
        "For the short-time limit, only the maximum torque and maximum speed are known, as far as drawn."
        | "Von der Kurzzeitgrenze sind nur maximales Drehmoment und maximale Drehzahl bekannt, soweit gezeichnet.";
    continuous_limit = "continuous limit" | "Dauergrenze";
    short_time_limit = "short-time limit" | "Kurzzeitgrenze";
    band_of_an_estimate(limit) = "{limit}, estimation band" | "{limit}, Schätzband";
    the_same_at_less_voltage = "short-time limit at reduced voltage" | "Kurzzeitgrenze bei verringerter Spannung";
    limits = "Limits" | "Grenzen";
    largest_torque_and_speed = "maximum torque and speed" | "maximales Drehmoment und maximale Drehzahl";
    only_torque_and_speed_known =
        "Only the maximum torque and maximum speed of this actuator are known, not their relation, and no limit for continuous duty."
        | "Von diesem Antrieb sind nur das maximale Drehmoment und die maximale Drehzahl bekannt, weder ihr Zusammenhang noch eine Dauerbetriebsgrenze.";
    only_torque_known =
        "Only the maximum torque of this actuator is known."
        | "Von diesem Antrieb ist nur das maximale Drehmoment bekannt.";
    only_speed_known =
        "Only the maximum speed of this actuator is known."
        | "Von diesem Antrieb ist nur die maximale Drehzahl bekannt.";
    no_limit_known = "No limit of this actuator is known." | "Keine Grenze dieses Antriebs ist bekannt.";
    quadrants_and_colours =
        "Motoring in the first and third quadrants, braking in the others. Red: continuous duty; blue: acceleration and braking."
        | "Motorischer Betrieb im ersten und dritten, generatorischer Betrieb im zweiten und vierten Quadranten. Rot: Dauerbetrieb; blau: Beschleunigen und Bremsen.";
    s3_explained(minutes) =
        "S3: intermittent duty with a cycle of {minutes} min, lower edge."
        | "S3: Aussetzbetrieb mit {minutes} min Spieldauer, unterer Rand.";
    hatching_explained =
        "Hatched: estimation band; the checks use its lower edge."
        | "Schraffiert: Schätzband; die Nachweise verwenden den unteren Rand.";
    braking_explained =
        "During braking the voltage is not a limit; T_max applies."
        | "Beim Bremsen begrenzt die Spannung nicht; es gilt T_max.";
    no_voltage_limit =
        "No voltage limit drawn: no voltage stated."
        | "Ohne Spannungsgrenze: keine Spannung angegeben.";
    sagged_explained(shares) =
        "Dotted: the short-time limit at {shares} of the terminal voltage, as when the DC link sags; a share chosen by antrieb, for orientation, no check uses it."
        | "Punktiert: Kurzzeitgrenze bei {shares} der Klemmenspannung, etwa bei einem Einbruch des Zwischenkreises; von antrieb gewählter Anteil, nur zur Orientierung, kein Nachweis verwendet sie.";
    volts_explained = "Voltages: at the motor terminals, rms." | "Spannungen: an den Motorklemmen, effektiv.";
    limit_from_to(curve_name, torque, speed) =
        "{curve_name} from {torque} at standstill, up to {speed}"
        | "{curve_name} ab {torque} im Stillstand, bis {speed}";
    limits_described(code, listed) = "Limits of {code}: {listed}." | "Grenzen von {code}: {listed}.";
    plane_described(duration) =
        "Torque over speed: a cycle of {duration} and the limits of the actuator."
        | "Drehmoment über Drehzahl: ein Zyklus von {duration} und die Grenzen des Antriebs.";
    demand_described(peak, when, fast, rms, mean) =
        "The torque reaches {peak} at {when}, the speed {fast}; the mean point is at {rms} (rms) and {mean}."
        | "Das Drehmoment erreicht {peak} bei {when}, die Drehzahl {fast}; der mittlere Punkt liegt bei {rms} (effektiv) und {mean}.";
    continuous_limit_at_mean_speed(limit) =
        "continuously {limit} at the mean speed"
        | "dauernd {limit} bei der mittleren Drehzahl";
    at_most_for_a_short_time(limit) = "at most {limit} for a short time" | "kurzzeitig höchstens {limit}";
    at_most(limit) = "at most {limit}" | "höchstens {limit}";
    working_point = "working point" | "Arbeitspunkt";
    torque_on_the_gear = "Torque on the gear" | "Drehmoment am Getriebe";
    torsion = "Torsion angle" | "Torsionswinkel";
    torsion_described(torque, angle, one, two) =
        "The largest load torque of {torque} twists the gear by {angle}. The stiffness changes at {one} and {two}."
        | "Das größte Lastmoment von {torque} verdreht das Getriebe um {angle}. Die Steifigkeit ändert sich bei {one} und {two}.";
    torsion_of_a_code_described(torque, angle, one, two) =
        "{torque} twists the gear by {angle}. The stiffness changes at {one} and {two}."
        | "{torque} verdreht das Getriebe um {angle}. Die Steifigkeit ändert sich bei {one} und {two}.";
    torsion_caption(one, two) =
        "Mean values of many gears with locked input; hysteresis and lost motion are additional. The stiffness changes at T_1 = {one} and T_2 = {two}."
        | "Mittelwerte vieler Getriebe bei blockiertem Eingang; Hysterese und Lost Motion kommen hinzu. Die Steifigkeit ändert sich bei T_1 = {one} und T_2 = {two}.";
    torque_of_the_load =
        "Load torque without the inertia of the actuator."
        | "Lastmoment ohne Eigenträgheit des Antriebs.";
    utilisation_caption =
        "The line at 100 % is the limit. A broken bar extends beyond the picture. Checks that were not performed are listed below with the missing value; they do not count as passed."
        | "Die Linie bei 100 % ist die Grenze. Ein unterbrochener Balken reicht über das Bild hinaus. Nicht geprüfte Nachweise stehen unten mit der fehlenden Angabe; sie gelten nicht als erfüllt.";
    estimated_band =
        "The line with stops in a bar spans the utilisations by the upper and the lower edge of an estimated limit."
        | "Die Linie mit Endstrichen in einem Balken reicht von der Auslastung am oberen bis zu der am unteren Rand einer geschätzten Grenze.";
    checks_counted(checks, id, listed) =
        "{checks} checks of {id}: {listed}."
        | "{checks} Nachweise von {id}: {listed}.";
    tightest_named(head, listed) = "{head} Highest utilisation: {listed}." | "{head} Höchste Auslastung: {listed}.";
    and = "and" | "und";
    load_is_constant(name, value) = "{name} is constant at {value}" | "{name} beträgt konstant {value}";
    load_reaches(name, value) = "{name} reaches {value}" | "{name} erreicht {value}";
    load_rests(name, value, turning) =
        "{name} reaches {value}, while the gear turns {turning}"
        | "{name} erreicht {value}, bei drehendem Getriebe {turning}";
    value_of_limit(value, limit) = "{value} of {limit}" | "{value} von {limit}";
    constant(value) = "constant: {value}" | "konstant: {value}";
    the_angle = "the angle" | "der Winkel";
    the_speed = "the speed" | "die Drehzahl";
    the_torque = "the torque" | "das Drehmoment";
    the_current = "the current" | "der Strom";
    the_power = "the power" | "die Leistung";
    the_winding = "the winding" | "die Wicklung";
    the_overload = "the overload" | "die Überlast";
    from_to(what, low, high) = "{what} from {low} to {high}" | "{what} von {low} bis {high}";
    cycle_described(count, duration, parts) =
        "One cycle of {duration}: {parts}."
        | "Ein Zyklus von {duration}: {parts}.",
        "One cycle of {duration} in {count} segments: {parts}."
        | "Ein Zyklus von {duration} in {count} Abschnitten: {parts}.";
}
