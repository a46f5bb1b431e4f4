//! Words about the digital twin.

use crate::pick;
use crate::texts::texts;
use feedback::{Failure, Finding};
use quantities::Language;
use twin::{EventKind, Fault, Loop, ScenarioId};

texts! {
    title(code, axis) = "Simulation of {code}: {axis}" | "Simulation von {code}: {axis}";
    course(scenario, time, start, steps, step) =
        "{scenario}: {time} s simulated, start {start}; {steps} steps of {step} µs, Taylor's series of fourth order"
        | "{scenario}: {time} s simuliert, Beginn {start}; {steps} Schritte von {step} µs, Taylorreihe vierter Ordnung";
    warm(winding, housing) =
        "warm, winding {winding} °C, housing {housing} °C" | "warm, Wicklung {winding} °C, Gehäuse {housing} °C";
    cold(ambient) = "cold, everything at {ambient} °C" | "kalt, alles auf {ambient} °C";
    summary = "summary" | "Zusammenfassung";
    verdicts = "verdicts" | "Urteile";
    events = "events" | "Ereignisse";
    no_events = "no events" | "keine Ereignisse";
    agreement = "sizing and twin" | "Auslegung und Zwilling";
    sizing_said = "sizing" | "Auslegung";
    twin_shows = "twin" | "Zwilling";
    why = "why they differ" | "Grund der Abweichung";
    loops = "control loops" | "Regelkreise";
    gains = "gains" | "Reglerparameter";
    gains_rule =
        "default gains by the magnitude optimum (current) and the symmetrical optimum (speed), position by the frequency of the load"
        | "Voreinstellung nach dem Betragsoptimum (Strom) und dem symmetrischen Optimum (Drehzahl), Lage nach der Frequenz der Last";
    gains_stated = "gains of the project" | "Reglerparameter aus dem Projekt";
    assumed = "parameters that no table has" | "Parameter, die in keiner Tabelle stehen";
    left_out(data) =
        "not printed, and so left out or assumed: {data}" | "nicht abgedruckt und deshalb weggelassen oder angenommen: {data}";
    band =
        "A twin from catalogue data alone: friction of such gears was measured up to 15 % (viscous) and 40 % (dry) beside it; measured values of the project replace it."
        | "Ein Zwilling allein aus Katalogdaten: gemessen lag die Reibung solcher Getriebe bis zu 15 % (viskos) und 40 % (trocken) daneben; gemessene Werte des Projekts ersetzen sie.";
    quantity = "quantity" | "Größe";
    limit = "limit" | "Grenze";
    time_s = "time s" | "Zeit s";
    event = "event" | "Ereignis";
    loop_head = "loop" | "Regelkreis";
    crossover = "crossover Hz" | "Durchtritt Hz";
    phase_margin = "phase margin °" | "Phasenreserve °";
    gain_margin = "gain margin dB" | "Amplitudenreserve dB";
    bandwidth = "bandwidth Hz" | "Bandbreite Hz";
    stable = "stable" | "stabil";
    unstable = "unstable" | "instabil";
    parameter = "parameter" | "Parameter";
    source_head = "source" | "Quelle";
    supply_assumed(volt) =
        "no supply is stated: a DC link of {volt} V is assumed" | "keine Versorgung angegeben: Zwischenkreis von {volt} V angenommen";
    following_peak = "following error of the load, largest" | "Schleppfehler der Last, größter";
    following_rms = "following error of the load, effective" | "Schleppfehler der Last, effektiv";
    settling = "settling time after a move" | "Ausregelzeit nach einer Bewegung";
    standing = "deviation at rest, largest" | "Abweichung im Stillstand, größte";
    current_peak = "motor current, largest" | "Motorstrom, größter";
    current_rms = "motor current, effective" | "Motorstrom, effektiv";
    torque_peak = "torque through the gear, largest" | "Drehmoment durch das Getriebe, größtes";
    torque_rms = "torque through the gear, effective" | "Drehmoment durch das Getriebe, effektiv";
    speed_peak = "speed of the motor over the ratio, largest" | "Motordrehzahl durch die Untersetzung, größte";
    winding_end = "winding at the end" | "Wicklung am Ende";
    housing_end = "housing at the end" | "Gehäuse am Ende";
    winding_peak = "winding, warmest" | "Wicklung, wärmste";
    overload = "overload supervision I²t, largest state" | "Überlastüberwachung I²t, größter Zustand";
    link_low = "DC link, least" | "Zwischenkreis, kleinste";
    link_high = "DC link, largest" | "Zwischenkreis, größte";
    energy_motor = "energy to the motor" | "Energie an den Motor";
    energy_regenerated = "energy regenerated" | "Energie zurückgespeist";
    energy_copper = "loss of the winding" | "Verlust der Wicklung";
    energy_friction = "loss by friction of no load" | "Verlust durch Leerlaufreibung";
    energy_mesh = "loss of the teeth under torque" | "Verlust der Verzahnung unter Last";
    energy_hysteresis = "loss by hysteresis and damping of the gear" | "Verlust durch Hysterese und Dämpfung des Getriebes";
    energy_brake = "heat of the brake" | "Wärme der Bremse";
    energy_load = "energy to the load" | "Energie an die Last";
    energy_constants = "difference of k_TM and k_EM" | "Unterschied von k_TM und k_EM";
    energy_resistor = "heat of the brake resistor" | "Wärme des Bremswiderstands";
    energy_supply = "energy from the supply" | "Energie aus der Versorgung";
    unaccounted = "error of the energy balance" | "Fehler der Energiebilanz";
    resonance_blocked = "resonance with blocked motor" | "Resonanz bei blockiertem Motor";
    resonance_free = "resonance with free motor" | "Resonanz bei freiem Motor";
    stop_time = "time to rest" | "Zeit bis zum Stillstand";
    stop_angle = "way to rest" | "Weg bis zum Stillstand";
    brake_rest = "brake closed at rest" | "Bremse im Stillstand geschlossen";
    brake_moving = "brake closed in motion" | "Bremse in Bewegung geschlossen";
    drive_faults = "faults of the drive" | "Störungen des Reglers";
    why_current =
        "the twin accelerates the rotor on the motor side of the gear, and the control swings about the set-point"
        | "der Zwilling beschleunigt den Rotor auf der Motorseite des Getriebes, und die Regelung schwingt um den Sollwert";
    why_torque =
        "the sizing counts the own inertia at the output; the twin shows what the gear passes, with the oscillation of the load"
        | "die Auslegung zählt das eigene Trägheitsmoment am Abtrieb mit; der Zwilling zeigt, was das Getriebe überträgt, mit der Schwingung der Last";
    why_speed = "overshoot of the control" | "Überschwingen der Regelung";
    why_thermal =
        "the twin counts the ripple of the current; the sizing takes the resistance of continuous duty"
        | "der Zwilling zählt die Welligkeit des Stroms; die Auslegung nimmt den Widerstand im Dauerbetrieb";
    why_overload =
        "the sizing is settled; the twin begins at zero and runs the stated cycles"
        | "die Auslegung ist eingeschwungen; der Zwilling beginnt bei null und läuft die angegebenen Zyklen";
    why_regeneration =
        "the sizing takes a cold winding, the twin that of the run; the oscillation passes energy to and fro"
        | "die Auslegung nimmt eine kalte Wicklung, der Zwilling die des Laufs; die Schwingung trägt Energie hin und her";
    refused_missing(symbol) = "no simulation: {symbol} is not known" | "keine Simulation: {symbol} ist nicht bekannt";
    refused_recorded =
        "no simulation: the torque of the joint is recorded with its motion and does not follow from a state"
        | "keine Simulation: das Drehmoment des Gelenks ist mit der Bewegung aufgezeichnet und folgt nicht aus einem Zustand";
    refused_load(key) =
        "measured.{key} replaces nothing: this load changes with the position or with the direction of the power"
        | "measured.{key} ersetzt nichts: Diese Last hängt von der Stellung oder der Richtung der Leistung ab";
    refused_inertia = "no simulation: the load has no inertia" | "keine Simulation: die Last hat kein Trägheitsmoment";
    refused_step(steps) =
        "the step is too long for the stiffest part: at least {steps} steps in a period of the current loop"
        | "der Schritt ist zu lang für den steifsten Teil: mindestens {steps} Schritte je Periode der Stromregelung";
    refused_brake = "the scenario needs a brake, and the actuator has none" | "das Szenario braucht eine Bremse, und der Antrieb hat keine";
    refused_output_encoder =
        "no simulation: the position loop is closed at the output, and the actuator has no encoder there (option EC)"
        | "keine Simulation: der Lageregelkreis wird am Abtrieb geschlossen, und der Antrieb hat dort keinen Geber (Option EC)";
    refused_battery =
        "the scenario needs a feedback with battery, and the actuator has none"
        | "das Szenario braucht einen Geber mit Batterie, und der Antrieb hat keinen";
    refused_encoder =
        "the scenario needs an encoder whose signals are known: state an ordering code"
        | "das Szenario braucht einen Geber, dessen Signale bekannt sind: eine Bestellbezeichnung angeben";
    refused_failure_of_encoder(failure, possible) =
        "the encoder of this actuator cannot fail so: {failure}; possible are {possible}"
        | "der Geber dieses Antriebs kann so nicht ausfallen: {failure}; möglich sind {possible}";
    refused_failure(scenario) =
        "a failure of the encoder belongs to the scenario {scenario}" | "ein Ausfall des Gebers gehört zum Szenario {scenario}";
    noticed(failure, time, finding, angle) =
        "Encoder: {failure}; noticed after {time} ms: {finding}; the angle read was then {angle}° beside the true one at the output."
        | "Geber: {failure}; erkannt nach {time} ms: {finding}; der gelesene Winkel lag dann am Abtrieb um {angle}° neben dem wahren.";
    not_noticed(failure, angle) =
        "Encoder: {failure}; the drive does not notice it; at the end the angle read is {angle}° beside the true one at the output."
        | "Geber: {failure}; der Regler bemerkt es nicht; am Ende liegt der gelesene Winkel am Abtrieb um {angle}° neben dem wahren.";
    refused_late(end) = "the scenario takes place after the end of the run, {end} s" | "das Szenario liegt nach dem Ende des Laufs, {end} s";
    refused_moving = "the scenario begins at rest, and the axis moves then" | "das Szenario beginnt im Stillstand, und die Achse bewegt sich dann";
    refused_resting = "the scenario needs a moving axis, and it rests then" | "das Szenario braucht eine bewegte Achse, und sie steht dann";
    refused_unstable = "with these gains a loop swings up" | "mit diesen Reglerparametern schwingt ein Regelkreis auf";
    refused_range(key) = "{key} is out of its range" | "{key} liegt außerhalb seines Bereichs";
    too_many_steps(steps, most) =
        "{steps} steps are more than are run without a time limit, {most}: run fewer cycles or state --deadline"
        | "{steps} Schritte sind mehr als ohne Zeitgrenze gerechnet werden, {most}: weniger Zyklen rechnen oder --deadline angeben";
    refused_every(period) =
        "at least {period} µs lie between two rows, a period of the current loop"
        | "zwischen zwei Zeilen liegen mindestens {period} µs, eine Periode der Stromregelung";
    too_many_rows(rows, most) = "{rows} rows of the trace are more than {most}: state a longer --every" | "{rows} Zeilen des Verlaufs sind mehr als {most}: ein längeres --every angeben";
    trace = "course of the simulation" | "Verlauf der Simulation";
    trace_about = "one row for each instant, at the output unless the name says motor" | "eine Zeile je Zeitpunkt, am Abtrieb, wenn der Name nicht motor nennt";
    picture_of_a_run = "this picture is one of a run: `antrieb simulate` draws it" | "dieses Bild gehört zu einem Lauf: `antrieb simulate` zeichnet es";
    identified(axis, samples) =
        "Identified for {axis} from {samples} samples" | "Identifiziert für {axis} aus {samples} Abtastwerten";
    interval_95 = "± (95 %)";
    of_the_project = "project or table" | "Projekt oder Tabelle";
    load_inertia = "inertia of the load, with the flange" | "Massenträgheitsmoment der Last, mit Flansch";
    coulomb = "Coulomb friction of the load" | "Coulomb-Reibung der Last";
    viscous = "viscous friction of the load" | "viskose Reibung der Last";
    gravity = "weight of the load at its largest lever" | "Gewichtsmoment der Last am größten Hebel";
    external = "external torque of the load" | "äußeres Moment der Last";
    gravity_angle = "angle of the centre of mass above the horizontal at position 0" | "Winkel des Schwerpunkts über der Waagerechten in Stellung 0";
    at_the_limit(count) =
        "{count} samples have a current at its limit: they and their neighbours say nothing of the motor."
        | "{count} Abtastwerte haben einen Strom an der Grenze: Sie und ihre Nachbarn sagen nichts über den Motor.";
    motor_not_estimated =
        "Too few samples below the limit of the current: torque constant and no-load current are not estimated."
        | "Zu wenige Abtastwerte unterhalb der Stromgrenze: Drehmomentkonstante und Leerlaufstrom werden nicht geschätzt.";
    load_not_replaced =
        "Load, efficiency or stage of this mechanism change with the position or the direction of the power: estimates of the load are means over the run, and the project takes over only what is listed."
        | "Last, Wirkungsgrad oder Stufe dieses Mechanismus hängen von der Stellung oder der Richtung der Leistung ab: Schätzwerte der Last sind Mittelwerte über den Lauf, und das Projekt übernimmt nur das Aufgeführte.";
    torque_constant_out = "torque constant at the output" | "Drehmomentkonstante am Abtrieb";
    no_load_starting_current = "no-load starting current" | "Leerlaufanlaufstrom";
    no_load_current_constant = "no-load current constant" | "Leerlaufstromkonstante";
    one_direction =
        "Estimated from samples in motion; in one direction alone Coulomb friction holds every constant torque, and gravity is not estimated."
        | "Geschätzt aus Abtastwerten in Bewegung; in nur einer Richtung enthält die Coulomb-Reibung jedes konstante Moment, und das Gewicht wird nicht geschätzt.";
    averaged = "operation over days, by the mean losses of the cycle" | "Betrieb über Tage, aus den mittleren Verlusten des Zyklus";
    averaged_about =
        "From cold each day: mean losses of a cycle at the temperatures of each minute; within a cycle the winding swings about this mean."
        | "Jeden Tag aus der Kälte: mittlere Verluste eines Zyklus bei den Temperaturen jeder Minute; innerhalb eines Zyklus schwankt die Wicklung um diesen Mittelwert.";
    days = "days" | "Tage";
    operation = "time in operation" | "Betriebszeit";
    cycles = "cycles of the motion" | "Bewegungszyklen";
    starts = "starts: cycles of the temperature" | "Anläufe: Temperaturzyklen";
    housing_peak = "highest temperature of the housing" | "höchste Gehäusetemperatur";
    housing_mean = "mean temperature of the housing in operation" | "mittlere Gehäusetemperatur im Betrieb";
    winding_swing = "swing of the winding over a day" | "Schwankung der Wicklung über einen Tag";
    housing_swing = "swing of the housing over a day" | "Schwankung des Gehäuses über einen Tag";
    energy_housing = "heat in the housing" | "Wärme im Gehäuse";
    refused_days = "days of operation belong to the cycle, not to another scenario" | "Betriebstage gehören zum Zyklus, nicht zu einem anderen Szenario";
    refused_hours = "from 0 to 24 hours a day, together with --days" | "0 bis 24 Stunden am Tag, zusammen mit --days";
    lines_for_the_project = "lines for the project" | "Zeilen für das Projekt";
    no_such_trace(name) = "{name} cannot be read" | "{name} kann nicht gelesen werden";
    trace_too_large(name, most) = "{name} is larger than {most} MiB" | "{name} ist größer als {most} MiB";
    trace_lacks(columns) = "the trace lacks columns: {columns}" | "dem Verlauf fehlen Spalten: {columns}";
    trace_not_a_number(line, column) = "line {line}: the value of {column} is no number" | "Zeile {line}: der Wert von {column} ist keine Zahl";
    trace_too_short = "too few samples in motion" | "zu wenige Abtastwerte in Bewegung";
    trace_not_excited =
        "the run leaves the values open: it needs accelerations and several speeds"
        | "der Lauf lässt die Werte offen: er braucht Beschleunigungen und mehrere Drehzahlen";
    simulation = "simulation" | "Simulation";
    following_error = "Following error of the load" | "Schleppfehler der Last";
    temperatures = "Temperatures" | "Temperaturen";
    logarithm_of_frequency = "Decimal logarithm of the frequency" | "Zehnerlogarithmus der Frequenz";
    magnitude = "Magnitude of the open loop" | "Betrag des offenen Kreises";
    phase = "Phase of the open loop" | "Phase des offenen Kreises";
    run_caption =
        "Speeds at the output; torque through the gear; the dashed line is the instant of the scenario."
        | "Drehzahlen am Abtrieb; Drehmoment durch das Getriebe; die gestrichelte Linie ist der Zeitpunkt des Szenarios.";
    run_described(scenario, time, current, torque, error) =
        "{scenario}, {time} s: largest motor current {current} A, largest torque through the gear {torque} Nm, largest following error {error} arcmin."
        | "{scenario}, {time} s: größter Motorstrom {current} A, größtes Drehmoment durch das Getriebe {torque} Nm, größter Schleppfehler {error} Winkelminuten.";
    loops_caption =
        "Where the magnitude passes 0 dB the distance of the phase from −180° is the phase margin; the dip and peak are load and rotor on the gear's spring."
        | "Wo der Betrag durch 0 dB geht, ist der Abstand der Phase von −180° die Phasenreserve; Senke und Spitze sind Last und Rotor an der Feder des Getriebes.";
    loop_described(name, crossover, margin, bandwidth) =
        "{name}: crossover {crossover} Hz, phase margin {margin}°, bandwidth {bandwidth} Hz."
        | "{name}: Durchtritt {crossover} Hz, Phasenreserve {margin}°, Bandbreite {bandwidth} Hz.";
    wanted = "set-point" | "Sollwert";
    of_the_load = "of the load" | "der Last";
    measured = "as the drive reads it" | "wie der Regler sie liest";
    of_the_motor = "of the motor over the ratio" | "des Motors durch die Untersetzung";
    peak_of_a_phase = "peak of a phase" | "Scheitelwert eines Strangs";
    sensor = "sensor of the winding" | "Fühler der Wicklung";
    voltage = "voltage" | "Spannung";
    dc_link = "DC link" | "Zwischenkreis";
    braked = "brake closed" | "Bremse geschlossen";
    trace_written(file, rows, every) = "{file}: {rows} rows, one each {every} ms" | "{file}: {rows} Zeilen, eine je {every} ms";
    signals_need_a_format =
        "signals are columns of the trace: with `format` csv or parquet"
        | "Größen sind Spalten des Verlaufs: mit `format` csv oder parquet";
    figure_needs_a_format = "a picture is answered with `format` svg" | "ein Bild kommt mit `format` svg";
    ending_of_a_trace = "the trace is a .csv or .parquet file" | "der Verlauf ist eine Datei .csv oder .parquet";
}

/// What happens in a scenario.
#[must_use]
pub fn scenario_title(scenario: ScenarioId, language: Language) -> String {
    let (en, de) = match scenario {
        ScenarioId::Cycle => ("cycle", "Zyklus"),
        ScenarioId::EmergencyStop => ("emergency stop", "Not-Halt"),
        ScenarioId::PowerFailure => ("power failure", "Netzausfall"),
        ScenarioId::BrakeStuck => ("brake that does not open", "Bremse öffnet nicht"),
        ScenarioId::HangingLoad => ("load sags while the brake closes", "Last sackt, während die Bremse schließt"),
        ScenarioId::BlockedLoad => ("blocked load", "blockierte Last"),
        ScenarioId::EncoderFailure => ("failure of the encoder", "Ausfall des Gebers"),
        ScenarioId::BatteryLoss => ("battery of the encoder empty", "Batterie des Gebers leer"),
        ScenarioId::LinkSag => ("sag of the supply", "Einbruch der Versorgung"),
        ScenarioId::HotAmbient => ("warmest ambient", "wärmste Umgebung"),
        ScenarioId::ColdGrease => ("cold grease", "kaltes Fett"),
        ScenarioId::Collision => ("collision", "Kollision"),
    };
    pick(language, en, de).to_owned()
}

/// What happened.
#[must_use]
pub fn event_title(event: EventKind, language: Language) -> String {
    let (en, de) = match event {
        EventKind::Scenario => ("the scenario takes place", "das Szenario tritt ein"),
        EventKind::Ramp => ("the drive stops along a ramp", "der Regler bremst an einer Rampe"),
        EventKind::PulsesOff => ("pulses off", "Impulssperre"),
        EventKind::BrakeCloses => ("brake commanded to close", "Bremse soll schließen"),
        EventKind::BrakeClosed => ("brake closed at rest", "Bremse im Stillstand geschlossen"),
        EventKind::BrakeClosedMoving => ("brake closed in motion", "Bremse in Bewegung geschlossen"),
        EventKind::BrakeOpen => ("brake open", "Bremse offen"),
        EventKind::BrakeSlips => ("the closed brake slips", "die geschlossene Bremse rutscht"),
        EventKind::AtRest => ("at rest", "Stillstand"),
        EventKind::Limited => ("current or voltage at its limit", "Strom oder Spannung an der Grenze"),
        EventKind::Overload => ("overload supervision I²t trips", "Überlastüberwachung I²t löst aus"),
        EventKind::WindingWarning => ("winding: warning temperature", "Wicklung: Warntemperatur"),
        EventKind::WindingShutdown => ("winding: shutdown temperature", "Wicklung: Abschalttemperatur"),
        EventKind::PtcResponse => ("winding: the PTC responds", "Wicklung: der PTC spricht an"),
        EventKind::FollowingError => ("following error too large", "Schleppfehler zu groß"),
        EventKind::LinkLow => ("DC link: undervoltage", "Zwischenkreis: Unterspannung"),
        EventKind::LinkHigh => ("DC link: overvoltage", "Zwischenkreis: Überspannung"),
        EventKind::BrakeResistor => ("brake resistor on", "Bremswiderstand ein"),
        EventKind::NoPosition => {
            ("failure of the encoder noticed: no valid position", "Ausfall des Gebers erkannt: keine gültige Position")
        }
        EventKind::TurnsLost => {
            ("the encoder has lost its turns, unseen", "der Geber hat seine Umdrehungen verloren, unbemerkt")
        }
        EventKind::Demagnetisation => ("demagnetisation current reached", "Entmagnetisierungsstrom erreicht"),
        EventKind::CollisionTorque => {
            ("collision torque of the gear exceeded", "Kollisionsmoment des Getriebes überschritten")
        }
        EventKind::Overspeed => ("speed too high", "Drehzahl zu hoch"),
        EventKind::Diverged => ("the run diverges and ends", "der Lauf divergiert und endet"),
    };
    pick(language, en, de).to_owned()
}

/// How an encoder fails; without a failure of its own it is the battery.
#[must_use]
pub fn failure_title(failure: Option<Failure>, language: Language) -> String {
    let (en, de) = match failure {
        Some(Failure::Track) => ("one track or winding gives no signal", "eine Spur oder Wicklung gibt kein Signal"),
        Some(Failure::Amplitude) => ("signals with a quarter of their level", "Signale mit einem Viertel ihres Pegels"),
        Some(Failure::Cable) => ("no signal arrives", "kein Signal kommt an"),
        Some(Failure::Check) => ("words arrive with a wrong bit", "Telegramme kommen mit einem falschen Bit an"),
        Some(Failure::ErrorBit) => ("the encoder reports an error", "der Geber meldet einen Fehler"),
        Some(Failure::DataLine) => ("the data line stays low", "die Datenleitung bleibt auf niedrigem Pegel"),
        None => ("turns lost with the battery", "Umdrehungen mit der Batterie verloren"),
    };
    pick(language, en, de).to_owned()
}

/// What a drive notices of it.
#[must_use]
pub fn finding_title(finding: Finding, language: Language) -> String {
    let (en, de) = match finding {
        Finding::Amplitude => ("level of the signals out of its bounds", "Pegel der Signale außerhalb seiner Grenzen"),
        Finding::Commutation => (
            "counted angle beside that of the commutation signals",
            "gezählter Winkel neben dem der Kommutierungssignale",
        ),
        Finding::Sector => ("commutation signals all alike", "Kommutierungssignale alle gleich"),
        Finding::Start => ("word without start bit", "Telegramm ohne Startbit"),
        Finding::Check => ("word with wrong check", "Telegramm mit falscher Prüfsumme"),
        Finding::ErrorBit => ("error bit of the word", "Fehlerbit des Telegramms"),
        Finding::Difference => ("absolute position beside the counted one", "absolute Position neben der gezählten"),
    };
    pick(language, en, de).to_owned()
}

/// A loop of the control.
#[must_use]
pub fn loop_title(of: Loop, language: Language) -> String {
    let (en, de) = match of {
        Loop::Current => ("current", "Strom"),
        Loop::Speed => ("speed", "Drehzahl"),
        Loop::Position => ("position", "Lage"),
    };
    pick(language, en, de).to_owned()
}

/// Why nothing is simulated.
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
        Fault::Unstable => crate::simulation::refused_unstable(language).to_owned(),
        Fault::OutOfRange(key) => crate::simulation::refused_range(key, language),
    }
}
