//! Symbols of derivations, and what was searched or integrated.

use super::either;
use quantities::Language;

/// Greek letters by the names that symbols write.
const GREEK: [(&str, &str); 12] = [
    ("alpha", "α"),
    ("dtheta", "Δϑ"),
    ("gamma", "γ"),
    ("kappa", "κ"),
    ("mu", "µ"),
    ("omega", "ω"),
    ("phi", "φ"),
    ("psi", "ψ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("theta", "ϑ"),
];

/// A symbol as people write it: `omega_1` is ω_1.
#[must_use]
pub fn symbol_shown(symbol: &str) -> String {
    let (head, tail) = symbol.split_once('_').map_or((symbol, None), |(head, tail)| (head, Some(tail)));
    let head = GREEK.iter().find(|(name, _)| *name == head).map_or(head, |(_, letter)| letter);
    tail.map_or_else(|| head.to_owned(), |tail| format!("{head}_{tail}"))
}

/// What was searched or integrated, in words: English as the checks note it, German.
const FOUND: &[(&str, &str)] = &[
    ("acceleration at t", "Beschleunigung bei t"),
    ("continuous curve at n_av", "Dauerkennlinie bei n_av"),
    ("direction at t", "Richtung bei t"),
    ("largest current at n within U_M", "größter Strom bei n innerhalb U_M"),
    ("largest minus smallest position over the cycle", "größte minus kleinste Lage im Zyklus"),
    (
        "largest of the first-order lag of (I/I_0)² with tau_w in the steady cycle",
        "Größtwert der Verzögerung erster Ordnung von (I/I_0)² mit tau_w im eingeschwungenen Zyklus",
    ),
    ("largest on the way", "größtes auf dem Weg"),
    (
        "largest rise of the winding above its mean, τ_w = 60 s, τ_h = 2400 s",
        "größte Erwärmung der Wicklung über ihr Mittel, τ_w = 60 s, τ_h = 2400 s",
    ),
    ("life for t_op a day after t_store", "Lebensdauer bei t_op je Tag nach t_store"),
    (
        "max |torque that holds the load without friction| over the cycle",
        "max |Moment, das die Last ohne Reibung hält| im Zyklus",
    ),
    ("mean of 1.5 R_hot I² + w I_f k_TM ω_mot over the cycle", "Mittel von 1,5 R_hot I² + w I_f k_TM ω_mot im Zyklus"),
    ("n is above n_end", "n liegt über n_end"),
    ("n_av is above n_N_out: no continuous duty", "n_av liegt über n_N_out: kein Dauerbetrieb"),
    ("over the cycle", "im Zyklus"),
    ("over the segments", "über die Abschnitte"),
    ("short-time curve at n, at most T_max", "Kurzzeitkennlinie bei n, höchstens T_max"),
    ("speed at t", "Drehzahl bei t"),
    ("torque of the load at t", "Moment der Last bei t"),
    ("torque of the load that drives on, at most", "Moment der Last, das weiter antreibt, höchstens"),
    (
        "upper bound of U_LL between this instant and the next",
        "obere Schranke von U_LL zwischen diesem und dem nächsten Zeitpunkt",
    ),
    (" where ", " wo "),
];

/// What was searched or integrated, as it is told to people.
#[must_use]
pub fn found_text(text: &'static str, language: Language) -> String {
    let whole = FOUND.iter().find(|(en, _)| *en == text);
    let words = match (whole, language) {
        (_, Language::En) => text.to_owned(),
        (Some((_, de)), Language::De) => (*de).to_owned(),
        // A formula with a few words around it.
        (None, Language::De) => FOUND.iter().fold(text.to_owned(), |text, (en, de)| text.replace(en, de)),
    };
    either(language, words.clone(), words.replace("1.5 ", "1,5 "))
}

/// Symbols of derivations that are no printed cell: English, German.
const TERMS: &[(&str, &str, &str)] = &[
    ("alpha", "angular acceleration", "Winkelbeschleunigung"),
    ("alpha_rms", "effective acceleration", "effektive Beschleunigung"),
    ("band", "half width of the estimate's band", "halbe Bandbreite der Schätzung"),
    ("dtheta", "swing of the winding's temperature", "Temperaturschwankung der Wicklung"),
    ("E_reg", "energy given back in one cycle", "in einem Zyklus zurückgegebene Energie"),
    ("F", "loss against standstill", "Verlust gegenüber Stillstand"),
    ("F_a", "axial force", "Axialkraft"),
    ("F_r", "radial force", "Radialkraft"),
    ("f_w", "load factor", "Betriebsfaktor"),
    ("I", "motor current", "Motorstrom"),
    ("I_f", "current of friction", "Reibstrom"),
    ("I_peak", "peak current", "Spitzenstrom"),
    ("I_th", "current at the permissible loss", "Strom beim zulässigen Verlust"),
    ("I_U", "current at the voltage limit", "Strom an der Spannungsgrenze"),
    ("i_q", "torque-forming current, peak of a phase", "momentbildender Strom, Scheitelwert eines Strangs"),
    ("J", "inertia of load and actuator", "Trägheit von Last und Antrieb"),
    ("J_L", "moment of inertia of the load", "Massenträgheitsmoment der Last"),
    ("J_L_rec", "recommended for high dynamics", "empfohlen für hohe Dynamik"),
    ("L", "inductance of a phase", "Stranginduktivität"),
    ("L_a", "distance of the axial force from the axis", "Abstand der Axialkraft von der Drehachse"),
    ("L_asked", "life asked for", "geforderte Lebensdauer"),
    ("L_bat", "life of the battery", "Lebensdauer der Batterie"),
    ("L_r", "distance of the radial force from the flange", "Abstand der Radialkraft vom Flansch"),
    ("m", "modulation reserve", "Modulationsreserve"),
    ("n", "output speed", "Abtriebsdrehzahl"),
    ("n_2", "running speed", "Drehzahl der Bewegung"),
    ("n_av", "mean output speed", "mittlere Abtriebsdrehzahl"),
    ("n_max", "largest output speed", "größte Abtriebsdrehzahl"),
    ("n_N_out", "rated motor speed at the output", "Bemessungsdrehzahl am Abtrieb"),
    ("n_peak", "peak output speed", "Spitzendrehzahl am Abtrieb"),
    ("N", "absolute turns of the encoder", "absolute Umdrehungen des Gebers"),
    ("N_out", "absolute range at the output", "absoluter Bereich am Abtrieb"),
    ("N_stops", "stops asked for", "geforderte Nothalte"),
    ("omega_1", "speed when the brake takes hold", "Drehzahl, wenn die Bremse greift"),
    ("omega_e", "electrical angular frequency", "elektrische Kreisfrequenz"),
    ("P_0", "loss at I_0", "Verlust bei I_0"),
    ("P_f", "loss by friction", "Reibverlust"),
    ("P_mean", "mean loss of the cycle", "mittlerer Verlust im Zyklus"),
    ("P_perm", "power that can be taken back", "aufnehmbare Leistung"),
    ("P_reg", "mean power given back", "mittlere Rückspeiseleistung"),
    ("phi", "angle travelled", "zurückgelegter Winkel"),
    ("phi_stop", "stop by the brake alone", "Halt allein durch die Bremse"),
    ("psi", "flux linkage, peak of a phase", "Flussverkettung, Scheitelwert eines Strangs"),
    ("R", "resistance of a phase, hot", "Strangwiderstand, warm"),
    ("R_hot", "resistance at 80 °C", "Widerstand bei 80 °C"),
    ("rho", "correlation of acceleration and load torque", "Korrelation von Beschleunigung und Lastmoment"),
    ("s_mot", "step at the motor", "Schritt am Motor"),
    ("s_out", "step at the output", "Schritt am Abtrieb"),
    ("sigma", "direction of motion", "Bewegungsrichtung"),
    ("t", "instant", "Zeitpunkt"),
    ("T", "torque at the output", "Drehmoment am Abtrieb"),
    ("t_0", "cycle time", "Zykluszeit"),
    ("t_1", "acceleration time", "Beschleunigungszeit"),
    ("t_2", "time at constant speed", "Zeit mit konstanter Drehzahl"),
    ("t_3", "braking time", "Bremszeit"),
    ("t_p", "pause", "Pausenzeit"),
    ("T_1", "torque while accelerating", "Drehmoment beim Beschleunigen"),
    ("T_2", "torque at constant speed", "Drehmoment bei konstanter Drehzahl"),
    ("T_3", "torque while braking", "Drehmoment beim Bremsen"),
    ("T_at", "torque there", "Drehmoment dort"),
    ("T_cont", "continuous torque", "Dauerdrehmoment"),
    ("T_curve", "torque of the curve", "Drehmoment der Kennlinie"),
    ("T_d", "torque that drives on", "antreibendes Moment"),
    ("T_hold", "torque to be held", "zu haltendes Moment"),
    ("T_L", "torque of the load", "Lastmoment"),
    ("T_L_rms", "effective torque of the load", "effektives Lastmoment"),
    ("T_peak", "peak torque", "Spitzenmoment"),
    ("T_rms", "effective torque", "effektives Drehmoment"),
    ("T_short", "short-time torque", "Kurzzeitdrehmoment"),
    ("T_th", "torque at the permissible loss", "Drehmoment beim zulässigen Verlust"),
    ("T_trans", "torque that the screws transmit", "von den Schrauben übertragbares Moment"),
    ("tau_w", "time constant of the winding", "Zeitkonstante der Wicklung"),
    ("theta_a", "ambient temperature", "Umgebungstemperatur"),
    ("theta_m", "mean temperature of the winding", "mittlere Wicklungstemperatur"),
    ("theta_w", "temperature of the winding", "Wicklungstemperatur"),
    ("theta_warn", "warning threshold", "Warnschwelle"),
    ("U", "terminal voltage", "Klemmenspannung"),
    ("u_d", "voltage across the flux", "Spannung in Flussrichtung"),
    ("U_DC", "DC link voltage", "Zwischenkreisspannung"),
    ("U_LL", "terminal voltage, fundamental, rms", "Klemmenspannung, Grundwelle, effektiv"),
    ("U_M", "available terminal voltage", "verfügbare Klemmenspannung"),
    ("u_q", "voltage along the torque", "Spannung in Momentrichtung"),
    ("w", "share of the friction loss", "Anteil des Reibverlusts"),
    ("y", "overload integral", "Überlastintegral"),
];

/// The word for a symbol that a derivation makes; empty where none is needed.
pub(crate) fn step_term(symbol: &str, language: Language) -> &'static str {
    TERMS.iter().find(|(name, ..)| *name == symbol).map_or("", |(_, en, de)| match language {
        Language::En => en,
        Language::De => de,
    })
}
