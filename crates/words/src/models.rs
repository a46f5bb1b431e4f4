//! Names of the models, and of the chapters of the theory that describe them.

use crate::pick;
use quantities::Language;

/// Returns the name of a model; the identifier is that of its page in docs/theory.
#[must_use]
pub fn model_name(id: &'static str, language: Language) -> &'static str {
    MODELS.iter().find(|(model, ..)| *model == id).map_or(id, |(_, en, de)| pick(language, en, de))
}

/// Models by the pages in docs/theory, with their names in English and German.
pub const MODELS: [(&str, &str, &str); 20] = [
    ("battery", "battery", "Batterie"),
    ("brake", "brake", "Bremse"),
    ("continuous-torque", "continuous torque", "Dauerdrehmoment"),
    ("current", "motor current", "Motorstrom"),
    ("demand", "demand", "Belastung"),
    ("energy", "energy", "Energie"),
    ("error-budget", "error budget", "Fehlersumme"),
    ("feedback", "encoder", "Geber"),
    ("flange-loads", "flange loads", "Flanschlasten"),
    ("gear", "gear", "Getriebe"),
    ("mechanisms", "mechanism", "Mechanik"),
    ("moments", "time integrals", "Zeitintegrale"),
    ("output-bearing", "output bearing", "Abtriebslager"),
    ("overload", "overload", "Überlast"),
    ("screw-joint", "bolted joint", "Schraubenverbindung"),
    ("short-time-torque", "short-time torque", "Kurzzeitdrehmoment"),
    ("stage", "stage", "Stufe"),
    ("thermal", "heating", "Erwärmung"),
    ("twin", "digital twin", "digitaler Zwilling"),
    ("voltage", "terminal voltage", "Klemmenspannung"),
];

/// Returns the title of a chapter of the theory, for lists of chapters.
#[must_use]
pub fn chapter_name(id: &'static str, language: Language) -> &'static str {
    let (en, de) = match id {
        "motion-laws" => ("motion laws", "Bewegungsgesetze"),
        "recorded-motion" => ("recorded motion", "aufgezeichnete Bewegung"),
        "sweep" => ("sweeps", "Parameterstudien"),
        "tolerances" => ("tolerances", "Toleranzen"),
        model => return model_name(model, language),
    };
    pick(language, en, de)
}
