//! Words for the identification of an axis from a recorded run.

use crate::pick;
use crate::texts::texts;
use quantities::Language;
use twin::{Column, Misread, Open};

texts! {
    open = "not determined" | "nicht bestimmt";
    doubts = "signals that contradict their columns" | "Signale im Widerspruch zu ihren Spalten";
    no_lines =
        "No lines for the project: the estimates are not valid until the signals are corrected."
        | "Keine Zeilen für das Projekt: Die Schätzwerte gelten erst, wenn die Signale berichtigt sind.";
    method(windows, length) =
        "Estimated from {windows} windows of {length} ms in motion; position and motor speed are weighted and integrated, not differentiated."
        | "Geschätzt aus {windows} Fenstern von {length} ms in Bewegung; Position und Motordrehzahl werden gewichtet und integriert, nicht differenziert.";
    scale_of_the_torque =
        "The intervals hold for the scale of torque_nm as it is: values 5 % too large make inertia, friction, weight, external torque and torque constant 5 % too large. Current and rotor show a wrong scale only from about 20 % on."
        | "Die Intervalle setzen den Maßstab von torque_nm voraus: um 5 % zu große Werte machen Massenträgheitsmoment, Reibung, Gewichtsmoment, äußeres Moment und Drehmomentkonstante um 5 % zu groß. Strom und Rotor zeigen einen falschen Maßstab erst ab etwa 20 %.";
    payloads_off(share, half) =
        "The run shows {share} (± {half}) times the payloads and process torques that the moves of the project add: they are stated incorrectly, or torque_nm has another scale. The estimates take them as stated."
        | "Der Lauf zeigt das {share}-Fache (± {half}) der Nutzlasten und Prozessmomente, die die Bewegungen des Projekts hinzufügen: sie sind falsch angegeben, oder torque_nm hat einen anderen Maßstab. Die Schätzung übernimmt sie wie angegeben.";
    position_offset(offset, half) =
        "position_rad counts from another zero than the mechanism of the project: at 0 the mechanism stands at {offset}° (± {half}°). The weights of load and payloads are estimated with this offset; there is no line for the angle of the weight."
        | "position_rad zählt von einem anderen Nullpunkt als die Mechanik des Projekts: bei 0 steht die Mechanik bei {offset}° (± {half}°). Die Gewichte von Last und Nutzlasten sind mit diesem Versatz geschätzt; für den Winkel des Gewichts gibt es keine Zeile.";
    follows_no_cycle(correlation) =
        "The run does not follow the cycle of the project (correlation of the positions {correlation}): it is another motion, or time_s has another scale, which would not show otherwise: times 10 % too large make the inertia 21 % too large."
        | "Der Lauf folgt nicht dem Zyklus des Projekts (Korrelation der Positionen {correlation}): Er ist eine andere Bewegung, oder time_s hat einen anderen Maßstab, was sonst nicht auffiele: Um 10 % zu große Zeiten machen das Massenträgheitsmoment um 21 % zu groß.";
    assumed_rotor(inertia, spread) =
        "Assumed: rotor and wave generator have {inertia} kgm² at the output (table, less the share of the flange), standard deviation {spread} %."
        | "Angenommen: Rotor und Wave Generator haben {inertia} kgm² am Abtrieb (Tabelle abzüglich des Flanschanteils), Standardabweichung {spread} %.";
    in_step(every) =
        "The current, one value each {every} ms, may be sampled in step with the control and then misses up to 10 % of the rotor's acceleration; a row spacing below 0.2 ms narrows the interval of the torque constant."
        | "Der Strom, ein Wert je {every} ms, kann im Takt der Regelung abgetastet sein; dann fehlen bis zu 10 % der Rotorbeschleunigung. Ein Zeilenabstand unter 0,2 ms verkleinert das Intervall der Drehmomentkonstante.";
    stamps_scatter(scatter, interval) =
        "The time stamps scatter by {scatter} ms (standard deviation) about equal intervals of {interval} ms, which the signals follow: the rows are taken as evenly spaced."
        | "Die Zeitstempel streuen um {scatter} ms (Standardabweichung) um gleiche Abstände von {interval} ms, denen die Signale folgen: die Zeilen gelten als gleichmäßig verteilt.";
    held_values(column, period, interval) =
        "{column} is updated every {period} ms only, with rows every {interval} ms: one value for each update is used. The instant of an update is known within its period only, so that the equations contain a lag of torque and current."
        | "{column} wird nur alle {period} ms aktualisiert, Zeilen stehen alle {interval} ms: verwendet wird ein Wert je Aktualisierung. Der Zeitpunkt einer Aktualisierung ist nur bis auf ihre Periode bekannt; die Gleichungen enthalten deshalb eine Verzögerung von Moment und Strom.";
    of_the_first_move(shift) =
        "Payloads and process torques of the moves are taken from the project; the estimates are those of the first move. The run starts {shift} s after the start of the cycle."
        | "Nutzlasten und Prozessmomente der Bewegungen sind dem Projekt entnommen; die Schätzwerte gelten für die erste Bewegung. Der Lauf beginnt {shift} s nach dem Anfang des Zyklus.";
    of_the_first_move_later(shift) =
        "Payloads and process torques of the moves are taken from the project; the estimates are those of the first move. The cycle starts {shift} s after the instant 0 of the run."
        | "Nutzlasten und Prozessmomente der Bewegungen sind dem Projekt entnommen; die Schätzwerte gelten für die erste Bewegung. Der Zyklus beginnt {shift} s nach dem Zeitpunkt 0 des Laufs.";
    position_steps(step) =
        "The position has steps of {step}°; the estimates are corrected for this noise, the intervals include it."
        | "Die Position hat Stufen von {step}°; die Schätzwerte sind um dieses Rauschen korrigiert, die Intervalle enthalten es.";
    motor_lags(lag) =
        "The speed of the motor lags the position by {lag} ms, as the difference of two rows or a filter does; the estimates take this into account."
        | "Die Motordrehzahl eilt der Position um {lag} ms nach, wie die Differenz zweier Zeilen oder ein Filter; die Schätzwerte berücksichtigen das.";
    signals = "zeros, delays and filters of the signals" | "Nullpunkte, Verzögerungen und Filter der Signale";
    current_zero = "zero of the current, against that of the torque" | "Nullpunkt des Stroms gegenüber dem des Moments";
    torque_delay = "lag of the torque behind the position" | "Nacheilen des Moments hinter der Position";
    current_delay = "lag of the current behind the position" | "Nacheilen des Stroms hinter der Position";
    torque_filter = "time constant of a filter of the torque" | "Zeitkonstante eines Filters des Moments";
    current_filter = "time constant of a filter of the current" | "Zeitkonstante eines Filters des Stroms";
    signal_filtered(column, constant, half) =
        "{column} lags the position as behind a first-order low-pass filter with a time constant of {constant} ms (± {half} ms), which damps fast changes more than a delay does; all other signals are filtered likewise before the estimates."
        | "{column} eilt der Position nach wie hinter einem Tiefpass erster Ordnung mit der Zeitkonstante {constant} ms (± {half} ms), der schnelle Änderungen stärker dämpft als eine Verzögerung; alle anderen Signale sind vor der Schätzung ebenso gefiltert.";
    signal_lags(column, lag, half) =
        "{column} lags the position by {lag} ms (± {half} ms), as after a filter or in another bus cycle; the lag is removed before the estimates."
        | "{column} eilt der Position um {lag} ms nach (± {half} ms), wie nach einem Filter oder in einem anderen Zyklus des Busses; die Verzögerung ist vor der Schätzung herausgerechnet.";
    signal_leads(column, lag, half) =
        "{column} leads the position by {lag} ms (± {half} ms): the position is late; the difference is removed before the estimates."
        | "{column} eilt der Position um {lag} ms voraus (± {half} ms): die Position kommt verspätet; der Unterschied ist vor der Schätzung herausgerechnet.";
    zero_of_current(current, half, torque) =
        "The zeros of current_q_a and torque_nm differ: {current} A (± {half} A) in the current, or {torque} Nm in the torque. The motor parameters take this into account. The run does not show which signal has the offset: the interval of the external torque includes it if only one of both has one (offsets of both that cancel each other do not show), and no line states that torque."
        | "Die Nullpunkte von current_q_a und torque_nm passen nicht zusammen: {current} A (± {half} A) im Strom oder {torque} Nm im Moment. Die Motorparameter berücksichtigen das. Welches Signal den Versatz hat, zeigt der Lauf nicht: das Intervall des äußeren Moments enthält ihn, wenn nur eines von beiden versetzt ist (Versätze beider, die sich aufheben, zeigen sich nicht), und keine Zeile gibt dieses Moment an.";
    zero_in_the_interval(most) =
        "An offset of torque_nm would appear as external torque. The run excludes one of more than {most} Nm if current_q_a has none, and the interval of the external torque includes it; offsets of both that cancel each other do not show."
        | "Ein Versatz von torque_nm erschiene als äußeres Moment. Mehr als {most} Nm schließt der Lauf aus, wenn current_q_a keinen Versatz hat, und das Intervall des äußeren Moments enthält ihn; Versätze beider, die sich aufheben, zeigen sich nicht.";
    zero_of_torque(torque, current) =
        "torque_nm apparently has an offset of {torque} Nm: the external torque deviates from that of the project by as much, and current_q_a, {current} A beside it, does not contain it. If the project is right, subtract the offset from torque_nm. The motor parameters take it into account; no line states the external torque."
        | "torque_nm hat offenbar einen Versatz von {torque} Nm: um so viel weicht das äußere Moment vom Projekt ab, und current_q_a enthält ihn nicht ({current} A daneben). Stimmt das Projekt, den Versatz von torque_nm abziehen. Die Motorparameter berücksichtigen ihn; keine Zeile gibt das äußere Moment an.";
    about(value) = "about {value}" | "etwa {value}";
    factor_of_convention(factor) = "(exact factor of this convention: {factor})" | "(genauer Faktor dieser Konvention: {factor})";
    unit_row(line, units) =
        "line {line} contains other units than the columns: {units}; convert the values and delete the line"
        | "Zeile {line} enthält andere Einheiten als die der Spalten: {units}; Werte umrechnen und die Zeile löschen";
    unit_with_factor(heading, unit, factor) = "{heading} in {unit}, values times {factor}" | "{heading} in {unit}, Werte mal {factor}";
    too_many_rows(rows, most, seconds) =
        "{rows} rows of the run take more than about {seconds} seconds; by default at most {most} are evaluated: use a shorter part of the run or rows further apart, or state a time limit with --deadline"
        | "{rows} Zeilen des Laufs dauern länger als etwa {seconds} Sekunden; ohne Angabe werden höchstens {most} ausgewertet: einen kürzeren Abschnitt des Laufs oder größere Zeilenabstände verwenden oder mit --deadline eine Zeitgrenze angeben";
    one_way =
        "Motion in one direction only: Coulomb friction and constant torques cannot be separated and are not stated."
        | "Bewegung in nur einer Richtung: Coulomb-Reibung und konstante Momente sind nicht zu trennen und werden nicht angegeben.";
    windows_at_the_limit(count) =
        "In {count} windows the current is at its limit: they are not used for the motor parameters."
        | "In {count} Fenstern liegt der Strom an der Grenze: sie werden für die Motorparameter nicht verwendet.";
    friction_of_the_stated_load =
        "Load, efficiency or stage of this mechanism depend on the position or the direction of power flow: the deviation from the stated load is estimated. The losses of transmission and stage enter with the stated efficiencies, the friction is that without them."
        | "Last, Wirkungsgrad oder Stufe dieser Mechanik hängen von der Position oder der Leistungsrichtung ab: Geschätzt wird die Abweichung von der angegebenen Last. Die Verluste von Übertragung und Stufe gehen mit den angegebenen Wirkungsgraden ein, die Reibung ist die ohne diese Verluste.";
    time_not_rising(line) =
        "line {line}: the time is not later than that of the previous row"
        | "Zeile {line}: die Zeit liegt nicht nach der Zeit der vorigen Zeile";
    taken_as(heading, column, signal) =
        "column \"{heading}\" is taken as {column}, {signal}, and converted from its unit"
        | "Spalte „{heading}“ wird als {column} gelesen, {signal}, und aus ihrer Einheit umgerechnet";
    signal_time = "the time" | "die Zeit";
    signal_position = "the angle of the mechanism, times the ratio of a stage" | "der Winkel der Mechanik, mal der Übersetzung einer Zwischenstufe";
    signal_speed = "the speed of the load at the output of the actuator" | "die Drehzahl der Last am Abtrieb des Antriebs";
    signal_motor_speed =
        "the speed of the motor divided by the ratio" | "die Motordrehzahl geteilt durch die Untersetzung";
    signal_torque = "the torque through the gear at the output" | "das Drehmoment durch das Getriebe am Abtrieb";
    signal_current = "the peak value of i_q" | "der Scheitelwert von i_q";
    columns_of_the_file(columns) = "; the file has {columns}" | "; die Datei hat {columns}";
    headings_to_write(headings) = "; write {headings}" | "; {headings} schreiben";
    heading_instead(heading, written) = "{heading} for {written}" | "{heading} statt {written}";
    heading_with_factor(heading, written, factor) =
        "{heading} for {written}, its values times {factor}" | "{heading} statt {written}, die Werte mal {factor}";
    headings_below(line, before) =
        "; line {line} contains headings of a run: delete lines 1 to {before}, or begin each with #"
        | "; Zeile {line} enthält Überschriften eines Laufs: Zeilen 1 bis {before} löschen oder jede mit # beginnen";
    time_of_day(line, written) =
        "line {line}: {written} in time_s is a date or a time of day: write seconds as numbers, in every row"
        | "Zeile {line}: {written} in time_s ist ein Datum oder eine Uhrzeit: in jeder Zeile Sekunden als Zahl schreiben";
    out_of_range(line, column, value, most) =
        "line {line}: {value} in {column} is out of range, at most ±{most}"
        | "Zeile {line}: {value} in {column} liegt außerhalb des Bereichs, höchstens ±{most}";
    too_coarse(step, most) =
        "the position has steps or noise of {step}°, too coarse for the acceleration of this run: at most {most}°, or faster moves"
        | "die Position hat Stufen oder Rauschen von {step}°, zu grob für die Beschleunigung dieses Laufs: höchstens {most}°, oder schnellere Bewegungen";
    other_motion =
        "the moves of the project carry different payloads or process torques, and the run does not follow them: state the moves of the run in [[motion]], each with its own payload"
        | "die Bewegungen des Projekts haben verschiedene Nutzlasten oder Prozessmomente, und der Lauf folgt ihnen nicht: die Bewegungen des Laufs in [[motion]] angeben, jede mit ihrer Nutzlast";
    ambiguous_motion =
        "the moves of the project carry different payloads or process torques, and the run matches them at several instants of the cycle: let the time of the run start at 0 with the first move"
        | "die Bewegungen des Projekts haben verschiedene Nutzlasten oder Prozessmomente, und der Lauf stimmt ab mehreren Zeitpunkten des Zyklus mit ihnen überein: die Zeit des Laufs mit der ersten Bewegung bei 0 beginnen lassen";
}

/// Returns the reason why a parameter has no estimate.
#[must_use]
pub fn open_reason(open: Open, language: Language) -> String {
    let (en, de) = match open {
        Open::OneDirection => (
            "motion in both directions required, with gravity torque also a larger stroke",
            "Bewegung in beiden Richtungen erforderlich, bei einem Gewichtsmoment auch ein größerer Hub",
        ),
        Open::NotSeparated => (
            "not separable from other parts of the torque in this run; larger strokes and different durations help",
            "in diesem Lauf nicht von anderen Anteilen des Moments zu trennen; größere Hübe und verschiedene Bewegungszeiten helfen",
        ),
        Open::Wide => (
            "the interval exceeds a fifth of the value; more moves, faster moves or less noise help",
            "das Intervall ist größer als ein Fünftel des Werts; mehr oder schnellere Bewegungen oder weniger Rauschen helfen",
        ),
        Open::NotConstant => ("not constant for this mechanism", "bei dieser Mechanik nicht konstant"),
        Open::AtLimit => (
            "too few samples with a current below its limit",
            "zu wenige Abtastwerte mit einem Strom unterhalb der Grenze",
        ),
        Open::Scale => (
            "the run does not exclude current values √2 times too small or too large (rms values): larger loads, or a row spacing below 0.2 ms, narrow the interval of the torque constant",
            "der Lauf schließt Stromwerte nicht aus, die um √2 zu klein oder zu groß sind (Effektivwerte): größere Lasten oder ein Zeilenabstand unter 0,2 ms verkleinern das Intervall der Drehmomentkonstante",
        ),
        Open::Zero => (
            "an offset of torque_nm would be part of it, and this run does not limit that offset",
            "ein Versatz von torque_nm wäre darin enthalten, und dieser Lauf begrenzt ihn nicht",
        ),
    };
    pick(language, en, de).to_owned()
}

/// Returns the heading of the column of a signal.
#[must_use]
pub const fn column_heading(column: Column) -> &'static str {
    match column {
        Column::Time => "time_s",
        Column::Position => "position_rad",
        Column::Speed => "speed_rad_s",
        Column::MotorSpeed => "motor_speed_rad_s",
        Column::Torque => "torque_nm",
        Column::Current => "current_q_a",
    }
}

/// Returns the symptom of another sign or unit convention, with the remedy; `value` is inserted unchanged.
#[must_use]
pub fn doubt(column: Column, misread: Misread, value: &str, language: Language) -> String {
    let (en, de) = match (column, misread) {
        (Column::Torque, Misread::Reversed) => (
            "the inertia becomes negative ({value} kgm²): torque and position have opposite signs; reverse the sign of the torque",
            "das Massenträgheitsmoment wird negativ ({value} kgm²): Moment und Position haben entgegengesetzte Vorzeichen; Vorzeichen des Moments umkehren",
        ),
        (Column::Current, Misread::Reversed) => (
            "the torque constant becomes negative ({value} times that of the table): current and torque have opposite signs; reverse the sign of the current",
            "die Drehmomentkonstante wird negativ (das {value}-Fache der Tabelle): Strom und Moment haben entgegengesetzte Vorzeichen; Vorzeichen des Stroms umkehren",
        ),
        (Column::Position, Misread::Reversed) => (
            "the position counts against motor speed and torque or against the motion of the project: reverse the sign of position_rad",
            "die Position zählt entgegen Motordrehzahl und Moment oder entgegen der Bewegung des Projekts: Vorzeichen von position_rad umkehren",
        ),
        (_, Misread::Reversed) => (
            "{value} times the speed of the position: opposite counting direction (the motor turns opposite to the output); reverse the sign",
            "das {value}-Fache der Drehzahl aus der Position: entgegengesetzte Zählrichtung (der Motor dreht entgegengesetzt zum Abtrieb); Vorzeichen umkehren",
        ),
        (Column::Position, Misread::Degrees) => (
            "apparently degrees, {value} times the radians of the other signals or of the project: multiply positions and speeds in degrees by π/180",
            "offenbar Grad, das {value}-Fache der Radiant anderer Signale oder des Projekts: Positionen und Drehzahlen in Grad mit π/180 multiplizieren",
        ),
        (_, Misread::Degrees) => (
            "{value} times the speed of the position: apparently degrees per second; multiply by π/180",
            "das {value}-Fache der Drehzahl aus der Position: offenbar Grad je Sekunde; mit π/180 multiplizieren",
        ),
        (_, Misread::Turns) => (
            "{value} times the position of the project's motion: apparently revolutions; multiply by 2π",
            "das {value}-Fache der Position in der Bewegung des Projekts: offenbar Umdrehungen; mit 2π multiplizieren",
        ),
        (_, Misread::PerMinute) => (
            "{value} times the speed of the position: apparently revolutions per minute; multiply by 2π/60",
            "das {value}-Fache der Drehzahl aus der Position: offenbar Umdrehungen je Minute; mit 2π/60 multiplizieren",
        ),
        (Column::Torque, Misread::MotorShaft) => (
            "{value} times what project or table give: apparently the torque of the motor shaft; the column is the torque through the gear at the output: multiply torque_nm by i",
            "das {value}-Fache dessen, was Projekt oder Tabelle ergeben: offenbar das Moment der Motorwelle; die Spalte ist das Moment durch das Getriebe am Abtrieb: torque_nm mit i multiplizieren",
        ),
        (Column::Position, Misread::MotorShaft) => (
            "{value} times the position of the project's motion: apparently the angle of the motor shaft; divide by i",
            "das {value}-Fache der Position in der Bewegung des Projekts: offenbar der Winkel der Motorwelle; durch i teilen",
        ),
        (_, Misread::MotorShaft) => (
            "{value} times the speed of the position: not divided by i; divide by i, and where it is negative by −i",
            "das {value}-Fache der Drehzahl aus der Position: nicht durch i geteilt; durch i teilen, bei negativem Wert durch −i",
        ),
        (_, Misread::MotorShaftPerMinute) => (
            "{value} times the speed of the position: apparently revolutions per minute of the motor shaft; multiply by 2π/60 and divide by i, where it is negative by −i",
            "das {value}-Fache der Drehzahl aus der Position: offenbar Umdrehungen je Minute der Motorwelle; mit 2π/60 multiplizieren und durch i teilen, bei negativem Wert durch −i",
        ),
        (Column::Position, Misread::BehindStage) => (
            "{value} times what the motor or the project's motion gives: apparently the position behind the stage; the column is that of the actuator's output: multiply it by the ratio of the stage",
            "das {value}-Fache dessen, was Motor oder Bewegung des Projekts ergeben: offenbar die Position hinter der Stufe; die Spalte ist die am Abtrieb des Antriebs: mit der Übersetzung der Stufe multiplizieren",
        ),
        (_, Misread::BehindStage) => (
            "{value} times the speed of the position: apparently the speed behind the stage; multiply it by the ratio of the stage",
            "das {value}-Fache der Drehzahl aus der Position: offenbar die Drehzahl hinter der Stufe; mit der Übersetzung der Stufe multiplizieren",
        ),
        (_, Misread::Milliseconds) => (
            "{value} times the speed of the position: apparently the time is in milliseconds; divide time_s by 1000",
            "das {value}-Fache der Drehzahl aus der Position: die Zeit steht offenbar in Millisekunden; time_s durch 1000 teilen",
        ),
        (_, Misread::Minutes) => (
            "{value} times the speed of the position: apparently the time is in minutes; multiply time_s by 60",
            "das {value}-Fache der Drehzahl aus der Position: die Zeit steht offenbar in Minuten; time_s mit 60 multiplizieren",
        ),
        (_, Misread::Magnitude) => (
            "never negative, though the other signals require both signs: apparently absolute values; record the signal with its sign",
            "nie negativ, obwohl die anderen Signale beide Vorzeichen verlangen: offenbar Beträge; das Signal mit Vorzeichen aufzeichnen",
        ),
        (_, Misread::Frozen) => (
            "one value over {value} s, in which the axis moves: the signal was not recorded, or its recording stopped",
            "ein einziger Wert über {value} s, in denen sich die Achse bewegt: das Signal wurde nicht oder nicht durchgehend aufgezeichnet",
        ),
        (_, Misread::Doubled) => (
            "the same course as that of another column, {value} times its values: one of both is computed from the other or stands in the wrong column; record each signal itself",
            "derselbe Verlauf wie in einer anderen Spalte, das {value}-Fache ihrer Werte: eines der beiden Signale ist aus dem anderen berechnet oder steht in der falschen Spalte; jedes Signal selbst aufzeichnen",
        ),
        (_, Misread::Outlier) => (
            "single values far from those before and after, the first at {value} s: recording errors; delete these rows",
            "einzelne Werte weit neben den Werten davor und danach, der erste bei {value} s: Fehler der Aufzeichnung; diese Zeilen löschen",
        ),
        (_, Misread::Jump) => (
            "jumps at {value} s from one row to the next: the position was set anew, or rows are missing; use the run before or after it",
            "springt bei {value} s von einer Zeile zur nächsten: die Position wurde neu gesetzt, oder Zeilen fehlen; den Lauf davor oder danach verwenden",
        ),
        (_, Misread::Rms) => (
            "the torque constant is {value} times that of the table, more than motor and gear can give: apparently rms values; the column is the peak value of a phase, √2 times as large",
            "die Drehmomentkonstante ist das {value}-Fache der Tabelle, mehr als Motor und Getriebe geben: offenbar Effektivwerte; die Spalte ist der Scheitelwert eines Strangs, √2-mal so groß",
        ),
        (_, Misread::PowerInvariant) => (
            "the torque constant is {value} times that of the table: apparently i_q of a power-invariant transformation; multiply by √(2/3)",
            "die Drehmomentkonstante ist das {value}-Fache der Tabelle: offenbar i_q einer leistungsinvarianten Transformation; mit √(2/3) multiplizieren",
        ),
        (_, Misread::PeakTwice) => (
            "the torque constant is {value} times that of the table: apparently √2 times the peak value of a phase; divide by √2",
            "die Drehmomentkonstante ist das {value}-Fache der Tabelle: offenbar das √2-Fache des Scheitelwerts eines Strangs; durch √2 teilen",
        ),
        (_, Misread::NewtonCentimetres) => (
            "{value} times what current, payloads and project give: apparently N cm; divide torque_nm by 100",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar N cm; torque_nm durch 100 teilen",
        ),
        (_, Misread::NewtonMillimetres) => (
            "{value} times what current, payloads and project give: apparently N mm (mN m); divide torque_nm by 1000",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar N mm (mN m); torque_nm durch 1000 teilen",
        ),
        (_, Misread::KilonewtonMetres) => (
            "{value} times what current, payloads and project give: apparently kN m; multiply torque_nm by 1000",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar kN m; torque_nm mit 1000 multiplizieren",
        ),
        (_, Misread::PoundForceFeet) => (
            "{value} times what current, payloads and project give: apparently lbf ft; multiply torque_nm by 1.3558",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar lbf ft; torque_nm mit 1,3558 multiplizieren",
        ),
        (_, Misread::PoundForceInches) => (
            "{value} times what current, payloads and project give: apparently lbf in; multiply torque_nm by 0.11298",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar lbf in; torque_nm mit 0,11298 multiplizieren",
        ),
        (_, Misread::OunceForceInches) => (
            "{value} times what current, payloads and project give: apparently ozf in; multiply torque_nm by 0.0070616",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar ozf in; torque_nm mit 0,0070616 multiplizieren",
        ),
        (_, Misread::KilogramForceMetres) => (
            "{value} times what current, payloads and project give: apparently kgf m or a tenth of N m; multiply torque_nm by 9.80665, or by 10",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar kgf m oder ein Zehntel von N m; torque_nm mit 9,80665 oder mit 10 multiplizieren",
        ),
        (_, Misread::KilogramForceCentimetres) => (
            "{value} times what current, payloads and project give: apparently kgf cm or ten times N m; multiply torque_nm by 0.0980665, or by 0.1",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: offenbar kgf cm oder das Zehnfache von N m; torque_nm mit 0,0980665 oder mit 0,1 multiplizieren",
        ),
        (_, Misread::Milliamperes) => (
            "the torque constant is {value} times that of the table: apparently milliamperes; divide current_q_a by 1000",
            "die Drehmomentkonstante ist das {value}-Fache der Tabelle: offenbar Milliampere; current_q_a durch 1000 teilen",
        ),
        (_, Misread::PayloadMissing) => (
            "payloads and process torques of the moves appear with {value} times what the project states: run and [[motion]] contradict each other; state the payload of this run in each [[motion]], none if it ran without",
            "Nutzlasten und Prozessmomente der Bewegungen erscheinen mit dem {value}-Fachen der Angabe des Projekts: Lauf und [[motion]] widersprechen sich; in jedem [[motion]] die Nutzlast dieses Laufs angeben, keine, wenn er ohne Nutzlast war",
        ),
        (_, Misread::PayloadUnstated) => (
            "the load differs from move to move, by up to {value} Nm (rms over a move) beside what the project states: payloads or process torques of this run, to be stated in each [[motion]], or an efficiency that differs from the stated one",
            "die Last unterscheidet sich von Bewegung zu Bewegung, um bis zu {value} Nm (Effektivwert über eine Bewegung) neben den Angaben des Projekts: Nutzlasten oder Prozessmomente dieses Laufs, in jedem [[motion]] anzugeben, oder ein anderer Wirkungsgrad als der angegebene",
        ),
        (Column::Torque, Misread::Other) => (
            "{value} times what current, payloads and project give: another unit or scale; divide torque_nm by this factor",
            "das {value}-Fache dessen, was Strom, Nutzlasten und Projekt ergeben: eine andere Einheit oder ein anderer Maßstab; torque_nm durch diesen Faktor teilen",
        ),
        (_, Misread::GravityOpposite) => (
            "the direction of the weight deviates by {value}° from that of the project: opposite counting direction or another zero of the position, or wrong start_angle, inclination or sign of the external torque in the project",
            "die Richtung des Gewichts weicht um {value}° von der des Projekts ab: entgegengesetzte Zählrichtung oder anderer Nullpunkt der Position, oder start_angle, Neigung oder Vorzeichen des äußeren Moments im Projekt sind falsch",
        ),
        (_, Misread::TimeStamps) => (
            "the time stamps scatter by {value} ms (standard deviation) about equal intervals, and no signal shows whether the rows were sampled at the stamps or evenly spaced: record time_s with the clock that samples the signals, or write equal intervals if it samples evenly",
            "die Zeitstempel streuen um {value} ms (Standardabweichung) um gleiche Abstände, und kein Signal zeigt, ob die Zeilen zu den Zeitstempeln oder in gleichen Abständen abgetastet sind: time_s mit dem Takt aufzeichnen, der die Signale abtastet, oder gleiche Abstände schreiben, wenn er gleichmäßig abtastet",
        ),
        (Column::Current, Misread::NegativeFriction) => (
            "motor and gear have a negative friction ({value} A): another sign or scale of the current, or a delay that varies",
            "Motor und Getriebe haben eine negative Reibung ({value} A): ein anderes Vorzeichen, ein anderer Maßstab oder eine schwankende Verzögerung des Stroms",
        ),
        (_, Misread::NegativeFriction) => (
            "the load has a negative friction ({value} Nm): another sign of the torque, or a delay that varies",
            "die Last hat eine negative Reibung ({value} Nm): ein anderes Vorzeichen oder eine schwankende Verzögerung des Moments",
        ),
        (Column::Current, _) => (
            "the torque constant is {value} times that of the table: another scale of current or torque, or another actuator",
            "die Drehmomentkonstante ist das {value}-Fache der Tabelle: ein anderer Maßstab von Strom oder Moment, oder ein anderer Antrieb",
        ),
        _ => (
            "{value} times what the position gives: another unit, scale or side",
            "das {value}-Fache dessen, was die Position ergibt: andere Einheit, anderer Maßstab oder andere Seite",
        ),
    };
    format!("{}: {}", column_heading(column), pick(language, en, de).replace("{value}", value))
}
