//! Words for the keys of a recording.

use crate::pick;
use project::names::{ColumnsName, RatiosName, UnitsName};
use quantities::Language;

/// Returns the purpose of the key of a column of a recording.
pub(crate) const fn column_text(key: ColumnsName, language: Language) -> &'static str {
    let (en, de) = match key {
        ColumnsName::time => ("name of the time column", "Name der Zeitspalte"),
        ColumnsName::position => {
            ("name of the position column; none: not present", "Name der Positionsspalte; none: nicht vorhanden")
        }
        ColumnsName::speed => (
            "name of the speed column; none: not present",
            "Name der Drehzahl- oder Geschwindigkeitsspalte; none: nicht vorhanden",
        ),
        ColumnsName::torque => (
            "name of the torque or force column; none: not present",
            "Name der Momenten- oder Kraftspalte; none: nicht vorhanden",
        ),
    };
    pick(language, en, de)
}

/// Returns the purpose of the key of a unit of a recording.
pub(crate) const fn unit_text(key: UnitsName, language: Language) -> &'static str {
    let (en, de) = match key {
        UnitsName::time => {
            ("unit of time, if not stated in the file", "Einheit der Zeit, wenn nicht in der Datei angegeben")
        }
        UnitsName::position => {
            ("unit of position, if not stated in the file", "Einheit der Position, wenn nicht in der Datei angegeben")
        }
        UnitsName::speed => {
            ("unit of speed, if not stated in the file", "Einheit der Drehzahl, wenn nicht in der Datei angegeben")
        }
        UnitsName::torque => (
            "unit of torque or force, if not stated in the file",
            "Einheit des Moments oder der Kraft, wenn nicht in der Datei angegeben",
        ),
    };
    pick(language, en, de)
}

/// Returns the purpose of the key of a ratio of a recording.
pub(crate) const fn ratio_text(key: RatiosName, language: Language) -> &'static str {
    let (en, de) = match key {
        RatiosName::position => (
            "turns at the place of recording per turn of the output, negative where it turns the other way; 1: recorded at the output",
            "Umdrehungen am Ort der Aufzeichnung je Umdrehung des Abtriebs, negativ bei Gegensinn; 1: am Abtrieb aufgezeichnet",
        ),
        RatiosName::speed => (
            "speed at the place of recording per speed of the output, negative where it turns the other way; 1: recorded at the output",
            "Drehzahl am Ort der Aufzeichnung je Drehzahl des Abtriebs, negativ bei Gegensinn; 1: am Abtrieb aufgezeichnet",
        ),
        RatiosName::torque => (
            "ratio by which the recorded torque is multiplied, negative where it acts the other way; 1: recorded at the output",
            "Übersetzung, mit der das aufgezeichnete Moment multipliziert wird, negativ bei Gegensinn; 1: am Abtrieb aufgezeichnet",
        ),
    };
    pick(language, en, de)
}
