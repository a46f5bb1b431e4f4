//! Words for the digital twin.

use crate::pick;
use crate::texts::texts;
use feedback::{Failure, Finding};
use quantities::Language;
use sizing::{RunCheck, RunCheckId};
use twin::{EventKind, Fault, Loop, ScenarioId};

texts! {
    title(code, axis) = "Simulation of {code}: {axis}" | "Simulation von {code}: {axis}";
    course(scenario, time, start, steps, step) =
        "{scenario}: {time} s simulated, start {start}; {steps} steps of {step} µs, fourth-order Taylor series"
        | "{scenario}: {time} s simuliert, Beginn {start}; {steps} Schritte zu {step} µs, Taylorreihe vierter Ordnung";
    warm(winding, housing) =
        "warm, winding {winding} °C, housing {housing} °C" | "warm, Wicklung {winding} °C, Gehäuse {housing} °C";
    cold(ambient) = "cold, all parts at {ambient} °C" | "kalt, alle Teile auf {ambient} °C";
    worst_instant(count, time, direction, effect, value) =
        "Instant of the event: {time} s, the worst of {count} examined over the cycle, {direction}, by the {effect} ({value})"
        | "Zeitpunkt des Ereignisses: {time} s, der ungünstigste von {count} im Zyklus untersuchten, {direction}, nach {effect} ({value})";
    worst_elsewhere(direction, value, time) = "{direction}: {value} at {time} s" | "{direction}: {value} bei {time} s";
    overrun_above(value, time) =
        "beyond the highest position of the motion by up to {value} (event at {time} s)"
        | "über die höchste Position der Bewegung hinaus um bis zu {value} (Ereignis bei {time} s)";
    overrun_below(value, time) =
        "beyond the lowest position of the motion by up to {value} (event at {time} s)"
        | "über die niedrigste Position der Bewegung hinaus um bis zu {value} (Ereignis bei {time} s)";
    search_limited =
        "the limit of the steps left further instants out (--deadline for all)"
        | "die Grenze der Schritte ließ weitere Zeitpunkte aus (alle mit --deadline)";
    no_rest(value) = "{value} after 2 s, still moving" | "{value} nach 2 s, noch in Bewegung";
    direction_positive = "in positive direction" | "in positiver Richtung";
    direction_negative = "in negative direction" | "in negativer Richtung";
    direction_standstill = "at standstill" | "im Stillstand";
    effect_travel = "travel until standstill" | "dem Weg bis zum Stillstand";
    effect_torque = "gear torque" | "dem Getriebemoment";
    effect_link = "lowest DC link voltage" | "der kleinsten Zwischenkreisspannung";
    effect_speed = "speed, since the event does not stop the motion" | "der Drehzahl, da das Ereignis die Bewegung nicht anhält";
    stop_missing =
        "after the event the axis does not come to rest within this run: time and angle of the stop are not known"
        | "nach dem Ereignis kommt die Achse in diesem Lauf nicht zum Stillstand: Anhaltezeit und Anhaltewinkel sind nicht bekannt";
    beyond_lowest = "beyond the lowest position of the motion" | "über die niedrigste Position der Bewegung hinaus";
    beyond_highest = "beyond the highest position of the motion" | "über die höchste Position der Bewegung hinaus";
    stop_travel = "stopping distance" | "Anhalteweg";
    steps_at(key) = "state the instant of the event ({key})" | "den Zeitpunkt des Ereignisses angeben ({key})";
    summary = "summary" | "Zusammenfassung";
    verdicts = "verdicts" | "Ergebnisse";
    events = "events" | "Ereignisse";
    no_events = "no events" | "keine Ereignisse";
    agreement = "sizing and twin" | "Auslegung und Zwilling";
    sizing_said = "sizing" | "Auslegung";
    twin_shows = "twin" | "Zwilling";
    why = "reason for the difference" | "Grund der Abweichung";
    loops = "control loops" | "Regelkreise";
    gains = "gains" | "Reglerparameter";
    gains_rule =
        "default gains from the magnitude optimum (current) and the symmetrical optimum (speed), position from the natural frequency of the load"
        | "Voreinstellung nach Betragsoptimum (Strom) und symmetrischem Optimum (Drehzahl), Position nach der Eigenfrequenz der Last";
    gains_stated = "gains of the project" | "Reglerparameter aus dem Projekt";
    assumed = "parameters not contained in any table" | "Parameter, die in keiner Tabelle enthalten sind";
    left_out(data) =
        "not stated and therefore neglected or assumed: {data}" | "nicht angegeben und deshalb vernachlässigt oder angenommen: {data}";
    band =
        "A twin based on catalogue data only: measured friction of such gears deviates by up to 15 % (viscous) and 40 % (dry); measured values in the project replace the catalogue data."
        | "Zwilling allein aus Katalogdaten: die gemessene Reibung solcher Getriebe weicht um bis zu 15 % (viskos) und 40 % (trocken) ab; gemessene Werte im Projekt ersetzen die Katalogdaten.";
    limit_named(title, limit) = "{title} (limit: {limit})" | "{title} (Grenze: {limit})";
    shutdown_threshold = "shutdown threshold" | "Abschaltschwelle";
    setpoint_limit(current) =
        "the drive limits the current setpoint to I_max = {current} A; the current itself may exceed it for a short time, I_E is its limit"
        | "der Servoregler begrenzt den Stromsollwert auf I_max = {current} A; der Strom selbst darf ihn kurzzeitig übersteigen, seine Grenze ist I_E";
    quantity = "quantity" | "Größe";
    limit = "limit" | "Grenze";
    stability = "stability" | "Stabilität";
    time_s = "time s" | "Zeit s";
    event = "event" | "Ereignis";
    loop_head = "loop" | "Regelkreis";
    crossover = "crossover Hz" | "Durchtrittsfrequenz Hz";
    phase_margin = "phase margin °" | "Phasenreserve °";
    gain_margin = "gain margin dB" | "Amplitudenreserve dB";
    bandwidth = "bandwidth Hz" | "Bandbreite Hz";
    stable = "stable" | "stabil";
    unstable = "unstable" | "instabil";
    parameter = "parameter" | "Parameter";
    source_head = "source" | "Quelle";
    supply_assumed(volt) =
        "no supply stated: DC link of {volt} V assumed" | "keine Versorgung angegeben: Zwischenkreis von {volt} V angenommen";
    supply_edges(least, most) =
        "mains with tolerance: currents, torques and speeds refer to the lowest DC link voltage, {least} V; maximum voltage and heat of the braking resistor to the highest, {most} V"
        | "Netz mit Toleranz: Ströme, Drehmomente und Drehzahlen gelten bei der kleinsten Zwischenkreisspannung, {least} V; maximale Spannung und Wärme des Bremswiderstands bei der größten, {most} V";
    no_chopper_threshold(most) =
        "no switch-on threshold of a braking resistor lies between the supply of {most} V and U_DCmax: the simulated one is at 1.15 times the supply, so the DC link can exceed U_DCmax while braking; the manual permits this for a short time and states no value"
        | "zwischen der Versorgung von {most} V und U_DCmax liegt keine Einschaltschwelle eines Bremswiderstands: simuliert ist das 1,15-Fache der Versorgung; der Zwischenkreis kann U_DCmax beim Bremsen übersteigen, was die Anleitung kurzfristig zulässt, ohne einen Wert zu nennen";
    following_peak = "following error of the load, maximum" | "Schleppfehler der Last, Maximum";
    following_rms = "following error of the load, rms" | "Schleppfehler der Last, effektiv";
    settling = "settling time after a move" | "Ausregelzeit nach einer Bewegung";
    standing = "deviation at standstill, maximum" | "Abweichung im Stillstand, Maximum";
    current_peak = "motor current, maximum" | "Motorstrom, Maximum";
    current_rms = "motor current, rms" | "Motorstrom, effektiv";
    torque_peak = "gear torque, maximum" | "Getriebemoment, Maximum";
    torque_rms = "gear torque, rms" | "Getriebemoment, effektiv";
    speed_peak = "motor speed / ratio, maximum" | "Motordrehzahl/Untersetzung, Maximum";
    winding_end = "winding temperature at the end" | "Wicklungstemperatur am Ende";
    housing_end = "housing temperature at the end" | "Gehäusetemperatur am Ende";
    winding_peak = "winding temperature, maximum" | "Wicklungstemperatur, Maximum";
    overload = "overload monitoring I²t, maximum" | "Überlastüberwachung I²t, Maximum";
    link_low = "DC link voltage, minimum" | "Zwischenkreisspannung, Minimum";
    link_high = "DC link voltage, maximum" | "Zwischenkreisspannung, Maximum";
    energy_motor = "energy supplied to the motor" | "dem Motor zugeführte Energie";
    energy_regenerated = "regenerated energy" | "zurückgespeiste Energie";
    energy_copper = "winding losses" | "Wicklungsverluste";
    energy_friction = "no-load friction losses" | "Verluste durch Leerlaufreibung";
    energy_mesh = "load-dependent meshing losses" | "lastabhängige Verzahnungsverluste";
    energy_hysteresis = "losses by hysteresis and damping of the gear" | "Verluste durch Hysterese und Dämpfung des Getriebes";
    energy_brake = "heat in the brake" | "Wärme in der Bremse";
    energy_load = "energy supplied to the load" | "der Last zugeführte Energie";
    energy_constants = "difference between k_TM and k_EM" | "Differenz zwischen k_TM und k_EM";
    energy_resistor = "heat in the braking resistor" | "Wärme im Bremswiderstand";
    energy_supply = "energy from the supply" | "Energie aus der Versorgung";
    unaccounted = "error of the energy balance" | "Fehler der Energiebilanz";
    resonance_blocked = "resonance with locked rotor" | "Resonanz bei blockiertem Rotor";
    resonance_free = "resonance with free rotor" | "Resonanz bei freiem Rotor";
    stop_time = "stopping time" | "Anhaltezeit";
    stop_angle = "stopping angle" | "Anhaltewinkel";
    brake_rest = "closings of the brake at standstill" | "Schließvorgänge der Bremse im Stillstand";
    brake_moving = "brake closed in motion" | "Bremse in Bewegung geschlossen";
    data_ratio = "reduction ratio" | "Untersetzung";
    data_pole_pairs = "number of pole pairs" | "Polpaarzahl";
    data_torque_max = "maximum torque" | "maximales Drehmoment";
    data_current_max = "maximum current" | "Maximalstrom";
    data_current_demagnetisation = "demagnetisation current" | "Entmagnetisierungsstrom";
    data_stall_torque = "continuous stall torque" | "Stillstandsdrehmoment";
    data_stall_current = "continuous stall current" | "Stillstandsstrom";
    data_dc_link_max = "maximum DC link voltage" | "maximale Zwischenkreisspannung";
    data_collision_torque_max = "momentary peak torque of the gear" | "Kollisionsdrehmoment des Getriebes";
    data_feedback_resolution = "resolution of the motor encoder" | "Auflösung des Motorgebers";
    data_housing_share = "share of the housing in the thermal resistance" | "Anteil des Gehäuses am Wärmewiderstand";
    data_winding_warning = "winding temperature, warning" | "Wicklungstemperatur, Warnung";
    data_winding_shutdown = "winding temperature, shutdown" | "Wicklungstemperatur, Abschaltung";
    data_brake_opening = "opening time of a brake whose table states none" | "Öffnungszeit einer Bremse ohne Angabe in der Tabelle";
    data_brake_closing = "closing time of a brake whose table states none" | "Schließzeit einer Bremse ohne Angabe in der Tabelle";
    drive_faults = "drive faults" | "Störungen des Servoreglers";
    why_current =
        "the twin accelerates the rotor on the motor side of the gear, and the closed-loop control oscillates about the setpoint"
        | "der Zwilling beschleunigt den Rotor auf der Motorseite des Getriebes, und die Regelung schwingt um den Sollwert";
    why_torque =
        "the sizing includes the actuator inertia at the output; the twin shows the torque transmitted by the gear, including the oscillation of the load"
        | "die Auslegung enthält das Massenträgheitsmoment des Antriebs am Abtrieb; der Zwilling zeigt das vom Getriebe übertragene Moment mit der Schwingung der Last";
    why_speed = "overshoot of the control" | "Überschwingen der Regelung";
    why_thermal =
        "the twin takes the current ripple into account; the sizing uses the winding resistance in continuous duty"
        | "der Zwilling berücksichtigt die Stromwelligkeit; die Auslegung rechnet mit dem Wicklungswiderstand im Dauerbetrieb";
    why_overload =
        "both refer to I_0 of the ratio; the sizing is the steady state and permits the continuous curve; the twin starts at zero, runs the stated cycles and trips at 1"
        | "beide beziehen sich auf I_0 der Untersetzung; die Auslegung gilt eingeschwungen und lässt die Dauerkennlinie zu; der Zwilling beginnt bei null, rechnet die angegebenen Zyklen und löst bei 1 aus";
    why_regeneration =
        "the sizing assumes a cold winding, the twin uses the winding temperature of the run; the oscillation exchanges energy; where k_TM and k_EM of the table do not describe one motor, the twin's voltage follows k_EM, and their difference is a line of the energy balance"
        | "die Auslegung rechnet mit kalter Wicklung, der Zwilling mit der Wicklungstemperatur des Laufs; die Schwingung tauscht Energie aus; wo k_TM und k_EM der Tabelle nicht einen Motor beschreiben, folgt die Spannung des Zwillings k_EM, und ihre Differenz steht in der Energiebilanz";
    refused_missing(symbol) = "no simulation: {symbol} is not known" | "keine Simulation: {symbol} ist nicht bekannt";
    refused_recorded =
        "no simulation: the torque of the joint is recorded with its motion and cannot be derived from a state"
        | "keine Simulation: das Gelenkmoment ist mit der Bewegung aufgezeichnet und lässt sich nicht aus einem Zustand ableiten";
    refused_load(key) =
        "measured.{key} has no effect: this load depends on the position or on the direction of power flow"
        | "measured.{key} bleibt ohne Wirkung: diese Last hängt von der Position oder der Leistungsrichtung ab";
    refused_inertia = "no simulation: the load has no moment of inertia" | "keine Simulation: die Last hat kein Massenträgheitsmoment";
    refused_step(steps) =
        "the step size is too large for the stiffest subsystem: at least {steps} steps per period of the current controller are required"
        | "Rechenschrittweite zu groß für das steifste Teilsystem: mindestens {steps} Schritte je Periode der Stromregelung erforderlich";
    refused_brake = "the scenario requires a brake; the actuator has none" | "das Szenario erfordert eine Bremse; der Antrieb hat keine";
    refused_output_encoder =
        "no simulation: the position loop is closed at the output, but the actuator has no output encoder (option EC)"
        | "keine Simulation: der Lageregelkreis wird am Abtrieb geschlossen, der Antrieb hat jedoch keinen Abtriebsgeber (Option EC)";
    refused_battery =
        "the scenario requires an encoder with battery; the actuator has none"
        | "das Szenario erfordert einen Geber mit Batterie; der Antrieb hat keinen";
    refused_encoder =
        "the scenario requires an encoder with known signals: state an ordering code"
        | "das Szenario erfordert einen Geber mit bekannten Signalen: eine Bestellbezeichnung angeben";
    refused_failure_of_encoder(failure, possible) =
        "the encoder of this actuator cannot fail in this way: {failure}; possible: {possible}"
        | "der Geber dieses Antriebs kann nicht auf diese Weise ausfallen: {failure}; möglich: {possible}";
    refused_failure(scenario) =
        "an encoder failure can be stated for the scenario {scenario} only" | "ein Geberausfall ist nur beim Szenario {scenario} zulässig";
    noticed(failure, time, finding, angle) =
        "Encoder: {failure}; detected after {time} ms: {finding}; at this time the angle read deviated by {angle}° from the true angle at the output."
        | "Geber: {failure}; erkannt nach {time} ms: {finding}; der gelesene Winkel wich zu diesem Zeitpunkt am Abtrieb um {angle}° vom wahren Winkel ab.";
    not_noticed(failure, angle) =
        "Encoder: {failure}; not detected by the drive; at the end the angle read deviates by {angle}° from the true angle at the output."
        | "Geber: {failure}; vom Servoregler nicht erkannt; am Ende weicht der gelesene Winkel am Abtrieb um {angle}° vom wahren Winkel ab.";
    refused_late(end) = "the scenario occurs after the end of the run, {end} s" | "das Szenario liegt nach dem Ende des Laufs, {end} s";
    refused_moving = "the scenario must begin at standstill; the axis is in motion at this time" | "das Szenario muss im Stillstand beginnen; die Achse bewegt sich zu diesem Zeitpunkt";
    refused_resting = "the scenario requires a moving axis; the axis is at standstill at this time" | "das Szenario erfordert eine bewegte Achse; die Achse steht zu diesem Zeitpunkt";
    refused_unstable(name, key) =
        "with these gains the {name} is unstable: reduce {key}"
        | "mit diesen Reglerparametern schwingt die {name} auf: {key} verringern";
    refused_unstable_beyond(name, key, limit) =
        "with these gains the {name} is unstable: reduce {key}; the limit of stability is at {limit} % of it"
        | "mit diesen Reglerparametern schwingt die {name} auf: {key} verringern; die Stabilitätsgrenze liegt bei {limit} % davon";
    refused_range(key) = "{key} is out of range" | "{key} liegt außerhalb seines Bereichs";
    refused_above(lower, upper) =
        "{lower} is above {upper}: state both"
        | "{lower} ist größer als {upper}: beide angeben";
    too_many_steps(steps, most) =
        "{steps} steps exceed the limit of {most}" | "{steps} Schritte überschreiten die Grenze von {most}";
    too_many_steps_besides(steps, besides, most) =
        "{steps} steps and up to {besides} for the temperatures at its start exceed the limit of {most}"
        | "{steps} Schritte und bis zu {besides} für die Temperaturen am Beginn überschreiten die Grenze von {most}";
    too_many_steps_chosen(steps, besides, most) =
        "{steps} steps and up to {besides} for the temperatures at its start and the worst instant of its event exceed the limit of {most}"
        | "{steps} Schritte und bis zu {besides} für die Temperaturen am Beginn und den ungünstigsten Zeitpunkt des Ereignisses überschreiten die Grenze von {most}";
    steps_cycles(most, key) = "simulate at most {most} cycles ({key})" | "höchstens {most} Zyklen rechnen ({key})";
    steps_cold(key) = "start cold ({key})" | "kalt beginnen ({key})";
    steps_without_days = "leave out the days (--days)" | "die Tage weglassen (--days)";
    steps_one_axis = "select one axis (--axis)" | "eine Achse wählen (--axis)";
    steps_in_the_terminal =
        "on the command line the run is computed: antrieb simulate with a time limit (--deadline 10min)"
        | "die Befehlszeile rechnet den Lauf: antrieb simulate mit einer Zeitgrenze (--deadline 10min)";
    fewer_cycles(most) = "at most {most} cycles" | "höchstens {most} Zyklen";
    cold_start = "start cold" | "kalt beginnen";
    steps_time_limit = "state a time limit (--deadline)" | "eine Zeitgrenze angeben (--deadline)";
    steps_and(one, other) = "{one} and {other}" | "{one} und {other}";
    steps_or(one, other) = "{one}, or {other}" | "{one} oder {other}";
    refused_every(period) =
        "the interval between two rows must be at least {period} µs, one period of the current controller"
        | "der Abstand zweier Zeilen muss mindestens {period} µs betragen, eine Periode der Stromregelung";
    too_many_rows(rows, most) = "{rows} rows of the trace exceed the limit of {most}: state a longer --every" | "{rows} Zeilen des Verlaufs überschreiten die Grenze von {most}: ein größeres --every angeben";
    trace = "trace of the simulation" | "Verlauf der Simulation";
    trace_about = "one row per instant; values at the output unless the name contains motor" | "eine Zeile je Zeitpunkt; Werte am Abtrieb, sofern der Name nicht motor enthält";
    picture_of_a_run = "this picture shows a simulation run: use `antrieb simulate`" | "dieses Bild zeigt einen Simulationslauf: `antrieb simulate` verwenden";
    identified(axis, samples) =
        "Identified for {axis} from {samples} samples" | "Identifiziert für {axis} aus {samples} Abtastwerten";
    interval_95 = "± (95 %)";
    of_the_project = "project or table" | "Projekt oder Tabelle";
    load_inertia = "moment of inertia of the load, including the flange" | "Massenträgheitsmoment der Last, mit Flansch";
    coulomb = "Coulomb friction of the load" | "Coulomb-Reibung der Last";
    viscous = "viscous friction of the load" | "viskose Reibung der Last";
    gravity = "gravity torque of the load at its largest lever arm" | "Gewichtsmoment der Last am größten Hebelarm";
    external = "external torque of the load" | "äußeres Moment der Last";
    gravity_angle = "angle of the centre of mass above the horizontal at position zero" | "Winkel des Schwerpunkts über der Waagerechten in Nullposition";
    torque_constant_out = "torque constant at the output" | "Drehmomentkonstante am Abtrieb";
    no_load_starting_current = "no-load starting current" | "lastfreier Anlaufstrom";
    no_load_current_constant = "no-load current constant" | "Leerlaufstromkonstante";
    averaged = "operation over days, with the mean losses of the cycle" | "Betrieb über Tage, aus den mittleren Verlusten des Zyklus";
    averaged_about =
        "Cold start each day: mean losses of a cycle at the temperatures of each minute; within a cycle the winding temperature varies about this mean."
        | "Kaltstart an jedem Tag: mittlere Verluste eines Zyklus bei den Temperaturen jeder Minute; innerhalb eines Zyklus schwankt die Wicklungstemperatur um diesen Mittelwert.";
    day_course(day) = "temperatures over day {day}" | "Temperaturen über Tag {day}";
    day_course_about =
        "Each row is the end of an hour; operation begins at 0 h. The highest winding temperature is that within a cycle, in the hour before."
        | "Jede Zeile ist das Ende einer Stunde; der Betrieb beginnt bei 0 h. Die höchste Wicklungstemperatur ist die innerhalb eines Zyklus in der Stunde davor.";
    hour_h = "time h" | "Zeit h";
    winding_mean = "winding °C" | "Wicklung °C";
    winding_in_the_hour = "winding, highest °C" | "Wicklung, höchste °C";
    housing_then = "housing °C" | "Gehäuse °C";
    day_number = "day" | "Tag";
    day_number_about = "number of the day of operation: the first and the last" | "Nummer des Betriebstags: der erste und der letzte";
    days_table = "temperatures over the day" | "Temperaturen über den Tag";
    days_table_about = "one row per minute of the first and the last day; operation begins at 0 h" | "eine Zeile je Minute des ersten und des letzten Tages; der Betrieb beginnt bei 0 h";
    hour_about = "time since the beginning of the day; operation begins at zero" | "Zeit seit Beginn des Tages; der Betrieb beginnt bei null";
    winding_mean_about = "mean over a cycle of the motion" | "Mittelwert über einen Bewegungszyklus";
    winding_highest = "winding, highest" | "Wicklung, höchste";
    winding_highest_about = "highest within a cycle of the motion" | "höchste innerhalb eines Bewegungszyklus";
    housing_about = "follows the mean losses of the cycle" | "folgt den mittleren Verlusten des Zyklus";
    no_days =
        "the actuator has no thermal model: there is no course of the temperatures over a day"
        | "der Antrieb hat kein thermisches Modell: ein Verlauf der Temperaturen über einen Tag ist nicht möglich";
    days_written(file, rows) = "{file}: {rows} rows, one per minute of the first and the last day" | "{file}: {rows} Zeilen, eine je Minute des ersten und des letzten Tages";
    days = "days" | "Tage";
    operation = "operating time" | "Betriebszeit";
    cycles = "motion cycles" | "Bewegungszyklen";
    starts = "starts (temperature cycles)" | "Anläufe (Temperaturzyklen)";
    housing_peak = "highest housing temperature" | "höchste Gehäusetemperatur";
    housing_mean = "mean housing temperature in operation" | "mittlere Gehäusetemperatur im Betrieb";
    winding_swing = "winding temperature swing over a day" | "Schwankung der Wicklungstemperatur über einen Tag";
    housing_swing = "housing temperature swing over a day" | "Schwankung der Gehäusetemperatur über einen Tag";
    energy_housing = "heat in the housing" | "Wärme im Gehäuse";
    refused_at =
        "the scenario has no instant; state one with an event, such as emergency_stop"
        | "das Szenario hat keinen Zeitpunkt; eines mit einem Ereignis angeben, etwa emergency_stop";
    refused_reaction =
        "the drive does not stop in the scenario cycle; state one with a stop, such as emergency_stop"
        | "der Servoregler hält im Szenario Zyklus nicht an; eines mit einem Halt angeben, etwa emergency_stop";
    refused_days = "days of operation can be stated for the scenario cycle only" | "Betriebstage sind nur beim Szenario Zyklus zulässig";
    refused_hours = "0 to 24 hours per day, together with --days" | "0 bis 24 Stunden je Tag, zusammen mit --days";
    lines_for_the_project = "lines for the project" | "Zeilen für das Projekt";
    trace_unread(name, why) = "{name} cannot be read: {why}" | "{name} kann nicht gelesen werden: {why}";
    trace_too_large(name, most) = "{name} is larger than {most} MiB" | "{name} ist größer als {most} MiB";
    trace_lacks(columns) = "the trace lacks columns: {columns}" | "dem Verlauf fehlen Spalten: {columns}";
    trace_not_a_number(line, column) = "line {line}: the value of {column} is not a number" | "Zeile {line}: der Wert von {column} ist keine Zahl";
    trace_too_short = "too few samples in motion" | "zu wenige Abtastwerte in Bewegung";
    trace_not_excited =
        "the run does not determine the values: it must contain accelerations and several speeds"
        | "der Lauf bestimmt die Werte nicht: er muss Beschleunigungen und mehrere Drehzahlen enthalten";
    simulation = "simulation" | "Simulation";
    following_error = "Following error of the load" | "Schleppfehler der Last";
    temperatures = "Temperatures" | "Temperaturen";
    logarithm_of_frequency = "Decimal logarithm of the frequency" | "Zehnerlogarithmus der Frequenz";
    magnitude = "Magnitude of the open loop" | "Betrag des offenen Kreises";
    phase = "Phase of the open loop" | "Phase des offenen Kreises";
    run_caption =
        "Speeds at the output; gear torque; the dashed line marks the instant of the scenario."
        | "Drehzahlen am Abtrieb; Getriebemoment; die gestrichelte Linie markiert den Zeitpunkt des Szenarios.";
    run_described(scenario, time, current, torque, error) =
        "{scenario}, {time} s: maximum motor current {current} A, maximum gear torque {torque} Nm, maximum following error {error} arcmin."
        | "{scenario}, {time} s: maximaler Motorstrom {current} A, maximales Getriebemoment {torque} Nm, maximaler Schleppfehler {error} Winkelminuten.";
    loops_caption =
        "At the 0 dB crossover of the magnitude, the distance of the phase from −180° is the phase margin; dip and peak are due to load and rotor oscillating on the gear stiffness."
        | "Beim 0-dB-Durchtritt des Betrags ist der Abstand der Phase von −180° die Phasenreserve; Senke und Spitze entstehen durch Last und Rotor an der Getriebesteifigkeit.";
    loop_described(name, crossover, margin, bandwidth) =
        "{name}: crossover {crossover} Hz, phase margin {margin}°, bandwidth {bandwidth} Hz."
        | "{name}: Durchtrittsfrequenz {crossover} Hz, Phasenreserve {margin}°, Bandbreite {bandwidth} Hz.";
    wanted = "setpoint" | "Sollwert";
    of_the_load = "load" | "Last";
    measured = "actual value in the drive" | "Istwert im Servoregler";
    of_the_motor = "motor / ratio" | "Motor/Untersetzung";
    peak_of_a_phase = "peak of a phase" | "Scheitelwert eines Strangs";
    sensor = "winding temperature sensor" | "Temperatursensor der Wicklung";
    voltage = "voltage" | "Spannung";
    dc_link = "DC link" | "Zwischenkreis";
    dc_link_high = "DC link at the highest mains" | "Zwischenkreis bei höchster Netzspannung";
    braked = "brake closed" | "Bremse geschlossen";
    trace_written(file, rows, every) = "{file}: {rows} rows, one every {every} ms" | "{file}: {rows} Zeilen im Abstand von {every} ms";
    signals_need_a_format =
        "signals are columns of the trace and require `format` csv or parquet"
        | "Größen sind Spalten des Verlaufs und erfordern `format` csv oder parquet";
    figure_needs_a_format = "a picture requires `format` svg" | "ein Bild erfordert `format` svg";
    ending_of_a_trace = "the trace must be a .csv or .parquet file" | "der Verlauf muss eine Datei .csv oder .parquet sein";
}

/// Returns the title of a scenario.
#[must_use]
pub fn scenario_title(scenario: ScenarioId, language: Language) -> String {
    let (en, de) = match scenario {
        ScenarioId::Cycle => ("cycle", "Zyklus"),
        ScenarioId::EmergencyStop => ("emergency stop", "Not-Halt"),
        ScenarioId::PowerFailure => ("power failure", "Netzausfall"),
        ScenarioId::BrakeStuck => ("brake does not open", "Bremse öffnet nicht"),
        ScenarioId::HangingLoad => ("load sag while the brake closes", "Absacken der Last beim Schließen der Bremse"),
        ScenarioId::BlockedLoad => ("blocked load", "blockierte Last"),
        ScenarioId::EncoderFailure => ("encoder failure", "Geberausfall"),
        ScenarioId::BatteryLoss => ("encoder battery empty", "Geberbatterie leer"),
        ScenarioId::LinkSag => ("supply voltage dip", "Einbruch der Versorgungsspannung"),
        ScenarioId::HotAmbient => ("highest ambient temperature", "höchste Umgebungstemperatur"),
        ScenarioId::ColdGrease => ("cold grease", "kaltes Fett"),
        ScenarioId::Collision => ("collision", "Kollision"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the title of a check of a run.
#[must_use]
pub fn run_check_title(id: RunCheckId, language: Language) -> String {
    let title = match id {
        RunCheckId::CurrentPeak => current_peak,
        RunCheckId::TorquePeak => torque_peak,
        RunCheckId::SpeedPeak => speed_peak,
        RunCheckId::WindingPeak => winding_peak,
        RunCheckId::Overload => overload,
        RunCheckId::LinkHigh => link_high,
        RunCheckId::StopAngle => stop_angle,
        RunCheckId::DriveFaults => drive_faults,
    };
    title(language).to_owned()
}

/// Returns the title of a check of a run with the limit that is meant, where several are possible.
#[must_use]
pub fn run_check_against(check: &RunCheck, language: Language) -> String {
    let title = run_check_title(check.id, language);
    match check.limit_symbol {
        "" => title,
        "T_KTY_shutdown" => {
            crate::simulation::limit_named(&title, &crate::simulation::shutdown_threshold(language), language)
        }
        symbol => crate::simulation::limit_named(&title, &symbol, language),
    }
}

/// Returns the title of an event.
#[must_use]
pub fn event_title(event: EventKind, language: Language) -> String {
    let (en, de) = match event {
        EventKind::Scenario => ("the scenario occurs", "das Szenario tritt ein"),
        EventKind::Ramp => ("the drive stops with a ramp", "der Servoregler bremst an der Rampe"),
        EventKind::PulsesOff => ("pulse inhibit", "Impulssperre"),
        EventKind::BrakeCloses => ("brake close command", "Schließbefehl an die Bremse"),
        EventKind::BrakeClosed => ("brake closed at standstill", "Bremse im Stillstand geschlossen"),
        EventKind::BrakeClosedMoving => ("brake closed in motion", "Bremse in Bewegung geschlossen"),
        EventKind::BrakeOpen => ("brake open", "Bremse offen"),
        EventKind::BrakeSlips => ("the closed brake slips", "die geschlossene Bremse rutscht"),
        EventKind::AtRest => ("standstill", "Stillstand"),
        EventKind::Limited => ("current or voltage at its limit", "Strom oder Spannung an der Grenze"),
        EventKind::Overload => ("overload monitoring I²t trips", "Überlastüberwachung I²t löst aus"),
        EventKind::WindingWarning => ("winding: warning temperature", "Wicklung: Warntemperatur"),
        EventKind::WindingShutdown => ("winding: shutdown temperature", "Wicklung: Abschalttemperatur"),
        EventKind::PtcResponse => ("winding: the PTC responds", "Wicklung: der PTC spricht an"),
        EventKind::FollowingError => ("following error too large", "Schleppfehler zu groß"),
        EventKind::LinkLow => ("DC link: undervoltage", "Zwischenkreis: Unterspannung"),
        EventKind::LinkHigh => ("DC link: overvoltage", "Zwischenkreis: Überspannung"),
        EventKind::BrakeResistor => ("braking resistor on", "Bremswiderstand ein"),
        EventKind::NoPosition => {
            ("encoder failure detected: no valid position", "Geberausfall erkannt: keine gültige Position")
        }
        EventKind::TurnsLost => {
            ("the encoder has lost its turns, undetected", "der Geber hat seine Umdrehungen unbemerkt verloren")
        }
        EventKind::Demagnetisation => ("demagnetisation current reached", "Entmagnetisierungsstrom erreicht"),
        EventKind::CollisionTorque => {
            ("collision torque of the gear exceeded", "Kollisionsdrehmoment des Getriebes überschritten")
        }
        EventKind::Overspeed => ("speed too high", "Drehzahl zu hoch"),
        EventKind::Diverged => ("the run diverges and is stopped", "der Lauf divergiert und wird abgebrochen"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the title of an encoder failure; `None` is the loss of turns due to an empty battery.
#[must_use]
pub fn failure_title(failure: Option<Failure>, language: Language) -> String {
    let (en, de) = match failure {
        Some(Failure::Track) => ("no signal from one track or winding", "kein Signal einer Spur oder Wicklung"),
        Some(Failure::Amplitude) => ("signals at a quarter of their level", "Signale mit einem Viertel ihres Pegels"),
        Some(Failure::Cable) => ("signal loss", "Signalverlust"),
        Some(Failure::Check) => ("words received with a wrong bit", "Datenwörter mit einem falschen Bit"),
        Some(Failure::ErrorBit) => ("the encoder reports an error", "der Geber meldet einen Fehler"),
        Some(Failure::DataLine) => ("the data line stays low", "die Datenleitung bleibt auf niedrigem Pegel"),
        None => ("turns lost due to empty battery", "Umdrehungen durch leere Batterie verloren"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the title of a finding by which a drive detects an encoder failure.
#[must_use]
pub fn finding_title(finding: Finding, language: Language) -> String {
    let (en, de) = match finding {
        Finding::Amplitude => ("signal level out of limits", "Signalpegel außerhalb der Grenzen"),
        Finding::Commutation => (
            "counted angle deviates from the commutation signals",
            "gezählter Winkel weicht von den Kommutierungssignalen ab",
        ),
        Finding::Sector => ("all commutation signals equal", "Kommutierungssignale alle gleich"),
        Finding::Start => ("word without start bit", "Datenwort ohne Startbit"),
        Finding::Check => ("word with wrong checksum", "Datenwort mit falscher Prüfsumme"),
        Finding::ErrorBit => ("error bit of the word", "Fehlerbit des Datenworts"),
        Finding::Difference => {
            ("absolute position deviates from the counted one", "absolute Position weicht von der gezählten ab")
        }
    };
    pick(language, en, de).to_owned()
}

/// Returns the name of a control loop.
#[must_use]
pub fn loop_title(of: Loop, language: Language) -> String {
    let (en, de) = match of {
        Loop::Current => ("current", "Strom"),
        Loop::Speed => ("speed", "Drehzahl"),
        Loop::Position => ("position", "Position"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the reason why nothing is simulated.
#[must_use]
pub fn simulation_fault(fault: &Fault, language: Language) -> String {
    match fault {
        Fault::Missing(missing) => crate::simulation::refused_missing(&missing.symbol, language),
        Fault::RecordedTorque => crate::simulation::refused_recorded(language).to_owned(),
        Fault::NotOfThisLoad(key) => crate::simulation::refused_load(key, language),
        Fault::NoInertia => crate::simulation::refused_inertia(language).to_owned(),
        Fault::StepTooLong { substeps } => crate::simulation::refused_step(substeps, language),
        Fault::NoBrake => crate::simulation::refused_brake(language).to_owned(),
        Fault::NoOutputEncoder => crate::simulation::refused_output_encoder(language).to_owned(),
        Fault::NoEncoder => crate::simulation::refused_encoder(language).to_owned(),
        Fault::NotOfThisEncoder { failure, possible } => {
            let possible: Vec<&str> = possible.iter().flatten().map(|each| each.id()).collect();
            let title = failure_title(Some(*failure), language);
            crate::simulation::refused_failure_of_encoder(&title, &possible.join(", "), language)
        }
        Fault::NoBattery => crate::simulation::refused_battery(language).to_owned(),
        Fault::AfterTheEnd { end_s } => {
            crate::simulation::refused_late(&quantities::format_significant(*end_s, 4, language), language)
        }
        Fault::NotAtRest => crate::simulation::refused_moving(language).to_owned(),
        Fault::AtRest => crate::simulation::refused_resting(language).to_owned(),
        Fault::Unstable { of, limit } => {
            let (en, de) = match of {
                Loop::Current => ("current control", "Stromregelung"),
                Loop::Speed => ("speed control", "Drehzahlregelung"),
                Loop::Position => ("position control", "Lageregelung"),
            };
            let (name, key) = (pick(language, en, de), format!("twin.{}_gain", of.id()));
            match limit.filter(|limit| *limit < 1.0) {
                Some(limit) => {
                    let limit = quantities::format_significant(100.0 * limit, 3, language);
                    crate::simulation::refused_unstable_beyond(&name, &key, &limit, language)
                }
                None => crate::simulation::refused_unstable(&name, &key, language),
            }
        }
        Fault::OutOfRange(key) => crate::simulation::refused_range(key, language),
        Fault::Above { lower, upper } => crate::simulation::refused_above(lower, upper, language),
    }
}
