//! The units: how they are written and how they convert.

use crate::Language;

/// The kind of a quantity, decided at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each variant is named after its quantity")]
pub enum Dimension {
    Torque,
    AngularVelocity,
    AngularAcceleration,
    MomentOfInertia,
    Time,
    Length,
    Mass,
    Force,
    Current,
    Voltage,
    Resistance,
    Inductance,
    Angle,
    Power,
    Energy,
    Temperature,
    Frequency,
    Pressure,
    Acceleration,
    Ratio,
    TorqueConstant,
    VoltageConstant,
    NoLoadCurrentConstant,
    TorsionalStiffness,
    TiltingStiffness,
    ViscousFriction,
    Information,
}

impl Dimension {
    /// Name of the quantity.
    #[must_use]
    pub const fn name(self, language: Language) -> &'static str {
        let (en, de) = match self {
            Self::Torque => ("torque", "Drehmoment"),
            Self::AngularVelocity => ("rotational speed", "Drehzahl"),
            Self::AngularAcceleration => ("angular acceleration", "Winkelbeschleunigung"),
            Self::MomentOfInertia => ("moment of inertia", "Massenträgheitsmoment"),
            Self::Time => ("time", "Zeit"),
            Self::Length => ("length", "Länge"),
            Self::Mass => ("mass", "Masse"),
            Self::Force => ("force", "Kraft"),
            Self::Current => ("electric current", "Strom"),
            Self::Voltage => ("voltage", "Spannung"),
            Self::Resistance => ("resistance", "Widerstand"),
            Self::Inductance => ("inductance", "Induktivität"),
            Self::Angle => ("angle", "Winkel"),
            Self::Power => ("power", "Leistung"),
            Self::Energy => ("energy", "Energie"),
            Self::Temperature => ("temperature", "Temperatur"),
            Self::Frequency => ("frequency", "Frequenz"),
            Self::Pressure => ("pressure", "Druck"),
            Self::Acceleration => ("acceleration", "Beschleunigung"),
            Self::Ratio => ("ratio", "Verhältnis"),
            Self::TorqueConstant => ("torque constant", "Drehmomentkonstante"),
            Self::VoltageConstant => ("voltage constant", "Spannungskonstante"),
            Self::NoLoadCurrentConstant => ("no-load current constant", "Leerlaufstromkonstante"),
            Self::TorsionalStiffness => ("torsional stiffness", "Torsionssteifigkeit"),
            Self::TiltingStiffness => ("tilting stiffness", "Kippsteifigkeit"),
            Self::ViscousFriction => ("viscous friction", "viskose Reibung"),
            Self::Information => ("data word length", "Datenwortlänge"),
        };
        match language {
            Language::En => en,
            Language::De => de,
        }
    }

    /// A quantity of this kind as one would write it.
    #[must_use]
    pub const fn example(self) -> &'static str {
        match self {
            Self::Torque => "5 N m",
            Self::AngularVelocity => "40 1/min",
            Self::AngularAcceleration => "42 rad/s^2",
            Self::MomentOfInertia => "1.3 kg m^2",
            Self::Time => "0.1 s",
            Self::Length => "50 mm",
            Self::Mass => "3.2 kg",
            Self::Force => "500 N",
            Self::Current => "2.1 A",
            Self::Voltage => "560 V",
            Self::Resistance => "5.9 ohm",
            Self::Inductance => "8 mH",
            Self::Angle => "90 deg",
            Self::Power => "250 W",
            Self::Energy => "100 J",
            Self::Temperature => "40 degC",
            Self::Frequency => "50 Hz",
            Self::Pressure => "10 kPa",
            Self::Acceleration => "9.81 m/s^2",
            Self::Ratio => "25 %",
            Self::TorqueConstant => "16.5 N m/A",
            Self::VoltageConstant => "23 V/1000 1/min",
            Self::NoLoadCurrentConstant => "4e-3 A/(1/min)",
            Self::TorsionalStiffness => "67000 N m/rad",
            Self::TiltingStiffness => "70 N m/arcmin",
            Self::ViscousFriction => "0.5 N m s/rad",
            Self::Information => "29 bit",
        }
    }

    /// The units of this quantity, the usual one first.
    #[must_use]
    pub fn units(self) -> Vec<&'static Unit> {
        unit::ALL.iter().copied().filter(|unit| unit.dimension == self).collect()
    }
}

/// One unit: how it is written and how it converts.
#[derive(Debug)]
pub struct Unit {
    /// The quantity it measures.
    pub dimension: Dimension,
    /// Spelling of project files: `N m`, `1/min`, `kg m^2`.
    pub ascii: &'static str,
    /// Spelling for people: `Nm`, `min⁻¹`, `kgm²`.
    pub symbol: &'static str,
    /// Spelling in data exchange: `Nm`, `1/min`, `kgm^2`.
    pub json: &'static str,
    pub(crate) others: &'static [&'static str],
    forth: fn(f64) -> f64,
    back: fn(f64) -> f64,
}

impl Unit {
    /// A value in this unit, in SI.
    #[must_use]
    pub fn to_si(&self, value: f64) -> f64 {
        (self.forth)(value)
    }

    /// An SI value in this unit.
    #[must_use]
    pub fn from_si(&self, si: f64) -> f64 {
        (self.back)(si)
    }

    /// The unit with this spelling, of whatever dimension; the first in the order of [`unit::ALL`] where several share it.
    #[must_use]
    pub fn of(spelling: &str) -> Option<&'static Self> {
        let wanted = canonical(spelling);
        unit::ALL.iter().copied().find(|unit| unit.is_spelt(&wanted))
    }

    /// The unit of a dimension with this spelling.
    #[must_use]
    pub fn of_dimension(dimension: Dimension, spelling: &str) -> Option<&'static Self> {
        let wanted = canonical(spelling);
        unit::ALL.iter().copied().filter(|unit| unit.dimension == dimension).find(|unit| unit.is_spelt(&wanted))
    }

    fn is_spelt(&self, wanted: &str) -> bool {
        !wanted.is_empty()
            && [self.ascii, self.symbol, self.json].iter().chain(self.others).any(|known| canonical(known) == wanted)
    }
}

/// A spelling without what does not matter: spaces, dots and stars of a product, raised digits, Greek letters.
fn canonical(spelling: &str) -> String {
    let mut out = String::with_capacity(spelling.len());
    for c in spelling.trim().chars().take(40) {
        match c {
            ' ' | '·' | '*' | '^' | '⋅' | '(' | ')' => {}
            '²' => out.push('2'),
            '³' => out.push('3'),
            '⁻' | '−' => out.push('-'),
            '¹' => out.push('1'),
            '⁴' => out.push('4'),
            'µ' | 'μ' => out.push('u'),
            '\u{2126}' | '\u{3a9}' => out.push_str("ohm"),
            '°' => out.push_str("deg"),
            c => out.push(c),
        }
    }
    out
}

macro_rules! units {
    ($($name:ident: $dimension:ident, $ascii:literal, $symbol:literal, $json:literal, [$($other:literal),*], $forth:expr, $back:expr;)*) => {
        /// Every unit by name.
        pub mod unit {
            use super::{Dimension, Unit};
            use uom::si::f64::{
                Acceleration, Angle, AngularAcceleration, AngularVelocity, ElectricCurrent, ElectricPotential,
                ElectricalResistance, Energy, Force, Frequency, Inductance, Length, Mass, MomentOfInertia, Power,
                Pressure, Ratio, ThermodynamicTemperature, Time, Torque,
            };
            use uom::si::{
                acceleration, angle, angular_acceleration, angular_velocity, electric_current, electric_potential,
                electrical_resistance, energy, force, frequency, inductance, length, mass, moment_of_inertia, power,
                pressure, ratio, thermodynamic_temperature, time, torque,
            };

            /// 2π/60: one revolution per minute in rad/s, from `uom`.
            fn per_minute() -> f64 {
                AngularVelocity::new::<angular_velocity::revolution_per_minute>(1.0).value
            }

            /// One arc minute in rad, from `uom`.
            fn arcminute() -> f64 {
                Angle::new::<angle::minute>(1.0).value
            }

            $(
                #[doc = concat!("`", $ascii, "`")]
                pub static $name: Unit = Unit {
                    dimension: Dimension::$dimension,
                    ascii: $ascii,
                    symbol: $symbol,
                    json: $json,
                    others: &[$($other),*],
                    forth: $forth,
                    back: $back,
                };
            )*

            /// Every unit, the usual one of each dimension first.
            pub static ALL: &[&Unit] = &[$(&$name),*];
        }
    };
}

/// Conversion through a unit of `uom`.
macro_rules! u {
    ($quantity:ident, $($unit:ident)::+) => { |x| $quantity::new::<$($unit)::+>(x).value };
}

/// And back.
macro_rules! b {
    ($quantity:ident, $($unit:ident)::+) => { |si| {
        $quantity { dimension: std::marker::PhantomData, units: std::marker::PhantomData, value: si }.get::<$($unit)::+>()
    } };
}

units! {
    NEWTON_METRE: Torque, "N m", "Nm", "Nm", [], u!(Torque, torque::newton_meter), b!(Torque, torque::newton_meter);
    KILONEWTON_METRE: Torque, "kN m", "kNm", "kNm", [], u!(Torque, torque::kilonewton_meter), b!(Torque, torque::kilonewton_meter);
    MILLINEWTON_METRE: Torque, "mN m", "mNm", "mNm", [], u!(Torque, torque::millinewton_meter), b!(Torque, torque::millinewton_meter);
    NEWTON_CENTIMETRE: Torque, "N cm", "Ncm", "Ncm", [], |x| Torque::new::<torque::newton_meter>(x / 100.0).value, |si| si * 100.0;
    REVOLUTION_PER_MINUTE: AngularVelocity, "1/min", "min⁻¹", "1/min", ["min^-1", "rpm", "rev/min", "U/min", "r/min"], u!(AngularVelocity, angular_velocity::revolution_per_minute), b!(AngularVelocity, angular_velocity::revolution_per_minute);
    RADIAN_PER_SECOND: AngularVelocity, "rad/s", "rad/s", "rad/s", [], u!(AngularVelocity, angular_velocity::radian_per_second), b!(AngularVelocity, angular_velocity::radian_per_second);
    DEGREE_PER_SECOND: AngularVelocity, "deg/s", "°/s", "deg/s", [], u!(AngularVelocity, angular_velocity::degree_per_second), b!(AngularVelocity, angular_velocity::degree_per_second);
    REVOLUTION_PER_SECOND: AngularVelocity, "1/s", "s⁻¹", "1/s", ["rev/s", "U/s", "s^-1"], u!(AngularVelocity, angular_velocity::revolution_per_second), b!(AngularVelocity, angular_velocity::revolution_per_second);
    RADIAN_PER_SECOND_SQUARED: AngularAcceleration, "rad/s^2", "rad/s²", "rad/s^2", [], u!(AngularAcceleration, angular_acceleration::radian_per_second_squared), b!(AngularAcceleration, angular_acceleration::radian_per_second_squared);
    DEGREE_PER_SECOND_SQUARED: AngularAcceleration, "deg/s^2", "°/s²", "deg/s^2", [], u!(AngularAcceleration, angular_acceleration::degree_per_second_squared), b!(AngularAcceleration, angular_acceleration::degree_per_second_squared);
    KILOGRAM_SQUARE_METRE: MomentOfInertia, "kg m^2", "kgm²", "kgm^2", [], u!(MomentOfInertia, moment_of_inertia::kilogram_square_meter), b!(MomentOfInertia, moment_of_inertia::kilogram_square_meter);
    TEN_THOUSANDTH_KILOGRAM_SQUARE_METRE: MomentOfInertia, "10^-4 kg m^2", "10⁻⁴ kgm²", "10^-4 kgm^2", ["kg cm^2"], |x| MomentOfInertia::new::<moment_of_inertia::kilogram_square_meter>(x * 1e-4).value, |si| si * 1e4;
    GRAM_SQUARE_CENTIMETRE: MomentOfInertia, "g cm^2", "gcm²", "gcm^2", [], |x| x * 1e-7, |si| si * 1e7;
    SECOND: Time, "s", "s", "s", [], u!(Time, time::second), b!(Time, time::second);
    MILLISECOND: Time, "ms", "ms", "ms", [], u!(Time, time::millisecond), b!(Time, time::millisecond);
    MINUTE: Time, "min", "min", "min", [], u!(Time, time::minute), b!(Time, time::minute);
    HOUR: Time, "h", "h", "h", [], u!(Time, time::hour), b!(Time, time::hour);
    DAY: Time, "d", "d", "d", [], u!(Time, time::day), b!(Time, time::day);
    // The Julian year of 365.25 days, the usual year of life and storage times.
    YEAR: Time, "a", "a", "a", [], |x| Time::new::<time::day>(x * 365.25).value, |si| si / (86_400.0 * 365.25);
    MILLIMETRE: Length, "mm", "mm", "mm", [], u!(Length, length::millimeter), b!(Length, length::millimeter);
    METRE: Length, "m", "m", "m", [], u!(Length, length::meter), b!(Length, length::meter);
    CENTIMETRE: Length, "cm", "cm", "cm", [], u!(Length, length::centimeter), b!(Length, length::centimeter);
    MICROMETRE: Length, "um", "µm", "um", [], u!(Length, length::micrometer), b!(Length, length::micrometer);
    KILOMETRE: Length, "km", "km", "km", [], u!(Length, length::kilometer), b!(Length, length::kilometer);
    KILOGRAM: Mass, "kg", "kg", "kg", [], u!(Mass, mass::kilogram), b!(Mass, mass::kilogram);
    GRAM: Mass, "g", "g", "g", [], u!(Mass, mass::gram), b!(Mass, mass::gram);
    TONNE: Mass, "t", "t", "t", [], u!(Mass, mass::ton), b!(Mass, mass::ton);
    NEWTON: Force, "N", "N", "N", [], u!(Force, force::newton), b!(Force, force::newton);
    KILONEWTON: Force, "kN", "kN", "kN", [], u!(Force, force::kilonewton), b!(Force, force::kilonewton);
    AMPERE: Current, "A", "A", "A", ["Aeff", "Arms"], u!(ElectricCurrent, electric_current::ampere), b!(ElectricCurrent, electric_current::ampere);
    MILLIAMPERE: Current, "mA", "mA", "mA", [], u!(ElectricCurrent, electric_current::milliampere), b!(ElectricCurrent, electric_current::milliampere);
    MICROAMPERE: Current, "uA", "µA", "uA", [], u!(ElectricCurrent, electric_current::microampere), b!(ElectricCurrent, electric_current::microampere);
    VOLT: Voltage, "V", "V", "V", ["VDC", "VAC", "Veff", "Vrms"], u!(ElectricPotential, electric_potential::volt), b!(ElectricPotential, electric_potential::volt);
    MILLIVOLT: Voltage, "mV", "mV", "mV", [], u!(ElectricPotential, electric_potential::millivolt), b!(ElectricPotential, electric_potential::millivolt);
    KILOVOLT: Voltage, "kV", "kV", "kV", [], u!(ElectricPotential, electric_potential::kilovolt), b!(ElectricPotential, electric_potential::kilovolt);
    OHM: Resistance, "ohm", "Ω", "ohm", ["Ohm"], u!(ElectricalResistance, electrical_resistance::ohm), b!(ElectricalResistance, electrical_resistance::ohm);
    MILLIOHM: Resistance, "mohm", "mΩ", "mohm", ["mOhm"], u!(ElectricalResistance, electrical_resistance::milliohm), b!(ElectricalResistance, electrical_resistance::milliohm);
    KILOOHM: Resistance, "kohm", "kΩ", "kohm", ["kOhm"], u!(ElectricalResistance, electrical_resistance::kiloohm), b!(ElectricalResistance, electrical_resistance::kiloohm);
    MEGAOHM: Resistance, "Mohm", "MΩ", "Mohm", ["MOhm"], u!(ElectricalResistance, electrical_resistance::megaohm), b!(ElectricalResistance, electrical_resistance::megaohm);
    MILLIHENRY: Inductance, "mH", "mH", "mH", [], u!(Inductance, inductance::millihenry), b!(Inductance, inductance::millihenry);
    HENRY: Inductance, "H", "H", "H", [], u!(Inductance, inductance::henry), b!(Inductance, inductance::henry);
    MICROHENRY: Inductance, "uH", "µH", "uH", [], u!(Inductance, inductance::microhenry), b!(Inductance, inductance::microhenry);
    DEGREE: Angle, "deg", "°", "deg", [], u!(Angle, angle::degree), b!(Angle, angle::degree);
    RADIAN: Angle, "rad", "rad", "rad", [], u!(Angle, angle::radian), b!(Angle, angle::radian);
    MILLIRADIAN: Angle, "mrad", "mrad", "mrad", [], |x| x * 1e-3, |si| si * 1e3;
    ARCMINUTE: Angle, "arcmin", "arcmin", "arcmin", [], u!(Angle, angle::minute), b!(Angle, angle::minute);
    ARCSECOND: Angle, "arcsec", "arcsec", "arcsec", [], u!(Angle, angle::second), b!(Angle, angle::second);
    REVOLUTION: Angle, "rev", "rev", "rev", [], u!(Angle, angle::revolution), b!(Angle, angle::revolution);
    WATT: Power, "W", "W", "W", [], u!(Power, power::watt), b!(Power, power::watt);
    KILOWATT: Power, "kW", "kW", "kW", [], u!(Power, power::kilowatt), b!(Power, power::kilowatt);
    JOULE: Energy, "J", "J", "J", [], u!(Energy, energy::joule), b!(Energy, energy::joule);
    KILOJOULE: Energy, "kJ", "kJ", "kJ", [], u!(Energy, energy::kilojoule), b!(Energy, energy::kilojoule);
    WATT_HOUR: Energy, "W h", "Wh", "Wh", [], u!(Energy, energy::watt_hour), b!(Energy, energy::watt_hour);
    DEGREE_CELSIUS: Temperature, "degC", "°C", "degC", [], u!(ThermodynamicTemperature, thermodynamic_temperature::degree_celsius), b!(ThermodynamicTemperature, thermodynamic_temperature::degree_celsius);
    KELVIN: Temperature, "K", "K", "K", [], u!(ThermodynamicTemperature, thermodynamic_temperature::kelvin), b!(ThermodynamicTemperature, thermodynamic_temperature::kelvin);
    HERTZ: Frequency, "Hz", "Hz", "Hz", [], u!(Frequency, frequency::hertz), b!(Frequency, frequency::hertz);
    KILOHERTZ: Frequency, "kHz", "kHz", "kHz", [], u!(Frequency, frequency::kilohertz), b!(Frequency, frequency::kilohertz);
    PASCAL: Pressure, "Pa", "Pa", "Pa", [], u!(Pressure, pressure::pascal), b!(Pressure, pressure::pascal);
    KILOPASCAL: Pressure, "kPa", "kPa", "kPa", [], u!(Pressure, pressure::kilopascal), b!(Pressure, pressure::kilopascal);
    BAR: Pressure, "bar", "bar", "bar", [], u!(Pressure, pressure::bar), b!(Pressure, pressure::bar);
    METRE_PER_SECOND_SQUARED: Acceleration, "m/s^2", "m/s²", "m/s^2", [], u!(Acceleration, acceleration::meter_per_second_squared), b!(Acceleration, acceleration::meter_per_second_squared);
    STANDARD_GRAVITY: Acceleration, "g", "g", "g", [], u!(Acceleration, acceleration::standard_gravity), b!(Acceleration, acceleration::standard_gravity);
    PERCENT: Ratio, "%", "%", "%", [], u!(Ratio, ratio::percent), b!(Ratio, ratio::percent);
    ONE: Ratio, "1", "1", "1", [], u!(Ratio, ratio::ratio), b!(Ratio, ratio::ratio);
    PER_MILLE: Ratio, "‰", "‰", "‰", [], u!(Ratio, ratio::per_mille), b!(Ratio, ratio::per_mille);
    NEWTON_METRE_PER_AMPERE: TorqueConstant, "N m/A", "Nm/A", "Nm/A", ["Nm/Aeff"], |x| x, |si| si;
    VOLT_PER_THOUSAND_REVOLUTIONS: VoltageConstant, "V/1000 1/min", "V/1000 min⁻¹", "V/1000 min^-1", ["V/1000 rpm", "V/krpm", "Veff/1000 min^-1"], |x| x / (1000.0 * per_minute()), |si| si * (1000.0 * per_minute());
    VOLT_SECOND_PER_RADIAN: VoltageConstant, "V s/rad", "Vs/rad", "Vs/rad", ["V/(rad/s)"], |x| x, |si| si;
    AMPERE_PER_REVOLUTION_PER_MINUTE: NoLoadCurrentConstant, "A/(1/min)", "A/min⁻¹", "A/min^-1", ["A min", "A/rpm"], |x| x / per_minute(), |si| si * per_minute();
    MILLIAMPERE_PER_REVOLUTION_PER_MINUTE: NoLoadCurrentConstant, "10^-3 A/(1/min)", "10⁻³ A/min⁻¹", "10^-3 A/min^-1", ["mA/(1/min)", "mA/min^-1", "mA/rpm"], |x| x * 1e-3 / per_minute(), |si| si * 1e3 * per_minute();
    NEWTON_METRE_PER_RADIAN: TorsionalStiffness, "N m/rad", "Nm/rad", "Nm/rad", [], |x| x, |si| si;
    KILONEWTON_METRE_PER_RADIAN: TorsionalStiffness, "10^3 N m/rad", "10³ Nm/rad", "10^3 Nm/rad", ["kNm/rad"], |x| x * 1e3, |si| si * 1e-3;
    NEWTON_METRE_PER_ARCMINUTE: TiltingStiffness, "N m/arcmin", "Nm/arcmin", "Nm/arcmin", [], |x| x / arcminute(), |si| si * arcminute();
    NEWTON_METRE_SECOND_PER_RADIAN: ViscousFriction, "N m s/rad", "Nms/rad", "Nms/rad", ["N m/(rad/s)"], |x| x, |si| si;
    BIT: Information, "bit", "bit", "bit", [], |x| x, |si| si;
}

#[cfg(test)]
#[path = "units_tests.rs"]
mod tests;
