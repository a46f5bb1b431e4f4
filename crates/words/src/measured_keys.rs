//! Words for the keys of a record of measured values.

use crate::pick;
use crate::{commission, measurand_name, terms};
use installation::commission::expected::Measurand;
use project::MeasuredKey;
use project::names::{
    BrakeName, DirectionName, EmfName, MeasuredRootName, NoLoadName, SensorName, SpeedName, WindingName,
};
use quantities::Language;

/// Returns the label of a key of a record, or the title of its table.
#[must_use]
pub const fn measured_label(key: MeasuredKey, language: Language) -> &'static str {
    if let Some(what) = axis::measurand(key) {
        return measurand_name(what, language);
    }
    let (en, de) = match key {
        MeasuredKey::Root(MeasuredRootName::no_load) => return measurand_name(Measurand::NoLoadCurrent, language),
        MeasuredKey::Root(MeasuredRootName::winding) => return terms::winding(language),
        MeasuredKey::Root(MeasuredRootName::format) => ("format", "Format"),
        MeasuredKey::Winding(WindingName::temperature)
        | MeasuredKey::Sensor(SensorName::temperature)
        | MeasuredKey::NoLoad(NoLoadName::temperature) => {
            return commission::temperature(language);
        }
        MeasuredKey::Root(MeasuredRootName::emf) => ("induced voltage", "induzierte Spannung"),
        MeasuredKey::Emf(EmfName::speed_motor) | MeasuredKey::Speed(SpeedName::motor) => {
            ("motor speed", "Motordrehzahl")
        }
        MeasuredKey::Root(MeasuredRootName::sensor) => ("temperature sensors", "Temperatursensoren"),
        MeasuredKey::Root(MeasuredRootName::brake) => ("brake", "Bremse"),
        MeasuredKey::Root(MeasuredRootName::direction) => ("directions of rotation", "Drehrichtungen"),
        MeasuredKey::Direction(DirectionName::motor) => ("motor shaft turns", "Motorwelle dreht"),
        MeasuredKey::Direction(DirectionName::flange) => ("flange turns", "Flansch dreht"),
        MeasuredKey::Direction(DirectionName::position) => ("position is", "Position ist"),
        MeasuredKey::Root(MeasuredRootName::speed) => return terms::rotary_speed(language),
        MeasuredKey::Speed(SpeedName::flange) | MeasuredKey::NoLoad(NoLoadName::speed_out) => {
            ("flange speed", "Flanschdrehzahl")
        }
        MeasuredKey::Speed(SpeedName::electrical_frequency) => {
            ("frequency of the motor current", "Frequenz des Motorstroms")
        }
        // A measured value has the name of its measurand.
        MeasuredKey::Winding(WindingName::resistance_ll | WindingName::inductance_ll)
        | MeasuredKey::Emf(EmfName::voltage_ll)
        | MeasuredKey::Sensor(SensorName::kty | SensorName::ptc)
        | MeasuredKey::Brake(_)
        | MeasuredKey::NoLoad(NoLoadName::current) => ("", ""),
    };
    pick(language, en, de)
}

/// Returns the purpose of a key of a record.
#[must_use]
pub const fn measured_key_text(key: MeasuredKey, language: Language) -> &'static str {
    let (en, de) = match key {
        MeasuredKey::Root(MeasuredRootName::format) => ("version of the file format, 1", "Version des Dateiformats, 1"),
        MeasuredKey::Root(MeasuredRootName::winding) => {
            ("winding, disconnected from the drive", "Wicklung, vom Servoregler getrennt")
        }
        MeasuredKey::Winding(WindingName::temperature) => (
            "winding temperature, measured with the KTY, or the air temperature after several hours at standstill",
            "Wicklungstemperatur, mit dem KTY gemessen, oder Lufttemperatur nach mehreren Stunden Stillstand",
        ),
        MeasuredKey::Winding(WindingName::resistance_ll) => (
            "between two of the three terminals, without test leads",
            "zwischen zwei der drei Klemmen, ohne Messleitungen",
        ),
        MeasuredKey::Winding(WindingName::inductance_ll) => {
            ("between two of the three terminals", "zwischen zwei der drei Klemmen")
        }
        MeasuredKey::Root(MeasuredRootName::emf) => {
            ("induced voltage, motor driven, terminals open", "induzierte Spannung, Motor angetrieben, Klemmen offen")
        }
        MeasuredKey::Emf(EmfName::voltage_ll) => ("rms, between two terminals", "effektiv, zwischen zwei Klemmen"),
        MeasuredKey::Emf(EmfName::speed_motor) | MeasuredKey::Speed(SpeedName::motor) => {
            ("motor speed, not flange speed", "Motordrehzahl, nicht Flanschdrehzahl")
        }
        MeasuredKey::Root(MeasuredRootName::sensor) => ("sensors in the winding", "Sensoren in der Wicklung"),
        MeasuredKey::Sensor(SensorName::temperature) => (
            "winding temperature measured with another thermometer",
            "Wicklungstemperatur, mit einem anderen Thermometer gemessen",
        ),
        MeasuredKey::Sensor(SensorName::kty) => {
            ("resistance at about 2 mA, with correct polarity", "Widerstand bei etwa 2 mA, richtig gepolt")
        }
        MeasuredKey::Sensor(SensorName::ptc) => {
            ("resistance; windings E and N only", "Widerstand; nur Wicklungen E und N")
        }
        MeasuredKey::Root(MeasuredRootName::brake) => {
            ("holding brake, at its own connector", "Haltebremse, an ihrem Stecker")
        }
        MeasuredKey::Brake(BrakeName::voltage) => ("at the brake during opening", "an der Bremse beim Öffnen"),
        MeasuredKey::Brake(BrakeName::opening_current) => ("current during opening", "Strom beim Öffnen"),
        MeasuredKey::Brake(BrakeName::holding_current) => ("current while held open", "Strom im geöffneten Zustand"),
        MeasuredKey::Brake(BrakeName::opening_time) => {
            ("from switching on the voltage until released", "vom Einschalten der Spannung bis zum Öffnen")
        }
        MeasuredKey::Brake(BrakeName::closing_time) => {
            ("from switching off the voltage until engaged", "vom Abschalten der Spannung bis zum Schließen")
        }
        MeasuredKey::Root(MeasuredRootName::direction) => (
            "seen from the front, uncoupled: cw clockwise, ccw counter-clockwise",
            "von vorne gesehen, ungekuppelt: cw Rechtslauf, ccw Linkslauf",
        ),
        MeasuredKey::Direction(DirectionName::motor) => ("of the motor shaft", "der Motorwelle"),
        MeasuredKey::Direction(DirectionName::flange) => {
            ("of the output flange at the same time", "des Abtriebsflansches, gleichzeitig")
        }
        MeasuredKey::Direction(DirectionName::position) => (
            "of the motor encoder at the same time: rising or falling",
            "des Motorgebers, gleichzeitig: rising steigend, falling fallend",
        ),
        MeasuredKey::Root(MeasuredRootName::speed) => {
            ("constant speed, read at the same time", "konstante Drehzahl, gleichzeitig abgelesen")
        }
        MeasuredKey::Speed(SpeedName::flange) => ("speed of the output flange", "Drehzahl des Abtriebsflansches"),
        MeasuredKey::Speed(SpeedName::electrical_frequency) => {
            ("frequency of the motor current", "Frequenz des Motorstroms")
        }
        MeasuredKey::Root(MeasuredRootName::no_load) => (
            "no-load current at constant speed; one entry per speed",
            "Leerlaufstrom bei konstanter Drehzahl; je Drehzahl ein Eintrag",
        ),
        MeasuredKey::NoLoad(NoLoadName::speed_out) => {
            ("speed of the output flange, not of the motor", "Drehzahl des Abtriebsflansches, nicht des Motors")
        }
        MeasuredKey::NoLoad(NoLoadName::current) => ("rms, torque-producing", "effektiv, drehmomentbildend"),
        MeasuredKey::NoLoad(NoLoadName::temperature) => ("of the housing", "des Gehäuses"),
    };
    pick(language, en, de)
}
