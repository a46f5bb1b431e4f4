//! Typed physical quantities: creation, conversion, parsing and formatting. The only place of conversion factors.
//!
//! The types are those of `uom` (f64, SI inside); the few that `uom` does not distinguish are newtypes here. [`Unit`]
//! has the spellings of a unit and converts through `uom`, [`parse()`] reads `"1.3 kg m^2"`, and [`format_number`]
//! formats numbers for display.
//!
//! ```
//! use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE};
//! use quantities::{AngularVelocity, Language, Measure, Torque, format_significant, parse_as};
//!
//! let torque: Torque = parse_as("85 N m")?;
//! let speed = AngularVelocity::new_in(40.0, &REVOLUTION_PER_MINUTE);
//! assert_eq!(format_significant((torque * speed).si(), 4, Language::De), "356,0");
//!
//! let fault = parse_as::<Torque>("85 1/min").unwrap_err();
//! assert_eq!(fault.span(), 3..8);
//! assert_eq!(fault.to_string(), "\"1/min\" is a unit of rotational speed, expected a unit of torque");
//! assert_eq!(torque.in_unit(&NEWTON_METRE), 85.0);
//! # Ok::<(), quantities::QuantityError>(())
//! ```

mod algebra;
mod dimension;
mod error;
mod expression;
mod factors;
mod format;
mod ids;
mod measure;
mod parse;
mod proposal;
mod seen;
mod spelling;
mod tolerance;

#[macro_use]
mod unit_table;
pub mod unit;
mod units;

pub use dimension::Dimension;
pub use error::QuantityError;
pub use format::{digits_apart, format_number, format_significant, grouped, parse_german, with_symbol};
pub use measure::{
    CurrentGain, EffectiveVoltage, Lead, Measure, NoLoadCurrentConstant, PositionGain, SpeedGain, TiltingStiffness,
    TorqueConstant, TorsionalStiffness, ViscousFriction, VoltageConstant,
};
pub use parse::{Reading, parse, parse_as};
pub use seen::{is_unseen, seen};
pub use tolerance::{HalfWidth, PLUS_MINUS, parse_toleranced, quantity_faults, without_tolerance};
pub use units::Unit;
pub use uom::si::f64::{
    Acceleration, Angle, AngularAcceleration, AngularJerk, AngularVelocity, Area, ElectricCurrent, ElectricPotential,
    ElectricalResistance, ElectricalResistivity, Energy, Force, Frequency, Inductance, Jerk, Length, Mass, MassDensity,
    MomentOfInertia, Power, Pressure, Ratio, TemperatureInterval, ThermodynamicTemperature, Time, Torque, Velocity,
};

/// A language of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English, decimal point.
    #[default]
    En,
    /// German, decimal comma.
    De,
}

impl Language {
    /// Language of errors for developers who use a crate.
    pub const OF_ERRORS: Self = Self::En;

    /// The languages.
    pub const ALL: [Self; 2] = [Self::En, Self::De];

    /// Returns the code of ISO 639-1.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::De => "de",
        }
    }

    /// Returns the language of a code, in lower or upper case.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.id().eq_ignore_ascii_case(id))
    }

    /// Returns the decimal mark.
    #[must_use]
    pub const fn decimal_mark(self) -> char {
        match self {
            Self::En => '.',
            Self::De => ',',
        }
    }
}
