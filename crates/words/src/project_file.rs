//! Words for the project file: its tables, its keys, and the words that are values of keys.

use crate::{law_text, shape_title, simulation};
use feedback::Failure;
use project::{BODY_SHAPES, SegmentLaw};
use quantities::Language;
use std::borrow::Cow;
use twin::ScenarioId;

/// Returns the title of a table of the project file; `None` if the table has only the name of its key.
#[must_use]
pub fn table_of_project(name: &str, language: Language) -> Option<&'static str> {
    let (en, de) = match name {
        "" => ("General", "Allgemein"),
        "axis" => ("Axis", "Achse"),
        "catalogue" => ("Catalogue", "Katalog"),
        "twin" => ("Settings of the simulation", "Vorgaben für die Simulation"),
        "load" => ("Load", "Last"),
        "body" => ("Body", "Körper"),
        "stage" => ("Stage", "Zwischenstufe"),
        "motion" => ("Motion, segment", "Bewegung, Abschnitt"),
        "bearing" => ("Loads on the output flange", "Lasten am Abtriebsflansch"),
        "motion.bearing" => (
            "Loads on the output flange, in place of all common ones",
            "Lasten am Abtriebsflansch, anstelle aller gemeinsamen",
        ),
        "requirements" => ("Requirements", "Anforderungen"),
        "drive" => ("Drive", "Servoregler"),
        "actuator" => ("Own actuator", "Eigener Antrieb"),
        "curve" => ("Curve", "Kennlinie"),
        "recorded_ratio" => ("ratios of the recorded gear", "Übersetzungen des aufgezeichneten Getriebes"),
        "measured" => ("measured values", "Messwerte"),
        "columns" => ("columns", "Spalten"),
        "units" => ("units", "Einheiten"),
        _ => return None,
    };
    Some(if language == Language::De { de } else { en })
}

/// Returns a word that is a value of a key; `None` for a value outside a fixed set.
#[must_use]
pub fn key_word(key: &str, word: &str, language: Language) -> Option<Cow<'static, str>> {
    match key {
        // The same motion as the triangle, by its name in VDI 2143.
        "law" if word == "parabola" => {
            let (en, de) = ("quadratic parabola (triangle)", "quadratische Parabel (Dreieck)");
            return Some(if language == Language::De { de } else { en }.into());
        }
        "law" => return SegmentLaw::of_id(word).map(|law| law_text(law, language).into()),
        "shape" => {
            // Those of an arm that no body has stand in the list below.
            if let Some(shape) = BODY_SHAPES.iter().find(|shape| shape.name == word) {
                return Some(shape_title(shape, language).into());
            }
        }
        "scenario" => {
            let scenario = ScenarioId::ALL.iter().find(|each| each.id() == word)?;
            return Some(simulation::scenario_title(*scenario, language).into());
        }
        "failure" => {
            let failure = Failure::ALL.iter().find(|each| each.id() == word)?;
            return Some(simulation::failure_title(Some(*failure), language).into());
        }
        // Parts of an ordering code.
        "feedback" | "option_1" | "option_2" => return Some(word.to_owned().into()),
        // Degrees of protection have the same spelling in both languages.
        "protection" => return Some(word.to_owned().into()),
        _ => {}
    }
    let (_, _, en, de) = KEY_WORDS.iter().find(|(of, known, ..)| (of.is_empty() || *of == key) && *known == word)?;
    Some(Cow::Borrowed(if language == Language::De { de } else { en }))
}

/// Returns the name of a key of a body; `None` for any other key.
#[must_use]
pub fn body_key(key: &str, language: Language) -> Option<&'static str> {
    let (_, en, de) = BODY_KEYS.iter().find(|(name, ..)| *name == key)?;
    Some(if language == Language::De { de } else { en })
}

/// Returns the part of a description that labels a key; the rest is for authors of the file.
#[must_use]
pub fn short_label(label: &str) -> String {
    let label = label.split(';').next().unwrap_or(label);
    // The word of the file for which the description is true; a switch that is off by it is labelled by what it switches.
    let stated = ["true: ", "allow: ", "even: ", "interpolate: "].iter().find_map(|word| label.strip_prefix(word));
    let label = match label.strip_prefix("false: ") {
        Some(off) => OFF.iter().find_map(|tail| off.strip_suffix(tail)).unwrap_or(off),
        None => stated.unwrap_or(label),
    };
    let label = label.replace(" (true)", "").replace(" (false)", "");
    // The sign is shown with the value.
    const TAILS: [&str; 3] =
        [", entgegen der positiven Richtung", ", against the positive direction", ", at the output or along the guide"];
    TAILS.iter().find_map(|tail| label.strip_suffix(tail)).map_or(label.clone(), str::to_owned)
}

/// Ends of a description of what `false` switches off.
const OFF: [&str; 4] = [" is neglected", " are neglected", " wird vernachlässigt", " werden vernachlässigt"];

/// Words of the project file: key, word, English, German. A word without a key is valid for every key.
const KEY_WORDS: &[(&str, &str, &str, &str)] = &[
    ("brake", "true", "required", "gefordert"),
    ("brake", "false", "excluded", "ausgeschlossen"),
    ("", "true", "yes", "ja"),
    ("", "false", "no", "nein"),
    ("hold", "motor", "by the motor", "durch den Motor"),
    ("hold", "brake", "by the brake", "durch die Bremse"),
    ("hold", "free", "not held", "nicht gehalten"),
    ("leave_out", "supply", "supply", "Speisung"),
    ("leave_out", "flange_loads", "loads on the flange", "Lasten am Flansch"),
    ("leave_out", "conditions", "conditions of use", "Einsatzbedingungen"),
    ("leave_out", "application", "field of application", "Anwendungsbereich"),
    ("for", "sinamics", "SINAMICS (Siemens)", "SINAMICS (Siemens)"),
    ("for", "cia402", "CiA 402 (CANopen, EtherCAT)", "CiA 402 (CANopen, EtherCAT)"),
    ("for", "plain", "of no particular manufacturer", "herstellerneutral"),
    ("shape", "bar", "bar with a width", "Balken mit Breite"),
    ("bearing_type", "crossed_roller", "crossed roller bearing", "Kreuzrollenlager"),
    ("bearing_type", "four_point", "four-point contact ball bearing", "Vierpunktlager"),
    ("shape", "taper", "tapering to a point", "spitz zulaufend"),
    ("spline", "cubic", "third degree", "dritter Grad"),
    ("spline", "quintic", "fifth degree", "fünfter Grad"),
    ("ends", "rest", "standstill", "Stillstand"),
    ("ends", "natural", "free", "frei"),
    ("ends", "periodic", "equal at both ends", "an beiden gleich"),
    ("ends", "stated", "as stated", "wie angegeben"),
    ("operating_condition", "normal", "normal", "normal"),
    ("operating_condition", "shock", "shock", "Stöße"),
    ("operating_condition", "high_accuracy", "high accuracy", "hohe Genauigkeit"),
    ("mechanism", "add", "added to the stated loads", "zu den angegebenen addiert"),
    ("mechanism", "replace", "unless a segment states its own", "sofern kein Abschnitt eigene nennt"),
    ("mechanism", "ignore", "ignored", "nicht berücksichtigt"),
    ("kind", "belt", "belt", "Riemen"),
    ("kind", "gear", "gear", "Zahnradstufe"),
    ("kind", "coupling", "coupling", "Kupplung"),
    ("kind", "continuous", "continuous duty", "Dauerbetrieb"),
    ("kind", "s3_50", "intermittent duty S3, 50 %", "Aussetzbetrieb S3, 50 %"),
    ("kind", "s3_25", "intermittent duty S3, 25 %", "Aussetzbetrieb S3, 25 %"),
    ("kind", "short_time", "short-time duty", "Kurzzeitbetrieb"),
    ("axis", "parallel", "parallel to the axis of rotation", "parallel zur Drehachse"),
    ("axis", "perpendicular", "perpendicular to it", "quer zur Drehachse"),
    ("winding", "up", "winding", "Aufwickeln"),
    ("winding", "off", "unwinding", "Abwickeln"),
    ("gaps", "allow", "permitted", "zulässig"),
    ("held_values", "interpolate", "one value for each update", "ein Wert je Aktualisierung"),
    ("time_stamps", "even", "evenly spaced rows", "Zeilen in gleichem Abstand"),
    ("reaction", "ramp", "ramp", "Rampe"),
    ("reaction", "brake", "brake", "Bremse"),
    ("reaction", "coast", "coast to standstill", "Auslaufen"),
    ("", "cw", "clockwise", "rechts"),
    ("", "ccw", "counter-clockwise", "links"),
    ("position", "rising", "rising", "steigend"),
    ("position", "falling", "falling", "fallend"),
    ("mains_phases", "single", "single-phase", "einphasig"),
    ("mains_phases", "three", "three-phase", "dreiphasig"),
    ("mounting", "horizontal", "axis of rotation horizontal", "Drehachse waagerecht"),
    ("mounting", "flange_up", "axis of rotation vertical, flange up", "Drehachse senkrecht, Flansch oben"),
    ("mounting", "flange_down", "axis of rotation vertical, flange down", "Drehachse senkrecht, Flansch unten"),
    ("mounting", "changing", "changing in operation", "im Betrieb wechselnd"),
    ("position_loop", "motor", "motor encoder", "Motorgeber"),
    ("position_loop", "output", "output encoder", "Abtriebsgeber"),
    ("special_application", "aerospace", "aerospace", "Luft- und Raumfahrt"),
    ("special_application", "explosive_atmosphere", "explosive atmosphere", "explosionsfähige Atmosphäre"),
    ("special_application", "nuclear", "nuclear", "Kerntechnik"),
    ("special_application", "vacuum", "vacuum", "Vakuum"),
    ("special_application", "household", "household", "Haushalt"),
    ("special_application", "medical", "medical", "Medizintechnik"),
    ("special_application", "human_contact", "contact with people", "Kontakt mit Menschen"),
    ("special_application", "lifting_of_persons", "lifting of persons", "Heben von Personen"),
    ("special_application", "amusement", "amusement rides", "Fahrgeschäfte"),
];

/// Keys of a body: key, English, German.
const BODY_KEYS: &[(&str, &str, &str)] = &[
    ("diameter", "diameter", "Durchmesser"),
    ("length", "length", "Länge"),
    ("outer", "outer diameter", "Außendurchmesser"),
    ("inner", "inner diameter", "Innendurchmesser"),
    ("a", "a", "a"),
    ("b", "b", "b"),
    ("height", "height", "Höhe"),
    ("mass", "mass", "Masse"),
    ("density", "density", "Dichte"),
    ("distance", "distance", "Abstand"),
    ("angle", "angle", "Winkel"),
    ("count", "count", "Anzahl"),
    ("axis", "axis", "Achse"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use project::{KEYS, Key, Kind};

    /// A word of a project file that a page shows exists in both languages.
    #[test]
    fn every_word_of_a_choice_is_said() {
        fn walk(keys: &[Key], left: &mut Vec<String>) {
            for key in keys {
                if let Kind::OneOf(words) | Kind::ListOf(words) = key.kind {
                    let silent = words.iter().filter(|word| key_word(key.name, word, Language::De).is_none());
                    left.extend(silent.map(|word| format!("{} {word}", key.name)));
                }
                walk(key.kind.keys(true), left);
            }
        }
        let mut left = Vec::new();
        walk(KEYS, &mut left);
        assert!(left.is_empty(), "{left:?}");
    }

    /// A label begins with no word of the project file.
    #[test]
    fn a_label_is_words() {
        fn walk(keys: &[Key], left: &mut Vec<String>) {
            for key in keys {
                let words = match key.kind {
                    Kind::OneOf(words) | Kind::ListOf(words) => words,
                    _ => &["true", "false"],
                };
                let labels = Language::ALL.map(|language| short_label(crate::about_text(key.about, language)));
                let is_file = |label: &String| words.iter().any(|word| label.starts_with(&format!("{word}: ")));
                left.extend(labels.into_iter().filter(is_file));
                // "… is not offered: no" says the opposite of what is meant.
                let abouts = Language::ALL.map(|language| crate::about_text(key.about, language));
                let is_negated = |about: &&str| {
                    let off = about.strip_prefix("false: ").map(|off| off.split(';').next().unwrap_or(off));
                    off.is_some_and(|off| !OFF.iter().any(|tail| off.ends_with(tail)))
                };
                left.extend(abouts.into_iter().filter(is_negated).map(str::to_owned));
                walk(key.kind.keys(true), left);
            }
        }
        let mut left = Vec::new();
        walk(KEYS, &mut left);
        assert!(left.is_empty(), "{left:?}");
        assert_eq!(
            short_label("false: Reibung von Motor und Getriebe wird vernachlässigt"),
            "Reibung von Motor und Getriebe"
        );
    }
}
