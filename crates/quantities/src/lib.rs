//! Typed physical quantities: make, convert, parse and print them. The only home of conversion factors.
//!
//! The types are those of `uom` (f64, SI inside); a few that `uom` lacks are newtypes here. [`Unit`] tells how a unit
//! is written and converts through `uom`; [`parse`] reads `"1.3 kg m^2"`; [`format_number`] writes numbers for people.

mod algebra;
mod format;
mod measure;
mod parse;
mod units;

pub use algebra::{acceleration_of, power_of, torque_of};
pub use format::{format_number, format_significant, parse_german};
pub use measure::{
    Measure, NoLoadCurrentConstant, TiltingStiffness, TorqueConstant, TorsionalStiffness, ViscousFriction,
    VoltageConstant,
};
pub use parse::{QuantityError, Reading, parse, parse_as};
pub use units::{Dimension, Unit, unit};
pub use uom::si::f64::{
    Acceleration, Angle, AngularAcceleration, AngularVelocity, ElectricCurrent, ElectricPotential,
    ElectricalResistance, Energy, Force, Frequency, Inductance, Length, Mass, MomentOfInertia, Power, Pressure, Ratio,
    TemperatureInterval, ThermodynamicTemperature, Time, Torque,
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
