//! Words for the keys of an actuator that is not in the catalogue.

use crate::pick;
use project::names::ActuatorName;
use quantities::Language;

/// Returns the purpose of a key of `[actuator]`.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn actuator_key_text(key: ActuatorName, language: Language) -> &'static str {
    let (en, de) = match key {
        ActuatorName::name => ("name of the actuator", "Name des Antriebs"),
        ActuatorName::ratio => ("i, reduction ratio", "i, Untersetzung"),
        ActuatorName::torque_max => ("T_max, maximum torque at the output", "T_max, maximales Drehmoment am Abtrieb"),
        ActuatorName::speed_max => ("n_max, maximum speed at the output", "n_max, maximale Drehzahl am Abtrieb"),
        ActuatorName::speed_motor_max => ("maximum motor speed", "maximale Motordrehzahl"),
        ActuatorName::speed_motor_rated => ("n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
        ActuatorName::inertia_out => (
            "J_out, own moment of inertia at the output",
            "J_out, eigenes Massenträgheitsmoment am Abtrieb",
        ),
        ActuatorName::stall_torque => ("T_0, continuous stall torque at the output", "T_0, Stillstandsdrehmoment am Abtrieb"),
        ActuatorName::stall_current => ("I_0, stall current, rms", "I_0, Stillstandsstrom, effektiv"),
        ActuatorName::current_max => ("I_max, maximum current, rms", "I_max, Maximalstrom, effektiv"),
        ActuatorName::current_demagnetisation => ("I_E, demagnetisation current, rms", "I_E, Entmagnetisierungsstrom, effektiv"),
        ActuatorName::no_load_starting_current => ("I_NLS, no-load starting current, rms", "I_NLS, lastfreier Anlaufstrom, effektiv"),
        ActuatorName::no_load_current_constant_30 => (
            "K_INL, no-load current constant at 30 °C, per output speed",
            "K_INL, Leerlaufstromkonstante bei 30 °C, je Abtriebsdrehzahl",
        ),
        ActuatorName::no_load_current_constant_80 => (
            "K_INL, no-load current constant at 80 °C, per output speed",
            "K_INL, Leerlaufstromkonstante bei 80 °C, je Abtriebsdrehzahl",
        ),
        ActuatorName::torque_constant_out => ("k_Tout, torque constant at the output, per A rms", "k_Tout, Drehmomentkonstante am Abtrieb, je A effektiv"),
        ActuatorName::torque_constant_motor => ("k_TM, torque constant of the motor, per A rms", "k_TM, Drehmomentkonstante des Motors, je A effektiv"),
        ActuatorName::voltage_constant_motor => ("k_EM, voltage constant of the motor, line to line, rms", "k_EM, Spannungskonstante des Motors, Leiter-Leiter, effektiv"),
        ActuatorName::resistance_ll => ("R_LL, resistance line to line at 20 °C", "R_LL, Widerstand Leiter-Leiter bei 20 °C"),
        ActuatorName::winding_temperature_max => (
            "maximum winding temperature, at which the voltage is checked; default: the shutdown threshold of the catalogue",
            "maximale Wicklungstemperatur, bei der die Spannung geprüft wird; ohne Angabe die Abschaltschwelle des Katalogs",
        ),
        ActuatorName::inductance_ll => ("L_LL, inductance line to line", "L_LL, Induktivität Leiter-Leiter"),
        ActuatorName::pole_pairs => ("p, number of pole pairs", "p, Polpaarzahl"),
        ActuatorName::mass => ("m, mass", "m, Masse"),
        ActuatorName::length => ("L, length", "L, Baulänge"),
        ActuatorName::hollow_shaft => ("d_H, hollow shaft bore diameter", "d_H, Hohlwellendurchmesser"),
        ActuatorName::dc_link_max => ("U_DCmax, maximum steady DC link voltage", "U_DCmax, maximale stationäre Zwischenkreisspannung"),
        ActuatorName::terminal_voltage_min => (
            "U_M, terminal voltage from which the performance data are valid",
            "U_M, Klemmenspannung, ab der die Leistungsdaten gelten",
        ),
        ActuatorName::gear_torque_rated => (
            "T_N, rated torque of the gear, for its life",
            "T_N, Nenndrehmoment des Getriebes, für seine Lebensdauer",
        ),
        ActuatorName::gear_torque_mean_max => (
            "T_A, limit of the mean torque of the gear",
            "T_A, Grenzwert des mittleren Drehmoments des Getriebes",
        ),
        ActuatorName::gear_torque_momentary_max => (
            "T_M, limit of the momentary peak torque of the gear, in a collision",
            "T_M, Grenzwert des kurzzeitigen Spitzendrehmoments des Getriebes, bei einer Kollision",
        ),
        ActuatorName::gear_speed_max => (
            "largest input speed of the gear",
            "größte Eingangsdrehzahl des Getriebes",
        ),
        ActuatorName::gear_speed_mean_max => (
            "limit of the mean input speed of the gear",
            "Grenzwert der mittleren Eingangsdrehzahl des Getriebes",
        ),
        ActuatorName::gear_life_rated => (
            "L_10 life of the gear at T_N and n_N",
            "L_10-Lebensdauer des Getriebes bei T_N und n_N",
        ),
        ActuatorName::gear_life_speed => (
            "n_N, input speed to which the life applies",
            "n_N, Eingangsdrehzahl, für die die Lebensdauer gilt",
        ),
        ActuatorName::stiffness_1 => (
            "K_1, torsional stiffness below T_1",
            "K_1, Torsionssteifigkeit unter T_1",
        ),
        ActuatorName::stiffness_2 => (
            "K_2, torsional stiffness between T_1 and T_2",
            "K_2, Torsionssteifigkeit zwischen T_1 und T_2",
        ),
        ActuatorName::stiffness_3 => (
            "K_3, torsional stiffness above T_2",
            "K_3, Torsionssteifigkeit über T_2",
        ),
        ActuatorName::torque_1 => (
            "T_1, end of the first region of stiffness",
            "T_1, Ende des ersten Bereichs der Steifigkeit",
        ),
        ActuatorName::torque_2 => (
            "T_2, end of the second region of stiffness",
            "T_2, Ende des zweiten Bereichs der Steifigkeit",
        ),
        ActuatorName::transmission_accuracy => (
            "transmission accuracy of the gear, at the output",
            "Übertragungsgenauigkeit des Getriebes, am Abtrieb",
        ),
        ActuatorName::repeatability => (
            "repeatability of the gear, in either direction",
            "Wiederholgenauigkeit des Getriebes, in jeder Richtung",
        ),
        ActuatorName::hysteresis_loss => (
            "hysteresis loss of the gear",
            "Hystereseverlust des Getriebes",
        ),
        ActuatorName::lost_motion => ("lost motion of the gear", "Lost Motion des Getriebes"),
        ActuatorName::feedback_resolution => (
            "step of the position, at the output",
            "Schritt der Position, am Abtrieb",
        ),
        ActuatorName::feedback_accuracy => (
            "largest deviation of the position in either direction, at the output",
            "größte Abweichung der Position in jeder Richtung, am Abtrieb",
        ),
        ActuatorName::bearing_type => ("design of the output bearing", "Bauart des Abtriebslagers"),
        ActuatorName::bearing_pitch_diameter => (
            "d_p, pitch circle diameter of the output bearing",
            "d_p, Teilkreisdurchmesser des Abtriebslagers",
        ),
        ActuatorName::bearing_offset => (
            "R, distance of the bearing centre from the flange face",
            "R, Abstand der Lagermitte von der Flanschfläche",
        ),
        ActuatorName::bearing_dynamic => (
            "C, dynamic load rating of the output bearing",
            "C, dynamische Tragzahl des Abtriebslagers",
        ),
        ActuatorName::bearing_static => (
            "C_0, static load rating of the output bearing",
            "C_0, statische Tragzahl des Abtriebslagers",
        ),
        ActuatorName::tilting_moment_max => (
            "permissible tilting moment in motion",
            "zulässiges Kippmoment in Bewegung",
        ),
        ActuatorName::static_moment_max => (
            "permissible tilting moment at standstill",
            "zulässiges Kippmoment im Stillstand",
        ),
        ActuatorName::axial_force_max => (
            "permissible axial force in motion, without other loads",
            "zulässige Axialkraft in Bewegung, ohne andere Lasten",
        ),
        ActuatorName::radial_force_max => (
            "permissible radial force in motion, without other loads",
            "zulässige Radialkraft in Bewegung, ohne andere Lasten",
        ),
        ActuatorName::tilting_stiffness => (
            "K_B, tilting stiffness of the output bearing",
            "K_B, Kippsteifigkeit des Abtriebslagers",
        ),
        ActuatorName::brake_torque => (
            "T_Br, holding torque of the brake, at the output",
            "T_Br, Haltemoment der Bremse, am Abtrieb",
        ),
        ActuatorName::brake_closing_time => (
            "t_c, closing time of the brake",
            "t_c, Schließzeit der Bremse",
        ),
        ActuatorName::brake_opening_time => (
            "t_o, opening time of the brake",
            "t_o, Öffnungszeit der Bremse",
        ),
        ActuatorName::winding_time_constant => (
            "τ_w, thermal time constant of the winding",
            "τ_w, thermische Zeitkonstante der Wicklung",
        ),
        ActuatorName::ambient_min => (
            "lowest permitted ambient temperature in operation",
            "niedrigste zulässige Umgebungstemperatur im Betrieb",
        ),
        ActuatorName::ambient_max => (
            "highest permitted ambient temperature in operation",
            "höchste zulässige Umgebungstemperatur im Betrieb",
        ),
        ActuatorName::short_time_curve => (
            "corner points of the short-time curve, from standstill",
            "Eckpunkte der Kurzzeitkennlinie, ab Stillstand",
        ),
        ActuatorName::continuous_curve => (
            "corner points of the continuous-duty curve, from standstill",
            "Eckpunkte der Dauerbetriebskennlinie, ab Stillstand",
        ),
    };
    pick(language, en, de)
}
