//! Kinds of quantities, decided at run time.

use crate::Language;
use crate::unit;
use crate::units::Unit;

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident: $a_en:ident $en:literal, $a_de:ident $de:literal, $example:literal;)*) => {
        /// The physical kind of a quantity, decided at run time (project file, tables).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Dimension {
            $($(#[$doc])* $name,)*
        }

        impl Dimension {
            /// The kinds. If several share a spelling, it belongs to the first one here: `g` is a gram.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the name of the quantity: `torque`, `Drehmoment`.
            #[must_use]
            pub const fn name(self, language: Language) -> &'static str {
                match (self, language) {
                    $((Self::$name, Language::En) => $en, (Self::$name, Language::De) => $de,)*
                }
            }

            /// Returns the name with its indefinite article: `a torque`, `ein Drehmoment`.
            #[must_use]
            pub const fn name_with_article(self, language: Language) -> &'static str {
                match (self, language) {
                    $(
                        (Self::$name, Language::En) => concat!(stringify!($a_en), " ", $en),
                        (Self::$name, Language::De) => concat!(stringify!($a_de), " ", $de),
                    )*
                }
            }

            /// Returns an example of this kind in the usual notation, `5 N m`; [`parse`](crate::parse()) reads it.
            #[must_use]
            pub const fn example(self) -> &'static str {
                match self {
                    $(Self::$name => $example,)*
                }
            }
        }
    };
}

dimensions! {
    /// Torque, SI unit N m.
    Torque: a "torque", ein "Drehmoment", "5 N m";
    /// Angular velocity, SI unit rad/s; in the field a rotational speed in revolutions per minute.
    AngularVelocity: a "rotational speed", eine "Drehzahl", "40 1/min";
    /// Angular acceleration, SI unit rad/s².
    AngularAcceleration: an "angular acceleration", eine "Winkelbeschleunigung", "42 rad/s^2";
    /// Angular jerk, SI unit rad/s³.
    AngularJerk: an "angular jerk", ein "Winkelruck", "900 rad/s^3";
    /// Moment of inertia, SI unit kg m².
    MomentOfInertia: a "moment of inertia", ein "Massenträgheitsmoment", "1.3 kg m^2";
    /// Time, SI unit s.
    Time: a "time", eine "Zeit", "0.1 s";
    /// Length, SI unit m.
    Length: a "length", eine "Länge", "50 mm";
    /// Travel of a nut per revolution, SI unit m.
    Lead: a "lead", eine "Steigung", "10 mm";
    /// Area, SI unit m²: the cross-section of a wire.
    Area: an "area", eine "Fläche", "0.75 mm^2";
    /// Mass, SI unit kg.
    Mass: a "mass", eine "Masse", "3.2 kg";
    /// Mass per volume, SI unit kg/m³.
    MassDensity: a "density", eine "Dichte", "7850 kg/m^3";
    /// Force, SI unit N.
    Force: a "force", eine "Kraft", "500 N";
    /// Electric current, SI unit A.
    Current: an "electric current", ein "Strom", "2.1 A";
    /// Voltage, SI unit V.
    Voltage: a "voltage", eine "Spannung", "560 V";
    /// Effective voltage between two lines of an alternating current, SI unit V: never one of a DC link.
    EffectiveVoltage: an "effective voltage", eine "Effektivspannung", "400 V";
    /// Electrical resistance, SI unit Ω.
    Resistance: a "resistance", ein "Widerstand", "5.9 ohm";
    /// Electrical resistivity, SI unit Ω m.
    Resistivity: an "electrical resistivity", ein "spezifischer Widerstand", "0.0172 ohm mm^2/m";
    /// Inductance, SI unit H.
    Inductance: an "inductance", eine "Induktivität", "8 mH";
    /// Plane angle, SI unit rad.
    Angle: an "angle", ein "Winkel", "90 deg";
    /// Power, SI unit W.
    Power: a "power", eine "Leistung", "250 W";
    /// Energy, SI unit J.
    Energy: an "energy", eine "Energie", "100 J";
    /// Thermodynamic temperature, SI unit K: 40 °C is 313.15 K.
    Temperature: a "temperature", eine "Temperatur", "40 °C";
    /// Difference of two temperatures, SI unit K.
    TemperatureInterval: a "temperature difference", eine "Temperaturdifferenz", "60 K";
    /// Frequency, SI unit Hz.
    Frequency: a "frequency", eine "Frequenz", "50 Hz";
    /// Pressure and mechanical stress, SI unit Pa.
    Pressure: a "pressure", ein "Druck", "10 kPa";
    /// Velocity along a line, SI unit m/s.
    Velocity: a "velocity", eine "Geschwindigkeit", "0.5 m/s";
    /// Acceleration along a line, SI unit m/s².
    Acceleration: an "acceleration", eine "Beschleunigung", "9.81 m/s^2";
    /// Jerk along a line, SI unit m/s³.
    Jerk: a "jerk", ein "Ruck", "50 m/s^3";
    /// Ratio, a pure number; the only kind that may go without a unit.
    Ratio: a "ratio", ein "Verhältnis", "25 %";
    /// Torque constant, torque per current, SI unit N m/A.
    TorqueConstant: a "torque constant", eine "Drehmomentkonstante", "16.5 N m/A";
    /// Voltage constant, voltage per angular velocity, SI unit V s/rad.
    VoltageConstant: a "voltage constant", eine "Spannungskonstante", "23 V/1000 1/min";
    /// No-load current constant, current per angular velocity, SI unit A s/rad.
    NoLoadCurrentConstant: a "no-load current constant", eine "Leerlaufstromkonstante", "4e-3 A/(1/min)";
    /// Torsional stiffness, torque per angle of twist, SI unit N m/rad.
    TorsionalStiffness: a "torsional stiffness", eine "Torsionssteifigkeit", "67000 N m/rad";
    /// Tilting stiffness of a bearing, moment per angle of tilt, SI unit N m/rad.
    TiltingStiffness: a "tilting stiffness", eine "Kippsteifigkeit", "70 N m/arcmin";
    /// Viscous friction, torque per angular velocity, SI unit N m s/rad.
    ViscousFriction: a "viscous friction", eine "viskose Reibung", "0.5 N m s/rad";
    /// Gain of a position loop, speed per deviation, SI unit 1/s.
    PositionGain: a "position gain", eine "Verstärkung der Lageregelung", "25 1/s";
    /// Gain of a speed loop, torque per angular velocity, SI unit N m s/rad.
    SpeedGain: a "speed gain", eine "Verstärkung der Drehzahlregelung", "900 N m s/rad";
    /// Gain of a current loop, voltage per current, SI unit V/A.
    CurrentGain: a "current gain", eine "Verstärkung der Stromregelung", "20 V/A";
    /// Length of a data word, unit bit.
    Information: a "data word length", eine "Datenwortlänge", "29 bit";
}

impl Dimension {
    /// Returns the units of this quantity, the usual one first.
    #[must_use]
    pub fn units(self) -> &'static [Unit] {
        unit::of_dimension(self)
    }
}

impl Dimension {
    /// Returns the resolution of computed figures in SI: a smaller one is the rounding of its computation, such as an
    /// instant of 3·10⁻¹⁰ s for the start. Zero where small values occur.
    ///
    /// # Source
    /// A choice, far below all that matters for an axis: 1 ns, 1 µN, 1 pm, 1 prad.
    #[must_use]
    pub const fn resolution_si(self) -> f64 {
        match self {
            Self::Torque | Self::Force | Self::Power | Self::Energy | Self::Voltage | Self::EffectiveVoltage => 1e-6,
            Self::Current => 1e-8,
            Self::Time
            | Self::AngularVelocity
            | Self::AngularAcceleration
            | Self::AngularJerk
            | Self::Velocity
            | Self::Acceleration
            | Self::Jerk => 1e-9,
            Self::Angle | Self::Length => 1e-12,
            Self::MomentOfInertia
            | Self::Lead
            | Self::Area
            | Self::Mass
            | Self::MassDensity
            | Self::Resistance
            | Self::Resistivity
            | Self::Inductance
            | Self::Temperature
            | Self::TemperatureInterval
            | Self::Frequency
            | Self::Pressure
            | Self::Ratio
            | Self::TorqueConstant
            | Self::VoltageConstant
            | Self::NoLoadCurrentConstant
            | Self::TorsionalStiffness
            | Self::TiltingStiffness
            | Self::ViscousFriction
            | Self::PositionGain
            | Self::SpeedGain
            | Self::CurrentGain
            | Self::Information => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dimension_has_units_of_its_own_and_an_example_that_parses() {
        for dimension in Dimension::ALL.iter().copied() {
            assert!(!dimension.units().is_empty(), "{dimension:?}");
            assert!(dimension.units().iter().all(|unit| unit.dimension == dimension), "{dimension:?}");
            assert!(crate::parse(dimension, dimension.example()).is_ok(), "{dimension:?}");
        }
    }

    #[test]
    fn names_are_reported_in_both_languages() {
        assert_eq!(Dimension::Torque.name(Language::De), "Drehmoment");
        assert_eq!(Dimension::AngularVelocity.name_with_article(Language::De), "eine Drehzahl");
        assert_eq!(Dimension::Angle.name_with_article(Language::En), "an angle");
        for dimension in Dimension::ALL {
            let name = dimension.name(Language::En);
            let an = name.starts_with(['a', 'e', 'i', 'o', 'u']);
            let article = if an { "an" } else { "a" };
            assert_eq!(dimension.name_with_article(Language::En), format!("{article} {name}"));
        }
    }
}
