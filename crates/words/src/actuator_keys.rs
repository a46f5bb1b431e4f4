//! Words for the keys of an actuator that is not in the catalogue.

use crate::pick;
use project::names::ActuatorValueName;
use quantities::Language;

/// Returns the purpose of a datum of an actuator.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn actuator_key_text(key: ActuatorValueName, language: Language) -> &'static str {
    let (en, de) = match key {
        ActuatorValueName::ratio => ("i, reduction ratio", "i, Untersetzung"),
        ActuatorValueName::torque_max => ("T_max, maximum torque at the output", "T_max, maximales Drehmoment am Abtrieb"),
        ActuatorValueName::speed_max => ("n_max, maximum speed at the output", "n_max, maximale Drehzahl am Abtrieb"),
        ActuatorValueName::speed_motor_max => ("maximum motor speed", "maximale Motordrehzahl"),
        ActuatorValueName::speed_motor_rated => ("n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
        ActuatorValueName::inertia_out => (
            "J_out, own moment of inertia at the output",
            "J_out, eigenes Massenträgheitsmoment am Abtrieb",
        ),
        ActuatorValueName::stall_torque => ("T_0, continuous stall torque at the output", "T_0, Stillstandsdrehmoment am Abtrieb"),
        ActuatorValueName::stall_current => ("I_0, stall current, rms", "I_0, Stillstandsstrom, effektiv"),
        ActuatorValueName::current_max => ("I_max, maximum current, rms", "I_max, Maximalstrom, effektiv"),
        ActuatorValueName::current_demagnetisation => ("I_E, demagnetisation current, rms", "I_E, Entmagnetisierungsstrom, effektiv"),
        ActuatorValueName::no_load_starting_current => ("I_NLS, no-load starting current, rms", "I_NLS, lastfreier Anlaufstrom, effektiv"),
        ActuatorValueName::no_load_current_constant_30 => (
            "K_INL, no-load current constant at 30 °C, per output speed",
            "K_INL, Leerlaufstromkonstante bei 30 °C, je Abtriebsdrehzahl",
        ),
        ActuatorValueName::no_load_current_constant_80 => (
            "K_INL, no-load current constant at 80 °C, per output speed",
            "K_INL, Leerlaufstromkonstante bei 80 °C, je Abtriebsdrehzahl",
        ),
        ActuatorValueName::torque_constant_out => ("k_Tout, torque constant at the output, per A rms", "k_Tout, Drehmomentkonstante am Abtrieb, je A effektiv"),
        ActuatorValueName::torque_constant_motor => ("k_TM, torque constant of the motor, per A rms", "k_TM, Drehmomentkonstante des Motors, je A effektiv"),
        ActuatorValueName::voltage_constant_motor => ("k_EM, voltage constant of the motor, line to line, rms", "k_EM, Spannungskonstante des Motors, Leiter-Leiter, effektiv"),
        ActuatorValueName::resistance_ll => ("R_LL, resistance line to line at 20 °C", "R_LL, Widerstand Leiter-Leiter bei 20 °C"),
        ActuatorValueName::winding_temperature_max => (
            "maximum winding temperature, at which the voltage is checked; default: the shutdown threshold of the catalogue",
            "maximale Wicklungstemperatur, bei der die Spannung geprüft wird; ohne Angabe die Abschaltschwelle des Katalogs",
        ),
        ActuatorValueName::inductance_ll => ("L_LL, inductance line to line", "L_LL, Induktivität Leiter-Leiter"),
        ActuatorValueName::pole_pairs => ("p, number of pole pairs", "p, Polpaarzahl"),
        ActuatorValueName::mass => ("m, mass", "m, Masse"),
        ActuatorValueName::length => ("L, length", "L, Baulänge"),
        ActuatorValueName::hollow_shaft => ("d_H, hollow shaft bore diameter", "d_H, Hohlwellendurchmesser"),
        ActuatorValueName::dc_link_max => ("U_DCmax, maximum steady DC link voltage", "U_DCmax, maximale stationäre Zwischenkreisspannung"),
        ActuatorValueName::terminal_voltage_min => (
            "U_M, terminal voltage from which the performance data are valid",
            "U_M, Klemmenspannung, ab der die Leistungsdaten gelten",
        ),
        ActuatorValueName::gear_torque_rated => (
            "T_N, rated torque of the gear, for its life",
            "T_N, Nenndrehmoment des Getriebes, für seine Lebensdauer",
        ),
        ActuatorValueName::gear_torque_mean_max => (
            "T_A, limit of the mean torque of the gear",
            "T_A, Grenzwert des mittleren Drehmoments des Getriebes",
        ),
        ActuatorValueName::gear_torque_momentary_max => (
            "T_M, limit of the momentary peak torque of the gear, in a collision",
            "T_M, Grenzwert des kurzzeitigen Spitzendrehmoments des Getriebes, bei einer Kollision",
        ),
        ActuatorValueName::gear_speed_max => (
            "largest input speed of the gear",
            "größte Eingangsdrehzahl des Getriebes",
        ),
        ActuatorValueName::gear_speed_mean_max => (
            "limit of the mean input speed of the gear",
            "Grenzwert der mittleren Eingangsdrehzahl des Getriebes",
        ),
        ActuatorValueName::gear_life_rated => (
            "L_10 life of the gear at T_N and n_N",
            "L_10-Lebensdauer des Getriebes bei T_N und n_N",
        ),
        ActuatorValueName::gear_life_speed => (
            "n_N, input speed to which the life applies",
            "n_N, Eingangsdrehzahl, für die die Lebensdauer gilt",
        ),
        ActuatorValueName::stiffness_1 => (
            "K_1, torsional stiffness below T_1",
            "K_1, Torsionssteifigkeit unter T_1",
        ),
        ActuatorValueName::stiffness_2 => (
            "K_2, torsional stiffness between T_1 and T_2",
            "K_2, Torsionssteifigkeit zwischen T_1 und T_2",
        ),
        ActuatorValueName::stiffness_3 => (
            "K_3, torsional stiffness above T_2",
            "K_3, Torsionssteifigkeit über T_2",
        ),
        ActuatorValueName::torque_1 => (
            "T_1, end of the first region of stiffness",
            "T_1, Ende des ersten Bereichs der Steifigkeit",
        ),
        ActuatorValueName::torque_2 => (
            "T_2, end of the second region of stiffness",
            "T_2, Ende des zweiten Bereichs der Steifigkeit",
        ),
        ActuatorValueName::transmission_accuracy => (
            "transmission accuracy of the gear, at the output",
            "Übertragungsgenauigkeit des Getriebes, am Abtrieb",
        ),
        ActuatorValueName::repeatability => (
            "repeatability of the gear, in either direction",
            "Wiederholgenauigkeit des Getriebes, in jeder Richtung",
        ),
        ActuatorValueName::hysteresis_loss => (
            "hysteresis loss of the gear",
            "Hystereseverlust des Getriebes",
        ),
        ActuatorValueName::lost_motion => ("lost motion of the gear", "Lost Motion des Getriebes"),
        ActuatorValueName::feedback_resolution => (
            "step of the position, at the output",
            "Schritt der Position, am Abtrieb",
        ),
        ActuatorValueName::feedback_accuracy => (
            "largest deviation of the position in either direction, at the output",
            "größte Abweichung der Position in jeder Richtung, am Abtrieb",
        ),
        ActuatorValueName::bearing_type => ("design of the output bearing", "Bauart des Abtriebslagers"),
        ActuatorValueName::bearing_pitch_diameter => (
            "d_p, pitch circle diameter of the output bearing",
            "d_p, Teilkreisdurchmesser des Abtriebslagers",
        ),
        ActuatorValueName::bearing_offset => (
            "R, distance of the bearing centre from the flange face",
            "R, Abstand der Lagermitte von der Flanschfläche",
        ),
        ActuatorValueName::bearing_dynamic => (
            "C, dynamic load rating of the output bearing",
            "C, dynamische Tragzahl des Abtriebslagers",
        ),
        ActuatorValueName::bearing_static => (
            "C_0, static load rating of the output bearing",
            "C_0, statische Tragzahl des Abtriebslagers",
        ),
        ActuatorValueName::tilting_moment_max => (
            "permissible tilting moment in motion",
            "zulässiges Kippmoment in Bewegung",
        ),
        ActuatorValueName::static_moment_max => (
            "permissible tilting moment at standstill",
            "zulässiges Kippmoment im Stillstand",
        ),
        ActuatorValueName::axial_force_max => (
            "permissible axial force in motion, without other loads",
            "zulässige Axialkraft in Bewegung, ohne andere Lasten",
        ),
        ActuatorValueName::radial_force_max => (
            "permissible radial force in motion, without other loads",
            "zulässige Radialkraft in Bewegung, ohne andere Lasten",
        ),
        ActuatorValueName::tilting_stiffness => (
            "K_B, tilting stiffness of the output bearing",
            "K_B, Kippsteifigkeit des Abtriebslagers",
        ),
        ActuatorValueName::brake_torque => (
            "T_Br, holding torque of the brake, at the output",
            "T_Br, Haltemoment der Bremse, am Abtrieb",
        ),
        ActuatorValueName::brake_closing_time => (
            "t_c, closing time of the brake",
            "t_c, Schließzeit der Bremse",
        ),
        ActuatorValueName::brake_opening_time => (
            "t_o, opening time of the brake",
            "t_o, Öffnungszeit der Bremse",
        ),
        ActuatorValueName::winding_time_constant => (
            "τ_w, thermal time constant of the winding",
            "τ_w, thermische Zeitkonstante der Wicklung",
        ),
        ActuatorValueName::ambient_min => (
            "lowest permissible ambient temperature in operation",
            "niedrigste zulässige Umgebungstemperatur im Betrieb",
        ),
        ActuatorValueName::ambient_max => (
            "highest permissible ambient temperature in operation",
            "höchste zulässige Umgebungstemperatur im Betrieb",
        ),
        ActuatorValueName::short_time_curve => (
            "corner points of the short-time curve, from standstill",
            "Eckpunkte der Kurzzeitkennlinie, ab Stillstand",
        ),
        ActuatorValueName::continuous_curve => (
            "corner points of the continuous-duty curve, from standstill",
            "Eckpunkte der Dauerbetriebskennlinie, ab Stillstand",
        ),
    };
    pick(language, en, de)
}
