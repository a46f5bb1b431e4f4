//! Words for the assumptions made where the project states nothing.

use crate::pick;
use crate::recorded_samples::{self, figure};
use crate::texts::said;
use crate::{about_text, short_label};
use axis::{Assumption, Overrun, WindowEnd};
use motion::{Alternating, MadeUp, Remark, SlowMotion, Spline, Spurious, SteppedColumn};
use project::{KeyDefault, key_at};
use quantities::unit::{
    DEGREE, MILLIMETRE, MILLISECOND, NEWTON_METRE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND,
};
use quantities::{Language, format_number, format_significant, with_symbol};

/// Returns a default that the user did not confirm, as text.
#[must_use]
pub fn assumption_text(assumption: Assumption, language: Language) -> String {
    let (en, de) = match assumption {
        Assumption::RecordedRest(noise) => {
            let (speed, place, time) = (
                figure(noise.speed_rad_s, &REVOLUTION_PER_MINUTE, language),
                figure(noise.place_rad, &DEGREE, language),
                figure(noise.duration_s, &SECOND, language),
            );
            return said!(language =>
                "standstill is assumed (motion.standstill) where the recording shows noise or settling only, speeds up to {speed} within {place}, {time} in total: no friction acts there; if the axis moves there, state standstill = \"1e-9 1/min\""
                | "Stillstand angesetzt (motion.standstill), wo die Aufzeichnung nur Rauschen oder Einschwingen zeigt, Drehzahlen bis {speed} innerhalb von {place}, insgesamt {time}: dort keine Reibung; bewegt sich die Achse dort, standstill = \"1e-9 1/min\" angeben"
            );
        }
        Assumption::OfTemplate(figure) => {
            let path = figure.path;
            let value = figure.value.replace('.', language.decimal_mark().encode_utf8(&mut [0; 4]));
            let label = key_at(path).map(|key| short_label(about_text(key.about, language))).unwrap_or_default();
            return said!(language =>
                "{label}: {value} is a figure of the template, not stated ({path})"
                | "{label}: {value} ist eine Angabe der Vorlage, nicht bestätigt ({path})"
            );
        }
        Assumption::RecordedSlow(slow) => return slow_text(&slow, language),
        Assumption::RecordedAlternating(alternating) => return alternating_text(&alternating, language),
        Assumption::RecordedWindow(end) => return window_text(&end, language),
        Assumption::RecordedKey(remark) => return key_text(remark, language),
        Assumption::Motionless(segment, hidden_rad_s) => return motionless_text(segment, hidden_rad_s, language),
        Assumption::Overruns(overrun) => return overrun_text(&overrun, language),
        Assumption::RecordedTorqueNoise(deviation_nm) => return recorded_samples::torque_noise(deviation_nm, language),
        Assumption::RecordedOutliers(outliers) => return recorded_samples::outliers(&outliers, language),
        Assumption::RecordedSparse(sparse) => return recorded_samples::sparse(sparse, language),
        Assumption::RecordedSteps(made_up, torque) => return spurious_text(&made_up, torque, language),
        Assumption::SplineThroughPoints(Spline::Cubic) => (
            "a cubic spline goes through the points of the cam table: the acceleration is continuous there (C²), the jerk is discontinuous; at the ends the acceleration may be discontinuous",
            "Kurventabelle mit kubischem Spline interpoliert: die Beschleunigung ist an den Stützpunkten stetig (C²), der Ruck unstetig; an den Enden kann die Beschleunigung springen",
        ),
        Assumption::SplineThroughPoints(Spline::Quintic) => (
            "a spline of the fifth degree goes through the points of the cam table: jerk and its derivative are continuous there (C⁴); at the ends the jerk may be discontinuous",
            "Kurventabelle mit Spline fünften Grades interpoliert: Ruck und Ruckableitung sind an den Stützpunkten stetig (C⁴); an den Enden kann der Ruck springen",
        ),
        Assumption::Default(KeyDefault::NoFriction) => {
            ("no friction torque given: 0 Nm assumed", "kein Reibmoment angegeben: 0 Nm angenommen")
        }
        Assumption::Default(KeyDefault::AmbientWithinRange) => (
            "no ambient temperature given: heating computed for the highest permissible one (CHA: 40 °C), cold gear friction for 30 °C; colder starts are not covered",
            "keine Umgebungstemperatur angegeben: Erwärmung für die höchste zulässige (CHA: 40 °C) gerechnet, Reibung des kalten Getriebes für 30 °C; kältere Starts sind nicht abgedeckt",
        ),
        Assumption::ConditionsWithinRange => (
            "conditions of use that are not stated: assumed within those of the manufacturer (CHA: table 13.2)",
            "nicht angegebene Einsatzbedingungen: innerhalb der Herstellerangaben angenommen (CHA: Tabelle 13.2)",
        ),
        Assumption::CoolingPlate => (
            "mounted on the aluminium plate of table 13.3: the continuous-duty data are valid for this plate only",
            "Montage auf der Aluminiumplatte nach Tabelle 13.3: nur dafür gelten die Dauerbetriebsdaten",
        ),
        Assumption::Default(KeyDefault::ModulationReserve) => (
            "the drive provides 90 % of U_DC/√2 at the motor terminals (requirements.modulation_reserve)",
            "der Servoregler stellt an den Motorklemmen 90 % von U_DC/√2 bereit (requirements.modulation_reserve)",
        ),
        Assumption::Default(KeyDefault::NoSupply) => (
            "no voltage given, neither that of the DC link (requirements.supply) nor that of the mains (requirements.mains): the terminal voltage is not checked",
            "keine Spannung angegeben, weder die des Zwischenkreises (requirements.supply) noch die des Netzes (requirements.mains): die Klemmenspannung wird nicht geprüft",
        ),
        Assumption::Rectifier => (
            "the DC link is fed by an uncontrolled three-phase rectifier: 1.35 times the lowest mains voltage under load, √2 times the highest at no load",
            "Zwischenkreis mit ungesteuertem Drehstromgleichrichter gespeist: unter Last das 1,35-Fache der niedrigsten, im Leerlauf das √2-Fache der höchsten Netzspannung",
        ),
        Assumption::RectifierAndDeviation => (
            "the mains voltage varies by ± 10 % (requirements.mains_deviation), and the DC link is fed by an uncontrolled three-phase rectifier: 1.35 times the lowest mains voltage under load, √2 times the highest at no load",
            "Netzspannung ± 10 % (requirements.mains_deviation), Zwischenkreis mit ungesteuertem Drehstromgleichrichter gespeist: unter Last das 1,35-Fache der niedrigsten, im Leerlauf das √2-Fache der höchsten Netzspannung",
        ),
        Assumption::SinglePhaseRectifier => (
            "the DC link is fed by an uncontrolled single-phase rectifier: 0.90 times the lowest mains voltage under load, the mean of the rectified voltage (a capacitor raises it: state that voltage as requirements.supply), √2 times the highest at no load",
            "Zwischenkreis mit ungesteuertem Einphasengleichrichter gespeist: unter Last das 0,90-Fache der niedrigsten Netzspannung, der Gleichrichtwert (ein Kondensator hebt ihn an: diese Spannung als requirements.supply angeben), im Leerlauf das √2-Fache der höchsten",
        ),
        Assumption::SinglePhaseRectifierAndDeviation => (
            "the mains voltage varies by ± 10 % (requirements.mains_deviation), and the DC link is fed by an uncontrolled single-phase rectifier: 0.90 times the lowest mains voltage under load, the mean of the rectified voltage (a capacitor raises it: state that voltage as requirements.supply), √2 times the highest at no load",
            "Netzspannung ± 10 % (requirements.mains_deviation), Zwischenkreis mit ungesteuertem Einphasengleichrichter gespeist: unter Last das 0,90-Fache der niedrigsten Netzspannung, der Gleichrichtwert (ein Kondensator hebt ihn an: diese Spannung als requirements.supply angeben), im Leerlauf das √2-Fache der höchsten",
        ),
        Assumption::OwnStallCurrentIncludesFriction => (
            "I_0 of the own actuator taken to include its no-load starting current I_NLS",
            "I_0 des eigenen Antriebs enthält den lastfreien Anlaufstrom I_NLS",
        ),
        Assumption::OwnStallTorqueAboveLargest => (
            "stall torque T_0 of the own actuator above its T_max: taken as the heat limit of the motor alone; T_max limits every torque",
            "Stillstandsdrehmoment T_0 des eigenen Antriebs größer als T_max: als Erwärmungsgrenze des Motors angesetzt, jedes Drehmoment ist durch T_max begrenzt",
        ),
        Assumption::OwnStallCurrentAboveLargest => (
            "stall current I_0 of the own actuator above its I_max: taken as the heat limit of the motor alone; I_max limits every current",
            "Stillstandsstrom I_0 des eigenen Antriebs größer als I_max: als Erwärmungsgrenze des Motors angesetzt, jeder Strom ist durch I_max begrenzt",
        ),
        Assumption::OwnRatedSpeedAboveLargest => (
            "rated speed n_N of the own actuator's motor above its largest speed n_mot,max: taken as that of the motor alone; n_mot,max limits every speed",
            "Bemessungsdrehzahl n_N des eigenen Antriebs größer als n_mot,max: als die des Motors allein angesetzt, jede Drehzahl ist durch n_mot,max begrenzt",
        ),
        Assumption::NoFlangeLoads => (
            "no loads on the flange are known: the output bearing is not checked",
            "keine Lasten am Flansch bekannt: das Abtriebslager wird nicht geprüft",
        ),
        Assumption::FlangeMomentsAligned => (
            "moments of radial and axial force on the flange assumed to act in the same direction",
            "Momente aus Radial- und Axialkraft am Flansch gleichgerichtet angesetzt",
        ),
        Assumption::Default(KeyDefault::NoLosses) => (
            "no efficiency of the mechanism given: 1 assumed",
            "kein Wirkungsgrad der Mechanik angegeben: 1 angenommen",
        ),
        Assumption::Default(KeyDefault::LossesDoNotHelp) => (
            "no efficiency for a driving load given (efficiency_back): while the load drives, the losses are not counted as braking torque",
            "kein Wirkungsgrad für die treibende Last angegeben (efficiency_back): bei treibender Last wird keine bremsende Wirkung der Verluste angesetzt",
        ),
        Assumption::Default(KeyDefault::TravelHorizontal) => (
            "no inclination of the travel given (inclination): horizontal, without the weight of the load along it",
            "keine Neigung des Verfahrwegs angegeben (inclination): waagerecht, ohne Gewichtskraft in Bewegungsrichtung",
        ),
        Assumption::Default(KeyDefault::GroundHorizontal) => (
            "no inclination of the ground link given (inclination): horizontal",
            "keine Neigung des Gestells angegeben (inclination): waagerecht",
        ),
        Assumption::Default(KeyDefault::AxisVertical) => (
            "no tilt of the axis of rotation given (axis_tilt): vertical, without a torque of gravity",
            "keine Neigung der Drehachse angegeben (axis_tilt): senkrecht, ohne Gewichtsmoment",
        ),
        Assumption::Default(KeyDefault::PartsWithoutInertia) => (
            "no inertia of the rotating parts of the mechanism given (inertia): 0 assumed",
            "kein Massenträgheitsmoment der drehenden Teile der Mechanik angegeben (inertia): 0 angenommen",
        ),
        Assumption::Default(KeyDefault::RopeWeightless) => {
            ("no mass of the rope given (rope_mass): 0 assumed", "keine Seilmasse angegeben (rope_mass): 0 angenommen")
        }
        Assumption::Default(KeyDefault::SheavesNoLosses) => (
            "no efficiency of the rope sheaves given (sheave_efficiency): 1 assumed",
            "kein Wirkungsgrad der Seilrollen angegeben (sheave_efficiency): 1 angenommen",
        ),
        Assumption::Default(KeyDefault::ArmsWeightless) => (
            "no mass of the arms given (arm_mass): 0 assumed",
            "keine Masse der Arme angegeben (arm_mass): 0 angenommen",
        ),
        Assumption::Default(KeyDefault::CouplerWeightless) => (
            "no mass of the coupler given (coupler_mass): 0 assumed",
            "keine Masse der Koppel angegeben (coupler_mass): 0 angenommen",
        ),
        Assumption::Default(KeyDefault::RockerWeightless) => (
            "no mass of the rocker given (rocker_mass): 0 assumed",
            "keine Masse der Schwinge angegeben (rocker_mass): 0 angenommen",
        ),
        Assumption::Default(KeyDefault::AxisLevel) => (
            "no tilt of the axis of rotation given (axis_tilt): horizontal, with the full gravity torque",
            "keine Neigung der Drehachse angegeben (axis_tilt): waagerecht, das Gewicht wirkt voll quer zur Achse",
        ),
        Assumption::Default(KeyDefault::StartsAtZero) => (
            "no position at the beginning of the motion given (start_angle): 0°, or the first position of a recording or cam table",
            "keine Position zu Beginn der Bewegung angegeben (start_angle): 0° oder die erste Position einer Aufzeichnung oder Kurventabelle",
        ),
        Assumption::Default(KeyDefault::WindsUp) => (
            "no direction of winding given (winding): a positive rotation winds up",
            "keine Wickelrichtung angegeben (winding): positive Drehung wickelt auf",
        ),
        Assumption::Default(KeyDefault::RollToWind) => (
            "no diameter at position zero given (start_diameter): the core when winding up, the full roll when unwinding",
            "kein Durchmesser in Nullposition angegeben (start_diameter): beim Aufwickeln die Hülse, beim Abwickeln der volle Wickel",
        ),
        Assumption::Default(KeyDefault::OneScissor) => (
            "no number of scissor stages given (stages): 1 assumed",
            "keine Anzahl der Scherenpaare angegeben (stages): 1 angenommen",
        ),
        Assumption::LawOpen => (
            "motion law not decided: polynomial 3-4-5, without a jump of the acceleration",
            "Bewegungsgesetz nicht festgelegt: Polynom 3-4-5, ohne Beschleunigungssprung",
        ),
        Assumption::OneRevolution => (
            "neither duration nor distance of a constant speed given (time, distance): one revolution",
            "weder Dauer noch Weg einer konstanten Drehzahl angegeben (time, distance): eine Umdrehung",
        ),
        Assumption::WebRamps => (
            "no time given for accelerating or braking the web (accelerate, brake): 10 s each assumed",
            "keine Zeit zum Beschleunigen oder Bremsen der Bahn angegeben (accelerate, brake): je 10 s angenommen",
        ),
        Assumption::TrapezoidThirds => (
            "a trapezoid given by two quantities is split into thirds: acceleration, constant speed and deceleration",
            "Trapez aus zwei Angaben: je ein Drittel der Zeit für Beschleunigen, Konstantfahrt und Bremsen",
        ),
        Assumption::SingleMoveRepeats => (
            "the single move is evaluated as if it were repeated without a pause, which is conservative for the rms torque",
            "die einmalige Bewegung wird wie eine ohne Pause wiederholte gerechnet; für das effektive Drehmoment liegt das auf der sicheren Seite",
        ),
        Assumption::Default(KeyDefault::OrdinaryApplication) => (
            "no field of application that requires the manufacturer's approval (section 2.4)",
            "kein Anwendungsbereich, der eine Freigabe des Herstellers erfordert (Abschnitt 2.4)",
        ),
        Assumption::UniformTolerances => (
            "each quantity with a tolerance is uniformly distributed within its band, independent of the others",
            "jede Größe mit Toleranz ist in ihrem Toleranzband gleichverteilt, unabhängig von den anderen",
        ),
        Assumption::Default(KeyDefault::MotorHolds) => (
            "no means of holding stated for standstill (motion.hold): the motor holds the load",
            "keine Angabe zum Halten im Stillstand (motion.hold): der Motor hält die Last",
        ),
        Assumption::PayloadTowardsCentre => (
            "the payload of a segment lies in the direction of the common centre of mass of the bodies (of balanced bodies at start_angle), at payload_distance",
            "die Nutzlast eines Abschnitts liegt in Richtung des gemeinsamen Schwerpunkts der Körper (bei ausgewuchteten Körpern bei start_angle), im Abstand payload_distance",
        ),
        Assumption::ArmIsRod => (
            "shape of the arm not stated (mechanism.arm.shape): a uniform rod of the stated length",
            "keine Form des Arms angegeben (mechanism.arm.shape): gleichmäßiger Stab der angegebenen Länge",
        ),
        Assumption::PayloadAtArmEnd => (
            "distance of the payload not stated (mechanism.arm.payload_distance): at the end of the arm",
            "kein Abstand der Nutzlast angegeben (mechanism.arm.payload_distance): am Ende des Arms",
        ),
        Assumption::RecordedTorqueAdds => (
            "the recorded torque is a process torque; it is added to the torque of inertia, gravity and friction of the mechanism",
            "das aufgezeichnete Moment ist ein Prozessmoment; die Momente aus Trägheit, Gewicht und Reibung der Mechanik kommen hinzu",
        ),
        Assumption::RecordedAtOutput => (
            "recorded angles, speeds and torques are those at the output of the actuator (motion.recorded_ratio is not stated), with a stage at the output of the stage, positive in the direction of the axis",
            "aufgezeichnete Winkel, Drehzahlen und Momente gelten am Abtrieb (motion.recorded_ratio nicht angegeben), bei einer Zwischenstufe an deren Abtrieb, positiv in der Richtung der Achse",
        ),
        Assumption::RecordedTurnsAlike => (
            "the recorded shaft turns in the direction of the output (motion.recorded_ratio is positive); if the recorded gear turns the other way, as a strain wave gear does, and the drive does not invert the sign, the ratio is negative",
            "die aufgezeichnete Welle dreht im Sinn des Abtriebs (motion.recorded_ratio positiv); kehrt das aufgezeichnete Getriebe die Drehrichtung um, wie ein Wellgetriebe, und der Servoregler nicht das Vorzeichen, ist die Übersetzung negativ",
        ),
        Assumption::RecordedTorqueOfMotor => (
            "inertia and friction of the recorded motor and gear are not removed from the torque recorded at the motor (motion.recorded_ratio); those of the actuator are added",
            "Trägheit und Reibung des aufgezeichneten Motors und Getriebes sind im motorseitig aufgezeichneten Moment (motion.recorded_ratio) enthalten; die des Antriebs kommen hinzu",
        ),
        Assumption::RecordedPositionDifferentiated => (
            "speed and acceleration are difference quotients of the recorded position, without smoothing: noise in the position increases the computed torque",
            "Drehzahl und Beschleunigung sind ungeglättete Differenzenquotienten der aufgezeichneten Position: deren Rauschen erhöht das berechnete Moment",
        ),
        Assumption::RecordedModulo => (
            "the recorded position starts again after one revolution (modulo axis): continuous rotation is assumed, the jumps of 360° are removed",
            "die aufgezeichnete Position beginnt nach einer Umdrehung von vorn (Moduloachse): die Achse dreht weiter, die Sprünge um 360° sind herausgerechnet",
        ),
        Assumption::FlangeLoadsConstant => (
            "the stated loads on the flange are the complete loads, constant over the cycle, moments of radial and axial force in the same direction",
            "die angegebenen Flanschlasten sind die gesamten Lasten, über den Zyklus konstant, Momente aus Radial- und Axialkraft gleichgerichtet",
        ),
        Assumption::FlangeLoadsOfMechanism => (
            "loads on the flange are computed at every instant from masses, motion and process forces of the mechanism",
            "die Flanschlasten werden zu jedem Zeitpunkt aus Massen, Bewegung und Prozesskräften der Mechanik berechnet",
        ),
        Assumption::FlangeLoadsAddUp => (
            "loads stated for the flange are added to those of the mechanism in the worst case: all in the same direction",
            "angegebene Flanschlasten werden im ungünstigsten Fall zu denen der Mechanik addiert: alle gleichgerichtet",
        ),
        Assumption::FlangeLoadsIgnored => (
            "weight, motion and process forces of the mechanism are not taken into account at the flange, as the project states (bearing.mechanism = \"ignore\")",
            "Gewicht, Bewegung und Prozesskräfte der Mechanik werden am Flansch nicht berücksichtigt, wie im Projekt angegeben (bearing.mechanism = \"ignore\")",
        ),
        Assumption::FlangeLoadsReplaced => (
            "in a segment that states loads on the flange, these take the place of those of the mechanism (bearing.mechanism = \"replace\")",
            "in einem Abschnitt mit eigenen Lasten am Flansch treten diese an die Stelle derer aus der Mechanik (bearing.mechanism = \"replace\")",
        ),
        Assumption::Default(KeyDefault::FlangeBearsAll) => (
            "no share of the flange in the loads given (bearing.flange_share): the flange carries the full loads of the mechanism",
            "kein Lastanteil des Flansches angegeben (bearing.flange_share): der Flansch nimmt die Lasten der Mechanik vollständig auf",
        ),
        Assumption::FlangeBodiesFlat => (
            "the masses on the flange have no products of inertia (dynamically balanced)",
            "die Massen am Flansch haben keine Deviationsmomente (dynamisch ausgewuchtet)",
        ),
        Assumption::FlangeUpwards => (
            "no tilt of the axis given (axis_tilt): the flange faces upwards",
            "keine Neigung der Achse angegeben (axis_tilt): der Flansch zeigt nach oben",
        ),
        Assumption::NoPayloadInDwell => (
            "dwell without a stated payload after a move with one: computed without payload; if the payload stays, state it in the dwell too (motion.payload)",
            "Rast ohne angegebene Nutzlast nach einer Bewegung mit Nutzlast: ohne Nutzlast gerechnet; bleibt die Nutzlast, ist sie auch in der Rast anzugeben (motion.payload)",
        ),
        Assumption::PayloadInertiaWeightless => (
            "the moment of inertia of the payload (payload_inertia) adds no weight to the flange loads",
            "das Massenträgheitsmoment der Nutzlast (payload_inertia) geht nicht als Gewicht in die Flanschlasten ein",
        ),
        Assumption::Default(KeyDefault::WheelWeightless) => (
            "no mass of pulley, pinion or crank given (bearing.wheel_mass): parts rotating with the flange are assumed to have no mass",
            "keine Masse von Scheibe, Ritzel oder Kurbel angegeben (bearing.wheel_mass): die mit dem Flansch umlaufenden Teile werden masselos angesetzt",
        ),
        Assumption::Default(KeyDefault::SpurTeeth) => (
            "no helix angle given (bearing.helix_angle): spur teeth",
            "kein Schrägungswinkel angegeben (bearing.helix_angle): Geradverzahnung",
        ),
        Assumption::Default(KeyDefault::StageNoLosses) => (
            "no efficiency of the stage given: 1 assumed",
            "kein Wirkungsgrad der Zwischenstufe angegeben: 1 angenommen",
        ),
        Assumption::Default(KeyDefault::StageLossesDoNotHelp) => (
            "no efficiency of the stage for a driving mechanism given (stage.efficiency_back): while the mechanism drives, the losses of the stage are not counted as braking torque",
            "kein Wirkungsgrad der Stufe für die treibende Mechanik angegeben (stage.efficiency_back): bei treibender Mechanik wird keine bremsende Wirkung der Stufenverluste angesetzt",
        ),
        Assumption::Default(KeyDefault::StageWithoutInertia) => (
            "no inertia of the stage given: 0 kgm² assumed",
            "keine Massenträgheit der Stufe angegeben: 0 kgm² angenommen",
        ),
        Assumption::Default(KeyDefault::StageRigid) => (
            "no stiffness of the stage given (stage.stiffness): the stage is rigid",
            "keine Steifigkeit der Stufe angegeben (stage.stiffness): die Stufe ist starr",
        ),
        Assumption::Default(KeyDefault::StageNoBacklash) => (
            "no backlash of the stage given (stage.backlash): the stage has no backlash",
            "kein Spiel der Stufe angegeben (stage.backlash): die Stufe hat kein Spiel",
        ),
        Assumption::StageRatioChosen(ratio) => {
            let ratio = format_significant(ratio, 4, language);
            return said!(language =>
                "ratio of the stage {ratio}: of the stated ones (stage.ratios) that with the best actuator of the catalogue; for another actuator state stage.ratio"
                | "Übersetzung der Stufe {ratio}: von den angegebenen (stage.ratios) die mit dem besten Antrieb des Katalogs; für einen anderen Antrieb stage.ratio angeben"
            );
        }
        Assumption::MechanismOnOwnBearings => (
            "with a stage the mechanism has its own bearings: the flange carries the loads of the stage only",
            "mit Zwischenstufe ist die Mechanik eigens gelagert: der Flansch nimmt nur die Kräfte der Stufe auf",
        ),
    };
    pick(language, en, de).to_owned()
}

/// Returns the value of `standstill` in a line of a project file that sets speeds up to this one to zero.
fn standstill_above(speed_rad_s: f64) -> String {
    // A line of the project file has a decimal point; rounded up, so that the noise remains below.
    let speed = REVOLUTION_PER_MINUTE.from_si(speed_rad_s);
    let digit = 10_f64.powi(speed.log10().floor() as i32 - 1);
    format_significant(((speed / digit).floor() + 1.0) * digit, 2, Language::En)
}

/// Returns the remark on a slow motion between the moves, with the key that makes it rest.
fn slow_text(slow: &SlowMotion, language: Language) -> String {
    let (speed, place, time) = (
        figure(slow.speed_rad_s, &REVOLUTION_PER_MINUTE, language),
        figure(slow.place_rad, &DEGREE, language),
        figure(slow.duration_s, &SECOND, language),
    );
    let key = standstill_above(slow.speed_rad_s);
    said!(language =>
        "for {time} the recorded axis moves by up to {place} only, at up to {speed}: this counts as motion with friction; if the axis is at rest there, state standstill = \"{key} 1/min\""
        | "die aufgezeichnete Achse bewegt sich über {time} nur um bis zu {place}, mit bis zu {speed}: das zählt als Bewegung mit Reibung; steht die Achse dort, standstill = \"{key} 1/min\" angeben"
    )
}

/// Returns the remark on an end of the part of a recording in use that lies beside the samples.
fn window_text(end: &WindowEnd, language: Language) -> String {
    // As many digits as show the difference.
    let apart = 0.01 * (end.stated_s - end.used_s).abs();
    let of = |value: f64| {
        let off = |digits: usize| (format!("{value:.digits$}").parse::<f64>().unwrap_or(0.0) - value).abs();
        let digits = (0..12).find(|digits| off(*digits) <= apart).unwrap_or(12);
        with_symbol(&format_number(value, digits, language), SECOND.symbol_in(language))
    };
    let (stated, used) = (of(end.stated_s), of(end.used_s));
    if end.is_start {
        said!(language =>
            "the recording has no sample at from = {stated}: it is used from its next sample on, at {used}"
            | "die Aufzeichnung hat bei from = {stated} keinen Abtastwert: sie gilt ab dem nächsten, bei {used}"
        )
    } else {
        said!(language =>
            "the recording has no sample at to = {stated}: it is used up to its last sample before, at {used}"
            | "die Aufzeichnung hat bei to = {stated} keinen Abtastwert: sie gilt bis zum letzten davor, bei {used}"
        )
    }
}

/// Returns the remark on speeds that change their sign from sample to sample, with the key that makes them rest.
fn alternating_text(alternating: &Alternating, language: Language) -> String {
    let share = format_number(100.0 * alternating.share, 0, language);
    let below = figure(alternating.speed_rad_s, &REVOLUTION_PER_MINUTE, language);
    let key = standstill_above(alternating.speed_rad_s);
    said!(language =>
        "{share} % of the recorded speeds, up to {below}, have another sign than the samples before and after them: they count as motion with friction of alternating direction; if the axis is at rest there, state standstill = \"{key} 1/min\""
        | "{share} % der aufgezeichneten Drehzahlen, bis {below}, haben ein anderes Vorzeichen als die Werte davor und dahinter: sie zählen als Bewegung mit wechselnder Reibung; steht die Achse dort, standstill = \"{key} 1/min\" angeben"
    )
}

/// Returns the remark on a key of a recording that does not do what it is stated for.
fn key_text(remark: Remark, language: Language) -> String {
    match remark {
        Remark::NotHeld => said!(language =>
            "held_values = \"interpolate\" is stated, but no recorded column holds its values over several rows: the values are used as they are"
            | "held_values = \"interpolate\" ist angegeben, aber keine aufgezeichnete Spalte hält ihre Werte über mehrere Zeilen: die Werte werden unverändert verwendet"
        ),
        Remark::EvenAlready => said!(language =>
            "time_stamps = \"even\" is stated, but the rows are evenly spaced by their time stamps: the key changes nothing"
            | "time_stamps = \"even\" ist angegeben, die Zeitstempel haben aber bereits gleiche Abstände: die Angabe ändert nichts"
        ),
        Remark::FollowsStamps => said!(language =>
            "time_stamps = \"even\" is stated, but the recorded signal follows the time stamps of the file: they are correct, and without the key they are used"
            | "time_stamps = \"even\" ist angegeben, das aufgezeichnete Signal folgt aber den Zeitstempeln der Datei: sie sind richtig und gelten ohne die Angabe"
        ),
        Remark::StandstillSteps { speed_rad_s, acceleration_rad_s2, without_rad_s2 } => {
            let speed = figure(speed_rad_s, &REVOLUTION_PER_MINUTE, language);
            let of = |si: f64| figure(si, &RADIAN_PER_SECOND_SQUARED, language);
            let (with, without) = (of(acceleration_rad_s2), of(without_rad_s2));
            said!(language =>
                "the stated standstill of {speed} contains speeds of the motion: the axis stops in a step, with accelerations of up to {with} instead of {without}; a smaller value avoids this"
                | "die angegebene Grenze des Stillstands von {speed} umfasst Drehzahlen der Bewegung: die Achse hält sprunghaft an, mit Beschleunigungen bis {with} statt {without}; ein kleinerer Wert vermeidet das"
            )
        }
    }
}

/// Returns the remark on a recording or a cam table that does not move.
fn motionless_text(segment: usize, hidden_rad_s: f64, language: Language) -> String {
    if hidden_rad_s > 0.0 {
        let speed = figure(hidden_rad_s, &REVOLUTION_PER_MINUTE, language);
        return said!(language =>
            "motion[{segment}]: the stated standstill is above the largest recorded speed, {speed}: the whole recording counts as standstill, and only the torque at standstill is evaluated"
            | "motion[{segment}]: die angegebene Grenze des Stillstands liegt über der größten aufgezeichneten Drehzahl, {speed}: die ganze Aufzeichnung gilt als Stillstand, bewertet wird nur das Drehmoment im Stillstand"
        );
    }
    said!(language =>
        "motion[{segment}]: the axis does not move in this segment: only the torque at standstill is evaluated"
        | "motion[{segment}]: die Achse bewegt sich in diesem Abschnitt nicht: bewertet wird nur das Drehmoment im Stillstand"
    )
}

/// Returns the remark on a move that is shorter than its change of speed, with the distance of the plain change.
fn overrun_text(overrun: &Overrun, language: Language) -> String {
    let (unit, factor, key_unit) = match overrun.travel_m_per_rad {
        Some(travel) => (&MILLIMETRE, travel, "mm"),
        None => (&DEGREE, 1.0, "deg"),
    };
    // As many digits as make the change of speed of the file a plain one.
    let of = |rad: f64, language: Language| {
        let value = unit.from_si(rad * factor);
        let off = |digits: usize| (format!("{value:.digits$}").parse::<f64>().unwrap_or(0.0) - value).abs();
        let digits = (0..12).find(|digits| off(*digits) <= 2e-10 * value.abs()).unwrap_or(12);
        format_number(value, digits, language)
    };
    let (stated, plain) = (overrun.stated_rad, overrun.plain_rad);
    let (stated, plain) = (of(stated, language) + " " + unit.symbol, of(plain, language) + " " + unit.symbol);
    let segment = overrun.segment;
    // A line of the project file has a plain minus sign.
    let key = of(overrun.plain_rad, Language::En).replace('−', "-") + " " + key_unit;
    let change = if overrun.travel_m_per_rad.is_some() { "Geschwindigkeitsänderung" } else { "Drehzahländerung" };
    said!(language =>
        "segment {segment} covers {stated}, its change of speed alone takes {plain} at the stated acceleration: the axis makes up for the difference with a movement to and fro; distance = \"{key}\" is the plain change of speed"
        | "Abschnitt {segment} ist {stated} lang, seine {change} allein erfordert mit der angegebenen Beschleunigung {plain}: die Achse gleicht den Unterschied durch eine Hin- und Herbewegung aus; distance = \"{key}\" ergibt die einfache {change}"
    )
}

/// Returns the remark on an acceleration caused by the resolution of a column in value or time, with the remedy.
fn spurious_text(made_up: &MadeUp, torque_nm: f64, language: Language) -> String {
    let interval = figure(made_up.interval_s, &MILLISECOND, language);
    let of = |si: f64| figure(si, &RADIAN_PER_SECOND_SQUARED, language);
    let (alone, motion) = (of(made_up.acceleration_rad_s2), of(made_up.motion_rad_s2));
    let torque = figure(torque_nm, &NEWTON_METRE, language);
    let column = match made_up.column {
        SteppedColumn::Position => said!(language => "position" | "Position"),
        SteppedColumn::Speed => said!(language => "speed" | "Drehzahl"),
    };
    match made_up.cause {
        Spurious::Steps { step, smoothing_s } => {
            let step = match made_up.column {
                SteppedColumn::Position => figure(step, &DEGREE, language),
                SteppedColumn::Speed => figure(step, &REVOLUTION_PER_MINUTE, language),
            };
            let remedy = smoothing_text(smoothing_s, made_up.column, language);
            said!(language =>
                "the recorded {column} has steps of {step} at intervals of {interval}: these steps alone produce apparent accelerations of up to {alone}, {torque} at the load, while the motion itself has {motion}; {remedy}"
                | "die aufgezeichnete {column} hat Stufen von {step} im Abstand von {interval}: sie allein täuschen Beschleunigungen bis {alone} vor, an der Last {torque}, die Bewegung selbst hat {motion}; {remedy}"
            )
        }
        Spurious::Held { period_s } => {
            let period = figure(period_s, &MILLISECOND, language);
            said!(language =>
                "the recorded {column} is updated every {period} only, with rows every {interval}: the held values alone produce apparent accelerations of up to {alone}, {torque} at the load, while the motion itself has {motion}; held_values = \"interpolate\" uses one value for each update"
                | "die aufgezeichnete {column} wird nur alle {period} aktualisiert, Zeilen stehen alle {interval}: die gehaltenen Werte allein täuschen Beschleunigungen bis {alone} vor, an der Last {torque}, die Bewegung selbst hat {motion}; held_values = \"interpolate\" verwendet einen Wert je Aktualisierung"
            )
        }
        Spurious::Updates { smoothing_s } => {
            let remedy = match smoothing_s {
                Some(_) => smoothing_text(smoothing_s, made_up.column, language),
                None => {
                    said!(language => "updates at equal intervals are required" | "erforderlich sind Aktualisierungen in gleichem Abstand")
                }
            };
            said!(language =>
                "the recorded {column} is updated irregularly, every {interval} on average, and the instants are known to within a row only: this alone produces apparent accelerations of up to {alone}, {torque} at the load, while the motion itself has {motion}; {remedy}"
                | "die aufgezeichnete {column} wird unregelmäßig aktualisiert, im Mittel alle {interval}, und der Zeitpunkt ist nur auf eine Zeile genau bekannt: das allein täuscht Beschleunigungen bis {alone} vor, an der Last {torque}, die Bewegung selbst hat {motion}; {remedy}"
            )
        }
        Spurious::Noise { deviation, rms_rad_s2, smoothing_s } => {
            let noise = match made_up.column {
                SteppedColumn::Position => figure(deviation, &DEGREE, language),
                SteppedColumn::Speed => figure(deviation, &REVOLUTION_PER_MINUTE, language),
            };
            let rms = figure(torque_nm * rms_rad_s2 / made_up.acceleration_rad_s2, &NEWTON_METRE, language);
            let remedy = smoothing_text(smoothing_s, made_up.column, language);
            said!(language =>
                "the recorded {column} has noise of {noise} (standard deviation) at intervals of {interval}: the noise alone produces apparent accelerations of up to {alone} wherever the axis moves, {torque} at the load without the inertia of the actuator in T_peak and {rms} (rms), which adds to T_rms by its square, while the motion itself has {motion}; {remedy}"
                | "die aufgezeichnete {column} hat Rauschen von {noise} (Standardabweichung) im Abstand von {interval}: es allein täuscht überall, wo die Achse sich bewegt, Beschleunigungen bis {alone} vor, an der Last ohne das Eigenträgheitsmoment des Antriebs {torque} in T_peak und {rms} effektiv, die quadratisch in T_rms eingehen, die Bewegung selbst hat {motion}; {remedy}"
            )
        }
        Spurious::Stamps { scatter_s } => {
            let scatter = figure(scatter_s, &MILLISECOND, language);
            said!(language =>
                "the time stamps of the recording scatter by {scatter} (standard deviation) about equal intervals of {interval}, which the recorded {column} does not follow: the scatter alone produces apparent accelerations of up to {alone}, {torque} at the load, while the motion itself has {motion}; time_stamps = \"even\" takes the rows as evenly spaced"
                | "die Zeitstempel der Aufzeichnung streuen um {scatter} (Standardabweichung) um gleiche Abstände von {interval}, die aufgezeichnete {column} folgt dem nicht: die Streuung allein täuscht Beschleunigungen bis {alone} vor, an der Last {torque}, die Bewegung selbst hat {motion}; time_stamps = \"even\" nimmt die Zeilen in gleichem Abstand"
            )
        }
    }
}

/// Returns the remedy for steps of a column.
fn smoothing_text(smoothing_s: Option<f64>, column: SteppedColumn, language: Language) -> String {
    match (smoothing_s, column) {
        (Some(window), _) => {
            // A line of the project file has a decimal point.
            let window = format_significant(MILLISECOND.from_si(window), 4, Language::En);
            said!(language =>
                "smoothing = \"{window} ms\" reduces them to a twentieth"
                | "smoothing = \"{window} ms\" senkt sie auf ein Zwanzigstel davon"
            )
        }
        (None, SteppedColumn::Position) => said!(language =>
            "a recorded speed or more digits are required"
            | "erforderlich sind eine aufgezeichnete Drehzahl oder mehr Stellen"
        ),
        (None, SteppedColumn::Speed) => {
            said!(language => "more digits are required" | "erforderlich sind mehr Stellen")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A speed in 1/min is a rotational one in German.
    #[test]
    fn a_rotational_speed_is_no_linear_one() {
        for assumption in Assumption::ALL {
            let text = assumption_text(assumption, Language::De);
            let is_linear = text.contains("Geschwindigkeit") || text.contains("geschwindigkeit");
            assert!(!is_linear || !text.contains("min⁻¹") && !text.contains('°'), "{text}");
            let is_of_a_line = matches!(assumption, Assumption::Overruns(Overrun { travel_m_per_rad: Some(_), .. }));
            assert_eq!(is_linear, is_of_a_line, "{text}");
        }
    }
}
