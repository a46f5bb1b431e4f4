//! The units by name.
//!
//! A unit known to `uom` takes its factor from there (`is`). For the others the factor is an exact definition: `times`
//! and `over` state the number by which a value is multiplied or divided to obtain SI, `si` that no conversion is
//! needed.

use crate::dimension::Dimension;
use crate::factors::{
    FLYWHEEL_EFFECT, FOOT_M, HORSEPOWER_W, INCH_M, OUNCES, PFERDESTAERKE_W, POUND_FORCE_N, POUND_KG,
    STANDARD_GRAVITY_M_S2, arcminute, day, degree, per_minute,
};
use crate::units::Unit;
use std::f64::consts::TAU;

with_stiffnesses! {
    {
        Torque [Torque torque] {
            NEWTON_METRE: "N m", "Nm", "Nm", [], (is newton_meter);
            KILONEWTON_METRE: "kN m", "kNm", "kNm", [], (is kilonewton_meter);
            DECANEWTON_METRE: "daN m", "daNm", "daNm", [], (times 1e1);
            MILLINEWTON_METRE: "mN m", "mNm", "mNm", [], (is millinewton_meter);
            NEWTON_CENTIMETRE: "N cm", "Ncm", "Ncm", [], (is newton_centimeter);
            CENTINEWTON_METRE: "cN m", "cNm", "cNm", [], (over 1e2);
            NEWTON_MILLIMETRE: "N mm", "Nmm", "Nmm", [], (is newton_millimeter);
            ///
            /// A pound in a torque is a pound-force.
            POUND_FORCE_INCH: "lbf in", "lbf in", "lbf in", ["in lbf", "lb in", "in lb"], (times POUND_FORCE_N * INCH_M);
            POUND_FORCE_FOOT: "lbf ft", "lbf ft", "lbf ft", ["ft lbf", "lb ft", "ft lb"], (times POUND_FORCE_N * FOOT_M);
            OUNCE_FORCE_INCH: "ozf in", "ozf in", "ozf in", ["in ozf", "oz in", "in oz"],
                (times POUND_FORCE_N / OUNCES * INCH_M);
            KILOGRAM_FORCE_METRE: "kgf m", "kgf m", "kgf m", ["kp m"], (times STANDARD_GRAVITY_M_S2);
            KILOGRAM_FORCE_CENTIMETRE: "kgf cm", "kgf cm", "kgf cm", ["kp cm"], (times STANDARD_GRAVITY_M_S2 / 1e2);
            GRAM_FORCE_CENTIMETRE: "gf cm", "gf cm", "gf cm", [], (times STANDARD_GRAVITY_M_S2 / 1e5);
        }
        AngularVelocity [AngularVelocity angular_velocity] {
            ///
            /// A rotational speed: 1/min means revolutions per minute, 2π/60 rad/s.
            REVOLUTION_PER_MINUTE: "1/min", "min⁻¹", "1/min",
                ["min^-1", "rpm", "rev/min", "U/min", "r/min", "tr/min", "Upm"], (is revolution_per_minute);
            RADIAN_PER_SECOND: "rad/s", "rad/s", "rad/s", [], (is radian_per_second);
            DEGREE_PER_SECOND: "deg/s", "°/s", "deg/s", ["dps"], (is degree_per_second);
            DEGREE_PER_MINUTE: "deg/min", "°/min", "deg/min", [], (times degree() / 60.0);
            MILLIDEGREE_PER_SECOND: "mdeg/s", "m°/s", "mdeg/s", [], (times degree() / 1e3);
            MILLIRADIAN_PER_SECOND: "mrad/s", "mrad/s", "mrad/s", [], (over 1e3);
            ARCMINUTE_PER_SECOND: "arcmin/s", "arcmin/s", "arcmin/s", ["′/s"], (times arcminute());
            ARCSECOND_PER_SECOND: "arcsec/s", "arcsec/s", "arcsec/s", ["″/s"], (times arcminute() / 60.0);
            ///
            /// Never written 1/s, which some read as rad/s.
            REVOLUTION_PER_SECOND: "rev/s", "rev/s", "rev/s", ["U/s", "r/s", "rps"], (is revolution_per_second);
            THOUSAND_REVOLUTIONS_PER_MINUTE: "krpm", "krpm", "krpm", ["10^3 rpm", "10^3 1/min", "10^3 min^-1"],
                (times 1e3 * per_minute());
        }
        AngularAcceleration [AngularAcceleration angular_acceleration] {
            RADIAN_PER_SECOND_SQUARED: "rad/s^2", "rad/s²", "rad/s^2", [], (is radian_per_second_squared);
            DEGREE_PER_SECOND_SQUARED: "deg/s^2", "°/s²", "deg/s^2", [], (is degree_per_second_squared);
            REVOLUTION_PER_SECOND_SQUARED: "rev/s^2", "rev/s²", "rev/s^2", ["U/s^2", "r/s^2"], (times TAU);
            ///
            /// A drive states so the ramp of a speed.
            REVOLUTION_PER_MINUTE_PER_SECOND: "1/min/s", "min⁻¹/s", "1/min/s",
                ["min^-1/s", "rpm/s", "rev/min/s", "U/min/s", "r/min/s"], (times per_minute());
            THOUSAND_REVOLUTIONS_PER_MINUTE_PER_SECOND: "krpm/s", "krpm/s", "krpm/s", [], (times 1e3 * per_minute());
        }
        AngularJerk [AngularJerk angular_jerk] {
            RADIAN_PER_SECOND_CUBED: "rad/s^3", "rad/s³", "rad/s^3", [], (is radian_per_second_cubed);
            DEGREE_PER_SECOND_CUBED: "deg/s^3", "°/s³", "deg/s^3", [], (is degree_per_second_cubed);
        }
        MomentOfInertia [MomentOfInertia moment_of_inertia] {
            KILOGRAM_SQUARE_METRE: "kg m^2", "kgm²", "kgm^2",
                ["N m s^2", "N m s^2/rad", "N m/(rad/s^2)"], (is kilogram_square_meter);
            TONNE_SQUARE_METRE: "t m^2", "t m²", "t m^2", [], (times 1e3);
            ///
            /// The unit of the tables for what turns with the motor.
            TEN_THOUSANDTH_KILOGRAM_SQUARE_METRE: "10^-4 kg m^2", "10⁻⁴ kgm²", "10^-4 kgm^2", [], (over 1e4);
            ///
            /// (10⁻² m)² = 10⁻⁴ m².
            KILOGRAM_SQUARE_CENTIMETRE: "kg cm^2", "kgcm²", "kgcm^2", [], (over 1e4);
            ///
            /// 10⁻³ kg × 10⁻⁴ m².
            GRAM_SQUARE_CENTIMETRE: "g cm^2", "gcm²", "gcm^2", [], (over 1e7);
            ///
            /// 10⁻³ kg × 1 m².
            GRAM_SQUARE_METRE: "g m^2", "gm²", "gm^2", ["10^-3 kg m^2"], (over 1e3);
            ///
            /// (10⁻³ m)² = 10⁻⁶ m².
            KILOGRAM_SQUARE_MILLIMETRE: "kg mm^2", "kgmm²", "kgmm^2", ["10^-6 kg m^2"], (over 1e6);
            ///
            /// 10⁻³ kg × 10⁻⁶ m².
            GRAM_SQUARE_MILLIMETRE: "g mm^2", "gmm²", "gmm^2", [], (over 1e9);
            ///
            /// WK² and WR² of inch-pound papers are the weight times the square of the radius of gyration.
            POUND_SQUARE_INCH: "lb in^2", "lb in²", "lb in^2", ["lbm in^2", "WK^2 lb in^2", "WR^2 lb in^2", "Wk^2 lb in^2"], (times POUND_KG * INCH_M * INCH_M);
            POUND_SQUARE_FOOT: "lb ft^2", "lb ft²", "lb ft^2", ["lbm ft^2", "WK^2 lb ft^2", "WR^2 lb ft^2", "Wk^2 lb ft^2"], (times POUND_KG * FOOT_M * FOOT_M);
            OUNCE_SQUARE_INCH: "oz in^2", "oz in²", "oz in^2", [], (times POUND_KG / OUNCES * INCH_M * INCH_M);
            ///
            /// 1 slug is accelerated with 1 ft/s² by 1 lbf.
            SLUG_SQUARE_FOOT: "slug ft^2", "slug ft²", "slug ft^2",
                ["lbf ft s^2", "ft lbf s^2", "lb ft s^2", "ft lb s^2"], (times POUND_FORCE_N * FOOT_M);
            ///
            /// 1 lbf in per 1 rad/s².
            POUND_FORCE_INCH_SECOND_SQUARED: "lbf in s^2", "lbf in s²", "lbf in s^2",
                ["in lbf s^2", "lb in s^2", "in lb s^2"], (times POUND_FORCE_N * INCH_M);
            ///
            /// 1 ozf in per 1 rad/s².
            OUNCE_FORCE_INCH_SECOND_SQUARED: "ozf in s^2", "ozf in s²", "ozf in s^2",
                ["in ozf s^2", "oz in s^2", "in oz s^2"], (times POUND_FORCE_N / OUNCES * INCH_M);
            ///
            /// 1 kgf m per 1 rad/s².
            KILOGRAM_FORCE_METRE_SECOND_SQUARED: "kgf m s^2", "kgf m s²", "kgf m s^2", ["kp m s^2"],
                (times STANDARD_GRAVITY_M_S2);
            ///
            /// 1 kgf cm per 1 rad/s².
            KILOGRAM_FORCE_CENTIMETRE_SECOND_SQUARED: "kgf cm s^2", "kgf cm s²", "kgf cm s^2", ["kp cm s^2"],
                (times STANDARD_GRAVITY_M_S2 / 1e2);
            ///
            /// 1 gf cm per 1 rad/s².
            GRAM_FORCE_CENTIMETRE_SECOND_SQUARED: "gf cm s^2", "gf cm s²", "gf cm s^2", [],
                (times STANDARD_GRAVITY_M_S2 / 1e5);
            ///
            /// Flywheel effect GD² of weight and diameter, J = GD²/4; read only where `GD^2` is written.
            FLYWHEEL_KILOGRAM_FORCE_SQUARE_METRE: "GD^2 kgf m^2", "GD² kgf m²", "GD^2 kgf m^2",
                ["GD^2 kp m^2", "GD^2 kg m^2"],
                (times FLYWHEEL_EFFECT);
            ///
            /// Flywheel effect GD², J = GD²/4.
            FLYWHEEL_KILOGRAM_FORCE_SQUARE_CENTIMETRE: "GD^2 kgf cm^2", "GD² kgf cm²", "GD^2 kgf cm^2",
                ["GD^2 kp cm^2", "GD^2 kg cm^2"],
                (times FLYWHEEL_EFFECT / 1e4);
        }
        Time [Time time] {
            SECOND: "s", "s", "s", [], (is second);
            MILLISECOND: "ms", "ms", "ms", [], (is millisecond);
            MICROSECOND: "us", "µs", "us", [], (is microsecond);
            NANOSECOND: "ns", "ns", "ns", [], (is nanosecond);
            MINUTE: "min", "min", "min", [], (is minute);
            HOUR: "h", "h", "h", [], (is hour);
            DAY: "d", "d", "d", [], (is day);
            ///
            /// The Julian year of 365.25 days (IAU), not the 365 days of `uom`.
            YEAR: "a", "a", "a", [], (times 365.25 * day());
        }
        Length [Length length] {
            MILLIMETRE: "mm", "mm", "mm", [], (is millimeter);
            METRE: "m", "m", "m", [], (is meter);
            CENTIMETRE: "cm", "cm", "cm", [], (is centimeter);
            MICROMETRE: "um", "µm", "um", [], (is micrometer);
            KILOMETRE: "km", "km", "km", [], (is kilometer);
            INCH: "in", "in", "in", [], (times INCH_M);
            ///
            /// A thousandth of an inch.
            MIL: "mil", "mil", "mil", ["thou"], (times INCH_M / 1e3);
            FOOT: "ft", "ft", "ft", [], (times FOOT_M);
            ///
            /// Three feet.
            YARD: "yd", "yd", "yd", [], (times 3.0 * FOOT_M);
        }
        Lead [] {
            MILLIMETRE_PER_REVOLUTION: "mm", "mm", "mm", ["mm/rev", "mm/U", "mm/r"], (over 1e3);
            METRE_PER_REVOLUTION: "m", "m", "m", ["m/rev", "m/U", "m/r"], (si);
            CENTIMETRE_PER_REVOLUTION: "cm", "cm", "cm", ["cm/rev", "cm/U", "cm/r"], (over 1e2);
            INCH_PER_REVOLUTION: "in", "in", "in", ["in/rev", "in/r"], (times INCH_M);
        }
        Area [Area area] {
            SQUARE_MILLIMETRE: "mm^2", "mm²", "mm^2", [], (is square_millimeter);
            SQUARE_CENTIMETRE: "cm^2", "cm²", "cm^2", [], (is square_centimeter);
            SQUARE_METRE: "m^2", "m²", "m^2", [], (is square_meter);
        }
        Mass [Mass mass] {
            KILOGRAM: "kg", "kg", "kg", [], (is kilogram);
            GRAM: "g", "g", "g", [], (is gram);
            ///
            /// 1000 kg.
            TONNE: "t", "t", "t", [], (is ton);
            POUND: "lb", "lb", "lb", ["lbm"], (times POUND_KG);
            OUNCE: "oz", "oz", "oz", [], (times POUND_KG / OUNCES);
            ///
            /// 1 slug is accelerated with 1 ft/s² by 1 lbf.
            SLUG: "slug", "slug", "slug", [], (times POUND_FORCE_N / FOOT_M);
            MILLIGRAM: "mg", "mg", "mg", [], (over 1e6);
        }
        MassDensity [MassDensity mass_density] {
            KILOGRAM_PER_CUBIC_METRE: "kg/m^3", "kg/m³", "kg/m^3", [], (is kilogram_per_cubic_meter);
            GRAM_PER_CUBIC_CENTIMETRE: "g/cm^3", "g/cm³", "g/cm^3", [], (is gram_per_cubic_centimeter);
            ///
            /// 1 kg per 10⁻³ m³.
            KILOGRAM_PER_CUBIC_DECIMETRE: "kg/dm^3", "kg/dm³", "kg/dm^3", ["kg/l", "kg/L"], (times 1e3);
            POUND_PER_CUBIC_INCH: "lb/in^3", "lb/in³", "lb/in^3", [], (times POUND_KG / (INCH_M * INCH_M * INCH_M));
            POUND_PER_CUBIC_FOOT: "lb/ft^3", "lb/ft³", "lb/ft^3", [], (times POUND_KG / (FOOT_M * FOOT_M * FOOT_M));
        }
        Force [Force force] {
            NEWTON: "N", "N", "N", [], (is newton);
            KILONEWTON: "kN", "kN", "kN", [], (is kilonewton);
            DECANEWTON: "daN", "daN", "daN", [], (times 1e1);
            MEGANEWTON: "MN", "MN", "MN", [], (is meganewton);
            MILLINEWTON: "mN", "mN", "mN", [], (is millinewton);
            POUND_FORCE: "lbf", "lbf", "lbf", [], (times POUND_FORCE_N);
            KILOGRAM_FORCE: "kgf", "kgf", "kgf", ["kp"], (times STANDARD_GRAVITY_M_S2);
            GRAM_FORCE: "gf", "gf", "gf", [], (times STANDARD_GRAVITY_M_S2 / 1e3);
            OUNCE_FORCE: "ozf", "ozf", "ozf", [], (times POUND_FORCE_N / OUNCES);
        }
        Current [ElectricCurrent electric_current] {
            AMPERE: "A", "A", "A", ["A eff", "A_eff", "A rms", "A_rms"], (is ampere);
            MILLIAMPERE: "mA", "mA", "mA", [], (is milliampere);
            MICROAMPERE: "uA", "µA", "uA", [], (is microampere);
        }
        Voltage [ElectricPotential electric_potential] {
            VOLT: "V", "V", "V", ["V DC", "V dc"], (is volt);
            MILLIVOLT: "mV", "mV", "mV", [], (is millivolt);
            KILOVOLT: "kV", "kV", "kV", [], (is kilovolt);
        }
        EffectiveVoltage [] {
            ///
            /// Of an alternating voltage; of a DC link it is [`VOLT`].
            EFFECTIVE_VOLT: "V", "V", "V", ["V AC", "V ac", "V eff", "V_eff", "V rms", "V_rms", "V~"], (si);
        }
        Resistance [ElectricalResistance electrical_resistance] {
            OHM: "ohm", "Ω", "ohm", ["Ohm"], (is ohm);
            MILLIOHM: "mohm", "mΩ", "mohm", ["mOhm"], (is milliohm);
            KILOOHM: "kohm", "kΩ", "kohm", ["kOhm"], (is kiloohm);
            MEGAOHM: "Mohm", "MΩ", "Mohm", ["MOhm"], (is megaohm);
        }
        Resistivity [ElectricalResistivity electrical_resistivity] {
            ///
            /// 1 Ω across 1 m of 1 mm², 10⁻⁶ Ω m.
            OHM_SQUARE_MILLIMETRE_PER_METRE: "ohm mm^2/m", "Ω mm²/m", "ohm mm^2/m", [], (over 1e6);
            OHM_METRE: "ohm m", "Ω m", "ohm m", [], (is ohm_meter);
        }
        Inductance [Inductance inductance] {
            MILLIHENRY: "mH", "mH", "mH", [], (is millihenry);
            HENRY: "H", "H", "H", [], (is henry);
            MICROHENRY: "uH", "µH", "uH", [], (is microhenry);
        }
        Angle [Angle angle] {
            DEGREE: "deg", "°", "deg", [], (is degree);
            MILLIDEGREE: "mdeg", "m°", "mdeg", [], (times degree() / 1e3);
            RADIAN: "rad", "rad", "rad", [], (is radian);
            MILLIRADIAN: "mrad", "mrad", "mrad", [], (over 1e3);
            ARCMINUTE: "arcmin", "arcmin", "arcmin", ["′"], (is minute);
            ARCSECOND: "arcsec", "arcsec", "arcsec", ["″"], (is second);
            ///
            /// 400 gon are a revolution.
            GON: "gon", "gon", "gon", [], (times TAU / 400.0);
            REVOLUTION: "rev", "rev", "rev", [], (is revolution);
        }
        Power [Power power] {
            WATT: "W", "W", "W", [], (is watt);
            KILOWATT: "kW", "kW", "kW", [], (is kilowatt);
            ///
            /// Mechanical horsepower, 550 ft lbf/s; the metric one is [`PFERDESTAERKE`].
            HORSEPOWER: "hp", "hp", "hp", [], (times HORSEPOWER_W);
            ///
            /// Metric horsepower, 75 kgf m/s.
            PFERDESTAERKE: "PS", "PS", "PS", [], (times PFERDESTAERKE_W);
        }
        Energy [Energy energy] {
            JOULE: "J", "J", "J", ["W s"], (is joule);
            KILOJOULE: "kJ", "kJ", "kJ", [], (is kilojoule);
            MILLIJOULE: "mJ", "mJ", "mJ", [], (over 1e3);
            WATT_HOUR: "W h", "Wh", "Wh", [], (is watt_hour);
            KILOWATT_HOUR: "kW h", "kWh", "kWh", [], (times 3.6e6);
        }
        Temperature [ThermodynamicTemperature thermodynamic_temperature] {
            ///
            /// The only unit with an offset: 0 °C is 273.15 K.
            DEGREE_CELSIUS: "degC", "°C", "degC", ["° C"], (is degree_celsius);
            DEGREE_FAHRENHEIT: "degF", "°F", "degF", ["° F"], (is degree_fahrenheit);
            KELVIN: "K", "K", "K", [], (is kelvin);
        }
        TemperatureInterval [TemperatureInterval temperature_interval] {
            ///
            /// Of a temperature difference; a temperature has [`KELVIN`].
            KELVIN_DIFFERENCE: "K", "K", "K", [], (is kelvin);
        }
        Frequency [Frequency frequency] {
            HERTZ: "Hz", "Hz", "Hz", [], (is hertz);
            KILOHERTZ: "kHz", "kHz", "kHz", [], (is kilohertz);
        }
        Pressure [Pressure pressure] {
            PASCAL: "Pa", "Pa", "Pa", [], (is pascal);
            KILOPASCAL: "kPa", "kPa", "kPa", [], (is kilopascal);
            MEGAPASCAL: "MPa", "MPa", "MPa", ["N/mm^2"], (is megapascal);
            BAR: "bar", "bar", "bar", [], (is bar);
            POUND_FORCE_PER_SQUARE_INCH: "psi", "psi", "psi", [], (times POUND_FORCE_N / (INCH_M * INCH_M));
        }
        Velocity [Velocity velocity] {
            METRE_PER_SECOND: "m/s", "m/s", "m/s", [], (is meter_per_second);
            MILLIMETRE_PER_SECOND: "mm/s", "mm/s", "mm/s", [], (is millimeter_per_second);
            CENTIMETRE_PER_SECOND: "cm/s", "cm/s", "cm/s", [], (over 1e2);
            METRE_PER_MINUTE: "m/min", "m/min", "m/min", [], (over 60.0);
            MILLIMETRE_PER_MINUTE: "mm/min", "mm/min", "mm/min", [], (over 60e3);
            KILOMETRE_PER_HOUR: "km/h", "km/h", "km/h", [], (over 3.6);
            INCH_PER_SECOND: "in/s", "in/s", "in/s", ["ips"], (times INCH_M);
            FOOT_PER_SECOND: "ft/s", "ft/s", "ft/s", [], (times FOOT_M);
            INCH_PER_MINUTE: "in/min", "in/min", "in/min", ["ipm"], (times INCH_M / 60.0);
            FOOT_PER_MINUTE: "ft/min", "ft/min", "ft/min", ["fpm"], (times FOOT_M / 60.0);
        }
        Acceleration [Acceleration acceleration] {
            METRE_PER_SECOND_SQUARED: "m/s^2", "m/s²", "m/s^2", [], (is meter_per_second_squared);
            ///
            /// Standard gravity, 9.80665 m/s² (CGPM 1901); of a mass, `g` is [`GRAM`].
            STANDARD_GRAVITY: "g", "g", "g", [], (is standard_gravity);
            MILLIMETRE_PER_SECOND_SQUARED: "mm/s^2", "mm/s²", "mm/s^2", [], (over 1e3);
            CENTIMETRE_PER_SECOND_SQUARED: "cm/s^2", "cm/s²", "cm/s^2", [], (over 1e2);
            INCH_PER_SECOND_SQUARED: "in/s^2", "in/s²", "in/s^2", [], (times INCH_M);
            FOOT_PER_SECOND_SQUARED: "ft/s^2", "ft/s²", "ft/s^2", [], (times FOOT_M);
        }
        Jerk [Jerk jerk] {
            METRE_PER_SECOND_CUBED: "m/s^3", "m/s³", "m/s^3", [], (is meter_per_second_cubed);
            MILLIMETRE_PER_SECOND_CUBED: "mm/s^3", "mm/s³", "mm/s^3", [], (over 1e3);
            INCH_PER_SECOND_CUBED: "in/s^3", "in/s³", "in/s^3", [], (times INCH_M);
        }
        Ratio [Ratio ratio] {
            PERCENT: "%", "%", "%", [], (is percent);
            ///
            /// A pure number; the unit of a ratio without one.
            ONE: "1", "1", "1", [], (is ratio);
            PER_MILLE: "‰", "‰", "‰", [], (is per_mille);
        }
        TorqueConstant [] {
            NEWTON_METRE_PER_AMPERE: "N m/A", "Nm/A", "Nm/A", ["Nm/Aeff", "Nm/Arms", "N m/A_rms", "N m/A_eff"], (si);
            MILLINEWTON_METRE_PER_AMPERE: "mN m/A", "mNm/A", "mNm/A",
                ["mN m/Arms", "mN m/Aeff", "mN m/A_rms", "mN m/A_eff"],
                (over 1e3);
            NEWTON_CENTIMETRE_PER_AMPERE: "N cm/A", "Ncm/A", "Ncm/A",
                ["N cm/Arms", "N cm/Aeff", "N cm/A_rms", "N cm/A_eff"],
                (over 1e2);
            POUND_FORCE_INCH_PER_AMPERE: "lbf in/A", "lbf in/A", "lbf in/A",
                ["lbf in/Arms", "lbf in/Aeff", "lbf in/A_rms", "lbf in/A_eff", "lb in/A", "lb in/Arms", "lb in/Aeff",
                    "lb in/A_rms", "lb in/A_eff"],
                (times POUND_FORCE_N * INCH_M);
            POUND_FORCE_FOOT_PER_AMPERE: "lbf ft/A", "lbf ft/A", "lbf ft/A",
                ["lbf ft/Arms", "lbf ft/Aeff", "lbf ft/A_rms", "lbf ft/A_eff", "lb ft/A", "lb ft/Arms", "lb ft/Aeff",
                    "lb ft/A_rms", "lb ft/A_eff"],
                (times POUND_FORCE_N * FOOT_M);
            OUNCE_FORCE_INCH_PER_AMPERE: "ozf in/A", "ozf in/A", "ozf in/A",
                ["ozf in/Arms", "ozf in/Aeff", "ozf in/A_rms", "ozf in/A_eff", "oz in/A", "oz in/Arms", "oz in/Aeff",
                    "oz in/A_rms", "oz in/A_eff"],
                (times POUND_FORCE_N / OUNCES * INCH_M);
            KILOGRAM_FORCE_METRE_PER_AMPERE: "kgf m/A", "kgf m/A", "kgf m/A",
                ["kgf m/Arms", "kgf m/Aeff", "kgf m/A_rms", "kgf m/A_eff", "kp m/A", "kp m/Arms", "kp m/Aeff",
                    "kp m/A_rms", "kp m/A_eff"],
                (times STANDARD_GRAVITY_M_S2);
            KILOGRAM_FORCE_CENTIMETRE_PER_AMPERE: "kgf cm/A", "kgf cm/A", "kgf cm/A",
                ["kgf cm/Arms", "kgf cm/Aeff", "kgf cm/A_rms", "kgf cm/A_eff", "kp cm/A", "kp cm/Arms", "kp cm/Aeff",
                    "kp cm/A_rms", "kp cm/A_eff"],
                (times STANDARD_GRAVITY_M_S2 / 1e2);
        }
        VoltageConstant [] {
            ///
            /// 1 V at 1000 revolutions per minute.
            VOLT_PER_THOUSAND_REVOLUTIONS: "V/1000 1/min", "V/1000 min⁻¹", "V/1000 min^-1",
                ["V/(1000 1/min)", "V/(1000 min^-1)", "V/1000 rpm", "V/krpm", "Veff/1000 min^-1", "Veff/krpm",
                    "Vrms/krpm", "V_rms/krpm", "V_eff/krpm", "Veff/1000 rpm", "Vrms/1000 rpm", "V_rms/1000 rpm",
                    "Vrms/1000 min^-1", "mV/rpm", "mV/(1/min)", "mV/(min^-1)", "mV/min^-1"],
                (over (1000.0 * per_minute()));
            VOLT_PER_REVOLUTION_PER_MINUTE: "V/(1/min)", "V/min⁻¹", "V/min^-1",
                ["V/(min^-1)", "V/rpm"], (over per_minute());
            VOLT_SECOND_PER_RADIAN: "V s/rad", "Vs/rad", "Vs/rad", ["V/(rad/s)"], (si);
            MILLIVOLT_SECOND_PER_RADIAN: "mV s/rad", "mVs/rad", "mVs/rad", ["mV/(rad/s)"], (over 1e3);
        }
        NoLoadCurrentConstant [] {
            AMPERE_PER_REVOLUTION_PER_MINUTE: "A/(1/min)", "A/min⁻¹", "A/min^-1",
                ["A/(min^-1)", "A/rpm"], (over per_minute());
            MILLIAMPERE_PER_REVOLUTION_PER_MINUTE: "10^-3 A/(1/min)", "10⁻³ A/min⁻¹", "10^-3 A/min^-1",
                ["mA/(1/min)", "mA/(min^-1)", "mA/min^-1", "mA/rpm"],
                (over (1e3 * per_minute()));
            AMPERE_SECOND_PER_RADIAN: "A s/rad", "As/rad", "As/rad", ["A/(rad/s)"], (si);
        }
    }
    {
        NEWTON_METRE_PER_RADIAN TILTING_NEWTON_METRE_PER_RADIAN: "N m/rad", "Nm/rad", "Nm/rad", [], (si);
        KILONEWTON_METRE_PER_RADIAN TILTING_KILONEWTON_METRE_PER_RADIAN: "10^3 N m/rad", "10³ Nm/rad", "10^3 Nm/rad",
            ["kN m/rad", "kNm/rad", "N m/mrad"],
            (times 1e3);
        TORSIONAL_TEN_KILONEWTON_METRE_PER_RADIAN TILTING_TEN_KILONEWTON_METRE_PER_RADIAN:
            "10^4 N m/rad", "10⁴ Nm/rad", "10^4 Nm/rad",
            [],
            (times 1e4);
        TORSIONAL_MEGANEWTON_METRE_PER_RADIAN TILTING_MEGANEWTON_METRE_PER_RADIAN:
            "10^6 N m/rad", "10⁶ Nm/rad", "10^6 Nm/rad",
            ["MN m/rad"],
            (times 1e6);
    }
    {
        TORSIONAL_NEWTON_METRE_PER_ARCMINUTE NEWTON_METRE_PER_ARCMINUTE: "N m/arcmin", "Nm/arcmin", "Nm/arcmin",
            ["N m/arc min", "N m/′"],
            (over arcminute());
        TORSIONAL_KILONEWTON_METRE_PER_ARCMINUTE TILTING_KILONEWTON_METRE_PER_ARCMINUTE:
            "kN m/arcmin", "kNm/arcmin", "kNm/arcmin",
            ["kN m/arc min", "kN m/′"],
            (times 1e3 / arcminute());
        TORSIONAL_KILONEWTON_METRE_PER_DEGREE TILTING_KILONEWTON_METRE_PER_DEGREE: "kN m/deg", "kNm/°", "kNm/deg", [],
            (times 1e3 / degree());
        TORSIONAL_NEWTON_CENTIMETRE_PER_RADIAN TILTING_NEWTON_CENTIMETRE_PER_RADIAN: "N cm/rad", "Ncm/rad", "Ncm/rad", [],
            (over 1e2);
        TORSIONAL_NEWTON_MILLIMETRE_PER_RADIAN TILTING_NEWTON_MILLIMETRE_PER_RADIAN: "N mm/rad", "Nmm/rad", "Nmm/rad",
            ["mN m/rad"],
            (over 1e3);
        TORSIONAL_NEWTON_CENTIMETRE_PER_ARCMINUTE TILTING_NEWTON_CENTIMETRE_PER_ARCMINUTE:
            "N cm/arcmin", "Ncm/arcmin", "Ncm/arcmin",
            ["N cm/arc min", "N cm/′"],
            (over (1e2 * arcminute()));
        TORSIONAL_NEWTON_MILLIMETRE_PER_ARCMINUTE TILTING_NEWTON_MILLIMETRE_PER_ARCMINUTE:
            "N mm/arcmin", "Nmm/arcmin", "Nmm/arcmin",
            ["N mm/arc min", "N mm/′", "mN m/arcmin", "mN m/arc min", "mN m/′"],
            (over (1e3 * arcminute()));
        TORSIONAL_NEWTON_MILLIMETRE_PER_DEGREE TILTING_NEWTON_MILLIMETRE_PER_DEGREE: "N mm/deg", "Nmm/°", "Nmm/deg",
            ["mN m/deg"],
            (over (1e3 * degree()));
    }
    {
        TORSIONAL_POUND_FORCE_INCH_PER_ARCMINUTE TILTING_POUND_FORCE_INCH_PER_ARCMINUTE:
            "lbf in/arcmin", "lbf in/arcmin", "lbf in/arcmin",
            ["lbf in/arc min", "lbf in/′", "lb in/arcmin", "lb in/arc min", "lb in/′"],
            (times POUND_FORCE_N * INCH_M / arcminute());
        POUND_FORCE_INCH_PER_RADIAN TILTING_POUND_FORCE_INCH_PER_RADIAN: "lbf in/rad", "lbf in/rad", "lbf in/rad",
            ["lb in/rad"],
            (times POUND_FORCE_N * INCH_M);
        TORSIONAL_POUND_FORCE_FOOT_PER_RADIAN TILTING_POUND_FORCE_FOOT_PER_RADIAN:
            "lbf ft/rad", "lbf ft/rad", "lbf ft/rad",
            ["lb ft/rad"],
            (times POUND_FORCE_N * FOOT_M);
        TORSIONAL_KILOGRAM_FORCE_METRE_PER_RADIAN TILTING_KILOGRAM_FORCE_METRE_PER_RADIAN:
            "kgf m/rad", "kgf m/rad", "kgf m/rad",
            ["kp m/rad"],
            (times STANDARD_GRAVITY_M_S2);
        TORSIONAL_NEWTON_METRE_PER_DEGREE TILTING_NEWTON_METRE_PER_DEGREE: "N m/deg", "Nm/°", "Nm/deg", [], (over degree());
        TORSIONAL_POUND_FORCE_INCH_PER_DEGREE TILTING_POUND_FORCE_INCH_PER_DEGREE:
            "lbf in/deg", "lbf in/°", "lbf in/deg",
            ["lb in/deg"],
            (times POUND_FORCE_N * INCH_M / degree());
        TORSIONAL_POUND_FORCE_FOOT_PER_DEGREE TILTING_POUND_FORCE_FOOT_PER_DEGREE:
            "lbf ft/deg", "lbf ft/°", "lbf ft/deg",
            ["lb ft/deg"],
            (times POUND_FORCE_N * FOOT_M / degree());
        TORSIONAL_KILOGRAM_FORCE_METRE_PER_DEGREE TILTING_KILOGRAM_FORCE_METRE_PER_DEGREE:
            "kgf m/deg", "kgf m/°", "kgf m/deg",
            ["kp m/deg"],
            (times STANDARD_GRAVITY_M_S2 / degree());
        TORSIONAL_POUND_FORCE_FOOT_PER_ARCMINUTE TILTING_POUND_FORCE_FOOT_PER_ARCMINUTE:
            "lbf ft/arcmin", "lbf ft/arcmin", "lbf ft/arcmin",
            ["lbf ft/arc min", "lbf ft/′", "lb ft/arcmin", "lb ft/arc min", "lb ft/′"],
            (times POUND_FORCE_N * FOOT_M / arcminute());
        TORSIONAL_KILOGRAM_FORCE_METRE_PER_ARCMINUTE TILTING_KILOGRAM_FORCE_METRE_PER_ARCMINUTE:
            "kgf m/arcmin", "kgf m/arcmin", "kgf m/arcmin",
            ["kgf m/arc min", "kgf m/′", "kp m/arcmin", "kp m/arc min", "kp m/′"],
            (times STANDARD_GRAVITY_M_S2 / arcminute());
    }
    {
        ViscousFriction [] {
            NEWTON_METRE_SECOND_PER_RADIAN: "N m s/rad", "Nms/rad", "Nms/rad", ["N m/(rad/s)", "N m s"], (si);
            NEWTON_METRE_PER_REVOLUTION_PER_MINUTE: "N m/(1/min)", "Nm/min⁻¹", "Nm/min^-1",
                ["N m/(min^-1)", "N m/rpm", "N m min"],
                (over per_minute());
            NEWTON_METRE_PER_THOUSAND_REVOLUTIONS: "N m/krpm", "Nm/krpm", "Nm/krpm",
                ["N m/1000 rpm", "N m/1000 1/min", "N m/1000 min^-1"],
                (over (1e3 * per_minute()));
            MILLINEWTON_METRE_SECOND_PER_RADIAN: "mN m s/rad", "mNms/rad", "mNms/rad", ["mN m/(rad/s)"], (over 1e3);
            MILLINEWTON_METRE_PER_THOUSAND_REVOLUTIONS: "mN m/krpm", "mNm/krpm", "mNm/krpm",
                ["mN m/1000 rpm", "mN m/1000 1/min", "mN m/1000 min^-1"],
                (over (1e6 * per_minute()));
            POUND_FORCE_INCH_SECOND_PER_RADIAN: "lbf in s/rad", "lbf in s/rad", "lbf in s/rad",
                ["lb in s/rad", "lbf in/(rad/s)", "lb in/(rad/s)"],
                (times POUND_FORCE_N * INCH_M);
            POUND_FORCE_INCH_PER_THOUSAND_REVOLUTIONS: "lbf in/krpm", "lbf in/krpm", "lbf in/krpm",
                ["lbf in/1000 rpm", "lbf in/1000 1/min", "lbf in/1000 min^-1", "lb in/krpm", "lb in/1000 rpm",
                    "lb in/1000 1/min", "lb in/1000 min^-1"],
                (times POUND_FORCE_N * INCH_M / (1e3 * per_minute()));
            POUND_FORCE_FOOT_SECOND_PER_RADIAN: "lbf ft s/rad", "lbf ft s/rad", "lbf ft s/rad",
                ["lb ft s/rad", "lbf ft/(rad/s)", "lb ft/(rad/s)"],
                (times POUND_FORCE_N * FOOT_M);
            POUND_FORCE_FOOT_PER_THOUSAND_REVOLUTIONS: "lbf ft/krpm", "lbf ft/krpm", "lbf ft/krpm",
                ["lbf ft/1000 rpm", "lbf ft/1000 1/min", "lbf ft/1000 min^-1", "lb ft/krpm", "lb ft/1000 rpm",
                    "lb ft/1000 1/min", "lb ft/1000 min^-1"],
                (times POUND_FORCE_N * FOOT_M / (1e3 * per_minute()));
            OUNCE_FORCE_INCH_SECOND_PER_RADIAN: "ozf in s/rad", "ozf in s/rad", "ozf in s/rad",
                ["oz in s/rad", "ozf in/(rad/s)", "oz in/(rad/s)"],
                (times POUND_FORCE_N / OUNCES * INCH_M);
            OUNCE_FORCE_INCH_PER_THOUSAND_REVOLUTIONS: "ozf in/krpm", "ozf in/krpm", "ozf in/krpm",
                ["ozf in/1000 rpm", "ozf in/1000 1/min", "ozf in/1000 min^-1", "oz in/krpm", "oz in/1000 rpm",
                    "oz in/1000 1/min", "oz in/1000 min^-1"],
                (times POUND_FORCE_N / OUNCES * INCH_M / (1e3 * per_minute()));
            KILOGRAM_FORCE_METRE_SECOND_PER_RADIAN: "kgf m s/rad", "kgf m s/rad", "kgf m s/rad",
                ["kp m s/rad", "kgf m/(rad/s)", "kp m/(rad/s)"],
                (times STANDARD_GRAVITY_M_S2);
            KILOGRAM_FORCE_METRE_PER_THOUSAND_REVOLUTIONS: "kgf m/krpm", "kgf m/krpm", "kgf m/krpm",
                ["kgf m/1000 rpm", "kgf m/1000 1/min", "kgf m/1000 min^-1", "kp m/krpm", "kp m/1000 rpm",
                    "kp m/1000 1/min", "kp m/1000 min^-1"],
                (times STANDARD_GRAVITY_M_S2 / (1e3 * per_minute()));
            KILOGRAM_FORCE_CENTIMETRE_SECOND_PER_RADIAN: "kgf cm s/rad", "kgf cm s/rad", "kgf cm s/rad",
                ["kp cm s/rad", "kgf cm/(rad/s)", "kp cm/(rad/s)"],
                (times STANDARD_GRAVITY_M_S2 / 1e2);
            KILOGRAM_FORCE_CENTIMETRE_PER_THOUSAND_REVOLUTIONS: "kgf cm/krpm", "kgf cm/krpm", "kgf cm/krpm",
                ["kgf cm/1000 rpm", "kgf cm/1000 1/min", "kgf cm/1000 min^-1", "kp cm/krpm", "kp cm/1000 rpm",
                    "kp cm/1000 1/min", "kp cm/1000 min^-1"],
                (times STANDARD_GRAVITY_M_S2 / 1e2 / (1e3 * per_minute()));
            NEWTON_METRE_SECOND_PER_DEGREE: "N m s/deg", "Nms/°", "Nms/deg", ["N m/(deg/s)"], (over degree());
        }
        PositionGain [] {
            PER_SECOND: "1/s", "s⁻¹", "1/s", ["s^-1"], (si);
        }
        SpeedGain [] {
            SPEED_GAIN_NEWTON_METRE_SECOND_PER_RADIAN: "N m s/rad", "Nms/rad", "Nms/rad", ["N m/(rad/s)", "N m s"], (si);
        }
        CurrentGain [] {
            VOLT_PER_AMPERE: "V/A", "V/A", "V/A", [], (si);
        }
        Information [] {
            BIT: "bit", "bit", "bit", [], (si);
        }
    }
}
