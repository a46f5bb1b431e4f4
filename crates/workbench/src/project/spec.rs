//! The project file, key by key: one description from which the reader, its messages and the JSON Schema come.

use quantities::Dimension;

/// Which numbers a quantity may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Range {
    /// Any finite number.
    Any,
    /// Zero or more.
    NotNegative,
    /// More than zero.
    Positive,
}

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    /// A number with its unit, written as text.
    Quantity(Dimension, Range),
    /// A plain number within bounds.
    Number(f64, f64),
    /// A whole number within bounds.
    Integer(i64, i64),
    /// `true` or `false`.
    Bool,
    /// Free text of bounded length.
    Text,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// Corner points `[["0 1/min", "32 N m"], …]`.
    Curve,
    /// A table.
    Table(&'static [Key]),
    /// An array of tables.
    Tables(&'static [Key]),
}

/// One key of the project file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) required: bool,
    pub(crate) en: &'static str,
    pub(crate) de: &'static str,
}

const fn key(name: &'static str, kind: Kind, required: bool, en: &'static str, de: &'static str) -> Key {
    Key { name, kind, required, en, de }
}

const fn quantity(name: &'static str, d: Dimension, range: Range, en: &'static str, de: &'static str) -> Key {
    key(name, Kind::Quantity(d, range), false, en, de)
}

const fn needed(name: &'static str, d: Dimension, range: Range, en: &'static str, de: &'static str) -> Key {
    key(name, Kind::Quantity(d, range), true, en, de)
}

/// The format of the project file that this version reads.
pub(crate) const FORMAT: i64 = 1;

/// Feedback systems in the spelling of the ordering code.
pub(crate) const FEEDBACKS: &[&str] = &["C1024", "M512P", "RES", "D2048", "M128S"];

/// The root of the project file.
#[rustfmt::skip] // one line per key
pub(crate) const ROOT: &[Key] = &[
    key("format", Kind::Integer(FORMAT, FORMAT), true, "version of the file format, 1", "Version des Dateiformats, 1"),
    key("axis", Kind::Table(AXIS), false, "the axis", "die Achse"),
    key("load", Kind::Table(LOAD), true, "what is moved, referred to the output", "was bewegt wird, auf den Abtrieb bezogen"),
    key("motion", Kind::Tables(MOTION), true, "the moves of one cycle, in order", "die Bewegungen eines Zyklus, der Reihe nach"),
    key("bearing", Kind::Table(BEARING), false, "loads on the output flange", "Lasten am Abtriebsflansch"),
    key("requirements", Kind::Table(REQUIREMENTS), false, "what the actuator must have", "was der Antrieb haben muss"),
    key("actuator", Kind::Table(ACTUATOR), false, "an actuator that the catalogue lacks", "ein Antrieb, der nicht im Katalog steht"),
];

#[rustfmt::skip] // one line per key
const AXIS: &[Key] = &[key("name", Kind::Text, false, "name of the axis", "Name der Achse")];

#[rustfmt::skip] // one line per key
const LOAD: &[Key] = &[
    needed("inertia", Dimension::MomentOfInertia, Range::NotNegative, "J_L, moment of inertia of the load at the output", "J_L, Massenträgheitsmoment der Last am Abtrieb"),
    quantity("friction_torque", Dimension::Torque, Range::NotNegative, "T_L, friction torque at the output; opposes every motion", "T_L, Reibmoment am Abtrieb; wirkt jeder Bewegung entgegen"),
];

#[rustfmt::skip] // one line per key
const MOTION: &[Key] = &[
    key("law", Kind::OneOf(&["manual"]), true, "law of the motion", "Bewegungsgesetz"),
    needed("speed", Dimension::AngularVelocity, Range::Any, "n_2, speed at the output while running; negative for the way back", "n_2, Abtriebsdrehzahl während der Fahrt; negativ für den Rückweg"),
    needed("accelerate", Dimension::Time, Range::NotNegative, "t_1, time of acceleration from rest", "t_1, Beschleunigungszeit aus dem Stillstand"),
    needed("run", Dimension::Time, Range::NotNegative, "t_2, time at constant speed", "t_2, Zeit mit konstanter Drehzahl"),
    needed("brake", Dimension::Time, Range::NotNegative, "t_3, time of braking to rest", "t_3, Bremszeit bis zum Stillstand"),
    needed("pause", Dimension::Time, Range::NotNegative, "t_p, rest after the move", "t_p, Stillstand nach der Bewegung"),
];

#[rustfmt::skip] // one line per key
const BEARING: &[Key] = &[
    quantity("radial_force", Dimension::Force, Range::NotNegative, "F_r, radial force on the flange", "F_r, Radialkraft am Flansch"),
    quantity("radial_distance", Dimension::Length, Range::NotNegative, "L_r, distance of the radial force from the flange face", "L_r, Abstand der Radialkraft von der Flanschfläche"),
    quantity("axial_force", Dimension::Force, Range::NotNegative, "F_a, axial force on the flange", "F_a, Axialkraft am Flansch"),
    quantity("axial_distance", Dimension::Length, Range::NotNegative, "L_a, distance of the axial force from the axis", "L_a, Abstand der Axialkraft von der Drehachse"),
    key("load_factor", Kind::Number(1.0, 3.0), false, "f_w, load factor of table 74.2", "f_w, Betriebsfaktor nach Tabelle 74.2"),
    key("operating_condition", Kind::OneOf(&["normal", "shock", "high_accuracy"]), false, "operating condition of table 76.3", "Betriebsbedingung nach Tabelle 76.3"),
];

#[rustfmt::skip] // one line per key
const REQUIREMENTS: &[Key] = &[
    key("feedback", Kind::ListOf(FEEDBACKS), false, "permitted motor feedback systems", "zulässige Motorfeedbacksysteme"),
    key("brake", Kind::Bool, false, "with (true) or without (false) holding brake", "mit (true) oder ohne (false) Haltebremse"),
    quantity("hollow_shaft_min", Dimension::Length, Range::NotNegative, "smallest bore of the hollow shaft", "kleinster Hohlwellendurchmesser"),
    quantity("length_max", Dimension::Length, Range::Positive, "largest length of the actuator", "größte Länge des Antriebs"),
    quantity("mass_max", Dimension::Mass, Range::Positive, "largest mass of the actuator", "größte Masse des Antriebs"),
    quantity("supply", Dimension::Voltage, Range::Positive, "DC link voltage", "Zwischenkreisspannung"),
    key("modulation_reserve", Kind::Number(0.5, 1.0), false, "share of U_DC/√2 that the drive can give as fundamental", "Anteil von U_DC/√2, den der Regler als Grundwelle stellen kann"),
    quantity("ambient", Dimension::Temperature, Range::Any, "ambient temperature in operation", "Umgebungstemperatur im Betrieb"),
    quantity("bearing_life_min", Dimension::Time, Range::Positive, "life required of the output bearing", "geforderte Lebensdauer des Abtriebslagers"),
    quantity("gear_life_min", Dimension::Time, Range::Positive, "life required of the wave-generator bearing", "geforderte Lebensdauer des Wave-Generator-Lagers"),
    quantity("torsion_max", Dimension::Angle, Range::Positive, "torsion of the gear permitted under the largest torque", "zulässiger Torsionswinkel des Getriebes unter dem größten Drehmoment"),
    quantity("natural_frequency_min", Dimension::Frequency, Range::Positive, "least first natural frequency with blocked motor", "kleinste erste Eigenfrequenz bei blockiertem Motor"),
    quantity("tilt_angle_max", Dimension::Angle, Range::Positive, "tilt of the flange permitted under the tilting moment", "zulässiger Kippwinkel des Flansches unter dem Kippmoment"),
    key("option_1", Kind::OneOf(&["EC"]), false, "sensor option", "Option 1 (Sensor)"),
    key("option_2", Kind::OneOf(&["K", "R", "S"]), false, "cable and connector option", "Option 2 (Kabel/Stecker)"),
];

#[rustfmt::skip] // one line per key
const ACTUATOR: &[Key] = &[
    key("name", Kind::Text, true, "name of the actuator", "Name des Antriebs"),
    key("ratio", Kind::Number(1.0, 10_000.0), false, "i, reduction ratio", "i, Untersetzung"),
    quantity("torque_max", Dimension::Torque, Range::Positive, "T_max", "T_max"),
    quantity("speed_max", Dimension::AngularVelocity, Range::Positive, "n_max at the output", "n_max am Abtrieb"),
    quantity("speed_motor_max", Dimension::AngularVelocity, Range::Positive, "largest motor speed", "maximale Motordrehzahl"),
    quantity("speed_motor_rated", Dimension::AngularVelocity, Range::Positive, "n_N, rated motor speed", "n_N, Motor-Bemessungsdrehzahl"),
    quantity("inertia_out", Dimension::MomentOfInertia, Range::NotNegative, "J_out, own moment of inertia at the output", "J_out, eigenes Massenträgheitsmoment am Abtrieb"),
    quantity("stall_torque", Dimension::Torque, Range::Positive, "T_0", "T_0"),
    quantity("stall_current", Dimension::Current, Range::Positive, "I_0", "I_0"),
    quantity("current_max", Dimension::Current, Range::Positive, "I_max", "I_max"),
    quantity("current_demagnetisation", Dimension::Current, Range::Positive, "I_E", "I_E"),
    quantity("no_load_starting_current", Dimension::Current, Range::NotNegative, "I_NLS", "I_NLS"),
    quantity("no_load_current_constant_30", Dimension::NoLoadCurrentConstant, Range::NotNegative, "K_INL at 30 °C, per output speed", "K_INL bei 30 °C, je Abtriebsdrehzahl"),
    quantity("no_load_current_constant_80", Dimension::NoLoadCurrentConstant, Range::NotNegative, "K_INL at 80 °C, per output speed", "K_INL bei 80 °C, je Abtriebsdrehzahl"),
    quantity("torque_constant_out", Dimension::TorqueConstant, Range::Positive, "k_Tout", "k_Tout"),
    quantity("torque_constant_motor", Dimension::TorqueConstant, Range::Positive, "k_TM", "k_TM"),
    quantity("voltage_constant_motor", Dimension::VoltageConstant, Range::Positive, "k_EM, line to line, rms", "k_EM, Leiter-Leiter, effektiv"),
    quantity("resistance_ll", Dimension::Resistance, Range::Positive, "R_LL at 20 °C", "R_LL bei 20 °C"),
    quantity("inductance_ll", Dimension::Inductance, Range::Positive, "L_LL", "L_LL"),
    key("pole_pairs", Kind::Integer(1, 100), false, "p", "p"),
    quantity("mass", Dimension::Mass, Range::Positive, "m", "m"),
    quantity("length", Dimension::Length, Range::Positive, "L", "L"),
    quantity("hollow_shaft", Dimension::Length, Range::NotNegative, "d_H", "d_H"),
    quantity("dc_link_max", Dimension::Voltage, Range::Positive, "U_DCmax", "U_DCmax"),
    quantity("terminal_voltage_min", Dimension::Voltage, Range::Positive, "U_M from which the performance holds", "U_M, ab der die Leistungsdaten gelten"),
    key("continuous_curve", Kind::Curve, false, "continuous-duty curve by its corner points, from standstill", "Dauerbetriebskennlinie durch ihre Eckpunkte, ab Stillstand"),
];
