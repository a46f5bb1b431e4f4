//! Words for the identifiers of the commissioning: parameters, gaps, measurands, bands, causes.

use super::commission;
use crate::pick;
use crate::texts::said;
use installation::commission::cia402::ObjectId;
use installation::commission::expected::{Band, Measurand};
use installation::commission::recorded::{Cause, Unjudged};
use installation::commission::sinamics::ParameterChoice;
use installation::commission::{Conversion, Gap, ParameterId};
use quantities::{Language, format_significant};

/// Returns the name of a parameter.
#[must_use]
pub fn parameter_name(id: ParameterId, language: Language) -> &'static str {
    use ParameterId as P;
    let (en, de) = match id {
        P::ReductionRatio => (
            "reduction ratio; the gear reverses the direction of rotation",
            "Untersetzung; das Getriebe kehrt die Drehrichtung um",
        ),
        P::PolePairs => ("pole pairs", "Polpaarzahl"),
        P::SpeedMotorMax => ("maximum speed of the motor", "maximale Drehzahl des Motors"),
        P::SpeedMotorRated => ("rated speed of the motor", "Bemessungsdrehzahl des Motors"),
        P::FrequencyRated => ("frequency at rated speed", "Frequenz bei Bemessungsdrehzahl"),
        P::SpeedOutMax => ("maximum speed of the flange", "maximale Drehzahl des Flansches"),
        P::TorqueOutMax => ("maximum torque at the output", "maximales Drehmoment am Abtrieb"),
        P::StallTorqueOut => ("continuous stall torque at the output", "Stillstandsdrehmoment am Abtrieb"),
        P::StallTorqueMotor => ("motor torque at stall current", "Motormoment bei Stillstandsstrom"),
        P::CurrentMax => ("maximum current, rms", "Maximalstrom, effektiv"),
        P::CurrentMaxPeak => ("maximum current, amplitude", "Maximalstrom, Scheitelwert"),
        P::StallCurrent => ("stall current, rms", "Stillstandsstrom, effektiv"),
        P::StallCurrentPeak => ("stall current, amplitude", "Stillstandsstrom, Scheitelwert"),
        P::CurrentDemagnetisation => ("demagnetisation current, rms", "Entmagnetisierungsstrom, effektiv"),
        P::CurrentLimit => (
            "maximum motor current as limit in the drive, rms",
            "maximaler Motorstrom als Grenze im Servoregler, effektiv",
        ),
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
        P::NoLoadCurrentConstant30 => {
            ("no-load current constant, 30 °C, per flange speed", "Leerlaufstromkonstante, 30 °C, je Flanschdrehzahl")
        }
        P::NoLoadCurrentConstant80 => {
            ("no-load current constant, 80 °C, per flange speed", "Leerlaufstromkonstante, 80 °C, je Flanschdrehzahl")
        }
        P::WindingWarning => ("winding temperature, warning", "Wicklungstemperatur, Warnung"),
        P::WindingShutdown => ("winding temperature, shutdown", "Wicklungstemperatur, Abschaltung"),
        P::EncoderIncrements => (
            "increments per turn of the motor, with the interpolation of the table",
            "Inkremente je Motorumdrehung, mit der Interpolation der Tabelle",
        ),
        P::EncoderLines => (
            "signal periods of the encoder per motor revolution; pole pairs of a resolver",
            "Strichzahl des Gebers je Motorumdrehung, beim Resolver Polpaarzahl",
        ),
        P::EncoderPositions => ("absolute positions per motor revolution", "absolute Positionen je Motorumdrehung"),
        P::EncoderTurns => ("motor revolutions resolved by the encoder", "vom Geber unterschiedene Motorumdrehungen"),
        P::BrakeVoltage => ("supply voltage of the brake", "Bremsenspannung"),
        P::BrakeOpeningCurrent => ("opening current of the brake", "Öffnungsstrom der Bremse"),
        P::BrakeHoldingCurrent => ("holding current of the brake", "Haltestrom der Bremse"),
        P::BrakeOpeningTime => ("opening time of the brake", "Öffnungszeit der Bremse"),
        P::BrakeClosingTime => ("closing time of the brake", "Schließzeit der Bremse"),
        P::BrakeHoldingTorque => ("holding torque of the brake at the output", "Haltemoment der Bremse am Abtrieb"),
    };
    pick(language, en, de)
}

/// Returns the conversion from the value in the manual to the parameter.
#[must_use]
pub const fn conversion_text(conversion: Conversion, language: Language) -> &'static str {
    let (en, de) = match conversion {
        Conversion::AsPrinted => ("as stated in the manual", "laut Anleitung"),
        Conversion::FromTenThousandths => ("10⁻⁴ kgm² in the manual", "laut Anleitung in 10⁻⁴ kgm²"),
        Conversion::PhaseOfStar => {
            ("half the line-to-line value, star connection", "halber Wert Leiter-Leiter, Sternschaltung")
        }
        Conversion::Amplitude => ("√2 × rms", "√2 × Effektivwert"),
        Conversion::Frequency => ("p n_N/60", "p·n_N/60"),
        Conversion::EmfOfSpeed => ("k_EM n_N/1000", "k_EM·n_N/1000"),
        Conversion::TorqueOfCurrent => ("k_TM I_0", "k_TM·I_0"),
        Conversion::Smaller => ("smaller of I_max and I_E", "kleinerer Wert von I_max und I_E"),
    };
    pick(language, en, de)
}

/// Returns the meaning of a parameter number of a drive.
#[must_use]
pub const fn choice_text(choice: ParameterChoice, language: Language) -> &'static str {
    let (en, de) = match choice {
        ParameterChoice::Synchronous => (
            "motor type: rotary permanent-magnet synchronous motor",
            "Motortyp: rotatorischer permanenterregter Synchronmotor",
        ),
        ParameterChoice::IdentifiedEncoder => (
            "encoder: identified by the drive over EnDat; compare p0408, p0421, p0423 with the result",
            "Geber: vom Servoregler über EnDat identifiziert; p0408, p0421, p0423 mit dem Ergebnis vergleichen",
        ),
        ParameterChoice::EnteredEncoder => ("encoder: data entered by hand", "Geber: Daten von Hand eingegeben"),
        ParameterChoice::SensorAtEncoder => (
            "temperature sensor connected through the motor encoder",
            "Temperatursensor über den Motorgeber angeschlossen",
        ),
        ParameterChoice::SensorKty => ("type of temperature sensor: KTY 84", "Typ des Temperatursensors: KTY 84"),
    };
    pick(language, en, de)
}

/// Returns a missing datum and the remedy.
#[must_use]
pub fn gap_text(gap: Gap, language: Language) -> String {
    let (en, de) = match gap {
        Gap::RatedPoint => (
            "rated current, torque and power (SINAMICS p0305, p0307): not stated; use the current of the continuous curve at n_N if the curve is available, otherwise I_0 as upper limit, and ask the manufacturer",
            "Bemessungsstrom, -moment und -leistung (SINAMICS p0305, p0307): nicht angegeben; Strom der Dauerkennlinie bei n_N verwenden, wenn die Kennlinie vorliegt, sonst I_0 als obere Grenze; beim Hersteller erfragen",
        ),
        Gap::RatedVoltage => (
            "rated voltage (SINAMICS p0304): not stated; enter the induced voltage at n_N, k_EM n_N/1000, plus the voltage drop under load",
            "Bemessungsspannung (SINAMICS p0304): nicht angegeben; induzierte Spannung bei n_N, k_EM·n_N/1000, zuzüglich Spannungsabfall unter Last eintragen",
        ),
        Gap::CommutationOffset => (
            "commutation offset: not stated; determine it on the machine as described here",
            "Kommutierungswinkel: nicht angegeben; an der Maschine bestimmen, wie hier beschrieben",
        ),
        Gap::PolePosition => (
            "currents and times of the pole position identification (SINAMICS p0325, p0329): not stated; keep the defaults of the drive, below I_0",
            "Ströme und Zeiten der Pollageidentifikation (SINAMICS p0325, p0329): nicht angegeben; Vorgabewerte des Servoreglers beibehalten, unter I_0",
        ),
        Gap::ThermalTimeConstant => (
            "thermal time constant for I²t: not stated in any table; the value shown comes from a model and must be checked on the warm motor",
            "thermische Zeitkonstante für I²t: in keiner Tabelle angegeben; der gezeigte Wert ist ein Modellwert und am betriebswarmen Motor zu prüfen",
        ),
        Gap::Saliency => (
            "d- and q-axis inductance, saturation: the manual states a single inductance without saturation; both are set to it until the drive has identified them",
            "Längs- und Querinduktivität, Sättigung: die Anleitung nennt eine einzige Induktivität ohne Sättigung; beide erhalten diesen Wert, bis der Servoregler sie identifiziert hat",
        ),
        Gap::LoopGains => (
            "gains of current, speed and position controller: not stated; determine them by the identification of the drive with the load coupled",
            "Verstärkungen von Strom-, Drehzahl- und Lageregler: nicht angegeben; durch Identifikation des Servoreglers mit angekuppelter Last bestimmen",
        ),
        Gap::Counting => (
            "counting direction of the position: not stated for the resolver; determine it at the first motion and set the sign in the drive (CiA 402: 0x607E); the gear reverses the direction of rotation",
            "Zählrichtung der Position: für den Resolver nicht angegeben; bei der ersten Bewegung feststellen und das Vorzeichen im Servoregler einstellen (CiA 402: 0x607E); das Getriebe kehrt die Drehrichtung um",
        ),
        Gap::OwnObjects => (
            "resistance, inductance, inertia and pole pairs in CiA 402: the profile has no objects for them; use the manufacturer-specific objects of the drive (see its manual) and observe phase or line-to-line values",
            "Widerstand, Induktivität, Trägheit und Polpaare in CiA 402: das Profil hat dafür keine Objekte; herstellerspezifische Objekte des Servoreglers verwenden (siehe dessen Handbuch), Strangwert oder Leiter-Leiter-Wert beachten",
        ),
        Gap::NotPrinted(id) => {
            let name = parameter_name(id, language);
            let symbol = id.symbol();
            return said!(language =>
                "{name} ({symbol}): not stated for this ordering code; ask the manufacturer before use"
                | "{name} ({symbol}): für diese Bestellbezeichnung nicht angegeben; vor Verwendung beim Hersteller erfragen"
            );
        }
    };
    pick(language, en, de).to_owned()
}

/// Returns the name of an object in its profile, which is English in both languages.
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

/// Returns the name of a measurand.
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
        Measurand::DirectionFlange => ("flange turns opposite to the motor", "Flansch dreht entgegengesetzt zum Motor"),
        Measurand::DirectionPosition => {
            ("position increases with the motor turning clockwise", "Position steigt bei Rechtslauf des Motors")
        }
        Measurand::Ratio => ("motor speed / flange speed", "Motordrehzahl/Flanschdrehzahl"),
        Measurand::PolePairs => ("electrical frequency / speed", "elektrische Frequenz/Drehzahl"),
    };
    pick(language, en, de)
}

/// Returns the basis of a tolerance band.
#[must_use]
pub const fn band_text(band: Band, language: Language) -> &'static str {
    let (en, de) = match band {
        Band::Printed => ("tolerance stated in the manual", "Toleranz laut Anleitung"),
        Band::ServoMotors => (
            "band of another manufacturer's servo motors (SIMODRIVE 611 A); none is stated for this actuator",
            "Toleranzband für Servomotoren eines anderen Herstellers (SIMODRIVE 611 A); für diesen Antrieb ist keines angegeben",
        ),
        Band::KtySheet => (
            "smallest and largest value of the sensor's data sheet: ±3 % at 100 °C, wider away from it",
            "kleinster und größter Wert nach Datenblatt des Sensors: ±3 % bei 100 °C, abseits davon weiter",
        ),
        Band::Din44081 => ("limits of DIN 44081", "Grenzen nach DIN 44081"),
        Band::Friction => (
            "estimate: identification of a joint with such a gear deviated by 40 % (constant part) and 15 % (speed-dependent part) from the catalogue (CompliantJointToolbox, issue 44); theory of the motor current, “Band of the no-load current”",
            "Schätzung: ein Gelenk mit solchem Getriebe wich bei der Identifikation um 40 % (konstanter Anteil) und 15 % (drehzahlabhängiger Anteil) vom Katalog ab (CompliantJointToolbox, Issue 44); Theorie des Motorstroms, Abschnitt „Band des Leerlaufstroms“",
        ),
        Band::Ours => {
            ("band assumed by antrieb; no source states one", "von antrieb angenommenes Band; keine Quelle nennt eines")
        }
        Band::Exact => ("2 % for reading two values", "2 % für das Ablesen zweier Werte"),
    };
    pick(language, en, de)
}

/// Returns the reason why a measurement is not judged.
#[must_use]
pub const fn unjudged_text(why: Unjudged, language: Language) -> &'static str {
    match why {
        Unjudged::NotMeasured => commission::not_measured(language),
        Unjudged::NotStated => commission::not_stated(language),
        Unjudged::NotThere => commission::not_there(language),
    }
}

/// Returns the likely cause of a deviating value, and what to check.
#[must_use]
pub fn cause_text(cause: Cause, language: Language) -> String {
    let shown = |value: f64| format_significant(value, 3, language);
    let (en, de) = match cause {
        Cause::OnePhase => (
            "half the value: phase value instead of line-to-line value",
            "halber Wert: Strangwert statt Leiter-Leiter-Wert",
        ),
        Cause::Doubled => (
            "twice the value: a line-to-line value was taken for a phase value and doubled",
            "doppelter Wert: ein Leiter-Leiter-Wert wurde für einen Strangwert gehalten und verdoppelt",
        ),
        Cause::TerminalsJoined => (
            "three quarters of the value: measured against two connected terminals",
            "drei Viertel des Werts: gegen zwei verbundene Klemmen gemessen",
        ),
        Cause::WindingTemperature(celsius) => {
            let celsius = shown(celsius);
            return said!(language =>
                "corresponds to a winding at {celsius} °C: temperature stated wrongly or not converted"
                | "entspricht einer Wicklung mit {celsius} °C: Temperatur falsch angegeben oder nicht umgerechnet"
            );
        }
        Cause::Leads(ohm) => {
            let ohm = shown(ohm);
            return said!(language =>
                "includes {ohm} Ω of leads and contacts: use a four-wire measurement"
                | "enthält {ohm} Ω von Leitungen und Kontakten: in Vierleitertechnik messen"
            );
        }
        Cause::Open => {
            ("open circuit: wire, contact or connector open", "kein Durchgang: Leitung, Kontakt oder Stecker offen")
        }
        Cause::Short => {
            ("short circuit in cable, connector or component", "Kurzschluss in Leitung, Stecker oder Bauteil")
        }
        Cause::PhaseVoltage => (
            "1/√3: measured against the star point instead of line to line",
            "1/√3: gegen den Sternpunkt statt Leiter-Leiter gemessen",
        ),
        Cause::Amplitude => ("√2: amplitude instead of rms", "√2: Scheitelwert statt Effektivwert"),
        Cause::PhaseAmplitude => {
            ("√2/√3: amplitude against the star point", "√2/√3: Scheitelwert gegen den Sternpunkt")
        }
        Cause::PeakToPeak => ("2√2: peak-to-peak value", "2√2: Spitze-Spitze-Wert"),
        Cause::RootThree => (
            "√3: a line-to-line value was taken for a phase value and converted",
            "√3: ein Leiter-Leiter-Wert wurde für einen Strangwert gehalten und umgerechnet",
        ),
        Cause::SpeedFactor => (
            "factor 2: speed read wrongly, or pole pairs and poles confused",
            "Faktor 2: Drehzahl falsch abgelesen oder Polpaare und Pole verwechselt",
        ),
        Cause::SpeedOfFlange => {
            ("factor i: flange speed instead of motor speed", "Faktor i: Flanschdrehzahl statt Motordrehzahl")
        }
        Cause::Magnets => (
            "too low: magnets hot, or weakened by a current above I_E",
            "zu klein: Magnete heiß oder durch einen Strom über I_E geschwächt",
        ),
        Cause::KtyPolesOrTemperature(celsius) => {
            let celsius = shown(celsius);
            return said!(language =>
                "the sensor reads {celsius} °C: polarity reversed, measuring current not 2 mA, or temperature stated wrongly"
                | "der Sensor zeigt {celsius} °C: verpolt, Messstrom ungleich 2 mA oder Temperatur falsch angegeben"
            );
        }
        Cause::OtherSensor => (
            "this is the value of the other sensor: KTY and PTC interchanged",
            "Wert des anderen Sensors: KTY und PTC vertauscht",
        ),
        Cause::PtcResponded => (
            "the PTC has responded: winding hot, or temperature stated incorrectly; otherwise a bad contact in its circuit",
            "der PTC hat angesprochen: Wicklung heiß oder Temperatur falsch angegeben; sonst schlechter Kontakt in seinem Kreis",
        ),
        Cause::BrakeNotConnected => (
            "no current: brake not connected, wrong contacts, or supply switched off",
            "kein Strom: Bremse nicht angeschlossen, falsche Kontakte oder Versorgung ausgeschaltet",
        ),
        Cause::HalfVoltage => (
            "half the value: the brake receives half its voltage",
            "halber Wert: an der Bremse liegt die halbe Spannung",
        ),
        Cause::HoldingCurrent => (
            "this is the holding current: measured after the current was reduced",
            "Haltestrom: nach der Absenkung gemessen",
        ),
        Cause::OpeningCurrent => (
            "this is the opening current: it is not reduced, the coil overheats",
            "Öffnungsstrom: er wird nicht abgesenkt, die Spule überhitzt",
        ),
        Cause::SlowBrake => (
            "too slow: voltage too low, or a freewheeling diode across the coil",
            "zu langsam: Spannung zu niedrig oder Freilaufdiode an der Spule",
        ),
        Cause::Dragging => (
            "far above friction: brake closed or dragging, parts jammed in the hollow shaft, distorted flange or wrong commutation offset",
            "weit über der Reibung: Bremse geschlossen oder schleifend, Klemmen in der Hohlwelle, verspannter Flansch oder falscher Kommutierungswinkel",
        ),
        Cause::ConvertedTwice => ("1/√2: converted to rms twice", "1/√2: doppelt in den Effektivwert umgerechnet"),
        Cause::SpeedOfMotor => (
            "the flange cannot turn this fast: this is the motor speed",
            "so schnell kann der Flansch nicht drehen: Motordrehzahl eingetragen",
        ),
        Cause::SameDirection => (
            "the gear reverses the direction of rotation: seen from the same side, both cannot turn the same way; one was observed from behind, or the drive inverts the direction",
            "das Getriebe kehrt die Drehrichtung um: von derselben Seite gesehen können beide nicht gleichsinnig drehen; einer wurde von hinten betrachtet oder der Servoregler invertiert die Richtung",
        ),
        Cause::CountingReversed => (
            "counts in the opposite direction: encoder signals or motor phases interchanged, or the drive inverts the position",
            "zählt in Gegenrichtung: Gebersignale oder Motorphasen vertauscht oder der Servoregler invertiert die Position",
        ),
        Cause::OtherRatio(ratio) => {
            return said!(language =>
                "corresponds to a gear with ratio {ratio}: check the rating plate and the gear ratio in the drive"
                | "entspricht einem Getriebe mit Untersetzung {ratio}: Typenschild und Getriebefaktor im Servoregler prüfen"
            );
        }
        Cause::PolePairs(pairs) => {
            let pairs = shown(pairs);
            return said!(language =>
                "corresponds to a motor with {pairs} pole pairs: a wrong setting falsifies the speed by the same factor"
                | "entspricht einem Motor mit {pairs} Polpaaren: eine falsche Einstellung verfälscht die Drehzahl um denselben Faktor"
            );
        }
    };
    pick(language, en, de).to_owned()
}
