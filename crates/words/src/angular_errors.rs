//! Names of the angular errors at the output.

use crate::texts::said;
use actuator::ErrorKind;
use quantities::Language;

/// Returns the name of an angular error.
#[must_use]
pub fn error_kind_text(kind: ErrorKind, language: Language) -> String {
    match kind {
        ErrorKind::TransmissionAccuracy => {
            said!(language => "transmission accuracy of the gear" | "Übertragungsgenauigkeit des Getriebes")
        }
        ErrorKind::Repeatability => {
            said!(language => "repeatability of the gear" | "Wiederholgenauigkeit des Getriebes")
        }
        ErrorKind::Hysteresis => said!(language => "hysteresis of the gear" | "Hysterese des Getriebes"),
        ErrorKind::LostMotion => said!(language => "lost motion of the gear" | "Lost Motion des Getriebes"),
        ErrorKind::FeedbackAccuracy => said!(language => "accuracy of the encoder" | "Genauigkeit des Gebers"),
        ErrorKind::FeedbackResolution => said!(language => "resolution of the encoder" | "Auflösung des Gebers"),
        ErrorKind::Torsion => {
            said!(language => "torsion of the gear under the peak torque" | "Torsion des Getriebes unter dem Spitzendrehmoment")
        }
        ErrorKind::Tilt => {
            said!(language => "tilt of the flange under the largest moment" | "Kippung des Flansches unter dem größten Moment")
        }
        ErrorKind::StageBacklash => said!(language => "backlash of the stage" | "Spiel der Zwischenstufe"),
        ErrorKind::StageTorsion => said!(language => "torsion of the stage" | "Torsion der Zwischenstufe"),
    }
}
