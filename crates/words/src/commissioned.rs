//! Words of what the commissioning knows by identifier: parameters, gaps, measurands, bands, causes.

use super::commission;
use crate::pick;
use crate::texts::said;
use installation::commission::cia402::ObjectId;
use installation::commission::expected::{Band, Measurand};
use installation::commission::recorded::{Cause, Unjudged};
use installation::commission::sinamics::Choice;
use installation::commission::{Conversion, Gap, ParameterId};
use quantities::{Language, format_significant};

/// What a parameter is.
#[must_use]
pub fn parameter_name(id: ParameterId, language: Language) -> &'static str {
    use ParameterId as P;
    let (en, de) = match id {
        P::ReductionRatio => ("reduction ratio, the gear reverses", "Untersetzung, das Getriebe kehrt um"),
        P::PolePairs => ("pole pairs", "Polpaarzahl"),
        P::SpeedMotorMax => ("maximum speed of the motor", "maximale Drehzahl des Motors"),
        P::SpeedMotorRated => ("rated speed of the motor", "Bemessungsdrehzahl des Motors"),
        P::FrequencyRated => ("frequency at rated speed", "Frequenz bei Bemessungsdrehzahl"),
        P::SpeedOutMax => ("maximum speed of the flange", "maximale Drehzahl des Flansches"),
        P::TorqueOutMax => ("maximum torque at the output", "maximales Drehmoment am Abtrieb"),
        P::StallTorqueOut => ("stall torque at the output", "Stillstandsdrehmoment am Abtrieb"),
        P::StallTorqueMotor => ("torque of the motor at stall current", "Motormoment bei Stillstandsstrom"),
        P::CurrentMax => ("maximum current, rms", "Maximalstrom, effektiv"),
        P::CurrentMaxPeak => ("maximum current, amplitude", "Maximalstrom, Scheitelwert"),
        P::StallCurrent => ("stall current, rms", "Stillstandsstrom, effektiv"),
        P::StallCurrentPeak => ("stall current, amplitude", "Stillstandsstrom, Scheitelwert"),
        P::CurrentDemagnetisation => ("demagnetisation current, rms", "Entmagnetisierungsstrom, effektiv"),
        P::CurrentLimit => ("current limit of the drive, rms", "Stromgrenze des Reglers, effektiv"),
        P::TorqueConstantMotor => {
            ("torque constant of the motor, per A rms", "Drehmomentkonstante des Motors, je A effektiv")
        }
        P::TorqueConstantOut => {
            ("torque constant at the output, per A rms", "Drehmomentkonstante am Abtrieb, je A effektiv")
        }
        P::VoltageConstant => (
            "voltage constant of the motor, line to line, rms",
            "Spannungskonstante des Motors, Leiter-Leiter, effektiv",
        ),
        P::EmfRated => (
            "induced voltage at rated speed, line to line, rms",
            "induzierte Spannung bei Bemessungsdrehzahl, Leiter-Leiter, effektiv",
        ),
        P::ResistanceLl => ("resistance line to line, 20 °C", "Widerstand Leiter-Leiter, 20 °C"),
        P::ResistancePhase => ("resistance of a phase, 20 °C", "Strangwiderstand, 20 °C"),
        P::InductanceLl => ("inductance line to line", "Induktivität Leiter-Leiter"),
        P::InductancePhase => ("inductance of a phase", "Stranginduktivität"),
        P::InertiaMotor => ("moment of inertia at the motor", "Massenträgheitsmoment am Motor"),
        P::Mass => ("mass", "Masse"),
        P::DcLinkMax => ("maximum steady DC link voltage", "maximale stationäre Zwischenkreisspannung"),
        P::NoLoadStartingCurrent => ("no-load starting current, rms", "lastfreier Anlaufstrom, effektiv"),
        P::NoLoadCurrentConstant30 => (
            "no-load current constant, 30 °C, per speed of the flange",
            "Leerlaufstromkonstante, 30 °C, je Flanschdrehzahl",
        ),
        P::NoLoadCurrentConstant80 => (
            "no-load current constant, 80 °C, per speed of the flange",
            "Leerlaufstromkonstante, 80 °C, je Flanschdrehzahl",
        ),
        P::WindingWarning => ("winding temperature, warning", "Wicklungstemperatur, Warnung"),
        P::WindingShutdown => ("winding temperature, shutdown", "Wicklungstemperatur, Abschaltung"),
        P::EncoderIncrements => (
            "increments per turn of the motor, with the interpolation of the table",
            "Inkremente je Motorumdrehung, mit der Interpolation der Tabelle",
        ),
        P::BrakeVoltage => ("voltage of the brake", "Spannung der Bremse"),
        P::BrakeOpeningCurrent => ("opening current of the brake", "Öffnungsstrom der Bremse"),
        P::BrakeHoldingCurrent => ("holding current of the brake", "Haltestrom der Bremse"),
        P::BrakeOpeningTime => ("opening time of the brake", "Öffnungszeit der Bremse"),
        P::BrakeClosingTime => ("closing time of the brake", "Schließzeit der Bremse"),
        P::BrakeHoldingTorque => ("holding torque of the brake at the output", "Haltemoment der Bremse am Abtrieb"),
    };
    pick(language, en, de)
}

/// How a value follows from what is printed.
#[must_use]
pub const fn conversion_text(conversion: Conversion, language: Language) -> &'static str {
    let (en, de) = match conversion {
        Conversion::AsPrinted => ("as printed", "wie gedruckt"),
        Conversion::FromTenThousandths => ("10⁻⁴ kgm² in print", "10⁻⁴ kgm² im Druck"),
        Conversion::PhaseOfStar => ("half of line to line, star winding", "Hälfte von Leiter-Leiter, Sternschaltung"),
        Conversion::Amplitude => ("√2 × rms", "√2 × Effektivwert"),
        Conversion::Frequency => ("p n_N/60", "p·n_N/60"),
        Conversion::EmfOfSpeed => ("k_EM n_N/1000", "k_EM·n_N/1000"),
        Conversion::TorqueOfCurrent => ("k_TM I_0", "k_TM·I_0"),
        Conversion::Smaller => ("smaller one of I_max and I_E", "kleinerer Wert von I_max und I_E"),
    };
    pick(language, en, de)
}

/// Meaning of a parameter number of a drive.
#[must_use]
pub const fn choice_text(choice: Choice, language: Language) -> &'static str {
    let (en, de) = match choice {
        Choice::SensorAtEncoder => {
            ("temperature sensor comes in with the encoder of the motor", "Temperatursensor kommt mit dem Motorgeber")
        }
        Choice::SensorKty => ("kind of temperature sensor: KTY 84", "Art des Temperatursensors: KTY 84"),
    };
    pick(language, en, de)
}

/// What is missing and what to do.
#[must_use]
pub fn gap_text(gap: Gap, language: Language) -> String {
    let (en, de) = match gap {
        Gap::RatedPoint => (
            "rated current, torque and power (SINAMICS p0305, p0307): not stated; take the current of the continuous curve at n_N where you have the curve, else keep to I_0 as the upper bound and ask the maker",
            "Bemessungsstrom, -moment und -leistung (SINAMICS p0305, p0307): nicht angegeben; den Strom der Dauerkennlinie bei n_N nehmen, wo die Kennlinie vorliegt, sonst I_0 als obere Grenze und beim Hersteller fragen",
        ),
        Gap::RatedVoltage => (
            "rated voltage (SINAMICS p0304): not stated; the induced voltage at n_N is in the list, the drop at current comes on top",
            "Bemessungsspannung (SINAMICS p0304): nicht angegeben; die induzierte Spannung bei n_N steht in der Liste, der Abfall unter Strom kommt hinzu",
        ),
        Gap::CommutationOffset => (
            "commutation offset: not stated; determine it on the machine as described here",
            "Kommutierungswinkel: nicht angegeben; an der Maschine bestimmen, wie hier beschrieben",
        ),
        Gap::PolePosition => (
            "currents and times of the pole position identification (SINAMICS p0325, p0329): not stated; leave the drive's defaults, below I_0",
            "Ströme und Zeiten der Pollageidentifikation (SINAMICS p0325, p0329): nicht angegeben; Vorgaben des Reglers lassen, unter I_0",
        ),
        Gap::ThermalTimeConstant => (
            "thermal time constant for I²t: no table has it; the value shown is a model, check it against the warm motor",
            "thermische Zeitkonstante für I²t: in keiner Tabelle; der gezeigte Wert ist ein Modell, am warmen Motor prüfen",
        ),
        Gap::Saliency => (
            "inductances along and across the rotor, saturation: one inductance is printed, without saturation; both are set to it until the drive has identified them",
            "Längs- und Querinduktivität, Sättigung: gedruckt ist eine Induktivität ohne Sättigung; beide werden auf sie gesetzt, bis der Regler sie identifiziert hat",
        ),
        Gap::LoopGains => (
            "gains of current, speed and position loop: not stated; by the drive's identification with the load",
            "Verstärkungen von Strom-, Drehzahl- und Lageregler: nicht angegeben; durch die Identifikation des Reglers mit Last",
        ),
        Gap::Counting => (
            "direction in which the position counts: not stated for the resolver; find it at the first motion and set the sign in the drive (CiA 402: 0x607E), the gear reverses",
            "Zählrichtung der Position: für den Resolver nicht angegeben; bei der ersten Bewegung feststellen und das Vorzeichen im Regler setzen (CiA 402: 0x607E), das Getriebe kehrt um",
        ),
        Gap::OwnObjects => (
            "resistance, inductance, inertia and pole pairs in CiA 402: the profile has no object for them; each drive has its own, see its manual and mind phase or line to line",
            "Widerstand, Induktivität, Trägheit und Polpaare in CiA 402: das Profil hat dafür kein Objekt; jeder Regler hat eigene, siehe dessen Handbuch, Strang oder Leiter-Leiter beachten",
        ),
        Gap::NotPrinted(id) => {
            let name = parameter_name(id, language);
            let symbol = id.symbol();
            return said!(language =>
                "{name} ({symbol}): not printed for this code; ask the maker before you rely on it"
                | "{name} ({symbol}): für diesen Code nicht gedruckt; vor Gebrauch beim Hersteller fragen"
            );
        }
    };
    pick(language, en, de).to_owned()
}

/// The name of an object in its profile, in which it stands in English everywhere.
#[must_use]
pub const fn object_name(id: ObjectId, language: Language) -> &'static str {
    match id {
        ObjectId::MaxTorque => commission::object_max_torque(language),
        ObjectId::MaxCurrent => commission::object_max_current(language),
        ObjectId::MotorRatedCurrent => commission::object_rated_current(language),
        ObjectId::MotorRatedTorque => commission::object_rated_torque(language),
        ObjectId::Polarity => commission::object_polarity(language),
        ObjectId::MaxMotorSpeed => commission::object_max_motor_speed(language),
        ObjectId::EncoderIncrements => commission::object_encoder_increments(language),
        ObjectId::EncoderRevolutions => commission::object_encoder_revolutions(language),
        ObjectId::GearMotorRevolutions => commission::object_gear_motor(language),
        ObjectId::GearShaftRevolutions => commission::object_gear_shaft(language),
    }
}

/// What is measured.
#[must_use]
pub const fn measurand_name(what: Measurand, language: Language) -> &'static str {
    let (en, de) = match what {
        Measurand::ResistanceLl => ("winding resistance line to line", "Wicklungswiderstand Leiter-Leiter"),
        Measurand::InductanceLl => ("inductance line to line", "Induktivität Leiter-Leiter"),
        Measurand::Emf => ("induced voltage line to line, rms", "induzierte Spannung Leiter-Leiter, effektiv"),
        Measurand::Kty => ("resistance of the KTY 84-130", "Widerstand des KTY 84-130"),
        Measurand::Ptc => ("resistance of the PTC", "Widerstand des PTC"),
        Measurand::BrakeVoltage => ("voltage at the brake", "Spannung an der Bremse"),
        Measurand::BrakeOpeningCurrent => ("opening current of the brake", "Öffnungsstrom der Bremse"),
        Measurand::BrakeHoldingCurrent => ("holding current of the brake", "Haltestrom der Bremse"),
        Measurand::BrakeOpeningTime => ("opening time of the brake", "Öffnungszeit der Bremse"),
        Measurand::BrakeClosingTime => ("closing time of the brake", "Schließzeit der Bremse"),
        Measurand::NoLoadCurrent => ("no-load current, rms", "Leerlaufstrom, effektiv"),
        Measurand::DirectionFlange => ("flange turns against the motor", "Flansch dreht gegen den Motor"),
        Measurand::DirectionPosition => {
            ("position rises with the motor clockwise", "Position steigt bei rechtsdrehendem Motor")
        }
        Measurand::Ratio => ("speed of motor over flange", "Drehzahl Motor durch Flansch"),
        Measurand::PolePairs => ("electrical frequency over speed", "elektrische Frequenz durch Drehzahl"),
    };
    pick(language, en, de)
}

/// What a band rests on.
#[must_use]
pub const fn band_text(band: Band, language: Language) -> &'static str {
    let (en, de) = match band {
        Band::Printed => ("tolerance of the manual", "Toleranz der Anleitung"),
        Band::ServoMotors => (
            "band of another maker's servo motors (simodrive-611a); this one states none",
            "Band der Servomotoren eines anderen Herstellers (simodrive-611a); dieser nennt keines",
        ),
        Band::KtySheet => {
            ("±3 % of the sensor's data sheet, there for 100 °C", "±3 % nach Datenblatt des Sensors, dort bei 100 °C")
        }
        Band::Din44081 => ("bounds of DIN 44081", "Grenzen nach DIN 44081"),
        Band::Friction => (
            "estimate: a joint with such a gear was identified 40 % (constant part) and 15 % (with speed) off its catalogue (cjt-issue-44); docs/theory/current.md, band of the no-load current",
            "Schätzung: ein Gelenk mit solchem Getriebe wich bei der Identifikation 40 % (konstanter Anteil) und 15 % (mit der Drehzahl) vom Katalog ab (cjt-issue-44); docs/theory/current.md, Abschnitt „Band of the no-load current“",
        ),
        Band::Ours => {
            ("band assumed by antrieb; no source states one", "Band von antrieb angenommen; keine Quelle nennt eines")
        }
        Band::Exact => ("2 % for reading two values", "2 % für das Ablesen zweier Werte"),
    };
    pick(language, en, de)
}

/// Why a measurement is not judged.
#[must_use]
pub const fn unjudged_text(why: Unjudged, language: Language) -> &'static str {
    match why {
        Unjudged::NotMeasured => commission::not_measured(language),
        Unjudged::NotStated => commission::not_stated(language),
        Unjudged::NotThere => commission::not_there(language),
    }
}

/// The likely cause of a value that is off, and what to look at.
#[must_use]
pub fn cause_text(cause: Cause, language: Language) -> String {
    let shown = |value: f64| format_significant(value, 3, language);
    let (en, de) = match cause {
        Cause::OnePhase => {
            ("half of it: the value of one phase instead of line to line", "die Hälfte: Strangwert statt Leiter-Leiter")
        }
        Cause::Doubled => (
            "twice as much: a line-to-line value was taken for a phase and doubled",
            "das Doppelte: ein Leiter-Leiter-Wert wurde für einen Strangwert gehalten und verdoppelt",
        ),
        Cause::TerminalsJoined => (
            "three quarters: measured against two terminals that were joined",
            "drei Viertel: gegen zwei verbundene Klemmen gemessen",
        ),
        Cause::WindingTemperature(celsius) => {
            let celsius = shown(celsius);
            return said!(language =>
                "a winding at {celsius} °C would have it: temperature not stated or not converted rightly"
                | "eine Wicklung mit {celsius} °C hätte ihn: Temperatur falsch angegeben oder nicht umgerechnet"
            );
        }
        Cause::Leads(ohm) => {
            let ohm = shown(ohm);
            return said!(language =>
                "{ohm} Ω of leads and contacts are in it: measure with four wires"
                | "{ohm} Ω Leitungen und Kontakte sind enthalten: vierpolig messen"
            );
        }
        Cause::Open => {
            ("no passage: wire, contact or connector open", "kein Durchgang: Leitung, Kontakt oder Stecker offen")
        }
        Cause::Short => ("short circuit in cable, connector or part", "Kurzschluss in Leitung, Stecker oder Bauteil"),
        Cause::PhaseVoltage => (
            "1/√3: measured against the star point instead of line to line",
            "1/√3: gegen den Sternpunkt statt Leiter-Leiter gemessen",
        ),
        Cause::Amplitude => ("√2: amplitude instead of rms", "√2: Scheitelwert statt Effektivwert"),
        Cause::PhaseAmplitude => {
            ("√2/√3: amplitude against the star point", "√2/√3: Scheitelwert gegen den Sternpunkt")
        }
        Cause::PeakToPeak => ("2√2: from peak to peak", "2√2: von Spitze zu Spitze"),
        Cause::RootThree => (
            "√3: a line-to-line value was taken for a phase and converted",
            "√3: ein Leiter-Leiter-Wert wurde für einen Strangwert gehalten und umgerechnet",
        ),
        Cause::SpeedFactor => (
            "factor two: speed read wrongly, or pole pairs and poles mixed up",
            "Faktor zwei: Drehzahl falsch abgelesen oder Polpaare und Pole verwechselt",
        ),
        Cause::SpeedOfFlange => {
            ("factor i: speed of the flange instead of the motor", "Faktor i: Drehzahl des Flansches statt des Motors")
        }
        Cause::Magnets => (
            "low: magnets hot, or weakened by a current above I_E",
            "zu klein: Magnete heiß oder durch einen Strom über I_E geschwächt",
        ),
        Cause::KtyPolesOrTemperature(celsius) => {
            let celsius = shown(celsius);
            return said!(language =>
                "the sensor reads {celsius} °C: poles exchanged, measuring current other than 2 mA, or temperature stated wrongly"
                | "der Sensor zeigt {celsius} °C: verpolt, Messstrom anders als 2 mA oder Temperatur falsch angegeben"
            );
        }
        Cause::OtherSensor => (
            "this is the value of the other sensor, KTY and PTC exchanged",
            "das ist der Wert des anderen Sensors, KTY und PTC vertauscht",
        ),
        Cause::PtcResponded => (
            "the PTC has responded or is open: winding hot, or no passage",
            "der PTC hat angesprochen oder ist offen: Wicklung heiß oder kein Durchgang",
        ),
        Cause::BrakeNotConnected => (
            "nothing flows: brake not connected, wrong contacts, or its supply is off",
            "nichts fließt: Bremse nicht angeschlossen, falsche Kontakte oder ihre Versorgung aus",
        ),
        Cause::HalfVoltage => {
            ("half: the brake gets half of its voltage", "die Hälfte: die Bremse bekommt die halbe Spannung")
        }
        Cause::HoldingCurrent => (
            "this is the holding current: measured after the drive had lowered it",
            "das ist der Haltestrom: nach der Absenkung gemessen",
        ),
        Cause::OpeningCurrent => (
            "this is the opening current: nothing lowers it, the coil grows hot",
            "das ist der Öffnungsstrom: er wird nicht abgesenkt, die Spule wird heiß",
        ),
        Cause::SlowBrake => (
            "slow: voltage too low, or a diode across the coil lets its current die slowly",
            "zu langsam: Spannung zu klein oder Freilaufdiode an der Spule",
        ),
        Cause::Dragging => (
            "far above friction: brake closed or dragging, something jams in the hollow shaft, clamped flange or a wrong commutation offset",
            "weit über der Reibung: Bremse zu oder schleift, Klemmen in der Hohlwelle, verspannter Flansch oder falscher Kommutierungswinkel",
        ),
        Cause::ConvertedTwice => {
            ("1/√2: converted to rms once too often", "1/√2: einmal zu oft in den Effektivwert umgerechnet")
        }
        Cause::SpeedOfMotor => (
            "the flange cannot turn so fast: this is the speed of the motor",
            "so schnell kann der Flansch nicht drehen: das ist die Drehzahl des Motors",
        ),
        Cause::SameDirection => (
            "the gear reverses: seen from the same side both cannot turn alike; one was seen from behind, or the drive inverts",
            "das Getriebe kehrt um: von derselben Seite gesehen können beide nicht gleich drehen; einer wurde von hinten betrachtet oder der Regler invertiert",
        ),
        Cause::CountingReversed => (
            "counts the other way: encoder signals or motor phases exchanged, or the drive inverts the position",
            "zählt umgekehrt: Gebersignale oder Motorphasen vertauscht oder der Regler invertiert die Position",
        ),
        Cause::OtherRatio(ratio) => {
            return said!(language =>
                "this is a gear of ratio {ratio}: look at the type plate and at the gear ratio in the drive"
                | "das ist ein Getriebe mit Untersetzung {ratio}: Typenschild und Getriebefaktor im Regler prüfen"
            );
        }
        Cause::PolePairs(pairs) => {
            let pairs = shown(pairs);
            return said!(language =>
                "the motor would have {pairs} pole pairs: pole pairs set wrongly make the speed off by the same factor"
                | "der Motor hätte {pairs} Polpaare: falsch gesetzte Polpaare verfälschen die Drehzahl um denselben Faktor"
            );
        }
    };
    pick(language, en, de).to_owned()
}
