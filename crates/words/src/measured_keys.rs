//! Words of the keys of a record of measured values.

use crate::{commission, measurand_name, terms};
use installation::commission::expected::Measurand;
use project::MeasuredKey;
use quantities::Language;

/// What a key of a record is called, or what its table is about.
#[must_use]
pub const fn measured_label(key: MeasuredKey, language: Language) -> &'static str {
    if let Some(what) = key.measurand() {
        return measurand_name(what, language);
    }
    let (en, de) = match key {
        MeasuredKey::NoLoad => return measurand_name(Measurand::NoLoadCurrent, language),
        MeasuredKey::Winding => return terms::winding(language),
        MeasuredKey::Format => ("format", "Format"),
        MeasuredKey::WindingTemperature | MeasuredKey::SensorTemperature | MeasuredKey::NoLoadTemperature => {
            return commission::temperature(language);
        }
        MeasuredKey::Emf => ("induced voltage", "induzierte Spannung"),
        MeasuredKey::EmfSpeed | MeasuredKey::SpeedMotor => ("speed of the motor", "Drehzahl des Motors"),
        MeasuredKey::Sensor => ("temperature sensors", "Temperatursensoren"),
        MeasuredKey::Brake => ("brake", "Bremse"),
        MeasuredKey::Direction => ("directions", "Drehrichtungen"),
        MeasuredKey::DirectionMotor => ("motor shaft turns", "Motorwelle dreht"),
        MeasuredKey::DirectionFlange => ("flange turns", "Flansch dreht"),
        MeasuredKey::DirectionPosition => ("position is", "Position ist"),
        MeasuredKey::Speed => return terms::rotary_speed(language),
        MeasuredKey::SpeedFlange | MeasuredKey::NoLoadSpeed => ("speed of the flange", "Drehzahl des Flansches"),
        MeasuredKey::SpeedFrequency => ("frequency of the motor current", "Frequenz des Motorstroms"),
        _ => ("", ""),
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}

/// What a key of a record is for.
#[must_use]
pub const fn measured_key_text(key: MeasuredKey, language: Language) -> &'static str {
    let (en, de) = match key {
        MeasuredKey::Format => ("version of the file format, 1", "Version des Dateiformats, 1"),
        MeasuredKey::Winding => ("winding, disconnected from the drive", "Wicklung, vom Regler getrennt"),
        MeasuredKey::WindingTemperature => (
            "temperature of the winding, by the KTY or after hours at rest that of the air",
            "Temperatur der Wicklung, mit dem KTY oder nach Stunden im Stillstand die der Luft",
        ),
        MeasuredKey::ResistanceLl => (
            "between two of the three terminals, leads subtracted",
            "zwischen zwei der drei Klemmen, Messleitungen abgezogen",
        ),
        MeasuredKey::InductanceLl => ("between two of the three terminals", "zwischen zwei der drei Klemmen"),
        MeasuredKey::Emf => {
            ("induced voltage, motor driven, terminals open", "induzierte Spannung, Motor angetrieben, Klemmen offen")
        }
        MeasuredKey::EmfVoltage => ("rms, between two terminals", "effektiv, zwischen zwei Klemmen"),
        MeasuredKey::EmfSpeed | MeasuredKey::SpeedMotor => {
            ("speed of the motor, not of the flange", "Drehzahl des Motors, nicht des Flansches")
        }
        MeasuredKey::Sensor => ("sensors in the winding", "Sensoren in der Wicklung"),
        MeasuredKey::SensorTemperature => (
            "temperature of the winding by another thermometer",
            "Temperatur der Wicklung nach einem anderen Thermometer",
        ),
        MeasuredKey::Kty => {
            ("resistance at about 2 mA, with the right polarity", "Widerstand bei etwa 2 mA, richtig gepolt")
        }
        MeasuredKey::Ptc => ("resistance; windings E and N only", "Widerstand; nur Wicklungen E und N"),
        MeasuredKey::Brake => ("holding brake, at its own connector", "Haltebremse, an ihrem Stecker"),
        MeasuredKey::BrakeVoltage => ("at the brake while it opens", "an der Bremse, während sie öffnet"),
        MeasuredKey::OpeningCurrent => ("current while it opens", "Strom, während sie öffnet"),
        MeasuredKey::HoldingCurrent => ("current that keeps it open", "Strom, der sie offen hält"),
        MeasuredKey::OpeningTime => ("from voltage on to free", "vom Einschalten der Spannung bis frei"),
        MeasuredKey::ClosingTime => ("from voltage off to held", "vom Abschalten der Spannung bis gehalten"),
        MeasuredKey::Direction => (
            "seen from the front, uncoupled: cw clockwise, ccw counter-clockwise",
            "von vorne gesehen, ungekuppelt: cw rechts, ccw links",
        ),
        MeasuredKey::DirectionMotor => ("of the motor shaft", "der Motorwelle"),
        MeasuredKey::DirectionFlange => {
            ("of the output flange at the same time", "des Abtriebsflansches zur selben Zeit")
        }
        MeasuredKey::DirectionPosition => (
            "of the motor's encoder at the same time: rising or falling",
            "des Motorgebers zur selben Zeit: rising steigend, falling fallend",
        ),
        MeasuredKey::Speed => ("steady speed, read at the same time", "stetige Drehzahl, zur selben Zeit abgelesen"),
        MeasuredKey::SpeedFlange => ("speed of the output flange", "Drehzahl des Abtriebsflansches"),
        MeasuredKey::SpeedFrequency => ("frequency of the motor current", "Frequenz des Motorstroms"),
        MeasuredKey::NoLoad => (
            "current without load at a steady speed; several [[no_load]] for several speeds",
            "Strom ohne Last bei stetiger Drehzahl; mehrere [[no_load]] für mehrere Drehzahlen",
        ),
        MeasuredKey::NoLoadSpeed => {
            ("speed of the output flange, not of the motor", "Drehzahl des Abtriebsflansches, nicht des Motors")
        }
        MeasuredKey::NoLoadCurrent => ("rms, torque-producing", "effektiv, drehmomentbildend"),
        MeasuredKey::NoLoadTemperature => ("of the housing", "des Gehäuses"),
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}
