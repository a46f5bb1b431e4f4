//! Words of both languages for the values of options with a choice.

/// Values of an option, each with its other words.
type Values = &'static [(&'static str, &'static [&'static str])];

/// Options with a choice, each with its values and their other words; kinds and drives have titles of their own, and so have checks besides.
#[rustfmt::skip] // one line per value
pub const CHOICES: &[(&str, Values)] = &[
    ("reaction", &[
        ("ramp", &["deceleration ramp", "rampe", "bremsrampe", "verzögerungsrampe"]),
        ("brake", &["holding brake", "bremse", "haltebremse"]),
        ("coast", &["coast down", "freewheel", "austrudeln", "auslaufen", "freier auslauf"]),
    ]),
    ("scenario", &[
        ("cycle", &["motion", "zyklus", "takt"]),
        ("emergency_stop", &["e-stop", "estop", "quick stop", "not-aus", "not-halt", "schnellhalt", "schnellstopp"]),
        ("power_failure", &["power loss", "blackout", "netzausfall", "stromausfall"]),
        ("brake_stuck", &["stuck brake", "jammed brake", "bremse klemmt", "klemmende bremse"]),
        ("hanging_load", &["vertical load", "gravity load", "schwerkraft", "schwerkraftbelastete achse"]),
        ("blocked_load", &["jam", "blocked", "stall", "blockade", "blockierung", "blockierte last"]),
        ("encoder_failure", &["encoder fault", "geberausfall", "geberfehler"]),
        ("battery_loss", &["battery failure", "empty battery", "batterieausfall", "batterie leer"]),
        ("link_sag", &["voltage sag", "undervoltage", "spannungseinbruch", "unterspannung"]),
        ("hot_ambient", &["heat", "hot", "hitze", "hohe umgebungstemperatur"]),
        ("cold_grease", &["cold", "cold start", "kälte", "kaltstart", "kaltes fett"]),
        ("collision", &["crash", "kollision", "anprall"]),
    ]),
    ("failure", &[
        ("track", &["signal loss", "spur", "spurausfall", "signalausfall"]),
        ("amplitude", &["amplituden", "signalamplitude"]),
        ("cable", &["broken cable", "cable break", "kabel", "kabelbruch"]),
        ("check", &["checksum", "crc", "prüfsumme"]),
        ("error_bit", &["error", "fehlerbit", "fehler"]),
        ("data_line", &["data", "datenleitung", "daten"]),
    ]),
    ("figure", &[
        ("torque_speed", &["torque-speed curve", "torque-speed plane", "drehmoment drehzahl", "kennlinie", "kennfeld"]),
        ("cycle", &["motion", "motion profile", "zyklus", "bewegung"]),
        ("utilisation", &["utilization", "load factor", "auslastung", "ausnutzung"]),
        ("torsion", &["stiffness", "verdrehung", "steifigkeit"]),
        ("bearing_load", &["bearing", "lager", "lagerlast", "lagerbelastung"]),
        ("candidate_map", &["candidates", "ranking", "kandidaten", "rangfolge"]),
        ("simulation", &["trace", "simulated run", "verlauf", "aufzeichnung"]),
        ("control_loops", &["bode", "frequency response", "regelkreise", "frequenzgang"]),
    ]),
    ("table", &[
        ("inputs", &["input", "eingaben", "eingabewerte"]),
        ("assumptions", &["assumed", "annahmen"]),
        ("demand", &["requirement", "bedarf", "anforderung"]),
        ("motion", &["cycle", "bewegung", "zyklus"]),
        ("candidates", &["ranking", "actuators", "kandidaten", "rangfolge", "antriebe"]),
        ("checks", &["nachweise", "nachweis"]),
        ("course", &["trace", "time course", "verlauf", "zeitverlauf"]),
    ]),
    ("by", &[
        ("mass", &["weight", "masse", "gewicht"]),
        ("length", &["overall length", "länge", "baulänge"]),
        ("sobol", &["quasi-random", "quasizufällig"]),
        ("lhs", &["latin hypercube", "lateinisches hyperquadrat"]),
        ("grid", &["full factorial", "raster", "gitter"]),
    ]),
    // Symbols of the values of the checks, and words that mean one check alone.
    ("check", &[
        ("peak_torque", &["t_peak", "t_max", "maximum torque", "spitzenmoment", "maximales drehmoment"]),
        ("peak_speed", &["n_peak", "n_max", "speed", "maximum speed", "drehzahl", "spitzendrehzahl"]),
        ("mean_speed", &["n_av", "average speed", "mittlere drehzahl"]),
        ("continuous_torque", &["t_rms", "rms torque", "effective torque", "effektivmoment", "effektives drehmoment"]),
        ("peak_current", &["i_peak", "i_max", "current", "maximum current", "strom", "spitzenstrom"]),
        ("gear_mean_torque", &["t_av", "average torque", "mittleres drehmoment"]),
        ("torsion", &["twist", "windup", "wind-up", "verdrehung"]),
        ("natural_frequency", &["frequency", "resonance", "eigenfrequenz", "frequenz", "resonanz"]),
        ("bearing_axial", &["f_a", "axial force", "axial load", "axialkraft"]),
        ("bearing_radial", &["f_r", "radial force", "radial load", "radialkraft"]),
        ("bearing_tilting_moment", &["m_k", "tilting moment", "kippmoment"]),
        ("bearing_life", &["l_10", "l10", "l_10h", "lagerlebensdauer"]),
        ("bearing_static", &["f_s", "static safety", "statische sicherheit"]),
        ("thermal", &["temperature", "heat", "heating", "temperatur", "erwärmung", "wärme"]),
        ("overload_i2t", &["i2t", "i²t", "overload", "überlast"]),
        ("regeneration", &["braking energy", "braking resistor", "bremsenergie", "bremswiderstand", "rückspeisung"]),
    ]),
    ("connector", &[
        ("motor", &["power", "leistung"]),
        ("feedback", &["encoder", "motor encoder", "geber", "motorgeber"]),
        ("output_encoder", &["encoder at the output", "abtriebsgeber"]),
    ]),
    ("protocol", &[
        ("line", &["lines", "text", "zeilen"]),
        ("socketcand", &["can", "canopen", "can-bus"]),
    ]),
    ("time", &[
        ("real", &["real time", "echtzeit"]),
        ("stepped", &["steps", "simulated", "schrittweise"]),
    ]),
    ("inputs", &[
        ("table", &["columns", "tabelle", "spalten"]),
        ("all", &["everything", "alle", "alles"]),
    ]),
    ("theme", &[
        ("light", &["white", "hell"]),
        ("dark", &["black", "dunkel"]),
    ]),
    ("format", &[
        ("xlsx", &["excel", "workbook", "arbeitsmappe"]),
        ("csv", &["table", "tabelle"]),
        ("svg", &["picture", "bild"]),
    ]),
];

/// Returns the value of an option that another word stands for; case, blanks and hyphens do not matter.
#[must_use]
pub fn choice(option: &str, written: &str) -> Option<&'static str> {
    let joined = |text: &str| -> String {
        let letters = text.to_lowercase().replace([' ', '-', '_'], "");
        [('ä', "ae"), ('ö', "oe"), ('ü', "ue"), ('ß', "ss")]
            .iter()
            .fold(letters, |text, (letter, plain)| text.replace(*letter, plain))
    };
    let written = joined(written);
    let (_, values) = CHOICES.iter().find(|(name, _)| *name == option)?;
    let is_it = |(_, words): &&(&str, &'static [&'static str])| words.iter().any(|word| joined(word) == written);
    values.iter().find(is_it).map(|(value, _)| *value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn a_word_names_one_value_of_an_option() {
        for (option, values) in CHOICES {
            let own: BTreeSet<&str> = values.iter().map(|(value, _)| *value).collect();
            assert_eq!(own.len(), values.len(), "{option}");
            for (value, words) in *values {
                for word in *words {
                    assert!(!own.contains(word), "{option} {word}");
                    assert_eq!(choice(option, &word.to_uppercase()), Some(*value), "{option} {word}");
                }
            }
        }
    }
}
