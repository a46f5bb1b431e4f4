//! Words for the keys of `[twin]`.

use crate::pick;
use project::names::{ReplacedName, TwinName};
use quantities::Language;

/// Returns the purpose of a key of the simulation.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn twin_key_text(name: TwinName, language: Language) -> &'static str {
    let (en, de) = match name {
        TwinName::scenario => ("scenario of the simulation", "Szenario der Simulation"),
        TwinName::at => ("time at which the scenario occurs", "Zeitpunkt des Szenarios"),
        TwinName::reaction => ("stop reaction of the drive", "Stillsetzreaktion des Servoreglers"),
        TwinName::failure => ("type of encoder failure; default: signal loss", "Art des Geberausfalls; ohne Angabe Signalverlust"),
        TwinName::cycles => ("number of cycles simulated", "Anzahl der simulierten Zyklen"),
        TwinName::cold => ("true: start at ambient temperature", "true: Start auf Umgebungstemperatur"),
        TwinName::friction => ("false: friction of motor and gear is neglected", "false: Reibung von Motor und Getriebe wird vernachlässigt"),
        TwinName::hysteresis => ("false: hysteresis of the gear is neglected", "false: Hysterese des Getriebes wird vernachlässigt"),
        TwinName::kinematic_error => ("false: kinematic error of the gear is neglected", "false: kinematischer Getriebefehler wird vernachlässigt"),
        TwinName::delay => ("false: sampling delay of the current loop is neglected", "false: Abtastverzögerung der Stromregelung wird vernachlässigt"),
        TwinName::limits => ("false: limits and monitoring of the drive are neglected", "false: Grenzwerte und Überwachungen des Servoreglers werden vernachlässigt"),
        TwinName::noise => ("false: errors of the measured angle and current are neglected", "false: Messfehler von Winkel und Strom werden vernachlässigt"),
        TwinName::position_gain => ("K_v of the position loop", "K_v der Lageregelung"),
        TwinName::speed_gain => ("K_p of the speed loop at the output", "K_p der Drehzahlregelung am Abtrieb"),
        TwinName::speed_time => ("integral-action time of the speed loop", "Nachstellzeit der Drehzahlregelung"),
        TwinName::speed_filter => ("time constant of the speed actual value filter", "Zeitkonstante des Drehzahlistwertfilters"),
        TwinName::current_gain => ("K_p of the current loop per phase", "K_p der Stromregelung je Strang"),
        TwinName::current_time => ("integral-action time of the current loop", "Nachstellzeit der Stromregelung"),
        TwinName::following_error_max => ("following error at which the drive stops", "Abschaltgrenze des Schleppfehlers"),
        TwinName::measured => ("measured values instead of the values of tables and model", "Messwerte anstelle der Werte aus Tabellen und Modell"),
    };
    pick(language, en, de)
}

/// Returns the name of a measured value.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn replaced_key_text(name: ReplacedName, language: Language) -> &'static str {
    let (en, de) = match name {
        ReplacedName::resistance_ll => ("resistance line to line at 20 °C", "Widerstand Leiter-Leiter bei 20 °C"),
        ReplacedName::inductance_ll => ("inductance line to line", "Induktivität Leiter-Leiter"),
        ReplacedName::torque_constant_motor => ("torque constant of the motor", "Drehmomentkonstante des Motors"),
        ReplacedName::torque_constant_out => ("torque constant at the output, gear losses included", "Drehmomentkonstante am Abtrieb mit Getriebeverlusten"),
        ReplacedName::voltage_constant_motor => ("voltage constant of the motor, line to line, rms", "Spannungskonstante des Motors, Leiter-Leiter, effektiv"),
        ReplacedName::inertia_out => ("own moment of inertia at the output", "eigenes Massenträgheitsmoment am Abtrieb"),
        ReplacedName::no_load_starting_current => ("no-load starting current", "lastfreier Anlaufstrom"),
        ReplacedName::no_load_current_constant_cold => ("no-load current constant at the lower temperature of the table", "Leerlaufstromkonstante bei der niedrigeren Tabellentemperatur"),
        ReplacedName::no_load_current_constant_warm => ("no-load current constant at the higher temperature of the table", "Leerlaufstromkonstante bei der höheren Tabellentemperatur"),
        ReplacedName::gear_torque_1 => ("end of the first stiffness region", "Ende des ersten Steifigkeitsbereichs"),
        ReplacedName::gear_torque_2 => ("end of the second stiffness region", "Ende des zweiten Steifigkeitsbereichs"),
        ReplacedName::gear_stiffness_1 => ("torsional stiffness of the first region", "Torsionssteifigkeit des ersten Bereichs"),
        ReplacedName::gear_stiffness_2 => ("torsional stiffness of the second region", "Torsionssteifigkeit des zweiten Bereichs"),
        ReplacedName::gear_stiffness_3 => ("torsional stiffness of the third region", "Torsionssteifigkeit des dritten Bereichs"),
        ReplacedName::transmission_accuracy => ("transmission accuracy of the gear, peak to peak", "Übertragungsgenauigkeit des Getriebes, Spitze-Spitze"),
        ReplacedName::hysteresis_loss => ("hysteresis loss of the gear", "Hystereseverlust des Getriebes"),
        ReplacedName::lost_motion => ("lost motion of the gear", "Lost Motion des Getriebes"),
        ReplacedName::brake_torque => ("holding torque of the brake at the output", "Haltemoment der Bremse am Abtrieb"),
        ReplacedName::brake_opening_time => ("opening time of the brake", "Öffnungszeit der Bremse"),
        ReplacedName::brake_closing_time => ("closing time of the brake", "Schließzeit der Bremse"),
        ReplacedName::feedback_accuracy => ("largest deviation of the motor encoder", "größte Abweichung des Motorgebers"),
        ReplacedName::winding_time_constant => ("thermal time constant of the winding", "thermische Zeitkonstante der Wicklung"),
        ReplacedName::housing_time_constant => ("thermal time constant of the housing", "thermische Zeitkonstante des Gehäuses"),
        ReplacedName::flange_inertia_share => ("share of the actuator inertia rotating with the flange", "mit dem Flansch umlaufender Anteil des eigenen Massenträgheitsmoments"),
        ReplacedName::gear_damping_ratio => ("damping ratio of the gear", "Dämpfungsgrad des Getriebes"),
        ReplacedName::breakaway_ratio => ("ratio of breakaway torque to running torque at zero speed", "Verhältnis von Losbrechmoment zu Laufmoment bei Drehzahl null"),
        ReplacedName::kinematic_share_1 => ("relative amplitude of the kinematic error once per turn of the wave generator; the four amplitudes are scaled together to the transmission accuracy", "relative Amplitude des kinematischen Fehlers einmal je Umdrehung des Wave Generators; die vier Amplituden werden gemeinsam auf die Übertragungsgenauigkeit skaliert"),
        ReplacedName::kinematic_share_2 => ("relative amplitude twice per turn of the wave generator", "relative Amplitude zweimal je Umdrehung des Wave Generators"),
        ReplacedName::kinematic_share_4 => ("relative amplitude four times per turn of the wave generator", "relative Amplitude viermal je Umdrehung des Wave Generators"),
        ReplacedName::kinematic_share_out => ("relative amplitude once per turn of the output", "relative Amplitude einmal je Umdrehung des Abtriebs"),
        ReplacedName::sensor_lag => ("time constant of the KTY in the winding", "Zeitkonstante des KTY in der Wicklung"),
        ReplacedName::ptc_lag => ("time constant of the PTC in the winding", "Zeitkonstante des PTC in der Wicklung"),
        ReplacedName::ptc_response_temperature => ("response temperature of the PTC", "Ansprechtemperatur des PTC"),
        ReplacedName::link_energy => ("energy in the DC link at nominal supply voltage", "Energie im Zwischenkreis bei Nennspannung der Versorgung"),
        ReplacedName::supply_resistance => ("internal resistance of the DC link supply", "Innenwiderstand der Zwischenkreisversorgung"),
        ReplacedName::brake_resistor => ("braking resistor", "Bremswiderstand"),
        ReplacedName::chopper_on => ("ratio of the switch-on voltage of the braking resistor to the highest supply voltage", "Verhältnis von Einschaltspannung des Bremswiderstands zu größter Versorgungsspannung"),
        ReplacedName::chopper_off => ("ratio of the switch-off voltage of the braking resistor to the highest supply voltage", "Verhältnis von Ausschaltspannung des Bremswiderstands zu größter Versorgungsspannung"),
        ReplacedName::stop_stiffness => ("stiffness of the end stop hit by the load", "Steifigkeit des Anschlags, auf den die Last trifft"),
        ReplacedName::current_noise => ("noise of a measured phase current, rms", "Rauschen eines gemessenen Strangstroms, effektiv"),
        ReplacedName::load_inertia => ("moment of inertia of the load at the output, including the flange", "Massenträgheitsmoment der Last am Abtrieb, mit Flansch"),
        ReplacedName::load_coulomb => ("Coulomb friction of the load", "Coulomb-Reibung der Last"),
        ReplacedName::load_viscous => ("viscous friction of the load", "viskose Reibung der Last"),
        ReplacedName::load_gravity => ("gravity torque of the load at its largest lever arm", "Gewichtsmoment der Last am größten Hebelarm"),
        ReplacedName::load_gravity_angle => ("angle of the centre of mass above the horizontal at position zero", "Winkel des Schwerpunkts über der Waagerechten in Nullposition"),
        ReplacedName::load_external => ("external torque of the load", "äußeres Moment der Last"),
    };
    pick(language, en, de)
}
