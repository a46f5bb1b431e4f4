//! Words of the keys of `[twin]`.

use crate::pick;
use project::names::{ReplacedName, TwinName};
use quantities::Language;

/// What a key of the simulation is for.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn twin_key_text(name: TwinName, language: Language) -> &'static str {
    let (en, de) = match name {
        TwinName::scenario => ("what happens to the axis", "was mit der Achse geschieht"),
        TwinName::at => ("when the scenario takes place", "wann das Szenario eintritt"),
        TwinName::reaction => ("how the drive ends a motion", "wie der Regler eine Bewegung beendet"),
        TwinName::failure => ("how the encoder fails; without it no signal arrives", "wie der Geber ausfällt; ohne Angabe kommt kein Signal an"),
        TwinName::cycles => ("cycles that are run", "gerechnete Zyklen"),
        TwinName::cold => ("whether everything is as cold as the air at the start", "ob zu Beginn alles so kalt wie die Luft ist"),
        TwinName::friction => ("false leaves out friction of motor and gear", "false lässt die Reibung von Motor und Getriebe weg"),
        TwinName::hysteresis => ("false leaves out the hysteresis of the gear", "false lässt die Hysterese des Getriebes weg"),
        TwinName::kinematic_error => ("false leaves out the kinematic error of the gear", "false lässt den kinematischen Fehler des Getriebes weg"),
        TwinName::delay => ("false leaves out the sample by which the current loop is late", "false lässt die Abtastverzögerung der Stromregelung weg"),
        TwinName::limits => ("false leaves out limits and supervision of the drive", "false lässt Grenzen und Überwachung des Reglers weg"),
        TwinName::noise => ("false leaves out errors of the measured angle and current", "false lässt Fehler von gemessenem Winkel und Strom weg"),
        TwinName::position_gain => ("K_v of the position loop in 1/s", "K_v der Lageregelung in 1/s"),
        TwinName::speed_gain => ("K_p of the speed loop in Nm s/rad at the output", "K_p der Drehzahlregelung in Nm s/rad am Abtrieb"),
        TwinName::speed_time => ("integral-action time of the speed loop", "Nachstellzeit der Drehzahlregelung"),
        TwinName::speed_filter => ("time constant of the filter of the measured speed", "Zeitkonstante des Filters der gemessenen Drehzahl"),
        TwinName::current_gain => ("K_p of the current loop in V/A of a phase", "K_p der Stromregelung in V/A eines Strangs"),
        TwinName::current_time => ("integral-action time of the current loop", "Nachstellzeit der Stromregelung"),
        TwinName::following_error_max => ("following error at which the drive stops", "Schleppfehler, bei dem der Regler anhält"),
        TwinName::measured => ("measured values in the place of those of the tables and of the model", "gemessene Werte anstelle der Werte aus Tabellen und Modell"),
    };
    pick(language, en, de)
}

/// What a measured value is.
#[rustfmt::skip] // one line per key and language
pub(crate) const fn replaced_key_text(name: ReplacedName, language: Language) -> &'static str {
    let (en, de) = match name {
        ReplacedName::resistance_ll => ("resistance line to line at 20 °C", "Widerstand Leiter-Leiter bei 20 °C"),
        ReplacedName::inductance_ll => ("inductance line to line", "Induktivität Leiter-Leiter"),
        ReplacedName::torque_constant_motor => ("torque constant of the motor", "Drehmomentkonstante des Motors"),
        ReplacedName::torque_constant_out => ("torque constant at the output, gear losses included", "Drehmomentkonstante am Abtrieb mit Getriebeverlusten"),
        ReplacedName::voltage_constant_motor => ("voltage constant of the motor, line to line, rms", "Spannungskonstante des Motors, Leiter-Leiter, effektiv"),
        ReplacedName::inertia_out => ("own moment of inertia at the output", "eigenes Massenträgheitsmoment am Abtrieb"),
        ReplacedName::no_load_starting_current => ("no-load starting current", "Leerlaufanlaufstrom"),
        ReplacedName::no_load_current_constant_cold => ("no-load current constant at the colder printed temperature", "Leerlaufstromkonstante bei der kälteren abgedruckten Temperatur"),
        ReplacedName::no_load_current_constant_warm => ("no-load current constant at the warmer printed temperature", "Leerlaufstromkonstante bei der wärmeren abgedruckten Temperatur"),
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
        ReplacedName::feedback_accuracy => ("largest deviation of the motor feedback", "größte Abweichung des Motorgebers"),
        ReplacedName::winding_time_constant => ("thermal time constant of the winding", "thermische Zeitkonstante der Wicklung"),
        ReplacedName::housing_time_constant => ("thermal time constant of the housing", "thermische Zeitkonstante des Gehäuses"),
        ReplacedName::flange_inertia_share => ("share of the own inertia that turns with the flange", "Anteil des eigenen Trägheitsmoments, der mit dem Flansch dreht"),
        ReplacedName::gear_damping_ratio => ("damping ratio of the gear", "Dämpfungsgrad des Getriebes"),
        ReplacedName::breakaway_ratio => ("breakaway torque over running torque at no speed", "Losbrechmoment durch Laufmoment bei Drehzahl null"),
        ReplacedName::kinematic_share_1 => ("share of the kinematic error once a turn of the wave generator", "Anteil des kinematischen Fehlers einmal je Umdrehung des Wave Generators"),
        ReplacedName::kinematic_share_2 => ("share twice a turn of the wave generator", "Anteil zweimal je Umdrehung des Wave Generators"),
        ReplacedName::kinematic_share_4 => ("share four times a turn of the wave generator", "Anteil viermal je Umdrehung des Wave Generators"),
        ReplacedName::kinematic_share_out => ("share once a turn of the output", "Anteil einmal je Umdrehung des Abtriebs"),
        ReplacedName::sensor_lag => ("time constant of the KTY in the winding", "Zeitkonstante des KTY in der Wicklung"),
        ReplacedName::ptc_lag => ("time constant of the PTC in the winding", "Zeitkonstante des PTC in der Wicklung"),
        ReplacedName::ptc_response_temperature => ("response temperature of the PTC", "Ansprechtemperatur des PTC"),
        ReplacedName::link_energy => ("energy in the DC link at 560 V", "Energie im Zwischenkreis bei 560 V"),
        ReplacedName::supply_resistance => ("resistance of the supply of the DC link", "Widerstand der Versorgung des Zwischenkreises"),
        ReplacedName::brake_resistor => ("brake resistor", "Bremswiderstand"),
        ReplacedName::chopper_on => ("switching voltage of the brake resistor over that of the supply", "Einschaltspannung des Bremswiderstands durch die der Versorgung"),
        ReplacedName::chopper_off => ("its switching-off voltage over that of the supply", "seine Ausschaltspannung durch die der Versorgung"),
        ReplacedName::stop_stiffness => ("stiffness of a stop that the load meets", "Steifigkeit eines Anschlags, auf den die Last trifft"),
        ReplacedName::current_noise => ("noise of a measured phase current, effective", "Rauschen eines gemessenen Strangstroms, effektiv"),
        ReplacedName::load_inertia => ("inertia of the load at the output, with the flange", "Massenträgheitsmoment der Last am Abtrieb, mit Flansch"),
        ReplacedName::load_coulomb => ("Coulomb friction of the load", "Coulomb-Reibung der Last"),
        ReplacedName::load_viscous => ("viscous friction of the load", "viskose Reibung der Last"),
        ReplacedName::load_gravity => ("weight of the load at its largest lever", "Gewichtsmoment der Last am größten Hebel"),
        ReplacedName::load_gravity_angle => ("angle of the centre of mass above the horizontal at position 0", "Winkel des Schwerpunkts über der Waagerechten in Stellung 0"),
        ReplacedName::load_external => ("external torque of the load", "äußeres Moment der Last"),
    };
    pick(language, en, de)
}
