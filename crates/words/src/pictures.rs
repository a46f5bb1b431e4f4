//! Words in pictures: axes, legends, captions, and descriptions.

use crate::texts::texts;

texts! {
    radial_force = "Radial force" | "Radialkraft";
    the_radial_force = "the radial force" | "die Radialkraft";
    axial_force = "Axial force" | "Axialkraft";
    the_axial_force = "the axial force" | "die Axialkraft";
    tilting_moment = "Tilting moment" | "Kippmoment";
    the_tilting_moment = "the tilting moment" | "das Kippmoment";
    bearing_load_caption =
        "Loads as the project states them, or as they follow from the mechanism; the tilting moment is about the middle of the bearing. The limits hold one at a time."
        | "Lasten, wie das Projekt sie angibt oder wie sie aus dem Mechanismus folgen; das Kippmoment gilt für die Mitte des Lagers. Die Grenzen gelten je für sich.";
    each_load_is_constant = "Each load is constant over the cycle." | "Jede Last ist über den Zyklus konstant.";
    utilisation_of_the_limit = "Utilisation of the limit" | "Auslastung der Grenze";
    angle_at_the_output = "Angle at the output" | "Winkel am Abtrieb";
    output_speed = "Output speed" | "Abtriebsdrehzahl";
    position_along_the_line = "Position along the line" | "Position längs der Führung";
    speed_along_the_line = "Speed along the line" | "Geschwindigkeit längs der Führung";
    acceleration_along_the_line = "Acceleration along the line" | "Beschleunigung längs der Führung";
    acceleration_at_the_output = "Acceleration at the output" | "Beschleunigung am Abtrieb";
    output_torque = "Output torque" | "Abtriebsdrehmoment";
    motor_current_rms = "Motor current, rms" | "Motorstrom, effektiv";
    power_at_the_motor_terminals = "Power at the motor terminals" | "Leistung an den Motorklemmen";
    overload = "Overload" | "Überlast";
    cycle_caption =
        "The steady cycle, on one time axis; dashed verticals are borders of segments. Torque with the actuator's own inertia. A limit far above the course is left out."
        | "Der eingeschwungene Zyklus über einer Zeitachse; gestrichelte Senkrechte sind Grenzen der Abschnitte. Drehmoment mit der Eigenträgheit des Antriebs. Eine Grenze weit über dem Verlauf ist weggelassen.";
    temperature = "Temperature" | "Temperatur";
    warning = "warning" | "Warnung";
    torsion_of_the_gear = "Torsion of the gear" | "Torsion des Getriebes";
    load_on_the_output_bearing = "Load on the output bearing" | "Belastung des Abtriebslagers";
    no_stiffness =
        "the torsional stiffness of this actuator is not known"
        | "die Torsionssteifigkeit dieses Antriebs ist nicht bekannt";
    length = "Length" | "Länge";
    margin_to_the_tightest_limit = "Margin to the tightest limit" | "Reserve zur engsten Grenze";
    limit_exceeded = "limit exceeded" | "Grenze überschritten";
    fits_with_advice = "fits, with advice" | "geeignet, mit Hinweis";
    the_best = "The best" | "Der beste";
    marked = "Marked" | "Markiert";
    candidate_map_caption(left_out, floor) =
        "Each point is an actuator of the catalogue; below the red line a limit or a recommendation is exceeded. {left_out} are left out: margin below {floor}, or no figure known."
        | "Jeder Punkt ist ein Antrieb des Katalogs; unter der roten Linie ist eine Grenze oder eine Empfehlung überschritten. {left_out} fehlen: Reserve unter {floor}, oder Angabe nicht bekannt.";
    no_candidate_can_be_shown(count, floor) =
        "No candidate can be shown: each of the {count} misses its tightest limit by so much that its margin is below {floor}, or a figure of it is not known."
        | "Kein Kandidat lässt sich zeigen: Jeder der {count} überschreitet seine engste Grenze so weit, dass seine Reserve unter {floor} liegt, oder eine Angabe zu ihm ist nicht bekannt.";
    how_many_fit(all, fitting) = "{all} actuators, {fitting} fit." | "{all} Antriebe, {fitting} davon geeignet.";
    candidate_without_margin(id, figure) =
        "{id}, {figure}, without margin: a limit is zero"
        | "{id}, {figure}, ohne Reserve: eine Grenze ist null";
    candidate_with_margin(id, figure, margin) = "{id}, {figure}, margin {margin}" | "{id}, {figure}, Reserve {margin}";
    mean = "mean" | "Mittel";
    peaks = "peaks" | "Spitzen";
    short_time_limit_known_in_part =
        "Of the short-time limit only the largest torque and the largest speed are known, each as far as it is drawn."
        | "Von der Kurzzeitgrenze sind nur größtes Drehmoment und größte Drehzahl bekannt, soweit gezeichnet.";
    continuous_limit = "continuous limit" | "Dauergrenze";
    short_time_limit = "short-time limit" | "Kurzzeitgrenze";
    band_of_an_estimate = "band of an estimate" | "Band einer Schätzung";
    the_same_at_less_voltage = "the same at less voltage" | "dieselbe bei weniger Spannung";
    limits = "Limits" | "Grenzen";
    largest_torque_and_speed = "largest torque and speed" | "größtes Drehmoment und größte Drehzahl";
    only_torque_and_speed_known =
        "Only the largest torque and the largest speed of this actuator are known, not how one limits the other, and no limit of continuous duty."
        | "Von diesem Antrieb sind nur das größte Drehmoment und die größte Drehzahl bekannt, nicht wie eines das andere begrenzt, und keine Grenze des Dauerbetriebs.";
    only_torque_known =
        "Of this actuator only the largest torque is known."
        | "Von diesem Antrieb ist nur das größte Drehmoment bekannt.";
    only_speed_known =
        "Of this actuator only the largest speed is known."
        | "Von diesem Antrieb ist nur die größte Drehzahl bekannt.";
    no_limit_known = "No limit of this actuator is known." | "Keine Grenze dieses Antriebs ist bekannt.";
    quadrants_and_colours =
        "Driving in the first and third quadrant, braking in the others. Red: continuous duty; blue: acceleration and braking."
        | "Treiben im ersten und dritten Quadranten, Bremsen in den anderen. Rot: Dauerbetrieb; blau: Beschleunigen und Bremsen.";
    s3_explained(minutes) =
        "S3: intermittent duty with a cycle of {minutes} min, lower edge."
        | "S3: Aussetzbetrieb mit {minutes} min Spieldauer, unterer Rand.";
    hatching_explained =
        "Hatched: between the edges of an estimate; the checks use the lower one."
        | "Schraffiert: zwischen den Rändern einer Schätzung; die Nachweise nehmen den unteren.";
    braking_explained =
        "While braking the voltage helps, and T_max is the limit."
        | "Beim Bremsen hilft die Spannung, und T_max ist die Grenze.";
    no_voltage_limit =
        "No voltage limit is drawn: none was given."
        | "Ohne Spannungsgrenze: es ist keine Spannung angegeben.";
    volts_explained = "Volts: at the motor terminals, rms." | "Volt: an den Motorklemmen, effektiv.";
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
        "continuous {limit} at the mean speed"
        | "dauernd {limit} bei der mittleren Drehzahl";
    at_most_for_a_short_time(limit) = "at most {limit} for a short time" | "kurzzeitig höchstens {limit}";
    at_most(limit) = "at most {limit}" | "höchstens {limit}";
    working_point = "working point" | "Arbeitspunkt";
    torque_on_the_gear = "Torque on the gear" | "Drehmoment am Getriebe";
    torsion = "Torsion" | "Verdrehung";
    torsion_described(torque, angle, one, two) =
        "The largest torque of the load, {torque}, twists the gear by {angle}. The stiffness changes at {one} and {two}."
        | "Das größte Drehmoment der Last, {torque}, verdreht das Getriebe um {angle}. Die Steifigkeit ändert sich bei {one} und {two}.";
    torsion_of_a_code_described(torque, angle, one, two) =
        "{torque} twists the gear by {angle}. The stiffness changes at {one} and {two}."
        | "{torque} verdreht das Getriebe um {angle}. Die Steifigkeit ändert sich bei {one} und {two}.";
    torsion_caption(one, two) =
        "Mean values of many gears with blocked input; hysteresis and lost motion come on top. The stiffness changes at T_1 = {one} and T_2 = {two}."
        | "Mittelwerte vieler Getriebe bei blockiertem Eingang; Hysterese und Lost Motion kommen hinzu. Die Steifigkeit ändert sich bei T_1 = {one} und T_2 = {two}.";
    torque_of_the_load =
        "Torque of the load without the actuator's own inertia."
        | "Drehmoment der Last ohne die Eigenträgheit des Antriebs.";
    utilisation_caption =
        "The line at 100 % is the limit. A bar that is broken goes on beyond the picture. What is not checked stands below with the datum that is missing; it does not count as passed."
        | "Die Linie bei 100 % ist die Grenze. Ein unterbrochener Balken reicht über das Bild hinaus. Nicht Geprüftes steht unten mit der fehlenden Angabe; es gilt nicht als erfüllt.";
    checks_counted(checks, id, listed) =
        "{checks} checks of {id}: {listed}."
        | "{checks} Nachweise von {id}: {listed}.";
    tightest_named(head, listed) = "{head} The tightest: {listed}." | "{head} Am engsten: {listed}.";
    and = "and" | "und";
    load_is_constant(name, value) = "{name} is constant at {value}" | "{name} beträgt konstant {value}";
    load_reaches(name, value) = "{name} reaches {value}" | "{name} erreicht {value}";
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
